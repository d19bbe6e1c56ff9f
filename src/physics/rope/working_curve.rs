//! Tension of a rope over its mean strain, loaded slowly: one curve, or the working curves of the Syrope model.
//!
//! A new polyester rope is loaded along its original curve. Where it is unloaded and loaded again it follows a working curve
//! instead, which leaves the original one at the greatest mean strain `x_p` and tension `T_p` so far and ends without tension at
//! the permanent strain `x_0` (Falkenberg, Ahjem and Yang 2017, OTC-27761, doi 10.4043/27761-MS). With
//! `s = (x - x_0) / (x_p - x_0)`, as in MoorDyn's file of working curves, its parameters being k1 and k2:
//!
//! ```text
//! linear        T = T_p s
//! quadratic     T = T_p s (k s + 1 - k)
//! exponential   T = T_p (exp(k s) - 1) / (exp(k) - 1)
//! x_0 = r x_p, or of a linear curve of the stiffness EA:  x_0 = x_p - T_p / EA
//! ```

use super::TensionTable;

/// Tension over mean strain.
#[derive(Debug, Clone, PartialEq)]
pub enum MeanCurve {
    /// This stiffness EA \[N\].
    Linear(f64),
    /// A table.
    Table(TensionTable),
    /// An original curve, and a working curve for every point of it.
    Syrope(TensionTable, WorkingCurve),
}

/// The working curves of a rope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorkingCurve {
    /// Their shape.
    pub shape: CurveShape,
    /// Where they end.
    pub end: CurveEnd,
}

/// Shape of a working curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurveShape {
    /// Straight.
    Linear,
    /// With this k, from -1 to 1.
    Quadratic(f64),
    /// With this k.
    Exponential(f64),
}

/// The permanent strain of a working curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurveEnd {
    /// By the greatest mean strain: r, from 0 to less than 1.
    Ratio(f64),
    /// By a mean stiffness EA \[N\] of the curve; not below zero.
    Stiffness(f64),
}

/// A point of a curve.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CurvePoint {
    /// Mean tension \[N\], not negative.
    pub tension: f64,
    /// Its derivative by mean strain \[N\].
    pub by_strain: f64,
    /// The second derivative \[N\].
    pub bent: f64,
    /// Energy by unstretched length that slow unloading gives back \[N\].
    pub stored: f64,
    /// Derivative of that by mean strain \[N\]: less than the tension on an original curve, where the rope yields.
    pub stored_by_strain: f64,
}

/// The greatest parameter of an exponential curve: beyond it the curve is a corner to any precision.
const SHARPEST: f64 = 100.0;
/// The least one that differs from a straight line.
const BLUNTEST: f64 = 1e-6;
/// The least width of a working curve by the greatest mean strain.
const NARROWEST: f64 = 1e-6;

impl MeanCurve {
    /// The point at a mean strain, the greatest so far being `peak`; where the rope is slack all is zero.
    #[must_use]
    pub fn at(&self, strain: f64, peak: f64) -> CurvePoint {
        if strain <= 0.0 {
            return CurvePoint::default();
        }
        match self {
            Self::Linear(ea) => CurvePoint {
                tension: ea * strain,
                by_strain: *ea,
                bent: 0.0,
                stored: 0.5 * ea * strain * strain,
                stored_by_strain: ea * strain,
            },
            Self::Table(table) => {
                let point = table.at(strain);
                CurvePoint {
                    tension: point.tension,
                    by_strain: point.by_strain,
                    bent: table.bent(strain),
                    stored: table.stored(strain),
                    stored_by_strain: point.tension,
                }
            }
            Self::Syrope(table, curve) if strain >= peak => curve.leaving(table, strain),
            Self::Syrope(table, curve) => curve.at(strain, peak, table.at(peak).tension),
        }
    }

    /// The mean strain without tension, below which the rope is slack.
    #[must_use]
    pub fn slack(&self, peak: f64) -> f64 {
        match self {
            Self::Syrope(table, curve) if peak > 0.0 => {
                peak - curve.width(peak, table.at(peak).tension)
            }
            _ => 0.0,
        }
    }

