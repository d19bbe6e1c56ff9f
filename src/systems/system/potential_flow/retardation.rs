//! Retardation functions: radiated waves as a memory of past velocities.
//!
//! ```text
//! F(t) = - A_inf v'(t) - int_0^inf K(tau) v(t - tau) dtau      K(tau) = 2/pi int_0^inf B(omega) cos(omega tau) domega
//! A(omega) = A_inf - 1/omega int K sin(omega tau) dtau          B(omega) = int K cos(omega tau) dtau
//! ```
//!
//! (Cummins 1962; Ogilvie 1964). B is taken at even steps of frequency, straight lines between those of the file, up to the highest of the
//! file; below the lowest it falls with the cube of frequency, as that of heave does (Haskind's relation). K is their sum of cosines over half the period of the step, on which cosines are orthogonal: B comes back exactly at these
//! frequencies, however sharply it peaks. In time K is a straight line between the points of a fine grid, up to where it has died away; what
//! is lost is stated by transforming it back.

use std::f64::consts::{FRAC_2_PI, PI, TAU};

use nalgebra::{Matrix6, Vector6};
use pulp::{Simd, WithSimd};

use super::RadiationTable;
use crate::numerics::interpolation::linear_clamped;
use crate::numerics::processor::{ARCH, LANES, Lanes};

/// Points of the grid in a period of the highest frequency.
const POINTS: f64 = 24.0;
/// Share of its greatest value below which a function has died away.
const FAINT: f64 = 1e-3;
/// Longest memory \[s\], and most steps of frequency.
const LONGEST: f64 = 200.0;
const MOST_STEPS: f64 = 512.0;
/// Relative difference of intervals of frequency that count as the same.
const EVEN: f64 = 1e-3;
/// Greatest number of functions of a body.
pub const PAIRS: usize = 36;
/// Fours of functions.
const FOURS: usize = PAIRS / LANES;
/// Damping by that of the modes themselves that counts as none.
const NOTHING: f64 = 1e-5;

/// One function, of velocity j on load i, at the points of the grid.
#[derive(Debug, Clone, PartialEq)]
struct RetardationFunction {
    i: usize,
    j: usize,
    value: Vec<f64>,
}

/// At the points of the grid the values of all functions, their integrals from 0 and the integrals of these, four side by side: a convolution reads
/// them together.
#[derive(Debug, Clone, PartialEq)]
struct Points {
    /// Fours of functions, the last filled up with those of nothing.
    fours: usize,
    /// The last point but one.
    last: usize,
    numbers: Vec<Lanes>,
}

impl Points {
    /// Of functions at even times \[s\].
    fn of_functions(functions: &[RetardationFunction], step: f64) -> Self {
        let count = functions.first().map_or(2, |f| f.value.len());
        let fours = functions.len().div_ceil(LANES);
        let mut numbers = vec![[0.0; LANES]; 3 * fours * count];
        for (p, function) in functions.iter().enumerate() {
            let (first, second) = integrals(&function.value, step);
            for (k, point) in numbers.chunks_exact_mut(3 * fours).enumerate() {
                let (at, lane) = (p / LANES, p % LANES);
                point[at][lane] = function.value[k];
                point[fours + at][lane] = first[k];
                point[2 * fours + at][lane] = second[k];
            }
        }
        Self {
            fours,
            last: count - 2,
            numbers,
        }
    }

    /// Values, integrals and integrals of these of four functions at a point.
    #[inline(always)]
    fn at(&self, k: usize, four: usize) -> [&Lanes; 3] {
        let first = 3 * self.fours * k + four;
        let numbers = &self.numbers;
        [
            &numbers[first],
            &numbers[first + self.fours],
            &numbers[first + 2 * self.fours],
        ]
    }
}

/// The retardation functions of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Retardation {
    step: f64,
    /// Its inverse, and that of six times it.
    rate: f64,
    sixth: f64,
    functions: Vec<RetardationFunction>,
    points: Points,
    /// Added mass at infinite frequency \[kg, kg m, kg m²\].
    pub at_infinity: Matrix6<f64>,
    /// Greatest difference of the damping transformed back, by the greatest of its pair of modes \[-\].
    pub error: f64,
}

