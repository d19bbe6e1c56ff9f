//! Error bars against true errors: every result of a case with its estimated error, beside the same result of a converged run.
//!
//! The converged run is by the same method on a mesh three times as fine with a time error ten times as small, so that the
//! difference from it is the error but for an eighth of that. Results that are zero but for rounding do not count.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;

use crate::case::Method;
use crate::run::accuracy::steps::Steps;
use crate::run::job::Request;
use crate::run::{Quantity, Run, RunState};
use crate::study::study_job::StudyJob;
use crate::study::timed::{Timed, divided};
use crate::table::{Columns, NumberFormat, Table};

/// A case by one method at one accuracy.
#[derive(Debug, Clone)]
pub struct BarSetting {
    /// The case's name.
    pub name: String,
    /// Method and accuracy, in words.
    pub setting: String,
    /// Its run, with error estimates.
    run: StudyJob,
    /// The converged run, or why there is none.
    converged: Result<StudyJob, String>,
}

/// A result, its bar and its true error.
#[derive(Debug, Clone, PartialEq)]
pub struct BarResult {
    /// Name of the result.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Its value.
    pub value: f64,
    /// Estimated error.
    pub bar: f64,
    /// Its part from the time step, and that from the mesh.
    pub parts: [Option<f64>; 2],
    /// The converged value.
    pub converged: f64,
    /// The range that is given in the place of a bar where the result is not settled.
    pub unsettled: Option<[f64; 2]>,
}

/// All results of a setting; none where one of the two runs did not come to its end.
#[derive(Debug, Clone)]
pub struct BarCheck {
    /// What was computed.
    pub setting: BarSetting,
    /// Its results, or why there are none.
    pub results: Result<Vec<BarResult>, String>,
}

/// How well bars hold.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BarTally {
    /// Results that count.
    pub results: usize,
    /// Those whose error lies inside the bar.
    pub inside: usize,
    /// Those that are not settled.
    pub unsettled: usize,
    /// Those whose bar is more than ten times the error.
    pub too_large: usize,
    /// Median of bar over error.
    pub median: f64,
}

/// The mesh of the converged run by that of the case.
const REFINEMENT: usize = 3;
/// Its tolerance and its constant step by those of the case.
const FINER_TOLERANCE: f64 = 1.0 / 32.0;
const FINER_STEP: f64 = 1.0 / 3.0;
/// The looser of the two tolerances by that of the case.
const LOOSE: f64 = 8.0;
/// Evaluations of the force at all nodes that the converged run by RK4 may cost.
const DEAREST: f64 = 3e8;
/// A bar this much larger than the error, or an error this much smaller than the value, says nothing.
const TOO_LARGE: f64 = 10.0;
const ZERO: f64 = 1e-9;

impl BarResult {
    /// Difference from the converged value.
    #[must_use]
    pub fn error(&self) -> f64 {
        (self.value - self.converged).abs()
    }

    /// Whether the error lies inside the bar, or the converged value in the range.
    #[must_use]
    pub fn is_inside(&self) -> bool {
        match self.unsettled {
            Some([least, greatest]) => (least..=greatest).contains(&self.converged),
            None => self.error() <= self.bar,
        }
    }

    /// Bar by error, where there is a bar.
    fn ratio(&self) -> Option<f64> {
        let ratio = self.bar / self.error().max(f64::MIN_POSITIVE);
        self.unsettled.is_none().then_some(ratio)
    }
}

/// The settings of a scene: as it is, and in motion by generalized-alpha at two tolerances and by RK4 where that can be afforded.
#[must_use]
pub fn settings<C: Timed>(name: &str, case: &C) -> Vec<BarSetting>
where
    StudyJob: From<Request<C>>,
{
    let own = case.steps();
    let by = |method| Steps { method, ..own };
    let of = |words: &str, steps: Steps| setting((name, words), case, steps);
    match own.method {
        Method::Static => return vec![of("static", own)],
        Method::Quasi => return vec![of("quasi", own)],
        _ => {}
    }
    let mut list = vec![of("alpha", by(Method::Alpha))];
    if own.length.is_none() {
        let loose = Steps {
            tolerance: (LOOSE * own.tolerance).min(1.0),
            ..by(Method::Alpha)
        };
        list.push(of("alpha, 8 x tolerance", loose));
    }
    let explicit = Steps {
        length: None,
        ..by(Method::Rk4)
    };
    if evaluations(case).is_some_and(|cost| cost < DEAREST) {
        list.push(of("rk4", explicit));
    }
    list
}

