//! States in parts: the nodes of a line each, or the joints between lines.

use std::fmt::Debug;
use std::ops::Range;

use super::{Kinematics, State};

/// A state in parts.
pub trait Parted: Clone + Debug + 'static {
    /// Its parts, in an order that stays.
    fn parts(&self) -> impl Iterator<Item = &State>;

    /// The same, to be changed.
    fn parts_mut(&mut self) -> impl Iterator<Item = &mut State>;

    /// Copies another state of the same size without allocating.
    fn copy_from(&mut self, other: &Self);

    /// Copies what a step begins with apart from positions, velocities and accelerations.
    fn copy_history_from(&mut self, other: &Self);

    /// Swaps what is kept to read the waves with another state at places close by.
    fn swap_kept_waves(&mut self, other: &mut Self) {
        for (own, other) in self.parts_mut().zip(other.parts_mut()) {
            std::mem::swap(&mut own.kept_waves, &mut other.kept_waves);
        }
    }
}

/// A line alone is one part.
impl Parted for State {
    fn parts(&self) -> impl Iterator<Item = &State> {
        std::iter::once(self)
    }

    fn parts_mut(&mut self) -> impl Iterator<Item = &mut State> {
        std::iter::once(self)
    }

    fn copy_from(&mut self, other: &Self) {
        Self::copy_from(self, other);
    }

    fn copy_history_from(&mut self, other: &Self) {
        self.memory.copy_from(&other.memory);
    }
}

/// A system whose states come in parts.
pub trait PartedSystem: Sync {
    /// Its states.
    type State: Parted;

    /// The nodes of a part that follow the equation of motion; the others are prescribed, or follow these.
    fn free(&self, part: usize) -> Range<usize>;

    /// Whether a part is a line.
    fn is_line(&self, part: usize) -> bool;

    /// Number of the first node of a part, where all nodes are numbered one after the other.
    fn offset(&self, part: usize) -> usize;

    /// By what lengths the nodes of a part count: 1 for displacements, an arm for a rotation \[m/rad\].
    fn scale(&self, _part: usize, _node: usize) -> f64 {
        1.0
    }
}

impl<S: Kinematics> PartedSystem for S {
    type State = State;

    fn free(&self, _: usize) -> Range<usize> {
        Kinematics::free(self)
    }

    fn is_line(&self, _: usize) -> bool {
        true
    }

    fn offset(&self, _: usize) -> usize {
        0
    }
}
