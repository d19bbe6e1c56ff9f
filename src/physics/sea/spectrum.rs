//! The spectra of Pierson and Moskowitz (1964) and of JONSWAP (Hasselmann et al. 1973).
//!
//! Both in the form by significant height and peak period (DNV-RP-C205, section 3.5.5):
//! `S(omega) = C 5 omega_p^4 / omega^5 exp(-5/4 (omega_p/omega)^4) gamma^r`, with
//! `r = exp(-1/2 ((omega/omega_p - 1) / sigma)²)`, sigma 0.07 below the peak and 0.09 above it. C makes the
//! variance exactly what it is asked to be: it is integrated, where the usual formula for it is a fit.
//!
//! # The variable of integration
//! With `u = exp(-5/4 (omega_p/omega)^4)`, the share of a Pierson-Moskowitz spectrum below omega, the energy in
//! du is `C gamma^r du`. So what has to be integrated and sampled lies between 1 and gamma, and is smooth.

use std::f64::consts::TAU;

use crate::numerics::interpolation::{self, interval};

use super::Moments;

/// Frequencies above this many times the peak are left out: their share is 0.2 % of the energy or less, and their
/// accelerations would grow without bound.
const CUT: f64 = 5.0;
/// Intervals of the cumulated energy.
const INTERVALS: usize = 8192;

/// How the variance of a record is spread over frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spectrum {
    /// Variance \[unit²\], all of it below the cut at five times the peak.
    pub variance: f64,
    /// Angular frequency of the peak \[rad/s\].
    pub peak: f64,
    /// Peak enhancement gamma \[-\], 1 for Pierson-Moskowitz.
    pub gamma: f64,
}

impl Spectrum {
    /// JONSWAP of a significant height (of crest above trough) and a peak period \[s\].
    #[must_use]
    pub fn jonswap(significant_height: f64, peak_period: f64, gamma: f64) -> Self {
        Self::of_rms(0.25 * significant_height, peak_period, gamma)
    }

    /// Pierson-Moskowitz of a significant height and a peak period \[s\].
    #[must_use]
    pub fn pierson_moskowitz(significant_height: f64, peak_period: f64) -> Self {
        Self::jonswap(significant_height, peak_period, 1.0)
    }

    /// A record of which only the root mean square about its mean and the peak period \[s\] are known, such as
    /// the published statistics of a motion: JONSWAP of that variance.
    #[must_use]
    pub fn of_rms(rms: f64, peak_period: f64, gamma: f64) -> Self {
        Self {
            variance: rms * rms,
            peak: TAU / peak_period,
            gamma,
        }
    }

    /// Density \[unit² s/rad\] at an angular frequency \[rad/s\].
    #[must_use]
    pub fn density(&self, omega: f64) -> f64 {
        if omega <= 0.0 || omega > CUT * self.peak {
            return 0.0;
        }
        let ratio = self.peak / omega;
        let moskowitz = 5.0 * ratio.powi(4) / omega * share_below(ratio);
        self.variance / self.whole() * moskowitz * self.enhancement(omega)
    }

    /// Variance and variance of the rate of change.
    #[must_use]
    pub fn moments(&self) -> Moments {
        let [square] = self.integrals(|omega| [omega * omega]);
        Moments {
            m0: self.variance,
            m2: square,
        }
    }

    /// Integrals of the density times functions of angular frequency \[rad/s\], such as the square of a response.
    #[must_use]
    pub fn integrals<const N: usize>(&self, of: impl Fn(f64) -> [f64; N]) -> [f64; N] {
        let energy = self.cumulated();
        let whole = energy[INTERVALS];
        let width = 1.0 / INTERVALS as f64;
        let mut sums = [0.0; N];
        for (i, pair) in energy.windows(2).enumerate() {
            let omega = self.frequency((i as f64 + 0.5) * width * limit());
            let share = (pair[1] - pair[0]) / whole * self.variance;
            for (sum, value) in sums.iter_mut().zip(of(omega)) {
                *sum += share * value;
            }
        }
        sums
    }

