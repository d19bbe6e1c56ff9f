//! A motion in space as a sum of harmonics, with its velocity and acceleration.

use nalgebra::Complex;

use super::{Component, Moments};
use crate::numerics::V3;

/// One harmonic along three axes: `cosine cos(omega t) + sine sin(omega t)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// Angular frequency \[rad/s\].
    pub omega: f64,
    /// In phase with the cosine, along x, y, z \[m\].
    pub cosine: V3,
    /// In phase with the sine \[m\].
    pub sine: V3,
}

/// A sum of harmonics about nothing.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Harmonics {
    /// The terms.
    pub terms: Vec<Harmonic>,
}

impl Harmonics {
    /// Independent records along x, y, z \[m\].
    #[must_use]
    pub fn along_axes(axes: &[Vec<Component>; 3]) -> Self {
        let unit = [V3::x(), V3::y(), V3::z()];
        let terms = axes.iter().zip(unit).flat_map(|(record, axis)| {
            record.iter().map(move |c| Harmonic {
                omega: c.omega,
                cosine: axis * (c.amplitude * c.phase.cos()),
                sine: axis * (-c.amplitude * c.phase.sin()),
            })
        });
        Self {
            terms: terms.collect(),
        }
    }

    /// From complex amplitudes A along x, y, z, `Re(A exp(i omega t))`, by frequency.
    #[must_use]
    pub fn of_amplitudes(list: impl IntoIterator<Item = (f64, [Complex<f64>; 3])>) -> Self {
        let term = |(omega, a): (f64, [Complex<f64>; 3])| Harmonic {
            omega,
            cosine: V3::new(a[0].re, a[1].re, a[2].re),
            sine: V3::new(-a[0].im, -a[1].im, -a[2].im),
        };
        Self {
            terms: list.into_iter().map(term).collect(),
        }
    }

    /// The sum of several.
    #[must_use]
    pub fn sum(parts: impl IntoIterator<Item = Self>) -> Self {
        let terms = parts.into_iter().flat_map(|part| part.terms);
        Self {
            terms: terms.collect(),
        }
    }

    /// Displacement \[m\], velocity \[m/s\] and acceleration \[m/s²\] at time t \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> (V3, V3, V3) {
        let (mut x, mut v, mut a) = (V3::zeros(), V3::zeros(), V3::zeros());
        for term in &self.terms {
            let (sin, cos) = (term.omega * t).sin_cos();
            let here = term.cosine * cos + term.sine * sin;
            x += here;
            v += (term.sine * cos - term.cosine * sin) * term.omega;
            a -= here * (term.omega * term.omega);
        }
        (x, v, a)
    }

    /// The angular frequency \[rad/s\] below which half of the mean square acceleration lies; nothing without terms. The
    /// terms may stand in any order.
    #[must_use]
    pub fn middle_of_acceleration(&self) -> Option<f64> {
        let share = |h: &Harmonic| {
            let square = h.cosine.norm_squared() + h.sine.norm_squared();
            (h.omega, square * h.omega.powi(4))
        };
        let mut shares: Vec<(f64, f64)> = self.terms.iter().map(share).collect();
        shares.sort_by(|a, b| a.0.total_cmp(&b.0));
        let half = 0.5 * shares.iter().map(|s| s.1).sum::<f64>();
        let mut sum = 0.0;
        let reaches = |s: &&(f64, f64)| {
            sum += s.1;
            sum >= half
        };
        shares.iter().find(reaches).map(|s| s.0)
    }

    /// Whether all terms have the same period.
    #[must_use]
    pub fn has_one_period(&self) -> bool {
        let same = |pair: &[Harmonic]| pair[0].omega.to_bits() == pair[1].omega.to_bits();
        self.terms.windows(2).all(same)
    }

    /// Spectral moments of the displacement along all axes together, of an endless record.
    #[must_use]
    pub fn moments(&self) -> Moments {
        let mut sum = Moments::default();
        for term in &self.terms {
            let energy = 0.5 * (term.cosine.norm_squared() + term.sine.norm_squared());
            sum.m0 += energy;
            sum.m2 += energy * term.omega * term.omega;
        }
        sum
    }

    /// Root mean square displacement along x, y, z \[m\] of an endless record (no two terms of one axis of the same
    /// frequency).
    #[must_use]
    pub fn rms(&self) -> V3 {
        let square = |h: &Harmonic| {
            (h.cosine.component_mul(&h.cosine) + h.sine.component_mul(&h.sine)) * 0.5
        };
        let sum: V3 = self.terms.iter().map(square).sum();
        sum.map(f64::sqrt)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sea::{Spectrum, synthesise};

    #[test]
    fn rates_are_derivatives_and_the_rms_is_the_one_asked_for() {
        let rms = [0.8, 0.3, 0.5];
        let record = |axis: usize| {
            let spectrum = Spectrum::of_rms(rms[axis], 11.0, 3.3);
            synthesise(&spectrum, 40, 9, axis as u64)
        };
        let motion = Harmonics::along_axes(&[record(0), record(1), record(2)]);
        assert!((motion.rms() - V3::from(rms)).norm() < 1e-12);
        let all = Moments::of_components(&[record(0), record(1), record(2)].concat());
        let moments = motion.moments();
        assert!((moments.m0 - all.m0).abs() < 1e-12 && (moments.m2 - all.m2).abs() < 1e-12);
        let (t, h) = (31.0, 1e-4);
        let (before, now, after) = (motion.at(t - h), motion.at(t), motion.at(t + h));
        assert!(((after.0 - before.0) / (2.0 * h) - now.1).norm() < 1e-7);
        assert!(((after.1 - before.1) / (2.0 * h) - now.2).norm() < 1e-7);
        let first: f64 = record(0).iter().map(|c| c.at(t)).sum();
        assert!((first - now.0.x).abs() < 1e-12);
    }
}
