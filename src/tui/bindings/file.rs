//! The file of keys: `[keys]` binds a command wherever it is, `[charts]` and the like in one pane.
//!
//! What is wrong is reported with its place, and the commands meant keep the keys that they declare.

use std::ops::Range;

use super::names::{command_of, name, pane_name, pane_of};
use super::registry::{FIXED, together};
use super::{KeyTable, Scope};
use crate::case::{Diagnostic, Finding, TomlNode, diagnose, nearest, tree_of};
use crate::command::{Command, CommandId};
use crate::key::KeyPress;
use crate::pane::PaneId;

/// The name of the table of what holds everywhere.
pub const EVERYWHERE: &str = "keys";

/// A line of the file that binds a command.
struct Binding {
    scope: Scope,
    id: CommandId,
    keys: Vec<String>,
    /// The bytes of each key, or of the whole value where there is none.
    places: Vec<Range<usize>>,
}

/// Reads the text of a file of this name.
#[must_use]
pub fn read(text: &str, file: &str) -> (KeyTable, Vec<Diagnostic>) {
    let (bindings, mut found) = match tree_of(text) {
        Ok(tree) => bindings(&tree),
        Err(faults) => (Vec::new(), faults),
    };
    let (kept, conflicts) = without_conflicts(bindings);
    found.extend(conflicts);
    found.sort_by_key(|finding| finding.span.start);
    let mut table = KeyTable::default();
    for binding in kept {
        table.bind(binding.scope, binding.id, binding.keys);
    }
    (table, diagnose(found, text, file))
}

/// The bindings of the file, and what is wrong with its lines one by one.
fn bindings(tree: &TomlNode) -> (Vec<Binding>, Vec<Finding>) {
    let (mut bindings, mut found) = (Vec::new(), Vec::new());
    for table in tree.entries() {
        let scope = match scope_of(&table.key) {
            Some(scope) if table.node.is_table() => scope,
            Some(_) => {
                let remedy = format!(
                    "write a table: [{}], and below it a command a line",
                    table.key
                );
                found.push(Finding::new(
                    &table.key_span,
                    &table.key,
                    "is no table",
                    remedy,
                ));
                continue;
            }
            None => {
                found.push(unknown_table(&table.key, &table.key_span));
                continue;
            }
        };
        for entry in table.node.entries() {
            let path = format!("{}.{}", table.key, entry.key);
            match command(scope, &entry.key).and_then(|id| {
                let (keys, places) = keys(&entry.node)?;
                Ok(Binding {
                    scope,
                    id,
                    keys,
                    places,
                })
            }) {
                Ok(binding) => bindings.push(binding),
                Err(fault) => {
                    let span = fault.span.unwrap_or(entry.key_span.clone());
                    found.push(Finding::new(&span, path, fault.problem, fault.remedy));
                }
            }
        }
    }
    (bindings, found)
}

fn scope_of(table: &str) -> Option<Scope> {
    match table {
        EVERYWHERE => Some(Scope::Everywhere),
        table => pane_of(table).map(Scope::Pane),
    }
}

fn unknown_table(key: &str, span: &Range<usize>) -> Finding {
    let mut names: Vec<String> = PaneId::ALL.into_iter().map(pane_name).collect();
    names.insert(0, EVERYWHERE.to_owned());
    let remedy = match nearest(key, names.iter().map(String::as_str)) {
        Some(meant) => format!("write [{meant}]"),
        None => format!("the tables are [{}]", names.join("], [")),
    };
    Finding::new(span, key, "is neither `keys` nor a pane", remedy)
}

/// What is wrong with a line; its name is meant where no place is given.
struct BindingFault {
    span: Option<Range<usize>>,
    problem: String,
    remedy: String,
}

impl BindingFault {
    fn of_name(problem: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            span: None,
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    fn at(span: &Range<usize>, problem: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            span: Some(span.clone()),
            ..Self::of_name(problem, remedy)
        }
    }
}

