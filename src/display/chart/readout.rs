//! What the series say at the cursor.

use super::Chart;
use crate::number;
use crate::numerics::interpolation::mix;

/// A series at the cursor.
#[derive(Debug, Clone, PartialEq)]
pub struct Readout {
    /// Name of the series.
    pub label: String,
    /// Where it was read: the cursor, or the sample next to it.
    pub x: f64,
    /// What it says there, in the unit of the y axis; absent where the series says nothing.
    pub y: Option<f64>,
    /// Unit of the y axis.
    pub unit: String,
    /// How it was read.
    pub method: ReadoutMethod,
}

impl Readout {
    /// As words: `vessel|chain 3.94 MN`; a nearest sample says where it lies, a missing value is a
    /// dash.
    #[must_use]
    pub fn words(&self, x_unit: &str) -> String {
        match (self.y, self.method) {
            (None, _) => format!("{} -", self.label),
            (Some(y), ReadoutMethod::Nearest) => format!(
                "{} {} (at {})",
                self.label,
                number::si(y, &self.unit),
                number::si(self.x, x_unit)
            ),
            (Some(y), _) => format!("{} {}", self.label, number::si(y, &self.unit)),
        }
    }
}

/// How a value was read from a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReadoutMethod {
    /// On the straight line between the samples on both sides.
    Interpolated,
    /// At the nearest sample: the series does not go from left to right, or is a single point.
    Nearest,
    /// Nowhere: the cursor is before the first or behind the last sample, or in a gap.
    Outside,
}

/// What every visible series says at an x. A series whose x grows from sample to sample is
/// interpolated, any other is read at the sample whose x is nearest.
/// A map is read at the cursor's place on both axes.
#[must_use]
pub fn readout(chart: &Chart, x: f64) -> Vec<Readout> {
    if let Some((map, y)) = chart.map.as_ref().zip(chart.cursor_y) {
        let value = map.at((x, chart.x.scale), (y, chart.y.scale));
        return vec![Readout {
            label: format!("{} at {}", map.of.label, number::si(y, &chart.y.unit)),
            x,
            y: value,
            unit: map.of.unit.clone(),
            method: value.map_or(ReadoutMethod::Outside, |_| ReadoutMethod::Interpolated),
        }];
    }
    let shown = chart.series.iter().filter(|series| series.visible);
    shown
        .map(|series| {
            let (at, y, method) = read(&series.points, x);
            Readout {
                label: series.label.clone(),
                x: at,
                y,
                unit: chart.y.unit.clone(),
                method,
            }
        })
        .collect()
}

fn read(points: &[(f64, f64)], x: f64) -> (f64, Option<f64>, ReadoutMethod) {
    let growing = points.len() > 1 && points.windows(2).all(|pair| pair[0].0 < pair[1].0);
    let value = if growing {
        interpolate(points, x).map(|y| (x, y, ReadoutMethod::Interpolated))
    } else {
        nearest(points, x).map(|(at, y)| (at, y, ReadoutMethod::Nearest))
    };
    match value {
        Some((at, y, method)) if y.is_finite() => (at, Some(y), method),
        _ => (x, None, ReadoutMethod::Outside),
    }
}

/// The value on the straight line between two samples.
fn interpolate(points: &[(f64, f64)], x: f64) -> Option<f64> {
    let after = points.partition_point(|p| p.0 < x);
    let right = points.get(after)?;
    if right.0 <= x {
        return Some(right.1);
    }
    let left = points.get(after.checked_sub(1)?)?;
    Some(mix(left.1, right.1, (x - left.0) / (right.0 - left.0)))
}

/// The sample whose x is nearest; of equals, the first.
fn nearest(points: &[(f64, f64)], x: f64) -> Option<(f64, f64)> {
    let finite = points.iter().filter(|p| p.0.is_finite() && p.1.is_finite());
    finite
        .copied()
        .min_by(|a, b| (a.0 - x).abs().total_cmp(&(b.0 - x).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Series;

    fn read_one(points: &[(f64, f64)], x: f64) -> (Option<f64>, ReadoutMethod) {
        let chart = Chart {
            series: vec![Series::new("s", 0, points.to_vec())],
            ..Chart::default()
        };
        let read = readout(&chart, x).remove(0);
        (read.y, read.method)
    }

    #[test]
    fn histories_are_interpolated() {
        let points = [(0.0, 1.0), (1.0, 3.0), (2.0, 3.0)];
        assert_eq!(
            read_one(&points, 0.5),
            (Some(2.0), ReadoutMethod::Interpolated)
        );
        assert_eq!(
            read_one(&points, 1.0),
            (Some(3.0), ReadoutMethod::Interpolated)
        );
        assert_eq!(
            read_one(&points, 0.0),
            (Some(1.0), ReadoutMethod::Interpolated)
        );
        assert_eq!(
            read_one(&points, 2.0),
            (Some(3.0), ReadoutMethod::Interpolated)
        );
        assert_eq!(read_one(&points, 2.1), (None, ReadoutMethod::Outside));
        assert_eq!(read_one(&points, -0.1), (None, ReadoutMethod::Outside));
    }

    #[test]
    fn a_gap_reads_as_nothing() {
        let points = [(0.0, 1.0), (1.0, f64::NAN), (2.0, 3.0)];
        assert_eq!(read_one(&points, 0.5), (None, ReadoutMethod::Outside));
    }

    #[test]
    fn a_line_that_turns_back_is_read_at_its_nearest_sample() {
        let points = [(0.0, 1.0), (2.0, 3.0), (1.0, 7.0)];
        assert_eq!(read_one(&points, 1.2), (Some(7.0), ReadoutMethod::Nearest));
        assert_eq!(read_one(&[], 1.2), (None, ReadoutMethod::Outside));
    }
}
