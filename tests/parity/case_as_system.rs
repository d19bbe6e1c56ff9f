//! Shipped cases of a line, computed as they are and as the systems that they are converted to.

use std::fmt::Write as _;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, Case, Diagnostic, End, EndKind, Method, edit, kind, shipped};
use seacable::import::{ImportOptions, line_case};
use seacable::kinds::FileBytes;
use seacable::open::OpenedFile;
use seacable::reference::Outcome;
use seacable::run::History;
use seacable::system::motion::run::run;
use seacable::system::{SolvedSystem, SystemFile, quantities, validation};

use crate::one_line::{line_run, system_run};

/// Steps of a run in time.
const STEPS: usize = 40;
/// The longest step \[s\].
const STEP: f64 = 0.01;

/// A shipped case: its path and its text.
type Shipped = (&'static str, &'static str);

/// The shipped cases of a line.
fn cases() -> impl Iterator<Item = Shipped> {
    shipped::SHIPPED.iter().copied()
}

fn path_of(name: &str) -> String {
    let root = env!("CARGO_MANIFEST_DIR");
    format!("{root}/cases/{name}")
}

/// The system of a text.
fn converted(name: &str, text: &str) -> Result<String, Vec<Diagnostic>> {
    line_case::read(text, Path::new(&path_of(name))).map(|imported| imported.text)
}

/// A case over a few constant steps, its text with the files that it names.
fn shortened(name: &str, text: &str) -> String {
    let read = |text: &str| case::parse(text, &path_of(name)).unwrap();
    let given = read(text);
    let whole = case::stand_alone(text, &given).into_owned();
    if given.solver.method == Method::Static {
        return whole;
    }
    let step = given.solver.time_step_s.unwrap_or(STEP).min(STEP);
    let duration = step * STEPS as f64;
    let method = match given.solver.method {
        Method::Auto => "alpha",
        Method::Rk4 => "rk4",
        Method::Quasi => "quasi",
        _ => "alpha",
    };
    let [step, duration] = [step, duration].map(|value| format!("{value:?}"));
    let mut edits = vec![
        ("solver.method", method),
        ("solver.time_step_s", &step),
        ("solver.duration_s", &duration),
        ("solver.error_estimate", "false"),
        ("solver.position_tolerance_m", "1e-10"),
        ("output.interval_s", &step),
    ];
    // A motion that sets in at full speed begins otherwise.
    let swings = |end: &End| end.kind == EndKind::Moving && end.ramp_s == 0.0;
    for (key, end) in [
        ("ends.a.ramp_s", &given.ends.a),
        ("ends.b.ramp_s", &given.ends.b),
    ] {
        if swings(end) {
            edits.push((key, "1.0"));
        }
    }
    edit::set_all(&whole, &edits).unwrap()
}

/// How far a line and its system are from each other.
#[derive(Debug, Clone, Copy, Default)]
struct Apart {
    /// Of tensions, by the greatest.
    tension: f64,
    /// Of places \[m\].
    place_m: f64,
}

/// Differences that count as none, where both are divided alike \[-\], \[m\].
const ALIKE: Apart = Apart {
    tension: 1e-8,
    place_m: 1e-10,
};

/// The same at rest, where the line is its closed form: its mesh error.
const OF_MESH: Apart = Apart {
    tension: 1e-5,
    place_m: 1e-5,
};

/// Cases whose systems come to no equilibrium: a clamped line with nothing at its free end.
const NOT_AT_REST: [&str; 1] = ["benchmarks/beam_cantilevered.toml"];

/// Cases whose line snaps from slack to taut at steps that the Newton iterations of lines and of systems end apart, after which no two
/// runs are alike: their published values hold.
const SNAPPING: [&str; 2] = ["hard/stop.toml", "hard/whip.toml"];

/// Tensions below this are rounding, as of a line that falls freely \[N\].
const NO_TENSION: f64 = 1e-6;

