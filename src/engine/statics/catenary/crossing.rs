//! A line that leaves the water: dry from an end that is above the surface, or from both, and wet between.
//!
//! Where it is dry it weighs `w + b`, with its weight in water w and the weight b of the water that it displaces. Weight by height has the potential
//! `w z + b max(z, 0)`, convex in the height z above the surface, so that there is still one state of least energy. With given
//! lengths of dry line the line is one of wet and dry sections, which the other modules solve; where they meet its height must be zero. A
//! place of division that moves by ds along the line loads it there by `b ds`, and with the compliances `C_ij >= 0` between places
//! of division their heights change by
//!
//! ```text
//! dz_i = z'_i ds_i + Σ_j C_ij b_j ds_j
//! ```
//!
//! with ds towards the end that is dry, towards which the line rises there. One place is found within a bracket, two by Newton's method.
//!
//! What is dry between two wet parts, or afloat, is not covered.

use smallvec::SmallVec;

use super::error::CatenaryError;
use super::line::{CatenaryLine, SectionProperties};
use super::profile::{PieceLaw, ProfilePiece};
use super::solution::Solution;
use super::span::length;
use crate::numerics::roots::false_position;

/// A line that may leave the water at its ends, with sections that weigh what they weigh under water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrossingLine<'a> {
    /// The line as it is under water, without a surface above.
    pub line: CatenaryLine<'a>,
    /// Weight of the water that each section displaces per unstretched length \[N/m\].
    pub displaced_n_per_m: &'a [f64],
    /// Height of end A above the surface \[m\].
    pub a_above_m: f64,
}

/// Where a line goes through the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crossing {
    /// Number of the piece that begins there.
    pub piece: usize,
    /// Weight of the water that the line displaces there per unstretched length.
    pub displaced: f64,
}

/// Places at which a line goes through the surface, in order from A.
pub(super) type Crossings = SmallVec<[Crossing; 2]>;

/// Height that is none, by the length of the line and the heights of its ends.
const LEVEL: f64 = 1e-13;
/// Height beyond the surface that is rounding, by the same.
const BEYOND: f64 = 1e-9;
/// Parts of sections shorter than this part of the line are none.
const SHORTEST: f64 = 1e-14;
/// Steps towards two places of division.
const STEPS: usize = 60;
/// Step of their differences, by the length of the line.
const DIFFERENCE: f64 = 1e-7;
/// Heights that rounding leaves at both.
const ROUNDED: f64 = 1e3;

const FLOATS: CatenaryError = CatenaryError::AtSurface(
    "a part of the line between its ends floats at the surface or rises through it",
);
const NO_CROSSING: CatenaryError =
    CatenaryError::AtSurface("where the line goes through the surface was not found");

/// Sections in the water and in the air in order.
type DividedSections = SmallVec<[SectionProperties; 4]>;

