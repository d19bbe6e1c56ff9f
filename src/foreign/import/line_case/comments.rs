//! Comments of a case, put where its system says what they are about.

use std::collections::BTreeMap;
use std::ops::{Range, RangeInclusive};

use super::source::LineSource;
use crate::case::TomlNode;
use crate::import::imported::Imported;
use crate::import::to_case::case_text::{CaseText, LineStarts};

/// Comments of a text, by the line of what they are about.
#[derive(Debug, Default)]
struct Comments {
    /// Lines of comments above a line, empty ones between them too.
    above: BTreeMap<usize, Vec<String>>,
    /// The comment at the end of a line.
    behind: BTreeMap<usize, String>,
    /// What stands below the last line.
    last: Vec<String>,
}

impl Comments {
    /// The comments of a text that is this tree.
    fn of_text(text: &str, root: &TomlNode) -> Self {
        let values = root.value_spans().into_iter();
        let values = values.map(|span| (span.start, span.end)).collect();
        let mut found = Self::default();
        let (mut above, mut line, mut at) = (Vec::new(), 1, 0);
        while let Some(rest) = text.get(at..).filter(|rest| !rest.is_empty()) {
            let row = Row::of_text(text, at, &values);
            let comment = row.comment.map(|from| text[from..row.end].trim_end());
            match (row.is_empty(), comment) {
                (true, Some(comment)) => above.push(comment.to_owned()),
                (true, None) if above.is_empty() => {}
                (true, None) => above.push(String::new()),
                (false, comment) => {
                    found.above.insert(line, std::mem::take(&mut above));
                    found
                        .behind
                        .extend(comment.map(|own| (line, own.to_owned())));
                }
            }
            line += rest[..row.end - at].matches('\n').count() + 1;
            at = row.end + 1;
        }
        found.last = above;
        found
    }

    /// Moves comments of lines that are not among these to the next that is, or to the end.
    fn gather(&mut self, kept: &BTreeMap<usize, RangeInclusive<usize>>) {
        let lost = |line: &usize| !kept.contains_key(line);
        let mut lines: Vec<usize> = self
            .above
            .keys()
            .chain(self.behind.keys())
            .copied()
            .collect();
        lines.retain(lost);
        lines.sort_unstable();
        lines.dedup();
        for line in lines.into_iter().rev() {
            let mut moved = self.above.remove(&line).unwrap_or_default();
            moved.extend(self.behind.remove(&line));
            if moved.is_empty() {
                continue;
            }
            let next = kept.range(line..).next().map(|(next, _)| *next);
            let to = match next {
                Some(next) => self.above.entry(next).or_default(),
                None => &mut self.last,
            };
            to.splice(0..0, moved);
        }
    }
}

/// A line of a text, to the end of a value that goes over several.
struct Row {
    /// Where its first key or header begins, if it has one.
    content: Option<usize>,
    /// Where its comment begins.
    comment: Option<usize>,
    /// Where it ends.
    end: usize,
}

impl Row {
    /// The line that begins at a byte, with the ends of values by where they begin.
    fn of_text(text: &str, start: usize, values: &BTreeMap<usize, usize>) -> Self {
        let bytes = text.as_bytes();
        let (mut at, mut content, mut quote) = (start, None, None);
        while at < bytes.len() && bytes[at] != b'\n' {
            if let Some(end) = values.get(&at).filter(|end| **end > at) {
                at = *end;
                continue;
            }
            match (quote, bytes[at]) {
                (None, b'#') => {
                    let end = text[at..]
                        .find('\n')
                        .map_or(bytes.len(), |count| at + count);
                    return Self {
                        content,
                        comment: Some(at),
                        end,
                    };
                }
                (None, mark @ (b'"' | b'\'')) => quote = Some(mark),
                (Some(open), mark) if open == mark => quote = None,
                _ => {}
            }
            if !bytes[at].is_ascii_whitespace() {
                content = content.or(Some(at));
            }
            at += 1;
        }
        Self {
            content,
            comment: None,
            end: at,
        }
    }

    fn is_empty(&self) -> bool {
        self.content.is_none()
    }
}

/// Puts the comments of a case into its system: those above a key or header above what it became, those behind it behind that, and those of what the
/// system does not say above what comes next.
pub(super) fn put(system: &mut Imported, source: &LineSource<'_>) {
    let lines = LineStarts::of_text(source.text);
    let of_row = |from: &Option<Range<usize>>| from.as_ref().map(|span| lines.line(span.start));
    let of_rows: Vec<Option<usize>> = system.from.iter().map(of_row).collect();
    let mut comments = Comments::of_text(source.text, source.root());
    let places = places(&of_rows, &system.from);
    comments.gather(&places);
    let mut woven = CaseText::of_text(source.text);
    for (number, words) in system.text.lines().enumerate() {
        let place = of_rows[number].map(|line| (line, &places[&line]));
        let begun = place.filter(|(_, rows)| *rows.start() == number);
        let above = begun.and_then(|(line, _)| comments.above.remove(&line));
        for comment in above.iter().flatten() {
            woven.line(comment, None);
        }
        let ended = place.filter(|(_, rows)| *rows.end() == number);
        let behind = ended.and_then(|(line, _)| comments.behind.remove(&line));
        let behind = behind.unwrap_or_default();
        let behind = behind.trim_start_matches('#').trim();
        woven.commented(words, behind, system.from[number].as_ref());
    }
    for comment in &comments.last {
        woven.line(comment, None);
    }
    (system.text, system.from) = (woven.text, woven.from);
}

/// The rows that a line of the case became, first and last, by its number. Of several places it is the first; a value may go over several rows.
fn places(
    of_rows: &[Option<usize>],
    from: &[Option<Range<usize>>],
) -> BTreeMap<usize, RangeInclusive<usize>> {
    let mut places: BTreeMap<usize, RangeInclusive<usize>> = BTreeMap::new();
    for (row, line) in of_rows.iter().enumerate() {
        let Some(line) = line else { continue };
        let place = places.entry(*line).or_insert(row..=row);
        let goes_on = *place.end() + 1 == row && from[row] == from[*place.start()];
        if goes_on {
            *place = *place.start()..=row;
        }
    }
    places
}
