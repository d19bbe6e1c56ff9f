//! Hyperbolic functions and the small differences of them that cancel in taut catenaries, to full relative accuracy.

/// `sinh x`, `cosh x - 1` and `sinh x - x`, each to full relative accuracy, for x >= 0.
#[derive(Debug, Clone, Copy)]
pub struct Hyperbolic {
    /// sinh x
    pub sinh: f64,
    /// cosh x - 1
    pub cosh_minus_1: f64,
    /// sinh x - x
    pub sinh_minus_x: f64,
}

/// Below this the power series, above it the exponential.
const SERIES: f64 = 1.0;

/// See [`Hyperbolic`]. Overflows to infinity beyond x = 710.
#[must_use]
pub fn hyperbolic(x: f64) -> Hyperbolic {
    if x < SERIES {
        let q = x * x;
        // sinh x - x = x³/3! + x⁵/5! + ..., cosh x - 1 = x²/2! + x⁴/4! + ...
        let sinh_minus_x = x * q / 6.0 * nest(q, [20.0, 42.0, 72.0, 110.0, 156.0, 210.0, 272.0]);
        let cosh_minus_1 = q / 2.0 * nest(q, [12.0, 30.0, 56.0, 90.0, 132.0, 182.0, 240.0]);
        return Hyperbolic {
            sinh: x + sinh_minus_x,
            cosh_minus_1,
            sinh_minus_x,
        };
    }
    let grown = x.exp();
    let sinh = 0.5 * (grown - 1.0 / grown);
    Hyperbolic {
        sinh,
        cosh_minus_1: 0.5 * (grown + 1.0 / grown) - 1.0,
        sinh_minus_x: sinh - x,
    }
}

/// 1 + q/d0 (1 + q/d1 (1 + ...)).
fn nest(q: f64, divisors: [f64; 7]) -> f64 {
    divisors
        .iter()
        .rev()
        .fold(1.0, |inner, divisor| 1.0 + q / divisor * inner)
}

/// `atanh(u)/u - 1` for 0 <= u < 1 where `twice_atanh` is the already known 2 atanh(u).
#[must_use]
pub fn atanh_ratio_minus_1(u: f64, twice_atanh: f64) -> f64 {
    if u > 0.2 {
        return 0.5 * twice_atanh / u - 1.0;
    }
    let q = u * u;
    // u²/3 + u⁴/5 + u⁶/7 + ...
    let mut sum = 0.0;
    for k in (1..=11).rev() {
        sum = q * (1.0 / f64::from(2 * k + 1) + sum);
    }
    sum
}

/// `asinh(x) - x / sqrt(1 + x²)` for x >= 0: the second term is the sine of the angle whose tangent is x.
#[must_use]
pub fn asinh_minus_sine(x: f64) -> f64 {
    let root = (1.0 + x * x).sqrt();
    if x > 0.2 {
        return x.asinh() - x / root;
    }
    // With t = x/root = tanh b: atanh t - t = t³/3 + t⁵/5 + ...
    let t = x / root;
    t * atanh_ratio_minus_1(t, 0.0)
}

/// `x - asinh(x)` for x >= 0.
#[must_use]
pub fn x_minus_asinh(x: f64) -> f64 {
    if x > 0.2 {
        return x - x.asinh();
    }
    // x - asinh x = x³/6 - 3x⁵/40 + 15x⁷/336 - ...; each coefficient from the one before.
    let q = x * x;
    let (mut term, mut sum) = (x, 0.0);
    for k in 1..=14 {
        let n = f64::from(2 * k - 1);
        term *= -q * n / (n + 1.0);
        sum -= term / (n + 2.0);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_meet_the_closed_forms_at_their_seams() {
        let (below, above) = (hyperbolic(1.0 - 1e-15), hyperbolic(1.0));
        assert!((below.sinh_minus_x / above.sinh_minus_x - 1.0).abs() < 1e-13);
        assert!((below.cosh_minus_1 / above.cosh_minus_1 - 1.0).abs() < 1e-13);
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
        near(x_minus_asinh(0.2), x_minus_asinh(0.2 + 1e-15));
        near(asinh_minus_sine(0.2), asinh_minus_sine(0.2 + 1e-15));
        near(
            atanh_ratio_minus_1(0.2, 0.0),
            atanh_ratio_minus_1(0.2 + 1e-15, 2.0 * 0.2_f64.atanh()),
        );
    }

    #[test]
    fn leading_terms_hold_for_tiny_arguments() {
        let x = 1e-40;
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-14, "{a} {b}");
        near(x_minus_asinh(x), x * x * x / 6.0);
        near(asinh_minus_sine(x), x * x * x / 3.0);
        near(hyperbolic(x).sinh_minus_x, x * x * x / 6.0);
        near(atanh_ratio_minus_1(x, 0.0), x * x / 3.0);
    }
}
