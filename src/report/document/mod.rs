//! A report as blocks (headings, paragraphs, tables, charts), and its writers: plain text, Markdown, HTML.
//!
//! Every report is built as a [`Report`] once; what it looks like is the matter of its writers. Plain text keeps blank lines
//! where they are asked for ([`Block::Gap`]); the other formats have their own spacing.

mod format;
mod html;
mod markdown;
mod text;

pub use format::ReportFormat;
pub use text::wrap;

use super::chart::{Chart, Glyphs};
use super::table::Table;

/// A part of a report.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// The title of the whole, or of a part of equal rank.
    Title(String),
    /// The heading of a section.
    Heading(String),
    /// Sentences; a blank line in them begins a new paragraph.
    Paragraph(String),
    /// A mark, such as `* ` or `! `, and the sentences that hang behind it.
    Item(String, String),
    /// Labels and what belongs to them.
    Pairs(Vec<(String, String)>),
    /// A table.
    Table(Table),
    /// A chart, of so many lines where it is drawn in characters.
    Chart(Box<Chart>, usize),
    /// A blank line of plain text.
    Gap,
}

/// A report, built from top to bottom.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Report {
    blocks: Vec<Block>,
}

impl Report {
    /// A report of these blocks, with gaps before tables and between paragraphs.
    #[must_use]
    pub fn of_blocks(blocks: Vec<Block>) -> Self {
        let mut report = Self::default();
        report.extend(blocks);
        report
    }

    /// The blocks from the top.
    #[must_use]
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The report as plain text of so many columns, its charts drawn with these characters.
    #[must_use]
    pub fn to_text(&self, width: usize, glyphs: Glyphs) -> String {
        text::text(&self.blocks, width, glyphs)
    }

    /// The report as Markdown, its charts drawn with these characters.
    #[must_use]
    pub fn to_markdown(&self, glyphs: Glyphs) -> String {
        markdown::markdown(&self.blocks, glyphs)
    }

    /// The report as one HTML page.
    #[must_use]
    pub fn to_html(&self) -> String {
        html::html(&self.blocks)
    }

    /// Adds blocks, with gaps before tables and between paragraphs.
    pub fn extend(&mut self, blocks: Vec<Block>) {
        for block in blocks {
            let after_head = matches!(
                self.blocks.last(),
                None | Some(Block::Title(_) | Block::Heading(_))
            );
            match &block {
                Block::Heading(_) | Block::Table(_) => self.gap(),
                Block::Paragraph(_) if !after_head => self.gap(),
                _ => {}
            }
            self.blocks.push(block);
        }
    }

    /// Adds the blocks of another report.
    pub fn append(&mut self, other: Self) {
        self.blocks.extend(other.blocks);
    }

    /// The title of the whole.
    pub(crate) fn title(&mut self, words: &str) {
        self.blocks.push(Block::Title(words.to_owned()));
    }

    /// The heading of a section, with a gap above.
    pub(crate) fn heading(&mut self, words: &str) {
        self.gap();
        self.blocks.push(Block::Heading(words.to_owned()));
    }

    /// A blank line of plain text, unless it would be the first line.
    pub(crate) fn gap(&mut self) {
        if !self.blocks.is_empty() {
            self.blocks.push(Block::Gap);
        }
    }

    /// Sentences.
    pub(crate) fn paragraph(&mut self, words: &str) {
        self.blocks.push(Block::Paragraph(words.to_owned()));
    }

    /// A mark and the sentences behind it.
    pub(crate) fn item(&mut self, mark: &str, words: &str) {
        self.blocks
            .push(Block::Item(mark.to_owned(), words.to_owned()));
    }

    /// Labels and words; nothing for empty words.
    pub(crate) fn pairs(&mut self, pairs: &[(&str, String)]) {
        let given = pairs.iter().filter(|(_, words)| !words.is_empty());
        let given = given.map(|(label, words)| ((*label).to_owned(), words.clone()));
        self.blocks.push(Block::Pairs(given.collect()));
    }

    /// Source and notes, as far as there are any, with a gap above each.
    pub(crate) fn prose(&mut self, prose: [&str; 2]) {
        for prose in prose.iter().filter(|prose| !prose.trim().is_empty()) {
            self.gap();
            self.paragraph(prose);
        }
    }

    /// A table directly below what is above it.
    pub(crate) fn close_table(&mut self, table: Table) {
        self.blocks.push(Block::Table(table));
    }

    /// A table, with a gap above.
    pub fn table(&mut self, table: Table) {
        self.gap();
        self.close_table(table);
    }

    /// A section of a table alone.
    pub(crate) fn section(&mut self, heading: &str, table: Table) {
        self.heading(heading);
        self.close_table(table);
    }

    /// A chart directly below what is above it.
    pub(crate) fn close_chart(&mut self, chart: Chart, lines: usize) {
        self.blocks.push(Block::Chart(Box::new(chart), lines));
    }

    /// A chart of so many lines, with a gap above.
    pub fn chart(&mut self, chart: Chart, lines: usize) {
        self.gap();
        self.close_chart(chart, lines);
    }
}
