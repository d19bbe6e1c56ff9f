//! Who carries a tension, and how much tension that lets the cable have.

use super::element::Element;
use super::layout::Layout;
use super::model::Core;
use super::stiffness::{Twist, matrix, unit_strain};

/// What one kind of unit of one layer carries.
#[derive(Debug, Clone, PartialEq)]
pub struct Share {
    /// The layer; the middle is called "centre".
    pub layer: String,
    /// The unit.
    pub unit: String,
    /// How many there are.
    pub count: usize,
    /// Share of the cable's tension that all of them carry along the cable's axis \[-\].
    pub share: f64,
    /// Strain of the unit along its own axis \[-\].
    pub strain: f64,
    /// Force in one unit along its own axis \[N\].
    pub force: f64,
    /// Stress in it, where its area is known \[Pa\].
    pub stress: Option<f64>,
    /// Force by what it stands, where that is known \[-\].
    pub utilisation: Option<f64>,
}

/// What each kind of unit carries under a tension \[N\]; empty when nothing carries.
///
/// From the strains that eqs. (16)-(17) of Lin et al. 2016 rest on; see [`super::stiffness`].
#[must_use]
pub fn shares(layout: &Layout, core: Core, twist: Twist, tension: f64) -> Vec<Share> {
    let stiffness = matrix(layout, core);
    let Some((strain, turn)) = stiffness.stretched(tension, twist) else {
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
            if let Some(same) = all.iter_mut().find(|s: &&mut Share| s.unit == unit.name) {
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

fn share(layer: &str, unit: &Element, strain: f64) -> Share {
    let force = unit.ea * strain;
    Share {
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

/// The tension that a cable stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Strength {
    /// Tension at which the first unit reaches its strength \[N\].
    pub break_load: f64,
    /// That times the usage factor \[N\].
    pub allowable: f64,
    /// The layer and the unit that reach it first.
    pub weakest: (String, String),
    /// How the middle behaves then, and whether the ends are held.
    pub when: (Core, Twist),
}

/// The tension at which the first unit reaches its strength, over both kinds of middle and ends
/// held or free, whichever is least; nothing when no unit that carries has a known strength.
#[must_use]
pub fn strength(layout: &Layout, usage_factor: f64) -> Option<Strength> {
    let mut weakest: Option<Strength> = None;
    for core in Core::BOTH {
        for twist in [Twist::Held, Twist::Free] {
            for share in shares(layout, core, twist, 1.0) {
                let Some(used) = share.utilisation.filter(|used| *used > 0.0) else {
                    continue;
                };
                let load = 1.0 / used;
                if load.is_finite() && weakest.as_ref().is_none_or(|w| load < w.break_load) {
                    weakest = Some(Strength {
                        break_load: load,
                        allowable: load * usage_factor,
                        weakest: (share.layer, share.unit),
                        when: (core, twist),
                    });
                }
            }
        }
    }
    weakest
}
