//! Components of a sea as products of phasors by time, by place and of a decay with depth, and how these are carried a short way.
//!
//! `theta = (omega t + phase) - k x`, so its cosine and sine follow from those of both parts. The part by place and the decay are taken at an
//! anchor no further away than [`REACH`] in wave numbers times distance, and carried over the rest by series that are exact there to rounding.

use std::ops::{Div, Mul};

use wide::f64x4;

use super::component_lanes::{ComponentLanes, Four};
use crate::numerics::processor::Lanes;

/// Greatest wave number times the distance to an anchor.
pub(super) const REACH: f64 = 0.25;

/// Decay beyond `exp` of this is none; an exponent below is not let through, so that its inverse stays finite.
pub(super) const FLOOR: f64 = -60.0;

/// Cosines and sines.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Phasor {
    pub(super) cos: Lanes,
    pub(super) sin: Lanes,
}

/// `exp(kz)` and `exp(-k(z + 2h))`, both over `1 - exp(-2kh)` and times omega.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Decay {
    pub(super) falling: Lanes,
    pub(super) back: Lanes,
}

/// Lane by lane.
#[inline(always)]
fn each(of: impl Fn(usize) -> f64) -> Lanes {
    [of(0), of(1), of(2), of(3)]
}

impl Phasor {
    #[inline(always)]
    fn of_angle(angle: f64x4) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self {
            cos: cos.to_array(),
            sin: sin.to_array(),
        }
    }

    /// That of a component.
    #[inline(always)]
    pub(super) fn at(&self, lane: usize) -> Turn {
        Turn {
            cos: self.cos[lane],
            sin: self.sin[lane],
        }
    }
}

/// Cosine and sine of one angle: a number of the complex plane.
#[derive(Clone, Copy)]
pub(super) struct Turn {
    pub(super) cos: f64,
    pub(super) sin: f64,
}

impl Mul for Turn {
    type Output = Self;

    /// Of the sum of both angles.
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            cos: self.cos * other.cos - self.sin * other.sin,
            sin: self.sin * other.cos + self.cos * other.sin,
        }
    }
}

impl Div for Turn {
    type Output = Self;

    /// Of the difference of both angles; the length of the second is one.
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self {
            cos: self.cos * other.cos + self.sin * other.sin,
            sin: self.sin * other.cos - self.cos * other.sin,
        }
    }
}

impl Four {
    /// Amplitude times cosine and sine of `omega t + phase`.
    #[inline(always)]
    fn by_time(&self, t: f64) -> Phasor {
        let (omega, phase) = (f64x4::new(self.omega), f64x4::new(self.phase));
        let turned = Phasor::of_angle(omega * t + phase);
        Phasor {
            cos: each(|i| self.amplitude[i] * turned.cos[i]),
            sin: each(|i| self.amplitude[i] * turned.sin[i]),
        }
    }

    /// Cosine and sine of `k x`.
    #[inline(always)]
    fn by_place(&self, along: f64) -> Phasor {
        Phasor::of_angle(f64x4::new(self.k) * along)
    }

    /// The decay down to a height \[m\].
    #[inline(always)]
    fn by_height(&self, z: f64) -> Decay {
        let falling = (f64x4::new(self.k) * z).fast_max(f64x4::splat(FLOOR)).exp();
        let back = f64x4::new(self.back) / falling;
        let whole = f64x4::new(self.whole);
        Decay {
            falling: (falling * whole).to_array(),
            back: (back * whole).to_array(),
        }
    }
}

/// Series of the sine, cosine and exponential of small numbers.
#[derive(Clone, Copy)]
pub(super) struct PowerSeries {
    long: bool,
}

impl PowerSeries {
    /// Below this the short ones are exact to rounding; the long ones up to [`REACH`].
    pub(super) const SHORT: f64 = 0.0625;

    #[inline(always)]
    pub(super) const fn short() -> Self {
        Self { long: false }
    }

    #[inline(always)]
    pub(super) const fn long() -> Self {
        Self { long: true }
    }

