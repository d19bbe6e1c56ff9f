//! Speed against error at rest, and meshes searched for: what is recommended or reached holds against finer answers. Nothing here asks how long
//! anything took.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::case::{Case, kind};
use seacable::numerics::random::Random;
use seacable::run::accuracy::searchable::{Asked, Searchable};
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};
use seacable::study::speed::at_rest::{self, RestErrors, RestStudy, SceneAtRest, Way};
use seacable::study::speed::{self, SpeedError};
use seacable::system::SystemFile;
use seacable::system::at_rest::{SystemAtRest, main_results, named_result};

/// A shipped system on a mesh of so many segments a line.
fn system(name: &str, segments: usize) -> SystemAtRest {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases/systems")
        .join(name);
    let text = std::fs::read_to_string(path).unwrap();
    let solved = kind::parse_stored::<SystemFile>(&text, name).unwrap();
    let own = SystemAtRest::new(solved.file);
    own.with_file(|file| {
        for line in &mut file.lines {
            line.segments = Some(segments);
        }
    })
}

fn line(name: &str) -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases")
        .join(name);
    seacable::case::load(&path).unwrap().case
}

fn studied<S: SceneAtRest>(scene: &S) -> RestStudy {
    let mut told = 0;
    let mut tell = |number: usize, of: usize, _: &str| {
        told += 1;
        assert!(number <= of, "{number} of {of}");
    };
    let study = at_rest::compute(scene, 1, &AtomicBool::new(false), &mut tell).unwrap();
    assert_eq!(told, study.points.len() + 2);
    study
}

/// The errors of what is recommended against a mesh four times as fine as the reference.
fn checked<S: SceneAtRest>(
    scene: &S,
    study: &RestStudy,
    accuracy: f64,
) -> Option<(String, RestErrors)> {
    let found = study.recommended(accuracy)?;
    let finer: Vec<usize> = study.reference.segments.iter().map(|n| 4 * n).collect();
    let exact = scene
        .answer(Way::Segments, &finer, &AtomicBool::new(false))
        .unwrap();
    let errors = found.answer.as_ref().unwrap().errors(&exact);
    Some((found.name.solver.clone(), errors))
}

#[test]
fn what_is_recommended_is_as_accurate_against_a_finer_mesh() {
    let mut random = Random::new(50, 1);
    let scenes = [
        "volturnus.toml",
        "lazy_wave.toml",
        "crows_foot.toml",
        "chain_and_rope.toml",
    ];
    for name in scenes {
        let segments = 12 + (8.0 * random.uniform()) as usize;
        let scene = system(name, segments);
        let study = studied(&scene);
        let own = study.reference.errors.unwrap();
        let mut held = 0;
        for accuracy in [3e-2, 1e-2, 3e-3] {
            let Some((_, errors)) = checked(&scene, &study, accuracy) else {
                assert!(own.greatest() > 1e-3, "{name}, {accuracy}: {own:?}");
                continue;
            };
            held += 1;
            let allowed = accuracy + 2.0 * own.greatest();
            assert!(
                errors.greatest() <= allowed,
                "{name}, {accuracy}: {errors:?}"
            );
        }
        assert!(held > 0, "{name}: nothing is recommended, {own:?}");
    }
}

#[test]
fn errors_fall_with_the_mesh_and_closed_forms_have_none() {
    let scene = system("lazy_wave.toml", 24);
    let study = studied(&scene);
    let of = |way: &str| -> Vec<f64> {
        let points = study.points.iter().filter(|point| point.name.solver == way);
        points
            .map(|point| point.errors.unwrap().greatest())
            .collect()
    };
    let [closed, meshes] = ["closed form", "segments"].map(of);
    assert_eq!(
        (closed.len(), scene.ways()),
        (1, vec![Way::ClosedForm, Way::Segments])
    );
    assert!(meshes.len() >= 3, "{meshes:?}");
    let (first, last) = (meshes[0], meshes[meshes.len() - 1]);
    assert!(last < 0.1 * first, "{meshes:?}");
    // The bed yields a little under segments.
    assert!(closed[0] < 0.1 * first && study.rigid_bed, "{closed:?}");

    let table = at_rest::table(&study);
    assert_eq!(table.rows.len(), study.points.len() + 1);
    let text = table.to_text(160);
    for word in ["closed form", "reference:", "own error", "does not yield"] {
        assert!(text.contains(word), "{word} is not in\n{text}");
    }
    let recommended = at_rest::recommended_table(&study, &[1e-2, 1e-9]).to_text(120);
    assert!(
        recommended.contains("the reference itself errs by"),
        "{recommended}"
    );
    assert_eq!(at_rest::chart(&study).series.len(), 2);
    let results = at_rest::results_table(&study, &[1e-2]);
    assert_eq!(results.rows.len(), 12);
}

