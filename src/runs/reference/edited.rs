//! Published values of a case with edited inputs: they are those of another case, and do not judge it.

use super::{Outcome, ValidationRow};
use crate::case::{EditedKey, PublishedCurve, QuantityId, Study, StudyPoint};
use crate::published::{PublishedNumber, PublishedTrend};

/// Edited keys that a reason names.
const NAMED: usize = 3;

/// The rows of a file that is computed without a run, of which every edited key but that of a trend counts.
pub fn judge_plain(rows: &mut [ValidationRow], edited: &[EditedKey]) {
    for row in rows {
        let own = row.trend.as_ref().map(|line| line.key.as_str());
        let concern = |key: &&EditedKey| is_physical(&key.path) && own != Some(key.path.as_str());
        let keys: Vec<&EditedKey> = edited.iter().filter(concern).collect();
        set_aside(row, &keys);
    }
}

/// A row reads EDITED where there are such keys.
pub(super) fn set_aside(row: &mut ValidationRow, keys: &[&EditedKey]) {
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
///
/// Keys of solver, output, modes and mesh leave a published value what it is: every well-resolved computation should agree with
/// it. The duration counts for what is taken of the whole run. The key of a study does not count for rows at its points, which set
/// it themselves.
#[derive(Debug, Clone, Default)]
pub(super) struct RowScope<'a> {
    /// The studies at whose points it is, each of which sets its key.
    studies: Vec<&'a str>,
    /// Whether it is of the whole run, however long that is.
    whole_run: bool,
}

impl<'a> RowScope<'a> {
    pub(super) fn of_number(number: &'a PublishedNumber) -> Self {
        // A change or a ratio is of two variants: what only one of them sets counts.
        let own = |at: &Option<StudyPoint>| at.as_ref().is_none_or(|at| same(at, &number.at));
        let alone = own(&number.change_from) && own(&number.ratio_to);
        let at = number.at.as_ref().filter(|_| alone);
        Self {
            studies: at.iter().map(|at| at.study.as_str()).collect(),
            whole_run: is_of_whole_run(&number.quantity),
        }
    }

    pub(super) fn of_trend(trend: &'a PublishedTrend) -> Self {
        Self {
            studies: vec![&trend.study],
            whole_run: is_of_whole_run(&trend.quantity),
        }
    }

    pub(super) fn of_curve(curve: &'a PublishedCurve) -> Self {
        Self {
            studies: curve.at.iter().map(|at| at.study.as_str()).collect(),
            whole_run: curve.window_s.is_none(),
        }
    }

    /// Whether the published value is for another value of this key.
    pub(super) fn concerns(&self, studies: &[Study], key: &str) -> bool {
        let mut own = studies.iter().filter(|study| study.key == key);
        if own.any(|study| self.studies.contains(&study.name.as_str())) {
            return false;
        }
        match key {
            "solver.duration_s" => self.whole_run,
            key => is_physical(key),
        }
    }
}

/// Whether a result of this name is one of the run in time, over all of it.
fn is_of_whole_run(name: &str) -> bool {
    match name.parse() {
        Ok(QuantityId::Statistic { of, within, .. }) => {
            within.is_none() || of.line_quantity().is_some()
        }
        _ => false,
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
    let tables = ["solver.", "output.", "modes.", "case.", "system."];
    !(tables.iter().any(|table| key.starts_with(table))
        || words.iter().any(|word| key.ends_with(word)))
}
