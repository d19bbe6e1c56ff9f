//! A text cut into rows, and rows into words that know where they stand.

use std::ops::Range;

use super::fault::Fault;

/// A word of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Word<'t> {
    /// Its text.
    pub text: &'t str,
    /// Its first byte in the file.
    pub start: usize,
}

impl<'t> Word<'t> {
    /// Its bytes in the file.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    /// Its parts between separators, each with its own place.
    #[must_use]
    pub fn parts(&self, separator: char) -> Vec<Self> {
        let mut parts = Vec::new();
        let mut start = self.start;
        for text in self.text.split(separator) {
            parts.push(Self { text, start });
            start += text.len() + separator.len_utf8();
        }
        parts
    }

    /// The number it is, in the ways of C and of Fortran (1.5D3, 1.5+3); infinite and NaN are none.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        let number = |text: &str| text.parse::<f64>().ok().filter(|value| value.is_finite());
        let plain = self
            .text
            .bytes()
            .all(|byte| byte.is_ascii_digit() || b"+-.eEdD".contains(&byte));
        let of_fortran = || {
            number(&self.text.replace(['d', 'D'], "e"))
                .or_else(|| number(&with_exponent(self.text)?))
        };
        plain
            .then(|| number(self.text).or_else(of_fortran))
            .flatten()
    }

    /// The number it must be, or the fault that it is none.
    ///
    /// # Errors
    /// It is no finite number.
    pub fn required(&self, key: &str) -> Result<f64, Fault> {
        self.number().ok_or_else(|| {
            Fault::new(
                self.span(),
                key,
                format!("`{}` is not a number", self.text),
                "write a number such as 0.25 or 3.84e8",
            )
        })
    }

    /// The whole number it must be.
    ///
    /// # Errors
    /// It is no whole number that is not negative.
    pub fn whole(&self, key: &str) -> Result<usize, Fault> {
        let written_as_real = || {
            let value = self.number()?;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "whole and in range"
            )]
            (value.fract() == 0.0 && (0.0..1e9).contains(&value)).then_some(value as usize)
        };
        let whole = self.text.parse().ok().or_else(written_as_real);
        whole.ok_or_else(|| {
            Fault::new(
                self.span(),
                key,
                format!("`{}` is not a whole number", self.text),
                "write a whole number such as 20",
            )
        })
    }

    /// Whether it is this word, in capitals or not.
    #[must_use]
    pub fn is(&self, word: &str) -> bool {
        self.text.eq_ignore_ascii_case(word)
    }
}

/// A number whose exponent has a sign and no letter, as Fortran writes and reads it, with the letter.
fn with_exponent(text: &str) -> Option<String> {
    let (digits, exponent) = text.split_at(text.rfind(['+', '-'])?);
    let is_plain = digits.ends_with(|letter: char| letter.is_ascii_digit() || letter == '.');
    is_plain.then(|| format!("{digits}e{exponent}"))
}

/// A row of a file: one line of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row<'t> {
    /// Its text without the end of the line.
    pub text: &'t str,
    /// Its first byte in the file.
    pub start: usize,
}

impl<'t> Row<'t> {
    /// The rows of a text.
    pub fn all(text: &'t str) -> impl Iterator<Item = Self> {
        Self::all_from(text, 0)
    }

    /// The rows of a text whose first byte is counted as `start`.
    pub fn all_from(text: &'t str, mut start: usize) -> impl Iterator<Item = Self> {
        text.split_inclusive('\n').map(move |line| {
            let row = Self {
                text: line.trim_end_matches(['\n', '\r']),
                start,
            };
            start += line.len();
            row
        })
    }

    /// Its bytes in the file, without the blanks around it.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        let left = self.text.len() - self.text.trim_start().len();
        let start = self.start + left;
        start..start + self.text.trim().len()
    }

    /// Its words, up to a remark: what follows `#` or `%` at the beginning of a word, or `!` anywhere.
    #[must_use]
    pub fn words(&self) -> Vec<Word<'t>> {
        self.up_to(&['#', '%', '!'])
    }

    /// Its words where `#` marks numbers: up to what follows `!`.
    #[must_use]
    pub fn words_with_marks(&self) -> Vec<Word<'t>> {
        self.up_to(&['!'])
    }

    fn up_to(&self, remarks: &[char]) -> Vec<Word<'t>> {
        let mut words = Vec::new();
        let mut rest = self.text.split('!').next().unwrap_or_default();
        let end = rest.len();
        loop {
            let trimmed = rest.trim_start();
            if trimmed.is_empty() || trimmed.starts_with(remarks) {
                return words;
            }
            let length = trimmed.find(char::is_whitespace).unwrap_or(trimmed.len());
            let start = self.start + (end - trimmed.len());
            words.push(Word {
                text: &trimmed[..length],
                start,
            });
            rest = &trimmed[length..];
        }
    }

    /// Whether there is nothing on it but blanks and remarks.
    #[must_use]
    pub fn is_blank(&self) -> bool {
        self.words().is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_know_where_they_stand() {
        let text = "one\ttwo  # rest\r\n\n 3.5 4D2|5\n";
        let rows: Vec<Row<'_>> = Row::all(text).collect();
        assert_eq!(rows.len(), 3);
        assert!(rows[1].is_blank());
        let words: Vec<Word<'_>> = rows.iter().flat_map(Row::words).collect();
        let texts: Vec<&str> = words.iter().map(|word| word.text).collect();
        assert_eq!(texts, ["one", "two", "3.5", "4D2|5"]);
        for word in &words {
            assert_eq!(&text[word.span()], word.text);
        }
        assert_eq!(words[2].number(), Some(3.5));
        assert_eq!(words[3].number(), None);
        let parts = words[3].parts('|');
        assert_eq!(parts[0].number(), Some(400.0));
        assert_eq!(&text[parts[1].span()], "5");
        assert_eq!(parts[1].whole("x"), Ok(5));
    }

    #[test]
    fn remarks_and_exponents_are_those_of_fortran() {
        let row = Row::all("1.2+9 .25!remark % 7").next().unwrap();
        let words = row.words();
        let texts: Vec<&str> = words.iter().map(|word| word.text).collect();
        assert_eq!(texts, ["1.2+9", ".25"]);
        assert_eq!(words[0].number(), Some(1.2e9));
        assert_eq!(words[1].start, 6);
        let plain = |text| Word { text, start: 0 }.number();
        assert_eq!(plain("1-2-3"), None);
        assert_eq!(plain("-5"), Some(-5.0));
    }

    #[test]
    fn what_is_no_number_says_so() {
        for text in [
            "", "nan", "inf", "1e999", "0x10", "1_000", "-", "abc", "1.2.3",
        ] {
            let word = Word { text, start: 0 };
            assert_eq!(word.number(), None, "{text}");
        }
        let word = Word {
            text: "2.5",
            start: 7,
        };
        let fault = word.whole("NumSegs").unwrap_err();
        assert_eq!((fault.span, fault.key.as_str()), (7..10, "NumSegs"));
    }
}
