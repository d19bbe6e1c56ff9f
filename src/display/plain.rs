//! Text for places that know ASCII only.

use std::borrow::Cow;

use super::table::Table;

/// The table with all its words in ASCII, before it is laid out.
#[must_use]
pub fn ascii_table(table: &Table) -> Table {
    let mut plain = table.clone();
    let heads = plain.columns.iter_mut().map(|column| &mut column.head);
    let cells = plain.rows.iter_mut().flatten().map(|cell| &mut cell.text);
    let title = std::iter::once(&mut plain.title);
    for text in title.chain(heads).chain(cells).chain(&mut plain.notes) {
        if let Cow::Owned(replaced) = ascii(text) {
            *text = replaced;
        }
    }
    plain
}

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
            '\u{2010}'..='\u{2015}' | '−' | '─' | '━' | '╌' => out.push('-'),
            '·' | '•' => out.push('.'),
            '…' => out.push_str("..."),
            '×' => out.push('x'),
            '⁰'..='⁹' | '²' | '³' | '¹' | '₀'..='₉' => out.push(digit(c)),
            '½' => out.push_str("1/2"),
            '√' => out.push_str("sqrt"),
            '∞' => out.push_str("inf"),
            '‰' => out.push_str("0/00"),
            '∂' => out.push('d'),
            '°' => out.push_str("deg"),
            'µ' | 'μ' => out.push('u'),
            '≤' => out.push_str("<="),
            '≥' => out.push_str(">="),
            '≈' => out.push('~'),
            '→' => out.push_str("->"),
            '←' => out.push_str("<-"),
            '↑' => out.push('^'),
            '↓' => out.push('v'),
            '│' | '┃' | '╎' => out.push('|'),
            '┌' | '┐' | '└' | '┘' | '├' | '┤' | '┬' | '┴' | '┼' | '╋' => {
                out.push('+');
            }
            '▶' => out.push('>'),
            '◀' => out.push('<'),
            '█' => out.push('#'),
            '\u{a0}' | '\u{2007}' | '\u{2009}' | '\u{202f}' => out.push(' '),
            '‘' | '’' => out.push('\''),
            '“' | '”' | '„' | '«' | '»' => out.push('"'),
            _ => out.push_str(letters(c)),
        }
    }
    Cow::Owned(out)
}

/// The digit of a superscript or subscript.
fn digit(c: char) -> char {
    let value = match c {
        '¹' => 1,
        '²' => 2,
        '³' => 3,
        '⁰'..='⁹' => u32::from(c) - u32::from('⁰'),
        _ => u32::from(c) - u32::from('₀'),
    };
    char::from_digit(value, 10).unwrap_or('?')
}

/// Letters of Europe without their accents, and the names of Greek ones.
#[rustfmt::skip] // a table
const LETTERS: &[(&str, &str)] = &[
    ("ÀÁÂÃÅĀĂĄ", "A"), ("àáâãåāăą", "a"), ("ÄÆ", "Ae"), ("äæ", "ae"), ("ÇĆČ", "C"), ("çćč", "c"),
    ("ĎĐÐ", "D"), ("ďđð", "d"), ("ÈÉÊËĒĖĘĚ", "E"), ("èéêëēėęě", "e"), ("Ğ", "G"), ("ğ", "g"),
    ("ÌÍÎÏĪİ", "I"), ("ìíîïīı", "i"), ("Ł", "L"), ("ł", "l"), ("ÑŃŇ", "N"), ("ñńň", "n"),
    ("ÒÓÔÕŌŐ", "O"), ("òóôõōő", "o"), ("ÖØŒ", "Oe"), ("öøœ", "oe"), ("Ř", "R"), ("ř", "r"),
    ("ŚŞŠ", "S"), ("śşš", "s"), ("ß", "ss"), ("ŢŤ", "T"), ("ţť", "t"), ("ÙÚÛŪŮŰ", "U"),
    ("ùúûūůű", "u"), ("Ü", "Ue"), ("ü", "ue"), ("ÝŸ", "Y"), ("ýÿ", "y"), ("ŹŻŽ", "Z"), ("źżž", "z"),
    ("Þ", "Th"), ("þ", "th"),
    ("α", "alpha"), ("β", "beta"), ("γΓ", "gamma"), ("δΔ", "delta"), ("ε", "epsilon"), ("ζ", "zeta"),
    ("η", "eta"), ("θΘ", "theta"), ("κ", "kappa"), ("λΛ", "lambda"), ("ν", "nu"), ("ξ", "xi"),
    ("π", "pi"), ("ρ", "rho"), ("σΣ", "sigma"), ("τ", "tau"), ("φΦ", "phi"), ("ψΨ", "psi"),
    ("ωΩ", "omega"),
];

fn letters(c: char) -> &'static str {
    let found = LETTERS.iter().find(|(from, _)| from.contains(c));
    found.map_or("?", |(_, to)| to)
}

#[cfg(test)]
mod tests {
    use super::ascii;

    #[test]
    fn the_nearest_words_are_taken() {
        assert_eq!(ascii("1.96 MN ± 0.01"), "1.96 MN +/- 0.01");
        assert_eq!(ascii("m²/s → 漢"), "m2/s -> ?");
        assert_eq!(ascii("plain"), "plain");
        assert_eq!(
            ascii("Dépôt Tromsø, 20 °C … ½ λ"),
            "Depot Tromsoe, 20 degC ... 1/2 lambda"
        );
    }
}
