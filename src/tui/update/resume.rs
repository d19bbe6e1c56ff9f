//! Resuming a stored run: the end is asked for, and it joins the queue as a run of its own.

use std::path::PathBuf;

use tui_input::Input;

use super::jobs::{queue, start_newest};
use super::notice::info;
use crate::msg::Effect;
use crate::state::{AppState, JobRequest, JobState, Overlay, PromptPurpose, RunStatus};

/// Asks for the end of the run under the cursor.
pub fn ask(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view() else {
        return Vec::new();
    };
    let Some((slot, dir)) = view.current_run().and_then(|s| Some((s, s.dir.clone()?))) else {
        return Vec::new();
    };
    let end = slot.duration_s;
    let whole = slot.state == RunStatus::Job(JobState::Done);
    // A run that was stopped is offered its own end, a complete one twice its time.
    let offer = format!("{}", if whole { 2.0 * end } else { end });
    let words = if whole {
        "The run is complete. It is resumed as a run of its own, to the same bits as if it had never stopped."
    } else {
        "The run was stopped. It is resumed from its last checkpoint, as a run of its own, to the same bits as \
         if it had never stopped."
    };
    state.overlay = Some(Overlay::Prompt {
        purpose: PromptPurpose::Resume(dir),
        input: Input::new(offer),
        words: words.to_owned(),
    });
    Vec::new()
}

/// Prepares the run to be resumed up to the time typed.
///
/// # Errors
/// What is wrong with it.
pub(super) fn until(dir: PathBuf, typed: &str) -> Result<Vec<Effect>, String> {
    match typed.parse::<f64>() {
        Ok(until) if until.is_finite() => Ok(vec![Effect::PrepareResume(dir, until)]),
        _ => Err("The time must be a number of seconds, such as 1800.".to_owned()),
    }
}

/// The run is resumed, or the question is asked again with the reason why not.
pub(super) fn found(
    state: &mut AppState,
    dir: PathBuf,
    until: f64,
    found: Result<JobRequest, String>,
) -> Vec<Effect> {
    let request = match found {
        Ok(request) => request,
        Err(words) => {
            state.overlay = Some(Overlay::Prompt {
                purpose: PromptPurpose::Resume(dir),
                input: Input::new(format!("{until}")),
                words,
            });
            return Vec::new();
        }
    };
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    view.hide_runs();
    let time = request.begins_at();
    queue(state, request, format!("to {until} s"), None, true);
    let effects = start_newest(state);
    info(
        state,
        format!(
            "The run is resumed from {time} s. `:pane_2` shows its curves, `:pane_6` the jobs."
        ),
    );
    effects
}
