//! The layout of a table as it was drawn last. Breaking its words anew took half the time of a frame.

use std::cell::RefCell;
use std::sync::Arc;

use crate::table::{Table, TableLayout};

/// A layout, and all that it depends on. It is no part of the state: copies are without, and all are equal.
#[derive(Debug, Default)]
pub(super) struct LayoutMemo(RefCell<Option<LaidOut>>);

/// What a layout depends on besides the table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct LayoutMemoKey {
    /// Head of the column that sorts, and whether the greatest comes first.
    pub(super) sort: Option<(String, bool)>,
    /// Heads of the columns that are hidden.
    pub(super) hidden: Vec<String>,
    /// The filter of the rows.
    pub(super) filter: String,
    pub(super) width: usize,
}

#[derive(Debug)]
struct LaidOut {
    table: Table,
    key: LayoutMemoKey,
    layout: Arc<TableLayout>,
}

impl LayoutMemo {
    /// The layout of a table as the user has it; made by `lay_out` where it is not that of the last time.
    pub(super) fn layout(
        &self,
        table: &Table,
        key: LayoutMemoKey,
        lay_out: impl FnOnce() -> TableLayout,
    ) -> Arc<TableLayout> {
        let mut last = self.0.borrow_mut();
        let known = last
            .as_ref()
            .filter(|last| last.key == key && last.table == *table);
        if let Some(known) = known {
            return Arc::clone(&known.layout);
        }
        let layout = Arc::new(lay_out());
        *last = Some(LaidOut {
            table: table.clone(),
            key,
            layout: Arc::clone(&layout),
        });
        layout
    }
}

impl Clone for LayoutMemo {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for LayoutMemo {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for LayoutMemo {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layout_is_made_anew_when_anything_changes_that_it_depends_on() {
        let memo = LayoutMemo::default();
        let made = std::cell::Cell::new(0);
        let table = |n: usize| Table::of_records("", &[n]).count("n", |n| n).build();
        let lay_out = |n, sort: Option<&str>, width| {
            let key = LayoutMemoKey {
                sort: sort.map(|head| (head.to_owned(), false)),
                hidden: Vec::new(),
                filter: String::new(),
                width,
            };
            memo.layout(&table(n), key, || {
                made.set(made.get() + 1);
                table(n).layout(width)
            });
            made.get()
        };
        assert_eq!([lay_out(1, None, 80), lay_out(1, None, 80)], [1, 1]);
        assert_eq!([lay_out(2, None, 80), lay_out(2, None, 60)], [2, 3]);
        assert_eq!(
            [lay_out(2, Some("n"), 60), lay_out(2, Some("n"), 60)],
            [4, 4]
        );
    }
}
