//! What the user does with a table: select, sort, filter, hide columns, go from column to column.
//!
//! [`TablePane`] is plain state over a [`Table`] that comes from elsewhere. [`TablePane::act`]
//! changes it, [`TablePane::draw`] paints the table as the user has it.

mod layout_memo;
mod painting;
mod rows;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use self::layout_memo::{LayoutMemo, LayoutMemoKey};
use super::state::Filter;
use super::theme::Theme;
use crate::chart::Glyphs;
use crate::table::{LineKind, Table, TableLayout};

/// What can be done with a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableVerb {
    /// Selection down by so many rows, or up where negative.
    Select(isize),
    /// The cursor so many columns further right.
    Column(isize),
    /// Sort by the column under the cursor, the other way round, as it came; without a cursor by the next column.
    Sort,
    /// Sort the other way round.
    SortAround,
    /// Hide the column under the cursor.
    Hide,
    /// Show all columns.
    ShowAll,
}

/// A table as the user has it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TablePane {
    /// The selected row, in the order shown.
    pub selected: usize,
    /// The rows that are shown.
    pub filter: Filter,
    /// The head of the column under the cursor.
    column: Option<String>,
    /// The head of the column sorted by, and whether the greatest comes first.
    sort: Option<(String, bool)>,
    /// The heads of the columns that are hidden.
    hidden: Vec<String>,
    memo: LayoutMemo,
}

impl TablePane {
    /// The selected row by its number in the whole table; absent when there is none.
    #[must_use]
    pub fn selected(&self, table: &Table) -> Option<usize> {
        let rows = self.rows(table);
        let last = rows.len().saturating_sub(1);
        rows.get(self.selected.min(last)).copied()
    }

    /// How many rows pass the filter.
    #[must_use]
    pub fn count(&self, table: &Table) -> usize {
        self.rows(table).len()
    }

    /// The head of the column under the cursor, where the table has it.
    #[must_use]
    pub fn column(&self, table: &Table) -> Option<usize> {
        let head = self.column.as_ref()?;
        self.place(table, head)
    }

    /// The heads of the columns that are shown.
    #[must_use]
    pub fn shown(&self, table: &Table) -> Vec<usize> {
        let all = table.columns.iter().enumerate();
        let shown = all.filter(|(_, column)| !self.hidden.contains(&column.head));
        shown.map(|(place, _)| place).collect()
    }

    /// The head of the column sorted by, and whether the greatest comes first.
    #[must_use]
    pub const fn sorted_by(&self) -> Option<&(String, bool)> {
        self.sort.as_ref()
    }

    /// The heads of the columns that are hidden.
    #[must_use]
    pub fn hidden(&self) -> &[String] {
        &self.hidden
    }

    /// Sorts by the column of a head.
    pub fn sort_by(&mut self, sort: Option<(String, bool)>) {
        self.sort = sort;
    }

    /// Hides the columns of these heads and no others.
    pub fn hide_only(&mut self, heads: Vec<String>) {
        self.hidden = heads;
    }

    /// Puts the cursor on the column of a head.
    pub fn go_to(&mut self, head: &str) {
        self.column = Some(head.to_owned());
    }

    /// Does what the user asked for.
    pub fn act(&mut self, verb: TableVerb, table: &Table) {
        match verb {
            TableVerb::Select(by) => {
                let last = self.count(table).saturating_sub(1);
                let at = self.selected.min(last).saturating_add_signed(by);
                self.selected = at.min(last);
            }
            TableVerb::Column(by) => self.turn_column(by, table),
            TableVerb::Sort => self.turn_sort(table),
            TableVerb::SortAround => self.sort_around(table),
            TableVerb::Hide => self.hide(table),
            TableVerb::ShowAll => self.hidden.clear(),
        }
    }

    fn turn_column(&mut self, by: isize, table: &Table) {
        let shown = self.shown(table);
        let now = self.column(table);
        let now = now.and_then(|column| shown.iter().position(|place| *place == column));
        let next = match now {
            Some(place) => place.saturating_add_signed(by),
            None => 0,
        };
        let last = shown.len().saturating_sub(1);
        let place = shown.get(next.min(last));
        self.column = place.map(|place| table.columns[*place].head.clone());
    }

