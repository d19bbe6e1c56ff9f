//! Accuracy as an input: mesh and steps are searched by which the estimated errors of a run are below a share of what each result is a
//! part of.
//!
//! The search climbs: it begins with an eighth of the segments of the case and eight times its steps, and makes the one or the other
//! twice as fine, whichever the greater error is made by. Each run is so the companion of those above it, which show its errors at no
//! cost of their own, and all those below the last cost together about as much as that alone.

mod deadline;
mod event_record;
mod reached;
mod rung;
mod shares;

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::companions::{Coarser, Companions};
use super::compute::{Computed, Resolution, compute};
use super::error_estimate::{self, ErrorEstimates};
use super::event::JobEvent;
use super::job::Request;
use super::{RunState, SearchProgress};
use crate::case::{Case, Method};
use crate::number::si;
use deadline::Deadline;
use event_record::EventRecord;
pub(super) use reached::Reached;
use reached::reached;
use rung::Fineness;
use shares::{AllowedErrors, Shares};

/// A run of the search.
pub(super) struct EstimatedRun {
    pub(super) computed: Computed,
    pub(super) estimates: ErrorEstimates,
    /// All that it reported; absent where that is too much to keep.
    pub(super) events: Option<Vec<JobEvent>>,
}

/// A run of the search, as fine as the one before it or twice as fine in one thing.
struct Rung {
    case: Case,
    computed: Computed,
    wall_s: f64,
}

/// The most accurate rung so far.
struct Best {
    case: Case,
    run: EstimatedRun,
    shares: Shares,
}

/// Wall time of a search whose case sets none \[s\].
const BUDGET_S: f64 = 60.0;
/// Rungs of a search, at most.
const RUNGS: usize = 32;
/// A rung is more accurate than the best before it where its share is below this of that one's; after so many that are not, the
/// search ends.
const GAIN: f64 = 0.8;
const IDLE_RUNGS: usize = 6;
/// Times that each error must be seen to fall before it is believed.
const SEEN: usize = 2;

/// Searches mesh and steps for a request that asks for an accuracy.
pub(super) fn search(
    request: &Request,
    accuracy: f64,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Reached {
    let mut search = Search {
        own: &request.case,
        accuracy,
        cancel,
        deadline: Deadline::after(request.case.solver.budget_s.unwrap_or(BUDGET_S)),
        rungs: Vec::new(),
        stair: Vec::new(),
        best: None,
        computed: 0,
        idle: 0,
    };
    let mut fineness = Fineness::first(&request.case, 1);
    let limit = loop {
        events(JobEvent::Searching(SearchProgress {
            round: search.computed + 1,
            asked: accuracy,
            reached: search
                .best
                .as_ref()
                .map(|best| best.shares.reached() * accuracy),
        }));
        match search.advance(&fineness) {
            Ok(next) => fineness = next,
            Err(limit) => break limit,
        }
    };
    let spent = search.deadline.begun.elapsed().as_secs_f64();
    let plural = if search.computed == 1 { "" } else { "s" };
    let cost = format!("{} round{plural}, {}", search.computed, si(spent, "s"));
    reached(request, accuracy, search.best, &cost, &limit)
}

/// A search while it lasts.
struct Search<'a> {
    own: &'a Case,
    accuracy: f64,
    cancel: &'a AtomicBool,
    deadline: Deadline,
    /// Those computed, from the coarsest.
    rungs: Vec<Rung>,
    /// What each is coarser in than the next finer one, from the finest.
    stair: Vec<Coarser>,
    best: Option<Best>,
    /// Runs computed, those that failed included.
    computed: usize,
    /// Those of the rungs, at the end, that were hardly more accurate than the best before.
    idle: usize,
}

