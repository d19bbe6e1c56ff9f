//! `seacable export`: the file of another program that a case is.

use seacable_base::visible;
use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};

use super::{
    CommandError, cases,
    import::ImportArgs,
    output::{self, FileFormat, OutputFile},
};
use seacable_foreign::export::{self, ExportOptions, Exported, Target, Unsayable};
use seacable_model::kinds::FileBytes;
use seacable_systems::system::SystemFile;

#[derive(Debug, clap::Args)]
#[command(group = clap::ArgGroup::new("target").required(true).args(["moordyn", "map"]))]
pub(super) struct ExportArgs {
    /// The case of a system or of a line, or the file of another program.
    #[arg(value_name = "CASE")]
    pub(super) file: PathBuf,

    /// Write a file of MoorDyn, version 2.
    #[arg(long)]
    pub(super) moordyn: bool,

    /// Write a file of MAP++.
    #[arg(long)]
    pub(super) map: bool,

    /// Write free points and bodies where they rest, in the place of where the search for that begins.
    #[arg(long)]
    pub(super) at_rest: bool,

    /// Write to this file, and files that it names beside it; by default it is printed.
    #[arg(short, long = "output", value_name = "FILE")]
    pub(super) output: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "output")]
    pub(super) force: bool,

    /// Set a key on top of the case, for example lines.a.segments=40; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) set: Vec<String>,

    #[command(flatten)]
    pub(super) import: ImportArgs,
}

pub(super) fn export(args: &ExportArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.file.clone()];
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let (_, solved) = cases::load_with::<SystemFile>(
        FileBytes::read(&args.file),
        &args.set,
        &args.import.options(),
    )?;
    let target = match args.map {
        true => Target::MapPlusPlus,
        false => Target::MoorDyn,
    };
    let options = ExportOptions {
        at_rest: args.at_rest,
    };
    let made = export::export(&solved, target, options)
        .map_err(|refused| CommandError::Usage(refusal(&args.file, target, &refused)))?;
    for remark in &made.remarks {
        output::message(&format!("note: {remark}"));
    }
    match file {
        Some(file) => {
            write_beside(args, &made)?;
            file.write(made.text.as_bytes(), FileFormat::Text)?;
        }
        None if made.files.is_empty() => output::results(&made.text, false)?,
        None => {
            let names: Vec<&str> = made.files.iter().map(|(name, _)| name.as_str()).collect();
            return Err(CommandError::Usage(format!(
                "The file names others ({}); give --output, beside which they are written.",
                names.join(", ")
            )));
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Writes the files that the file names. All are checked before the first is written.
fn write_beside(args: &ExportArgs, made: &Exported) -> Result<(), CommandError> {
    let output = args.output.as_deref().unwrap_or(Path::new(""));
    let folder = output.parent().unwrap_or(Path::new(""));
    let inputs = [args.file.clone()];
    let names = made.files.iter();
    let paths: Vec<PathBuf> = names.map(|(name, _)| folder.join(name)).collect();
    let mut files = Vec::new();
    for path in &paths {
        files.extend(OutputFile::check(Some(path), args.force, &inputs)?);
    }
    for (file, (_, text)) in files.iter().zip(&made.files) {
        file.write(text.as_bytes(), FileFormat::Text)?;
    }
    Ok(())
}

/// All that the file cannot say.
fn refusal(path: &Path, target: Target, refused: &[Unsayable]) -> String {
    let rows: Vec<String> = refused
        .iter()
        .map(|one| format!("{}: {}: {}", visible::path(path), one.key, one.what))
        .collect();
    format!(
        "{}\nA file of {} would not be the same system; set these keys otherwise with --set, or leave them out.",
        rows.join("\n"),
        target.name()
    )
}
