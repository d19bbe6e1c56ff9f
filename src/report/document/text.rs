//! A report as plain text of a fixed width.

use std::borrow::Cow;

use unicode_width::UnicodeWidthStr;

use super::Block;
use seacable_base::visible;
use seacable_display::chart::{Glyphs, draw};
use seacable_display::plain;
use seacable_display::table::Table;
use seacable_display::wrap::WideWords;

/// Columns of a chart at most.
const CHART_WIDTH: usize = 100;

/// The blocks as text of so many columns, charts drawn with these characters.
pub(super) fn text(blocks: &[Block], width: usize, glyphs: Glyphs) -> String {
    let mut page = Page {
        width,
        glyphs,
        text: String::new(),
    };
    for block in blocks {
        page.block(block);
    }
    page.text
}

/// A page being written from top to bottom.
struct Page {
    width: usize,
    glyphs: Glyphs,
    text: String,
}

impl Page {
    fn block(&mut self, block: &Block) {
        match block {
            Block::Gap => self.line(""),
            Block::Title(words) => {
                self.paragraph(words);
                self.line(&"=".repeat(self.width));
            }
            Block::Heading(words) => {
                let words = self.words(words);
                self.line(&words);
                self.line(&"-".repeat(words.width()));
            }
            Block::Paragraph(words) => self.paragraph(words),
            Block::Item(mark, words) => self.hanging(mark, words),
            Block::Pairs(pairs) => self.pairs(pairs),
            Block::Table(table) => self.table(table),
            Block::Chart(chart, lines) => {
                let width = self.width.min(CHART_WIDTH);
                self.lines(&draw(chart, width, *lines, self.glyphs).to_text());
            }
        }
    }

    fn table(&mut self, table: &Table) {
        // Words grow when they are put into ASCII, which the columns have to know.
        let text = match self.glyphs {
            Glyphs::Ascii => plain::ascii_table(table).to_text(self.width),
            Glyphs::Braille => table.to_text(self.width),
        };
        self.lines(&text);
    }

    /// Words in the characters of the page.
    fn words<'w>(&self, words: &'w str) -> Cow<'w, str> {
        match self.glyphs {
            Glyphs::Ascii => plain::ascii(words),
            Glyphs::Braille => Cow::Borrowed(words),
        }
    }

    /// One line as it is.
    fn line(&mut self, words: &str) {
        self.text.push_str(visible::text(words).trim_end());
        self.text.push('\n');
    }

    /// Lines as they are.
    fn lines(&mut self, text: &str) {
        for line in text.lines() {
            self.line(line);
        }
    }

    /// Words broken into lines; line ends of the source that are not blank lines do not count.
    fn paragraph(&mut self, words: &str) {
        for part in words.trim().split("\n\n") {
            self.hanging("", part);
        }
    }

    /// A first word, and words broken into lines that all begin behind it.
    fn hanging(&mut self, head: &str, words: &str) {
        let indent = head.width();
        let lines = wrap(&self.words(words), self.width.saturating_sub(indent));
        for (i, line) in lines.iter().enumerate() {
            let head = if i == 0 {
                head.to_owned()
            } else {
                " ".repeat(indent)
            };
            self.line(&format!("{head}{line}"));
        }
    }

    /// Labels and words, the words all beginning in one column.
    fn pairs(&mut self, pairs: &[(String, String)]) {
        let widths = pairs.iter().map(|(label, _)| label.width());
        let widest = widths.max().unwrap_or(0);
        for (label, words) in pairs {
            let gap = " ".repeat(widest - label.width() + 2);
            self.hanging(&format!("{label}{gap}"), words);
        }
    }
}

/// Words in lines of at most so many characters, whatever lines they were in; a longer word gets a line of its own.
pub fn wrap(words: &str, width: usize) -> Vec<String> {
    seacable_display::wrap::wrap(&words.replace('\n', " "), width, WideWords::Whole)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Report;

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
        let mut report = Report::default();
        report.pairs(&[
            ("a", "x".to_owned()),
            ("long", "y z".to_owned()),
            ("none", String::new()),
        ]);
        assert_eq!(report.to_text(80, Glyphs::Ascii), "a     x\nlong  y z\n");
    }
}
