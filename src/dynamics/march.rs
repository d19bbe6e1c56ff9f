//! The march through time that all methods share: output times hit exactly, a step that fails is
//! halved and counted, the sink may stop it at any step.

use crate::solve::{Instant, NewtonError, Progressing, Sink, State, System};

/// A method that can take one step.
pub trait Stepper {
    /// Moves `state` from t to t + dt. On failure `state` must be as before the step.
    ///
    /// # Errors
    /// Why the step cannot be taken at this length.
    fn step<S: System + ?Sized>(
        &mut self,
        system: &S,
        t: f64,
        dt: f64,
        state: &mut State,
    ) -> Result<(), NewtonError>;

    /// Work done so far.
    fn tally(&self) -> Tally;
}

/// Machine-independent work of a stepper.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tally {
    /// Newton iterations.
    pub iterations: u64,
    /// Evaluations of the force without tangent.
    pub evaluations: u64,
}

/// What is marched: from 0 to `duration` in steps of at most `step`, output every `output`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct March {
    /// Simulated time \[s\].
    pub duration: f64,
    /// Greatest step \[s\].
    pub step: f64,
    /// Interval of output times \[s\].
    pub output: f64,
}

/// How a march ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Accepted steps.
    pub steps: u64,
    /// Steps that failed and were halved.
    pub rejections: u64,
    /// Whether the sink stopped it.
    pub stopped: bool,
}

/// A step that could not be taken at any length tried.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("at t = {time:.6} s, node {}: {why} (the step was halved down to {step:.3e} s)", why.node())]
pub struct MarchError {
    /// Time of the last accepted state \[s\].
    pub time: f64,
    /// The shortest step tried \[s\].
    pub step: f64,
    /// Steps accepted before.
    pub steps: u64,
    /// Steps rejected before.
    pub rejections: u64,
    /// Why.
    pub why: NewtonError,
}

/// How often a failing step is halved before the march gives up.
const HALVINGS: u32 = 14;

impl March {
    /// Marches `state` from time 0. The state at time 0 is given to the sink first.
    ///
    /// # Errors
    /// [`MarchError`] when a step fails at every length tried; `state` is the last accepted one.
    pub fn run<M: Stepper, S: System + ?Sized>(
        &self,
        method: &mut M,
        system: &S,
        state: &mut State,
        sink: &mut dyn Sink,
    ) -> Result<Outcome, MarchError> {
        let mut outcome = Outcome {
            steps: 0,
            rejections: 0,
            stopped: false,
        };
        let first = Instant {
            time: 0.0,
            state,
            steps: 0,
            output: true,
        };
        if sink.accept(first) == Progressing::Stop {
            return Ok(Outcome {
                stopped: true,
                ..outcome
            });
        }
        // Output intervals divide the duration, steps divide the output interval: no time is ever a
        // sum of many roundings.
        let outputs = (self.duration / self.output).round().max(1.0) as u64;
        let interval = self.duration / outputs as f64;
        let per_output = (interval / self.step * (1.0 - 1e-9)).ceil().max(1.0) as u64;
        let dt = interval / per_output as f64;
        for k in 0..outputs * per_output {
            let t = k as f64 * dt;
            self.guarded(method, system, t, dt, state, &mut outcome)?;
            let output = (k + 1) % per_output == 0;
            let instant = Instant {
                time: (k + 1) as f64 * dt,
                state,
                steps: outcome.steps,
                output,
            };
            if sink.accept(instant) == Progressing::Stop {
                outcome.stopped = true;
                return Ok(outcome);
            }
        }
        Ok(outcome)
    }

    /// One step of length dt, in halves of halves where it must be.
    fn guarded<M: Stepper, S: System + ?Sized>(
        &self,
        method: &mut M,
        system: &S,
        from: f64,
        dt: f64,
        state: &mut State,
        outcome: &mut Outcome,
    ) -> Result<(), MarchError> {
        let (mut done, mut pieces) = (0_u64, 1_u64);
        let mut halvings = 0;
        while done < pieces {
            let h = dt / pieces as f64;
            match method.step(system, from + done as f64 * h, h, state) {
                Ok(()) => {
                    done += 1;
                    outcome.steps += 1;
                    // Twice the piece as soon as it fits: a hard moment does not slow the rest of the step.
                    if pieces > 1 && done % 2 == 0 {
                        (done, pieces) = (done / 2, pieces / 2);
                        halvings -= 1;
                    }
                }
                Err(why) => {
                    outcome.rejections += 1;
                    if halvings == HALVINGS {
                        let (steps, rejections) = (outcome.steps, outcome.rejections);
                        let time = from + done as f64 * h;
                        return Err(MarchError {
                            time,
                            step: h,
                            steps,
                            rejections,
                            why,
                        });
                    }
                    (done, pieces) = (done * 2, pieces * 2);
                    halvings += 1;
                }
            }
        }
        Ok(())
    }
}
