//! The list of cases, and opening one.

use std::path::PathBuf;

use super::text_input::type_key;
use super::{edit, jobs, moved, runs};
use crate::tui::case_library::FIRST;
use crate::tui::command::Id;
use crate::tui::key::Key;
use crate::tui::line_tables::LineTable;
use crate::tui::msg::{CaseRead, Effect};
use crate::tui::pane::PaneId;
use crate::tui::state::modes::ModesView;
use crate::tui::state::open_case::Live;
use crate::tui::state::{
    AppState, CaseEntry, ChartKind, Level, OpenCase, Overlay, ParameterEditor, Question,
};
use crate::tui::table_pane::TablePane;

pub(super) fn command(state: &mut AppState, id: Id) -> Vec<Effect> {
    match (id, state.cases.current()) {
        (Id::Open, Some(entry)) => vec![Effect::ReadCase(entry.path.clone())],
        (Id::Reload, _) => vec![Effect::ReadCases],
        _ => Vec::new(),
    }
}

/// Keys while the filter is typed.
pub(super) fn typing_key(state: &mut AppState, key: Key) -> Option<Vec<Effect>> {
    if state.editor().is_some() || !state.cases.typing {
        return None;
    }
    let lines = state.cases.shown().count();
    let cases = &mut state.cases;
    match key {
        Key::Enter => cases.typing = false,
        Key::Esc | Key::Ctrl('c') => {
            cases.typing = false;
            cases.filter.reset();
            cases.cursor = 0;
        }
        Key::Down => cases.cursor = moved(cases.cursor, 1, lines),
        Key::Up => cases.cursor = moved(cases.cursor, -1, lines),
        Key::Ctrl('z') => return Some(vec![Effect::Suspend]),
        _ => {
            if type_key(&mut cases.filter, key) {
                cases.cursor = 0;
            }
        }
    }
    Some(Vec::new())
}

pub(super) fn listed(state: &mut AppState, dir: PathBuf, entries: Vec<CaseEntry>) -> Vec<Effect> {
    let before = state.cases.current().map(|e| e.path.clone());
    state.cases.dir = dir;
    state.cases.entries = entries;
    // The cursor stays on its case; at first it is on the one that newcomers should see.
    let at = match before {
        Some(path) => state.cases.shown().position(|e| e.path == path),
        None => state.cases.shown().position(|e| e.name == FIRST),
    };
    let lines = state.cases.shown().count();
    state.cases.cursor = at
        .unwrap_or(state.cases.cursor)
        .min(lines.saturating_sub(1));
    Vec::new()
}

pub(super) fn rejected(state: &mut AppState, title: String, text: String) -> Vec<Effect> {
    state.say(Level::Error, format!("{title} cannot be opened."));
    state.overlay = Some(Overlay::Text {
        title,
        text,
        scroll: 0,
    });
    Vec::new()
}

pub(super) fn opened(state: &mut AppState, read: CaseRead) -> Vec<Effect> {
    let CaseRead {
        path,
        text,
        case,
        recovered,
    } = read;
    let editor = ParameterEditor::new(path, text);
    let chart = ChartKind::of(&case)
        .first()
        .copied()
        .unwrap_or(ChartKind::Shape);
    state.close();
    state.open = Some(OpenCase {
        editor,
        case,
        pane: PaneId::Inputs,
        chart,
        views: Default::default(),
        series: None,
        instant: None,
        live: Live::default(),
        runs: Vec::new(),
        run: 0,
        checks: Vec::new(),
        checks_pane: TablePane::default(),
        line_table: LineTable::default(),
        nodes_pane: TablePane::default(),
        modes: ModesView::default(),
        report: None,
        report_scroll: (0, 0),
    });
    edit::refresh(state);
    let mut effects = jobs::resolve(state);
    effects.extend(state.open.as_ref().map(runs::list));
    if let Some(text) = recovered {
        state.overlay = Some(Overlay::Ask(Question::Recover { text }));
    }
    effects
}
