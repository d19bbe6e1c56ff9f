//! Keys while something lies over the screen, and the commands by their name.

use tui_input::Input;

use super::motion::moved;
use super::notice::info;
use super::text_input::type_key;
use super::{edit, export, jobs, keys, quit, resume, runs, studies, trials};
use crate::report::chart::Glyphs;
use crate::tui::command::{Command, Id};
use crate::tui::key::Key;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::panes;
use crate::tui::state::parameter_editor::AfterSave;
use crate::tui::state::{AppState, Overlay, PromptPurpose, Question};

pub(super) fn key(state: &mut AppState, key: Key) -> Vec<Effect> {
    if key == Key::Ctrl('z') {
        return vec![Effect::Suspend];
    }
    let Some(overlay) = state.overlay.take() else {
        return Vec::new();
    };
    if key == Key::Ctrl('c') && !matches!(overlay, Overlay::Ask(_)) {
        return Vec::new();
    }
    match overlay {
        Overlay::Help { scroll } => {
            state.overlay = scrolled(scroll, key).map(|scroll| Overlay::Help { scroll });
            Vec::new()
        }
        Overlay::Messages { scroll } => {
            state.overlay = scrolled(scroll, key).map(|scroll| Overlay::Messages {
                scroll: scroll.min(state.log.len()),
            });
            Vec::new()
        }
        Overlay::Text {
            title,
            text,
            scroll,
        } => {
            let lines = text.lines().count();
            state.overlay = scrolled(scroll, key).map(|scroll| Overlay::Text {
                title,
                text,
                scroll: scroll.min(lines),
            });
            Vec::new()
        }
        Overlay::Palette { input, cursor } => palette(state, input, cursor, key),
        Overlay::Studies { items, cursor } => choose_study(state, items, cursor, key),
        Overlay::Prompt {
            purpose,
            input,
            words,
        } => prompt(state, purpose, input, words, key),
        Overlay::Ask(question) => answer(state, question, key),
    }
}

/// The new scroll position; none closes.
fn scrolled(scroll: usize, key: Key) -> Option<usize> {
    Some(match key {
        Key::Down | Key::Char('j') => scroll + 1,
        Key::Up | Key::Char('k') => scroll.saturating_sub(1),
        Key::PageDown | Key::Char(' ') => scroll + 10,
        Key::PageUp => scroll.saturating_sub(10),
        Key::Home | Key::Char('g') => 0,
        _ => return None,
    })
}

/// The commands whose name, key or text holds every word typed.
#[must_use]
pub fn palette_matches(state: &AppState, typed: &str) -> Vec<Command> {
    let typed = typed.to_lowercase();
    let mut commands = panes::commands(state);
    commands.retain(|c| {
        let text = format!("{:?} {} {} {}", c.id, c.label, c.keys.join(" "), c.doc);
        crate::tui::state::case_list::passes(&text, &typed)
    });
    commands
}

fn palette(state: &mut AppState, mut input: Input, mut cursor: usize, key: Key) -> Vec<Effect> {
    let found = palette_matches(state, input.value());
    match key {
        Key::Esc => return Vec::new(),
        Key::Enter => {
            return match found.get(cursor) {
                Some(command) => run_command(state, command.id),
                None => info(state, "No command has that name."),
            };
        }
        Key::Down | Key::Tab => cursor = moved(cursor, 1, found.len()),
        Key::Up | Key::BackTab => cursor = moved(cursor, -1, found.len()),
        _ => {
            if type_key(&mut input, key) {
                cursor = 0;
            }
        }
    }
    state.overlay = Some(Overlay::Palette { input, cursor });
    Vec::new()
}

fn choose_study(
    state: &mut AppState,
    items: Vec<String>,
    mut cursor: usize,
    key: Key,
) -> Vec<Effect> {
    match key {
        Key::Esc | Key::Char('q') => return Vec::new(),
        Key::Enter => return studies::study(state, cursor),
        Key::Down | Key::Char('j') => cursor = moved(cursor, 1, items.len()),
        Key::Up | Key::Char('k') => cursor = moved(cursor, -1, items.len()),
        _ => {}
    }
    state.overlay = Some(Overlay::Studies { items, cursor });
    Vec::new()
}

fn prompt(
    state: &mut AppState,
    purpose: PromptPurpose,
    mut input: Input,
    mut words: String,
    key: Key,
) -> Vec<Effect> {
    match (key, &purpose) {
        (Key::Esc, _) => {
            if let Some(editor) = state.editor_mut() {
                editor.after_save = AfterSave::Stay;
            }
            return Vec::new();
        }
        (Key::Enter, PromptPurpose::SaveAs) => {
            if let Some(effects) = quit::save_as(state, input.value().trim()) {
                return effects;
            }
        }
        (Key::Enter, PromptPurpose::Resume(dir)) => {
            match resume::until(dir.clone(), input.value().trim()) {
                Ok(effects) => return effects,
                Err(problem) => words = problem,
            }
        }
        _ => {
            type_key(&mut input, key);
        }
    }
    state.overlay = Some(Overlay::Prompt {
        purpose,
        input,
        words,
    });
    Vec::new()
}

