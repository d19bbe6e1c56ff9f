//! Tables as people see them, and what must hold at any width.

use proptest::prelude::*;
use seacable::table::{Cell, CellStyle, Column, Table};
use unicode_width::UnicodeWidthStr;

/// Accepted tables live in the top-level `snapshots/`, named by what they show.
fn accept(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

fn validation() -> Table {
    let row = |cells: [&str; 7], ink: CellStyle| {
        let mut row: Vec<Cell> = cells.map(Cell::plain).into();
        row[5].ink = ink;
        row
    };
    Table {
        title: "Manifold: computed against published".to_owned(),
        columns: vec![
            Column::left("quantity"),
            Column::decimal("published"),
            Column::left("printed in"),
            Column::decimal("computed"),
            Column::decimal("difference"),
            Column::left("outcome"),
            Column::left("inputs"),
        ],
        rows: vec![
            row(
                [
                    "tension at the wire joint, mean 0-200 s, reference",
                    "0.770 MN",
                    "sec. 2.1, fig. 5",
                    "0.7631 MN ± 0.0003",
                    "-0.91 %",
                    "PASS",
                    "calibrated",
                ],
                CellStyle::Good,
            ),
            row(
                [
                    "tension at the wire joint, mean 600-1200 s, reference",
                    "1.97 MN",
                    "sec. 2.1, fig. 5",
                    "1.9631 MN ± 0.0001",
                    "-0.36 %",
                    "PASS",
                    "published",
                ],
                CellStyle::Good,
            ),
            row(
                [
                    "greatest tension at polyester-wire",
                    "4.23 MN",
                    "sec. 3.1",
                    "3.780 MN ± 0.002",
                    "-10.6 %",
                    "DIFFERS",
                    "assumed",
                ],
                CellStyle::Warn,
            ),
            row(
                [
                    "travel at 0.8 m/s",
                    "1394.23 m",
                    "table 4",
                    "not run",
                    "-",
                    "NOT RUN",
                    "assumed",
                ],
                CellStyle::Dim,
            ),
        ],
        notes: vec!["Only the drag area was fitted, to one number.".to_owned()],
    }
}

#[test]
fn a_wide_table_is_flat_and_a_narrow_one_is_stacked() {
    let table = validation();
    accept("table_validation_140", &table.to_text(140));
    accept("table_validation_100", &table.to_text(100));
    accept("table_validation_80", &table.to_text(80));
    accept("table_validation_30", &table.to_text(30));
}

#[test]
fn points_are_below_each_other() {
    let numbers = ["1.5", "-12.25", "300", "none", "0.001 m"];
    let table = Table {
        columns: vec![Column::decimal("a long head above numbers")],
        rows: numbers.iter().map(|n| vec![Cell::plain(*n)]).collect(),
        ..Table::default()
    };
    for width in [80, 12] {
        let text = table.to_text(width);
        let at = |n: &str| {
            let line = text.lines().find(|line| line.contains(n)).unwrap_or("");
            line.find('.')
        };
        assert_eq!(at("1.5"), at("12.25"), "{text}");
        assert_eq!(at("1.5"), at("0.001"), "{text}");
    }
}

fn text() -> impl Strategy<Value = String> {
    prop_oneof![
        "[a-z]{0,14}( [a-zäö漢]{1,9}){0,4}",
        "-?[0-9]{1,5}(\\.[0-9]{1,4})?( MN)?",
        Just(String::new()),
    ]
}

prop_compose! {
    fn tables()(
        columns in prop::collection::vec(("[a-z ]{0,20}", 0..3_u8), 0..7),
        rows in prop::collection::vec(prop::collection::vec(text(), 0..8), 0..6),
        notes in prop::collection::vec(text(), 0..2),
        title in text(),
    ) -> Table {
        let column = |(head, align): (String, u8)| match align {
            0 => Column::left(&head),
            1 => Column::right(&head),
            _ => Column::decimal(&head),
        };
        Table {
            title,
            notes,
            columns: columns.into_iter().map(column).collect(),
            rows: rows.into_iter().map(|r| r.into_iter().map(Cell::plain).collect()).collect(),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_table_fits_any_sensible_width(table in tables(), width in 14..160_usize) {
        for line in table.to_text(width).lines() {
            prop_assert!(line.width() <= width, "{width}: {line}");
        }
    }

    #[test]
    fn numbers_are_whole_at_any_width(table in tables(), width in 0..160_usize) {
        let shown = table.to_text(width);
        for row in &table.rows {
            for cell in row.iter().take(table.columns.len()) {
                let number = cell.text.split(' ').next().unwrap_or("");
                if number.bytes().any(|b| b.is_ascii_digit()) {
                    prop_assert!(shown.contains(number), "{number} in\n{shown}");
                }
            }
        }
    }
}
