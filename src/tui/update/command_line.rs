//! Keys on the line on which a command is typed.

use tui_input::Input;

use super::line_commands::execute;
use super::motion::moved;
use super::overlay::run_command;
use super::text_input::type_key;
use crate::bindings::names::name;
use crate::command_line::candidates::{Argument, CompletionCandidate, candidates};
use crate::command_line::{LineCommand, typed};
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::panes;
use crate::state::command_line::CommandLine;
use crate::state::{AppState, Overlay};

/// Takes a key; the line closes where the key does so.
pub(super) fn key(state: &mut AppState, mut line: CommandLine, key: KeyPress) -> Vec<Effect> {
    let found = candidates(state, line.input.value());
    match key {
        KeyPress::Esc => return Vec::new(),
        KeyPress::Enter => return enter(state, line, &found),
        KeyPress::Tab => complete(&mut line, &found),
        KeyPress::Up if line.cursor == 0 => recall(state, &mut line, 1),
        KeyPress::Down if line.recalled.is_some() => recall(state, &mut line, -1),
        KeyPress::Down => line.cursor = moved(line.cursor, 1, found.len()),
        KeyPress::Up | KeyPress::BackTab => line.cursor = moved(line.cursor, -1, found.len()),
        KeyPress::PageDown => line.cursor = moved(line.cursor, PAGE, found.len()),
        KeyPress::PageUp => line.cursor = moved(line.cursor, -PAGE, found.len()),
        _ => {
            if type_key(&mut line.input, key) {
                begin_anew(&mut line);
            }
        }
    }
    state.overlay = Some(Overlay::Palette(line));
    Vec::new()
}

const PAGE: isize = 10;

/// What is typed has changed: what was said of it and chosen for it no longer holds.
pub(super) fn begin_anew(line: &mut CommandLine) {
    line.cursor = 0;
    line.problem.clear();
    line.recalled = None;
}

/// Takes what is under the cursor into the line; where it is there already, goes to the next.
fn complete(line: &mut CommandLine, found: &[CompletionCandidate]) {
    let now = line.input.value().to_owned();
    let Some(candidate) = found.get(line.cursor) else {
        return;
    };
    let completed = candidate.line(&now);
    if completed.trim_end() == now.trim_end() {
        line.cursor = moved(line.cursor, 1, found.len());
        return;
    }
    line.input = Input::new(completed);
    begin_anew(line);
}

/// Shows a line of before, older or newer ones.
fn recall(state: &AppState, line: &mut CommandLine, by: isize) {
    let next = match line.recalled {
        None => Some(0),
        Some(now) => now.checked_add_signed(by),
    };
    let recalled = next.and_then(|back| Some((back, state.history.recall(back)?)));
    match recalled {
        Some((back, text)) => {
            line.input = Input::new(text.to_owned());
            line.cursor = 0;
            line.recalled = Some(back);
        }
        None if by < 0 => {
            line.input = Input::default();
            line.recalled = None;
        }
        None => {}
    }
}

/// Does what is typed, or says on the line why not.
fn enter(
    state: &mut AppState,
    mut line: CommandLine,
    found: &[CompletionCandidate],
) -> Vec<Effect> {
    let now = line.input.value().trim().to_owned();
    let done = match typed(line.input.value()) {
        Some(typed) => {
            let chosen = match found.get(line.cursor) {
                Some(CompletionCandidate::Argument(argument)) => Some(argument),
                _ => None,
            };
            let needs_value = matches!(typed.word.id, LineCommand::Set | LineCommand::Vary);
            if needs_value && !typed.argument.contains('=') && chosen.is_some() {
                complete(&mut line, found);
                state.overlay = Some(Overlay::Palette(line));
                return Vec::new();
            }
            let argument = argument(typed.word.id, typed.argument, chosen);
            let text = format!("{} {argument}", typed.word.name);
            execute(state, typed.word.id, &argument)
                .map(|effects| (text.trim().to_owned(), effects))
        }
        None => match found.get(line.cursor) {
            Some(CompletionCandidate::Word(_)) => {
                complete(&mut line, found);
                state.overlay = Some(Overlay::Palette(line));
                return Vec::new();
            }
            Some(CompletionCandidate::Command(command)) => {
                let id = command.id;
                panes::enabled(state, id).map(|()| (name(id), run_command(state, id)))
            }
            _ => Err(format!("No command is called `{now}`.")),
        },
    };
    match done {
        Ok((text, effects)) => {
            state.history.push(&text);
            effects
        }
        Err(problem) => {
            line.problem = state.worded(&problem);
            state.overlay = Some(Overlay::Palette(line));
            Vec::new()
        }
    }
}

/// The argument that is meant: the one under the cursor where a command takes one of several, else what is typed.
fn argument(command: LineCommand, typed: &str, chosen: Option<&Argument>) -> String {
    let as_typed = matches!(
        command,
        LineCommand::Set | LineCommand::Vary | LineCommand::Filter | LineCommand::SaveAs
    );
    // `show` without a column shows all.
    let all = command == LineCommand::Show && typed.trim().is_empty();
    match chosen {
        Some(chosen) if !as_typed && !all => chosen.text.clone(),
        _ => typed.trim().to_owned(),
    }
}
