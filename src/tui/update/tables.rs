//! Commands of the table that has the focus: its filter, its columns, and what they mean.

use std::borrow::Cow;

use super::motion::table_verb;
use super::notice::info;
use crate::command::CommandId;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::run_cells::plain_head;
use crate::run_columns;
use crate::state::{AppState, Filter, Overlay, RunColumn, RunsView};
use crate::table::explanations;
use crate::table_pane::{TablePane, TableVerb};

/// Commands that need a table.
pub const OF_TABLE: [CommandId; 6] = [
    CommandId::ColumnRight,
    CommandId::ColumnLeft,
    CommandId::Explain,
    CommandId::HideColumn,
    CommandId::ShowColumns,
    CommandId::SortAround,
];

/// Why a command of a table cannot be done now.
#[must_use]
pub fn why_not(state: &AppState, id: CommandId) -> Option<&'static str> {
    let of_some = matches!(id, CommandId::Filter | CommandId::Sort) && state.table_pane().is_some();
    if !(OF_TABLE.contains(&id) || of_some) || state.focus() == PaneId::Runs {
        return None;
    }
    let Some(table) = state.focused_table() else {
        return Some("There is no table here yet.");
    };
    let pane = state.table_pane()?;
    match id {
        CommandId::HideColumn if pane.column(&table).is_none() => {
            Some("No column has the cursor; `:column_right` puts it on one.")
        }
        CommandId::HideColumn if pane.shown(&table).len() < 2 => Some("One column stays."),
        CommandId::ShowColumns if pane.hidden().is_empty() => Some("All columns are shown."),
        _ => None,
    }
}

/// Does a command of the table that has the focus; nothing where none has it.
pub(super) fn command(state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
    let table = state.focused_table()?.into_owned();
    match id {
        CommandId::Filter => state.table_pane_mut()?.filter.typing = true,
        CommandId::Explain => return explain(state),
        id if OF_TABLE.contains(&id) || id == CommandId::Sort => {
            let verb = table_verb(state, id)?;
            state.table_pane_mut()?.act(verb, &table);
        }
        _ => return None,
    }
    Some(Vec::new())
}

/// Says what the column under the cursor is; where none has it, the first gets it.
fn explain(state: &mut AppState) -> Option<Vec<Effect>> {
    let table = state.focused_table()?.into_owned();
    let pane = state.table_pane_mut()?;
    if pane.column(&table).is_none() {
        pane.act(TableVerb::Column(1), &table);
    }
    let column = table.columns.get(pane.column(&table)?)?;
    let words = explanations::words(&table.title, &column.head);
    show(state, &column.head, words);
    Some(Vec::new())
}

/// Says what the column of runs under the cursor is.
pub fn explain_run_column(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    let column = view.runs.column_or_first();
    let (head, words) = run_columns::explanation(&view.runs, column);
    show(state, &head, words);
    Vec::new()
}

/// Sorts the table that has the focus by the column of this head, the other way round where it does so already.
pub(super) fn sort_by(state: &mut AppState, head: &str) -> Result<Vec<Effect>, String> {
    if let Some((view, column)) = run_column(state, head) {
        let down = view.runs.sort == Some((column, false));
        view.runs.sort = Some((column, down));
        view.runs.arrange();
        return Ok(Vec::new());
    }
    let pane = pane_with(state, head)?;
    let down = pane.sorted_by() == Some(&(head.to_owned(), false));
    pane.sort_by(Some((head.to_owned(), down)));
    Ok(Vec::new())
}

/// Hides the column of this head.
pub(super) fn hide(state: &mut AppState, head: &str) -> Result<Vec<Effect>, String> {
    if let Some((view, column)) = run_column(state, head) {
        view.runs.column = view.runs.name_of(column);
        view.runs.hide_column();
        return Ok(Vec::new());
    }
    let table = state.focused_table().map(Cow::into_owned);
    let pane = pane_with(state, head)?;
    pane.go_to(head);
    if let Some(table) = table {
        pane.act(TableVerb::Hide, &table);
    }
    Ok(Vec::new())
}

/// Shows the column of this head again, or all of them.
pub(super) fn show_again(state: &mut AppState, head: &str) -> Result<Vec<Effect>, String> {
    if state.focus() == PaneId::Runs {
        let view = state.runs_view_mut().ok_or(NO_TABLE)?;
        let names = view.runs.hidden.clone();
        let kept = names.into_iter().filter(|name| {
            let column = view.runs.column_of(name);
            let own = column.map(|column| plain_head(&view.runs, column));
            !head.is_empty() && own.as_deref() != Some(head)
        });
        let kept = kept.collect();
        view.runs.hide_only(kept);
        return Ok(Vec::new());
    }
    let pane = state.table_pane_mut().ok_or(NO_TABLE)?;
    let mut hidden = pane.hidden().to_vec();
    hidden.retain(|own| !head.is_empty() && own != head);
    pane.hide_only(hidden);
    Ok(Vec::new())
}

/// Says what the column of this head is.
pub(super) fn explain_named(state: &mut AppState, head: &str) -> Result<Vec<Effect>, String> {
    if let Some((view, column)) = run_column(state, head) {
        view.runs.column = view.runs.name_of(column);
        return Ok(explain_run_column(state));
    }
    pane_with(state, head)?.go_to(head);
    explain(state).ok_or_else(|| NO_TABLE.to_owned())
}

const NO_TABLE: &str = "There is no table here.";

/// The column of runs of this head, where the runs have the focus.
fn run_column<'a>(state: &'a mut AppState, head: &str) -> Option<(&'a mut RunsView, RunColumn)> {
    if state.focus() != PaneId::Runs {
        return None;
    }
    let view = state.runs_view_mut()?;
    let mut columns = view.runs.shown_columns().iter().copied();
    let column = columns.find(|column| plain_head(&view.runs, *column) == head)?;
    Some((view, column))
}

/// The table that has the focus, where it has a column of this head.
fn pane_with<'a>(state: &'a mut AppState, head: &str) -> Result<&'a mut TablePane, String> {
    let table = state.focused_table().ok_or(NO_TABLE)?;
    if !table.columns.iter().any(|column| column.head == head) {
        return Err(format!("The table has no column `{head}`."));
    }
    state.table_pane_mut().ok_or_else(|| NO_TABLE.to_owned())
}

/// Says what the result of the load cases that is shown is.
pub fn explain_result(state: &mut AppState) -> Vec<Effect> {
    let view = state
        .document
        .as_ref()
        .and_then(|document| document.sweeps());
    let shown = view.and_then(|view| view.open.as_ref()?.shown());
    let Some(name) = shown.map(|result| result.name.clone()) else {
        return info(state, "No result is shown.");
    };
    show(state, &name, run_columns::result(&name));
    Vec::new()
}

fn show(state: &mut AppState, head: &str, words: String) {
    state.overlay = Some(Overlay::Explanation {
        title: head.trim().to_owned(),
        text: words,
    });
}

/// Drops the filter of the list that has the focus; false where there is none.
pub fn drop_filter(state: &mut AppState) -> bool {
    let Some((filter, cursor, _)) = state.filter_mut() else {
        return false;
    };
    if filter.is_empty() {
        return false;
    }
    *filter = Filter::default();
    *cursor = 0;
    super::filter::filtered(state);
    true
}

/// Begins to type the filter of the list that has the focus.
pub(super) fn begin_filter(state: &mut AppState) -> Vec<Effect> {
    match state.filter_mut() {
        Some((filter, ..)) => {
            filter.typing = true;
            Vec::new()
        }
        None => info(state, "There is no list here to be filtered."),
    }
}