/// The command of a name that may be bound here.
fn command(scope: Scope, word: &str) -> Result<CommandId, BindingFault> {
    let found = command_of(word).ok_or_else(|| unknown_command(scope, word))?;
    if FIXED.contains(&found) {
        let remedy = "leave the line out; the terminal sends this key as a signal to every program";
        return Err(BindingFault::of_name(
            "is a command whose key is fixed",
            remedy,
        ));
    }
    let Scope::Pane(pane) = scope else {
        return Ok(found);
    };
    if together(pane).iter().any(|command| command.id == found) {
        return Ok(found);
    }
    let panes = PaneId::ALL.into_iter();
    let with = panes.filter(|pane| together(*pane).iter().any(|command| command.id == found));
    let names: Vec<String> = with.map(|pane| format!("[{}]", pane_name(pane))).collect();
    let remedy = format!(
        "it is a command of {}; [{EVERYWHERE}] binds it in all of them",
        names.join(", ")
    );
    Err(BindingFault::of_name(
        format!("is no command of the pane {}", pane_name(pane)),
        remedy,
    ))
}

fn unknown_command(scope: Scope, word: &str) -> BindingFault {
    let here = match scope {
        Scope::Pane(pane) => together(pane),
        Scope::Everywhere => super::registry::declared()
            .into_iter()
            .map(|(_, command)| command)
            .collect(),
    };
    let names: Vec<String> = here.iter().map(|command| name(command.id)).collect();
    let remedy = match nearest(word, names.iter().map(String::as_str)) {
        Some(meant) => format!("write `{meant}`"),
        None => "`seacable bindings` lists the commands".to_owned(),
    };
    BindingFault::of_name("is no command", remedy)
}

/// The keys of a value: one in quotes, or a list of them.
fn keys(value: &TomlNode) -> Result<(Vec<String>, Vec<Range<usize>>), BindingFault> {
    let one = std::slice::from_ref(value);
    let items = if value.text().is_some() {
        one
    } else {
        value.items()
    };
    if value.text().is_none() && !value.is_list() {
        let remedy =
            r#"give a key in quotes, "ctrl+r", or a list of keys, ["+", "="]; [] for none"#;
        return Err(BindingFault::at(
            &value.span,
            format!("is {}", value.describe()),
            remedy,
        ));
    }
    let mut keys: Vec<String> = Vec::new();
    for item in items {
        let Some(word) = item.text() else {
            let remedy = "give each key in quotes";
            return Err(BindingFault::at(
                &item.span,
                format!("holds {}", item.describe()),
                remedy,
            ));
        };
        let key =
            key(word).map_err(|(problem, remedy)| BindingFault::at(&item.span, problem, remedy))?;
        if keys.contains(&key) {
            return Err(BindingFault::at(
                &item.span,
                format!("`{key}` is given twice"),
                "leave one out",
            ));
        }
        keys.push(key);
    }
    let places = items.iter().map(|item| item.span.clone()).collect();
    Ok((keys, places))
}

/// A key by its name, as the screen words it.
fn key(word: &str) -> Result<String, (String, String)> {
    let key = KeyPress::of_user(word).map_err(|error| {
        let remedy = "names are enter, esc, tab, shift+tab, space, backspace, del, ins, up, down, left, right, home, end, pgup and pgdn";
        (error.to_string(), remedy.to_owned())
    })?;
    let arrives_as = match key {
        KeyPress::Ctrl('c' | 'z') => {
            let problem = format!("`{key}` is fixed: it stops a job or the program everywhere");
            return Err((problem, "give another key".to_owned()));
        }
        KeyPress::Ctrl('h') => "backspace",
        KeyPress::Ctrl('i') => "tab",
        KeyPress::Ctrl('j' | 'm') => "enter",
        key => return Ok(key.to_string()),
    };
    let problem = format!("a terminal sends `{key}` as `{arrives_as}`");
    Err((problem, "give another key".to_owned()))
}

