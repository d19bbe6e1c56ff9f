//! The files: a page of the manual for every command, and completions for shells.

use std::path::PathBuf;

use clap::{Command, CommandFactory};
use clap_complete::{Shell, generate};
use clap_mangen::Man;

use crate::args::Args;

/// By this a file is known to be the program's own.
pub(crate) const MARK: &str = "written by `seacable install-manual`";

/// The shells that look for completions in a folder of the user.
pub(crate) const SHELLS: [Shell; 3] = [Shell::Bash, Shell::Zsh, Shell::Fish];

/// A file that is put in place.
#[derive(Debug, Clone)]
pub(crate) struct ManualFile {
    /// Its name.
    pub(crate) name: String,
    /// Where it goes, below the user's folder for data.
    pub(crate) path: PathBuf,
    pub(crate) text: String,
}

/// All files: pages, and completions of these shells.
pub(crate) fn all(shells: &[Shell]) -> Vec<ManualFile> {
    let mut files = pages();
    files.extend(shells.iter().filter_map(|shell| {
        let path = PathBuf::from(place(*shell)?);
        Some(ManualFile {
            name: path.file_name()?.to_string_lossy().into_owned(),
            text: marked_completion(*shell),
            path,
        })
    }));
    files
}

/// The name of the page of a command: `seacable-study-vary.1`.
pub(crate) fn page(command: &[String]) -> String {
    let words = std::iter::once("seacable").chain(command.iter().map(String::as_str));
    format!("{}.1", words.collect::<Vec<_>>().join("-"))
}

/// The pages of all commands.
pub(crate) fn pages() -> Vec<ManualFile> {
    let mut command = Args::command().disable_help_subcommand(true);
    command.build();
    let mut pages = Vec::new();
    add_pages(&command, "seacable", &mut pages);
    pages
}

fn add_pages(command: &Command, name: &str, pages: &mut Vec<ManualFile>) {
    let file = format!("{name}.1");
    pages.push(ManualFile {
        path: PathBuf::from("man/man1").join(&file),
        text: roff(command, name),
        name: file,
    });
    for sub in command.get_subcommands().filter(|sub| !sub.is_hide_set()) {
        add_pages(sub, &format!("{name}-{}", sub.get_name()), pages);
    }
}

/// A page in the language of `man`.
fn roff(command: &Command, name: &str) -> String {
    let mut text = format!(".\\\" {MARK}\n").into_bytes();
    let man = Man::new(command.clone().display_name(name.to_owned()));
    // Writing into memory does not fail.
    let _ = man.render(&mut text);
    String::from_utf8_lossy(&text).into_owned()
}

/// The completions of a shell.
pub(crate) fn completion(shell: Shell) -> String {
    let mut text = Vec::new();
    generate(shell, &mut Args::command(), "seacable", &mut text);
    String::from_utf8_lossy(&text).into_owned()
}

/// The completions with the mark in a comment: of zsh below the line that names the command.
fn marked_completion(shell: Shell) -> String {
    let text = completion(shell);
    match text.split_once('\n') {
        Some((first, rest)) if first.starts_with("#compdef") => {
            format!("{first}\n# {MARK}\n{rest}")
        }
        _ => format!("# {MARK}\n{text}"),
    }
}

/// Where a shell looks for completions, below the user's folder for data.
pub(crate) const fn place(shell: Shell) -> Option<&'static str> {
    match shell {
        Shell::Bash => Some("bash-completion/completions/seacable"),
        Shell::Fish => Some("fish/vendor_completions.d/seacable.fish"),
        Shell::Zsh => Some("zsh/site-functions/_seacable"),
        _ => None,
    }
}
