//! A line at rest: forces at its ends, and shape and tension anywhere on it.

use super::span::{Span, length};

/// What a line looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Straight and weightless.
    Straight,
    /// Touching nothing between its ends.
    Hanging,
    /// Straight up or down under tension.
    Vertical,
    /// The ends above each other, more line than distance: it hangs doubled over.
    HangingDouble,
    /// Lying from A, then rising to B.
    PartlyOnBed,
    /// Lying from end to end.
    WhollyOnBed,
    /// More line than needed lies at A; it rises straight to B.
    SlackOnBed,
    /// Down from A, along the bed, up to B.
    TroughOnBed,
    /// Straight down from A, surplus on the bed, straight up to B.
    SlackTroughOnBed,
    /// Several stretches on the bed with arches between.
    ManyOnBed,
}

impl Shape {
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

    /// The shape in words for a floating line held down by the surface.
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

/// A point of the line, seen from end A.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Point {
    /// Unstretched arc length from A \[m\].
    pub arc_m: f64,
    /// Horizontal position \[m\].
    pub x_m: f64,
    /// Height above A \[m\].
    pub z_m: f64,
    /// Tension \[N\].
    pub tension_n: f64,
}

/// Where a solution came from, to start a neighbouring line from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Seed {
    None,
    Free(f64),
    Leg(f64),
    Trough(f64),
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
    /// What it looks like.
    pub shape: Shape,
    /// Whether `on_bed_m` rests against the surface above instead.
    pub against_surface: bool,
    /// Evaluations of the line spent on it.
    pub iterations: u32,
    /// Error of force that the miss of end B stands for, over the larger end tension \[-\]; measured
    /// afterwards, from the forces back to the position, by other formulas.
    pub residual: f64,
    /// Change of (`h_b_n`, `v_b_n`) per metre that B moves along (x, z), A held \[N/m\]:
    /// \[\[h/x, h/z\], \[v/x, v/z\]\]. x counts as positive away from A.
    pub stiffness_n_per_m: [[f64; 2]; 2],
    pub(super) frame: Frame,
    pub(super) pieces: Pieces,
    pub(super) seed: Seed,
}

/// How the plane the solver worked in lies in the user's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    /// 1, or -1 when B lies on the other side of A.
    pub along: f64,
    /// 1, or -1 for a floating line solved upside down.
    pub up: f64,
}

/// Stretches of a line in order from A; without allocation for a line of one section.
#[derive(Debug, Clone, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "a line of one section is solved without allocation"
)]
pub(super) enum Pieces {
    Few([Piece; 3], usize),
    Many(Vec<Piece>),
}

impl Pieces {
    fn slice(&self) -> &[Piece] {
        match self {
            Self::Few(few, n) => &few[..*n],
            Self::Many(many) => many,
        }
    }
}

/// A stretch of line with one law of shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// Unstretched arc length where it begins, and its own unstretched length.
    pub from: f64,
    pub length: f64,
    /// Where it begins.
    pub x: f64,
    pub z: f64,
    pub kind: Kind,
}

/// The laws of shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    /// Hanging, with the force at its beginning.
    Hanging { h: f64, va: f64, w: f64, ea: f64 },
    /// Lying: tension at its end, lost by `loss` per metre towards its beginning but never below zero.
    Lying {
        end: f64,
        loss: f64,
        cos: f64,
        sin: f64,
        ea: f64,
    },
    /// More line than room, without tension, spread evenly up to this x and z.
    Heap { x: f64, z: f64 },
}

impl Default for Piece {
    fn default() -> Self {
        Self {
            from: 0.0,
            length: 0.0,
            x: 0.0,
            z: 0.0,
            kind: Kind::Heap { x: 0.0, z: 0.0 },
        }
    }
}

/// Tension summed over the last `n` of a lying stretch whose end carries `end`.
pub(super) fn lying_sum(end: f64, loss: f64, n: f64) -> f64 {
    let n = if loss > 0.0 { n.min(end / loss) } else { n };
    n * (end - 0.5 * loss * n)
}

impl Piece {
    fn point(&self, arc: f64) -> Point {
        let u = (arc - self.from).clamp(0.0, self.length);
        let (dx, dz, tension_n) = match self.kind {
            Kind::Hanging { h, va, w, ea } => {
                let span = Span {
                    length: u,
                    weight: w,
                    ea,
                };
                let (dx, dz) = span.reach(h, va);
                (dx, dz, length(h, va + w * u))
            }
            Kind::Lying {
                end,
                loss,
                cos,
                sin,
                ea,
            } => {
                let rest = self.length - u;
                let sum = lying_sum(end, loss, self.length) - lying_sum(end, loss, rest);
                let along = u + sum / ea;
                (along * cos, along * sin, (end - loss * rest).max(0.0))
            }
            Kind::Heap { x, z } => {
                let part = if self.length > 0.0 {
                    u / self.length
                } else {
                    0.0
                };
                (part * (x - self.x), part * (z - self.z), 0.0)
            }
        };
        Point {
            arc_m: arc,
            x_m: self.x + dx,
            z_m: self.z + dz,
            tension_n,
        }
    }

    /// The lowest point of this stretch.
    fn lowest(&self) -> Point {
        let (begin, end) = (self.point(self.from), self.point(self.from + self.length));
        let mut low = if end.z_m < begin.z_m { end } else { begin };
        if let Kind::Hanging { va, w, .. } = self.kind
            && va * w < 0.0
            && -va / w < self.length
        {
            let inner = self.point(self.from - va / w);
            if inner.z_m < low.z_m {
                low = inner;
            }
        }
        low
    }
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
    /// Line lying slack is shown spread evenly over the room it has.
    #[must_use]
    pub fn at(&self, arc_m: f64) -> Point {
        let pieces = self.pieces.slice();
        let arc_m = arc_m.clamp(0.0, self.length_m());
        let found = pieces
            .iter()
            .find(|piece| arc_m <= piece.from + piece.length)
            .or(pieces.last());
        found.map_or_else(Point::default, |piece| self.shown(piece.point(arc_m)))
    }

    /// The lowest point of the line.
    #[must_use]
    pub fn lowest(&self) -> Point {
        let mut low = self.at(0.0);
        let end = self.at(self.length_m());
        if end.z_m < low.z_m {
            low = end;
        }
        for piece in self.pieces.slice() {
            // An upside-down line is lowest where its mirror image is highest: at ends of stretches.
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

    /// From the solver's plane to the user's.
    fn shown(&self, point: Point) -> Point {
        Point {
            x_m: self.frame.along * point.x_m,
            z_m: self.frame.up * point.z_m,
            ..point
        }
    }
}
