//! What the user does with a table: select, scroll, sort.
//!
//! [`TablePane`] is plain state over a [`Table`] that comes from elsewhere. [`TablePane::act`]
//! changes it, [`TablePane::draw`] paints the table as the user has it.

mod layout_memo;

use std::cmp::Ordering;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthChar;

use self::layout_memo::LayoutMemo;
use super::theme::Theme;
use crate::report::chart::Glyphs;
use crate::report::plain;
use crate::report::table::{LineKind, Table, TableLayout, TableLine};

/// What can be done with a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableVerb {
    /// Selection down by so many rows, or up where negative.
    Select(isize),
    /// Show what lies so many columns of text further right.
    Scroll(isize),
    /// Sort by the next column; after the last: as it came.
    Sort,
}

/// The furthest that a table is scrolled sideways.
const LAST_COLUMN: usize = 1000;

/// A table as the user has it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TablePane {
    /// The selected row, in the order shown.
    selected: usize,
    /// Columns hidden at the left.
    right: usize,
    /// Column sorted by.
    sort: Option<usize>,
    memo: LayoutMemo,
}

impl TablePane {
    /// The selected row by its number in the whole table; absent when there is none.
    #[must_use]
    pub fn selected(&self, table: &Table) -> Option<usize> {
        let last = table.rows.len().saturating_sub(1);
        self.rows(table).get(self.selected.min(last)).copied()
    }

    /// Does what the user asked for.
    pub fn act(&mut self, verb: TableVerb, table: &Table) {
        let last = table.rows.len().saturating_sub(1);
        match verb {
            TableVerb::Select(by) => {
                let at = self.selected.min(last).saturating_add_signed(by);
                self.selected = at.min(last);
            }
            TableVerb::Scroll(by) => {
                self.right = self.right.saturating_add_signed(by).min(LAST_COLUMN);
            }
            TableVerb::Sort => {
                let next = self.sort.map_or(0, |column| column + 1);
                self.sort = (next < table.columns.len()).then_some(next);
            }
        }
    }

    /// Numbers of the rows in the order shown.
    fn rows(&self, table: &Table) -> Vec<usize> {
        let mut rows: Vec<usize> = (0..table.rows.len()).collect();
        if let Some(column) = self.sort {
            let text = |row: usize| table.cell(row, column).text;
            rows.sort_by(|a, b| compare(&text(*a), &text(*b)));
        }
        rows
    }

    /// The table sorted.
    fn sorted(&self, table: &Table) -> Table {
        let rows = self.rows(table);
        let mut sorted = table.clone();
        sorted.rows = rows.iter().map(|row| table.rows[*row].clone()).collect();
        if let Some(column) = self.sort.and_then(|i| sorted.columns.get_mut(i)) {
            column.head.push_str(" (up)");
        }
        sorted
    }

    /// Paints the table into an area of the screen: heads stay at the top, the selected row is in
    /// sight, notes follow the last row.
    pub fn draw(&self, table: &Table, area: Rect, buf: &mut Buffer, glyphs: Glyphs, theme: Theme) {
        let area = area.intersection(*buf.area());
        let width = area.width.into();
        let lay_out = || self.sorted(table).layout(width);
        let layout = self.memo.of(table, self.sort, width, lay_out);
        let selected = self.selected.min(table.rows.len().saturating_sub(1));
        let hidden = self
            .right
            .min(layout.width.saturating_sub(area.width.into()));
        for (line, row) in in_sight(&layout, selected, area.height.into()).zip(area.top()..) {
            let place = Rect::new(area.x, row, area.width, 1);
            let is_selected = line.kind == LineKind::Row(selected);
            draw_line(line, hidden, place, buf, glyphs, theme);
            if is_selected {
                buf.set_style(place, theme.selected());
            }
        }
    }
}

/// Numbers by their value and before words, words by their letters. A cell is a number when it
/// begins with one; a prefix of its unit counts.
fn compare(a: &str, b: &str) -> Ordering {
    match (number(a), number(b)) {
        (Some(a), Some(b)) => a.total_cmp(&b),
        (Some(_), None) => Ordering::Less,
        (None, Some(_)) => Ordering::Greater,
        (None, None) => a.to_lowercase().cmp(&b.to_lowercase()),
    }
}

/// The value of a cell such as `-1.96 MN ± 0.01`.
fn number(text: &str) -> Option<f64> {
    let mut words = text.split_whitespace();
    let value: f64 = words.next()?.parse().ok()?;
    let factor = match words.next() {
        Some("kN" | "kPa" | "kW" | "kJ") => 1e3,
        Some("MN" | "MPa" | "MW" | "MJ") => 1e6,
        Some("GN" | "GPa" | "GW" | "GJ") => 1e9,
        Some("ms") => 1e-3,
        _ => 1.0,
    };
    Some(value * factor)
}