impl Retardation {
    /// The functions of a table.
    #[must_use]
    pub fn new(table: &RadiationTable) -> Self {
        let omega = even_frequencies(table);
        let step = TAU / omega[omega.len() - 1] / POINTS;
        let longest = PI / omega[0];
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a count of points"
        )]
        let count = (longest / step).round() as usize + 1;
        let pairs = pairs(table);
        let sampled = pairs
            .iter()
            .map(|&pair| sample(table, pair, &omega, (step, count)));
        let mut values: Vec<Vec<f64>> = sampled.collect();
        let kept = values.iter().map(|value| alive(value)).max().unwrap_or(1);
        for value in &mut values {
            value.truncate(kept.max(2));
        }
        let functions = pairs.iter().zip(values);
        let functions: Vec<RetardationFunction> = functions
            .map(|(&(i, j), value)| RetardationFunction { i, j, value })
            .collect();
        let mut made = Self {
            step,
            rate: 1.0 / step,
            sixth: 1.0 / (6.0 * step),
            points: Points::of_functions(&functions, step),
            functions,
            at_infinity: Matrix6::zeros(),
            error: 0.0,
        };
        made.at_infinity = table
            .at_infinity
            .unwrap_or_else(|| made.mean_at_infinity(table));
        made.error = made.difference(table);
        made
    }

    /// Time over which it lasts \[s\].
    #[must_use]
    pub fn duration(&self) -> f64 {
        let points = self.functions.first().map_or(1, |f| f.value.len());
        self.step * (points - 1) as f64
    }

    /// The pairs of modes, load and velocity, in the order of their functions.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> {
        self.functions.iter().map(|f| (f.i, f.j))
    }

    /// The first integral of every function over the times before tau \[s\].
    pub fn first_integrals(&self, tau: f64, out: &mut [f64; PAIRS]) {
        let (k, s) = self.place(tau);
        let s = s.min(self.step);
        let curve = 0.5 * s * s / self.step;
        for (four, out) in out
            .chunks_exact_mut(LANES)
            .take(self.points.fours)
            .enumerate()
        {
            let [value, first, _] = self.points.at(k, four);
            let [next, ..] = self.points.at(k + 1, four);
            for p in 0..LANES {
                out[p] = first[p] + s * value[p] + curve * (next[p] - value[p]);
            }
        }
    }

    /// The integral of that, which is straight beyond the memory.
    pub fn second_integrals(&self, tau: f64, out: &mut [f64; PAIRS]) {
        let at = self.place(tau);
        for (four, out) in out
            .chunks_exact_mut(LANES)
            .take(self.points.fours)
            .enumerate()
        {
            out.copy_from_slice(&self.four_seconds(at, four));
        }
    }

    /// Fours of functions, the last filled up with those of nothing.
    pub const fn fours(&self) -> usize {
        self.points.fours
    }

    /// Velocities, or slopes of them, as each of the functions acts by them.
    pub fn side_by_side(&self, velocity: &Vector6<f64>) -> impl Iterator<Item = Lanes> {
        self.functions.chunks(LANES).map(|functions| {
            let mut four = [0.0; LANES];
            for (own, function) in four.iter_mut().zip(functions) {
                *own = velocity[function.j];
            }
            four
        })
    }

    /// Adds to a convolution what changes of every function's second integral between times before now \[s\] bring, times slopes of the
    /// velocities it acts by, [side by side](Self::side_by_side).
    pub fn convolve(
        &self,
        (rows, slopes): (&[(f64, Vector6<f64>)], &[Lanes]),
        now: f64,
        sum: &mut [f64; PAIRS],
    ) {
        ARCH.dispatch(Convolution {
            of: self,
            rows,
            slopes,
            now,
            sum,
        });
    }

    /// Second integrals of four functions.
    #[inline(always)]
    fn four_seconds(&self, (k, s): (usize, f64), four: usize) -> Lanes {
        let [value, integral, second] = self.points.at(k, four);
        let [next, next_integral, _] = self.points.at(k + 1, four);
        let beyond = (s - self.step).max(0.0);
        let s = s - beyond;
        let (square, cube) = (0.5 * s * s, s * s * s * self.sixth);
        let mut out = [0.0; LANES];
        for p in 0..LANES {
            out[p] = second[p]
                + s * integral[p]
                + square * value[p]
                + cube * (next[p] - value[p])
                + beyond * next_integral[p];
        }
        out
    }

    /// The interval of the grid that holds a time, the last one beyond, and the distance into it.
    #[inline(always)]
    fn place(&self, tau: f64) -> (usize, f64) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "tau is not negative; large ones are clamped"
        )]
        let k = ((tau * self.rate) as u32 as usize).min(self.points.last);
        (k, tau - k as f64 * self.step)
    }

    /// Added mass and damping that the functions give back at a frequency \[rad/s\].
    #[must_use]
    pub fn transformed_back(&self, omega: f64) -> (Matrix6<f64>, Matrix6<f64>) {
        let (mut added, mut damping) = (self.at_infinity, Matrix6::zeros());
        for function in &self.functions {
            let (beyond, here) = self.transformed(function, omega);
            added[(function.i, function.j)] += beyond;
            damping[(function.i, function.j)] = here;
        }
        (added, damping)
    }

    /// Added mass less that at infinite frequency, and damping, of a function at a frequency.
    fn transformed(&self, function: &RetardationFunction, omega: f64) -> (f64, f64) {
        let (mut sine, mut cosine) = (0.0, 0.0);
        for (k, pair) in function.value.windows(2).enumerate() {
            let from = k as f64 * self.step;
            let (c, s) = line_transform(pair, from, self.step, omega);
            cosine += c;
            sine += s;
        }
        (-sine / omega, cosine)
    }

    /// Added mass at infinite frequency as the mean over the frequencies of what they give for it.
    fn mean_at_infinity(&self, table: &RadiationTable) -> Matrix6<f64> {
        let count = table.omega.len() as f64;
        let mut mean: Matrix6<f64> = table.added.iter().sum::<Matrix6<f64>>() / count;
        for function in &self.functions {
            let beyond = table.omega.iter().map(|w| self.transformed(function, *w).0);
            mean[(function.i, function.j)] -= beyond.sum::<f64>() / count;
        }
        mean
    }

    /// Greatest difference of the damping transformed back, by the greatest of the modes it joins.
    fn difference(&self, table: &RadiationTable) -> f64 {
        let peak = peaks(table);
        let mut worst = 0.0_f64;
        for function in &self.functions {
            let (i, j) = (function.i, function.j);
            for (omega, damping) in table.omega.iter().zip(&table.damping) {
                let back = self.transformed(function, *omega).1;
                let size = (peak[i] * peak[j]).sqrt();
                worst = worst.max((back - damping[(i, j)]).abs() / size);
            }
        }
        worst
    }
}

