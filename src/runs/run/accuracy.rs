//! Accuracy as an input: mesh and steps are searched by which the estimated errors of a run are below a share of what each result is a
//! part of.
//!
//! The search begins with a sixteenth of the segments of the case and sixteen times its steps, and makes the one or the other twice as
//! fine, whichever makes the greater error. The runs before a run are so its companions: its errors cost nothing of their own, and all
//! the runs before the last together about as much as the last.

mod deadline;
mod event_record;
pub mod fineness;
mod reached;
pub mod searchable;
mod shares;
pub mod steps;

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::companions::{Coarsening, Companions};
use super::compute::Computed;
use super::error_estimate::{self, ErrorEstimates};
use super::event::JobEvent;
use super::{RunState, SearchProgress};
use crate::case::Method;
use crate::number::si;
use deadline::Deadline;
use event_record::EventRecord;
use fineness::Fineness;
use reached::reached;
pub(super) use reached::{Reached, as_override};
use searchable::{Asked, Searchable};
use shares::{AllowedErrors, Shares};

/// A run of the search.
pub(super) struct EstimatedRun {
    pub(super) computed: Computed,
    pub(super) estimates: ErrorEstimates,
    /// All that it reported; absent where that is too much to keep.
    pub(super) events: Option<Vec<JobEvent>>,
}

/// A run of the search, as fine as the one before it or twice as fine in one thing.
struct Level<C> {
    found: C,
    computed: Computed,
    wall_s: f64,
}

/// The most accurate level so far.
struct Best<C> {
    found: C,
    run: EstimatedRun,
    shares: Shares,
}

/// Wall time of a search whose case sets none \[s\].
const BUDGET_S: f64 = 60.0;
/// Levels of a search, at most.
const LEVELS: usize = 32;
/// A level is more accurate than the best before it where its share is below this of that one's; after so many that are not, the
/// search ends.
const GAIN: f64 = 0.8;
const IDLE_LEVELS: usize = 6;
/// Times that each error must be seen to fall before it is believed.
const SEEN: usize = 2;
/// Time of a run with error bars by that without.
const WITH_BARS: f64 = 1.5;

/// Searches mesh and steps of what asks for an accuracy.
pub(super) fn search<C: Searchable>(
    own: &C,
    asked: Asked,
    cancel: &AtomicBool,
    events: &mut dyn FnMut(JobEvent),
) -> Reached<C> {
    let accuracy = asked.accuracy;
    let mut search = AccuracySearch {
        own,
        accuracy,
        cancel,
        deadline: Deadline::after(asked.budget_s.unwrap_or(BUDGET_S)),
        levels: Vec::new(),
        coarsenings: Vec::new(),
        best: None,
        computed: 0,
        idle: 0,
    };
    let mut fineness = Fineness::first(own, 1);
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
    reached(own, accuracy, search.best, &cost, &limit)
}

/// A search while it lasts.
struct AccuracySearch<'a, C> {
    own: &'a C,
    accuracy: f64,
    cancel: &'a AtomicBool,
    deadline: Deadline,
    /// Those computed, from the coarsest.
    levels: Vec<Level<C>>,
    /// What each is coarser in than the next finer one, from the finest.
    coarsenings: Vec<Coarsening>,
    best: Option<Best<C>>,
    /// Runs computed, those that failed included.
    computed: usize,
    /// Those of the levels, at the end, that were hardly more accurate than the best before.
    idle: usize,
}

