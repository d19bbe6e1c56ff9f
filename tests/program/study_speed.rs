//! `seacable study speed`: what its table says of a pendulum. Nothing here asks how long anything took.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use assert_cmd::Command;
use seacable::case::{self, Case, Method};
use seacable::chart::{Glyphs, draw};
use seacable::study::speed::{self, SpeedError, SpeedPlan, SpeedStudy};

fn pendulum() -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/basics/pendulum.toml");
    let mut case = case::load(&path).unwrap().case;
    case.solver.duration_s = 4.0;
    case
}

fn computed(case: &Case, plan: SpeedPlan<Case>) -> SpeedStudy {
    let mut reported = Vec::new();
    let mut tell =
        |begun: usize, of: usize, what: &str| reported.push(format!("{begun} {of} {what}"));
    let study = speed::compute(case, plan, 1, &AtomicBool::new(false), &mut tell).unwrap();
    assert_eq!(reported.len(), study.points.len() + 3, "{reported:?}");
    study
}

#[test]
fn errors_fall_with_the_step_and_are_compared_with_another_method() {
    let case = pendulum();
    let plan = speed::plan(&case).unwrap();
    assert_eq!(plan.reference.case.solver.method, Method::Rk4);
    let study = computed(&case, plan);
    let rms = |solver: &str| -> Vec<f64> {
        let points = study.points.iter().filter(|p| p.setting.solver == solver);
        points.map(|p| p.errors.unwrap().tension_rms).collect()
    };
    for solver in ["alpha", "alpha, steps vary"] {
        let errors = rms(solver);
        assert_eq!(errors.len(), 5);
        assert!(errors[4] < 0.1 * errors[0], "{solver}: {errors:?}");
    }
    // The reference is known better than anything that is held against it, its own method left out.
    let own = study.reference.errors.unwrap();
    assert!(own.tension_rms < 0.1 * rms("alpha")[4], "{own:?}");
    assert!(!study.mesh.is_empty() && study.mesh.iter().any(|q| q.mesh_error.is_some()));

    let table = speed::table(&study);
    assert_eq!(table.rows.len(), study.points.len() + 1);
    let text = table.to_text(160);
    for word in [
        "tolerance",
        "reference",
        "own error",
        "Left out: quasi",
        "rk4",
        "ns/node",
    ] {
        assert!(text.contains(word), "{word} is not in\n{text}");
    }
    let picture = draw(&speed::chart(&study), 80, 24, Glyphs::Ascii).to_text();
    assert!(picture.is_ascii() && picture.contains("log10"), "{picture}");
    assert!(
        speed::mesh_table(&study)
            .to_text(120)
            .contains("half the segments")
    );
}

#[test]
fn a_point_that_fails_is_marked_with_its_reason() {
    let case = pendulum();
    let mut plan = speed::plan(&case).unwrap();
    plan.points.truncate(2);
    plan.points[0].case.solver.method = Method::Rk4;
    plan.points[0].case.solver.time_step_s = Some(1.0);
    let study = computed(&case, plan);
    assert!(study.points[0].errors.is_none() && study.points[1].errors.is_some());
    let table = speed::table(&study);
    assert_eq!(table.rows[0].last().unwrap().text, "FAILED [1]");
    assert!(
        table.notes[0].starts_with("[1] ") && table.notes[0].contains("stability limit"),
        "{:?}",
        table.notes
    );
    let drawn: usize = speed::chart(&study)
        .series
        .iter()
        .map(|s| s.points.len())
        .sum();
    assert_eq!(drawn, 1);
}

#[test]
fn nothing_static_is_measured() {
    let mut case = pendulum();
    case.solver.method = Method::Static;
    assert_eq!(speed::plan(&case).err(), Some(SpeedError::Static));
}

#[test]
fn the_command_prints_and_writes_the_table() {
    let folder = tempfile::tempdir().unwrap();
    let csv = folder.path().join("table.csv");
    let mut command = Command::cargo_bin("seacable").unwrap();
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/basics/pendulum.toml");
    command.args([
        "study",
        "speed",
        case,
        "--set",
        "solver.duration_s=1",
        "--repeats",
        "1",
        "--ascii",
        "-o",
    ]);
    let out = command.arg(&csv).assert().success();
    let text = String::from_utf8(out.get_output().stdout.clone()).unwrap();
    assert!(
        text.is_ascii() && text.contains("Error of the mesh"),
        "{text}"
    );
    let written = std::fs::read_to_string(&csv).unwrap();
    let mut lines = written.lines();
    let Some(heads) = lines.next() else {
        panic!("no heads in {written}");
    };
    assert!(heads.contains("tension rms [% of peak]"), "{heads}");
    assert!(lines.count() > 10);
}

#[test]
fn varying_steps_are_compared_with_constant_ones_of_the_same_error() {
    let mut case = pendulum();
    case.solver.duration_s = 2.0;
    let cancel = AtomicBool::new(false);
    let rows = speed::compare(&case, 3, &cancel, &mut |_, _, _| {}).unwrap();
    assert_eq!(rows.len(), 15);
    for of_radius in rows.chunks(5) {
        // A finer tolerance costs more and is nearer.
        assert!(of_radius[4].median.work > of_radius[0].median.work);
        assert!(of_radius[4].median.errors[0] < of_radius[0].median.errors[0]);
    }
    assert!(
        rows.iter()
            .flat_map(speed::WorkComparison::ratios)
            .flatten()
            .count()
            > 0
    );
    let text = speed::comparison_table(&rows, 3).to_text(160);
    assert!(
        text.contains("Median of the ratios at rho") && text.contains("3 variants"),
        "{text}"
    );
    case.solver.method = Method::Static;
    let refused = speed::compare(&case, 1, &cancel, &mut |_, _, _| {});
    assert_eq!(refused.err(), Some(SpeedError::Static));
}

#[test]
fn a_case_without_inertia_is_measured_by_quasi_static_steps() {
    let mut case = pendulum();
    case.solver.method = Method::Quasi;
    let plan = speed::plan(&case).unwrap();
    assert!(plan.points.iter().all(|point| point.name.solver == "quasi"));
    assert_eq!(plan.reference.case.solver.method, Method::Quasi);
    assert!(plan.left_out[0].contains("leaves inertia out"));
}
