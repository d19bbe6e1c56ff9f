//! The results of a report as one JSON object; `docs/output.schema.json` says what is in it.

use serde_json::{Value, json};

use super::{ReportSubject, RunInputs, RunSubject};
use crate::document::{Block, Report};
use crate::system::{self, motion};
use crate::{comparison, run_json};
use seacable_display::chart::{Axis, Chart};
use seacable_display::table::Table;
use seacable_model::case::Diagnostic;
pub(super) use seacable_studies::comparison::Comparison;
use seacable_systems::system::analysis::analyses::Analyses;

impl ReportSubject<'_> {
    /// The results: of runs, sweeps and systems what the commands that compute them print with `--json`; of other files their tables and
    /// charts.
    pub(super) fn to_json(
        &self,
        report: &dyn Fn() -> Result<Report, Vec<Diagnostic>>,
    ) -> Result<Value, Vec<Diagnostic>> {
        Ok(match self {
            Self::Run(subject) => of_run(subject)?,
            Self::System(solved, analyses, ..) => system::json::object(solved, analyses),
            Self::Sweep(sweep) => run_json::study("sweep", &sweep.view.csv_table()),
            _ => of_blocks(&report()?),
        })
    }
}

/// A run, its published values, and its differences from another run.
fn of_run(subject: &RunSubject<'_>) -> Result<Value, Vec<Diagnostic>> {
    let run = subject.run;
    let inputs = subject.inputs()?;
    let mut object = match &inputs {
        RunInputs::System(solved) => {
            let mut object = system::json::object(solved, &Analyses::of_object(solved));
            object["motion"] = motion::object(run, subject.dir);
            object
        }
        RunInputs::Line(case) => {
            let mut object = run_json::run(run, subject.dir);
            object["published"] = run_json::validation(&subject.rows(case));
            object
        }
    };
    let checks = subject.verdict(&inputs).ok().flatten();
    object["checks"] = json!(checks.map(|found| found.to_json()));
    object["against"] = json!(subject.against.map(|other| {
        let compared = Comparison::of_runs(&[other, run]);
        json!({
            "run": other.info.id,
            "results": comparison::results_table(&compared, false).to_json(),
        })
    }));
    Ok(object)
}

/// The tables and charts of a report.
fn of_blocks(report: &Report) -> Value {
    let blocks = report.blocks().iter();
    let title = blocks.clone().find_map(|block| match block {
        Block::Title(words) => Some(words.as_str()),
        _ => None,
    });
    let tables = blocks.clone().filter_map(|block| match block {
        Block::Table(of) => Some(table(of)),
        _ => None,
    });
    let charts = blocks.clone().filter_map(|block| match block {
        Block::Chart(of, _) => Some(chart(of)),
        _ => None,
    });
    json!({
        "kind": "report",
        "title": title,
        "version": env!("CARGO_PKG_VERSION"),
        "tables": tables.collect::<Vec<_>>(),
        "charts": charts.collect::<Vec<_>>(),
    })
}

fn table(of: &Table) -> Value {
    json!({"title": of.title, "rows": of.to_json(), "notes": of.notes})
}

/// A chart: its axes, and its curves as points; null separates two parts of a curve.
fn chart(of: &Chart) -> Value {
    let axis = |axis: &Axis| json!({"label": axis.label, "unit": axis.unit});
    let point = |(x, y): &(f64, f64)| match x.is_finite() && y.is_finite() {
        true => json!([x, y]),
        false => Value::Null,
    };
    let series = of.series.iter().map(|series| {
        let points: Vec<Value> = series.points.iter().map(point).collect();
        json!({"label": series.label, "points": points})
    });
    json!({
        "title": of.title,
        "x": axis(&of.x),
        "y": axis(&of.y),
        "series": series.collect::<Vec<_>>(),
    })
}
