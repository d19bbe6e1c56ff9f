//! A ropeway in views: drawing, tables and charts, and all of them as a report.

pub mod cargo;
pub mod drawing;
pub mod tables;
pub mod winch;

use crate::document::Report;
use crate::text::inputs;
use seacable_model::case::FieldRow;
use seacable_systems::ropeway::{ModelResults, SolvedRopeway};

/// Lines of a picture and of a chart.
const LINES: usize = 18;

/// The report of a ropeway at the position of the results: drawing, models side by side, crossing, hauling, winch, motion of
/// the cargo, inputs with their provenance. `fields` are those of its file.
#[must_use]
pub fn report(solved: &SolvedRopeway, results: &ModelResults, fields: &[FieldRow]) -> Report {
    let about = &solved.ropeway.about;
    let mut page = Report::default();
    page.title(&about.title);
    page.prose([&about.source, &about.notes]);
    page.chart(drawing::chart(solved, results), LINES);
    let warnings = tables::warnings(solved, results);
    if !warnings.is_empty() {
        page.heading("Warnings");
        for warning in &warnings {
            page.item("! ", warning);
        }
    }
    page.heading("Models at rest");
    page.table(tables::models(solved, results));
    page.table(tables::crossing(solved, 10));
    page.table(tables::ropes(solved, results));
    if let Some(check) = tables::weight_check(solved) {
        page.table(check);
    }
    page.heading("Hauling the rope out");
    page.chart(winch::hauling_chart(solved), LINES);
    page.table(winch::hauling(solved));
    moving_ship(&mut page, solved);
    page.heading("Motion of the cargo");
    page.table(cargo::cargo(solved));
    let (path, comparison) = cargo::dynamic_crossing(solved);
    page.chart(path, LINES);
    page.table(comparison);
    inputs(&mut page, fields, !about.source.trim().is_empty());
    page
}

fn moving_ship(page: &mut Report, solved: &SolvedRopeway) {
    page.heading("Motion of the ship");
    let Some(series) = solved.ship_motion() else {
        page.paragraph("The ship does not move; add [motion].");
        return;
    };
    match solved.run_winch(&series) {
        Ok(run) => {
            let motion = solved.rope_motion();
            page.chart(winch::winch_chart(&run, motion.as_ref()), LINES);
            page.table(winch::winch(solved, &run, motion.as_ref()));
        }
        Err(error) => page.paragraph(&format!("No solution: {error}.")),
    }
}
