//! A ship in views: plan, charts and tables, and all of them as a report.

pub mod coupled;
pub mod motion;
pub mod plan;
pub mod rope;
pub mod statics;

use crate::document::Report;
use crate::text::{self, inputs};
use seacable_model::case::{FieldRow, edited};
use seacable_runs::reference;
pub use seacable_systems::ship::rope::RopeAnalysis;
use seacable_systems::ship::validation;
pub use seacable_systems::ship::{
    DynamicAnalysis, MooredEquilibrium, MotionAnalysis, StaticAnalysis,
};

/// Lines of a chart, and of the plan view.
const LINES: usize = 18;
const PLAN: usize = 34;

/// The report of a ship: plan view, equilibrium headings with their stability, loads, mooring; motions and spectra; ship and
/// anchor line in the time domain; the rope; validation; inputs with their provenance. `fields` are those of its file; without a
/// dynamic analysis the report says that it is still running.
#[must_use]
pub fn report(
    statics: &StaticAnalysis,
    dynamic: Option<&DynamicAnalysis>,
    fields: &[FieldRow],
) -> Report {
    let particulars = &statics.ship.ship;
    let mut page = Report::default();
    page.title(&particulars.title);
    page.prose([&particulars.source, &particulars.notes]);
    static_section(&mut page, statics);
    match dynamic {
        Some(dynamic) => dynamic_sections(&mut page, statics, dynamic),
        None => page.paragraph("The dynamic analysis is still running."),
    }
    let motion = dynamic.and_then(|dynamic| dynamic.motion.as_ref());
    if !statics.ship.published.is_empty() {
        page.heading("Validation");
        page.gap();
        let mut rows = validation::rows(&statics.ship, motion);
        reference::set_edited_aside(&mut rows, &edited::of_rows(fields));
        text::add_validation(&mut page, &rows);
    }
    inputs(&mut page, fields, !particulars.source.trim().is_empty());
    page
}

/// The index of the governing equilibrium.
#[must_use]
pub fn governing(statics: &StaticAnalysis) -> usize {
    let equilibria = statics.equilibria.as_deref().unwrap_or_default();
    let governing = statics.governing();
    let same =
        |one: &MooredEquilibrium| governing.is_some_and(|governing| std::ptr::eq(one, governing));
    equilibria.iter().position(same).unwrap_or(0)
}

fn static_section(page: &mut Report, statics: &StaticAnalysis) {
    page.heading("Static analysis");
    page.chart(plan::chart(statics, governing(statics)), PLAN);
    page.chart(statics::moments(statics), LINES);
    let tables = [
        Some(statics::headings(statics)),
        statics::eigenvalues(statics),
        statics::loads(statics),
        statics::mooring(statics),
    ];
    for one in tables.into_iter().flatten() {
        page.table(one);
    }
}

fn dynamic_sections(page: &mut Report, statics: &StaticAnalysis, dynamic: &DynamicAnalysis) {
    match (&dynamic.motion, &statics.ship.motion) {
        (Some(Ok(analysis)), Some(settings)) => {
            motion_section(page, analysis, settings.seed());
        }
        (Some(Err(error)), _) => {
            page.heading("Motion");
            page.item("! ", &format!("The motion analysis failed: {error}."));
        }
        _ => {}
    }
    if let Some(coupled) = &dynamic.coupled {
        page.heading("Ship and anchor line in the time domain");
        match coupled {
            Ok(coupled) => {
                page.chart(coupled::motions(coupled), LINES);
                page.chart(coupled::tension(coupled), LINES);
                page.table(coupled::statistics(coupled));
                page.table(coupled::decay(coupled));
            }
            Err(error) => page.item("! ", &format!("The coupled analysis failed: {error}.")),
        }
    }
    if let Some(rope) = &dynamic.rope {
        page.heading("Rope at the moving ship");
        match rope {
            Ok(rope) => rope_section(page, rope),
            Err(error) => page.item("! ", &format!("The rope analysis failed: {error}.")),
        }
    }
}

/// The motion: first minutes, statistics, spectra.
fn motion_section(page: &mut Report, analysis: &MotionAnalysis, seed: u64) {
    page.heading("Motion");
    page.chart(motion::motions(analysis, None), LINES);
    page.table(motion::statistics(analysis, seed));
    page.table(motion::spectra(analysis));
}

fn rope_section(page: &mut Report, rope: &RopeAnalysis) {
    page.chart(rope::chart(rope), LINES);
    page.table(rope::table(rope));
    if let Some(over) = rope::dynamic_chart(rope) {
        page.chart(over, LINES);
    }
    if let Some(against) = rope::dynamic_table(rope) {
        page.table(against);
    }
}
