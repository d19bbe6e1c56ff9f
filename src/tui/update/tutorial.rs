//! The tutorial: begun, left, and led from step to step by what the user does.

use super::notice::info;
use crate::msg::Effect;
use crate::state::{AppState, Severity};
use crate::tutorial::{COUNT, Tutorial};

/// Begins the tutorial where it was left, or leaves it.
pub(super) fn turn(state: &mut AppState) -> Vec<Effect> {
    match state.tutorial.take() {
        Some(tutorial) => {
            let is_over = tutorial.step + 1 == COUNT;
            state.tutorial_left = (!is_over).then_some(tutorial.step);
            info(state, "The tutorial is left. `:tutorial` resumes it.")
        }
        None => {
            begin(state);
            Vec::new()
        }
    }
}

/// Begins the tutorial where it was left.
pub fn begin(state: &mut AppState) {
    let step = state.tutorial_left.take().unwrap_or(0);
    state.tutorial = Some(Tutorial::at(state, step));
}

/// Goes to the next step; after the last the tutorial ends.
pub(super) fn skip(state: &mut AppState) -> Vec<Effect> {
    let next = state.tutorial.as_ref().and_then(|now| now.next(state));
    state.tutorial = next;
    Vec::new()
}

/// Goes on as far as the user has done what the steps ask for.
pub(super) fn follow(state: &mut AppState) {
    // Each step is compared with the state in which it begins: one message completes one step.
    let done = state.tutorial.as_ref().filter(|now| now.is_done(state));
    let Some(done) = done.cloned() else {
        return;
    };
    let title = done.shown().title;
    state.tutorial = done.next(state);
    let number = done.step + 1;
    let is_free = state
        .note
        .as_ref()
        .is_none_or(|note| note.level == Severity::Info);
    if is_free && state.tutorial.is_some() && state.overlay.is_none() {
        state.say(Severity::Info, format!("Step {number} is done: {title}."));
    }
}
