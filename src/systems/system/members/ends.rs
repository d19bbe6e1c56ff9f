//! The flat ends of a member: drag and added mass along its axis, as `MoorDyn` has them for rods (`CdEnd`, `CaEnd`; Hall 2020).
//!
//! An end of radius r that is in the water has the added mass `rho Ca 2/3 pi r³`, on the volume of the half ball over it, and the drag
//! `1/2 rho Cd pi r² |u| u` of the velocity u of the water along the axis. One that the surface cuts counts by the share of its area below it.

use std::f64::consts::PI;

use num_dual::DualNum;

use super::super::moving_pose::{Dual, DualVector};
use super::placed::Placed;
use crate::physics::sea::WaterMotion;

/// Thickness over which an end that is level comes into the water, by its radius, on either side: a load must not jump.
const THICKNESS: f64 = 0.01;

/// An end in the water.
pub(super) struct WetEnd<'a> {
    /// From the origin of the body.
    pub(super) arm: DualVector,
    /// Height above the surface \[m\].
    pub(super) height: Dual,
    /// Area in the water times coefficient of drag \[m²\].
    pub(super) drag_area: Dual,
    /// Volume of the water that goes with it along the axis \[m³\].
    pub(super) added_volume: Dual,
    /// What waves make of the water there; nothing in still water.
    pub(super) waves: Option<&'a WaterMotion>,
}

impl<'a> Placed<'a> {
    /// The ends that are in the water and have coefficients.
    pub(super) fn wet_ends(&self) -> impl Iterator<Item = WetEnd<'a>> {
        let radii = [self.radius.0, self.radius.1];
        (0..2).filter_map(move |number| {
            let (drag, added_mass) = self.ends[number];
            let radius = radii[number];
            if radius == 0.0 || (drag == 0.0 && added_mass == 0.0) {
                return None;
            }
            let along = Dual::from_re(number as f64);
            let height = self.z + self.rise * along;
            let wet = share_in_water(height, radius, self.tilt2)?;
            Some(WetEnd {
                arm: self.arm_at(along),
                height,
                drag_area: wet * (drag * PI * radius * radius),
                added_volume: wet * (added_mass * 2.0 / 3.0 * PI * radius.powi(3)),
                waves: self.waves.get(number),
            })
        })
    }
}

/// Share of the area of an end that is below the surface; nothing where it is all above.
fn share_in_water(height: Dual, radius: f64, tilt2: Dual) -> Option<Dual> {
    let thin = THICKNESS * THICKNESS;
    let half = (tilt2 * (1.0 - thin) + thin).sqrt() * radius;
    let level = -height / half;
    if level.re >= 1.0 {
        return Some(Dual::from_re(1.0));
    }
    (level.re > -1.0).then(|| {
        let chord = (-(level * level) + 1.0).sqrt();
        -(level.acos() - level * chord) / PI + 1.0
    })
}
