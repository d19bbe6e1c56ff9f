//! The method of a run in time whose file leaves the choice to the program, as for a line: see [`outlook`](crate::run::outlook).

use std::sync::atomic::AtomicBool;

use super::checkpoint::ResumedSystem;
use super::motion_plan::MotionPlan;
use super::start::Start;
use super::system_bounds::bounds;
use super::system_under_way::compute;
use crate::case::{Method, Solver};
use crate::run::Work;
use crate::run::lines_along::LinesAlong;
use crate::run::outlook::{Cheaper, TRIAL, method_by};

/// The inputs with the method that the program chooses, and why; nothing where the file names one. A run that is resumed keeps its
/// method.
pub(super) fn chosen(
    given: &Solver,
    begun: &Start,
    from: Option<&ResumedSystem>,
    cancel: &AtomicBool,
) -> Option<(Solver, String)> {
    if given.method != Method::Auto {
        return None;
    }
    let by = |method| Solver {
        method,
        ..given.clone()
    };
    if let Some(from) = from.filter(|from| from.checkpoint.place.steps > 0) {
        let begun_with = match from.checkpoint.method.work_counts.evaluations {
            0 => Cheaper::Alpha,
            _ => Cheaper::Rk4,
        };
        return Some((by(begun_with.into()), begun_with.as_begun()));
    }
    let outlook = bounds(&begun.system).outlook(given);
    let (method, why) = method_by(outlook, || trial(&by(Method::Alpha), begun, cancel));
    Some((by(method), why))
}

/// Work of generalized-alpha over a part of the duration.
fn trial(given: &Solver, begun: &Start, cancel: &AtomicBool) -> Work {
    let duration_s = TRIAL * given.duration_s;
    let given = Solver {
        duration_s,
        ..given.clone()
    };
    let begun = Start {
        along: LinesAlong::default(),
        ..begun.clone()
    };
    let plan = MotionPlan::new(&given, duration_s, &begun.system);
    let tried = compute(begun, &plan, None, cancel, None);
    tried.outcome.work
}
