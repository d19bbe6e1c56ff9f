//! How the forces at both ends of a line at rest change as its ends move.
//!
//! Between places on the bed the line is a suspended *bay*, with the vertical force `V(s) = offset + W(s)` (`elements`). Its
//! reach and rise change with H and its offset by the compliances of its spans (`span`): where it leaves the bed V is zero
//! and both have the same rate on either side, so the moving touchdown adds nothing. With the compliances of a bay summed,
//!
//! ```text
//! Σ (c_hh dH + c_hv do) + Σ_bed (L/EA) dH = dx,      c_hv dH + c_vv do = d rise    for each bay
//! ```
//!
//! On a bed with friction the tension of the grounded part is `H + mu U(s)`, which adds `mu L/EA do` of the bay beyond it, and
//! less reaches end A.
//!
//! Where a line goes through the surface (`crossing`) the vertical force beyond changes by `k dz`, with the change dz of its height there, as
//! more of it gets dry: reach, rise and the force at the end of a bay then follow from dH, do and the rise of its beginning by a march along its spans.

use super::profile::{PieceLaw, ProfilePiece};
use super::solution::Solution;
use super::span::{Compliance, Span};
use smallvec::SmallVec;

/// Change of the forces at the ends \[N/m\] with the horizontal distance of the ends and with the height of each end.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct EndStiffness {
    /// Change of `h_a_n`, by distance, height of A, height of B.
    pub h_a: [f64; 3],
    /// Change of `v_a_n`.
    pub v_a: [f64; 3],
    /// Change of `h_b_n`.
    pub h_b: [f64; 3],
    /// Change of `v_b_n`.
    pub v_b: [f64; 3],
}

/// How a bay changes with H, with its offset and with the height of its beginning, and where it begins and ends.
#[derive(Debug, Clone, Copy)]
struct BayCompliance {
    /// Its reach \[m/N, m/N, -\].
    reach: [f64; 3],
    /// The height of its end \[m/N, m/N, -\].
    height: [f64; 3],
    /// The vertical force at its end \[-, -, N/m\].
    force: [f64; 3],
    from_a: bool,
    to_b: bool,
}

impl BayCompliance {
    /// A bay without length.
    const fn begin(from_a: bool) -> Self {
        Self {
            reach: [0.0; 3],
            height: [0.0, 0.0, 1.0],
            force: [0.0, 1.0, 0.0],
            from_a,
            to_b: true,
        }
    }

    /// Goes on by a span; where it begins at the surface the force rises by `k` with its height.
    fn push(&mut self, c: &Compliance, k: f64) {
        for j in 0..3 {
            self.force[j] += k * self.height[j];
            let h = if j == 0 { 1.0 } else { 0.0 };
            self.reach[j] += c.hh * h + c.hv * self.force[j];
            self.height[j] += c.hv * h + c.vv * self.force[j];
        }
    }
}

/// Compliances beyond count as infinite: the line has no resistance there.
const LOOSE: f64 = 1e200;

impl Solution {
    /// The change of the forces at both ends as the ends move in the line's plane, on a level bed with this axial friction.
    ///
    /// An end that lies on the bed, its line with it, has no stiffness upwards: raised by `d` it carries a force that begins
    /// as the root of `d`.
    #[must_use]
    pub fn end_stiffness(&self, friction: f64) -> EndStiffness {
        let response = LineCompliance::of_line(self, friction);
        let up = self.frame.up;
        let mut out = EndStiffness::default();
        let motions = [(1.0, 0.0, 0.0), (0.0, up, 0.0), (0.0, 0.0, up)];
        for (column, (dx, dz_a, dz_b)) in motions.into_iter().enumerate() {
            let [h_a, v_a, h_b, v_b] = response.forces(dx, [dz_a, dz_b]);
            // Friction of the bed that takes all of the tension leaves end A without any, whatever moves.
            let lies = response.bays.is_empty() || response.beyond().is_some();
            let borne_by_bed = self.h_a_n <= 0.0 && lies;
            out.h_a[column] = if borne_by_bed { 0.0 } else { h_a };
            out.v_a[column] = up * v_a;
            out.h_b[column] = h_b;
            out.v_b[column] = up * v_b;
        }
        out
    }
}

/// The compliances of a line's bays and of its grounded part.
struct LineCompliance {
    bays: Bays,
    /// What friction on the bed adds to the coupling of a bay's offset and the distance.
    rub: f64,
    friction: f64,
    /// Change of the distance by H, the heights held.
    by_h: f64,
}

