//! What methods of time integration ask of a system: a line, or lines, points and bodies together.

use super::newton::Iterated;
use super::{
    ExplicitRhs, Hysteresis, Kinematics, MidstepBalance, NewtonError, PartedSystem, State,
};
use crate::numerics::V3;

/// What the time march asks of a system.
pub trait Marched: PartedSystem {
    /// As [`Kinematics::next_kink`].
    fn next_kink(&self, state: &Self::State) -> f64;

    /// As [`Kinematics::update_wave_kinematics`].
    fn update_wave_kinematics(&self, t: f64, state: &mut Self::State);

    /// As [`Hysteresis::commit`].
    fn commit(&self, t: f64, dt: f64, state: &mut Self::State);
}

impl<S: Hysteresis> Marched for S {
    fn next_kink(&self, state: &State) -> f64 {
        Kinematics::next_kink(self, state)
    }

    fn update_wave_kinematics(&self, t: f64, state: &mut State) {
        Kinematics::update_wave_kinematics(self, t, state);
    }

    fn commit(&self, t: f64, dt: f64, state: &mut State) {
        Hysteresis::commit(self, t, dt, state);
    }
}

/// What the methods ask of it.
pub trait Integrated: Marched + Iterated {
    /// How fast what a free node counts in changes: its velocity \[m/s\], or of a rotation what its angular velocity makes of it.
    fn rate(&self, _part: usize, state: &State, node: usize) -> V3 {
        state.v[node]
    }

    /// As [`Kinematics::prescribe`].
    fn prescribe(&self, t: f64, state: &mut Self::State);

    /// Sets what follows the free nodes.
    fn follow(&self, _state: &mut Self::State) {}

    /// As [`Kinematics::pass_kink`].
    fn pass_kink(&self, t: f64, state: &mut Self::State) -> bool;

    /// Sets the accelerations of what is prescribed in the mix of the states before and after a step at which forces balance;
    /// `fraction` is that of the state before.
    fn prescribe_between(
        &self,
        _fraction: f64,
        _before: &Self::State,
        _end: &Self::State,
        _between: &mut Self::State,
    ) {
    }

    /// Accelerations from positions and velocities, by the forces.
    ///
    /// # Errors
    /// Where nothing has mass.
    fn accelerate(
        &self,
        work: &mut Self::Work,
        t: f64,
        state: &mut Self::State,
    ) -> Result<(), NewtonError>;

    /// As [`ExplicitRhs::fastest_decay`].
    fn fastest_decay(&self, work: &Self::Work, state: &Self::State) -> (f64, usize);

    /// As [`Kinematics::extrapolate_wave_kinematics`].
    fn extrapolate_wave_kinematics(
        &self,
        t: f64,
        time: f64,
        before: &Self::State,
        state: &mut Self::State,
    );

    /// As [`MidstepBalance::correct_chord_lengths`], and what else a state at the end of a step takes of its balance, which is that of the
    /// state between.
    fn correct_after_balance(
        &self,
        fraction: f64,
        before: &Self::State,
        between: &Self::State,
        end: &mut Self::State,
    );

    /// As [`MidstepBalance::snap_acceleration`].
    fn snap_acceleration(&self, between: &Self::State, end: &Self::State) -> f64;

    /// By how much a step exceeds what it may pass of lengths that change, by an error ratio.
    fn passes(&self, _before: &Self::State, _end: &Self::State) -> f64 {
        0.0
    }

    /// As [`Hysteresis::freeze_drag_coefficients`].
    fn freeze_drag_coefficients(&self, state: &mut Self::State);
}

impl<S: MidstepBalance + ExplicitRhs + Hysteresis> Integrated for S {
    fn prescribe(&self, t: f64, state: &mut State) {
        Kinematics::prescribe(self, t, state);
    }

    fn pass_kink(&self, t: f64, state: &mut State) -> bool {
        Kinematics::pass_kink(self, t, state)
    }

    fn accelerate(&self, _: &mut Self::Work, t: f64, state: &mut State) -> Result<(), NewtonError> {
        ExplicitRhs::accelerate(self, t, state);
        Ok(())
    }

    fn fastest_decay(&self, _: &Self::Work, state: &State) -> (f64, usize) {
        ExplicitRhs::fastest_decay(self, state)
    }

    fn extrapolate_wave_kinematics(&self, t: f64, time: f64, before: &State, state: &mut State) {
        Kinematics::extrapolate_wave_kinematics(self, t, time, before, state);
    }

    fn correct_after_balance(&self, fraction: f64, before: &State, _: &State, end: &mut State) {
        self.correct_chord_lengths(fraction, before, end);
    }

    fn snap_acceleration(&self, between: &State, end: &State) -> f64 {
        MidstepBalance::snap_acceleration(self, between, end)
    }

    fn freeze_drag_coefficients(&self, state: &mut State) {
        Hysteresis::freeze_drag_coefficients(self, state);
    }
}
