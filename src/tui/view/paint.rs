//! Small strokes: text into cells, lists with a cursor, frames.

use std::borrow::Cow;
use std::ops::Range;

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;
use ratatui::symbols::border;
use ratatui::widgets::{Block, Clear, Widget};
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use crate::chart::Glyphs;
use crate::plain::ascii;
use crate::visible;
use crate::wrap::WideWords;

/// Writes text from a column on, at most so many columns; returns the column after it.
pub(crate) fn text(buf: &mut Buffer, at: (u16, u16), width: u16, words: &str, style: Style) -> u16 {
    if !buf.area().contains(at.into()) {
        return at.0;
    }
    let words = visible::line(words);
    if words.is_ascii() {
        return ascii_text(buf, at, width, &words, style);
    }
    let (x, _) = buf.set_stringn(at.0, at.1, words, width.into(), style);
    x
}

/// Text of one cell for each byte: most of a screen is that, and a search for its graphemes takes a tenth of a frame.
fn ascii_text(buf: &mut Buffer, at: (u16, u16), width: u16, words: &str, style: Style) -> u16 {
    let end = at.0.saturating_add(width).min(buf.area().right());
    let mut x = at.0;
    for (c, column) in words
        .chars()
        .filter(|c| !c.is_ascii_control())
        .zip(at.0..end)
    {
        if let Some(cell) = buf.cell_mut((column, at.1)) {
            cell.set_char(c).set_style(style);
        }
        x = column + 1;
    }
    x
}

/// The text as far as it fits, with a mark at its end where it is cut.
pub(crate) fn cut(words: &str, width: usize, glyphs: Glyphs) -> Cow<'_, str> {
    // What is only blank at its end loses nothing.
    if words.width() <= width || words.trim_end().width() <= width {
        return Cow::Borrowed(words);
    }
    let mark = match glyphs {
        Glyphs::Braille => "…",
        Glyphs::Ascii if width > 20 => "...",
        Glyphs::Ascii => "~",
    };
    let room = width.saturating_sub(mark.width());
    let mut used = 0;
    let fits = |c: &char| {
        used += c.width().unwrap_or(0);
        used <= room
    };
    let kept: String = words.chars().take_while(fits).collect();
    Cow::Owned(format!("{kept}{mark}"))
}

/// The tabs that are seen of those of these widths: all, or as many as fit around the selected one beside the marks that there
/// are more.
pub(crate) fn tabs_seen(widths: &[usize], selected: usize, room: usize) -> Range<usize> {
    let needed = |seen: &Range<usize>| {
        let columns = widths[seen.clone()].iter().sum::<usize>() + usize::from(seen.start > 0);
        // The blank behind the last of all is not needed.
        match seen.end < widths.len() {
            true => columns + 1,
            false => columns.saturating_sub(1),
        }
    };
    let mut seen = 0..widths.len();
    while needed(&seen) > room && seen.end > selected + 1 {
        seen.end -= 1;
    }
    while needed(&seen) > room && seen.start < selected {
        seen.start += 1;
    }
    seen
}

/// Writes text that ends at the right edge of a line.
pub(crate) fn right(buf: &mut Buffer, line: Rect, words: &str, style: Style) {
    let width = u16::try_from(words.width())
        .unwrap_or(u16::MAX)
        .min(line.width);
    text(buf, (line.right() - width, line.y), width, words, style);
}

/// A row of an area, counted from the top.
pub(crate) fn row(area: Rect, index: u16) -> Rect {
    if index >= area.height {
        return Rect::new(area.x, area.y, 0, 0);
    }
    Rect::new(area.x, area.y + index, area.width, 1)
}

/// A part of a line: from so many columns after its beginning, at most so wide.
pub(crate) fn span(line: Rect, from: u16, width: u16) -> Rect {
    Rect::new(line.x.saturating_add(from), line.y, width, line.height).intersection(line)
}

