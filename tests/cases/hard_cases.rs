//! Hard cases: every trial comes out as it must, on any number of threads, and nothing is silently wrong.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use seacable::study::hard_cases::{self, HardCase, TrialRun, TrialTask};
use seacable::study::{TrialOutcome, TrialVerdict, tally};

fn compute(cases: &[HardCase], tasks: &[TrialTask]) -> Vec<Option<TrialRun>> {
    let one = |task: &TrialTask| {
        let hard = &cases[task.case];
        Some(hard_cases::compute(
            hard,
            &hard.trials[task.trial],
            &AtomicBool::new(false),
        ))
    };
    tasks.par_iter().map(one).collect()
}

fn findings(cases: &[HardCase]) -> Vec<TrialVerdict> {
    hard_cases::verdicts(cases, &compute(cases, &hard_cases::tasks(cases)))
}

fn reported(finding: &TrialVerdict) -> String {
    format!(
        "{}, {}: {} {:?} {:?}",
        finding.file,
        finding.trial,
        finding.outcome.word(),
        finding.reason,
        finding.numbers
    )
}

#[test]
fn every_trial_comes_out_as_it_must() {
    let cases = hard_cases::shipped().unwrap();
    assert!(cases.len() >= 20);
    let findings = findings(&cases);
    let off: Vec<String> = findings
        .iter()
        .filter(|f| !f.is_as_expected())
        .map(reported)
        .collect();
    assert!(off.is_empty(), "{}", off.join("\n"));
    let chosen = |trial: &str| {
        let found = findings.iter().find(|f| f.trial == trial);
        found.unwrap().settings.clone().unwrap()
    };
    for method in ["rk4", "alpha"] {
        let settings = chosen(&format!("auto, {method} costs less"));
        assert_eq!(settings.method, method);
        assert!(settings.method_reason.unwrap().starts_with(method));
    }
    let tally = tally(&findings);
    assert!(
        tally.holds() && tally.refused >= 5 && tally.ok >= 60,
        "{tally}"
    );
}

#[test]
fn the_table_does_not_depend_on_the_number_of_threads() {
    let mut cases = hard_cases::shipped().unwrap();
    cases.retain(|hard| {
        ["hard/stop.toml", "hard/taut.toml", "hard/coincident.toml"].contains(&hard.file.as_str())
    });
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| findings(&cases))
    };
    let one = on(1);
    assert!(one.len() > 8);
    for threads in [2, 5] {
        assert_eq!(on(threads), one);
    }
}

/// A case of one hanging rope, its trials added.
fn small(trials: &str) -> Vec<TrialVerdict> {
    let text = format!(
        r#"
        case.title = "small"
        materials.rope = {{ diameter_m = 0.05, mass_kg_per_m = 10.0, wet_weight_kg_per_m = 10.0, ea_n = 1e8 }}
        line = [{{ name = "rope", material = "rope", length_m = 100.0, segments = 4 }}]
        ends.a = {{ name = "top", kind = "fixed", position_m = [0.0, 0.0, 0.0] }}
        ends.b = {{ name = "tip", kind = "free" }}
        solver = {{ method = "static" }}
        published = [{{ name = "T", channel = "tension_n[top|rope]", statistic = "final", value = 9806.65, tolerance_rel = 1e-6, source = "w L", inputs = "published" }}]
        {trials}
        "#
    );
    findings(&[HardCase::read(&text, "small.toml").unwrap()])
}

#[test]
fn what_is_wrong_reads_wrong() {
    let found = small(
        r#"
        trial = [
            { name = "right" },
            { name = "heavier", set = ["materials.rope.wet_weight_kg_per_m=10.1"] },
            { name = "refused for nothing", refused = "slack" },
            { name = "refused for another reason", set = ["line.rope.length_m=0.0"], refused = "slack" },
            { name = "refused too much", set = ["line.rope.length_m=-1.0"] },
            { name = "not the same", set = ["materials.rope.wet_weight_kg_per_m=10.1"], same_as = "right", same_rel = 1e-3 },
            { name = "the same", set = ["materials.rope.ea_n=1e9"], same_as = "right", same_rel = 1e-9 },
        ]
        "#,
    );
    use TrialOutcome::{Ok, Refused, Wrong};
    let outcomes: Vec<TrialOutcome> = found.iter().map(|f| f.outcome).collect();
    assert_eq!(outcomes, [Ok, Wrong, Wrong, Wrong, Refused, Wrong, Ok]);
    let expected: Vec<bool> = found.iter().map(TrialVerdict::is_as_expected).collect();
    assert_eq!(expected, [true, false, false, false, false, false, true]);
    let tally = tally(&found);
    assert_eq!(
        (tally.ok, tally.refused, tally.refused_too_much, tally.wrong),
        (2, 0, 1, 4)
    );
    assert!(!tally.holds());
}
