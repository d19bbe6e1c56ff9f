//! Accuracy as an input: what is asked is reached, against a converged run, and what is not reached is said.

use crate::lines;
use std::sync::atomic::AtomicBool;

use seacable::case::{self, Case};
use seacable::laboratory::accuracy::{self, AccuracyTrial};
use seacable::run::event::JobEvent;
use seacable::run::job::{Request, execute};
use seacable::run::{Run, RunState};

/// A heaved line of few segments.
fn request(solver: &str) -> Request {
    let case = lines::line(&format!(
        r#"
        environment.water_density_kg_per_m3 = 1025.0
        materials.rope = {{ mass_kg_per_m = 12.0, drag_normal = 1.2 }}
        line = {{ length_m = 60.0, segments = 6 }}
        ends.a = {{ kind = "moving", amplitude_m = [0.4, 0.0, 0.5], period_s = 4.0, ramp_s = 4.0 }}
        ends.b = {{ name = "foot", kind = "anchor", position_m = [30.0, 0.0, -40.0] }}
        solver = {{ {solver}, duration_s = 12.0, error_estimate = true }}
        "#
    ));
    Request {
        text: case::write(&case),
        case,
        file: "test.toml".to_owned(),
        overrides: Vec::new(),
        id: "test".to_owned(),
    }
}

