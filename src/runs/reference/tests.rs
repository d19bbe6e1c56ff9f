//! Rows against runs made by hand.

use super::{CalibrationBasis, Outcome, ValidationRow, count_outcomes, plan, rows};
use crate::{
    case::{Case, StudyPoint},
    run::{Channel, History, Quantity, Run, RunInfo, RunState, Settings},
};

const CASE: &str = r#"
[case]
title = "x"
[materials.m]
diameter_m = 0.1
mass_kg_per_m = 10.0
ea_n = 1e8
[[line]]
name = "wire"
material = "m"
length_m = 100.0
segments = 4
[ends.a]
name = "vessel"
kind = "fixed"
[ends.b]
name = "payload"
kind = "free"

[[study]]
name = "current"
key = "current.speed_m_per_s"
values = [0.4, 0.0, 0.2]
"#;

const VALUE: &str = r#"
[[published]]
name = "mean tension"
channel = "tension_n[wire|payload]"
statistic = "mean"
window_s = [0, 200]
value = 100.0
tolerance_rel = 0.03
source = "sec. 2"
inputs = "published"
"#;

const TREND: &str = r#"
[[trend]]
name = "travel shrinks"
study = "current"
channel = "z_m[payload]"
statistic = "travel"
expect = "falls"
source = "fig. 9"
"#;

fn case(parts: &[&str]) -> Case {
    crate::case::parse_keys(&format!("{CASE}{}", parts.concat())).unwrap()
}

fn run(quantities: &[(&str, f64, f64)]) -> Run {
    let quantity = |&(name, value, error): &(&str, f64, f64)| Quantity {
        id: name.parse().unwrap(),
        value,
        time_error: Some(error / 2.0),
        mesh_error: Some(error / 2.0),
        unsettled: None,
    };
    let channel = Channel::new("tension_n[wire|payload]".parse().unwrap());
    Run {
        info: RunInfo {
            id: String::new(),
            title: String::new(),
            case_file: String::new(),
            state: RunState::Done,
            version: String::new(),
            started: String::new(),
            overrides: Vec::new(),
            failure: None,
            warnings: Vec::new(),
            happened: Vec::new(),
            settings: Settings::default(),
            work: crate::run::Work::default(),
            cost: crate::run::Cost::default(),
        },
        case_text: String::new(),
        history: History {
            time: Vec::new(),
            channels: vec![channel],
        },
        shapes: Vec::new(),
        profiles: Vec::new(),
        summary: quantities.iter().map(quantity).collect(),
        fatigue: Vec::new(),
    }
}

const MEAN: &str = "tension_n[wire|payload].mean(0..200)";

fn one(value: f64, error: f64, extra: &str) -> ValidationRow {
    let run = run(&[(MEAN, value, error)]);
    rows(&case(&[VALUE, extra]), &|_| Some(&run)).remove(0)
}

#[test]
fn within_the_tolerance_passes_to_the_last_bit_and_beyond_it_fails() {
    assert_eq!(one(103.0, 0.1, "").outcome, Outcome::Pass);
    assert_eq!(one(97.0, 0.1, "").outcome, Outcome::Pass);
    assert_eq!(one(103.0_f64.next_up(), 0.1, "").outcome, Outcome::Fail);
    let row = one(98.0, 0.1, "");
    assert_eq!(
        (row.published, row.computed, row.difference),
        (Some(100.0), Some(98.0), Some(-2.0))
    );
    assert_eq!(
        (row.tolerance, row.error, row.reason),
        (Some(3.0), Some(0.1), None)
    );
}

#[test]
fn the_wider_of_two_tolerances_counts() {
    assert_eq!(
        one(105.0, 0.1, "tolerance_abs = 5.0").outcome,
        Outcome::Pass
    );
    assert_eq!(
        one(103.0, 0.1, "tolerance_abs = 0.5").outcome,
        Outcome::Pass
    );
}

#[test]
fn a_number_declared_out_of_reach_differs_with_its_reason() {
    let extra = "out_of_reach = \"The floats are not printed.\"";
    let row = one(150.0, 0.1, extra);
    assert_eq!(row.outcome, Outcome::Differs);
    assert_eq!(row.reason.as_deref(), Some("The floats are not printed."));
    let row = one(101.0, 0.1, extra);
    assert_eq!(row.outcome, Outcome::Pass);
    assert!(row.reason.unwrap().contains("declaration can go"));
}

#[test]
fn an_error_that_is_not_small_beside_the_tolerance_is_said() {
    assert!(
        one(101.0, 0.31, "")
            .reason
            .unwrap()
            .contains("more than a tenth")
    );
    assert_eq!(one(101.0, 0.3, "").reason, None);
    let row = one(150.0, 0.31, "out_of_reach = \"No.\"");
    assert!(row.reason.unwrap().starts_with("No. Its estimated"));
}

#[test]
fn what_was_fitted_is_told_from_what_was_predicted() {
    let calibrated = VALUE.replace("inputs = \"published\"", "inputs = \"calibrated\"");
    let basis = |parts: &[&str]| {
        rows(&case(parts), &|_| None)
            .iter()
            .map(|row| row.basis)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        basis(&[VALUE, &calibrated]),
        [None, Some(CalibrationBasis::Prediction)]
    );
    let fitted = format!("{calibrated}kind = \"fitted\"\n");
    assert_eq!(
        basis(&[&fitted, &calibrated]),
        [
            Some(CalibrationBasis::Fitted),
            Some(CalibrationBasis::FittedNearby)
        ]
    );
    let elsewhere = calibrated.replace("[0, 200]", "[0, 100]");
    assert_eq!(
        basis(&[&fitted, &elsewhere]),
        [
            Some(CalibrationBasis::Fitted),
            Some(CalibrationBasis::Prediction)
        ]
    );
}

