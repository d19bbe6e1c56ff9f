//! How deep a text in TOML may nest before it is read.
//!
//! `toml_parser` 1.1 limits the depth of what is nested right (80), but a bracket that closes what is not open takes from its count, so that a
//! text of `[}` over and over ends in an overflow of the stack.

use toml_parser::Source;
use toml_parser::lexer::TokenKind;

/// More than the parser's own limit, whose message is the better one.
const DEEPEST: usize = 100;

/// A text in TOML up to where it nests too deep; there is a fault of its syntax before that place then.
#[must_use]
pub fn shallow(text: &str) -> &str {
    let mut open = Vec::with_capacity(DEEPEST);
    for token in Source::new(text).lex() {
        match token.kind() {
            kind @ (TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket) => {
                if open.len() == DEEPEST {
                    return &text[..token.span().start()];
                }
                open.push(kind);
            }
            TokenKind::RightSquareBracket => {
                open.pop_if(|kind| *kind == TokenKind::LeftSquareBracket);
            }
            TokenKind::RightCurlyBracket => {
                open.pop_if(|kind| *kind == TokenKind::LeftCurlyBracket);
            }
            _ => {}
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_nests_in_order_is_whole() {
        let text = "a = [[1, {b = [2]}]]\n[[c]]\nd = \"[[[\" # [[[\n".repeat(200);
        assert_eq!(shallow(&text), text);
    }

    #[test]
    fn what_nests_too_deep_is_a_fault_and_no_overflow() {
        for unit in ["[", "[}", "{a=[", "[{]", "[{a={]}", "[1 }", "[[]}", "{]a="] {
            let text = format!("a = {}", unit.repeat(50_000));
            assert!(shallow(&text).len() < 2_000, "{unit}");
            assert!(
                toml_edit::Document::parse(shallow(&text)).is_err(),
                "{unit}"
            );
            assert!(
                toml::from_str::<toml::Table>(shallow(&text)).is_err(),
                "{unit}"
            );
        }
    }
}
