//! Every input with its value and where it comes from.

use crate::{
    document::Report,
    table::{Align, Cell, CellStyle, Table},
};
use seacable_model::case::{Case, FieldRow, Provenance, YOURS, edited, fields::ValueType, kind};
use seacable_runs::run::{Run, edited_inputs};

/// The inputs table, and below it the reason of every input that its source does not print.
pub(super) fn table(page: &mut Report, run: &Run, case: &Case) {
    let mut all = kind::rows::<Case>(&run.case_text);
    edited::mark(&mut all, &edited_inputs::<Case>(run));
    list(page, &all, !case.case.source.trim().is_empty());
}

/// The same for the fields of any kind of file; `sourced` when what carries no mark is printed in its source.
pub(crate) fn list(page: &mut Report, all: &[FieldRow], sourced: bool) {
    let rows: Vec<&FieldRow> = all.iter().filter(|row| shown(row)).collect();
    if rows.is_empty() {
        return;
    }
    page.section("Inputs", lines(&rows, sourced));

    let yours = || {
        rows.iter()
            .filter_map(|row| Some((row, row.replaced.as_ref()?)))
    };
    if yours().next().is_some() {
        page.gap();
        page.paragraph("Inputs that are yours, not those of the file:");
        for (row, replaced) in yours() {
            page.item("* ", &format!("{}: {}", row.path, replaced.words()));
        }
    }
    let marked = || {
        rows.iter()
            .filter_map(|row| Some((row, row.standing.as_ref()?)))
    };
    if marked().next().is_some() {
        page.gap();
        page.paragraph("Inputs that the source does not print, and why they have their value:");
        for (row, mark) in marked() {
            let head = format!("{} ({}):", row.path, mark.status.name());
            page.item("* ", &format!("{head} {}", mark.reason.trim()));
        }
    }
}

/// Names are in the headings; keys that have no effect are left out.
fn shown(row: &FieldRow) -> bool {
    !row.value.is_empty() && row.field.kind != ValueType::Name && row.is_shown()
}

fn lines(rows: &[&FieldRow], sourced: bool) -> Table {
    let mut lines = Vec::new();
    for group in rows.chunk_by(|a, b| a.group == b.group) {
        lines.push((group[0], true));
        lines.extend(group.iter().map(|row| (*row, false)));
    }
    // The line of a group has its name alone.
    let unless = |heads_group: bool, cell: Cell| if heads_group { Cell::default() } else { cell };
    Table::of_records("", &lines)
        .text("input", |(row, heads_group)| match heads_group {
            true => format!("{}:", row.group),
            false => row.label.clone().into_owned(),
        })
        .cell("value", Align::Left, |(row, heads_group)| {
            unless(*heads_group, value(row))
        })
        .cell("standing", Align::Left, |(row, heads_group)| {
            unless(*heads_group, standing(row, sourced))
        })
        .build()
}

fn value(row: &FieldRow) -> Cell {
    Cell::plain(row.value_with_unit())
}

/// Inputs of a sourced case that carry no mark are printed in the source; what the file leaves out has
/// its default.
fn standing(row: &FieldRow, sourced: bool) -> Cell {
    if row.replaced.is_some() {
        return Cell::new(YOURS, CellStyle::Warn);
    }
    match (&row.standing, row.given) {
        (Some(mark), _) => Cell::new(mark.status.name(), CellStyle::Warn),
        (None, false) => Cell::new("default", CellStyle::Dim),
        (None, true) if row.is_setting() => Cell::plain("setting"),
        (None, true) => Cell::plain(row.provenance(sourced).map_or("", Provenance::name)),
    }
}
