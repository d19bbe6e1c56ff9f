//! Waves: what is given twice, and what has no effect.

use crate::case::diagnostic::Finding;
use crate::case::model::{CaseKeys, DecayName, SpectrumName, WavesKeys};

/// Checks of the waves.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let has_bed = case.place.node.get("seabed").is_some();
    let waves = case.waves.iter();
    waves.flat_map(|waves| of_waves(waves, has_bed)).collect()
}

/// Checks of one wave system, over a sea bed or not.
pub(crate) fn of_waves(waves: &WavesKeys<'_>, has_bed: bool) -> Vec<Finding> {
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
    found.into_iter().flatten().collect()
}