    /// The frequencies \[rad/s\] below which these shares of the energy lie, each from 0 to 1 and in rising order.
    pub(super) fn quantiles(&self, shares: impl Iterator<Item = f64>) -> Vec<f64> {
        let energy = self.cumulated();
        let whole = energy[INTERVALS];
        let at = |share: f64| {
            let wanted = share * whole;
            let i = interval(&energy, wanted);
            let u = (i as f64 + interpolation::share(&energy, i, wanted)) / INTERVALS as f64;
            self.frequency(u * limit())
        };
        shares.map(at).collect()
    }

    /// Energy from nothing up to each of the equal steps in u, not yet scaled by C.
    fn cumulated(&self) -> Vec<f64> {
        let width = limit() / INTERVALS as f64;
        let mut sum = 0.0;
        let mut list = vec![0.0];
        list.extend((0..INTERVALS).map(|i| {
            let omega = self.frequency((i as f64 + 0.5) * width);
            sum += width * self.enhancement(omega);
            sum
        }));
        list
    }

    fn whole(&self) -> f64 {
        self.cumulated()[INTERVALS]
    }

    /// `gamma^r`.
    fn enhancement(&self, omega: f64) -> f64 {
        let sigma = if omega <= self.peak { 0.07 } else { 0.09 };
        let off = (omega / self.peak - 1.0) / sigma;
        self.gamma.powf((-0.5 * off * off).exp())
    }

    /// The frequency below which the share u of a Pierson-Moskowitz spectrum lies.
    fn frequency(&self, u: f64) -> f64 {
        self.peak * (1.25 / -u.ln()).powf(0.25)
    }
}

/// Share of a Pierson-Moskowitz spectrum below `omega_p / ratio`.
fn share_below(ratio: f64) -> f64 {
    (-1.25 * ratio.powi(4)).exp()
}

/// That share at the cut.
fn limit() -> f64 {
    share_below(1.0 / CUT)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integral of `omega^power S` by the midpoint rule over omega.
    fn moment(spectrum: &Spectrum, power: i32) -> f64 {
        let n = 20_000;
        let width = CUT * spectrum.peak / f64::from(n);
        let whole = spectrum.whole();
        let at = |i: i32| {
            let omega = (f64::from(i) + 0.5) * width;
            let ratio = spectrum.peak / omega;
            let s = 5.0 * ratio.powi(4) / omega * share_below(ratio) * spectrum.enhancement(omega);
            omega.powi(power) * s * spectrum.variance / whole
        };
        (0..n).map(|i| at(i) * width).sum()
    }

    #[test]
    fn the_variance_is_the_one_asked_for() {
        for gamma in [1.0, 3.3, 7.0] {
            let spectrum = Spectrum::jonswap(4.0, 9.0, gamma);
            assert!((moment(&spectrum, 0) - 1.0).abs() < 1e-6);
            assert!((spectrum.moments().significant_height() - 4.0).abs() < 1e-12);
            let m2 = spectrum.moments().m2;
            assert!((moment(&spectrum, 2) / m2 - 1.0).abs() < 1e-4);
        }
    }

    #[test]
    fn pierson_moskowitz_is_the_closed_form() {
        // 5/16 Hs² omega_p^4 / omega^5 exp(...), where the cut leaves out 0.2 %.
        let spectrum = Spectrum::pierson_moskowitz(3.0, 10.0);
        let (p, omega) = (spectrum.peak, 0.8);
        let printed = 5.0 / 16.0 * 9.0 * p.powi(4) / f64::powi(omega, 5)
            * (-1.25 * (p / omega).powi(4)).exp();
        assert!((spectrum.density(omega) * limit() / printed - 1.0).abs() < 1e-9);
        // Mean crossing period 0.710 Tp without the cut (DNV-RP-C205), which takes away rapid waves.
        let ratio = spectrum.moments().crossing_period() / 10.0;
        assert!((0.71..0.73).contains(&ratio), "{ratio}");
    }

    #[test]
    fn the_normalisation_is_near_the_usual_fit() {
        // 1 - 0.287 ln(gamma), DNV-RP-C205, said to be good between gamma 1 and 7.
        for gamma in [1.0, 2.0, 3.3, 5.0] {
            let fit = 1.0 - 0.287 * f64::ln(gamma);
            let own = limit() / Spectrum::jonswap(1.0, 1.0, gamma).whole();
            assert!((own - fit).abs() < 0.01, "{gamma}: {own} {fit}");
        }
    }
}
