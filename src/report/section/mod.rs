//! A cross-section in views: drawing and tables, and all of them as a text report.

pub mod drawing;
pub mod tables;

use crate::document::Report;
use crate::text;
use seacable_display::table::Table;
use seacable_model::case::{FieldRow, edited};
use seacable_model::section::stiffness::EndRotation;
use seacable_model::section::{Design, validation};
use seacable_runs::reference;

/// Tension of the load sharing where no strength is known \[N\].
const SAMPLE: f64 = 1e5;

/// Lines of the drawing.
const LINES: usize = 40;

/// Default tension of the load sharing \[N\]: the allowable tension, or 100 kN where that is unknown.
#[must_use]
pub fn tension(design: &Design) -> f64 {
    let allowable = design.strength.as_ref().map(|s| s.allowable);
    allowable.unwrap_or(SAMPLE)
}

/// The design as a report, with its validation table where published values are stated; `fields` are those of its file.
/// `tension` is that of the load sharing \[N\], [`tension`](tension()) by default.
#[must_use]
pub fn report(design: &Design, fields: &[FieldRow], tension: Option<f64>) -> Report {
    let about = &design.section.about;
    let tension = tension.unwrap_or_else(|| self::tension(design));
    let mut page = Report::default();
    page.title(&about.title);
    page.prose([&about.source, &about.notes]);
    page.chart(drawing::chart(design), LINES);
    if !design.layout.warnings.is_empty() {
        let warnings = design.layout.warnings.iter();
        page.table(Table::titled("Warnings").noted(warnings.map(ToString::to_string)));
    }
    page.table(tables::layers(design));
    page.table(tables::summary(design));
    page.table(tables::stiffness(design));
    page.table(tables::load_sharing(
        design,
        about.core,
        EndRotation::Fixed,
        tension,
    ));
    let mut rows = validation::rows(design);
    if !rows.is_empty() {
        page.heading("Validation");
        page.gap();
        reference::set_edited_aside(&mut rows, &edited::of_rows(fields));
        text::add_validation(&mut page, &rows);
    }
    text::inputs(&mut page, fields, !about.source.trim().is_empty());
    page
}
