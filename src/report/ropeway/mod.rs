//! A ropeway in views: drawing, tables and charts, and all of them as a text report on 80 columns.

pub mod cargo;
pub mod drawing;
pub mod tables;
pub mod winch;

use crate::report::chart::{Chart, Glyphs, draw};
use crate::report::table::Table;
use crate::report::text::{Page, WIDTH, inputs};
use crate::ropeway::edit;
use crate::ropeway::{ModelResults, SolvedRopeway};

/// Lines of a picture and of a chart.
const LINES: usize = 18;

/// The report of a ropeway at the position of the results: drawing, models side by side, crossing, hauling, winch, motion of
/// the cargo, inputs with their provenance. `text` is that of the file.
#[must_use]
pub fn report(
    worked: &SolvedRopeway,
    results: &ModelResults,
    text: &str,
    glyphs: Glyphs,
) -> String {
    let about = &worked.ropeway.about;
    let mut page = Page::default();
    page.title(&about.title);
    for words in [&about.source, &about.notes] {
        if !words.trim().is_empty() {
            page.line("");
            page.paragraph(words);
        }
    }
    page.line("");
    page.block(&drawing::text(worked, results, (WIDTH, LINES), glyphs));
    let warnings = tables::warnings(worked, results);
    if !warnings.is_empty() {
        page.heading("Warnings");
        for warning in &warnings {
            page.hanging("! ", warning);
        }
    }
    page.heading("Models at rest");
    table(&mut page, &tables::models(worked, results));
    table(&mut page, &tables::crossing(worked, 10));
    table(&mut page, &tables::ropes(worked, results));
    if let Some(check) = tables::weight_check(worked) {
        table(&mut page, &check);
    }
    page.heading("Hauling the rope out");
    chart(&mut page, &winch::hauling_chart(worked), glyphs);
    table(&mut page, &winch::hauling(worked));
    moving_ship(&mut page, worked, glyphs);
    page.heading("Motion of the cargo");
    table(&mut page, &cargo::cargo(worked));
    let (over, beside) = cargo::dynamic_crossing(worked);
    chart(&mut page, &over, glyphs);
    table(&mut page, &beside);
    inputs(
        &mut page,
        &edit::rows(text),
        !about.source.trim().is_empty(),
    );
    page.finish()
}

fn moving_ship(page: &mut Page, worked: &SolvedRopeway, glyphs: Glyphs) {
    page.heading("Motion of the ship");
    let Some(series) = worked.ship_motion() else {
        page.paragraph("The ship does not move; add [motion].");
        return;
    };
    match worked.run_winch(&series) {
        Ok(followed) => {
            chart(page, &winch::winch_chart(&followed), glyphs);
            table(page, &winch::winch(worked, &followed));
        }
        Err(error) => page.paragraph(&format!("No solution: {error}.")),
    }
}

fn table(page: &mut Page, table: &Table) {
    page.line("");
    page.block(&table.to_text(WIDTH));
}

fn chart(page: &mut Page, chart: &Chart, glyphs: Glyphs) {
    page.line("");
    page.block(&draw(chart, WIDTH, LINES, glyphs).to_text());
}
