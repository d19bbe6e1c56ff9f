//! Roots of one unknown inside a bracket: safeguarded Newton, false position, bisection.

/// Where a function that increases from `low` to `high` has its root.
#[derive(Debug, Clone, Copy)]
pub struct Bracket {
    /// The function is not positive here.
    pub low: f64,
    /// The function is not negative here.
    pub high: f64,
}

impl Bracket {
    /// Keeps the part that holds the root, given the value at `x`.
    pub fn shrink(&mut self, x: f64, value: f64) {
        if value > 0.0 {
            self.high = x;
        } else {
            self.low = x;
        }
    }

    /// The point half way.
    #[must_use]
    pub fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// Newton's next point `x - value / slope`, or the middle of the bracket where that leaves it.
    #[must_use]
    pub fn newton(&self, x: f64, value: f64, slope: f64) -> f64 {
        let newton = x - value / slope;
        if newton > self.low && newton < self.high {
            newton
        } else {
            self.middle()
        }
    }
}

/// Where a function that decreases over all real numbers is zero; `eval` gives the value and minus the slope. Newton's
/// method inside a bracket that is first sought in steps from `reach` on, each twice the one before. `None` where the
/// function has no zero within reach.
pub fn decreasing_root(
    guess: f64,
    mut reach: f64,
    mut eval: impl FnMut(f64) -> (f64, f64),
) -> Option<f64> {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut x = guess;
    for _ in 0..2000 {
        let (value, fall) = eval(x);
        if value > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let step = value / fall;
        if value == 0.0 || step.abs() <= f64::EPSILON * x.abs() {
            return Some(x + if step.is_finite() { step } else { 0.0 });
        }
        let mut next = x + step;
        if !(next > low && next < high) {
            next = match (low.is_finite(), high.is_finite()) {
                (true, true) => 0.5 * (low + high),
                (true, false) => x + reach,
                _ => x - reach,
            };
            reach *= 2.0;
        }
        if next <= low || next >= high {
            return Some(x);
        }
        x = next;
    }
    None
}

/// Greatest number of evaluations of [`false_position`]; 60 is the most observed.
const LIMIT: usize = 300;

/// Where a function crosses zero between two points at which its signs differ: false position that halves the weight of
/// a side that stays (the Illinois rule, Dowell and Jarratt, BIT 11 (1971) 168), with a bisection every fourth step.
/// `None` where the signs do not differ or the function is NaN.
///
/// # Errors
/// Those of the function.
pub fn false_position<E>(
    (mut a, mut b): (f64, f64),
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<Option<f64>, E> {
    let (mut fa, mut fb) = (f(a)?, f(b)?);
    if fa == 0.0 {
        return Ok(Some(a));
    }
    if fb == 0.0 {
        return Ok(Some(b));
    }
    if fa.is_nan() || fb.is_nan() || fa.signum() == fb.signum() {
        return Ok(None);
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
            return Ok(Some(x));
        }
        let fx = f(x)?;
        if fx == 0.0 {
            return Ok(Some(x));
        }
        if fx.is_nan() {
            return Ok(None);
        }
        if fx.signum() == fb.signum() {
            fa *= 0.5;
        } else {
            (a, fa) = (b, fb);
        }
        (b, fb) = (x, fx);
    }
    Ok(Some(0.5 * (a + b)))
}

/// Halves a bracket so many times, at points that `middle` chooses; `is_below` says whether a point lies below the root.
pub fn bisect(
    mut bracket: Bracket,
    halvings: usize,
    middle: impl Fn(&Bracket) -> f64,
    mut is_below: impl FnMut(f64) -> bool,
) -> Bracket {
    for _ in 0..halvings {
        let x = middle(&bracket);
        if is_below(x) {
            bracket.low = x;
        } else {
            bracket.high = x;
        }
    }
    bracket
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_roots() {
        let root = |bounds, f: fn(f64) -> f64| {
            let found = false_position(bounds, |x| Ok::<_, ()>(f(x)));
            found.unwrap().unwrap()
        };
        assert!((root((0.0, 5.0), |x| x.exp() - 7.0) - 7.0_f64.ln()).abs() < 1e-14);
        assert!((root((5.0, -3.0), |x| (x - 1e-9).powi(3)) - 1e-9).abs() < 1e-6);
        assert!(false_position((1.0, 2.0), Ok::<_, ()>).unwrap().is_none());
    }

    #[test]
    fn newton_stays_in_its_bracket() {
        let mut bracket = Bracket {
            low: 0.0,
            high: 10.0,
        };
        let mut x = 9.0;
        for _ in 0..60 {
            let (value, slope) = (f64::atan(x - 2.0), 1.0 / (1.0 + (x - 2.0) * (x - 2.0)));
            bracket.shrink(x, value);
            x = bracket.newton(x, value, slope);
        }
        assert!((x - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_bracket_is_found_far_away() {
        let x = decreasing_root(0.0, 1.0, |x| (1e3 - x, 1e-6)).unwrap();
        assert!((x - 1e3).abs() < 1e-9);
        assert_eq!(decreasing_root(5.0, 1.0, |x| (3.0 - x, 1.0)), Some(3.0));
    }

    #[test]
    fn bisection_halves() {
        let whole = Bracket {
            low: 0.0,
            high: 3.0,
        };
        let found = bisect(whole, 50, Bracket::middle, |x| x * x < 2.0);
        assert!((found.high - 2.0_f64.sqrt()).abs() < 1e-14);
    }
}
