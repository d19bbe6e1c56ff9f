//! `seacable [CASE|DIR]`: the screen, when there is one.

use seacable_base::visible;
use std::{path::Path, process::ExitCode};

use clap::CommandFactory;
use strsim::levenshtein;

use super::{CommandError, args::Args};
use seacable_display::chart::Glyphs;
use seacable_tui::{self as tui, WorkbenchOptions};

pub(crate) fn open(args: Args) -> Result<ExitCode, CommandError> {
    if let Some(path) = args.path.as_deref().filter(|path| !path.exists()) {
        return Err(CommandError::Usage(absent(path)));
    }
    let options = WorkbenchOptions {
        path: args.path,
        glyphs: args.glyphs.or(args.ascii.then_some(Glyphs::Ascii)),
        slow_link: args.slow_link,
        fresh: args.fresh,
        tutorial: args.tutorial,
        keep_screen: args.keep_screen,
        in_process: args.in_process,
    };
    tui::open(&options).map_err(CommandError::Screen)?;
    Ok(ExitCode::SUCCESS)
}

fn absent(path: &Path) -> String {
    let shown = visible::path(path);
    let commands = Args::command();
    let words = commands.get_subcommands().map(clap::Command::get_name);
    let near = words
        .filter(|word| shown.len() < 2 * word.len())
        .min_by_key(|word| levenshtein(word, &shown));
    let meant = near.filter(|word| levenshtein(word, &shown) * 3 <= word.len());
    let tip = meant.map_or_else(String::new, |word| {
        format!(" Was the command `{word}` meant?")
    });
    format!("There is no case file or directory `{shown}`.{tip}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mistyped_command_is_recognised() {
        assert!(absent(Path::new("valdate")).contains("`validate` meant"));
        assert!(absent(Path::new("reprot")).contains("`report` meant"));
        assert!(!absent(Path::new("manifold.toml")).contains("meant"));
    }
}
