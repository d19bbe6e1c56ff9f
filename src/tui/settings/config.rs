//! The look of the screen as the user sets it in `config.toml`.

use crate::case::{Diagnostic, Finding, TomlNode, diagnose, nearest, tree_of};
use crate::chart::Glyphs;
use crate::theme::Palette;

/// The look of the screen; what is absent is decided by the program.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Config {
    /// Colours.
    pub palette: Option<Palette>,
    /// Characters of charts and frames.
    pub glyphs: Option<Glyphs>,
    /// Whether the last screen stays in the shell when the program ends.
    pub keep_screen: bool,
}

/// The keys of the file.
const KEYS: [&str; 3] = ["theme", "glyphs", "keep_screen"];

/// Reads the text of a file of this name; what is wrong sets nothing.
#[must_use]
pub fn read(text: &str, file: &str) -> (Config, Vec<Diagnostic>) {
    let mut config = Config::default();
    let found = match tree_of(text) {
        Err(faults) => faults,
        Ok(tree) => {
            let faults = tree.entries().iter().filter_map(|entry| {
                let set = set(&mut config, &entry.key, &entry.node);
                let (on_key, problem, remedy) = set.err()?;
                let span = if on_key {
                    &entry.key_span
                } else {
                    &entry.node.span
                };
                Some(Finding::new(span, &entry.key, problem, remedy))
            });
            faults.collect()
        }
    };
    (config, diagnose(found, text, file))
}

/// What is wrong: with the key or with its value, and what would be right.
type SettingFault = (bool, String, String);

fn set(config: &mut Config, key: &str, value: &TomlNode) -> Result<(), SettingFault> {
    match key {
        "theme" => config.palette = Some(word(value, &Palette::NAMES)?),
        "glyphs" => {
            let names = [("braille", Glyphs::Braille), ("ascii", Glyphs::Ascii)];
            config.glyphs = Some(word(value, &names)?);
        }
        "keep_screen" => {
            config.keep_screen = value.boolean().ok_or_else(|| {
                let problem = format!("is {}", value.describe());
                (false, problem, "give true or false".to_owned())
            })?;
        }
        _ => {
            let remedy = match nearest(key, KEYS) {
                Some(meant) => format!("write `{meant}`"),
                None => format!("the settings are {}", KEYS.join(", ")),
            };
            return Err((true, "is no setting".to_owned(), remedy));
        }
    }
    Ok(())
}

/// One of several words.
fn word<T: Copy>(value: &TomlNode, names: &[(&str, T)]) -> Result<T, SettingFault> {
    let given = value.text();
    let found = names.iter().find(|(name, _)| Some(*name) == given);
    found.map(|(_, meant)| *meant).ok_or_else(|| {
        let problem = match given {
            Some(word) => format!("is `{word}`"),
            None => format!("is {}", value.describe()),
        };
        let words: Vec<String> = names.iter().map(|(name, _)| format!("{name:?}")).collect();
        (false, problem, format!("give {}", words.join(" or ")))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_set_is_read_and_what_is_wrong_is_reported() {
        let text = "theme = \"light\"\nglyphs = \"ascii\"\nkeep_screen = true\n";
        let (config, faults) = read(text, "config.toml");
        assert!(faults.is_empty(), "{faults:?}");
        assert_eq!(config.palette, Some(Palette::Light));
        assert_eq!(
            (config.glyphs, config.keep_screen),
            (Some(Glyphs::Ascii), true)
        );

        let text = "theme = \"bright\"\ntehme = \"dark\"\nkeep_screen = \"yes\"\n";
        let (config, faults) = read(text, "config.toml");
        assert_eq!(config, Config::default());
        let words: Vec<String> = faults.iter().map(ToString::to_string).collect();
        assert_eq!(
            words,
            [
                "config.toml:1:9: theme: is `bright`; give \"dark\" or \"light\" or \"mono\"",
                "config.toml:2:1: tehme: is no setting; write `theme`",
                "config.toml:3:15: keep_screen: is text; give true or false",
            ]
        );
    }
}
