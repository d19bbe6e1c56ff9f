//! Speed against error as tables and as a chart.

use super::{SolutionErrors, SpeedPoint, SpeedStudy};
use crate::chart::{Axis, Chart, Series};
use crate::number::{digits, with_error};
use crate::run::{Quantity, RunState};
use crate::table::{Align, Cell, CellStyle, NumberFormat, Table};

/// Errors within this many times that of the reference are not significant.
const SIGNIFICANT: f64 = 10.0;

/// The table: a row a point, the reference last with its own error. Numbers are bare, their units in the heads, so that
/// the same table serves as CSV.
#[must_use]
pub fn table(study: &SpeedStudy) -> Table {
    let points: Vec<&SpeedPoint> = study.points.iter().chain([&study.reference]).collect();
    let failed = failed(&points);
    let is_reference = |point: &SpeedPoint| std::ptr::eq(point, &raw const study.reference);
    let error = |point: &SpeedPoint, of: fn(&SolutionErrors) -> f64| {
        NumberFormat::Digits(3, "").cell(point.errors.as_ref().map(of))
    };
    let table = Table::of_records("", &points)
        .text("solver", |point| {
            if is_reference(point) {
                "reference"
            } else {
                &point.setting.solver
            }
        })
        .text("setting", |point| {
            let setting = &point.setting;
            if is_reference(point) {
                format!("{} {}", setting.solver, setting.setting)
            } else {
                setting.setting.clone()
            }
        })
        .count("CPU [ms]", |p| digits(p.run.info.cost.cpu_s * 1e3, 3))
        .count("steps", |p| p.run.info.work.steps)
        .count("rejections", |p| p.run.info.work.rejections)
        .count("iterations", |p| p.run.info.work.iterations)
        .count("force evals", |p| p.run.info.work.evaluations)
        .count("CPU [ns/node] by work", |p| digits(node_ns(p), 3))
        .cell("tension rms [% of peak]", Align::Right, |p| {
            error(p, |e| 100.0 * e.tension_rms)
        })
        .cell("tension max [% of peak]", Align::Right, |p| {
            error(p, |e| 100.0 * e.tension_max)
        })
        .cell("position rms [m]", Align::Right, |p| {
            error(p, |e| e.position_rms)
        })
        .cell("position max [m]", Align::Right, |p| {
            error(p, |e| e.position_max)
        })
        .cell("mark", Align::Left, |point| mark(point, &failed, study));
    let reasons = failed.iter().enumerate().map(|(i, point)| {
        let failure = point.run.info.failure.as_deref();
        let why = failure.unwrap_or("it has other output times");
        let setting = &point.setting;
        format!("[{}] {}, {}: {why}", i + 1, setting.solver, setting.setting)
    });
    table.build().noted(reasons).noted(explanations(study))
}

/// Whether a point failed, is the reference, or is near to it.
fn mark(point: &SpeedPoint, failed: &[&SpeedPoint], study: &SpeedStudy) -> Cell {
    match &point.errors {
        None => {
            let number = failed.iter().position(|one| std::ptr::eq(*one, point));
            let number = number.map_or(0, |number| number + 1);
            Cell::new(format!("FAILED [{number}]"), CellStyle::Bad)
        }
        Some(_) if std::ptr::eq(point, &raw const study.reference) => Cell::plain("own error"),
        Some(errors) if is_near(errors, study) => Cell::new("near the reference", CellStyle::Warn),
        Some(_) => Cell::default(),
    }
}

/// The points without errors, which the notes explain.
fn failed<'a>(points: &[&'a SpeedPoint]) -> Vec<&'a SpeedPoint> {
    let failed = points.iter().filter(|point| point.errors.is_none());
    failed.copied().collect()
}

/// CPU time by iterations or evaluations and nodes \[ns\].
fn node_ns(point: &SpeedPoint) -> f64 {
    let (info, work) = (&point.run.info, &point.run.info.work);
    let counted = (work.iterations.max(work.evaluations) * info.settings.nodes as u64).max(1);
    info.cost.cpu_s * 1e9 / counted as f64
}

/// Whether errors are not significant beside that of the reference.
fn is_near(errors: &SolutionErrors, study: &SpeedStudy) -> bool {
    study.reference.errors.is_none_or(|own| {
        errors.tension_rms < SIGNIFICANT * own.tension_rms
            || errors.position_rms < SIGNIFICANT * own.position_rms
    })
}

fn explanations(study: &SpeedStudy) -> Vec<String> {
    let mut notes = vec![
        "Errors are those of the time step alone, at output times (positions: stored shapes), against the reference on the \
         same mesh; the reference's own is its distance from a run in twice its steps, and what is within ten times \
         that is marked."
            .to_owned(),
        "CPU: least of the repeats, one thread. A node's share of a Newton iteration was seen to be 67 to 85 ns where \
         nothing bends, of an evaluation of the force 7 to 28 ns, by hand-written kernels on a 3.6 GHz Xeon; here all of \
         the run is counted, reading and recording included."
            .to_owned(),
    ];
    let reference = &study.reference.setting.solver;
    if study.points.iter().any(|p| p.setting.solver == *reference) {
        notes.push(format!(
            "Rows of `{reference}` are of the reference's own method: their errors rest on one method alone."
        ));
    }
    notes.extend(
        study
            .left_out
            .iter()
            .map(|what| format!("Left out: {what}.")),
    );
    notes
}

/// Error of the mesh: single numbers of the case as it stands, with their errors in time and by a companion of half the
/// segments.
#[must_use]
pub fn mesh_table(study: &SpeedStudy) -> Table {
    let estimated = study.mesh.iter().filter(|q| q.mesh_error.is_some());
    let estimated: Vec<&Quantity> = estimated.collect();
    let part = |error: Option<f64>, unit: &str| {
        error.map_or_else(|| "-".to_owned(), |e| format!("{} {unit}", digits(e, 2)))
    };
    Table::of_records("Error of the mesh, as the case stands", &estimated)
        .text("quantity", |q| q.name())
        .count("value and error", |q| {
            with_error(q.value, q.error_estimate(), &q.unit())
        })
        .count("time error", |q| part(q.time_error, &q.unit()))
        .count("mesh error (half the segments)", |q| {
            part(q.mesh_error, &q.unit())
        })
        .build()
}

/// Cost over error of the tensions, both in powers of ten; a curve a method, a point a setting. What failed is not on it.
#[must_use]
pub fn chart(study: &SpeedStudy) -> Chart {
    let mut series: Vec<Series> = Vec::new();
    for point in &study.points {
        let Some(errors) = point
            .errors
            .filter(|_| point.run.info.state == RunState::Done)
        else {
            continue;
        };
        let at = (
            (100.0 * errors.tension_rms).log10(),
            (point.run.info.cost.cpu_s * 1e3).log10(),
        );
        let known = series.iter().position(|s| s.label == point.setting.solver);
        let slot = known.unwrap_or(series.len());
        if known.is_none() {
            series.push(Series::new(&point.setting.solver, slot, Vec::new()));
        }
        series[slot].points.push(at);
    }
    Chart::new(
        "Cost against error: lower left is better",
        Axis::new("log10 of the tension error, rms, % of peak", ""),
        Axis::new("log10 of CPU time, ms", ""),
        series,
    )
}
