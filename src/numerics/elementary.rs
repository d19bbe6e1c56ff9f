//! Exponentials and logarithms of many numbers, without branches, so that a processor takes several at a time ([`ARCH`]); without fused products
//! their bits are the same on all.
//!
//! The logarithm is that of fdlibm (Sun Microsystems 1993), `e_log.c`, within an ulp; the exponential a Taylor series of what is left of a power of two.

use std::f64::consts::LOG2_E;

use pulp::{Simd, WithSimd};

use super::processor::{ARCH, LANES};

/// The parts of ln 2: the first is exact times any power of two.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// 1.5 times 2^52: added to a small number it leaves its nearest whole number in the last bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Replaces each number from -700 to 700 by `exp(x) - 1`.
pub fn exp_m1_each(numbers: &mut [f64]) {
    ARCH.dispatch(Each(numbers, exp_m1));
}

/// Replaces each positive number that is not subnormal by its logarithm.
pub fn ln_each(numbers: &mut [f64]) {
    ARCH.dispatch(Each(numbers, ln));
}

/// Replaces each number above -1 by `ln(1 + x)`.
pub fn ln_1p_each(numbers: &mut [f64]) {
    ARCH.dispatch(Each(numbers, ln_1p));
}

/// The sum of `exp(factor x)` over numbers, of which no product is above 700; one below -700 counts as nothing.
pub fn sum_exp(numbers: &[f64], factor: f64) -> f64 {
    ARCH.dispatch(SumExp(numbers, factor))
}

/// The loop of the sum, with four partial sums.
struct SumExp<'a>(&'a [f64], f64);

impl WithSimd for SumExp<'_> {
    type Output = f64;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> f64 {
        let mut sums = [0.0; LANES];
        let (fours, rest) = self.0.as_chunks::<LANES>();
        for four in fours {
            for (sum, x) in sums.iter_mut().zip(four) {
                *sum += exp_m1((self.1 * x).max(-700.0)) + 1.0;
            }
        }
        for (sum, x) in sums.iter_mut().zip(rest) {
            *sum += exp_m1((self.1 * x).max(-700.0)) + 1.0;
        }
        (sums[0] + sums[1]) + (sums[2] + sums[3])
    }
}

/// A function of each number, as code that is compiled for several processors.
struct Each<'a, F>(&'a mut [f64], F);

impl<F: Fn(f64) -> f64> WithSimd for Each<'_, F> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for number in self.0 {
            *number = (self.1)(*number);
        }
    }
}

#[inline(always)]
fn exp_m1(x: f64) -> f64 {
    let shifted = x * LOG2_E + WHOLE;
    let power = shifted - WHOLE;
    let x = (x - power * LN_2_HIGH) - power * LN_2_LOW;
    // To x^13/13!: the next term is below rounding for half of ln 2.
    let mut series = 1.0 / 6_227_020_800.0;
    for inverse in [
        1.0 / 479_001_600.0,
        1.0 / 39_916_800.0,
        1.0 / 3_628_800.0,
        1.0 / 362_880.0,
        1.0 / 40_320.0,
        1.0 / 5_040.0,
        1.0 / 720.0,
        1.0 / 120.0,
        1.0 / 24.0,
        1.0 / 6.0,
        0.5,
    ] {
        series = series * x + inverse;
    }
    let rest = x + x * x * series;
    let two = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    two * rest + (two - 1.0)
}

#[inline(always)]
fn ln(x: f64) -> f64 {
    // x is m 2^k with m from the root of 1/2 to that of 2.
    const ROOT_HALF: u64 = 0x3fe6_a09e_0000_0000;
    const ONE: u64 = 1023 << 52;
    const DIGITS: u64 = (1 << 52) - 1;
    let bits = x.to_bits().wrapping_add(ONE - ROOT_HALF);
    // The exponent as a number: behind 2^52 it is the last bits.
    let exponent = f64::from_bits((bits >> 52) | (1075 << 52)) - (4_503_599_627_370_496.0 + 1023.0);
    let f = f64::from_bits((bits & DIGITS) + ROOT_HALF) - 1.0;
    let half = 0.5 * f * f;
    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let even = w
        * (0.399_999_999_994_094_2 + w * (0.222_221_984_321_497_84 + w * 0.153_138_376_992_093_73));
    let odd = z
        * (0.666_666_666_666_673_5
            + w * (0.285_714_287_436_623_9
                + w * (0.181_835_721_616_180_5 + w * 0.147_981_986_051_165_86)));
    s * (half + (even + odd)) + exponent * LN_2_LOW - half + f + exponent * LN_2_HIGH
}

#[inline(always)]
fn ln_1p(x: f64) -> f64 {
    // What rounding took from 1 + x is added again.
    let one = 1.0 + x;
    ln(one) + (x - (one - 1.0)) / one
}

#[cfg(test)]
mod tests {
    use std::f64::consts::LN_2;

    use super::*;
    use crate::random::Random;

    /// Within a few units of the last place of the standard library's.
    #[test]
    fn they_are_those_of_the_standard_library() {
        let mut random = Random::new(4, 2);
        let mut off = [0.0_f64; 3];
        for _ in 0..300_000 {
            let size = random.power(-12.0, 2.8);
            let x = if random.chance(0.5) { size } else { -size };
            let apart = |a: f64, b: f64| ((a - b) / b).abs() / f64::EPSILON;
            off[0] = off[0].max(apart(exp_m1(x), x.exp_m1()));
            let positive = random.power(-300.0, 300.0);
            off[1] = off[1].max(apart(ln(positive), positive.ln()));
            let near = 1.0 + x.clamp(-0.5, 0.5);
            if near != 1.0 {
                off[1] = off[1].max(apart(ln(near), near.ln()));
            }
            let above = if x > -1.0 {
                x
            } else {
                -1.0 + random.power(-15.0, 0.0)
            };
            off[2] = off[2].max(apart(ln_1p(above), above.ln_1p()));
        }
        assert!(off.iter().all(|off| *off < 4.0), "{off:?}");
        assert_eq!([exp_m1(0.0), ln(1.0), ln_1p(0.0)], [0.0; 3]);
        assert!((exp_m1(700.0) / 700_f64.exp_m1() - 1.0).abs() < 1e-14);
        assert!((LN_2_HIGH + LN_2_LOW - LN_2).abs() < 1e-16);
    }

    #[test]
    fn wide_vectors_have_the_same_bits() {
        let mut random = Random::new(5, 2);
        let numbers: Vec<f64> = (0..1003).map(|_| random.power(-3.0, 2.0)).collect();
        for (each, one) in [
            (exp_m1_each as fn(&mut [f64]), exp_m1 as fn(f64) -> f64),
            (ln_each, ln),
            (ln_1p_each, ln_1p),
        ] {
            let mut together = numbers.clone();
            each(&mut together);
            let single: Vec<f64> = numbers.iter().map(|x| one(*x)).collect();
            assert_eq!(together, single);
        }
        let sum = SumExp(&numbers, -0.1).with_simd(pulp::Scalar::new());
        assert_eq!(sum_exp(&numbers, -0.1), sum);
        let each: f64 = numbers.iter().map(|x| (-0.1 * x).exp()).sum();
        assert!((sum / each - 1.0).abs() < 1e-13);
    }
}
