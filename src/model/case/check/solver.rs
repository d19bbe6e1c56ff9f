//! Keys of the solver that leave others without effect, and the companions it names.

use crate::case::diagnostic::Finding;
use crate::case::model::CaseKeys;
use crate::case::schema::Key;

/// What a companion may be coarser in.
const COMPANIONS: [&str; 2] = ["steps", "mesh"];
/// The word for those that are as the run in all but one thing.
const NEAREST: &str = "nearest";

/// Checks of the solver.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let Some(solver) = &case.solver else {
        return Vec::new();
    };
    let mut found = of_companions(&solver.companions);
    found.extend(of_longest_step(&solver.time_step_s, &solver.longest_step_s));
    found
}

/// A longest step beside steps of one length.
pub fn of_longest_step(step: &Key<'_, f64>, longest: &Key<'_, f64>) -> Option<Finding> {
    let has_no_effect = longest.if_given(
        "has no effect: solver.time_step_s sets steps of one length",
        "leave it out, or leave out solver.time_step_s",
    );
    has_no_effect.filter(|_| step.is_given())
}

/// Companions that are not known.
pub fn of_companions(companions: &Key<'_, Vec<String>>) -> Vec<Finding> {
    let Some(words) = companions.get() else {
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
        companions.finding_at_item(index, problem, remedy)
    };
    others.map(finding).collect()
}
