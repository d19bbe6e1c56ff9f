//! Load sharing between the units under tension, and the strength of the cable.

use super::element::CableElement;
use super::layout::SectionLayout;
use super::model::Core;
use super::stiffness::{EndRotation, matrix, unit_strain};

/// Load carried by one kind of unit of one layer.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadShare {
    /// The layer; "centre" for the centre.
    pub layer: String,
    /// The unit.
    pub unit: String,
    /// Number of units.
    pub count: usize,
    /// Share of the cable's tension that all of them carry along the cable's axis \[-\].
    pub share: f64,
    /// Strain of the unit along its own axis \[-\].
    pub strain: f64,
    /// Force in one unit along its own axis \[N\].
    pub force: f64,
    /// Stress in it, where its area is known \[Pa\].
    pub stress: Option<f64>,
    /// Force relative to its strength, where that is known \[-\].
    pub utilisation: Option<f64>,
}

/// Load of each kind of unit under a tension \[N\]; empty without axial stiffness.
///
/// From the strains behind eqs. (16)-(17) of Lin et al. 2016; see [`super::stiffness`].
#[must_use]
pub fn load_shares(
    layout: &SectionLayout,
    core: Core,
    twist: EndRotation,
    tension: f64,
) -> Vec<LoadShare> {
    let stiffness = matrix(layout, core);
    let Some((strain, turn)) = stiffness.strain_and_twist(tension, twist) else {
        return Vec::new();
    };
    let along = |force: f64| {
        if tension.abs() > 0.0 {
            force / tension
        } else {
            0.0
        }
    };
    let mut list = Vec::new();
    if let Some(centre) = &layout.centre {
        let mut share = share("centre", &centre.element, strain);
        share.share = along(share.force + centre.jacket().ea * strain);
        list.push(share);
    }
    for helix in layout.helices() {
        let (sin, cos) = helix.angle.sin_cos();
        let own = strain * unit_strain(layout, helix.pitch_radius, helix.angle, core)
            + turn * helix.pitch_radius * sin * cos;
        let first = list.len();
        for unit in &helix.elements {
            let all = list.get_mut(first..).unwrap_or_default();
            if let Some(same) = all
                .iter_mut()
                .find(|s: &&mut LoadShare| s.unit == unit.name)
            {
                same.count += 1;
            } else {
                list.push(share(&helix.name, unit, own));
            }
        }
        for share in list.get_mut(first..).unwrap_or_default() {
            share.share = along(share.force * cos * share.count as f64);
        }
    }
    list
}

fn share(layer: &str, unit: &CableElement, strain: f64) -> LoadShare {
    let force = unit.ea * strain;
    LoadShare {
        layer: layer.to_owned(),
        unit: unit.name.clone(),
        count: 1,
        share: 0.0,
        strain,
        force,
        stress: unit.area.map(|area| force / area),
        utilisation: unit
            .strength
            .filter(|_| unit.ea > 0.0)
            .map(|strength| force / strength),
    }
}

/// Strength of a cable.
#[derive(Debug, Clone, PartialEq)]
pub struct Strength {
    /// Tension at which the first unit reaches its strength \[N\].
    pub break_load: f64,
    /// That times the usage factor \[N\].
    pub allowable: f64,
    /// The layer and the unit that reach their strength first.
    pub weakest: (String, String),
    /// The core model and end rotation at which they do.
    pub governing: (Core, EndRotation),
}

/// The least tension at which a unit reaches its strength, over both core models and both end rotations; `None` where no
/// load-carrying unit has a known strength.
#[must_use]
pub fn strength(layout: &SectionLayout, usage_factor: f64) -> Option<Strength> {
    let mut weakest: Option<Strength> = None;
    for core in Core::BOTH {
        for twist in [EndRotation::Fixed, EndRotation::Free] {
            for share in load_shares(layout, core, twist, 1.0) {
                let Some(used) = share.utilisation.filter(|used| *used > 0.0) else {
                    continue;
                };
                let load = 1.0 / used;
                if load.is_finite() && weakest.as_ref().is_none_or(|w| load < w.break_load) {
                    weakest = Some(Strength {
                        break_load: load,
                        allowable: load * usage_factor,
                        weakest: (share.layer, share.unit),
                        governing: (core, twist),
                    });
                }
            }
        }
    }
    weakest
}
