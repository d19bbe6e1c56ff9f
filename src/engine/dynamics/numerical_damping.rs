//! Numerical damping and period elongation of generalized-alpha.

use nalgebra::Matrix3;

/// Numerical damping and period elongation of an undamped free oscillation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NumericalDamping {
    /// Damping ratio \[-\]; 1 if the method does not oscillate.
    pub damping: f64,
    /// Relative elongation of the period \[-\].
    pub elongation: f64,
}

impl NumericalDamping {
    /// Of an oscillator of angular frequency omega \[rad/s\] in steps of h \[s\], rho the spectral radius at infinite
    /// frequency.
    ///
    /// The amplification matrix of (x, h v, h² a) follows from the formulas of Chung and Hulbert 1993
    /// (doi 10.1115/1.2900803), eqs 9 to 12; the greater of its complex pair of eigenvalues, `exp(-zeta w h + i w h)`, gives
    /// `zeta = -ln|l| / sqrt(ln²|l| + arg² l)` and a period of `2 pi h / arg l`.
    #[must_use]
    pub fn of_oscillator(rho: f64, omega: f64, h: f64) -> Self {
        let (alpha_m, alpha_f) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
        let gamma = 0.5 - alpha_m + alpha_f;
        let beta = 0.25 * (1.0 - alpha_m + alpha_f).powi(2);
        let w = (omega * h).powi(2);
        // h² a1 = p x0 + q h v0 + r h² a0
        let d = 1.0 - alpha_m + w * (1.0 - alpha_f) * beta;
        let p = -w / d;
        let q = -w * (1.0 - alpha_f) / d;
        let r = -(alpha_m + w * (1.0 - alpha_f) * (0.5 - beta)) / d;
        #[rustfmt::skip]
        let matrix = Matrix3::new(
            1.0 + beta * p, 1.0 + beta * q, 0.5 - beta + beta * r,
            gamma * p,      1.0 + gamma * q, 1.0 - gamma + gamma * r,
            p,              q,               r,
        );
        let pair = matrix
            .complex_eigenvalues()
            .iter()
            .filter(|l| l.im > 0.0)
            .map(|l| (l.re.hypot(l.im), l.im.atan2(l.re)))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        let gone = Self {
            damping: 1.0,
            elongation: f64::INFINITY,
        };
        pair.map_or(gone, |(size, angle)| {
            let decay = -size.ln();
            Self {
                damping: (decay / decay.hypot(angle)).max(0.0),
                elongation: omega * h / angle - 1.0,
            }
        })
    }

    /// The same over a run in steps of these lengths \[s\] and numbers: means over time, so that the loss at the end is that of
    /// all steps. (At the mean length it would be less: damping grows with the cube of the step.)
    #[must_use]
    pub fn over(rho: f64, omega: f64, steps: &[(f64, u64)]) -> Self {
        let total: f64 = steps.iter().map(|(h, count)| h * *count as f64).sum();
        let mut mean = Self {
            damping: 0.0,
            elongation: 0.0,
        };
        for (h, count) in steps {
            let (of, share) = (
                Self::of_oscillator(rho, omega, *h),
                h * *count as f64 / total,
            );
            mean.damping += share * of.damping;
            mean.elongation += share * of.elongation;
        }
        mean
    }

    /// Relative loss of amplitude in a cycle \[-\].
    #[must_use]
    pub fn lost_a_cycle(&self) -> f64 {
        let free = (1.0 - self.damping * self.damping).max(0.0).sqrt();
        -(-std::f64::consts::TAU * self.damping / free).exp_m1()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numerical_damping(rho: f64, omega: f64, h: f64) -> f64 {
        NumericalDamping::of_oscillator(rho, omega, h).damping
    }

    /// For small steps the period grows by (omega h)²/12 times a number of the method, which is 1 for rho = 1.
    #[test]
    fn the_period_grows_with_the_square_of_the_step() {
        for rho in [0.0, 0.4, 0.8, 1.0] {
            let at = |h: f64| NumericalDamping::of_oscillator(rho, 1.0, h).elongation;
            assert!((at(0.02) / at(0.01) - 4.0).abs() < 0.05, "{rho}");
        }
        let average = NumericalDamping::of_oscillator(1.0, 1.0, 0.01).elongation;
        assert!((average / (1e-4 / 12.0) - 1.0).abs() < 0.01, "{average}");
        assert_eq!(
            NumericalDamping::of_oscillator(1.0, 1.0, 0.1).lost_a_cycle(),
            0.0
        );
    }

    /// For rho = 1 none at all; for less, as the cube of the step, and the more the smaller rho.
    #[test]
    fn grows_with_the_cube_of_the_step_and_vanishes_for_rho_one() {
        assert!(numerical_damping(1.0, 1.0, 0.5) < 1e-12);
        for rho in [0.0, 0.4, 0.8] {
            let (fine, coarse) = (
                numerical_damping(rho, 1.0, 0.02),
                numerical_damping(rho, 1.0, 0.04),
            );
            assert!((coarse / fine - 8.0).abs() < 0.1, "{rho}: {fine} {coarse}");
        }
        let at = |rho| numerical_damping(rho, 1.0, 0.3);
        assert!(at(0.0) > at(0.4) && at(0.4) > at(0.8) && at(0.8) > at(1.0));
    }

    /// An oscillation of which nine tenths of the time are marched in steps ten times as long: nearly all it loses it
    /// loses there; steps of the mean length would show less.
    #[test]
    fn steps_of_several_lengths_damp_as_they_do_one_by_one() {
        let (rho, omega) = (0.4, 1.0);
        let steps = [(0.05, 200), (0.5, 180)];
        let decay = |h: f64, count: f64| {
            NumericalDamping::of_oscillator(rho, omega, h).damping * omega * h * count
        };
        let time = 0.05 * 200.0 + 0.5 * 180.0;
        let over = NumericalDamping::over(rho, omega, &steps);
        let one_by_one = decay(0.05, 200.0) + decay(0.5, 180.0);
        assert!((over.damping * omega * time / one_by_one - 1.0).abs() < 1e-12);
        let of_mean = NumericalDamping::of_oscillator(rho, omega, time / 380.0);
        assert!(over.damping > 3.0 * of_mean.damping, "{over:?} {of_mean:?}");
        assert!(over.elongation > of_mean.elongation);
        assert_eq!(
            NumericalDamping::over(rho, omega, &[(0.3, 7)]),
            NumericalDamping::of_oscillator(rho, omega, 0.3)
        );
    }

    /// Against a swing marched through by the formulas themselves.
    #[test]
    fn is_what_a_swing_loses() {
        let (rho, h) = (0.4_f64, 0.2_f64);
        let (am, af) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
        let (gamma, beta) = (0.5 - am + af, 0.25 * (1.0 - am + af).powi(2));
        let (mut x, mut v, mut a) = (1.0, 0.0, -1.0);
        let energy = |x: f64, v: f64| 0.5 * (x * x + v * v);
        let steps = 3142;
        for _ in 0..steps {
            let predicted = x + h * v + h * h * (0.5 - beta) * a;
            let a1: f64 = -(am * a + (1.0 - af) * predicted + af * x)
                / (1.0 - am + (1.0 - af) * beta * h * h);
            v += h * ((1.0 - gamma) * a + gamma * a1);
            x = predicted + h * h * beta * a1;
            a = a1;
        }
        let lost = -0.5 * (energy(x, v) / 0.5).ln() / (f64::from(steps) * h);
        let expected = numerical_damping(rho, 1.0, h);
        assert!((lost / expected - 1.0).abs() < 0.02, "{lost} {expected}");
    }
}
