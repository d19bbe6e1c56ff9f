//! Studies and validation: the variants of a case that they need, as jobs.

use super::jobs::{enqueue, start_waiting};
use super::notice::info;
use super::runs;
use crate::case::StudyPoint;
use crate::reference;
use crate::tui::facade;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::state::{AppState, Document, JobState, Overlay, RunEntry, RunStatus, Severity};

/// Runs the study of the case, or asks which.
pub(super) fn ask(state: &mut AppState) -> Vec<Effect> {
    let Some(line) = state.line() else {
        return Vec::new();
    };
    if line.case.study.len() == 1 {
        return study(state, 0);
    }
    let items = line
        .case
        .study
        .iter()
        .map(|s| {
            let values: Vec<String> = s.values.iter().map(ToString::to_string).collect();
            format!("{}: {} = {}", s.name, s.key, values.join(", "))
        })
        .collect();
    state.overlay = Some(Overlay::Studies { items, cursor: 0 });
    Vec::new()
}

/// Runs all variants of a study and overlays them.
pub(super) fn study(state: &mut AppState, index: usize) -> Vec<Effect> {
    let Some(line) = state.line_mut() else {
        return Vec::new();
    };
    let Some(study) = line.case.study.get(index).cloned() else {
        return Vec::new();
    };
    line.hide_runs();
    let points = study.values.iter().map(|value| {
        Some(StudyPoint {
            study: study.name.clone(),
            value: value.clone(),
        })
    });
    let effects = variants(state, points.collect(), true);
    if let Some(document) = &mut state.document {
        document.pane = PaneId::Charts;
    }
    effects
}

/// Runs all that the published values of the case need.
pub(super) fn validate(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &mut state.document else {
        return Vec::new();
    };
    document.pane = PaneId::Validation;
    let plan = document
        .line()
        .map_or_else(Vec::new, |line| reference::plan(&line.case));
    variants(state, plan, false)
}

/// Queues the variants that are not there yet, and shows those that are.
fn variants(state: &mut AppState, points: Vec<Option<StudyPoint>>, shown: bool) -> Vec<Effect> {
    let mut effects = Vec::new();
    let mut begun = 0;
    for at in points {
        let document = state.document.as_mut();
        let Some((line, editor)) = document.and_then(Document::line_and_editor) else {
            break;
        };
        let (text, case) =
            match facade::variant(&editor.text, &line.case, at.as_ref(), &editor.file) {
                Ok(found) => found,
                Err(problem) => {
                    state.say(Severity::Error, problem);
                    continue;
                }
            };
        if let Some(slot) = line
            .runs
            .iter_mut()
            .rev()
            .find(|s| s.text == text && usable(s))
        {
            slot.at.clone_from(&at);
            slot.label = at
                .as_ref()
                .map_or_else(String::new, |at| facade::at_label(&line.case, at));
            slot.shown |= shown;
            effects.extend(runs::load(slot));
            continue;
        }
        let live = &line.live;
        if at.is_none() && !shown && (live.done_text == text || live.going_text == text) {
            // The live run is of this text.
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
        RunStatus::Job(JobState::Queued | JobState::Running | JobState::Done)
    )
}
