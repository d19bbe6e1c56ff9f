//! Which keys do which command: those that commands declare, and those that the user binds in a file.

pub mod file;
pub mod listing;
pub mod names;
pub mod registry;
mod words;

use std::collections::HashMap;
use std::sync::Arc;

use super::command::{Command, CommandId, CommandOrder};
use super::pane::PaneId;

/// The keys that the user binds in place of those that commands declare.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct KeyTable {
    chosen: HashMap<(Scope, CommandId), Arc<[String]>>,
}

/// Where a binding holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scope {
    /// Wherever there is the command.
    Everywhere,
    /// In a pane.
    Pane(PaneId),
}

/// The keys of a command.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BoundKeys {
    /// Those that it declares.
    Declared(&'static [&'static str]),
    /// Those that the user binds.
    Chosen(Arc<[String]>),
}

impl BoundKeys {
    /// Their names, the one shown in the footer first.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        let (declared, chosen): (&[&str], &[String]) = match self {
            Self::Declared(keys) => (keys, &[]),
            Self::Chosen(keys) => (&[], keys),
        };
        let declared = declared.iter().copied();
        declared.chain(chosen.iter().map(String::as_str))
    }

    /// The key shown in the footer.
    #[must_use]
    pub fn first(&self) -> Option<&str> {
        self.iter().next()
    }

    /// Whether a key is among them.
    #[must_use]
    pub fn has(&self, key: &str) -> bool {
        self.iter().any(|own| own == key)
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.first().is_none()
    }

    /// All of them with blanks between.
    #[must_use]
    pub fn joined(&self) -> String {
        self.iter().collect::<Vec<_>>().join(" ")
    }
}

/// A command with the keys that it has in a pane.
#[derive(Debug, Clone)]
pub struct BoundCommand {
    /// What it does.
    pub id: CommandId,
    /// Its keys.
    pub keys: BoundKeys,
    /// Two words for the footer; empty: not in the footer.
    pub label: &'static str,
    /// One line for help and palette.
    pub doc: &'static str,
    /// Position in footer, help and palette.
    pub order: CommandOrder,
}

impl KeyTable {
    /// Binds a command to keys.
    pub fn bind(&mut self, scope: Scope, id: CommandId, keys: Vec<String>) {
        self.chosen.insert((scope, id), keys.into());
    }

    /// The keys of a command in a pane.
    #[must_use]
    pub fn keys_of(&self, pane: PaneId, command: &Command) -> BoundKeys {
        match self.chosen.get(&(Scope::Pane(pane), command.id)) {
            Some(keys) => BoundKeys::Chosen(Arc::clone(keys)),
            None => self.everywhere(command),
        }
    }

    /// The keys of a command wherever no table of a pane binds it.
    #[must_use]
    pub fn everywhere(&self, command: &Command) -> BoundKeys {
        match self.chosen.get(&(Scope::Everywhere, command.id)) {
            Some(keys) => BoundKeys::Chosen(Arc::clone(keys)),
            None => BoundKeys::Declared(command.keys),
        }
    }

    /// A command with the keys that it has in a pane.
    #[must_use]
    pub fn bound(&self, pane: PaneId, command: &Command) -> BoundCommand {
        BoundCommand {
            id: command.id,
            keys: self.keys_of(pane, command),
            label: command.label,
            doc: command.doc,
            order: command.order,
        }
    }
}