/// A scene by one method, with its converged run.
fn setting<C: Timed>((name, words): (&str, &str), case: &C, steps: Steps) -> BarSetting
where
    StudyJob: From<Request<C>>,
{
    let finer = Steps {
        tolerance: FINER_TOLERANCE * steps.tolerance,
        length: steps.length.map(|step| FINER_STEP * step),
        ..steps
    };
    let converged = divided(case, REFINEMENT);
    let converged = converged.map(|case| job(case.stepped(finer).estimating(false)));
    BarSetting {
        name: name.to_owned(),
        setting: words.to_owned(),
        run: job(case.stepped(steps).estimating(true)),
        converged,
    }
}

/// The job of a scene that is not stored.
fn job<C>(case: C) -> StudyJob
where
    StudyJob: From<Request<C>>,
{
    StudyJob::from(Request {
        case,
        text: String::new(),
        file: String::new(),
        overrides: Vec::new(),
        id: "bars".to_owned(),
    })
}

/// Evaluations of the force by RK4 in the converged run, times the nodes; none where no segment binds its steps.
fn evaluations(case: &impl Timed) -> Option<f64> {
    let bounds = divided(case, REFINEMENT).ok()?.bounds().ok()?;
    let step = Some(bounds.explicit_step).filter(|step| step.is_finite())?;
    Some(4.0 * case.duration_s() / step * bounds.nodes as f64)
}

/// Computes settings and their converged runs, on all cores; `done` is called after each.
pub fn compute(
    settings: Vec<BarSetting>,
    cancel: &AtomicBool,
    done: &(dyn Fn(&BarSetting) + Sync),
) -> Vec<BarCheck> {
    let check = |setting: BarSetting| {
        let results = results(&setting, cancel);
        done(&setting);
        BarCheck { setting, results }
    };
    settings.into_par_iter().map(check).collect()
}

fn results(setting: &BarSetting, cancel: &AtomicBool) -> Result<Vec<BarResult>, String> {
    let run = run(&setting.run, cancel)?;
    let converged = setting.converged.as_ref().map_err(Clone::clone);
    let converged = converged.and_then(|job| self::run(job, cancel));
    let converged = converged.map_err(|why| format!("converged run: {why}"))?;
    let largest = |unit: &str| {
        let same = converged.summary.iter().filter(|q| q.unit() == unit);
        same.map(|q| q.value.abs()).fold(0.0, f64::max)
    };
    let result = |q: &Quantity| {
        let exact = converged.summary.iter().find(|other| other.id == q.id)?;
        let result = BarResult {
            name: q.name(),
            unit: q.unit(),
            value: q.value,
            bar: q.error_estimate()?,
            parts: [q.time_error, q.mesh_error],
            converged: exact.value,
            unsettled: q.unsettled,
        };
        let scale = ZERO * largest(&q.unit());
        let trivial = exact.value.abs() <= scale || result.error() <= ZERO * exact.value.abs();
        (!trivial).then_some(result)
    };
    Ok(run.summary.iter().filter_map(result).collect())
}

fn run(job: &StudyJob, cancel: &AtomicBool) -> Result<Run, String> {
    let run = job.execute(cancel);
    match run.info.state {
        RunState::Done => Ok(run),
        _ => Err(run.info.failure.unwrap_or_else(|| "stopped".to_owned())),
    }
}

/// How well the bars of these results hold.
#[must_use]
pub fn tally<'r>(results: impl IntoIterator<Item = &'r BarResult>) -> BarTally {
    let results: Vec<&BarResult> = results.into_iter().collect();
    let mut ratios: Vec<f64> = results.iter().filter_map(|r| r.ratio()).collect();
    ratios.sort_by(f64::total_cmp);
    BarTally {
        results: results.len(),
        inside: results.iter().filter(|r| r.is_inside()).count(),
        unsettled: results.iter().filter(|r| r.unsettled.is_some()).count(),
        too_large: ratios.iter().filter(|ratio| **ratio > TOO_LARGE).count(),
        median: ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN),
    }
}

/// Results of all settings that came to their end.
pub fn all(checks: &[BarCheck]) -> impl Iterator<Item = &BarResult> {
    checks
        .iter()
        .filter_map(|c| c.results.as_ref().ok())
        .flatten()
}

