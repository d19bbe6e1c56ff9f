//! One wording for numbers: digits that the error estimate supports, and the unit.
//!
//! Forces, pressures, powers and energies carry engineering prefixes from kilo up (`1.961 MN`);
//! metres, seconds and everything else stay as they are. Powers of ten are written only where a
//! number would otherwise be too long to read.

/// Units that take engineering prefixes.
const PREFIXED: [&str; 7] = ["N", "Pa", "W", "J", "N m", "N m²", "N s"];

/// Greatest number of significant digits shown, however small the error.
const MOST_DIGITS: i32 = 7;

/// What is smaller counts as zero: nothing measured is, and its powers of ten would underflow.
const SMALLEST: f64 = 1e-290;

/// The scale of a number for display: it is divided by `factor`, which the prefix of the unit or a power of ten
/// shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// What numbers are divided by.
    pub factor: f64,
    /// Prefix of the unit (`"M"`), or nothing.
    pub prefix: &'static str,
    /// Power of ten where no prefix serves; 0 for none.
    pub exponent: i32,
}

impl Scale {
    /// The scale at which a number of this magnitude is shown.
    #[must_use]
    pub fn of_magnitude(magnitude: f64, unit: &str) -> Self {
        let size = magnitude.abs();
        let prefixed = PREFIXED.contains(&unit);
        if prefixed && (1e3..1e15).contains(&size) {
            let (factor, prefix) = match size {
                s if s < 1e6 => (1e3, "k"),
                s if s < 1e9 => (1e6, "M"),
                s if s < 1e12 => (1e9, "G"),
                _ => (1e12, "T"),
            };
            return Self {
                factor,
                prefix,
                exponent: 0,
            };
        }
        if !size.is_finite() || size < SMALLEST || (1e-4..1e7).contains(&size) {
            return Self {
                factor: 1.0,
                prefix: "",
                exponent: 0,
            };
        }
        let exponent = order(size).div_euclid(3) * 3;
        Self {
            factor: 10f64.powi(exponent),
            prefix: "",
            exponent,
        }
    }

    /// The unit with its prefix, or a power of ten with the unit: `MN`, `m`, `1e9 m`; the text in the
    /// brackets of an axis label. Empty for a plain number without unit.
    #[must_use]
    pub fn unit(&self, unit: &str) -> String {
        let unit = shown(unit);
        match (self.exponent, unit) {
            (0, _) => format!("{}{unit}", self.prefix),
            (e, "") => format!("1e{e}"),
            (e, _) => format!("1e{e} {unit}"),
        }
    }

    /// What follows the digits of a number at this scale: `e9`, or nothing.
    fn power(&self) -> String {
        match self.exponent {
            0 => String::new(),
            e => format!("e{e}"),
        }
    }
}

/// A number with its estimated error, both to the digits that the error supports:
/// `1.9613 MN ± 0.0004`. Without an estimate it says so: `1.961 MN (error not estimated)`.
#[must_use]
pub fn with_error(value: f64, error: Option<f64>, unit: &str) -> String {
    if !value.is_finite() {
        return "not available".to_owned();
    }
    let Some(error) = error.filter(|e| e.is_finite() && *e >= 0.0) else {
        return format!("{} (error not estimated)", si(value, unit));
    };
    let scale = Scale::of_magnitude(value.abs().max(error), unit);
    let (value, error) = (value / scale.factor, error / scale.factor);
    let decimals = supported_decimals(value, error);
    let unit = scale_unit(scale, unit);
    let power = scale.power();
    format!(
        "{}{power}{unit} ± {}{power}",
        rounded(value, decimals),
        rounded(round_up(error, decimals), decimals),
    )
}

/// A number of a coarse computation, to three significant digits: `~2.13 MN`.
#[must_use]
pub fn coarse(value: f64, unit: &str) -> String {
    if !value.is_finite() {
        return "not available".to_owned();
    }
    let scale = Scale::of_magnitude(value, unit);
    format!(
        "~{}{}{}",
        digits(value / scale.factor, 3),
        scale.power(),
        scale_unit(scale, unit)
    )
}

