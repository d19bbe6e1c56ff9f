//! The pose of a body as numbers with derivatives: its loads are written once, for value and tangent.

use super::{members, pose::Pose};
use crate::{
    numerics::{M3, V3},
    physics::sea::WaterMotion,
};
use nalgebra::Vector3;
use num_dual::DualSVec64;

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
    /// What waves make of the water at the station of the body, at those of the members and at the strips of its drag; empty in still water.
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
    pub(super) fn at_rest(pose: &Pose) -> Self {
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

    /// What waves make of the water at the station of the body itself ([`Body::station`](super::network::Body::station)).
    pub(super) fn at_station(&self) -> Option<&'a WaterMotion> {
        self.waves.first()
    }

    /// What waves make of the water at the strips of the drag of the body, of this many; empty in still water.
    pub(super) fn at_strips(&self, count: usize) -> &'a [WaterMotion] {
        let first = self.waves.len().saturating_sub(count);
        &self.waves[first..]
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
