//! Statistics of the curves of a chart over the part of its horizontal axis that is shown.

use super::{AxisRange, Chart, Series};
use crate::number::si;
use crate::table::{Align, Cell, Table};

/// Statistics of a curve, straight between its points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurveStatistics {
    /// Its smallest value, and where.
    pub least: (f64, f64),
    /// Its greatest value, and where.
    pub greatest: (f64, f64),
    /// Its mean over the axis.
    pub mean: f64,
    /// Its standard deviation over the axis.
    pub deviation: f64,
}

/// The statistics of a curve over a window of its horizontal axis; nothing where it is not there, or runs backwards.
#[must_use]
pub fn of_curve(points: &[(f64, f64)], window: AxisRange) -> Option<CurveStatistics> {
    let (mut length, mut first, mut second) = (0.0, 0.0, 0.0);
    let mut ends: Vec<(f64, f64)> = Vec::new();
    for pair in points.windows(2) {
        let Some((a, b)) = inside(pair[0], pair[1], window)? else {
            continue;
        };
        let step = b.0 - a.0;
        length += step;
        first += step * 0.5 * (a.1 + b.1);
        // Of a straight piece.
        second += step * (a.1 * a.1 + a.1 * b.1 + b.1 * b.1) / 3.0;
        ends.extend([a, b]);
    }
    let least = ends.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let greatest = ends.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
    if length <= 0.0 {
        return None;
    }
    let mean = first / length;
    Some(CurveStatistics {
        least: (least.1, least.0),
        greatest: (greatest.1, greatest.0),
        mean,
        deviation: (second / length - mean * mean).max(0.0).sqrt(),
    })
}

/// The two ends of a piece of a curve.
type CurvePiece = ((f64, f64), (f64, f64));

/// The part of a piece inside the window; the outer absence says that the curve runs backwards.
fn inside(a: (f64, f64), b: (f64, f64), window: AxisRange) -> Option<Option<CurvePiece>> {
    if !(a.0.is_finite() && a.1.is_finite() && b.0.is_finite() && b.1.is_finite()) {
        return Some(None);
    }
    if b.0 < a.0 {
        return None;
    }
    let (from, to) = (a.0.max(window.0), b.0.min(window.1));
    if from > to {
        return Some(None);
    }
    let at = |x: f64| {
        let share = if b.0 > a.0 {
            (x - a.0) / (b.0 - a.0)
        } else {
            0.0
        };
        (x, a.1 + share * (b.1 - a.1))
    };
    Some(Some((at(from), at(to))))
}

/// The statistics of all curves of a chart, over what it shows of its horizontal axis.
#[must_use]
pub fn table(chart: &Chart) -> Table {
    let window = chart.x.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    let curves = chart
        .series
        .iter()
        .filter(|series| series.visible && !series.dimmed);
    let rows: Vec<(&Series, CurveStatistics)> = curves
        .filter_map(|series| Some((series, of_curve(&series.points, window)?)))
        .collect();
    let (x, y) = (&chart.x.unit, &chart.y.unit);
    let column = |of: fn(&CurveStatistics) -> f64| {
        move |row: &(&Series, CurveStatistics)| Cell::plain(si(of(&row.1), y))
    };
    let place = |of: fn(&CurveStatistics) -> f64| {
        move |row: &(&Series, CurveStatistics)| Cell::plain(si(of(&row.1), x))
    };
    Table::of_records(chart.title.as_str(), &rows)
        .text("curve", |row| row.0.label.clone())
        .cell("least", Align::Decimal, column(|s| s.least.0))
        .cell("at", Align::Decimal, place(|s| s.least.1))
        .cell("greatest", Align::Decimal, column(|s| s.greatest.0))
        .cell("at", Align::Decimal, place(|s| s.greatest.1))
        .cell("mean", Align::Decimal, column(|s| s.mean))
        .cell("deviation", Align::Decimal, column(|s| s.deviation))
        .build()
        .noted([
            "Of the curves as drawn, straight between their points, over the part of the axis that is shown. \
             The results of the run are of every step, and have error bars.",
        ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_has_the_statistics_of_a_uniform_distribution() {
        let points: Vec<(f64, f64)> = (0..=7)
            .map(|i| (f64::from(i * i), f64::from(i * i)))
            .collect();
        let found = of_curve(&points, (0.0, 49.0)).unwrap();
        assert!((found.mean - 24.5).abs() < 1e-12);
        assert!((found.deviation - 49.0 / 12_f64.sqrt()).abs() < 1e-12);
        assert_eq!((found.least, found.greatest), ((0.0, 0.0), (49.0, 49.0)));
    }

    #[test]
    fn a_window_cuts_pieces() {
        let points = [(0.0, 0.0), (10.0, 10.0), (20.0, 0.0)];
        let found = of_curve(&points, (5.0, 12.0)).unwrap();
        assert_eq!(found.greatest, (10.0, 10.0));
        assert_eq!(found.least, (5.0, 5.0));
        let mean = (5.0 * 7.5 + 2.0 * 9.0) / 7.0;
        assert!((found.mean - mean).abs() < 1e-12);
    }

    #[test]
    fn a_curve_that_runs_backwards_or_is_elsewhere_has_none() {
        assert!(of_curve(&[(0.0, 0.0), (1.0, 1.0), (0.5, 2.0)], (0.0, 9.0)).is_none());
        assert!(of_curve(&[(0.0, 0.0), (1.0, 1.0)], (5.0, 9.0)).is_none());
        let broken = [(0.0, 1.0), (1.0, f64::NAN), (2.0, 3.0), (4.0, 3.0)];
        assert_eq!(of_curve(&broken, (0.0, 9.0)).unwrap().mean, 3.0);
    }
}