/// The rest of a line from a column of the screen on.
pub(crate) fn rest(line: Rect, column: u16) -> Rect {
    span(line, column.saturating_sub(line.x), u16::MAX)
}

/// The first row of an area, and the others.
pub(crate) fn below_head(area: Rect) -> [Rect; 2] {
    Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area)
}

/// The first line to show so that the cursor is seen, with lines around it where there are any.
pub(crate) fn first_line(cursor: usize, lines: usize, height: usize) -> usize {
    cursor
        .saturating_sub(height / 2)
        .min(lines.saturating_sub(height))
}

/// The characters of frames.
pub(crate) fn border(glyphs: Glyphs) -> border::Set<'static> {
    match glyphs {
        Glyphs::Braille => border::PLAIN,
        Glyphs::Ascii => border::Set {
            top_left: "+",
            top_right: "+",
            bottom_left: "+",
            bottom_right: "+",
            vertical_left: "|",
            vertical_right: "|",
            horizontal_top: "-",
            horizontal_bottom: "-",
        },
    }
}

/// A frame with a title; returns its inside.
pub(crate) fn framed(
    buf: &mut Buffer,
    area: Rect,
    title: &str,
    glyphs: Glyphs,
    style: Style,
) -> Rect {
    let block = Block::bordered()
        .border_set(border(glyphs))
        .border_style(style)
        .title(format!(" {} ", visible::line(title)));
    let inside = block.inner(area);
    block.render(area, buf);
    inside
}

/// A box over the middle of the screen, at most so large; returns its inside.
pub(crate) fn over(
    buf: &mut Buffer,
    screen: Rect,
    size: (u16, u16),
    title: &str,
    glyphs: Glyphs,
    style: Style,
) -> Rect {
    let (width, height) = (size.0.min(screen.width), size.1.min(screen.height));
    let area = Rect::new(
        screen.x + (screen.width - width) / 2,
        screen.y + (screen.height - height) / 2,
        width,
        height,
    );
    Clear.render(area, buf);
    framed(buf, area, title, glyphs, style)
}

/// Breaks text into lines of a width, between words where it can.
pub(crate) fn wrap(words: &str, width: usize) -> Vec<String> {
    crate::wrap::wrap(words, width, WideWords::Broken)
}

/// Replaces what ASCII lacks, on the whole screen: text of case files may hold anything.
pub(crate) fn only_ascii(buf: &mut Buffer) {
    for cell in &mut buf.content {
        if !cell.symbol().is_ascii() {
            let first = ascii(cell.symbol()).chars().next().unwrap_or('?');
            cell.set_char(first);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cut_text_ends_with_a_mark() {
        assert_eq!(cut("as it is", 8, Glyphs::Braille), "as it is");
        assert_eq!(cut("longer than that", 8, Glyphs::Braille), "longer …");
        assert_eq!(cut("longer than that", 8, Glyphs::Ascii), "longer ~");
        assert_eq!(cut("深海ケーブル", 5, Glyphs::Braille), "深海…");
        assert_eq!(cut("blank    ", 6, Glyphs::Braille), "blank    ");
    }

    #[test]
    fn the_selected_tab_is_always_seen() {
        let widths = [9, 10, 7, 13, 9, 7, 8, 8];
        for room in 15..80 {
            for selected in 0..widths.len() {
                let seen = tabs_seen(&widths, selected, room);
                assert!(seen.contains(&selected), "{selected} in {room}: {seen:?}");
                assert!(widths[seen].iter().sum::<usize>() <= room + 1);
            }
        }
        assert_eq!(tabs_seen(&widths, 3, 70), 0..8);
    }

    #[test]
    fn the_cursor_is_always_seen() {
        for lines in 0..30 {
            for height in 1..12 {
                for cursor in 0..lines {
                    let first = first_line(cursor, lines, height);
                    assert!((first..first + height).contains(&cursor));
                }
            }
        }
    }
}
