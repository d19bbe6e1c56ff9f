//! Which published values of a system are of its run in time: those by the names that its summary has, `tension_n[LINE|b].max`.

use std::iter;

use super::model::{SystemFile, SystemKeys};
use super::motion::modes::id_of_mode;
use super::quantities;
use crate::case::schema::Key;
use crate::case::{ChannelId, Finding, QuantityId, Subject, of_result};

/// The single number of a run that has this name; nothing for a result at rest, which has no statistic.
#[must_use]
pub fn id_in_time(name: &str) -> Option<QuantityId> {
    let id = name.parse().ok()?;
    let is_in_time = matches!(id, QuantityId::Statistic { .. }) && id_of_mode(name).is_none();
    is_in_time.then_some(id)
}

/// Whether a file states published values, trends or curves of its run in time.
#[must_use]
pub fn has_published_in_time(file: &SystemFile) -> bool {
    !stated(file).is_empty() || !file.published_curve.is_empty()
}

/// The results of its run in time that a file states published values and trends of.
#[must_use]
pub fn stated(file: &SystemFile) -> Vec<QuantityId> {
    let numbers = file.published.iter();
    let numbers = numbers.flat_map(|row| iter::once(&row.quantity).chain(&row.divided_by));
    let trends = file.trend.iter().map(|trend| &trend.quantity);
    numbers
        .chain(trends)
        .filter_map(|name| id_in_time(name))
        .collect()
}

/// A result that exists neither at rest nor in time.
pub(super) fn unknown(key: &Key<'_, String>, keys: &SystemKeys<'_>) -> Option<Finding> {
    if let Some(id) = id_in_time(key.get()?) {
        return of_result(key, &id).or_else(|| unknown_part(key, &id, keys));
    }
    let mut found = quantities::unknown(key, keys)?;
    let in_time = "; of a run in time name it as in its summary, such as tension_n[...|b].max";
    found.remedy.push_str(in_time);
    Some(found)
}

/// A channel of a part that the system does not have.
pub(super) fn unknown_channel(key: &Key<'_, ChannelId>, keys: &SystemKeys<'_>) -> Option<Finding> {
    let part = key.get()?.place.split('|').next()?;
    quantities::unknown_part(key, part, keys)
}

/// A result of a part that the system does not have. Copies and halves of a part begin with its name.
fn unknown_part(key: &Key<'_, String>, id: &QuantityId, keys: &SystemKeys<'_>) -> Option<Finding> {
    let (subject, _) = id.parts();
    let part = match &subject {
        Subject::Channel(channel) => channel.place.split('|').next()?,
        Subject::Along(_, line) => line,
        Subject::Line(quantity) => {
            let name = quantity.name();
            let problem = format!("`{name}` does not say of which line");
            return Some(key.finding(problem, format!("name it: `{name}[along LINE]`")));
        }
        _ => return None,
    };
    quantities::unknown_part(key, part, keys)
}
