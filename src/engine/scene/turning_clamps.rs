//! Clamps that turn with what holds them, and the moment by which they act on it.
//!
//! The bend between the direction d of a clamp and the unit tangent t of the chord beside it has the energy `E = k (1 - d.t)`. A body that
//! turns by `dq` turns d by `dq x d`: d moves like a place of the body at the arm d, on which the force `k t` acts, and the moment on the
//! body is `k d x t`.

use super::Scene;
use crate::numerics::{M3, V3};
use crate::solve::State;

/// How a clamp acts on its direction d.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClampLoad {
    /// The direction, from A to B.
    pub direction: V3,
    /// Derivative of the energy by it, `-k t` \[N m\].
    pub residual: V3,
    /// Derivative of the residual of the second node of the chord by it, `-k (I - t t') / l` \[N\]; that of the first is opposite.
    pub coupling: M3,
}

impl ClampLoad {
    /// Moment on what holds the clamp \[N m\].
    #[must_use]
    pub fn moment(&self) -> V3 {
        -self.direction.cross(&self.residual)
    }
}

impl Scene {
    /// How the clamp at end A (0) or B (1) acts on its direction; nothing at a hinge.
    #[must_use]
    pub fn clamp_load(&self, end: usize, state: &State) -> Option<ClampLoad> {
        let flexure = self.elements.flexure.as_ref()?;
        let (direction, k) = flexure.clamp(end, state)?;
        let chord = self.line.chord(end * (self.line.segments.len() - 1), state);
        let t = &chord.tangent;
        let along = t * t.transpose();
        Some(ClampLoad {
            direction,
            residual: t * -k,
            coupling: (along - M3::identity()) * (k * chord.inverse),
        })
    }

    /// Whether end A (0) or B (1) is clamped.
    #[must_use]
    pub fn is_clamped(&self, end: usize) -> bool {
        let flexure = self.elements.flexure.as_ref();
        flexure.is_some_and(|flexure| flexure.clamps[end].is_some())
    }

    /// Turns the clamps at ends A and B into these directions, from A to B, where they are given; a hinge stays one.
    pub fn turn_clamps(&mut self, directions: &[Option<V3>; 2]) {
        let Some(flexure) = &mut self.elements.flexure else {
            return;
        };
        for (clamp, given) in flexure.clamps.iter_mut().zip(directions) {
            if let (Some((direction, _)), Some(given)) = (clamp, given) {
                *direction = *given;
            }
        }
    }

    /// Makes a hinge of a clamp at end A (0) or B (1).
    pub fn unclamp(&mut self, end: usize) {
        if let Some(flexure) = &mut self.elements.flexure {
            flexure.clamps[end] = None;
        }
    }
}
