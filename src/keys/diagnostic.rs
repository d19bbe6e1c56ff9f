//! What is wrong with a case file, where, and what would be right.

use std::fmt;
use std::ops::Range;

use crate::visible::{self, shortened};
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

/// Greatest number of diagnostics of a file.
pub const MOST_DIAGNOSTICS: usize = 50;

/// One thing wrong with a case file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Name of the file, as the user gave it.
    pub file: String,
    /// Line, from 1; 0 for what has no lines, as an option.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// Key path (`materials.chain.ea_n`); empty when the file as a whole is meant.
    pub key: String,
    /// What is wrong.
    pub problem: String,
    /// What would be right.
    pub remedy: Box<str>,
    /// The bytes meant, in the text of the file.
    pub span: Range<usize>,
    /// The lines of the file that they are in; absent where no place is meant, or where the file is not to be quoted.
    pub excerpt: Option<Box<Excerpt>>,
}

/// Longest part of a file that is shown with what is wrong in it \[bytes\].
const LONGEST_EXCERPT: usize = 1 << 12;

/// Lines of a file with the place meant in them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Excerpt {
    /// The lines.
    text: String,
    /// The number of the first, from 1.
    line: usize,
    /// The bytes meant.
    span: Range<usize>,
}

impl Excerpt {
    /// The lines of a text that these bytes are in. Without a place there are none, and none where they are very long.
    pub fn of_span(text: &str, span: &Range<usize>) -> Option<Box<Self>> {
        if text.is_empty() || *span == (0..0) {
            return None;
        }
        let span = within(text, span);
        let from = text[..span.start].rfind('\n').map_or(0, |end| end + 1);
        let rest = text[span.end..].find('\n');
        let to = rest.map_or(text.len(), |end| span.end + end + 1);
        let is_short = to - from <= LONGEST_EXCERPT;
        let excerpt = || Self {
            text: text[from..to].to_owned(),
            line: text[..from].matches('\n').count() + 1,
            span: span.start - from..span.end - from,
        };
        is_short.then(|| Box::new(excerpt()))
    }
}

impl Diagnostic {
    /// What stands in the place of diagnostics that are left out, at the first of them.
    #[must_use]
    pub fn further(number: usize, first: Self) -> Self {
        let faults = if number == 1 {
            "fault is"
        } else {
            "faults are"
        };
        Self {
            key: String::new(),
            problem: format!("{number} more {faults} not shown"),
            remedy: "mend those shown first".into(),
            ..first
        }
    }

    /// A diagnostic about the file as a whole.
    #[must_use]
    pub fn whole_file(file: &str, problem: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            file: file.to_owned(),
            line: 1,
            column: 1,
            key: String::new(),
            problem: problem.into(),
            remedy: remedy.into().into_boxed_str(),
            span: 0..0,
            excerpt: None,
        }
    }

    /// The same of an option of the command line, which has no lines.
    pub fn of_option(self, option: &str) -> Self {
        Self {
            file: option.to_owned(),
            line: 0,
            column: 0,
            excerpt: None,
            ..self
        }
    }

    /// The same without what the file holds: where it lies is all that is said.
    pub fn without_contents(self) -> Self {
        Self {
            key: String::new(),
            problem: "this table is not what it is named for".to_owned(),
            remedy: "what it holds is not shown, as it lies outside the root: --root DIR names the directory of the root".into(),
            excerpt: None,
            ..self
        }
    }

    /// The diagnostic as a compiler shows it: the line of the file with a mark under the place.
    ///
    /// Without `color` the result is plain ASCII apart from what the file itself holds.
    #[must_use]
    pub fn render(&self, color: bool) -> String {
        let renderer = if color {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        renderer.render(&[self.group()])
    }

    fn group(&self) -> Group<'_> {
        let title = Level::ERROR.primary_title(self.headline());
        let help = Level::HELP.message(&*self.remedy);
        let Some(excerpt) = &self.excerpt else {
            let origin = Origin::path(visible::line(&self.file));
            let origin = match self.line {
                // What has no lines, as an option.
                0 => origin,
                line => origin.line(line as usize).char_column(self.column as usize),
            };
            return title.element(origin).element(help);
        };
        let snippet = Snippet::source(excerpt.text.as_str())
            .path(visible::line(&self.file))
            .line_start(excerpt.line)
            .annotation(AnnotationKind::Primary.span(excerpt.span.clone()));
        title.element(snippet).element(help)
    }

    fn headline(&self) -> String {
        if self.key.is_empty() {
            self.problem.clone()
        } else {
            format!("{}: {}", self.key, self.problem)
        }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            file, line, column, ..
        } = self;
        match line {
            0 => write!(f, "{file}: ")?,
            _ => write!(f, "{file}:{line}:{column}: ")?,
        }
        write!(f, "{}; {}", self.headline(), self.remedy)
    }
}

