//! Waves: what is given twice, and what has no effect.

use super::unknown;
use crate::case::diagnostic::Finding;
use crate::case::model::{CaseKeys, DecayName, SpectrumName, WaveKind, WavesKeys};

/// Checks of the waves.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let has_bed = case.place.node.get("seabed").is_some();
    let waves = case.waves.iter();
    let mut found: Vec<Finding> = waves.flat_map(|waves| of_waves(waves, has_bed)).collect();
    let ends = case
        .ends
        .iter()
        .flat_map(|ends| [&ends.a, &ends.b])
        .flatten();
    let placed = ends.filter(|end| end.position_m.is_given());
    let names: Vec<&str> = placed.filter_map(|end| end.name.text()).collect();
    let waves = case.waves.iter();
    found
        .extend(waves.filter_map(|waves| of_gauge(waves, &names, ("end with a position", "case"))));
    found
}

/// A gauge over what is not among these names, which are of such parts of a file of such a kind, or at two places.
pub fn of_gauge(
    waves: &WavesKeys<'_>,
    names: &[&str],
    (part, file): (&str, &str),
) -> Option<Finding> {
    if waves.gauge_m.is_given() {
        let problem = "the gauge is at two places, here and at `gauge_m`";
        return waves.gauge_over.if_given(problem, "keep one of them");
    }
    unknown(&waves.gauge_over, names, part, file)
}

/// Checks of one wave system, over a sea bed or not.
pub fn of_waves(waves: &WavesKeys<'_>, has_bed: bool) -> Vec<Finding> {
    let twice = waves.depth_m.if_given(
        "the depth is given twice, here and by seabed.depth_m",
        "remove it: the waves feel the sea bed",
    );
    let gamma = waves.gamma.if_given(
        "has no effect: a Pierson-Moskowitz spectrum has no peak enhancement",
        "remove it, or set spectrum = \"jonswap\"",
    );
    let depth = waves.decay_depth_m.if_given(
        "has no effect: Airy's theory goes down to the bed",
        "remove it, or set decay = \"airy-cut\" or \"logarithmic\"",
    );
    let found = [
        twice.filter(|_| has_bed),
        gamma.filter(|_| waves.spectrum.is(&SpectrumName::PiersonMoskowitz)),
        depth.filter(|_| waves.decay.is(&DecayName::Airy)),
    ];
    let mut found: Vec<Finding> = found.into_iter().flatten().collect();
    if waves.kind.is(&WaveKind::Components) {
        found.extend(components(waves));
    }
    found
}

/// Components have periods and heights, and as many leads where these are given.
fn components(waves: &WavesKeys<'_>) -> Vec<Finding> {
    let missing = [
        waves
            .periods_s
            .if_missing("components have periods: `periods_s`"),
        waves.heights_m.if_missing("and heights: `heights_m`"),
    ];
    let mut found: Vec<Finding> = missing.into_iter().flatten().collect();
    let Some(periods) = waves.periods_s.given() else {
        return found;
    };
    for list in [&waves.heights_m, &waves.phases_deg] {
        let uneven = list.get().filter(|list| list.len() != periods.len());
        if let Some(values) = uneven {
            let problem = format!("has {} values for {} periods", values.len(), periods.len());
            found.push(list.finding(problem, "give one value for each of periods_s"));
        }
    }
    found
}