/// A range with its unit, to two significant digits of its width: `5.1 to 7.3 MN`.
#[must_use]
pub fn range(least: f64, greatest: f64, unit: &str) -> String {
    if !least.is_finite() || !greatest.is_finite() {
        return "not available".to_owned();
    }
    let scale = Scale::of_magnitude(least.abs().max(greatest.abs()), unit);
    let [least, greatest] = [least, greatest].map(|end| end / scale.factor);
    let decimals = supported_decimals(greatest, 0.5 * (greatest - least));
    let (power, unit) = (scale.power(), scale_unit(scale, unit));
    format!(
        "{}{power} to {}{power}{unit}",
        rounded(least, decimals),
        rounded(greatest, decimals)
    )
}

/// A number with its unit, to four significant digits: `1.961 MN`, `1404 m`, `0.3 m/s`.
#[must_use]
pub fn si(value: f64, unit: &str) -> String {
    if !value.is_finite() {
        return "not available".to_owned();
    }
    let scale = Scale::of_magnitude(value, unit);
    let value = value / scale.factor;
    format!(
        "{}{}{}",
        digits(value, 4),
        scale.power(),
        scale_unit(scale, unit)
    )
}

/// A bare number to so many significant digits, without trailing zeros after the point.
#[must_use]
pub fn digits(value: f64, count: i32) -> String {
    if !value.is_finite() {
        return "not available".to_owned();
    }
    let decimals = if value.abs() > SMALLEST {
        count - 1 - order(value)
    } else {
        0
    };
    let text = rounded(value, decimals.max(0));
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A fraction as a percentage: `0.91 %`, `12.3 %`, `0.0013 %`.
#[must_use]
pub fn percent(fraction: f64) -> String {
    let value = fraction * 100.0;
    if !value.is_finite() {
        return "not available".to_owned();
    }
    let decimals = match value.abs() {
        v if v <= 0.0 || v >= 100.0 => 0,
        v if v >= 10.0 => 1,
        v if v >= 0.01 => 2,
        v => 1 - order(v),
    };
    format!("{} %", rounded(value, decimals))
}

/// A stretch of time as people say it: `12.3 ms`, `3.42 s`, `2 min 05 s`, `1 h 02 min`.
#[must_use]
pub fn duration(seconds: f64) -> String {
    if !seconds.is_finite() {
        return "not available".to_owned();
    }
    let sign = if seconds < 0.0 { "-" } else { "" };
    let s = seconds.abs();
    let text = match s {
        s if s <= 0.0 => "0 s".to_owned(),
        s if s < 0.999_5e-3 => format!("{} µs", digits(s * 1e6, 3)),
        s if s < 0.999_5 => format!("{} ms", digits(s * 1e3, 3)),
        s if s < 59.95 => format!("{} s", digits(s, 3)),
        s if s < 3599.5 => {
            let whole = s.round() as u64;
            format!("{} min {:02} s", whole / 60, whole % 60)
        }
        s => {
            let minutes = (s / 60.0).round() as u64;
            format!("{} h {:02} min", minutes / 60, minutes % 60)
        }
    };
    format!("{sign}{text}")
}

/// A number with a fixed count of decimals, never `-0`. A negative count rounds to tens, hundreds.
#[must_use]
pub fn rounded(value: f64, decimals: i32) -> String {
    let value = if decimals < 0 {
        let unit = 10f64.powi(-decimals);
        (value / unit).round() * unit
    } else {
        value
    };
    let text = format!("{value:.*}", decimals.clamp(0, 300) as usize);
    match text.strip_prefix('-') {
        Some(rest) if !rest.bytes().any(|b| (b'1'..=b'9').contains(&b)) => rest.to_owned(),
        _ => text,
    }
}

/// The decimal order of a number: 0 for 1 to 9.99, -1 for 0.1, 3 for 1000. The sign does not matter.
#[must_use]
pub fn order(value: f64) -> i32 {
    value.abs().log10().floor() as i32
}

/// Decimals that an error supports: its first digit, or its first two when it begins with a one.
fn supported_decimals(value: f64, error: f64) -> i32 {
    let finest = if value.abs() > SMALLEST {
        MOST_DIGITS - 1 - order(value)
    } else {
        MOST_DIGITS - 1
    };
    if error < SMALLEST {
        return finest.max(0);
    }
    let first = order(error);
    let leading = error / 10f64.powi(first);
    let wanted = if leading < 1.95 { 1 - first } else { -first };
    wanted.min(finest.max(0))
}

/// An error is rounded up, so that the words never promise more than the estimate.
fn round_up(error: f64, decimals: i32) -> f64 {
    let unit = 10f64.powi(-decimals);
    // A hair less forgives the last bits of an error that is already round.
    (error / unit * (1.0 - 1e-9)).ceil() * unit
}

/// The unit as it follows a number, with the space before it.
fn scale_unit(scale: Scale, unit: &str) -> String {
    match shown(unit) {
        "" => String::new(),
        unit => format!(" {}{unit}", scale.prefix),
    }
}

/// The unit as shown: a dash in a file means a plain number.
fn shown(unit: &str) -> &str {
    if unit == "-" { "" } else { unit }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_decides_the_digits() {
        assert_eq!(
            with_error(1_961_342.0, Some(400.0), "N"),
            "1.9613 MN ± 0.0004"
        );
        assert_eq!(with_error(1404.377, Some(0.012), "m"), "1404.377 m ± 0.012");
        assert_eq!(with_error(281.4, Some(2.3), "s"), "281 s ± 3");
        assert_eq!(with_error(0.3, Some(12.0), "N"), "0 N ± 12");
        assert_eq!(with_error(12_346.0, Some(1234.0), "m"), "12300 m ± 1300");
    }

    #[test]
    fn a_tiny_error_is_not_given_more_digits_than_can_be_read() {
        assert_eq!(
            with_error(1_961_342.0, Some(1e-9), "N"),
            "1.961342 MN ± 0.000001"
        );
        assert_eq!(with_error(2.0, Some(0.0), "m"), "2.000000 m ± 0.000000");
    }

    #[test]
    fn a_missing_error_is_said_in_words() {
        assert_eq!(
            with_error(1_961_342.0, None, "N"),
            "1.961 MN (error not estimated)"
        );
        assert_eq!(
            with_error(1.0, Some(f64::NAN), "m"),
            "1 m (error not estimated)"
        );
        assert_eq!(with_error(f64::NAN, Some(1.0), "m"), "not available");
    }

    #[test]
    fn prefixes_go_with_forces_and_not_with_metres() {
        assert_eq!(si(763_000.0, "N"), "763 kN");
        assert_eq!(si(-9.4e8, "N"), "-940 MN");
        assert_eq!(si(12_345.0, "m"), "12345 m");
        assert_eq!(si(0.3, "m/s"), "0.3 m/s");
        assert_eq!(si(0.0, "N"), "0 N");
        assert_eq!(si(2.5e9, "m"), "2.5e9 m");
        assert_eq!(si(1.19e-6, "m²/s"), "1.19e-6 m²/s");
        assert_eq!(si(0.062, "-"), "0.062");
        assert_eq!(si(5e-324, "m"), "0 m");
    }

    #[test]
    fn percentages_keep_what_matters() {
        assert_eq!(percent(0.0091), "0.91 %");
        assert_eq!(percent(-0.0253), "-2.53 %");
        assert_eq!(percent(0.123), "12.3 %");
        assert_eq!(percent(0.000_013), "0.0013 %");
        assert_eq!(percent(0.0), "0 %");
        assert_eq!(percent(-1e-9), "-0.00000010 %");
    }

    #[test]
    fn durations_are_worded_as_people_say_them() {
        assert_eq!(duration(0.012_34), "12.3 ms");
        assert_eq!(duration(4.2e-5), "42 µs");
        assert_eq!(duration(3.416), "3.42 s");
        assert_eq!(duration(59.97), "1 min 00 s");
        assert_eq!(duration(125.0), "2 min 05 s");
        assert_eq!(duration(3720.0), "1 h 02 min");
    }
}
