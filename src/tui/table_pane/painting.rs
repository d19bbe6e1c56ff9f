//! The lines of a table on the screen.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthChar;

use crate::chart::Glyphs;
use crate::plain;
use crate::table::{LineKind, TableLayout, TableLine};
use crate::theme::Theme;

/// Columns of text by which a long cell is shown further, where cells are below each other.
pub(super) const STEP: usize = 8;

/// The lines that fit: title and heads, then as much of the body as has room, around the selection.
pub(super) fn in_sight(
    layout: &TableLayout,
    selected: usize,
    room: usize,
) -> impl Iterator<Item = &TableLine> {
    let is_top =
        |line: &&TableLine| matches!(line.kind, LineKind::Title | LineKind::Head | LineKind::Rule);
    let mut top = layout.lines.iter().take_while(is_top).count();
    // A body without a single line of room is worse than a table without heads.
    if top >= room {
        top = 0;
    }
    let (heads, body) = layout.lines.split_at(top);
    let room = room - top;
    let of_selected = |line: &TableLine| line.kind == LineKind::Row(selected);
    let first = body.iter().position(of_selected).unwrap_or(0);
    let last = body.iter().rposition(of_selected).unwrap_or(0);
    let middle = first.midpoint(last);
    let start = middle
        .saturating_sub(room / 2)
        .min(body.len().saturating_sub(room))
        // Of a row taller than the screen the beginning counts.
        .min(first);
    heads.iter().chain(body.iter().skip(start).take(room))
}

/// Paints a line, without its first `hidden` columns.
pub(super) fn draw_line(
    line: &TableLine,
    hidden: usize,
    place: Rect,
    buf: &mut Buffer,
    glyphs: Glyphs,
    theme: Theme,
) {
    let width = usize::from(place.width);
    let mut column = 0_usize;
    for piece in &line.pieces {
        let style = match line.kind {
            LineKind::Title => theme.chart(crate::chart::PicturePart::Title),
            LineKind::Head => theme.strong(),
            _ => theme.cell(piece.ink),
        };
        let text = match glyphs {
            Glyphs::Braille => piece.text.as_str().into(),
            Glyphs::Ascii => plain::ascii(&piece.text),
        };
        for ch in text.chars() {
            let wide = ch.width().unwrap_or(0);
            let shown = column.checked_sub(hidden).filter(|at| at + wide <= width);
            if let Some(at) = shown.and_then(|at| u16::try_from(at).ok()) {
                let (x, y) = (place.x + at, place.y);
                // Most letters take one cell, and need no search for their graphemes.
                match buf
                    .cell_mut((x, y))
                    .filter(|_| ch.is_ascii_graphic() || ch == ' ')
                {
                    Some(cell) => _ = cell.set_char(ch).set_style(style),
                    None => _ = buf.set_stringn(x, y, ch.to_string(), wide, style),
                }
            }
            column += wide;
        }
    }
}
