//! What commands with arguments do. What cannot be done is said as a sentence.

use std::path::PathBuf;

use tui_input::Input;

use super::{edit, filter, overlay, quit, tables, vary};
use crate::bindings::names::pane_of;
use crate::chart::Glyphs;
use crate::command_line::LineCommand;
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::state::{AppState, Filter, ParameterEditor};
use crate::theme::Palette;

type Done = Result<Vec<Effect>, String>;

/// Does a command with its argument.
pub(super) fn execute(state: &mut AppState, command: LineCommand, argument: &str) -> Done {
    if argument.is_empty() && command != LineCommand::Show && command != LineCommand::Filter {
        return Err("The argument is missing.".to_owned());
    }
    match command {
        LineCommand::Open => open(state, argument),
        LineCommand::Set => set(state, argument),
        LineCommand::Vary => vary_keys(state, argument),
        LineCommand::GoTo => go_to(state, argument).map(|()| Vec::new()),
        LineCommand::Pane => pane(state, argument),
        LineCommand::Filter => filter(state, argument),
        LineCommand::Sort => tables::sort_by(state, argument),
        LineCommand::Hide => tables::hide(state, argument),
        LineCommand::Show => tables::show_again(state, argument),
        LineCommand::Explain => tables::explain_named(state, argument),
        LineCommand::SaveAs => {
            let none = || "No file is open.".to_owned();
            quit::save_as(state, argument).ok_or_else(none)
        }
        LineCommand::Theme => theme(state, argument),
        LineCommand::Glyphs => match argument {
            "braille" => Ok(overlay::choose_glyphs(state, Glyphs::Braille)),
            "ascii" => Ok(overlay::choose_glyphs(state, Glyphs::Ascii)),
            other => Err(format!(
                "There are no characters `{other}`: braille or ascii."
            )),
        },
    }
}

/// Opens a case of the list, or a file by its path, in place of what is open.
fn open(state: &mut AppState, name: &str) -> Done {
    if state.editor().is_some_and(ParameterEditor::unsaved) {
        return Err("The open file has changes that are not saved: `:save` saves them, `:back` leaves them.".to_owned());
    }
    if state.document.is_some() && state.jobs.open() > 0 {
        return Err("Runs of the open case are still running; Ctrl-C cancels them.".to_owned());
    }
    let listed = state.cases.entries.iter().find(|entry| entry.name == name);
    let path = listed.map_or_else(|| PathBuf::from(name), |entry| entry.path.clone());
    Ok(vec![Effect::ReadCase(path)])
}

/// Sets a key as if it were typed into its field, which then says what is wrong with a value that is refused.
fn set(state: &mut AppState, argument: &str) -> Done {
    let (key, value) = key_and_value(argument)?;
    go_to(state, key)?;
    Ok(type_into_field(state, value))
}

/// Runs the case over values of one key or several, as if they were typed into their fields.
fn vary_keys(state: &mut AppState, argument: &str) -> Done {
    if state.line().is_none() {
        return Err(
            "Only line cases are run over values here; `seacable study vary` takes all files."
                .to_owned(),
        );
    }
    let words: Vec<&str> = keyed(argument);
    let Some((last, kept)) = words.split_last() else {
        return Err("Give KEY=VALUES: current.speed_m_per_s=0.2..0.8/4.".to_owned());
    };
    let mut effects = Vec::new();
    for word in kept {
        begin_range(state, word)?;
        if !vary::can_keep(state) {
            return Err(no_range(state, word));
        }
        effects.extend(vary::keep(state));
    }
    begin_range(state, last)?;
    if !vary::can_keep(state) {
        return Err(no_range(state, last));
    }
    effects.extend(vary::enter(state).unwrap_or_default());
    Ok(effects)
}

