//! A report as Markdown with tables (GitHub's dialect).

use super::Block;
use seacable_base::visible;
use seacable_display::chart::{Glyphs, draw};
use seacable_display::table::{Align, Table};

/// Columns of a chart.
const CHART_WIDTH: usize = 80;

/// The blocks as Markdown.
pub(super) fn markdown(blocks: &[Block], glyphs: Glyphs) -> String {
    let seen: Vec<&Block> = blocks
        .iter()
        .filter(|block| **block != Block::Gap)
        .collect();
    let lists =
        seen.chunk_by(|one, next| matches!((one, next), (Block::Item(..), Block::Item(..))));
    let parts = lists.map(|list| {
        list.iter()
            .map(|block| part(block, glyphs))
            .collect::<String>()
    });
    parts.collect::<Vec<_>>().join("\n")
}

fn part(block: &Block, glyphs: Glyphs) -> String {
    match block {
        Block::Title(words) => format!("# {}\n", inline(words)),
        Block::Heading(words) => format!("## {}\n", inline(words)),
        Block::Paragraph(words) => {
            let parts = words.trim().split("\n\n").map(sentence);
            parts
                .map(|words| format!("{words}\n"))
                .collect::<Vec<_>>()
                .join("\n")
        }
        Block::Item(mark, words) => match mark.trim() {
            "*" => format!("- {}\n", inline(words)),
            mark => format!("- **{}** {}\n", inline(mark), inline(words)),
        },
        Block::Pairs(of) => {
            let item = |(label, words): &(String, String)| {
                format!("- **{}**: {}\n", inline(label), inline(words))
            };
            of.iter().map(item).collect()
        }
        Block::Table(of) => table(of),
        Block::Chart(chart, lines) => fenced(&draw(chart, CHART_WIDTH, *lines, glyphs).to_text()),
        Block::Gap => String::new(),
    }
}

/// Lines as they are, between fences longer than any run of backticks in them.
fn fenced(text: &str) -> String {
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    format!("{fence}text\n{text}{fence}\n")
}

fn table(table: &Table) -> String {
    let line = |cells: &mut dyn Iterator<Item = String>| {
        let cells: Vec<String> = cells.collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let columns = 0..table.columns.len();
    let mut out = match table.title.is_empty() {
        true => String::new(),
        false => format!("**{}**\n\n", inline(&table.title)),
    };
    if !table.columns.is_empty() {
        out += &line(&mut table.columns.iter().map(|column| inline(&column.head)));
        out += &line(
            &mut table
                .columns
                .iter()
                .map(|column| rule(column.align).to_owned()),
        );
        for row in 0..table.rows.len() {
            out += &line(
                &mut columns
                    .clone()
                    .map(|column| inline(&table.cell(row, column).text)),
            );
        }
    }
    for note in &table.notes {
        out += &format!("\n{}\n", inline(note));
    }
    out
}

const fn rule(align: Align) -> &'static str {
    match align {
        Align::Left => "---",
        Align::Right | Align::Decimal => "---:",
    }
}

/// Words that begin a line, and neither a list, a quotation, a rule nor a fence.
fn sentence(words: &str) -> String {
    let line = inline(words.trim_start());
    let digits = line.len() - line.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let (number, rest) = line.split_at(digits);
    let begins_list = digits > 0 && rest.starts_with(['.', ')']);
    let begins_block = digits == 0 && rest.starts_with(['-', '+', '>', '~', '=']);
    match begins_list || begins_block {
        true => format!("{number}\\{rest}"),
        false => line,
    }
}

/// Words on one line, in which nothing is markup.
fn inline(words: &str) -> String {
    let mut out = String::new();
    for letter in visible::line(&words.replace('\n', " ")).chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '#' => out.extend(['\\', letter]),
            letter => out.push(letter),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use seacable_display::table::{Cell, Column};

    #[test]
    fn a_paragraph_begins_no_list_and_no_fence() {
        for (words, wanted) in [
            ("- a", "\\- a"),
            ("~~~", "\\~~~"),
            ("> a", "\\> a"),
            ("12. a", "12\\. a"),
            ("12 statements", "12 statements"),
            ("# a", "\\# a"),
        ] {
            assert_eq!(sentence(words), wanted);
        }
    }

    #[test]
    fn a_fence_is_longer_than_what_is_in_it() {
        assert!(fenced("a ```` b\n").starts_with("`````text\n"));
        assert!(fenced("a\n").starts_with("```text\n"));
    }

    #[test]
    fn tables_keep_their_columns_whatever_is_in_them() {
        let table = Table {
            title: "T".to_owned(),
            columns: vec![Column::left("a|b"), Column::right("n")],
            rows: vec![vec![Cell::plain("x_y <b>"), Cell::plain("1\n2")]],
            notes: vec!["[1] A note.".to_owned()],
        };
        let blocks = [Block::Title("A *title*".to_owned()), Block::Table(table)];
        let wanted = "# A \\*title\\*\n\n**T**\n\n| a\\|b | n |\n| --- | ---: |\n| x\\_y &lt;b> | 1 2 |\n\n\\[1\\] A note.\n";
        assert_eq!(markdown(&blocks, Glyphs::Ascii), wanted);
    }
}
