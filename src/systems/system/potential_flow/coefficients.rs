//! Tables of coefficients over frequency and heading.

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix6, Vector6};

use crate::numerics::interpolation::{interval, mix, share};

/// Added mass \[kg, kg m, kg m²\] and damping \[N s/m, N s, N m s\] over angular frequency \[rad/s\].
#[derive(Debug, Clone, PartialEq)]
pub struct RadiationTable {
    /// Frequencies, rising.
    pub omega: Vec<f64>,
    /// Added mass at each.
    pub added: Vec<Matrix6<f64>>,
    /// Damping at each.
    pub damping: Vec<Matrix6<f64>>,
    /// Added mass at frequency zero, if the file has it.
    pub at_zero: Option<Matrix6<f64>>,
    /// Added mass at infinite frequency, if the file has it.
    pub at_infinity: Option<Matrix6<f64>>,
}

impl RadiationTable {
    /// Added mass for slow motions: at frequency zero, or at the lowest that is known.
    #[must_use]
    pub fn slow(&self) -> Matrix6<f64> {
        self.at_zero.unwrap_or_else(|| self.added[0])
    }
}

/// Complex numbers of several rows over frequency and heading.
#[derive(Debug, Clone, PartialEq)]
struct CoefficientGrid<T> {
    /// Headings towards which waves run, rising \[rad\].
    headings: Vec<f64>,
    /// Frequencies, rising \[rad/s\].
    omega: Vec<f64>,
    /// By heading, then by frequency.
    values: Vec<Vec<T>>,
}

/// A heading between two of a table, and the share of the way from one to the other.
struct HeadingInterval {
    from: usize,
    to: usize,
    share: f64,
}

/// Distance of headings that counts as none \[rad\].
const SAME: f64 = 1e-6;

impl<T> CoefficientGrid<T> {
    /// The headings around one; nothing where the table does not cover it.
    fn around(&self, heading: f64) -> Option<HeadingInterval> {
        let first = *self.headings.first()?;
        let last = *self.headings.last()?;
        let turned = first + (heading - first + SAME).rem_euclid(TAU) - SAME;
        if let Some(at) = self.headings.iter().position(|h| (h - turned).abs() < SAME) {
            return Some(HeadingInterval {
                from: at,
                to: at,
                share: 0.0,
            });
        }
        if turned < last {
            let from = interval(&self.headings, turned);
            return Some(HeadingInterval {
                from,
                to: from + 1,
                share: share(&self.headings, from, turned),
            });
        }
        // Around the circle, where no gap is wider than between other headings.
        let gap = first + TAU - last;
        let widest = self.headings.windows(2).map(|pair| pair[1] - pair[0]);
        (gap <= widest.fold(0.0, f64::max) * (1.0 + SAME)).then(|| HeadingInterval {
            from: self.headings.len() - 1,
            to: 0,
            share: (turned - last) / gap,
        })
    }

    /// The value at a heading and a frequency within the table, `mixed` between its neighbours; nothing where no heading covers it.
    fn at(&self, heading: f64, omega: f64, mixed: impl Fn(&T, &T, f64) -> T) -> Option<T> {
        let between = self.around(heading)?;
        let highest = self.omega.len() - 1;
        let row = |k: usize| {
            let values = &self.values[k];
            // The last value as it stands, which mixing would miss by a rounding.
            if omega >= self.omega[highest] {
                return mixed(&values[highest], &values[highest], 0.0);
            }
            let i = interval(&self.omega, omega);
            mixed(&values[i], &values[i + 1], share(&self.omega, i, omega))
        };
        let (from, to) = (row(between.from), row(between.to));
        Some(mixed(&from, &to, between.share))
    }
}

/// Loads of the first order per wave amplitude \[N/m, N\] over frequency and heading.
#[derive(Debug, Clone, PartialEq)]
pub struct ExcitationTable(CoefficientGrid<Vector6<Complex<f64>>>);

impl ExcitationTable {
    /// A table of rows by heading \[rad\], then by frequency \[rad/s\], both rising.
    #[must_use]
    pub fn new(
        headings: Vec<f64>,
        omega: Vec<f64>,
        values: Vec<Vec<Vector6<Complex<f64>>>>,
    ) -> Self {
        Self(CoefficientGrid {
            headings,
            omega,
            values,
        })
    }

    /// Whether the table covers a heading \[rad\].
    #[must_use]
    pub fn covers(&self, heading: f64) -> bool {
        self.0.around(heading).is_some()
    }

    /// The lowest and the highest frequency \[rad/s\].
    #[must_use]
    pub fn span(&self) -> (f64, f64) {
        (self.0.omega[0], self.0.omega[self.0.omega.len() - 1])
    }

    /// The loads of a wave of unit amplitude: real and imaginary part linear between headings and frequencies, held below the lowest
    /// frequency, none above the highest.
    #[must_use]
    pub fn at(&self, heading: f64, omega: f64) -> Vector6<Complex<f64>> {
        let (low, high) = self.span();
        let none = Vector6::zeros();
        if omega > high {
            return none;
        }
        let mixed = |a: &Vector6<Complex<f64>>, b: &Vector6<Complex<f64>>, share: f64| {
            a + (b - a) * Complex::from(share)
        };
        let found = self.0.at(heading, omega.max(low), mixed);
        found.unwrap_or(none)
    }
}

/// Mean drift per wave amplitude squared, of surge, sway \[N/m²\] and yaw \[N/m\], over frequency and heading.
#[derive(Debug, Clone, PartialEq)]
pub struct DriftTable(CoefficientGrid<[f64; 3]>);

impl DriftTable {
    /// A table of rows by heading \[rad\], then by frequency \[rad/s\], both rising.
    #[must_use]
    pub fn new(headings: Vec<f64>, omega: Vec<f64>, values: Vec<Vec<[f64; 3]>>) -> Self {
        Self(CoefficientGrid {
            headings,
            omega,
            values,
        })
    }

    /// Whether the table covers a heading \[rad\].
    #[must_use]
    pub fn covers(&self, heading: f64) -> bool {
        self.0.around(heading).is_some()
    }

    /// Mean drift in a wave of unit amplitude: linear between headings and frequencies, none below the lowest frequency, held above
    /// the highest, where waves are reflected.
    #[must_use]
    pub fn at(&self, heading: f64, omega: f64) -> [f64; 3] {
        let grid = &self.0.omega;
        if omega < grid[0] {
            return [0.0; 3];
        }
        let mixed = |a: &[f64; 3], b: &[f64; 3], share: f64| {
            [0, 1, 2].map(|axis| mix(a[axis], b[axis], share))
        };
        let found = self.0.at(heading, omega.min(grid[grid.len() - 1]), mixed);
        found.unwrap_or_default()
    }
}
