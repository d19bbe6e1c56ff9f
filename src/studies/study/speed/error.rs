//! How far one run is from another at their common output times.

use crate::case::ChannelQuantity;
use crate::numerics::statistics::rms_and_max;
use crate::run::{History, LineShape, Run, RunState};

/// Errors against a reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolutionErrors {
    /// Root mean square over time of the tension at the worst joint, as a share of its peak \[-\].
    pub tension_rms: f64,
    /// Greatest at any time and joint, likewise \[-\].
    pub tension_max: f64,
    /// Root mean square over all nodes and stored shapes of their distance \[m\].
    pub position_rms: f64,
    /// Greatest of these distances \[m\].
    pub position_max: f64,
}

/// Errors of a run against the reference; nothing where it did not come to its end or has other output times.
#[must_use]
pub(super) fn errors(run: &Run, reference: &Run) -> Option<SolutionErrors> {
    if run.info.state != RunState::Done || run.history.time.len() != reference.history.time.len() {
        return None;
    }
    let (tension_rms, tension_max) = of_tensions(&run.history, &reference.history);
    let (position_rms, position_max) = of_positions(&run.shapes, &reference.shapes);
    Some(SolutionErrors {
        tension_rms,
        tension_max,
        position_rms,
        position_max,
    })
}

fn of_tensions(run: &History, reference: &History) -> (f64, f64) {
    let joints = run.channels.iter().zip(&reference.channels);
    let tensions = joints.filter(|(_, r)| r.id.quantity == ChannelQuantity::Tension);
    let of_joint = tensions.map(|(ours, theirs)| {
        let values = ours.values.iter().zip(&theirs.values);
        let (rms, most) = rms_and_max(values.map(|(a, b)| (a - b).abs()));
        let peak = theirs.peak.0.abs().max(f64::MIN_POSITIVE);
        (rms / peak, most / peak)
    });
    of_joint.fold((0.0, 0.0), |a, b| (a.0.max(b.0), a.1.max(b.1)))
}

fn of_positions(run: &[LineShape], reference: &[LineShape]) -> (f64, f64) {
    let shapes = run.iter().zip(reference);
    let nodes = shapes.flat_map(|(ours, theirs)| ours.nodes.iter().zip(&theirs.nodes));
    rms_and_max(nodes.map(|(a, b)| {
        let squares = a.iter().zip(b).map(|(p, q)| (p - q) * (p - q));
        squares.sum::<f64>().sqrt()
    }))
}
