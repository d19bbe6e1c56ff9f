//! Keys while something lies over the screen, and the commands by their name.

use tui_input::Input;

use super::text_input::type_key;
use super::{
    cases, charts, edit, enabled, export, file, jobs, keys, moved, quit, resume, runs, studies,
};
use super::{modes, trials};
use crate::report::chart::Glyphs;
use crate::tui::command::{self, Command, Id};
use crate::tui::facade;
use crate::tui::key::Key;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::{AppState, Choice, Level, Overlay, Question};
use crate::tui::table_pane::TableVerb;

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
        Overlay::Choose {
            choice,
            items,
            cursor,
        } => choose(state, choice, items, cursor, key),
        Overlay::SaveAs { input, why } => quit::save_as_key(state, input, why, key),
        Overlay::Until { dir, input, words } => resume::key(state, dir, input, words, key),
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
pub fn palette_matches(place: PaneId, typed: &str) -> Vec<&'static Command> {
    let typed = typed.to_lowercase();
    command::at(place)
        .filter(|c| {
            let text = format!("{:?} {} {} {}", c.id, c.label, c.keys.join(" "), c.doc);
            crate::tui::state::case_list::passes(&text, &typed)
        })
        .collect()
}

fn palette(state: &mut AppState, mut input: Input, mut cursor: usize, key: Key) -> Vec<Effect> {
    let found = palette_matches(state.focus(), input.value());
    match key {
        Key::Esc => return Vec::new(),
        Key::Enter => {
            return match found.get(cursor) {
                Some(command) => run_command(state, command.id),
                None => super::info(state, "No command has that name."),
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

fn choose(
    state: &mut AppState,
    choice: Choice,
    items: Vec<String>,
    mut cursor: usize,
    key: Key,
) -> Vec<Effect> {
    match key {
        Key::Esc | Key::Char('q') => return Vec::new(),
        Key::Enter => {
            return match choice {
                Choice::Study => studies::study(state, cursor),
            };
        }
        Key::Down | Key::Char('j') => cursor = moved(cursor, 1, items.len()),
        Key::Up | Key::Char('k') => cursor = moved(cursor, -1, items.len()),
        _ => {}
    }
    state.overlay = Some(Overlay::Choose {
        choice,
        items,
        cursor,
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
    if let Err(reason) = enabled(state, id) {
        return super::info(state, reason);
    }
    if let Some(effects) = trials::command(state, id) {
        return effects;
    }
    if let Some(effects) = modes::command(state, id) {
        return effects;
    }
    if state.file.is_some()
        && let Some(effects) = file::command(state, id)
    {
        return effects;
    }
    match id {
        Id::Help => open_overlay(state, Overlay::Help { scroll: 0 }),
        Id::Messages => open_overlay(state, Overlay::Messages { scroll: 0 }),
        Id::Palette => open_overlay(
            state,
            Overlay::Palette {
                input: Input::default(),
                cursor: 0,
            },
        ),
        Id::Glyphs => {
            let other = match state.capabilities.glyphs {
                Glyphs::Braille => Glyphs::Ascii,
                Glyphs::Ascii => Glyphs::Braille,
            };
            choose_glyphs(state, other)
        }
        Id::Redraw => vec![Effect::Repaint],
        Id::Interrupt => keys::interrupt(state),
        Id::Suspend => vec![Effect::Suspend],
        Id::Quit => quit::quit(state),
        Id::Back => quit::back(state),
        Id::Open | Id::Reload => cases::command(state, id),
        Id::Filter => {
            match state.editor_mut() {
                Some(editor) => editor.filtering = true,
                None => state.cases.typing = true,
            }
            Vec::new()
        }
        Id::Down | Id::Up | Id::PageDown | Id::PageUp | Id::Top | Id::Bottom => {
            let by = step(state, id);
            by.map_or_else(Vec::new, |by| move_by(state, by))
        }
        Id::NextPane | Id::PreviousPane | Id::Pane(_) => pane(state, id),
        Id::Edit
        | Id::Reset
        | Id::Undo
        | Id::Redo
        | Id::NextGroup
        | Id::PreviousGroup
        | Id::Method
        | Id::ExternalEditor => edit::command(state, id),
        Id::Save => quit::save(state),
        Id::Run | Id::Study | Id::Validate | Id::CancelJob => jobs::command(state, id),
        Id::Resume => resume::ask(state),
        Id::Trials => trials::show(state),
        Id::Keep | Id::ShowAlone | Id::Select | Id::SelectNone | Id::Delete => {
            runs::command(state, id)
        }
        Id::NextTable => export::next_table(state, true),
        Id::PreviousTable => export::next_table(state, false),
        Id::Write | Id::ScrollLeft | Id::ScrollRight | Id::Sort => export::paper(state, id),
        _ => charts::command(state, id),
    }
}

fn open_overlay(state: &mut AppState, overlay: Overlay) -> Vec<Effect> {
    state.overlay = Some(overlay);
    Vec::new()
}

/// By how many lines a command moves a cursor.
pub(super) fn step(state: &AppState, id: Id) -> Option<isize> {
    match id {
        Id::Down => Some(1),
        Id::Up => Some(-1),
        Id::PageDown => Some(page(state)),
        Id::PageUp => Some(-page(state)),
        Id::Top => Some(isize::MIN / 2),
        Id::Bottom => Some(isize::MAX / 2),
        _ => None,
    }
}

fn page(state: &AppState) -> isize {
    isize::try_from(state.size.1.saturating_sub(8).max(2) / 2).unwrap_or(8)
}

fn pane(state: &mut AppState, id: Id) -> Vec<Effect> {
    if state.file.is_some() {
        return file::pane(state, id);
    }
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let panes = PaneId::PANES;
    let now = panes.iter().position(|p| *p == open.pane).unwrap_or(0);
    let next = match id {
        Id::NextPane => (now + 1) % panes.len(),
        Id::PreviousPane => (now + panes.len() - 1) % panes.len(),
        Id::Pane(n) => usize::from(n.saturating_sub(1)).min(panes.len() - 1),
        _ => now,
    };
    open.pane = panes[next];
    match open.pane {
        PaneId::Report => export::write_report(state),
        // Runs that other programs computed may have come to their end.
        PaneId::Runs => return vec![runs::list(open)],
        _ => {}
    }
    Vec::new()
}

/// The selection of a table by so many rows.
pub(super) fn by_rows(by: isize) -> TableVerb {
    let rows = by.unsigned_abs();
    if by < 0 {
        TableVerb::PageUp(rows)
    } else {
        TableVerb::PageDown(rows)
    }
}

fn move_by(state: &mut AppState, by: isize) -> Vec<Effect> {
    if state.file.is_some() {
        return file::move_by(state, by);
    }
    let job_lines = state.jobs.lines.len();
    match (&mut state.open, state.cases.shown().count()) {
        (None, lines) => state.cases.cursor = moved(state.cases.cursor, by, lines),
        (Some(open), _) => match open.pane {
            PaneId::Inputs => {
                open.editor.field = moved(open.editor.field, by, open.editor.fields().count());
            }
            PaneId::Runs => open.run = moved(open.run, by, open.runs.len() + 1),
            PaneId::Validation => {
                open.checks_pane
                    .act(by_rows(by), &facade::checks_table(&open.checks));
            }
            PaneId::Nodes => {
                let verb = by_rows(by);
                if let Some(table) = export::line_table(open) {
                    open.nodes_pane.act(verb, &table);
                }
            }
            PaneId::Report => {
                let lines = open.report.as_ref().map_or(0, |(_, t)| t.lines().count());
                open.report_scroll.0 = moved(open.report_scroll.0, by, lines);
            }
            PaneId::Jobs => state.jobs.cursor = moved(state.jobs.cursor, by, job_lines),
            _ => {}
        },
    }
    Vec::new()
}

/// The level is part of the signature of [`AppState::say`]; a warning for what the user should not miss.
pub(super) fn warn(state: &mut AppState, text: impl Into<String>) -> Vec<Effect> {
    state.say(Level::Warning, text);
    Vec::new()
}
