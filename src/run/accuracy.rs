//! Accuracy as an input: mesh and steps are searched that bring the estimated errors of a run below a share of what each result
//! is a part of.
//!
//! A search begins with the mesh and the steps of the case, and refines what makes the errors too large: segments by the order of the
//! mesh, steps by that of the method. It takes nothing coarser: runs that are all too coarse agree with each other, as a pendulum does
//! in steps of 0.08 s, none of which sees its line go slack.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::compute::{Computed, Resolution, compute};
use super::error_estimate::{self, ErrorEstimates};
use super::job::Request;
use super::{History, Quantity, QuantityId, RunState, Subject};
use crate::case::{Case, Method, Statistic, edit};
use crate::number::si;

/// A case as it reaches its accuracy, or comes nearest to it.
pub(super) struct Reached {
    /// The request with the mesh and the steps found.
    pub(super) request: Request,
    /// The errors of its run; absent where none was complete.
    pub(super) estimates: Option<ErrorEstimates>,
    /// What was asked, found and reached, in words.
    pub(super) words: String,
    /// Why it was not reached.
    pub(super) failure: Option<String>,
}

/// Mesh and steps by those of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Fineness {
    /// Segments by those of the case.
    mesh: f64,
    /// Length of the steps by that of the case.
    steps: f64,
}

/// What a run with an estimate came to.
struct Round {
    fineness: Fineness,
    case: Case,
    estimates: ErrorEstimates,
    shares: Shares,
    wall_s: f64,
}

/// Errors of results by what is asked of them.
#[derive(Debug, Clone, PartialEq)]
struct Shares {
    /// Of the results that count, from the smallest to the greatest.
    all: Vec<(f64, String)>,
    time: f64,
    mesh: f64,
}

/// Share of the results that must be as accurate as asked.
const WITHIN: f64 = 0.95;
/// Where a search begins.
const OWN: Fineness = Fineness {
    mesh: 1.0,
    steps: 1.0,
};
/// Rounds of a search, at most.
const ROUNDS: usize = 8;
/// By how much a round may refine or coarsen the mesh and the steps.
const MOST_MESH: f64 = 3.0;
const MOST_STEPS: f64 = 4.0;
/// The order that segments are refined by: lower than that of the mesh, which bends, the bed and joints do not leave as it is.
const MESH_ORDER: f64 = 1.5;
/// Part of what is asked that an error is brought to.
const AIM: f64 = 0.9;
/// Part of what is asked below which an error is smaller than it need be.
const IDLE: f64 = 0.1;
/// Searches mesh and steps for a request that asks for an accuracy.
pub(super) fn search(request: &Request, accuracy: f64, cancel: &AtomicBool) -> Reached {
    let begun = Instant::now();
    let budget = request.case.solver.budget_s;
    let mut fineness = OWN;
    let mut best: Option<Round> = None;
    let mut limit = format!("not in {ROUNDS} rounds");
    let mut rounds = 0;
    while rounds < ROUNDS && !cancel.load(Ordering::Relaxed) {
        rounds += 1;
        let next = match round(&request.case, fineness, accuracy, cancel) {
            Some(round) => {
                let next = round.next();
                let better = |best: &Round| round.shares.reached() < best.shares.reached();
                let cost = round.cost_of(next);
                if best.as_ref().is_none_or(better) {
                    best = Some(round);
                }
                let spent = begun.elapsed().as_secs_f64();
                if best
                    .as_ref()
                    .is_some_and(|best| best.shares.reached() <= 1.0)
                {
                    break;
                }
                if spent + cost > budget {
                    limit = format!("the next round needs some {}", si(cost, "s"));
                    break;
                }
                next
            }
            None => fineness.finer(1.0, 2.0),
        };
        if next == fineness {
            "its mesh or steps cannot be finer".clone_into(&mut limit);
            break;
        }
        fineness = next;
    }
    let spent = begun.elapsed().as_secs_f64();
    reached(
        request,
        accuracy,
        best,
        &format!("{rounds} rounds, {}", si(spent, "s")),
        &limit,
    )
}

/// Computes a case as fine as this, and its errors; none where the run is not complete.
fn round(case: &Case, fineness: Fineness, accuracy: f64, cancel: &AtomicBool) -> Option<Round> {
    let begun = Instant::now();
    let case = fineness.applied_to(case);
    let run = compute(&case, Resolution::AS_SET, None, cancel, &mut |_| {});
    if run.outcome.state != RunState::Done {
        return None;
    }
    let estimates = error_estimate::estimate(&case, &run, cancel);
    let shares = Shares::of(&case, &run, &estimates.summary, accuracy);
    Some(Round {
        fineness,
        case,
        estimates,
        shares,
        wall_s: begun.elapsed().as_secs_f64(),
    })
}

