//! Natural modes on the screen: found in the background, anew when the case changes, one search at a time.

use std::path::PathBuf;
use std::sync::Arc;

use super::{overlay, papers};
use crate::modes::LineModes;
use crate::report::modes as views;
use crate::tui::command::Id;
use crate::tui::msg::Effect;
use crate::tui::place::Place;
use crate::tui::state::State;

/// Asks for the modes of the case as it stands, where they are seen and not known.
pub(super) fn follow(state: &mut State) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let view = &mut open.modes;
    match open.pane {
        Place::Modes => view.beside = true,
        Place::Inputs | Place::Runs | Place::Jobs => {}
        _ => view.beside = false,
    }
    let known = view.found.is_some() && view.text == open.sheet.text;
    if !view.beside || known || view.going.is_some() {
        return Vec::new();
    }
    let text = open.sheet.text.clone();
    view.going = Some(text.clone());
    vec![Effect::FindModes {
        case: Box::new(open.case.clone()),
        text,
    }]
}

/// The modes of a text; dropped where nobody waits for them any more.
pub(super) fn found(
    state: &mut State,
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
pub(super) fn command(state: &mut State, id: Id) -> Option<Vec<Effect>> {
    let by = overlay::step(state, id);
    let open = state.open.as_mut().filter(|o| o.pane == Place::Modes)?;
    let found = match &open.modes.found {
        Some(Ok(found)) => Some(Arc::clone(found)),
        _ => None,
    };
    match id {
        Id::NextChart | Id::PreviousChart => open.modes.over = !open.modes.over,
        Id::Write => {
            let stem = open.sheet.file.trim_end_matches(".toml");
            let path = PathBuf::from(format!("{stem}-modes.csv"));
            let text = found.map(|found| views::csv(&found));
            return Some(papers::write(path, text, "The table of modes"));
        }
        Id::ScrollLeft | Id::ScrollRight => {
            let table = found.map(|found| views::table(&found))?;
            open.modes.pane.act(papers::table_verb(id), &table);
        }
        _ => {
            let verb = overlay::by_rows(by?);
            let table = found.map(|found| views::table(&found))?;
            open.modes.pane.act(verb, &table);
        }
    }
    Some(Vec::new())
}
