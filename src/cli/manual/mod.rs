//! Manual pages and shell completions, generated from the arguments of the program, and put where shells find them.

pub(super) mod files;
pub(super) mod installed;

use std::process::ExitCode;

use clap::CommandFactory;
use clap_complete::Shell;

use self::files::{completion, page, pages};
use self::installed::Written;
use super::about_args::{CompletionsArgs, InstallManualArgs, ManArgs};
use super::args::Args;
use super::output::{self, FileFormat};
use super::{BAD_RESULT, CommandError};
use seacable_base::visible;

/// `seacable completions SHELL`.
pub(super) fn completions(args: &CompletionsArgs) -> Result<ExitCode, CommandError> {
    output::document(completion(args.shell).as_bytes(), FileFormat::Text)?;
    Ok(ExitCode::SUCCESS)
}

/// `seacable man [COMMAND]`.
pub(super) fn man(args: &ManArgs) -> Result<ExitCode, CommandError> {
    let name = page(&args.command);
    let pages = pages();
    let Some(found) = pages.iter().find(|file| file.name == name) else {
        let mut command = Args::command();
        command.build();
        let known = command.get_subcommands().map(clap::Command::get_name);
        let known = known.collect::<Vec<_>>().join(", ");
        return Err(CommandError::Usage(format!(
            "There is no command `{}`; the commands are {known}.",
            args.command.join(" ")
        )));
    };
    output::document(found.text.as_bytes(), FileFormat::Text)?;
    Ok(ExitCode::SUCCESS)
}

/// `seacable install-manual`.
pub(super) fn install(args: &InstallManualArgs) -> Result<ExitCode, CommandError> {
    let shells = match args.shell.is_empty() {
        true => installed::shells(&installed::is_in_path),
        false => args.shell.clone(),
    };
    if let Some(other) = shells.iter().find(|shell| files::place(**shell).is_none()) {
        return Err(CommandError::Usage(format!(
            "No folder is known in which {other} looks for completions of a user; `seacable completions {other}` prints them."
        )));
    }
    // What is taken away is of every shell, whichever are there now.
    let all = match args.remove {
        true => files::all(&files::SHELLS),
        false => files::all(&shells),
    };
    let home = seacable_base::places::data_home()
        .map_err(|error| CommandError::Usage(error.to_string()))?;
    let mut words = Vec::new();
    let mut kept = 0;
    for file in &all {
        let path = home.join(&file.path);
        let done = match args.remove {
            true => installed::remove(&path),
            false => installed::write(&path, &file.text, args.force),
        };
        let done = done
            .map_err(|error| CommandError::Usage(format!("{}: {error}.", visible::path(&path))))?;
        kept += usize::from(done == Written::Kept);
        words.extend(done.words(&visible::path(&path)));
    }
    words.extend(hints(args, &shells, &home));
    output::results(&format!("{}\n", words.join("\n")), true)?;
    Ok(match kept {
        0 => ExitCode::SUCCESS,
        _ => ExitCode::from(BAD_RESULT),
    })
}

/// What the user may still have to do.
fn hints(args: &InstallManualArgs, shells: &[Shell], home: &std::path::Path) -> Vec<String> {
    if args.remove {
        return Vec::new();
    }
    let shown = visible::path(home);
    let mut hints = vec![format!(
        "`man seacable` finds the pages where MANPATH or the search path leads to {shown}/man."
    )];
    for shell in shells {
        hints.extend(match shell {
            Shell::Bash => Some("bash completes in its next session, where the package bash-completion is installed.".to_owned()),
            Shell::Zsh => Some(format!("zsh completes with `fpath=({shown}/zsh/site-functions $fpath)` before `compinit` in ~/.zshrc.")),
            Shell::Fish => Some("fish completes in its next session.".to_owned()),
            _ => None,
        });
    }
    hints
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_has_a_page_and_every_file_its_mark() {
        let all = files::all(&files::SHELLS);
        assert!(all.iter().all(|file| file.text.contains(files::MARK)));
        let names: Vec<&str> = all.iter().map(|file| file.name.as_str()).collect();
        for name in ["seacable.1", "seacable-run.1", "seacable-study-vary.1"] {
            assert!(names.contains(&name), "{names:?}");
        }
        let run = all
            .iter()
            .find(|file| file.name == "seacable-run.1")
            .unwrap();
        assert!(run.text.contains(".SH") && run.text.contains("resume"));
    }

    #[test]
    fn files_of_others_are_kept_and_own_ones_replaced_and_removed() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("man/man1/seacable.1");
        let text = format!("{} a page\n", files::MARK);
        let write = |force| installed::write(&path, &text, force).unwrap();
        assert_eq!((write(false), write(false)), (Written::New, Written::Same));
        std::fs::write(&path, format!("{} an older page\n", files::MARK)).unwrap();
        assert_eq!(write(false), Written::Replaced);
        std::fs::write(&path, "the user's own page\n").unwrap();
        assert_eq!(
            (write(false), installed::remove(&path).unwrap()),
            (Written::Kept, Written::Kept)
        );
        assert_eq!(write(true), Written::Replaced);
        assert_eq!(installed::remove(&path).unwrap(), Written::Removed);
        assert!(!path.exists());
        assert_eq!(installed::remove(&path).unwrap(), Written::Absent);
    }
}
