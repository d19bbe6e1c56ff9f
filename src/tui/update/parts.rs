//! Parts of the screen that are worked out behind it: asked for where they are seen, and taken when they are there.

use std::sync::Arc;

use crate::msg::Effect;
use crate::pane::PaneId;
use crate::state::parts::{PartKey, PartView, ScreenPart};
use crate::state::value_check::{ValidationTable, ValueCheck};
use crate::state::{AppState, Document};
use crate::view::layout;

/// The part that a pane shows, if any.
#[must_use]
pub fn of_pane(document: &Document, pane: PaneId) -> Option<ScreenPart> {
    match pane {
        PaneId::Model if document.line().is_some() => None,
        PaneId::Drawing | PaneId::Ropeway | PaneId::Ship | PaneId::System | PaneId::Model => {
            Some(ScreenPart::Drawing)
        }
        PaneId::Tables => Some(ScreenPart::Tab(document.tab)),
        PaneId::Nodes => {
            let line = document.line()?;
            let (_, run, _) = line.runs_view.reported()?;
            Some(ScreenPart::Line(line.line_table.or_nodes(&run)))
        }
        _ => None,
    }
}

/// Asks for the parts that are seen and not known as they are now.
pub(super) fn follow(state: &mut AppState) -> Vec<Effect> {
    let panes = layout::seen(state);
    let Some(document) = &mut state.document else {
        return Vec::new();
    };
    let parts = panes.into_iter().filter_map(|pane| of_pane(document, pane));
    let parts: Vec<ScreenPart> = parts.collect();
    let asked = parts.into_iter().filter_map(|part| document.ask_part(part));
    asked
        .map(|request| Effect::MakePart(Box::new(request)))
        .collect()
}

/// A part is there.
pub(super) fn made(state: &mut AppState, key: PartKey, view: Arc<PartView>) -> Vec<Effect> {
    if let Some(document) = &mut state.document {
        document.parts.take(key, view);
    }
    Vec::new()
}

/// Asks for the validation table of a line case where it is older than its runs, one comparison after the other.
pub(super) fn follow_checks(state: &mut AppState) -> Option<Effect> {
    let document = state.document.as_mut()?;
    let edited = document.editor.edited.clone();
    let (line, editor) = document.line_and_editor()?;
    if !line.checking.is_due || line.checking.asked.is_some() {
        return None;
    }
    let check = ValueCheck {
        token: Arc::default(),
        case: Box::new(line.case.clone()),
        edited,
        runs: line.checked_runs(&editor.text),
    };
    line.checking.is_due = false;
    line.checking.asked = Some(Arc::clone(&check.token));
    Some(Effect::CheckValues(Box::new(check)))
}

/// The validation table is there.
pub(super) fn compared(
    state: &mut AppState,
    token: &Arc<()>,
    table: ValidationTable,
) -> Vec<Effect> {
    if let Some(line) = state.line_mut()
        && let Some(asked) = &line.checking.asked
        && Arc::ptr_eq(asked, token)
    {
        line.checking.asked = None;
        line.checks = table;
    }
    Vec::new()
}

/// Whether what the pane with the focus shows is being worked out.
#[must_use]
pub fn is_open(state: &AppState) -> bool {
    let Some(document) = &state.document else {
        return false;
    };
    let focus = state.focus();
    let of_checks = matches!(focus, PaneId::Validation | PaneId::Report);
    let checking = document.line().is_some_and(|line| line.checking.is_open());
    let part = of_pane(document, focus);
    (of_checks && checking) || part.is_some_and(|part| !document.is_shown(part))
}

/// Whether anything that is seen is being worked out.
pub(super) fn any_open(state: &AppState) -> bool {
    let Some(document) = &state.document else {
        return false;
    };
    let checking = document.line().is_some_and(|line| line.checking.is_open());
    let mut parts = layout::seen(state)
        .into_iter()
        .filter_map(|pane| of_pane(document, pane));
    checking || parts.any(|part| !document.is_shown(part))
}
