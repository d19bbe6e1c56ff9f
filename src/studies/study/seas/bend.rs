//! The sharpest bend of a line over the runs of a sea. Radii are recorded as the least one of each run, so that the law is that of runs.

use super::SeaQuestion;
use super::checked::CheckRow;
use super::looks::taken;
use super::records::RunRecord;
use crate::case::GreatestMethod;
use crate::checks::resolved::Check;
use crate::checks::utilisation::Estimate;
use crate::extremes::gumbel;
use crate::extremes::interval::IntervalMethod;
use crate::extremes::target::{Statistic, Target};
use crate::study::record_statistics::FEWEST_RUNS;

/// The least bend radii of a sea against their limit, line by line.
pub(super) fn rows(
    check: &Check,
    sea: usize,
    runs: &[RunRecord],
    question: &SeaQuestion,
) -> Vec<Result<CheckRow, String>> {
    let first = runs.first();
    let lines = first.into_iter().flat_map(RunRecord::bent_lines);
    let rows = lines
        .filter(|line| line.is_empty() || check.holds_for(line))
        .filter_map(|line| row(check, (sea, line), runs, question));
    let rows: Vec<_> = rows.map(Ok).collect();
    match rows.is_empty() {
        true => vec![Err("no bend radius is recorded: none of its lines bends, which takes `ei_n_m2` of their material".to_owned())],
        false => rows,
    }
}

/// The least bend radius of a line, by its name: in a random sea by Gumbel's law of the greatest curvatures of the runs; nothing of runs
/// without one.
fn row(
    check: &Check,
    (sea, line): (usize, &str),
    runs: &[RunRecord],
    question: &SeaQuestion,
) -> Option<CheckRow> {
    let found = runs
        .iter()
        .filter_map(|run| Some((run, run.least_bend_radius(line)?)));
    let found: Vec<_> = found.collect();
    let least = found.iter().min_by(|a, b| a.1.0.total_cmp(&b.1.0));
    let (run, (radius, _)) = least?;
    let errors = found.iter().filter_map(|(_, (_, error))| *error);
    let (value, sample, method) = match question.scene.is_random {
        true => most_probable(&found, *radius, question),
        false => (*radius, None, GreatestMethod::Seen),
    };
    let limit = check.inputs.limit_m.unwrap_or(0.0);
    let load = Estimate {
        value,
        numerical: errors.reduce(f64::max),
        sample,
    };
    Some(CheckRow {
        sea: Some(sea),
        place: match line {
            "" => "the line".to_owned(),
            name => name.to_owned(),
        },
        load,
        limit,
        unit: "m",
        used: load.utilisation(|radius| match radius > 0.0 {
            true => limit / radius,
            false => f64::INFINITY,
        }),
        load_case: Some(run.load_case),
        time: None,
        method: Some(method),
    })
}

/// The radius of the most probable greatest curvature, its interval, and how it was found.
fn most_probable(
    found: &[(&RunRecord, (f64, Option<f64>))],
    least: f64,
    question: &SeaQuestion,
) -> (f64, Option<[f64; 2]>, GreatestMethod) {
    let curvatures = found.iter().map(|(_, (radius, _))| 1.0 / radius);
    let curvatures: Vec<f64> = curvatures.collect();
    let lengths = found.iter().filter_map(|(run, _)| run.length());
    let hours = lengths.sum::<f64>() / 3600.0 / found.len() as f64;
    let statistics = &question.statistics;
    let target = Target {
        statistic: Statistic::MostProbable,
        greatest_of: statistics.hours / hours,
    };
    let by_law = statistics.method != GreatestMethod::Seen && found.len() >= FEWEST_RUNS;
    let method = IntervalMethod::Conditional;
    let (count, level) = taken(statistics, curvatures.len());
    let curvatures = &curvatures[..count];
    let fitted = by_law
        .then(|| gumbel::interval(curvatures, target, level, method).ok())
        .flatten();
    match fitted.filter(|curvature| curvature.low > 0.0) {
        Some(curvature) => {
            let ends = [1.0 / curvature.high, 1.0 / curvature.low];
            (1.0 / curvature.estimate, Some(ends), GreatestMethod::Gumbel)
        }
        // A sharper bend may come at any time.
        None => (least, Some([0.0, least]), GreatestMethod::Seen),
    }
}
