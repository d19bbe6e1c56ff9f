//! The text of a case as it is written, line by line, each knowing the row that it comes from.

use std::fmt::Write as _;
use std::ops::Range;

use super::columns;
use crate::import::beside::ReferencedFile;
use crate::import::mooring::{Mooring, Program};
use crate::padding::at_left;

/// Column at which comments begin, where the value leaves room.
const COMMENT_COLUMN: usize = 40;

/// The text of a case.
#[derive(Debug, Clone)]
pub struct CaseText<'t> {
    source: LineStarts,
    /// Whether comments name the rows.
    names_rows: bool,
    program: Option<Program>,
    beside: Option<(&'t ReferencedFile, LineStarts)>,
    /// What is written.
    pub text: String,
    /// Of each of its lines, the bytes of the source that it comes from.
    pub from: Vec<Option<Range<usize>>>,
}

impl<'t> CaseText<'t> {
    /// An empty case of a mooring that was read from a source.
    #[must_use]
    pub fn of_mooring(source: &str, mooring: &'t Mooring) -> Self {
        let beside = mooring.beside.as_ref();
        Self {
            program: Some(mooring.program),
            beside: beside.map(|beside| (beside, LineStarts::of_text(&beside.text))),
            names_rows: true,
            ..Self::of_text(source)
        }
    }

    /// An empty case of a source with comments of its own, whose rows none name.
    #[must_use]
    pub fn of_text(source: &str) -> Self {
        Self {
            source: LineStarts::of_text(source),
            names_rows: false,
            program: None,
            beside: None,
            text: String::new(),
            from: Vec::new(),
        }
    }

    /// A line as it stands, or the lines of a value that goes over several.
    pub fn line(&mut self, line: &str, from: Option<&Range<usize>>) {
        self.text.push_str(line);
        self.text.push('\n');
        let count = line.matches('\n').count() + 1;
        self.from.extend(std::iter::repeat_n(from.cloned(), count));
    }

    /// The header of a table, `[points.p1]`, after a blank line.
    pub fn table(&mut self, header: &str, from: Option<&Range<usize>>) {
        if !self.text.is_empty() {
            self.line("", None);
        }
        let named = from.filter(|_| self.names_rows);
        let comment = named.map(|span| self.row_of(span)).unwrap_or_default();
        self.commented(header, &comment, from);
    }

    /// A key that a column gives.
    pub fn given(&mut self, key: &str, value: &str, from: &Range<usize>, column: &str) {
        let row = self.row_of(from);
        let column = match self.program.filter(|_| self.beside_of(from).is_none()) {
            Some(program) => columns::name(program, column),
            None => column,
        };
        let comment = match column {
            column if !self.names_rows => column.to_owned(),
            "" => row,
            column => format!("{row}, {column}"),
        };
        self.commented(&format!("{key} = {value}"), &comment, Some(from));
    }

    /// A key that no row gives, and why it has its value.
    pub fn assumed(&mut self, key: &str, value: &str, why: &str) {
        self.commented(&format!("{key} = {value}"), why, None);
    }

    /// The file beside the source that bytes are of.
    fn beside_of(&self, span: &Range<usize>) -> Option<&(&'t ReferencedFile, LineStarts)> {
        let beside = self.beside.as_ref();
        beside.filter(|(beside, _)| beside.holds(span))
    }

    /// The row of the source at these bytes: `line 12`.
    #[must_use]
    pub fn row_of(&self, span: &Range<usize>) -> String {
        if let Some((beside, lines)) = self.beside_of(span) {
            let line = lines.line(span.start.saturating_sub(beside.start));
            return format!("{} line {line}", beside.name);
        }
        format!("line {}", self.source.line(span.start))
    }

    /// A line with a comment behind it, or the lines of a value with one behind the last.
    pub fn commented(&mut self, line: &str, comment: &str, from: Option<&Range<usize>>) {
        let mut whole = line.to_owned();
        if !comment.is_empty() {
            let last = line.rfind('\n').map_or(0, |end| end + 1);
            let width = COMMENT_COLUMN.max(line[last..].chars().count() + 2);
            whole.truncate(last);
            whole += &format!("{}# {comment}", at_left(&line[last..], width));
        }
        self.line(&whole, from);
    }
}

