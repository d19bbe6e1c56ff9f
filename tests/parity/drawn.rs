//! Lines drawn at random from all that a case may say, computed as they are and as the systems that they are converted to.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use seacable::case::{self, Case, Method, StartShape, edit, kind};
use seacable::import::line_case;
use seacable::numerics::V3;
use seacable::run::{History, Run, RunState};
use seacable::system::SystemFile;
use seacable::system::equilibrium::{SystemEquilibrium, search_near};

use crate::case_as_system::{Apart, OF_ROD, ROD_RINGS, apart_of};
use crate::drawn_lines::{any_line, any_scene};
use crate::lines;
use crate::one_line::{line_run, system_run};

/// What became of a line and of its system.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Fate {
    /// Both are computed, and are the same.
    Alike,
    /// The conversion refuses it, at these keys.
    Refused(String),
    /// Neither comes to an end.
    NeitherEnds,
    /// The line comes to an end, its system does not.
    SystemFails,
    /// The system comes to an end, its line does not.
    LineFails,
    /// Each search found a rest of its own: the system rests where the line does, too.
    OtherRest,
    /// The payload turns, and the rod that it is on the line rings.
    Rings,
    /// Both are computed, and are not the same.
    Apart,
}

/// How far a rest on another bed, or by closed forms, may be from that of segments, by the length of the line.
const NEAR: f64 = 0.01;

/// Rows at the start of a line that falls, in which rounding decides which of its segments is taut.
const FALLS: usize = 4;

/// Differences that count as none: tensions by the greatest, places \[m\].
const ALIKE: Apart = Apart {
    tension: 1e-6,
    place_m: 1e-7,
};

/// Whether the system rests where the line does, too: the search near by, which forces of the current have a part in from the start, stays there.
fn rests_there(case: &Case, line: &History, system: &str) -> bool {
    let is_searched =
        case.start.shape != StartShape::Straight || case.solver.method == Method::Static;
    let solved = kind::parse::<SystemFile>(system, "system.toml").unwrap();
    let mut near = solved.rest.placement.clone();
    let ends = [&case.ends.a, &case.ends.b].into_iter();
    let free: Vec<(usize, V3)> = ends
        .filter(|end| !end.kind.is_held())
        .map(|end| {
            let channel = |axis: &str| line.channel(&format!("{axis}[{}]", end.name)).unwrap();
            let place = ["x_m", "y_m", "z_m"].map(|axis| channel(axis).values[0]);
            (solved.network.point(&end.name).unwrap(), place.into())
        })
        .collect();
    for (point, place) in &free {
        near.points[*point] = *place;
    }
    let length: f64 = case.line.iter().map(|section| section.length_m).sum();
    let found = search_near(&solved.network, &near);
    let stays = |rest: SystemEquilibrium| {
        let mut moved = free
            .iter()
            .map(|(point, place)| (rest.placement.points[*point] - place).norm());
        moved.all(|moved| moved < NEAR * length)
    };
    is_searched && found.is_ok_and(stays)
}

/// How far a line is from its system.
fn apart(case: &Case, line: &Run, system: &Run) -> (bool, Apart) {
    let named = |name: &str| system.history.channel(name).unwrap().values.clone();
    let turns = turns(case);
    let falls = case.start.shape == StartShape::Straight && case.solver.method != Method::Static;
    let (first, allowed) = match (turns, falls) {
        (true, _) => (ROD_RINGS, OF_ROD),
        (false, true) => (FALLS, ALIKE),
        (false, false) => (0, ALIKE),
    };
    let apart = apart_of(case, &line.history, first, named);
    (
        apart.tension <= allowed.tension && apart.place_m <= allowed.place_m,
        apart,
    )
}

/// Whether it has a payload that turns: on the line two masses on a rod that rings in a line as stiff as it is, in the system a rigid body.
fn turns(case: &Case) -> bool {
    case.payload
        .as_ref()
        .is_some_and(|of| of.rotation.is_some())
}

