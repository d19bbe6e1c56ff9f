//! Resuming a stored run: the request to compute, and the checkpoint.

use std::path::Path;

use super::job::Request;
use super::{Resume, store};
use crate::case::{self, Diagnostic};
use crate::dynamics::March;

/// The request of a stored run, up to its own end or a later one \[s\], and its checkpoint.
///
/// # Errors
/// Why the run cannot be resumed.
pub fn resume_request(dir: &Path, until: Option<f64>) -> Result<(Request, Resume), String> {
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
    // The time grid must be that of the checkpoint.
    let march = March {
        duration: case.solver.duration_s,
        step: info.settings.time_step_s.max(from.checkpoint.whole_step_s),
        output: case.output.interval_s,
    };
    if !from.checkpoint.fits(&march.grid()) {
        return Err(format!(
            "The run cannot be resumed to {} s, which is not a whole number of its output intervals of {} s.",
            case.solver.duration_s, case.output.interval_s
        ));
    }
    if march.is_over(&from.checkpoint.place) {
        return Err(format!(
            "The run is at {} s already; name a later time.",
            from.checkpoint.place.time
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
