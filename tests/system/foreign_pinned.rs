//! Files of MoorDyn with rods and bodies that are pinned, and without lines.

use std::f64::consts::PI;
use std::fs;

use seacable::audit::audit;
use seacable::case::kind;
use seacable::export::{ExportOptions, Target, export};
use seacable::import::{self, ImportOptions};
use seacable::report::audit::page;
use seacable::system::SolvedSystem;
use seacable::system::SystemFile;
use seacable::system::quantities::value;

const G: f64 = 9.80665;

/// Two rods that float on their pins.
const PINNED: &str = "\
--- ROD TYPES ---
Name Diam Mass/m Cd Ca CdEnd CaEnd
(-)
rod 0.25 10 0 0 0 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs
(-)
1 rod Pinned 0 0 -5 1 0 -5 1 -
2 rod Pinned 0 0 -5 0 1 -5 1 -
--- OPTIONS ---
1000 WtrDnsty
10 WtrDpth
";

/// A body whose origin another program moves, with a rod below.
const COUPLED: &str = "\
--- ROD TYPES ---
Name Diam Mass/m Cd Ca CdEnd CaEnd
(-)
can 2 5e3 0.6 1 1.2 1
--- BODIES ---
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG I Volume CdA Ca
(-)
1 CoupledPinned 0 0 -5 0 0 0 0 0 0 0 0 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs
(-)
1 can Body1 0 0 -5 0 0 -15 3 p
--- POINTS ---
ID Type X Y Z M V CdA Ca
(-)
1 Body1 0 0 -15 100 0 0 0
--- OPTIONS ---
0.0 WtrDnsty
30 WtrDpth
";

/// A moored body with a rod fixed on it, and another pinned to it.
const ON_BODY: &str = "\
--- LINE TYPES ---
Name Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(-)
nylon 0.124 13.76 2.5e6 -0.8 0 1.6 1 0.05 0
--- ROD TYPES ---
Name Diam Mass/m Cd Ca CdEnd CaEnd
(-)
can 10 1e3 0.6 1 1.2 1
spar 1 500 0.6 1 0 0
--- BODIES ---
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG I Volume CdA Ca
(-)
1 Free 0 0 0 0 0 0 9.4e5 0|0|-8 1e8 0 0 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs
(-)
1 can Body1 0 0 -12 0 0 8 3 p
2 spar Body1Pinned 5 0 -2 14 0 -3 3 p
--- POINTS ---
ID Type X Y Z M V CdA Ca
(-)
1 Fixed 267 0 -70 0 0 0 0
2 Fixed -133.5 231.23 -70 0 0 0 0
3 Fixed -133.5 -231.23 -70 0 0 0 0
4 Body1 5 0 -10 0 0 0 0
5 Body1 -2.5 4.33 -10 0 0 0 0
6 Body1 -2.5 -4.33 -10 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(-)
1 nylon 1 4 265 10 p
2 nylon 2 5 265 10 p
3 nylon 3 6 265 10 p
--- OPTIONS ---
70 WtrDpth
";

fn case_of(text: &str, options: &ImportOptions) -> String {
    let read = import::read(text, "file.dat", options);
    read.unwrap_or_else(|all| panic!("{all:#?}")).text
}

fn solved(case: &str) -> SolvedSystem {
    kind::parse::<SystemFile>(case, "case.toml").unwrap_or_else(|all| panic!("{case}\n{all:#?}"))
}

fn read(text: &str) -> SolvedSystem {
    solved(&case_of(text, &ImportOptions::default()))
}

#[test]
fn pinned_rods_without_lines_float_upright() {
    let system = read(PINNED);
    let net = (10.0 - 1000.0 * 0.25 * PI * 0.0625) * G;
    for rod in ["rod1", "rod2"] {
        let force = value(&system, &format!("pin_force_z_n[{rod}]")).unwrap();
        assert!((force - net).abs() < 1e-9, "{force}");
        let top = crate::place(&system, &format!("{rod}-b"));
        assert!((top[2] + 4.0).abs() < 1e-9, "{top:?}");
    }
}

