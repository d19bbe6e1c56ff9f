//! What lies over a plot besides its series: reference lines with their names, and the cursor.

use std::ops::Range;

use unicode_width::UnicodeWidthStr;

use super::picture::{Picture, PicturePart, PlotFrame};
use super::{Chart, Glyphs, LimitLine};

/// Reference lines and areas, to be drawn before the series.
pub(super) fn limits(chart: &Chart, frame: PlotFrame, glyphs: Glyphs, on: &mut Picture) {
    let [across, up, area] = match glyphs {
        Glyphs::Ascii => ['-', ':', '='],
        Glyphs::Braille => ['╌', '╎', '░'],
    };
    for limit in &chart.limits {
        let (columns, rows, ch) = match limit.line {
            LimitLine::Horizontal(y) | LimitLine::Bound(y) => {
                let row = frame.row_of(y);
                (0..frame.width, row.map_or(0..0, |r| r..r + 1), across)
            }
            LimitLine::Vertical(x) => {
                let column = frame.column_of(x);
                (column.map_or(0..0, |c| c..c + 1), 0..frame.height, up)
            }
            LimitLine::Band { x, y } => match band(x, y, &frame) {
                Some((columns, rows)) => (columns, rows, area),
                None => continue,
            },
        };
        for row in rows {
            for column in columns.clone() {
                on.put(frame.left + column, frame.top + row, ch, PicturePart::Limit);
            }
        }
    }
}

/// Columns and rows of an area, as far as they are inside the plot.
fn band(x: (f64, f64), y: (f64, f64), frame: &PlotFrame) -> Option<(Range<usize>, Range<usize>)> {
    let inside = |(low, high): (f64, f64), (from, to): (f64, f64)| {
        let seen = (low.max(from), high.min(to));
        (seen.0 <= seen.1).then_some(seen)
    };
    let (left, right) = inside(x, frame.x)?;
    let (low, high) = inside(y, frame.y)?;
    let columns = frame.column_of(left)?..frame.column_of(right)? + 1;
    let rows = frame.row_of(high)?..frame.row_of(low)? + 1;
    Some((columns, rows))
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
pub(super) fn names(chart: &Chart, frame: PlotFrame, glyphs: Glyphs, on: &mut Picture) {
    for limit in &chart.limits {
        let label = match limit.line {
            LimitLine::Bound(y) if frame.row_of(y).is_none() => {
                beyond(&limit.label, y, &frame, glyphs)
            }
            _ => limit.label.clone(),
        };
        let wide = label.width();
        if wide == 0 || wide > frame.width {
            continue;
        }
        let columns: Vec<usize> = (0..=frame.width - wide).rev().collect();
        let place = match limit.line {
            LimitLine::Horizontal(y) => frame.row_of(y).and_then(|row| {
                let rows = [Some(row), row.checked_sub(1), Some(row + 1)];
                free(&columns, rows.into_iter().flatten(), wide, frame, on)
            }),
            LimitLine::Bound(y) => {
                let row = frame.row_of(y);
                let edge = if y > frame.y.1 { 0 } else { frame.height - 1 };
                let rows = match row {
                    Some(row) => [Some(row), row.checked_sub(1), Some(row + 1)],
                    // Several lie beyond one edge.
                    None if edge == 0 => [Some(0), Some(1), Some(2)],
                    None => [Some(edge), edge.checked_sub(1), edge.checked_sub(2)],
                };
                free(&columns, rows.into_iter().flatten(), wide, frame, on)
            }
            LimitLine::Band { x, y } => band(x, y, &frame).and_then(|(across, up)| {
                let last = across.end.saturating_sub(wide).min(frame.width - wide);
                let columns: Vec<usize> = (across.start.min(last)..=last).rev().collect();
                let rows = [up.start.checked_sub(1), Some(up.end)];
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
                &label,
                PicturePart::Limit,
            );
        }
    }
}

/// The name of a bound beyond the plot, with the way to it.
fn beyond(label: &str, y: f64, frame: &PlotFrame, glyphs: Glyphs) -> String {
    if label.is_empty() {
        return String::new();
    }
    let way = match (y > frame.y.1, glyphs) {
        (true, Glyphs::Braille) => '↑',
        (false, Glyphs::Braille) => '↓',
        (true, Glyphs::Ascii) => '^',
        (false, Glyphs::Ascii) => 'v',
    };
    format!("{way} {label}")
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
