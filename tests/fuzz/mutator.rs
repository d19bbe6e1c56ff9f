//! Inputs made of others: bytes, words, numbers and lines changed, so that most of a text stays what a reader expects.

use std::ops::Range;

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

use crate::targets::LONGEST;

/// What stands in the place of a number.
const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "-0.0",
    "1",
    "-1",
    "2",
    "1e308",
    "-1e308",
    "1e309",
    "1e-320",
    "1e-308",
    "nan",
    "inf",
    "-inf",
    "NaN",
    "1e15",
    "1e9",
    "1e6",
    "1e-9",
    "0.1",
    "9223372036854775807",
    "9223372036854775808",
    "-9223372036854775808",
    "18446744073709551616",
    "4294967296",
    "2147483648",
    "99999999999999999999999999",
    "0x7fffffffffffffff",
    "1_000",
    "1d5",
    "1.5.2",
    "3.0000000000000000000001",
    "6.123233995736766e-17",
];

/// Characters that steer a terminal, reorder a text or end a word.
const CHARACTERS: &[&str] = &[
    "\u{0}",
    "\u{1b}[31m",
    "\u{1b}]52;c;aGk=\u{7}",
    "\u{9b}31m",
    "\u{202e}",
    "\u{2066}",
    "\u{200b}",
    "\u{feff}",
    "\u{2028}",
    "\u{e0041}",
    "\r",
    "\t",
    "\u{7f}",
    "\u{e9}",
    "\u{1f600}",
    "\"",
    "'",
    "\"\"\"",
    "#",
    "[",
    "]",
    "{",
    "}",
    ",",
    "=",
    ":",
    "-",
    "---",
    "&",
    "*",
    "|",
    "\\",
    "\n\n",
];

/// Makes inputs of a corpus, the same ones for the same seed.
pub(crate) struct Mutator<'a> {
    corpus: &'a [Vec<u8>],
    random: SplitMix64,
}

impl<'a> Mutator<'a> {
    /// One stream of a seed.
    pub(crate) fn new(corpus: &'a [Vec<u8>], seed: u64, stream: u64) -> Self {
        let mixed =
            SplitMix64::seed_from_u64(seed).next_u64() ^ stream.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        Self {
            corpus,
            random: SplitMix64::seed_from_u64(SplitMix64::seed_from_u64(mixed).next_u64()),
        }
    }

    /// The next input.
    pub(crate) fn input(&mut self) -> Vec<u8> {
        let mut data = self.any().clone();
        // Often one change: what many leave of a text is refused at its first fault.
        let most = [1, 1, 2, 4, 8][self.below(5)];
        for _ in 0..=self.below(most) {
            self.change(&mut data);
        }
        data.truncate(LONGEST);
        data
    }

    fn below(&mut self, end: usize) -> usize {
        let end = end.max(1) as u64;
        usize::try_from(self.random.next_u64() % end).unwrap_or(0)
    }

