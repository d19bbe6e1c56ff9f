//! Trials of a hard case: what they set, which published values they name, which trial they repeat.

use super::line::unknown_name;
use super::paths::unknown_path;
use crate::case::diagnostic::Finding;
use crate::case::fields::field_at;
use crate::case::fields::{join, split};
use crate::case::tree::{Node, element_names};

/// Checks of the trials.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let items = |list| root.get(list).map_or(&[] as &[Node], Node::items);
    let rows = element_names(items("published"));
    let mut found = Vec::new();
    let mut earlier: Vec<&str> = Vec::new();
    for (name, trial) in element_names(items("trial")).iter().zip(items("trial")) {
        let key = |last: &str| join(&["trial", name.as_str(), last]);
        found.extend(words(trial, "set").filter_map(|node| sets(root, node, key("set"))));
        for node in words(trial, "rows") {
            found.extend(names(node, &rows, "published value", key("rows")));
        }
        if let Some(node) = trial.get("same_as") {
            found.extend(names(node, &earlier, "trial further up", key("same_as")));
            if trial.get("same_rel").is_none() {
                let remedy =
                    "add `same_rel = ...`, how far numbers may be apart relative to themselves";
                found.push(Finding::new(
                    &node.span,
                    key("same_rel"),
                    "is missing",
                    remedy,
                ));
            }
        }
        found.extend(idle(trial, key));
        earlier.extend(trial.get("name").and_then(Node::text));
    }
    found
}

/// Keys that say nothing: how far numbers may be from those of no other trial, and what a trial without numbers is held
/// against.
fn idle(trial: &Node, name: impl Fn(&str) -> String) -> Vec<Finding> {
    let one = |key: &str, problem: &str, remedy: &str| {
        let span = &trial.get(key)?.span;
        Some(Finding::new(span, name(key), problem, remedy))
    };
    let mut found = Vec::new();
    if trial.get("refused").is_some() {
        let problem = "has no effect: the trial must be refused, and then has no numbers";
        let keys = ["rows", "told", "same_as"].into_iter();
        found.extend(keys.filter_map(|key| one(key, problem, "remove it, or `refused`")));
    } else if trial.get("same_as").is_none() {
        let remedy = "add `same_as = ...`, the trial further up, or remove it";
        found.extend(one("same_rel", "has no effect without same_as", remedy));
    }
    found
}

fn words<'a>(trial: &'a Node, key: &str) -> impl Iterator<Item = &'a Node> {
    trial.get(key).map_or(&[] as &[Node], Node::items).iter()
}

/// `key=value` with a key that a case can have.
fn sets(root: &Node, node: &Node, key: String) -> Option<Finding> {
    let word = node.text()?;
    let Some((path, _)) = word.split_once('=') else {
        let problem = format!("`{word}` gives no value");
        return Some(Finding::new(
            &node.span,
            key,
            problem,
            "write key=value, as in \"solver.method=rk4\"",
        ));
    };
    let known = split(path).is_some_and(|parts| field_at(&parts).is_some());
    (!known).then(|| {
        let (problem, remedy) = unknown_path(root, path.trim());
        Finding::new(&node.span, key, problem, remedy)
    })
}

fn names<S: AsRef<str>>(node: &Node, known: &[S], what: &str, key: String) -> Option<Finding> {
    let word = node.text()?;
    let known: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
    if known.contains(&word) {
        return None;
    }
    let (problem, remedy) = unknown_name(word, &known, what);
    Some(Finding::new(&node.span, key, problem, remedy))
}
