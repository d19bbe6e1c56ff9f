//! Events at given times: release of an end or of the payload. The scene is constant between two events.

use crate::case::Case;

/// A change of the scene at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneEvent {
    /// Time \[s\].
    pub time: f64,
    /// What changes.
    pub change: SceneChange,
}

/// What changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SceneChange {
    /// Release of end A (0) or B (1).
    ReleaseEnd(usize),
    /// Release of the payload.
    ReleasePayload,
}

/// The events of a case, the earliest first.
pub(super) fn events(case: &Case) -> Vec<SceneEvent> {
    let ends = [&case.ends.a, &case.ends.b].into_iter().enumerate();
    let mut list: Vec<SceneEvent> = ends
        .filter_map(|(end, of)| {
            let change = SceneChange::ReleaseEnd(end);
            of.release_s.map(|time| SceneEvent { time, change })
        })
        .collect();
    let cut = case.payload.as_ref().and_then(|p| p.release_s);
    list.extend(cut.map(|time| SceneEvent {
        time,
        change: SceneChange::ReleasePayload,
    }));
    list.sort_by(|a, b| a.time.total_cmp(&b.time));
    list
}
