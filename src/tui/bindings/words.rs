//! Keys in messages: `` `:undo` `` in a text stands for the key that undoes in the pane with the focus.

use std::borrow::Cow;

use super::names::name;
use super::{KeyTable, registry};
use crate::pane::PaneId;

/// What a name of a command begins with in a text.
const MARK: &str = "`:";

impl KeyTable {
    /// A text with the names of commands replaced by their keys in a pane. A command without a key stays as it is typed on the
    /// command line: `` `:undo` ``.
    #[must_use]
    pub fn worded<'a>(&self, pane: PaneId, text: &'a str) -> Cow<'a, str> {
        if !text.contains(MARK) {
            return Cow::Borrowed(text);
        }
        let mut rest = text;
        let mut words = String::with_capacity(text.len());
        while let Some((before, after)) = rest.split_once(MARK) {
            words.push_str(before);
            let key = after.split_once('`').and_then(|(word, behind)| {
                let key = self.key_of(pane, word)?;
                Some((key, behind))
            });
            match key {
                Some((key, behind)) => {
                    words.push('`');
                    words.push_str(&key);
                    words.push('`');
                    rest = behind;
                }
                None => {
                    words.push_str(MARK);
                    rest = after;
                }
            }
        }
        words.push_str(rest);
        Cow::Owned(words)
    }

    /// The first key of a command in a pane; of one that is not of this pane its key elsewhere.
    #[must_use]
    pub fn key_of(&self, pane: PaneId, word: &str) -> Option<String> {
        let here = registry::together(pane).into_iter();
        let elsewhere = registry::declared().into_iter().map(|(_, command)| command);
        let mut all = here.chain(elsewhere);
        let command = all.find(|command| name(command.id) == word)?;
        self.keys_of(pane, &command).first().map(str::to_owned)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Scope;
    use super::*;
    use crate::command::CommandId;

    #[test]
    fn names_in_a_text_become_the_keys_of_the_user() {
        let mut table = KeyTable::default();
        let text = "The edits are back. `:undo` undoes them; `:` finds `:run` and `:glyphs`.";
        let said = |table: &KeyTable| table.worded(PaneId::Inputs, text).into_owned();
        assert_eq!(
            said(&table),
            "The edits are back. `u` undoes them; `:` finds `R` and `:glyphs`."
        );
        table.bind(
            Scope::Everywhere,
            CommandId::Undo,
            vec!["ctrl+u".to_owned()],
        );
        assert!(said(&table).contains("`ctrl+u` undoes them"));
        assert_eq!(table.worded(PaneId::Inputs, "a `:"), "a `:");
    }
}
