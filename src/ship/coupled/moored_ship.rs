//! A ship as a rigid body at the end of a line, both in one system of equations (eqs. 4 and 5 of the ropeway paper): the
//! solvers see a line whose last two nodes are the ship.
//!
//! # Unknowns
//! The nodes of the line, the last of them the fairlead; then one for the ship's translation, the place of its reference
//! point, and one for its rotation from the heading it lies at, times a length. Rotations are of first order, as in the
//! paper's equation (4): constant mass, damping and restoring. Loads are constant, or a [`Forcing`]: wind, current and drift
//! on the ship as it turns and moves, and waves.
//!
//! # Equations
//! The rows of the line are its own. That of the fairlead ties it to the ship, `x_f = X + r + θ × r`, which is linear, so
//! that any method of time integration keeps it for velocities and accelerations as well. The line's end pulls at the ship
//! in the row of translation; the row of rotation is taken about the fairlead, `moment - r × force`, where that pull has no
//! arm: so each row reaches two nodes back at most, and the whole is solved as one block-banded system, in one Newton, with
//! the exact tangent and the order of the method.

use std::ops::Range;

use nalgebra::{Matrix6, Vector6};

use super::forcing::Forcing;
use crate::numerics::{BlockBand, M3, V3};
use crate::scene::Scene;
use crate::solve::{ExplicitRhs, Factors, Hysteresis, Kinematics, MidstepBalance, Residual, State};

/// A ship as a rigid body about its reference point, in the axes of the case: surge, sway, heave, roll, pitch, yaw as
/// displacements along and turns about x, y, z.
#[derive(Debug, Clone, PartialEq)]
pub struct ShipBody {
    /// Mass and added mass \[kg, kg m, kg m²\]; symmetric.
    pub mass: Matrix6<f64>,
    /// Damping per velocity.
    pub damping: Matrix6<f64>,
    /// Restoring per displacement.
    pub restoring: Matrix6<f64>,
    /// Constant load: force \[N\] and moment about the reference point \[N m\].
    pub load: Vector6<f64>,
    /// What acts beside it: flows on the ship as it turns and moves, and waves.
    pub forcing: Forcing,
    /// Where the reference point is when nothing restores \[m\].
    pub place: V3,
    /// From the reference point to the fairlead \[m\].
    pub arm: V3,
    /// A length of the ship, by which rotations are told in metres \[m\].
    pub length: f64,
}

/// A line with a ship at its end B.
#[derive(Debug, Clone, PartialEq)]
pub struct MooredShip {
    line: Scene,
    ship: ShipBody,
    /// Stiffness by which the tie of the fairlead is told as a force \[N/m\].
    tie: f64,
}

/// Why a line cannot hold a ship.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum MooredShipError {
    /// Bending reaches over three nodes.
    #[error("a line with bending stiffness cannot hold a ship; leave EI out")]
    Bends,
    /// The line's own end is not held.
    #[error("both ends of the line must be held: A by the anchor, B by the ship")]
    Loose,
}

impl MooredShip {
    /// Ties a ship to end B of a line.
    ///
    /// # Errors
    /// [`MooredShipError`].
    pub fn new(line: Scene, ship: ShipBody) -> Result<Self, MooredShipError> {
        if line.is_pentadiagonal() {
            return Err(MooredShipError::Bends);
        }
        if line.free() != (1..line.nodes() - 1) {
            return Err(MooredShipError::Loose);
        }
        let tie = line.force_scale / ship.length;
        Ok(Self { line, ship, tie })
    }

    /// The line's state with the ship at rest where its fairlead holds the line's end.
    #[must_use]
    pub fn at_rest(&self, line: &State) -> State {
        self.turned(line, V3::zeros())
    }

    /// The same, the ship turned \[rad\] about its fairlead.
    #[must_use]
    pub fn turned(&self, line: &State, turn: V3) -> State {
        let mut state = line.clone();
        let fairlead = state.x[self.fairlead()];
        let centre = fairlead - self.ship.arm - turn.cross(&self.ship.arm);
        state.x.extend([centre, turn * self.ship.length]);
        state.v.resize(state.x.len(), V3::zeros());
        state.a.resize(state.x.len(), V3::zeros());
        state
    }