fn timed(changes: &str) -> String {
    let text = lines::text(changes);
    let edits = [
        ("solver.method", "alpha"),
        ("solver.time_step_s", "0.01"),
        ("solver.duration_s", "0.5"),
        ("solver.position_tolerance_m", "1e-10"),
        ("output.interval_s", "0.01"),
    ];
    edit::set_all(&text, &edits).unwrap()
}

fn at_rest(changes: &str) -> String {
    edit::set_all(&lines::text(changes), &[("solver.method", "static")]).unwrap()
}

fn fate(text: &str) -> (Fate, String) {
    let system = match line_case::read(text, Path::new("line.toml")) {
        Ok(imported) => imported.text,
        Err(found) => {
            let keys: Vec<&str> = found.iter().map(|one| one.key.as_str()).collect();
            return (Fate::Refused(keys.join(" ")), String::new());
        }
    };
    if let Err(found) = kind::parse::<SystemFile>(&system, "system.toml") {
        return (
            Fate::Refused("as a system".to_owned()),
            format!("{found:?}\n{system}"),
        );
    }
    let (line, run) = (line_run(text.to_owned()), system_run(&system));
    let ends = [&line, &run].map(|run| run.info.state == RunState::Done);
    match ends {
        [false, false] => (Fate::NeitherEnds, String::new()),
        [false, true] => (Fate::LineFails, format!("{:?}", line.info.failure)),
        [true, false] => (Fate::SystemFails, format!("{:?}", run.info.failure)),
        [true, true] => {
            let case = case::parse(text, "line.toml").unwrap();
            let (is_alike, apart_by) = apart(&case, &line, &run);
            if is_alike {
                return (Fate::Alike, String::new());
            }
            if turns(&case) {
                return (Fate::Rings, String::new());
            }
            match rests_there(&case, &line.history, &system) {
                true => (Fate::OtherRest, String::new()),
                false => (Fate::Apart, format!("{apart_by:?}")),
            }
        }
    }
}

/// So many of a strategy, from a seed.
fn drawn(of: &impl Strategy<Value = String>, count: usize, seed: u8) -> Vec<String> {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    (0..count)
        .map(|_| of.new_tree(&mut runner).unwrap().current())
        .collect()
}

/// How many came to what, of so many in motion and at rest; and what is to be told of each that is not alike.
fn fates(count: usize, seed: u8) -> (BTreeMap<Fate, usize>, String) {
    let moving = drawn(&any_scene(), count, seed);
    let moving = moving.into_iter().map(|changes| timed(&changes));
    let resting = drawn(&any_line(), count, seed);
    let resting = resting.into_iter().map(|changes| at_rest(&changes));
    let (mut fates, mut told) = (BTreeMap::new(), String::new());
    for text in moving.chain(resting) {
        let (fate, why) = fate(&text);
        if !why.is_empty() {
            writeln!(told, "{fate:?} {why}\n{text}\n").unwrap();
        }
        *fates.entry(fate).or_default() += 1;
    }
    (fates, told)
}

/// All of them: `cargo test --release --test parity thousand -- --ignored --nocapture`.
#[test]
#[ignore = "the next test has a sample of the same"]
fn a_thousand_drawn_lines_are_as_their_systems() {
    let (fates, told) = fates(500, 1);
    println!("{told}\n{fates:#?}");
    let count = |fate: Fate| fates.get(&fate).copied().unwrap_or_default();
    assert!(count(Fate::Alike) >= 560, "{fates:?}");
    // Two lines that fall free from both ends, by 2e-4 of tensions that are next to none; two with an end that lies on a bed that slopes.
    assert!(
        count(Fate::Apart) <= 4 && count(Fate::SystemFails) <= 1,
        "{told}{fates:?}"
    );
}

#[test]
fn drawn_lines_are_as_their_systems() {
    let (fates, told) = fates(30, 2);
    let alike = fates.get(&Fate::Alike).copied().unwrap_or_default();
    let wrong = [Fate::Apart, Fate::SystemFails, Fate::LineFails];
    assert!(
        alike >= 36 && wrong.iter().all(|fate| !fates.contains_key(fate)),
        "{told}{fates:?}"
    );
}
