//! A random motion with given root mean squares of displacement, velocity and acceleration.
//!
//! The three are the square roots of the spectral moments m0, m2 and m4. The plainest spectrum that has them is flat over a
//! band of frequencies; where the moments are wider than a band of waves can be, as in a ship that also swings slowly at
//! its mooring, a slow band beside the band of waves. Beyond its three moments the shape is a choice, not a finding.

use std::f64::consts::TAU;

use crate::numerics::random::Random;
use crate::physics::sea::{Component, Moments};

/// Root mean squares of a motion with no mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionRms {
    /// Of the displacement.
    pub displacement: f64,
    /// Of the velocity, per second.
    pub velocity: f64,
    /// Of the acceleration, per second squared.
    pub acceleration: f64,
}

/// A flat spectrum over a band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralBand {
    /// Variance of the displacement.
    pub variance: f64,
    /// Middle of the band \[rad/s\].
    pub middle: f64,
    /// Half its width, as a share of the middle \[-\].
    pub half_width: f64,
}

/// Why no bands have these root mean squares.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SpectralBandError {
    /// A moment that is nothing beside others that are something.
    #[error("displacement, velocity and acceleration must all move, or none")]
    Part,
    /// No motion has them.
    #[error(
        "no motion has them: the square of the velocity, {velocity2:.4e}, is more than displacement times acceleration, {product:.4e}"
    )]
    Impossible {
        /// Mean square velocity.
        velocity2: f64,
        /// Displacement times acceleration.
        product: f64,
    },
    /// The slow band is too fast.
    #[error("the slow period is too short for them; more than {shortest:.4} s is needed")]
    Slow {
        /// No shorter slow period has them \[s\].
        shortest: f64,
    },
}

/// The widest band that is taken for waves: half its width as a share of its middle.
const WIDEST: f64 = 0.6;

/// Half the width of bands beside each other, as a share of the middle.
const USUAL: f64 = 0.3;

/// How far beyond what is possible rounding of printed numbers may lie.
const ROUNDING: f64 = 0.01;

impl SpectralBand {
    /// Variances of displacement, velocity and acceleration.
    #[must_use]
    pub fn moments(&self) -> [f64; 3] {
        let (second, fourth) = shape(self.half_width);
        let w2 = self.middle * self.middle;
        [1.0, second * w2, fourth * w2 * w2].map(|m| m * self.variance)
    }

    /// The band as regular components of equal energy and random phase, `count` at most, for a record of this duration
    /// \[s\]: their frequencies are whole multiples of its own, one drawn from each part of the band, or all there are. So
    /// the variance of that record, and of its rates, is the band's, not only that of an endless one; after the duration
    /// it repeats.
    #[must_use]
    pub fn components(
        &self,
        count: usize,
        duration: f64,
        seed: u64,
        stream: u64,
    ) -> Vec<Component> {
        let mut random = Random::new(seed, stream);
        let line = TAU / duration;
        let multiples = self.multiples(count, line, &mut random);
        let amplitude = (2.0 * self.variance / multiples.len() as f64).sqrt();
        let each = multiples.into_iter().map(|multiple| Component {
            omega: line * multiple,
            amplitude,
            phase: TAU * random.uniform(),
        });
        each.collect()
    }

    /// The multiples of a frequency that the components take.
    fn multiples(&self, count: usize, line: f64, random: &mut Random) -> Vec<f64> {
        let (low, high) = self.edges();
        let (first, last) = ((low / line).ceil().max(1.0), (high / line).floor());
        let lines = last - first + 1.0;
        if lines < 2.0 {
            return vec![(self.middle / line).round().max(1.0)];
        }
        if lines <= count as f64 {
            return (0..lines as usize).map(|i| first + i as f64).collect();
        }
        let start = |part: usize| (part as f64 * lines / count as f64).floor();
        let each = (0..count).map(|part| {
            let wide = start(part + 1) - start(part);
            first + start(part) + (random.uniform() * wide).floor()
        });
        each.collect()
    }

