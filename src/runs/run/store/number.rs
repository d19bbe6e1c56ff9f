//! Numbers as text that read back to the same bits.

use std::fmt::Write as _;

/// The fewest digits that read back to the same number.
pub(super) fn text(x: f64) -> String {
    let mut text = String::new();
    append(&mut text, x);
    text
}

/// The same at the end of a text.
pub(super) fn append(text: &mut String, x: f64) {
    // A fifth of the time of the standard library, where that writes no power of ten; of two numbers as short and as near, this
    // one takes the even one.
    if x == 0.0 || WITHOUT_POWER.contains(&x.abs()) {
        text.push_str(zmij::Buffer::new().format_finite(x));
    } else {
        // A string refuses nothing.
        let _ = write!(text, "{x:?}");
    }
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
}

/// Magnitudes that the standard library writes without a power of ten.
const WITHOUT_POWER: std::ops::Range<f64> = 1e-4..1e16;

/// Room for a number and a comma: most take no more.
pub(super) const ROOM: usize = 24;

/// As [`text`]; nothing for an absent number.
pub(super) fn text_or_empty(x: Option<f64>) -> String {
    x.map(text).unwrap_or_default()
}

/// Reads a number; absent where the text is no finite number.
pub(super) fn parse(text: &str) -> Option<f64> {
    let number: f64 = text.trim().parse().ok()?;
    number.is_finite().then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_reads_back_to_the_same_bits() {
        let tenth = 0.1_f64;
        for x in [
            0.0,
            -0.0,
            1.0,
            tenth + 0.2,
            1.0 / 3.0,
            1e300,
            -5e-324,
            f64::MAX,
            2.02e6,
        ] {
            let back = parse(&text(x)).unwrap_or(f64::NAN);
            assert_eq!(
                back.to_bits(),
                x.to_bits(),
                "{x} was written as {}",
                text(x)
            );
        }
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(parse(&text(x)), None);
        }
        assert_eq!(text(2.0), "2");
    }

    #[test]
    fn no_number_is_longer_than_by_the_standard_library() {
        let mut random = crate::numerics::random::Random::new(2026, 0);
        for count in 0..200_000 {
            let power = random.uniform() * 44.0 - 22.0;
            let digits = 10_f64.powi(count % 18);
            let exact = (random.uniform() - 0.5) * 10_f64.powf(power);
            for x in [exact, (exact * digits).round() / digits] {
                let debug = format!("{x:?}");
                let short = debug.strip_suffix(".0").unwrap_or(&debug);
                assert_eq!(text(x).len(), short.len(), "{x}");
                assert_eq!(parse(&text(x)).map(f64::to_bits), Some(x.to_bits()));
            }
        }
    }
}
