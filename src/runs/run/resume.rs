//! Resuming a stored run: the request to compute, and the checkpoint.

use crate::visible;
use std::path::Path;

use super::job::Request;
use super::output_times::OutputTimes;
use super::store::{self, StoreError};
use super::{Checkpoint, ResumedRun, RunInfo, RunState};
use crate::case::{self, Case, Diagnostic, Method};
use crate::kinds::FileType;

/// What a stored run says of itself, once nobody computes it.
///
/// # Errors
/// It cannot be read, or another program computes it.
pub fn info_of_ended(dir: &Path) -> Result<RunInfo, String> {
    let info = store::read_info(dir).map_err(|e| e.to_string())?;
    if store::is_locked(dir) {
        return Err(format!(
            "{} is still being computed by another program; it can be resumed once that has ended.",
            visible::path(dir)
        ));
    }
    Ok(info)
}

/// The request of a stored run, up to its own end or a later one \[s\], and its checkpoint; none of a run that was stopped before it
/// wrote one, which is computed from its start.
///
/// # Errors
/// Why the run cannot be resumed.
pub fn resume_request(
    dir: &Path,
    until: Option<f64>,
) -> Result<(Request, Option<ResumedRun>), String> {
    let info = info_of_ended(dir)?;
    let mut text = store::case_text(dir).map_err(|e| e.to_string())?;
    if FileType::of_text(&text) == FileType::System {
        return Err(format!(
            "{} is a run of a system of lines, which `seacable run --resume` continues.",
            visible::path(dir)
        ));
    }
    let found = match store::sealed_checkpoint::<Checkpoint>(dir) {
        // Stopped before its first step, and so begun anew.
        Err(StoreError::NoCheckpoint(_)) if info.state.was_stopped() => None,
        found => Some(found.map_err(|e| e.to_string())?),
    };
    if let Some((checkpoint, _)) = &found {
        check_later(dir, &info, checkpoint.time(), until)?;
    }
    let mut overrides = info.overrides.clone();
    let first = |all: &[Diagnostic]| all.first().map(ToString::to_string).unwrap_or_default();
    if let Some(until) = until {
        let value = format!("{until:?}");
        text = case::edit::set(&text, "solver.duration_s", &value)
            .map_err(|d| format!("solver.duration_s {}: {}", d.problem, d.remedy))?;
        overrides.push(format!("solver.duration_s={value}"));
    }
    let case = case::parse_stored(&text, &info.case_file).map_err(|all| first(&all))?;
    let from = match found {
        None => None,
        Some((checkpoint, same_case)) => {
            // Which table was changed says more than that the text was.
            check_tables(dir, &case, &checkpoint)?;
            same_case.map_err(|e| e.to_string())?;
            check(&case, &checkpoint)?;
            let dir = dir.to_owned();
            Some(ResumedRun { checkpoint, dir })
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
pub fn check_later(
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

/// Checks that a case can be computed on from a checkpoint of a run of it.
fn check(case: &Case, checkpoint: &Checkpoint) -> Result<(), String> {
    let times = OutputTimes::new(case.solver.duration_s, case.output.interval_s);
    // Older runs have intervals that are rounded otherwise.
    const ROUNDED: f64 = 1e-12;
    if (times.interval / checkpoint.recorded.output_interval_s - 1.0).abs() > ROUNDED {
        return Err(format!(
            "The run cannot be resumed to {} s, which is not a whole number of its output intervals of {} s.",
            case.solver.duration_s, case.output.interval_s
        ));
    }
    Ok(())
}

/// Checks that the tables of the case are those that the checkpoint was written with, by the method that `auto` chose.
fn check_tables(dir: &Path, case: &Case, checkpoint: &Checkpoint) -> Result<(), String> {
    let mut chosen = case.clone();
    if case.solver.method == Method::Auto {
        chosen.solver.method = checkpoint.chosen_method(case).into();
    }
    let checked = checkpoint.check_case(&chosen);
    checked.map_err(|reason| format!("{} cannot be resumed: {reason}.", visible::path(dir)))
}
