//! The results of a system at rest as its run has them: by the names of channels.

use super::record::readings;
use crate::case::fields::nearest;
use crate::case::{ChannelId, ChannelQuantity, QuantityId, Subject};
use crate::system::{SolvedSystem, quantities};

/// The last value of a channel.
fn last(id: ChannelId) -> QuantityId {
    QuantityId::single(Subject::Channel(id))
}

/// The results that matter most: the tension of every line at the end where it is greater, the places of free bodies, the forces of pins.
#[must_use]
pub fn main_results(solved: &SolvedSystem) -> Vec<QuantityId> {
    let named = quantities::main_results(solved);
    let named = named.iter().filter_map(|name| name.parse().ok());
    let free = solved.network.bodies.iter().filter(|body| body.free);
    let places =
        free.flat_map(|body| ChannelQuantity::POSITION.map(|axis| axis.at(body.name.as_str())));
    let wanted: Vec<ChannelId> = named.chain(places).collect();
    let known = readings(solved).into_iter().map(|(id, _)| id);
    known.filter(|id| wanted.contains(id)).map(last).collect()
}

/// The result of this name: `tension_n[mooring|b]`, with `.final` or without.
///
/// # Errors
/// There is no such result, and what would be right.
pub fn named_result(solved: &SolvedSystem, name: &str) -> Result<QuantityId, String> {
    let name = name.trim();
    let wanted = name.strip_suffix(".final").unwrap_or(name);
    let known: Vec<ChannelId> = readings(solved).into_iter().map(|(id, _)| id).collect();
    if let Some(id) = known.iter().find(|id| id.to_string() == wanted) {
        return Ok(last(id.clone()));
    }
    let names: Vec<String> = known.iter().map(ToString::to_string).collect();
    let near = nearest(wanted, names.iter().map(String::as_str));
    Err(match (near, names.first()) {
        (Some(near), _) => {
            format!("`{name}` is no result of this system at rest; did you mean `{near}`?")
        }
        (None, Some(first)) => format!(
            "`{name}` is no result of this system at rest; name one as in the summary of a run, such as {first}"
        ),
        (None, None) => format!("`{name}` is no result of this system at rest, which has none"),
    })
}
