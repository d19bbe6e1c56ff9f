//! What the user does with a table: select, scroll, sort, filter.
//!
//! [`TablePane`] is plain state over a [`Table`] that comes from elsewhere. [`TablePane::act`]
//! changes it, [`TablePane::view`] makes the table as the user has it, [`TablePane::draw`] paints
//! that.

use std::cmp::Ordering;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use super::theme::Theme;
use crate::report::chart::Glyphs;
use crate::report::plain;
use crate::report::table::{Layout, Line, LineKind, Table};

/// What can be done with a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableVerb {
    /// Selection up.
    Up,
    /// Selection down.
    Down,
    /// Selection up by a page of so many rows.
    PageUp(usize),
    /// Selection down by a page of so many rows.
    PageDown(usize),
    /// Selection to the first row.
    First,
    /// Selection to the last row.
    Last,
    /// Show what lies further left.
    Left,
    /// Show what lies further right.
    Right,
    /// Sort by a column, counted from 0; again: downwards; a third time: as it came.
    SortBy(usize),
    /// Sort by the next column; after the last: as it came.
    SortNext,
}

/// A table as the user has it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TablePane {
    /// The selected row, among those that pass the filter.
    selected: usize,
    /// Columns hidden at the left.
    right: usize,
    /// Column sorted by, and whether downwards.
    sort: Option<(usize, bool)>,
    filter: String,
}

/// A table as it is to be drawn: sorted and filtered.
#[derive(Debug, Clone, PartialEq)]
pub struct TableView {
    /// The table with the rows that are shown, in their order.
    pub table: Table,
    /// For each of them its number in the table it came from.
    pub rows: Vec<usize>,
}

impl TablePane {
    /// Letters that a row must contain, words in any order and any case; empty shows all rows.
    pub fn set_filter(&mut self, text: &str) {
        text.clone_into(&mut self.filter);
        self.selected = 0;
    }

    /// The filter.
    #[must_use]
    pub fn filter(&self) -> &str {
        &self.filter
    }

    /// Column sorted by, and whether downwards.
    #[must_use]
    pub fn sort(&self) -> Option<(usize, bool)> {
        self.sort
    }

    /// The selected row by its number in the whole table; absent when no row is shown.
    #[must_use]
    pub fn selected(&self, table: &Table) -> Option<usize> {
        let rows = self.rows(table);
        rows.get(self.selected.min(rows.len().saturating_sub(1)))
            .copied()
    }

    /// The table sorted and filtered.
    #[must_use]
    pub fn view(&self, table: &Table) -> TableView {
        let rows = self.rows(table);
        let mut shown = table.clone();
        shown.rows = rows
            .iter()
            .filter_map(|row| table.rows.get(*row).cloned())
            .collect();
        if let Some((column, down)) = self.sort
            && let Some(column) = shown.columns.get_mut(column)
        {
            column.head.push_str(if down { " (down)" } else { " (up)" });
        }
        TableView { table: shown, rows }
    }

    /// Does what the user asked for.
    pub fn act(&mut self, verb: TableVerb, table: &Table) {
        let last = self.rows(table).len().saturating_sub(1);
        let at = self.selected.min(last);
        let by = |rows: usize| at.saturating_add(rows).min(last);
        match verb {
            TableVerb::Up => self.selected = at.saturating_sub(1),
            TableVerb::Down => self.selected = by(1),
            TableVerb::PageUp(rows) => self.selected = at.saturating_sub(rows),
            TableVerb::PageDown(rows) => self.selected = by(rows),
            TableVerb::First => self.selected = 0,
            TableVerb::Last => self.selected = last,
            TableVerb::Left => self.right = self.right.saturating_sub(8),
            TableVerb::Right => self.right = self.right.saturating_add(8).min(1000),
            TableVerb::SortBy(column) => self.sort_by(column, table),
            TableVerb::SortNext => {
                let next = self.sort.map_or(0, |(column, _)| column + 1);
                self.sort = (next < table.columns.len()).then_some((next, false));
            }
        }
    }

    fn sort_by(&mut self, column: usize, table: &Table) {
        self.sort = match self.sort {
            Some((now, false)) if now == column => Some((column, true)),
            Some((now, true)) if now == column => None,
            _ => (column < table.columns.len()).then_some((column, false)),
        };
    }

    /// Numbers of the rows that are shown, in their order.
    fn rows(&self, table: &Table) -> Vec<usize> {
        let words: Vec<String> = self
            .filter
            .split_whitespace()
            .map(str::to_lowercase)
            .collect();
        let passes = |row: &usize| {
            let cells = (0..table.columns.len()).map(|column| table.cell(*row, column).text);
            let text = cells.collect::<Vec<_>>().join(" ").to_lowercase();
            words.iter().all(|word| text.contains(word))
        };
        let mut rows: Vec<usize> = (0..table.rows.len()).filter(passes).collect();
        if let Some((column, down)) = self.sort {
            let text = |row: usize| table.cell(row, column).text;
            rows.sort_by(|a, b| {
                let order = compare(&text(*a), &text(*b));
                if down { order.reverse() } else { order }
            });
        }
        rows
    }