/// [`Retardation::convolve`] as code that is compiled for several processors.
struct Convolution<'a> {
    of: &'a Retardation,
    rows: &'a [(f64, Vector6<f64>)],
    slopes: &'a [Lanes],
    now: f64,
    sum: &'a mut [f64; PAIRS],
}

impl WithSimd for Convolution<'_> {
    type Output = ();

    #[expect(
        clippy::needless_range_loop,
        reason = "iterators are not compiled for wide vectors everywhere"
    )]
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Some(((first, _), later)) = self.rows.split_first() else {
            return;
        };
        let of = self.of;
        let (mut before, mut sums) = ([[0.0; LANES]; FOURS], [[0.0; LANES]; FOURS]);
        let at = of.place(self.now - first);
        for four in 0..of.fours() {
            before[four] = of.four_seconds(at, four);
        }
        for row in 0..later.len() {
            let at = of.place(self.now - later[row].0);
            let slopes = &self.slopes[row * of.fours()..][..of.fours()];
            for four in 0..slopes.len() {
                let after = of.four_seconds(at, four);
                for p in 0..LANES {
                    sums[four][p] += (before[four][p] - after[p]) * slopes[four][p];
                }
                before[four] = after;
            }
        }
        for (sum, four) in self.sum.chunks_exact_mut(LANES).zip(sums) {
            for p in 0..LANES {
                sum[p] += four[p];
            }
        }
    }
}

/// Greatest damping of each mode.
fn peaks(table: &RadiationTable) -> [f64; 6] {
    std::array::from_fn(|i| {
        let own = table.damping.iter().map(|b| b[(i, i)].abs());
        own.fold(f64::MIN_POSITIVE, f64::max)
    })
}

/// The pairs of modes with damping.
fn pairs(table: &RadiationTable) -> Vec<(usize, usize)> {
    let peak = peaks(table);
    let all = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
    let acts = |&(i, j): &(usize, usize)| {
        let own = table.damping.iter().map(|b| b[(i, j)].abs());
        own.fold(0.0, f64::max) > NOTHING * (peak[i] * peak[j]).sqrt()
    };
    all.filter(acts).collect()
}

/// Multiples of a step of frequency up to the highest of a table: its own where it is even, else as fine as the memory allows.
fn even_frequencies(table: &RadiationTable) -> Vec<f64> {
    let highest = table.omega[table.omega.len() - 1];
    let widths = || table.omega.windows(2).map(|pair| pair[1] - pair[0]);
    let (least, most) = (
        widths().fold(f64::INFINITY, f64::min),
        widths().fold(0.0, f64::max),
    );
    let even = most < least * (1.0 + EVEN);
    let own = if even { 0.5 * (least + most) } else { least };
    let width = own.max(PI / LONGEST).max(highest / MOST_STEPS);
    let count = (1_u32..).take_while(|k| f64::from(*k) * width <= highest * (1.0 + EVEN));
    count.map(|k| f64::from(k) * width).collect()
}