impl CrossingLine<'_> {
    /// The line at rest.
    ///
    /// # Errors
    /// As [`CatenaryLine::solve`]; lines that float at the surface, or are dry between wet parts.
    pub fn solve(&self) -> Result<Solution, CatenaryError> {
        let [a, b] = self.end_heights();
        let dry = match (a > 0.0, b > 0.0) {
            (false, false) => [0.0; 2],
            (true, true) => self.dry_at_both()?,
            (true, false) => [self.dry_from(0)?, 0.0],
            (false, true) => [0.0, self.dry_from(1)?],
        };
        let solution = self.with_dry(dry)?;
        if !self.is_wet_between(dry, &solution) {
            return Err(FLOATS);
        }
        Ok(self.crossed(dry, solution))
    }

    /// Heights of both ends above the surface.
    fn end_heights(&self) -> [f64; 2] {
        [self.a_above_m, self.a_above_m + self.line.ends.z_m]
    }

    fn length(&self) -> f64 {
        self.line.sections.iter().map(|one| one.length_m).sum()
    }

    /// The scale of heights.
    fn scale(&self) -> f64 {
        let [a, b] = self.end_heights();
        self.length() + a.abs() + b.abs()
    }

    /// The line with given lengths of dry line from A and from B.
    fn with_dry(&self, dry: [f64; 2]) -> Result<Solution, CatenaryError> {
        let sections = self.divided(dry)?;
        let line = CatenaryLine {
            sections: &sections,
            ..self.line
        };
        line.solve()
    }

    /// Its sections divided where it is dry from both ends.
    fn divided(&self, [from_a, from_b]: [f64; 2]) -> Result<DividedSections, CatenaryError> {
        let whole = self.length();
        let shortest = SHORTEST * whole;
        let cuts = [from_a, whole - from_b];
        let mut divided = DividedSections::new();
        let mut begin = 0.0;
        for (section, displaced) in self.line.sections.iter().zip(self.displaced_n_per_m) {
            let end = begin + section.length_m;
            let (mut at, first) = (begin, divided.len());
            let inside = |cut: &f64| *cut > begin + shortest && *cut < end - shortest;
            for cut in cuts.into_iter().filter(inside).chain([end]) {
                if cut - at <= shortest && divided.len() > first {
                    continue;
                }
                let middle = 0.5 * (at + cut);
                let is_dry = middle < cuts[0] || middle > cuts[1];
                divided.push(SectionProperties {
                    length_m: cut - at,
                    weight_n_per_m: section.weight_n_per_m + if is_dry { *displaced } else { 0.0 },
                    clump_n: 0.0,
                    ..*section
                });
                at = cut;
            }
            if let Some(last) = divided.last_mut() {
                // A buoy that is out of the water has another weight.
                if section.clump_n < 0.0 && (end < cuts[0] || end > cuts[1]) {
                    return Err(FLOATS);
                }
                last.clump_n = section.clump_n;
            }
            begin = end;
        }
        Ok(divided)
    }

    /// Height above the surface at an unstretched length from A.
    fn height(&self, solution: &Solution, arc: f64) -> f64 {
        self.a_above_m + solution.at(arc).z_m
    }

    /// Length of dry line from an end (0 A, 1 B) that is above the surface, with the other one below.
    fn dry_from(&self, end: usize) -> Result<f64, CatenaryError> {
        let (whole, heights) = (self.length(), self.end_heights());
        let level = LEVEL * self.scale();
        let height = |from_end: f64| {
            if from_end <= 0.0 {
                return Ok(heights[end]);
            }
            if from_end >= whole {
                return Ok(heights[1 - end].min(-f64::MIN_POSITIVE));
            }
            let mut dry = [0.0; 2];
            dry[end] = from_end;
            let found = self.heights(dry)?[end];
            Ok(if found.abs() <= level { 0.0 } else { found })
        };
        false_position((0.0, whole), height)?.ok_or(NO_CROSSING)
    }

    /// Lengths of dry line from both ends, both of which are above the surface.
    fn dry_at_both(&self) -> Result<[f64; 2], CatenaryError> {
        let whole = self.length();
        let in_air = self.with_dry([whole, 0.0])?;
        let low = in_air.lowest();
        if self.a_above_m + low.z_m >= -LEVEL * self.scale() {
            return Ok([whole, 0.0]);
        }
        let deep = -(self.a_above_m + low.z_m);
        let [a, b] = self.end_heights();
        let start = [
            low.arc_m * a / (a + deep),
            (whole - low.arc_m) * b / (b + deep),
        ];
        self.dry_near(start)
    }

    /// Heights of both places of division.
    fn heights(&self, dry: [f64; 2]) -> Result<[f64; 2], CatenaryError> {
        let solution = self.with_dry(dry)?;
        Ok([dry[0], self.length() - dry[1]].map(|arc| self.height(&solution, arc)))
    }

    /// Lengths of dry line by Newton's method from these: the heights are the slopes of a concave energy by them, along which a step is
    /// halved until it has no more than half of its slope left, turned round.
    fn dry_near(&self, mut dry: [f64; 2]) -> Result<[f64; 2], CatenaryError> {
        let (whole, level) = (self.length(), LEVEL * self.scale());
        let mut here = self.heights(dry)?;
        for _ in 0..STEPS {
            if here.iter().all(|z| z.abs() <= level) {
                return Ok(dry);
            }
            let step = self.newton_step(dry, here)?;
            let slope = |z: [f64; 2]| z[0] * step[0] + z[1] * step[1];
            let before = slope(here);
            let mut share = 1.0;
            let next = loop {
                let tried = [0, 1].map(|end| dry[end] + share * step[end]);
                let is_inside = tried.iter().all(|one| *one > 0.0) && tried[0] + tried[1] < whole;
                let then = is_inside.then(|| self.heights(tried)).and_then(Result::ok);
                if let Some(then) = then.filter(|then| slope(*then).abs() <= 0.5 * before.abs()) {
                    break Some((tried, then));
                }
                share *= 0.5;
                if share < SHORTEST {
                    break None;
                }
            };
            match next {
                Some(next) => (dry, here) = next,
                None => break,
            }
        }
        let rounded = here.iter().all(|z| z.abs() <= ROUNDED * level);
        rounded.then_some(dry).ok_or(NO_CROSSING)
    }

    /// Newton's step of both lengths of dry line, with derivatives by differences.
    fn newton_step(&self, dry: [f64; 2], here: [f64; 2]) -> Result<[f64; 2], CatenaryError> {
        let by = DIFFERENCE * self.length();
        let [p, q] = [
            self.heights([dry[0] - by.min(0.5 * dry[0]), dry[1]])?,
            self.heights([dry[0], dry[1] - by.min(0.5 * dry[1])])?,
        ];
        let column = |at: [f64; 2], end: usize| {
            let by = by.min(0.5 * dry[end]);
            [0, 1].map(|k| (here[k] - at[k]) / by)
        };
        let ([a, c], [b, d]) = (column(p, 0), column(q, 1));
        let determinant = a * d - b * c;
        let [x, y] = here;
        Ok([(b * y - d * x) / determinant, (c * x - a * y) / determinant])
    }

    /// Whether what counts as wet is below the surface, and what counts as dry above it.
    fn is_wet_between(&self, [from_a, from_b]: [f64; 2], solution: &Solution) -> bool {
        let (whole, beyond) = (self.length(), BEYOND * self.scale());
        let (wet_from, wet_to) = (from_a, whole - from_b);
        solution.pieces.slice().iter().all(|piece| {
            let middle = piece.from + 0.5 * piece.length;
            let [low, high] = extremes(piece).map(|z| self.a_above_m + z);
            match middle > wet_from && middle < wet_to {
                true => high <= beyond,
                false => low >= -beyond,
            }
        })
    }

    /// The solution with the places where it goes through the surface, and its stiffness with these moving along the line.
    fn crossed(&self, [from_a, from_b]: [f64; 2], mut solution: Solution) -> Solution {
        let whole = self.length();
        let cuts = [from_a, whole - from_b];
        let is_inside = |cut: &f64| *cut > SHORTEST * whole && *cut < whole * (1.0 - SHORTEST);
        for cut in cuts.into_iter().filter(is_inside) {
            let pieces = solution.pieces.slice();
            let numbered = pieces.iter().enumerate().skip(1);
            let suspended =
                numbered.filter(|(_, piece)| matches!(piece.kind, PieceLaw::Suspended { .. }));
            let nearest = suspended.min_by(|(_, one), (_, other)| {
                (one.from - cut).abs().total_cmp(&(other.from - cut).abs())
            });
            if let Some((piece, _)) = nearest {
                let displaced = self.displaced_at(cut);
                solution.crossings.push(Crossing { piece, displaced });
            }
        }
        if !solution.crossings.is_empty() {
            let found = solution.end_stiffness(self.line.bed.map_or(0.0, |bed| bed.friction));
            solution.stiffness_n_per_m =
                [[found.h_b[0], found.h_b[2]], [found.v_b[0], found.v_b[2]]];
            let top = solution.tension_a_n().max(solution.tension_b_n());
            let displaced = self.displaced_n_per_m.iter().copied().fold(0.0, f64::max);
            solution.residual += displaced * LEVEL * self.scale() / top.max(f64::MIN_POSITIVE);
        }
        solution
    }

    fn displaced_at(&self, arc: f64) -> f64 {
        let mut end = 0.0;
        let mut sections = self.line.sections.iter().zip(self.displaced_n_per_m);
        let found = sections.find(|(section, _)| {
            end += section.length_m;
            arc <= end
        });
        found.map_or(0.0, |(_, displaced)| *displaced)
    }
}

