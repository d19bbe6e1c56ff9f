//! The range of a number.

/// A range of numbers; either bound may be left out or excluded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest value; minus infinity for none.
    pub min: f64,
    /// Greatest value; infinity for none.
    pub max: f64,
    /// True when the smallest value itself is not allowed.
    pub min_excluded: bool,
}

impl Range {
    /// Any finite number.
    pub const ANY: Self = Self::of(f64::NEG_INFINITY, f64::INFINITY);

    /// From `min` to `max`, both allowed.
    #[must_use]
    pub const fn of(min: f64, max: f64) -> Self {
        Self {
            min,
            max,
            min_excluded: false,
        }
    }

    /// Greater than zero, up to `max`.
    #[must_use]
    pub const fn positive(max: f64) -> Self {
        Self {
            min: 0.0,
            max,
            min_excluded: true,
        }
    }

    /// True when the number is finite and inside.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        let above = if self.min_excluded {
            value > self.min
        } else {
            value >= self.min
        };
        value.is_finite() && above && value <= self.max
    }

    /// The range in words: "greater than 0 m, up to 1e5 m", "from 0 to 1".
    #[must_use]
    pub fn text(&self, unit: &str) -> String {
        let min = quantity(self.min, unit);
        let max = quantity(self.max, unit);
        match (self.min.is_finite(), self.max.is_finite()) {
            (false, false) if matches!(unit, "" | "-") => "any number".to_owned(),
            (false, false) => format!("any number of {unit}"),
            (true, false) if self.min_excluded => format!("greater than {min}"),
            (true, false) => format!("{min} or more"),
            (false, true) => format!("{max} or less"),
            (true, true) if self.min_excluded => format!("greater than {min}, up to {max}"),
            (true, true) => format!("from {} to {max}", number(self.min)),
        }
    }

    /// The range of a whole number in words.
    #[must_use]
    pub fn whole_text(&self) -> String {
        format!("a whole number {}", self.text(""))
    }
}

/// From `min` to `max`, both allowed.
pub const fn of(min: f64, max: f64) -> Range {
    Range::of(min, max)
}

/// Greater than 0, up to `max`.
pub const fn positive(max: f64) -> Range {
    Range::positive(max)
}

/// A number with its unit, short: `1e5 m`, `0.4`.
pub fn quantity(value: f64, unit: &str) -> String {
    match unit {
        "" | "-" => number(value),
        _ => format!("{} {unit}", number(value)),
    }
}

/// A number as a person writes it: `25`, `0.4`, `1e5`, `3.2e-7`.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if size > 0.0 && !(1e-3..1e5).contains(&size) {
        format!("{value:e}")
    } else {
        format!("{value}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_in_words() {
        assert_eq!(
            Range::positive(1e5).text("m"),
            "greater than 0 m, up to 1e5 m"
        );
        assert_eq!(Range::of(0.0, 1.0).text("-"), "from 0 to 1");
        assert_eq!(Range::of(0.0, f64::INFINITY).text("kg"), "0 kg or more");
        assert_eq!(
            Range::of(1.0, 1000.0).whole_text(),
            "a whole number from 1 to 1000"
        );
    }

    #[test]
    fn nothing_but_finite_numbers_is_inside() {
        assert!(!Range::ANY.contains(f64::NAN));
        assert!(!Range::ANY.contains(f64::INFINITY));
        assert!(!Range::positive(1.0).contains(0.0));
        assert!(Range::of(0.0, 1.0).contains(1.0));
    }
}
