//! A ship as text: its charts and tables.

use super::motion::{self, MotionError};
use super::rest::Rest;
use super::rope::RopeAtSea;
use super::voyage::Voyage;
use super::{picture, rope_tables, tables};
use crate::reference::standing_word;
use crate::report::chart::{Glyphs, draw};
use crate::report::table::{Cell, Column, Table};

/// Rows of a chart.
const HEIGHT: usize = 22;

/// The whole ship as text of this width.
#[must_use]
pub fn text(
    rest: &Rest,
    rope: Option<&Result<RopeAtSea, String>>,
    width: usize,
    glyphs: Glyphs,
) -> String {
    let about = &rest.ship.about;
    let mut parts = vec![paragraph(&about.title, width)];
    let words = [&about.source, &about.notes];
    parts.extend(
        words
            .iter()
            .filter(|w| !w.is_empty())
            .map(|w| paragraph(w, width)),
    );
    parts.push(draw(&picture::moments(rest), width, HEIGHT, glyphs).to_text());
    parts.push(tables::headings(rest).to_text(width));
    parts.extend(tables::loads(rest).map(|table| table.to_text(width)));
    parts.extend(tables::mooring(rest).map(|table| table.to_text(width)));
    if let (Some(words), Some(voyage)) = (&rest.ship.motion, &rest.voyage) {
        parts.extend(motion(words.seed(), voyage.as_ref(), width, glyphs));
    }
    match rope {
        Some(Ok(rope)) => parts.extend([
            rope_tables::table(rope).to_text(width),
            draw(&rope_tables::chart(rope), width, HEIGHT, glyphs).to_text(),
        ]),
        Some(Err(why)) => parts.push(paragraph(
            &format!("WARNING: the rope does not follow the ship: {why}."),
            width,
        )),
        None => {}
    }
    if !rest.ship.marks.is_empty() {
        parts.push(marks(rest).to_text(width));
    }
    parts.join("\n")
}

fn paragraph(words: &str, width: usize) -> String {
    let table = Table {
        title: words.split_whitespace().collect::<Vec<_>>().join(" "),
        ..Table::default()
    };
    table.to_text(width)
}

/// The motion: statistics, spectra, and the first minutes drawn.
fn motion(
    seed: u64,
    voyage: Result<&Voyage, &MotionError>,
    width: usize,
    glyphs: Glyphs,
) -> Vec<String> {
    match voyage {
        Err(why) => vec![paragraph(
            &format!("The ship has no such motion: {why}."),
            width,
        )],
        Ok(voyage) => vec![
            motion::tables::statistics(voyage, seed).to_text(width),
            motion::tables::spectra(voyage).to_text(width),
            draw(&picture::motions(voyage), width, HEIGHT, glyphs).to_text(),
        ],
    }
}

/// Where the inputs come from that the source does not print.
fn marks(rest: &Rest) -> Table {
    let rows = rest.ship.marks.iter().map(|(key, mark)| {
        vec![
            Cell::plain(key),
            Cell::plain(standing_word(mark.status)),
            Cell::plain(&mark.reason),
        ]
    });
    Table {
        title: "Inputs that the source does not print".to_owned(),
        columns: vec![
            Column::left("key"),
            Column::left("standing"),
            Column::left("why"),
        ],
        rows: rows.collect(),
        notes: Vec::new(),
    }
}
