//! The shape of a line in pieces, each suspended, on the bed under tension, or slack on the bed.

use super::span::{Span, length};

/// A point of the line, seen from end A.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ProfilePoint {
    /// Unstretched arc length from A \[m\].
    pub arc_m: f64,
    /// Horizontal position \[m\].
    pub x_m: f64,
    /// Height above A \[m\].
    pub z_m: f64,
    /// Tension \[N\].
    pub tension_n: f64,
}

/// The pieces of a line in order from A; without allocation for a line of one section.
#[derive(Debug, Clone, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "a line of one section is solved without allocation"
)]
pub(super) enum Pieces {
    Few([ProfilePiece; 3], usize),
    Many(Vec<ProfilePiece>),
}

impl Pieces {
    /// Up to three pieces, empty ones left out.
    pub(super) fn few(pieces: &[ProfilePiece]) -> Self {
        let mut few = [ProfilePiece::default(); 3];
        let mut n = 0;
        for piece in pieces {
            if piece.length > 0.0 && n < few.len() {
                few[n] = *piece;
                n += 1;
            }
        }
        Self::Few(few, n)
    }

    pub(super) fn slice(&self) -> &[ProfilePiece] {
        match self {
            Self::Few(few, n) => &few[..*n],
            Self::Many(many) => many,
        }
    }
}

/// A part of the line with one law of shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ProfilePiece {
    /// Unstretched arc length where it begins, and its own unstretched length.
    pub from: f64,
    pub length: f64,
    /// Where it begins.
    pub x: f64,
    pub z: f64,
    pub kind: PieceLaw,
}

/// The laws of shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PieceLaw {
    /// Suspended, with the force at its beginning.
    Suspended { h: f64, va: f64, w: f64, ea: f64 },
    /// On the bed: tension at its end, lost by `loss` per metre towards its beginning but never below zero.
    Grounded {
        end: f64,
        loss: f64,
        cos: f64,
        sin: f64,
        ea: f64,
    },
    /// More line than room on the bed, without tension, spread evenly up to this x and z.
    Slack { x: f64, z: f64 },
}

impl Default for ProfilePiece {
    fn default() -> Self {
        Self {
            from: 0.0,
            length: 0.0,
            x: 0.0,
            z: 0.0,
            kind: PieceLaw::Slack { x: 0.0, z: 0.0 },
        }
    }
}

/// Tension integrated over the last `n` metres of a grounded part whose end carries `end`.
pub(super) fn grounded_tension_sum(end: f64, loss: f64, n: f64) -> f64 {
    let n = if loss > 0.0 { n.min(end / loss) } else { n };
    n * (end - 0.5 * loss * n)
}

impl ProfilePiece {
    pub(super) fn point(&self, arc: f64) -> ProfilePoint {
        let u = (arc - self.from).clamp(0.0, self.length);
        let (dx, dz, tension_n) = match self.kind {
            PieceLaw::Suspended { h, va, w, ea } => {
                let span = Span {
                    length: u,
                    weight: w,
                    ea,
                };
                let (dx, dz) = span.reach(h, va);
                (dx, dz, length(h, va + w * u))
            }
            PieceLaw::Grounded {
                end,
                loss,
                cos,
                sin,
                ea,
            } => {
                let rest = self.length - u;
                let sum = grounded_tension_sum(end, loss, self.length)
                    - grounded_tension_sum(end, loss, rest);
                let along = u + sum / ea;
                (along * cos, along * sin, (end - loss * rest).max(0.0))
            }
            PieceLaw::Slack { x, z } => {
                let part = if self.length > 0.0 {
                    u / self.length
                } else {
                    0.0
                };
                (part * (x - self.x), part * (z - self.z), 0.0)
            }
        };
        ProfilePoint {
            arc_m: arc,
            x_m: self.x + dx,
            z_m: self.z + dz,
            tension_n,
        }
    }

    /// The lowest point of this piece.
    pub(super) fn lowest(&self) -> ProfilePoint {
        let (begin, end) = (self.point(self.from), self.point(self.from + self.length));
        let mut low = if end.z_m < begin.z_m { end } else { begin };
        if let PieceLaw::Suspended { va, w, .. } = self.kind
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

/// Places pieces one after the other from A.
#[derive(Default)]
pub(super) struct ProfileBuilder {
    arc: f64,
    x: f64,
    z: f64,
    pieces: Vec<ProfilePiece>,
}

impl ProfileBuilder {
    /// A part of this unstretched length that reaches (dx, dz).
    pub(super) fn push(&mut self, length: f64, law: PieceLaw, (dx, dz): (f64, f64)) {
        self.pieces.push(ProfilePiece {
            from: self.arc,
            length,
            x: self.x,
            z: self.z,
            kind: law,
        });
        self.arc += length;
        self.x += dx;
        self.z += dz;
    }

    /// A suspended part whose beginning carries (`h`, `va`).
    pub(super) fn suspend(&mut self, span: &Span, h: f64, va: f64) {
        let law = PieceLaw::Suspended {
            h,
            va,
            w: span.weight,
            ea: span.ea,
        };
        self.push(span.length, law, span.reach(h, va));
    }

    /// Height reached.
    pub(super) fn z(&self) -> f64 {
        self.z
    }

    /// A slack part on the bed that takes up (`dx`, `dz`) and ends at the height `z`.
    pub(super) fn slack(&mut self, length: f64, (dx, dz): (f64, f64), z: f64) {
        let x = self.x + dx;
        self.push(length, PieceLaw::Slack { x, z }, (dx, dz));
    }

    pub(super) fn pieces(self) -> Pieces {
        Pieces::Many(self.pieces)
    }
}
