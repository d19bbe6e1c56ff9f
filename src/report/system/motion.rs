//! A run of a system in time: tables, charts, text report, JSON.

use seacable_base::visible;
use std::collections::HashMap;
use std::path::Path;

use serde_json::{Value, json};

use crate::document::Report;
use crate::figures::{FigureData, FigureId, PlottedRun, SystemContents, against_time_at};
use crate::response;
use crate::text::{self, WIDTH, inputs};
use seacable_base::number::{si, with_error};
use seacable_display::chart::{Chart, Glyphs};
use seacable_display::table::{Align, Cell, NumberFormat, Table};
use seacable_model::case::{
    ChannelQuantity, EnergyQuantity, FieldRow, LineQuantity, Method, QuantityId, Statistic,
    Subject, edited, kind,
};
use seacable_runs::run::{Channel, Profile, Quantity, Run, edited_inputs};
use seacable_systems::system::motion::job::STATISTICS;
use seacable_systems::system::{SolvedSystem, SystemFile, validation, warnings::warnings};

/// Lines of a chart.
const LINES: usize = 16;

/// A channel with its statistics, as far as the run has them.
struct ChannelRow<'a> {
    channel: &'a Channel,
    numbers: [Option<&'a Quantity>; 4],
}

impl<'a> ChannelRow<'a> {
    fn all(run: &'a Run) -> Vec<Self> {
        let channels = run.history.channels.iter();
        let mut by_name: HashMap<String, Vec<&Quantity>> = HashMap::new();
        for quantity in &run.summary {
            if let QuantityId::Statistic {
                of: Subject::Channel(id),
                ..
            } = &quantity.id
            {
                by_name.entry(id.to_string()).or_default().push(quantity);
            }
        }
        let of = |channel: &Channel| by_name.get(&channel.id.to_string());
        channels
            .map(|channel| Self::new(of(channel).map_or(&[][..], Vec::as_slice), channel))
            .collect()
    }