    /// Of an odd and an even function of x whose terms alternate (`sign` -1) or not (1).
    #[inline(always)]
    fn odd_and_even(self, x: f64, sign: f64) -> (f64, f64) {
        let q = sign * x * x;
        let (odd, even) = match self.long {
            true => (
                1.0 / 5040.0 + q * (1.0 / 362_880.0),
                1.0 / 720.0 + q * (1.0 / 40_320.0 + q * (1.0 / 3_628_800.0)),
            ),
            false => (1.0 / 5040.0, 1.0 / 720.0),
        };
        (
            x * (1.0 + q * (1.0 / 6.0 + q * (1.0 / 120.0 + q * odd))),
            1.0 + q * (0.5 + q * (1.0 / 24.0 + q * even)),
        )
    }

    /// Cosine and sine of x.
    #[inline(always)]
    pub(super) fn turn(self, x: f64) -> Turn {
        let (sin, cos) = self.odd_and_even(x, -1.0);
        Turn { cos, sin }
    }

    /// `exp(x)` and `exp(-x)`.
    #[inline(always)]
    pub(super) fn carry(self, x: f64) -> (f64, f64) {
        let (odd, even) = self.odd_and_even(x, 1.0);
        (even + odd, even - odd)
    }
}

/// Where the sums take the phasors of four components from.
pub(super) trait Phasors {
    /// By time, times the amplitude.
    fn time(&self, number: usize, four: &Four) -> Phasor;
    /// By the anchor along the waves.
    fn place(&self, number: usize, four: &Four) -> Phasor;
    /// By the anchor in height.
    fn decay(&self, number: usize, four: &Four) -> Decay;
}

/// Phasors that move to the anchors of what is read.
pub(super) trait Anchored: Phasors {
    /// The anchor along the waves \[m\].
    fn along(&self) -> f64;
    /// The anchor in height \[m\].
    fn z(&self) -> f64;
    /// Moves to the anchor nearest to a distance along the waves \[m\].
    fn move_along(&mut self, lanes: &ComponentLanes, along: f64);
    /// Moves to the anchor nearest to a height \[m\].
    fn move_up(&mut self, lanes: &ComponentLanes, z: f64);
}

/// The phasors of each field of a sea.
pub(super) trait FieldPhasors {
    /// Those of a field.
    fn of_field(&mut self, field: usize) -> impl Anchored;
}

/// Phasors that are worked out where they are asked for.
pub(super) struct ComputedPhasors {
    t: f64,
    along: f64,
    z: f64,
}

impl ComputedPhasors {
    /// At a time \[s\].
    pub(super) const fn at(t: f64) -> Self {
        Self {
            t,
            along: 0.0,
            z: 0.0,
        }
    }
}

impl Phasors for ComputedPhasors {
    #[inline(always)]
    fn time(&self, _: usize, four: &Four) -> Phasor {
        four.by_time(self.t)
    }

    #[inline(always)]
    fn place(&self, _: usize, four: &Four) -> Phasor {
        four.by_place(self.along)
    }

    #[inline(always)]
    fn decay(&self, _: usize, four: &Four) -> Decay {
        four.by_height(self.z)
    }
}

impl FieldPhasors for ComputedPhasors {
    fn of_field(&mut self, _: usize) -> impl Anchored {
        Self::at(self.t)
    }
}

impl Anchored for ComputedPhasors {
    fn along(&self) -> f64 {
        self.along
    }

    fn z(&self) -> f64 {
        self.z
    }

    fn move_along(&mut self, lanes: &ComponentLanes, along: f64) {
        self.along = lanes.anchor(along);
    }

    fn move_up(&mut self, lanes: &ComponentLanes, z: f64) {
        self.z = lanes.anchor(z);
    }
}

/// The phasors of a field by time.
#[derive(Debug)]
pub(super) struct TimePhasors {
    of: u64,
    t: f64,
    fours: Vec<Phasor>,
}

impl Default for TimePhasors {
    fn default() -> Self {
        Self {
            of: 0,
            t: f64::NAN,
            fours: Vec::new(),
        }
    }
}

