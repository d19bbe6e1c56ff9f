//! Stress in the units of a section under tension and bending, at the places where fatigue is counted:
//!
//! ```text
//! σ = s T + E ρ (κ₁ cos ψ + κ₂ sin ψ)      ρ = r at full slip, r + R cos²α at full stick
//! ```
//!
//! with the stress s by tension of the load sharing ([`super::strength`], fixed ends), the curvature κ of the cable in two planes, the angle
//! ψ around it, Young's modulus E and outer radius r of the unit, the pitch radius R and the lay angle α of its layer. At full slip each
//! unit bends about its own axis alone, with the curvature of the cable, which a helix has at most; at full stick plane sections stay plane
//! and a helical unit is strained by κ R cos²α besides ([`super::bending`]). In between friction decides, which is not modelled: full stick
//! bounds the stress from above. A unit passes all ψ within a lay length, so that every angle is a place of its own.

use std::f64::consts::{PI, TAU};

use super::design::Design;
use super::element::CableElement;
use super::layout::SectionLayout;
use super::stiffness::EndRotation;
use super::strength::{LoadShare, load_shares};
use crate::case::UnitSlip;

/// Places around the cable; a plane of bending between two of them has 2 % less amplitude at most.
pub const AROUND: usize = 16;

/// A place in a unit at which its stress is read.
#[derive(Debug, Clone, PartialEq)]
pub struct HotSpot {
    /// The layer; "centre" for the centre.
    pub layer: String,
    /// The unit.
    pub unit: String,
    /// Angle around the cable, from the first plane of bending \[rad\].
    pub angle: f64,
    /// Stress by tension \[Pa/N\].
    pub by_tension: f64,
    /// Stress by curvature in both planes \[Pa m\].
    pub by_curvature: [f64; 2],
}

/// The hot spots of all units whose load-carrying area is known, and whose unit or layer is `wanted`, from the centre out.
#[must_use]
pub fn hot_spots(design: &Design, slip: UnitSlip, wanted: &dyn Fn(&str) -> bool) -> Vec<HotSpot> {
    let (layout, core) = (&design.layout, design.section.about.core);
    let shares = load_shares(layout, core, EndRotation::Fixed, 1.0);
    let shares = shares
        .iter()
        .filter(|share| wanted(&share.unit) || wanted(&share.layer));
    shares
        .flat_map(|share| around(layout, share, slip))
        .collect()
}

fn around(layout: &SectionLayout, share: &LoadShare, slip: UnitSlip) -> Vec<HotSpot> {
    let Some((by_tension, (element, lever))) = share.stress.zip(element(layout, share)) else {
        return Vec::new();
    };
    let Some(area) = element.area.filter(|area| *area > 0.0) else {
        return Vec::new();
    };
    // Of a tube in a jacket, the tube.
    let radius = (area / PI + element.bore_radius.powi(2)).sqrt();
    let stuck = match slip {
        UnitSlip::Full => 0.0,
        UnitSlip::None => lever,
    };
    let by_curvature = element.ea / area * (radius + stuck);
    let spots = (0..AROUND).map(|place| {
        let angle = TAU * place as f64 / AROUND as f64;
        HotSpot {
            layer: share.layer.clone(),
            unit: share.unit.clone(),
            angle,
            by_tension,
            by_curvature: [by_curvature * angle.cos(), by_curvature * angle.sin()],
        }
    });
    spots.collect()
}

/// A unit of a share, and `R cos²α` of its layer \[m\].
fn element<'a>(layout: &'a SectionLayout, share: &LoadShare) -> Option<(&'a CableElement, f64)> {
    let mut helices = layout.helices();
    let helix = helices.find(|helix| helix.name == share.layer);
    match (helix, &layout.centre) {
        (Some(helix), _) => {
            let mut units = helix.elements.iter();
            let unit = units.find(|unit| unit.name == share.unit)?;
            Some((unit, helix.pitch_radius * helix.angle.cos().powi(2)))
        }
        (None, Some(centre)) => Some((&centre.element, 0.0)),
        (None, None) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::kind;
    use crate::section::CrossSection;

    const TEXT: &str = include_str!("../../../cases/umbilical/section.toml");

    #[test]
    fn stress_is_that_of_the_load_sharing_and_of_a_bent_bar() {
        let design = kind::parse_stored::<CrossSection>(TEXT, "section.toml").unwrap();
        let every = |_: &str| true;
        let [slipping, stuck] =
            [UnitSlip::Full, UnitSlip::None].map(|slip| hot_spots(&design, slip, &every));
        assert!(!slipping.is_empty() && slipping.len() == stuck.len());
        let shares = load_shares(
            &design.layout,
            design.section.about.core,
            EndRotation::Fixed,
            1.0,
        );
        for (slip, stick) in slipping.iter().zip(&stuck) {
            let mut known = shares.iter();
            let share = known
                .find(|share| (&share.layer, &share.unit) == (&slip.layer, &slip.unit))
                .unwrap();
            assert_eq!(Some(slip.by_tension), share.stress);
            assert!(stick.by_curvature[0].abs() >= slip.by_curvature[0].abs());
        }
        // A wire of the outer armour: E r, and E (r + R cos² α).
        let armour = design.layout.helices().last().unwrap();
        let wire = &armour.elements[0];
        let youngs = wire.ea / wire.area.unwrap();
        let of = |spots: &[HotSpot]| {
            let mut own = spots.iter().filter(|spot| spot.layer == armour.name);
            own.next().unwrap().by_curvature[0]
        };
        assert!((of(&slipping) / (youngs * wire.radius) - 1.0).abs() < 1e-12);
        let lever = wire.radius + armour.pitch_radius * armour.angle.cos().powi(2);
        assert!((of(&stuck) / (youngs * lever) - 1.0).abs() < 1e-12);
        let only = hot_spots(&design, UnitSlip::Full, &|name| name == armour.name);
        assert_eq!(only.len(), AROUND);
    }
}
