//! The steps: what each says, in two lines of 80 columns, and when it is done.

use super::Since;
use super::progress::{complete_runs, key_of};
use crate::pane::PaneId;
use crate::state::{AppState, Overlay, ParameterEditor};

/// A step of the tutorial.
#[derive(Clone, Copy)]
pub struct TutorialStep {
    /// Its title.
    pub title: &'static str,
    /// What to do, with names of commands for their keys.
    pub words: fn(&AppState) -> String,
    pub(super) done: fn(&AppState, &Since) -> bool,
}

impl std::fmt::Debug for TutorialStep {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Step")
            .field("title", &self.title)
            .finish_non_exhaustive()
    }
}

/// How many there are.
pub const COUNT: usize = STEPS.len();

impl TutorialStep {
    /// A step by its number, from 0; the last one beyond.
    #[must_use]
    pub fn of_number(number: usize) -> Self {
        STEPS[number.min(COUNT - 1)]
    }
}

const STEPS: [TutorialStep; 11] = [
    TutorialStep {
        title: "Open a case",
        words: |_| {
            "These are cases: files that describe a line. `:down` and `:up` move the cursor. Put it on pendulous/manifold.toml, and open it with `:open`.".to_owned()
        },
        done: |state, _| state.line().is_some(),
    },
    TutorialStep {
        title: "Results and their errors",
        words: |state| {
            format!(
                "The case is computed as it opens. Below are its main results, behind ± the numerical error. Press {} to see all of them.",
                key_of(state, PaneId::Results)
            )
        },
        done: |state, _| state.focus() == PaneId::Results,
    },
    TutorialStep {
        title: "Change a value",
        words: |state| {
            format!(
                "Press {} for the inputs, then `:filter`, type `current speed` and press Enter. `:step_up` raises the value: curve and results follow.",
                key_of(state, PaneId::Inputs)
            )
        },
        done: |state, since| text(state) != since.text,
    },
    TutorialStep {
        title: "Hold results, and see differences",
        words: |state| {
            format!(
                "In the inputs ({}) `:hold_against` holds these results. Change the value again: each result shows its difference from them.",
                key_of(state, PaneId::Inputs)
            )
        },
        done: |state, since| holds(state) && text(state) != since.text,
    },
    TutorialStep {
        title: "Published values",
        words: |state| {
            format!(
                "{} compares with the paper: PASS, FAIL, or EDITED, as you changed an input that the paper states.",
                key_of(state, PaneId::Validation)
            )
        },
        done: |state, _| state.focus() == PaneId::Validation,
    },
    TutorialStep {
        title: "Undo",
        words: |_| {
            "`:undo` takes an edit back. Press it until `*unsaved` is gone from the first line: the case is as the paper has it.".to_owned()
        },
        done: |state, _| {
            state
                .editor()
                .is_some_and(|editor| !editor.unsaved() && !waits(editor))
        },
    },
    TutorialStep {
        title: "Run and store",
        words: |_| {
            "So far all was in memory. `:run` computes the case with estimates of its errors, and stores the run below runs/.".to_owned()
        },
        done: |state, since| complete_runs(state) > since.runs,
    },
    TutorialStep {
        title: "A second run",
        words: |state| {
            format!(
                "Change the current speed again ({}, `:step_up`), then `:run` once more.",
                key_of(state, PaneId::Inputs)
            )
        },
        done: |state, since| complete_runs(state) > since.runs && text(state) != since.text,
    },
    TutorialStep {
        title: "Compare two runs",
        words: |state| {
            format!(
                "{} lists the runs. Mark both with `:mark`, then `:compare` shows what differs and whether error bars overlap.",
                key_of(state, PaneId::Runs)
            )
        },
        done: |state, _| matches!(state.overlay, Some(Overlay::Page { .. })),
    },
    TutorialStep {
        title: "Write a report",
        words: |state| {
            format!(
                "Esc closes the page. {} shows the report of a run; `:write` writes it to a file, whose name is said below.",
                key_of(state, PaneId::Report)
            )
        },
        done: |state, since| {
            let new = state.log.iter().skip(since.messages);
            state.overlay.is_none()
                && new
                    .into_iter()
                    .any(|said| said.text.contains("report") && said.text.contains(" is in "))
        },
    },
    TutorialStep {
        title: "That is all",
        words: |_| {
            "`:help` shows the keys of the pane you are in, `:palette` finds any command by a word. `:tutorial` ends this; it can be started again at any time.".to_owned()
        },
        done: |_, _| false,
    },
];

/// The text of the open file.
fn text(state: &AppState) -> &str {
    state.editor().map_or("", |editor| &editor.text)
}

fn waits(editor: &ParameterEditor) -> bool {
    !editor.pending.is_empty()
}

/// Whether results are held.
fn holds(state: &AppState) -> bool {
    state.runs_view().is_some_and(|view| view.against.is_some())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Glyphs;
    use crate::terminal::capabilities::Capabilities;
    use crate::theme::Palette;
    use crate::view::paint::wrap;

    #[test]
    fn every_step_fits_into_two_lines_of_80_columns() {
        let looks = Capabilities {
            glyphs: Glyphs::Ascii,
            colour: false,
            palette: Palette::Mono,
            unsure: false,
        };
        let state = AppState::new((80, 24), looks);
        for step in STEPS {
            let words = state.worded(&(step.words)(&state));
            assert!(wrap(&words, 80).len() <= 2, "{}: {words}", step.title);
            // The key of the line of commands is a colon itself.
            let others = words.replace("`:`", "");
            assert!(!others.contains("`:"), "a command without a key: {words}");
        }
    }
}
