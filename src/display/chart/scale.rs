//! Linear and logarithmic axes: where a value lies along an axis, and back.

use super::range::{AxisRange, drawable, extent};

/// How values are spread over an axis.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum AxisScale {
    /// Equal differences are equally far apart.
    #[default]
    Linear,
    /// Equal ratios are; only positive values have a place.
    Log,
}

/// The most decades that are shown unasked: what is smaller is rounding beside the greatest value.
const DECADES: i32 = 9;

/// What is smaller has no place: its powers of ten would underflow.
const SMALLEST: f64 = 1e-290;

/// Least ratio of the ends of a logarithmic axis.
const NARROWEST: f64 = 1.0 + 1e-6;

impl AxisScale {
    /// The place of a value along the axis; not finite where it has none.
    #[must_use]
    pub fn place(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Log => value.log10(),
        }
    }

    /// The value at a place.
    #[must_use]
    pub fn value(self, place: f64) -> f64 {
        match self {
            Self::Linear => place,
            Self::Log => 10_f64.powf(place),
        }
    }

    /// The places of both ends of a range.
    #[must_use]
    pub fn places(self, range: AxisRange) -> AxisRange {
        (self.place(range.0), self.place(range.1))
    }

    /// The values at both ends of a range of places.
    #[must_use]
    pub fn values(self, places: AxisRange) -> AxisRange {
        (self.value(places.0), self.value(places.1))
    }

    /// Whether a value has a place.
    pub(super) fn shows(self, value: f64) -> bool {
        drawable(value) && (self == Self::Linear || value > 0.0)
    }
}

/// What a logarithmic axis shows: the range asked for, from the least positive value where that begins at zero or below; else all
/// positive values, to round numbers. Nothing where no value is positive.
#[must_use]
pub fn log_range(asked: Option<AxisRange>, values: impl Iterator<Item = f64>) -> Option<AxisRange> {
    let (least, greatest) = extent(values.filter(|value| *value > SMALLEST))?;
    let widened = |low: f64, high: f64| match high > low * NARROWEST {
        true => (low, high),
        false => (0.5 * low, 2.0 * low),
    };
    let asked = asked.map(|(low, high)| (low.min(high), low.max(high)));
    let asked = asked.filter(|range| drawable(range.0) && drawable(range.1) && range.1 > SMALLEST);
    Some(match asked {
        Some((low, high)) if low > SMALLEST => widened(low, high),
        Some((_, high)) => widened(least.min(0.5 * high), high),
        None => {
            let low = least.max(greatest * 10_f64.powi(-DECADES));
            widened(round_below(low), round_above(greatest))
        }
    })
}

/// The next of 1, 2, 5 times a power of ten at or below a positive value.
fn round_below(value: f64) -> f64 {
    let decade = 10_f64.powf(value.log10().floor());
    let found = [5.0, 2.0, 1.0].map(|m| m * decade);
    let found = found.into_iter().find(|v| *v <= value * (1.0 + 1e-9));
    found.unwrap_or(decade)
}

/// The next at or above.
fn round_above(value: f64) -> f64 {
    let decade = 10_f64.powf(value.log10().floor());
    let found = [1.0, 2.0, 5.0].map(|m| m * decade);
    let found = found.into_iter().find(|v| *v >= value * (1.0 - 1e-9));
    found.unwrap_or(10.0 * decade)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_values_are_inverse() {
        for value in [1e-7, 0.3, 1.0, 2.5e9] {
            let there = AxisScale::Log.value(AxisScale::Log.place(value));
            assert!((there / value - 1.0).abs() < 1e-12);
            assert_eq!(AxisScale::Linear.value(value).to_bits(), value.to_bits());
        }
        assert!(!AxisScale::Log.shows(0.0) && !AxisScale::Log.shows(-1.0));
        assert!(AxisScale::Linear.shows(-1.0));
    }

    #[test]
    fn only_positive_values_are_shown() {
        let close = |found: Option<AxisRange>, low: f64, high: f64| {
            let (a, b) = found.unwrap();
            assert!(
                (a / low - 1.0).abs() < 1e-9 && (b / high - 1.0).abs() < 1e-9,
                "{a} {b}"
            );
        };
        close(log_range(None, [-4.0, 0.3, 700.0].into_iter()), 0.2, 1000.0);
        close(
            log_range(Some((0.0, 60.0)), [0.0, 2.0, 60.0].into_iter()),
            2.0,
            60.0,
        );
        close(log_range(None, [1e-30, 1e3].into_iter()), 1e-6, 1e3);
        close(log_range(None, [3.0].into_iter()), 2.0, 5.0);
        close(log_range(None, [2.0].into_iter()), 1.0, 4.0);
        assert_eq!(log_range(None, [-1.0, 0.0, f64::NAN].into_iter()), None);
    }
}
