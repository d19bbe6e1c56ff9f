//! Roots and minima of one unknown, between bounds that hold them.

use super::Trouble;

/// More than any search here has needed is about 60.
const LIMIT: usize = 300;

/// Where a function crosses zero between two places at which its signs differ: false position that halves the weight
/// of a side that stays (the Illinois rule), and bisection where that dawdles.
///
/// # Errors
/// Those of the function, [`Trouble::NotFound`] where the signs do not differ.
pub(super) fn root(
    bounds: (f64, f64),
    what: &'static str,
    mut f: impl FnMut(f64) -> Result<f64, Trouble>,
) -> Result<f64, Trouble> {
    let (mut a, mut b) = bounds;
    let (mut fa, mut fb) = (f(a)?, f(b)?);
    if fa == 0.0 {
        return Ok(a);
    }
    if fb == 0.0 {
        return Ok(b);
    }
    if fa.is_nan() || fb.is_nan() || fa.signum() == fb.signum() {
        return Err(Trouble::NotFound(what));
    }
    for turn in 0..LIMIT {
        let secant = b - fb * (b - a) / (fb - fa);
        let inside = secant > a.min(b) && secant < a.max(b);
        let x = if inside && turn % 4 != 3 {
            secant
        } else {
            0.5 * (a + b)
        };
        if (b - a).abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs()) || x == a || x == b {
            return Ok(x);
        }
        let fx = f(x)?;
        if fx == 0.0 {
            return Ok(x);
        }
        if fx.is_nan() {
            return Err(Trouble::NotFound(what));
        }
        if fx.signum() == fb.signum() {
            fa *= 0.5;
        } else {
            (a, fa) = (b, fb);
        }
        (b, fb) = (x, fx);
    }
    Ok(0.5 * (a + b))
}

/// The place of the least value between two bounds, of a function that falls and then rises (golden section).
///
/// # Errors
/// Those of the function.
pub(super) fn least(
    bounds: (f64, f64),
    mut f: impl FnMut(f64) -> Result<f64, Trouble>,
) -> Result<f64, Trouble> {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = bounds;
    let (mut c, mut d) = (b - golden * (b - a), a + golden * (b - a));
    let (mut fc, mut fd) = (f(c)?, f(d)?);
    for _ in 0..LIMIT {
        if (b - a).abs() <= 1e-10 * a.abs().max(b.abs()) {
            break;
        }
        if fc < fd {
            (b, d, fd) = (d, c, fc);
            c = b - golden * (b - a);
            fc = f(c)?;
        } else {
            (a, c, fc) = (c, d, fd);
            d = a + golden * (b - a);
            fd = f(d)?;
        }
    }
    Ok(0.5 * (a + b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_roots_and_minima() {
        let x = root((0.0, 5.0), "", |x| Ok(x.exp() - 7.0)).unwrap();
        assert!((x - 7.0_f64.ln()).abs() < 1e-14);
        let x = root((5.0, -3.0), "", |x| Ok((x - 1e-9).powi(3))).unwrap();
        assert!((x - 1e-9).abs() < 1e-6);
        assert!(root((1.0, 2.0), "", Ok).is_err());
        let x = least((0.0, 9.0), |x| Ok((x - 2.0).powi(2))).unwrap();
        assert!((x - 2.0).abs() < 1e-6);
    }
}
