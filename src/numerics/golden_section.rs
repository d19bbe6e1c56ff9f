//! The minimum of a function of one unknown that falls and then rises, by golden section.

/// Where the function has its least value between two bounds, to `relative` of the bound or after so many `steps`.
///
/// # Errors
/// Those of the function.
pub fn golden_section<E>(
    (mut a, mut b): (f64, f64),
    relative: f64,
    steps: usize,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<f64, E> {
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let (mut c, mut d) = (b - RATIO * (b - a), a + RATIO * (b - a));
    let (mut fc, mut fd) = (f(c)?, f(d)?);
    for _ in 0..steps {
        if (b - a).abs() <= relative * a.abs().max(b.abs()) {
            break;
        }
        if fc < fd {
            (b, d, fd) = (d, c, fc);
            c = b - RATIO * (b - a);
            fc = f(c)?;
        } else {
            (a, c, fc) = (c, d, fd);
            d = a + RATIO * (b - a);
            fd = f(d)?;
        }
    }
    Ok(0.5 * (a + b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_minimum() {
        let parabola = |x: f64| Ok::<_, ()>((x - 2.0).powi(2));
        let x = golden_section((0.0, 9.0), 1e-10, 300, parabola).unwrap();
        assert!((x - 2.0).abs() < 1e-6);
    }
}
