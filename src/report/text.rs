//! The text report of a stored run: everything a reader needs to judge it, on 80 columns.

mod about;
mod charts;
mod inputs;
mod results;
mod validation;

pub use about::numerical_damping;
pub(crate) use about::{head, settings, warnings, work};
pub(crate) use inputs::list as inputs;
pub use results::summary;
pub use validation::add_validation;
pub use validation::validation;

use super::chart::Glyphs;
use super::document::Report;
use super::{limits, sea};
use seacable_model::case::Case;
use seacable_runs::reference::ValidationRow;
use seacable_runs::run::Run;

/// Columns of a report.
pub const WIDTH: usize = 80;

/// The report of a run as plain text, its charts drawn with `glyphs`; for a report that is ASCII throughout, pass the result through
/// [`plain::ascii`](super::plain::ascii).
#[must_use]
pub fn report(run: &Run, case: &Case, rows: &[ValidationRow], glyphs: Glyphs) -> String {
    of_run(run, case, rows).to_text(WIDTH, glyphs)
}

/// The report of a run: what was computed and with which settings, inputs with their standing,
/// results with their errors, charts, comparison with published values, work and cost.
///
/// `rows` are the published rows of the case ([`reference::rows`](seacable_runs::reference::rows)).
#[must_use]
pub fn of_run(run: &Run, case: &Case, rows: &[ValidationRow]) -> Report {
    let mut page = Report::default();
    let about = &case.case;
    head(
        &mut page,
        &run.info,
        [&about.title, &about.source, &about.notes],
    );
    warnings(&mut page, &run.info.warnings);
    settings(&mut page, &run.info);
    inputs::table(&mut page, run, case);
    let sea = sea::table(case);
    if !sea.rows.is_empty() {
        page.section("Irregular records", sea);
    }
    page.heading("Results");
    results::add_summary(&mut page, run);
    if let Some(limits) = limits::of_run(case, run.profile()) {
        page.section("What the sections bear", limits);
    }
    charts::all(&mut page, run, case, rows);
    results::answer(&mut page, run, case);
    results::nodes(&mut page, run);
    if !rows.is_empty() {
        page.heading("Published values");
        add_validation(&mut page, rows);
        validation::not_judged(&mut page, rows);
    }
    work(&mut page, &run.info);
    page
}
