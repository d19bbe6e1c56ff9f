//! Accuracy as an input, held against the truth: what a search for it found, beside a run on twice the mesh of what was found and of
//! the case, with a time error four times as small, and what it cost, beside the cheapest of some settings that are as accurate.
//!
//! A setting is as accurate as asked where [`WITHIN`] of its results are, as shares of what [`result_scales`] says. It knows that where
//! so many of the errors that it expects are as small: only such a setting can be chosen without the truth.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use rustix::time::{ClockId, clock_gettime};

use crate::case::Method;
use crate::numerics::statistics::median;
use crate::run::accuracy::searchable::Asked;
use crate::run::accuracy::steps::Steps;
use crate::run::job::{self, Request};
use crate::run::{QuantityId, Run, RunState, result_scales};
use crate::study::timed::Timed;
use crate::table::{NumberFormat, Table};

/// Share of the results that must be as accurate as asked.
pub const WITHIN: f64 = 0.95;
/// The mesh of the run that counts as true by that found, and its steps.
const FINER_MESH: usize = 2;
const SHORTER_STEPS: f64 = 0.5;
/// Segments and steps of the settings compared with, by those of the case.
const MESHES: [f64; 4] = [0.25, 0.5, 1.0, 2.0];
const STEPS: [f64; 5] = [8.0, 4.0, 2.0, 1.0, 0.5];

/// The accuracy asked of a case or a system.
#[derive(Debug, Clone)]
pub struct AccuracyTrial {
    /// Its name.
    pub name: String,
    /// The accuracy asked, as a share.
    pub asked: f64,
    /// Wall time that the search may take \[s\].
    pub budget_s: f64,
}

/// The outcome of a trial.
#[derive(Debug, Clone, PartialEq)]
pub struct AccuracyFinding {
    /// The case's name.
    pub name: String,
    /// The accuracy asked.
    pub asked: f64,
    /// Whether the run says that it is reached.
    pub said: bool,
    /// Results that have an accuracy.
    pub results: usize,
    /// Those that are as accurate as asked.
    pub within: usize,
    /// CPU time of the search, its run included \[s\].
    pub cpu_s: f64,
    /// The cheapest setting that is as accurate; none where none of those tried is.
    pub cheapest: Option<FixedDiscretisation>,
    /// The cheapest that is as accurate and knows it, with its error bars.
    pub knowing: Option<FixedDiscretisation>,
}

/// Segments and steps that do not change during a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FixedDiscretisation {
    /// Segments by those of the case.
    pub segments: f64,
    /// Steps by those of the case; none at rest.
    pub steps: Option<f64>,
    /// CPU time of its run \[s\].
    pub cpu_s: f64,
}

impl FixedDiscretisation {
    fn words(self) -> String {
        let segments = format!("{} x segments", self.segments);
        match self.steps {
            Some(steps) => format!("{segments}, {steps} x steps"),
            None => segments,
        }
    }
}

impl AccuracyFinding {
    /// CPU time by that of the cheapest setting.
    #[must_use]
    pub fn cost(&self) -> Option<f64> {
        self.cheapest.map(|setting| self.cpu_s / setting.cpu_s)
    }

    /// CPU time by that of the cheapest setting that knows how accurate it is.
    #[must_use]
    pub fn cost_by_knowing(&self) -> Option<f64> {
        self.knowing.map(|setting| self.cpu_s / setting.cpu_s)
    }
}

/// A trial with its outcome, or the reason why it has none.
pub type AccuracyRow = (AccuracyTrial, Result<AccuracyFinding, String>);

/// Searches what a text says, and holds against the truth. The search is computed alone, so that its CPU time is that of the process.
///
/// # Errors
/// The reason for which the search or the run that counts as true did not come to its end.
pub fn check<C: Timed>(
    trial: &AccuracyTrial,
    own: &C,
    text: &str,
    cancel: &AtomicBool,
) -> Result<AccuracyFinding, String> {
    let asked = own.asking(Asked {
        accuracy: trial.asked,
        budget_s: Some(trial.budget_s),
    });
    let begun = cpu(ClockId::ProcessCPUTime);
    let run = run(asked, text, cancel)?;
    let cpu_s = cpu(ClockId::ProcessCPUTime) - begun;
    let found = C::of_stored(&run.case_text, &trial.name)?;
    let exact = finer(own, &found).and_then(|finer| self::run(finer, "", cancel));
    let exact = exact.map_err(|why| format!("true run: {why}"))?;
    let judge = Judge {
        scales: result_scales(found.duration_s(), &run),
        exact: &exact,
        asked: trial.asked,
    };
    let (results, within) = judge.count(&run);
    let met = met(own, &judge, cancel);
    Ok(AccuracyFinding {
        name: trial.name.clone(),
        asked: trial.asked,
        said: !run
            .info
            .warnings
            .iter()
            .any(|w| w.contains("is not reached")),
        results,
        within,
        cpu_s,
        cheapest: met.first().copied(),
        knowing: knowing(own, &judge, &met, cancel),
    })
}

