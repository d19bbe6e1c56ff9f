//! `seacable import`: the case that a file of another program is, or the system that a case of a line is.

use seacable_base::visible;
use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};

use super::{
    CommandError,
    output::{self, FileFormat, OutputFile},
};
use seacable_foreign::import::ImportOptions;
use seacable_foreign::open::OpenedFile;
use seacable_model::kinds::FileBytes;
use seacable_systems::system::SystemFile;

/// What a file of another program does not say.
#[derive(Debug, Clone, Default, clap::Args)]
pub(super) struct ImportArgs {
    /// Of a file of another program, leave out what is not modelled, by the names that the refusal gives.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    pub(super) without: Vec<String>,

    /// Of a file of another program, the depth of the bed, in m.
    #[arg(long, value_name = "DEPTH", value_parser = positive)]
    pub(super) depth: Option<f64>,

    /// Of a file of another program, the density of the water, in kg/m³.
    #[arg(long, value_name = "DENSITY", value_parser = positive)]
    pub(super) density: Option<f64>,

    /// Of a file of another program, gravity, in m/s².
    #[arg(long, value_name = "GRAVITY", value_parser = positive)]
    pub(super) gravity: Option<f64>,

    /// Of a file of another program, the motion of what it is coupled to: a table of the time and of every coupled coordinate.
    #[arg(long, value_name = "TABLE")]
    pub(super) motion: Option<PathBuf>,
}

impl ImportArgs {
    /// For the reader.
    pub(super) fn options(&self) -> ImportOptions {
        ImportOptions {
            without: self.without.clone(),
            depth: self.depth,
            density: self.density,
            gravity: self.gravity,
            motion: self.motion.clone(),
        }
    }
}

#[derive(Debug, clap::Args)]
pub(super) struct ImportCommandArgs {
    /// The file of another program, or the case of a line.
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,

    /// Write the case to this file; by default it is printed.
    #[arg(short, long = "output", value_name = "CASE.toml")]
    pub(super) output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub(super) force: bool,

    #[command(flatten)]
    pub(super) import: ImportArgs,
}

pub(super) fn import(args: &ImportCommandArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.file.clone()];
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let text = text_of(&args.file, &args.import.options())?;
    match file {
        Some(file) => file.write(text.as_bytes(), FileFormat::Toml)?,
        None => output::document(text.as_bytes(), FileFormat::Toml)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// The case of a file, checked as a case.
fn text_of(path: &Path, options: &ImportOptions) -> Result<String, CommandError> {
    let unreadable =
        |error| CommandError::Usage(format!("Reading {} failed: {error}", visible::path(path)));
    let file = FileBytes::read(path).readable().map_err(unreadable)?;
    let opened =
        OpenedFile::of_bytes::<SystemFile>(file, options).map_err(CommandError::Invalid)?;
    if !opened.is_foreign() {
        let what = format!(
            "{} is not a file of MoorDyn, MoorPy, MAP++ or CableDyn, which have rows of dashes between their tables, nor a design in YAML, nor a case of a line.",
            visible::path(path)
        );
        return Err(CommandError::Usage(what));
    }
    opened.read::<SystemFile>().map_err(CommandError::Invalid)?;
    Ok(opened.text)
}

/// A positive number.
fn positive(word: &str) -> Result<f64, String> {
    match word.parse::<f64>() {
        Ok(value) if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err("give a positive number".to_owned()),
    }
}
