//! The formulas of generalized-alpha by its spectral radius, one node at a time: see [`generalized_alpha`](super::generalized_alpha).

use crate::numerics::V3;
use crate::solve::Factors;

/// Its four numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AlphaScheme {
    /// Weight of the acceleration before in the balance.
    pub alpha_m: f64,
    /// Weight of position and velocity before in the balance.
    pub alpha_f: f64,
    /// See [`AlphaScheme::end`].
    pub beta: f64,
    /// See [`AlphaScheme::end`].
    pub gamma: f64,
}

impl AlphaScheme {
    /// Of the spectral radius at infinite frequency, from 0 to 1.
    #[must_use]
    pub fn new(rho: f64) -> Self {
        let alpha_m = (2.0 * rho - 1.0) / (rho + 1.0);
        let alpha_f = rho / (rho + 1.0);
        Self {
            alpha_m,
            alpha_f,
            beta: 0.25 * (1.0 - alpha_m + alpha_f).powi(2),
            gamma: 0.5 - alpha_m + alpha_f,
        }
    }

    /// Weights of the tangent for a step of h seconds.
    #[must_use]
    pub fn factors(&self, h: f64) -> Factors {
        let (k_f, k_m) = (1.0 - self.alpha_f, 1.0 - self.alpha_m);
        Factors {
            mass: k_m / (k_f * self.beta * h * h),
            damping: self.gamma / (self.beta * h),
            stiffness: 1.0,
        }
    }

    /// How far behind its step the algorithmic acceleration belongs to \[s\].
    #[must_use]
    pub fn shift(&self, h: f64) -> f64 {
        (self.alpha_m - self.alpha_f) * h
    }

    /// Position and velocity at the end of a step from those at its start and both algorithmic accelerations.
    #[inline(always)]
    #[must_use]
    pub fn end(&self, h: f64, (x0, v0): (&V3, &V3), (a0, a1): (&V3, &V3)) -> (V3, V3) {
        let (beta, gamma) = (self.beta, self.gamma);
        (
            x0 + (v0 + (a0 * (0.5 - beta) + a1 * beta) * h) * h,
            v0 + (a0 * (1.0 - gamma) + a1 * gamma) * h,
        )
    }

    /// The algorithmic acceleration at the end from that of the balance.
    #[inline(always)]
    #[must_use]
    pub fn acceleration_at_end(&self, a0: &V3, between: &V3) -> V3 {
        (between - a0 * self.alpha_m) * (1.0 / (1.0 - self.alpha_m))
    }

    /// Squares of the estimated errors of a node in a step relative to the limits: in position `|beta - 1/6| h² |a1 - a0|`
    /// (Zienkiewicz and Xie 1991, doi 10.1002/eqe.4290200907); in velocity `h |a1 - a0 - h j0| / 12` from the second
    /// difference, which the predictor missed.
    #[inline(always)]
    #[must_use]
    pub fn squared_error(&self, h: f64, limits: &ErrorLimits, change: &V3, predicted: &V3) -> f64 {
        let by_change = (self.beta - 1.0 / 6.0).abs() * h * h / limits.position;
        let by_miss = h / (12.0 * limits.velocity);
        let miss = change - predicted;
        (change.norm_squared() * by_change * by_change).max(miss.norm_squared() * by_miss * by_miss)
    }
}

/// `new (1 - k) + old k`, node by node.
pub fn mix(k: f64, new: &[V3], old: &[V3], out: &mut [V3]) {
    for ((o, n), p) in out.iter_mut().zip(new).zip(old) {
        *o = n * (1.0 - k) + p * k;
    }
}

/// Error limits of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorLimits {
    /// In the position of any node \[m\].
    pub position: f64,
    /// In the velocity of any node \[m/s\].
    pub velocity: f64,
}

/// Fraction of the error limits of a step that the iteration may leave transverse to the line (1/10 to 1/100 in Hairer and
/// Wanner 1996, sec. IV.8; where Newton extrapolates its convergence, its safety factor leaves less).
const ITERATION_ERROR: f64 = 0.1;

impl ErrorLimits {
    /// Tolerance on transverse displacements of the iteration \[m\] that leaves a tenth of these limits at the
    /// end of the step.
    #[must_use]
    pub fn transverse_tolerance(&self, scheme: &AlphaScheme, factors: &Factors) -> f64 {
        let at_end = self.position.min(self.velocity / factors.damping);
        ITERATION_ERROR * (1.0 - scheme.alpha_f) * at_end
    }
}