#[test]
fn a_coupled_pin_follows_its_coordinates() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("motion.csv");
    let row = |k: i32| {
        let t = 0.5 * f64::from(k);
        format!("{t} {} 0 -5 0 0 0\n", 0.3 * (0.4 * t).sin())
    };
    fs::write(&table, (0..=20).map(row).collect::<String>()).unwrap();
    let options = ImportOptions {
        motion: Some(table),
        ..ImportOptions::default()
    };
    let case = case_of(COUPLED, &options);
    for part in [
        "kind = \"pinned\"",
        "table_x_m",
        "[points.p1]",
        "duration_s = 10.0",
    ] {
        assert!(case.contains(part), "{part}: {case}");
    }
    assert!(!case.contains("table_roll_deg"), "{case}");
    let system = solved(&case);
    // The rod, and the point at its end.
    let [body] = &system.network.bodies[..] else {
        panic!("{case}")
    };
    assert!((body.mass - 50_100.0).abs() < 1e-6);
    let centre = (50_000.0 * 10.0 + 100.0 * 15.0) / 50_100.0;
    assert!((body.centre_of_gravity.z + centre).abs() < 1e-9);
    let given = system.file.solver.clone().unwrap();
    let run = seacable::system::motion::run::run(
        &system,
        &given,
        &std::sync::atomic::AtomicBool::new(false),
        &mut |_| {},
    );
    let run = run.unwrap();
    assert_eq!(run.failure, None);
    let x = crate::motion::channel(&run, "x_m[body1]");
    for (t, x) in run.history.time.iter().zip(x) {
        assert!((x - 0.3 * (0.4 * t).sin()).abs() < 1e-3, "{t}: {x}");
    }
    let turned = crate::motion::channel(&run, "pitch_deg[body1]");
    assert!(turned.iter().any(|angle| angle.abs() > 0.1), "{turned:?}");
    // A rod has no such coordinates here.
    let rod = COUPLED.replace("1 can Body1 ", "1 can CoupledPinned ");
    let rod = rod.replace("1 CoupledPinned 0 0 -5 0", "1 Fixed 0 0 -5 0");
    let row = |k: i32| format!("{} 0 0 -5\n", 0.5 * f64::from(k));
    fs::write(
        options.motion.as_ref().unwrap(),
        (0..=20).map(row).collect::<String>(),
    )
    .unwrap();
    let refused = import::read(&rod, "file.dat", &options).unwrap_err();
    let problem = &refused[0].problem;
    assert!(
        problem.contains("a pinned rod whose end follows a motion"),
        "{problem}"
    );
    assert_eq!(refused[0].line, 12);
}

#[test]
fn a_rod_pinned_to_a_body_is_written_and_read_again() {
    let system = read(ON_BODY);
    assert_eq!(system.network.bodies.len(), 2);
    let made = export(&system, Target::MoorDyn, ExportOptions::default()).unwrap();
    assert!(made.text.contains("Body1Pinned"), "{}", made.text);
    let again = read(&made.text);
    let twice = export(&again, Target::MoorDyn, ExportOptions::default()).unwrap();
    assert_eq!(twice.text, made.text);
    let refused = export(&system, Target::MapPlusPlus, ExportOptions::default()).unwrap_err();
    assert!(
        refused.iter().any(|one| one.what.contains("pinned rods")),
        "{refused:?}"
    );
    // The rod floats: its far end is at the surface, and its pin holds it down.
    let force = |system: &SolvedSystem| value(system, "pin_force_z_n[rod2]").unwrap();
    assert!(force(&system) < 0.0, "{}", force(&system));
    let end = crate::place(&system, "rod2-b");
    assert!(end[2] > -1.0 && end[2] < 4.0, "{end:?}");
    assert!((force(&again) / force(&system) - 1.0).abs() < 1e-6);
}

#[test]
fn the_rest_of_such_files_is_written_and_judged_as_far_as_it_goes() {
    for text in [PINNED, COUPLED] {
        let system = read(text);
        let made = export(&system, Target::MoorDyn, ExportOptions::default()).unwrap();
        let twice = export(&read(&made.text), Target::MoorDyn, ExportOptions::default()).unwrap();
        assert_eq!(twice.text, made.text);
        let judged = audit(text, "file.dat", &ImportOptions::default()).unwrap();
        let said = "there are no lines";
        assert!(judged.not_judged.iter().any(|what| what.contains(said)));
        assert!(page(&judged).contains(said));
    }
    let judged = audit(ON_BODY, "file.dat", &ImportOptions::default()).unwrap();
    assert_eq!(judged.lines.len(), 3);
}

#[test]
fn a_file_in_which_nothing_moves_is_refused() {
    let text = PINNED.replace("Pinned", "Fixed");
    let refused = import::read(&text, "file.dat", &ImportOptions::default()).unwrap_err();
    let problem = &refused[0].problem;
    assert!(
        problem.contains("no lines, and no body or rod"),
        "{problem}"
    );
}
