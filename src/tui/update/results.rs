//! The results beside the inputs: which, and what they are held against.

use super::notice::info;
use crate::case::QuantityId;
use crate::msg::Effect;
use crate::result_lines::{listed, solved_run};
use crate::state::AppState;
use crate::study::results::main_results;

/// The most results beside the inputs.
const MOST: usize = 5;

/// Shows the result under the cursor beside the inputs, or takes it off.
pub fn choose(state: &mut AppState) -> Vec<Effect> {
    let Some(id) = at_cursor(state) else {
        return Vec::new();
    };
    let Some(line) = state.line_mut() else {
        return Vec::new();
    };
    if let Some(at) = line.results.iter().position(|chosen| *chosen == id) {
        line.results.remove(at);
    } else if line.results.len() < MOST {
        line.results.push(id);
    } else {
        return info(
            state,
            "Five results stand beside the inputs already; `:select` takes one off.",
        );
    }
    Vec::new()
}

/// The result under the cursor.
pub(super) fn at_cursor(state: &AppState) -> Option<QuantityId> {
    let document = state.document.as_ref()?;
    listed(document).into_iter().nth(document.result)
}

/// Why nothing can be done with a result.
#[must_use]
pub fn why_no_result(state: &AppState) -> Option<&'static str> {
    at_cursor(state)
        .is_none()
        .then_some("There is no result yet.")
}

/// Why a result cannot stand beside the inputs.
#[must_use]
pub fn why_not_beside(state: &AppState) -> Option<&'static str> {
    let words =
        "Only results of a line case, which is solved with every edit, stand beside the inputs.";
    let other = state.line().is_none().then_some(words);
    other.or_else(|| why_no_result(state))
}

/// Why the results cannot be held.
#[must_use]
pub fn why_not_held(state: &AppState) -> Option<&'static str> {
    if state.line().is_none() {
        return Some("A run of a system is held against in the table of runs.");
    }
    let coarse = state
        .line()
        .is_some_and(|line| line.runs_view.live.coarse.is_some());
    let words = "These results are coarse; they can be held when the full solve is complete.";
    why_no_result(state).or(coarse.then_some(words))
}

/// Whether the main results of the case stand beside the inputs.
#[must_use]
pub fn shows_main_ones(state: &AppState) -> bool {
    state.line().is_none_or(|line| {
        let main = main_results(&line.case);
        line.results[..] == main[..main.len().min(MOST)]
    })
}

/// Shows the main results of the case again.
pub fn main_ones(state: &mut AppState) {
    if let Some(line) = state.line_mut() {
        line.results = main_results(&line.case);
        line.results.truncate(MOST);
    }
}

/// Holds the results as they are now.
pub fn hold_live(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    let Some(run) = solved_run(view).cloned() else {
        return info(state, "There is no complete result to hold yet.");
    };
    view.against = Some(("the results held".to_owned(), run));
    info(
        state,
        "Held: later results are shown with their difference from these.",
    )
}

/// Holds the run under the cursor of the table, which is read where it is not yet.
pub fn hold_run(state: &mut AppState) -> Vec<Effect> {
    let Some(view) = state.runs_view_mut() else {
        return Vec::new();
    };
    let Some(entry) = view.runs.current() else {
        return hold_live(state);
    };
    let name = entry.title();
    match &entry.curves.run {
        Some(run) => {
            view.against = Some((name.clone(), run.clone()));
            view.hold = None;
            info(
                state,
                format!("The results beside the inputs are held against {name}."),
            )
        }
        None => {
            let effects = super::runs::load(entry);
            view.hold.clone_from(&entry.dir);
            effects
        }
    }
}
