//! Which published values of a system are of its run in time: those by the names that its summary has, `tension_n[LINE|b].max`.

use super::model::{SystemFile, SystemKeys};
use super::quantities;
use crate::case::schema::Key;
use crate::case::{Finding, QuantityId};

/// The single number of a run that has this name; nothing for a result at rest, which has no statistic.
#[must_use]
pub fn id_in_time(name: &str) -> Option<QuantityId> {
    let id = name.parse().ok()?;
    matches!(id, QuantityId::Statistic { .. }).then_some(id)
}

/// Whether a file states published values or curves of its run in time.
#[must_use]
pub fn has_published_in_time(file: &SystemFile) -> bool {
    let mut numbers = file.published.iter();
    let has_numbers = numbers.any(|printed| id_in_time(&printed.quantity).is_some());
    has_numbers || !file.published_curve.is_empty()
}

/// A result that exists neither at rest nor in time.
pub(super) fn unknown(key: &Key<'_, String>, keys: &SystemKeys<'_>) -> Option<Finding> {
    if id_in_time(key.get()?).is_some() {
        return None;
    }
    let mut found = quantities::unknown(key, keys)?;
    let in_time = "; of a run in time name it as in its summary, such as tension_n[...|b].max";
    found.remedy.push_str(in_time);
    Some(found)
}
