//! Times on the command line: `10s`, `2min`, `1h`, or seconds without a unit.

/// Seconds of a time given with its unit.
///
/// # Errors
/// Not a number, or no known unit behind it.
pub(super) fn seconds(text: &str) -> Result<f64, String> {
    let split = text.find(|c: char| c.is_ascii_alphabetic() && c != 'e');
    let (number, unit) = text.split_at(split.unwrap_or(text.len()));
    let scale = match unit.trim() {
        "" | "s" => 1.0,
        "min" => 60.0,
        "h" => 3600.0,
        other => return Err(format!("`{other}` is not a unit of time; give s, min or h")),
    };
    match number.trim().parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(scale * value),
        _ => Err("give a time above zero, such as 10s or 2min".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::seconds;

    #[test]
    fn times_have_units() {
        assert_eq!(seconds("10s"), Ok(10.0));
        assert_eq!(seconds("2min"), Ok(120.0));
        assert_eq!(seconds("1.5 h"), Ok(5400.0));
        assert_eq!(seconds("7"), Ok(7.0));
        assert!(seconds("3d").is_err() && seconds("-1s").is_err() && seconds("s").is_err());
    }
}