fn answer(state: &mut AppState, question: Question, key: Key) -> Vec<Effect> {
    let (_, answers) = question.wording();
    let chosen = match key {
        Key::Char(c) => answers.iter().find(|(k, _)| *k == c.to_ascii_lowercase()),
        Key::Esc | Key::Ctrl('c') => answers.last(),
        _ => None,
    };
    let Some(&(chosen, _)) = chosen else {
        state.overlay = Some(Overlay::Ask(question));
        return Vec::new();
    };
    match (question, chosen) {
        (Question::Unsaved { quit }, 's') => quit::save_then_leave(state, quit),
        (Question::Unsaved { quit }, 'd') => quit::drop_edits(state, quit),
        (Question::JobsRunning, 'q') => vec![Effect::Quit],
        (Question::DeleteRun { dir, .. }, 'd') => vec![Effect::DeleteRun(dir)],
        (Question::Recover { text }, 'r') => edit::recover(state, text),
        (Question::Recover { .. }, 'd') => state
            .editor()
            .map(|editor| Effect::DropRecovery(editor.path.clone()))
            .into_iter()
            .collect(),
        (Question::Glyphs, c) => choose_glyphs(
            state,
            if c == 'y' {
                Glyphs::Braille
            } else {
                Glyphs::Ascii
            },
        ),
        (Question::Overwrite, 'o') => quit::overwrite(state),
        (Question::Overwrite, 'a') => quit::ask_name(state, "the file has changed on disk"),
        _ => Vec::new(),
    }
}

fn choose_glyphs(state: &mut AppState, glyphs: Glyphs) -> Vec<Effect> {
    state.capabilities.glyphs = glyphs;
    state.capabilities.unsure = false;
    vec![Effect::RememberGlyphs(glyphs)]
}

/// Does what the command says, or says why not.
pub fn run_command(state: &mut AppState, id: Id) -> Vec<Effect> {
    if let Err(reason) = panes::enabled(state, id) {
        return info(state, reason);
    }
    let pane = panes::pane(state.focus());
    pane.update(state, id)
        .or_else(|| document_command(state, id))
        .unwrap_or_else(|| everywhere(state, id))
}

/// What a command does to the document that is open, whatever pane has the focus.
fn document_command(state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
    let document = state.document.as_ref()?;
    Some(match id {
        Id::NextPane | Id::PreviousPane | Id::Pane(_) => go(state, id)?,
        Id::Undo => edit::undo(state),
        Id::Redo => edit::redo(state),
        Id::Method => edit::next_method(state),
        Id::Save => quit::save(state),
        Id::Back => quit::back(state),
        Id::Run => jobs::run(state),
        Id::Study => studies::ask(state),
        Id::Validate => studies::validate(state),
        Id::Keep => runs::keep(state),
        Id::Trials => trials::show(state),
        Id::LineInput => export::write_line_input(state),
        Id::Write => export::write_report(state),
        Id::Copy => {
            let text = document.kind().copy()?;
            vec![Effect::Copy(text)]
        }
        _ => return None,
    })
}

/// What a command does wherever it is given.
fn everywhere(state: &mut AppState, id: Id) -> Vec<Effect> {
    match id {
        Id::Help => state.overlay = Some(Overlay::Help { scroll: 0 }),
        Id::Messages => state.overlay = Some(Overlay::Messages { scroll: 0 }),
        Id::Palette => {
            state.overlay = Some(Overlay::Palette {
                input: Input::default(),
                cursor: 0,
            });
        }
        Id::Glyphs => {
            let other = match state.capabilities.glyphs {
                Glyphs::Braille => Glyphs::Ascii,
                Glyphs::Ascii => Glyphs::Braille,
            };
            return choose_glyphs(state, other);
        }
        Id::Redraw => return vec![Effect::Repaint],
        Id::Interrupt => return keys::interrupt(state),
        Id::Suspend => return vec![Effect::Suspend],
        Id::Quit => return quit::quit(state),
        _ => {}
    }
    Vec::new()
}

/// Goes to another pane.
fn go(state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
    let document = state.document.as_mut()?;
    let panes = document.kind().panes();
    let now = panes.iter().position(|pane| *pane == document.pane)?;
    let next = match id {
        Id::NextPane => now + 1,
        Id::PreviousPane => now + panes.len() - 1,
        Id::Pane(number) => usize::from(number.saturating_sub(1)).min(panes.len() - 1),
        _ => now,
    };
    document.pane = panes[next % panes.len()];
    match document.pane {
        PaneId::Report => export::make_report(document),
        // Runs that other programs computed may have ended.
        PaneId::Runs => return Some(runs::list(state).into_iter().collect()),
        _ => {}
    }
    Some(Vec::new())
}
