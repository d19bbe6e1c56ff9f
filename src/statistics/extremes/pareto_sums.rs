//! Means over excesses that the likelihood of the generalized Pareto law is made of.
//!
//! Of excesses `y` over their greatest, and a ratio `t` above -1, the likelihood needs the means of `ln(1 + t y)` and of `1/(1 + t y)` alone.
//! Logarithms are those of products: the factors lie between 1e-16 and 1e18, so sixteen of them neither over- nor underflow, and the power of two of
//! their product is taken apart before the next. Four reciprocals share a division. There are four partial sums whatever the processor
//! ([`ARCH`]), without fused products, so that the bits are the same on all.

use std::cell::OnceCell;
use std::f64::consts::LN_2;

use pulp::{Simd, WithSimd};

use crate::numerics::processor::{ARCH, LANES, Lanes};

/// Excesses that share divisions.
type ExcessRows = [Lanes; 4];

/// Rows whose factors make a product before its power of two is taken apart: sixteen factors a lane.
const ROWS: usize = 4;

/// Ratios, without sign, below which the means are series.
const SERIES: f64 = 0.1;
/// The greatest ratio whose products of sixteen do not overflow.
const GREATEST: f64 = 1e18;
/// Terms of the series: the next one is below rounding.
const TERMS: usize = 17;

/// Excesses over their greatest, for means over all of them.
#[derive(Debug, Clone)]
pub(super) struct UnitExcesses {
    rows: Vec<ExcessRows>,
    /// Zeros that fill the last rows.
    padding: f64,
    count: usize,
    greatest: f64,
    /// Means of the powers from the first on, once they are needed.
    powers: OnceCell<[f64; TERMS]>,
    /// Mean and mean square.
    first_powers: [f64; 2],
}

/// The means at a ratio `t`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Means {
    /// Mean of `ln(1 + t y)`: the shape of greatest likelihood at this ratio.
    pub(super) log: f64,
    /// That over `t`: the scale.
    pub(super) scale: f64,
    /// Mean of `1/(1 + t y)`.
    pub(super) inverse: f64,
    /// Fall of the logarithm of the scale with the ratio.
    pub(super) fall: f64,
    /// Rise of the shape with the ratio: mean of `y/(1 + t y)`.
    pub(super) rise: f64,
}

impl UnitExcesses {
    /// Of excesses above zero, at least one.
    pub(super) fn new(excesses: &[f64]) -> Self {
        let greatest = excesses.iter().copied().fold(0.0, f64::max);
        let mut rows = vec![[[0.0; LANES]; 4]; excesses.len().div_ceil(4 * LANES)];
        let (mut first, mut second) = (0.0, 0.0);
        let places = rows.as_flattened_mut().as_flattened_mut();
        for (place, excess) in places.iter_mut().zip(excesses) {
            let y = excess / greatest;
            *place = y;
            first += y;
            second += y * y;
        }
        let count = excesses.len() as f64;
        Self {
            padding: places.len() as f64 - count,
            rows,
            count: excesses.len(),
            greatest,
            powers: OnceCell::new(),
            first_powers: [first / count, second / count],
        }
    }

    /// The number of excesses.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// The greatest of them, in the unit of the values.
    pub(super) fn greatest(&self) -> f64 {
        self.greatest
    }

    /// At a finite ratio above -1.
    pub(super) fn means(&self, ratio: f64) -> Means {
        if ratio.abs() <= SERIES {
            return self.by_series(ratio);
        }
        let sums = if ratio < GREATEST {
            ARCH.dispatch(SumLoop {
                rows: &self.rows,
                ratio,
            })
        } else {
            self.one_by_one(ratio)
        };
        let count = self.count as f64;
        let inverse = (sums.inverse - self.padding) / count;
        let log = sums.log / count;
        let rise = (1.0 - inverse) / ratio;
        Means {
            log,
            scale: log / ratio,
            inverse,
            fall: 1.0 / ratio - rise / log,
            rise,
        }
    }

