//! Round numbers along an axis: 1, 2, 5 times a power of ten, at their true places.

use super::{AxisRange, AxisScale};
use crate::number::{self, Scale};

/// A round distance between ticks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct TickStep {
    /// 1, 2 or 5.
    mantissa: i32,
    /// Power of ten.
    exponent: i32,
}

impl TickStep {
    /// The smallest round distance that is not smaller than `least`.
    pub(super) fn at_least(least: f64) -> Self {
        let least = least.clamp(1e-300, 1e305);
        let exponent = number::order(least);
        // The tolerance keeps 0.1 from becoming 0.2 for want of its last bit.
        let mantissa = least / 10f64.powi(exponent) * (1.0 - 1e-9);
        match mantissa {
            m if m <= 1.0 => Self {
                mantissa: 1,
                exponent,
            },
            m if m <= 2.0 => Self {
                mantissa: 2,
                exponent,
            },
            m if m <= 5.0 => Self {
                mantissa: 5,
                exponent,
            },
            _ => Self {
                mantissa: 1,
                exponent: exponent + 1,
            },
        }
    }

    /// The next coarser round distance.
    pub(super) fn coarser(self) -> Self {
        match self.mantissa {
            1 => Self {
                mantissa: 2,
                ..self
            },
            2 => Self {
                mantissa: 5,
                ..self
            },
            _ => Self {
                mantissa: 1,
                exponent: self.exponent + 1,
            },
        }
    }

    /// The value of the tick with this number. Dividing by a power of ten instead of multiplying by
    /// its inverse gives 0.3 and not 0.30000000000000004.
    pub(super) fn value(self, index: f64) -> f64 {
        let count = index * f64::from(self.mantissa);
        if self.exponent < 0 {
            count / 10f64.powi(-self.exponent)
        } else {
            count * 10f64.powi(self.exponent)
        }
    }

    /// Number of the last tick at or below a value.
    pub(super) fn below(self, value: f64) -> f64 {
        (value / self.value(1.0) + 1e-6).floor()
    }

    /// Number of the first tick at or above a value.
    pub(super) fn above(self, value: f64) -> f64 {
        (value / self.value(1.0) - 1e-6).ceil()
    }

    /// The ticks inside a range; at most a thousand.
    pub(super) fn ticks(self, range: AxisRange) -> Vec<f64> {
        let (first, last) = (self.above(range.0), self.below(range.1));
        if !(last - first).is_finite() || last - first > 1000.0 {
            return Vec::new();
        }
        let count = (last - first).max(-1.0) as i64 + 1;
        (0..count).map(|i| self.value(first + i as f64)).collect()
    }

    /// Decimals that distinguish neighbouring ticks at a scale.
    fn decimals(self, scale: Scale) -> i32 {
        (number::order(scale.factor * (1.0 + 1e-9)) - self.exponent).max(0)
    }
}

/// A tick and its number in words.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    /// Its position.
    pub(super) value: f64,
    /// What is written beside it, at the scale of the axis.
    pub(super) label: String,
}

/// The scale all numbers of an axis are written at.
pub(super) fn scale(range: AxisRange, unit: &str) -> Scale {
    Scale::of_magnitude(range.0.abs().max(range.1.abs()), unit)
}

/// The finest round ticks that pass a test, labelled at one scale; the test sees them all and says
/// whether there is room. More than `most` never have room: writing all their numbers took half the time of a frame.
pub(super) fn choose(
    range: AxisRange,
    unit: &str,
    most: usize,
    roomy: impl Fn(&[Tick]) -> bool,
) -> Vec<Tick> {
    let scale = scale(range, unit);
    let mut step = TickStep::at_least((range.1 - range.0) / 400.0);
    // 400 is passed in 8 steps; more only ever leave fewer ticks.
    for _ in 0..12 {
        let values = step.ticks(range);
        if values.len() <= most {
            let ticks = label(&values, step.decimals(scale), scale);
            if roomy(&ticks) {
                return ticks;
            }
        }
        step = step.coarser();
    }
    Vec::new()
}

/// The finest round ticks of an axis that pass a test.
pub(super) fn along(
    spread: AxisScale,
    range: AxisRange,
    unit: &str,
    most: usize,
    roomy: impl Fn(&[Tick]) -> bool,
) -> Vec<Tick> {
    match spread {
        AxisScale::Linear => choose(range, unit, most, roomy),
        AxisScale::Log => choose_log(range, unit, most, roomy),
    }
}

