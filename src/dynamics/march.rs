//! The march through time that all methods share: output times hit exactly, a step that fails is
//! halved and counted, the sink may stop it at any step.

use serde::{Deserialize, Serialize};

use super::MethodState;
use crate::solve::{Instant, NewtonError, Progressing, Sink, State, System};

/// A method that can take one step.
pub trait Stepper {
    /// Moves `state` from t to t + dt and returns the estimated error of the step as a share of what is allowed
    /// (0 where the method controls none). A step whose share exceeds 1 is refused while `refuse` says so. On
    /// failure `state` must be as before the step.
    ///
    /// # Errors
    /// Why the step cannot be taken at this length.
    fn step<S: System + ?Sized>(
        &mut self,
        system: &S,
        at: TimeStep,
        state: &mut State,
    ) -> Result<f64, StepError>;

    /// Work done so far.
    fn work_counts(&self) -> WorkCounts;

    /// What it carries from step to step.
    fn method_state(&self) -> MethodState {
        MethodState::default()
    }

    /// Takes up what it carried in an earlier march.
    fn restore(&mut self, _carried: &MethodState) {}

    /// Forgets what it carries from step to step: at time t \[s\] the line has changed, and its forces have jumped.
    fn restart<S: System + ?Sized>(&mut self, system: &S, t: f64, state: &mut State);
}

/// A step to take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimeStep {
    /// Where it begins \[s\].
    pub t: f64,
    /// Its length \[s\].
    pub dt: f64,
    /// Whether a step that is too inaccurate is refused; it is not once it cannot be halved any more.
    pub refuse: bool,
}

/// Why a step is not taken.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum StepError {
    /// Its equations were not solved.
    #[error(transparent)]
    Unsolved(#[from] NewtonError),
    /// Its estimated error exceeds what is allowed by this factor.
    #[error("the estimated error is {0:.3} of what is allowed")]
    Inaccurate(f64),
}

/// Machine-independent work of a stepper.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct WorkCounts {
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
pub struct MarchSummary {
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

/// How often a step that cannot be solved is halved before the march gives up.
const HALVINGS: u32 = 14;

/// How many lengths steps may have: whole, and halved up to so many times.
const LENGTHS: usize = HALVINGS as usize + 1;

/// How often a step is halved for accuracy: a jump of a force is no more accurate in smaller steps than these,
/// since the estimate falls with the step and not with its square.
const HALVINGS_FOR_ACCURACY: u32 = 7;

/// Share of the allowed error below which the next step may be twice as long. An error that grows with the cube
/// of the step stays below one then.
pub(super) const ROOM_TO_DOUBLE: f64 = 0.1;

/// Where a march is.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct MarchProgress {
    /// Time \[s\].
    pub time: f64,
    /// Whole steps completed.
    pub whole: u64,
    /// How often whole steps are halved at present.
    pub level: u32,
    /// Steps accepted so far.
    pub steps: u64,
    /// Steps rejected so far.
    pub rejections: u64,
    /// Steps accepted so far of each length, halved 0, 1, 2 ... times.
    #[serde(default)]
    pub halved: [u64; LENGTHS],
}

/// The times of a march. Output intervals divide the duration, whole steps divide the output interval: no time is ever
/// a sum of many roundings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Length of a whole step \[s\].
    pub dt: f64,
    /// Whole steps an output interval.
    pub per_output: u64,
    /// Output intervals.
    pub outputs: u64,
}

impl Grid {
    /// When the output of this number is due \[s\].
    #[must_use]
    pub fn output(&self, number: u64) -> f64 {
        (number * self.per_output) as f64 * self.dt
    }
}

impl March {
    /// The times of this march.
    #[must_use]
    pub fn grid(&self) -> Grid {
        let outputs = (self.duration / self.output).round().max(1.0) as u64;
        let interval = self.duration / outputs as f64;
        let per_output = (interval / self.step * (1.0 - 1e-9)).ceil().max(1.0) as u64;
        Grid {
            dt: interval / per_output as f64,
            per_output,
            outputs,
        }
    }

    /// The lengths of the steps taken so far \[s\], and how many of each; one cut short by an event counts as uncut.
    pub fn lengths(&self, place: &MarchProgress) -> impl Iterator<Item = (f64, u64)> {
        let dt = self.grid().dt;
        let taken = place.halved.into_iter().enumerate();
        let lengths = taken.map(move |(k, steps)| (dt / (1_u64 << k) as f64, steps));
        lengths.filter(|(_, steps)| *steps > 0)
    }

