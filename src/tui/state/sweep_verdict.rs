//! What the load cases of a sweep say together, as the screen shows it: the tables of the command line's report, and what governs each
//! check.

use crate::number::duration;
use crate::report::seas::SeasView;
use crate::study::load_case_table::{LoadCaseColumn, used_columns};
use crate::study::seas::{CheckResult, SeaResults};
use crate::study::sweep::SweepSnapshot;
use crate::table::Table;

/// What load cases say together.
#[derive(Debug, Clone, Default)]
pub struct SweepVerdict {
    /// How many load cases had results when it was worked out.
    pub done: usize,
    /// The verdict, a row for each check; without rows where there are no checks.
    pub checks: Table,
    /// What governs each row of it.
    pub governing: Vec<GoverningCase>,
    /// The tensions of the seas.
    pub seas: Table,
    /// The load cases of each row of them.
    pub load_cases: Vec<Vec<usize>>,
    /// The share of its limit that each check uses, as results of the load cases.
    pub used: Vec<LoadCaseColumn>,
}

/// What governs a check.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct GoverningCase {
    /// In words.
    pub words: Vec<String>,
    /// The load case, by its place in the list; nothing where all of them together govern, or none does.
    pub load_case: Option<usize>,
    /// The time at which it does \[s\].
    pub time: Option<f64>,
}

impl SweepVerdict {
    /// Works it out from the records of all runs. For the threads behind the screen.
    #[must_use]
    pub fn of_snapshot(snapshot: &SweepSnapshot) -> Self {
        let done = snapshot.done();
        let Some(results) = snapshot.answers() else {
            return Self {
                done,
                ..Self::default()
            };
        };
        let view = SeasView {
            results: &results,
            statistics: &snapshot.plan.question.statistics,
        };
        let has_checks = !results.checks.is_empty();
        // The table leaves out checks that no load case is for.
        let judged = results
            .checks
            .iter()
            .filter(|check| check.verdict().is_some());
        Self {
            done,
            checks: match has_checks {
                true => view.verdict(),
                false => Table::default(),
            },
            governing: judged.map(|check| governing(check, &results)).collect(),
            seas: view.seas(),
            load_cases: results
                .seas
                .iter()
                .map(|sea| sea.load_cases.clone())
                .collect(),
            used: used_columns(&results, snapshot.load_cases()),
        }
    }
}

/// What governs a check: where, in which sea, load case, when, and with which errors.
fn governing(check: &CheckResult, results: &SeaResults) -> GoverningCase {
    let name = &check.check.name;
    let verdict = check.verdict().map_or("", |verdict| verdict.word());
    let mut words = vec![format!("{name}: {verdict}.")];
    let Some(row) = check.governing() else {
        words.extend(check.missing.iter().map(|why| format!("Open: {why}.")));
        return GoverningCase {
            words,
            ..GoverningCase::default()
        };
    };
    let ends = |ends: Option<[f64; 2]>| {
        ends.map_or_else(
            || "unknown".to_owned(),
            |[low, high]| format!("{low:.3} to {high:.3}"),
        )
    };
    let sample = match row.used.sample {
        Some(_) => format!(", by the sample {}", ends(row.used.sample)),
        None => String::new(),
    };
    words.push(format!(
        "Uses {:.3} of the limit; by the numerical error {}{sample}.",
        row.used.value,
        ends(row.used.numerical)
    ));
    let sea = row.sea.and_then(|sea| Some((sea, results.seas.get(sea)?)));
    let sea = sea.map_or_else(
        || "all seas together".to_owned(),
        |(number, sea)| format!("sea {}: {}", number + 1, sea.words()),
    );
    let case = row
        .load_case
        .map(|case| format!(", load case {}", case + 1));
    let time = row.time.map(|time| format!(" at {}", duration(time)));
    words.push(format!(
        "At {}, {sea}{}{}.",
        row.place,
        case.unwrap_or_default(),
        time.unwrap_or_default()
    ));
    words.extend(check.missing.iter().map(|why| format!("Open: {why}.")));
    if !check.check.clause.is_empty() {
        words.push(format!("{}.", check.check.clause));
    }
    GoverningCase {
        words,
        load_case: row.load_case,
        time: row.time,
    }
}
