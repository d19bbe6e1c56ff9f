//! The layout of a table as it was drawn last. Breaking its words anew took half the time of a frame.

use std::cell::RefCell;
use std::sync::Arc;

use crate::report::table::{Table, TableLayout};

/// A layout, and all that it depends on. It is no part of the state: copies are without, and all are equal.
#[derive(Debug, Default)]
pub(super) struct LayoutMemo(RefCell<Option<LaidOut>>);

#[derive(Debug)]
struct LaidOut {
    table: Table,
    sort: Option<usize>,
    width: usize,
    layout: Arc<TableLayout>,
}

impl LayoutMemo {
    /// The layout of a table that is sorted by a column, in a width; made by `lay_out` where it is not that of the last time.
    pub(super) fn of(
        &self,
        table: &Table,
        sort: Option<usize>,
        width: usize,
        lay_out: impl FnOnce() -> TableLayout,
    ) -> Arc<TableLayout> {
        let mut last = self.0.borrow_mut();
        let known = last
            .as_ref()
            .filter(|last| last.width == width && last.sort == sort && last.table == *table);
        if let Some(known) = known {
            return Arc::clone(&known.layout);
        }
        let layout = Arc::new(lay_out());
        *last = Some(LaidOut {
            table: table.clone(),
            sort,
            width,
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
        let table = |n: usize| Table::of("", &[n]).count("n", |n| n).build();
        let lay_out = |n, sort, width| {
            memo.of(&table(n), sort, width, || {
                made.set(made.get() + 1);
                table(n).layout(width)
            });
            made.get()
        };
        assert_eq!([lay_out(1, None, 80), lay_out(1, None, 80)], [1, 1]);
        assert_eq!([lay_out(2, None, 80), lay_out(2, None, 60)], [2, 3]);
        assert_eq!([lay_out(2, Some(0), 60), lay_out(2, Some(0), 60)], [4, 4]);
    }
}
