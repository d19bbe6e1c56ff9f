//! Rigid payload that rotates: the last two nodes of the scene and the rod between them, in the water.
//!
//! A load at the centre of buoyancy acts on both nodes by the shares `b`, a couple by `g = (-1, 1)`; the motion of that centre and
//! of the axis follow from the nodes by the same shares. The added mass A and added inertia I so couple the nodes,
//! `W_ij = b_i b_j A + g_i g_j I / d²`, d the length of the rod.

mod energy;
mod hydrodynamics;
#[cfg(test)]
mod tests;

use nalgebra::Matrix6;

use crate::numerics::{BlockBand, M3, V3};
use crate::physics::RigidBody;
use crate::physics::kirchhoff::RelativeMotion;
use crate::scene::LumpedLine;
use crate::scene::element::{At, Element};
use crate::solve::{Factors, State};
use hydrodynamics::SurroundingWater;

/// A rigid body at the end of the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidPayload {
    /// The node of its hang point, the last of the line; the next one is its centre of percussion.
    pub node: usize,
    /// The body; its mass and weight are included in those of the two nodes, and its rod is the last segment.
    pub body: RigidBody,
}

/// Shares of both nodes in a couple.
const COUPLE: [f64; 2] = [-1.0, 1.0];

/// Blocks of a matrix that couples the two nodes: `[i][j]` is the block of row i and node j.
type Blocks = [[M3; 2]; 2];

impl Element for RigidPayload {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        let a = [at.state.a[self.node], at.state.a[self.node + 1]];
        let balance = self.balance(at.line, at.state, a);
        for (r, balance) in r[self.node..].iter_mut().zip(balance) {
            *r += balance;
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.add_residual(at, r);
        let there = self.water_around(at.line, at.state);
        let mut blocks = self.inertia_blocks(&there, at.state, c);
        self.add_drag_blocks(&there, at.line, at.state, c, &mut blocks);
        let [[near, upper], [lower, far]] = blocks;
        tangent.diag[self.node] += near;
        tangent.upper[self.node] += upper;
        tangent.lower[self.node + 1] += lower;
        tangent.diag[self.node + 1] += far;
    }

    fn has_explicit_form(&self) -> bool {
        true
    }

    fn add_energy(&self, at: At<'_>, energy: &mut f64) {
        *energy += self.kinetic_energy(at.line, at.state);
    }

    fn add_dissipation(&self, at: At<'_>, power: &mut f64) {
        *power += self.dissipation(at.line, at.state);
    }

    fn add_wave_power(&self, at: At<'_>, power: &mut f64) {
        *power += self.wave_power(at.line, at.state);
    }

    fn add_water_drag_power(&self, at: At<'_>, power: &mut f64) {
        *power += self.water_drag_power(at.line, at.state);
    }

    fn add_growth(&self, at: At<'_>, power: &mut f64) {
        *power += self.growth(at.line, at.state);
    }
}

impl RigidPayload {
    pub(in crate::scene) fn at(&self, values: &[V3], place: f64) -> V3 {
        values[self.node] * (1.0 - place) + values[self.node + 1] * place
    }

    /// Difference of both nodes: from velocities, the rate of the axis times the length of the rod.
    fn opening(&self, values: &[V3]) -> V3 {
        values[self.node + 1] - values[self.node]
    }

    /// Motion of the body relative to the water, at these accelerations of both nodes.
    fn moving(&self, there: &SurroundingWater, state: &State, a: [V3; 2]) -> RelativeMotion {
        let (at, inverse) = (self.body.buoyancy_at, 1.0 / self.body.reach);
        RelativeMotion {
            t: there.axis.tangent,
            v: self.at(&state.v, at) - there.flow.0,
            a: a[0] * (1.0 - at) + a[1] * at - there.carried.0,
            turn: self.opening(&state.v) * inverse,
            gain: (a[1] - a[0]) * inverse,
        }
    }

    /// Residual of the water and the spin at both nodes, at these accelerations \[N\].
    pub(in crate::scene) fn balance(
        &self,
        line: &LumpedLine,
        state: &State,
        a: [V3; 2],
    ) -> [V3; 2] {
        let there = self.water_around(line, state);
        let moving = self.moving(&there, state, a);
        let (force, couple) = self.body.added.force_and_couple(&moving);
        let spin = self.body.gyroscopic(&moving.t, &moving.turn).0;
        let load = force * there.wet.0 - self.lift(&there);
        let pull = (couple * there.wet.0 + spin) / self.body.reach;
        let shares = RigidBody::shares(self.body.buoyancy_at);
        let mut balance = [0, 1].map(|i| load * shares[i] + pull * COUPLE[i]);
        for strip in self.strips(line, state) {
            let drag = self.body.drag(&moving.t, &strip.u) * (strip.part * there.wet.0);
            for (out, share) in balance.iter_mut().zip(RigidBody::shares(strip.place)) {
                *out -= drag * share;
            }
        }
        balance
    }

    /// Derivative of the axis by the difference of both nodes \[1/m\].
    fn axis_by_difference(there: &SurroundingWater) -> M3 {
        let t = &there.axis.tangent;
        (M3::identity() - t * t.transpose()) * there.axis.inverse
    }

