//! Which commands can be done now, and why the others cannot.

use crate::tui::command::Id;
use crate::tui::pane::PaneId;
use crate::tui::state::trials::Trials;
use crate::tui::state::{AppState, Content, OpenCase, ParameterEditor, RunOrigin, RunStatus};

/// Nothing, or the reason why the command cannot be done now.
///
/// # Errors
/// The reason, as a full sentence.
pub fn enabled(state: &AppState, id: Id) -> Result<(), String> {
    if let Some(trials) = state.trials.as_ref().filter(|t| t.shown) {
        let reason = in_trials(trials, id);
        return reason.map_or(Ok(()), |r| Err(r.to_owned()));
    }
    let reason = match (&state.open, id) {
        (None, Id::Open) => state
            .cases
            .current()
            .is_none()
            .then_some("There is no case here. `ctrl+r` reads the directory again."),
        (Some(open), _) => in_case(state, open, id),
        (None, _) => state
            .editor()
            .and_then(|editor| in_sheet(editor, id))
            .or_else(|| in_file(state, id)),
    };
    reason.map_or(Ok(()), |r| Err(r.to_owned()))
}

fn in_trials(trials: &Trials, id: Id) -> Option<&'static str> {
    let when = |condition: bool, reason: &'static str| condition.then_some(reason);
    match id {
        Id::CancelJob => when(!trials.running(), "All trials are computed already."),
        Id::Write => when(
            trials.progress.findings.is_empty(),
            "No trial is computed yet.",
        ),
        _ => None,
    }
}

fn in_sheet(editor: &ParameterEditor, id: Id) -> Option<&'static str> {
    let when = |condition: bool, reason: &'static str| condition.then_some(reason);
    match id {
        Id::Undo => when(editor.undo.is_empty(), "There is nothing to undo."),
        Id::Redo => when(editor.redo.is_empty(), "There is nothing to redo."),
        Id::ExternalEditor => when(
            editor.unsaved(),
            "There are changes that the file does not hold; `s` saves them first.",
        ),
        Id::Save => when(!editor.unsaved(), "The file already holds everything."),
        Id::Edit | Id::Reset => when(
            editor.current_field().is_none(),
            "No field passes the filter. `/` and Esc drop it.",
        ),
        _ => None,
    }
}

/// What only some kinds of file can do.
fn in_file(state: &AppState, id: Id) -> Option<&'static str> {
    let file = state.file.as_ref()?;
    match (id, &file.content) {
        (Id::Copy, Content::Ropeway(_) | Content::Ship(_)) => {
            Some("Only the material of a cross-section is copied; `M` writes it to a file.")
        }
        (Id::NextTrace, Content::Section(_) | Content::Ropeway(_)) => {
            Some("Only a ship has six motions.")
        }
        _ => None,
    }
}

fn in_case(state: &AppState, open: &OpenCase, id: Id) -> Option<&'static str> {
    let when = |condition: bool, reason: &'static str| condition.then_some(reason);
    if let Some(reason) = in_sheet(&open.editor, id) {
        return Some(reason);
    }
    match id {
        Id::Study => when(
            open.case.study.is_empty(),
            "This case has no study. A `[[study]]` table in its file makes one.",
        ),
        Id::Validate => when(
            open.case.published.is_empty()
                && open.case.trend.is_empty()
                && open.case.published_curve.is_empty(),
            "This case states no published values to be held against.",
        ),
        Id::Keep => keep(open),
        Id::Delete => delete(open),
        Id::Resume => go_on(open),
        Id::Trials => when(
            open.case.trial.is_empty(),
            "This case has no trials. A `[[trial]]` table in its file makes one; in the list of cases `T` computes all.",
        ),
        Id::ShowAlone | Id::Select => None,
        Id::CancelJob => {
            let open = state.jobs.lines.get(state.jobs.cursor);
            when(
                !open.is_some_and(|l| l.state.is_open()),
                "There is no running job under the cursor.",
            )
        }
        Id::Write => match open.pane {
            PaneId::Modes => when(
                !matches!(open.modes.found, Some(Ok(_))),
                "There are no modes to write.",
            ),
            PaneId::Report => when(
                open.report.is_none(),
                "There is no finished run to report on. `R` runs the case.",
            ),
            PaneId::Nodes => when(
                super::reported(open).is_none(),
                "There is no finished run to write the nodes of. `R` runs the case.",
            ),
            PaneId::Validation => when(
                open.checks.is_empty(),
                "This case states no published values to be held against.",
            ),
            _ => None,
        },
        _ => None,
    }
}

fn keep(open: &OpenCase) -> Option<&'static str> {
    if open.live.kept.is_some() {
        Some("The live run is already kept.")
    } else if open.live.ticket.is_some() {
        Some("The live run is still on its way; it can be kept when it is complete.")
    } else if open.live.done.as_ref().is_none_or(|d| d.run.is_none()) {
        Some("There is no live run to keep.")
    } else {
        None
    }
}

fn go_on(open: &OpenCase) -> Option<&'static str> {
    match open.current_run() {
        None => Some("The live run is in memory only; `R` makes one that can go on."),
        Some(run) => match run.state {
            RunStatus::Queued | RunStatus::Running => {
                Some("This run is still going on; `ctrl+c` stops it.")
            }
            RunStatus::Elsewhere => Some("Another program is still computing this run."),
            RunStatus::Unreadable(_) => Some("This run cannot be read."),
            _ if run.dir.is_none() => Some("This run has no directory to go on from."),
            _ => None,
        },
    }
}

fn delete(open: &OpenCase) -> Option<&'static str> {
    match open.current_run() {
        None => Some("The live run is in memory only; there is nothing to delete."),
        Some(run) if matches!(run.state, RunStatus::Queued | RunStatus::Running) => {
            Some("This run is still going on; `ctrl+c` cancels it.")
        }
        Some(run) if run.state == RunStatus::Elsewhere => {
            Some("Another program is still computing this run.")
        }
        Some(run) if run.kind == RunOrigin::Session && run.dir.is_none() => {
            Some("This run has no directory to delete.")
        }
        Some(_) => None,
    }
}