    /// From the lowest frequency to the highest \[rad/s\].
    #[must_use]
    pub fn edges(&self) -> (f64, f64) {
        let half = self.middle * self.half_width;
        (self.middle - half, self.middle + half)
    }
}

/// Second and fourth moment of a flat band about no frequency, in powers of its middle.
fn shape(half_width: f64) -> (f64, f64) {
    let q = half_width * half_width;
    (1.0 + q / 3.0, 1.0 + 2.0 * q + q * q / 5.0)
}

/// The bands of a motion, none for one that does not move. `slow_period` \[s\] is that of the slow band, where one is
/// needed.
///
/// # Errors
/// [`SpectralBandError`].
pub fn bands(scatter: MotionRms, slow_period: f64) -> Result<Vec<SpectralBand>, SpectralBandError> {
    let [m0, m2, m4] =
        [scatter.displacement, scatter.velocity, scatter.acceleration].map(|s| s * s);
    if m0 + m2 + m4 <= 0.0 {
        return Ok(Vec::new());
    }
    if m0 <= 0.0 || m2 <= 0.0 || m4 <= 0.0 {
        return Err(SpectralBandError::Part);
    }
    let spread = m0 * m4 / (m2 * m2);
    if spread < (1.0 - ROUNDING).powi(2) {
        return Err(SpectralBandError::Impossible {
            velocity2: m2,
            product: (m0 * m4).sqrt(),
        });
    }
    let (second, fourth) = shape(WIDEST);
    if spread <= fourth / (second * second) {
        return Ok(vec![one_band(m0, m2, spread)]);
    }
    two_bands(m0, m2, m4, TAU / slow_period)
}

/// One band as wide as the moments ask; one frequency where they are as narrow as can be.
fn one_band(m0: f64, m2: f64, spread: f64) -> SpectralBand {
    // (1 + 2q + q²/5) = spread (1 + q/3)², for the square q of the half width.
    let (a, b, c) = (0.2 - spread / 9.0, 2.0 - 2.0 * spread / 3.0, 1.0 - spread);
    let q = (-2.0 * c / (b + (b * b - 4.0 * a * c).max(0.0).sqrt())).max(0.0);
    let half_width = q.sqrt().max(1e-3);
    let (second, _) = shape(half_width);
    SpectralBand {
        variance: m0,
        middle: (m2 / (m0 * second)).sqrt(),
        half_width,
    }
}

/// A slow band about a frequency, and a band of waves that takes what is left of the moments.
fn two_bands(m0: f64, m2: f64, m4: f64, slow: f64) -> Result<Vec<SpectralBand>, SpectralBandError> {
    let (second, fourth) = shape(USUAL);
    let s2 = slow * slow;
    let too_fast = SpectralBandError::Slow {
        shortest: TAU * (m0 * second / m2).sqrt(),
    };
    let a = m2 / second - m0 * s2;
    let b = m4 / fourth - m0 * s2 * s2;
    if a <= 0.0 || b <= 0.0 {
        return Err(too_fast);
    }
    // With V of the variance in waves of frequency w: a = V (w² - s²), b = V (w⁴ - s⁴).
    let w2 = b / a - s2;
    let variance = a / (w2 - s2);
    let apart = slow * (1.0 + USUAL) < w2.max(0.0).sqrt() * (1.0 - USUAL);
    if !apart || variance > m0 {
        return Err(too_fast);
    }
    let band = |variance: f64, middle: f64| SpectralBand {
        variance,
        middle,
        half_width: USUAL,
    };
    Ok(vec![band(m0 - variance, slow), band(variance, w2.sqrt())])
}