    /// From the quantities of a channel.
    fn new(quantities: &[&'a Quantity], channel: &'a Channel) -> Self {
        let find = |statistic| {
            let id = QuantityId::new(Subject::Channel(channel.id.clone()), statistic, None);
            let mut quantities = quantities.iter();
            quantities.find(|quantity| quantity.id == id).copied()
        };
        Self {
            channel,
            numbers: STATISTICS.map(find),
        }
    }

    /// A number with its error.
    fn written(&self, number: usize) -> Cell {
        self.numbers[number].map_or_else(Cell::none, |q| Cell::plain(written(q)))
    }

    fn values(&self) -> [Option<f64>; 4] {
        self.numbers.map(|number| number.map(|q| q.value))
    }

    /// The errors of all four numbers by the time steps, or by the mesh.
    fn errors(&self, of: fn(&Quantity) -> Option<f64>) -> Option<Vec<f64>> {
        self.numbers.iter().map(|number| of((*number)?)).collect()
    }
}

/// A number with its error.
fn written(q: &Quantity) -> String {
    match q.error_estimate().filter(|error| *error > 0.0) {
        Some(error) => with_error(q.value, Some(error), &q.unit()),
        None => si(q.value, &q.unit()),
    }
}

/// Least, greatest, mean and last value of every channel, with errors.
#[must_use]
pub fn channels(run: &Run) -> Table {
    const SECONDS: NumberFormat = NumberFormat::Digits(6, "s");
    let rows = ChannelRow::all(run);
    let mut table = Table::of_records("In motion", &rows)
        .text("channel", |row| row.channel.name())
        .cell("least", Align::Left, |row| row.written(0))
        .number("at", SECONDS, |row| row.channel.trough.1)
        .cell("greatest", Align::Left, |row| row.written(1))
        .number("at", SECONDS, |row| row.channel.peak.1)
        .cell("mean", Align::Left, |row| row.written(2))
        .cell("at the end", Align::Left, |row| row.written(3))
        .build();
    if run.summary.iter().any(|q| q.error_estimate().is_some()) {
        let method = &run.info.settings.error_method;
        table.notes.push(format!("Errors: {method}, added up."));
    }
    table
}

/// The extremes along every line with their errors, and where they are.
#[must_use]
pub fn along_lines(run: &Run) -> Table {
    const METRES: NumberFormat = NumberFormat::Digits(6, "m");
    let by_name: HashMap<String, &Quantity> = run.summary.iter().map(|q| (q.name(), q)).collect();
    let find = |line: &Profile, quantity, statistic| {
        let id = QuantityId::new(Subject::along(quantity, &line.line), statistic, None);
        by_name.get(&id.to_string()).copied()
    };
    let cell = |line: &Profile, quantity, statistic| {
        find(line, quantity, statistic).map_or_else(Cell::none, |q| Cell::plain(written(q)))
    };
    let at = |line: &Profile, quantity, statistic| {
        find(line, quantity, statistic).map_or(f64::NAN, |q| q.value)
    };
    let lines: Vec<&Profile> = run.profiles.iter().collect();
    let mut table = Table::of_records("Along the lines", &lines)
        .text("line", |line| line.line.clone())
        .cell("least tension", Align::Left, |line| {
            cell(line, LineQuantity::Tension, Statistic::Min)
        })
        .number("at", METRES, |line| {
            at(line, LineQuantity::Tension, Statistic::ArcOfMin)
        })
        .cell("greatest tension", Align::Left, |line| {
            cell(line, LineQuantity::Tension, Statistic::Max)
        })
        .number("at", METRES, |line| {
            at(line, LineQuantity::Tension, Statistic::ArcOfMax)
        });
    if lines.iter().any(|line| line.bends()) {
        table = table
            .cell("least bend radius", Align::Left, |line| {
                cell(line, LineQuantity::BendRadius, Statistic::Min)
            })
            .number("at", METRES, |line| {
                at(line, LineQuantity::BendRadius, Statistic::ArcOfMin)
            });
    }
    table.build()
}

/// The energy balance in words; nothing of a run that has none.
#[must_use]
pub fn energy(run: &Run) -> Option<String> {
    let value = |of| {
        let id = QuantityId::single(Subject::Energy(of));
        Some(run.summary.iter().find(|q| q.id == id)?.value)
    };
    Some(format!(
        "Energy put in {:.4e} J, dissipated {:.4e} J, stored {:.4e} J, not accounted for {:.1e} J ({:.3} %).",
        value(EnergyQuantity::Supplied)?,
        value(EnergyQuantity::Dissipated)?,
        value(EnergyQuantity::Stored)?,
        value(EnergyQuantity::Drift)?,
        value(EnergyQuantity::DriftShare)?.abs(),
    ))
}

/// Events, channels and energy balance.
fn results(page: &mut Report, run: &Run) {
    for event in &run.info.happened {
        page.item("* ", event);
    }
    if run.history.channels.is_empty() {
        return page.paragraph("The run holds no results.");
    }
    page.table(channels(run));
    if !run.profiles.is_empty() {
        page.table(along_lines(run));
        page.gap();
    }
    for line in &run.profiles {
        let peaks = response::peaks(line);
        if !peaks.rows.is_empty() {
            let title = format!("Peaks and valleys of the response of {}", line.line);
            page.section(&title, peaks);
            page.gap();
        }
    }
    if let Some(energy) = energy(run) {
        page.paragraph(&energy);
    }
}

/// The results on 80 columns.
#[must_use]
pub fn summary(run: &Run) -> String {
    let mut page = Report::default();
    results(&mut page, run);
    page.to_text(WIDTH, Glyphs::Braille)
}

/// The charts that have something to show: tensions by ends, then positions and angles.
fn charts(run: &Run) -> Vec<Chart> {
    let runs = [PlottedRun::whole(run, "")];
    let tension = ["|a", "|b"].map(|end| {
        let chart = against_time_at(&runs, ChannelQuantity::Tension, |place| {
            place.ends_with(end)
        });
        Chart {
            title: format!("Tension at ends {}", end[1..].to_uppercase()),
            ..chart
        }
    });
    let recorded = run.history.channels.iter().map(|c| c.id.quantity);
    let contents = SystemContents {
        dynamic: run.info.settings.method != Method::Static.name(),
        recorded: recorded.collect(),
        bends: run.profiles.iter().any(Profile::bends),
        responds: run.profiles.iter().any(|line| !line.rms.is_empty()),
        driven: run.profiles.iter().any(|line| !line.towards_a.is_empty()),
    };
    let others = FigureId::of_system(&contents).into_iter();
    let others = others.filter(|id| *id != FigureId::Tensions);
    let others = others.map(|id| id.figure().draw(&FigureData::of_system(&runs)));
    let all = tension.into_iter().chain(others);
    all.filter(|chart| chart.series.iter().any(|series| series.points.len() > 1))
        .collect()
}

/// The report of a stored run, of the system of its own text.
#[must_use]
pub fn stored_report(run: &Run, solved: &SolvedSystem) -> Report {
    let mut fields = kind::rows::<SystemFile>(&run.case_text);
    edited::mark(&mut fields, &edited_inputs::<SystemFile>(run));
    report(solved, run, &fields)
}

/// The report of a run: what was computed and how, inputs, results with their errors, charts, work and cost.
fn report(solved: &SolvedSystem, run: &Run, fields: &[FieldRow]) -> Report {
    let about = &solved.file.about;
    let mut page = Report::default();
    text::head(
        &mut page,
        &run.info,
        [&about.title, &about.source, &about.notes],
    );
    page.gap();
    page.paragraph(&super::tables::summary(solved));
    let at_rest = warnings(solved);
    let own = run.info.warnings.iter();
    let own = own.filter(|warning| !at_rest.contains(warning));
    let warnings: Vec<String> = at_rest.iter().chain(own).cloned().collect();
    text::warnings(&mut page, &warnings);
    text::settings(&mut page, &run.info);
    inputs(&mut page, fields, !about.source.trim().is_empty());
    page.heading("Results");
    results(&mut page, run);
    let rows = validation::rows_of_run(solved, run);
    if !rows.is_empty() {
        page.heading("Published values");
        text::add_validation(&mut page, &rows);
    }
    let charts = charts(run);
    if !charts.is_empty() {
        page.heading("Charts");
    }
    for chart in charts {
        page.chart(chart, LINES);
    }
    text::work(&mut page, &run.info);
    page
}

/// The run as a JSON object, with the directory that holds it.
#[must_use]
pub fn object(run: &Run, directory: &Path) -> Value {
    let channel = |row: &ChannelRow<'_>| {
        let [least, greatest, mean, last] = row.values();
        json!({
            "name": row.channel.name(),
            "unit": row.channel.unit(),
            "least": least,
            "least_at_s": row.channel.trough.1,
            "greatest": greatest,
            "greatest_at_s": row.channel.peak.1,
            "mean": mean,
            "last": last,
            "time_errors": row.errors(|q| q.time_error),
            "mesh_errors": row.errors(|q| q.mesh_error),
        })
    };
    let energy = |of| {
        let id = QuantityId::single(Subject::Energy(of));
        run.summary.iter().find(|q| q.id == id).map(|q| q.value)
    };
    // An extreme along a line, or its place.
    let along = |q: &Quantity| {
        let QuantityId::Statistic { of, statistic, .. } = &q.id else {
            return None;
        };
        let (quantity, line) = of.line_quantity()?;
        Some(json!({
            "line": line,
            "quantity": quantity.name(),
            "statistic": statistic.name(),
            "value": q.value,
            "time_error": q.time_error,
            "mesh_error": q.mesh_error,
        }))
    };
    let info = &run.info;
    json!({
        "state": info.state,
        "failure": info.failure,
        "warnings": info.warnings,
        "events": info.happened,
        "reached_s": run.history.time.last(),
        "steps": info.work.steps,
        "rejections": info.work.rejections,
        "iterations": info.work.iterations,
        "energy_put_in_j": energy(EnergyQuantity::Supplied),
        "energy_lost_j": energy(EnergyQuantity::Dissipated),
        "energy_stored_j": energy(EnergyQuantity::Stored),
        "energy_drift_j": energy(EnergyQuantity::Drift),
        "directory": visible::path(directory),
        "channels": ChannelRow::all(run).iter().map(channel).collect::<Vec<_>>(),
        "along_lines": run.summary.iter().filter_map(along).collect::<Vec<_>>(),
    })
}
