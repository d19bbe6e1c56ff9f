//! Tables as the user has them.

use super::*;
use crate::table::{Align, Cell, CellStyle};
use ratatui::style::Modifier;

fn table() -> Table {
    let rows = [
        ("vessel|chain", "3.94 MN ± 0.01", "PASS", CellStyle::Good),
        ("wire|payload", "763 kN", "FAIL", CellStyle::Bad),
        ("chain|polyester", "3.88 MN", "PASS", CellStyle::Good),
        ("polyester|wire", "not run", "NOT RUN", CellStyle::Dim),
    ];
    Table::of_records("Joints", &rows)
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
    pane.act(TableVerb::Column(1), &table);
    for width in 0..40 {
        for height in 0..12 {
            let _ = drawn(&pane, &table, width, height);
        }
    }
}

#[test]
fn a_wide_line_can_be_scrolled_to_its_end() {
    let table = Table::of_records("", &["0123456789"])
        .count("n", |n| n)
        .build();
    let mut pane = TablePane::default();
    pane.act(TableVerb::Column(1), &table);
    // Narrower than the number, so the table is set as records: "n:" above the number.
    let lines = text(&drawn(&pane, &table, 6, 4));
    assert!(lines.iter().any(|line| line == "456789"), "{lines:?}");
}