/// What of both is compared: names of channels of the line, whose squares are summed, and that of the system.
fn pairs(case: &Case) -> Vec<(Vec<String>, String)> {
    let sections = [case.line.first(), case.line.last()].map(|section| &section.unwrap().name);
    let ends = [&case.ends.a, &case.ends.b];
    let mut pairs = Vec::new();
    for ((end, section), letter) in ends.into_iter().zip(sections).zip(["a", "b"]) {
        let at_joint = match letter {
            "a" => format!("tension_n[{}|{section}]", end.name),
            _ => format!("tension_n[{section}|{}]", end.name),
        };
        // At rest the tension of a system is the force on the end.
        let is_force = case.solver.method == Method::Static && end.kind.is_held();
        let own = match is_force {
            true => ["x", "y", "z"]
                .map(|axis| format!("force_{axis}_n[{}]", end.name))
                .to_vec(),
            false => vec![at_joint],
        };
        pairs.push((own, format!("tension_n[line|{letter}]")));
        let stays = end.release_s.is_none()
            && case
                .payload
                .as_ref()
                .is_none_or(|of| of.release_s.is_none());
        if stays && end.kind != EndKind::Fixed && end.kind != EndKind::Anchor {
            let places = ["x_m", "y_m", "z_m"].map(|axis| format!("{axis}[{}]", end.name));
            pairs.extend(places.map(|name| (vec![name.clone()], name)));
        }
    }
    pairs
}

/// The values of a system: over time, or at rest.
enum Values {
    Over(Box<History>),
    AtRest(Box<SolvedSystem>),
}

impl Values {
    fn of(text: &str) -> Self {
        let solved = kind::parse::<SystemFile>(text, "system.toml").unwrap();
        match solved.file.solver {
            Some(_) => Self::Over(Box::new(system_run(text).history)),
            None => Self::AtRest(Box::new(solved)),
        }
    }

    fn named(&self, name: &str) -> Vec<f64> {
        match self {
            Self::Over(history) => {
                let channel = history.channel(name);
                let channel = channel.unwrap_or_else(|| panic!("no channel {name}"));
                channel.values.clone()
            }
            Self::AtRest(solved) => vec![quantities::value(solved, name).unwrap()],
        }
    }
}

/// Values of a line: of one channel, or the size of those of several.
fn of_line(history: &History, names: &[String]) -> Vec<f64> {
    let channels: Vec<&[f64]> = names
        .iter()
        .map(|name| &*history.channel(name).unwrap().values)
        .collect();
    match channels.as_slice() {
        [one] => one.to_vec(),
        many => (0..many[0].len())
            .map(|k| {
                many.iter()
                    .map(|values| values[k].powi(2))
                    .sum::<f64>()
                    .sqrt()
            })
            .collect(),
    }
}

fn apart(name: &str, text: &str) -> Apart {
    let text = shortened(name, text);
    let case = case::parse(&text, &path_of(name)).unwrap();
    let system = Values::of(&converted(name, &text).unwrap());
    let line = line_run(text).history;
    let (mut apart, mut greatest) = (Apart::default(), 0.0_f64);
    for (own, other) in pairs(&case) {
        let (own_values, others) = (of_line(&line, &own), system.named(&other));
        assert_eq!(own_values.len(), others.len(), "{name}: {other}");
        let differences = own_values.iter().zip(&others).map(|(a, b)| (a - b).abs());
        let difference = differences.fold(0.0, f64::max);
        if other.starts_with("tension") {
            greatest = others.iter().fold(greatest, |a, b| a.max(b.abs()));
            apart.tension = apart.tension.max(difference);
        } else {
            apart.place_m = apart.place_m.max(difference);
        }
    }
    apart.tension /= greatest.max(NO_TENSION / ALIKE.tension);
    apart
}

/// A row for each case, and those that differ by more than they may.
fn compared<'a>(cases: impl Iterator<Item = &'a Shipped>) -> (Vec<String>, Vec<&'static str>) {
    let (mut rows, mut differ) = (Vec::new(), Vec::new());
    for (name, text) in cases.filter(|(name, _)| !SNAPPING.contains(name)) {
        let found = apart(name, text);
        let case = case::parse(text, &path_of(name)).unwrap();
        let allowed = match case.solver.method {
            Method::Static => OF_MESH,
            _ => ALIKE,
        };
        rows.push(format!(
            "{name}: {:.1e}, {:.1e} m",
            found.tension, found.place_m
        ));
        if found.tension > allowed.tension || found.place_m > allowed.place_m {
            differ.push(*name);
        }
    }
    (rows, differ)
}

