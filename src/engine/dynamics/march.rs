//! The time march that all methods share: events cut a step short, and the sink may stop it after any step. What is recorded
//! between two steps is interpolated: no output time changes a step. See [`step_control`](super::step_control) for the
//! length of the steps.

use super::progress::MarchProgress;
use super::step_control::WholeStep;
use super::{MarchError, Stepper};
use crate::solve::{AcceptedStep, Marched, Progressing, Sink};

/// A march from time 0 to `duration` in whole steps of `step`, each divided as the step control asks for. The last whole step
/// is cut short where they do not divide the duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct March {
    /// Simulated time \[s\].
    pub duration: f64,
    /// Length of a whole step, the greatest there is \[s\].
    pub step: f64,
}

/// Summary of a march.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarchSummary {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Whether the sink stopped it.
    pub stopped: bool,
}

impl March {
    /// Number of whole steps, the last one counted though it be cut short.
    #[must_use]
    pub fn whole_steps(&self) -> u64 {
        (self.duration / self.step * (1.0 - 1e-9)).ceil().max(1.0) as u64
    }

    /// The lengths of the accepted steps \[s\] and the number of each; a step cut short by an event counts as whole.
    pub fn lengths(&self, progress: &MarchProgress) -> impl Iterator<Item = (f64, u64)> {
        let dt = self.step;
        let taken = progress.halved.into_iter().enumerate();
        let lengths = taken.map(move |(k, steps)| (dt / (1_u64 << k) as f64, steps));
        lengths.filter(|(_, steps)| *steps > 0)
    }

    /// Whether a march is complete.
    #[must_use]
    pub fn is_over(&self, progress: &MarchProgress) -> bool {
        self.is_at(progress, self.duration)
    }

    /// Whether a march has come to a time \[s\], but for rounding.
    #[must_use]
    pub fn is_at(&self, progress: &MarchProgress, time: f64) -> bool {
        progress.time >= time - self.slop()
    }

    /// Whether a time \[s\] is after the end.
    #[must_use]
    pub fn is_after_end(&self, time: f64) -> bool {
        time > self.duration + self.slop()
    }

    /// Times closer than this are the same \[s\].
    fn slop(&self) -> f64 {
        1e-9 * self.step
    }

    /// Marches `state` from time 0. The sink receives the state at time 0 first.
    ///
    /// # Errors
    /// [`MarchError`] when a step fails at every length tried; `state` is the last accepted one.
    pub fn run<M: Stepper<S>, S: Marched>(
        &self,
        method: &mut M,
        system: &S,
        state: &mut S::State,
        sink: &mut dyn Sink<S::State>,
    ) -> Result<MarchSummary, MarchError> {
        let mut progress = MarchProgress::default();
        system.update_wave_kinematics(0.0, state);
        system.commit(0.0, 0.0, state);
        let first = AcceptedStep {
            time: 0.0,
            state,
            steps: 0,
            whole: true,
        };
        let mut going = sink.accept(first);
        if going == Progressing::Continue {
            going = self.advance(&mut progress, f64::INFINITY, method, system, state, sink)?;
        }
        Ok(MarchSummary {
            steps: progress.steps,
            rejections: progress.rejections,
            stopped: going == Progressing::Stop,
        })
    }

    /// Continues the march to a time \[s\] or to its end. A time between two whole steps is hit exactly, by a step that is cut
    /// short there and completed when the march continues. So is every kink of the prescribed motion, which is passed when the
    /// march continues.
    ///
    /// # Errors
    /// As [`March::run`].
    pub fn advance<M: Stepper<S>, S: Marched>(
        &self,
        progress: &mut MarchProgress,
        until: f64,
        method: &mut M,
        system: &S,
        state: &mut S::State,
        sink: &mut dyn Sink<S::State>,
    ) -> Result<Progressing, MarchError> {
        let until = until.min(self.duration);
        let same = |a: f64, b: f64| (a - b).abs() <= self.slop();
        while progress.time < until && !same(progress.time, until) {
            let kink = system.next_kink(state);
            if progress.done == 0 && progress.time >= kink - self.slop() {
                method.pass_kink(system, progress.time, state);
                sink.jump(progress.time, state);
                continue;
            }
            let until = until.min(kink);
            let end = (progress.whole + 1) as f64 * self.step;
            let cut = until < end && !same(until, end);
            let whole = if cut {
                WholeStep {
                    from: progress.time,
                    dt: until - progress.time,
                    end: until,
                }
            } else {
                // From a time on the grid this is its step to the last digit.
                let on_grid = progress.time == progress.whole as f64 * self.step;
                WholeStep {
                    from: progress.time,
                    dt: if on_grid {
                        self.step
                    } else {
                        end - progress.time
                    },
                    end: if same(self.duration, end) {
                        self.duration
                    } else {
                        end
                    },
                }
            };
            if whole.take(progress, method, system, state, sink)? == Progressing::Stop {
                return Ok(Progressing::Stop);
            }
            progress.time = whole.end;
            progress.done = 0;
            progress.whole += u64::from(!cut);
        }
        Ok(Progressing::Continue)
    }
}
