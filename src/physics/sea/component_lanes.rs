//! The sums over the components of a sea, four components side by side in vector registers.
//!
//! A step of a line in a random sea is spent here: a hundred components at every node. Sines and exponentials are those of `wide`, which
//! agree with those of the standard library within 1e-15 of the amplitude, and what depends on the component alone is worked out once.

use wide::f64x4;

use super::Component;
use super::decay::{DepthDecay, Fading};
use super::stretching::StretchedHeight;

/// Components side by side.
const LANES: usize = 4;

/// Deeper than this, in wave numbers times depth, the bed is not felt.
const DEEP: f64 = 20.0;

/// Decay beyond `exp` of this is none; an exponent below is not let through, so that its inverse stays finite.
const FLOOR: f64 = -60.0;

/// Sums over the components: `c`, `s` stand for cosine and sine of theta, `k` for another wave number in the sum.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ComponentSums {
    // Weighted by a omega, then by a omega².
    pub(super) across: [f64; 2],
    pub(super) up: [f64; 2],
    pub(super) across_k: [f64; 2],
    pub(super) up_k: [f64; 2],
    pub(super) across_z: [f64; 2],
    pub(super) up_z: [f64; 2],
}

/// Height of the surface, its slope along the waves and its rate.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SurfaceSums {
    /// \[m\]
    pub(super) elevation: f64,
    /// \[-\]
    pub(super) slope: f64,
    /// \[m/s\]
    pub(super) rate: f64,
}

/// Four components; those that fill up the last four have no amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Four {
    omega: f64x4,
    /// Wave number \[1/m\].
    k: f64x4,
    /// The least of the four.
    least_k: f64,
    phase: f64x4,
    amplitude: f64x4,
    /// `exp(-2 k h)`, 0 where the bed is not felt.
    back: f64x4,
    /// `1 / (1 - exp(-2 k h))`.
    whole: f64x4,
}

/// The components of a sea in fours, wave numbers rising.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ComponentLanes(Vec<Four>);

impl ComponentLanes {
    /// Of components with their wave numbers \[1/m\], in water of this depth \[m\].
    pub(super) fn new(components: &[Component], numbers: &[f64], depth: f64) -> Self {
        let fours = components.chunks(LANES).zip(numbers.chunks(LANES));
        let four = |(components, numbers): (&[Component], &[f64])| {
            let lanes = |of: &dyn Fn(usize) -> f64| {
                let last = components.len() - 1;
                f64x4::new(std::array::from_fn(|lane| of(lane.min(last))))
            };
            let kh = |lane: usize| numbers[lane] * depth;
            let is_deep = |lane: usize| kh(lane) > DEEP;
            let mut amplitude = lanes(&|lane| components[lane].amplitude).to_array();
            amplitude[components.len()..].fill(0.0);
            Four {
                omega: lanes(&|lane| components[lane].omega),
                k: lanes(&|lane| numbers[lane]),
                least_k: numbers[0],
                phase: lanes(&|lane| components[lane].phase),
                amplitude: f64x4::new(amplitude),
                back: lanes(&|lane| match is_deep(lane) {
                    true => 0.0,
                    false => (-2.0 * kh(lane)).exp(),
                }),
                whole: lanes(&|lane| match is_deep(lane) {
                    true => 1.0,
                    false => 1.0 / -(-2.0 * kh(lane)).exp_m1(),
                }),
            }
        };
        Self(fours.map(four).collect())
    }

    /// The surface at a time \[s\] and a distance along the waves \[m\].
    pub(super) fn surface(&self, t: f64, along: f64) -> SurfaceSums {
        let [mut elevation, mut slope, mut rate] = [f64x4::ZERO; 3];
        for four in &self.0 {
            let (sin, cos) = four.theta(t, along).sin_cos();
            elevation += four.amplitude * cos;
            let sin = four.amplitude * sin;
            slope += four.k * sin;
            rate -= four.omega * sin;
        }
        SurfaceSums {
            elevation: elevation.reduce_add(),
            slope: slope.reduce_add(),
            rate: rate.reduce_add(),
        }
    }

