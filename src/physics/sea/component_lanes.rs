//! The components of a sea in fours, and the lattice of anchors that their phasors are kept at.

use std::hash::{DefaultHasher, Hash, Hasher};

use super::Component;
use super::phasors::REACH;
use crate::numerics::processor::{LANES, Lanes};

/// Deeper than this, in wave numbers times depth, the bed is not felt.
const DEEP: f64 = 20.0;

/// A component that is weaker than `exp` of this, 1e-7, of what it is at the surface has no part in a node: below the errors of all steps.
const FAINT: f64 = -16.0;

/// Four components; those that fill up the last four have no amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Four {
    pub(super) omega: Lanes,
    /// Wave number \[1/m\].
    pub(super) k: Lanes,
    /// The least and the greatest of the four.
    least_k: f64,
    pub(super) most_k: f64,
    pub(super) phase: Lanes,
    pub(super) amplitude: Lanes,
    /// `exp(-2 k h)`, 0 where the bed is not felt.
    pub(super) back: Lanes,
    /// `omega / (1 - exp(-2 k h))`.
    pub(super) whole: Lanes,
}

/// The components of a sea in fours, wave numbers rising.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ComponentLanes {
    fours: Vec<Four>,
    /// Distance between two anchors \[m\].
    cell: f64,
    /// A digest of all of it: what was kept of other components is not taken for theirs.
    digest: u64,
}

impl ComponentLanes {
    /// Of components with their wave numbers \[1/m\], in water of this depth \[m\].
    pub(super) fn new(components: &[Component], numbers: &[f64], depth: f64) -> Self {
        let fours = components.chunks(LANES).zip(numbers.chunks(LANES));
        let four = |(components, numbers): (&[Component], &[f64])| {
            let last = components.len() - 1;
            let lanes = |of: &dyn Fn(usize) -> f64| -> Lanes {
                std::array::from_fn(|lane| of(lane.min(last)))
            };
            let kh = |lane: usize| numbers[lane] * depth;
            let is_deep = |lane: usize| kh(lane) > DEEP;
            let mut amplitude = lanes(&|lane| components[lane].amplitude);
            amplitude[components.len()..].fill(0.0);
            Four {
                omega: lanes(&|lane| components[lane].omega),
                k: lanes(&|lane| numbers[lane]),
                least_k: numbers[0],
                most_k: numbers[last],
                phase: lanes(&|lane| components[lane].phase),
                amplitude,
                back: lanes(&|lane| match is_deep(lane) {
                    true => 0.0,
                    false => (-2.0 * kh(lane)).exp(),
                }),
                whole: lanes(&|lane| match is_deep(lane) {
                    true => components[lane].omega,
                    false => components[lane].omega / -(-2.0 * kh(lane)).exp_m1(),
                }),
            }
        };
        let most_k = numbers.last().copied().unwrap_or(1.0);
        let mut digest = DefaultHasher::new();
        depth.to_bits().hash(&mut digest);
        for (c, k) in components.iter().zip(numbers) {
            [c.omega, c.amplitude, c.phase, *k]
                .map(f64::to_bits)
                .hash(&mut digest);
        }
        Self {
            fours: fours.map(four).collect(),
            cell: 2.0 * REACH / most_k,
            digest: digest.finish().max(1),
        }
    }

    /// A number that other components do not share; never 0.
    pub(super) const fn digest(&self) -> u64 {
        self.digest
    }

    /// The fours.
    pub(super) fn fours(&self) -> &[Four] {
        &self.fours
    }

    /// The anchor nearest to a coordinate \[m\]. No round number lies half way between two of them.
    pub(super) fn anchor(&self, x: f64) -> f64 {
        const OFF: f64 = 0.381_966;
        ((x / self.cell + OFF).round() - OFF) * self.cell
    }

    /// How many fours reach down to a height \[m\]; none to one that is no number.
    pub(super) fn reaching(&self, z: f64) -> usize {
        self.fours.partition_point(|four| four.least_k * z >= FAINT)
    }

    /// The highest place in the cell of an anchor \[m\], and a little more.
    pub(super) fn top(&self, anchor: f64) -> f64 {
        anchor + 0.501 * self.cell
    }
}
