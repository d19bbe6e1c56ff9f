//! Classical Runge-Kutta of order 4: the independent reference for accuracy, and the method for short,
//! snappy lines. Stable up to 2.785 / omega of the fastest axial mode, which is known beforehand, and to 2.785 / lambda
//! of the fastest decay by drag, which grows with speed: a step longer than that is refused and halved.

use super::march::ROOM_TO_DOUBLE;
use super::{MethodState, StepError, Stepper, TimeStep, WorkCounts};
use crate::numerics::V3;
use crate::solve::{NewtonError, State, System};

/// Where the stability region ends on the negative real axis.
const REAL_AXIS: f64 = 2.785;

/// Scratch for one line; allocates only when made.
#[derive(Debug, Clone)]
pub struct Rk4 {
    stage: State,
    next: State,
    /// The fastest decay at the end of the last step \[1/s\] and its node, once it is known.
    decay: Option<(f64, usize)>,
    work_counts: WorkCounts,
}

impl Rk4 {
    /// Scratch for a line of `nodes` nodes.
    #[must_use]
    pub fn new(nodes: usize) -> Self {
        let state = State::at_rest(vec![V3::zeros(); nodes]);
        Self {
            stage: state.clone(),
            next: state,
            decay: None,
            work_counts: WorkCounts::default(),
        }
    }

    /// Evaluates the stage and adds its derivative, times `weight`, to the next state.
    fn add_stage<S: System + ?Sized>(&mut self, system: &S, t: f64, weight: f64) {
        system.prescribe(t, &mut self.stage);
        system.update_wave_kinematics(t, &mut self.stage);
        system.accelerate(t, &mut self.stage);
        self.work_counts.evaluations += 1;
        for i in system.free() {
            self.next.x[i] += self.stage.v[i] * weight;
            self.next.v[i] += self.stage.a[i] * weight;
        }
    }

    /// Sets the stage to the state moved along its own last derivative by h.
    fn move_stage<S: System + ?Sized>(&mut self, system: &S, state: &State, h: f64) {
        for i in system.free() {
            self.stage.x[i] = state.x[i] + self.stage.v[i] * h;
            self.stage.v[i] = state.v[i] + self.stage.a[i] * h;
        }
    }

    /// Refuses a step in which a number is not finite (accelerations too: what goes astray shows in them first), and
    /// one that is too long for the decay by drag at either end of it. Returns a share of error that leaves room for a
    /// step twice as long where the decay bears that. The end of one step is the beginning of the next.
    fn check<S: System + ?Sized>(
        &mut self,
        system: &S,
        h: f64,
        state: &State,
    ) -> Result<f64, NewtonError> {
        let finite = |p: &V3| p.iter().all(|c| c.is_finite());
        let next = &self.next;
        let spoilt = |i: usize| !finite(&next.x[i]) || !finite(&next.v[i]) || !finite(&next.a[i]);
        if let Some(node) = system.free().find(|&i| spoilt(i)) {
            return Err(NewtonError::NotFinite { node });
        }
        let mut share = 0.0_f64;
        let begin = self.decay.unwrap_or_else(|| system.fastest_decay(state));
        self.decay = Some(begin);
        let end = system.fastest_decay(next);
        for (rate, node) in [end, begin] {
            if h * rate > REAL_AXIS {
                return Err(NewtonError::Unstable { node });
            }
            share = share.max(2.0 * ROOM_TO_DOUBLE * h * rate / REAL_AXIS);
        }
        self.decay = Some(end);
        Ok(share)
    }
}

impl Stepper for Rk4 {
    fn step<S: System + ?Sized>(
        &mut self,
        system: &S,
        at: TimeStep,
        state: &mut State,
    ) -> Result<f64, StepError> {
        let TimeStep { t, dt, .. } = at;
        self.stage.copy_from(state);
        self.next.copy_from(state);
        let half = 0.5 * dt;
        self.add_stage(system, t, dt / 6.0);
        self.move_stage(system, state, half);
        self.add_stage(system, t + half, dt / 3.0);
        self.move_stage(system, state, half);
        self.add_stage(system, t + half, dt / 3.0);
        self.move_stage(system, state, dt);
        self.add_stage(system, t + dt, dt / 6.0);
        system.prescribe(t + dt, &mut self.next);
        system.update_wave_kinematics(t + dt, &mut self.next);
        // The acceleration of the last stage is at the end of the step: good for what is read off.
        self.next.a.copy_from_slice(&self.stage.a);
        let share = self.check(system, dt, state)?;
        state.copy_from(&self.next);
        Ok(share)
    }

    fn method_state(&self) -> MethodState {
        MethodState {
            decay: self.decay,
            work_counts: self.work_counts,
            ..MethodState::default()
        }
    }

    fn restore(&mut self, carried: &MethodState) {
        self.decay = carried.decay;
        self.work_counts = carried.work_counts;
    }

    fn restart<S: System + ?Sized>(&mut self, system: &S, t: f64, state: &mut State) {
        system.update_wave_kinematics(t, state);
        system.accelerate(t, state);
        self.decay = None;
    }

    fn work_counts(&self) -> WorkCounts {
        self.work_counts
    }
}
