//! No result that is not finite leaves as one: a run that has one has failed, and says which it is.

use super::{Run, RunState};

/// Takes every result that is not finite out of a run, which has then failed. Errors that are not finite are none.
pub(crate) fn refuse_not_finite(run: &mut Run) {
    let mut wild = run.summary.iter().filter(|q| !q.value.is_finite());
    let failure = wild.next().map(|first| match wild.count() {
        0 => format!("{} is not finite", first.name()),
        more => format!("{} and {more} more results are not finite", first.name()),
    });
    run.summary.retain(|quantity| quantity.value.is_finite());
    for quantity in &mut run.summary {
        let finite = |error: &f64| error.is_finite();
        quantity.time_error = quantity.time_error.filter(finite);
        quantity.mesh_error = quantity.mesh_error.filter(finite);
        quantity.unsettled = quantity
            .unsettled
            .filter(|range| range.iter().all(|end| end.is_finite()));
    }
    if let Some(failure) = failure {
        run.info.state = RunState::Failed;
        run.info.failure.get_or_insert(failure);
    }
}