/// The lines that fit: title and heads, then as much of the body as has room, around the selection.
fn in_sight(
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
fn draw_line(
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
            LineKind::Title => theme.chart(crate::report::chart::PicturePart::Title),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::table::{Align, Cell, CellStyle};
    use ratatui::style::Modifier;

    fn table() -> Table {
        let rows = [
            ("vessel|chain", "3.94 MN ± 0.01", "PASS", CellStyle::Good),
            ("wire|payload", "763 kN", "FAIL", CellStyle::Bad),
            ("chain|polyester", "3.88 MN", "PASS", CellStyle::Good),
            ("polyester|wire", "not run", "NOT RUN", CellStyle::Dim),
        ];
        Table::of("Joints", &rows)
            .text("joint", |row| row.0)
            .cell("tension", Align::Decimal, |row| Cell::plain(row.1))
            .cell("outcome", Align::Left, |row| Cell::new(row.2, row.3))
            .build()
            .noted(["One note."])
    }

    fn text(buf: &Buffer) -> Vec<String> {
        let width = usize::from(buf.area().width);
        let rows = buf.content().chunks(width);
        rows.map(|row| {
            row.iter()
                .map(ratatui::buffer::Cell::symbol)
                .collect::<String>()
        })
        .map(|line| line.trim_end().to_owned())
        .collect()
    }

    fn drawn(pane: &TablePane, table: &Table, width: u16, height: u16) -> Buffer {
        let mut buf = Buffer::empty(Rect::new(0, 0, width, height));
        let area = *buf.area();
        pane.draw(table, area, &mut buf, Glyphs::Braille, Theme::default());
        buf
    }

    #[test]
    fn sorting_knows_prefixes_and_puts_words_last() {
        let (table, mut pane) = (table(), TablePane::default());
        pane.act(TableVerb::Sort, &table);
        assert_eq!(pane.rows(&table), [2, 3, 0, 1]);
        pane.act(TableVerb::Sort, &table);
        assert_eq!(pane.rows(&table), [1, 2, 0, 3]);
        pane.act(TableVerb::Sort, &table);
        pane.act(TableVerb::Sort, &table);
        assert_eq!(pane.rows(&table), [0, 1, 2, 3]);
    }

    #[test]
    fn the_selection_is_a_row_of_the_whole_table() {
        let (table, mut pane) = (table(), TablePane::default());
        pane.act(TableVerb::Sort, &table);
        pane.act(TableVerb::Select(10), &table);
        assert_eq!(pane.selected(&table), Some(1));
        pane.act(TableVerb::Select(-1), &table);
        assert_eq!(pane.selected(&table), Some(0));
        pane.act(TableVerb::Select(isize::MIN / 2), &table);
        assert_eq!(pane.selected(&table), Some(2));
        assert_eq!(pane.selected(&Table::default()), None);
    }

    #[test]
    fn heads_stay_and_the_selected_row_is_in_sight_and_reversed() {
        let (table, mut pane) = (table(), TablePane::default());
        pane.act(TableVerb::Select(isize::MAX / 2), &table);
        let buf = drawn(&pane, &table, 60, 5);
        let lines = text(&buf);
        assert!(lines[1].starts_with("joint"), "{lines:?}");
        let at = lines
            .iter()
            .position(|line| line.starts_with("polyester|wire"));
        let at = u16::try_from(at.unwrap()).unwrap();
        assert!(buf[(0, at)].modifier.contains(Modifier::REVERSED));
        assert!(!buf[(0, at - 1)].modifier.contains(Modifier::REVERSED));
    }

    #[test]
    fn no_size_is_too_small() {
        let (table, mut pane) = (table(), TablePane::default());
        pane.act(TableVerb::Scroll(8), &table);
        for width in 0..40 {
            for height in 0..12 {
                let _ = drawn(&pane, &table, width, height);
            }
        }
    }

    #[test]
    fn a_wide_line_can_be_scrolled_to_its_end() {
        let table = Table::of("", &["0123456789"]).count("n", |n| n).build();
        let mut pane = TablePane::default();
        pane.act(TableVerb::Scroll(8), &table);
        // Narrower than the number, so the table is set as records: "n:" above the number.
        let lines = text(&drawn(&pane, &table, 6, 4));
        assert!(lines.iter().any(|line| line == "456789"), "{lines:?}");
    }
}