/// Bays of a line; without allocation for a line of one section.
type Bays = SmallVec<[BayCompliance; 2]>;

impl LineCompliance {
    fn of_line(line: &Solution, friction: f64) -> Self {
        let pieces = line.pieces.slice();
        let bays = bays(line);
        let bed = grounded_compliance(pieces);
        let slack = |piece: &ProfilePiece| {
            matches!(piece.kind, PieceLaw::Slack { .. }) && piece.length > 0.0
        };
        let mut found = Self {
            bays,
            rub: friction * bed,
            friction,
            by_h: bed,
        };
        for k in 0..found.bays.len() {
            let bay = &found.bays[k];
            found.by_h += bay.reach[0] - found.coupling(k) * bay.height[0] / bay.height[1];
        }
        if pieces.iter().any(slack) || !found.by_h.is_finite() {
            found.by_h = f64::INFINITY;
        }
        found
    }

    /// Change of the distance by the offset of a bay: with friction, the first that rises from the bed drags what lies before it.
    fn coupling(&self, k: usize) -> f64 {
        let beyond = self.beyond() == Some(k);
        self.bays[k].reach[1] + if beyond { self.rub } else { 0.0 }
    }

    /// The bay that rises from the part on the bed that end A lies on.
    fn beyond(&self) -> Option<usize> {
        self.bays.first().filter(|bay| !bay.from_a).map(|_| 0)
    }

    /// Changes of `h_a`, `v_a`, `h_b`, `v_b` as the distance changes and the ends rise.
    fn forces(&self, dx: f64, rises: [f64; 2]) -> [f64; 4] {
        let of = |counts: bool, rise: f64| if counts { rise } else { 0.0 };
        let begins = |bay: &BayCompliance| of(bay.from_a, rises[0]);
        let rise = |bay: &BayCompliance| of(bay.to_b, rises[1]) - bay.height[2] * begins(bay);
        let mut rest = dx;
        for (k, bay) in self.bays.iter().enumerate() {
            rest -= bay.reach[2] * begins(bay);
            rest -= self.coupling(k) / bay.height[1] * rise(bay);
        }
        let dh = if self.by_h > LOOSE {
            0.0
        } else {
            rest / self.by_h
        };
        let offset = |bay: &BayCompliance| (rise(bay) - bay.height[0] * dh) / bay.height[1];
        let at_end = |bay: &BayCompliance| {
            bay.force[0] * dh + bay.force[1] * offset(bay) + bay.force[2] * begins(bay)
        };
        let v_a = self.bays.iter().find(|bay| bay.from_a).map_or(0.0, offset);
        let v_b = self.bays.iter().find(|bay| bay.to_b).map_or(0.0, at_end);
        let lost = self
            .beyond()
            .map_or(0.0, |k| self.friction * offset(&self.bays[k]));
        [dh + lost, v_a, dh, v_b]
    }
}

/// The bays in order: runs of suspended pieces. A grounded piece without length marks where the line touches the bed; one no
/// longer than rounding is nothing.
fn bays(line: &Solution) -> Bays {
    let pieces = line.pieces.slice();
    let whole: f64 = pieces.iter().map(|piece| piece.length).sum();
    let counts =
        |(_, piece): &(usize, &ProfilePiece)| piece.length == 0.0 || piece.length > 1e-11 * whole;
    let mut bays = Bays::new();
    let (mut open, mut first) = (false, true);
    for (number, piece) in pieces.iter().enumerate().filter(counts) {
        let PieceLaw::Suspended { h, va, w, ea } = piece.kind else {
            if let Some(bay) = bays.last_mut().filter(|_| piece.length > 0.0) {
                bay.to_b = false;
            }
            (open, first) = (false, false);
            continue;
        };
        let span = Span {
            length: piece.length,
            weight: w,
            ea,
        };
        if !open {
            if let Some(before) = bays.last_mut() {
                before.to_b = false;
            }
            bays.push(BayCompliance::begin(first));
        }
        (open, first) = (true, false);
        if let Some(bay) = bays.last_mut() {
            bay.push(&span.compliance(h, va), line.heavier_by_height(number));
        }
    }
    bays
}

/// `L/EA` of the grounded pieces that carry tension.
fn grounded_compliance(pieces: &[ProfilePiece]) -> f64 {
    let taut = pieces.iter().map(|piece| match piece.kind {
        PieceLaw::Grounded { end, loss, ea, .. } => {
            let taut = if loss > 0.0 {
                piece.length.min(end / loss)
            } else {
                piece.length
            };
            taut / ea
        }
        _ => 0.0,
    });
    taut.sum()
}