impl Fineness {
    /// With so many times the segments, and steps so many times shorter.
    fn finer(self, mesh: f64, steps: f64) -> Self {
        Self {
            mesh: self.mesh * mesh,
            steps: self.steps / steps,
        }
    }

    /// The case with this mesh and these steps. On a section with clumps the number of segments stays a multiple of its own, so that
    /// they stay where they hang.
    fn applied_to(self, case: &Case) -> Case {
        let mut case = case.clone();
        for section in &mut case.line {
            let own = section.segments;
            let hung = case
                .clumps
                .iter()
                .any(|clump| clump.section == section.name);
            section.segments = if hung {
                own * (self.mesh.ceil() as usize).max(1)
            } else {
                (own as f64 * self.mesh).round() as usize
            };
        }
        let solver = &mut case.solver;
        solver.time_step_s = solver.time_step_s.map(|step| self.steps * step);
        solver.step_tolerance *= self.steps.powi(3);
        case
    }
}

impl Round {
    /// How fine the next round is: by which the errors would be a little smaller than asked.
    fn next(&self) -> Fineness {
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
        let mesh = factor(self.shares.mesh, MESH_ORDER, MOST_MESH);
        let steps = factor(self.shares.time, order, MOST_STEPS);
        let next = self.fineness.finer(mesh, steps);
        Fineness {
            mesh: next.mesh.max(OWN.mesh),
            steps: next.steps.min(OWN.steps),
        }
    }

    /// Wall time that a round as fine as this would take \[s\].
    fn cost_of(&self, next: Fineness) -> f64 {
        let mesh = next.mesh / self.fineness.mesh;
        // Explicit steps are as short as the segments, whatever is asked.
        let steps = match self.case.solver.method {
            Method::Rk4 => mesh,
            Method::Static => 1.0,
            _ => self.fineness.steps / next.steps,
        };
        self.wall_s * mesh * steps
    }
}

impl Shares {
    fn of(case: &Case, run: &Computed, summary: &[Quantity], accuracy: f64) -> Self {
        let scales = Scales {
            case,
            summary,
            history: &run.record.history,
        };
        let counted = summary.iter().filter_map(|q| {
            let allowed = accuracy * scales.of(q)?;
            Some((q, allowed, q.error_estimate()? / allowed))
        });
        let counted: Vec<_> = counted.filter(|(.., share)| share.is_finite()).collect();
        let mut all: Vec<_> = counted
            .iter()
            .map(|(q, _, share)| (*share, q.name()))
            .collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Either error may be half of what is asked; at rest there is one.
        let parts = if case.solver.method == Method::Static {
            1.0
        } else {
            2.0
        };
        let part = |error: fn(&Quantity) -> Option<f64>| {
            let shares = counted
                .iter()
                .filter_map(|(q, allowed, _)| Some(parts * error(q)? / allowed));
            let mut shares: Vec<f64> = shares.collect();
            shares.sort_by(f64::total_cmp);
            quantile(&shares)
        };
        Self {
            time: part(|q| q.time_error),
            mesh: part(|q| q.mesh_error),
            all,
        }
    }

    /// The share that [`WITHIN`] of the results reach.
    fn reached(&self) -> f64 {
        let shares: Vec<f64> = self.all.iter().map(|(share, _)| *share).collect();
        quantile(&shares)
    }

    /// Results that are not as accurate as asked, the worst first.
    fn missed(&self) -> impl Iterator<Item = &(f64, String)> {
        self.all.iter().rev().take_while(|(share, _)| *share > 1.0)
    }
}

/// The least of these sorted numbers that [`WITHIN`] of them do not exceed; zero of none.
fn quantile(sorted: &[f64]) -> f64 {
    let count = (WITHIN * sorted.len() as f64).ceil() as usize;
    count.checked_sub(1).map_or(0.0, |last| sorted[last])
}

/// What results are a part of.
struct Scales<'a> {
    case: &'a Case,
    summary: &'a [Quantity],
    history: &'a History,
}

