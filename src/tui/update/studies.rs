//! Studies and validation: the variants of a case that they need, as jobs.

use super::jobs::{enqueue, start_waiting};
use super::{info, runs};
use crate::case::At;
use crate::tui::facade;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::{AppState, Choice, Level, Overlay, RunEntry, RunStatus};

/// Runs the study of the case, or asks which.
pub(super) fn ask(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = &state.open else {
        return Vec::new();
    };
    if open.case.study.len() == 1 {
        return study(state, 0);
    }
    let items = open
        .case
        .study
        .iter()
        .map(|s| {
            let values: Vec<String> = s.values.iter().map(ToString::to_string).collect();
            format!("{}: {} = {}", s.name, s.key, values.join(", "))
        })
        .collect();
    state.overlay = Some(Overlay::Choose {
        choice: Choice::Study,
        items,
        cursor: 0,
    });
    Vec::new()
}

/// Runs all variants of a study and overlays them.
pub(super) fn study(state: &mut AppState, index: usize) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let Some(study) = open.case.study.get(index).cloned() else {
        return Vec::new();
    };
    open.live.hidden = true;
    for slot in &mut open.runs {
        slot.shown = false;
    }
    let points = study.values.iter().map(|value| {
        Some(At {
            study: study.name.clone(),
            value: value.clone(),
        })
    });
    let effects = variants(state, points.collect(), true);
    if let Some(open) = &mut state.open {
        open.pane = PaneId::Charts;
    }
    effects
}

/// Runs all that the published values of the case need.
pub(super) fn validate(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    open.pane = PaneId::Validation;
    let plan = facade::plan(&open.case);
    variants(state, plan, false)
}

/// Queues the variants that are not there yet, and shows those that are.
fn variants(state: &mut AppState, points: Vec<Option<At>>, shown: bool) -> Vec<Effect> {
    let mut effects = Vec::new();
    let mut begun = 0;
    for at in points {
        let Some(open) = &mut state.open else {
            break;
        };
        let (text, case) = match facade::variant(
            &open.editor.text,
            &open.case,
            at.as_ref(),
            &open.editor.file,
        ) {
            Ok(found) => found,
            Err(problem) => {
                state.say(Level::Error, problem);
                continue;
            }
        };
        if let Some(slot) = open
            .runs
            .iter_mut()
            .rev()
            .find(|s| s.text == text && usable(s))
        {
            slot.at.clone_from(&at);
            slot.label = at
                .as_ref()
                .map_or_else(String::new, |at| facade::at_label(&open.case, at));
            slot.shown |= shown;
            effects.extend(runs::load(slot));
            continue;
        }
        let live = &open.live;
        if at.is_none() && !shown && (live.done_text == text || live.going_text == text) {
            // The live run answers for the case as it stands.
            continue;
        }
        begun += 1;
        enqueue(state, &text, case, at, shown);
    }
    effects.extend(start_waiting(state));
    runs::check(state);
    info(
        state,
        if begun == 0 {
            "Everything needed has been run already.".to_owned()
        } else {
            format!("{begun} runs begun. `6` shows the jobs, `ctrl+c` cancels.")
        },
    );
    effects
}

fn usable(slot: &RunEntry) -> bool {
    matches!(
        slot.state,
        RunStatus::Queued | RunStatus::Running | RunStatus::Done
    )
}
