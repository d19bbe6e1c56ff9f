//! A line, and the system of it alone: one result.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, kind};
use seacable::run::{History, Run, RunState, job};
use seacable::system::SystemFile;
use seacable::system::motion::job as system_job;

/// A chain on a bed, its upper end heaved.
const COMMON: &str = r"
[seabed]
depth_m = 50.0
stiffness_n_per_m3 = 1e5
damping_n_s_per_m3 = 1e4

[materials.chain]
diameter_m = 0.1
mass_kg_per_m = 180.0
ea_n = 8e8
drag_normal = 1.2
drag_tangential = 0.1
added_mass_normal = 1.0
";

const LINE: &str = r#"
[case]
title = "One chain, as a line case"
[[line]]
name = "chain"
material = "chain"
length_m = 200.0
segments = 50
[ends.a]
name = "anchor"
kind = "anchor"
position_m = [180.0, 0.0, -50.0]
[ends.b]
name = "fairlead"
kind = "moving"
position_m = [0.0, 0.0, 0.0]
amplitude_m = [0.0, 0.0, 0.5]
period_s = 8.0
ramp_s = 4.0
"#;

const SYSTEM: &str = r#"
[system]
title = "One chain, as a system"
[points.anchor]
kind = "fixed"
position_m = [180.0, 0.0, -50.0]
[points.fairlead]
kind = "moved"
position_m = [0.0, 0.0, 0.0]
amplitude_m = [0.0, 0.0, 0.5]
period_s = 8.0
ramp_s = 4.0
[[lines]]
name = "chain"
from = "anchor"
to = "fairlead"
material = "chain"
length_m = 200.0
segments = 50
"#;

fn solver(method: &str, step: &str) -> String {
    format!(
        "[solver]\nduration_s = 8.0\nmethod = \"{method}\"\n{step}\nerror_estimate = false\n[output]\ninterval_s = 0.1\n"
    )
}

/// The run of a line case.
pub(crate) fn line_run(text: String) -> Run {
    let request = job::Request {
        case: case::parse(&text, "line.toml").unwrap(),
        text,
        file: "line.toml".to_owned(),
        overrides: Vec::new(),
        id: String::new(),
    };
    job::execute(&request, &AtomicBool::new(false), &mut |_| {})
}

/// The run of a system.
pub(crate) fn system_run(text: &str) -> Run {
    let solved = kind::parse::<SystemFile>(text, "system.toml").unwrap();
    let name = "system.toml".to_owned();
    let request = system_job::request(Arc::new(solved), text, name, Vec::new()).unwrap();
    job::execute(&request, &AtomicBool::new(false), &mut |_| {})
}

fn as_line(solver: &str) -> History {
    let start = "[start]\nshape = \"equilibrium\"\n";
    line_run(format!("{LINE}{COMMON}{start}{solver}")).history
}

fn as_system(solver: &str) -> History {
    system_run(&format!("{SYSTEM}{COMMON}{solver}")).history
}

/// Differences of a tension of 183 kN that count as none \[N\].
const NONE: f64 = 2e-3;

fn assert_agree(solver: &str) {
    assert_same(solver, (&as_line(solver), &as_system(solver)));
}

fn assert_same(solver: &str, (line, system): (&History, &History)) {
    let of = |history: &History, name: &str| history.channel(name).unwrap().values.clone();
    let pairs = [
        ("tension_n[anchor|chain]", "tension_n[chain|a]"),
        ("tension_n[chain|fairlead]", "tension_n[chain|b]"),
    ];
    for (own, other) in pairs {
        let (own, other) = (of(line, own), of(system, other));
        assert_eq!(own.len(), 81, "{solver}");
        let apart = own.iter().zip(&other).map(|(a, b)| (a - b).abs());
        let apart = apart.fold(0.0, f64::max);
        assert!(
            own.len() == other.len() && apart < NONE,
            "{solver}: {apart} N"
        );
    }
}

#[test]
fn by_generalized_alpha_at_a_constant_step() {
    assert_agree(&solver("alpha", "time_step_s = 0.02"));
}

#[test]
fn by_runge_kutta() {
    assert_agree(&solver("rk4", "time_step_s = 5e-4"));
}

#[test]
fn quasi_statically() {
    assert_agree(&solver("quasi", "time_step_s = 0.05"));
}

/// Its rest on the mesh is a run of one instant, with all along the line, by errors that the mesh makes.
#[test]
fn at_rest_by_the_method_static() {
    let errors = |solver: String| solver.replace("error_estimate = false", "error_estimate = true");
    let solver = errors(solver("static", ""));
    let start = "[start]\nshape = \"equilibrium\"\n";
    let line = line_run(format!("{LINE}{COMMON}{start}{solver}"));
    let system = system_run(&format!("{SYSTEM}{COMMON}{solver}"));
    assert_eq!(
        (line.info.state, system.info.state),
        (RunState::Done, RunState::Done)
    );
    assert_eq!(system.history.time, [0.0]);
    let [own, other] = [&line, &system].map(|run| &run.profiles[0]);
    assert_eq!(own.arc, other.arc);
    let most = |a: &[f64], b: &[f64]| {
        assert_eq!(a.len(), b.len());
        a.iter()
            .zip(b)
            .fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
    };
    for (a, b) in [
        (&own.tension, &other.tension),
        (&own.tension_min, &other.tension_min),
        (&own.tension_max, &other.tension_max),
    ] {
        let apart = most(a, b);
        assert!(apart < NONE, "{apart} N");
    }
    let apart = most(&own.bed_clearance, &other.bed_clearance);
    assert!(apart < 1e-7, "{apart} m");
    for (own, other) in [
        (
            "tension_n[chain|fairlead].final",
            "tension_n[chain|b].final",
        ),
        ("tension_n.max", "tension_n[along chain].max"),
        ("on_bed_m[line].final", "on_bed_m[chain].final"),
    ] {
        let of = |run: &Run, name: &str| {
            let found = run.summary.iter().find(|number| number.name() == name);
            let found = found.unwrap_or_else(|| panic!("{name}"));
            (found.value, found.error_estimate().unwrap())
        };
        let ((value, error), (again, known)) = (of(&line, own), of(&system, other));
        assert!((value - again).abs() < NONE, "{other}: {value} {again}");
        assert!(
            known > 0.0 && (error - known).abs() <= 1e-3 * error,
            "{other}: {error} {known}"
        );
    }
}

