//! A ropeway as a text report on 80 columns.

use super::edit;
use super::motions;
use super::picture::picture;
use super::tables;
use super::work::{Readings, Worked};
use crate::report::chart::{Chart, Glyphs, draw};
use crate::report::table::Table;
use crate::report::text::{Page, WIDTH, inputs};

/// Lines of a picture and of a chart.
const LINES: usize = 18;

/// The report of a ropeway with the cargo where the readings have it: picture, inputs with their standing, readings side by
/// side, the crossing, hauling out, the winch, the cargo's motion. `text` is that of the file.
#[must_use]
pub fn text(worked: &Worked, readings: &Readings, text: &str, glyphs: Glyphs) -> String {
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
    page.block(&picture(worked, readings, (WIDTH, LINES), glyphs));
    let warnings = tables::warnings(worked, readings);
    if !warnings.is_empty() {
        page.heading("Warnings");
        for warning in &warnings {
            page.hanging("! ", warning);
        }
    }
    page.heading("Readings");
    table(&mut page, &tables::readings(worked, readings));
    table(&mut page, &tables::crossing(worked, 10));
    table(&mut page, &tables::ropes(worked, readings));
    if let Some(check) = tables::check(worked, readings) {
        table(&mut page, &check);
    }
    page.heading("Hauling the rope out");
    chart(&mut page, &motions::hauling_chart(worked), glyphs);
    table(&mut page, &motions::hauling(worked));
    winch(&mut page, worked, glyphs);
    page.heading("The cargo's motion");
    table(&mut page, &motions::cargo(worked));
    let (over, beside) = motions::full(worked);
    chart(&mut page, &over, glyphs);
    table(&mut page, &beside);
    inputs(
        &mut page,
        &edit::rows(text),
        !about.source.trim().is_empty(),
    );
    page.finish()
}

fn winch(page: &mut Page, worked: &Worked, glyphs: Glyphs) {
    page.heading("The ship moves");
    let Some(series) = worked.series() else {
        page.paragraph("The file gives the ship no motion; [motion] does.");
        return;
    };
    match worked.follow(&series) {
        Ok(followed) => {
            chart(page, &motions::winch_chart(&followed), glyphs);
            table(page, &motions::winch(worked, &followed));
        }
        Err(trouble) => page.paragraph(&format!("No answer: {trouble}.")),
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
