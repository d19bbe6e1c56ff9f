//! A random motion with given root mean squares of displacement, velocity and acceleration.
//!
//! The three are the square roots of the spectral moments m0, m2 and m4. The simplest spectrum with these moments is constant
//! over a band of frequencies; where the moments are wider than a band of waves can be, as for a ship with slow-drift motion at
//! its mooring, a low-frequency band beside the wave-frequency band. The shape beyond the three moments is an assumption.

use std::f64::consts::TAU;

use crate::numerics::random::Random;
use crate::physics::sea::{Component, Moments};

/// Root mean squares of a motion about its mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionRms {
    /// Of the displacement.
    pub displacement: f64,
    /// Of the velocity, per second.
    pub velocity: f64,
    /// Of the acceleration, per second squared.
    pub acceleration: f64,
}

/// A spectrum that is constant over a band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralBand {
    /// Variance of the displacement.
    pub variance: f64,
    /// Centre frequency \[rad/s\].
    pub middle: f64,
    /// Half width relative to the centre frequency \[-\].
    pub half_width: f64,
}

/// Why no bands have given root mean squares.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SpectralBandError {
    /// Some root mean squares are zero, others are not.
    #[error("displacement, velocity and acceleration must be all zero or all positive")]
    Mixed,
    /// They violate the Cauchy-Schwarz inequality m2² <= m0 m4.
    #[error(
        "no motion has these root mean squares: the square of the velocity, {velocity2:.4e}, exceeds displacement times acceleration, {product:.4e}"
    )]
    Impossible {
        /// Mean square velocity.
        velocity2: f64,
        /// Displacement times acceleration.
        product: f64,
    },
    /// The low-frequency band is too close to the wave-frequency band.
    #[error(
        "slow_period_s is too short for these root mean squares; more than {shortest:.4} s is needed"
    )]
    Slow {
        /// Lower limit of the slow period \[s\].
        shortest: f64,
    },
}

/// Half width of the widest wave-frequency band, relative to its centre.
const MAX_HALF_WIDTH: f64 = 0.6;

/// Half width of each of two bands, relative to its centre.
const HALF_WIDTH: f64 = 0.3;

/// Violation of the inequality that rounding of published numbers explains.
const ROUNDING: f64 = 0.01;

impl SpectralBand {
    /// Variances of displacement, velocity and acceleration.
    #[must_use]
    pub fn moments(&self) -> [f64; 3] {
        let (second, fourth) = relative_moments(self.half_width);
        let w2 = self.middle * self.middle;
        [1.0, second * w2, fourth * w2 * w2].map(|m| m * self.variance)
    }

    /// At most `count` regular components of equal energy and random phase, for a record of this duration \[s\]. Their
    /// frequencies are multiples of that of the record, one drawn from each part of the band, or all of them, so that the
    /// variances of the record and of its derivatives are those of the band. The record is periodic.
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

    /// Frequencies of the components as multiples of `line`.
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

    /// Lowest and highest frequency \[rad/s\].
    #[must_use]
    pub fn edges(&self) -> (f64, f64) {
        let half = self.middle * self.half_width;
        (self.middle - half, self.middle + half)
    }
}

/// Second and fourth spectral moment of a constant band of unit variance, in powers of its centre frequency.
fn relative_moments(half_width: f64) -> (f64, f64) {
    let q = half_width * half_width;
    (1.0 + q / 3.0, 1.0 + 2.0 * q + q * q / 5.0)
}

/// The bands of a motion, none where all root mean squares are zero. `slow_period` \[s\] is that of the low-frequency band,
/// where one is needed.
///
/// # Errors
/// [`SpectralBandError`].
pub fn fit_bands(rms: MotionRms, slow_period: f64) -> Result<Vec<SpectralBand>, SpectralBandError> {
    let [m0, m2, m4] = [rms.displacement, rms.velocity, rms.acceleration].map(|s| s * s);
    if m0 + m2 + m4 <= 0.0 {
        return Ok(Vec::new());
    }
    if m0 <= 0.0 || m2 <= 0.0 || m4 <= 0.0 {
        return Err(SpectralBandError::Mixed);
    }
    let spread = m0 * m4 / (m2 * m2);
    if spread < (1.0 - ROUNDING).powi(2) {
        return Err(SpectralBandError::Impossible {
            velocity2: m2,
            product: (m0 * m4).sqrt(),
        });
    }
    let (second, fourth) = relative_moments(MAX_HALF_WIDTH);
    if spread <= fourth / (second * second) {
        return Ok(vec![one_band(m0, m2, spread)]);
    }
    two_bands(m0, m2, m4, TAU / slow_period)
}