/// Holds runs against the true one.
struct Judge<'a> {
    scales: Vec<(QuantityId, f64)>,
    exact: &'a Run,
    asked: f64,
}

impl Judge<'_> {
    /// Results that have an accuracy, and those of them that are as accurate as asked.
    fn count(&self, run: &Run) -> (usize, usize) {
        let value = |run: &Run, id: &QuantityId| {
            let found = run.summary.iter().find(|q| q.id == *id);
            found.map(|q| q.value)
        };
        let share = |(id, scale): &(QuantityId, f64)| {
            Some((value(run, id)? - value(self.exact, id)?).abs() / scale)
        };
        let shares: Vec<f64> = self.scales.iter().filter_map(share).collect();
        let within = shares.iter().filter(|share| **share <= self.asked).count();
        (shares.len(), within)
    }

    fn is_met(&self, run: &Run) -> bool {
        let (results, within) = self.count(run);
        within as f64 >= WITHIN * results as f64
    }

    /// Whether a run expects to be as accurate as asked.
    fn is_expected(&self, run: &Run) -> bool {
        let share = |(id, scale): &(QuantityId, f64)| {
            let found = run.summary.iter().find(|q| q.id == *id)?;
            Some(found.expected_error()? / scale)
        };
        let shares: Vec<f64> = self.scales.iter().filter_map(share).collect();
        let within = shares.iter().filter(|share| **share <= self.asked).count();
        within as f64 >= WITHIN * shares.len() as f64
    }
}

/// The settings that are as accurate as asked, the cheapest first; without error bars.
fn met<C: Timed>(case: &C, judge: &Judge<'_>, cancel: &AtomicBool) -> Vec<FixedDiscretisation> {
    let steps = match case.steps().method {
        Method::Static => vec![None],
        _ => STEPS.map(Some).to_vec(),
    };
    let settings = MESHES
        .iter()
        .flat_map(|mesh| steps.iter().map(|steps| (*mesh, *steps)));
    let settings: Vec<(f64, Option<f64>)> = settings.collect();
    let met = settings.into_par_iter().filter_map(|(segments, steps)| {
        let begun = cpu(ClockId::ThreadCPUTime);
        let run = run(with(case, segments, steps).ok()?, "", cancel).ok()?;
        let cpu_s = cpu(ClockId::ThreadCPUTime) - begun;
        judge.is_met(&run).then_some(FixedDiscretisation {
            segments,
            steps,
            cpu_s,
        })
    });
    let mut met: Vec<FixedDiscretisation> = met.collect();
    met.sort_by(|a, b| a.cpu_s.total_cmp(&b.cpu_s));
    met
}

/// The cheapest of those that are as accurate which knows it. Each is computed alone, since its companions have threads of their own.
fn knowing<C: Timed>(
    case: &C,
    judge: &Judge<'_>,
    met: &[FixedDiscretisation],
    cancel: &AtomicBool,
) -> Option<FixedDiscretisation> {
    let mut cheapest: Option<FixedDiscretisation> = None;
    for setting in met {
        // With bars it costs more than without.
        if cheapest.is_some_and(|cheapest| cheapest.cpu_s <= setting.cpu_s) {
            break;
        }
        let Ok(case) = with(case, setting.segments, setting.steps) else {
            continue;
        };
        let begun = cpu(ClockId::ProcessCPUTime);
        let Ok(run) = run(case.estimating(true), "", cancel) else {
            continue;
        };
        let cpu_s = cpu(ClockId::ProcessCPUTime) - begun;
        if judge.is_expected(&run) && cheapest.is_none_or(|cheapest| cpu_s < cheapest.cpu_s) {
            cheapest = Some(FixedDiscretisation { cpu_s, ..*setting });
        }
    }
    cheapest
}

/// Twice as fine as what was found and as the scene itself.
fn finer<C: Timed>(own: &C, found: &C) -> Result<C, String> {
    let pairs = found.segments().into_iter().zip(own.segments());
    let segments: Vec<usize> = pairs.map(|(a, b)| FINER_MESH * a.max(b)).collect();
    let [found_steps, own_steps] = [found, own].map(|of| shorter(of.steps(), SHORTER_STEPS));
    let steps = Steps {
        tolerance: found_steps.tolerance.min(own_steps.tolerance),
        length: match (found_steps.length, own_steps.length) {
            (Some(found), Some(own)) => Some(found.min(own)),
            (found, own) => found.or(own),
        },
        // Where it is longer than that of the scene, the scene has its own.
        longest: None,
        ..found_steps
    };
    let finer = found.with_segments(&segments)?;
    Ok(finer.stepped(steps).estimating(false))
}

/// The scene with these segments and steps by its own, without a search or bars.
fn with<C: Timed>(scene: &C, mesh: f64, steps: Option<f64>) -> Result<C, String> {
    let own = scene.segments().into_iter().zip(scene.fewest());
    let segments = own.map(|(own, fewest)| ((own as f64 * mesh).ceil() as usize).max(fewest));
    let scene = scene.with_segments(&segments.collect::<Vec<_>>())?;
    let steps = shorter(scene.steps(), steps.unwrap_or(1.0));
    Ok(scene.stepped(steps).estimating(false))
}

