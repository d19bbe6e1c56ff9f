//! A ship as a text report on 80 columns.

use super::{charts, coupled, motion, plan, rope, statics};
use crate::report::chart::{Chart, Glyphs, draw};
use crate::report::table::Table;
use crate::report::text::{self, Page, WIDTH, inputs};
use crate::ship::rope::RopeAnalysis;
use crate::ship::{DynamicAnalysis, Equilibrium, MotionAnalysis, StaticAnalysis};
use crate::ship::{edit, validation};

/// Lines of a chart, and of the ship from above.
const LINES: usize = 18;
const PLAN: usize = 34;

/// The report of a ship: from above, headings in balance with what becomes of small motions, loads, mooring; its motions and
/// spectra; ship and anchor line in time; the rope; validation; inputs with their standing. `text` is that of the file; what
/// is still to be worked out at sea is said to be.
#[must_use]
pub fn text(
    statics: &StaticAnalysis,
    sea: Option<&DynamicAnalysis>,
    text: &str,
    glyphs: Glyphs,
) -> String {
    let particulars = &statics.ship.particulars;
    let mut page = Page::default();
    page.title(&particulars.title);
    for prose in [&particulars.source, &particulars.notes] {
        if !prose.trim().is_empty() {
            page.line("");
            page.paragraph(prose);
        }
    }
    page.heading("At rest");
    page.line("");
    page.block(&draw(&plan::chart(statics, chosen(statics)), WIDTH, PLAN, glyphs).to_text());
    chart(&mut page, &charts::moments(statics), glyphs);
    table(&mut page, &statics::headings(statics));
    for one in [
        statics::small_motions(statics),
        statics::loads(statics),
        statics::mooring(statics),
    ]
    .into_iter()
    .flatten()
    {
        table(&mut page, &one);
    }
    match sea {
        Some(sea) => at_sea(&mut page, statics, sea, glyphs),
        None => page.paragraph("The ship at sea is still being worked out."),
    }
    let motion = sea.and_then(|sea| sea.motion.as_ref());
    if !statics.ship.published.is_empty() {
        page.heading("Validation");
        page.line("");
        page.block(&text::validation(&validation::rows(&statics.ship, motion)));
    }
    inputs(
        &mut page,
        &edit::rows(text),
        !particulars.source.trim().is_empty(),
    );
    page.finish()
}

/// The place of the heading at which the ship is most likely found, among all.
#[must_use]
pub fn chosen(statics: &StaticAnalysis) -> usize {
    let equilibria = statics.equilibria.as_deref().unwrap_or_default();
    let found = statics.governing();
    let same = |one: &Equilibrium| found.is_some_and(|found| std::ptr::eq(one, found));
    equilibria.iter().position(same).unwrap_or(0)
}

fn at_sea(page: &mut Page, statics: &StaticAnalysis, sea: &DynamicAnalysis, glyphs: Glyphs) {
    match (&sea.motion, &statics.ship.motion) {
        (Some(Ok(motion)), Some(settings)) => motion_section(page, motion, settings.seed(), glyphs),
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
                chart(page, &coupled::motions(coupled), glyphs);
                chart(page, &coupled::tension(coupled), glyphs);
                table(page, &coupled::statistics(coupled));
                table(page, &coupled::decay(coupled));
            }
            Err(why) => page.hanging("! ", &format!("No answer: {why}.")),
        }
    }
    if let Some(rope) = &sea.rope {
        page.heading("The rope at the moving ship");
        match rope {
            Ok(rope) => rope_section(page, rope, glyphs),
            Err(why) => page.hanging("! ", &format!("The rope does not follow the ship: {why}.")),
        }
    }
}

/// The motion: first minutes drawn, statistics, spectra.
fn motion_section(page: &mut Page, motion: &MotionAnalysis, seed: u64, glyphs: Glyphs) {
    page.heading("Motion");
    chart(page, &charts::motions(motion, None), glyphs);
    table(page, &motion::statistics(motion, seed));
    table(page, &motion::spectra(motion));
}

fn rope_section(page: &mut Page, rope: &RopeAnalysis, glyphs: Glyphs) {
    chart(page, &rope::chart(rope), glyphs);
    table(page, &rope::table(rope));
    if let Some(over) = rope::dynamic_chart(rope) {
        chart(page, &over, glyphs);
    }
    if let Some(beside) = rope::dynamic_table(rope) {
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
