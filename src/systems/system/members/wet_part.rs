//! The part of a member in the water: the length whose slices across the axis are whole in the water, and the length whose slices the surface
//! cuts. Sums over it are by Gauss's rule, which is exact for cylinders and cones; a slice counts by the share of its area in the water. So the
//! sums go on without a step as the surface moves along the member or over its ends.

use std::f64::consts::PI;
use std::sync::LazyLock;

use num_dual::DualNum;

use super::super::moving_pose::{Dual, DualVector};
use super::placed::Placed;
use crate::numerics::quadrature::gauss_legendre;

/// Slices of the length that is whole in the water, and of the length that the surface cuts.
const WHOLE: usize = 16;
const CUT: usize = 12;
/// Slices of both.
pub(super) const SLICES: usize = WHOLE + CUT;

/// Sine of the tilt below which slices count as level: the surface then cuts a length of 1e-6 diameters.
pub(super) const UPRIGHT: f64 = 1e-6;

/// Gauss's rule over the length that is whole in the water.
static WHOLE_RULE: LazyLock<[(f64, f64); WHOLE]> = LazyLock::new(gauss_legendre);

/// The same over the length that the surface cuts, by the half angle t of `(1 - cos pi t)/2`: the area of a segment of a circle grows with the
/// power 3/2 of its height, which is smooth in t.
static CUT_RULE: LazyLock<[(f64, f64); CUT]> = LazyLock::new(|| {
    gauss_legendre().map(|(node, weight): (f64, f64)| {
        let (sin, cos) = (PI * node).sin_cos();
        (0.5 * (1.0 - cos), weight * 0.5 * PI * sin)
    })
});

/// A length between two shares of that of the member, from its lower end.
pub(super) type MemberSpan = (Dual, Dual);

/// The part of a member in the water.
pub(in crate::system) struct WetPart {
    /// Where its slices are whole in the water.
    pub(super) whole: MemberSpan,
    /// Where the surface cuts them.
    pub(super) cut: MemberSpan,
}

/// A slice across the part of a member in the water.
pub(super) struct MemberSlice {
    /// Its number.
    pub(super) number: usize,
    /// From the origin of the body.
    pub(super) arm: DualVector,
    /// Height of its centre above the surface \[m\].
    pub(super) height: Dual,
    /// Its radius \[m\].
    pub(super) radius: Dual,
    /// Length along the axis that it stands for, by the share of its area in the water \[m\].
    pub(super) long: Dual,
}

/// The part of a circle below a level.
pub(super) struct CircleSegment {
    /// Its area \[m²\].
    pub(super) area: Dual,
    /// Half its chord \[m\].
    pub(super) half_chord: Dual,
}

/// The part of a circle of a radius below a level above its centre; nothing where the circle is above the level.
pub(super) fn segment(radius: Dual, level: Dual) -> Option<CircleSegment> {
    if level.re >= radius.re {
        return Some(CircleSegment {
            area: radius * radius * PI,
            half_chord: Dual::from_re(0.0),
        });
    }
    let inside = radius * radius - level * level;
    (inside.re > 0.0).then(|| {
        let half_chord = inside.sqrt();
        let angle = Dual::from_re(PI) - (level / radius).acos();
        CircleSegment {
            area: radius * radius * angle + level * half_chord,
            half_chord,
        }
    })
}

/// Whether a length is nothing.
pub(super) fn is_empty(span: &MemberSpan) -> bool {
    span.1.re <= span.0.re
}

/// Shares of a span with the lengths that they stand for, by a rule.
pub(super) fn by_rule(span: MemberSpan, rule: &[(f64, f64)]) -> impl Iterator<Item = (Dual, Dual)> {
    let long = span.1 - span.0;
    rule.iter()
        .map(move |(node, weight)| (span.0 + long * *node, long * *weight))
}

/// The same of a span that the surface cuts.
pub(super) fn cut_shares(span: MemberSpan) -> impl Iterator<Item = (Dual, Dual)> {
    by_rule(span, &CUT_RULE[..])
}