/// Steps by these: the error in a step grows with one power more than that of the run.
fn shorter(steps: Steps, by: f64) -> Steps {
    Steps {
        tolerance: (steps.tolerance * by.powi(3)).min(1.0),
        length: steps.length.map(|step| step * by),
        ..steps
    }
}

fn run<C: Timed>(case: C, text: &str, cancel: &AtomicBool) -> Result<Run, String> {
    let request = Request {
        case,
        text: text.to_owned(),
        file: String::new(),
        overrides: Vec::new(),
        id: "accuracy".to_owned(),
    };
    let run = job::execute(&request, cancel, &mut |_| {});
    match run.info.state {
        RunState::Done => Ok(run),
        _ => Err(run.info.failure.unwrap_or_else(|| "stopped".to_owned())),
    }
}

/// CPU time by this clock \[s\].
fn cpu(clock: ClockId) -> f64 {
    let t = clock_gettime(clock);
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}

/// The table: a row a trial.
#[must_use]
pub fn table(rows: &[AccuracyRow]) -> Table {
    let found = |row: &AccuracyRow| row.1.as_ref().ok().cloned();
    Table::of_records("Accuracy asked, and the true one", rows)
        .text("case", |row| row.0.name.clone())
        .number("asked", NumberFormat::Digits(2, ""), |row| row.0.asked)
        .text("said", move |row| match found(row) {
            Some(found) if found.said => "reached".to_owned(),
            Some(_) => "not reached".to_owned(),
            None => String::new(),
        })
        .number("results", NumberFormat::Decimals(0, ""), move |row| {
            found(row).map(|found| found.results as f64)
        })
        .number("within", NumberFormat::Percent, move |row| {
            let found = found(row).filter(|found| found.results > 0)?;
            Some(found.within as f64 / found.results as f64)
        })
        .number("CPU", NumberFormat::Digits(3, "s"), move |row| {
            found(row).map(|found| found.cpu_s)
        })
        .number("cheapest", NumberFormat::Digits(3, "s"), move |row| {
            found(row)?.cheapest.map(|setting| setting.cpu_s)
        })
        .number("CPU by it", NumberFormat::Digits(2, ""), move |row| {
            found(row)?.cost()
        })
        .text("its setting", move |row| {
            let cheapest = found(row).and_then(|found| found.cheapest);
            cheapest.map_or_else(String::new, FixedDiscretisation::words)
        })
        .number("that knows it", NumberFormat::Digits(3, "s"), move |row| {
            found(row)?.knowing.map(|setting| setting.cpu_s)
        })
        .number("CPU by that", NumberFormat::Digits(2, ""), move |row| {
            found(row)?.cost_by_knowing()
        })
        .text("not computed", |row| {
            row.1.as_ref().err().cloned().unwrap_or_default()
        })
        .build()
}

/// All trials of each accuracy together.
#[must_use]
pub fn totals(rows: &[AccuracyRow]) -> Table {
    let mut asked: Vec<f64> = rows.iter().map(|(trial, _)| trial.asked).collect();
    asked.sort_by(|a, b| b.total_cmp(a));
    asked.dedup();
    let of = |asked: f64| {
        let all = rows.iter().filter_map(|(_, found)| found.as_ref().ok());
        all.filter(|found| found.asked == asked).cloned().collect()
    };
    let totals: Vec<(f64, Vec<AccuracyFinding>)> =
        asked.into_iter().map(|asked| (asked, of(asked))).collect();
    let share = |found: &[AccuracyFinding], counts: fn(&AccuracyFinding) -> bool| {
        let counted = || found.iter().filter(|found| counts(found));
        let results: usize = counted().map(|found| found.results).sum();
        let within: usize = counted().map(|found| found.within).sum();
        (results > 0).then(|| within as f64 / results as f64)
    };
    Table::of_records("All of them", &totals)
        .number("asked", NumberFormat::Digits(2, ""), |row| row.0)
        .number("cases", NumberFormat::Decimals(0, ""), |row| {
            row.1.len() as f64
        })
        .number("said reached", NumberFormat::Decimals(0, ""), |row| {
            row.1.iter().filter(|found| found.said).count() as f64
        })
        .number("results within", NumberFormat::Percent, move |row| {
            share(&row.1, |_| true)
        })
        .number("of those said reached", NumberFormat::Percent, move |row| {
            share(&row.1, |found| found.said)
        })
        .number(
            "of those that a setting meets",
            NumberFormat::Percent,
            move |row| share(&row.1, |found| found.cheapest.is_some()),
        )
        .number(
            "median of CPU by the cheapest",
            NumberFormat::Digits(2, ""),
            |row| median(row.1.iter().filter_map(AccuracyFinding::cost).collect()),
        )
        .number(
            "by the cheapest that knows it",
            NumberFormat::Digits(2, ""),
            |row| {
                median(
                    row.1
                        .iter()
                        .filter_map(AccuracyFinding::cost_by_knowing)
                        .collect(),
                )
            },
        )
        .build()
}
