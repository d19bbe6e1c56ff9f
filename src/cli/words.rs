//! The words of the command line before they are parsed.

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::process::ExitCode;

use clap::{CommandFactory, error::ErrorKind};

use super::{BAD_INPUT, args::Args, output};
use seacable_base::visible;

/// Whether this is an option of every command; each takes a value.
fn is_global(name: &str) -> bool {
    name == "--root" || name.starts_with("--limit-")
}

/// The words with the command before the options that every command takes, so that these may also stand before it.
pub(super) fn command_first(mut words: Vec<OsString>) -> Vec<OsString> {
    let mut at = 1;
    while let Some(word) = words.get(at).and_then(|word| word.to_str()) {
        let (name, value) = word
            .split_once('=')
            .map_or((word, None), |(n, v)| (n, Some(v)));
        if !is_global(name) {
            break;
        }
        at += if value.is_some() { 1 } else { 2 };
    }
    let is_command = |word: &OsString| {
        let known = Args::command();
        known
            .get_subcommands()
            .any(|command| command.get_name() == word)
    };
    if at > 1 && words.get(at).is_some_and(is_command) {
        words[1..=at].rotate_right(1);
    }
    words
}

/// Reports the words that are not text where text is needed, which the parser does not name.
pub(super) fn no_text(words: &[OsString], error: &clap::Error) -> Option<ExitCode> {
    if error.kind() != ErrorKind::InvalidUtf8 {
        return None;
    }
    let mut before: &OsStr = OsStr::new("");
    let mut shown = Vec::new();
    for word in words.iter().skip(1) {
        if word.to_str().is_none() {
            let option = match before.to_str() {
                Some(option) if option.starts_with('-') => format!("{option} "),
                _ => String::new(),
            };
            shown.push(format!("`{option}{}`", visible::path(Path::new(word))));
        }
        before = word;
    }
    let said = format!("error: not text in UTF-8: {}.", shown.join(", "));
    output::message(&said);
    Some(ExitCode::from(BAD_INPUT))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_of_every_command_may_stand_before_it() {
        let ordered = |words: &str| {
            let words = words.split(' ').map(OsString::from).collect();
            let ordered = command_first(words);
            ordered.join(OsStr::new(" ")).into_string().unwrap()
        };
        for (given, wanted) in [
            ("p --root d run c", "p run --root d c"),
            (
                "p --root=d --limit-steps 5 run c",
                "p run --root=d --limit-steps 5 c",
            ),
            ("p --root run", "p --root run"),
            ("p --root d case.toml", "p --root d case.toml"),
            ("p run c --root d", "p run c --root d"),
        ] {
            assert_eq!(ordered(given), wanted);
        }
    }
}
