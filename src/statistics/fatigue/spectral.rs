//! Damage by the moments of a tension spectrum, for Gaussian tensions: narrow band, Dirlik, Tovo and Benasciutti.
//!
//! With `m_n = ∫ f^n S(f) df`: crossings of the mean upwards `ν0 = √(m2/m0)`, crests `νp = √(m4/m2)`,
//! `α1 = m1/√(m0 m2)`, `α2 = m2/√(m0 m4)`.

use super::closed_form::{narrow_band_scale, weibull_damage};
use super::component::FatigueComponent;
use super::curve::CurveError;

/// Why a spectrum gives no damage.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SpectralError {
    /// Frequencies and densities differ in number, or are fewer than two.
    #[error(
        "the spectrum has {frequencies} frequencies and {densities} densities; it needs two or more of both, as many of each"
    )]
    Lengths {
        /// Number of frequencies.
        frequencies: usize,
        /// Number of densities.
        densities: usize,
    },
    /// A point of the spectrum that cannot be.
    #[error(
        "point {index} of the spectrum has {frequency} Hz and the density {density}; frequencies rise from zero, densities are finite and not negative"
    )]
    Point {
        /// Its place, from zero.
        index: usize,
        /// Its frequency, Hz.
        frequency: f64,
        /// Its density.
        density: f64,
    },
    /// Moments that no spectrum has.
    #[error(
        "the moments {0:?} are those of no spectrum: all are positive and finite, m1² <= m0 m2 and m2² <= m0 m4"
    )]
    Moments([f64; 4]),
    /// The curve refuses.
    #[error(transparent)]
    Curve(#[from] CurveError),
}

/// Moments m0, m1, m2, m4 of a one-sided spectrum of tension, N² Hzⁿ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TensionMoments {
    m0: f64,
    m1: f64,
    m2: f64,
    m4: f64,
}

impl TensionMoments {
    /// Of a spectrum by the trapezoidal rule: frequencies in Hz, densities in N²/Hz.
    ///
    /// # Errors
    /// Lengths that differ; frequencies that do not rise from zero or more; densities that are negative or not finite; a
    /// spectrum without energy.
    pub fn of_spectrum(frequencies: &[f64], densities: &[f64]) -> Result<Self, SpectralError> {
        let (n, d) = (frequencies.len(), densities.len());
        if n != d || n < 2 {
            return Err(SpectralError::Lengths {
                frequencies: n,
                densities: d,
            });
        }
        let mut sums = [0.0; 4];
        let mut before: Option<(f64, f64)> = None;
        for (index, (&frequency, &density)) in frequencies.iter().zip(densities).enumerate() {
            let rises = before.map_or(frequency >= 0.0, |(last, _)| frequency > last);
            let is_good = frequency.is_finite() && density.is_finite() && density >= 0.0;
            if !(rises && is_good) {
                return Err(SpectralError::Point {
                    index,
                    frequency,
                    density,
                });
            }
            if let Some((last, last_density)) = before {
                for (sum, power) in sums.iter_mut().zip([0, 1, 2, 4]) {
                    let ends = last.powi(power) * last_density + frequency.powi(power) * density;
                    *sum += 0.5 * (frequency - last) * ends;
                }
            }
            before = Some((frequency, density));
        }
        let [m0, m1, m2, m4] = sums;
        Self::new(m0, m1, m2, m4)
    }

    /// Of given moments.
    ///
    /// # Errors
    /// Moments that are not positive and finite or break the inequality of Cauchy and Schwarz.
    pub fn new(m0: f64, m1: f64, m2: f64, m4: f64) -> Result<Self, SpectralError> {
        let moments = Self { m0, m1, m2, m4 };
        let is_positive = [m0, m1, m2, m4].iter().all(|m| *m > 0.0 && m.is_finite());
        let derived = [
            moments.crossing_rate(),
            moments.crest_rate(),
            moments.deviation(),
        ];
        let (a, b) = (moments.alpha1(), moments.alpha2());
        let limit = 1.0 + 1e-9;
        let is_spectrum = a > 0.0 && a <= limit && b > 0.0 && b <= limit;
        if is_positive && is_spectrum && derived.iter().all(|v| *v > 0.0 && v.is_finite()) {
            Ok(moments)
        } else {
            Err(SpectralError::Moments([m0, m1, m2, m4]))
        }
    }

