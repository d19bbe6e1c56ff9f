//! Expected damage of ranges that follow a Weibull law, among them the Rayleigh law of a narrow-band Gaussian tension.
//!
//! Of ranges with `P(range > r) = exp(-(r/s)^h)` the expected damage of a cycle is
//! `E[D] = s^m1/K1 Γ(1 + m1/h; t) + s^m2/K2 γ(1 + m2/h; t)` with `t = (knee/s)^h` and the upper and lower incomplete Gamma
//! functions (DNV-RP-C203, simplified fatigue analysis with Weibull ranges, for one and for two slopes). A narrow-band Gaussian tension of deviation σ has
//! `h = 2` and `s = 2 √2 σ`, so that with one slope `E[D] = (2 √2 σ)^m / K Γ(1 + m/2)`.

use super::component::FatigueComponent;
use super::curve::{CurveError, check};
use statrs::function::gamma::{gamma_lr, gamma_ur, ln_gamma};
use std::f64::consts::{LN_10, SQRT_2};

/// Expected damage of a cycle of ranges of tension that follow a Weibull law of this scale in N and this shape, about a mean
/// tension in N; zero of a scale of zero.
///
/// # Errors
/// A scale that is negative or not finite, a shape outside 0.2 to 20, a mean that the curve refuses, a damage above 1e300.
pub fn weibull_damage(
    component: &FatigueComponent,
    scale: f64,
    shape: f64,
    mean: f64,
) -> Result<f64, CurveError> {
    check(
        "the scale of the ranges in N",
        scale,
        0.0..=f64::MAX,
        "finite and not negative",
    )?;
    check(
        "the shape of the law of the ranges",
        shape,
        0.2..=20.0,
        "from 0.2 to 20",
    )?;
    let parts = component.law().parts(component.mean_ratio(mean)?);
    let log10_x = component.x(scale).log10();
    if log10_x == f64::NEG_INFINITY {
        return Ok(0.0);
    }
    let whole = |(exponent, constant): (f64, f64)| -> (f64, f64) {
        let order = 1.0 + exponent / shape;
        (
            order,
            LN_10 * (exponent * log10_x - constant) + ln_gamma(order),
        )
    };
    let damage = match parts.small {
        None => whole(parts.large).1.exp(),
        Some((knee, below)) => {
            // Beyond e^700 all ranges lie below the knee, below e^-700 none.
            let t = (LN_10 * shape * (knee - log10_x))
                .clamp(-700.0, 700.0)
                .exp();
            let ((above_order, above), (below_order, below)) = (whole(parts.large), whole(below));
            part(above, gamma_ur(above_order, t)) + part(below, gamma_lr(below_order, t))
        }
    };
    if damage <= 1e300 {
        Ok(damage)
    } else {
        Err(CurveError::Overflow { range: scale })
    }
}

/// A share of a damage that is given by its logarithm; no share of one that overflows is none.
fn part(log: f64, share: f64) -> f64 {
    if share > 0.0 {
        (log + share.ln()).exp()
    } else {
        0.0
    }
}

/// Expected damage of so many cycles of a narrow-band Gaussian tension of this deviation in N about this mean in N.
///
/// # Errors
/// A number of cycles or deviation that is negative or not finite, and what [`weibull_damage`] refuses.
pub fn narrow_band_damage(
    component: &FatigueComponent,
    deviation: f64,
    mean: f64,
    cycles: f64,
) -> Result<f64, CurveError> {
    check(
        "the number of cycles",
        cycles,
        0.0..=f64::MAX,
        "finite and not negative",
    )?;
    let scale = narrow_band_scale(deviation);
    let damage = cycles * weibull_damage(component, scale, 2.0, mean)?;
    if damage.is_finite() {
        Ok(damage)
    } else {
        Err(CurveError::Overflow { range: scale })
    }
}

