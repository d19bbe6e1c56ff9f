//! Members of bodies: round cylinders and cones in the water. Buoyancy of the part that is immersed, drag in a current, added mass.
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
use std::sync::LazyLock;

use nalgebra::Matrix6;
use num_dual::DualNum;

use super::body_loads::{Dual, DualVector, LoadSum, MovingPose, constant, near};
use super::network::{Body, Member, Network};
use super::pose::{Pose, cross};
use crate::numerics::{M3, V3};
use crate::physics::sea::{Sea, WaterMotion};

/// Points of a quadrature.
const POINTS: usize = 24;

/// Fejér's first rule on 0 to 1: nodes and weights (Fejér 1933; Waldvogel, BIT 46, 2006).
static RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| {
    let n = POINTS as f64;
    let node = |k: usize| {
        let angle = (k as f64 + 0.5) * PI / n;
        let sum: f64 = (1..=POINTS / 2)
            .map(|j| j as f64)
            .map(|j| (2.0 * j * angle).cos() / (4.0 * j * j - 1.0))
            .sum();
        (0.5 * (1.0 - angle.cos()), (1.0 - 2.0 * sum) / n)
    };
    (0..POINTS).map(node).collect()
});

/// A member where it is, its lower end first.
pub(super) struct Placed<'a> {
    /// From the origin of the body to its lower end.
    arm: DualVector,
    /// Height of the lower end, and of the upper one above it.
    z: Dual,
    rise: Dual,
    /// Along its axis, upwards.
    axis: DualVector,
    length: f64,
    /// Radii at the lower and at the upper end.
    radius: (f64, f64),
    /// Sine of the angle between axis and vertical, squared.
    tilt2: Dual,
    /// What waves make of the water at its lower end, its upper end, and along its part in the water; empty in still water.
    waves: &'a [WaterMotion],
}

/// A slice across the part of a member in the water.
struct Slice {
    /// Its number.
    number: usize,
    /// From the origin of the body.
    arm: DualVector,
    /// Height above the surface \[m\].
    height: Dual,
    radius: Dual,
    /// Length along the axis that it stands for \[m\].
    long: Dual,
}

impl<'a> Placed<'a> {
    /// A member at a pose; heights are above the surface of the waves at its stations.
    pub(super) fn of(member: &Member, pose: &MovingPose<'_>, waves: &'a [WaterMotion]) -> Self {
        let (from, to) = (pose.arm(&member.from), pose.arm(&member.to));
        let radius = member.radius;
        let (low, high, radius) = if to.z.re < from.z.re {
            (to, from, (radius.1, radius.0))
        } else {
            (from, to, radius)
        };
        let length = (member.to - member.from).norm();
        let axis = (high - low) / Dual::from_re(length);
        let surface = |end: usize, arm: &DualVector| {
            let flow = waves.get(end);
            flow.map_or_else(
                || Dual::from_re(0.0),
                |flow| elevation(flow, &pose.place(arm)),
            )
        };
        let (at_low, at_high) = (surface(0, &low), surface(1, &high));
        Self {
            z: pose.origin.z + low.z - at_low,
            rise: high.z - low.z - (at_high - at_low),
            tilt2: axis.x.powi(2) + axis.y.powi(2),
            arm: low,
            axis,
            length,
            radius,
            waves,
        }
    }

    /// Share of the length that is in the water, from the lower end; nothing where that end is out of it.
    fn wet_share(&self) -> Option<Dual> {
        let upper_is_dry = self.z.re + self.rise.re > 0.0;
        (self.z.re < 0.0).then(|| match upper_is_dry {
            true => -self.z / self.rise,
            false => Dual::from_re(1.0),
        })
    }

    /// Slices of the part in the water.
    fn wet_slices(&self) -> impl Iterator<Item = Slice> {
        let wet = self.wet_share();
        let slice = move |(number, (node, weight)): (usize, &(f64, f64))| {
            let wet = wet?;
            let share = wet * *node;
            Some(Slice {
                number,
                arm: self.arm + self.axis * (share * self.length),
                height: self.z + self.rise * share,
                radius: self.radius_at(share),
                long: wet * (*weight * self.length),
            })
        };
        RULE.iter().enumerate().filter_map(slice)
    }

    fn radius_at(&self, share: Dual) -> Dual {
        share * (self.radius.1 - self.radius.0) + self.radius.0
    }