/// One band of the width that the moments require.
fn one_band(m0: f64, m2: f64, spread: f64) -> SpectralBand {
    // (1 + 2q + q²/5) = spread (1 + q/3)², for the square q of the half width.
    let (a, b, c) = (0.2 - spread / 9.0, 2.0 - 2.0 * spread / 3.0, 1.0 - spread);
    let q = (-2.0 * c / (b + (b * b - 4.0 * a * c).max(0.0).sqrt())).max(0.0);
    let half_width = q.sqrt().max(1e-3);
    let (second, _) = relative_moments(half_width);
    SpectralBand {
        variance: m0,
        middle: (m2 / (m0 * second)).sqrt(),
        half_width,
    }
}

/// A low-frequency band about `slow` \[rad/s\], and a wave-frequency band with the rest of the moments.
fn two_bands(m0: f64, m2: f64, m4: f64, slow: f64) -> Result<Vec<SpectralBand>, SpectralBandError> {
    let (second, fourth) = relative_moments(HALF_WIDTH);
    let s2 = slow * slow;
    let too_fast = SpectralBandError::Slow {
        shortest: TAU * (m0 * second / m2).sqrt(),
    };
    let a = m2 / second - m0 * s2;
    let b = m4 / fourth - m0 * s2 * s2;
    if a <= 0.0 || b <= 0.0 {
        return Err(too_fast);
    }
    // With variance V at wave frequency w: a = V (w² - s²), b = V (w⁴ - s⁴).
    let w2 = b / a - s2;
    let variance = a / (w2 - s2);
    let separate = slow * (1.0 + HALF_WIDTH) < w2.max(0.0).sqrt() * (1.0 - HALF_WIDTH);
    if !separate || variance > m0 {
        return Err(too_fast);
    }
    let band = |variance: f64, middle: f64| SpectralBand {
        variance,
        middle,
        half_width: HALF_WIDTH,
    };
    Ok(vec![band(m0 - variance, slow), band(variance, w2.sqrt())])
}

/// Root mean squares of components, over an infinite record.
#[must_use]
pub fn rms_of(components: &[Component]) -> MotionRms {
    let moments = Moments::of_components(components);
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
            let rms = MotionRms {
                displacement: x,
                velocity: v,
                acceleration: a,
            };
            let found = of(&fit_bands(rms, slow).unwrap());
            for (f, e) in found.iter().zip([x, v, a]) {
                assert!((f / e - 1.0).abs() < 1e-6, "{found:?} {x} {v} {a}");
            }
        }
    }

    #[test]
    fn impossible_root_mean_squares_are_errors() {
        let with = |displacement, velocity, acceleration, slow| {
            fit_bands(
                MotionRms {
                    displacement,
                    velocity,
                    acceleration,
                },
                slow,
            )
        };
        assert_eq!(with(0.0, 0.0, 0.0, 9.0), Ok(Vec::new()));
        assert_eq!(with(1.0, 0.0, 1.0, 9.0), Err(SpectralBandError::Mixed));
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
                let cycles = |c: &Component| c.omega * 10_800.0 / TAU;
                assert!(
                    components
                        .iter()
                        .all(|c| (cycles(c) - cycles(c).round()).abs() < 1e-9)
                );
                assert!(
                    components
                        .windows(2)
                        .all(|pair| pair[0].omega < pair[1].omega)
                );
                let made = rms_of(&components);
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
        fn fitted_bands_have_the_moments(
            x in 1e-3..10.0f64, v in 1e-3..10.0f64, a in 1e-3..10.0f64, slow in 1.0..500.0f64,
        ) {
            let rms = MotionRms { displacement: x, velocity: v, acceleration: a };
            if let Ok(bands) = fit_bands(rms, slow) {
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
