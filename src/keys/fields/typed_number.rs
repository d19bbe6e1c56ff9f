//! Text that stands for a number: in quotes, with a unit, with a decimal comma, as a product. What it means is proposed, not taken: a
//! unit that is not known is not dropped.

use crate::decimal::decimal_length;

/// What the text stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TypedNumber {
    /// The number, alone or with the unit of the field.
    Plain(f64),
    /// A number with another unit of the same kind, in the unit of the field.
    Converted(f64),
    /// A number with a decimal comma.
    Comma(f64),
    /// A product or quotient.
    Computed(f64),
    /// A number with a unit that is none of these.
    UnknownUnit,
}

/// Prefixes of units, and what they multiply by.
const PREFIXES: [(&str, f64); 5] = [("k", 1e3), ("M", 1e6), ("G", 1e9), ("c", 1e-2), ("m", 1e-3)];

/// Other units by those of fields.
const OTHERS: [(&str, &str, f64); 12] = [
    ("t", "kg", 1e3),
    ("g", "kg", 1e-3),
    ("t/m", "kg/m", 1e3),
    ("min", "s", 60.0),
    ("h", "s", 3600.0),
    ("kn", "m/s", 1852.0 / 3600.0),
    ("km/h", "m/s", 1.0 / 3.6),
    ("ft", "m", 0.3048),
    ("in", "m", 0.0254),
    ("rad", "deg", 180.0 / std::f64::consts::PI),
    ("bar", "Pa", 1e5),
    ("tf", "N", 9806.65),
];

impl TypedNumber {
    /// Reads the text for a field of this unit; nothing where it begins with no number.
    pub fn read(text: &str, unit: &str) -> Option<Self> {
        let (value, rest) = leading_number(text.trim())?;
        let unit = plain(unit);
        let rest = rest.trim();
        if let Some(decimals) = rest.strip_prefix(',') {
            // `1,500` may be either of 1.5 and 1500.
            let is_clear = !decimals.is_empty() && decimals.len() != 3;
            let digits = is_clear && decimals.bytes().all(|b| b.is_ascii_digit());
            let value = text.trim().replace(',', ".").parse().ok();
            return value.filter(|_| digits).map(Self::Comma);
        }
        if rest.starts_with(['*', '/']) {
            return computed(value, rest).map(Self::Computed);
        }
        let written = plain(rest);
        if written.is_empty() || written == unit {
            return Some(Self::Plain(value));
        }
        Some(
            conversion(&written, &unit).map_or(Self::UnknownUnit, |by| Self::Converted(value * by)),
        )
    }
}

impl TypedNumber {
    /// What follows the number of a text; nothing where it begins with no number.
    pub fn unit_text(text: &str) -> Option<&str> {
        leading_number(text.trim()).map(|(_, rest)| rest.trim())
    }
}

/// The finite number that a text begins with, as long as it can be, and what follows.
fn leading_number(text: &str) -> Option<(f64, &str)> {
    let sign = usize::from(text.starts_with(['+', '-']));
    let length = decimal_length(&text[sign..])?;
    let (number, rest) = text.split_at(sign + length);
    let value = number.parse::<f64>().ok()?;
    value.is_finite().then_some((value, rest))
}

/// `* b / c ...` after a number.
fn computed(first: f64, rest: &str) -> Option<f64> {
    let (mut value, mut rest) = (first, rest);
    while let Some(sign) = rest.chars().next() {
        let (number, after) = leading_number(rest.strip_prefix(['*', '/'])?.trim_start())?;
        value = if sign == '*' {
            value * number
        } else {
            value / number
        };
        rest = after.trim_start();
    }
    value.is_finite().then_some(value)
}

/// A unit as one types it: without spaces and raised digits.
fn plain(unit: &str) -> String {
    let letters = unit.chars().filter(|c| !c.is_whitespace() && *c != '^');
    let lowered = letters.map(|c| match c {
        '²' => '2',
        '³' => '3',
        '°' => 'd',
        other => other,
    });
    match lowered.collect::<String>() {
        unit if unit == "d" => "deg".to_owned(),
        unit if unit == "-" => String::new(),
        unit => unit,
    }
}

/// What a number in one unit is multiplied by to be in another.
fn conversion(from: &str, to: &str) -> Option<f64> {
    let other = OTHERS
        .iter()
        .find(|(name, of, _)| *name == from && *of == to);
    let by_prefix = || {
        let fits =
            |(prefix, _): &&(&str, f64)| !to.is_empty() && from.strip_prefix(*prefix) == Some(to);
        PREFIXES.iter().find(fits).map(|(_, by)| *by)
    };
    // A prefix multiplies the square or the cube of a length as often.
    let is_power = to.starts_with("m2") || to.starts_with("m3") || to.starts_with("m4");
    other
        .map(|(.., by)| *by)
        .or_else(|| by_prefix().filter(|_| !is_power))
}

#[cfg(test)]
mod tests {
    use super::TypedNumber::{Comma, Computed, Converted, Plain, UnknownUnit};
    use super::*;

    #[test]
    fn what_is_typed_is_understood() {
        for (text, unit, meant) in [
            ("80 m", "m", Some(Plain(80.0))),
            ("80", "m", Some(Plain(80.0))),
            ("1e3 N/m^3", "N/m³", Some(Plain(1e3))),
            ("12°", "deg", Some(Plain(12.0))),
            ("0.5 km", "m", Some(Converted(500.0))),
            ("2.5 MN", "N", Some(Converted(2.5e6))),
            ("3 t", "kg", Some(Converted(3e3))),
            ("1.5kN/m", "N/m", Some(Converted(1.5e3))),
            ("20 mm", "m", Some(Converted(0.02))),
            ("1 h", "s", Some(Converted(3600.0))),
            ("1,5", "m", Some(Comma(1.5))),
            ("2*250", "m", Some(Computed(500.0))),
            ("3 / 4 * 2", "m", Some(Computed(1.5))),
            ("2*", "m", None),
            ("1/0", "m", None),
            ("1,5,2", "m", None),
            ("1,500", "m", None),
            ("5 furlongs", "m", Some(UnknownUnit)),
            ("2 km2", "m²", Some(UnknownUnit)),
            ("inf", "m", None),
            ("long", "m", None),
            ("", "m", None),
        ] {
            assert_eq!(TypedNumber::read(text, unit), meant, "{text} for {unit}");
        }
    }
}
