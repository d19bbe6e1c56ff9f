//! A text of numbers between spaces, as words that know where they stand.

use std::ops::Range;

use super::attachments::{PlacedNumber, PlacedWord, without_mark};
use super::diagnostic::Finding;

/// The words of a line as numbers.
pub(super) fn numbers(line: &[PlacedWord<'_>]) -> Result<Vec<PlacedNumber>, Finding> {
    let number = |(word, span): &PlacedWord<'_>| {
        let value = word.parse::<f64>().ok().filter(|value| value.is_finite());
        let placed = value.map(|value| PlacedNumber {
            value,
            span: span.clone(),
        });
        placed.ok_or_else(|| {
            let problem = format!("`{word}` is not a number");
            Finding::new(span, "", problem, "write a number, such as -30.5")
        })
    };
    line.iter().map(number).collect()
}

/// The bytes of a line that has words.
pub(super) fn whole(line: &[PlacedWord<'_>]) -> Range<usize> {
    let start = line.first().map_or(0, |word| word.1.start);
    start..line.last().map_or(start, |word| word.1.end)
}

/// The lines, empty ones too, as words between spaces.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Vec<PlacedWord<'_>>> {
    let (mut start, text) = without_mark(text);
    text.split_inclusive('\n').map(move |line| {
        let from = start;
        start += line.len();
        words(from, line)
    })
}

fn words(from: usize, line: &str) -> Vec<PlacedWord<'_>> {
    let mut at = 0;
    let mut words = Vec::new();
    for word in line.split_whitespace() {
        let begin = at + line.get(at..).and_then(|rest| rest.find(word)).unwrap_or(0);
        at = begin + word.len();
        words.push((word, from + begin..from + at));
    }
    words
}
