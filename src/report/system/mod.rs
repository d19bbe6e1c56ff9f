//! A system of lines in views: plan, side and oblique view, tables of lines, points and bodies, text report, JSON.

pub mod analysis;
pub mod json;
pub mod motion;
pub mod tables;
pub mod views;

use crate::document::Report;
use crate::text::{self, inputs};
use crate::verdict::{self, RunVerdict};
use seacable_model::case::FieldRow;
use seacable_runs::reference::ValidationRow;
use seacable_studies::study::seas::SeaQuestion;
pub use seacable_systems::system::SolvedSystem;
use seacable_systems::system::analysis::analyses::Analyses;
use seacable_systems::system::warnings::warnings;

/// Lines of a view.
const LINES: usize = 20;

/// The report of a system: views, lines, points, bodies with their stiffness, comparison with published values, inputs.
#[must_use]
pub fn report(
    solved: &SolvedSystem,
    analyses: &Analyses,
    rows: &[ValidationRow],
    fields: &[FieldRow],
) -> Report {
    let about = &solved.file.about;
    let mut page = Report::default();
    page.title(&about.title);
    page.prose([&about.source, &about.notes]);
    page.paragraph(&tables::summary(solved));
    if let Some(ageing) = tables::ageing(solved) {
        page.paragraph(&ageing);
    }
    for warning in warnings(solved) {
        page.item("! ", &warning);
    }
    let network = &solved.network;
    let has_lines = !network.lines.is_empty();
    if has_lines {
        page.heading("Lines");
        page.chart(views::plan(solved), LINES);
        page.chart(views::side(solved), LINES);
        page.table(tables::lines(solved));
    }
    page.heading("Points and bodies");
    if has_lines || !network.points.is_empty() {
        page.table(tables::points(solved));
    }
    if !network.bodies.is_empty() {
        page.table(tables::bodies(solved));
        for body in (0..network.bodies.len()).filter(|_| has_lines) {
            page.table(tables::stiffness(solved, body));
        }
    }
    if !analyses.others.is_empty() {
        page.table(analysis::equilibria(solved, &analyses.others));
    }
    if has_lines {
        page.table(analysis::clearances(solved, &analyses.clearances));
    }
    match &analyses.periods {
        Ok(found) if found.modes.is_empty() => {}
        Ok(found) => page.table(analysis::periods(solved, found)),
        Err(why) => page.paragraph(&format!("No natural periods: {why}.")),
    }
    asked(&mut page, solved, analyses);
    let question = SeaQuestion::of_system(solved);
    let verdict = question.map(|question| RunVerdict::of_equilibrium(&question, solved));
    verdict::add(&mut page, verdict);
    if !rows.is_empty() {
        page.heading("Published values");
        text::add_validation(&mut page, rows);
    }
    inputs(&mut page, fields, !about.source.trim().is_empty());
    page
}

/// The analyses that the file asks for.
fn asked(page: &mut Report, solved: &SolvedSystem, asked: &Analyses) {
    if !asked.offsets.is_empty() || !asked.circles.is_empty() {
        page.heading("Offsets");
    }
    for curve in &asked.offsets {
        page.chart(
            analysis::offset_chart(curve.heading_deg, &curve.points),
            LINES,
        );
        page.table(analysis::offset_curve(solved, curve));
    }
    for (_, circle) in &asked.circles {
        page.chart(analysis::watch_chart(solved, circle), LINES);
        page.table(analysis::watch_circle(solved, circle));
    }
    if !asked.goals.is_empty() {
        page.heading("Goals");
        page.table(analysis::goals(&asked.goals));
    }
}
