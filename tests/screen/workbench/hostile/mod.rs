//! Text from outside on the screen: invisible characters are shown as escapes, on every pane, over every pane, in every message.

mod answers;
mod documents;
mod walk;

use seacable::visible::is_invisible;

use super::desk::Desk;

/// A name that steers a terminal (C0, C1, a title by OSC, its end by a bell), reorders its neighbours, ends lines and hides.
const HOSTILE: &str =
    "a\u{1b}]0;x\u{7}\u{1b}[31m\u{9b}2J\u{85}\u{202e}b\u{2066}\u{200f}\u{2028}\u{200b}\u{7f}c";

/// What is seen of its beginning.
const SEEN: &str = "a\\u{1b}]0;x\\u{7}";

/// The text by escapes of TOML, for between quotes.
fn escaped(text: &str) -> String {
    let each = text.chars().map(|c| format!("\\U{:08X}", u32::from(c)));
    each.collect()
}

/// That no cell holds a character that is not seen.
fn check(desk: &Desk, what: &dyn Fn() -> String) {
    let buffer = desk.buffer();
    let symbols = buffer.content.iter().map(ratatui::buffer::Cell::symbol);
    let raw: Vec<&str> = symbols.filter(|s| s.contains(is_invisible)).collect();
    assert!(raw.is_empty(), "{raw:?} in {}", what());
}
