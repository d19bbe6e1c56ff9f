//! Saving, leaving a case, quitting.

use crate::visible;
use std::path::PathBuf;
use std::sync::Arc;

use tui_input::Input;

use super::end::{drop_ranges, nothing_unsaved, now};
use super::notice::{info, warn};
use super::{edit, job_processes, jobs, recovery, tables};
use crate::msg::Effect;
use crate::state::parameter_editor::AfterSave;
use crate::state::reading::SavedRows;
use crate::state::{
    AppState, Filter, JobLine, JobPurpose, JobState, Overlay, ParameterEditor, PromptPurpose,
    Question, Severity,
};

pub(super) fn quit(state: &mut AppState) -> Vec<Effect> {
    if state.editor().is_some_and(ParameterEditor::unsaved) {
        state.overlay = Some(Overlay::Ask(Question::Unsaved { quit: true }));
        return Vec::new();
    }
    quit_past_edits(state)
}

fn quit_past_edits(state: &mut AppState) -> Vec<Effect> {
    let open = state.jobs.open();
    if open > 0 {
        state.overlay = Some(Overlay::Ask(match state.jobs.open_here() {
            0 => Question::JobsGoOn {
                count: open,
                warning: state.jobs.ended_by_logout.clone(),
            },
            _ => Question::JobsRunning,
        }));
        return Vec::new();
    }
    now(state)
}

/// Cancels the jobs that would go on, and ends the program.
pub(super) fn cancel_and_quit(state: &mut AppState) -> Vec<Effect> {
    let open = state.jobs.lines.iter().filter(|l| l.state.is_open());
    let tickets: Vec<_> = open
        .filter(|l| l.process.is_some())
        .map(|l| l.ticket)
        .collect();
    let mut effects: Vec<Effect> = tickets.into_iter().map(Effect::Cancel).collect();
    effects.extend(now(state));
    effects
}

pub(super) fn back(state: &mut AppState) -> Vec<Effect> {
    if tables::drop_filter(state) {
        return Vec::new();
    }
    let Some(editor) = state.editor_mut() else {
        return Vec::new();
    };
    if !editor.filter.is_empty() {
        editor.filter = Filter::default();
        editor.field = 0;
        return Vec::new();
    }
    if editor.unsaved() {
        state.overlay = Some(Overlay::Ask(Question::Unsaved { quit: false }));
        return Vec::new();
    }
    if state.jobs.open_here() > 0 {
        return warn(
            state,
            "Runs of this case are still running. Ctrl-C cancels them; the case list comes back when they have ended.",
        );
    }
    close(state)
}

fn close(state: &mut AppState) -> Vec<Effect> {
    let mut effects = drop_ranges(state);
    effects.extend(jobs::cancel_all(state));
    effects.extend(job_processes::hide(state));
    state.close();
    let goes_on = |l: &JobLine| {
        let is_elsewhere = matches!(l.state, JobState::Elsewhere(_));
        let has_process = l.purpose == JobPurpose::Trials || l.process.is_some();
        has_process && (l.state.is_open() || is_elsewhere)
    };
    state.jobs.lines.retain(goes_on);
    state.jobs.cursor = 0;
    effects.push(Effect::ReadCases);
    effects
}

/// Writes the text to its file, unless that has changed on disk.
pub(super) fn save(state: &mut AppState) -> Vec<Effect> {
    let expected = state.editor().map(|editor| {
        // A save that is still on its way comes first.
        let on_its_way = editor.saving.as_ref();
        on_its_way.unwrap_or(&editor.saved).clone()
    });
    write(state, expected)
}

/// Writes the text to its file, whatever that holds.
pub(super) fn overwrite(state: &mut AppState) -> Vec<Effect> {
    write(state, None)
}

fn write(state: &mut AppState, expected: Option<String>) -> Vec<Effect> {
    state.editor_mut().map_or_else(Vec::new, |editor| {
        editor.saving = Some(editor.text.clone());
        vec![Effect::SaveCase {
            path: editor.path.clone(),
            text: editor.text.clone(),
            expected,
            new: false,
        }]
    })
}

pub(super) fn save_then_leave(state: &mut AppState, quit: bool) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut() {
        editor.after_save = if quit {
            AfterSave::Quit
        } else {
            AfterSave::Close
        };
    }
    save(state)
}

pub(super) fn drop_edits(state: &mut AppState, quit: bool) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut() {
        editor.text.clone_from(&editor.saved);
        editor.kept.clear();
    }
    let mut effects = recovery::keep_recovery(state);
    effects.extend(if quit {
        quit_past_edits(state)
    } else {
        back(state)
    });
    // It may stay open, while runs are computed.
    effects.extend(edit::reread(state));
    effects
}

pub(super) fn saved(state: &mut AppState, path: PathBuf, text: String) -> Vec<Effect> {
    let Some(editor) = state.editor_mut() else {
        return Vec::new();
    };
    let old = std::mem::replace(&mut editor.path, path);
    if let Some(name) = editor.path.file_name() {
        editor.file = name.to_string_lossy().into_owned();
    }
    editor.saving = editor.saving.take().filter(|later| *later != text);
    editor.saved = text;
    let differs = editor.unsaved() || !editor.pending.is_empty();
    if !differs {
        editor.saved_rows = Some(Arc::new(SavedRows {
            text: editor.saved.clone(),
            rows: editor.rows.clone(),
        }));
    }
    let after = std::mem::take(&mut editor.after_save);
    let draft = match editor.draft {
        Some(_) => {
            " It is a draft: until it is complete, the list opens it in the editor alone (`:external_editor`)."
        }
        None => "",
    };
    let said = format!("Saved to {}.{draft}", visible::path(&editor.path));
    let moved = (old != editor.path).then_some(old);
    // Edits made since, and ranges that wait, are not in the file: they are kept anew before anything is dropped.
    let mut effects = recovery::keep_recovery(state);
    effects.extend(moved.map(nothing_unsaved));
    info(state, said);
    effects.extend(match after {
        // What was edited since differs from another file now.
        AfterSave::Stay if differs => edit::reread(state),
        AfterSave::Stay => Vec::new(),
        AfterSave::Close => back(state),
        AfterSave::Quit => quit(state),
    });
    effects
}

pub(super) fn not_saved(state: &mut AppState, why: &str) -> Vec<Effect> {
    forget_saving(state);
    state.say(Severity::Error, why);
    ask_name(state, why)
}

/// No save of before is in the file.
fn forget_saving(state: &mut AppState) {
    if let Some(editor) = state.editor_mut() {
        editor.saving = None;
    }
}

pub(super) fn changed_on_disk(state: &mut AppState) -> Vec<Effect> {
    forget_saving(state);
    state.overlay = Some(Overlay::Ask(Question::Overwrite));
    Vec::new()
}

/// Asks for another file name.
pub(super) fn ask_name(state: &mut AppState, why: &str) -> Vec<Effect> {
    if let Some(editor) = state.editor() {
        let stem = editor.stem();
        state.overlay = Some(Overlay::Prompt {
            purpose: PromptPurpose::SaveAs,
            input: Input::new(format!("{stem}-copy.toml")),
            words: format!("Not saved to the file itself: {why}"),
        });
    }
    Vec::new()
}

/// Saves under the name typed.
pub(super) fn save_as(state: &AppState, name: &str) -> Option<Vec<Effect>> {
    let editor = state.editor().filter(|_| !name.is_empty())?;
    Some(vec![Effect::SaveCase {
        path: PathBuf::from(name),
        text: editor.text.clone(),
        expected: None,
        new: true,
    }])
}