#[test]
fn what_is_missing_is_an_outcome_with_its_reason() {
    let reason = |run: Option<&Run>| {
        let row = rows(&case(&[VALUE]), &|_| run).remove(0);
        assert_eq!((row.outcome, row.computed), (Outcome::NotRun, None));
        assert_eq!(row.unit, "N");
        row.reason.unwrap()
    };
    assert!(reason(None).contains("has not been run"));
    assert!(
        reason(Some(&run(&[]))).contains("does not hold `tension_n[wire|payload].mean(0..200)`")
    );
    assert!(reason(Some(&run(&[(MEAN, f64::NAN, 0.0)]))).contains("no finite value"));

    let mut other = run(&[]);
    other.history.channels[0].id = "x_m[b]".parse().unwrap();
    assert!(reason(Some(&other)).contains("it has x_m[b]"));

    let mut failed = run(&[(MEAN, 100.0, 0.0)]);
    failed.info.failure = Some("Newton gave up at 3 s.".to_owned());
    for (state, word) in [
        (RunState::Failed, "Newton gave up at 3 s."),
        (RunState::Cancelled, "cancelled"),
        (RunState::Partial, "partial"),
    ] {
        failed.info.state = state;
        assert!(reason(Some(&failed)).contains(word));
    }
}

/// A trend row from travels at 0, 0.2 and 0.4 m/s.
fn trend(extra: &str, travels: [f64; 3], error: f64) -> ValidationRow {
    let runs = travels.map(|t| run(&[("z_m[payload].travel", t, error)]));
    let pick = |at: Option<&StudyPoint>| {
        at.map(|at| &runs[(at.value.number().unwrap() / 0.2).round() as usize])
    };
    rows(&case(&[TREND, extra]), &pick).remove(0)
}

#[test]
fn a_trend_holds_when_every_step_does() {
    let row = trend("", [3.0, 2.0, 1.0], 0.1);
    assert_eq!((row.outcome, row.reason), (Outcome::Pass, None));
    let line = row.trend.unwrap();
    let values: Vec<Option<f64>> = line.points.iter().map(|p| p.value.number()).collect();
    assert_eq!(values, [Some(0.0), Some(0.2), Some(0.4)]);
    assert_eq!(line.points[2].computed, Some(1.0));

    let row = trend("", [3.0, 1.0, 2.0], 0.1);
    assert_eq!(row.outcome, Outcome::Fail);
    assert!(row.reason.unwrap().contains("from 0.2 to 0.4"));
    assert_eq!(trend("", [3.0, 3.0, 1.0], 0.1).outcome, Outcome::Fail);
    let row = trend("out_of_reach = \"Why.\"", [3.0, 3.0, 1.0], 0.1);
    assert_eq!(
        (row.outcome, row.reason.as_deref()),
        (Outcome::Differs, Some("Why."))
    );
}

#[test]
fn a_step_within_the_errors_shows_nothing() {
    let row = trend("", [3.0, 2.9, 1.0], 0.1);
    assert_eq!(row.outcome, Outcome::Fail);
    assert!(row.reason.unwrap().contains("from 0 to 0.2 is no larger"));
}

#[test]
fn two_points_are_no_trend() {
    let two = TREND.replace("study = \"current\"", "study = \"two\"");
    let study = "[[study]]\nname = \"two\"\nkey = \"current.speed_m_per_s\"\nvalues = [0.0, 0.4]\n";
    let run = run(&[("z_m[payload].travel", 1.0, 0.1)]);
    let row = rows(&case(&[study, &two]), &|_| Some(&run)).remove(0);
    assert_eq!(row.outcome, Outcome::NotRun);
    assert!(row.reason.unwrap().contains("needs 3 values"));
}

#[test]
fn a_trend_with_a_gap_is_not_run() {
    let run = run(&[("z_m[payload].travel", 1.0, 0.1)]);
    let case = case(&[TREND]);
    let row = rows(&case, &|at| {
        at.filter(|a| a.value.number() < Some(0.3)).map(|_| &run)
    })
    .remove(0);
    assert_eq!(row.outcome, Outcome::NotRun);
    assert!(row.reason.unwrap().contains("At 0.4"));
}

#[test]
fn the_plan_lists_every_variant_once() {
    let at = "at = { study = \"current\", value = 0.2 }\n";
    let case = case(&[VALUE, VALUE, at, VALUE, at, TREND]);
    let planned: Vec<Option<f64>> = plan(&case)
        .iter()
        .map(|p| p.as_ref().and_then(|a| a.value.number()))
        .collect();
    assert_eq!(planned, [None, Some(0.2), Some(0.4), Some(0.0)]);
}

#[test]
fn outcomes_are_counted() {
    let rows = [
        one(100.0, 0.1, ""),
        one(150.0, 0.1, ""),
        one(150.0, 0.1, "out_of_reach = \"x\""),
    ];
    let counts = count_outcomes(&rows);
    assert_eq!(
        (counts.pass, counts.fail, counts.differs, counts.total()),
        (1, 1, 1, 3)
    );
    assert!(!counts.holds());
    assert!(count_outcomes(&rows[2..]).holds());
    assert_eq!(
        counts.to_string(),
        "3 rows: 1 PASS, 1 FAIL, 1 DIFFERS, 0 NOT RUN"
    );
}