/// A motion that sets in at full speed: its velocity counts in the first row, as after every kink. Later the line snaps, and differences of
/// rounding grow.
#[test]
fn a_motion_without_a_ramp_begins_alike() {
    for solver in [
        solver("alpha", "time_step_s = 0.02"),
        solver("rk4", "time_step_s = 5e-4"),
        solver("quasi", "time_step_s = 0.05"),
    ] {
        let jump = |text: &str| text.replace("ramp_s = 4.0\n", "");
        let line = line_run(format!("{}{COMMON}{solver}", jump(LINE))).history;
        let system = system_run(&format!("{}{COMMON}{solver}", jump(SYSTEM))).history;
        let of = |history: &History, name: &str| history.channel(name).unwrap().values.clone();
        let own = of(&line, "tension_n[chain|fairlead]");
        let other = of(&system, "tension_n[chain|b]");
        let before = own.iter().zip(&other).take(4);
        let apart = before.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < NONE, "{solver}: {apart} N");
    }
}

/// The upper end raised, held and lowered along a table, with kinks between two steps.
fn assert_agree_by_table(interpolation: &str, solver: &str) {
    let swing = "amplitude_m = [0.0, 0.0, 0.5]\nperiod_s = 8.0\nramp_s = 4.0\n";
    let rows = "0,0,0,0\\n1.303,0,0,0\\n3.117,0.02,0,0.06\\n4.217,0.02,0,0.06\\n6.05,0,0,0.02\\n9,0,0,0.02";
    let by_file = format!(
        "motion = \"table\"\nmotion_file = \"p.csv\"\nmotion_interpolation = \"{interpolation}\"\n"
    );
    let own = LINE.replace(swing, &by_file);
    let line = format!(
        "files.\"p.csv\".text = \"time_s,x_m,y_m,z_m\\n{rows}\"\n{own}{COMMON}[start]\nshape = \"equilibrium\"\n{solver}"
    );
    let by_keys = format!(
        "table_time_s = [0.0, 1.303, 3.117, 4.217, 6.05, 9.0]\ntable_x_m = [0.0, 0.0, 0.02, 0.02, 0.0, 0.0]\n\
         table_z_m = [0.0, 0.0, 0.06, 0.06, 0.02, 0.02]\ntable_interpolation = \"{interpolation}\"\n"
    );
    let system = format!("{}{COMMON}{solver}", SYSTEM.replace(swing, &by_keys));
    let (line, system) = (line_run(line).history, system_run(&system).history);
    assert_same(&format!("{interpolation} {solver}"), (&line, &system));
}

/// A spline through these rows begins with a velocity.
#[test]
fn moved_by_tables_with_kinks() {
    for interpolation in ["monotone", "linear"] {
        assert_agree_by_table(interpolation, &solver("alpha", "time_step_s = 0.02"));
    }
    assert_agree_by_table("linear", &solver("rk4", "time_step_s = 5e-4"));
    assert_agree_by_table("linear", &solver("quasi", "time_step_s = 0.05"));
}

/// Root mean squares along the line, both waves at the period of the heave, and from when on they are steady.
#[test]
fn the_response_along_the_line() {
    let solver = "[solver]\nduration_s = 40.0\ntime_step_s = 0.02\nerror_estimate = false\n[output]\ninterval_s = 0.1\n\
                  shape_interval_s = 0.5\nresponse_from_s = 16.0\n";
    let start = "[start]\nshape = \"equilibrium\"\n";
    let line = line_run(format!("{LINE}{COMMON}{start}{solver}"));
    let system = system_run(&format!("{SYSTEM}{COMMON}{solver}"));
    let (own, other) = (line.profile(), system.profile());
    let pairs = [
        (&own.rms, &other.rms),
        (&own.rms_vertical, &other.rms_vertical),
        (&own.wave_cos, &other.wave_cos),
        (&own.wave_sin, &other.wave_sin),
        (&own.wkb_number, &other.wkb_number),
    ];
    for (own, other) in pairs {
        assert!(own.len() == 51 && other.len() == 51);
        assert!(own.iter().any(|value| value.abs() > 1e-2), "{own:?}");
        for (own, other) in own.iter().zip(other) {
            assert!((own - other).abs() < 1e-8, "{own} {other}");
        }
    }
    let steady = |run: &Run| run.quantity("response_steady_s.final").map(|q| q.value);
    assert!(steady(&line).is_some());
    assert_eq!(steady(&line), steady(&system));
}
