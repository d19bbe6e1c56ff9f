//! The load of a sea at a place: its mean and its greatest and least value, each with the error of the sample and the numerical one.

use super::looks::taken;
use super::records::{RecordedSeries, SeaRunRecord};
use crate::case::{GreatestMethod, Statistic, StatisticsInputs};
use crate::checks::utilisation::Estimate;
use crate::numerics::statistics::Statistics;
use crate::study::record_statistics::{
    ChannelRecord, ExtremeMethod, ExtremeQuestion, FEWEST_RUNS, greatest, pooled_mean,
};

/// Standard errors of a mean that count as its interval: 95 % of a normal law.
const NORMAL_95: f64 = 1.96;

/// The greatest or least value of a sea at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// The most probable one of the hours asked for.
    pub estimate: Estimate,
    /// How it was found.
    pub method: GreatestMethod,
    /// The most extreme value that was seen.
    pub seen: f64,
    /// In which load case.
    pub load_case: usize,
    /// When \[s\]; nothing at rest.
    pub time: Option<f64>,
}

/// What a sea does at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaceLoads {
    /// The series.
    pub series: RecordedSeries,
    /// The place.
    pub place: String,
    /// The mean of all records.
    pub mean: Estimate,
    /// Their deviation.
    pub deviation: f64,
    /// The greatest value.
    pub greatest: Extreme,
    /// The least value.
    pub least: Extreme,
    /// Length of all records together \[s\].
    pub duration: f64,
}

/// Finds what the runs of a sea do at a place; nothing where they have no such record.
#[must_use]
pub(super) fn loads_at(
    runs: &[SeaRunRecord],
    (series, place): (RecordedSeries, &str),
    question: &StatisticsInputs,
    is_random: bool,
) -> Option<PlaceLoads> {
    let found: Vec<(&SeaRunRecord, ChannelRecord)> = runs
        .iter()
        .filter_map(|run| Some((run, run.series(series, place)?)))
        .filter(|(_, record)| !record.values.is_empty())
        .collect();
    if found.is_empty() {
        return None;
    }
    let records: Vec<ChannelRecord> = found.iter().map(|(_, record)| record.clone()).collect();
    let moments = moments(&records);
    // What never changes has no sample.
    let is_random = is_random && moments.max > moments.min;
    let numerical = |of: Statistic| numerical_error(&found, (series, place), of);
    let sample = match is_random {
        true => interval_of_mean(&records, moments.mean),
        false => None,
    };
    let extreme = |sign: f64, of: Statistic| {
        let Seen {
            value: seen,
            run,
            time,
        } = most_extreme(&found, (series, place), of)?;
        let (value, sample, method) = match is_random {
            true => most_probable(&records, sign, seen, question),
            false => (seen, None, GreatestMethod::Seen),
        };
        Some(Extreme {
            estimate: Estimate {
                value,
                numerical: numerical(of),
                sample,
            },
            method,
            seen,
            load_case: run.load_case,
            time,
        })
    };
    Some(PlaceLoads {
        series,
        place: place.to_owned(),
        mean: Estimate {
            value: moments.mean,
            numerical: numerical(Statistic::Mean),
            sample,
        },
        deviation: moments.deviation,
        greatest: extreme(1.0, Statistic::Max)?,
        least: extreme(-1.0, Statistic::Min)?,
        duration: records.iter().map(ChannelRecord::duration).sum(),
    })
}

/// The greatest numerical error of a statistic in the runs.
fn numerical_error(
    found: &[(&SeaRunRecord, ChannelRecord)],
    (series, place): (RecordedSeries, &str),
    of: Statistic,
) -> Option<f64> {
    let errors = found
        .iter()
        .filter_map(|(run, _)| run.numerical(series, place, of));
    errors.reduce(f64::max)
}

/// Statistics of the values of all records.
fn moments(records: &[ChannelRecord]) -> Statistics {
    let values = records.iter().flat_map(|record| &record.values).copied();
    Statistics::of_values(&values.collect::<Vec<f64>>())
}

