//! Speed against error as tables and as a chart.

use super::{Errors, SpeedPoint, SpeedStudy};
use crate::number::{digits, with_error};
use crate::report::chart::{Axis, Chart, Series};
use crate::report::table::{Cell, CellInk, Column, Table};
use crate::run::RunState;

/// Errors within this many times that of the reference are not significant.
const SIGNIFICANT: f64 = 10.0;

/// The table: a row a point, the reference last with its own error. Numbers are bare, their units in the heads, so that
/// the same table serves as CSV.
#[must_use]
pub fn table(study: &SpeedStudy) -> Table {
    let mut notes = Vec::new();
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for point in &study.points {
        rows.push(row(point, study, &mut notes));
    }
    let mut last = row(&study.reference, study, &mut notes);
    last[0] = Cell::plain("reference");
    last[1] = Cell::plain(format!(
        "{} {}",
        study.reference.setting.solver, study.reference.setting.setting
    ));
    rows.push(last);
    notes.extend(explanations(study));
    Table {
        title: String::new(),
        columns: vec![
            Column::left("solver"),
            Column::left("setting"),
            Column::right("CPU [ms]"),
            Column::right("steps"),
            Column::right("rejections"),
            Column::right("iterations"),
            Column::right("force evals"),
            Column::right("CPU [ns/node] by work"),
            Column::right("tension rms [% of peak]"),
            Column::right("tension max [% of peak]"),
            Column::right("position rms [m]"),
            Column::right("position max [m]"),
            Column::left("mark"),
        ],
        rows,
        notes,
    }
}

fn row(point: &SpeedPoint, study: &SpeedStudy, notes: &mut Vec<String>) -> Vec<Cell> {
    let (info, work) = (&point.run.info, &point.run.info.work);
    let counted = (work.iterations.max(work.evaluations) * info.settings.nodes as u64).max(1);
    let mut cells = vec![
        Cell::plain(point.setting.solver.as_str()),
        Cell::plain(point.setting.setting.as_str()),
        Cell::plain(digits(info.cost.cpu_s * 1e3, 3)),
        Cell::plain(work.steps.to_string()),
        Cell::plain(work.rejections.to_string()),
        Cell::plain(work.iterations.to_string()),
        Cell::plain(work.evaluations.to_string()),
        Cell::plain(digits(info.cost.cpu_s * 1e9 / counted as f64, 3)),
    ];
    let Some(errors) = &point.errors else {
        cells.extend((0..4).map(|_| Cell::new("-", CellInk::Dim)));
        let number = notes.len() + 1;
        cells.push(Cell::new(format!("FAILED [{number}]"), CellInk::Bad));
        let why = info
            .failure
            .as_deref()
            .unwrap_or("it has other output times");
        let setting = &point.setting;
        notes.push(format!(
            "[{number}] {}, {}: {why}",
            setting.solver, setting.setting
        ));
        return cells;
    };
    let told = [
        100.0 * errors.tension_rms,
        100.0 * errors.tension_max,
        errors.position_rms,
        errors.position_max,
    ];
    cells.extend(told.map(|value| Cell::plain(digits(value, 3))));
    cells.push(if std::ptr::eq(point, &raw const study.reference) {
        Cell::plain("own error")
    } else if is_near(errors, study) {
        Cell::new("near the reference", CellInk::Warn)
    } else {
        Cell::plain("")
    });
    cells
}

/// Whether errors are not significant beside that of the reference.
fn is_near(errors: &Errors, study: &SpeedStudy) -> bool {
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
    let told = study.mesh.iter().filter(|q| q.mesh_error.is_some());
    let part = |error: Option<f64>, unit: &str| {
        let bare = error.map(|e| format!("{} {unit}", digits(e, 2)));
        Cell::plain(bare.unwrap_or_else(|| "-".to_owned()))
    };
    Table {
        title: "Error of the mesh, as the case stands".to_owned(),
        columns: vec![
            Column::left("quantity"),
            Column::right("value and error"),
            Column::right("time error"),
            Column::right("mesh error (half the segments)"),
        ],
        rows: told
            .map(|q| {
                vec![
                    Cell::plain(q.name()),
                    Cell::plain(with_error(q.value, q.error_estimate(), &q.unit())),
                    part(q.time_error, &q.unit()),
                    part(q.mesh_error, &q.unit()),
                ]
            })
            .collect(),
        notes: Vec::new(),
    }
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
    Chart {
        title: "Cost against error: lower left is better".to_owned(),
        x: Axis::new("log10 of the tension error, rms, % of peak", ""),
        y: Axis::new("log10 of CPU time, ms", ""),
        series,
        legend: true,
        ..Chart::default()
    }
}
