//! A ship as a rigid body at the end of a line, both in one system of equations (eqs. 4 and 5 of the ropeway paper): to the
//! solvers it is a line whose last two nodes are the ship.
//!
//! # Unknowns
//! The nodes of the line, the last of them the fairlead; then the position of the ship's reference point, and its rotation from
//! the equilibrium heading times a length. Rotations are of first order, as in the paper's equation (4): constant mass, damping
//! and restoring. Loads are constant, or a [`Forcing`]: wind, current and drift on the moving ship, and waves.
//!
//! # Equations
//! The rows of the line are unchanged. The row of the fairlead is the constraint `x_f = X + r + θ × r`, which is linear, so that
//! any time integration preserves it for velocities and accelerations. The line force on the ship is in the row of translation;
//! the row of rotation is taken about the fairlead, `moment - r × force`, where that force has no arm: each row then couples to
//! at most two preceding nodes, and the whole is one block-banded system with its exact tangent.

use std::ops::Range;

use nalgebra::{Matrix6, Vector6};

use super::forcing::Forcing;
use crate::numerics::{BlockBand, M3, V3};
use crate::scene::Scene;
use crate::solve::{ExplicitRhs, Factors, Hysteresis, Kinematics, MidstepBalance, Residual, State};

/// A ship as a rigid body about its reference point, in global axes: surge, sway, heave, roll, pitch, yaw are displacements
/// along and rotations about x, y, z.
#[derive(Debug, Clone, PartialEq)]
pub struct ShipBody {
    /// Mass and added mass \[kg, kg m, kg m²\]; symmetric.
    pub mass: Matrix6<f64>,
    /// Damping matrix.
    pub damping: Matrix6<f64>,
    /// Restoring stiffness matrix.
    pub restoring: Matrix6<f64>,
    /// Constant load: force \[N\] and moment about the reference point \[N m\].
    pub load: Vector6<f64>,
    /// Further loads: environment and waves.
    pub forcing: Forcing,
    /// Position of the reference point at zero restoring force \[m\].
    pub origin: V3,
    /// From the reference point to the fairlead \[m\].
    pub arm: V3,
    /// Length by which rotations are scaled to metres \[m\].
    pub length: f64,
}

/// A line with a ship at its end B.
#[derive(Debug, Clone, PartialEq)]
pub struct MooredShip {
    line: Scene,
    ship: ShipBody,
    /// Scale of the constraint of the fairlead to a force \[N/m\].
    constraint: f64,
}

/// Why a line cannot be coupled to a ship.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum MooredShipError {
    /// Bending couples five nodes.
    #[error("a line with bending stiffness cannot be coupled to a ship; omit EI")]
    Bending,
    /// An end of the line is not fixed.
    #[error("both ends of the line must be fixed: A at the anchor, B at the ship")]
    FreeEnd,
}

impl MooredShip {
    /// Couples a ship to end B of a line.
    ///
    /// # Errors
    /// [`MooredShipError`].
    pub fn new(line: Scene, ship: ShipBody) -> Result<Self, MooredShipError> {
        if line.is_pentadiagonal() {
            return Err(MooredShipError::Bending);
        }
        if line.free() != (1..line.nodes() - 1) {
            return Err(MooredShipError::FreeEnd);
        }
        let constraint = line.line.force_scale / ship.length;
        Ok(Self {
            line,
            ship,
            constraint,
        })
    }

    /// A state of the line with the ship at rest at its end.
    #[must_use]
    pub fn at_rest(&self, line: &State) -> State {
        self.rotated(line, V3::zeros())
    }

    /// The same, the ship rotated \[rad\] about its fairlead.
    #[must_use]
    pub fn rotated(&self, line: &State, rotation: V3) -> State {
        let mut state = line.clone();
        let fairlead = state.x[self.fairlead()];
        let centre = fairlead - self.ship.arm - rotation.cross(&self.ship.arm);
        state.x.extend([centre, rotation * self.ship.length]);
        state.v.resize(state.x.len(), V3::zeros());
        state.a.resize(state.x.len(), V3::zeros());
        state
    }

    /// Surge, sway, heave from the origin \[m\], roll, pitch, yaw \[rad\].
    #[must_use]
    pub fn motion(&self, state: &State) -> Vector6<f64> {
        let t = self.fairlead() + 1;
        stacked(
            state.x[t] - self.ship.origin,
            state.x[t + 1] / self.ship.length,
        )
    }

