//! Every input with its value and where it comes from.

use super::layout::{Page, WIDTH};
use crate::{
    case::{Case, FieldRow, fields::Kind},
    reference::standing_word,
    report::table::{Cell, CellInk, Column, Table},
    run::Run,
};

/// The inputs table, and below it the reason of every input that its source does not print.
pub(super) fn table(page: &mut Page, run: &Run, case: &Case) {
    let all = crate::case::rows(&run.case_text, case);
    list(page, &all, !case.case.source.trim().is_empty());
}

/// The same for the fields of any kind of file; `sourced` when what carries no mark is printed in its source.
pub(crate) fn list(page: &mut Page, all: &[FieldRow], sourced: bool) {
    let rows: Vec<&FieldRow> = all.iter().filter(|row| shown(row)).collect();
    if rows.is_empty() {
        return;
    }
    page.heading("Inputs");
    page.block(&lines(&rows, sourced).to_text(WIDTH));

    let marked = || {
        rows.iter()
            .filter_map(|row| Some((row, row.standing.as_ref()?)))
    };
    if marked().next().is_some() {
        page.line("");
        page.paragraph("Inputs that the source does not print, and why they have their value:");
        for (row, mark) in marked() {
            let head = format!("{} ({}):", row.path, standing_word(mark.status));
            page.hanging("* ", &format!("{head} {}", mark.reason.trim()));
        }
    }
}

/// Names are in the headings; keys that have no effect are left out.
fn shown(row: &FieldRow) -> bool {
    !row.value.is_empty() && row.field.kind != Kind::Name && row.is_shown()
}

fn lines(rows: &[&FieldRow], sourced: bool) -> Table {
    let mut group = "";
    let mut lines = Vec::new();
    for row in rows {
        if row.group != group {
            group = &row.group;
            lines.push(vec![Cell::plain(format!("{group}:"))]);
        }
        let unit = if row.unit == "-" { "" } else { row.unit };
        lines.push(vec![
            Cell::plain(row.label),
            Cell::plain(format!("{} {unit}", row.value).trim_end()),
            standing(row, sourced),
        ]);
    }
    Table {
        columns: vec![
            Column::left("input"),
            Column::left("value"),
            Column::left("standing"),
        ],
        rows: lines,
        ..Table::default()
    }
}

/// Inputs of a sourced case that carry no mark are printed in the source; what the file leaves out has
/// its default.
fn standing(row: &FieldRow, sourced: bool) -> Cell {
    let number = !matches!(
        row.field.kind,
        Kind::Name | Kind::Text | Kind::Choice(_) | Kind::Integer
    );
    let setting = ["solver", "output", "start"]
        .iter()
        .any(|table| row.path.starts_with(table));
    match (&row.standing, row.given) {
        (Some(mark), _) => Cell::new(standing_word(mark.status), CellInk::Warn),
        (None, false) => Cell::new("default", CellInk::Dim),
        (None, true) if setting => Cell::plain("setting"),
        (None, true) if number && sourced => Cell::plain("published"),
        (None, true) => Cell::plain(""),
    }
}