/// Scale of the ranges of a narrow-band Gaussian tension of a deviation, both in N.
pub(crate) fn narrow_band_scale(deviation: f64) -> f64 {
    2.0 * SQRT_2 * deviation
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fatigue::component::Measure;
    use crate::fatigue::curve::Law;
    use crate::numerics::random::Random;

    fn ratio(law: Law) -> FatigueComponent {
        FatigueComponent::new("", law, Measure::TensionRatio, Some(1e6)).unwrap()
    }

    /// `Γ(1 + 3/2) = 3 √π / 4` and `Γ(1 + 4/2) = 2`.
    #[test]
    fn one_slope() {
        let cubic = narrow_band_damage(&ratio(Law::new(3.0, 2.5)), 1e5, 0.0, 10.0).unwrap();
        let gamma = 0.75 * std::f64::consts::PI.sqrt();
        let expected = 10.0 * (0.2 * SQRT_2).powi(3) / 10.0_f64.powf(2.5) * gamma;
        assert!((cubic / expected - 1.0).abs() < 1e-12);
        let fourth = narrow_band_damage(&ratio(Law::new(4.0, 2.0)), 1e5, 0.0, 1.0).unwrap();
        assert!((fourth / ((0.2 * SQRT_2).powi(4) / 100.0 * 2.0) - 1.0).abs() < 1e-12);
    }

    /// Two slopes against the midpoint rule over 100,000 equal probabilities.
    #[test]
    fn two_slopes() {
        for (knee, shape, slope) in [
            (1e5, 2.0, 0.0),
            (1e3, 1.0, 1.5),
            (1e7, 0.8, 0.0),
            (1e12, 2.0, 0.0),
        ] {
            let component = ratio(
                Law::new(3.0, 2.5)
                    .with_knee(knee, 5.0)
                    .falling_with_mean(slope),
            );
            let number = 100_000;
            let sum: f64 = (0..number)
                .map(|i| {
                    let p = (f64::from(i) + 0.5) / f64::from(number);
                    let range = 1e5 * (-p.ln()).powf(1.0 / shape);
                    component.cycle_damage(range, 2e5).unwrap().damage
                })
                .sum();
            let found = weibull_damage(&component, 1e5, shape, 2e5).unwrap();
            let ratio = found * f64::from(number) / sum;
            // The rule misses most of the last interval where the tail is long.
            assert!(
                (ratio - 1.0).abs() < if shape < 2.0 { 6e-3 } else { 3e-4 },
                "{ratio} of {shape}"
            );
        }
    }

    #[test]
    fn equal_slopes_are_one() {
        let one = narrow_band_damage(&ratio(Law::new(3.0, 2.5)), 1e5, 0.0, 1.0).unwrap();
        for knee in [1.0, 1e5, 1e6, 1e15] {
            let component = ratio(Law::new(3.0, 2.5).with_knee(knee, 3.0));
            let two = narrow_band_damage(&component, 1e5, 0.0, 1.0).unwrap();
            assert!((two / one - 1.0).abs() < 1e-10, "{knee}");
        }
    }

    #[test]
    fn whatever_comes_is_finite_or_refused() {
        let mut random = Random::new(18, 0);
        let odd = [
            0.0,
            1.0,
            -1.0,
            1e-320,
            1e5,
            1e6,
            1e300,
            f64::MAX,
            f64::NAN,
            f64::INFINITY,
            2.0,
            0.3,
        ];
        let laws = [
            Law::new(3.0, 2.5),
            Law::new(50.0, -100.0).with_knee(1e15, 0.1),
            Law::new(0.1, 100.0).with_knee(1.0, 50.0),
            Law::new(4.0, 3.0)
                .falling_with_mean(3.0)
                .with_knee(1e6, 5.0),
        ];
        for turn in 0..8000 {
            let mut pick = || odd[(odd.len() as f64 * random.uniform()) as usize];
            let component = ratio(laws[turn % laws.len()]);
            let found = [
                weibull_damage(&component, pick(), pick(), pick()),
                narrow_band_damage(&component, pick(), pick(), pick()),
            ];
            assert!(
                found.iter().flatten().all(|d| d.is_finite() && *d >= 0.0),
                "{found:?}"
            );
        }
        assert_eq!(narrow_band_damage(&ratio(laws[0]), 0.0, 0.0, 9.0), Ok(0.0));
    }
}
