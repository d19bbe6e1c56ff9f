//! A coarse answer ahead of the full one: the case on a coarser mesh with longer steps, without error estimates.

use std::sync::atomic::{AtomicBool, Ordering};

use super::compute::{Computed, Resolution, compute};
use super::job::{Request, assemble};
use super::{Run, RunState, error_estimate};
use crate::case::{Case, Method};

/// Segments and steps are so many times as long. The second is for cases that the first does not get through; together they take
/// a twentieth of a run with its companions.
const COARSE: [usize; 2] = [4, 2];

/// Computes a request coarsely; nothing where that fails or is cancelled. There is no trial for its method and no search for its
/// accuracy. The run is for the eye: it is no run of the case, to be stored or compared.
#[must_use]
pub fn coarse(request: &Request, cancel: &AtomicBool) -> Option<Run> {
    let mut request = request.clone();
    let solver = &mut request.case.solver;
    if solver.method == Method::Auto {
        solver.method = Method::Alpha;
    }
    if solver.method == Method::Rk4 {
        // Explicit steps are as long as the coarse mesh permits.
        solver.time_step_s = None;
    }
    let attempts = COARSE.map(|ratio| resolution(&request.case, ratio));
    let computed = attempts
        .into_iter()
        .map(|resolution| compute(&request.case, resolution, None, cancel, None))
        .take_while(|_| !cancel.load(Ordering::Relaxed))
        .find(is_done)?;
    let summary = error_estimate::without_errors(&computed).summary;
    Some(assemble(&request, computed, String::new(), summary))
}

fn resolution(case: &Case, ratio: usize) -> Resolution {
    let explicit = case.solver.method == Method::Rk4;
    Resolution {
        coarsening: ratio,
        step_ratio: if explicit { 1.0 } else { ratio as f64 },
    }
}

fn is_done(computed: &Computed) -> bool {
    computed.outcome.state == RunState::Done
}