/// The words `KEY=VALUES` of an argument; values may have blanks.
fn keyed(argument: &str) -> Vec<&str> {
    let mut begins: Vec<usize> = argument
        .match_indices('=')
        .map(|(at, _)| argument[..at].rfind(' ').map_or(0, |blank| blank + 1))
        .collect();
    begins.push(argument.len());
    let words = begins
        .windows(2)
        .map(|pair| argument[pair[0]..pair[1]].trim());
    words.filter(|word| !word.is_empty()).collect()
}

fn begin_range(state: &mut AppState, word: &str) -> Result<(), String> {
    let (key, values) = key_and_value(word)?;
    go_to(state, key)?;
    begin_typing(state, values);
    Ok(())
}

/// Why what is typed into the field is no range; it is not typed any more.
fn no_range(state: &mut AppState, word: &str) -> String {
    let said = state.document.as_ref().and_then(vary::typed);
    if let Some(editor) = state.editor_mut() {
        editor.editing = None;
    }
    match said {
        Some(Err(why)) => format!("{word}: {why}."),
        _ => format!("{word} is one value; several are 0.2..0.8/4 or 1, 2, 4."),
    }
}

fn key_and_value(argument: &str) -> Result<(&str, &str), String> {
    let (key, value) = argument
        .split_once('=')
        .ok_or("Give KEY=VALUE: a key of the file, then its value.")?;
    Ok((key.trim(), value.trim()))
}

/// Puts the cursor of the inputs on a key.
fn go_to(state: &mut AppState, key: &str) -> Result<(), String> {
    let document = state.document.as_mut().ok_or("No file is open.")?;
    let editor = &mut document.editor;
    let row = editor.rows.iter().find(|row| row.path == key);
    let row = row.ok_or_else(|| format!("The file has no key `{key}`."))?;
    if !row.is_shown() {
        return Err(format!(
            "`{key}` has no effect beside the other keys of its table."
        ));
    }
    document.pane = PaneId::Inputs;
    let editor = &mut document.editor;
    editor.filter = Filter::default();
    editor.editing = None;
    let place = |editor: &ParameterEditor| editor.fields().position(|row| row.path == key);
    if place(editor).is_none() {
        editor.folded = false;
    }
    editor.field = place(editor).unwrap_or(editor.field);
    Ok(())
}

/// Begins to type into the field under the cursor.
fn begin_typing(state: &mut AppState, value: &str) {
    edit::begin(state);
    if let Some(editing) = state
        .editor_mut()
        .and_then(|editor| editor.editing.as_mut())
    {
        editing.input = Input::new(value.to_owned());
    }
}

fn type_into_field(state: &mut AppState, value: &str) -> Vec<Effect> {
    begin_typing(state, value);
    edit::typing_key(state, KeyPress::Enter).unwrap_or_default()
}

fn pane(state: &mut AppState, name: &str) -> Done {
    let found = pane_of(name).filter(|pane| state.panes().contains(pane));
    let document = state.document.as_mut().ok_or("No file is open.")?;
    let pane = found.ok_or_else(|| format!("This file has no pane `{name}`."))?;
    document.pane = pane;
    let runs = (pane == PaneId::Runs).then_some(Effect::RefreshRuns);
    Ok(runs.into_iter().collect())
}

fn filter(state: &mut AppState, words: &str) -> Done {
    let (filter, cursor, _) = state
        .filter_mut()
        .ok_or("There is no list here to be filtered.")?;
    *filter = Filter::of_words(words);
    *cursor = 0;
    filter::filtered(state);
    Ok(Vec::new())
}

fn theme(state: &mut AppState, name: &str) -> Done {
    let mut named = Palette::NAMES.iter();
    let (_, palette) = named
        .find(|(known, _)| *known == name)
        .ok_or_else(|| format!("There is no theme `{name}`: dark, light or mono."))?;
    state.capabilities.palette = *palette;
    state.theme = Some(*palette);
    if !state.capabilities.colour && *palette != Palette::Mono {
        return Err("NO_COLOR is set: the screen stays without colours.".to_owned());
    }
    Ok(vec![Effect::Repaint])
}
