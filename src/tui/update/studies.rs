//! Studies and validation: the variants of a case that they need, as jobs.

use super::jobs::{enqueue, start_waiting};
use super::notice::info;
use super::runs;
use crate::facade;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::state::line::PlannedWork;
use crate::state::{
    AppState, CaseVariant, JobState, LineView, Overlay, RunEntry, RunStatus, Severity,
};

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
    let Some(line) = ready(state, PlannedWork::Study(index)) else {
        return Vec::new();
    };
    let Some(study) = line.case.study.get(index) else {
        return Vec::new();
    };
    let wanted: Vec<CaseVariant> = line.plan.of_study(&study.name).cloned().collect();
    line.runs_view.hide_runs();
    let effects = variants(state, wanted, true);
    if let Some(document) = &mut state.document {
        document.pane = PaneId::Charts;
    }
    effects
}

/// Runs all that the published values of the case need.
pub(super) fn validate(state: &mut AppState) -> Vec<Effect> {
    if let Some(document) = &mut state.document {
        document.pane = PaneId::Validation;
    }
    let Some(line) = ready(state, PlannedWork::Validate) else {
        return Vec::new();
    };
    let wanted = line.plan.of_published_values().to_vec();
    variants(state, wanted, false)
}

/// The case with its variants; where they are not worked out yet, the work waits for them.
fn ready(state: &mut AppState, work: PlannedWork) -> Option<&mut LineView> {
    let document = state.document.as_mut()?;
    let (line, editor) = document.line_and_editor()?;
    if line.plan.text == editor.text {
        return Some(line);
    }
    line.planned = Some(work);
    None
}

/// Queues the variants that are not there yet, and shows those that are.
fn variants(state: &mut AppState, wanted: Vec<CaseVariant>, shown: bool) -> Vec<Effect> {
    let mut effects = Vec::new();
    let mut begun = 0;
    for variant in wanted {
        let case = match variant.case {
            Ok(case) => *case,
            Err(problem) => {
                state.say(Severity::Error, problem);
                continue;
            }
        };
        let Some(line) = state.line_mut() else {
            break;
        };
        let same = |run: &RunEntry| run.text == variant.digest && usable(run);
        if let Some(slot) = line.runs_view.runs.newest_mut(same) {
            slot.at.clone_from(&variant.at);
            if let Some(at) = &variant.at {
                slot.label = facade::at_label(&line.case, at);
            }
            slot.shown |= shown;
            effects.extend(runs::load(slot));
            continue;
        }
        let live = &line.runs_view.live;
        let is_live = live.done_text == variant.text || live.going_text == variant.text;
        if variant.at.is_none() && !shown && is_live {
            continue;
        }
        begun += 1;
        enqueue(
            state,
            (&variant.text, &variant.rows),
            case,
            variant.at,
            shown,
        );
    }
    if let Some(line) = state.line_mut() {
        line.runs_view.runs.arrange();
    }
    effects.extend(start_waiting(state));
    runs::check(state);
    info(
        state,
        if begun == 0 {
            "Everything needed has been run already.".to_owned()
        } else {
            format!("{begun} runs begun. `:pane_6` shows the jobs, `ctrl+c` cancels.")
        },
    );
    effects
}

/// Whether a run has what one of the same text would have.
pub(super) fn usable(slot: &RunEntry) -> bool {
    matches!(
        slot.state,
        RunStatus::Job(JobState::Queued | JobState::Running | JobState::Done)
    )
}
