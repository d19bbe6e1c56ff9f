//! The hybrid mooring line of Zhu, Yin and Shen 2017.

use std::sync::atomic::AtomicBool;

use seacable::case::{self, Case, Evidence, StudyPoint, StudyValue, edit};
use seacable::reference::{self, Outcome, ValidationRow};
use seacable::run::job::{self, Request};
use seacable::run::{Run, RunState};

const FIXED: &str = include_str!("../../../cases/mooring/hybrid_fixed.toml");
const MOVING: &str = include_str!("../../../cases/mooring/hybrid_moving.toml");

/// A run of a case with changes.
fn run(text: &str, changes: &[(&str, &str)]) -> Run {
    let text = changes.iter().fold(text.to_owned(), |text, (key, value)| {
        edit::set(&text, key, value).unwrap()
    });
    let request = Request {
        case: case::parse(&text, "hybrid.toml").unwrap(),
        text,
        file: "hybrid.toml".to_owned(),
        overrides: Vec::new(),
        id: "hybrid".to_owned(),
    };
    let run = job::execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert_eq!(run.info.state, RunState::Done, "{:?}", run.info.failure);
    run
}

const READING: &str = "materials.polyester.dynamic_stiffness";

/// Rows of a case, every variant computed.
fn rows(text: &str) -> Vec<ValidationRow> {
    let case: Case = case::parse(text, "hybrid.toml").unwrap();
    let runs: Vec<(Option<StudyPoint>, Run)> = reference::plan(&case)
        .into_iter()
        .map(|at| {
            let value = at.as_ref().map(|at| at.value.clone());
            let changes = match &value {
                Some(StudyValue::Word(word)) => vec![(READING, word.as_str())],
                _ => Vec::new(),
            };
            (at.clone(), run(text, &changes))
        })
        .collect();
    reference::rows(&case, &|at| {
        let found = runs.iter().find(|(known, _)| known.as_ref() == at);
        found.map(|(_, run)| run)
    })
}

/// Held still: pretension, mean loads, stiffnesses and ratios, within the tolerances of the printed digits; moved: the
/// eight printed percentages within 5 points and in sign.
#[test]
fn every_printed_figure_comes_out() {
    for (text, count) in [(FIXED, 14), (MOVING, 16)] {
        let rows = rows(text);
        assert_eq!(rows.len(), count);
        for row in rows {
            assert_eq!(row.outcome, Outcome::Pass, "{row:#?}");
        }
    }
}

/// What was fitted to a printed figure says so: only how the mean load goes along the rope, and what moves, is predicted.
#[test]
fn what_was_fitted_is_marked() {
    let case: Case = case::parse(FIXED, "hybrid.toml").unwrap();
    let fitted = case
        .published
        .iter()
        .filter(|p| p.kind == Evidence::Fitted)
        .count();
    assert_eq!((fitted, case.published.len()), (9, 10));
    let case: Case = case::parse(MOVING, "hybrid.toml").unwrap();
    assert!(case.published.iter().all(|p| p.kind != Evidence::Fitted));
}

/// About the mean state, dynamic stiffness is none at rest.
#[test]
fn about_the_mean_a_line_at_rest_has_its_static_tensions() {
    let tensions = |reading| run(FIXED, &[(READING, reading)]).profile.tension;
    let (a, b) = (tensions("none"), tensions("about-the-mean"));
    for (a, b) in a.iter().zip(&b) {
        assert!((a - b).abs() < 1.0, "{a} {b}");
    }
}

/// Greatest less smallest value of a channel in the second half of the run.
fn swing(run: &Run, channel: &str) -> f64 {
    let values = &run.history.channel(channel).unwrap().values;
    let late = &values[values.len() / 2..];
    let most = late.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most - late.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Figs 14, 15, 17 and 18: the lower end of the polyester swings more than the upper, in tension and in stiffness.
#[test]
fn the_lower_end_of_the_polyester_swings_more() {
    for reading in ["secant", "about-the-mean"] {
        let run = run(
            MOVING,
            &[(READING, reading), ("solver.error_estimate", "false")],
        );
        for quantity in ["load_deviation_percent", "stiffness_k"] {
            let at = |end: &str| swing(&run, &format!("{quantity}[polyester.{end}]"));
            assert!(at("a") > 1.05 * at("b"), "{reading} {quantity}");
        }
        let tension = |joint: &str| swing(&run, &format!("tension_n[{joint}]"));
        assert!(tension("lower|polyester") > tension("polyester|upper"));
        // What the line remembers along the rope is recorded along with the channels.
        let ropes = &run.profile.ropes;
        assert_eq!(ropes.arc.len(), 80);
        assert!((ropes.arc[0] - 1537.5).abs() < 1e-9);
        let last = |channel: &str| *run.history.channel(channel).unwrap().values.last().unwrap();
        assert_eq!(ropes.mean_load[0], last("mean_load_percent[polyester.a]"));
        assert_eq!(ropes.stiffness[79], last("stiffness_k[polyester.b]"));
        assert!(ropes.mean_load.windows(2).all(|pair| pair[1] > pair[0]));
    }
}

/// Tensions are held against breaking loads at every step: a peak between two output times is found.
#[test]
fn a_peak_between_output_times_breaks_the_rope() {
    let few = [
        ("solver.error_estimate", "false"),
        ("solver.time_step_s", "0.125"),
        ("solver.duration_s", "60"),
        // Every output falls where the top stands at its mean.
        ("output.interval_s", "5"),
        ("materials.chain.break_load_n", "2.68e6"),
    ];
    let run = run(MOVING, &few);
    let top = run.history.channel("tension_n[upper|top]").unwrap();
    let shown = top.values.iter().copied().fold(0.0, f64::max);
    assert!(
        shown < 2.68e6 && top.peak.0 > 2.68e6,
        "{shown} {}",
        top.peak.0
    );
    let greatest = run.profile.tension_max.iter().copied().fold(0.0, f64::max);
    assert!((greatest / top.peak.0 - 1.0).abs() < 1e-3, "{greatest}");
    let reported = |word: &&String| word.contains("beyond its breaking load");
    assert!(
        run.info.warnings.iter().any(|w| reported(&w)),
        "{:?}",
        run.info.warnings
    );
}
