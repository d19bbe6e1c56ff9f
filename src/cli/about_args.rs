//! The arguments of commands about the program itself: keys of the workbench, doctor, manual.

use clap_complete::Shell;

#[derive(Debug, clap::Args)]
pub(super) struct DoctorArgs {
    /// Print one JSON object.
    #[arg(long, conflicts_with = "ascii")]
    pub(super) json: bool,

    /// Print with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct CompletionsArgs {
    /// The shell.
    #[arg(value_name = "SHELL")]
    pub(super) shell: Shell,
}

#[derive(Debug, clap::Args)]
pub(super) struct ManArgs {
    /// The command, such as `run` or `study vary`; without one the page of the program.
    #[arg(value_name = "COMMAND")]
    pub(super) command: Vec<String>,
}

#[derive(Debug, clap::Args)]
pub(super) struct InstallManualArgs {
    /// Completions for this shell, whether it is installed or not: bash, zsh or fish; may be repeated.
    #[arg(long, value_name = "SHELL", conflicts_with = "remove")]
    pub(super) shell: Vec<Shell>,

    /// Replace files that are not of this program too.
    #[arg(long, conflicts_with = "remove")]
    pub(super) force: bool,

    /// Take away what this command has written.
    #[arg(long)]
    pub(super) remove: bool,
}

#[derive(Debug, clap::Args)]
pub(super) struct BindingsArgs {
    /// Only the commands of this table: keys, which holds everywhere, or a pane such as charts.
    #[arg(value_name = "TABLE", conflicts_with = "default")]
    pub(super) table: Option<String>,

    /// Print a whole file of keys: every command with the program's own keys, each line a comment that says what it does.
    #[arg(long)]
    pub(super) default: bool,

    /// Columns of the page; by default those of the terminal, 80 at least.
    #[arg(long, value_name = "N", conflicts_with = "default")]
    pub(super) width: Option<usize>,

    /// Print one JSON object.
    #[arg(long, conflicts_with_all = ["default", "ascii"])]
    pub(super) json: bool,

    /// Print with ASCII characters only.
    #[arg(long)]
    pub(super) ascii: bool,
}