impl Scales<'_> {
    /// The range of its channel; of what is at rest or along the line its magnitude; of a time the duration. None of
    /// what is zero but for rounding, of places along the line, and of what is neither of a channel nor of the line.
    fn of(&self, q: &Quantity) -> Option<f64> {
        const ZERO: f64 = 1e-9;
        let QuantityId::Statistic { of, statistic, .. } = &q.id else {
            return None;
        };
        match statistic {
            Statistic::TimeOfMax
            | Statistic::TimeOfMin
            | Statistic::SettlingTime
            | Statistic::RiseTime => {
                return Some(self.case.solver.duration_s);
            }
            // A place is known to a segment, whatever the forces are.
            Statistic::ArcOfMax | Statistic::ArcOfMin => return None,
            _ => {}
        }
        let unit = q.unit();
        let same_unit = self.summary.iter().filter(|other| other.unit() == unit);
        let largest = same_unit.map(|other| other.value.abs()).fold(0.0, f64::max);
        let scale = match of {
            Subject::Channel(_) => self.range(q).max(q.value.abs() * self.at_rest(q)),
            Subject::Line(_) => self.magnitude(of),
            _ => return None,
        };
        (scale > ZERO * largest).then_some(scale)
    }

    /// One for a channel that does not move, else zero.
    fn at_rest(&self, q: &Quantity) -> f64 {
        const STILL: f64 = 1e-6;
        f64::from(u8::from(self.range(q) <= STILL * q.value.abs()))
    }

    /// The range of the channel that a result is taken of.
    fn range(&self, q: &Quantity) -> f64 {
        let QuantityId::Statistic {
            of: Subject::Channel(id),
            ..
        } = &q.id
        else {
            return 0.0;
        };
        let channel = self
            .history
            .channels
            .iter()
            .find(|channel| channel.id == *id);
        channel.map_or(0.0, |channel| channel.peak.0 - channel.trough.0)
    }

    /// The largest result of a subject.
    fn magnitude(&self, of: &Subject) -> f64 {
        let same = self.summary.iter().filter(|q| {
            matches!(&q.id, QuantityId::Statistic { of: other, statistic, .. }
                if other == of && !matches!(statistic, Statistic::ArcOfMax | Statistic::ArcOfMin))
        });
        same.map(|q| q.value.abs()).fold(0.0, f64::max)
    }
}

/// The request with what was found, and what that is in words.
fn reached(
    request: &Request,
    accuracy: f64,
    best: Option<Round>,
    cost: &str,
    limit: &str,
) -> Reached {
    let Some(best) = best else {
        return Reached {
            request: request.clone(),
            estimates: None,
            words: format!("{accuracy} asked; no run was complete ({cost})"),
            failure: Some(format!(
                "the accuracy of {accuracy} is not reached: no run of the search was complete"
            )),
        };
    };
    let share = best.shares.reached();
    let missed: Vec<String> = best.shares.missed().map(|(_, name)| name.clone()).collect();
    let count = best.shares.all.len();
    let settings = settings(request, &best.case);
    let list: Vec<String> = settings
        .iter()
        .map(|(key, value)| format!("{key}={value}"))
        .collect();
    let words = format!(
        "{accuracy} asked; {:.2e} reached by 95 % of {count} results, {} of them are within; {} ({cost})",
        share * accuracy,
        count - missed.len(),
        list.join(", "),
    );
    let failure = (share > 1.0).then(|| {
        let few: Vec<&str> = missed.iter().take(3).map(String::as_str).collect();
        let more = missed.len() - few.len();
        let and = if more > 0 { format!(" and {more} more") } else { String::new() };
        format!(
            "the accuracy of {accuracy} is not reached ({limit}): {:.1e} is; {}{and} are less accurate",
            share * accuracy,
            few.join(", ")
        )
    });
    let edits: Vec<(&str, &str)> = settings
        .iter()
        .map(|(key, value)| (key.as_str(), value.as_str()))
        .collect();
    let mut request = request.clone();
    if let Ok(text) = edit::set_all(&request.text, &edits) {
        request.text = text;
    }
    request.overrides.extend(list);
    request.case = best.case;
    Reached {
        request,
        estimates: Some(best.estimates),
        words,
        failure,
    }
}

/// The keys of mesh and steps, with their values.
fn settings(request: &Request, found: &Case) -> Vec<(String, String)> {
    let mut keys: Vec<(String, String)> = Vec::new();
    for (own, section) in request.case.line.iter().zip(&found.line) {
        if own.segments != section.segments {
            keys.push((
                format!("line.{}.segments", section.name),
                section.segments.to_string(),
            ));
        }
    }
    let solver = &found.solver;
    if solver.method == Method::Alpha && solver.time_step_s.is_none() {
        keys.push((
            "solver.step_tolerance".to_owned(),
            format!("{:?}", solver.step_tolerance),
        ));
    }
    if let Some(step) = solver.time_step_s {
        keys.push(("solver.time_step_s".to_owned(), format!("{step:?}")));
    }
    keys.push((
        "solver.method".to_owned(),
        super::settings::method_name(solver.method).to_owned(),
    ));
    keys
}