    /// The motion under the surface, read at a height; components weaker than `exp(faint)` there are left out, where they decay.
    pub(super) fn motion(
        &self,
        (t, along): (f64, f64),
        reading: &StretchedHeight,
        decay: &DepthDecay,
        faint: f64,
    ) -> ComponentSums {
        let fading = decay.fading(reading.z);
        let mut sums = LaneSums::default();
        for four in &self.0 {
            if fading.decays && four.least_k * reading.z < faint {
                break;
            }
            let shares = four.shares(reading, &fading);
            sums.add(four, four.theta(t, along).sin_cos(), &shares);
        }
        sums.reduced()
    }
}

/// Shares of the surface's motion at a height, across and up, with their derivatives by z.
struct Shares {
    across: f64x4,
    up: f64x4,
    across_by_z: f64x4,
    up_by_z: f64x4,
}

impl Four {
    #[inline(always)]
    fn theta(&self, t: f64, along: f64) -> f64x4 {
        self.omega * t - self.k * along + self.phase
    }

    /// `cosh k(z+h) / sinh kh` and `sinh k(z+h) / sinh kh`, with what the law of decay makes of them.
    #[inline(always)]
    fn shares(&self, reading: &StretchedHeight, fading: &Fading) -> Shares {
        let (f, f_z) = (f64x4::splat(fading.share), f64x4::splat(fading.by_z));
        if !fading.decays {
            return Shares {
                across: f,
                up: f,
                across_by_z: f_z,
                up_by_z: f_z,
            }
            .beyond(reading.beyond);
        }
        let falling = (self.k * reading.z).fast_max(f64x4::splat(FLOOR)).exp();
        let back = self.back / falling;
        let (across, up) = ((falling + back) * self.whole, (falling - back) * self.whole);
        Shares {
            across: across * f,
            up: up * f,
            across_by_z: self.k * up * f + across * f_z,
            up_by_z: self.k * across * f + up * f_z,
        }
        .beyond(reading.beyond)
    }
}

impl Shares {
    /// At a distance above still water, along the straight line that touches there.
    #[inline(always)]
    fn beyond(self, above: f64) -> Self {
        if above <= 0.0 {
            return self;
        }
        Self {
            across: self.across + self.across_by_z * above,
            up: self.up + self.up_by_z * above,
            ..self
        }
    }
}

/// [`ComponentSums`], a sum a lane.
#[derive(Default)]
struct LaneSums {
    across: [f64x4; 2],
    up: [f64x4; 2],
    across_k: [f64x4; 2],
    up_k: [f64x4; 2],
    across_z: [f64x4; 2],
    up_z: [f64x4; 2],
}

impl LaneSums {
    /// Adds four components at `(sin, cos)` of their theta.
    #[inline(always)]
    fn add(&mut self, four: &Four, (sin, cos): (f64x4, f64x4), share: &Shares) {
        let v = four.amplitude * four.omega;
        // Velocity goes with (C cos, -S sin), acceleration by time with (-C sin, -S cos) omega, both by place
        // with d theta / d along = -k.
        let parts = [
            (v, cos, -sin, four.k * sin, four.k * cos),
            (v * four.omega, -sin, -cos, four.k * cos, -(four.k * sin)),
        ];
        for (which, (size, across, up, across_k, up_k)) in parts.into_iter().enumerate() {
            let (by_across, by_up) = (size * share.across, size * share.up);
            self.across[which] += by_across * across;
            self.up[which] += by_up * up;
            self.across_k[which] += by_across * across_k;
            self.up_k[which] += by_up * up_k;
            self.across_z[which] += size * share.across_by_z * across;
            self.up_z[which] += size * share.up_by_z * up;
        }
    }