/// The least and the greatest height of a piece above end A.
fn extremes(piece: &ProfilePiece) -> [f64; 2] {
    let ends = [piece.from, piece.from + piece.length].map(|arc| piece.point(arc).z_m);
    let turn = match piece.kind {
        PieceLaw::Suspended { va, w, .. } if va * w < 0.0 && -va / w < piece.length => {
            Some(piece.point(piece.from - va / w).z_m)
        }
        _ => None,
    };
    let all = ends.into_iter().chain(turn);
    [
        all.clone().fold(f64::INFINITY, f64::min),
        all.fold(f64::NEG_INFINITY, f64::max),
    ]
}

impl Solution {
    /// By how much the vertical force beyond the beginning of a piece rises as the line rises there: nothing where it does not go through
    /// the surface \[N/m\].
    pub(super) fn heavier_by_height(&self, piece: usize) -> f64 {
        let found = self.crossings.iter().find(|one| one.piece == piece);
        let Some((crossing, piece)) = found.zip(self.pieces.slice().get(piece)) else {
            return 0.0;
        };
        let PieceLaw::Suspended { h, va, ea, .. } = piece.kind else {
            return 0.0;
        };
        let tension = length(h, va);
        let slope = va.abs() / tension + va.abs() / ea;
        crossing.displaced / slope.max(LEAST_SLOPE)
    }
}

/// Slope at which a line counts as going through the surface level.
const LEAST_SLOPE: f64 = 1e-12;
