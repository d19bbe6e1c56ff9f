//! How a sweep is looked at: the result, the axes, the rule and the cursor; and from a cell or a check to the run behind it.

use std::path::Path;

use super::motion::{moved, step};
use super::notice::{info, warn};
use super::runs;
use crate::case::TextDigest;
use crate::command::CommandId;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::state::sweeps::{CellList, OpenSweep, SweepTab};
use crate::state::{AppState, Filter, JobState, RunEntry, RunOrigin, RunStatus};
use crate::study::load_case_table::{HeatMapChoice, Reduction};
use crate::table_pane::TableVerb;

/// Shows the result so many places further on.
pub fn turn_result(state: &mut AppState, by: isize) {
    let Some(view) = state.sweeps_mut() else {
        return;
    };
    // The shares that checks use are results too.
    view.wants_verdict = true;
    let Some(open) = &mut view.open else { return };
    let count = open.columns().count();
    if count == 0 {
        return;
    }
    let place = (open.result as isize + by).rem_euclid(count as isize);
    open.result = place as usize;
    open.choice.reduction = open
        .shown()
        .map_or(Reduction::default(), |of| Reduction::suiting(&of.name));
    open.arrange();
}

/// Another axis across, or down where `down` says so; one that the other direction shows changes places with it.
pub fn turn_axis(state: &mut AppState, down: bool) {
    let Some(open) = open(state) else { return };
    let count = open.table.axes.len();
    if count < 2 {
        return;
    }
    let HeatMapChoice {
        across,
        down: along,
        ..
    } = open.choice;
    let (own, other) = if down {
        (along, across)
    } else {
        (across, along)
    };
    let next = own.map_or(0, |own| (own + 1) % count);
    // The axis that was here goes where the next one was.
    let other = if other == Some(next) { own } else { other };
    let (across, along) = if down {
        (other, Some(next))
    } else {
        (Some(next), other)
    };
    (open.choice.across, open.choice.down) = (across, along);
    (open.cursor, open.other) = ((0, 0), 0);
    open.arrange();
}

/// The next rule by which load cases of a cell are made one value.
pub fn turn_rule(state: &mut AppState) {
    if let Some(open) = open(state) {
        open.choice.reduction = open.choice.reduction.next();
        open.arrange();
    }
}

/// Another of the axes that are not shown is held next.
pub fn turn_other(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = open(state) else {
        return Vec::new();
    };
    let count = open.choice.others().count();
    if count == 0 {
        return info(state, "All axes of the load cases are shown.");
    }
    open.other = (open.other + 1) % count;
    let place = open.choice.others().nth(open.other);
    let label = place.map_or_else(String::new, |place| open.table.axes[place].label.clone());
    info(
        state,
        format!("`:hold_next` and `:hold_previous` hold {label} at one of its values."),
    )
}

/// Holds an axis that is not shown at its next value; after the last it is not held.
pub fn hold(state: &mut AppState, by: isize) -> Vec<Effect> {
    let Some(open) = open(state) else {
        return Vec::new();
    };
    let Some(place) = open.choice.others().nth(open.other) else {
        return info(state, "All axes of the load cases are shown.");
    };
    let count = open.table.axes[place].values.len() as isize;
    let now = open.choice.held[place].map_or(0, |value| value as isize + 1);
    let next = (now + by).rem_euclid(count + 1);
    open.choice.held[place] = usize::try_from(next - 1).ok();
    open.arrange();
    Vec::new()
}

/// Sorts the table by the result shown, or in the order of the load cases again.
pub fn sort(state: &mut AppState) {
    if let Some(open) = open(state) {
        open.by_result = !open.by_result;
        open.row = 0;
        open.arrange();
    }
}

/// Moves the cursor of what is shown.
pub fn go(state: &mut AppState, id: CommandId) -> Option<()> {
    let across = match id {
        CommandId::CursorRight => 1,
        CommandId::CursorLeft => -1,
        _ => 0,
    };
    let by = if across == 0 { step(state, id)? } else { 0 };
    let view = state.sweeps_mut()?;
    let tab = view.tab;
    let open = view.open.as_mut()?;
    if let Some(cell) = &mut open.cell {
        cell.cursor = moved(cell.cursor, by, cell.shown.len());
        return Some(());
    }
    match tab {
        SweepTab::Map => {
            open.cursor.0 = moved(open.cursor.0, across, open.map.columns);
            open.cursor.1 = moved(open.cursor.1, by, open.map.rows);
        }
        SweepTab::LoadCases if across != 0 => turn_result(state, across),
        SweepTab::LoadCases => open.row = moved(open.row, by, open.order.len()),
        SweepTab::Checks | SweepTab::Seas => {
            let verb = match across {
                0 => TableVerb::Select(by),
                way => TableVerb::Column(way),
            };
            let verdict = open.verdict.as_ref()?;
            match tab {
                SweepTab::Checks => open.checks_pane.act(verb, &verdict.checks),
                _ => open.seas_pane.act(verb, &verdict.seas),
            }
        }
    }
    Some(())
}

