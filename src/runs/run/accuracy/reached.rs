//! What a search came to: the request with the mesh and the steps found, and that in words.

use super::{Best, EstimatedRun};
use crate::case::model::CASE;
use crate::case::{Case, Method, edit};
use crate::run::job::Request;
use crate::run::settings::method_name;

/// A case as it reaches its accuracy, or comes nearest to it.
pub(in crate::run) struct Reached {
    /// The request with the mesh and the steps found.
    pub(in crate::run) request: Request,
    /// Its run with the errors; absent where none shows them.
    pub(in crate::run) run: Option<EstimatedRun>,
    /// What was asked, found and reached, in words.
    pub(in crate::run) words: String,
    /// Why it was not reached.
    pub(in crate::run) failure: Option<String>,
}

/// The request with what was found, and what that is in words.
pub(super) fn reached(
    request: &Request,
    accuracy: f64,
    best: Option<Best>,
    cost: &str,
    limit: &str,
) -> Reached {
    let Some(best) = best else {
        return Reached {
            request: request.clone(),
            run: None,
            words: format!("{accuracy} asked; no run of the search shows its errors ({cost})"),
            failure: Some(format!(
                "the accuracy of {accuracy} is not reached ({limit}): the case is computed as it is set"
            )),
        };
    };
    let share = best.shares.reached();
    let missed: Vec<String> = best.shares.missed().map(|(_, name)| name.clone()).collect();
    let count = best.shares.all.len();
    let settings = settings(request, &best.case);
    let list: Vec<String> = settings
        .iter()
        .map(|(key, value)| format!("{key}={value}"))
        .collect();
    let words = format!(
        "{accuracy} asked; {:.2e} reached by 95 % of {count} results, {} of them are within; {} ({cost})",
        share * accuracy,
        count - missed.len(),
        list.join(", "),
    );
    let failure = (share > 1.0).then(|| {
        let few: Vec<&str> = missed.iter().take(3).map(String::as_str).collect();
        let more = missed.len() - few.len();
        let and = if more > 0 { format!(" and {more} more") } else { String::new() };
        format!(
            "the accuracy of {accuracy} is not reached ({limit}): {:.1e} is; {}{and} are less accurate",
            share * accuracy,
            few.join(", ")
        )
    });
    let mut request = request.clone();
    if let Some(text) = text(&request.text, &settings) {
        request.text = text;
    }
    let is_asked = |key: &String| ASKED.iter().any(|asked| key.starts_with(asked));
    request.overrides.retain(|key| !is_asked(key));
    request.overrides.extend(list);
    request.case = best.case;
    Reached {
        request,
        run: Some(best.run),
        words,
        failure,
    }
}

/// What a search is asked, and a case that was found asks no more: computed again it is the same.
const ASKED: [&str; 2] = ["solver.accuracy", "solver.budget_s"];

/// The text of the case with what was found in the place of what was asked.
fn text(own: &str, settings: &[(String, String)]) -> Option<String> {
    let edits: Vec<(&str, &str)> = settings
        .iter()
        .map(|(key, value)| (key.as_str(), value.as_str()))
        .collect();
    let (mut text, _) = edit::put_all(&CASE, own, &edits).ok()?;
    for key in ASKED {
        text = edit::cut(&text, key).unwrap_or(text);
    }
    Some(text)
}

/// The keys of mesh and steps, with their values.
fn settings(request: &Request, found: &Case) -> Vec<(String, String)> {
    let mut keys: Vec<(String, String)> = Vec::new();
    for (own, section) in request.case.line.iter().zip(&found.line) {
        if own.segments != section.segments {
            keys.push((
                format!("line.{}.segments", section.name),
                section.segments.to_string(),
            ));
        }
    }
    let solver = &found.solver;
    if solver.method == Method::Alpha && solver.time_step_s.is_none() {
        keys.push((
            "solver.step_tolerance".to_owned(),
            format!("{:?}", solver.step_tolerance),
        ));
    }
    let steps = [
        ("solver.time_step_s", solver.time_step_s),
        ("solver.longest_step_s", solver.longest_step_s),
    ];
    for (key, step) in steps {
        keys.extend(step.map(|step| (key.to_owned(), format!("{step:?}"))));
    }
    let companions = solver.companions.as_deref().unwrap_or_default();
    keys.push(("solver.companions".to_owned(), format!("{companions:?}")));
    keys.push((
        "solver.method".to_owned(),
        method_name(solver.method).to_owned(),
    ));
    keys
}
