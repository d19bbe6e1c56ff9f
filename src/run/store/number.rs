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
    // A string refuses nothing.
    let _ = write!(text, "{x:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
}

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
}