/// The bindings that can hold together, and those that cannot, each at the key that is taken.
fn without_conflicts(mut bindings: Vec<Binding>) -> (Vec<Binding>, Vec<Finding>) {
    let mut found = Vec::new();
    while let Some((at, finding)) = conflict(&bindings) {
        bindings.remove(at);
        found.push(finding);
    }
    (bindings, found)
}

/// A command of a pane with the keys that it would have.
struct PaneBinding<'a> {
    command: Command,
    keys: Vec<&'a str>,
    /// The binding that gives them; nothing for those that it declares.
    by: Option<usize>,
}

/// The first binding of which a key does something else in some pane.
fn conflict(bindings: &[Binding]) -> Option<(usize, Finding)> {
    PaneId::ALL.into_iter().find_map(|pane| {
        let held = held(pane, bindings);
        held.iter().enumerate().find_map(|(place, one)| {
            let mut others = held[place + 1..].iter();
            others.find_map(|other| shared(pane, one, other, bindings))
        })
    })
}

/// The commands of a pane with the keys that the bindings give them.
fn held(pane: PaneId, bindings: &[Binding]) -> Vec<PaneBinding<'_>> {
    let by = |id: CommandId| {
        let of = |scope: Scope| {
            bindings
                .iter()
                .rposition(|b| b.scope == scope && b.id == id)
        };
        of(Scope::Pane(pane)).or_else(|| of(Scope::Everywhere))
    };
    let each = together(pane).into_iter().map(|command| {
        let by = by(command.id);
        let keys = match by {
            Some(at) => bindings[at].keys.iter().map(String::as_str).collect(),
            None => command.keys.to_vec(),
        };
        PaneBinding { command, keys, by }
    });
    each.collect()
}

