//! A document as headings, paragraphs and tables, written as plain text, Markdown or HTML.

mod html;
mod markdown;

pub use html::html;
pub use markdown::markdown;

use super::table::Table;
use super::text::Page;

/// A part of a document.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// The title of the whole.
    Title(String),
    /// The heading of a section.
    Heading(String),
    /// Sentences.
    Paragraph(String),
    /// A table.
    Table(Table),
}

/// The document as plain text of so many columns.
#[must_use]
pub fn text(blocks: &[Block], width: usize) -> String {
    let mut page = Page::new(width);
    for (number, block) in blocks.iter().enumerate() {
        match block {
            Block::Title(words) => page.title(words),
            Block::Heading(words) => page.heading(words),
            Block::Paragraph(words) => {
                if number > 0 && !matches!(blocks[number - 1], Block::Title(_) | Block::Heading(_))
                {
                    page.line("");
                }
                page.paragraph(words);
            }
            Block::Table(table) => page.table(table),
        }
    }
    page.finish()
}
