//! A solution before its verification counts.
//!
//! Nothing is returned before the forces, put back into the formulas of `span` with 30 digits, have led to end B. The
//! position residual is turned into force by the line's own stiffness: metres say nothing about a stiff line. A Newton
//! step with that residual corrects the rounding; a residual above [`ACCEPTED`] afterwards is an error.

use super::crossing::Crossings;
use super::error::CatenaryError;
use super::profile::Pieces;
use super::solution::{CatenaryShape, LocalFrame, Solution, StartingUnknown};

/// Greatest error of force, over the end tension, that is accepted.
pub(super) const ACCEPTED: f64 = 1e-7;
/// Errors below this are rounding.
pub(super) const ROUNDING: f64 = 1e-13;

/// Forces and their derivatives in the solver's plane.
pub(super) struct Candidate {
    /// (H, V) at A and at B.
    pub ends: [(f64, f64); 2],
    pub on_bed: f64,
    pub shape: CatenaryShape,
    pub iterations: u32,
    pub residual: f64,
    pub stiffness: [[f64; 2]; 2],
    pub seed: StartingUnknown,
}

impl Candidate {
    /// The solution in the user's frame.
    ///
    /// # Errors
    /// [`CatenaryError::NotVerified`] where the residual is too great or a force is not finite.
    pub(super) fn verified(
        &self,
        frame: LocalFrame,
        pieces: Pieces,
    ) -> Result<Solution, CatenaryError> {
        let up = frame.up;
        let [(h_a, v_a), (h_b, v_b)] = self.ends;
        let finite = h_a.is_finite() && v_a.is_finite() && h_b.is_finite() && v_b.is_finite();
        if !(finite && self.residual <= ACCEPTED) {
            return Err(CatenaryError::NotVerified {
                error: self.residual,
                iterations: self.iterations,
            });
        }
        let [[xx, xz], [zx, zz]] = self.stiffness;
        Ok(Solution {
            h_a_n: h_a,
            v_a_n: up * v_a,
            h_b_n: h_b,
            v_b_n: up * v_b,
            on_bed_m: self.on_bed,
            shape: self.shape,
            against_surface: up < 0.0 && self.on_bed > 0.0,
            iterations: self.iterations,
            residual: self.residual,
            stiffness_n_per_m: [[xx, up * xz], [up * zx, zz]],
            frame,
            pieces,
            seed: self.seed,
            crossings: Crossings::new(),
        })
    }
}
