//! Trials of a hard case: what they set, which published values they name, which trial they repeat.

use super::unknown_path;
use super::{unknown, unknown_name};
use crate::case::diagnostic::Finding;
use crate::case::fields::{Schema, split};
use crate::case::model::{CASE, CaseKeys, TrialKeys};
use crate::case::tree::TomlNode;

/// Checks of the trials of a case.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let published = case.published.iter().map(|(name, _)| name.as_str());
    let rows: Vec<&str> = published.collect();
    of_trials(&CASE, case.place.node, &rows, &case.trial)
}

/// Checks the trials of a file with this schema and published values of these names.
pub fn of_trials(
    schema: &'static Schema,
    root: &TomlNode,
    rows: &[&str],
    trials: &[(String, TrialKeys<'_>)],
) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut earlier: Vec<&str> = Vec::new();
    for (_, trial) in trials {
        let set = trial.set.get().into_iter().flatten().enumerate();
        found.extend(set.filter_map(|(index, word)| {
            let (problem, remedy) = sets(schema, root, word)?;
            Some(trial.set.finding_at_item(index, problem, remedy))
        }));
        let named = trial.rows.get().into_iter().flatten().enumerate();
        found.extend(named.filter_map(|(index, word)| {
            let (problem, remedy) = unknown_name(word, rows, "published value", schema.what)?;
            Some(trial.rows.finding_at_item(index, problem, remedy))
        }));
        found.extend(unknown(
            &trial.same_as,
            &earlier,
            "trial further up",
            schema.what,
        ));
        found.extend(idle(trial));
        earlier.extend(trial.name.get().map(String::as_str));
    }
    found
}

/// Keys without effect: how far numbers may be from those of no other trial, and what a trial without numbers is held
/// against; and the tolerance that a trial compared with another needs.
fn idle(trial: &TrialKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    if trial.same_as.is_given() && !trial.same_rel.is_given() {
        let remedy = "add `same_rel = ...`, how far numbers may be apart relative to themselves";
        found.push(Finding {
            key: trial.same_rel.path(),
            ..trial.same_as.finding("is missing", remedy)
        });
    }
    if trial.refused.is_given() {
        let problem = "has no effect: the trial must be refused, and then has no numbers";
        let remedy = "remove it, or `refused`";
        found.extend(trial.rows.if_given(problem, remedy));
        found.extend(trial.told.if_given(problem, remedy));
        found.extend(trial.same_as.if_given(problem, remedy));
    } else if !trial.same_as.is_given() {
        let remedy = "add `same_as = ...`, the trial further up, or remove it";
        found.extend(
            trial
                .same_rel
                .if_given("has no effect without same_as", remedy),
        );
    }
    found
}

/// Problem and remedy of a word that is not `key=value` with a key that a file with this schema can have.
fn sets(schema: &'static Schema, root: &TomlNode, word: &str) -> Option<(String, String)> {
    let Some((path, _)) = word.split_once('=') else {
        let problem = format!("`{word}` gives no value");
        return Some((
            problem,
            "write key=value, as in \"solver.method=rk4\"".to_owned(),
        ));
    };
    let known = split(path).is_some_and(|parts| schema.fields_at(&parts).next().is_some());
    (!known).then(|| unknown_path(schema, root, path.trim()))
}
