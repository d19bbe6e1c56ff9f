//! What a search came to, in words.

use super::searchable::Searchable;
use super::{Best, EstimatedRun};

/// A case or a system as it reaches its accuracy, or comes nearest to it.
pub(in crate::run) struct Reached<C> {
    /// With the mesh and the steps found.
    pub(in crate::run) found: C,
    /// The keys in which that differs, with their values.
    pub(in crate::run) keys: Vec<(String, String)>,
    /// Its run with the errors; absent where none shows them.
    pub(in crate::run) run: Option<EstimatedRun>,
    /// What was asked, found and reached, in words.
    pub(in crate::run) words: String,
    /// Why it was not reached.
    pub(in crate::run) failure: Option<String>,
}

/// What was found, and that in words.
pub(super) fn reached<C: Searchable>(
    own: &C,
    accuracy: f64,
    best: Option<Best<C>>,
    cost: &str,
    limit: &str,
) -> Reached<C> {
    let Some(best) = best else {
        return Reached {
            found: own.clone(),
            keys: Vec::new(),
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
    let keys = own.found_keys(&best.found);
    let list: Vec<String> = keys.iter().map(as_override).collect();
    // Of a system at rest whose lines all have closed forms.
    let settings = match list.is_empty() {
        true => "as its file is".to_owned(),
        false => list.join(", "),
    };
    let words = format!(
        "{accuracy} asked; {:.2e} reached by 95 % of {count} results, {} of them are within; {settings} ({cost})",
        share * accuracy,
        count - missed.len(),
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
    Reached {
        found: best.found,
        keys,
        run: Some(best.run),
        words,
        failure,
    }
}

/// A key with its value, as it is set on top of a file.
pub(in crate::run) fn as_override((key, value): &(String, String)) -> String {
    format!("{key}={value}")
}