    fn any(&mut self) -> &'a Vec<u8> {
        let at = self.below(self.corpus.len());
        &self.corpus[at]
    }

    fn one(&mut self, of: &[&'static str]) -> &'static str {
        of[self.below(of.len())]
    }

    fn change(&mut self, data: &mut Vec<u8>) {
        let at = self.below(data.len() + 1);
        match self.below(20) {
            0 => self.flip(data, at),
            1 => data.truncate(at),
            2 => {
                let byte = self.random.next_u64().to_le_bytes()[0];
                data.insert(at, byte);
            }
            3 => {
                let end = (at + 1 + self.below(40)).min(data.len());
                data.drain(at..end);
            }
            4 => self.splice(data, at),
            5..=9 => self.number(data, at),
            10 | 11 => self.word(data, at),
            12 | 13 => self.double(data, at),
            14 => drop(data.drain(line_at(data, at))),
            15 => self.line(data, at),
            16 => self.value(data, at),
            17 => self.nest(data, at),
            18 => self.lengthen(data, at),
            _ => insert(data, at, self.one(CHARACTERS).as_bytes()),
        }
    }

    fn flip(&mut self, data: &mut [u8], at: usize) {
        if let Some(byte) = data.get_mut(at) {
            *byte ^= 1 << self.below(8);
        }
    }

    /// Goes on as another input does.
    fn splice(&mut self, data: &mut Vec<u8>, at: usize) {
        let other = self.any();
        let from = line_at(other, self.below(other.len() + 1)).start;
        data.truncate(line_at(data, at).start);
        data.extend_from_slice(&other[from..]);
    }

    /// Another number in the place of the next one.
    fn number(&mut self, data: &mut Vec<u8>, at: usize) {
        let Some(place) = next_number(data, at) else {
            return;
        };
        let old = String::from_utf8_lossy(&data[place.clone()]).into_owned();
        let new = match (self.below(3), old.parse::<f64>()) {
            (0, Ok(value)) => {
                let factor = [-1.0, 10.0, 0.1, 1.000_001, 0.5, 1e3, 1e-3][self.below(7)];
                format!("{:?}", value * factor)
            }
            (1, Ok(value)) => format!("{}", value.trunc() + [1.0, -1.0, 0.0][self.below(3)]),
            _ => self.one(NUMBERS).to_owned(),
        };
        data.splice(place, new.bytes());
    }

    /// A word of another input in the place of one here.
    fn word(&mut self, data: &mut Vec<u8>, at: usize) {
        let other = self.any();
        let new = word_at(other, self.below(other.len() + 1));
        data.splice(word_at(data, at), other[new].iter().copied());
    }

    /// A line, or a stretch of lines, once more or many times.
    fn double(&mut self, data: &mut Vec<u8>, at: usize) {
        let first = line_at(data, at);
        let end = line_at(data, first.end + self.below(200)).end;
        let lines = data[first.start..end.max(first.end)].to_vec();
        let times = [1, 1, 1, 2, 5, 40][self.below(6)];
        let times = times.min(LONGEST / lines.len().max(1));
        insert(data, first.end, &lines.repeat(times));
    }

    /// A line of another input.
    fn line(&mut self, data: &mut Vec<u8>, at: usize) {
        let other = self.any();
        let line = line_at(other, self.below(other.len() + 1));
        let start = line_at(data, at).start;
        insert(data, start, &other[line]);
    }

    /// The value of another line.
    fn value(&mut self, data: &mut Vec<u8>, at: usize) {
        let from = self.below(data.len() + 1);
        if let (Some(old), Some(new)) = (value_at(data, at), value_at(data, from)) {
            let new = data[new].to_vec();
            data.splice(old, new);
        }
    }

    fn nest(&mut self, data: &mut Vec<u8>, at: usize) {
        let (open, close) = [
            ("[", "]"),
            ("{a=", "}"),
            ("{\"a\":", "}"),
            ("- ", ""),
            ("a.", ""),
            ("[[", "]]"),
        ][self.below(6)];
        let deep = [3, 100, 3000][self.below(3)];
        insert(
            data,
            at,
            (open.repeat(deep) + "1" + &close.repeat(deep)).as_bytes(),
        );
    }

    fn lengthen(&mut self, data: &mut Vec<u8>, at: usize) {
        let piece = self.one(&["a", "9", "é", " ", "\u{301}"]);
        let long = piece.repeat([30, 300, 3000][self.below(3)]);
        let end = word_at(data, at).end;
        insert(data, end, long.as_bytes());
    }
}

fn insert(data: &mut Vec<u8>, at: usize, piece: &[u8]) {
    let at = at.min(data.len());
    data.splice(at..at, piece.iter().copied());
}

/// The line that holds a place, with its end.
fn line_at(data: &[u8], at: usize) -> Range<usize> {
    let at = at.min(data.len());
    let start = data[..at]
        .iter()
        .rposition(|byte| *byte == b'\n')
        .map_or(0, |end| end + 1);
    let end = data[at..]
        .iter()
        .position(|byte| *byte == b'\n')
        .map_or(data.len(), |end| at + end + 1);
    start..end
}

fn is_of_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.' | b'-' | b'+')
}

/// The word that holds a place, or begins there.
fn word_at(data: &[u8], at: usize) -> Range<usize> {
    let at = at.min(data.len());
    let start = data[..at]
        .iter()
        .rposition(|byte| !is_of_word(*byte))
        .map_or(0, |end| end + 1);
    let end = data[at..]
        .iter()
        .position(|byte| !is_of_word(*byte))
        .map_or(data.len(), |end| at + end);
    start..end
}

/// The next word that begins as a number does.
fn next_number(data: &[u8], at: usize) -> Option<Range<usize>> {
    let mut from = word_at(data, at).start;
    while from < data.len() {
        let word = word_at(data, from);
        let digits = data[word.clone()]
            .iter()
            .skip_while(|byte| matches!(byte, b'-' | b'+' | b'.'));
        if digits.clone().next().is_some_and(u8::is_ascii_digit) {
            return Some(word);
        }
        from = word.end + 1;
    }
    None
}

/// What follows `=` or `:` in the line at a place.
fn value_at(data: &[u8], at: usize) -> Option<Range<usize>> {
    let line = line_at(data, at);
    let sign = data[line.clone()]
        .iter()
        .position(|byte| matches!(byte, b'=' | b':'))?;
    let end = line.end - usize::from(data[line.clone()].ends_with(b"\n"));
    Some((line.start + sign + 1).min(end)..end)
}
