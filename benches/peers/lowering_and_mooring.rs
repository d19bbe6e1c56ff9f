//! The same two lines in MoorDyn and here: CPU time of the whole process against error.
//!
//! Both begin at rest, MoorDyn by its catenaries between the ends and the places where the sections meet. It runs by RK4 in its largest
//! stable step, from Python.

use std::process::Command;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, Case};
use seacable::run::job::{self, Request};
use seacable::scene;
use seacable::solve::State;
use seacable::statics::equilibrium::EquilibriumSearch;

use crate::histories::{History, errors, milliseconds, printed};
use crate::lines::{LINES, Line, Segments};
use crate::place::{Peer, Place, output};

/// How much finer than what is held against it the history that counts as true is, in mesh and steps.
const FINER: usize = 4;
const SHORTER: usize = 8;

pub(crate) fn run(place: &Place) {
    if !place.has(Peer::MoorDyn) {
        println!("\nLowering and hybrid mooring are not run: no MoorDyn");
        return;
    }
    println!(
        "\n{:<34} {:>8} {:>9} {:>9} {:>10} {:>8}",
        "Lowering and hybrid mooring", "segments", "end B, %", "end A, %", "process ms", "faster"
    );
    for line in LINES {
        compare(line, place);
    }
}

/// The command that runs a line in MoorDyn.
fn moordyn(
    place: &Place,
    line: &Line,
    segments: Segments,
    joints: &[[f64; 3]; 2],
    shorter: usize,
) -> Command {
    let steps = line.steps_a_row * shorter;
    let name = format!("{}-{shorter}", line.name);
    let file = place.write(
        &format!("{name}.dat"),
        &line.moordyn(segments, joints, line.interval_s / steps as f64),
    );
    let table = place.write(&format!("{name}.txt"), &line.motion(line.calls(steps)));
    let mut command = place.script("march.py");
    command
        .args([file, table])
        .arg(line.calls(steps).to_string());
    command
}

fn compare(line: &Line, place: &Place) {
    let fine = line.segments.map(|n| FINER * n);
    place.write("motion.csv", &line.table());
    let rest = at_rest(place, line, fine);
    let joints = [rest[fine[0]], rest[fine[0] + fine[1]]];
    let exact = printed(&output(&mut moordyn(place, line, fine, &joints, SHORTER)));
    let mut peer = moordyn(place, line, line.segments, &joints, 1);
    let tensions = printed(&output(&mut peer));
    let slow = place.cost(&peer).process;
    let row = |name: &str, segments: Segments, errors: Option<[f64; 2]>, cpu: f64| {
        let error = |end: usize| errors.map_or_else(String::new, |of| format!("{:.3}", of[end]));
        println!(
            "{name:<34} {:>8} {:>9} {:>9} {:>10.1} {:>8.1}",
            segments.iter().sum::<usize>(),
            error(1),
            error(0),
            1e3 * cpu,
            slow / cpu
        );
    };
    let name = |what: &str| format!("{}, {what}", line.name);
    row(
        &name("MoorDyn"),
        line.segments,
        Some(errors(&tensions, &exact)),
        slow,
    );
    let converged = here(place, &line.case(fine, &rest, "step_tolerance = 1e-9"));
    for segments in line.meshes {
        let rest = at_rest(place, line, *segments);
        let errors = errors(&here(place, &line.case(*segments, &rest, "")), &converged);
        for (what, bars) in [
            ("default settings", false),
            ("the same with error bars", true),
        ] {
            let solver = format!("error_estimate = {bars}");
            let file = place.write("case.toml", &line.case(*segments, &rest, &solver));
            row(
                &name(what),
                *segments,
                (!bars).then_some(errors),
                place.cost(&place.run(&file)).process,
            );
        }
    }
    let between = errors(&converged, &exact);
    println!(
        "{:<34} {:>8} {:>9.3} {:>9.3}",
        name("the two converged histories"),
        "",
        between[1],
        between[0]
    );
}

fn parsed(place: &Place, text: &str) -> Case {
    let file = place.write("case.toml", text);
    let read = case::load(&file).unwrap_or_else(|found| panic!("{found:?}"));
    read.case
}

/// Tensions by a run here, without the row at the start.
fn here(place: &Place, text: &str) -> History {
    let request = Request {
        case: parsed(place, text),
        text: text.to_owned(),
        file: "case.toml".to_owned(),
        overrides: vec!["solver.error_estimate=false".to_owned()],
        id: "bench".to_owned(),
    };
    let run = job::execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.failure, None);
    let [a, b] = ["tension_n[a|s0]", "tension_n[s2|b]"]
        .map(|name| &run.history.channel(name).unwrap().values);
    let ends = a.iter().zip(b).map(|(a, b)| [*a, *b]);
    let times = run.history.time.iter().map(|time| milliseconds(*time));
    times.zip(ends).skip(1).collect()
}

/// The places of the nodes at rest with end B held.
fn at_rest(place: &Place, line: &Line, segments: Segments) -> Vec<[f64; 3]> {
    let scene = scene::build(&parsed(place, &line.held(segments)), 1).unwrap();
    let mut state: State = scene.initial_state();
    EquilibriumSearch::default()
        .run(&scene, 0.0, &mut state)
        .unwrap();
    state.x.iter().map(|place| (*place).into()).collect()
}
