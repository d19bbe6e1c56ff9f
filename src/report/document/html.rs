//! A report as one HTML page: no script, nothing loaded, readable without colour, fit to be printed on A4.

use unicode_width::UnicodeWidthStr;

use super::Block;
use seacable_display::chart::svg::svg;
use seacable_display::markup::escaped;
use seacable_display::table::{Align, CellStyle, Column, Table};

const STYLE: &str = "\
@page { size: A4; margin: 15mm }
body { font: 10pt/1.4 sans-serif; max-width: 60em; margin: 1em auto; padding: 0 1em; color: #1a1a1a; background: #fff }
@media print { body { max-width: none; margin: 0; padding: 0 } }
h1, h2, p, li, td, caption { overflow-wrap: anywhere }
th, .right { overflow-wrap: normal }
thead { break-after: avoid }
table { border-collapse: collapse; margin: 0.6em 0 }
caption { text-align: left; font-weight: bold }
th, td { padding: 0.15em 0.7em 0.15em 0; text-align: left; vertical-align: top; border-bottom: 1px solid #ccc }
th { border-bottom: 1px solid #000 }
thead { display: table-header-group }
tr, figure { break-inside: avoid }
h1, h2, caption { break-after: avoid }
figure { margin: 0.8em 0 }
svg { display: block; width: 100%; max-width: 180mm; height: auto }
.right { text-align: right }
td.right { white-space: nowrap }
.wide { font-size: 8pt }
.dense { font-size: 7pt }
.dense td.right { white-space: normal }
.pairs th { border-bottom: 1px solid #ccc; white-space: nowrap }
.good { color: #060 }
.bad { color: #a00; font-weight: bold }
.warn { color: #850 }
.dim { color: #666 }
.note { margin: 0.2em 0 }
";

/// Characters that fit across a printed page in words of the usual size, and of the small size of wide tables.
const USUAL: usize = 80;
const SMALL: usize = 100;

/// Characters of a column of words, which may be broken, and those between columns.
const BROKEN: usize = 24;
const BETWEEN: usize = 2;

/// The blocks as an HTML page.
pub(super) fn html(blocks: &[Block]) -> String {
    let title = blocks.iter().find_map(|block| match block {
        Block::Title(words) => Some(words.as_str()),
        _ => None,
    });
    let parts: String = blocks.chunk_by(are_items).map(parts).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
         <title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n{parts}</body>\n</html>\n",
        escaped(title.unwrap_or("seacable"))
    )
}

/// Whether two blocks are items of one list.
const fn are_items(one: &Block, next: &Block) -> bool {
    matches!((one, next), (Block::Item(..), Block::Item(..)))
}

/// A block, or the items of a list.
fn parts(blocks: &[Block]) -> String {
    match blocks {
        [Block::Item(..), ..] => {
            let items: String = blocks.iter().map(part).collect();
            format!("<ul>\n{items}</ul>\n")
        }
        blocks => blocks.iter().map(part).collect(),
    }
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
        Block::Item(mark, words) => match mark.trim() {
            "*" => format!("<li>{}</li>\n", escaped(words)),
            mark => format!("<li><b>{}</b> {}</li>\n", escaped(mark), escaped(words)),
        },
        Block::Pairs(of) => pairs(of),
        Block::Table(of) => table(of),
        Block::Chart(chart, lines) => format!("<figure>\n{}</figure>\n", svg(chart, *lines)),
        Block::Gap => String::new(),
    }
}

/// Labels and what belongs to them.
fn pairs(pairs: &[(String, String)]) -> String {
    let row = |(label, words): &(String, String)| {
        let (label, words) = (escaped(label), escaped(words));
        format!("<tr><th scope=\"row\">{label}</th><td>{words}</td></tr>\n")
    };
    let rows: String = pairs.iter().map(row).collect();
    format!("<table class=\"pairs\">\n<tbody>\n{rows}</tbody>\n</table>\n")
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
            let text = match tag {
                "th" => breakable(&escaped(text)),
                _ => escaped(text),
            };
            format!("<{tag}{class}>{text}</{tag}>")
        };
        let heads = table
            .columns
            .iter()
            .map(|column| cell("th", column.align, None, &column.head));
        let heads: String = heads.collect();
        let wide = match needed(table) {
            few if few <= USUAL => "",
            more if more <= SMALL => " class=\"wide\"",
            _ => " class=\"dense\"",
        };
        out += &format!("<table{wide}>\n{caption}<thead><tr>{heads}</tr></thead>\n<tbody>\n");
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

/// Characters that a table needs across: its numbers whole, its words broken where they are long.
fn needed(table: &Table) -> usize {
    let column = |(number, column): (usize, &Column)| {
        let cells = (0..table.rows.len()).map(|row| table.cell(row, number).text.width());
        let widest = cells.max().unwrap_or(0);
        let head = column
            .head
            .split([' ', '_', '.'])
            .map(UnicodeWidthStr::width);
        let head = head.max().unwrap_or(0);
        let body = match column.align {
            Align::Left => widest.min(BROKEN),
            Align::Right | Align::Decimal => widest,
        };
        head.max(body) + BETWEEN
    };
    table.columns.iter().enumerate().map(column).sum()
}

/// Words in which paths of keys may be broken.
fn breakable(words: &str) -> String {
    words.replace('_', "_<wbr>").replace('.', ".<wbr>")
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

#[cfg(test)]
mod tests {
    use super::*;
    use seacable_display::table::Cell;

    /// The luminance of a colour such as `#a00` (WCAG 2.1).
    fn luminance(colour: &str) -> f64 {
        let digits = |at: usize| u8::from_str_radix(&colour[at..=at], 16).unwrap();
        let part = |at: usize| match colour.len() {
            3 => 17 * digits(at),
            _ => 16 * digits(2 * at) + digits(2 * at + 1),
        };
        let linear = |at: usize| {
            let value = f64::from(part(at)) / 255.0;
            match value <= 0.04045 {
                true => value / 12.92,
                false => ((value + 0.055) / 1.055).powf(2.4),
            }
        };
        0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2)
    }

    #[test]
    fn words_are_dark_enough_on_white() {
        let colours = STYLE
            .split([' ', '{', ';'])
            .zip(STYLE.split([' ', '{', ';']).skip(1));
        let words = colours.filter(|(key, _)| *key == "color:");
        let mut count = 0;
        for (_, colour) in words {
            let contrast = 1.05 / (luminance(colour.trim_start_matches('#')) + 0.05);
            assert!(contrast >= 4.5, "{colour}: {contrast}");
            count += 1;
        }
        assert_eq!(count, 5);
    }

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
