//! Mass and weight of the cable per length, in air and in water.

use super::element::disc;
use super::layout::{LaidLayer, SectionLayout};
use super::model::{SectionInfo, Voids};

/// Mass and weight per length.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CableWeight {
    /// Mass in air with empty gaps \[kg/m\].
    pub in_air: f64,
    /// Mass in water, including water in flooded gaps \[kg/m\].
    pub moving: f64,
    /// Weight in water as mass \[kg/m\].
    pub in_water: f64,
    /// Weight in water as force \[N/m\].
    pub in_water_force: f64,
    /// Area of the gaps without filler \[m²\].
    pub voids: f64,
}

/// The weight of a section.
#[must_use]
pub fn weight(layout: &SectionLayout, about: &SectionInfo) -> CableWeight {
    let shells = layout.shells.iter().map(|shell| match shell {
        LaidLayer::Helix(helix) => helix.mass(),
        LaidLayer::Tube(tube) => tube.mass(),
    });
    let centre = layout
        .centre
        .as_ref()
        .map_or(0.0, super::CentreCylinder::mass);
    let in_air = centre + shells.sum::<f64>();
    let voids = layout
        .helices()
        .map(|helix| helix.gaps() * (1.0 - helix.filler.0))
        .sum::<f64>();
    let water = about.water_density_kg_per_m3;
    let outside = disc(layout.outer_radius);
    // Water in the gaps is neutrally buoyant.
    let (moving, displaced) = match about.voids {
        Voids::Dry => (in_air, outside),
        Voids::Flooded => (in_air + voids * water, outside - voids),
    };
    let in_water = in_air - displaced * water;
    CableWeight {
        in_air,
        moving,
        in_water,
        in_water_force: in_water * about.gravity_m_per_s2,
        voids,
    }
}
