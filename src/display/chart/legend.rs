//! The legend: which line is which, by a sample that carries the series' marker.

use unicode_width::UnicodeWidthStr;

use super::canvas::ink;
use super::picture::{Picture, PicturePart};
use super::{Chart, Glyphs, Series, marker};

/// Columns of a sample of a line, and the blank after it.
const SAMPLE: usize = 4;

/// Columns between entries.
const GAP: usize = 3;

/// Positions of the entries of a legend.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct LegendLayout {
    /// Series by number, with row and column.
    entries: Vec<(usize, usize, usize)>,
    /// How many found no place, and where that is said: row and column.
    more: Option<(usize, usize, usize)>,
}

impl LegendLayout {
    /// Rows used.
    pub(super) fn rows(&self) -> usize {
        self.entries.last().map_or(0, |(_, row, _)| row + 1)
    }
}

/// Sets the entries one after the other into rows, the first beginning after `indent` columns, the
/// others at the left. What does not fit whole is left out and counted.
pub(super) fn flow(chart: &Chart, width: usize, indent: usize, rows: usize) -> LegendLayout {
    let mut flow = LegendLayout::default();
    let (mut row, mut column) = (0, indent);
    let mut left_out = 0;
    for (number, series) in chart.series.iter().enumerate() {
        let wide = SAMPLE + series.label.width();
        if column > 0 && column + wide > width {
            (row, column) = (row + 1, 0);
        }
        if row >= rows || wide > width {
            left_out += 1;
            continue;
        }
        flow.entries.push((number, row, column));
        column += wide + GAP;
    }
    if left_out > 0 {
        let text = more(left_out).width();
        let (last, end) = flow
            .entries
            .last()
            .map_or((0, indent), |(number, row, column)| {
                let label = chart.series.get(*number).map_or(0, |s| s.label.width());
                (*row, column + SAMPLE + label + GAP)
            });
        if end + text <= width && last < rows {
            flow.more = Some((left_out, last, end));
        }
    }
    flow
}

/// Draws the entries.
pub(super) fn draw(
    chart: &Chart,
    flow: &LegendLayout,
    top: usize,
    glyphs: Glyphs,
    on: &mut Picture,
) {
    for (number, row, column) in &flow.entries {
        let Some(series) = chart.series.get(*number) else {
            continue;
        };
        on.write(
            *column,
            top + row,
            &sample(series, glyphs),
            sample_ink(series),
        );
        on.write(
            column + SAMPLE,
            top + row,
            &series.label,
            PicturePart::Legend,
        );
    }
    if let Some((count, row, column)) = flow.more {
        on.write(column, top + row, &more(count), PicturePart::Legend);
    }
}

fn more(count: usize) -> String {
    format!("and {count} more")
}

/// Three cells as the line is drawn; a hidden series has an empty bracket instead.
fn sample(series: &Series, glyphs: Glyphs) -> String {
    let marker = marker(series.slot);
    let side = match (series.visible, series.dimmed, glyphs) {
        (false, _, _) => return "[ ]".to_owned(),
        (true, false, Glyphs::Braille) => '⠒',
        (true, true, Glyphs::Braille) => '⠂',
        (true, false, Glyphs::Ascii) => marker,
        (true, true, Glyphs::Ascii) => '.',
    };
    format!("{side}{marker}{side}")
}

fn sample_ink(series: &Series) -> PicturePart {
    if series.visible {
        ink(series)
    } else {
        PicturePart::Legend
    }
}