    /// Tension of the line at the ship \[N\].
    #[must_use]
    pub fn tension(&self, state: &State) -> f64 {
        self.line.tension_at(self.fairlead(), state)
    }

    /// Tension of the line at its anchor \[N\].
    #[must_use]
    pub fn anchor_tension(&self, state: &State) -> f64 {
        self.line.tension_at(0, state)
    }

    /// Sets the velocities of the ship \[m/s, rad/s\], and those of the line linear between anchor and fairlead.
    pub fn set_velocity(&self, velocity: &Vector6<f64>, state: &mut State) {
        let f = self.fairlead();
        let translation = velocity.fixed_rows::<3>(0).into_owned();
        let rotation: V3 = velocity.fixed_rows::<3>(3).into_owned();
        let fairlead = translation + rotation.cross(&self.ship.arm);
        for (i, v) in state.v.iter_mut().enumerate().take(f + 1) {
            *v = fairlead * (i as f64 / f as f64);
        }
        state.v[f + 1] = translation;
        state.v[f + 2] = rotation * self.ship.length;
    }

    /// Energy of line and ship, with the potential of the constant load and without that of the forcing \[J\].
    #[must_use]
    pub fn energy(&self, state: &State) -> f64 {
        let (q, v) = (self.motion(state), self.velocity(state));
        let own = 0.5 * v.dot(&(self.ship.mass * v)) + 0.5 * q.dot(&(self.ship.restoring * q));
        self.line.energy(state) + own - q.dot(&self.ship.load)
    }

    /// Power dissipated by the ship's damping \[W\].
    #[must_use]
    pub fn dissipation(&self, state: &State) -> f64 {
        let v = self.velocity(state);
        v.dot(&(self.ship.damping * v))
    }

    /// Velocities of the six motions \[m/s, rad/s\].
    #[must_use]
    pub fn velocity(&self, state: &State) -> Vector6<f64> {
        let t = self.fairlead() + 1;
        stacked(state.v[t], state.v[t + 1] / self.ship.length)
    }

    fn fairlead(&self) -> usize {
        self.line.nodes() - 1
    }

    /// Residual force and moment of the ship alone, `M a + C v + K q - F`.
    fn ship_residual(&self, time: f64, state: &State) -> (V3, V3) {
        let t = self.fairlead() + 1;
        let a = stacked(state.a[t], state.a[t + 1] / self.ship.length);
        let (q, v) = (self.motion(state), self.velocity(state));
        let r = self.ship.mass * a + self.ship.damping * v + self.ship.restoring * q
            - self.ship.load
            - self.ship.forcing.at(time, &q, &v);
        (
            r.fixed_rows::<3>(0).into_owned(),
            r.fixed_rows::<3>(3).into_owned(),
        )
    }

    /// The rows of fairlead and ship, from that of the line's end.
    fn couple(&self, time: f64, state: &State, r: &mut [V3]) {
        let (f, arm) = (self.fairlead(), &self.ship.arm);
        let pull = r[f];
        let (force, moment) = self.ship_residual(time, state);
        let rotation = state.x[f + 2] / self.ship.length;
        let fairlead = state.x[f + 1] + arm + rotation.cross(arm);
        r[f] = (state.x[f] - fairlead) * self.constraint;
        r[f + 1] = force + pull;
        r[f + 2] = (moment - arm.cross(&force)) / self.ship.length;
    }

    fn couple_tangent(&self, state: &State, c: Factors, tangent: &mut BlockBand) {
        let (f, length) = (self.fairlead(), self.ship.length);
        let ship = self.ship.mass * c.mass
            + self.ship.damping * c.damping
            + self.ship.restoring * c.stiffness
            - self
                .ship
                .forcing
                .tangent(&self.motion(state), &self.velocity(state), c);
        let block =
            |i: usize, j: usize| -> M3 { ship.fixed_view::<3, 3>(3 * i, 3 * j).into_owned() };
        let arm = self.ship.arm.cross_matrix();
        let constraint = self.constraint * c.stiffness;
        // The row of the line's end is added to the row of translation.
        tangent.far_lower[f + 1] = tangent.lower[f];
        tangent.lower[f + 1] = tangent.diag[f];
        tangent.diag[f + 1] = block(0, 0);
        tangent.upper[f + 1] = block(0, 1) / length;
        tangent.lower[f] = M3::zeros();
        tangent.diag[f] = M3::identity() * constraint;
        tangent.upper[f] = M3::identity() * -constraint;
        tangent.far_upper[f] = arm * (constraint / length);
        tangent.lower[f + 2] = (block(1, 0) - arm * block(0, 0)) / length;
        tangent.diag[f + 2] = (block(1, 1) - arm * block(0, 1)) / (length * length);
    }
}

