//! A document as one HTML page: no script, nothing loaded, readable without colour, fit to be printed on A4.

use super::Block;
use crate::report::table::{Align, CellStyle, Table};
use crate::visible;

const STYLE: &str = "\
@page { size: A4; margin: 15mm }
body { font: 10pt/1.4 sans-serif; max-width: 60em; margin: 1em auto; padding: 0 1em }
table { border-collapse: collapse; margin: 0.6em 0 }
caption { text-align: left; font-weight: bold }
th, td { padding: 0.15em 0.7em 0.15em 0; text-align: left; vertical-align: top; border-bottom: 1px solid #ccc }
th { border-bottom: 1px solid #000 }
thead { display: table-header-group }
tr { break-inside: avoid }
h2 { break-after: avoid }
.right { text-align: right; white-space: nowrap }
.good { color: #060 }
.bad { color: #a00; font-weight: bold }
.warn { color: #850 }
.dim { color: #666 }
.note { margin: 0.2em 0 }
";

/// The document as an HTML page.
#[must_use]
pub fn html(blocks: &[Block]) -> String {
    let title = blocks.iter().find_map(|block| match block {
        Block::Title(words) => Some(words.as_str()),
        _ => None,
    });
    let parts: String = blocks.iter().map(part).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n{parts}</body>\n</html>\n",
        escaped(title.unwrap_or("seacable"))
    )
}

fn part(block: &Block) -> String {
    match block {
        Block::Title(words) => format!("<h1>{}</h1>\n", escaped(words)),
        Block::Heading(words) => format!("<h2>{}</h2>\n", escaped(words)),
        Block::Paragraph(words) => {
            let parts = words.trim().split("\n\n");
            parts
                .map(|words| format!("<p>{}</p>\n", escaped(words)))
                .collect()
        }
        Block::Table(of) => table(of),
    }
}

fn table(table: &Table) -> String {
    let mut out = String::new();
    let caption = match table.title.is_empty() {
        true => String::new(),
        false => format!("<caption>{}</caption>\n", escaped(&table.title)),
    };
    if table.columns.is_empty() {
        if !table.title.is_empty() {
            out += &format!("<p><b>{}</b></p>\n", escaped(&table.title));
        }
    } else {
        let cell = |tag: &str, align: Align, style: Option<&str>, text: &str| {
            let right = (align != Align::Left).then_some("right");
            let classes: Vec<&str> = right.into_iter().chain(style).collect();
            let class = match classes.is_empty() {
                true => String::new(),
                false => format!(" class=\"{}\"", classes.join(" ")),
            };
            format!("<{tag}{class}>{}</{tag}>", escaped(text))
        };
        let heads = table
            .columns
            .iter()
            .map(|column| cell("th", column.align, None, &column.head));
        let heads: String = heads.collect();
        out += &format!("<table>\n{caption}<thead><tr>{heads}</tr></thead>\n<tbody>\n");
        for row in 0..table.rows.len() {
            let cells = table.columns.iter().enumerate().map(|(number, column)| {
                let found = table.cell(row, number);
                cell("td", column.align, style(found.ink), &found.text)
            });
            out += &format!("<tr>{}</tr>\n", cells.collect::<String>());
        }
        out += "</tbody>\n</table>\n";
    }
    for note in &table.notes {
        out += &format!("<p class=\"note\">{}</p>\n", escaped(note));
    }
    out
}

const fn style(ink: CellStyle) -> Option<&'static str> {
    match ink {
        CellStyle::Plain => None,
        CellStyle::Good => Some("good"),
        CellStyle::Bad => Some("bad"),
        CellStyle::Warn => Some("warn"),
        CellStyle::Dim => Some("dim"),
    }
}

/// Words in which nothing is markup, nor invisible.
fn escaped(words: &str) -> String {
    let mut out = String::new();
    for letter in visible::line(&words.replace('\n', " ")).chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            letter => out.push(letter),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::table::{Cell, Column};

    #[test]
    fn words_are_no_markup() {
        let table = Table {
            columns: vec![Column::left("a"), Column::right("n")],
            rows: vec![vec![
                Cell::new("<script>", CellStyle::Bad),
                Cell::plain("1 & 2"),
            ]],
            ..Table::default()
        };
        let page = html(&[Block::Title("\"T\"".to_owned()), Block::Table(table)]);
        assert!(page.contains("<title>&quot;T&quot;</title>"));
        assert!(
            page.contains(
                "<td class=\"bad\">&lt;script&gt;</td><td class=\"right\">1 &amp; 2</td>"
            )
        );
        assert!(!page.contains("<script"));
    }
}