fn computed(request: &Request) -> Run {
    let run = execute(request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

/// The case as found, which asks for no accuracy any more.
fn found(run: &Run) -> Case {
    let case = case::parse(&run.case_text, "test.toml").unwrap();
    assert_eq!((case.solver.accuracy, case.solver.budget_s), (None, None));
    assert!(case.solver.companions.is_some());
    case
}

#[test]
fn what_is_asked_is_reached_and_computed_anew_from_what_is_kept() {
    let run = computed(&request("accuracy = 2e-3"));
    let words = run.info.settings.accuracy.clone().unwrap();
    assert!(
        !run.info.warnings.iter().any(|w| w.contains("not reached")),
        "{words}"
    );
    assert!(
        run.info.overrides.iter().any(|o| o.starts_with("line.")),
        "{words}"
    );
    let kept = found(&run);
    assert!(kept.line[0].segments > 6, "{words}");
    let again = computed(&Request {
        case: kept.clone(),
        ..request("accuracy = 2e-3")
    });
    assert_eq!(again.summary, run.summary);

    let mut finer = kept;
    finer.line[0].segments *= 3;
    finer.solver.step_tolerance /= 32.0;
    finer.solver.longest_step_s = None;
    finer.solver.error_estimate = false;
    let converged = computed(&Request {
        case: finer,
        ..request("accuracy = 2e-3")
    });
    let mut missed = Vec::new();
    let mut count = 0;
    for channel in &converged.history.channels {
        let range = channel.peak.0 - channel.trough.0;
        for statistic in ["max", "min", "mean"] {
            let name = format!("{}.{statistic}", channel.id);
            let value = |run: &Run| {
                run.summary
                    .iter()
                    .find(|q| q.name() == name)
                    .map(|q| q.value)
            };
            let (Some(value), Some(exact)) = (value(&run), value(&converged)) else {
                continue;
            };
            count += 1;
            if (value - exact).abs() > 2e-3 * range {
                missed.push((name, value, exact));
            }
        }
    }
    assert!(
        count > 10 && 20 * missed.len() <= count,
        "{count}: {missed:#?}\n{words}"
    );
}

#[test]
fn what_a_budget_does_not_allow_is_said_and_the_best_is_kept() {
    let run = computed(&request("accuracy = 1e-6, budget_s = 1e-6"));
    let warning = run
        .info
        .warnings
        .iter()
        .find(|w| w.contains("not reached"))
        .unwrap();
    assert!(warning.contains("next round needs"), "{warning}");
    // The first levels are computed all the same: without them nothing is known of the errors.
    let words = run.info.settings.accuracy.clone().unwrap();
    assert!(words.contains("(5 rounds, "), "{words}");
    assert_eq!(found(&run).line[0].segments, 4);
    assert!(run.summary.iter().any(|q| q.error_estimate().is_some()));
}

/// A clump that only the mesh of the case has at a node: all levels are as fine as that or finer, and dearer than the case as it is set.
#[test]
fn a_case_dearer_to_search_than_to_compute_is_computed_as_it_is_set() {
    let mut request = request("method = \"alpha\", accuracy = 1e-6, budget_s = 1e-6");
    request.text += "\n[[clumps]]\nname = \"c\"\nsection = \"rope\"\nat_m = 10.0\nmass_kg = 20.0\nwet_mass_kg = 15.0\n";
    request.case = case::parse(&request.text, "test.toml").unwrap();
    let run = computed(&request);
    let words = run.info.settings.accuracy.clone().unwrap();
    assert!(words.contains("(1 round, "), "{words}");
    let warns = |what: &str| run.info.warnings.iter().any(|w| w.contains(what));
    assert!(
        warns("not reached") && warns("as it is set"),
        "{:?}",
        run.info.warnings
    );
    assert_eq!(run.info.settings.nodes, 7);
    assert!(run.summary.iter().any(|q| q.error_estimate().is_some()));
}

/// The rounds are told as they come; the run that is kept is reported once, whole.
#[test]
fn a_search_tells_its_rounds_and_reports_one_run() {
    let (mut rounds, mut started, mut frames) = (Vec::new(), 0, 0);
    let run = execute(
        &request("accuracy = 2e-3"),
        &AtomicBool::new(false),
        &mut |event| match event {
            JobEvent::Searching(search) => rounds.push(search),
            JobEvent::Started { .. } => started += 1,
            JobEvent::Frame(_) => frames += 1,
            _ => {}
        },
    );
    assert_eq!((started, frames), (1, run.history.time.len()));
    // Five levels show the first errors.
    let known = rounds.iter().position(|round| round.reached.is_some());
    assert_eq!(known, Some(5), "{rounds:?}");
    assert_eq!(rounds[1].to_string(), "accuracy 2e-3: round 2");
    let words = rounds[5].to_string();
    assert!(words.starts_with("accuracy 2e-3: round 6, "), "{words}");
}

#[test]
fn the_study_finds_it_met_and_a_cheapest_setting() {
    let mut request = request("method = \"alpha\"");
    request.case.line[0].segments = 24;
    let trial = AccuracyTrial {
        name: "line".to_owned(),
        asked: 3e-2,
        budget_s: 20.0,
    };
    let (case, text) = (&request.case, case::write(&request.case));
    let found = accuracy::check(&trial, case, &text, &AtomicBool::new(false)).unwrap();
    assert!(found.said && found.results > 20, "{found:?}");
    assert!(20 * found.within >= 19 * found.results, "{found:?}");
    let [cheapest, knowing] = [found.cheapest, found.knowing].map(|setting| setting.unwrap().cpu_s);
    assert!(cheapest > 0.0 && cheapest < knowing && cheapest < found.cpu_s);
}

/// Where nothing moves, forces across that are zero but for rounding are a part of the weight.
#[test]
fn forces_that_are_zero_are_a_part_of_those_that_are_not() {
    let case = lines::line(
        r#"
        materials.rope = { mass_kg_per_m = 12.0 }
        line = { length_m = 60.0, segments = 6 }
        ends.a = { kind = "fixed" }
        ends.b = { name = "load", kind = "payload" }
        payload = { dry_mass_kg = 100.0, wet_mass_kg = 100.0, added_mass_kg = 0.0, drag_area_m2 = 1.0 }
        solver = { method = "static", accuracy = 1e-2 }
        "#,
    );
    let run = computed(&Request {
        text: case::write(&case),
        case,
        ..request("accuracy = 2e-3")
    });
    let words = run.info.settings.accuracy.clone().unwrap();
    assert!(words.contains("(3 rounds,"), "{words}");
    assert!(!run.info.warnings.iter().any(|w| w.contains("not reached")));
}

/// Errors by other companions are about those by the usual ones, and the run says which they are.
#[test]
fn companions_can_be_named() {
    let of = |companions: &str| {
        let mut request = request(companions);
        request.case.line[0].segments = 24;
        request.case.solver.step_tolerance = 1e-6;
        let run = computed(&request);
        let q = run
            .summary
            .iter()
            .find(|q| q.name() == "tension_n[top|rope].max");
        let q = q.unwrap();
        (
            run.info.settings.error_method.clone(),
            [q.time_error.unwrap(), q.mesh_error.unwrap()],
        )
    };
    let (usual, errors) = of("method = \"alpha\"");
    assert!(
        usual.contains("27 times the error allowed in a step"),
        "{usual}"
    );
    for (companions, words) in [
        (
            r#"companions = ["nearest"]"#,
            "time: 8 times the error allowed in a step, and 64 times",
        ),
        (
            r#"companions = ["steps", "mesh", "steps", "mesh"]"#,
            "on half the segments",
        ),
    ] {
        let (method, named) = of(companions);
        assert!(method.contains(words), "{method}");
        for (a, b) in errors.into_iter().zip(named) {
            assert!((0.1..10.0).contains(&(a / b)), "{companions}: {a} {b}");
        }
    }
}

#[test]
fn steps_that_vary_are_no_longer_than_the_longest() {
    let longest = |solver: &str| {
        let run = computed(&request(solver));
        (run.info.settings.time_step_s, run.info.work.steps)
    };
    let (own, steps) = longest("step_tolerance = 1e-2");
    let (bound, more) = longest("step_tolerance = 1e-2, longest_step_s = 0.02");
    assert!(own > 0.05 && (bound - 0.02).abs() < 1e-15, "{own} {bound}");
    assert!(more >= 600 && more > 2 * steps, "{steps} {more}");
}

#[test]
fn companions_and_steps_that_contradict_are_refused() {
    let problems = |solver: &str| {
        let text = case::write(&request("method = \"alpha\"").case);
        let text = text.replace("[solver]\n", &format!("[solver]\n{solver}\n"));
        let found = case::parse(&text, "test.toml").unwrap_err();
        found
            .iter()
            .map(|d| format!("{}: {}", d.key, d.problem))
            .collect::<String>()
    };
    let unknown = problems(r#"companions = ["steps", "nearest"]"#);
    assert!(unknown.contains("is not known: \"nearest\""), "{unknown}");
    let both = problems("time_step_s = 0.1\nlongest_step_s = 0.1");
    assert!(both.contains("steps of one length"), "{both}");
}
