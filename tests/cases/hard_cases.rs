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
        tally.holds() && tally.refused >= 20 && tally.ok >= 240,
        "{tally}"
    );
}

/// A thousand pendulums in a row, each a weight on a line of its own.
#[test]
fn a_thousand_lines_come_out_as_one() {
    let mut text = String::from(
        r#"
        environment.water_density_kg_per_m3 = 0.0
        materials.rope = { diameter_m = 0.02, mass_kg_per_m = 1.0, ea_n = 1e8, axial_damping_ratio = 0.3 }
        solver = { duration_s = 0.2 }
        published = [
            { name = "first", quantity = "tension_n[l0|b]", value = 1961.33, tolerance_rel = 1e-9, source = "W", inputs = "published" },
            { name = "last", quantity = "tension_n[l999|a]", value = 2059.3965, tolerance_rel = 1e-9, source = "W + w L", inputs = "published" },
            { name = "last in time", quantity = "tension_n[l999|a].max", value = 2059.3965, tolerance_rel = 1e-6, source = "W + w L", inputs = "published" },
        ]
        trial = [
            { name = "at rest", rows = ["first", "last"] },
            { name = "alpha", set = ["solver.method=alpha", "solver.longest_step_s=0.1"] },
        ]
        [system]
        title = "A thousand pendulums"
        "#,
    );
    for number in 0..1000 {
        let x = 10.0 * f64::from(number);
        text.push_str(&format!(
            "[points.h{number}]\nkind = \"fixed\"\nposition_m = [{x:?}, 0.0, 0.0]\n\
             [points.w{number}]\nkind = \"free\"\nmass_kg = 200.0\n\
             [[lines]]\nname = \"l{number}\"\nfrom = \"h{number}\"\nto = \"w{number}\"\nmaterial = \"rope\"\nlength_m = 10.0\nsegments = 2\n"
        ));
    }
    let found = findings(&[HardCase::read(&text, "row.toml").unwrap()]);
    let off: Vec<String> = found.iter().map(reported).collect();
    assert!(tally(&found).ok == 2, "{}", off.join("\n"));
}

/// A weight that hangs on a rope: published values of its rest and of its run, told apart by their names.
#[test]
fn a_trial_of_a_system_is_at_rest_or_in_time() {
    let text = r#"
        environment.water_density_kg_per_m3 = 0.0
        materials.rope = { diameter_m = 0.02, mass_kg_per_m = 1.0, ea_n = 1e7 }
        points.hook = { kind = "fixed", position_m = [0.0, 0.0, 0.0] }
        points.weight = { kind = "free", mass_kg = 100.0 }
        lines = [{ name = "rope", from = "hook", to = "weight", material = "rope", length_m = 10.0, segments = 4 }]
        published = [
            { name = "rest", quantity = "tension_n[rope|b]", value = 980.665, tolerance_rel = 1e-9, source = "W", inputs = "published" },
            { name = "motion", quantity = "tension_n[rope|b].max", value = 980.665, tolerance_rel = 0.06, source = "W", inputs = "published" },
            { name = "no such place", quantity = "tension_n[rope|3].max", value = 980.665, tolerance_rel = 1.0, source = "W", inputs = "published" },
        ]
        trial = [
            { name = "rest", rows = ["rest"] },
            { name = "motion", set = ["solver.duration_s=0.1"], rows = ["rest", "motion"] },
            { name = "the same", set = ["solver.duration_s=0.1", "solver.method=rk4"], rows = ["motion"], same_as = "motion", same_rel = 0.01 },
            { name = "of no run", rows = ["motion"] },
            { name = "of no place", set = ["solver.duration_s=0.1"], rows = ["no such place"] },
            { name = "refused", set = ["points.weight.kind=fixed"], refused = "position" },
            { name = "heavier", set = ["points.weight.mass_kg=101.0"], rows = ["rest"] },
        ]
        [system]
        title = "small"
        "#;
    let found = findings(&[HardCase::read(text, "small.toml").unwrap()]);
    use TrialOutcome::{Ok, Refused, Wrong};
    let outcomes: Vec<TrialOutcome> = found.iter().map(|f| f.outcome).collect();
    let all: Vec<String> = found.iter().map(reported).collect();
    let expected = [Ok, Ok, Ok, Wrong, Wrong, Refused, Wrong];
    assert_eq!(outcomes, expected, "{}", all.join("\n"));
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