/// Motion of components: the root mean squares of an endless record.
#[must_use]
pub fn scatter(components: &[Component]) -> MotionRms {
    let moments = Moments::of(components);
    let fourth = components
        .iter()
        .map(|c| 0.5 * (c.amplitude * c.omega * c.omega).powi(2));
    MotionRms {
        displacement: moments.m0.sqrt(),
        velocity: moments.m2.sqrt(),
        acceleration: fourth.sum::<f64>().sqrt(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of(bands: &[SpectralBand]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for band in bands {
            for (s, m) in sum.iter_mut().zip(band.moments()) {
                *s += m;
            }
        }
        sum.map(f64::sqrt)
    }

    #[test]
    fn narrow_wide_and_slow_motions_have_their_moments() {
        for (x, v, a, slow) in [
            (0.04797, 0.06232, 0.08809, 100.0),
            (0.4093, 0.08904, 0.1153, 100.0),
            (1.0, 2.0, 4.0001, 100.0),
        ] {
            let scatter = MotionRms {
                displacement: x,
                velocity: v,
                acceleration: a,
            };
            let found = of(&bands(scatter, slow).unwrap());
            for (f, e) in found.iter().zip([x, v, a]) {
                assert!((f / e - 1.0).abs() < 1e-6, "{found:?} {x} {v} {a}");
            }
        }
    }

    #[test]
    fn what_no_motion_has_is_refused() {
        let with = |displacement, velocity, acceleration, slow| {
            bands(
                MotionRms {
                    displacement,
                    velocity,
                    acceleration,
                },
                slow,
            )
        };
        assert_eq!(with(0.0, 0.0, 0.0, 9.0), Ok(Vec::new()));
        assert_eq!(with(1.0, 0.0, 1.0, 9.0), Err(SpectralBandError::Part));
        assert!(matches!(
            with(1.0, 2.0, 1.0, 9.0),
            Err(SpectralBandError::Impossible { .. })
        ));
        let slow = with(1.0, 0.1, 0.1, 30.0).unwrap_err();
        let SpectralBandError::Slow { shortest } = slow else {
            panic!("{slow}")
        };
        assert!(with(1.0, 0.1, 0.1, 1.001 * shortest).is_ok());
    }

    #[test]
    fn components_have_the_moments_of_their_band_and_repeat_with_the_record() {
        for (middle, half_width, count) in [(1.3, 0.5, 100), (0.06, 0.3, 100), (0.8, 1e-3, 100)] {
            let band = SpectralBand {
                variance: 2.0,
                middle,
                half_width,
            };
            for seed in 0..20 {
                let components = band.components(count, 10_800.0, seed, 3);
                let turns = |c: &Component| c.omega * 10_800.0 / TAU;
                assert!(
                    components
                        .iter()
                        .all(|c| (turns(c) - turns(c).round()).abs() < 1e-9)
                );
                assert!(
                    components
                        .windows(2)
                        .all(|pair| pair[0].omega < pair[1].omega)
                );
                let made = scatter(&components);
                let asked = band.moments().map(f64::sqrt);
                let made = [made.displacement, made.velocity, made.acceleration];
                for (m, a) in made.iter().zip(asked) {
                    assert!((m / a - 1.0).abs() < 8e-3, "{made:?} {asked:?}");
                }
            }
        }
    }

    proptest! {
        #[test]
        fn bands_have_the_moments_or_say_why_not(
            x in 1e-3..10.0f64, v in 1e-3..10.0f64, a in 1e-3..10.0f64, slow in 1.0..500.0f64,
        ) {
            let scatter = MotionRms { displacement: x, velocity: v, acceleration: a };
            if let Ok(bands) = bands(scatter, slow) {
                let found = of(&bands);
                // Narrower than possible by rounding: the acceleration gives way.
                for (f, e) in found.iter().zip([x, v, a]) {
                    prop_assert!((f / e - 1.0).abs() < 1.1e-2, "{found:?}");
                }
                for band in bands {
                    prop_assert!(band.variance >= 0.0 && band.edges().0 > 0.0);
                }
            }
        }
    }
}
