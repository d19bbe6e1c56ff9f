//! Keys while something lies over the screen, and the commands by their name.

use tui_input::Input;

use super::motion::moved;
use super::notice::info;
use super::text_input::type_key;
use super::{
    build, column_plot, command_line, curves, edit, end, export, jobs, keys, line_types, pages,
    quit, resume, run_table, runs, studies, sweeps, tables, trials, tutorial, vary,
};
use crate::chart::Glyphs;
use crate::command::CommandId;
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::report::document::ReportFormat;
use crate::state::command_line::CommandLine;
use crate::state::parameter_editor::AfterSave;
use crate::state::{AppState, Filter, Overlay, PromptPurpose, Question};
use crate::view::last_scroll;
use crate::{panes, visible};

pub(super) fn key(state: &mut AppState, key: KeyPress) -> Vec<Effect> {
    if key == KeyPress::Ctrl('z') {
        return vec![Effect::Suspend];
    }
    let Some(mut overlay) = state.overlay.take() else {
        return Vec::new();
    };
    let last = last_scroll(state, &overlay);
    if key == KeyPress::Ctrl('c') && !matches!(overlay, Overlay::Ask(_)) {
        return Vec::new();
    }
    if let Overlay::Help { scroll, filter } | Overlay::Messages { scroll, filter } = &mut overlay
        && filters(filter, key)
    {
        *scroll = 0;
        state.overlay = Some(overlay);
        return Vec::new();
    }
    match overlay {
        Overlay::Text { file, .. } if key == KeyPress::Char('E') => vec![Effect::EditFile(file)],
        Overlay::Page {
            title,
            text,
            scroll,
        } if key == KeyPress::Char('w') => {
            let effects = pages::write(state, &title, &text);
            state.overlay = Some(Overlay::Page {
                title,
                text,
                scroll,
            });
            effects
        }
        Overlay::Explanation { .. } => Vec::new(),
        Overlay::Help { ref mut scroll, .. }
        | Overlay::Page { ref mut scroll, .. }
        | Overlay::Messages { ref mut scroll, .. }
        | Overlay::Text { ref mut scroll, .. } => {
            if let Some(moved) = scrolled(*scroll, key) {
                *scroll = moved.min(last);
                state.overlay = Some(overlay);
            }
            Vec::new()
        }
        Overlay::Palette(line) => command_line::key(state, line, key),
        Overlay::Columns(pair) => column_plot::key(state, pair, key),
        Overlay::Picker(picker) => build::picker::key(state, picker, key),
        Overlay::Form(form) => build::form::key(state, form, key),
        Overlay::LineTypes(picker) => line_types::key(state, picker, key),
        Overlay::Curves { cursor } => curves::key(state, cursor, key),
        Overlay::Studies { items, cursor } => choose_study(state, items, cursor, key),
        Overlay::Prompt {
            purpose,
            input,
            words,
        } => prompt(state, purpose, input, words, key),
        Overlay::Ask(question) => answer(state, question, key),
    }
}

/// Takes a key for the filter of a list that lies over the screen; false where it is for the list.
fn filters(filter: &mut Filter, key: KeyPress) -> bool {
    match key {
        KeyPress::Char('/') if !filter.typing => filter.typing = true,
        KeyPress::Enter if filter.typing => filter.typing = false,
        KeyPress::Esc if filter.is_in_use() => *filter = Filter::default(),
        key if filter.typing => _ = type_key(&mut filter.input, key),
        _ => return false,
    }
    true
}

/// The new scroll position; none closes.
fn scrolled(scroll: usize, key: KeyPress) -> Option<usize> {
    Some(match key {
        KeyPress::Down | KeyPress::Char('j') => scroll.saturating_add(1),
        KeyPress::Up | KeyPress::Char('k') => scroll.saturating_sub(1),
        KeyPress::PageDown | KeyPress::Char(' ') => scroll.saturating_add(10),
        KeyPress::PageUp => scroll.saturating_sub(10),
        KeyPress::Home | KeyPress::Char('g') => 0,
        KeyPress::End | KeyPress::Char('G') => usize::MAX,
        _ => return None,
    })
}

