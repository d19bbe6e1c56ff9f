//! Accuracy as an input: mesh and steps are searched that bring the estimated errors of a run below a share of what each result
//! is a part of.
//!
//! A search begins with the mesh and the steps of the case, and refines what makes the errors too large: segments by the order of the
//! mesh, steps by that of the method. It takes nothing coarser: runs that are all too coarse agree with each other, as a pendulum does
//! in steps of 0.08 s, none of which sees its line go slack.

mod deadline;
mod event_record;
mod fineness;
mod reached;
mod section_errors;
mod shares;

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::compute::{Computed, Resolution, compute};
use super::error_estimate::{self, ErrorEstimates};
use super::event::JobEvent;
use super::job::Request;
use super::{RunState, SearchProgress};
use crate::case::{Case, Method};
use crate::number::si;
use deadline::Deadline;
use event_record::EventRecord;
use fineness::Fineness;
pub(super) use reached::Reached;
use reached::reached;
use section_errors::{factors, section_errors};
use shares::{AllowedErrors, Shares};

/// A run of the search.
pub(super) struct EstimatedRun {
    pub(super) computed: Computed,
    pub(super) estimates: ErrorEstimates,
    /// All that it reported; absent where that is too much to keep.
    pub(super) events: Option<Vec<JobEvent>>,
}

/// What a run with an estimate came to.
struct Round {
    fineness: Fineness,
    case: Case,
    run: EstimatedRun,
    allowed: AllowedErrors,
    shares: Shares,
    wall_s: f64,
}

/// Wall time of a search whose case sets none \[s\].
const BUDGET_S: f64 = 60.0;
/// Rounds of a search, at most.
const ROUNDS: usize = 8;
/// A round is more accurate than the best before it where its share is below this of that one's; after so many that are not, the
/// search ends.
const GAIN: f64 = 0.8;
const IDLE_ROUNDS: usize = 2;
/// By how much a round may refine or coarsen the mesh and the steps.
const MOST_MESH: f64 = 3.0;
const MOST_STEPS: f64 = 4.0;
/// The order that segments are refined by: lower than that of the mesh, which bends, the bed and joints do not leave as it is.
const MESH_ORDER: f64 = 1.5;
/// Part of what the finest mesh of a round takes away that is aimed at by refining some sections more than others.
const ONE_ROUND: f64 = 0.8;
/// Part of what is asked that an error is brought to.
const AIM: f64 = 0.9;
/// Part of what is asked below which an error is smaller than it need be.
const IDLE: f64 = 0.1;

/// Searches mesh and steps for a request that asks for an accuracy.
pub(super) fn search(
    request: &Request,
    accuracy: f64,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Reached {
    let mut search = Search {
        case: &request.case,
        accuracy,
        cancel,
        deadline: Deadline::after(request.case.solver.budget_s.unwrap_or(BUDGET_S)),
        fineness: Fineness::own(&request.case),
        best: None,
        rounds: 0,
        idle: 0,
    };
    let limit = loop {
        events(JobEvent::Searching(SearchProgress {
            round: search.rounds + 1,
            asked: accuracy,
            reached: search
                .best
                .as_ref()
                .map(|best| best.shares.reached() * accuracy),
        }));
        match search.advance() {
            Ok(fineness) => search.fineness = fineness,
            Err(limit) => break limit,
        }
    };
    let spent = search.deadline.begun.elapsed().as_secs_f64();
    let plural = if search.rounds == 1 { "" } else { "s" };
    let cost = format!("{} round{plural}, {}", search.rounds, si(spent, "s"));
    reached(request, accuracy, search.best, &cost, &limit)
}

/// A search while it lasts.
struct Search<'a> {
    case: &'a Case,
    accuracy: f64,
    cancel: &'a AtomicBool,
    deadline: Deadline,
    /// That of the round to come.
    fineness: Fineness,
    best: Option<Round>,
    /// Rounds computed.
    rounds: usize,
    /// Those of them, at the end, that were hardly more accurate than the best before.
    idle: usize,
}

