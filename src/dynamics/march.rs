//! The time march that all methods share: output times are hit exactly, events cut a step short, and the sink may stop it
//! after any step. See [`step_control`](super::step_control) for the length of the steps.

use super::progress::MarchProgress;
use super::step_control::WholeStep;
use super::{MarchError, Stepper};
use crate::solve::{Hysteresis, Instant, Progressing, Sink, State};

/// A march from time 0 to `duration` in steps of at most `step`, with output every `output`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct March {
    /// Simulated time \[s\].
    pub duration: f64,
    /// Greatest step \[s\].
    pub step: f64,
    /// Interval of output times \[s\].
    pub output: f64,
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

/// The times of a march. Output intervals divide the duration, and whole steps divide the output interval, so that no time
/// accumulates rounding errors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimeGrid {
    /// Length of a whole step \[s\].
    pub dt: f64,
    /// Whole steps in an output interval.
    pub per_output: u64,
    /// Output intervals.
    pub outputs: u64,
}

impl TimeGrid {
    /// Time of the output with this number \[s\].
    #[must_use]
    pub fn output(&self, number: u64) -> f64 {
        (number * self.per_output) as f64 * self.dt
    }
}

impl March {
    /// The times of this march.
    #[must_use]
    pub fn grid(&self) -> TimeGrid {
        let outputs = (self.duration / self.output).round().max(1.0) as u64;
        let interval = self.duration / outputs as f64;
        let per_output = (interval / self.step * (1.0 - 1e-9)).ceil().max(1.0) as u64;
        TimeGrid {
            dt: interval / per_output as f64,
            per_output,
            outputs,
        }
    }

    /// The lengths of the accepted steps \[s\] and the number of each; a step cut short by an event counts as whole.
    pub fn lengths(&self, progress: &MarchProgress) -> impl Iterator<Item = (f64, u64)> {
        let dt = self.grid().dt;
        let taken = progress.halved.into_iter().enumerate();
        let lengths = taken.map(move |(k, steps)| (dt / (1_u64 << k) as f64, steps));
        lengths.filter(|(_, steps)| *steps > 0)
    }

    /// Whether a march is complete.
    #[must_use]
    pub fn is_over(&self, progress: &MarchProgress) -> bool {
        let grid = self.grid();
        progress.whole >= grid.outputs * grid.per_output
    }

    /// Marches `state` from time 0. The sink receives the state at time 0 first.
    ///
    /// # Errors
    /// [`MarchError`] when a step fails at every length tried; `state` is the last accepted one.
    pub fn run<M: Stepper<S>, S: Hysteresis>(
        &self,
        method: &mut M,
        system: &S,
        state: &mut State,
        sink: &mut dyn Sink,
    ) -> Result<MarchSummary, MarchError> {
        let mut progress = MarchProgress::default();
        system.update_wave_kinematics(0.0, state);
        system.commit(0.0, 0.0, state);
        let first = Instant {
            time: 0.0,
            state,
            steps: 0,
            output: true,
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
    /// short there and completed when the march continues.
    ///
    /// # Errors
    /// As [`March::run`].
    pub fn advance<M: Stepper<S>, S: Hysteresis>(
        &self,
        progress: &mut MarchProgress,
        until: f64,
        method: &mut M,
        system: &S,
        state: &mut State,
        sink: &mut dyn Sink,
    ) -> Result<Progressing, MarchError> {
        let grid = self.grid();
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * grid.dt;
        while progress.whole < grid.outputs * grid.per_output {
            if progress.time >= until || same(progress.time, until) {
                break;
            }
            let end = (progress.whole + 1) as f64 * grid.dt;
            let cut = until < end && !same(until, end);
            let whole = if cut {
                WholeStep {
                    from: progress.time,
                    dt: until - progress.time,
                    end: until,
                    output: false,
                }
            } else {
                // From a time on the grid this is its step to the last digit.
                let on_grid = progress.time == progress.whole as f64 * grid.dt;
                WholeStep {
                    from: progress.time,
                    dt: if on_grid {
                        grid.dt
                    } else {
                        end - progress.time
                    },
                    end: if on_grid {
                        progress.time + grid.dt
                    } else {
                        end
                    },
                    output: (progress.whole + 1).is_multiple_of(grid.per_output),
                }
            };
            if whole.take(progress, method, system, state, sink)? == Progressing::Stop {
                return Ok(Progressing::Stop);
            }
            progress.time = if cut { until } else { end };
            progress.whole += u64::from(!cut);
        }
        Ok(Progressing::Continue)
    }
}
