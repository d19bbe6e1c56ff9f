//! A tension-strain table: a monotone cubic through its points or straight between them, straight beyond the last.
//!
//! Slopes of the cubic at the points are harmonic means of those of the stretches at either side (Fritsch and Butland 1984,
//! doi 10.1137/0905021, their simple formula), at both ends that of the stretch there. Tension then rises
//! everywhere, without overshoot, and its slope has no jump, so that Newton and the time steps see none. A table that is
//! straight between its points has a jump of its slope at each: there the slope is that of the stretch beyond.

use super::elastic_tension::ElasticTension;
use crate::numerics::roots::Bracket;

/// How the tension runs between the points of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableInterpolation {
    /// By a monotone cubic without jumps of its slope.
    Smooth,
    /// Straight.
    Straight,
}

/// Tension of a rope over its strain.
#[derive(Debug, Clone, PartialEq)]
pub struct TensionTable {
    strain: Vec<f64>,
    tension: Vec<f64>,
    /// Slopes at both ends of each stretch between two points \[N\].
    slopes: Vec<[f64; 2]>,
    /// Energy per unstretched length that is stored at the points \[N\].
    stored: Vec<f64>,
}

impl TensionTable {
    /// Smooth, from strains \[-\] and tensions \[N\], both rising from zero; nothing where they are not, or fewer than two.
    #[must_use]
    pub fn new(strain: &[f64], tension: &[f64]) -> Option<Self> {
        Self::interpolated(strain, tension, TableInterpolation::Smooth)
    }

    /// The same, smooth or straight between the points.
    #[must_use]
    pub fn interpolated(
        strain: &[f64],
        tension: &[f64],
        between: TableInterpolation,
    ) -> Option<Self> {
        let rises = |list: &[f64]| {
            list.first() == Some(&0.0)
                && list.windows(2).all(|pair| pair[1] > pair[0])
                && list.iter().all(|v| v.is_finite())
        };
        if strain.len() != tension.len() || strain.len() < 2 || !rises(strain) || !rises(tension) {
            return None;
        }
        let secants: Vec<f64> = strain
            .windows(2)
            .zip(tension.windows(2))
            .map(|(e, t)| (t[1] - t[0]) / (e[1] - e[0]))
            .collect();
        let slopes = match between {
            TableInterpolation::Smooth => smooth_slopes(&secants),
            TableInterpolation::Straight => secants.iter().map(|slope| [*slope; 2]).collect(),
        };
        let mut table = Self {
            strain: strain.to_vec(),
            tension: tension.to_vec(),
            stored: vec![0.0; strain.len()],
            slopes,
        };
        for i in 1..strain.len() {
            table.stored[i] = table.stored[i - 1] + table.stored_within(i - 1, 1.0);
        }
        Some(table)
    }

    /// Tension and slope at a strain. Below zero, where only a rod goes, the line through zero goes on straight.
    #[must_use]
    pub fn at(&self, strain: f64) -> ElasticTension {
        let Some(i) = self.stretch(strain) else {
            let (i, slope) = self.beyond(strain);
            return ElasticTension {
                tension: self.tension[i] + slope * (strain - self.strain[i]),
                by_strain: slope,
            };
        };
        let (h, rise, d) = self.shape(i);
        let s = (strain - self.strain[i]) / h;
        // Hermite: T0 + s (h d0 + s (3 rise - h (2 d0 + d1) + s (h (d0 + d1) - 2 rise))).
        let (b, c) = (
            3.0 * rise - h * (2.0 * d[0] + d[1]),
            h * (d[0] + d[1]) - 2.0 * rise,
        );
        ElasticTension {
            tension: self.tension[i] + s * (h * d[0] + s * (b + s * c)),
            by_strain: d[0] + s * (2.0 * b + 3.0 * s * c) / h,
        }
    }

    /// Second derivative of the tension by strain \[N\]; it jumps at the points.
    #[must_use]
    pub fn bent(&self, strain: f64) -> f64 {
        let Some(i) = self.stretch(strain) else {
            return 0.0;
        };
        let (h, rise, d) = self.shape(i);
        let s = (strain - self.strain[i]) / h;
        let (b, c) = (
            3.0 * rise - h * (2.0 * d[0] + d[1]),
            h * (d[0] + d[1]) - 2.0 * rise,
        );
        (2.0 * b + 6.0 * s * c) / (h * h)
    }

