//! Resuming a stored run: the request to compute, and the checkpoint.

use crate::visible;
use std::path::Path;

use super::computation::Computation;
use super::job::Request;
use super::store::{self, StoreError};
use super::{Checkpoint, Resumed, RunInfo, RunState};

/// What a stored run says of itself, once nobody computes it.
///
/// # Errors
/// It cannot be read, or another program computes it.
fn info_of_ended(dir: &Path) -> Result<RunInfo, String> {
    let info = store::read_info(dir).map_err(|e| e.to_string())?;
    if store::is_locked(dir) {
        return Err(format!(
            "{} is still being computed by another program; it can be resumed once that has ended.",
            visible::path(dir)
        ));
    }
    Ok(info)
}

/// A request, and the stored run that it goes on from.
type Resuming<C> = (Request<C>, Option<Resumed<<C as Computation>::State>>);

/// The request of a stored run, up to its own end or a later one \[s\], and its checkpoint; none of a run that was stopped before it
/// wrote one, which is computed from its start.
///
/// # Errors
/// Why the run cannot be resumed.
pub fn resume_request<C: Computation>(
    dir: &Path,
    until: Option<f64>,
) -> Result<Resuming<C>, String> {
    let info = info_of_ended(dir)?;
    let mut text = store::case_text(dir).map_err(|e| e.to_string())?;
    let found = match store::sealed_checkpoint::<Checkpoint<C::State>>(dir) {
        // Stopped before its first step, and so begun anew.
        Err(StoreError::NoCheckpoint(_)) if info.state.was_stopped() => None,
        found => Some(found.map_err(|e| e.to_string())?),
    };
    if let Some((checkpoint, _)) = &found {
        check_later(dir, &info, checkpoint.time(), until)?;
    }
    let mut overrides = info.overrides.clone();
    if let Some(until) = until {
        let value = format!("{until:?}");
        text = C::with_key(&text, "solver.duration_s", &value)?;
        overrides.push(format!("solver.duration_s={value}"));
    }
    let case = C::of_stored(&text, &info.case_file)?;
    let from = match found {
        None => None,
        Some((checkpoint, same_case)) => {
            // Which table was changed says more than that the text was.
            let unchanged = case.check_unchanged(&checkpoint);
            unchanged.map_err(|why| format!("{} cannot be resumed: {why}.", visible::path(dir)))?;
            same_case.map_err(|e| e.to_string())?;
            case.check_rows(&checkpoint)?;
            let dir = dir.to_owned();
            Some(Resumed { checkpoint, dir })
        }
    };
    let request = Request {
        case,
        text,
        file: info.case_file.clone(),
        overrides,
        id: String::new(),
    };
    Ok((request, from))
}

/// Checks that a run with a checkpoint at a time \[s\] has anything left to compute up to its end, or the one asked for.
fn check_later(
    dir: &Path,
    info: &RunInfo,
    checkpoint_s: f64,
    until: Option<f64>,
) -> Result<(), String> {
    let end = info.settings.duration_s;
    let until = until.unwrap_or(end);
    // A run that was stopped while its errors were estimated has only those left.
    let is_done = info.state == RunState::Done;
    if !(is_done && until <= end || until < checkpoint_s) {
        return Ok(());
    }
    let (name, at) = (visible::path(dir), checkpoint_s);
    Err(match is_done {
        true => format!(
            "{name} is complete: it is at {end} s already; a later time resumes it, `--until {}s`.",
            2.0 * end
        ),
        false => format!(
            "{name} is at {at} s already, before its end at {end} s; name a later time, or leave out --until to resume it to its end."
        ),
    })
}
