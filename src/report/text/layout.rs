//! Headings, paragraphs and labelled lines on a page of fixed width.

use unicode_width::UnicodeWidthStr;

use crate::report::chart::{Chart, Glyphs, draw};
use crate::report::table::Table;
use crate::visible;

/// Characters a line.
pub(crate) const WIDTH: usize = 80;

/// A page being written from top to bottom.
#[derive(Debug, Default)]
pub(crate) struct Page {
    text: String,
}

impl Page {
    /// The text.
    pub(crate) fn finish(self) -> String {
        self.text
    }

    /// The title of the whole, underlined over the full width.
    pub(crate) fn title(&mut self, words: &str) {
        self.paragraph(words);
        self.line(&"=".repeat(WIDTH));
    }

    /// The heading of a section, with space above.
    pub(crate) fn heading(&mut self, words: &str) {
        self.line("");
        self.line(words);
        self.line(&"-".repeat(words.width()));
    }

    /// One line as it is.
    pub(crate) fn line(&mut self, words: &str) {
        self.text.push_str(visible::text(words).trim_end());
        self.text.push('\n');
    }

    /// Lines as they are.
    pub(crate) fn block(&mut self, text: &str) {
        for line in text.lines() {
            self.line(line);
        }
    }

    /// The title with source and notes below.
    pub(crate) fn head(&mut self, title: &str, prose: [&str; 2]) {
        self.title(title);
        for prose in prose.iter().filter(|prose| !prose.trim().is_empty()) {
            self.line("");
            self.paragraph(prose);
        }
    }

    /// A table, with space above.
    pub(crate) fn table(&mut self, table: &Table) {
        self.line("");
        self.block(&table.to_text(WIDTH));
    }

    /// A chart of so many lines, with space above.
    pub(crate) fn chart(&mut self, chart: &Chart, lines: usize, glyphs: Glyphs) {
        self.line("");
        self.block(&draw(chart, WIDTH, lines, glyphs).to_text());
    }

    /// Words broken into lines; line ends of the source that are not blank lines do not count.
    pub(crate) fn paragraph(&mut self, words: &str) {
        for part in words.trim().split("\n\n") {
            self.hanging("", part);
        }
    }

    /// A first word, and words broken into lines that all begin behind it.
    pub(crate) fn hanging(&mut self, head: &str, words: &str) {
        let indent = head.width();
        let lines = wrap(words, WIDTH.saturating_sub(indent));
        for (i, line) in lines.iter().enumerate() {
            let head = if i == 0 {
                head.to_owned()
            } else {
                " ".repeat(indent)
            };
            self.line(&format!("{head}{line}"));
        }
    }

    /// Labels and words, the words all beginning in one column; nothing for empty words.
    pub(crate) fn pairs(&mut self, pairs: &[(&str, String)]) {
        let given = pairs.iter().filter(|(_, words)| !words.is_empty());
        let widest = given
            .clone()
            .map(|(label, _)| label.width())
            .max()
            .unwrap_or(0);
        for (label, words) in given {
            let gap = " ".repeat(widest - label.width() + 2);
            self.hanging(&format!("{label}{gap}"), words);
        }
    }
}

/// Breaks words into lines of at most so many characters; a longer word gets a line of its own.
pub(crate) fn wrap(words: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in visible::text(words).split_whitespace() {
        if !line.is_empty() && line.width() + 1 + word.width() > width {
            lines.push(std::mem::take(&mut line));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    if !line.is_empty() || lines.is_empty() {
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_broken_at_the_width() {
        assert_eq!(
            wrap("one two  three\nfour", 9),
            ["one two", "three", "four"]
        );
        assert_eq!(wrap("a verylongword b", 5), ["a", "verylongword", "b"]);
        assert_eq!(wrap("", 5), [""]);
    }

    #[test]
    fn labels_line_up() {
        let mut page = Page::default();
        page.pairs(&[
            ("a", "x".to_owned()),
            ("long", "y z".to_owned()),
            ("none", String::new()),
        ]);
        assert_eq!(page.finish(), "a     x\nlong  y z\n");
    }
}
