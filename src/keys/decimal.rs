//! Where a decimal number ends.

/// Bytes of the decimal number without a sign at the beginning of a text (`1`, `1.`, `.5`, `1.5e-3`); nothing where there is none.
pub fn decimal_length(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    let digits = |from: usize| {
        let rest = bytes.get(from..).unwrap_or_default().iter();
        rest.take_while(|byte| byte.is_ascii_digit()).count()
    };
    let whole = digits(0);
    let mut end = whole;
    if bytes.get(end) == Some(&b'.') {
        let decimals = digits(end + 1);
        if whole + decimals == 0 {
            return None;
        }
        end += 1 + decimals;
    }
    if end == 0 {
        return None;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    Some(end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_ends_where_it_is_none_with_more() {
        for (text, length) in [
            ("1", Some(1)),
            ("12.5 m", Some(4)),
            ("1.", Some(2)),
            (".5", Some(2)),
            ("1.5e-3x", Some(6)),
            ("1E+9", Some(4)),
            ("1e", Some(1)),
            ("1e+", Some(1)),
            ("1..2", Some(2)),
            ("1.2.3", Some(3)),
            (".", None),
            (".e5", None),
            ("e5", None),
            ("-1", None),
            ("", None),
        ] {
            let found = decimal_length(text);
            assert_eq!(found, length, "{text}");
            if let Some(end) = found {
                assert!(text[..end].parse::<f64>().is_ok(), "{text}");
            }
        }
    }
}
