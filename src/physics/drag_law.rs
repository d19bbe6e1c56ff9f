//! Drag coefficients: constant, or the Reynolds laws of Jia et al. 2019, eqs (4) and (5).

/// A drag coefficient as a function of the Reynolds number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DragLaw {
    /// The same everywhere.
    Constant(f64),
    /// Normal drag of a cylinder, Jia et al. 2019, eq. (4):
    /// 0 (Re <= 0.1); 0.45 + 5.93 / Re^0.33 (<= 400); 1.27 (<= 1e5); 0.3 above.
    Jia2019Normal,
    /// Tangential drag of a cylinder, Jia et al. 2019, eq. (5):
    /// 1.88 / Re^0.74 (0.1 < Re <= 100.5); 0.062 above. Nothing is printed for Re <= 0.1: 0 here.
    Jia2019Tangential,
}

impl DragLaw {
    /// Coefficient \[-\] and its derivative by the Reynolds number; at a jump, that of the branch.
    #[inline(always)]
    #[must_use]
    pub fn coefficient(self, re: f64) -> (f64, f64) {
        match self {
            Self::Constant(c) => (c, 0.0),
            Self::Jia2019Normal => {
                if re > CRISIS {
                    (0.3, 0.0)
                } else if re > 400.0 {
                    (1.27, 0.0)
                } else {
                    power_law(re, 0.45, 5.93, 0.33)
                }
            }
            Self::Jia2019Tangential => {
                if re > 100.5 {
                    (0.062, 0.0)
                } else {
                    power_law(re, 0.0, 1.88, 0.74)
                }
            }
        }
    }
}

impl DragLaw {
    /// A coefficient that, with the square of this Reynolds number, gives no less force than any part of the velocity
    /// does: past the crisis that of before it, as a part may be slower.
    #[must_use]
    pub fn greatest(self, re: f64) -> f64 {
        match self {
            Self::Jia2019Normal if re > CRISIS => 1.27,
            _ => self.coefficient(re).0,
        }
    }

    /// The Reynolds number at which the coefficient jumps by so much that the force of a moving line would jump
    /// with it: the drag crisis of eq. (4), where the coefficient falls from 1.27 to 0.3. (The other joints of
    /// the printed branches jump by less than the last digit printed, or where the force is next to nothing.)
    #[must_use]
    pub fn crisis(self) -> Option<f64> {
        match self {
            Self::Jia2019Normal => Some(CRISIS),
            Self::Constant(_) | Self::Jia2019Tangential => None,
        }
    }
}

/// Drag crisis of Jia et al. 2019, eq. (4).
const CRISIS: f64 = 1e5;

/// `base + factor / Re^exponent` above Re = 0.1, nothing below.
#[cold]
fn power_law(re: f64, base: f64, factor: f64, exponent: f64) -> (f64, f64) {
    if re <= 0.1 {
        return (0.0, 0.0);
    }
    let part = factor * re.powf(-exponent);
    (base + part, -exponent * part / re)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_branches() {
        let normal = |re| DragLaw::Jia2019Normal.coefficient(re).0;
        assert_eq!(normal(0.1), 0.0);
        assert!((normal(100.0) - (0.45 + 5.93 / 100f64.powf(0.33))).abs() < 1e-15);
        assert_eq!(normal(401.0), 1.27);
        assert_eq!(normal(1.0e5), 1.27);
        assert_eq!(normal(1.001e5), 0.3);
        let tangential = |re| DragLaw::Jia2019Tangential.coefficient(re).0;
        assert_eq!(tangential(0.05), 0.0);
        assert!((tangential(10.0) - 1.88 / 10f64.powf(0.74)).abs() < 1e-15);
        assert_eq!(tangential(101.0), 0.062);
    }

    #[test]
    fn the_derivative_is_that_of_the_branch() {
        for law in [DragLaw::Jia2019Normal, DragLaw::Jia2019Tangential] {
            for re in [0.5, 3.0, 40.0, 99.0, 300.0, 2e4, 3e5] {
                let h = 1e-6 * re;
                let slope = (law.coefficient(re + h).0 - law.coefficient(re - h).0) / (2.0 * h);
                assert!(
                    (law.coefficient(re).1 - slope).abs() < 1e-6 * (1.0 + slope.abs()),
                    "{law:?} {re}"
                );
            }
        }
    }
}