impl std::error::Error for Diagnostic {}

/// All diagnostics one below the other, each as [`Diagnostic::render`] shows it.
#[must_use]
pub fn render_all(diagnostics: &[Diagnostic], color: bool) -> String {
    let each: Vec<String> = diagnostics.iter().map(|d| d.render(color)).collect();
    each.join("\n\n")
}

/// What a check found, before it is placed in its file by line and column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The bytes of the text that it is about.
    pub span: Range<usize>,
    /// The key path.
    pub key: String,
    /// What is wrong.
    pub problem: String,
    /// What would be right.
    pub remedy: String,
}

impl Finding {
    /// What is wrong with a key, and what would be right.
    pub fn new(
        span: &Range<usize>,
        key: impl Into<String>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            span: span.clone(),
            key: key.into(),
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    /// The diagnostic of the file with this name and text.
    #[must_use]
    pub fn at(self, file: &str, text: &str) -> Diagnostic {
        let span = within(text, &self.span);
        let (line, column) = position(text, span.start);
        Diagnostic {
            file: file.to_owned(),
            line,
            column,
            key: shortened(self.key),
            problem: shortened(self.problem),
            remedy: shortened(self.remedy).into_boxed_str(),
            excerpt: Excerpt::of_span(text, &self.span),
            span,
        }
    }
}

/// Line and column of a byte offset, both from 1, the column in characters.
pub fn position(text: &str, offset: usize) -> (u32, u32) {
    let before = &text[..floor_boundary(text, offset)];
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = before.matches('\n').count() + 1;
    (count(line), count(before[line_start..].chars().count() + 1))
}

/// Lines and columns are 32-bit numbers; a larger one is cut to the greatest of them.
pub fn count(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}

/// The span, cut to the text and to whole characters.
fn within(text: &str, span: &Range<usize>) -> Range<usize> {
    let start = floor_boundary(text, span.start);
    start..floor_boundary(text, span.end).max(start)
}

fn floor_boundary(text: &str, offset: usize) -> usize {
    let mut offset = offset.min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Diagnostic {
        let text = "[line]\nlength = 5\n";
        Finding::new(&(7..13), "line.length", "has no unit", "write `length_m`").at("a.toml", text)
    }

    #[test]
    fn one_line_names_file_line_column_key_problem_remedy() {
        assert_eq!(
            sample().to_string(),
            "a.toml:2:1: line.length: has no unit; write `length_m`"
        );
    }

    #[test]
    fn rendered_text_marks_the_place() {
        let shown = sample().render(false);
        assert_eq!(
            shown,
            "error: line.length: has no unit\n --> a.toml:2:1\n  |\n2 | length = 5\n  | ^^^^^^\n  |\n  = help: write `length_m`"
        );
        assert!(shown.is_ascii());
    }

    #[test]
    fn columns_count_characters() {
        assert_eq!(position("é = \"ü\"x", 8), (1, 7));
        assert_eq!(position("ab\ncd", 999), (2, 3));
    }
}
