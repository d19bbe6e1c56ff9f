//! Double-double arithmetic: a number as an unevaluated sum of two `f64`, about 32 digits.
//!
//! A taut rope with EA/T = 1e10 turns a position rounded to 1e-16 of the length into a force wrong by 1e-6: verifying a
//! force takes more digits than computing it. T. J. Dekker, Numer. Math. 18 (1971) 224; products are split by Veltkamp's
//! constant, so no fused multiply-add is needed.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// An unevaluated sum `hi + lo` with |lo| at most half a unit in the last place of `hi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

/// Sum and its rounding error.
fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let s = a + b;
    let t = s - a;
    DoubleDouble {
        hi: s,
        lo: (a - (s - t)) + (b - t),
    }
}

/// Sum and its rounding error when |a| >= |b|.
fn quick_sum(a: f64, b: f64) -> DoubleDouble {
    let s = a + b;
    DoubleDouble {
        hi: s,
        lo: b - (s - a),
    }
}

/// Product and its rounding error.
fn two_product(a: f64, b: f64) -> DoubleDouble {
    const SPLIT: f64 = 134_217_729.0;
    let split = |x: f64| {
        let c = SPLIT * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    DoubleDouble {
        hi: p,
        lo: ((ah * bh - p) + ah * bl + al * bh) + al * bl,
    }
}

impl DoubleDouble {
    /// Rounded to one `f64`.
    #[must_use]
    pub fn value(self) -> f64 {
        self.hi + self.lo
    }

    /// Square root; zero of a negative number.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::from(0.0);
        }
        let root = self.hi.sqrt();
        let rest = (self - two_product(root, root)).hi;
        quick_sum(root, rest / (2.0 * root))
    }
}

impl From<f64> for DoubleDouble {
    fn from(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let mid = quick_sum(high.hi, high.lo + low.hi);
        quick_sum(mid.hi, mid.lo + low.lo)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let p = two_product(self.hi, other.hi);
        quick_sum(p.hi, p.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        if other.hi.is_infinite() {
            return Self::from(first);
        }
        let rest = self - other * Self::from(first);
        let second = rest.hi / other.hi;
        quick_sum(first, second)
    }
}

impl Add<f64> for DoubleDouble {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        self + Self::from(other)
    }
}

impl Mul<f64> for DoubleDouble {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        let p = two_product(self.hi, other);
        quick_sum(p.hi, p.lo + self.lo * other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_quotients_and_roots_keep_thirty_digits() {
        let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
        let rest = third * 3.0 - DoubleDouble::from(1.0);
        assert!(rest.value().abs() < 1e-31);
        let two = DoubleDouble::from(2.0);
        let rest = two.sqrt() * two.sqrt() - two;
        assert!(rest.value().abs() < 1e-30);
        let sum = DoubleDouble::from(1.0) + 1e-25;
        assert!(((sum - DoubleDouble::from(1.0)).value() - 1e-25).abs() < 1e-40);
    }
}
