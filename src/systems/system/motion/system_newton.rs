//! Newton's iteration of a system in a step of an implicit method.

use super::border::Border;
use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::solve::{Convergence, ConvergenceRate, Factors, NewtonError, Residual};

/// Iterations without progress after which a step is halved.
const STAGNATION_LIMIT: usize = 6;

/// The iteration and its work arrays; allocates in [`SystemNewton::new`] only.
#[derive(Debug, Clone)]
pub(super) struct SystemNewton {
    pub(super) border: Border,
    tolerance: f64,
    /// Tolerance on the velocities \[m/s\], infinite where no force depends steeply on them.
    velocity_tolerance: f64,
    max_iterations: usize,
    /// Rate of convergence of the last iterations.
    pub(super) rate: Option<ConvergenceRate>,
    /// Iterations so far.
    pub(super) iterations: u64,
}

impl SystemNewton {
    /// For a system from a state, with a tolerance \[m\] and the greatest number of iterations in a step.
    pub(super) fn new(
        system: &MovingSystem,
        state: &SystemState,
        tolerance: f64,
        max_iterations: usize,
    ) -> Self {
        Self {
            border: Border::new(system, state),
            tolerance,
            velocity_tolerance: f64::INFINITY,
            max_iterations,
            rate: None,
            iterations: 0,
        }
    }

    /// The same with a tolerance on the velocities \[m/s\].
    pub(super) fn resolving(self, speed: f64) -> Self {
        Self {
            velocity_tolerance: speed,
            ..self
        }
    }

    /// Iterates on a state whose velocities and accelerations follow its places by the factors; transverse to the lines within another
    /// tolerance \[m\] where that is greater.
    ///
    /// # Errors
    /// Where it does not converge.
    pub(super) fn solve(
        &mut self,
        system: &MovingSystem,
        t: f64,
        state: &mut SystemState,
        c: Factors,
        transverse: f64,
    ) -> Result<(), NewtonError> {
        let tolerance = match c.damping > 0.0 {
            true => self.tolerance.min(self.velocity_tolerance / c.damping),
            false => self.tolerance,
        };
        let mut convergence = Convergence::new(tolerance, self.rate);
        let (mut worst, mut made) = ((0, f64::INFINITY), 0);
        while made < self.max_iterations && convergence.idle() < STAGNATION_LIMIT {
            made += 1;
            self.iterations += 1;
            self.border.solve(system, t, state, c)?;
            worst = self.border.greatest(system)?;
            let moved = self.norm(system, state, worst.1, transverse);
            self.apply(system, state, c);
            let reached = convergence.is_reached(moved);
            self.rate = convergence.rate();
            let smooth = reached && (moved <= tolerance || !self.passes_kink(system, state));
            if smooth && self.border.missed_by_drives(system, c) <= self.tolerance {
                return Ok(());
            }
        }
        self.rate = None;
        Err(NewtonError::NotConverged {
            iterations: made,
            node: worst.0,
            moved: worst.1,
        })
    }

    /// Whether the displacement just made turns a segment taut or slack. The rate of convergence, measured where no tension has a
    /// kink, predicts nothing there: with it an iteration stopped with the whole tension of the segment out of balance.
    fn passes_kink(&self, system: &MovingSystem, state: &SystemState) -> bool {
        let lines = system.lines(state).enumerate();
        let joints = self.border.displacements(system.scenes.len());
        let mut passes = lines.map(|(number, (scene, line))| {
            let d = self.border.displacements(number);
            let out = system.paid_out_by(number, joints);
            scene.line.turns_taut_or_slack(d, out, line)
        });
        passes.any(|passes| passes)
    }

    /// The displacement in the norm of convergence \[m\]: along the lines in full, transverse to them by the ratio of the tolerances.
    fn norm(&self, system: &MovingSystem, state: &SystemState, moved: f64, transverse: f64) -> f64 {
        // A force that depends steeply on velocity does so in every direction.
        if transverse <= self.tolerance || self.velocity_tolerance.is_finite() {
            return moved;
        }
        let lines = system.lines(state).enumerate();
        let along = lines
            .map(|(number, (scene, line))| {
                scene.force_norm_displacement(self.border.displacements(number), line)
            })
            .fold(0.0, f64::max);
        along.max(moved * self.tolerance / transverse)
    }

    fn apply(&self, system: &MovingSystem, state: &mut SystemState, c: Factors) {
        for (number, part) in state.parts_mut().enumerate() {
            let d = self.border.displacements(number);
            for i in system.free(number) {
                part.x[i] -= d[i];
                part.v[i] -= d[i] * c.damping;
                part.a[i] -= d[i] * c.mass;
            }
        }
        system.follow(state);
    }
}
