//! What lies over a plot besides its series: reference lines with their names, and the cursor.

use unicode_width::UnicodeWidthStr;

use super::picture::{Picture, PicturePart, PlotFrame};
use super::{Chart, Glyphs, LimitLine};

/// Reference lines, to be drawn before the series.
pub(super) fn limits(chart: &Chart, frame: PlotFrame, glyphs: Glyphs, on: &mut Picture) {
    let ascii = glyphs == Glyphs::Ascii;
    for limit in &chart.limits {
        match limit.line {
            LimitLine::Horizontal(y) => {
                let Some(row) = frame.row_of(y) else { continue };
                for column in 0..frame.width {
                    let ch = if ascii { '-' } else { '╌' };
                    on.put(frame.left + column, frame.top + row, ch, PicturePart::Limit);
                }
            }
            LimitLine::Vertical(x) => {
                let Some(column) = frame.column_of(x) else {
                    continue;
                };
                for row in 0..frame.height {
                    let ch = if ascii { ':' } else { '╎' };
                    on.put(frame.left + column, frame.top + row, ch, PicturePart::Limit);
                }
            }
        }
    }
}

/// The cursor: a line from bottom to top, and a mark on the axis that no series can hide; on a map a line across as well.
pub(super) fn cursor(
    chart: &Chart,
    frame: PlotFrame,
    axis: Option<usize>,
    glyphs: Glyphs,
    on: &mut Picture,
) {
    let Some(column) = chart.cursor.and_then(|x| frame.column_of(x)) else {
        return;
    };
    let (line, mark) = match glyphs {
        Glyphs::Ascii => ('|', '^'),
        Glyphs::Braille => ('┃', '╋'),
    };
    for row in 0..frame.height {
        on.put(
            frame.left + column,
            frame.top + row,
            line,
            PicturePart::Cursor,
        );
    }
    if let Some(row) = chart.cursor_y.and_then(|y| frame.row_of(y)) {
        let across = if glyphs == Glyphs::Ascii { '-' } else { '━' };
        for column in 0..frame.width {
            on.put(
                frame.left + column,
                frame.top + row,
                across,
                PicturePart::Cursor,
            );
        }
        on.put(
            frame.left + column,
            frame.top + row,
            mark,
            PicturePart::Cursor,
        );
    }
    if let Some(row) = axis {
        on.put(frame.left + column, row, mark, PicturePart::Cursor);
    }
}

/// Writes the names of reference lines where they hide no series; the right end is tried first.
pub(super) fn names(chart: &Chart, frame: PlotFrame, on: &mut Picture) {
    for limit in &chart.limits {
        let wide = limit.label.width();
        if wide == 0 || wide > frame.width {
            continue;
        }
        let columns: Vec<usize> = (0..=frame.width - wide).rev().collect();
        let place = match limit.line {
            LimitLine::Horizontal(y) => frame.row_of(y).and_then(|row| {
                let rows = [Some(row), row.checked_sub(1), Some(row + 1)];
                free(&columns, rows.into_iter().flatten(), wide, frame, on)
            }),
            LimitLine::Vertical(x) => frame.column_of(x).and_then(|column| {
                // Right of the line, else left of it.
                let beside = [Some(column + 1), column.checked_sub(wide)];
                let beside: Vec<usize> = beside.into_iter().flatten().collect();
                free(&beside, 0..frame.height, wide, frame, on)
            }),
        };
        if let Some((column, row)) = place {
            on.write(
                frame.left + column,
                frame.top + row,
                &limit.label,
                PicturePart::Limit,
            );
        }
    }
}

/// The first of the places where a name covers neither a series, nor the cursor, nor another name.
fn free(
    columns: &[usize],
    rows: impl Iterator<Item = usize>,
    wide: usize,
    frame: PlotFrame,
    on: &Picture,
) -> Option<(usize, usize)> {
    let is_free = |column: usize, row: usize| {
        let cell = on.get(frame.left + column, frame.top + row);
        cell.is_some_and(|cell| match cell.ink {
            PicturePart::Blank => true,
            PicturePart::Limit => matches!(cell.ch, '-' | '╌'),
            _ => false,
        })
    };
    let fits = |column: usize, row: usize| {
        let inside = column + wide <= frame.width && row < frame.height;
        inside && (column..column + wide).all(|c| is_free(c, row))
    };
    rows.flat_map(|row| columns.iter().map(move |column| (*column, row)))
        .find(|(column, row)| fits(*column, *row))
}
