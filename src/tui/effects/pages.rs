//! Pages worked out behind the screen: runs compared, the effect of every input on a result, what a scene needs.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::outbox::Outbox;
use crate::case::Case;
use crate::chart::Glyphs;
use crate::comparison::Comparison;
use crate::msg::{Msg, RunToCompare, StudyRequest};
use crate::number::duration;
use crate::report::effects::TornadoView;
use crate::report::{comparison, physics};
use crate::run::{Run, store};
use crate::state::study_of::StudyOf;
use crate::study::points::PointProgress;
use crate::study::{effects, physics as scene_physics};

/// Reads the runs that are not in memory, and compares all with the first.
pub(super) fn compare(
    runs: Vec<RunToCompare>,
    width: usize,
    glyphs: Glyphs,
) -> Result<String, String> {
    let read = |run: RunToCompare| match run {
        RunToCompare::Memory(run) => Ok(run),
        RunToCompare::Stored(dir) => store::read(&dir).map(Arc::new).map_err(|e| e.to_string()),
    };
    let runs: Vec<Arc<Run>> = runs.into_iter().map(read).collect::<Result<_, _>>()?;
    let all: Vec<&Run> = runs.iter().map(Arc::as_ref).collect();
    let page = comparison::report(&Comparison::of_runs(&all), &all, width);
    Ok(page.to_text(width, glyphs))
}

/// Computes a study of the case, telling how far it is; nothing where it was stopped.
pub(super) fn study(
    request: &StudyRequest,
    cancel: &AtomicBool,
    out: &Outbox,
) -> Option<Result<String, String>> {
    let tell = |progress: PointProgress<'_>| {
        out.send(Msg::StudyProgress(progress.done, progress.of));
    };
    let page = match request.of {
        StudyOf::Inputs => input_effects(request, cancel, &tell),
        StudyOf::Physics => {
            let found = scene_physics::compute::<Case>(&request.base, cancel, &tell);
            found.map(|found| {
                physics::table(&found, std::slice::from_ref(&request.result)).to_text(request.width)
            })
        }
    };
    (!cancel.load(std::sync::atomic::Ordering::Relaxed)).then_some(page)
}

fn input_effects(
    request: &StudyRequest,
    cancel: &AtomicBool,
    tell: &(dyn Fn(PointProgress<'_>) + Sync),
) -> Result<String, String> {
    let found = effects::compute::<Case>(&request.base, cancel, tell)?;
    let Some(view) = TornadoView::of_result(&found, &request.result) else {
        return Err(format!(
            "The run of the case does not have `{}`.",
            request.result
        ));
    };
    let (chart, table) = (view.chart(request.width), view.table());
    Ok(format!(
        "{}\n{}\nCost: {} of CPU time.\n",
        chart.to_text(request.width),
        table.to_text(request.width),
        duration(found.cpu_s())
    ))
}