/// The binding that takes a key of the other command, with what is wrong; keys that both declare are shared on purpose.
fn shared(
    pane: PaneId,
    one: &PaneBinding,
    other: &PaneBinding,
    bindings: &[Binding],
) -> Option<(usize, Finding)> {
    let declared = |key: &str| one.command.keys.contains(&key) && other.command.keys.contains(&key);
    let mut both = one.keys.iter().filter(|key| other.keys.contains(key));
    let key = both.find(|key| !declared(key))?;
    // The later of two lines is wrong, and a line against what a command declares.
    let (at, taken) = match (one.by, other.by) {
        (Some(first), Some(second)) if first > second => (first, other),
        (Some(first), None) => (first, other),
        (_, Some(second)) => (second, one),
        (None, None) => return None,
    };
    let binding = &bindings[at];
    let place = binding.keys.iter().position(|own| own == key)?;
    let path = match binding.scope {
        Scope::Everywhere => format!("{EVERYWHERE}.{}", name(binding.id)),
        Scope::Pane(pane) => format!("{}.{}", pane_name(pane), name(binding.id)),
    };
    let of = name(taken.command.id);
    let problem = format!(
        "`{key}` is the key of `{of}` in the pane {}",
        pane_name(pane)
    );
    let remedy = format!("give another key, or give `{of}` another one too");
    Some((
        at,
        Finding::new(&binding.places[place], path, problem, remedy),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(text: &str) -> Vec<String> {
        let (_, faults) = read(text, "keys.toml");
        faults.iter().map(ToString::to_string).collect()
    }

    fn keys(text: &str, pane: PaneId, id: CommandId) -> String {
        let (table, faults) = read(text, "keys.toml");
        assert!(faults.is_empty(), "{faults:?}");
        let all = together(pane);
        let command = all.iter().find(|command| command.id == id).unwrap();
        table.keys_of(pane, command).joined()
    }

    #[test]
    fn a_pane_goes_before_everywhere_and_both_before_what_is_declared() {
        let text = "[keys]\nrun = \"F5\"\ndown = [\"f9\", \"Down\"]\n[charts]\nzoom_in = \"Ctrl+X\"\nrun = \"space\"\n";
        assert_eq!(keys(text, PaneId::Inputs, CommandId::Run), "f5");
        assert_eq!(keys(text, PaneId::Charts, CommandId::Run), "space");
        assert_eq!(keys(text, PaneId::Inputs, CommandId::Down), "f9 down");
        assert_eq!(keys(text, PaneId::Charts, CommandId::ZoomIn), "ctrl+x");
        assert_eq!(keys(text, PaneId::Charts, CommandId::ZoomOut), "-");
    }

    #[test]
    fn what_is_wrong_is_reported_at_its_place_with_a_remedy() {
        let text = "[keys]\nrnu = \"F5\"\nrun = \"f13\"\nsave = \"ctrl+c\"\nundo = 3\nquit = \"ctrl+m\"\ninterrupt = \"x\"\n[chart]\nfit = \"0\"\n[runs]\nzoom_in = \"+\"\n";
        assert_eq!(
            faults(text),
            [
                "keys.toml:2:1: keys.rnu: is no command; write `run`",
                "keys.toml:3:7: keys.run: `f13` is no key; keys are a character, `ctrl+` and a letter, `f1` to `f12`, or a name such as `enter`; names are enter, esc, tab, shift+tab, space, backspace, del, ins, up, down, left, right, home, end, pgup and pgdn",
                "keys.toml:4:8: keys.save: `ctrl+c` is fixed: it stops a job or the program everywhere; give another key",
                "keys.toml:5:8: keys.undo: is a whole number; give a key in quotes, \"ctrl+r\", or a list of keys, [\"+\", \"=\"]; [] for none",
                "keys.toml:6:8: keys.quit: a terminal sends `ctrl+m` as `enter`; give another key",
                "keys.toml:7:1: keys.interrupt: is a command whose key is fixed; leave the line out; the terminal sends this key as a signal to every program",
                "keys.toml:8:2: chart: is neither `keys` nor a pane; write [charts]",
                "keys.toml:11:1: runs.zoom_in: is no command of the pane runs; it is a command of [charts], [drawing]; [keys] binds it in all of them",
            ]
        );
    }

    #[test]
    fn a_key_that_does_something_else_is_a_conflict_and_the_command_keeps_its_own() {
        let text = "[charts]\nzoom_in = \"f\"\nzoom_out = [\"f2\", \"q\"]\nfit = \"f3\"\nfreeze = \"f3\"\n";
        assert_eq!(
            faults(text),
            [
                "keys.toml:2:11: charts.zoom_in: `f` is the key of `freeze` in the pane charts; give another key, or give `freeze` another one too",
                "keys.toml:3:19: charts.zoom_out: `q` is the key of `quit` in the pane charts; give another key, or give `quit` another one too",
                "keys.toml:5:10: charts.freeze: `f3` is the key of `fit` in the pane charts; give another key, or give `fit` another one too",
            ]
        );
        let (table, _) = read(text, "keys.toml");
        let all = together(PaneId::Charts);
        let of = |id| {
            table
                .keys_of(PaneId::Charts, all.iter().find(|c| c.id == id).unwrap())
                .joined()
        };
        assert_eq!([of(CommandId::Freeze), of(CommandId::Fit)], ["f", "f3"]);
    }

    #[test]
    fn keys_may_change_places() {
        let text = "[keys]\nundo = \"s\"\nsave = \"u\"\n";
        assert_eq!(keys(text, PaneId::Inputs, CommandId::Undo), "s");
        let text = "[keys]\nquit = []\nhelp = \"q\"\n";
        assert_eq!(keys(text, PaneId::Runs, CommandId::Quit), "");
        assert_eq!(keys(text, PaneId::Runs, CommandId::Help), "q");
    }

    #[test]
    fn a_file_that_is_no_toml_says_where() {
        let found = faults("[keys\nrun = \"x\"\n");
        assert!(found[0].starts_with("keys.toml:1:"), "{found:?}");
        assert!(read("", "keys.toml").1.is_empty());
    }
}