impl Search<'_> {
    /// Computes a rung. Returns how fine the next one is, or why there is none.
    fn advance(&mut self, fineness: &Fineness) -> Result<Fineness, String> {
        self.computed += 1;
        let (rung, events) = match self.climb(fineness) {
            Ok(climbed) => climbed,
            Err(why) => return self.after_failure(&why),
        };
        self.rungs.push(rung);
        let shares = self.estimate(events);
        if shares
            .as_ref()
            .is_some_and(|shares| shares.reached() <= 1.0)
        {
            return Err("reached".to_owned());
        }
        let next = self.next(shares.as_ref());
        self.may_go_on(shares.is_some(), next)?;
        self.stair.insert(0, next);
        Ok(fineness.finer(next))
    }

    fn is_over(&self) -> bool {
        self.cancel.load(Ordering::Relaxed) || self.deadline.left() <= 0.0
    }

    /// Computes the case as fine as this, with what the run reports.
    fn climb(&self, fineness: &Fineness) -> Result<(Rung, Option<Vec<JobEvent>>), String> {
        let begun = Instant::now();
        // As it is kept where it is the one looked for: its checkpoints belong to it.
        let mut case = fineness.applied_to(self.own)?;
        let solver = &mut case.solver;
        solver.companions = Some(words(&self.stair));
        (solver.accuracy, solver.budget_s) = (None, None);
        let mut record = EventRecord::new();
        let mut run = |cancel: &AtomicBool| {
            compute(&case, Resolution::AS_SET, None, cancel, &mut |event| {
                record.push(event);
            })
        };
        // The first ones have all the time that they take: without them nothing is known.
        let computed = if self.rungs.len() <= 2 * SEEN {
            run(self.cancel)
        } else {
            self.deadline.watch(self.cancel, run)
        };
        match computed.outcome.state {
            RunState::Done => Ok((
                Rung {
                    case,
                    computed,
                    wall_s: begun.elapsed().as_secs_f64(),
                },
                record.finish(),
            )),
            _ => Err(computed.outcome.failure.unwrap_or_else(|| self.stopped())),
        }
    }

    fn stopped(&self) -> String {
        if self.cancel.load(Ordering::Relaxed) {
            "it was stopped".to_owned()
        } else {
            "its time is over".to_owned()
        }
    }

    /// A run too coarse to come to its end is left for finer ones; among those that show an error it ends the search.
    fn after_failure(&mut self, why: &str) -> Result<Fineness, String> {
        if self.best.is_some() || self.is_over() {
            return Err(format!("a finer run does not come to its end: {why}"));
        }
        self.rungs.clear();
        self.stair.clear();
        // A fourth as coarse, and as fine as the case itself.
        let finer = 4_usize.pow(self.computed as u32);
        if finer > rung::COARSEST {
            return Err(format!("no run comes to its end: {why}"));
        }
        Ok(Fineness::first(self.own, finer))
    }

    /// The errors of the last rung by those below it, once each is seen to fall; keeps it where it is the most accurate.
    fn estimate(&mut self, events: Option<Vec<JobEvent>>) -> Option<Shares> {
        let seen = |what| self.stair.iter().filter(|by| **by == what).count() >= SEEN;
        let by_steps = matches!(
            self.own.solver.method,
            Method::Quasi | Method::Alpha | Method::Auto
        );
        if !seen(Coarser::Mesh) || (by_steps && !seen(Coarser::Steps)) {
            return None;
        }
        let rung = self.rungs.last()?;
        let case = rung.case.clone();
        let below: Vec<&Computed> = self
            .rungs
            .iter()
            .rev()
            .skip(1)
            .map(|r| &r.computed)
            .collect();
        let companions = Companions::down(&case, &rung.computed, &self.stair, &below, self.cancel);
        let estimates = error_estimate::by_companions(&case, &rung.computed, &companions);
        let allowed = AllowedErrors::of(&case, &rung.computed, &estimates.summary, self.accuracy);
        let shares = Shares::of(&case, &allowed, &estimates.summary);
        let (best, share) = (self.reached(), shares.reached());
        self.idle = if share < GAIN * best {
            0
        } else {
            self.idle + 1
        };
        if share < best || self.best.is_none() {
            let run = EstimatedRun {
                computed: rung.computed.clone(),
                estimates,
                events,
            };
            self.best = Some(Best {
                case,
                run,
                shares: shares.clone(),
            });
        }
        Some(shares)
    }

    /// The share of what is asked that the best rung reaches; infinite without one.
    fn reached(&self) -> f64 {
        let best = self.best.as_ref();
        best.map_or(f64::INFINITY, |best| best.shares.reached())
    }

    /// What the next rung is finer in: by turns until both errors are seen, and then in what makes the greater one.
    fn next(&self, shares: Option<&Shares>) -> Coarser {
        match (self.own.solver.method, shares) {
            (Method::Static | Method::Rk4, _) => Coarser::Mesh,
            (_, Some(shares)) if shares.time > shares.mesh => Coarser::Steps,
            (_, Some(_)) => Coarser::Mesh,
            (_, None) if self.stair.first() == Some(&Coarser::Steps) => Coarser::Mesh,
            (_, None) => Coarser::Steps,
        }
    }

    /// Why there is no further rung.
    fn may_go_on(&self, is_estimated: bool, next: Coarser) -> Result<(), String> {
        if self.cancel.load(Ordering::Relaxed) {
            return Err("it was stopped".to_owned());
        }
        if self.idle >= IDLE_RUNGS {
            return Err("finer meshes and shorter steps make it no more accurate".to_owned());
        }
        if self.computed >= RUNGS {
            return Err(format!("not in {RUNGS} rounds"));
        }
        let cost = self.cost_of(next);
        if is_estimated && self.deadline.left() < cost {
            return Err(format!("the next round needs some {}", si(cost, "s")));
        }
        Ok(())
    }

    /// Wall time that a rung finer in this would take \[s\].
    fn cost_of(&self, next: Coarser) -> f64 {
        let last = self.rungs.last().map_or(0.0, |rung| rung.wall_s);
        // Explicit steps are as short as the segments.
        let by_both = self.own.solver.method == Method::Rk4 && next == Coarser::Mesh;
        if by_both { 4.0 * last } else { 2.0 * last }
    }
}

/// The companions of a rung in the words of a case.
fn words(stair: &[Coarser]) -> Vec<String> {
    let last = |what| {
        let places = stair.iter().enumerate().filter(|(_, by)| **by == what);
        places.map(|(place, _)| place + 1).nth(SEEN - 1)
    };
    // Those further down show nothing more.
    let count = last(Coarser::Steps).max(last(Coarser::Mesh));
    let stair = &stair[..count.unwrap_or(stair.len())];
    stair.iter().map(|by| by.word().to_owned()).collect()
}
