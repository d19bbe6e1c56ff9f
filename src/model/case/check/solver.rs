//! Keys of the solver that leave others without effect, and the companions it names.

use crate::case::diagnostic::Finding;
use crate::case::model::{CaseKeys, SolverKeys};

/// What a companion may be coarser in.
const COMPANIONS: [&str; 2] = ["steps", "mesh"];
/// The word for those that are as the run in all but one thing.
const NEAREST: &str = "nearest";

/// Checks of the solver.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let Some(solver) = &case.solver else {
        return Vec::new();
    };
    let mut found = companions(solver);
    if solver.time_step_s.is_given() {
        found.extend(solver.longest_step_s.if_given(
            "has no effect: solver.time_step_s sets steps of one length",
            "leave it out, or leave out solver.time_step_s",
        ));
    }
    found
}

fn companions(solver: &SolverKeys<'_>) -> Vec<Finding> {
    let Some(words) = solver.companions.get() else {
        return Vec::new();
    };
    if words.as_slice() == [NEAREST] {
        return Vec::new();
    }
    let words = words.iter().enumerate();
    let others = words.filter(|(_, word)| !COMPANIONS.contains(&word.as_str()));
    let finding = |(index, word): (usize, &String)| {
        let problem = format!("is not known: \"{}\"", word.escape_default());
        let remedy =
            "give `steps` or `mesh` for each companion, from the finest, or `nearest` alone";
        solver.companions.finding_at_item(index, problem, remedy)
    };
    others.map(finding).collect()
}