impl WetPart {
    /// The shares of the length at which the slices are, all of them, of lengths that are nothing too.
    pub(in crate::system) fn shares(&self) -> impl Iterator<Item = f64> {
        let whole = by_rule(self.whole, &WHOLE_RULE[..]);
        whole.chain(cut_shares(self.cut)).map(|(share, _)| share.re)
    }
}

impl Placed<'_> {
    /// The part in the water.
    pub(in crate::system) fn wet_part(&self) -> WetPart {
        let at = Dual::from_re;
        let all = (at(0.0), at(1.0));
        let tilt = self.tilt2.re.max(0.0).sqrt();
        let (low, high) = (self.z.re, self.z.re + self.rise.re);
        let (half_low, half_high) = (tilt * self.radius.0, tilt * self.radius.1);
        let span = |whole: MemberSpan, cut: MemberSpan| WetPart { whole, cut };
        if low + half_low <= 0.0 && high + half_high <= 0.0 {
            return span(all, (at(1.0), at(1.0)));
        }
        if low - half_low >= 0.0 && high - half_high >= 0.0 {
            return span((at(0.0), at(0.0)), (at(0.0), at(0.0)));
        }
        if tilt < UPRIGHT {
            let whole = below(self.z, self.rise);
            return span(whole, (whole.1, whole.1));
        }
        let tilt = self.tilt2.sqrt();
        let taper = tilt * (self.radius.1 - self.radius.0);
        // Where the top, and the bottom, of a slice is below the surface.
        let whole = below(self.z + tilt * self.radius.0, self.rise + taper);
        let wet = below(self.z - tilt * self.radius.0, self.rise - taper);
        if is_empty(&whole) {
            return span((wet.0, wet.0), wet);
        }
        // What is whole in the water begins or ends with what is in the water.
        let beyond = wet.1.re - whole.1.re >= whole.0.re - wet.0.re;
        let cut = if beyond {
            (whole.1, wet.1)
        } else {
            (wet.0, whole.0)
        };
        span(whole, cut)
    }

    /// Slices of the part in the water, without those of lengths that are nothing.
    pub(super) fn wet_slices(&self) -> impl Iterator<Item = MemberSlice> {
        let wet = self.wet_part();
        let tilt = self.tilt2.re.max(0.0).sqrt();
        let tilt = (tilt >= UPRIGHT).then(|| self.tilt2.sqrt());
        let whole = by_rule(wet.whole, &WHOLE_RULE[..]).enumerate();
        let whole = whole
            .filter(move |_| !is_empty(&wet.whole))
            .map(move |(number, (share, long))| self.slice(number, share, long * self.length));
        let cut = cut_shares(wet.cut).enumerate();
        let cut =
            cut.filter(move |_| !is_empty(&wet.cut))
                .filter_map(move |(number, (share, long))| {
                    let slice = self.slice(WHOLE + number, share, long * self.length);
                    let wet = segment(slice.radius, -slice.height / tilt?)?;
                    let circle = slice.radius * slice.radius * PI;
                    let long = slice.long * wet.area / circle;
                    Some(MemberSlice { long, ..slice })
                });
        whole.chain(cut)
    }

    fn slice(&self, number: usize, share: Dual, long: Dual) -> MemberSlice {
        MemberSlice {
            number,
            arm: self.arm_at(share),
            height: self.z + self.rise * share,
            radius: self.radius_at(share),
            long,
        }
    }
}

/// Where a height that is `at` at the lower end and changes by `slope` up to the upper one is below the surface.
fn below(at: Dual, slope: Dual) -> MemberSpan {
    let (none, whole) = (Dual::from_re(0.0), Dual::from_re(1.0));
    match (at.re <= 0.0, at.re + slope.re <= 0.0) {
        (true, true) => (none, whole),
        (false, false) => (none, none),
        (true, false) => (none, -at / slope),
        (false, true) => (-at / slope, whole),
    }
}
