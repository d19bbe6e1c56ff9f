//! `seacable [CASE|DIR]`: the screen, when there is one.

use std::{path::Path, process::ExitCode};

use super::{
    Failure,
    args::{Args, GlyphWord},
};
use crate::{
    report::chart::Glyphs,
    tui::{self, Options},
};

/// Words that are commands, and may have been meant by a path that is not there.
const COMMANDS: [&str; 7] = [
    "run", "validate", "report", "catenary", "section", "ropeway", "help",
];

pub(super) fn open(args: Args) -> Result<ExitCode, Failure> {
    if let Some(path) = args.path.as_deref().filter(|path| !path.exists()) {
        return Err(Failure::Usage(absent(path)));
    }
    let options = Options {
        path: args.path,
        glyphs: match args.glyphs {
            Some(GlyphWord::Braille) => Some(Glyphs::Braille),
            Some(GlyphWord::Ascii) => Some(Glyphs::Ascii),
            None => args.ascii.then_some(Glyphs::Ascii),
        },
        slow_link: args.slow_link,
    };
    tui::open(&options).map_err(Failure::Screen)?;
    Ok(ExitCode::SUCCESS)
}

fn absent(path: &Path) -> String {
    let shown = path.display().to_string();
    let near = COMMANDS
        .into_iter()
        .min_by_key(|word| distance(word, &shown));
    let meant = near.filter(|word| distance(word, &shown) * 3 <= word.len());
    let tip = meant.map_or_else(String::new, |word| {
        format!(" Was the command `{word}` meant?")
    });
    format!("There is no case file or directory `{shown}`.{tip}")
}

/// Letters to add, drop or change to get from one word to the other (Levenshtein).
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut left = i + 1;
        let mut next = vec![left];
        for (other, pair) in b.iter().zip(row.windows(2)) {
            let (diagonal, above) = match pair {
                [diagonal, above] => (*diagonal, *above),
                _ => (0, 0),
            };
            left = (diagonal + usize::from(letter != *other))
                .min(above + 1)
                .min(left + 1);
            next.push(left);
        }
        row = next;
    }
    row.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistyped_command_is_recognised() {
        assert_eq!(distance("validate", "validat"), 1);
        assert_eq!(distance("run", "urn"), 2);
        assert!(absent(Path::new("valdate")).contains("`validate` meant"));
        assert!(absent(Path::new("reprot")).contains("`report` meant"));
        assert!(!absent(Path::new("manifold.toml")).contains("meant"));
    }
}