fn choose_study(
    state: &mut AppState,
    items: Vec<String>,
    mut cursor: usize,
    key: KeyPress,
) -> Vec<Effect> {
    match key {
        KeyPress::Esc | KeyPress::Char('q') => return Vec::new(),
        KeyPress::Enter => return studies::study(state, cursor),
        KeyPress::Down | KeyPress::Char('j') => cursor = moved(cursor, 1, items.len()),
        KeyPress::Up | KeyPress::Char('k') => cursor = moved(cursor, -1, items.len()),
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
    key: KeyPress,
) -> Vec<Effect> {
    match (key, &purpose) {
        (KeyPress::Esc, _) => {
            if let Some(editor) = state.editor_mut() {
                editor.after_save = AfterSave::Stay;
            }
            return Vec::new();
        }
        (KeyPress::Enter, PromptPurpose::SaveAs) => {
            if let Some(effects) = quit::save_as(state, input.value().trim()) {
                return effects;
            }
        }
        (KeyPress::Enter, PromptPurpose::RunText { what, dirs }) => {
            return run_table::take_text(state, *what, dirs, input.value().trim());
        }
        (KeyPress::Enter, PromptPurpose::Resume(dir)) => {
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

fn answer(state: &mut AppState, question: Question, key: KeyPress) -> Vec<Effect> {
    let (_, answers) = question.wording();
    let chosen = match key {
        // Nothing is lost by it.
        KeyPress::Enter if matches!(question, Question::JobsGoOn { .. }) => answers.first(),
        KeyPress::Char(c) => answers.iter().find(|(k, _)| *k == c.to_ascii_lowercase()),
        KeyPress::Esc | KeyPress::Ctrl('c') => answers.last(),
        _ => None,
    };
    let Some(&(chosen, _)) = chosen else {
        state.overlay = Some(Overlay::Ask(question));
        return Vec::new();
    };
    match (question, chosen) {
        (Question::Unsaved { quit }, 's') => quit::save_then_leave(state, quit),
        (Question::Unsaved { quit }, 'd') => quit::drop_edits(state, quit),
        (Question::JobsRunning | Question::JobsGoOn { .. }, 'q') => end::now(state),
        (Question::JobsGoOn { .. }, 'x') => quit::cancel_and_quit(state),
        (Question::DeleteRuns { dirs, .. }, 'd') => vec![Effect::DeleteRuns(dirs)],
        (Question::Recover { left }, 'r') => edit::recover(state, left),
        (Question::Recover { .. }, 'd') => state
            .editor()
            .map(|editor| Effect::DropRecovery(editor.path.clone()))
            .into_iter()
            .collect(),
        (Question::ManyRuns { .. }, 'r') => vary::begin(state),
        (Question::ReportFormat, key) => match Question::format_of(key) {
            Some(format) => export::write_report_as(state, format),
            None => Vec::new(),
        },
        (Question::Overwrite, 'o') => quit::overwrite(state),
        (Question::Overwrite, 'a') => quit::ask_name(state, "the file has changed on disk"),
        _ => Vec::new(),
    }
}

/// Draws with these characters from now on, and remembers it.
pub(super) fn choose_glyphs(state: &mut AppState, glyphs: Glyphs) -> Vec<Effect> {
    state.capabilities.glyphs = glyphs;
    state.capabilities.unsure = false;
    vec![Effect::RememberGlyphs(glyphs)]
}

/// Does what the command says, or says why not.
pub fn run_command(state: &mut AppState, id: CommandId) -> Vec<Effect> {
    if let Err(reason) = panes::enabled(state, id) {
        return info(state, reason);
    }
    let pane = panes::pane(state.focus());
    pane.update(state, id)
        .or_else(|| tables::command(state, id))
        .or_else(|| document_command(state, id))
        .unwrap_or_else(|| everywhere(state, id))
}

/// What a command does to the document that is open, whatever pane has the focus.
fn document_command(state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
    let document = state.document.as_ref()?;
    Some(match id {
        CommandId::NextPane | CommandId::PreviousPane | CommandId::Pane(_) => go(state, id)?,
        CommandId::Undo => edit::undo(state),
        CommandId::Redo => edit::redo(state),
        CommandId::Method => edit::next_method(state),
        CommandId::AddLineType => line_types::open(state),
        CommandId::Model => {
            state.document.as_mut()?.pane = PaneId::Model;
            Vec::new()
        }
        CommandId::Save => quit::save(state),
        CommandId::Back => quit::back(state),
        CommandId::Run => jobs::run(state),
        CommandId::StartSweep => sweeps::start(state),
        CommandId::Sweep => {
            sweeps::go(state);
            Vec::new()
        }
        CommandId::Study => studies::ask(state),
        CommandId::Validate => studies::validate(state),
        CommandId::Keep => runs::keep(state),
        CommandId::Trials => trials::show(state),
        CommandId::LineInput => export::write_line_input(state),
        CommandId::Write => export::write_report(state, ReportFormat::Text),
        CommandId::WriteAs => export::ask_format(state),
        CommandId::Copy => {
            let text = visible::toml(document.kind().copy()?).into_owned();
            vec![Effect::Copy(text)]
        }
        _ => return None,
    })
}

/// What a command does wherever it is given.
fn everywhere(state: &mut AppState, id: CommandId) -> Vec<Effect> {
    match id {
        CommandId::Help => {
            state.overlay = Some(Overlay::Help {
                scroll: 0,
                filter: Filter::default(),
            });
        }
        CommandId::Messages => {
            state.overlay = Some(Overlay::Messages {
                scroll: 0,
                filter: Filter::default(),
            });
        }
        CommandId::Palette => {
            state.overlay = Some(Overlay::Palette(CommandLine::default()));
        }
        CommandId::Glyphs => {
            let other = match state.capabilities.glyphs {
                Glyphs::Braille => Glyphs::Ascii,
                Glyphs::Ascii => Glyphs::Braille,
            };
            return choose_glyphs(state, other);
        }
        CommandId::Filter => return tables::begin_filter(state),
        CommandId::Tutorial => return tutorial::turn(state),
        CommandId::TutorialSkip => return tutorial::skip(state),
        CommandId::Keys => return vec![Effect::EditKeys],
        CommandId::ReadSettings => return vec![Effect::ReadSettings],
        CommandId::Redraw => return vec![Effect::Repaint],
        CommandId::Interrupt => return keys::interrupt(state),
        CommandId::Suspend => return vec![Effect::Suspend],
        CommandId::Quit => return quit::quit(state),
        _ => {}
    }
    Vec::new()
}

/// Goes to another pane.
fn go(state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
    let document = state.document.as_mut()?;
    let panes = document.kind().info().panes;
    // From the model, which has no number, to the first and the last.
    let now = panes.iter().position(|pane| *pane == document.pane);
    let next = match id {
        CommandId::NextPane if now.is_none() => 0,
        CommandId::PreviousPane if now.is_none() => panes.len() - 1,
        CommandId::NextPane => now? + 1,
        CommandId::PreviousPane => now? + panes.len() - 1,
        CommandId::Pane(number) => usize::from(number.saturating_sub(1)).min(panes.len() - 1),
        _ => now?,
    };
    document.pane = panes[next % panes.len()];
    // Runs that other programs computed may have ended.
    let runs = document.pane == PaneId::Runs;
    Some(runs.then_some(Effect::RefreshRuns).into_iter().collect())
}
