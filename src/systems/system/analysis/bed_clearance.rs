//! The least height of a line at rest above the bed, over a stretch of it.

use std::convert::Infallible;

use super::super::equilibrium::SystemEquilibrium;
use super::super::network::Network;
use crate::numerics::golden_section::golden_section;

/// Parts of a stretch of which the lowest is searched further.
const PARTS: u32 = 200;

/// The least height \[m\] of a line above the bed between two arc lengths from its end A \[m\], all of it where none are given: vertical,
/// negative below the bed.
///
/// # Errors
/// Why there is none, as a sentence.
pub fn least_height(
    (network, rest): (&Network, &SystemEquilibrium),
    line: usize,
    stretch: Option<[f64; 2]>,
) -> Result<f64, String> {
    let bed = network.bed.as_ref();
    let bed = bed.ok_or("The system has no sea bed.")?;
    let given = &network.lines[line];
    let length = given.length();
    let [from, to] = stretch.unwrap_or([0.0, length]);
    // Lengths of sections are sums of roundings: the end of the line belongs to it.
    if !(from >= 0.0 && from <= to && to <= length * (1.0 + 1e-9)) {
        return Err(format!(
            "Line {} is {length} m long and has no stretch from {from} to {to} m.",
            given.name
        ));
    }
    let places = &rest.placement.points;
    let ends = [&places[given.from], &places[given.to]];
    let at_rest = &rest.balance.lines[line];
    let height = |arc: f64| bed.height(&at_rest.at((arc / length).min(1.0), ends).0);
    let arc = |part: u32| from + (to - from) * f64::from(part) / f64::from(PARTS);
    let parts = (0..=PARTS).map(|part| (part, height(arc(part))));
    let lowest = parts.reduce(|low, part| if part.1 < low.1 { part } else { low });
    let (part, least) = lowest.unwrap_or((0, height(from)));
    let around = (arc(part.saturating_sub(1)), arc((part + 1).min(PARTS)));
    let Ok(turn) = golden_section(around, 1e-9, 100, |arc| Ok::<_, Infallible>(height(arc)));
    Ok(least.min(height(turn)))
}
