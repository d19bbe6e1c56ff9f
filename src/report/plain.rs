//! Text for places that know ASCII only.

use std::borrow::Cow;

/// The text with every character that ASCII lacks replaced by the nearest words: `±` becomes `+/-`,
/// `m²` becomes `m2`; what has no neighbour becomes a question mark.
#[must_use]
pub fn ascii(text: &str) -> Cow<'_, str> {
    if text.is_ascii() {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            c if c.is_ascii() => out.push(c),
            '±' => out.push_str("+/-"),
            '–' | '—' | '−' | '─' => out.push('-'),
            '·' | '…' => out.push('.'),
            '×' => out.push('x'),
            '²' => out.push('2'),
            '³' => out.push('3'),
            '°' => out.push_str("deg"),
            'µ' | 'μ' => out.push('u'),
            'π' => out.push_str("pi"),
            '≤' => out.push_str("<="),
            '≥' => out.push_str(">="),
            '≈' => out.push('~'),
            '→' => out.push_str("->"),
            '│' => out.push('|'),
            '‘' | '’' => out.push('\''),
            '“' | '”' => out.push('"'),
            _ => out.push('?'),
        }
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::ascii;

    #[test]
    fn the_nearest_words_are_taken() {
        assert_eq!(ascii("1.96 MN ± 0.01"), "1.96 MN +/- 0.01");
        assert_eq!(ascii("m²/s → 漢"), "m2/s -> ?");
        assert_eq!(ascii("plain"), "plain");
    }
}