impl TimePhasors {
    /// Moves them to a time \[s\]. Allocates at the first call only.
    pub(super) fn move_to(&mut self, lanes: &ComponentLanes, t: f64) {
        if (self.of, self.t) == (lanes.digest(), t) {
            return;
        }
        (self.of, self.t) = (lanes.digest(), t);
        self.fours.clear();
        let fours = lanes.fours().iter();
        self.fours.extend(fours.map(|four| four.by_time(t)));
    }
}

/// The phasors of a field at the anchors of a place that is read again and again.
#[derive(Debug)]
pub(super) struct PlacePhasors {
    of: u64,
    along: f64,
    z: f64,
    place: Vec<Phasor>,
    decay: Vec<Decay>,
}

impl Default for PlacePhasors {
    fn default() -> Self {
        Self {
            of: 0,
            along: f64::NAN,
            z: f64::NAN,
            place: Vec::new(),
            decay: Vec::new(),
        }
    }
}

impl PlacePhasors {
    /// Forgets what is of another field.
    fn enter(&mut self, lanes: &ComponentLanes) {
        if self.of != lanes.digest() {
            *self = Self {
                of: lanes.digest(),
                place: Vec::with_capacity(lanes.fours().len()),
                decay: Vec::with_capacity(lanes.fours().len()),
                ..Self::default()
            };
        }
    }
}

/// Those of a time and of a place.
pub(super) struct Kept<'a> {
    pub(super) time: &'a TimePhasors,
    pub(super) place: &'a mut PlacePhasors,
}

impl Phasors for Kept<'_> {
    #[inline(always)]
    fn time(&self, number: usize, _: &Four) -> Phasor {
        self.time.fours[number]
    }

    #[inline(always)]
    fn place(&self, number: usize, _: &Four) -> Phasor {
        self.place.place[number]
    }

    #[inline(always)]
    fn decay(&self, number: usize, _: &Four) -> Decay {
        self.place.decay[number]
    }
}

impl Anchored for Kept<'_> {
    fn along(&self) -> f64 {
        self.place.along
    }

    fn z(&self) -> f64 {
        self.place.z
    }

    fn move_along(&mut self, lanes: &ComponentLanes, along: f64) {
        let anchor = lanes.anchor(along);
        self.place.enter(lanes);
        if self.place.along != anchor {
            let fours = lanes.fours().iter();
            self.place.along = anchor;
            self.place.place.clear();
            self.place
                .place
                .extend(fours.map(|four| four.by_place(anchor)));
        }
    }

    fn move_up(&mut self, lanes: &ComponentLanes, z: f64) {
        let anchor = lanes.anchor(z);
        self.place.enter(lanes);
        if self.place.z != anchor {
            let reaching = &lanes.fours()[..lanes.reaching(lanes.top(anchor))];
            self.place.z = anchor;
            self.place.decay.clear();
            self.place
                .decay
                .extend(reaching.iter().map(|four| four.by_height(anchor)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    #[test]
    fn sines_of_lanes_are_those_of_the_standard_library() {
        let mut random = Random::new(19, 0);
        for size in [1.0, 1e2, 1e4, 1e6] {
            for _ in 0..2000 {
                let theta: [f64; 4] =
                    std::array::from_fn(|_| size * (2.0 * random.uniform() - 1.0));
                let (sin, cos) = f64x4::new(theta).sin_cos();
                for (lane, theta) in theta.into_iter().enumerate() {
                    let off = (sin.to_array()[lane] - theta.sin())
                        .abs()
                        .max((cos.to_array()[lane] - theta.cos()).abs());
                    assert!(
                        off < 1e-15 * size.max(1.0).sqrt() + 4e-16,
                        "{theta} {off:e}"
                    );
                }
            }
        }
    }

    #[test]
    fn exponentials_of_lanes_are_those_of_the_standard_library() {
        let mut random = Random::new(20, 0);
        for _ in 0..4000 {
            let x: [f64; 4] =
                std::array::from_fn(|_| FLOOR + (FLOOR.abs() + 20.0) * random.uniform());
            let found = f64x4::new(x).exp().to_array();
            for (found, x) in found.into_iter().zip(x) {
                assert!((found / x.exp() - 1.0).abs() < 1e-14, "{x} {found:e}");
            }
        }
    }
}
