//! Pages worked out behind the screen: runs compared, studies of one result.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::outbox::Outbox;
use crate::chart::Glyphs;
use crate::comparison::Comparison;
use crate::msg::{Msg, RunToCompare};
use crate::report::comparison;
use crate::run::{Run, store};
use crate::state::study_request::StudyRequest;

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

/// Computes a study of the case or system, telling how far it is; nothing where it was stopped.
pub(super) fn study(
    request: &StudyRequest,
    cancel: &AtomicBool,
    out: &Outbox,
) -> Option<Result<String, String>> {
    let page = request.page(cancel, &|progress| {
        out.send(Msg::StudyProgress(progress.done, progress.of));
    });
    (!cancel.load(Ordering::Relaxed)).then_some(page)
}
