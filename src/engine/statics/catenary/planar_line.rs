//! A line of one section in the local frame: A at the origin, B to the right, the weight pulling down.

use super::error::CatenaryError;
use super::line::RigidBed;
use super::profile::{PieceLaw, ProfilePiece};
use super::solution::LocalFrame;
use super::span::Span;

/// A line of one section in the local frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlanarLine {
    pub x: f64,
    pub z: f64,
    pub length: f64,
    pub w: f64,
    pub ea: f64,
    pub bed: Option<RigidBed>,
    pub frame: LocalFrame,
}

impl PlanarLine {
    /// Part of the line, of this unstretched length.
    pub(super) fn span(&self, length: f64) -> Span {
        Span {
            length,
            weight: self.w,
            ea: self.ea,
        }
    }

    /// A suspended piece that begins at an arc length and a position, with the force (`h`, `va`) there.
    pub(super) fn suspended_piece(
        &self,
        from: f64,
        length: f64,
        at: (f64, f64),
        h: f64,
        va: f64,
    ) -> ProfilePiece {
        ProfilePiece {
            from,
            length,
            x: at.0,
            z: at.1,
            kind: PieceLaw::Suspended {
                h,
                va,
                w: self.w,
                ea: self.ea,
            },
        }
    }
}

/// Ends closer to the bed than this part of the line's size count as on it.
pub(super) const ON_BED: f64 = 1e-12;

/// Both ends must be on the bed or above.
pub(super) fn ends_above(bed: &RigidBed, x: f64, z: f64, length: f64) -> Result<(), CatenaryError> {
    let rise = x.abs() * bed.slope_rad.tan();
    let slip = ON_BED * (length + z.abs() + rise.abs());
    for (end, height) in [('A', bed.below_a_m), ('B', bed.below_a_m + z - rise)] {
        if height < -slip {
            return Err(CatenaryError::EndBelowBed {
                end,
                below_m: -height,
            });
        }
    }
    Ok(())
}
