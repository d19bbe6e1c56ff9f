//! The least value of a result along a line over the runs of a sea: its sharpest bend, its least height above the bed. Both are recorded as
//! the least one of each run, so that the law is that of runs.

use super::SeaQuestion;
use super::checked::CheckRow;
use super::looks::taken;
use super::records::SeaRunRecord;
use crate::case::{CheckKind, GreatestMethod};
use crate::checks::resolved::Check;
use crate::checks::utilisation::Estimate;
use crate::extremes::gumbel;
use crate::extremes::interval::IntervalMethod;
use crate::extremes::target::{ExtremesTarget, Statistic};
use crate::study::record_statistics::FEWEST_RUNS;

/// The least values of a sea against their limit, line by line.
pub(super) fn rows(
    check: &Check,
    sea: usize,
    runs: &[SeaRunRecord],
    question: &SeaQuestion,
) -> Vec<Result<CheckRow, String>> {
    let lines = question.scene.lines.iter();
    let rows: Vec<_> = lines
        .filter_map(|line| row(check, (sea, line), runs, question))
        .map(Ok)
        .collect();
    match (rows.is_empty(), check.kind) {
        (true, CheckKind::BendRadius) => vec![Err(NOTHING_BENDS.to_owned())],
        _ => rows,
    }
}

const NOTHING_BENDS: &str =
    "no bend radius is recorded: none of its lines bends, which takes `ei_n_m2` of their material";

/// The least value along a line, by its name: in a random sea by Gumbel's law of the worst values of the runs; nothing of runs without one.
fn row(
    check: &Check,
    (sea, line): (usize, &str),
    runs: &[SeaRunRecord],
    question: &SeaQuestion,
) -> Option<CheckRow> {
    let id = check.least_along(line)?;
    let found = runs.iter().filter_map(|run| Some((run, run.result(&id)?)));
    let found: Vec<LeastOfRun<'_>> = found.collect();
    let least = found.iter().min_by(|a, b| a.1.0.total_cmp(&b.1.0));
    let (run, (least, _)) = least?;
    let errors = found.iter().filter_map(|(_, (_, error))| *error);
    let (value, sample, method) = match question.scene.is_random {
        true => most_probable(check.kind, &found, *least, question),
        false => (*least, None, GreatestMethod::Seen),
    };
    let load = Estimate {
        value,
        numerical: errors.reduce(f64::max),
        sample,
    };
    let limit = check.inputs.limit_m.unwrap_or(0.0);
    Some(CheckRow {
        sea: Some(sea),
        place: place(check, line)?,
        load,
        limit,
        unit: "m",
        used: load.utilisation(|value| match value > 0.0 {
            true => limit / value,
            false => f64::INFINITY,
        }),
        load_case: Some(run.load_case),
        time: None,
        method: Some(method),
    })
}

/// A run, and its least value with its numerical error.
type LeastOfRun<'a> = (&'a SeaRunRecord, (f64, Option<f64>));

/// The line, and the stretch of it that a check holds; nothing of checks and lines of which it holds no least value.
pub(super) fn place(check: &Check, line: &str) -> Option<String> {
    check.least_along(line)?;
    let line = match line {
        "" => "the line",
        name => name,
    };
    Some(match check.inputs.stretch_m {
        Some([from, to]) => format!("{line}, {from} to {to} m"),
        None => line.to_owned(),
    })
}

/// What a law of greatest values is fitted to, and back: curvatures of radii, depths of heights.
fn turned(kind: CheckKind, value: f64) -> f64 {
    match kind {
        CheckKind::BendRadius => 1.0 / value,
        _ => -value,
    }
}

/// The most probable least value, its interval, and how it was found.
fn most_probable(
    kind: CheckKind,
    found: &[LeastOfRun<'_>],
    least: f64,
    question: &SeaQuestion,
) -> (f64, Option<[f64; 2]>, GreatestMethod) {
    let worst = found.iter().map(|(_, (value, _))| turned(kind, *value));
    let worst: Vec<f64> = worst.collect();
    let lengths = found.iter().filter_map(|(run, _)| run.length());
    let hours = lengths.sum::<f64>() / 3600.0 / found.len() as f64;
    let statistics = &question.statistics;
    let target = ExtremesTarget {
        statistic: Statistic::MostProbable,
        greatest_of: statistics.hours / hours,
    };
    let by_law = statistics.method != GreatestMethod::Seen && found.len() >= FEWEST_RUNS;
    let method = IntervalMethod::Conditional;
    let (count, level) = taken(statistics, worst.len());
    let worst = &worst[..count];
    let fitted = by_law
        .then(|| gumbel::interval(worst, target, level, method).ok())
        .flatten();
    // A law of curvatures that reaches to straight lines is none.
    match fitted.filter(|fitted| kind != CheckKind::BendRadius || fitted.low > 0.0) {
        Some(fitted) => {
            let ends = [fitted.high, fitted.low].map(|end| turned(kind, end));
            (
                turned(kind, fitted.estimate),
                Some(ends),
                GreatestMethod::Gumbel,
            )
        }
        // A worse one may come at any time.
        None => (least, Some([least.min(0.0), least]), GreatestMethod::Seen),
    }
}