/// A function at the points of the grid.
fn sample(
    table: &RadiationTable,
    (i, j): (usize, usize),
    omega: &[f64],
    (step, count): (f64, usize),
) -> Vec<f64> {
    let mut known = vec![0.0];
    known.extend(&table.omega);
    let mut damping = vec![0.0];
    damping.extend(table.damping.iter().map(|b| b[(i, j)]));
    let damping_at = |w: f64| match w < table.omega[0] {
        true => damping[1] * (w / table.omega[0]).powi(3),
        false => linear_clamped(&known, &damping, w),
    };
    let weight = FRAC_2_PI * omega[0];
    let even = omega.iter().map(|w| (*w, weight * damping_at(*w)));
    let even: Vec<(f64, f64)> = even.collect();
    let at = |tau: f64| even.iter().map(|(w, b)| b * (w * tau).cos()).sum();
    (0..count).map(|k| at(k as f64 * step)).collect()
}

/// Integrals of a straight line, from one value to another over an interval of this width, times `cos(p x)` and `sin(p x)`.
fn line_transform(ends: &[f64], from: f64, width: f64, p: f64) -> (f64, f64) {
    let (a, b) = (ends[0], ends[1]);
    let (half, middle) = (0.5 * width, from + 0.5 * width);
    let q = p * half;
    // Of 1 and of x / half over -1 to 1, times cos(q x) and sin(q x).
    let (even, odd) = if q.abs() < 1e-2 {
        let q2 = q * q;
        (
            2.0 - q2 / 3.0 + q2 * q2 / 60.0,
            2.0 * q * (1.0 / 3.0 - q2 / 30.0 + q2 * q2 / 840.0),
        )
    } else {
        (2.0 * q.sin() / q, 2.0 * (q.sin() - q * q.cos()) / (q * q))
    };
    let (mean, slope) = (0.5 * (a + b), 0.5 * (b - a));
    let (sin, cos) = (p * middle).sin_cos();
    let (level, tilted) = (half * mean * even, half * slope * odd);
    (level * cos - tilted * sin, level * sin + tilted * cos)
}

/// Points after which a function has died away.
fn alive(value: &[f64]) -> usize {
    let greatest = value.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let last = value.iter().rposition(|v| v.abs() > FAINT * greatest);
    last.map_or(1, |last| last + 1)
}

/// The integral of straight lines from the start, and the integral of that, at the points.
fn integrals(value: &[f64], step: f64) -> (Vec<f64>, Vec<f64>) {
    let (mut first, mut second) = (vec![0.0], vec![0.0]);
    for (k, pair) in value.windows(2).enumerate() {
        second.push(second[k] + step * (first[k] + step * (pair[0] / 3.0 + pair[1] / 6.0)));
        first.push(first[k] + 0.5 * step * (pair[0] + pair[1]));
    }
    (first, second)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Damping of heave with one peak.
    fn peaked() -> RadiationTable {
        let omega: Vec<f64> = (1..=30).map(|k| 0.1 * f64::from(k)).collect();
        let one = |value: f64| {
            let mut matrix = Matrix6::zeros();
            matrix[(2, 2)] = value;
            matrix
        };
        RadiationTable {
            added: vec![one(1.0); omega.len()],
            damping: omega
                .iter()
                .map(|w| one((w / (1.0 + w.powi(4))).powi(2)))
                .collect(),
            omega,
            at_zero: None,
            at_infinity: Some(one(0.5)),
        }
    }

    #[test]
    fn integrals_are_those_of_the_function() {
        let made = Retardation::new(&peaked());
        let h = 1e-4;
        let mut out = [0.0; PAIRS];
        let mut second = |tau: f64| {
            made.second_integrals(tau, &mut out);
            out[0]
        };
        let first = |tau: f64| {
            let mut out = [0.0; PAIRS];
            made.first_integrals(tau, &mut out);
            out[0]
        };
        for tau in [0.3, 1.234, 5.0, made.duration() + 3.0] {
            let slope = (second(tau + h) - second(tau - h)) / (2.0 * h);
            assert!((slope - first(tau)).abs() < 1e-7, "{tau}");
        }
        assert_eq!(second(0.0), 0.0);
    }
}