/// The table: a row a setting, and one for all of them.
#[must_use]
pub fn table(checks: &[BarCheck]) -> Table {
    let mut rows: Vec<(String, String, Result<BarTally, String>)> = Vec::new();
    for check in checks {
        let tally = check.results.as_ref().map(tally).map_err(Clone::clone);
        rows.push((
            check.setting.name.clone(),
            check.setting.setting.clone(),
            tally,
        ));
    }
    rows.push(("all".to_owned(), String::new(), Ok(tally(all(checks)))));
    let share = |of: fn(&BarTally) -> usize| {
        move |row: &(String, String, Result<BarTally, String>)| {
            let tally = row.2.as_ref().ok().filter(|tally| tally.results > 0)?;
            Some(of(tally) as f64 / tally.results as f64)
        }
    };
    Table::of_records("Error bars against converged runs", &rows)
        .text("case", |row| row.0.clone())
        .text("method", |row| row.1.clone())
        .number("results", NumberFormat::Decimals(0, ""), |row| {
            row.2.as_ref().ok().map(|tally| tally.results as f64)
        })
        .number("inside", NumberFormat::Percent, share(|tally| tally.inside))
        .number(
            "not settled",
            NumberFormat::Percent,
            share(|tally| tally.unsettled),
        )
        .number(
            "bar over ten times the error",
            NumberFormat::Percent,
            share(|tally| tally.too_large),
        )
        .number(
            "median of bar by error",
            NumberFormat::Digits(2, ""),
            |row| {
                row.2
                    .as_ref()
                    .ok()
                    .map(|tally| tally.median)
                    .filter(|m| m.is_finite())
            },
        )
        .text("not computed", |row| {
            row.2.as_ref().err().cloned().unwrap_or_default()
        })
        .build()
}

/// A result with its setting.
type BarRow<'a> = (&'a BarSetting, &'a BarResult);

/// The results of all settings that came to their end.
fn rows(checks: &[BarCheck]) -> impl Iterator<Item = BarRow<'_>> {
    let done = checks
        .iter()
        .filter_map(|check| Some((&check.setting, check.results.as_ref().ok()?)));
    done.flat_map(|(setting, results)| results.iter().map(move |result| (setting, result)))
}

/// The table of the results that lie outside their bars.
#[must_use]
pub fn outside_table(checks: &[BarCheck]) -> Table {
    let outside = rows(checks).filter(|(_, result)| !result.is_inside());
    let rows: Vec<_> = outside.collect();
    named("Results outside their bars", &rows)
        .number("bar", NumberFormat::Digits(2, ""), |row| row.1.bar)
        .number("error", NumberFormat::Digits(2, ""), |row| row.1.error())
        .build()
}

/// The table of all results, a row each.
#[must_use]
pub fn results_table(checks: &[BarCheck]) -> Table {
    let rows: Vec<_> = rows(checks).collect();
    let range = |end: usize| move |row: &BarRow<'_>| Some(row.1.unsettled?[end]);
    let part = |of: usize| move |row: &BarRow<'_>| row.1.parts[of];
    named("Results and their bars", &rows)
        .number("converged", NumberFormat::Digits(6, ""), |row| {
            row.1.converged
        })
        .number("error", NumberFormat::Digits(2, ""), |row| row.1.error())
        .number("bar", NumberFormat::Digits(2, ""), |row| row.1.bar)
        .number("by time step", NumberFormat::Digits(2, ""), part(0))
        .number("by mesh", NumberFormat::Digits(2, ""), part(1))
        .number("not settled from", NumberFormat::Digits(4, ""), range(0))
        .number("to", NumberFormat::Digits(4, ""), range(1))
        .text("inside", |row| {
            if row.1.is_inside() { "yes" } else { "no" }.to_owned()
        })
        .build()
}

/// The columns of what a result is.
fn named<'r, 'a>(title: &str, rows: &'r [BarRow<'a>]) -> Columns<'r, BarRow<'a>> {
    Table::of_records(title, rows)
        .text("case", |row| row.0.name.clone())
        .text("method", |row| row.0.setting.clone())
        .text("result", |row| row.1.name.clone())
        .text("unit", |row| row.1.unit.clone())
        .number("value", NumberFormat::Digits(6, ""), |row| row.1.value)
}
