//! Saving, leaving a case, quitting.

use std::path::PathBuf;

use tui_input::Input;

use super::typing::type_key;
use super::{edit, info, jobs};
use crate::tui::key::Key;
use crate::tui::msg::Effect;
use crate::tui::state::sheet::After;
use crate::tui::state::{JobLine, Level, Overlay, Purpose, Question, Sheet, State};

pub(super) fn quit(state: &mut State) -> Vec<Effect> {
    if state.sheet().is_some_and(Sheet::unsaved) {
        state.overlay = Some(Overlay::Ask(Question::Unsaved { quit: true }));
        return Vec::new();
    }
    quit_past_edits(state)
}

fn quit_past_edits(state: &mut State) -> Vec<Effect> {
    if state.jobs.open() > 0 {
        state.overlay = Some(Overlay::Ask(Question::JobsRunning));
        return Vec::new();
    }
    vec![Effect::Quit]
}

pub(super) fn back(state: &mut State) -> Vec<Effect> {
    let Some(sheet) = state.sheet_mut() else {
        return Vec::new();
    };
    if !sheet.filter.value().is_empty() {
        sheet.filter.reset();
        sheet.field = 0;
        return Vec::new();
    }
    if sheet.unsaved() {
        state.overlay = Some(Overlay::Ask(Question::Unsaved { quit: false }));
        return Vec::new();
    }
    if state.jobs.open() > 0 {
        return super::overlay::warn(
            state,
            "Runs of this case are still going on. Ctrl-C cancels them; the case list comes back when they have ended.",
        );
    }
    close(state)
}

fn close(state: &mut State) -> Vec<Effect> {
    let mut effects = jobs::cancel_all(state);
    state.close();
    let goes_on = |l: &JobLine| l.purpose == Purpose::Trials && l.state.is_open();
    state.jobs.lines.retain(goes_on);
    state.jobs.cursor = 0;
    effects.push(Effect::ReadCases);
    effects
}

pub(super) fn save(state: &mut State) -> Vec<Effect> {
    state.sheet().map_or_else(Vec::new, |sheet| {
        vec![Effect::SaveCase {
            path: sheet.path.clone(),
            text: sheet.text.clone(),
            expected: Some(sheet.saved.clone()),
            new: false,
        }]
    })
}

pub(super) fn overwrite(state: &mut State) -> Vec<Effect> {
    state.sheet().map_or_else(Vec::new, |sheet| {
        vec![Effect::SaveCase {
            path: sheet.path.clone(),
            text: sheet.text.clone(),
            expected: None,
            new: false,
        }]
    })
}

pub(super) fn save_then_leave(state: &mut State, quit: bool) -> Vec<Effect> {
    if let Some(sheet) = state.sheet_mut() {
        sheet.after_save = if quit { After::Quit } else { After::Close };
    }
    save(state)
}

pub(super) fn drop_edits(state: &mut State, quit: bool) -> Vec<Effect> {
    if let Some(sheet) = state.sheet_mut() {
        sheet.text.clone_from(&sheet.saved);
    }
    let mut effects = edit::keep_draft(state);
    effects.extend(if quit {
        quit_past_edits(state)
    } else {
        edit::refresh(state);
        back(state)
    });
    effects
}

pub(super) fn saved(state: &mut State, path: PathBuf, text: String) -> Vec<Effect> {
    let Some(sheet) = state.sheet_mut() else {
        return Vec::new();
    };
    let old = std::mem::replace(&mut sheet.path, path);
    if let Some(name) = sheet.path.file_name() {
        sheet.file = name.to_string_lossy().into_owned();
    }
    sheet.saved = text;
    let after = std::mem::take(&mut sheet.after_save);
    let said = format!("Saved to {}.", sheet.path.display());
    let mut effects = vec![Effect::KeepDraft {
        path: old,
        text: None,
    }];
    info(state, said);
    effects.extend(match after {
        After::Stay => Vec::new(),
        After::Close => back(state),
        After::Quit => quit(state),
    });
    effects
}

pub(super) fn not_saved(state: &mut State, why: &str) -> Vec<Effect> {
    state.say(Level::Error, why);
    ask_name(state, why)
}

pub(super) fn changed_on_disk(state: &mut State) -> Vec<Effect> {
    state.overlay = Some(Overlay::Ask(Question::Overwrite));
    Vec::new()
}

/// Asks for another file name.
pub(super) fn ask_name(state: &mut State, why: &str) -> Vec<Effect> {
    if let Some(sheet) = state.sheet() {
        let stem = sheet.file.trim_end_matches(".toml");
        state.overlay = Some(Overlay::SaveAs {
            input: Input::new(format!("{stem}-copy.toml")),
            why: why.to_owned(),
        });
    }
    Vec::new()
}

pub(super) fn save_as_key(
    state: &mut State,
    mut input: Input,
    why: String,
    key: Key,
) -> Vec<Effect> {
    let name = input.value().trim().to_owned();
    match (key, state.sheet_mut()) {
        (Key::Esc, Some(sheet)) => {
            sheet.after_save = After::Stay;
            return Vec::new();
        }
        (Key::Enter, Some(sheet)) if !name.is_empty() => {
            return vec![Effect::SaveCase {
                path: PathBuf::from(name),
                text: sheet.text.clone(),
                expected: None,
                new: true,
            }];
        }
        _ => {
            type_key(&mut input, key);
        }
    }
    state.overlay = Some(Overlay::SaveAs { input, why });
    Vec::new()
}
