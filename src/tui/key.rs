//! Keys as the program words them: `j`, `enter`, `ctrl+r`, `shift+tab`. One spelling for the command
//! table, the footer and the help.

use std::fmt;
use std::str::FromStr;

/// A key press. Modifiers other than Ctrl on letters are left out on purpose: they do not pass
/// every terminal, multiplexer and slow link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum KeyPress {
    /// A printable character.
    Char(char),
    /// Ctrl and a lower-case letter.
    Ctrl(char),
    /// Function key 1 to 12.
    F(u8),
    /// Return.
    Enter,
    /// Escape.
    Esc,
    /// Tabulator.
    Tab,
    /// Shift and tabulator.
    BackTab,
    /// Rub out to the left.
    Backspace,
    /// Rub out under the cursor.
    Delete,
    /// Insert.
    Insert,
    /// Arrow up.
    Up,
    /// Arrow down.
    Down,
    /// Arrow left.
    Left,
    /// Arrow right.
    Right,
    /// Home.
    Home,
    /// End.
    End,
    /// Page up.
    PageUp,
    /// Page down.
    PageDown,
}

/// Names of the keys that are not a character.
const NAMES: [(&str, KeyPress); 16] = [
    ("enter", KeyPress::Enter),
    ("esc", KeyPress::Esc),
    ("tab", KeyPress::Tab),
    ("shift+tab", KeyPress::BackTab),
    ("backspace", KeyPress::Backspace),
    ("del", KeyPress::Delete),
    ("ins", KeyPress::Insert),
    ("up", KeyPress::Up),
    ("down", KeyPress::Down),
    ("left", KeyPress::Left),
    ("right", KeyPress::Right),
    ("home", KeyPress::Home),
    ("end", KeyPress::End),
    ("pgup", KeyPress::PageUp),
    ("pgdn", KeyPress::PageDown),
    ("space", KeyPress::Char(' ')),
];

impl fmt::Display for KeyPress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((name, _)) = NAMES.iter().find(|(_, k)| k == self) {
            return f.write_str(name);
        }
        match self {
            Self::Ctrl(c) => write!(f, "ctrl+{c}"),
            Self::F(n) => write!(f, "f{n}"),
            Self::Char(c) => write!(f, "{c}"),
            _ => Ok(()),
        }
    }
}

/// A key name that says nothing to us.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{0}` is no key; keys are a character, `ctrl+` and a letter, `f1` to `f12`, or a name such as `enter`"
)]
pub struct KeyNameError(pub String);

impl FromStr for KeyPress {
    type Err = KeyNameError;

    fn from_str(text: &str) -> Result<Self, KeyNameError> {
        if let Some((_, key)) = NAMES.iter().find(|(n, _)| *n == text) {
            return Ok(*key);
        }
        let mut chars = text.chars();
        if let (Some(c), None) = (chars.next(), chars.next()) {
            return Ok(Self::Char(c));
        }
        let letter = text.strip_prefix("ctrl+").and_then(|rest| {
            let mut rest = rest.chars();
            match (rest.next(), rest.next()) {
                (Some(c), None) if c.is_ascii_lowercase() => Some(c),
                _ => None,
            }
        });
        if let Some(c) = letter {
            return Ok(Self::Ctrl(c));
        }
        if let Some(n) = text.strip_prefix('f').and_then(|n| n.parse::<u8>().ok())
            && (1..=12).contains(&n)
        {
            return Ok(Self::F(n));
        }
        Err(KeyNameError(text.to_owned()))
    }
}

/// Further names that users give keys.
const ALIASES: [(&str, &str); 12] = [
    ("return", "enter"),
    ("escape", "esc"),
    ("backtab", "shift+tab"),
    ("delete", "del"),
    ("insert", "ins"),
    ("pageup", "pgup"),
    ("page_up", "pgup"),
    ("pagedown", "pgdn"),
    ("page_down", "pgdn"),
    (" ", "space"),
    ("plus", "+"),
    ("minus", "-"),
];

impl KeyPress {
    /// A key as users name it: `F5`, `Ctrl+R`, `PageUp`. The case of a single character counts.
    ///
    /// # Errors
    /// The name is that of no key.
    pub fn of_user(text: &str) -> Result<Self, KeyNameError> {
        if text.chars().count() == 1 && text != " " {
            return text.parse();
        }
        let name = text.to_lowercase().replace("ctrl-", "ctrl+");
        let alias = ALIASES.iter().find(|(alias, _)| *alias == name);
        let name = alias.map_or(name.as_str(), |(_, name)| name);
        name.parse().map_err(|_| KeyNameError(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_reads_back_as_the_key_it_came_from() {
        let mut keys: Vec<KeyPress> = NAMES.iter().map(|(_, k)| *k).collect();
        keys.extend([
            KeyPress::Ctrl('r'),
            KeyPress::F(11),
            KeyPress::Char('?'),
            KeyPress::Char('+'),
            KeyPress::Char('é'),
        ]);
        for key in keys {
            assert_eq!(key.to_string().parse(), Ok(key));
        }
    }

    #[test]
    fn users_may_write_names_in_several_ways() {
        for (text, name) in [
            ("F5", "f5"),
            ("Ctrl+R", "ctrl+r"),
            ("ctrl-r", "ctrl+r"),
            ("PageUp", "pgup"),
            (" ", "space"),
            ("Escape", "esc"),
            ("G", "G"),
        ] {
            assert_eq!(KeyPress::of_user(text).unwrap().to_string(), name);
        }
        assert!(KeyPress::of_user("").is_err() && KeyPress::of_user("Meta+X").is_err());
    }

    #[test]
    fn nonsense_is_refused() {
        for text in ["", "ctrl+", "ctrl+R", "f13", "meta+x", "ab"] {
            assert_eq!(text.parse::<KeyPress>(), Err(KeyNameError(text.to_owned())));
        }
    }
}