    /// The mean strain at a tension \[N\]; below zero the curve goes on straight.
    #[must_use]
    pub fn strain_at(&self, tension: f64, peak: f64) -> f64 {
        match self {
            Self::Linear(ea) => tension / ea,
            Self::Table(table) => table.strain_at(tension),
            Self::Syrope(table, curve) => {
                let greatest = table.at(peak).tension;
                if peak <= 0.0 || tension >= greatest {
                    return table.strain_at(tension);
                }
                let width = curve.width(peak, greatest);
                if tension <= 0.0 {
                    return peak - width + tension / self.slack_stiffness(peak);
                }
                peak - width + width * curve.shape.place(tension / greatest)
            }
        }
    }

    /// Stiffness with which the curve goes on straight where the rope is slack \[N\]: only a search for rest goes there.
    #[must_use]
    pub fn slack_stiffness(&self, peak: f64) -> f64 {
        match self {
            Self::Linear(ea) => *ea,
            Self::Syrope(table, curve) if peak > 0.0 => {
                let greatest = table.at(peak).tension;
                greatest / curve.width(peak, greatest)
            }
            Self::Table(table) | Self::Syrope(table, _) => table.at(0.0).by_strain,
        }
    }

    /// A representative stiffness \[N\].
    #[must_use]
    pub fn representative_stiffness(&self) -> f64 {
        match self {
            Self::Linear(ea) => *ea,
            Self::Table(table) | Self::Syrope(table, _) => table.representative_stiffness(),
        }
    }
}

impl WorkingCurve {
    /// The point where a working curve leaves the original one. What is stored is what the working curve gives back.
    fn leaving(&self, table: &TensionTable, strain: f64) -> CurvePoint {
        let point = table.at(strain);
        let width = self.width(strain, point.tension);
        let by_strain = match self.end {
            CurveEnd::Ratio(ratio) => 1.0 - ratio,
            CurveEnd::Stiffness(_) if width >= strain => 1.0,
            CurveEnd::Stiffness(ea) => point.by_strain / ea,
        };
        let share = self.shape.at(1.0).area;
        CurvePoint {
            tension: point.tension,
            by_strain: point.by_strain,
            bent: table.bent(strain),
            stored: share * point.tension * width,
            stored_by_strain: share * (point.by_strain * width + point.tension * by_strain),
        }
    }

    /// A point of the working curve that leaves the original one at this strain and tension \[N\].
    fn at(&self, strain: f64, peak: f64, greatest: f64) -> CurvePoint {
        let width = self.width(peak, greatest);
        let place = (strain - (peak - width)) / width;
        if place <= 0.0 {
            return CurvePoint::default();
        }
        let point = self.shape.at(place);
        CurvePoint {
            tension: greatest * point.value,
            by_strain: greatest * point.slope / width,
            bent: greatest * point.bent / (width * width),
            stored: greatest * width * point.area,
            stored_by_strain: greatest * point.value,
        }
    }

    /// Strain from the end of a working curve to where it leaves the original one.
    fn width(&self, peak: f64, greatest: f64) -> f64 {
        let width = match self.end {
            CurveEnd::Ratio(ratio) => (1.0 - ratio) * peak,
            CurveEnd::Stiffness(ea) => (greatest / ea).min(peak),
        };
        width.max(NARROWEST * peak)
    }
}

/// A shape between 0 and 1, both ways.
struct ShapePoint {
    value: f64,
    slope: f64,
    bent: f64,
    /// Integral from zero.
    area: f64,
}

impl CurveShape {
    /// The shape with parameters in their bounds; an exponential that is straight to any precision is straight.
    fn bounded(self) -> Self {
        match self {
            Self::Quadratic(k) => Self::Quadratic(k.clamp(-1.0, 1.0)),
            Self::Exponential(k) if k.abs() < BLUNTEST => Self::Linear,
            Self::Exponential(k) => Self::Exponential(k.clamp(-SHARPEST, SHARPEST)),
            Self::Linear => Self::Linear,
        }
    }