/// Whether a case is read, converted and computed as a system.
fn is_system(name: &str) -> bool {
    refused(name).is_empty() && !NOT_AT_REST.contains(&name)
}

/// All that is wrong with a case as a system.
fn refused(name: &str) -> Vec<Diagnostic> {
    let bytes = FileBytes::read(Path::new(&path_of(name)));
    let opened = OpenedFile::of::<SystemFile>(bytes, &ImportOptions::default());
    let read = opened.and_then(|opened| opened.read::<SystemFile>());
    read.err().unwrap_or_default()
}

/// All of them, with a row for each: `cargo test --test parity every_shipped_line -- --ignored --nocapture`.
#[test]
#[ignore = "the next test has a sample of the same"]
fn every_shipped_line_and_its_system_agree() {
    let all: Vec<Shipped> = cases().filter(|(name, _)| is_system(name)).collect();
    let (rows, differ) = compared(all.iter());
    println!("{}\n{} cases", rows.join("\n"), rows.len());
    assert!(differ.is_empty(), "{differ:?}");
}

/// Of all that are converted every sixth, from one that the seed draws.
#[test]
fn a_sample_of_shipped_lines_agrees_with_its_systems() {
    let seed = std::env::var("SEACABLE_SEED").ok();
    let seed = seed.and_then(|seed| seed.parse().ok()).unwrap_or(1_usize);
    let all: Vec<Shipped> = cases().filter(|(name, _)| is_system(name)).collect();
    assert!(all.len() >= 50, "{}", all.len());
    let (rows, differ) = compared(all.iter().skip(seed % 6).step_by(6));
    assert!(
        rows.len() >= 6 && differ.is_empty(),
        "{differ:?}: {rows:#?}"
    );
}

/// Published values of lines, at rest and of runs in time, hold for their systems: rows that pass, of all.
fn published(name: &str, text: &str) -> (usize, usize) {
    let given = case::parse(text, &path_of(name)).unwrap();
    let system = converted(name, &case::stand_alone(text, &given)).unwrap();
    let solved = kind::parse::<SystemFile>(&system, "system.toml").unwrap();
    let motion = solved
        .file
        .solver
        .as_ref()
        .map(|solver| run(&solved, solver, &AtomicBool::new(false), &mut |_| {}).unwrap());
    let rows = validation::rows(&solved, motion.as_ref());
    let passed = rows.iter().filter(|row| row.outcome == Outcome::Pass);
    (passed.count(), rows.len())
}

#[test]
fn published_values_of_lines_hold_for_their_systems() {
    let quick = [
        "basics/hanging_line.toml",
        "double_stepped/regular_wave.toml",
        "hard/buoyant.toml",
        "hard/cut_off.toml",
        "hard/falling.toml",
        "hard/free_fall.toml",
        "hard/stop.toml",
        "hard/ten_km.toml",
        "hard/vertical.toml",
        "hard/whip.toml",
    ];
    let found = cases().filter(|(name, _)| quick.contains(name));
    let found: Vec<(usize, usize)> = found.map(|(name, text)| published(name, text)).collect();
    assert_eq!(found.iter().map(|(_, all)| all).sum::<usize>(), 24);
    assert!(found.iter().all(|(passed, all)| passed == all), "{found:?}");
}

/// What is refused, by its place and key.
#[test]
fn what_is_refused_is_named_by_its_key() {
    let mut list = String::new();
    for (name, _) in cases() {
        for one in refused(name) {
            assert!(one.line > 0 && !one.key.is_empty(), "{name}: {one:?}");
            writeln!(
                list,
                "{name}:{}:{}: {}: {}",
                one.line, one.column, one.key, one.problem
            )
            .unwrap();
        }
    }
    insta::assert_snapshot!("refused_lines", list);
}