    /// Tangent of added mass, wave pressure, buoyancy and gyroscopic couple.
    fn inertia_blocks(&self, there: &SurroundingWater, state: &State, c: Factors) -> Blocks {
        let moving = self.moving(there, state, [state.a[self.node], state.a[self.node + 1]]);
        let (needs, [force, couple]) = (
            self.body.added.force_and_couple(&moving),
            self.body.added.derivatives(&moving),
        );
        let (spin_t, spin_turn) = self.body.gyroscopic(&moving.t, &moving.turn).1.into();
        let (share, by_place) = there.wet;
        let (by_axis, inverse) = (Self::axis_by_difference(there), 1.0 / self.body.reach);
        // Of the load and of the couple, each by the position of the centre and by the difference of the nodes.
        let moved = force.a + M3::from_diagonal_element(there.displaced);
        let gained = needs.0 - self.lift_if_wet(there);
        let load_by_place = gained * by_place.transpose()
            - (moved * there.carried.1 + force.v * there.flow.1) * share;
        let load = [
            force.a * (c.mass * share)
                + force.v * (c.damping * share)
                + load_by_place * c.stiffness,
            force.turn * (c.damping * share * inverse) + force.t * by_axis * (c.stiffness * share),
        ];
        let couple_by_place = needs.1 * by_place.transpose() - couple.v * there.flow.1 * share;
        let pull = [
            couple.v * (c.damping * share) + couple_by_place * c.stiffness,
            couple.gain * (c.mass * share * inverse)
                + spin_turn * (c.damping * inverse)
                + (couple.t * share + spin_t) * by_axis * c.stiffness,
        ];
        let b = RigidBody::shares(self.body.buoyancy_at);
        let block = |i: usize, j: usize| {
            (load[0] * b[j] + load[1] * COUPLE[j]) * b[i]
                + (pull[0] * b[j] + pull[1] * COUPLE[j]) * (COUPLE[i] * inverse)
        };
        [[block(0, 0), block(0, 1)], [block(1, 0), block(1, 1)]]
    }

    /// Subtracts the tangent of drag: by the relative velocity of each strip, by the axis, and by the submerged fraction.
    fn add_drag_blocks(
        &self,
        there: &SurroundingWater,
        line: &LumpedLine,
        state: &State,
        c: Factors,
        blocks: &mut Blocks,
    ) {
        let (t, axis) = (&there.axis.tangent, Self::axis_by_difference(there));
        let (share, by_place) = there.wet;
        let b = RigidBody::shares(self.body.buoyancy_at);
        for strip in self.strips(line, state) {
            let (by_velocity, by_axis) = self.body.drag_derivatives(t, &strip.u);
            let own = by_velocity
                * (M3::from_diagonal_element(c.damping) - strip.gradient * c.stiffness)
                * share;
            let by_axis = by_axis * axis * (-c.stiffness * share);
            let by_wet = self.body.drag(t, &strip.u) * by_place.transpose() * -c.stiffness;
            let d = RigidBody::shares(strip.place);
            for (row, d_i) in blocks.iter_mut().zip(d) {
                for (j, block) in row.iter_mut().enumerate() {
                    *block +=
                        (own * d[j] + by_axis * COUPLE[j] + by_wet * b[j]) * (d_i * strip.part);
                }
            }
        }
    }

    /// Mass matrix of both nodes, added mass included \[kg\].
    pub(in crate::scene) fn coupled_mass(&self, line: &LumpedLine, state: &State) -> Matrix6<f64> {
        let there = self.water_around(line, state);
        let t = &there.axis.tangent;
        let added = self.body.added.matrix(t) * there.wet.0;
        let turned = (M3::identity() - t * t.transpose())
            * (there.wet.0 * self.body.added.inertia / self.body.reach.powi(2));
        let b = RigidBody::shares(self.body.buoyancy_at);
        let mut mass = Matrix6::zeros();
        for i in 0..2 {
            for j in 0..2 {
                let block = added * (b[i] * b[j]) + turned * (COUPLE[i] * COUPLE[j]);
                mass.fixed_view_mut::<3, 3>(3 * i, 3 * j).copy_from(&block);
            }
            let own = line.own_mass(self.node + i, state);
            let mut block = mass.fixed_view_mut::<3, 3>(3 * i, 3 * i);
            block += own;
        }
        mass
    }

    /// Accelerations of both nodes by a force on the hang point \[1/kg\].
    pub(in crate::scene) fn inverse_mass(&self, line: &LumpedLine, state: &State) -> [M3; 2] {
        let inverse = self.coupled_mass(line, state).try_inverse();
        let inverse = inverse.unwrap_or_else(Matrix6::zeros);
        [0, 3].map(|row| inverse.fixed_view::<3, 3>(row, 0).into_owned())
    }

    /// Decay rate of the body by drag \[1/s\].
    pub(in crate::scene) fn decay(&self, line: &LumpedLine, state: &State) -> f64 {
        let mass = [line.mass[self.node], line.mass[self.node + 1]];
        let strips = self.strips(line, state);
        strips
            .map(|strip| strip.part * self.body.damping_rate(strip.place, strip.u.norm(), mass))
            .sum()
    }
}
