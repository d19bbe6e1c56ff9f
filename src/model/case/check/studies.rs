//! Studies vary keys that exist, and published rows belong to points of them.

use super::load_cases::{values, varied};
use super::{unknown, used_twice};
use crate::case::diagnostic::Finding;
use crate::case::fields::{Schema, number};
use crate::case::model::{AtKeys, StudyKeys, StudyValue};
use crate::case::schema::{Key, TableNode};
use crate::case::tree::TomlNode;

/// The studies of a file of this kind: names of their own, keys that exist and take one value, and values in their range.
#[must_use]
pub fn of_studies(
    schema: &'static Schema,
    root: &TomlNode,
    studies: &[(String, StudyKeys<'_>)],
) -> Vec<Finding> {
    let names = studies.iter().map(|(_, study)| &study.name);
    let mut found = used_twice(names, "give every study a name of its own");
    for (_, study) in studies {
        let Some(key) = study.key.get() else {
            continue;
        };
        match varied(schema, root, key) {
            Ok(field) => found.extend(values(&study.values, field)),
            Err((problem, remedy)) => found.push(study.key.finding(problem, remedy)),
        }
    }
    found
}

/// The study that a key names.
///
/// # Errors
/// There is none of that name.
pub fn of_study<'k, 'a>(
    studies: &'k [(String, StudyKeys<'a>)],
    key: &Key<'_, String>,
) -> Result<Option<&'k StudyKeys<'a>>, Finding> {
    let known: Vec<&str> = studies.iter().map(|(name, _)| name.as_str()).collect();
    if let Some(finding) = unknown(key, &known, "study", "case") {
        return Err(finding);
    }
    let mut studies = studies.iter();
    let study = studies.find(|(name, _)| Some(name) == key.get());
    Ok(study.map(|(_, study)| study))
}

/// The point of a study that a published row belongs to: one of the study's values.
#[must_use]
pub fn of_study_point(studies: &[(String, StudyKeys<'_>)], at: &AtKeys<'_>) -> Option<Finding> {
    let study = match of_study(studies, &at.study) {
        Ok(study) => study?,
        Err(finding) => return Some(finding),
    };
    let (value, values) = (at.value.get()?, study.values.get()?);
    let same = |candidate: &StudyValue| match (candidate.number(), value.number()) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()),
        _ => candidate == value,
    };
    if values.iter().any(same) {
        return None;
    }
    let shown = |value: &StudyValue| match value {
        StudyValue::Word(word) => format!("\"{}\"", word.escape_default()),
        StudyValue::Number(value) => number(*value),
    };
    let list: Vec<String> = values.iter().map(shown).collect();
    let problem = format!("{} is not a value of the study", shown(value));
    Some(at.value.finding(
        problem,
        format!("the study's values are {}", list.join(", ")),
    ))
}

/// A fault where two of three keys are given that each hold a row against another number.
#[must_use]
pub fn two_others(table: &TableNode<'_>, keys: [&str; 3]) -> Option<Finding> {
    let mut given = keys.iter().filter_map(|key| table.node.entry(key));
    let (first, _) = (given.next()?, given.next()?);
    let problem = "the row is held against two other numbers at once";
    let [by, ratio, change] = keys;
    let remedy = format!("keep one of {change}, {ratio} and {by}");
    let key = table.key("ratio_to");
    Some(Finding::new(&first.key_span, key, problem, remedy))
}
