//! `seacable audit`: a second opinion on a file of another program.

use seacable_base::visible;
use std::{path::PathBuf, process::ExitCode};

use super::{
    CommandError,
    import::ImportArgs,
    output::{self, FileFormat, OutputFile},
};
use seacable_base::files;
use seacable_foreign::audit;
use seacable_foreign::import;
use seacable_report::audit as page;

#[derive(Debug, clap::Args)]
pub(super) struct AuditArgs {
    /// The file of another program.
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,

    /// Write the findings as a table to this file.
    #[arg(long, value_name = "FINDINGS.csv")]
    pub(super) csv: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "csv")]
    pub(super) force: bool,

    /// Restrict the page to ASCII.
    #[arg(long)]
    pub(super) ascii: bool,

    #[command(flatten)]
    pub(super) import: ImportArgs,
}

pub(super) fn audit(args: &AuditArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.file.clone()];
    let file = OutputFile::check_option("--csv", args.csv.as_deref(), args.force, &inputs)?;
    let text = files::read::text_lossy(&args.file).map_err(|error| {
        CommandError::Usage(format!(
            "Reading {} failed: {error}",
            visible::path(&args.file)
        ))
    })?;
    if !import::is_foreign_file(&args.file, &text) {
        let what = format!(
            "{} is not a file of MoorDyn, MoorPy, MAP++ or CableDyn, and no design in YAML.",
            visible::path(&args.file)
        );
        return Err(CommandError::Usage(what));
    }
    let name = args.file.display().to_string();
    let audit = audit::audit(&text, &name, &args.import.options());
    let audit = audit.map_err(CommandError::Invalid)?;
    if let Some(file) = file {
        let mut rows = Vec::new();
        page::findings(&audit)
            .write_csv(&mut rows)
            .map_err(|error| {
                CommandError::Usage(format!("The findings were not written: {error}"))
            })?;
        file.write(&rows, FileFormat::Text)?;
    }
    output::results(&page::page(&audit), args.ascii)?;
    Ok(ExitCode::SUCCESS)
}
