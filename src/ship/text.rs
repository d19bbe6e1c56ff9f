//! A ship as a text report on 80 columns.

use super::rest::Rest;
use super::rope::RopeAtSea;
use super::sea::AtSea;
use super::voyage::Voyage;
use super::{coupled_tables, edit, held, motion, picture, plan, rope_tables, tables};
use crate::report::chart::{Chart, Glyphs, draw};
use crate::report::table::Table;
use crate::report::text::{Page, WIDTH, inputs, validation};

/// Lines of a chart, and of the ship from above.
const LINES: usize = 18;
const PLAN: usize = 34;

/// The report of a ship: from above, headings in balance with what becomes of small motions, loads, mooring; its motions and
/// spectra; ship and anchor line in time; the rope; validation; inputs with their standing. `text` is that of the file; what
/// is still to be worked out at sea is said to be.
#[must_use]
pub fn text(rest: &Rest, sea: Option<&AtSea>, text: &str, glyphs: Glyphs) -> String {
    let about = &rest.ship.about;
    let mut page = Page::default();
    page.title(&about.title);
    for words in [&about.source, &about.notes] {
        if !words.trim().is_empty() {
            page.line("");
            page.paragraph(words);
        }
    }
    page.heading("At rest");
    page.line("");
    page.block(&draw(&plan::chart(rest, chosen(rest)), WIDTH, PLAN, glyphs).to_text());
    chart(&mut page, &picture::moments(rest), glyphs);
    table(&mut page, &tables::headings(rest));
    for one in [
        tables::small_motions(rest),
        tables::loads(rest),
        tables::mooring(rest),
    ]
    .into_iter()
    .flatten()
    {
        table(&mut page, &one);
    }
    match sea {
        Some(sea) => at_sea(&mut page, rest, sea, glyphs),
        None => page.paragraph("The ship at sea is still being worked out."),
    }
    let voyage = sea.and_then(|sea| sea.voyage.as_ref());
    if !rest.ship.published.is_empty() {
        page.heading("Validation");
        page.line("");
        page.block(&validation(&held::rows(&rest.ship, voyage)));
    }
    inputs(
        &mut page,
        &edit::rows(text),
        !about.source.trim().is_empty(),
    );
    page.finish()
}

/// The place of the heading at which the ship is most likely found, among all.
#[must_use]
pub fn chosen(rest: &Rest) -> usize {
    let stations = rest.stations.as_deref().unwrap_or_default();
    let found = rest.chosen();
    let same = |one: &super::rest::Station| found.is_some_and(|found| std::ptr::eq(one, found));
    stations.iter().position(same).unwrap_or(0)
}

fn at_sea(page: &mut Page, rest: &Rest, sea: &AtSea, glyphs: Glyphs) {
    match (&sea.voyage, &rest.ship.motion) {
        (Some(Ok(voyage)), Some(words)) => sails(page, voyage, words.seed(), glyphs),
        (Some(Err(why)), _) => {
            page.heading("Motion");
            page.hanging("! ", &format!("The ship has no such motion: {why}."));
        }
        _ => {}
    }
    if let Some(coupled) = &sea.coupled {
        page.heading("Ship and anchor line in time");
        match coupled {
            Ok(coupled) => {
                chart(page, &coupled_tables::motions(coupled), glyphs);
                chart(page, &coupled_tables::tension(coupled), glyphs);
                table(page, &coupled_tables::statistics(coupled));
                table(page, &coupled_tables::decay(coupled));
            }
            Err(why) => page.hanging("! ", &format!("No answer: {why}.")),
        }
    }
    if let Some(rope) = &sea.rope {
        page.heading("The rope at the moving ship");
        match rope {
            Ok(rope) => follows(page, rope, glyphs),
            Err(why) => page.hanging("! ", &format!("The rope does not follow the ship: {why}.")),
        }
    }
}

/// The motion: first minutes drawn, statistics, spectra.
fn sails(page: &mut Page, voyage: &Voyage, seed: u64, glyphs: Glyphs) {
    page.heading("Motion");
    chart(page, &picture::motions(voyage, None), glyphs);
    table(page, &motion::tables::statistics(voyage, seed));
    table(page, &motion::tables::spectra(voyage));
}

fn follows(page: &mut Page, rope: &RopeAtSea, glyphs: Glyphs) {
    chart(page, &rope_tables::chart(rope), glyphs);
    table(page, &rope_tables::table(rope));
    if let Some(over) = rope_tables::dynamic_chart(rope) {
        chart(page, &over, glyphs);
    }
    if let Some(beside) = rope_tables::dynamic_table(rope) {
        table(page, &beside);
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
