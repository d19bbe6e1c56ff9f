//! Natural modes on the screen: found in the background, anew when the case changes, one search at a time.

use std::path::PathBuf;
use std::sync::Arc;

use super::{export, overlay};
use crate::modes::LineModes;
use crate::report::modes as views;
use crate::tui::command::Id;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::AppState;

/// Asks for the modes of the case as it stands, where they are seen and not known.
pub(super) fn follow(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let view = &mut open.modes;
    match open.pane {
        PaneId::Modes => view.beside = true,
        PaneId::Inputs | PaneId::Runs | PaneId::Jobs => {}
        _ => view.beside = false,
    }
    let known = view.found.is_some() && view.text == open.editor.text;
    if !view.beside || known || view.going.is_some() {
        return Vec::new();
    }
    let text = open.editor.text.clone();
    view.going = Some(text.clone());
    vec![Effect::FindModes {
        case: Box::new(open.case.clone()),
        text,
    }]
}

/// The modes of a text; dropped where nobody waits for them any more.
pub(super) fn found(
    state: &mut AppState,
    text: String,
    found: Result<Arc<LineModes>, String>,
) -> Vec<Effect> {
    if let Some(open) = &mut state.open
        && open.modes.going.as_ref() == Some(&text)
    {
        open.modes.going = None;
        open.modes.found = Some(found);
        open.modes.text = text;
    }
    Vec::new()
}

/// What a command does in the pane of modes; absent: the same as everywhere.
pub(super) fn command(state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
    let by = overlay::step(state, id);
    let open = state.open.as_mut().filter(|o| o.pane == PaneId::Modes)?;
    let found = match &open.modes.found {
        Some(Ok(found)) => Some(Arc::clone(found)),
        _ => None,
    };
    match id {
        Id::NextChart | Id::PreviousChart => open.modes.over = !open.modes.over,
        Id::Write => {
            let stem = open.editor.file.trim_end_matches(".toml");
            let path = PathBuf::from(format!("{stem}-modes.csv"));
            let text = found.map(|found| views::csv(&found));
            return Some(export::write(path, text, "The table of modes"));
        }
        Id::ScrollLeft | Id::ScrollRight => {
            let table = found.map(|found| views::table(&found))?;
            open.modes.pane.act(export::table_verb(id), &table);
        }
        _ => {
            let verb = overlay::by_rows(by?);
            let table = found.map(|found| views::table(&found))?;
            open.modes.pane.act(verb, &table);
        }
    }
    Some(Vec::new())
}
