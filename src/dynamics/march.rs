//! The march through time that all methods share: output times hit exactly, a step that fails is
//! halved and counted, the sink may stop it at any step.

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
        at: Step,
        state: &mut State,
    ) -> Result<f64, StepError>;

    /// Work done so far.
    fn tally(&self) -> Tally;
}

/// A step to take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
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

/// How often a step that cannot be solved is halved before the march gives up.
const HALVINGS: u32 = 14;

/// How often a step is halved for accuracy: a jump of a force is no more accurate in smaller steps than these,
/// since the estimate falls with the step and not with its square.
const HALVINGS_FOR_ACCURACY: u32 = 7;

/// Share of the allowed error below which the next step may be twice as long. An error that grows with the cube
/// of the step stays below one then.
pub(super) const ROOM_TO_DOUBLE: f64 = 0.1;

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
        let mut level = 0;
        for k in 0..outputs * per_output {
            let whole = Whole {
                from: k as f64 * dt,
                dt,
                output: (k + 1) % per_output == 0,
            };
            if self.whole_step(
                method,
                system,
                &whole,
                &mut level,
                state,
                &mut outcome,
                sink,
            )? == Progressing::Stop
            {
                outcome.stopped = true;
                return Ok(outcome);
            }
        }
        Ok(outcome)
    }

    /// One whole step, in `2^level` pieces. The level goes up where a piece fails and down again, one at a time and
    /// only where pieces join to the next longer one, when there is room; it is kept for the next whole step.
    #[expect(
        clippy::too_many_arguments,
        reason = "the loop variables of one march, used nowhere else"
    )]
    fn whole_step<M: Stepper, S: System + ?Sized>(
        &self,
        method: &mut M,
        system: &S,
        whole: &Whole,
        level: &mut u32,
        state: &mut State,
        outcome: &mut Outcome,
        sink: &mut dyn Sink,
    ) -> Result<Progressing, MarchError> {
        let mut done = 0_u64;
        while done < 1 << *level {
            let dt = whole.dt / (1_u64 << *level) as f64;
            let t = whole.from + done as f64 * dt;
            match method.step(
                system,
                Step {
                    t,
                    dt,
                    refuse: *level < HALVINGS_FOR_ACCURACY,
                },
                state,
            ) {
                Ok(share) => {
                    done += 1;
                    outcome.steps += 1;
                    let last = done == 1 << *level;
                    let time = if last {
                        whole.from + whole.dt
                    } else {
                        whole.from + done as f64 * dt
                    };
                    let instant = Instant {
                        time,
                        state,
                        steps: outcome.steps,
                        output: last && whole.output,
                    };
                    if sink.accept(instant) == Progressing::Stop {
                        return Ok(Progressing::Stop);
                    }
                    if *level > 0 && done.is_multiple_of(2) && share < ROOM_TO_DOUBLE {
                        done /= 2;
                        *level -= 1;
                    }
                }
                Err(why) => {
                    outcome.rejections += 1;
                    if let (StepError::Unsolved(why), HALVINGS..) = (why, *level) {
                        let (steps, rejections) = (outcome.steps, outcome.rejections);
                        return Err(MarchError {
                            time: t,
                            step: dt,
                            steps,
                            rejections,
                            why,
                        });
                    }
                    done *= 2;
                    *level += 1;
                }
            }
        }
        Ok(Progressing::Continue)
    }
}

/// A whole step of the march.
struct Whole {
    from: f64,
    dt: f64,
    output: bool,
}