    fn turn_sort(&mut self, table: &Table) {
        let sorted = self.sort.take();
        let by = sorted
            .as_ref()
            .and_then(|(head, _)| self.place(table, head));
        let head = |place: usize| table.columns.get(place).map(|column| column.head.clone());
        self.sort = match (self.column(table), by) {
            (Some(column), by) if by != Some(column) => head(column).map(|head| (head, false)),
            (Some(_), _) => sorted
                .filter(|(_, down)| !down)
                .map(|(head, _)| (head, true)),
            (None, by) => {
                let shown = self.shown(table);
                let after = by.map_or(0, |by| by + 1);
                let next = shown.into_iter().find(|place| *place >= after);
                next.and_then(head).map(|head| (head, false))
            }
        };
    }

    fn sort_around(&mut self, table: &Table) {
        let first = || {
            table
                .columns
                .first()
                .map(|column| (column.head.clone(), false))
        };
        let now = self.sort.take().or_else(first);
        self.sort = now.map(|(head, down)| (head, !down));
    }

    /// The last column that is shown stays; the cursor goes to the next one.
    fn hide(&mut self, table: &Table) {
        let shown = self.shown(table);
        let Some(column) = self.column(table).filter(|_| shown.len() > 1) else {
            return;
        };
        self.turn_column(1, table);
        if self.column(table) == Some(column) {
            self.turn_column(-1, table);
        }
        self.hidden.push(table.columns[column].head.clone());
    }

    /// The place of the column of a head.
    fn place(&self, table: &Table, head: &str) -> Option<usize> {
        table.columns.iter().position(|column| column.head == head)
    }

    /// Paints the table into an area of the screen: heads stay at the top, the selected row and the column under the cursor are in
    /// sight, notes follow the last row.
    pub fn draw(&self, table: &Table, area: Rect, buf: &mut Buffer, glyphs: Glyphs, theme: Theme) {
        let area = area.intersection(*buf.area());
        let layout = self.laid_out(table, area.width.into());
        let selected = self.selected.min(self.count(table).saturating_sub(1));
        let width = usize::from(area.width);
        let left = self.left(table, &layout, width);
        let marked = self.place_in(table, &layout);
        let lines = painting::in_sight(&layout, selected, area.height.into());
        for (line, row) in lines.zip(area.top()..) {
            let place = Rect::new(area.x, row, area.width, 1);
            painting::draw_line(line, left, place, buf, glyphs, theme);
            if line.kind == LineKind::Row(selected) {
                buf.set_style(place, theme.selected());
            }
            if let Some((from, wide)) = marked.filter(|_| line.kind == LineKind::Head) {
                let from = u16::try_from(from.saturating_sub(left)).unwrap_or(u16::MAX);
                let wide = u16::try_from(wide).unwrap_or(u16::MAX);
                let head = Rect::new(area.x.saturating_add(from), row, wide, 1);
                buf.set_style(head.intersection(place), theme.selected());
            }
        }
    }

    fn laid_out(&self, table: &Table, width: usize) -> std::sync::Arc<TableLayout> {
        let key = LayoutMemoKey {
            sort: self.sort.clone(),
            hidden: self.hidden.clone(),
            filter: self.filter.input.value().to_owned(),
            width,
        };
        self.memo
            .layout(table, key, || self.as_shown(table).layout(width))
    }

    /// Where the column under the cursor is in a layout: its first column of text and its width; nothing where the layout has no
    /// columns.
    fn place_in(&self, table: &Table, layout: &TableLayout) -> Option<(usize, usize)> {
        let column = self.column(table)?;
        let shown = self.shown(table);
        let place = shown.iter().position(|place| *place == column)?;
        let found = layout.columns.iter().find(|of| of.number == place)?;
        Some((found.from, found.width))
    }

    /// How many columns of text are hidden at the left, so that the column under the cursor is in sight.
    fn left(&self, table: &Table, layout: &TableLayout, width: usize) -> usize {
        let most = layout.width.saturating_sub(width);
        let wanted = match self.place_in(table, layout) {
            // The end of the last column is seen, where it is wider than the pane.
            Some(_) if self.column(table).as_ref() == self.shown(table).last() => most,
            Some((from, wide)) => (from + wide).saturating_sub(width).min(from),
            // Cells below each other: each step to the right shows some more of long ones.
            None => self
                .column(table)
                .map_or(0, |place| painting::STEP * (place + 1)),
        };
        wanted.min(most)
    }
}

#[cfg(test)]
mod tests;