fn stacked(upper: V3, lower: V3) -> Vector6<f64> {
    Vector6::new(upper.x, upper.y, upper.z, lower.x, lower.y, lower.z)
}

impl Kinematics for MooredShip {
    fn nodes(&self) -> usize {
        self.line.nodes() + 2
    }

    fn free(&self) -> Range<usize> {
        1..self.nodes()
    }

    fn prescribe(&self, t: f64, state: &mut State) {
        // The ship moves its end of the line, whatever the case of the line prescribes.
        let f = self.fairlead();
        let held = (state.x[f], state.v[f], state.a[f]);
        self.line.prescribe(t, state);
        (state.x[f], state.v[f], state.a[f]) = held;
    }

    fn next_kink(&self, state: &State) -> f64 {
        self.line.next_kink(state)
    }

    fn pass_kink(&self, t: f64, state: &mut State) -> bool {
        let f = self.fairlead();
        let held = (state.x[f], state.v[f], state.a[f]);
        let jumps = self.line.pass_kink(t, state);
        (state.x[f], state.v[f], state.a[f]) = held;
        jumps
    }

    fn update_wave_kinematics(&self, t: f64, state: &mut State) {
        self.line.update_wave_kinematics(t, state);
    }
}

impl Residual for MooredShip {
    fn is_pentadiagonal(&self) -> bool {
        // Rows couple to two neighbours on either side, as those of a line with bending stiffness.
        true
    }

    fn residual(&self, t: f64, state: &State, r: &mut [V3]) {
        self.line.residual(t, state, &mut r[..=self.fairlead()]);
        self.couple(t, state, r);
    }

    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        let f = self.fairlead();
        tangent.far_lower.fill(M3::zeros());
        tangent.far_upper.fill(M3::zeros());
        self.line.linearise(t, state, c, &mut r[..=f], tangent);
        self.couple(t, state, r);
        self.couple_tangent(state, c, tangent);
    }
}

impl ExplicitRhs for MooredShip {
    /// The mass of the last half segment, with its added mass, is taken as isotropic; only explicit solvers keep these
    /// accelerations.
    fn accelerate(&self, t: f64, state: &mut State) {
        let f = self.fairlead();
        state.a[f] = V3::zeros();
        self.line.accelerate(t, state);
        let (arm, length) = (self.ship.arm, self.ship.length);
        state.a[f + 1] = V3::zeros();
        state.a[f + 2] = V3::zeros();
        let (force, moment) = self.ship_residual(t, state);
        let pull = self.line.end_force(f, state);
        let right = stacked(pull - force, arm.cross(&pull) - moment);
        let mut mass = self.ship.mass;
        let cross = arm.cross_matrix();
        let end = self.line.line.mass[f];
        let mut add = |i: usize, j: usize, block: M3| {
            let mut view = mass.fixed_view_mut::<3, 3>(3 * i, 3 * j);
            view += block * end;
        };
        add(0, 0, M3::identity());
        add(0, 1, -cross);
        add(1, 0, cross);
        add(1, 1, -cross * cross);
        let a = mass.lu().solve(&right).unwrap_or_else(Vector6::zeros);
        let (linear, angular) = (V3::new(a[0], a[1], a[2]), V3::new(a[3], a[4], a[5]));
        state.a[f + 1] = linear;
        state.a[f + 2] = angular * length;
        state.a[f] = linear + angular.cross(&arm);
    }
}

impl Hysteresis for MooredShip {
    fn commit(&self, t: f64, dt: f64, state: &mut State) {
        self.line.commit(t, dt, state);
    }

    fn freeze_drag_coefficients(&self, state: &mut State) {
        self.line.freeze_drag_coefficients(state);
    }
}

impl MidstepBalance for MooredShip {}
