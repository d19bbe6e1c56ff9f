//! Comparison of a channel with a published curve: the differences, their numerical errors, and a chart of both.

use super::stated::ComparedRun;
use crate::case::{CurveMeasure, PublishedCurve};
use crate::published::{CurveOverlay, ValidationRow, compare};
use crate::run::Quantity;
use crate::run::published_curve::{self, CurveComparison};

/// The rows of the curve of this number among those of its file, from 0: of the root mean square and, where the file asks for it, of the
/// greatest difference.
pub(super) fn rows(
    number: usize,
    curve: &PublishedCurve,
    run: &Result<ComparedRun<'_>, String>,
) -> Vec<ValidationRow> {
    let run = run.as_ref().map_err(String::clone);
    let fit = run.and_then(|run| Ok((run, published_curve::compare(curve, run.history)?)));
    let row = |(measure, tolerance): (CurveMeasure, f64)| {
        let found = fit.as_ref().map_err(String::clone);
        let found = found.and_then(|(run, fit)| {
            let id = published_curve::difference_id(curve, measure, number);
            let known = run.summary.iter().find(|q| q.id == id);
            Ok((
                fit.measured(measure)?,
                known.and_then(Quantity::error_estimate),
            ))
        });
        let row = stated(curve, measure, tolerance);
        compare(row, curve.out_of_reach.as_deref(), found)
    };
    let mut rows: Vec<ValidationRow> = published_curve::held(curve).into_iter().map(row).collect();
    rows[0].overlay = Some(overlay(curve, fit.ok().map(|(_, fit)| fit)));
    rows
}

/// What a curve states of how far a run may be from it.
fn stated(curve: &PublishedCurve, measure: CurveMeasure, tolerance: f64) -> ValidationRow {
    let (name, unit) = match measure {
        CurveMeasure::RootMeanSquare => (curve.name.clone(), "% of peak, rms"),
        CurveMeasure::Greatest => (format!("{}, greatest difference", curve.name), "% of range"),
    };
    ValidationRow {
        at: curve.at.clone(),
        published: Some(0.0),
        tolerance: Some(tolerance),
        inputs: Some(curve.inputs),
        kind: curve.kind.into(),
        note: curve.note.clone(),
        tolerance_reason: curve.tolerance_reason.clone(),
        ..ValidationRow::not_run(&name, &curve.source, unit.to_owned())
    }
}

/// The points of the curve at the times of the run, as often as they repeat there, beside what the run gives.
fn overlay(curve: &PublishedCurve, fit: Option<CurveComparison>) -> CurveOverlay {
    let channel = curve.channel.clone();
    match fit {
        None => CurveOverlay {
            channel,
            unit: "",
            published: published_curve::points(curve).collect(),
            computed: Vec::new(),
        },
        Some(fit) => CurveOverlay {
            unit: channel.quantity.unit(),
            channel,
            published: fit.published,
            computed: fit.samples,
        },
    }
}