/// The interval of the sample about a mean; nothing where the records are too short for it.
fn interval_of_mean(records: &[ChannelRecord], mean: f64) -> Option<[f64; 2]> {
    let pooled = pooled_mean(records).ok()?;
    let error = NORMAL_95 * pooled.error.max(pooled.batch_error);
    Some([mean - error, mean + error])
}

/// The most extreme value of all runs.
struct Seen<'a> {
    value: f64,
    run: &'a SeaRunRecord,
    time: Option<f64>,
}

/// The greatest or least value of all runs over every step, with its run and its time: where the run kept none for it, that of the row
/// nearest to it.
fn most_extreme<'a>(
    found: &[(&'a SeaRunRecord, ChannelRecord)],
    (series, place): (RecordedSeries, &str),
    of: Statistic,
) -> Option<Seen<'a>> {
    let sign = if of == Statistic::Min { -1.0 } else { 1.0 };
    let beyond = |a: f64, b: f64| (sign * a).total_cmp(&(sign * b));
    let each = found.iter().filter_map(|(run, record)| {
        let rows = record.values.iter().enumerate();
        let (row, value) = rows.max_by(|a, b| beyond(*a.1, *b.1))?;
        let (value, time) = (*value, run.time(row));
        let own = run.extreme(series, place, of);
        let own = own.filter(|(own, _)| beyond(*own, value).is_ge());
        let (value, time) = own.map_or((value, time), |(own, at)| (own, at.or(time)));
        Some(Seen { value, run, time })
    });
    each.max_by(|a, b| beyond(a.value, b.value))
}

/// The most probable greatest value, with sign -1 the least one, its interval, and how it was found. A greatest value that was merely
/// seen may be passed at any time: its interval has no end.
fn most_probable(
    records: &[ChannelRecord],
    sign: f64,
    seen: f64,
    question: &StatisticsInputs,
) -> (f64, Option<[f64; 2]>, GreatestMethod) {
    let turned: Vec<ChannelRecord>;
    let records: &[ChannelRecord] = match sign < 0.0 {
        false => records,
        true => {
            let negated = records.iter().map(|record| ChannelRecord {
                step: record.step,
                values: record.values.iter().map(|value| -value).collect(),
                extremes: record.extremes.map(|[least, greatest]| [-greatest, -least]),
            });
            turned = negated.collect();
            &turned
        }
    };
    // Verdicts that are looked for again and again take the runs of the last look alone.
    let (count, level) = taken(question, records.len());
    let records = &records[..count];
    let asked = ExtremeQuestion {
        hours: question.hours,
        level,
    };
    let by = |method: ExtremeMethod| greatest(records, method, asked).ok();
    let (found, method) = match question.method {
        GreatestMethod::Auto if records.len() >= FEWEST_RUNS => {
            (by(ExtremeMethod::Gumbel), GreatestMethod::Gumbel)
        }
        GreatestMethod::Auto | GreatestMethod::Weibull => {
            (by(ExtremeMethod::Weibull), GreatestMethod::Weibull)
        }
        GreatestMethod::Gumbel => (by(ExtremeMethod::Gumbel), GreatestMethod::Gumbel),
        GreatestMethod::PeaksOverThreshold => {
            let found = by(ExtremeMethod::PeaksOverThreshold);
            (found, GreatestMethod::PeaksOverThreshold)
        }
        GreatestMethod::Seen | GreatestMethod::Spectrum => (None, GreatestMethod::Seen),
    };
    match found {
        Some(found) => {
            let interval = found.most_probable;
            let ends = [sign * interval.low, sign * interval.high];
            let ends = [f64::min(ends[0], ends[1]), f64::max(ends[0], ends[1])];
            (sign * interval.estimate, Some(ends), method)
        }
        None if sign > 0.0 => (seen, Some([seen, f64::INFINITY]), GreatestMethod::Seen),
        None => (seen, Some([f64::NEG_INFINITY, seen]), GreatestMethod::Seen),
    }
}
