//! The incomplete gamma and beta functions, and the distributions that follow from them.
//!
//! Those of `statrs` are 0 and 1 below arguments of 1.1e-15, where P(1/2, x) is 4e-8 already, and not in logarithms, which the tails of order
//! statistics need.

use std::convert::Infallible;

pub(super) use statrs::function::gamma::ln_gamma;

use crate::numerics::roots::false_position;

/// The regularised incomplete gamma functions, lower P(a, x) and upper Q(a, x): series and continued fraction (Abramowitz and
/// Stegun 6.5.29 and 6.5.31).
#[must_use]
pub(super) fn incomplete_gamma(a: f64, x: f64) -> (f64, f64) {
    incomplete_gamma_with(a, ln_gamma(a), x)
}

/// The same with the logarithm of the gamma function of `a` given.
#[must_use]
pub(super) fn incomplete_gamma_with(a: f64, ln_gamma_a: f64, x: f64) -> (f64, f64) {
    if x <= 0.0 {
        return (0.0, 1.0);
    }
    if x == f64::INFINITY {
        return (1.0, 0.0);
    }
    let front = (a * x.ln() - x - ln_gamma_a).exp();
    if x < a + 1.0 {
        let lower = (front * gamma_series(a, x)).min(1.0);
        (lower, 1.0 - lower)
    } else {
        let upper = (front * gamma_fraction(a, x)).min(1.0);
        (1.0 - upper, upper)
    }
}

/// Terms of a series or of a continued fraction at most: those needed grow as the root of the arguments.
const TERMS: usize = 100_000;

fn gamma_series(a: f64, x: f64) -> f64 {
    let (mut term, mut sum) = (1.0 / a, 1.0 / a);
    for n in 1..TERMS {
        term *= x / (a + n as f64);
        sum += term;
        if term < 1e-16 * sum || sum.is_nan() {
            break;
        }
    }
    sum
}

fn gamma_fraction(a: f64, x: f64) -> f64 {
    let next = |n: usize| (n as f64 * (a - n as f64), x + 2.0 * n as f64 + 1.0 - a);
    1.0 / lentz(x + 1.0 - a, next)
}

/// A continued fraction `b0 + a1/(b1 + a2/(b2 + ...))` by the modified Lentz algorithm (Thompson and Barnett 1986).
fn lentz(first: f64, next: impl Fn(usize) -> (f64, f64)) -> f64 {
    const TINY: f64 = 1e-300;
    let away = |v: f64| if v.abs() < TINY { TINY } else { v };
    let mut value = away(first);
    let (mut c, mut d) = (value, 0.0);
    for n in 1..TERMS {
        let (a, b) = next(n);
        d = 1.0 / away(b + a * d);
        c = away(b + a / c);
        let factor = c * d;
        value *= factor;
        // Not below the spacing of numbers about one; a value that is no number ends too.
        if (factor - 1.0).abs() <= 4e-16 || factor.is_nan() {
            break;
        }
    }
    value
}

/// Logarithm of the beta function.
#[must_use]
pub(super) fn ln_beta(a: f64, b: f64) -> f64 {
    ln_gamma(a) + ln_gamma(b) - ln_gamma(a + b)
}

/// Logarithm of the regularised incomplete beta function I_x(a, b) (Abramowitz and Stegun 26.5.8).
#[must_use]
pub(super) fn ln_incomplete_beta(a: f64, b: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return f64::NEG_INFINITY;
    }
    if x >= 1.0 {
        return 0.0;
    }
    if x > (a + 1.0) / (a + b + 2.0) {
        let other = beta_by_fraction(b, a, 1.0 - x).exp().min(1.0);
        return (-other).ln_1p();
    }
    beta_by_fraction(a, b, x).min(0.0)
}

fn beta_by_fraction(a: f64, b: f64, x: f64) -> f64 {
    let next = |n: usize| {
        let m = (n / 2) as f64;
        let coefficient = if n.is_multiple_of(2) {
            m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
        } else {
            -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0))
        };
        (coefficient, 1.0)
    };
    let fraction = lentz(1.0, next);
    a * x.ln() + b * (-x).ln_1p() - ln_beta(a, b) - a.ln() - fraction.abs().ln()
}

/// The probability that a standard normal variable is below `x`.
#[must_use]
pub(super) fn normal_probability(x: f64) -> f64 {
    let tail = 0.5 * incomplete_gamma(0.5, 0.5 * x * x).1;
    if x > 0.0 { 1.0 - tail } else { tail }
}

/// The standard normal variable that is not exceeded with a probability, cut at 38 deviations.
#[must_use]
pub(super) fn normal_quantile(probability: f64) -> f64 {
    // Of the smaller tail, whose digits are all significant.
    let tail = probability.min(1.0 - probability);
    let off = |x: f64| Ok::<_, Infallible>(normal_probability(x).max(1e-320).ln() - tail.ln());
    let Ok(found) = false_position((-38.0, 0.0), off);
    let x = found.unwrap_or(if tail < 0.25 { -38.0 } else { 0.0 });
    if probability > 0.5 { -x } else { x }
}

/// The chi-squared variable of these degrees of freedom that is not exceeded with a probability.
#[must_use]
pub(super) fn chi_squared_quantile(freedom: f64, probability: f64) -> f64 {
    let off = |log: f64| {
        let (lower, upper) = incomplete_gamma(0.5 * freedom, 0.5 * log.exp());
        Ok::<_, Infallible>(if probability < 0.5 {
            lower - probability
        } else {
            1.0 - probability - upper
        })
    };
    let Ok(found) = false_position((-700.0, (freedom + 10.0).ln() + 8.0), off);
    found.map_or(0.0, f64::exp)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn gamma_and_beta() {
        assert!((ln_gamma(0.5) - 0.5 * PI.ln()).abs() < 1e-14);
        assert!((ln_gamma(11.0) - 3_628_800.0_f64.ln()).abs() < 1e-13);
        for x in [0.01, 0.3, 2.0, 9.0, 60.0] {
            let (lower, upper) = incomplete_gamma(1.0, x);
            assert!((upper - (-x).exp()).abs() < 1e-14 && (lower + upper - 1.0).abs() < 1e-14);
        }
        // I_x(2, 3) = x^2 (6 - 8 x + 3 x^2).
        for x in [1e-9, 0.2, 0.5, 0.9] {
            let exact = x * x * (6.0 - 8.0 * x + 3.0 * x * x);
            assert!(
                (ln_incomplete_beta(2.0, 3.0, x) - exact.ln()).abs() < 1e-13,
                "{x}"
            );
        }
    }

    /// Table values (Abramowitz and Stegun, tables 26.1, 26.8).
    #[test]
    fn quantiles() {
        assert!((normal_quantile(0.975) - 1.959_963_984_540_054).abs() < 1e-12);
        assert!((normal_quantile(1e-10) + 6.361_340_902_404_056).abs() < 1e-11);
        assert_eq!(normal_quantile(0.5), 0.0);
        assert!((chi_squared_quantile(1.0, 0.95) - 3.841_458_820_694_124).abs() < 1e-11);
        assert!((chi_squared_quantile(10.0, 0.025) - 3.246_972_780_236_84).abs() < 1e-10);
        let back = chi_squared_quantile(2000.0, 0.6);
        assert!((incomplete_gamma(1000.0, 0.5 * back).0 - 0.6).abs() < 1e-12);
    }
}
