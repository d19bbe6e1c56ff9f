//! A file other than a line case on the screen: what is the same for every kind. What is not stands in [`section`],
//! [`ropeway`] and [`ship`].

use std::path::PathBuf;

use super::{edit, export, info, overlay, ropeway, section, ship};
use crate::reference;
use crate::report::chart::Glyphs;
use crate::tui::command::Id;
use crate::tui::msg::{Effect, FileRead};
use crate::tui::pane::PaneId;
use crate::tui::state::{AppState, Content, OpenFile, Overlay, ParameterEditor, Question};
use crate::tui::table_pane::TableVerb;

pub(super) fn opened(state: &mut AppState, read: FileRead) -> Vec<Effect> {
    state.close();
    let editor = ParameterEditor::new(read.path, read.text);
    state.file = Some(OpenFile::new(editor, read.content));
    edit::refresh(state);
    if let Some(text) = read.recovered {
        state.overlay = Some(Overlay::Ask(Question::Recover { text }));
    }
    ship::resolve(state).into_iter().collect()
}

/// What a command does to a file of another kind; absent: the same as everywhere.
pub(super) fn command(state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
    let own = match state.file.as_ref()?.content {
        Content::Section(_) => section::command(state, id),
        Content::Ropeway(_) => ropeway::command(state, id),
        Content::Ship(_) => ship::command(state, id),
    };
    if own.is_some() {
        return own;
    }
    let glyphs = state.capabilities.glyphs;
    let file = state.file.as_mut()?;
    let tabs = file.panes.len().max(1);
    match id {
        Id::NextTable => file.tab = (file.tab + 1) % tabs,
        Id::PreviousTable => file.tab = (file.tab + tabs - 1) % tabs,
        Id::ScrollLeft | Id::ScrollRight | Id::Sort => act(file, export::table_verb(id)),
        Id::HandOver => {
            let (path, text, what) = file.content.view().hand_over(stem(file));
            return Some(match text {
                Some(text) => export::write(path, Some(text), what),
                None => info(state, "There is nothing to write as it stands."),
            });
        }
        Id::Write => return Some(write(file, glyphs)),
        _ => return None,
    }
    Some(Vec::new())
}

/// The name of the file without its ending.
pub(super) fn stem(file: &OpenFile) -> &str {
    file.editor.file.trim_end_matches(".toml")
}

fn act(file: &mut OpenFile, verb: TableVerb) {
    if file.pane == PaneId::Checks {
        let table = reference::table(&file.checks);
        file.checks_pane.act(verb, &table);
    } else {
        let (_, table) = file.shown();
        if let Some(pane) = file.panes.get_mut(file.tab) {
            pane.act(verb, &table);
        }
    }
}

/// Writes the report, or from its pane the validation table.
fn write(file: &OpenFile, glyphs: Glyphs) -> Vec<Effect> {
    let stem = stem(file);
    if file.pane == PaneId::Checks {
        let words = crate::report::text::validation(&file.checks);
        let path = PathBuf::from(format!("{stem}-validation.txt"));
        return export::write(path, Some(words), "The validation table");
    }
    let words = file.content.view().report(&file.editor.text, glyphs);
    let (name, what) = file.content.view().paper();
    let path = PathBuf::from(format!("{stem}-{name}.txt"));
    export::write(path, words, what)
}

/// Goes to another pane.
pub(super) fn pane(state: &mut AppState, id: Id) -> Vec<Effect> {
    if let Some(file) = &mut state.file {
        let panes = file.content.view().panes();
        let now = panes.iter().position(|p| *p == file.pane).unwrap_or(0);
        file.pane = panes[match id {
            Id::NextPane => (now + 1) % panes.len(),
            Id::PreviousPane => (now + panes.len() - 1) % panes.len(),
            Id::Pane(n) => usize::from(n.saturating_sub(1)).min(panes.len() - 1),
            _ => now,
        }];
    }
    Vec::new()
}

/// Moves the cursor of the pane.
pub(super) fn move_by(state: &mut AppState, by: isize) -> Vec<Effect> {
    if let Some(file) = &mut state.file {
        match (file.pane, &mut file.content) {
            (PaneId::Checks | PaneId::Tables, _) => act(file, overlay::by_rows(by)),
            (PaneId::Ship, Content::Ship(ship)) => ship::choose(ship, by),
            _ => {
                let editor = &mut file.editor;
                editor.field = super::moved(editor.field, by, editor.fields().count());
            }
        }
    }
    Vec::new()
}
