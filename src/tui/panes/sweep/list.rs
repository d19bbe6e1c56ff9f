//! Load cases in lines: those of a cell, and the table of all with any result.

use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use crate::number::{si, with_error};
use crate::pane::PaneId;
use crate::state::sweeps::{CellList, OpenSweep};
use crate::study::load_case_table::{LoadCaseColumn, LoadCaseState};
use crate::view::paint::{below_head, first_line, row, span};
use crate::view::painter::Painter;

/// The widest column.
const WIDEST: usize = 34;
/// Blanks between columns.
const GAP: u16 = 2;

/// A column in sight: its head, and its cells.
struct SweepColumn {
    cells: Vec<String>,
    width: u16,
}

impl SweepColumn {
    fn new(head: &str, cells: impl Iterator<Item = String>) -> Self {
        let cells: Vec<String> = std::iter::once(head.to_owned()).chain(cells).collect();
        let widest = cells.iter().map(|cell| cell.width()).max().unwrap_or(0);
        Self {
            cells,
            width: u16::try_from(widest.min(WIDEST)).unwrap_or(0),
        }
    }
}

/// All load cases: what is set, the result shown and those after it, what became of them.
pub(super) fn table(painter: &mut Painter, area: Rect, open: &OpenSweep) {
    let order = match open.by_result {
        true => ", sorted by the first result",
        false => "",
    };
    let words = format!("{} load cases{order}", open.table.states.len());
    let of = (open.order.len(), open.table.states.len());
    let area = painter.filter_line(area, &open.filter, of);
    lines(painter, area, open, (&open.order, open.row), &words);
}

/// The load cases of the cell that was entered.
pub(super) fn of_cell(painter: &mut Painter, area: Rect, open: &OpenSweep, cell: &CellList) {
    let words = format!(
        "{} load cases; Enter shows the run, Esc goes back",
        cell.load_cases.len()
    );
    let of = (cell.shown.len(), cell.load_cases.len());
    let area = painter.filter_line(area, &open.filter, of);
    lines(painter, area, open, (&cell.shown, cell.cursor), &words);
}

/// The load cases of the cell under the cursor, without a cursor of their own.
pub(super) fn under_cursor(painter: &mut Painter, area: Rect, open: &OpenSweep) {
    let Some(cell) = open.current() else { return };
    let words = format!("{} load cases under the cursor", cell.load_cases.len());
    let none = usize::MAX;
    lines(painter, area, open, (&cell.load_cases, none), &words);
}

/// Draws load cases around a cursor; only what is in sight is worded.
fn lines(
    painter: &mut Painter,
    area: Rect,
    open: &OpenSweep,
    (cases, cursor): (&[usize], usize),
    title: &str,
) {
    let [head, below] = below_head(area);
    let strong = painter.theme.strong();
    painter.text(head, title, strong);
    let [heads, list] = below_head(below);
    let at = if cursor == usize::MAX { 0 } else { cursor };
    let first = first_line(at, cases.len(), list.height.into());
    let seen: Vec<usize> = cases
        .iter()
        .copied()
        .skip(first)
        .take(list.height.into())
        .collect();
    let columns = columns(open, &seen, area.width);
    line(painter, heads, &columns, 0, strong);
    let focused = painter.state.focus() == PaneId::Sweep;
    for (place, (case, down)) in seen.iter().zip(0..list.height).enumerate() {
        let at = row(list, down);
        let style = painter.line_style(focused && first + place == cursor);
        painter.buf.set_style(at, style);
        let failed = open
            .table
            .states
            .get(*case)
            .is_some_and(|of| of.reason().is_some());
        let style = match failed {
            true => style.patch(painter.theme.error()),
            false => style,
        };
        line(painter, at, &columns, place + 1, style);
    }
}

/// The columns that fit: number, state, axes, then results from the one shown on.
fn columns(open: &OpenSweep, seen: &[usize], room: u16) -> Vec<SweepColumn> {
    let table = &open.table;
    let state = |case: &usize| match table.states.get(*case) {
        Some(LoadCaseState::Done) | None => String::new(),
        Some(of) => of.word().to_owned(),
    };
    let mut columns = vec![SweepColumn::new(
        "case",
        seen.iter().map(|case| format!("{:>4}", case + 1)),
    )];
    for axis in &table.axes {
        let value = |case: &usize| {
            let place = axis.place(*case);
            place.map_or_else(String::new, |place| axis.values[place].clone())
        };
        columns.push(SweepColumn::new(&axis.label, seen.iter().map(value)));
    }
    columns.push(SweepColumn::new("state", seen.iter().map(state)));
    let shown = open.columns().skip(open.result);
    let mut used: u16 = columns.iter().map(|column| column.width + GAP).sum();
    for result in shown {
        // Axes with long names leave room for one result at least.
        if used >= room {
            shrink(&mut columns, used + 16 - room);
            used = columns.iter().map(|column| column.width + GAP).sum();
        }
        let column = SweepColumn::new(&result.name, seen.iter().map(|case| value(result, *case)));
        used = used.saturating_add(column.width + GAP);
        columns.push(column);
        if used >= room {
            break;
        }
    }
    columns
}

/// Takes columns of text from the widest columns.
fn shrink(columns: &mut [SweepColumn], by: u16) {
    for _ in 0..by {
        if let Some(widest) = columns.iter_mut().max_by_key(|column| column.width) {
            widest.width = widest.width.saturating_sub(1).max(1);
        }
    }
}

fn value(result: &LoadCaseColumn, case: usize) -> String {
    let Some(of) = result.values.get(case).copied().flatten() else {
        return "-".to_owned();
    };
    match of.error {
        Some(_) => with_error(of.value, of.error, &result.unit),
        None => format!("{} ± ?", si(of.value, &result.unit)),
    }
}

/// Writes the heads, the first row of cells, or a line of the table.
fn line(
    painter: &mut Painter,
    at: Rect,
    columns: &[SweepColumn],
    place: usize,
    style: ratatui::style::Style,
) {
    let mut from = 0;
    for column in columns {
        let words = column.cells.get(place).map_or("", String::as_str);
        painter.text(span(at, from, column.width), words, style);
        from += column.width + GAP;
    }
}
