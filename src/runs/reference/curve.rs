//! Comparison of a channel with a published curve: the difference, its numerical error, and a chart of both.

use crate::published::{CurveOverlay, ValidationRow, compare};
use crate::{
    case::{PublishedCurve, StudyPoint},
    run::{Run, RunState, published_curve},
};

/// The row of the curve of this number among those of its case, from 0.
pub(super) fn row<'r>(
    number: usize,
    curve: &PublishedCurve,
    lookup: &dyn Fn(Option<&StudyPoint>) -> Option<&'r Run>,
) -> ValidationRow {
    let unit = "% of peak, rms".to_owned();
    let row = ValidationRow {
        at: curve.at.clone(),
        published: Some(0.0),
        tolerance: Some(curve.tolerance_percent),
        inputs: Some(curve.inputs),
        kind: curve.kind.into(),
        note: curve.note.clone(),
        tolerance_reason: curve.tolerance_reason.clone(),
        ..ValidationRow::not_run(&curve.name, &curve.source, unit)
    };
    let run = lookup(curve.at.as_ref())
        .ok_or_else(|| "This variant of the case has not been run.".to_owned());
    let fit = run.and_then(|run| Ok((run, fit(curve, run)?)));
    let found = fit.as_ref().map_err(String::clone);
    let percent = found.map(|(run, fit)| (fit.percent, error(number, curve, run)));
    let mut row = compare(row, curve.out_of_reach.as_deref(), percent);
    row.overlay = Some(overlay(curve, fit.ok().map(|(_, fit)| fit)));
    row
}

fn fit(curve: &PublishedCurve, run: &Run) -> Result<published_curve::CurveComparison, String> {
    if run.info.state != RunState::Done {
        return Err("The run did not come to its end.".to_owned());
    }
    published_curve::compare(curve, &run.history)
}

/// Numerical error of the difference, where the run estimated it.
fn error(number: usize, curve: &PublishedCurve, run: &Run) -> Option<f64> {
    let id = published_curve::difference_id(curve, number);
    let difference = run.summary.iter().find(|q| q.id == id)?;
    difference.error_estimate()
}

/// The points of the curve at the times of the run, as often as they repeat there, beside what the run gives.
fn overlay(curve: &PublishedCurve, fit: Option<published_curve::CurveComparison>) -> CurveOverlay {
    let points = published_curve::points(curve);
    let Some(fit) = fit else {
        return CurveOverlay {
            channel: curve.channel.clone(),
            unit: "",
            published: points.collect(),
            computed: Vec::new(),
        };
    };
    let ends = fit.samples.first().zip(fit.samples.last());
    let (first, last) = ends.map_or((0.0, 0.0), |(a, b)| (a.0, b.0));
    let mut published: Vec<(f64, f64)> = Vec::new();
    for (time, value) in points {
        let time = time - fit.shift;
        match curve.period_s {
            None => published.push((time, value)),
            Some(period) => {
                let times = ((first - time) / period).ceil() as i64..;
                let times = times.map(|turn| time + period * turn as f64);
                published.extend(times.take_while(|t| *t <= last).map(|t| (t, value)));
            }
        }
    }
    published.sort_by(|a, b| a.0.total_cmp(&b.0));
    CurveOverlay {
        channel: curve.channel.clone(),
        unit: curve.channel.quantity.unit(),
        published,
        computed: fit.samples,
    }
}
