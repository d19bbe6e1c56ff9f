//! Small strokes: text into cells, lists with a cursor, frames.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::symbols::border;
use ratatui::widgets::{Block, Clear, Widget};
use unicode_width::UnicodeWidthStr;

use crate::report::chart::Glyphs;
use crate::report::plain::ascii;
use crate::visible;

/// Writes text from a column on, at most so many columns; returns the column after it.
pub(in crate::tui) fn text(
    buf: &mut Buffer,
    at: (u16, u16),
    width: u16,
    words: &str,
    style: Style,
) -> u16 {
    if !buf.area().contains(at.into()) {
        return at.0;
    }
    let (x, _) = buf.set_stringn(at.0, at.1, visible::line(words), width.into(), style);
    x
}

/// Writes text that ends at the right edge of a line.
pub(in crate::tui) fn right(buf: &mut Buffer, line: Rect, words: &str, style: Style) {
    let width = u16::try_from(words.width())
        .unwrap_or(u16::MAX)
        .min(line.width);
    text(buf, (line.right() - width, line.y), width, words, style);
}

/// A row of an area, counted from the top.
pub(in crate::tui) fn row(area: Rect, index: u16) -> Rect {
    if index >= area.height {
        return Rect::new(area.x, area.y, 0, 0);
    }
    Rect::new(area.x, area.y + index, area.width, 1)
}

/// The first line to show so that the cursor is seen, with lines around it where there are any.
pub(in crate::tui) fn first_line(cursor: usize, lines: usize, height: usize) -> usize {
    cursor
        .saturating_sub(height / 2)
        .min(lines.saturating_sub(height))
}

/// The characters of frames.
pub(in crate::tui) fn border(glyphs: Glyphs) -> border::Set<'static> {
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
pub(in crate::tui) fn framed(
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
pub(in crate::tui) fn over(
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
pub(in crate::tui) fn wrap(words: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines = Vec::new();
    for paragraph in words.lines() {
        let mut line = String::new();
        for word in paragraph.split(' ') {
            let mut word = word;
            if !line.is_empty() && line.width() + 1 + word.width() > width {
                lines.push(std::mem::take(&mut line));
            } else if !line.is_empty() {
                line.push(' ');
            }
            while line.is_empty() && word.width() > width {
                let cut = word
                    .char_indices()
                    .map(|(i, c)| i + c.len_utf8())
                    .take_while(|end| word[..*end].width() <= width)
                    .last()
                    .or_else(|| word.chars().next().map(char::len_utf8))
                    .unwrap_or(word.len());
                lines.push(word[..cut].to_owned());
                word = &word[cut..];
            }
            line.push_str(word);
        }
        lines.push(line);
    }
    lines
}

/// Replaces what ASCII lacks, on the whole screen: text of case files may hold anything.
pub(in crate::tui) fn only_ascii(buf: &mut Buffer) {
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
    fn words_are_kept_whole_where_they_fit() {
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("abcdefghij k", 4), ["abcd", "efgh", "ij k"]);
        assert_eq!(wrap("a\n\nb", 9), ["a", "", "b"]);
        assert_eq!(wrap("日本語", 2), ["日", "本", "語"]);
        assert_eq!(wrap("日", 1), ["日", ""]);
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