    /// Energy stored per unstretched length at a strain \[N\].
    #[must_use]
    pub fn stored(&self, strain: f64) -> f64 {
        let Some(i) = self.stretch(strain) else {
            let (i, slope) = self.beyond(strain);
            let beyond = strain - self.strain[i];
            return self.stored[i] + beyond * (self.tension[i] + 0.5 * slope * beyond);
        };
        let s = (strain - self.strain[i]) / (self.strain[i + 1] - self.strain[i]);
        self.stored[i] + self.stored_within(i, s)
    }

    /// The strain at a tension \[N\].
    #[must_use]
    pub fn strain_at(&self, tension: f64) -> f64 {
        let last = self.last();
        if tension <= 0.0 {
            return tension / self.slopes[0][0];
        }
        if tension >= self.tension[last] {
            return self.strain[last] + (tension - self.tension[last]) / self.slopes[last - 1][1];
        }
        let i = self.tension.partition_point(|t| *t <= tension) - 1;
        let mut bracket = Bracket {
            low: self.strain[i],
            high: self.strain[i + 1],
        };
        let mut strain = bracket.middle();
        for _ in 0..60 {
            let here = self.at(strain);
            let residual = here.tension - tension;
            bracket.shrink(strain, residual);
            let next = bracket.newton(strain, residual, here.by_strain);
            if (next - strain).abs() <= 4.0 * f64::EPSILON * bracket.high {
                return next;
            }
            strain = next;
        }
        strain
    }

    /// A slope that none of the curve exceeds \[N\]: between two points a cubic of this kind is nowhere steeper than its
    /// ends and one and a half times its mean.
    #[must_use]
    pub fn max_stiffness(&self) -> f64 {
        let inside = (0..self.last()).map(|i| {
            let (h, rise, d) = self.shape(i);
            let mean = rise / h;
            match d == [mean; 2] {
                true => mean,
                false => d[0].max(d[1]).max(1.5 * mean),
            }
        });
        inside.fold(0.0, f64::max)
    }

    /// Tension by strain at the last point \[N\]: a representative stiffness of the table.
    #[must_use]
    pub fn representative_stiffness(&self) -> f64 {
        self.tension[self.last()] / self.strain[self.last()]
    }

    fn last(&self) -> usize {
        self.strain.len() - 1
    }

    /// The stretch between two points that a strain lies in; nothing beyond them.
    fn stretch(&self, strain: f64) -> Option<usize> {
        let i = self.strain.partition_point(|e| *e <= strain);
        (1..=self.last()).contains(&i).then(|| i - 1)
    }

    /// Width \[-\], rise \[N\] and end slopes \[N\] of a stretch.
    fn shape(&self, i: usize) -> (f64, f64, [f64; 2]) {
        (
            self.strain[i + 1] - self.strain[i],
            self.tension[i + 1] - self.tension[i],
            self.slopes[i],
        )
    }

    /// The point that a strain outside the table lies beyond, and the slope there \[N\].
    fn beyond(&self, strain: f64) -> (usize, f64) {
        match strain < 0.0 {
            true => (0, self.slopes[0][0]),
            false => (self.last(), self.slopes[self.last() - 1][1]),
        }
    }

    /// The greatest strain of the table, beyond which it goes on straight.
    #[must_use]
    pub fn greatest_strain(&self) -> f64 {
        self.strain[self.last()]
    }

    /// Energy per length between the point i and a share s of the stretch after it \[N\].
    fn stored_within(&self, i: usize, s: f64) -> f64 {
        let (h, rise, d) = self.shape(i);
        let (b, c) = (
            3.0 * rise - h * (2.0 * d[0] + d[1]),
            h * (d[0] + d[1]) - 2.0 * rise,
        );
        h * s * (self.tension[i] + s * (0.5 * h * d[0] + s * (b / 3.0 + 0.25 * s * c)))
    }
}