    fn reduced(self) -> ComponentSums {
        let of = |lanes: [f64x4; 2]| lanes.map(f64x4::reduce_add);
        ComponentSums {
            across: of(self.across),
            up: of(self.up),
            across_k: of(self.across_k),
            up_k: of(self.up_k),
            across_z: of(self.across_z),
            up_z: of(self.up_z),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;
    use crate::physics::sea::decay::plain::share;
    use crate::physics::sea::wave_number;

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

    /// The same sums, one component after the other by the standard library.
    fn one_by_one(
        (components, numbers, depth): (&[Component], &[f64], f64),
        (t, along): (f64, f64),
        reading: &StretchedHeight,
        decay: DepthDecay,
    ) -> ComponentSums {
        let mut sums = ComponentSums::default();
        for (c, k) in components.iter().zip(numbers) {
            let share = share(decay, *k, depth, reading.z);
            let above = reading.beyond.max(0.0);
            let across_share = share.across + share.across_by_z * above;
            let up_share = share.up + share.up_by_z * above;
            let (sin, cos) = (c.omega * t - k * along + c.phase).sin_cos();
            let v = c.amplitude * c.omega;
            let parts = [
                (v, cos, -sin, k * sin, k * cos),
                (v * c.omega, -sin, -cos, k * cos, -k * sin),
            ];
            for (which, (size, across, up, across_k, up_k)) in parts.into_iter().enumerate() {
                sums.across[which] += size * across_share * across;
                sums.up[which] += size * up_share * up;
                sums.across_k[which] += size * across_share * across_k;
                sums.up_k[which] += size * up_share * up_k;
                sums.across_z[which] += size * share.across_by_z * across;
                sums.up_z[which] += size * share.up_by_z * up;
            }
        }
        sums
    }

    #[test]
    fn lanes_are_the_components_one_by_one() {
        let mut random = Random::new(21, 0);
        let laws = [
            DepthDecay::Airy,
            DepthDecay::AiryAbove(40.0),
            DepthDecay::Logarithmic(40.0),
        ];
        for (count, depth) in [(1, 50.0), (3, f64::INFINITY), (4, 20.0), (99, 200.0)] {
            let mut components: Vec<Component> = (0..count)
                .map(|_| Component {
                    omega: 0.3 + 1.5 * random.uniform(),
                    amplitude: random.uniform(),
                    phase: 6.0 * random.uniform(),
                })
                .collect();
            components.sort_by(|a, b| a.omega.total_cmp(&b.omega));
            let numbers: Vec<f64> = components
                .iter()
                .map(|c| wave_number(c.omega, 9.81, depth))
                .collect();
            let lanes = ComponentLanes::new(&components, &numbers, depth);
            for (decay, z) in laws
                .into_iter()
                .flat_map(|law| [0.0, -3.0, -19.0].map(|z| (law, z)))
            {
                for beyond in [0.0, 2.0] {
                    let reading = StretchedHeight {
                        z,
                        beyond,
                        by_z: 1.0,
                        by_elevation: 0.0,
                    };
                    let at = (700.0 * random.uniform(), 300.0 * random.uniform());
                    let found = lanes.motion(at, &reading, &decay, -60.0);
                    let plain = one_by_one((&components, &numbers, depth), at, &reading, decay);
                    let pairs = [
                        (found.across, plain.across),
                        (found.up, plain.up),
                        (found.across_k, plain.across_k),
                        (found.up_k, plain.up_k),
                        (found.across_z, plain.across_z),
                        (found.up_z, plain.up_z),
                    ];
                    for (found, plain) in pairs {
                        for (found, plain) in found.into_iter().zip(plain) {
                            let size = 1.0 + count as f64;
                            assert!(
                                (found - plain).abs() < 1e-13 * size,
                                "{decay:?} {z} {beyond}"
                            );
                        }
                    }
                    let surface = lanes.surface(at.0, at.1);
                    let height: f64 = components
                        .iter()
                        .zip(&numbers)
                        .map(|(c, k)| c.amplitude * (c.omega * at.0 - k * at.1 + c.phase).cos())
                        .sum();
                    assert!((surface.elevation - height).abs() < 1e-13 * (1.0 + count as f64));
                }
            }
        }
    }
}
