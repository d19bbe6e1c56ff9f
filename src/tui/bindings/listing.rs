//! The commands as a table, and as a file of keys with a comment for each.

use super::file::EVERYWHERE;
use super::names::{name, pane_name};
use super::registry::{FIXED, declared};
use super::{BoundKeys, KeyTable, Scope};
use crate::command::Command;
use crate::pane::PaneId;
use crate::table::Table;
use crate::wrap::{WideWords, wrap};

/// Columns of the comments.
const WIDTH: usize = 100;

/// What the file says of itself.
const HEAD: &str = "\
## Keys of the workbench. This file as it is changes nothing: every line is a comment. Take the `# ` off the lines to
## change, and off the name of their table. A key is a character, `ctrl+` and a letter, f1 to f12, or a name: enter, esc,
## tab, shift+tab, space, backspace, del, ins, up, down, left, right, home, end, pgup, pgdn. A list gives several, [] none.
## A table of a pane goes before [keys]. Keys of lines that are typed, and of windows that lie over the screen, are fixed,
## and so are ctrl+c and ctrl+z. Screen and tmux take ctrl+a and ctrl+b, and some terminals ctrl+s and ctrl+q.
";

/// The commands by the tables of the file in which they are listed: those that many panes share in the first.
fn sections() -> Vec<(Scope, Vec<Command>)> {
    let all: Vec<(Scope, Command)> = declared()
        .into_iter()
        .filter(|(_, command)| !FIXED.contains(&command.id))
        .collect();
    let shared = |command: &Command| {
        let mut everywhere = all.iter().filter(|(scope, _)| *scope == Scope::Everywhere);
        everywhere.any(|(_, other)| other.id == command.id && other.keys == command.keys)
    };
    let scopes = std::iter::once(Scope::Everywhere).chain(PaneId::ALL.into_iter().map(Scope::Pane));
    let of = |scope: Scope| {
        let own = all
            .iter()
            .filter(|(of, _)| *of == scope)
            .map(|(_, command)| *command);
        let listed = own.filter(|command| scope == Scope::Everywhere || !shared(command));
        (scope, listed.collect::<Vec<Command>>())
    };
    scopes
        .map(of)
        .filter(|(_, commands)| !commands.is_empty())
        .collect()
}

/// The name of a table of the file.
fn table_name(scope: Scope) -> String {
    match scope {
        Scope::Everywhere => EVERYWHERE.to_owned(),
        Scope::Pane(pane) => pane_name(pane),
    }
}

/// A file that binds every command to the keys that it declares, every line of it a comment.
#[must_use]
pub fn default_file() -> String {
    let mut text = HEAD.to_owned();
    for (scope, commands) in sections() {
        text.push_str(&format!("\n# [{}]\n", table_name(scope)));
        for command in commands {
            text.push('\n');
            for line in wrap(command.doc, WIDTH, WideWords::Whole) {
                text.push_str(&format!("## {line}\n"));
            }
            text.push_str(&format!(
                "# {} = {}\n",
                name(command.id),
                value(command.keys)
            ));
        }
    }
    text
}

/// Keys as a value of the file.
fn value(keys: &[&str]) -> String {
    let quoted: Vec<String> = keys
        .iter()
        .map(|key| toml::Value::from(*key).to_string())
        .collect();
    match quoted.as_slice() {
        [one] => one.clone(),
        all => format!("[{}]", all.join(", ")),
    }
}

/// A line of the listing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ListedCommand {
    /// The table of the file in which it is bound.
    pub table: String,
    /// Its name.
    pub name: String,
    /// Its keys as the user has them.
    pub keys: BoundKeys,
    /// What it does.
    pub doc: &'static str,
}

/// All commands with the keys that the user has.
#[must_use]
pub fn commands(keys: &KeyTable) -> Vec<ListedCommand> {
    let each = sections().into_iter().flat_map(|(scope, commands)| {
        let listed = move |command: Command| {
            let bound = match scope {
                Scope::Everywhere => keys.everywhere(&command),
                Scope::Pane(pane) => keys.keys_of(pane, &command),
            };
            ListedCommand {
                table: table_name(scope),
                name: name(command.id),
                keys: bound,
                doc: command.doc,
            }
        };
        commands.into_iter().map(listed)
    });
    each.collect()
}

/// The listing as a table.
#[must_use]
pub fn table(listed: &[ListedCommand]) -> Table {
    Table::of_records("", listed)
        .text("table", |line| line.table.clone())
        .text("command", |line| line.name.clone())
        .text("keys", |line| line.keys.joined())
        .text("what it does", |line| line.doc)
        .build()
}

#[cfg(test)]
mod tests {
    use super::super::file::read;
    use super::super::registry::together;
    use super::*;

    /// The file with its lines in force.
    fn in_force() -> String {
        let lines = default_file();
        let lines = lines.lines().filter(|line| !line.starts_with("##"));
        let tables = lines.filter_map(|line| line.strip_prefix("# "));
        let bound = tables.filter(|line| line.starts_with('[') || line.contains(" = "));
        bound.map(|line| format!("{line}\n")).collect()
    }

    #[test]
    fn the_default_file_read_back_changes_no_key() {
        let text = in_force();
        let (table, faults) = read(&text, "keys.toml");
        assert!(faults.is_empty(), "{faults:#?}");
        for pane in PaneId::ALL {
            for command in together(pane) {
                if FIXED.contains(&command.id) {
                    continue;
                }
                let keys = table.keys_of(pane, &command);
                let declared = BoundKeys::Declared(command.keys).joined();
                assert_eq!(keys.joined(), declared, "{pane:?} {:?}", command.id);
            }
        }
    }

    #[test]
    fn the_default_file_as_it_is_binds_nothing() {
        let (table, faults) = read(&default_file(), "keys.toml");
        assert!(faults.is_empty() && table == KeyTable::default());
    }
}
