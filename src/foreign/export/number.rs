//! Numbers as they are written.

/// A number with at most twelve significant digits: what conversions add in the last bits is not written.
#[must_use]
pub fn written(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    // A negative zero is zero.
    let rounded = rounded + 0.0;
    match rounded.abs() {
        0.0 => "0".to_owned(),
        size if (1e-4..1e7).contains(&size) => format!("{rounded}"),
        _ => format!("{rounded:e}"),
    }
}

/// Numbers with blanks between them.
#[must_use]
pub fn all_written(values: &[f64]) -> String {
    let all: Vec<String> = values.iter().copied().map(written).collect();
    all.join("  ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_bits_are_not_written() {
        assert_eq!(written(0.1 + 0.2), "0.3");
        assert_eq!(written(384_243_000.0), "3.84243e8");
        assert_eq!(written(-0.0), "0");
        assert_eq!(written(1.0 / 3.0), "0.333333333333");
        assert_eq!(written(-1e-300), "-1e-300");
        assert_eq!(all_written(&[1.0, 2.5]), "1  2.5");
    }
}
