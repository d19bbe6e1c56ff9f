//! Loads on a body that no line brings: weight, buoyancy, water-plane, steady loads, its members in the water and on the bed, wind and current.
//!
//! Loads that hang on the pose are written once, for dual numbers in the six small motions of the body: their stiffness is exact and
//! cannot come apart from them.

use nalgebra::{Matrix6, Vector3, Vector6};
use num_dual::DualSVec64;

use super::heading_loads;
use super::line_at_rest::LinePhysics;
use super::members::{self, Placed};
use super::network::{Body, Network};
use super::pose::{Pose, cross};
use super::waterplane;
use crate::numerics::{M3, V3};
use crate::physics::sea::WaterMotion;

/// A number and its change with three displacements and three turns.
pub(super) type Dual = DualSVec64<6>;
/// A vector of them.
pub(super) type DualVector = Vector3<Dual>;

/// A pose and its small motions, and how fast it moves.
pub(super) struct MovingPose<'a> {
    pose: Pose,
    /// The origin, and the small turn.
    pub(super) origin: DualVector,
    turn: DualVector,
    /// Velocity of the origin \[m/s\] and angular velocity \[rad/s\], in the earth's directions.
    pub(super) velocity: DualVector,
    pub(super) spin: DualVector,
    /// What waves make of the water at the origin and at the stations of the members; empty in still water.
    waves: &'a [WaterMotion],
}

/// A vector that moves with three of the six unknowns, by this matrix.
pub(super) fn unknown(value: &V3, first: usize, by: &M3) -> DualVector {
    DualVector::from_fn(|row, _| {
        let mut number = Dual::from_re(value[row]);
        let mut eps = nalgebra::SVector::<f64, 6>::zeros();
        for k in 0..3 {
            eps[first + k] = by[(row, k)];
        }
        number.eps = num_dual::Derivative::some(eps);
        number
    })
}

impl<'a> MovingPose<'a> {
    /// At rest; its unknowns are displacements and turns in the earth's directions.
    pub(super) fn of(pose: &Pose) -> Self {
        let one = M3::identity();
        let still = constant(&V3::zeros());
        Self::moving(
            pose,
            unknown(&pose.origin, 0, &one),
            unknown(&V3::zeros(), 3, &one),
            (still, still),
        )
    }

    /// In motion: its origin, its small turn, and its velocity and angular velocity as they depend on the unknowns.
    pub(super) fn moving(
        pose: &Pose,
        origin: DualVector,
        turn: DualVector,
        (velocity, spin): (DualVector, DualVector),
    ) -> Self {
        Self {
            pose: *pose,
            origin,
            turn,
            velocity,
            spin,
            waves: &[],
        }
    }

    /// The same in waves.
    pub(super) fn in_waves(self, waves: &'a [WaterMotion]) -> Self {
        Self { waves, ..self }
    }

    /// What waves make of the water at the origin.
    pub(super) fn at_origin(&self) -> Option<&'a WaterMotion> {
        self.waves.first()
    }

    /// What waves make of the water at the stations of a member; empty in still water.
    pub(super) fn at_member(&self, number: usize) -> &'a [WaterMotion] {
        let stations = self.waves.get(1..).unwrap_or_default();
        let mut members = stations.chunks_exact(members::STATIONS);
        members.nth(number).unwrap_or_default()
    }

    /// A place at an arm from the origin.
    pub(super) fn place(&self, arm: &DualVector) -> DualVector {
        self.origin + arm
    }

    /// The velocity at an arm.
    pub(super) fn velocity_at(&self, arm: &DualVector) -> DualVector {
        self.velocity + self.spin.cross(arm)
    }

    /// A vector of the earth's directions along the axes of the body.
    pub(super) fn to_body(&self, v: &DualVector) -> DualVector {
        let back = self.pose.rotation.inverse().to_rotation_matrix();
        let back = back.matrix().map(Dual::from_re);
        back * (v - self.turn.cross(v))
    }

    /// A vector along the axes of the body in the earth's directions.
    pub(super) fn to_earth(&self, v: &DualVector) -> DualVector {
        let there = self.pose.matrix().matrix().map(Dual::from_re) * v;
        there + self.turn.cross(&there)
    }

    /// The arm from the origin to a place of the body, or a direction of it, in the earth's axes.
    pub(super) fn arm(&self, place: &V3) -> DualVector {
        let arm = constant(&self.pose.arm(place));
        arm + self.turn.cross(&arm)
    }
}

/// A vector of the water near a place where it is known, to first order in the distance.
pub(super) fn near(known: (&V3, &M3), from: &V3, place: &DualVector) -> DualVector {
    let (value, gradient) = known;
    constant(value) + gradient.map(Dual::from_re) * (place - constant(from))
}

/// A vector that does not change.
pub(super) fn constant(v: &V3) -> DualVector {
    DualVector::from_fn(|k, _| Dual::from_re(v[k]))
}

