//! A line at rest: forces at its ends, and shape and tension anywhere on it.

use super::crossing::Crossings;
use super::profile::{Pieces, ProfilePoint};

/// The form of a line at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CatenaryShape {
    /// Straight and weightless.
    Straight,
    /// Suspended: it touches nothing between its ends.
    Hanging,
    /// Straight up or down under tension.
    Vertical,
    /// The ends above each other, more line than distance: it hangs doubled over.
    HangingDouble,
    /// Grounded from A, then suspended to B.
    PartlyOnBed,
    /// Grounded from end to end.
    WhollyOnBed,
    /// Slack on the bed from A, then vertical to B.
    SlackOnBed,
    /// Suspended from A, grounded, suspended to B.
    TroughOnBed,
    /// Vertical from A, slack on the bed, vertical to B.
    SlackTroughOnBed,
    /// Grounded in several places with suspended bays between.
    ManyOnBed,
}

impl CatenaryShape {
    /// The shape in words.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Straight => "straight",
            Self::Hanging => "hanging",
            Self::Vertical => "vertical",
            Self::HangingDouble => "hanging doubled over",
            Self::PartlyOnBed => "partly on bed",
            Self::WhollyOnBed => "wholly on bed",
            Self::SlackOnBed => "slack on bed",
            Self::TroughOnBed => "U on bed",
            Self::SlackTroughOnBed => "slack U on bed",
            Self::ManyOnBed => "several stretches on bed",
        }
    }

    /// The shape in words for a buoyant line under the surface.
    #[must_use]
    pub fn name_against_surface(self) -> &'static str {
        match self {
            Self::PartlyOnBed => "partly against surface",
            Self::WhollyOnBed => "wholly against surface",
            Self::SlackOnBed => "slack against surface",
            Self::TroughOnBed => "arch against surface",
            Self::SlackTroughOnBed => "slack arch against surface",
            other => other.name(),
        }
    }
}

/// The unknown of a solution, to start a neighbouring line from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum StartingUnknown {
    None,
    Suspended(f64),
    Touchdown(f64),
    GroundedSpan(f64),
}

/// A line at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Horizontal part of the tension at A \[N\], not negative.
    pub h_a_n: f64,
    /// Vertical force of the line on A \[N\]: pulls A up when positive.
    pub v_a_n: f64,
    /// Horizontal part of the tension at B \[N\], not negative.
    pub h_b_n: f64,
    /// Vertical force of the line on B \[N\]: pulls B down when positive.
    pub v_b_n: f64,
    /// Unstretched length resting on the bed, or against the surface \[m\].
    pub on_bed_m: f64,
    /// Its form.
    pub shape: CatenaryShape,
    /// Whether `on_bed_m` rests against the surface above instead.
    pub against_surface: bool,
    /// Evaluations of the line spent on it.
    pub iterations: u32,
    /// Error of force over the larger end tension \[-\]: the residual of the position of B, from the forces by formulas
    /// other than those that found them, times the stiffness.
    pub residual: f64,
    /// Change of (`h_b_n`, `v_b_n`) per metre that B moves along (x, z), A held \[N/m\]:
    /// \[\[h/x, h/z\], \[v/x, v/z\]\]. x counts as positive away from A.
    pub stiffness_n_per_m: [[f64; 2]; 2],
    pub(super) frame: LocalFrame,
    pub(super) pieces: Pieces,
    pub(super) seed: StartingUnknown,
    /// Where it goes through the surface.
    pub(super) crossings: Crossings,
}

/// The local frame in that of the user.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LocalFrame {
    /// 1, or -1 when B lies on the other side of A.
    pub along: f64,
    /// 1, or -1 for a buoyant line solved upside down.
    pub up: f64,
}

impl Solution {
    /// Tension at A \[N\].
    #[must_use]
    pub fn tension_a_n(&self) -> f64 {
        self.h_a_n.hypot(self.v_a_n)
    }

    /// Tension at B \[N\].
    #[must_use]
    pub fn tension_b_n(&self) -> f64 {
        self.h_b_n.hypot(self.v_b_n)
    }

    /// Unstretched length of the whole line \[m\].
    #[must_use]
    pub fn length_m(&self) -> f64 {
        self.pieces
            .slice()
            .last()
            .map_or(0.0, |last| last.from + last.length)
    }

    /// The line at an unstretched arc length from A \[m\], kept within the line; seen from A.
    ///
    /// Slack line is spread evenly over its room on the bed.
    #[must_use]
    pub fn at(&self, arc_m: f64) -> ProfilePoint {
        let pieces = self.pieces.slice();
        let arc_m = arc_m.clamp(0.0, self.length_m());
        let found = pieces
            .iter()
            .find(|piece| arc_m <= piece.from + piece.length)
            .or(pieces.last());
        found.map_or_else(ProfilePoint::default, |piece| {
            self.shown(piece.point(arc_m))
        })
    }

    /// The lowest point of the line.
    #[must_use]
    pub fn lowest(&self) -> ProfilePoint {
        let mut low = self.at(0.0);
        let end = self.at(self.length_m());
        if end.z_m < low.z_m {
            low = end;
        }
        for piece in self.pieces.slice() {
            // An upside-down line is lowest where its mirror image is highest: at ends of pieces.
            let point = if self.frame.up > 0.0 {
                self.shown(piece.lowest())
            } else {
                self.shown(piece.point(piece.from))
            };
            if point.z_m < low.z_m {
                low = point;
            }
        }
        low
    }

    /// The shape in words.
    #[must_use]
    pub fn shape_name(&self) -> &'static str {
        if self.against_surface {
            self.shape.name_against_surface()
        } else {
            self.shape.name()
        }
    }

    /// From the local frame to that of the user.
    fn shown(&self, point: ProfilePoint) -> ProfilePoint {
        ProfilePoint {
            x_m: self.frame.along * point.x_m,
            z_m: self.frame.up * point.z_m,
            ..point
        }
    }
}
