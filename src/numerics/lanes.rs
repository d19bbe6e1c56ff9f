//! Two numbers side by side, each in its lane of a vector register (SIMD): two computations of the same steps run as one.

use std::ops::Neg;

use nalgebra::{
    ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Complex, Matrix3, Scalar,
    Vector3,
};
use wide::f64x2;

use super::{M3, V3};

/// A number, real or complex, or two side by side.
pub trait Number:
    Scalar
    + Copy
    + From<f64>
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
    + Neg<Output = Self>
{
}

impl Number for f64 {}
impl Number for f64x2 {}
impl Number for Complex<f64> {}

/// A number with a size, by which pivots are judged.
pub trait Pivot: Number {
    /// Its absolute value; of a complex number the sum of those of its parts.
    fn size(self) -> f64;

    /// Whether it is less than zero; never of a complex number.
    fn is_negative(self) -> bool;
}

impl Pivot for f64 {
    #[inline(always)]
    fn size(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn is_negative(self) -> bool {
        self < 0.0
    }
}

impl Pivot for Complex<f64> {
    #[inline(always)]
    fn size(self) -> f64 {
        self.re.abs() + self.im.abs()
    }

    fn is_negative(self) -> bool {
        false
    }
}

/// Two numbers.
pub type Two = f64x2;

/// Two vectors.
pub type TwoV3 = Vector3<f64x2>;

/// Two blocks.
pub type TwoM3 = Matrix3<f64x2>;

/// Two vectors side by side.
#[inline(always)]
#[must_use]
pub fn vectors(first: &V3, second: &V3) -> TwoV3 {
    first.zip_map(second, |a, b| f64x2::new([a, b]))
}

/// The same vector twice.
#[inline(always)]
#[must_use]
pub fn twice(v: &V3) -> TwoV3 {
    v.map(f64x2::splat)
}

/// Two blocks side by side.
#[inline(always)]
#[must_use]
pub fn blocks(first: &M3, second: &M3) -> TwoM3 {
    first.zip_map(second, |a, b| f64x2::new([a, b]))
}

/// One vector of two, the first (0) or the second (1).
#[inline(always)]
#[must_use]
pub fn vector(v: &TwoV3, lane: usize) -> V3 {
    v.map(|c| c.to_array()[lane])
}

/// One block of two, the first (0) or the second (1).
#[inline(always)]
#[must_use]
pub fn block(m: &TwoM3, lane: usize) -> M3 {
    m.map(|c| c.to_array()[lane])
}

/// Each of the two where the other was.
#[inline(always)]
#[must_use]
pub fn swapped(two: Two) -> Two {
    let [first, second] = two.to_array();
    f64x2::new([second, first])
}

/// `a . b`.
#[inline(always)]
#[must_use]
pub fn dot<T: Number>(a: &Vector3<T>, b: &Vector3<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `m x`.
#[inline(always)]
#[must_use]
pub fn apply<T: Number>(m: &Matrix3<T>, x: &Vector3<T>) -> Vector3<T> {
    let row = |i: usize| m[(i, 0)] * x[0] + m[(i, 1)] * x[1] + m[(i, 2)] * x[2];
    Vector3::new(row(0), row(1), row(2))
}

/// `a b'`.
#[inline(always)]
#[must_use]
pub fn outer<T: Number>(a: &Vector3<T>, b: &Vector3<T>) -> Matrix3<T> {
    Matrix3::from_columns(&[a * b[0], a * b[1], a * b[2]])
}

/// `m + s I`.
#[inline(always)]
#[must_use]
pub fn plus_diagonal<T: Number>(mut m: Matrix3<T>, s: T) -> Matrix3<T> {
    for i in 0..3 {
        m[(i, i)] += s;
    }
    m
}