    /// Paints the table into an area of the screen: heads stay at the top, the selected row is in
    /// sight, notes follow the last row.
    pub fn draw(&self, table: &Table, area: Rect, buf: &mut Buffer, glyphs: Glyphs, theme: Theme) {
        let area = area.intersection(*buf.area());
        let view = self.view(table);
        let layout = view.table.layout(area.width.into());
        let selected = self.selected.min(view.rows.len().saturating_sub(1));
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
fn in_sight(layout: &Layout, selected: usize, room: usize) -> impl Iterator<Item = &Line> {
    let is_top =
        |line: &&Line| matches!(line.kind, LineKind::Title | LineKind::Head | LineKind::Rule);
    let mut top = layout.lines.iter().take_while(is_top).count();
    // A body without a single line of room is worse than a table without heads.
    if top >= room {
        top = 0;
    }
    let (heads, body) = layout.lines.split_at(top);
    let room = room - top;
    let of_selected = |line: &Line| line.kind == LineKind::Row(selected);
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
    line: &Line,
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
            LineKind::Title => theme.chart(crate::report::chart::Ink::Title),
            LineKind::Head => theme.strong(),
            _ => theme.cell(piece.ink),
        };
        let text = match glyphs {
            Glyphs::Braille => piece.text.as_str().into(),
            Glyphs::Ascii => plain::ascii(&piece.text),
        };
        for ch in text.chars() {
            let symbol = ch.to_string();
            let wide = symbol.width();
            let shown = column.checked_sub(hidden).filter(|at| at + wide <= width);
            if let Some(at) = shown {
                buf.set_stringn(place.x + at as u16, place.y, &symbol, wide, style);
            }
            column += wide;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::table::{Cell, CellInk, Column};
    use ratatui::style::Modifier;

    fn table() -> Table {
        let row = |name: &str, value: &str, outcome: &str, ink| {
            vec![
                Cell::plain(name),
                Cell::plain(value),
                Cell::new(outcome, ink),
            ]
        };
        Table {
            title: "Joints".to_owned(),
            columns: vec![
                Column::left("joint"),
                Column::decimal("tension"),
                Column::left("outcome"),
            ],
            rows: vec![
                row("vessel|chain", "3.94 MN ± 0.01", "PASS", CellInk::Good),
                row("wire|payload", "763 kN", "FAIL", CellInk::Bad),
                row("chain|polyester", "3.88 MN", "PASS", CellInk::Good),
                row("polyester|wire", "not run", "NOT RUN", CellInk::Dim),
            ],
            notes: vec!["One note.".to_owned()],
        }
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
        pane.act(TableVerb::SortBy(1), &table);
        assert_eq!(pane.view(&table).rows, [1, 2, 0, 3]);
        pane.act(TableVerb::SortBy(1), &table);
        assert_eq!(pane.view(&table).rows, [3, 0, 2, 1]);
        pane.act(TableVerb::SortBy(1), &table);
        assert_eq!(pane.view(&table).rows, [0, 1, 2, 3]);
    }

    #[test]
    fn the_selection_is_a_row_of_the_whole_table() {
        let (table, mut pane) = (table(), TablePane::default());
        pane.set_filter("WIRE pass");
        assert_eq!(pane.selected(&table), None);
        pane.set_filter("wire");
        pane.act(TableVerb::Last, &table);
        assert_eq!(pane.selected(&table), Some(3));
        pane.act(TableVerb::Up, &table);
        assert_eq!(pane.selected(&table), Some(1));
        pane.act(TableVerb::PageDown(10), &table);
        assert_eq!(pane.selected(&table), Some(3));
        assert_eq!(pane.selected(&Table::default()), None);
    }

    #[test]
    fn heads_stay_and_the_selected_row_is_in_sight_and_reversed() {
        let (table, mut pane) = (table(), TablePane::default());
        pane.act(TableVerb::Last, &table);
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
        pane.act(TableVerb::Right, &table);
        for width in 0..40 {
            for height in 0..12 {
                let _ = drawn(&pane, &table, width, height);
            }
        }
    }

    #[test]
    fn a_wide_line_can_be_scrolled_to_its_end() {
        let table = Table {
            columns: vec![Column::right("n")],
            rows: vec![vec![Cell::plain("0123456789")]],
            ..Table::default()
        };
        let mut pane = TablePane::default();
        pane.act(TableVerb::Right, &table);
        // Narrower than the number, so the table is set as records: "n:" above the number.
        let lines = text(&drawn(&pane, &table, 6, 4));
        assert!(lines.iter().any(|line| line == "456789"), "{lines:?}");
    }
}
