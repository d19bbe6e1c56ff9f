//! One root of one rising function of a positive unknown: Newton in the logarithm, kept inside a bracket.
//!
//! Every single-line problem is brought to a function that rises strictly with its unknown, so a
//! sign tells the side of the root and the bracket can only shrink; Newton then only makes it quick.

/// What the search found.
#[derive(Debug, Clone, Copy)]
pub(super) struct Root {
    /// The unknown at the root.
    pub at: f64,
    /// Function evaluations spent.
    pub iterations: u32,
}

/// A Newton step in the logarithm below this leaves an error of its square: nothing.
const LAST_STEP: f64 = 3e-9;
/// More than any root here has ever needed is about 20.
const LIMIT: u32 = 200;

/// A rising function at one point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Value {
    pub value: f64,
    /// Derivative with respect to the logarithm of the unknown.
    pub slope: f64,
    /// Sum of the magnitudes that the value is the difference of: its digits end at 1e-16 of this.
    pub scale: f64,
}

/// Finds where a rising function crosses zero between 0 and `most`.
///
/// `None`
/// when the function is not a number somewhere or the search ran out; `most` itself when the
/// function is still negative there.
pub(super) fn rising(guess: f64, most: f64, mut eval: impl FnMut(f64) -> Value) -> Option<Root> {
    let (mut low, mut high) = (0.0_f64, most);
    let mut at = guess.clamp(1e-300, most);
    for iterations in 1..=LIMIT {
        let Value {
            value,
            slope,
            scale,
        } = eval(at);
        if value.is_nan() {
            return None;
        }
        if value.abs() <= f64::EPSILON * scale {
            return Some(Root { at, iterations });
        }
        if value < 0.0 {
            low = at;
        } else {
            high = at;
        }
        let step = -value / slope;
        if step.abs() <= LAST_STEP {
            let at = (at * (1.0 + step)).min(most);
            return Some(Root { at, iterations });
        }
        // Long steps are cut; steps out of the bracket, or a search that dawdles, halve it instead.
        let mut next = at * step.clamp(-3.0, 3.0).exp();
        let dawdles = iterations > 15 && iterations % 2 == 0;
        if !(next > low && next < high) || dawdles {
            next = middle(low, high, at);
        }
        if next <= low || next >= high {
            return Some(Root { at, iterations });
        }
        at = next;
    }
    None
}

/// A point inside the bracket, in the middle of the logarithm where both sides are known.
fn middle(low: f64, high: f64, at: f64) -> f64 {
    if low <= 0.0 {
        high.min(at) / 16.0
    } else if high.is_infinite() {
        at * 16.0
    } else {
        low.sqrt() * high.sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(value: f64, slope: f64) -> Value {
        Value {
            value,
            slope,
            scale: 0.0,
        }
    }

    #[test]
    fn finds_a_root_from_a_guess_hundreds_of_decades_away() {
        for guess in [1e-200, 1.0, 1e200] {
            let root = rising(guess, f64::INFINITY, |x| plain(x.ln() - 2.0_f64.ln(), 1.0));
            assert!((root.map_or(0.0, |r| r.at) - 2.0).abs() < 1e-14);
        }
    }

    #[test]
    fn survives_a_slope_that_lies() {
        let root = rising(3.0, f64::INFINITY, |x| plain(x - 2.0, 1e-3));
        assert!((root.map_or(0.0, |r| r.at) - 2.0).abs() < 1e-8);
    }

    #[test]
    fn a_function_that_is_no_number_has_no_root() {
        assert!(rising(1.0, f64::INFINITY, |_| plain(f64::NAN, 1.0)).is_none());
    }
}
