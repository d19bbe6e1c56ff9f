//! What an axis shows: fitted to the data, widened to equal scale, or only ever growing.

use super::ticks::TickStep;

/// From where to where an axis goes.
pub type AxisRange = (f64, f64);

/// Greatest size of a value that is drawn; beyond it differences overflow.
const LARGEST: f64 = 1e300;

/// Smallest span, relative to the values, that is resolved; below it a series counts as constant.
const FINEST: f64 = 1e-10;

/// The smallest and the greatest of the values that can be drawn; absent when there is none.
pub fn extent(values: impl Iterator<Item = f64>) -> Option<AxisRange> {
    values.filter(|v| drawable(*v)).fold(None, |range, v| {
        let (low, high) = range.unwrap_or((v, v));
        Some((low.min(v), high.max(v)))
    })
}

/// Whether a value can be drawn at all.
pub(super) fn drawable(value: f64) -> bool {
    value.is_finite() && value.abs() <= LARGEST
}

/// The range of the data widened to round numbers (1, 2, 5 times a power of ten); a constant is
/// shown in the middle of a tenth of itself, and no data at all as 0 to 1.
#[must_use]
pub fn fit(data: Option<AxisRange>) -> AxisRange {
    let Some((low, high)) = data.filter(|(low, high)| drawable(*low) && drawable(*high)) else {
        return (0.0, 1.0);
    };
    let (low, high) = (low.min(high), low.max(high));
    let size = low.abs().max(high.abs());
    let (low, high) = if high - low > (size * FINEST).max(1e-290) {
        (low, high)
    } else {
        let half = if size > 1e-290 { 0.05 * size } else { 1.0 };
        (low - half, high + half)
    };
    let step = TickStep::at_least((high - low) / 10.0);
    let (first, last) = (step.below(low), step.above(high));
    sane((step.value(first), step.value(last)))
}

/// Span of the values of a unit below which they are rounding and no result: of forces, moments, lengths, angles.
fn noise(unit: &str) -> f64 {
    match unit {
        "N" | "N m" => 1e-4,
        "m" | "m/s" => 1e-7,
        "deg" => 1e-6,
        "1/m" => 1e-10,
        _ => 0.0,
    }
}

/// Smallest span of results, relative to the values: what differs by less is constant but for rounding.
const FINEST_RESULT: f64 = 1e-8;

/// The range of results, as [`fit`]; a span that is only rounding is not blown up to the height of the plot.
#[must_use]
pub(super) fn fit_above_noise(data: Option<AxisRange>, unit: &str) -> AxisRange {
    let Some((low, high)) = data else {
        return fit(data);
    };
    let (noise, size) = (noise(unit), low.abs().max(high.abs()));
    let middle = 0.5 * (low + high);
    match high - low {
        span if span > noise.max(size * FINEST_RESULT) || noise <= 0.0 => fit(data),
        _ if size <= noise => fit(Some((0.0, 0.0))),
        _ => fit(Some((middle, middle))),
    }
}

/// A range that can be divided by: finite, in order, wide enough to be resolved.
pub(super) fn sane((low, high): AxisRange) -> AxisRange {
    if !low.is_finite() || !high.is_finite() {
        return (0.0, 1.0);
    }
    let clamp = |v: f64| v.clamp(-1e305, 1e305);
    let (low, high) = (clamp(low.min(high)), clamp(low.max(high)));
    let least = (low.abs().max(high.abs()) * FINEST).max(1e-290);
    if high - low >= least {
        (low, high)
    } else {
        let middle = 0.5 * low + 0.5 * high;
        (middle - least, middle + least)
    }
}

/// Widens one of two ranges so that a metre has the same length on both, given the lengths of the
/// axes in the same unit of paper.
pub(super) fn equalise(x: AxisRange, y: AxisRange, paper: (f64, f64)) -> (AxisRange, AxisRange) {
    let (across, up) = (
        paper.0.max(f64::MIN_POSITIVE),
        paper.1.max(f64::MIN_POSITIVE),
    );
    let per_length = ((x.1 - x.0) / across).max((y.1 - y.0) / up);
    let widen = |range: AxisRange, paper: f64| {
        let missing = 0.5 * (per_length * paper - (range.1 - range.0)).max(0.0);
        sane((range.0 - missing, range.1 + missing))
    };
    (widen(x, across), widen(y, up))
}