impl Search<'_> {
    /// Computes a round. Returns how fine the next one is, or why there is none.
    fn advance(&mut self) -> Result<Fineness, String> {
        self.rounds += 1;
        let round = self.round();
        let next = match round {
            Some(round) => {
                if round.shares.reached() <= 1.0 {
                    self.keep(round);
                    return Err("reached".to_owned());
                }
                let next = |cancel: &AtomicBool| round.next(cancel);
                let next = self.deadline.watch(self.cancel, next);
                let cost = round.cost_of(self.case, &next);
                self.keep(round);
                if self.deadline.left() < cost {
                    return Err(format!("the next round needs some {}", si(cost, "s")));
                }
                next
            }
            None if self.deadline.left() > 0.0 => {
                self.fineness.finer(&vec![1.0; self.case.line.len()], 2.0)
            }
            None => return Err("its time is over".to_owned()),
        };
        if self.cancel.load(Ordering::Relaxed) {
            return Err("it was stopped".to_owned());
        }
        if self.idle >= IDLE_ROUNDS {
            return Err("finer meshes and shorter steps make it no more accurate".to_owned());
        }
        if self.rounds == ROUNDS {
            return Err(format!("not in {ROUNDS} rounds"));
        }
        if next == self.fineness {
            return Err("its mesh or steps cannot be finer".to_owned());
        }
        Ok(next)
    }

    /// The first round has all the time that it takes.
    fn round(&self) -> Option<Round> {
        let compute =
            |cancel: &AtomicBool| round(self.case, self.fineness.clone(), self.accuracy, cancel);
        if self.rounds == 1 {
            return compute(self.cancel);
        }
        self.deadline.watch(self.cancel, compute)
    }

    fn keep(&mut self, round: Round) {
        let (best, share) = (self.reached(), round.shares.reached());
        self.idle = if share < GAIN * best {
            0
        } else {
            self.idle + 1
        };
        if share < best || self.best.is_none() {
            self.best = Some(round);
        }
    }

    /// The share of what is asked that the best round reaches; infinite without one.
    fn reached(&self) -> f64 {
        let best = self.best.as_ref();
        best.map_or(f64::INFINITY, |best| best.shares.reached())
    }
}

/// Computes a case as fine as this, and its errors; none where the run is not complete.
fn round(case: &Case, fineness: Fineness, accuracy: f64, cancel: &AtomicBool) -> Option<Round> {
    let begun = Instant::now();
    let case = fineness.applied_to(case);
    let mut record = EventRecord::new();
    let computed = compute(&case, Resolution::AS_SET, None, cancel, &mut |event| {
        record.push(event);
    });
    if computed.outcome.state != RunState::Done {
        return None;
    }
    let estimates = error_estimate::estimate(&case, &computed, cancel);
    let allowed = AllowedErrors::of(&case, &computed, &estimates.summary, accuracy);
    let shares = Shares::of(&case, &allowed, &estimates.summary);
    let run = EstimatedRun {
        computed,
        estimates,
        events: record.finish(),
    };
    Some(Round {
        fineness,
        case,
        run,
        allowed,
        shares,
        wall_s: begun.elapsed().as_secs_f64(),
    })
}

impl Round {
    /// How fine the next round is: by which the errors would be a little smaller than asked.
    fn next(&self, cancel: &AtomicBool) -> Fineness {
        let factor = |share: f64, order: f64, most: f64| match share / AIM {
            share if share > 1.0 => share.powf(1.0 / order).min(most),
            share if share < IDLE => (share / IDLE).powf(1.0 / order).max(1.0 / most),
            _ => 1.0,
        };
        let order = if self.case.solver.method == Method::Rk4 {
            4.0
        } else {
            2.0
        };
        // Where either error is small enough in as many results as it must be, but not the sum, the greater one is as the sum.
        let Shares { time, mesh, .. } = self.shares;
        let sum = self.shares.reached();
        let (time, mesh) = match time.max(mesh) {
            greater if greater > AIM => (time, mesh),
            greater if greater == time => (sum, mesh),
            _ => (time, sum),
        };
        let steps = factor(time, order, MOST_STEPS);
        self.fineness.finer(&self.refined(mesh, cancel), steps)
    }

    /// By how many times each section has more segments where the mesh error is this share of what is asked.
    fn refined(&self, share: f64, cancel: &AtomicBool) -> Vec<f64> {
        let excess = share / AIM;
        if excess <= 1.0 {
            return vec![1.0; self.case.line.len()];
        }
        match section_errors(&self.case, &self.allowed, cancel) {
            Some(parts) => {
                // No more than one round can take away, lest every section become as fine as it may.
                let excess = excess.min(ONE_ROUND * MOST_MESH.powf(MESH_ORDER));
                let errors: Vec<f64> = parts.iter().map(|part| part * excess).collect();
                let segments = self.case.line.iter().map(|section| section.segments);
                factors(
                    &errors,
                    &segments.collect::<Vec<_>>(),
                    MESH_ORDER,
                    MOST_MESH,
                )
            }
            None => {
                let factor = excess.powf(1.0 / MESH_ORDER).min(MOST_MESH);
                vec![factor; self.case.line.len()]
            }
        }
    }

    /// Wall time that a round as fine as this would take \[s\].
    fn cost_of(&self, case: &Case, next: &Fineness) -> f64 {
        let segments = |case: &Case| crate::scene::mesh::segments(case, 1) as f64;
        let mesh = segments(&next.applied_to(case)) / segments(&self.case);
        // Explicit steps are as short as the segments, whatever is asked.
        let steps = match self.case.solver.method {
            Method::Rk4 => mesh,
            Method::Static => 1.0,
            _ => self.fineness.steps / next.steps,
        };
        self.wall_s * mesh * steps
    }
}