    /// The sums by single logarithms.
    fn one_by_one(&self, ratio: f64) -> Sums {
        let all = self.rows.as_flattened().as_flattened().iter();
        all.fold(Sums::default(), |sums, y| Sums {
            log: sums.log + (ratio * y).ln_1p(),
            inverse: sums.inverse + 1.0 / (1.0 + ratio * y),
        })
    }

    /// Where the closed forms cancel: `ln(1 + x)` and its derivatives by their series.
    fn by_series(&self, ratio: f64) -> Means {
        let [mean, square] = self.first_powers;
        if ratio == 0.0 {
            return Means {
                log: 0.0,
                scale: mean,
                inverse: 1.0,
                fall: 0.5 * square / mean,
                rise: mean,
            };
        }
        let powers = self
            .powers
            .get_or_init(|| powers(&self.rows, self.count as f64));
        // Horner's rule from the last term on; `slope` is minus the derivative of the scale.
        let (mut scale, mut slope, mut rise) = (0.0, 0.0, 0.0);
        for (j, power) in powers.iter().enumerate().rev() {
            let order = j as f64;
            scale = power / (order + 1.0) - ratio * scale;
            rise = power - ratio * rise;
            if j > 0 {
                slope = order * power / (order + 1.0) - ratio * slope;
            }
        }
        Means {
            log: ratio * scale,
            scale,
            inverse: 1.0 - ratio * rise,
            fall: slope / scale,
            rise,
        }
    }
}

/// Means of the powers.
fn powers(rows: &[ExcessRows], count: f64) -> [f64; TERMS] {
    let mut sums = [[0.0; LANES]; TERMS];
    for lanes in rows.as_flattened() {
        let mut power = *lanes;
        for sum in &mut sums {
            for lane in 0..LANES {
                sum[lane] += power[lane];
                power[lane] *= lanes[lane];
            }
        }
    }
    sums.map(|lanes| total(lanes) / count)
}

/// The sum of the partial sums, always in this order.
fn total(lanes: Lanes) -> f64 {
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
}

/// Sums of `ln(1 + t y)` and of `1/(1 + t y)`.
#[derive(Debug, Default, PartialEq)]
struct Sums {
    log: f64,
    inverse: f64,
}

/// The loop over all excesses, as code that is compiled for several processors.
struct SumLoop<'a> {
    rows: &'a [ExcessRows],
    ratio: f64,
}

/// The digits of a number that is not its power of two, and the power of one.
const DIGITS: u64 = (1 << 52) - 1;
const ONE: u64 = 1023 << 52;

impl WithSimd for SumLoop<'_> {
    type Output = Sums;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Sums {
        let mut inverse = [0.0; LANES];
        let mut product = [1.0_f64; LANES];
        let mut power = [0_u64; LANES];
        let mut parts = 0_u32;
        for rows in self.rows.chunks(ROWS) {
            for row in rows {
                add(&mut inverse, &mut product, row, self.ratio);
            }
            for lane in 0..LANES {
                let bits = product[lane].to_bits();
                power[lane] += bits >> 52;
                product[lane] = f64::from_bits(bits & DIGITS | ONE);
            }
            parts += 1;
        }
        let powers: u64 = power.iter().sum();
        let powers = powers as f64 - 1023.0 * LANES as f64 * f64::from(parts);
        let product = (product[0] * product[1]) * (product[2] * product[3]);
        Sums {
            log: product.ln() + powers * LN_2,
            inverse: total(inverse),
        }
    }
}

