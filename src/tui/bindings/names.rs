//! The names of commands and panes in the file of keys and on the command line of the screen.

use super::registry;
use crate::command::CommandId;
use crate::pane::PaneId;

/// The name of a command: `zoom_in`.
#[must_use]
pub fn name(id: CommandId) -> String {
    match id {
        CommandId::Pane(number) => format!("pane_{number}"),
        id => snake(&format!("{id:?}")),
    }
}

/// The command of a name.
#[must_use]
pub fn command_of(word: &str) -> Option<CommandId> {
    let mut all = registry::declared()
        .into_iter()
        .map(|(_, command)| command.id);
    all.find(|id| name(*id) == word)
}

/// The name of a pane: `charts`.
#[must_use]
pub fn pane_name(pane: PaneId) -> String {
    snake(&format!("{pane:?}"))
}

/// The pane of a name.
#[must_use]
pub fn pane_of(word: &str) -> Option<PaneId> {
    PaneId::ALL
        .into_iter()
        .find(|pane| pane_name(*pane) == word)
}

/// `ZoomIn` as `zoom_in`.
fn snake(camel: &str) -> String {
    let mut name = String::with_capacity(camel.len() + 4);
    for letter in camel.chars() {
        if letter.is_ascii_uppercase() && !name.is_empty() {
            name.push('_');
        }
        name.push(letter.to_ascii_lowercase());
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        assert_eq!(name(CommandId::ZoomIn), "zoom_in");
        assert_eq!(name(CommandId::Pane(3)), "pane_3");
        assert_eq!(command_of("pane_10"), Some(CommandId::Pane(10)));
        for (_, command) in registry::declared() {
            assert_eq!(command_of(&name(command.id)), Some(command.id));
        }
        for pane in PaneId::ALL {
            assert_eq!(pane_of(&pane_name(pane)), Some(pane));
        }
        assert_eq!(
            (command_of("zoom"), command_of("nothing")),
            (Some(CommandId::Zoom), None)
        );
    }
}
