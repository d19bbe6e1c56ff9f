//! Keys that edit a line of text.

use tui_input::{Input, InputRequest};

use crate::key::KeyPress;

/// Edits the line; false when the key is no editing key.
pub(super) fn type_key(input: &mut Input, key: KeyPress) -> bool {
    let request = match key {
        KeyPress::Char(c) => InputRequest::InsertChar(c),
        KeyPress::Backspace => InputRequest::DeletePrevChar,
        KeyPress::Delete => InputRequest::DeleteNextChar,
        KeyPress::Left => InputRequest::GoToPrevChar,
        KeyPress::Right => InputRequest::GoToNextChar,
        KeyPress::Home => InputRequest::GoToStart,
        KeyPress::End | KeyPress::Ctrl('e') => InputRequest::GoToEnd,
        KeyPress::Ctrl('u') => InputRequest::DeleteLine,
        KeyPress::Ctrl('w') => InputRequest::DeletePrevWord,
        KeyPress::Ctrl('k') => InputRequest::DeleteTillEnd,
        _ => return false,
    };
    input.handle(request);
    true
}

/// Inserts pasted text; line ends and tabulators become spaces, other control characters go.
pub(super) fn type_text(input: &mut Input, text: &str) {
    for c in text.trim_end_matches(['\r', '\n']).chars() {
        let c = if matches!(c, '\r' | '\n' | '\t') {
            ' '
        } else {
            c
        };
        if !c.is_control() {
            input.handle(InputRequest::InsertChar(c));
        }
    }
}
