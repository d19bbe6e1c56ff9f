//! What one computation of a system comes to, without companions.

use crate::run::compute::Computed;

/// A computation of a system, without companions.
pub(super) struct ComputedSystem {
    pub(super) computed: Computed,
    pub(super) work: MotionWork,
    /// What happened to the lines, in words.
    pub(super) happened: Vec<String>,
}

/// Work of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MotionWork {
    /// Nodes of all lines.
    pub nodes: usize,
    /// Unknown points, twice the free bodies included.
    pub joints: usize,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Newton iterations.
    pub iterations: u64,
    /// Evaluations of an explicit method.
    pub evaluations: u64,
    /// Time at its end \[s\].
    pub reached: f64,
}