#[test]
fn a_line_by_itself_has_its_closed_form_where_nothing_but_weight_loads_it() {
    let mut case = line("basics/mooring_static.toml");
    assert_eq!(case.ways(), [Way::Segments]);
    assert!(case.left_out()[0].contains("a current acts on the line"));
    case.current = None;
    assert_eq!(case.ways(), [Way::ClosedForm, Way::Segments]);
    let study = studied(&case);
    let closed = study.points[0].errors.unwrap();
    let coarse = study.points[1].errors.unwrap();
    assert!(
        closed.greatest() < 0.05 * coarse.greatest(),
        "{closed:?} {coarse:?}"
    );
    let (way, errors) = checked(&case, &study, 1e-3).unwrap();
    assert!(errors.greatest() < 1e-3, "{way}: {errors:?}");
}

#[test]
fn nothing_at_rest_has_steps_to_compare() {
    let scene = system("volturnus.toml", 16);
    let refused = speed::plan(&scene).err();
    assert_eq!(refused, Some(SpeedError::Static));
    let words = SpeedError::Static.to_string();
    assert!(
        words.contains("no steps to compare") && words.contains("[solver]"),
        "{words}"
    );
}

fn searched(scene: &SystemAtRest, accuracy: f64) -> Run {
    let asked = Asked {
        accuracy,
        budget_s: Some(600.0),
    };
    let request = Request {
        case: scene.asking(Some(asked), true),
        text: String::new(),
        file: String::new(),
        overrides: Vec::new(),
        id: String::new(),
    };
    let run = execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

#[test]
fn the_mesh_of_a_system_at_rest_is_searched_for_an_accuracy() {
    let scene = system("bridle_and_buoy.toml", 40);
    let run = searched(&scene, 2e-3);
    let words = run.info.settings.accuracy.as_deref().unwrap();
    assert!(
        words.starts_with("0.002 asked; ") && words.contains("lines."),
        "{words}"
    );
    assert!(
        run.info
            .overrides
            .iter()
            .all(|key| key.contains(".segments="))
    );
    // Against four times the segments of the file.
    let finer: Vec<usize> = scene.segments().iter().map(|own| 4 * own).collect();
    let finer = scene.with_segments(&finer).unwrap();
    let exact = finer.solve().unwrap();
    let greatest = 176.5e3;
    for id in main_results(&exact) {
        let name = id.to_string();
        let Some(tension) = name
            .strip_prefix("tension_n[")
            .and(name.strip_suffix(".final"))
        else {
            continue;
        };
        let exact = seacable::system::quantities::value(&exact, tension).unwrap();
        let found = run.quantity(&name).unwrap();
        let error = (found.value - exact).abs();
        assert!(error <= 2e-3 * greatest, "{name}: {error}");
        assert!(
            error <= found.error_estimate().unwrap(),
            "{name}: {error} {found:?}"
        );
    }
}

#[test]
fn closed_forms_reach_any_accuracy_at_once_and_know_their_rounding() {
    let run = searched(&system("volturnus.toml", 16), 1e-7);
    let words = run.info.settings.accuracy.as_deref().unwrap();
    assert!(words.contains("1 round"), "{words}");
    let tension = run.quantity("tension_n[chain|b].final").unwrap();
    let error = tension.error_estimate().unwrap();
    assert!(error > 0.0 && error < 1e-6 * tension.value, "{tension:?}");
}

#[test]
fn results_at_rest_are_named_as_in_time() {
    let solved = system("volturnus.toml", 16).solve().unwrap();
    assert!(named_result(&solved, "tension_n[chain|b]").is_ok());
    let near = named_result(&solved, "tension_n[chian|b]").unwrap_err();
    assert!(
        near.contains("did you mean `tension_n[chain|b]`?"),
        "{near}"
    );
}