/// A range for live charts: it only grows, and by round steps, so that the axes seldom change.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StickyRange {
    range: Option<AxisRange>,
}

impl StickyRange {
    /// What is shown now; absent before the first value.
    #[must_use]
    pub fn range(&self) -> Option<AxisRange> {
        self.range
    }

    /// Grows until the value is inside; values that are not finite change nothing.
    pub fn include(&mut self, value: f64) {
        if !drawable(value) {
            return;
        }
        let (low, high) = match self.range {
            Some((low, high)) if (low..=high).contains(&value) => return,
            Some((low, high)) => (low.min(value), high.max(value)),
            None => {
                self.range = Some(fit(Some((value, value))));
                return;
            }
        };
        // A coarse step leaves room to grow into, so that the next change is far away.
        let step = TickStep::at_least((high - low) / 4.0);
        let wide = sane((step.value(step.below(low)), step.value(step.above(high))));
        self.range = Some((wide.0.min(low), wide.1.max(high)));
    }

    /// Begins anew.
    pub fn clear(&mut self) {
        self.range = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_are_widened_to_round_numbers() {
        assert_eq!(fit(Some((0.0, 612.0))), (0.0, 700.0));
        assert_eq!(fit(Some((-1390.0, -3.0))), (-1400.0, 0.0));
        assert_eq!(fit(Some((1.0, 1.0))), (0.95, 1.05));
        assert_eq!(fit(Some((0.0, 0.0))), (-1.0, 1.0));
        assert_eq!(fit(None), (0.0, 1.0));
        assert_eq!(fit(Some((f64::NAN, 1.0))), (0.0, 1.0));
    }

    #[test]
    fn rounding_is_not_blown_up() {
        assert_eq!(fit_above_noise(Some((-2e-9, 1e-9)), "N"), (-1.0, 1.0));
        let (low, high) = fit_above_noise(Some((1e6, 1e6 + 1e-5)), "N");
        assert!(high - low > 1e4, "{low} {high}");
        assert_eq!(
            fit_above_noise(Some((0.0, 6e-3)), "N"),
            fit(Some((0.0, 6e-3)))
        );
        assert_eq!(
            fit_above_noise(Some((0.0, 1e-9)), ""),
            fit(Some((0.0, 1e-9)))
        );
        assert_eq!(fit_above_noise(None, "N"), (0.0, 1.0));
    }

    #[test]
    fn hostile_ranges_come_back_usable() {
        for range in [
            (f64::NAN, 1.0),
            (1.0, 1.0),
            (5.0, -5.0),
            (1e300, 1e300),
            (0.0, 1e-320),
            (f64::NEG_INFINITY, f64::INFINITY),
            (-f64::MAX, f64::MAX),
        ] {
            let (low, high) = sane(range);
            assert!(low < high && (high - low).is_finite(), "{range:?}");
        }
    }

    #[test]
    fn sticky_limits_grow_seldom_and_never_shrink() {
        let mut sticky = StickyRange::default();
        let mut changes = 0;
        let mut before = None;
        for i in 0..=1000 {
            sticky.include(f64::from(i) * 3.9e3);
            let now = sticky.range();
            if now != before {
                changes += 1;
            }
            before = now;
        }
        let (low, high) = sticky.range().unwrap();
        assert!(low <= 0.0 && (3.9e6..=8e6).contains(&high), "{low} {high}");
        assert!(changes < 40, "{changes}");
        sticky.include(f64::NAN);
        assert_eq!(sticky.range(), Some((low, high)));
    }

    #[test]
    fn equal_scale_only_widens() {
        let (x, y) = equalise((0.0, 10.0), (0.0, 100.0), (50.0, 50.0));
        assert_eq!(x, (-45.0, 55.0));
        assert_eq!(y, (0.0, 100.0));
    }
}