/// From a cell or a sea to its load cases, from a load case to its run, from a check to the run that governs it.
pub fn enter(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.sweeps_mut() else {
        return Vec::new();
    };
    let tab = view.tab;
    let Some(open) = view.open.as_mut() else {
        return Vec::new();
    };
    if let Some(cell) = &open.cell {
        let case = cell.shown.get(cell.cursor).copied();
        return case.map_or_else(Vec::new, |case| open_run(state, case, None));
    }
    match tab {
        SweepTab::Map => {
            let cell = open.current();
            let cases = cell.map(|cell| (cell.load_cases.clone(), cell.governing));
            let (cases, governing) = cases.unwrap_or_default();
            list(state, cases, governing)
        }
        SweepTab::LoadCases => match open.order.get(open.row).copied() {
            Some(case) => open_run(state, case, None),
            None => Vec::new(),
        },
        SweepTab::Checks => of_check(state),
        SweepTab::Seas => {
            let verdict = open.verdict.clone().unwrap_or_default();
            let sea = open.seas_pane.selected(&verdict.seas);
            let cases = sea.and_then(|sea| verdict.load_cases.get(sea)).cloned();
            list(state, cases.unwrap_or_default(), None)
        }
    }
}

/// Lists load cases, with the cursor on the one that governs.
fn list(state: &mut AppState, load_cases: Vec<usize>, governing: Option<usize>) -> Vec<Effect> {
    if load_cases.is_empty() {
        return info(state, "There is no load case here.");
    }
    if let Some(open) = open(state) {
        let cursor = load_cases.iter().position(|case| Some(*case) == governing);
        open.filter = Filter::default();
        open.cell = Some(CellList {
            cursor: cursor.unwrap_or(0),
            shown: load_cases.clone(),
            load_cases,
        });
        open.arrange();
    }
    Vec::new()
}

/// The run that governs the check under the cursor, at the time at which it does.
fn of_check(state: &mut AppState) -> Vec<Effect> {
    let Some(open) = open(state) else {
        return Vec::new();
    };
    let verdict = open.verdict.clone().unwrap_or_default();
    let row = open.checks_pane.selected(&verdict.checks);
    let Some(governing) = row.and_then(|row| verdict.governing.get(row)) else {
        return info(state, "There is no check here.");
    };
    match governing.load_case {
        Some(case) => open_run(state, case, governing.time),
        None => info(state, "No single load case governs this check."),
    }
}

/// Back from the load cases of a cell to the map; false where the map is shown already.
pub fn leave(state: &mut AppState) -> bool {
    open(state).is_some_and(|open| {
        let had = open.cell.take().is_some();
        if had {
            open.filter = Filter::default();
            open.arrange();
        }
        had
    })
}

/// Shows the run of a load case alone, as the table of runs does, at a time \[s\] where one is given.
fn open_run(state: &mut AppState, load_case: usize, time: Option<f64>) -> Vec<Effect> {
    let Some(open) = open(state) else {
        return Vec::new();
    };
    let table = open.table.clone();
    let number = load_case + 1;
    let Some(dir) = table.dirs.get(load_case).cloned().flatten() else {
        let state_of = table.states.get(load_case);
        let why = state_of.and_then(|of| of.reason());
        let word = state_of.map_or("not computed", |of| of.word());
        let words = match why {
            Some(why) => format!("Load case {number} has no run, {word}: {why}."),
            None => format!("Load case {number} has no stored run: {word}."),
        };
        return warn(state, words);
    };
    let words = table.words(load_case);
    let effects = show_run(state, &dir, &words, time);
    info(
        state,
        format!(
            "Charts and report show load case {number} ({words}). `:sweep` goes back to the load cases."
        ),
    );
    effects
}

fn show_run(state: &mut AppState, dir: &Path, label: &str, time: Option<f64>) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    view.hide_runs();
    if view.runs.in_dir(dir).is_none() {
        view.runs.extend([entry(dir, label)]);
    }
    let mut effects = Vec::new();
    if let Some(run) = view.runs.in_dir_mut(dir) {
        run.shown = true;
        effects = runs::load(run);
    }
    view.instant = time;
    view.runs.arrange();
    if let Some(document) = &mut state.document {
        document.pane = PaneId::Charts;
    }
    effects
}

/// A stored run that the index has not listed yet.
fn entry(dir: &Path, label: &str) -> RunEntry {
    let name = dir.file_name().unwrap_or_default();
    RunEntry {
        id: name.to_string_lossy().into_owned(),
        label: label.to_owned(),
        kind: RunOrigin::Stored,
        state: RunStatus::Job(JobState::Done),
        dir: Some(dir.to_owned()),
        ..RunEntry::session(TextDigest::of_text(""), String::new())
    }
}

fn open(state: &mut AppState) -> Option<&mut OpenSweep> {
    state.sweeps_mut()?.open.as_mut()
}
