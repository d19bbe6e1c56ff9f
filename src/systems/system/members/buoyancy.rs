//! Buoyancy of a member, as far as it is in the water.
//!
//! A member that the surface cuts between its ends has a closed form: a cylinder to the point where its axis meets the surface, and the wedge
//! between the cut across the axis and the level one, whose volume is nothing and whose first moment is
//!
//! ```text
//! S = pi r⁴/4 (-t/a_z + a c²/(2 a_z²)),   t = z - a a_z,   c² = 1 - a_z²
//! ```
//!
//! with the axis a and the vertical z. Where the surface cuts an end, slices across the axis are integrated, each the segment of a circle.

use std::f64::consts::PI;

use num_dual::DualNum;

use super::super::load_sum::LoadSum;
use super::super::moving_pose::{Dual, DualVector, constant};
use super::placed::Placed;
use super::wet_part::{MemberSpan, UPRIGHT, WetPart, cut_shares, is_empty, segment};
use crate::numerics::V3;
use crate::system::network::Network;

impl Placed<'_> {
    /// Volume between two shares of the length, and its first moment from the lower end.
    fn frustum(&self, (from, to): MemberSpan) -> (Dual, DualVector) {
        let (a, b) = (self.radius_at(from), self.radius_at(to));
        let long = (to - from) * self.length;
        let (aa, ab, bb) = (a * a, a * b, b * b);
        let sum = aa + ab + bb;
        let volume = long * sum * (PI / 3.0);
        let centre = from * self.length + long * (aa + ab * 2.0 + bb * 3.0) / (sum * 4.0);
        let moment = self.axis * (volume * centre);
        (volume, moment)
    }

    /// The wedge between the cut across the axis where that meets the surface and the level cut.
    fn wedge(&self, share: Dual) -> DualVector {
        let radius = self.radius_at(share);
        let second = radius.powi(4) * (PI / 4.0);
        let up = self.axis.z;
        let level = constant(&V3::z()) - self.axis * up;
        let along = second * self.tilt2 / (up * up * 2.0);
        self.axis * along - level * (second / up)
    }

    /// Volume and first moment of what is immersed, slice by slice; the axis is not upright.
    fn slices(&self, wet: &WetPart) -> (Dual, DualVector) {
        let (mut volume, mut moment) = nothing();
        if !is_empty(&wet.whole) {
            (volume, moment) = self.frustum(wet.whole);
        }
        if !is_empty(&wet.cut) {
            let (more, at) = self.cut_slices(wet.cut);
            volume += more;
            moment += at;
        }
        (volume, moment)
    }

    /// Slices that the surface cuts.
    fn cut_slices(&self, span: MemberSpan) -> (Dual, DualVector) {
        let tilt = self.tilt2.sqrt();
        let uphill = (constant(&V3::z()) - self.axis * self.axis.z) / tilt;
        let (mut volume, mut moment) = nothing();
        for (share, long) in cut_shares(span) {
            let wide = long * self.length;
            let level = -(self.z + self.rise * share) / tilt;
            let Some(wet) = segment(self.radius_at(share), level) else {
                continue;
            };
            let off = wet.half_chord.powi(3) * (-2.0 / 3.0);
            moment += (self.axis * (share * self.length * wet.area) + uphill * off) * wide;
            volume += wet.area * wide;
        }
        (volume, moment)
    }

    /// Volume in the water \[m³\].
    pub(in crate::system) fn volume_in_water(&self) -> f64 {
        self.immersed().0.re
    }

    /// Volume and first moment, from the lower end, of what is immersed.
    fn immersed(&self) -> (Dual, DualVector) {
        let tilt = self.tilt2.re.max(0.0).sqrt();
        let (low, high) = (self.z.re, self.z.re + self.rise.re);
        let between = low + tilt * self.radius.0 <= 0.0 && high - tilt * self.radius.1 >= 0.0;
        let straight = self.radius.0 == self.radius.1;
        if between && (straight || tilt < UPRIGHT) {
            let share = -self.z / self.rise;
            let (volume, moment) = self.frustum((Dual::from_re(0.0), share));
            return (volume, moment + self.wedge(share));
        }
        self.slices(&self.wet_part())
    }
}

fn nothing() -> (Dual, DualVector) {
    (Dual::from_re(0.0), constant(&V3::zeros()))
}

/// Buoyancy of a member, as far as it is in the water.
pub(in crate::system) fn buoyancy(network: &Network, placed: &Placed<'_>, sum: &mut LoadSum) {
    let (volume, moment) = placed.immersed();
    if volume.re == 0.0 {
        return;
    }
    let weight = network.density * network.gravity;
    let up = constant(&V3::z());
    let centre = placed.arm + moment / volume;
    sum.add(&centre, &(up * (volume * weight)));
}
