//! Accuracy as an input of systems: what is asked is reached, and what was found is kept with the run.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use seacable::run::job::execute;
use seacable::run::{Run, RunState};
use seacable::system::motion::job::{SystemRequest, request};

use crate::{HEAD, solved};

/// Two chains of few segments that meet at a clump, the upper one heaved.
const CHAINS: &str = r#"
environment.water_density_kg_per_m3 = 1025.0
materials.rope = { mass_kg_per_m = 12.0, diameter_m = 0.05, ea_n = 5e6, drag_normal = 1.2 }
points.hang = { kind = "moved", position_m = [0.0, 0.0, 0.0], amplitude_m = [0.4, 0.0, 0.5], period_s = 4.0, ramp_s = 4.0 }
points.clump = { kind = "free", mass_kg = 150.0, volume_m3 = 0.03 }
points.foot = { kind = "fixed", position_m = [30.0, 0.0, -40.0] }
lines = [
  { name = "upper", from = "hang", to = "clump", material = "rope", length_m = 30.0, segments = 4 },
  { name = "lower", from = "clump", to = "foot", material = "rope", length_m = 30.0, segments = 4 },
]
"#;

fn asked(solver: &str) -> SystemRequest {
    of_text(&format!(
        "{CHAINS}solver = {{ {solver}, duration_s = 12.0 }}\n{HEAD}"
    ))
}

fn of_text(text: &str) -> SystemRequest {
    request(
        Arc::new(solved(text)),
        text,
        "test.toml".to_owned(),
        Vec::new(),
    )
    .unwrap()
}

fn computed(request: &SystemRequest) -> Run {
    let run = execute(request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

/// The greatest, least and mean values of every channel that moves are as accurate as asked, by a run on three times the segments.
#[test]
fn what_is_asked_is_reached_and_computed_anew_from_what_is_kept() {
    let run = computed(&asked("accuracy = 5e-3"));
    let words = run.info.settings.accuracy.clone().unwrap();
    assert!(
        !run.info.warnings.iter().any(|w| w.contains("not reached")),
        "{words}"
    );
    let set = |start: &str| run.info.overrides.iter().any(|o| o.starts_with(start));
    assert!(
        set("lines.upper.segments") && set("solver.companions"),
        "{words}"
    );
    let kept = of_text(&run.case_text);
    let motion = &kept.case.motion;
    assert_eq!((motion.accuracy, motion.budget_s), (None, None));
    assert_eq!(computed(&kept).summary, run.summary);

    let mut finer = kept;
    let mut solved = (*finer.case.solved).clone();
    for line in &mut solved.file.lines {
        line.segments = line.segments.map(|segments| 3 * segments);
    }
    let motion = seacable::case::Solver {
        step_tolerance: finer.case.motion.step_tolerance / 32.0,
        error_estimate: false,
        ..finer.case.motion.clone()
    };
    solved.file.solver = Some(motion.clone());
    let solved = seacable::system::solved::solve(solved.file).unwrap();
    finer.case = seacable::system::motion::system_in_time::SystemInTime::new(solved.into(), motion);
    let converged = computed(&finer);
    let (mut missed, mut count) = (Vec::new(), 0);
    for channel in &converged.history.channels {
        let range = channel.peak.0 - channel.trough.0;
        for statistic in ["max", "min", "mean"] {
            let name = format!("{}.{statistic}", channel.id);
            let value = |run: &Run| {
                let all = &run.summary;
                all.iter().find(|q| q.name() == name).map(|q| q.value)
            };
            let (Some(value), Some(exact)) = (value(&run), value(&converged)) else {
                continue;
            };
            if range < 1e-6 {
                continue;
            }
            count += 1;
            if (value - exact).abs() > 5e-3 * range {
                missed.push((name, value, exact));
            }
        }
    }
    assert!(
        count > 10 && 20 * missed.len() <= count,
        "{count}: {missed:#?}\n{words}"
    );
}

/// By every method, and what a budget does not allow is said.
#[test]
fn every_method_is_searched() {
    for method in ["rk4", "quasi", "auto"] {
        let run = computed(&asked(&format!("method = \"{method}\", accuracy = 0.05")));
        let words = run.info.settings.accuracy.clone().unwrap();
        assert!(words.starts_with("0.05 asked; "), "{method}: {words}");
        let kept = of_text(&run.case_text);
        assert_eq!(computed(&kept).summary, run.summary, "{method}");
    }
    let run = computed(&asked("accuracy = 1e-6, budget_s = 1e-6"));
    let said = |w: &String| w.contains("the accuracy of 0.000001 is not reached");
    assert!(
        run.info.warnings.iter().any(said),
        "{:?}",
        run.info.warnings
    );
}

/// A body alone has no mesh: none is refined, and none is spoken of.
#[test]
fn a_body_without_lines_has_an_error_of_its_steps_alone() {
    let body = |solver: &str| {
        of_text(&format!(
            r#"
            bodies.float = {{ kind = "free", mass_kg = 1e6, volume_m3 = 975.6, waterplane_stiffness = [0.0, 0.0, 1e6, 1e8, 1e8, 0.0], inertia_kg_m2 = [1e8, 1e8, 1e8], start_offset_m = [0.0, 0.0, 1.0] }}
            start.placement = "given"
            solver = {{ {solver}, duration_s = 20.0 }}
            {HEAD}"#
        ))
    };
    for method in ["alpha", "rk4"] {
        let step = if method == "rk4" {
            ", time_step_s = 0.2"
        } else {
            ""
        };
        let solver = format!("method = \"{method}\", accuracy = 0.01{step}");
        let run = computed(&body(&solver));
        let words = run.info.settings.accuracy.clone().unwrap();
        assert!(words.contains("reached by 95 % of"), "{method}: {words}");
        let settings = &run.info.settings;
        assert!(
            !settings.error_method.contains("mesh"),
            "{}",
            settings.error_method
        );
        let heave = run
            .summary
            .iter()
            .find(|q| q.name() == "z_m[float].min")
            .unwrap();
        assert!(
            heave.mesh_error.is_none() && heave.error_estimate().is_some(),
            "{heave:?}"
        );
        // Undamped it swings by a metre: z = cos(t).
        assert!((heave.value + 1.0).abs() < 0.02, "{heave:?}");
    }
}
