//! From step to step: what is so when one begins, and whether it is done.

use super::{
    Since, Tutorial,
    steps::{COUNT, TutorialStep},
};
use crate::pane::PaneId;
use crate::state::{AppState, JobState, RunStatus};

impl Since {
    fn now(state: &AppState) -> Self {
        Self {
            text: state
                .editor()
                .map_or_else(String::new, |editor| editor.text.clone()),
            runs: complete_runs(state),
            messages: state.log.len(),
        }
    }
}

impl Tutorial {
    /// The tutorial from a step on.
    #[must_use]
    pub fn at(state: &AppState, step: usize) -> Self {
        Self {
            step: step.min(COUNT - 1),
            since: Since::now(state),
        }
    }

    /// The step shown.
    #[must_use]
    pub fn shown(&self) -> TutorialStep {
        TutorialStep::of_number(self.step)
    }

    /// Whether the user has done what the step asks for.
    #[must_use]
    pub fn is_done(&self, state: &AppState) -> bool {
        (self.shown().done)(state, &self.since)
    }

    /// The next step; nothing after the last.
    #[must_use]
    pub fn next(&self, state: &AppState) -> Option<Self> {
        (self.step + 1 < COUNT).then(|| Self::at(state, self.step + 1))
    }
}

/// Stored runs of the open file that are complete.
pub(super) fn complete_runs(state: &AppState) -> usize {
    let runs = state.runs_view().map_or(&[][..], |view| view.runs.all());
    let done = |state: &RunStatus| matches!(state, RunStatus::Job(JobState::Done));
    runs.iter().filter(|run| done(&run.state)).count()
}

/// The key of a pane, as a name of its command: `` `:pane_9` ``.
pub(super) fn key_of(state: &AppState, pane: PaneId) -> String {
    match state.number_of(pane) {
        0 => "`:next_pane`".to_owned(),
        number => format!("`:pane_{number}`"),
    }
}