/// Mantissas of the ticks of a logarithmic axis, and every how many decades they come, the finest first.
const LOG_STEPS: [(&[f64], i32); 6] = [
    (&[1.0, 2.0, 5.0], 1),
    (&[1.0], 1),
    (&[1.0], 2),
    (&[1.0], 3),
    (&[1.0], 5),
    (&[1.0], 10),
];

/// As [`choose`], of a logarithmic axis; within a decade there are not enough round numbers but those of a linear one.
fn choose_log(
    range: AxisRange,
    unit: &str,
    most: usize,
    roomy: impl Fn(&[Tick]) -> bool,
) -> Vec<Tick> {
    if range.1 < 10.0 * range.0 {
        return choose(range, unit, most, roomy);
    }
    let scale = scale(range, unit);
    let decades = number::order(range.0)..=number::order(range.1);
    for (mantissas, every) in LOG_STEPS {
        let decades = decades
            .clone()
            .filter(|decade| decade.rem_euclid(every) == 0);
        let values = decades.flat_map(|decade| mantissas.iter().map(move |m| (*m, decade)));
        let ticks: Vec<Tick> = values
            .map(|(mantissa, decade)| mantissa * 10f64.powi(decade))
            .filter(|value| (range.0 * (1.0 - 1e-9)..=range.1 * (1.0 + 1e-9)).contains(value))
            .map(|value| Tick {
                value,
                label: log_label(value / scale.factor),
            })
            .collect();
        if ticks.len() <= most && roomy(&ticks) {
            return ticks;
        }
    }
    Vec::new()
}

/// A round number of a logarithmic axis: short ones in full.
fn log_label(value: f64) -> String {
    if (0.9e-3..1.1e4).contains(&value) {
        number::digits(value, 2)
    } else {
        format!("{value:.0e}")
    }
}

fn label(values: &[f64], decimals: i32, scale: Scale) -> Vec<Tick> {
    values
        .iter()
        .map(|value| Tick {
            value: *value,
            label: number::rounded(value / scale.factor, decimals),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(range: AxisRange, unit: &str, most: usize) -> Vec<String> {
        choose(range, unit, usize::MAX, |ticks| ticks.len() <= most)
            .into_iter()
            .map(|tick| tick.label)
            .collect()
    }

    #[test]
    fn steps_are_one_two_five() {
        assert_eq!(TickStep::at_least(0.1).value(1.0).to_string(), "0.1");
        assert_eq!(TickStep::at_least(0.11).value(3.0).to_string(), "0.6");
        assert_eq!(TickStep::at_least(60.0).value(1.0).to_string(), "100");
        assert_eq!(
            TickStep::at_least(3e-7).coarser().value(1.0).to_string(),
            "0.000001"
        );
    }

    #[test]
    fn labels_share_one_scale_and_their_decimals() {
        assert_eq!(labels((0.0, 4e6), "N", 5), ["0", "1", "2", "3", "4"]);
        assert_eq!(
            labels((1.9e6, 2.1e6), "N", 5),
            ["1.90", "1.95", "2.00", "2.05", "2.10"]
        );
        assert_eq!(labels((-1400.0, 0.0), "m", 4), ["-1000", "-500", "0"]);
    }

    #[test]
    fn decades_have_round_numbers() {
        let labels = |range, most: usize| -> Vec<String> {
            let ticks = choose_log(range, "", usize::MAX, |ticks| ticks.len() <= most);
            ticks.into_iter().map(|tick| tick.label).collect()
        };
        assert_eq!(
            labels((0.2, 50.0), 9),
            ["0.2", "0.5", "1", "2", "5", "10", "20", "50"]
        );
        assert_eq!(labels((1e-6, 1e3), 4), ["1e-6", "0.001", "1", "1000"]);
        assert_eq!(labels((20.0, 60.0), 5), ["20", "30", "40", "50", "60"]);
    }

    #[test]
    fn ticks_stand_at_their_values_when_the_range_is_not_round() {
        let ticks = choose((137.0, 481.0), "s", 400, |ticks| ticks.len() <= 4);
        let values: Vec<f64> = ticks.iter().map(|tick| tick.value).collect();
        assert_eq!(values, [200.0, 300.0, 400.0]);
    }
}
