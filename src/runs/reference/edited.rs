//! Published values of a case with edited inputs: they are those of another case, and do not judge it.

use super::{Outcome, ValidationRow};
use crate::case::{Case, EditedKey, Published, PublishedCurve, StudyPoint, Trend};

/// Edited keys that a reason names.
const NAMED: usize = 3;

/// The rows whose published values are not for the case as edited read EDITED, with the keys that are why.
///
/// Keys of solver, output, modes and mesh leave a published value what it is: every well-resolved computation should agree with
/// it. The duration counts for what is taken of the whole run. The key of a study does not count for rows at its points, which set
/// it themselves.
pub(super) fn judge(rows: &mut [ValidationRow], case: &Case, edited: &[EditedKey]) {
    if edited.is_empty() {
        return;
    }
    let values = case.published.iter().map(RowScope::of_value);
    let trends = case.trend.iter().map(RowScope::of_trend);
    let curves = case.published_curve.iter().map(RowScope::of_curve);
    for (row, scope) in rows.iter_mut().zip(values.chain(trends).chain(curves)) {
        let concern = |key: &&EditedKey| scope.concerns(case, &key.path);
        let keys: Vec<&EditedKey> = edited.iter().filter(concern).collect();
        set_aside(row, &keys);
    }
}

/// The rows of a file that is computed without a run, of which every edited key but that of a trend counts.
pub fn judge_plain(rows: &mut [ValidationRow], edited: &[EditedKey]) {
    for row in rows {
        let own = row.trend.as_ref().map(|line| line.key.as_str());
        let concern = |key: &&EditedKey| is_physical(&key.path) && own != Some(key.path.as_str());
        let keys: Vec<&EditedKey> = edited.iter().filter(concern).collect();
        set_aside(row, &keys);
    }
}

fn set_aside(row: &mut ValidationRow, keys: &[&EditedKey]) {
    if keys.is_empty() {
        return;
    }
    let mut words: Vec<String> = keys.iter().take(NAMED).map(|key| key.words()).collect();
    if keys.len() > NAMED {
        words.push(format!("{} other inputs are yours", keys.len() - NAMED));
    }
    row.outcome = Outcome::Edited;
    row.reason = Some(format!("{}.", words.join("; ")));
}

/// What a row is taken of.
struct RowScope<'a> {
    /// The studies at whose points it is, each of which sets its key.
    studies: Vec<&'a str>,
    /// Whether it is of the whole run, however long that is.
    whole_run: bool,
}

impl<'a> RowScope<'a> {
    fn of_value(value: &'a Published) -> Self {
        // A change or a ratio is of two variants: what only one of them sets counts.
        let own = |at: &Option<StudyPoint>| at.as_ref().is_none_or(|at| same(at, &value.at));
        let alone = own(&value.change_from) && own(&value.ratio_to);
        let at = value.at.as_ref().filter(|_| alone);
        Self {
            studies: at.iter().map(|at| at.study.as_str()).collect(),
            whole_run: value.window_s.is_none(),
        }
    }

    fn of_trend(trend: &'a Trend) -> Self {
        Self {
            studies: vec![&trend.study],
            whole_run: trend.window_s.is_none(),
        }
    }

    fn of_curve(curve: &'a PublishedCurve) -> Self {
        Self {
            studies: curve.at.iter().map(|at| at.study.as_str()).collect(),
            whole_run: curve.window_s.is_none(),
        }
    }

    /// Whether the published value is for another value of this key.
    fn concerns(&self, case: &Case, key: &str) -> bool {
        let mut own = case.study.iter().filter(|study| study.key == key);
        if own.any(|study| self.studies.contains(&study.name.as_str())) {
            return false;
        }
        match key {
            "solver.duration_s" => self.whole_run,
            key => is_physical(key),
        }
    }
}

fn same(at: &StudyPoint, other: &Option<StudyPoint>) -> bool {
    other.as_ref().is_some_and(|other| other.study == at.study)
}

/// Whether a key is an input of the scene: not one of solver, output, modes or mesh, nor a title.
fn is_physical(key: &str) -> bool {
    let words = [
        ".segments",
        ".title",
        ".source",
        ".notes",
        ".beside",
        ".name",
    ];
    let tables = ["solver.", "output.", "modes.", "case."];
    !(tables.iter().any(|table| key.starts_with(table))
        || words.iter().any(|word| key.ends_with(word)))
}
