//! A system in motion in tables, charts and as JSON.

use serde_json::{Value, json};

use super::Glyphs;
use crate::case::FieldRow;
use crate::number::{duration, with_error};
use crate::reference::ValidationRow;
use crate::report::chart::{Axis, Chart, Series};
use crate::report::table::{NumberFormat, Table};
use crate::report::text::{self, Page, inputs};
use crate::system::SolvedSystem;
use crate::system::motion::run::{ChannelResult, MotionRun};

/// Lines of a chart.
const LINES: usize = 16;

/// The error of one of the four numbers of a channel, by steps and mesh together.
fn error(channel: &ChannelResult, number: usize) -> Option<f64> {
    Some(channel.time_error?[number] + channel.mesh_error?[number])
}

/// A number with its error.
fn written(channel: &ChannelResult, number: usize) -> String {
    let value = channel.summary.numbers()[number];
    with_error(value, error(channel, number), channel.id.quantity.unit())
}

/// Least, greatest, mean and last value of every channel, with errors.
#[must_use]
pub fn channels(run: &MotionRun) -> Table {
    const SECONDS: NumberFormat = NumberFormat::Digits(6, "s");
    let mut table = Table::of("In motion", &run.channels)
        .text("channel", |channel| channel.id.to_string())
        .text("least", |channel| written(channel, 0))
        .number("at", SECONDS, |channel| channel.summary.least.1)
        .text("greatest", |channel| written(channel, 1))
        .number("at", SECONDS, |channel| channel.summary.greatest.1)
        .text("mean", |channel| written(channel, 2))
        .text("at the end", |channel| written(channel, 3))
        .build();
    let estimated = run
        .channels
        .iter()
        .any(|channel| error(channel, 0).is_some());
    if estimated {
        table.notes.push(
            "Errors: of steps about twice as long and of half the segments, each by 3 times Richardson, order 2, added up.".to_owned(),
        );
    }
    table
}

/// Settings, work and energy in words.
#[must_use]
pub fn summary(run: &MotionRun) -> String {
    let (settings, work, balance) = (&run.settings, &run.work, &run.balance);
    let steps = match settings.step_tolerance {
        Some(tolerance) => format!(
            "steps of up to {:.3e} s by a step tolerance of {tolerance:.1e}",
            settings.time_step_s
        ),
        None => format!("steps of {} s", settings.time_step_s),
    };
    format!(
        "{} s by generalized-alpha, rho_inf {}, {steps}: {} steps, {} rejected, {} Newton iterations on {} nodes and {} joints, {}. \
         Energy put in {:.4e} J, lost {:.4e} J, stored {:.4e} J, not accounted for {:.1e} J ({:.3} %).",
        work.reached,
        settings.rho_inf,
        work.steps,
        work.rejections,
        work.iterations,
        work.nodes,
        work.joints,
        duration(work.seconds),
        balance.put_in,
        balance.lost,
        balance.stored,
        balance.drift(),
        100.0 * balance.relative_drift(),
    )
}

/// The tensions at the ends of the lines against time.
#[must_use]
pub fn tensions(run: &MotionRun, end: &str) -> Chart {
    let history = &run.history;
    let of_end = history.channels.iter();
    let of_end = of_end.filter(|channel| channel.id.place.ends_with(end));
    let series = of_end.enumerate().map(|(number, channel)| {
        let points = history.time.iter().zip(&channel.values);
        let points = points.map(|(time, value)| (*time, *value));
        Series::new(&channel.id.place, number, points.collect())
    });
    let title = format!(
        "Tension at ends {}",
        end.trim_start_matches('|').to_uppercase()
    );
    let (x, y) = (Axis::new("time", "s"), Axis::new("tension", "N"));
    Chart::new(title, x, y, series.collect())
}

/// The report of a run.
#[must_use]
pub fn report(
    solved: &SolvedSystem,
    run: &MotionRun,
    rows: &[ValidationRow],
    fields: &[FieldRow],
    glyphs: Glyphs,
) -> String {
    let about = &solved.file.about;
    let mut page = Page::default();
    page.title(&about.title);
    page.prose([&about.source, &about.notes]);
    page.paragraph(&super::tables::summary(solved));
    if let Some(why) = &run.failure {
        page.hanging("! ", &format!("The run ended early: {why}"));
    }
    for warning in super::tables::warnings(solved).iter().chain(&run.warnings) {
        page.hanging("! ", warning);
    }
    page.heading("In motion");
    page.paragraph(&summary(run));
    for event in &run.happened {
        page.hanging("", event);
    }
    page.table(&channels(run));
    for end in ["|a", "|b"] {
        page.chart(&tensions(run, end), LINES, glyphs);
    }
    if !rows.is_empty() {
        page.heading("Published values");
        page.block(&text::validation(rows));
    }
    inputs(&mut page, fields, !about.source.trim().is_empty());
    page.finish()
}

/// The run as a JSON object.
#[must_use]
pub fn object(run: &MotionRun) -> Value {
    let channel = |channel: &ChannelResult| {
        let [least, greatest, mean, last] = channel.summary.numbers();
        json!({
            "name": channel.id.to_string(),
            "unit": channel.id.quantity.unit(),
            "least": least,
            "least_at_s": channel.summary.least.1,
            "greatest": greatest,
            "greatest_at_s": channel.summary.greatest.1,
            "mean": mean,
            "last": last,
            "time_errors": channel.time_error,
            "mesh_errors": channel.mesh_error,
        })
    };
    let (work, balance) = (&run.work, &run.balance);
    json!({
        "state": if run.failure.is_some() { "failed" } else { "done" },
        "failure": run.failure,
        "warnings": run.warnings,
        "events": run.happened,
        "reached_s": work.reached,
        "steps": work.steps,
        "rejections": work.rejections,
        "iterations": work.iterations,
        "energy_put_in_j": balance.put_in,
        "energy_lost_j": balance.lost,
        "energy_stored_j": balance.stored,
        "energy_drift_j": balance.drift(),
        "directory": null,
        "channels": run.channels.iter().map(channel).collect::<Vec<_>>(),
    })
}
