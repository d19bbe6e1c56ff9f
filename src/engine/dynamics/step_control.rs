//! Time-step control: a whole step of the march is divided into `2^level` equal steps.
//!
//! A step that fails, or whose estimated error exceeds the limits, is halved (`level` + 1). Where two steps join to one of
//! twice the length and the error leaves room, the next one is doubled (`level` - 1). The level is kept from one whole
//! step to the next, so that all times are `2^-level` fractions of the grid.

use super::progress::{MAX_HALVINGS, MarchProgress};
use super::{StepError, Stepper, TimeStep};
use crate::solve::{AcceptedStep, Marched, NewtonError, Progressing, Sink};

/// Greatest number of times a step is halved for accuracy. Across a discontinuity of force shorter steps are no more
/// accurate, since the estimate there falls with the step and not with its square.
const MAX_HALVINGS_FOR_ACCURACY: u32 = 7;

/// The step is doubled if its error, relative to the limits, is below this: an error of third order then stays below 1.
pub(super) const DOUBLING_ERROR: f64 = 0.1;

/// A step that fails at every length.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("at t = {time:.6} s, node {}: {why} (the step was halved down to {step:.3e} s)", why.node())]
pub struct MarchError {
    /// Time of the last accepted state \[s\].
    pub time: f64,
    /// The shortest step tried \[s\].
    pub step: f64,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Why.
    pub why: NewtonError,
}

/// A whole step of the march.
pub(super) struct WholeStep {
    /// Start \[s\].
    pub(super) from: f64,
    /// Length \[s\].
    pub(super) dt: f64,
    /// End, without the rounding of a sum \[s\].
    pub(super) end: f64,
}

impl WholeStep {
    /// Takes the whole step in `2^level` steps, and adapts the level of `progress`.
    ///
    /// # Errors
    /// [`MarchError`] if a step fails at every length; `state` is then the last accepted one.
    pub(super) fn take<M: Stepper<S>, S: Marched>(
        &self,
        progress: &mut MarchProgress,
        method: &mut M,
        system: &S,
        state: &mut S::State,
        sink: &mut dyn Sink<S::State>,
    ) -> Result<Progressing, MarchError> {
        // What was taken of it before the march was stopped counts.
        while progress.done < 1 << progress.level {
            let dt = self.dt / (1_u64 << progress.level) as f64;
            let t = self.from + progress.done as f64 * dt;
            let reject = progress.level < MAX_HALVINGS_FOR_ACCURACY;
            match method.step(system, TimeStep { t, dt, reject }, state) {
                Ok(error) => {
                    progress.done += 1;
                    progress.steps += 1;
                    progress.halved[progress.level as usize] += 1;
                    let last = progress.done == 1 << progress.level;
                    let time = if last {
                        self.end
                    } else {
                        self.from + progress.done as f64 * dt
                    };
                    system.commit(time, dt, state);
                    let instant = AcceptedStep {
                        time,
                        state,
                        steps: progress.steps,
                        whole: last,
                    };
                    let joins = progress.level > 0 && progress.done.is_multiple_of(2);
                    if joins && error < DOUBLING_ERROR {
                        progress.done /= 2;
                        progress.level -= 1;
                    }
                    if sink.accept(instant) == Progressing::Stop {
                        return Ok(Progressing::Stop);
                    }
                }
                Err(why) => {
                    halve(why, t, dt, progress)?;
                    progress.done *= 2;
                }
            }
        }
        Ok(Progressing::Continue)
    }
}

/// Counts a rejected step and raises the level.
fn halve(why: StepError, t: f64, dt: f64, progress: &mut MarchProgress) -> Result<(), MarchError> {
    progress.rejections += 1;
    if let (StepError::Unsolved(why), MAX_HALVINGS..) = (why, progress.level) {
        return Err(MarchError {
            time: t,
            step: dt,
            steps: progress.steps,
            rejections: progress.rejections,
            why,
        });
    }
    progress.level += 1;
    Ok(())
}
