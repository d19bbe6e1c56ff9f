//! What a search came to: the request with the mesh and the steps found, and that in words.

use super::{EstimatedRun, Round};
use crate::case::{Case, Method, edit};
use crate::run::job::Request;
use crate::run::settings::method_name;

/// A case as it reaches its accuracy, or comes nearest to it.
pub(in crate::run) struct Reached {
    /// The request with the mesh and the steps found.
    pub(in crate::run) request: Request,
    /// Its run with the errors; absent where none was complete.
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
    best: Option<Round>,
    cost: &str,
    limit: &str,
) -> Reached {
    let Some(best) = best else {
        return Reached {
            request: request.clone(),
            run: None,
            words: format!("{accuracy} asked; no run was complete ({cost})"),
            failure: Some(format!(
                "the accuracy of {accuracy} is not reached: no run of the search was complete"
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
    let edits: Vec<(&str, &str)> = settings
        .iter()
        .map(|(key, value)| (key.as_str(), value.as_str()))
        .collect();
    let mut request = request.clone();
    if let Ok(text) = edit::set_all(&request.text, &edits) {
        request.text = text;
    }
    request.overrides.extend(list);
    request.case = best.case;
    Reached {
        request,
        run: Some(best.run),
        words,
        failure,
    }
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
    if let Some(step) = solver.time_step_s {
        keys.push(("solver.time_step_s".to_owned(), format!("{step:?}")));
    }
    keys.push((
        "solver.method".to_owned(),
        method_name(solver.method).to_owned(),
    ));
    keys
}
