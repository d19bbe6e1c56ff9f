//! The root of an increasing function of a positive unknown: Newton's method in the logarithm, safeguarded by a bracket.
//!
//! Newton in `ln x` spans hundreds of decades; since the function increases, the sign of its value always shrinks the
//! bracket.

/// A root.
#[derive(Debug, Clone, Copy)]
pub struct Root {
    /// The unknown at the root.
    pub x: f64,
    /// Function evaluations spent.
    pub evaluations: u32,
}

/// A Newton step in the logarithm below this leaves an error of its square, below rounding.
const LAST_STEP: f64 = 3e-9;
/// Greatest number of evaluations; 20 is the most observed.
const LIMIT: u32 = 200;

/// An increasing function at one point.
#[derive(Debug, Clone, Copy)]
pub struct FunctionSample {
    /// Its value.
    pub value: f64,
    /// Derivative with respect to the logarithm of the unknown.
    pub log_slope: f64,
    /// Sum of the magnitudes that the value is the difference of: its rounding is 1e-16 of this.
    pub scale: f64,
}

/// Where an increasing function crosses zero between 0 and `upper`.
///
/// `None` when the function is NaN or the evaluations run out; `upper` itself when the function is negative there.
#[must_use]
pub fn increasing_root(
    guess: f64,
    upper: f64,
    mut eval: impl FnMut(f64) -> FunctionSample,
) -> Option<Root> {
    let (mut low, mut high) = (0.0_f64, upper);
    let mut x = guess.clamp(1e-300, upper);
    for evaluations in 1..=LIMIT {
        let sample = eval(x);
        let value = sample.value;
        if value.is_nan() {
            return None;
        }
        if value.abs() <= f64::EPSILON * sample.scale {
            return Some(Root { x, evaluations });
        }
        if value < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let step = -value / sample.log_slope;
        if step.abs() <= LAST_STEP {
            let x = (x * (1.0 + step)).min(upper);
            return Some(Root { x, evaluations });
        }
        // Long steps are cut; a step out of the bracket, or slow convergence, is replaced by bisection.
        let mut next = x * step.clamp(-3.0, 3.0).exp();
        let slow = evaluations > 15 && evaluations % 2 == 0;
        if !(next > low && next < high) || slow {
            next = middle(low, high, x);
        }
        if next <= low || next >= high {
            return Some(Root { x, evaluations });
        }
        x = next;
    }
    None
}

/// A point inside the bracket, in the middle of the logarithm when both sides are known.
fn middle(low: f64, high: f64, x: f64) -> f64 {
    if low <= 0.0 {
        high.min(x) / 16.0
    } else if high.is_infinite() {
        x * 16.0
    } else {
        low.sqrt() * high.sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(value: f64, log_slope: f64) -> FunctionSample {
        FunctionSample {
            value,
            log_slope,
            scale: 0.0,
        }
    }

    #[test]
    fn finds_a_root_from_a_guess_hundreds_of_decades_away() {
        for guess in [1e-200, 1.0, 1e200] {
            let root =
                increasing_root(guess, f64::INFINITY, |x| sample(x.ln() - 2.0_f64.ln(), 1.0));
            assert!((root.map_or(0.0, |r| r.x) - 2.0).abs() < 1e-14);
        }
    }

    #[test]
    fn survives_a_wrong_slope() {
        let root = increasing_root(3.0, f64::INFINITY, |x| sample(x - 2.0, 1e-3));
        assert!((root.map_or(0.0, |r| r.x) - 2.0).abs() < 1e-8);
    }

    #[test]
    fn a_function_that_is_nan_has_no_root() {
        assert!(increasing_root(1.0, f64::INFINITY, |_| sample(f64::NAN, 1.0)).is_none());
    }
}