/// Slopes of the cubic at both ends of each stretch, by the mean slopes of the stretches.
fn smooth_slopes(secants: &[f64]) -> Vec<[f64; 2]> {
    let last = secants.len() - 1;
    let harmonic = |i: usize| 2.0 / (1.0 / secants[i] + 1.0 / secants[i + 1]);
    let before = |i: usize| {
        if i == 0 { secants[0] } else { harmonic(i - 1) }
    };
    let behind = |i: usize| {
        if i == last {
            secants[last]
        } else {
            harmonic(i)
        }
    };
    (0..=last).map(|i| [before(i), behind(i)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nylon() -> TensionTable {
        table(TableInterpolation::Smooth)
    }

    fn table(between: TableInterpolation) -> TensionTable {
        TensionTable::interpolated(&[0.0, 0.02, 0.05, 0.12], &[0.0, 1e4, 6e4, 4e5], between)
            .unwrap()
    }

    /// Half way between two rows there is half of both tensions; tension, slope, energy and strain go together, the slope
    /// at a row is that beyond it.
    #[test]
    fn straight_between_its_points() {
        let table = table(TableInterpolation::Straight);
        for (strain, tension) in [(0.01, 5e3), (0.035, 3.5e4), (0.085, 2.3e5), (0.19, 7.4e5)] {
            assert!((table.at(strain).tension - tension).abs() < 1e-9 * 4e5);
        }
        assert!((table.at(0.02).by_strain - 5e4 / 0.03).abs() < 1e-6);
        assert!((table.at(0.02 - 1e-9).by_strain - 5e5).abs() < 1e-6);
        assert!((table.max_stiffness() - 3.4e5 / 0.07).abs() < 1e-3);
        let h = 1e-7;
        for i in -5..80 {
            let strain = f64::from(i) * 2e-3 + 3e-4;
            let here = table.at(strain);
            let slope = (table.at(strain + h).tension - table.at(strain - h).tension) / (2.0 * h);
            assert!((slope / here.by_strain - 1.0).abs() < 1e-5, "{strain}");
            let force = (table.stored(strain + h) - table.stored(strain - h)) / (2.0 * h);
            assert!((force - here.tension).abs() < 1e-5 * 4e5, "{strain}");
            assert!(
                (table.strain_at(here.tension) - strain).abs() < 1e-12,
                "{strain}"
            );
            // Nothing but rounding, beside slopes of 4e5 N over 0.07.
            assert!(table.bent(strain).abs() < 1e-9 * 4e5);
        }
    }

    #[test]
    fn the_points_are_on_the_curve_and_it_rises_between_them() {
        let table = nylon();
        for (strain, tension) in [(0.0, 0.0), (0.02, 1e4), (0.05, 6e4), (0.12, 4e5)] {
            assert!((table.at(strain).tension - tension).abs() < 1e-9 * 4e5);
        }
        let mut before = table.at(-0.01);
        for i in -99..2000 {
            let here = table.at(f64::from(i) * 1e-4);
            assert!(here.tension > before.tension && here.by_strain > 0.0);
            assert!(here.by_strain <= table.max_stiffness());
            before = here;
        }
    }

    #[test]
    fn slope_energy_and_strain_go_with_the_tension() {
        let table = nylon();
        let h = 1e-7;
        for i in -5..80 {
            let strain = f64::from(i) * 2e-3 + 3e-4;
            let here = table.at(strain);
            let slope = (table.at(strain + h).tension - table.at(strain - h).tension) / (2.0 * h);
            assert!((slope / here.by_strain - 1.0).abs() < 1e-5, "{strain}");
            let force = (table.stored(strain + h) - table.stored(strain - h)) / (2.0 * h);
            assert!((force - here.tension).abs() < 1e-5 * 4e5, "{strain}");
            assert!(
                (table.strain_at(here.tension) - strain).abs() < 1e-12,
                "{strain}"
            );
        }
    }

    #[test]
    fn two_points_are_a_straight_line() {
        let table = TensionTable::new(&[0.0, 0.1], &[0.0, 5e5]).unwrap();
        for strain in [-0.02, 0.0, 0.03, 0.1, 0.2] {
            let here = table.at(strain);
            assert!((here.tension - 5e6 * strain).abs() < 1e-6);
            assert!((here.by_strain - 5e6).abs() < 1e-6);
        }
        assert!((table.representative_stiffness() - 5e6).abs() < 1e-6);
    }

    #[test]
    fn what_does_not_rise_from_zero_is_no_table() {
        for (strain, tension) in [
            (vec![0.0], vec![0.0]),
            (vec![0.0, 0.1], vec![1.0, 2.0]),
            (vec![0.0, 0.1, 0.1], vec![0.0, 1.0, 2.0]),
            (vec![0.0, 0.1, 0.2], vec![0.0, 2.0, 1.0]),
            (vec![0.0, 0.1], vec![0.0, 1.0, 2.0]),
            (vec![0.0, f64::NAN], vec![0.0, 1.0]),
        ] {
            assert!(TensionTable::new(&strain, &tension).is_none());
        }
    }
}