/// Where the lines of a text begin, so that a line is found without counting from the first.
#[derive(Debug, Clone)]
pub struct LineStarts {
    ends: Vec<usize>,
}

impl LineStarts {
    /// Those of a text.
    #[must_use]
    pub fn of_text(text: &str) -> Self {
        let bytes = text.bytes().enumerate();
        let ends = bytes.filter(|(_, byte)| *byte == b'\n').map(|(at, _)| at);
        Self {
            ends: ends.collect(),
        }
    }

    /// The line of a byte, from 1.
    #[must_use]
    pub fn line(&self, at: usize) -> usize {
        self.ends.partition_point(|end| *end < at) + 1
    }
}

/// A number, so that it is read as the same bits.
#[must_use]
pub fn number(value: f64) -> String {
    // A negative zero is zero.
    format!("{:?}", value + 0.0)
}

/// A list of numbers.
#[must_use]
pub fn numbers(values: &[f64]) -> String {
    let all: Vec<String> = values.iter().copied().map(number).collect();
    format!("[{}]", all.join(", "))
}

/// A text between quotes, over several lines where it has several.
#[must_use]
pub fn block(value: &str) -> String {
    if !value.contains('\n') {
        return text(value);
    }
    let lines = value.split('\n').map(text);
    let lines: Vec<String> = lines
        .map(|line| line[1..line.len() - 1].to_owned())
        .collect();
    let mut whole = lines.join("\n");
    // A quote alone does not end the text.
    if !value.contains("\"\"") && !value.ends_with('"') {
        whole = whole.replace("\\\"", "\"");
    }
    format!("\"\"\"\n{whole}\"\"\"")
}

/// A text between quotes.
#[must_use]
pub fn text(value: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in value.chars() {
        match letter {
            '"' | '\\' => {
                quoted.push('\\');
                quoted.push(letter);
            }
            '\n' => quoted.push_str("\\n"),
            letter if letter.is_control() => {
                // Writing to a string does not fail.
                let _ = write!(quoted, "\\u{:04x}", u32::from(letter));
            }
            letter => quoted.push(letter),
        }
    }
    quoted.push('"');
    quoted
}

/// A name as cases have them: letters, digits, `-` and `_`.
#[must_use]
pub fn name(of: &str) -> String {
    let letters = of.chars().map(|letter| match letter {
        letter if letter.is_ascii_alphanumeric() || "-_".contains(letter) => letter,
        _ => '_',
    });
    let name: String = letters.collect();
    match name.is_empty() {
        true => "unnamed".to_owned(),
        false => name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_over_lines_are_read_again() {
        for value in ["one", "a \"b\" c\nd\\ \\\"", "a\n\"\"\"\"b\n\nc \"d\" e"] {
            let whole = format!("key = {}", block(value));
            let read: toml::Table = toml::from_str(&whole).unwrap();
            assert_eq!(read["key"].as_str(), Some(value), "{whole}");
        }
    }

    #[test]
    fn lines_know_their_rows() {
        let mooring = Mooring::new(Program::MoorDyn);
        let mut case = CaseText::of_mooring("one\ntwo 0.09\n", &mooring);
        case.table("[materials.two]", Some(&(4..7)));
        case.given("diameter_m", &number(0.09), &(8..12), "Diam");
        case.assumed("gravity", "9.8", "assumed");
        let lines: Vec<&str> = case.text.lines().collect();
        assert_eq!(lines.len(), case.from.len());
        assert!(lines[0].ends_with("# line 2"), "{lines:?}");
        assert!(lines[1].ends_with("# line 2, Diam"));
        assert_eq!(case.from, [Some(4..7), Some(8..12), None]);
    }

    #[test]
    fn values_are_read_as_they_were() {
        let values = [0.1, 3.84e8, -0.0, 1e-300, 12.0, f64::MAX];
        for value in values {
            let read: toml::Table = format!("v = {}", number(value)).parse().unwrap();
            assert_eq!(read["v"].as_float(), Some(value));
        }
        let odd = "a \"b\" \\ \u{7} é\nc";
        let read: toml::Table = format!("v = {}", text(odd)).parse().unwrap();
        assert_eq!(read["v"].as_str(), Some(odd));
        assert_eq!(name("Chain 120mm/R4"), "Chain_120mm_R4");
    }
}
