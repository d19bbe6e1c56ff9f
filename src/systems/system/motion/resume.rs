//! A stored run of a system to be computed on.

use std::path::Path;

use super::checkpoint::ResumedSystem;
use super::job::{SystemRequest, request};
use crate::case::kind;
use crate::run::store::{self, StoreError};
use crate::run::{check_later, info_of_ended};
use crate::system::SystemFile;

/// The request of a stored run of a system, up to its own end or a later one \[s\], and its checkpoint; none of a run that was stopped
/// before it wrote one, which is computed from its start.
///
/// # Errors
/// Why the run cannot be resumed.
pub fn resume_request(
    dir: &Path,
    until: Option<f64>,
) -> Result<(SystemRequest, Option<ResumedSystem>), String> {
    let info = info_of_ended(dir)?;
    let mut text = store::case_text(dir).map_err(|e| e.to_string())?;
    let from = match read(dir) {
        Err(StoreError::NoCheckpoint(_)) if info.state.was_stopped() => None,
        found => Some(found.map_err(|e| e.to_string())?),
    };
    if let Some(from) = &from {
        check_later(dir, &info, from.checkpoint.time(), until)?;
    }
    let first =
        |all: &[crate::case::Diagnostic]| all.first().map(ToString::to_string).unwrap_or_default();
    let mut overrides = info.overrides.clone();
    if let Some(until) = until {
        let value = format!("{until:?}");
        text = kind::put::<SystemFile>(&text, "solver.duration_s", &value)
            .map_err(|all| first(&all))?;
        overrides.push(format!("solver.duration_s={value}"));
    }
    let solved =
        kind::parse_stored::<SystemFile>(&text, &info.case_file).map_err(|all| first(&all))?;
    let request = request(solved.into(), &text, info.case_file.clone(), overrides);
    let request = request.ok_or("its case.toml has no table `[solver]`")?;
    Ok((request, from))
}

fn read(dir: &Path) -> Result<ResumedSystem, StoreError> {
    let (checkpoint, same_case) = store::sealed_checkpoint(dir)?;
    same_case?;
    let dir = dir.to_owned();
    Ok(ResumedSystem { checkpoint, dir })
}