impl<C: Searchable> AccuracySearch<'_, C> {
    /// Computes a level. Returns how fine the next one is, or why there is none.
    fn advance(&mut self, fineness: &Fineness) -> Result<Fineness, String> {
        self.computed += 1;
        let (level, events) = match self.level(fineness) {
            Ok(level) => level,
            Err(why) => return self.after_failure(&why),
        };
        self.levels.push(level);
        let shares = self.estimate(events);
        if shares
            .as_ref()
            .is_some_and(|shares| shares.reached() <= 1.0)
        {
            return Err("reached".to_owned());
        }
        let next = self.next(shares.as_ref());
        self.may_go_on(shares.is_some(), next, fineness)?;
        self.coarsenings.insert(0, next);
        Ok(fineness.finer(next))
    }

    fn is_over(&self) -> bool {
        self.cancel.load(Ordering::Relaxed) || self.deadline.left() <= 0.0
    }

    /// Computes one as fine as this, with what the run reports.
    fn level(&self, fineness: &Fineness) -> Result<(Level<C>, Option<Vec<JobEvent>>), String> {
        let begun = Instant::now();
        // As it is kept where it is the one looked for: its checkpoints belong to it.
        let found = self.own.refined(fineness, &words(&self.coarsenings))?;
        let mut record = EventRecord::new();
        let mut run = |cancel: &AtomicBool| {
            let mut keep = |event| record.push(event);
            found.compute(None, cancel, Some(&mut keep))
        };
        // The first ones have all the time that they take: without them nothing is known.
        let computed = if self.levels.len() <= self.unknown_levels() {
            run(self.cancel)
        } else {
            self.deadline.watch(self.cancel, run)
        };
        match computed.outcome.state {
            RunState::Done => Ok((
                Level {
                    found,
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
        self.levels.clear();
        self.coarsenings.clear();
        // A fourth as coarse, and as fine as the case itself.
        let finer = 4_usize.pow(self.computed as u32);
        if finer > fineness::COARSEST {
            return Err(format!("no run comes to its end: {why}"));
        }
        Ok(Fineness::first(self.own, finer))
    }

    /// Whether steps are refined beside the mesh: at rest there are none, and explicit ones go with the segments.
    fn has_steps(&self) -> bool {
        self.own.has_own_steps()
    }

    /// Whether there is a mesh to refine: bodies alone have none.
    fn has_mesh(&self) -> bool {
        !self.own.segments().is_empty()
    }

    /// Levels before the first whose errors are known.
    fn unknown_levels(&self) -> usize {
        SEEN * (usize::from(self.has_steps()) + usize::from(self.has_mesh()))
    }

    /// How many errors a result has, of its steps and of its mesh.
    fn parts(&self) -> f64 {
        let at_rest = self.own.steps().method == Method::Static;
        if at_rest || !self.has_mesh() {
            1.0
        } else {
            2.0
        }
    }

    /// The errors of the last level by those below it, once each is seen to fall; keeps it where it is the most accurate.
    fn estimate(&mut self, events: Option<Vec<JobEvent>>) -> Option<Shares> {
        let seen = |what| self.coarsenings.iter().filter(|by| **by == what).count() >= SEEN;
        let unseen = |has: bool, what| has && !seen(what);
        if unseen(self.has_mesh(), Coarsening::Mesh) || unseen(self.has_steps(), Coarsening::Steps)
        {
            return None;
        }
        let level = self.levels.last()?;
        let found = level.found.clone();
        let below: Vec<&Computed> = self
            .levels
            .iter()
            .rev()
            .skip(1)
            .map(|r| &r.computed)
            .collect();
        let (run, coarsenings) = (&level.computed, &self.coarsenings);
        let estimates = found.ask_refinable(|refinable| {
            let known = Companions::coarsened_by(refinable, run, coarsenings, &below, self.cancel);
            error_estimate::by_companions(refinable, run, &known)
        })?;
        let duration = self.own.duration_s();
        let allowed = AllowedErrors::of_run(duration, run, &estimates.summary, self.accuracy);
        let shares = Shares::of_results(self.parts(), &allowed, &estimates.summary);
        let (best, share) = (self.reached(), shares.reached());
        self.idle = if share < GAIN * best {
            0
        } else {
            self.idle + 1
        };
        if share < best || self.best.is_none() {
            let run = EstimatedRun {
                computed: level.computed.clone(),
                estimates,
                events,
            };
            self.best = Some(Best {
                found,
                run,
                shares: shares.clone(),
            });
        }
        Some(shares)
    }

    /// The share of what is asked that the best level reaches; infinite without one.
    fn reached(&self) -> f64 {
        let best = self.best.as_ref();
        best.map_or(f64::INFINITY, |best| best.shares.reached())
    }

    /// What the next level is finer in: by turns until both errors are seen, and then in what makes the greater one.
    fn next(&self, shares: Option<&Shares>) -> Coarsening {
        if !self.has_mesh() {
            return Coarsening::Steps;
        }
        match (self.has_steps(), shares) {
            (false, _) => Coarsening::Mesh,
            (_, Some(shares)) if shares.time > shares.mesh => Coarsening::Steps,
            (_, Some(_)) => Coarsening::Mesh,
            (_, None) if self.coarsenings.first() == Some(&Coarsening::Steps) => Coarsening::Mesh,
            (_, None) => Coarsening::Steps,
        }
    }

    /// Why there is no level after one as fine as this.
    fn may_go_on(
        &self,
        is_estimated: bool,
        next: Coarsening,
        last: &Fineness,
    ) -> Result<(), String> {
        if self.cancel.load(Ordering::Relaxed) {
            return Err("it was stopped".to_owned());
        }
        if self.idle >= IDLE_LEVELS {
            return Err("finer meshes and shorter steps make it no more accurate".to_owned());
        }
        if self.computed >= LEVELS {
            return Err(format!("not in {LEVELS} rounds"));
        }
        let cost = self.cost_of(next);
        let may_stop = is_estimated || self.is_dearer_than_as_set(last);
        if may_stop && self.deadline.left() < cost {
            return Err(format!("the next round needs some {}", si(cost, "s")));
        }
        Ok(())
    }

    /// Whether the levels that are left before errors are known take longer than the case as it is set, which is computed without them.
    fn is_dearer_than_as_set(&self, last: &Fineness) -> bool {
        // Each takes twice as long as the one before it.
        let left = (self.unknown_levels() + 1).saturating_sub(self.levels.len());
        let levels = 2.0 * (2.0_f64.powi(left as i32) - 1.0);
        let mut as_set = Fineness::as_set(self.own);
        if !self.has_steps() {
            as_set.steps = last.steps;
        }
        levels > WITH_BARS * as_set.work() / last.work()
    }

    /// Wall time that a level finer in this would take \[s\]: as much more as the last one took more than that before it, where that is
    /// more than its size lets expect, as of statics that Newton alone does not find.
    fn cost_of(&self, next: Coarsening) -> f64 {
        // Explicit steps are as short as the segments.
        let is_explicit = self.own.steps().method == Method::Rk4;
        let by_both = is_explicit && next == Coarsening::Mesh;
        let by_size: f64 = if by_both { 4.0 } else { 2.0 };
        match self.levels.as_slice() {
            [] => 0.0,
            [only] => by_size * only.wall_s,
            [.., before, last] => by_size.max(last.wall_s / before.wall_s) * last.wall_s,
        }
    }
}

/// The companions of a level in the words of a case.
fn words(coarsenings: &[Coarsening]) -> Vec<String> {
    let last = |what| {
        let places = coarsenings
            .iter()
            .enumerate()
            .filter(|(_, by)| **by == what);
        places.map(|(place, _)| place + 1).nth(SEEN - 1)
    };
    // Those further down show nothing more.
    let count = last(Coarsening::Steps).max(last(Coarsening::Mesh));
    let coarsenings = &coarsenings[..count.unwrap_or(coarsenings.len())];
    coarsenings.iter().map(|by| by.word().to_owned()).collect()
}