    /// Standard deviation, N.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.m0.sqrt()
    }

    /// Upward crossings of the mean in a second, ν0.
    #[must_use]
    pub fn crossing_rate(&self) -> f64 {
        (self.m2 / self.m0).sqrt()
    }

    /// Crests in a second, νp.
    #[must_use]
    pub fn crest_rate(&self) -> f64 {
        (self.m4 / self.m2).sqrt()
    }

    /// α1: 1 for the narrowest band.
    #[must_use]
    pub fn alpha1(&self) -> f64 {
        self.m1 / self.m0.sqrt() / self.m2.sqrt()
    }

    /// α2, the irregularity factor ν0/νp: 1 for the narrowest band.
    #[must_use]
    pub fn alpha2(&self) -> f64 {
        self.m2 / self.m0.sqrt() / self.m4.sqrt()
    }

    /// Damage in a second as if the band were narrow, about a mean tension in N: an upper estimate for a broad band.
    ///
    /// # Errors
    /// What the curve refuses.
    pub fn narrow_band(
        &self,
        component: &FatigueComponent,
        mean: f64,
    ) -> Result<f64, SpectralError> {
        let scale = narrow_band_scale(self.deviation());
        Ok(self.crossing_rate() * weibull_damage(component, scale, 2.0, mean)?)
    }

    /// Damage in a second by Tovo and Benasciutti: `b` of the level-crossing count and `1 - b` of the range count
    /// (Benasciutti and Tovo, Int. J. Fatigue 27 (2005) 867; `b` is the second of their approximations).
    ///
    /// # Errors
    /// What the curve refuses.
    pub fn tovo_benasciutti(
        &self,
        component: &FatigueComponent,
        mean: f64,
    ) -> Result<f64, SpectralError> {
        let weight = self.level_crossing_weight();
        let narrower = narrow_band_scale(self.deviation() * self.alpha2());
        let ranges = self.crest_rate() * weibull_damage(component, narrower, 2.0, mean)?;
        Ok(weight * self.narrow_band(component, mean)? + (1.0 - weight) * ranges)
    }

    /// b of Tovo and Benasciutti, between 0 and 1.
    fn level_crossing_weight(&self) -> f64 {
        let (a1, a2) = (self.alpha1(), self.alpha2());
        let (difference, width) = (a1 - a2, (1.0 - a2).powi(2));
        if width < 1e-12 {
            // Both counts are the same in the narrowest band.
            return 1.0;
        }
        let product = 1.112 * (1.0 + a1 * a2 - (a1 + a2)) * (2.11 * a2).exp() + difference;
        (difference * product / width).clamp(0.0, 1.0)
    }

    /// Damage in a second by Dirlik's law of the ranges, an exponential and two Rayleigh laws (Dirlik, PhD thesis, University
    /// of Warwick, 1985). `None` where its weights are no numbers: in the narrowest band, where [`Self::narrow_band`] holds.
    ///
    /// # Errors
    /// What the curve refuses.
    pub fn dirlik(
        &self,
        component: &FatigueComponent,
        mean: f64,
    ) -> Result<Option<f64>, SpectralError> {
        let Some(law) = self.dirlik_law() else {
            return Ok(None);
        };
        let (half, rayleigh) = (2.0 * self.deviation(), narrow_band_scale(self.deviation()));
        let exponential = weibull_damage(component, half * law.q, 1.0, mean)?;
        let small = weibull_damage(component, rayleigh * law.r, 2.0, mean)?;
        let large = weibull_damage(component, rayleigh, 2.0, mean)?;
        let [d1, d2, d3] = law.weights;
        let damage = self.crest_rate() * (d1 * exponential + d2 * small + d3 * large);
        Ok(Some(damage).filter(|damage| damage.is_finite() && *damage >= 0.0))
    }

    fn dirlik_law(&self) -> Option<DirlikLaw> {
        let gamma = self.alpha2();
        let x = self.m1 / self.m0 * (self.m2 / self.m4).sqrt();
        let d1 = 2.0 * (x - gamma * gamma) / (1.0 + gamma * gamma);
        let r = (gamma - x - d1 * d1) / (1.0 - gamma - d1 + d1 * d1);
        let d2 = (1.0 - gamma - d1 + d1 * d1) / (1.0 - r);
        let d3 = 1.0 - d1 - d2;
        let q = 1.25 * (gamma - d3 - d2 * r) / d1;
        let all = [d1, d2, d3, q, r];
        let is_law = all.iter().all(|v| v.is_finite()) && q > 0.0;
        is_law.then_some(DirlikLaw {
            weights: [d1, d2, d3],
            q,
            r: r.abs(),
        })
    }
}

/// Dirlik's law: weights D1, D2, D3 and the scales Q and R.
struct DirlikLaw {
    weights: [f64; 3],
    q: f64,
    r: f64,
}

#[cfg(test)]
mod tests;
