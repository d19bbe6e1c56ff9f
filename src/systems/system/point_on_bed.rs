//! The bed under a free point: it gives way by the weight of the point, or over an area as under a payload.

use super::bed::Bed;
use super::network::{FreePoint, Network};
use crate::numerics::{M3, V3};
use crate::physics::ElasticBed;
use crate::physics::bed_reaction::BedReaction;
use crate::physics::seabed::push_slopes;

/// How far the bed gives way under the weight of a point that lies on it without an area \[m\].
const GIVES_WAY: f64 = 1e-3;

/// Damping ratio of such a point on the bed.
const DAMPING_RATIO: f64 = 0.5;

/// The area on which a point bears, and the bed there.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BearingArea {
    /// The area \[m²\].
    pub area: f64,
    /// Push of the bed per area and depth \[N/m³\].
    pub stiffness: f64,
    /// The same per area and speed \[N s/m³\].
    pub damping: f64,
    /// Friction per area and distance pulled, before the point slides \[N/m³\].
    pub grip: f64,
}

impl FreePoint {
    /// Its bottom, which bears on the bed \[m\].
    #[must_use]
    pub fn bottom(&self, x: &V3) -> V3 {
        x - V3::z() * self.below
    }

    /// Stiffness \[N/m\] and damping \[N s/m\] of the bed under it: none of a point with neither weight nor mass, where lines bear on the
    /// bed by themselves as between their ends.
    #[must_use]
    pub fn bed_springs(&self) -> (f64, f64) {
        if let Some(on) = &self.bearing {
            return (on.stiffness * on.area, on.damping * on.area);
        }
        if self.weight == self.buoyancy && self.moving_mass == V3::zeros() {
            return (0.0, 0.0);
        }
        let stiffness = (self.weight - self.buoyancy).abs().max(1.0) / GIVES_WAY;
        let damping = 2.0 * DAMPING_RATIO * (stiffness * self.moving_mass.z.max(0.0)).sqrt();
        (stiffness, damping)
    }

    /// Stiffness \[N/m\] and damping \[N s/m\] of its hold along the bed.
    #[must_use]
    pub fn grip_springs(&self) -> (f64, f64) {
        let (stiffness, damping) = self.bed_springs();
        let of_area = self.bearing.map(|on| on.grip * on.area);
        (of_area.unwrap_or(stiffness), damping)
    }

    /// The push of the bed on its bottom at x \[m\] that moves at v \[m/s\], along the gradient of the height above the bed.
    #[must_use]
    pub fn push_of_bed(&self, bed: &Bed, (x, v): (&V3, &V3)) -> BedReaction {
        let (stiffness, damping) = self.bed_springs();
        let springs = ElasticBed {
            z: 0.0,
            slope: None,
            grid: None,
            stiffness,
            damping,
            friction: None,
        };
        springs.push_at(-bed.height(x), bed.gradient(x).dot(v), 1.0)
    }

    /// The push of the bed on its bottom, less the pull of suction where that holds it; nothing where neither acts.
    #[must_use]
    pub fn held_by_bed(&self, bed: &Bed, (x, v): (&V3, &V3), stuck: bool) -> Option<BedReaction> {
        let height = bed.height(x);
        if height < 0.0 {
            return Some(self.push_of_bed(bed, (x, v)));
        }
        let suction = self.suction.filter(|_| stuck)?;
        let (pull, by_height) = suction.pull(height);
        let held = BedReaction {
            force: -pull,
            by_height: -by_height,
            by_speed: 0.0,
        };
        (pull > 0.0).then_some(held)
    }

    /// The force of the bed at rest on a point with an area \[N\], and its change with the place \[N/m\]; what bears by its weight alone lies
    /// on a rigid bed there ([`Bounds`](super::bounds::Bounds)).
    #[must_use]
    pub fn bed_at_rest(&self, network: &Network, place: &V3) -> Option<(V3, M3)> {
        let bed = network.bed.as_ref().filter(|_| self.bearing.is_some())?;
        let bottom = self.bottom(place);
        let still = V3::zeros();
        let push = self.push_of_bed(bed, (&bottom, &still));
        if push.force <= 0.0 {
            return None;
        }
        let gradient = bed.gradient(&bottom);
        let curvature = bed.curvature(&bottom);
        let [by_place, _] = push_slopes(&gradient, curvature.as_ref(), &still, &push);
        Some((gradient * push.force, by_place))
    }
}
