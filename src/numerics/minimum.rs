//! The minimum of a function of one unknown between three points, by parabolas (Brent, Algorithms for Minimization without Derivatives,
//! 1973, chapter 5).

/// Three points with their values, the middle one with the least; it may be one of the ends.
#[derive(Debug, Clone, Copy)]
pub struct Middle {
    /// The lower and the upper end.
    pub ends: [(f64, f64); 2],
    /// Between them.
    pub middle: (f64, f64),
}

/// The share of the wider part that a step takes where no parabola serves: that of the golden section.
const SHARE: f64 = 0.381_966_011_250_105_1;

/// Where the function has its least value between the ends, within `tolerance` or after so many `steps`, and the value. A smooth function takes
/// about eight values; one that is infinite somewhere is divided there by golden section.
///
/// # Errors
/// Those of the function.
pub fn parabolic_minimum<E>(
    points: Middle,
    tolerance: f64,
    steps: usize,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<(f64, f64), E> {
    let [mut a, mut b] = points.ends.map(|end| end.0);
    // The best point, the second best and the one before that; the last step and the one before.
    let mut best = points.middle;
    let [mut second, mut third] = points.ends;
    if third.1 < second.1 {
        (second, third) = (third, second);
    }
    let (mut step, mut before) = (b - a, b - a);
    for _ in 0..steps {
        let centre = 0.5 * (a + b);
        if (best.0 - centre).abs() <= 2.0 * tolerance - 0.5 * (b - a) {
            break;
        }
        match parabola(best, second, third) {
            Some(to) if (to > a && to < b) && (to - best.0).abs() < 0.5 * before.abs() => {
                (before, step) = (step, to - best.0);
                if to - a < 2.0 * tolerance || b - to < 2.0 * tolerance {
                    step = tolerance.copysign(centre - best.0);
                }
            }
            _ => {
                before = if best.0 < centre { b } else { a } - best.0;
                step = SHARE * before;
            }
        }
        let at = best.0 + tolerance.max(step.abs()).copysign(step);
        let next = (at, f(at)?);
        if next.1 <= best.1 {
            *(if at < best.0 { &mut b } else { &mut a }) = best.0;
            (best, second, third) = (next, best, second);
        } else {
            *(if at < best.0 { &mut a } else { &mut b }) = at;
            if next.1 <= second.1 || second.0 == best.0 {
                (second, third) = (next, second);
            } else {
                third = next;
            }
        }
    }
    Ok(best)
}

/// Where the parabola through three points has its extremum; nothing of values that are infinite or points that coincide.
fn parabola(best: (f64, f64), second: (f64, f64), third: (f64, f64)) -> Option<f64> {
    let r = (best.0 - second.0) * (best.1 - third.1);
    let q = (best.0 - third.0) * (best.1 - second.1);
    let step = ((best.0 - third.0) * q - (best.0 - second.0) * r) / (2.0 * (r - q));
    Some(best.0 + step).filter(|x| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(ends: (f64, f64), middle: f64, f: impl Fn(f64) -> f64) -> (f64, f64, usize) {
        let at = |x: f64| (x, f(x));
        let mut count = 0;
        let points = Middle {
            ends: [at(ends.0), at(ends.1)],
            middle: at(middle),
        };
        let counted = |x: f64| {
            count += 1;
            Ok::<_, ()>(f(x))
        };
        let (x, least) = parabolic_minimum(points, 1e-8, 100, counted).unwrap();
        (x, least, count)
    }

    #[test]
    fn a_smooth_function_takes_few_values() {
        let (x, least, count) = found((0.0, 9.0), 1.0, |x| (x - 2.0).powi(2) + 3.0);
        assert!((x - 2.0).abs() < 1e-7 && (least - 3.0).abs() < 1e-14);
        assert!(count < 6, "{count}");
        let (x, _, count) = found((0.1, 5.0), 1.0, |x| x - 2.0 * x.ln());
        assert!((x - 2.0).abs() < 1e-7 && count < 16, "{count}");
    }

    #[test]
    fn at_an_end_and_beside_what_is_infinite() {
        let (x, ..) = found((1.0, 4.0), 1.0, |x| x);
        assert!((x - 1.0).abs() < 1e-7);
        let cliff = |x: f64| {
            if x < 1.5 {
                f64::INFINITY
            } else {
                (x - 1.6).abs()
            }
        };
        let (x, ..) = found((1.0, 4.0), 2.0, cliff);
        assert!((x - 1.6).abs() < 1e-7);
        let edge = |x: f64| if x < 1.5 { f64::INFINITY } else { x };
        let (x, ..) = found((1.0, 4.0), 2.0, edge);
        assert!((x - 1.5).abs() < 1e-7);
    }
}