    /// Surge, sway, heave from the ship's place \[m\], roll, pitch, yaw \[rad\].
    #[must_use]
    pub fn motion(&self, state: &State) -> Vector6<f64> {
        let t = self.fairlead() + 1;
        stacked(
            state.x[t] - self.ship.place,
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

    /// Sets the ship going with these velocities \[m/s, rad/s\], and the line with it as a straight stretch would go.
    pub fn set_going(&self, velocity: &Vector6<f64>, state: &mut State) {
        let f = self.fairlead();
        let parts = velocity.fixed_rows::<3>(0).into_owned();
        let turn: V3 = velocity.fixed_rows::<3>(3).into_owned();
        let fairlead = parts + turn.cross(&self.ship.arm);
        for (i, v) in state.v.iter_mut().enumerate().take(f + 1) {
            *v = fairlead * (i as f64 / f as f64);
        }
        state.v[f + 1] = parts;
        state.v[f + 2] = turn * self.ship.length;
    }

    /// Energy of line and ship, its constant load counted as potential and any other forcing left out \[J\].
    #[must_use]
    pub fn energy(&self, state: &State) -> f64 {
        let (q, v) = (self.motion(state), self.velocity(state));
        let own = 0.5 * v.dot(&(self.ship.mass * v)) + 0.5 * q.dot(&(self.ship.restoring * q));
        self.line.energy(state) + own - q.dot(&self.ship.load)
    }

    /// Power that the ship's damping takes \[W\].
    #[must_use]
    pub fn dissipation(&self, state: &State) -> f64 {
        let v = self.velocity(state);
        v.dot(&(self.ship.damping * v))
    }

    /// The rates of its six motions \[m/s, rad/s\].
    #[must_use]
    pub fn velocity(&self, state: &State) -> Vector6<f64> {
        let t = self.fairlead() + 1;
        stacked(state.v[t], state.v[t + 1] / self.ship.length)
    }

    fn fairlead(&self) -> usize {
        self.line.nodes() - 1
    }

    /// Force and moment that the ship's own equation leaves, `M a + C v + K q - F`.
    fn own(&self, time: f64, state: &State) -> (V3, V3) {
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
    fn tie(&self, time: f64, state: &State, r: &mut [V3]) {
        let (f, arm) = (self.fairlead(), &self.ship.arm);
        let pull = r[f];
        let (force, moment) = self.own(time, state);
        let turn = state.x[f + 2] / self.ship.length;
        let hangs = state.x[f + 1] + arm + turn.cross(arm);
        r[f] = (state.x[f] - hangs) * self.tie;
        r[f + 1] = force + pull;
        r[f + 2] = (moment - arm.cross(&force)) / self.ship.length;
    }

    fn tie_tangent(&self, state: &State, c: Factors, tangent: &mut BlockBand) {
        let (f, length) = (self.fairlead(), self.ship.length);
        let own = self.ship.mass * c.mass
            + self.ship.damping * c.damping
            + self.ship.restoring * c.stiffness
            - self
                .ship
                .forcing
                .tangent(&self.motion(state), &self.velocity(state), c);
        let block =
            |i: usize, j: usize| -> M3 { own.fixed_view::<3, 3>(3 * i, 3 * j).into_owned() };
        let arm = self.ship.arm.cross_matrix();
        let tie = self.tie * c.stiffness;
        // The row of the line's end becomes part of the row of translation.
        tangent.far_lower[f + 1] = tangent.lower[f];
        tangent.lower[f + 1] = tangent.diag[f];
        tangent.diag[f + 1] = block(0, 0);
        tangent.upper[f + 1] = block(0, 1) / length;
        tangent.lower[f] = M3::zeros();
        tangent.diag[f] = M3::identity() * tie;
        tangent.upper[f] = M3::identity() * -tie;
        tangent.far_upper[f] = arm * (tie / length);
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
        // The ship holds its end of the line, whatever the line's case says of it.
        let f = self.fairlead();
        let held = (state.x[f], state.v[f], state.a[f]);
        self.line.prescribe(t, state);
        (state.x[f], state.v[f], state.a[f]) = held;
    }

    fn update_wave_kinematics(&self, t: f64, state: &mut State) {
        self.line.update_wave_kinematics(t, state);
    }
}

impl Residual for MooredShip {
    fn is_pentadiagonal(&self) -> bool {
        // Rows reach two nodes, as those of a line that bends.
        true
    }

    fn residual(&self, t: f64, state: &State, r: &mut [V3]) {
        self.line.residual(t, state, &mut r[..=self.fairlead()]);
        self.tie(t, state, r);
    }

    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        let f = self.fairlead();
        tangent.far_lower.fill(M3::zeros());
        tangent.far_upper.fill(M3::zeros());
        self.line.linearise(t, state, c, &mut r[..=f], tangent);
        self.tie(t, state, r);
        self.tie_tangent(state, c, tangent);
    }
}

impl ExplicitRhs for MooredShip {
    /// The added mass of the last half segment counts as that of the line's mass there, in all directions alike; no
    /// solver carries that on but an explicit one.
    fn accelerate(&self, t: f64, state: &mut State) {
        let f = self.fairlead();
        state.a[f] = V3::zeros();
        self.line.accelerate(t, state);
        let (arm, length) = (self.ship.arm, self.ship.length);
        state.a[f + 1] = V3::zeros();
        state.a[f + 2] = V3::zeros();
        let (force, moment) = self.own(t, state);
        let pull = self.line.end_force(f, state);
        let right = stacked(pull - force, arm.cross(&pull) - moment);
        let mut mass = self.ship.mass;
        let cross = arm.cross_matrix();
        let end = self.line.mass[f];
        let mut add = |i: usize, j: usize, block: M3| {
            let mut view = mass.fixed_view_mut::<3, 3>(3 * i, 3 * j);
            view += block * end;
        };
        add(0, 0, M3::identity());
        add(0, 1, -cross);
        add(1, 0, cross);
        add(1, 1, -cross * cross);
        let a = mass.lu().solve(&right).unwrap_or_else(Vector6::zeros);
        let (shift, turn) = (V3::new(a[0], a[1], a[2]), V3::new(a[3], a[4], a[5]));
        state.a[f + 1] = shift;
        state.a[f + 2] = turn * length;
        state.a[f] = shift + turn.cross(&arm);
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
