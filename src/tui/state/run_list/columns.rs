//! The cursor from column to column of the table of runs, columns that are hidden, and the one that is to sort.

use super::{ColumnName, RunColumn, RunList};

impl RunList {
    /// The column under the cursor, where it is shown.
    #[must_use]
    pub fn current_column(&self) -> Option<RunColumn> {
        let column = self.column_of(self.column.as_ref()?)?;
        self.shown_columns.contains(&column).then_some(column)
    }

    /// The column under the cursor; where none has it, the first gets it.
    pub fn column_or_first(&mut self) -> RunColumn {
        let column = self.current_column().unwrap_or(RunColumn::Name);
        self.column = self.name_of(column);
        column
    }

    /// Moves the cursor by so many columns.
    pub fn turn_column(&mut self, by: isize) {
        let now = self.current_column();
        let now = now.and_then(|column| self.shown_columns.iter().position(|c| *c == column));
        let last = self.shown_columns.len().saturating_sub(1);
        let next = now
            .map_or(0, |place| place.saturating_add_signed(by))
            .min(last);
        let column = self.shown_columns.get(next).copied();
        self.column = column.and_then(|column| self.name_of(column));
    }

    /// Hides the column under the cursor, which goes to the next one. The name stays.
    pub fn hide_column(&mut self) {
        let Some(column) = self
            .current_column()
            .filter(|column| *column != RunColumn::Name)
        else {
            return;
        };
        let name = self.name_of(column);
        self.turn_column(1);
        if self.current_column() == Some(column) {
            self.turn_column(-1);
        }
        self.hidden.extend(name);
        self.shown_columns = self.columns_to_show();
    }

    /// Hides these columns and no others.
    pub fn hide_only(&mut self, hidden: Vec<ColumnName>) {
        self.hidden = hidden;
        self.shown_columns = self.columns_to_show();
    }

    /// The column that sorts, or is to once it is there, by its name.
    #[must_use]
    pub fn wanted_sort(&self) -> Option<(ColumnName, bool)> {
        let sorted = self.sort;
        let named = sorted.and_then(|(column, down)| Some((self.name_of(column)?, down)));
        named.or_else(|| self.sort_later.clone())
    }

    /// Sorts by the column of a name, once there is one.
    pub fn sort_when_there(&mut self, wanted: Option<(ColumnName, bool)>) {
        let there = wanted.as_ref();
        let there = there.and_then(|(name, down)| Some((self.column_of(name)?, *down)));
        self.sort = there.or(self.sort);
        self.sort_later = wanted.filter(|_| there.is_none());
    }

    /// Sorts by the column under the cursor, then the other way round, then in the original order; without a cursor by the next
    /// column, after the last in the original order again.
    pub fn sort_next(&mut self) {
        self.sort_later = None;
        if let Some(column) = self.current_column() {
            self.sort = match self.sort {
                Some((by, down)) if by == column => (!down).then_some((column, true)),
                _ => Some((column, false)),
            };
            return self.arrange();
        }
        let columns = self.shown_columns();
        let at = self
            .sort
            .and_then(|(now, _)| columns.iter().position(|c| *c == now));
        let next = at.map_or(0, |at| at + 1);
        self.sort = columns.get(next).map(|column| (*column, false));
        self.arrange();
    }

    /// Turns the order around.
    pub fn sort_around(&mut self) {
        self.sort_later = None;
        let (column, down) = self.sort.unwrap_or((RunColumn::Age, false));
        self.sort = Some((column, !down));
        self.arrange();
    }
}