    fn at(self, s: f64) -> ShapePoint {
        match self.bounded() {
            Self::Linear => ShapePoint {
                value: s,
                slope: 1.0,
                bent: 0.0,
                area: 0.5 * s * s,
            },
            Self::Quadratic(k) => ShapePoint {
                value: s * (k * s + 1.0 - k),
                slope: 2.0 * k * s + 1.0 - k,
                bent: 2.0 * k,
                area: s * s * (k * s / 3.0 + 0.5 * (1.0 - k)),
            },
            Self::Exponential(k) => {
                let whole = k.exp_m1();
                let grown = (k * s).exp_m1();
                let slope = k * (grown + 1.0) / whole;
                ShapePoint {
                    value: grown / whole,
                    slope,
                    bent: k * slope,
                    area: (grown / k - s) / whole,
                }
            }
        }
    }

    /// The place at which the shape has a value from 0 to 1.
    fn place(self, value: f64) -> f64 {
        match self.bounded() {
            Self::Linear => value,
            Self::Quadratic(k) => {
                let start = 1.0 - k;
                let root = (start * start + 4.0 * k * value).max(0.0).sqrt();
                2.0 * value / (start + root).max(f64::MIN_POSITIVE)
            }
            Self::Exponential(k) => (value * k.exp_m1()).ln_1p() / k,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curves() -> Vec<MeanCurve> {
        let table = TensionTable::new(&[0.0, 0.01, 0.04], &[0.0, 7e5, 2.4e6]).unwrap();
        let mut all = vec![MeanCurve::Linear(1e8), MeanCurve::Table(table.clone())];
        for shape in [
            CurveShape::Linear,
            CurveShape::Quadratic(1.0),
            CurveShape::Quadratic(-0.5),
            CurveShape::Exponential(1.5),
            CurveShape::Exponential(-2.0),
        ] {
            for end in [CurveEnd::Ratio(0.3), CurveEnd::Stiffness(1.2e8)] {
                all.push(MeanCurve::Syrope(
                    table.clone(),
                    WorkingCurve { shape, end },
                ));
            }
        }
        all
    }

    #[test]
    fn derivatives_are_those_of_tension_and_energy() {
        let h = 1e-7;
        for curve in curves() {
            for peak in [0.0, 0.02] {
                for i in 1..40 {
                    let strain = f64::from(i) * 1.1e-3;
                    let at = |e: f64| curve.at(e, peak);
                    if strain <= curve.slack(peak) + h {
                        continue;
                    }
                    let difference = |of: fn(&CurvePoint) -> f64| {
                        (of(&at(strain + h)) - of(&at(strain - h))) / (2.0 * h)
                    };
                    let here = at(strain);
                    let close = |a: f64, b: f64, size: f64| (a - b).abs() < 1e-4 * size;
                    assert!(
                        close(difference(|p| p.tension), here.by_strain, 1e8),
                        "{curve:?} {strain}"
                    );
                    assert!(
                        close(difference(|p| p.by_strain), here.bent, 1e10),
                        "{curve:?} {strain}"
                    );
                    assert!(
                        close(difference(|p| p.stored), here.stored_by_strain, 1e6),
                        "{curve:?} {strain}"
                    );
                    assert!(here.stored_by_strain <= here.tension * (1.0 + 1e-9) || strain > peak);
                }
            }
        }
    }

    #[test]
    fn strains_are_those_of_their_tensions() {
        for curve in curves() {
            for peak in [0.0, 0.02] {
                for tension in [1e3, 1e5, 8e5, 1.2e6, 3e6] {
                    let strain = curve.strain_at(tension, peak);
                    let found = curve.at(strain, peak).tension;
                    assert!(
                        (found / tension - 1.0).abs() < 1e-9,
                        "{curve:?} {tension} {found}"
                    );
                }
                assert!((curve.strain_at(0.0, peak) - curve.slack(peak)).abs() < 1e-15);
            }
        }
    }
}