    /// Volume between two shares of the length, and its first moment from the lower end.
    fn frustum(&self, from: Dual, to: Dual) -> (Dual, DualVector) {
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
    fn slices(&self) -> (Dual, DualVector) {
        let tilt = self.tilt2.sqrt();
        // Both ends, and at most two cuts between.
        let mut cuts = [Dual::from_re(0.0); 4];
        cuts[1] = Dual::from_re(1.0);
        let mut count = 2;
        for sign in [1.0, -1.0] {
            // Where the top, or the bottom, of a slice is at the surface.
            let at_end = self.z + tilt * (sign * self.radius.0);
            let slope = self.rise + tilt * (sign * (self.radius.1 - self.radius.0));
            let cut = -at_end / slope;
            if cut.re > 0.0 && cut.re < 1.0 {
                cuts[count] = cut;
                count += 1;
            }
        }
        let cuts = &mut cuts[..count];
        cuts.sort_unstable_by(|a, b| a.re.total_cmp(&b.re));
        let mut volume = Dual::from_re(0.0);
        let mut moment = constant(&V3::zeros());
        for ends in cuts.windows(2) {
            let middle = 0.5 * (ends[0].re + ends[1].re);
            let height = self.z.re + self.rise.re * middle;
            let half = tilt.re * (self.radius.0 + middle * (self.radius.1 - self.radius.0));
            let (more, at) = if height + half <= 0.0 {
                self.frustum(ends[0], ends[1])
            } else if height - half < 0.0 {
                self.partly(ends[0], ends[1], tilt)
            } else {
                continue;
            };
            volume += more;
            moment += at;
        }
        (volume, moment)
    }

    /// Slices that the surface cuts, between two shares of the length.
    fn partly(&self, from: Dual, to: Dual, tilt: Dual) -> (Dual, DualVector) {
        let uphill = (constant(&V3::z()) - self.axis * self.axis.z) / tilt;
        let mut volume = Dual::from_re(0.0);
        let mut moment = constant(&V3::zeros());
        for (node, weight) in RULE.iter() {
            let share = from + (to - from) * *node;
            let wide = (to - from) * (*weight * self.length);
            let radius = self.radius_at(share);
            let level = -(self.z + self.rise * share) / tilt;
            let inside = radius * radius - level * level;
            if inside.re <= 0.0 {
                continue;
            }
            let chord = inside.sqrt();
            let angle = Dual::from_re(PI) - (level / radius).acos();
            let area = radius * radius * angle + level * chord;
            let off = chord * inside * (-2.0 / 3.0);
            moment += (self.axis * (share * self.length * area) + uphill * off) * wide;
            volume += area * wide;
        }
        (volume, moment)
    }

    /// Volume and first moment, from the lower end, of what is immersed.
    fn immersed(&self) -> (Dual, DualVector) {
        let (none, whole) = (Dual::from_re(0.0), Dual::from_re(1.0));
        let tilt = self.tilt2.re.max(0.0).sqrt();
        let (low, high) = (self.z.re, self.z.re + self.rise.re);
        let (half_low, half_high) = (tilt * self.radius.0, tilt * self.radius.1);
        if low + half_low <= 0.0 && high + half_high <= 0.0 {
            return self.frustum(none, whole);
        }
        if low - half_low >= 0.0 && high - half_high >= 0.0 {
            return (none, constant(&V3::zeros()));
        }
        let between = low + half_low <= 0.0 && high - half_high >= 0.0;
        let straight = self.radius.0 == self.radius.1;
        if between && (straight || tilt < UPRIGHT) {
            let share = -self.z / self.rise;
            let (volume, moment) = self.frustum(none, share);
            return (volume, moment + self.wedge(share));
        }
        self.slices()
    }
}

/// Sine of the tilt below which a cone at the surface counts as a cylinder of its radius there.
const UPRIGHT: f64 = 1e-6;

/// Height of the surface \[m\] over a place near where it is known.
fn elevation(flow: &WaterMotion, place: &DualVector) -> Dual {
    let away = place - constant(&flow.place);
    away.dot(&constant(&flow.slope)) + flow.elevation
}

/// Stations of a member at which waves are read: its lower end, its upper end, and the slices of its part in the water.
pub(super) const STATIONS: usize = POINTS + 2;

/// Reads the waves of a sea at a time \[s\] at the stations of a member.
pub(super) fn read_waves(
    member: &Member,
    pose: &Pose,
    (sea, t): (&Sea, f64),
    stations: &mut [WaterMotion],
) {
    let ends = [&member.from, &member.to].map(|end| pose.origin + pose.arm(end));
    let [low, high] = match ends[1].z < ends[0].z {
        true => [ends[1], ends[0]],
        false => ends,
    };
    stations.fill(WaterMotion::default());
    stations[0] = sea.flow(t, &low, true);
    stations[1] = sea.flow(t, &high, true);
    let z = low.z - stations[0].elevation;
    let rise = high.z - stations[1].elevation - z;
    if z >= 0.0 {
        return;
    }
    let wet = if z + rise > 0.0 { -z / rise } else { 1.0 };
    for (station, (node, _)) in stations[2..].iter_mut().zip(RULE.iter()) {
        *station = sea.flow(t, &low.lerp(&high, wet * node), false);
    }
}

/// Buoyancy of a member, as far as it is in the water.
pub(super) fn buoyancy(network: &Network, placed: &Placed<'_>, sum: &mut LoadSum) {
    let (volume, moment) = placed.immersed();
    if volume.re == 0.0 {
        return;
    }
    let weight = network.density * network.gravity;
    let up = constant(&V3::z());
    let centre = placed.arm + moment / volume;
    sum.add(&centre, &(up * (volume * weight)));
}

/// The bed under the ends of a member, each a ball of its radius whose lowest point bears on it: a spring that gives way by a millimetre
/// under the body's weight and pushes along the normal of the bed. Over a slope the height of that point is measured vertically.
pub(super) fn bed(
    network: &Network,
    body: &Body,
    member: &Member,
    pose: &MovingPose<'_>,
    sum: &mut LoadSum,
) {
    let Some(bed) = &network.bed else { return };
    let spring = body.weight.max(1.0) / GIVES_WAY;
    let ends = [
        (&member.from, member.radius.0),
        (&member.to, member.radius.1),
    ];
    for (end, radius) in ends {
        let arm = pose.arm(end);
        let place = pose.place(&arm);
        let here = place.map(|part| part.re);
        let gradient = bed.gradient(&here);
        let lower = (place - constant(&here)).dot(&constant(&V3::new(gradient.x, gradient.y, 0.0)));
        let above = pose.origin.z + arm.z - (bed.z_below(&here) + radius) + lower;
        if above.re < 0.0 {
            let turned = bed.curvature(&here).unwrap_or_else(M3::zeros);
            let along = near((&gradient, &turned), &here, &place);
            sum.add(&arm, &(along * (above * -spring)));
        }
    }
}

/// How far the bed gives way under the weight of a body in air on one end of a member \[m\].
const GIVES_WAY: f64 = 1e-3;

/// Drag across a member by the velocity of the water relative to it, on its part below the surface.
pub(super) fn drag(
    network: &Network,
    member: &Member,
    pose: &MovingPose<'_>,
    placed: &Placed<'_>,
    sum: &mut LoadSum,
) {
    if member.drag == 0.0 {
        return;
    }
    let current = network.current.as_ref();
    for slice in placed.wet_slices() {
        // The profile rises and falls with the surface.
        let mut at = pose.place(&slice.arm);
        at.z = slice.height;
        let here = at.map(|part| part.re);
        let (water, gradient) =
            current.map_or_else(Default::default, |current| current.flow(&here));
        let mut velocity = near((&water, &gradient), &here, &at) - pose.velocity_at(&slice.arm);
        if let Some(flow) = placed.waves.get(2 + slice.number) {
            let place = pose.place(&slice.arm);
            velocity += near((&flow.velocity, &flow.gradient), &flow.place, &place);
        }
        let across = velocity - placed.axis * velocity.dot(&placed.axis);
        let speed2 = across.dot(&across);
        if speed2.re == 0.0 {
            continue;
        }
        let width = slice.radius * 2.0;
        let by_speed = width * slice.long * speed2.sqrt() * (0.5 * network.density * member.drag);
        sum.add(&slice.arm, &(across * by_speed));
    }
}

/// Load of the acceleration of the water on the part of a member below the surface: the pressure of the undisturbed wave in all directions,
/// and the added mass across the member (Morison et al. 1950; DNV-RP-C205 2019, section 6.2). With the buoyancy up to the surface of the
/// wave, which counts its pressure at still water as that at rest, the pressure on the ends is complete.
pub(super) fn wave_inertia(
    network: &Network,
    member: &Member,
    pose: &MovingPose<'_>,
    placed: &Placed<'_>,
    sum: &mut LoadSum,
) {
    if placed.waves.is_empty() {
        return;
    }
    for slice in placed.wet_slices() {
        let flow = &placed.waves[2 + slice.number];
        let known = (&flow.acceleration, &flow.acceleration_gradient);
        let water = near(known, &flow.place, &pose.place(&slice.arm));
        let across = water - placed.axis * water.dot(&placed.axis);
        let mass = slice.radius * slice.radius * slice.long * (PI * network.density);
        sum.add(
            &slice.arm,
            &((water + across * Dual::from_re(member.added_mass)) * mass),
        );
    }
}

/// Added mass of the members about the origin of their body, in the earth's axes \[kg, kg m, kg m²\].
pub(super) fn added_mass(network: &Network, body: &Body, pose: &Pose) -> Matrix6<f64> {
    let mut mass = Matrix6::zeros();
    for member in body
        .members
        .iter()
        .filter(|member| member.added_mass > 0.0 && !member.drag_only)
    {
        let (from, to) = (pose.arm(&member.from), pose.arm(&member.to));
        let length = (to - from).norm();
        let axis = (to - from) / length;
        let across = M3::identity() - axis * axis.transpose();
        for (node, weight) in RULE.iter() {
            let arm = from.lerp(&to, *node);
            if pose.origin.z + arm.z > 0.0 {
                continue;
            }
            let radius = member.radius.0 + node * (member.radius.1 - member.radius.0);
            let water = network.density * member.added_mass * PI * radius * radius;
            let here = across * (water * weight * length);
            let lever = cross(&arm);
            let mut block = mass.fixed_view_mut::<3, 3>(0, 0);
            block += here;
            let mut block = mass.fixed_view_mut::<3, 3>(0, 3);
            block -= here * lever;
            let mut block = mass.fixed_view_mut::<3, 3>(3, 0);
            block += lever * here;
            let mut block = mass.fixed_view_mut::<3, 3>(3, 3);
            block -= lever * here * lever;
        }
    }
    mass
}
