//! An expression as its numbers, names, functions and signs, each with its place.

use std::ops::Range;

use super::vocabulary::{Function, FunctionOfTwo, PI, function, function_of_two};
use crate::decimal::decimal_length;

/// A piece of an expression.
#[derive(Debug, Clone)]
pub(super) struct Token<'t> {
    pub(super) symbol: Symbol<'t>,
    /// Its bytes in the expression.
    pub(super) place: Range<usize>,
}

/// What a piece is.
#[derive(Debug, Clone, Copy)]
pub(super) enum Symbol<'t> {
    Number(f64),
    Name(&'t str),
    /// A function with its opening parenthesis.
    Function(Function),
    /// The same of two values.
    FunctionOfTwo(FunctionOfTwo),
    /// One of `+ - * / ^`.
    Sign(char),
    Comma,
    Open,
    Close,
}

impl Token<'_> {
    /// The name that it is.
    pub(super) fn name(&self) -> Option<String> {
        match self.symbol {
            Symbol::Name(name) => Some(name.to_owned()),
            _ => None,
        }
    }
}

/// The pieces of an expression.
///
/// # Errors
/// The first that is none, and at which character.
pub(super) fn tokens(text: &str) -> Result<Vec<Token<'_>>, String> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(letter) = text[at..].chars().next() {
        if letter.is_whitespace() {
            at += letter.len_utf8();
            continue;
        }
        let (symbol, length) = token(&text[at..]).map_err(|fault| {
            let character = text[..at].chars().count() + 1;
            format!("{fault} (character {character})")
        })?;
        let place = at..at + length;
        at = place.end;
        tokens.push(Token { symbol, place });
    }
    Ok(tokens)
}

/// The piece at the beginning of a text that is not empty, and its length in bytes.
fn token(text: &str) -> Result<(Symbol<'_>, usize), String> {
    let letter = text.chars().next().unwrap_or_default();
    let sign = match letter {
        '(' => Symbol::Open,
        ')' => Symbol::Close,
        ',' => Symbol::Comma,
        '+' | '-' | '*' | '/' | '^' => Symbol::Sign(letter),
        '{' => return in_braces(text),
        _ if letter.is_alphabetic() || letter == '_' => return word(text),
        _ => return number(text).ok_or_else(|| format!("`{letter}` is no part of an expression")),
    };
    Ok((sign, 1))
}

/// A name in braces, which mean nothing.
fn in_braces(text: &str) -> Result<(Symbol<'_>, usize), String> {
    let end = text.find('}').ok_or("`{` is not closed by `}`")?;
    let name = text[1..end].trim();
    match word_length(name) == name.len() && !name.is_empty() {
        true => Ok((named(name), end + 1)),
        false => Err("braces hold a name".to_owned()),
    }
}

/// A name, the constant, or a function with its opening parenthesis.
fn word(text: &str) -> Result<(Symbol<'_>, usize), String> {
    let length = word_length(text);
    let (word, rest) = text.split_at(length);
    let called = function(word).map(Symbol::Function);
    let called = called.or_else(|| function_of_two(word).map(Symbol::FunctionOfTwo));
    let Some(called) = called else {
        return Ok((named(word), length));
    };
    let gap = rest.len() - rest.trim_start().len();
    match rest.trim_start().starts_with('(') {
        true => Ok((called, length + gap + 1)),
        false => Err(format!(
            "`{word}` takes its values in parentheses: {word}(...)"
        )),
    }
}

fn named(word: &str) -> Symbol<'_> {
    match word {
        PI => Symbol::Number(std::f64::consts::PI),
        name => Symbol::Name(name),
    }
}

/// Bytes of the letters, digits and underscores at the beginning of a text.
fn word_length(text: &str) -> usize {
    let end = text.find(|letter: char| !(letter.is_alphanumeric() || letter == '_'));
    end.unwrap_or(text.len())
}

fn number(text: &str) -> Option<(Symbol<'_>, usize)> {
    let length = decimal_length(text)?;
    let value = text[..length].parse().ok()?;
    Some((Symbol::Number(value), length))
}
