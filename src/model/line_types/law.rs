//! Formulas of line properties by nominal diameter.

use crate::number::digits;

/// Half of pi: two legs of a link have the area `pi/2 d^2`.
const TWO_LEGS: f64 = std::f64::consts::FRAC_PI_2;

/// A property by the nominal diameter d \[m\], in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DiameterLaw {
    /// `a d^2`.
    Square(f64),
    /// `a d^2 + b d^3`.
    Cubic(f64, f64),
    /// `c d^2 (44 - 80 d)`, loads of chain \[N\] (IACS UR W22, with d in mm and c in kN/mm^2 `c d^2 (44 - 0.08 d)`).
    ChainLoad(f64),
    /// `(e - f d) pi/2 d^2`, stiffness of two legs of a link by their effective modulus \[N\] (DNV-OS-E301).
    ChainModulus(f64, f64),
    /// A multiple of another property, given by value: `k` times the breaking load.
    OfBreakLoad(f64),
}

impl DiameterLaw {
    /// The property at a nominal diameter \[m\]; of a multiple of the breaking load, by that load \[N\].
    #[must_use]
    pub fn value(self, diameter: f64, break_load: f64) -> f64 {
        let square = diameter * diameter;
        match self {
            Self::Square(a) => a * square,
            Self::Cubic(a, b) => (a + b * diameter) * square,
            Self::ChainLoad(c) => c * square * (44.0 - 80.0 * diameter),
            Self::ChainModulus(e, f) => (e - f * diameter) * TWO_LEGS * square,
            Self::OfBreakLoad(k) => k * break_load,
        }
    }

    /// The formula with its numbers, d in m, the result in SI.
    #[must_use]
    pub fn formula(self) -> String {
        match self {
            Self::Square(a) => format!("{} d^2", short(a)),
            Self::Cubic(a, b) => format!("{} d^2 + {} d^3", short(a), short(b)),
            Self::ChainLoad(c) => format!("{} d^2 (44 - 80 d)", short(c)),
            Self::ChainModulus(e, f) if f > 0.0 => {
                format!("({} - {} d) pi/2 d^2", short(e), short(f))
            }
            Self::ChainModulus(e, _) => format!("{} pi/2 d^2", short(e)),
            Self::OfBreakLoad(k) => format!("{} times the breaking load", digits(k, 4)),
        }
    }
}

/// A coefficient to seven digits: `19900`, `2.74e7`.
pub(super) fn short(value: f64) -> String {
    if (1e-3..1e5).contains(&value.abs()) {
        return digits(value, 7);
    }
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    format!("{rounded:e}")
}

#[cfg(test)]
mod tests {
    use super::DiameterLaw;

    #[test]
    fn formulas_show_the_numbers_that_are_computed_with() {
        assert_eq!(DiameterLaw::Square(19_900.0).formula(), "19900 d^2");
        assert_eq!(
            DiameterLaw::ChainLoad(2.74e7).formula(),
            "2.74e7 d^2 (44 - 80 d)"
        );
        assert_eq!(
            DiameterLaw::ChainModulus(5.45e10, 2.5e10).formula(),
            "(5.45e10 - 2.5e10 d) pi/2 d^2"
        );
        let load = DiameterLaw::ChainLoad(2.74e7).value(0.12, 0.0);
        assert!((load - 2.74e7 * 0.0144 * 34.4).abs() < 1e-6 * load);
        assert!((DiameterLaw::OfBreakLoad(14.0).value(0.1, 2.0) - 28.0).abs() < 1e-12);
    }
}
