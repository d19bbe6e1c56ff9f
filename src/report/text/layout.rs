//! Headings, paragraphs and labelled lines on a page of fixed width.

use unicode_width::UnicodeWidthStr;

use crate::report::chart::{Chart, Glyphs, draw};
use crate::report::table::Table;
use crate::report::wrap::WideWords;
use crate::visible;

/// Characters a line.
pub(crate) const WIDTH: usize = 80;

/// A page being written from top to bottom.
#[derive(Debug)]
pub(crate) struct Page {
    width: usize,
    text: String,
}

impl Default for Page {
    fn default() -> Self {
        Self::new(WIDTH)
    }
}

impl Page {
    /// A page of so many columns.
    pub(crate) fn new(width: usize) -> Self {
        let text = String::new();
        Self { width, text }
    }

    /// Its columns.
    pub(crate) fn width(&self) -> usize {
        self.width
    }

    /// The text.
    pub(crate) fn finish(self) -> String {
        self.text
    }

    /// The title of the whole, underlined over the full width.
    pub(crate) fn title(&mut self, words: &str) {
        self.paragraph(words);
        self.line(&"=".repeat(self.width));
    }

    /// A blank line, unless the page is still empty.
    fn space(&mut self) {
        if !self.text.is_empty() {
            self.line("");
        }
    }

    /// The heading of a section, with space above.
    pub(crate) fn heading(&mut self, words: &str) {
        self.space();
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

    /// Source and notes, as far as there are any, with space above each.
    pub(crate) fn prose(&mut self, prose: [&str; 2]) {
        for prose in prose.iter().filter(|prose| !prose.trim().is_empty()) {
            self.space();
            self.paragraph(prose);
        }
    }

    /// A table, with space above.
    pub(crate) fn table(&mut self, table: &Table) {
        self.space();
        self.block(&table.to_text(self.width));
    }

    /// A section of a table alone.
    pub(crate) fn section(&mut self, heading: &str, table: &Table) {
        self.heading(heading);
        self.block(&table.to_text(self.width));
    }

    /// A chart of so many lines, with space above.
    pub(crate) fn chart(&mut self, chart: &Chart, lines: usize, glyphs: Glyphs) {
        self.space();
        self.block(&draw(chart, self.width, lines, glyphs).to_text());
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
        let lines = wrap(words, self.width.saturating_sub(indent));
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

/// Words in lines of at most so many characters, whatever lines they were in; a longer word gets a line of its own.
pub(crate) fn wrap(words: &str, width: usize) -> Vec<String> {
    crate::report::wrap::wrap(&words.replace('\n', " "), width, WideWords::Whole)
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
