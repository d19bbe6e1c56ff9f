//! Resuming a stored run: the request to compute, and the checkpoint.

use std::path::Path;

use super::job::Request;
use super::recorder::OutputTimes;
use super::{ResumedRun, RunState, store};
use crate::case::{self, Diagnostic};

/// The request of a stored run, up to its own end or a later one \[s\], and its checkpoint.
///
/// # Errors
/// Why the run cannot be resumed.
pub fn resume_request(dir: &Path, until: Option<f64>) -> Result<(Request, ResumedRun), String> {
    let info = store::read_info(dir).map_err(|e| e.to_string())?;
    if store::is_locked(dir) {
        return Err(format!(
            "{} is still being computed by another program; it can be resumed once that has ended.",
            dir.display()
        ));
    }
    let from = store::resume(dir).map_err(|e| e.to_string())?;
    let mut text = store::case_text(dir).map_err(|e| e.to_string())?;
    let mut overrides = info.overrides;
    let first = |all: &[Diagnostic]| all.first().map(ToString::to_string).unwrap_or_default();
    if let Some(until) = until {
        let value = format!("{until:?}");
        text = case::edit::set(&text, "solver.duration_s", &value)
            .map_err(|d| format!("solver.duration_s {}: {}", d.problem, d.remedy))?;
        overrides.push(format!("solver.duration_s={value}"));
    }
    let case = case::parse(&text, &info.case_file).map_err(|all| first(&all))?;
    if !from.checkpoint.can_be_resumed() {
        return Err(format!(
            "{} was written by version {}, whose checkpoints this version cannot resume; compute the case anew.",
            dir.display(),
            info.version
        ));
    }
    let times = OutputTimes::of(&case);
    if times.interval.to_bits() != from.checkpoint.output_interval_s.to_bits() {
        return Err(format!(
            "The run cannot be resumed to {} s, which is not a whole number of its output intervals of {} s.",
            case.solver.duration_s, case.output.interval_s
        ));
    }
    // A run that was stopped while its errors were estimated has only those left.
    let finished =
        info.state == RunState::Done && case.solver.duration_s <= info.settings.duration_s;
    if finished || case.solver.duration_s < from.checkpoint.time() {
        return Err(format!(
            "The run is at {} s already; name a later time.",
            info.settings.duration_s.max(from.checkpoint.time())
        ));
    }
    let request = Request {
        case,
        text,
        file: info.case_file,
        overrides,
        id: String::new(),
    };
    Ok((request, from))
}