/// Adds four excesses a lane: `1/a + 1/b + 1/c + 1/d = ((a + b) c d + (c + d) a b)/(a b c d)`.
#[inline(always)]
fn add(inverse: &mut Lanes, product: &mut Lanes, row: &ExcessRows, ratio: f64) {
    for lane in 0..LANES {
        let factor = |k: usize| 1.0 + ratio * row[k][lane];
        let (a, b, c, d) = (factor(0), factor(1), factor(2), factor(3));
        let (ab, cd) = (a * b, c * d);
        let all = ab * cd;
        inverse[lane] += ((a + b) * cd + (c + d) * ab) / all;
        product[lane] *= all;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::random::Random;

    fn excesses(count: usize) -> Vec<f64> {
        let mut random = Random::new(count as u64, 8);
        (0..count).map(|_| -random.uniform().ln()).collect()
    }

    /// From the least ratio to the greatest, the equal greatest excesses of a record that was cut off among them.
    #[test]
    fn means_are_those_of_single_logarithms() {
        for count in [1, 3, 16, 17, 30, 257, 1000] {
            let mut excesses = excesses(count);
            let most = excesses.iter().copied().fold(0.0, f64::max);
            for y in excesses.iter_mut().take(count / 2) {
                *y = if count == 257 { most } else { *y };
            }
            let unit = UnitExcesses::new(&excesses);
            for u in [
                -36.0, -20.0, -3.0, -0.2, -0.1, 0.09, 0.1, 0.7, 5.0, 24.0, 40.0, 42.0, 600.0_f64,
            ] {
                let ratio = u.exp_m1();
                let mean = |f: &dyn Fn(f64) -> f64| {
                    excesses.iter().map(|y| f(y / most)).sum::<f64>() / count as f64
                };
                let log = mean(&|y| (ratio * y).ln_1p());
                let inverse = mean(&|y| 1.0 / (1.0 + ratio * y));
                let rise = mean(&|y| y / (1.0 + ratio * y));
                let found = unit.means(ratio);
                let near = |a: f64, b: f64| (a - b).abs() < 1e-13 * (1.0 + b.abs());
                assert!(near(found.log, log), "{count} {u}: {found:?}, {log}");
                assert!(near(found.inverse, inverse), "{count} {u}: {found:?}");
                assert!((found.rise / rise - 1.0).abs() < 1e-12, "{count} {u}");
                assert!((found.scale * ratio / log - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn the_means_are_smooth_across_the_series() {
        let unit = UnitExcesses::new(&excesses(200));
        for ratio in [SERIES, -SERIES] {
            let (inside, outside) = (
                unit.means(ratio * (1.0 - 1e-15)),
                unit.means(ratio * (1.0 + 1e-14)),
            );
            for (a, b) in [
                (inside.log, outside.log),
                (inside.scale, outside.scale),
                (inside.fall, outside.fall),
                (inside.rise, outside.rise),
                (inside.inverse, outside.inverse),
            ] {
                assert!((a / b - 1.0).abs() < 2e-13, "{inside:?} {outside:?}");
            }
        }
        let near = unit.means(1e-9);
        let zero = unit.means(0.0);
        assert!((near.fall / zero.fall - 1.0).abs() < 1e-8);
    }

    #[test]
    fn the_fall_is_that_of_the_scale() {
        let unit = UnitExcesses::new(&excesses(60));
        let h = 1e-5;
        for ratio in [-0.7, -0.05, 0.02, 0.4, 30.0] {
            let logs = [ratio + h, ratio - h].map(|t| unit.means(t).scale.ln());
            let fall = (logs[1] - logs[0]) / (2.0 * h);
            assert!((unit.means(ratio).fall - fall).abs() < 1e-9, "{ratio}");
        }
    }

    #[test]
    fn wide_vectors_have_the_same_bits() {
        let unit = UnitExcesses::new(&excesses(333));
        for ratio in [-1.0 + 1e-15, -0.3, 0.2, 1e10] {
            let made = || SumLoop {
                rows: &unit.rows,
                ratio,
            };
            let narrow = made().with_simd(pulp::Scalar::new());
            assert_eq!(ARCH.dispatch(made()), narrow);
        }
    }
}
