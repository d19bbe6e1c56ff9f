//! The same two lines in MoorDyn and here: CPU time of the whole process against error.
//!
//! Each error is the root mean square difference of the tension at both ends from the program's own history on four times as many
//! segments in much shorter steps, by its peak: what the mesh and the steps cost, and no difference of the models. What those two
//! histories differ by is stated too. Both begin at rest, MoorDyn by its catenaries between the ends and the places where the sections
//! meet. It runs by RK4 in its largest stable step, from Python; runs here are written to memory where there is a disk of it.
//!
//! Needs Python with the package `moordyn` 2.7.2, named by `MOORDYN_PYTHON`: `cargo bench --bench moordyn`.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

mod lines;

use std::fs;
use std::path::{self, Path, PathBuf};
use std::process::Command;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, Case};
use seacable::run::job::{self, Request};
use seacable::scene;
use seacable::solve::State;
use seacable::statics::equilibrium::EquilibriumSearch;

use lines::{LINES, Line, Segments};

const REPEATS: &str = "7";
/// How much finer than what is held against it the history that counts as true is, in mesh and steps.
const FINER: usize = 4;
const SHORTER: usize = 8;

fn main() {
    let Ok(python) = std::env::var("MOORDYN_PYTHON") else {
        println!("not run: MOORDYN_PYTHON names no Python with the package moordyn");
        return;
    };
    let place = Place::new(python);
    println!(
        "{:<34} {:>8} {:>9} {:>9} {:>10} {:>8}",
        "", "segments", "end B, %", "end A, %", "CPU ms", "faster"
    );
    for line in LINES {
        compare(line, &place);
    }
}

/// Where files are, and what runs MoorDyn.
struct Place {
    folder: tempfile::TempDir,
    python: PathBuf,
}

/// Tensions at end A and end B at the times of the rows \[N\].
type Tensions = Vec<[f64; 2]>;

impl Place {
    fn new(python: String) -> Self {
        let memory = Path::new("/dev/shm");
        let folder = if memory.is_dir() {
            tempfile::tempdir_in(memory)
        } else {
            tempfile::tempdir()
        };
        // Commands are run in the folder.
        let python = match python.contains('/') {
            true => path::absolute(&python).unwrap(),
            false => PathBuf::from(python),
        };
        Self {
            folder: folder.unwrap(),
            python,
        }
    }

    fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.folder.path().join(name);
        fs::write(&path, text).unwrap();
        path
    }

    /// The command that runs a line in MoorDyn.
    fn moordyn(
        &self,
        line: &Line,
        segments: Segments,
        joints: &[[f64; 3]; 2],
        shorter: usize,
    ) -> Command {
        let steps = line.steps_a_row * shorter;
        let name = format!("{}-{shorter}", line.name);
        let file = self.write(
            &format!("{name}.dat"),
            &line.moordyn(segments, joints, line.interval_s / steps as f64),
        );
        let table = self.write(&format!("{name}.txt"), &line.motion(line.calls(steps)));
        let mut command = Command::new(&self.python);
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/moordyn/march.py");
        command
            .arg(script)
            .args([file, table])
            .arg(line.calls(steps).to_string());
        command
    }

    /// CPU time of a command \[s\].
    fn cost(&self, command: &Command) -> f64 {
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/moordyn/cost.py");
        let mut timed = Command::new(&self.python);
        timed.arg(script).arg(REPEATS).arg(command.get_program());
        timed.current_dir(self.folder.path());
        let said = output(timed.args(command.get_args()));
        said.trim().parse().unwrap()
    }
}

fn output(command: &mut Command) -> String {
    let done = command.output().unwrap();
    let messages = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{command:?}: {messages}");
    String::from_utf8(done.stdout).unwrap()
}

/// The tensions that MoorDyn printed.
fn printed(text: &str) -> Tensions {
    let numbers = |row: &str| {
        let words = row.split_whitespace().skip(1);
        let numbers: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
        [numbers[0], numbers[1]]
    };
    text.lines().map(numbers).collect()
}

fn compare(line: &Line, place: &Place) {
    let fine = line.segments.map(|n| FINER * n);
    place.write("motion.csv", &line.table());
    let rest = at_rest(place, line, fine);
    let joints = [rest[fine[0]], rest[fine[0] + fine[1]]];
    let exact = printed(&output(&mut place.moordyn(line, fine, &joints, SHORTER)));
    let mut moordyn = place.moordyn(line, line.segments, &joints, 1);
    let tensions = printed(&output(&mut moordyn));
    let slow = place.cost(&moordyn);
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
            let mut run = Command::new(env!("CARGO_BIN_EXE_seacable"));
            run.arg("run").arg(&file);
            row(
                &name(what),
                *segments,
                (!bars).then_some(errors),
                place.cost(&run),
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

/// Root mean square differences at end A and B by the peak there \[%\].
fn errors(of: &Tensions, exact: &Tensions) -> [f64; 2] {
    assert_eq!(of.len(), exact.len());
    [0, 1].map(|end| {
        let peak = exact.iter().map(|row| row[end]).fold(0.0, f64::max);
        let squares = of.iter().zip(exact).map(|(a, b)| (a[end] - b[end]).powi(2));
        100.0 * (squares.sum::<f64>() / of.len() as f64).sqrt() / peak
    })
}

fn parsed(place: &Place, text: &str) -> Case {
    let file = place.write("case.toml", text);
    let read = case::load(&file).unwrap_or_else(|found| panic!("{found:?}"));
    read.case
}

/// Tensions by a run here, without the row at the start.
fn here(place: &Place, text: &str) -> Tensions {
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
    a.iter().zip(b).skip(1).map(|(a, b)| [*a, *b]).collect()
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
