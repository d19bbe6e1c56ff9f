//! Words that must be the name of something in a file.

use std::collections::HashSet;

use crate::diagnostic::Finding;
use crate::fields::{either, nearest};
use crate::schema::Key;

/// A finding where a key names something that is not among those known of a kind of file.
pub fn unknown<S: AsRef<str>>(
    key: &Key<'_, String>,
    known: &[S],
    what: &str,
    of: &str,
) -> Option<Finding> {
    let (problem, remedy) = unknown_name(key.get()?, known, what, of)?;
    Some(key.finding(problem, remedy))
}

/// Problem and remedy of a word that is not among those known: the nearest one.
pub fn unknown_name<S: AsRef<str>>(
    word: &str,
    known: &[S],
    what: &str,
    of: &str,
) -> Option<(String, String)> {
    let known: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
    if known.contains(&word) {
        return None;
    }
    let problem = format!("there is no {what} named \"{}\"", word.escape_default());
    let remedy = match nearest(word, known.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None if known.is_empty() => format!("the {of} has no {what} yet; add one"),
        None => format!("the {of} has {}", either(&known).replace(" or ", " and ")),
    };
    Some((problem, remedy))
}

/// Findings where a name is used twice.
pub fn used_twice<'k, 'a: 'k>(
    keys: impl Iterator<Item = &'k Key<'a, String>>,
    remedy: &str,
) -> Vec<Finding> {
    let mut taken = HashSet::new();
    let mut found = Vec::new();
    for key in keys {
        let Some(name) = key.get() else {
            continue;
        };
        if !taken.insert(name.as_str()) {
            found.push(key.finding(format!("the name \"{name}\" is used twice"), remedy));
        }
    }
    found
}
