//! The process of a job. Not for people: `seacable jobs` is.

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use signal_hook::flag;

use super::CommandError;
use seacable_jobs::process;

#[derive(Debug, clap::Args)]
pub(super) struct JobArgs {
    /// The folder of the job.
    #[arg(value_name = "FOLDER")]
    pub(super) folder: PathBuf,
}

pub(super) fn job(args: &JobArgs) -> Result<ExitCode, CommandError> {
    process::leave_session();
    let cancel = listen();
    let cancel = cancel
        .map_err(|error| CommandError::Usage(format!("Signals cannot be caught: {error}")))?;
    process::compute(&args.folder, &cancel).map_err(CommandError::Usage)?;
    Ok(ExitCode::SUCCESS)
}

/// SIGTERM and SIGINT stop a job with a checkpoint; that a terminal goes away is nothing to it.
fn listen() -> io::Result<Arc<AtomicBool>> {
    let cancel = Arc::new(AtomicBool::new(false));
    for signal in [SIGTERM, SIGINT] {
        flag::register(signal, Arc::clone(&cancel))?;
    }
    flag::register(SIGHUP, Arc::default())?;
    Ok(cancel)
}