/// Force and moment about the moving origin.
pub(super) struct LoadSum {
    force: DualVector,
    moment: DualVector,
}

impl LoadSum {
    pub(super) fn none() -> Self {
        let zero = constant(&V3::zeros());
        Self {
            force: zero,
            moment: zero,
        }
    }

    /// A force at an arm.
    pub(super) fn add(&mut self, arm: &DualVector, force: &DualVector) {
        self.force += force;
        self.moment += arm.cross(force);
    }

    /// A moment alone.
    pub(super) fn turn(&mut self, moment: &DualVector) {
        self.moment += moment;
    }

    /// Values, and minus their change with the six motions.
    pub(super) fn parts(&self) -> (Vector6<f64>, Matrix6<f64>) {
        let at = |row: usize| match row {
            0..3 => &self.force[row],
            _ => &self.moment[row - 3],
        };
        let value = Vector6::from_fn(|row, _| at(row).re);
        let stiffness = Matrix6::from_fn(|row, column| {
            let eps = at(row).eps.0.as_ref();
            -eps.map_or(0.0, |eps| eps[column])
        });
        (value, stiffness)
    }
}

/// Force and moment about its origin on a body, lines apart \[N, N m\], and minus their change \[N/m, N, N m\].
///
/// Wind and current count in the full physics only: they have no energy.
#[must_use]
pub fn body_loads(
    network: &Network,
    body: &Body,
    pose: &Pose,
    physics: LinePhysics,
) -> (Vector6<f64>, Matrix6<f64>) {
    let (force, stiffness) = fixed_loads(body, pose);
    let flow = physics == LinePhysics::Full && network.flows();
    let mut sum = LoadSum::none();
    add_loads_by_pose(network, body, &MovingPose::of(pose), flow, &mut sum);
    let (by_water, by_pose) = sum.parts();
    (force + by_water, stiffness + by_pose)
}

/// The members of a body that displace water, at the pose given in still water.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MembersInWater {
    /// Their volume in the water \[m³\].
    pub volume: f64,
    /// Whether the surface cuts any of them.
    pub cut_by_surface: bool,
    /// Whether any has added mass, across it or at its ends.
    pub have_added_mass: bool,
}

impl MembersInWater {
    /// Of a body.
    #[must_use]
    pub fn of(body: &Body) -> Self {
        let pose = MovingPose::of(&body.pose);
        let mut found = Self::default();
        for member in body.members.iter().filter(|member| !member.drag_only) {
            let volume = Placed::of(member, &pose, &[]).volume_in_water();
            found.volume += volume;
            found.cut_by_surface |= volume > 0.0 && volume < (1.0 - ROUNDING) * member.volume();
            found.have_added_mass |=
                member.added_mass > 0.0 || member.added_mass_ends.iter().any(|mass| *mass > 0.0);
        }
        found
    }
}

/// Share of a volume that is rounding.
const ROUNDING: f64 = 1e-9;

/// Loads that hang on the pose and, where there is flow, on the velocity.
pub(super) fn add_loads_by_pose(
    network: &Network,
    body: &Body,
    moving: &MovingPose,
    flow: bool,
    sum: &mut LoadSum,
) {
    waterplane::add(body, moving, sum);
    for (number, member) in body.members.iter().enumerate() {
        let placed = Placed::of(member, moving, moving.at_member(number));
        if !member.drag_only {
            members::buoyancy(network, &placed, sum);
        }
        members::bed(network, body, member, moving, sum);
        if flow {
            members::drag(network, member, moving, &placed, sum);
            if !member.drag_only {
                members::wave_inertia(network, member, moving, &placed, sum);
            }
        }
    }
    if flow {
        heading_loads::add(network, body, moving, sum);
    }
}

/// Weight, buoyancy of the volume given, and steady loads.
pub(super) fn fixed_loads(body: &Body, pose: &Pose) -> (Vector6<f64>, Matrix6<f64>) {
    let mut force = Vector6::zeros();
    let mut stiffness = Matrix6::zeros();
    let mut at = |arm: V3, load: V3| {
        let moment = arm.cross(&load);
        for k in 0..3 {
            force[k] += load[k];
            force[k + 3] += moment[k];
        }
        let mut block = stiffness.fixed_view_mut::<3, 3>(3, 3);
        block -= cross(&load) * cross(&arm);
    };
    at(V3::zeros(), body.load);
    at(pose.arm(&body.centre_of_gravity), V3::z() * -body.weight);
    at(pose.arm(&body.centre_of_buoyancy), V3::z() * body.buoyancy);
    for k in 0..3 {
        force[k + 3] += body.moment[k];
    }
    if let Some(axis) = &body.spins_about {
        // A rod does not resist its spin, which nothing hangs on: this keeps it where it is.
        let axis = pose.arm(axis);
        let mut block = stiffness.fixed_view_mut::<3, 3>(3, 3);
        block += axis * axis.transpose() * body.spin_stiffness();
    }
    (force, stiffness)
}