    /// Whether a march has come to its end.
    #[must_use]
    pub fn is_over(&self, place: &MarchProgress) -> bool {
        let grid = self.grid();
        place.whole >= grid.outputs * grid.per_output
    }

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
    ) -> Result<MarchSummary, MarchError> {
        let mut place = MarchProgress::default();
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
            going = self.advance(&mut place, f64::INFINITY, method, system, state, sink)?;
        }
        Ok(MarchSummary {
            steps: place.steps,
            rejections: place.rejections,
            stopped: going == Progressing::Stop,
        })
    }

    /// Marches on from a place to a time \[s\], or to the end if that comes before. A time between two whole steps is
    /// hit exactly, by a step that is cut short there and completed when the march goes on.
    ///
    /// # Errors
    /// As [`March::run`].
    pub fn advance<M: Stepper, S: System + ?Sized>(
        &self,
        place: &mut MarchProgress,
        until: f64,
        method: &mut M,
        system: &S,
        state: &mut State,
        sink: &mut dyn Sink,
    ) -> Result<Progressing, MarchError> {
        let grid = self.grid();
        let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * grid.dt;
        while place.whole < grid.outputs * grid.per_output {
            if place.time >= until || same(place.time, until) {
                break;
            }
            let end = (place.whole + 1) as f64 * grid.dt;
            let cut = until < end && !same(until, end);
            let whole = if cut {
                WholeStep {
                    from: place.time,
                    dt: until - place.time,
                    end: until,
                    output: false,
                }
            } else {
                // From a place on the grid this is its step to the last digit.
                let on_grid = place.time == place.whole as f64 * grid.dt;
                WholeStep {
                    from: place.time,
                    dt: if on_grid { grid.dt } else { end - place.time },
                    end: if on_grid { place.time + grid.dt } else { end },
                    output: (place.whole + 1).is_multiple_of(grid.per_output),
                }
            };
            if whole_step(&whole, place, method, system, state, sink)? == Progressing::Stop {
                return Ok(Progressing::Stop);
            }
            place.time = if cut { until } else { end };
            place.whole += u64::from(!cut);
        }
        Ok(Progressing::Continue)
    }
}

/// One whole step, in `2^level` pieces. The level goes up where a piece fails and down again, one at a time and
/// only where pieces join to the next longer one, when there is room; it is kept for the next whole step.
fn whole_step<M: Stepper, S: System + ?Sized>(
    whole: &WholeStep,
    place: &mut MarchProgress,
    method: &mut M,
    system: &S,
    state: &mut State,
    sink: &mut dyn Sink,
) -> Result<Progressing, MarchError> {
    let mut done = 0_u64;
    while done < 1 << place.level {
        let dt = whole.dt / (1_u64 << place.level) as f64;
        let t = whole.from + done as f64 * dt;
        let refuse = place.level < HALVINGS_FOR_ACCURACY;
        match method.step(system, TimeStep { t, dt, refuse }, state) {
            Ok(share) => {
                done += 1;
                place.steps += 1;
                place.halved[place.level as usize] += 1;
                let last = done == 1 << place.level;
                let time = if last {
                    whole.end
                } else {
                    whole.from + done as f64 * dt
                };
                system.commit(time, dt, state);
                let instant = Instant {
                    time,
                    state,
                    steps: place.steps,
                    output: last && whole.output,
                };
                if sink.accept(instant) == Progressing::Stop {
                    return Ok(Progressing::Stop);
                }
                if place.level > 0 && done.is_multiple_of(2) && share < ROOM_TO_DOUBLE {
                    done /= 2;
                    place.level -= 1;
                }
            }
            Err(why) => {
                place.rejections += 1;
                if let (StepError::Unsolved(why), HALVINGS..) = (why, place.level) {
                    return Err(MarchError {
                        time: t,
                        step: dt,
                        steps: place.steps,
                        rejections: place.rejections,
                        why,
                    });
                }
                done *= 2;
                place.level += 1;
            }
        }
    }
    Ok(Progressing::Continue)
}

/// A whole step of the march.
struct WholeStep {
    from: f64,
    dt: f64,
    end: f64,
    output: bool,
}
