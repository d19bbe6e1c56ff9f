//! Where the tables of a text stand: each header with the lines under it.

use std::ops::Range;

use toml_edit::{Document, Item, Table};

use crate::files::shallow::shallow;
use crate::text_lines::{line_end, line_start};
use crate::tree::{TomlNode, element_names};

/// A table written under a header of its own: `[materials.chain]`, `[[lines]]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableBlock {
    /// Its key path; elements of lists of tables by their name, or their number from 1.
    pub path: Vec<String>,
    /// The header, from its first bracket to its last.
    pub header: Range<usize>,
    /// The block in the text: the comment lines right above the header, the header, and its keys with the rest of their last line.
    pub range: Range<usize>,
}

impl TableBlock {
    /// Whether it is the table of this path, or a table in it.
    pub fn is_in(&self, path: &[String]) -> bool {
        self.path.starts_with(path)
    }
}

/// The tables of a text under headers of their own, in the order of the text. A text that is not TOML has none.
pub fn blocks(text: &str) -> Vec<TableBlock> {
    let (Ok(document), Ok(tree)) = (Document::parse(shallow(text)), TomlNode::parse(text)) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    collect(document.as_table(), &tree, &mut Vec::new(), &mut found);
    found.sort_by_key(|(_, header, _)| header.start);
    let block = |(path, header, end): (Vec<String>, Range<usize>, usize)| TableBlock {
        range: with_comments(text, line_start(text, header.start))..line_end(text, end),
        path,
        header,
    };
    found.into_iter().map(block).collect()
}

/// Path, header and end of the last value of each table.
type FoundTables = Vec<(Vec<String>, Range<usize>, usize)>;

fn collect(table: &Table, node: &TomlNode, path: &mut Vec<String>, found: &mut FoundTables) {
    for (key, item) in table {
        let Some(inner) = node.get(key) else { continue };
        path.push(key.to_owned());
        match item {
            Item::Table(table) => one(table, inner, path, found),
            Item::ArrayOfTables(list) => {
                let names = element_names(inner.items());
                for ((table, node), name) in list.iter().zip(inner.items()).zip(names) {
                    path.push(name);
                    one(table, node, path, found);
                    path.pop();
                }
            }
            _ => {}
        }
        path.pop();
    }
}

fn one(table: &Table, node: &TomlNode, path: &mut Vec<String>, found: &mut FoundTables) {
    let header = table
        .span()
        .filter(|_| !table.is_implicit() && !table.is_dotted());
    if let Some(header) = header {
        let end = last_value(table, header.end);
        found.push((path.clone(), header, end));
    }
    collect(table, node, path, found);
}

/// Where the last value under a header ends, dotted keys among them.
fn last_value(table: &Table, header_end: usize) -> usize {
    let ends = table.iter().filter_map(|(_, item)| match item {
        Item::Value(value) => value.span().map(|span| span.end),
        Item::Table(inner) if inner.is_dotted() => Some(last_value(inner, header_end)),
        _ => None,
    });
    ends.max().unwrap_or(0).max(header_end)
}

/// Where the comment lines right above a line begin.
fn with_comments(text: &str, line: usize) -> usize {
    let mut from = line;
    while from > 0 {
        let above = line_start(text, from - 1);
        if !text[above..from].trim_start().starts_with('#') {
            break;
        }
        from = above;
    }
    from
}

/// The extent of a table with all tables in it: the table first, nothing else between them.
///
/// # Errors
/// Why it cannot be edited as one piece.
pub fn extent(text: &str, blocks: &[TableBlock], path: &[String]) -> Result<Range<usize>, String> {
    let own: Vec<usize> = (0..blocks.len())
        .filter(|number| blocks[*number].is_in(path))
        .collect();
    let (Some(first), Some(last)) = (own.first(), own.last()) else {
        return Err(no_block(text, path));
    };
    if last - first + 1 != own.len() {
        return Err(format!(
            "The tables of {} are not next to each other in the file; put them together in an editor first.",
            super::tables::shown(path)
        ));
    }
    Ok(blocks[*first].range.start..blocks[*last].range.end)
}

/// Why a table has no block: it is written in another way, or is not there.
fn no_block(text: &str, path: &[String]) -> String {
    let tree = TomlNode::parse(text).ok();
    let is_there = tree.is_some_and(|tree| tree.find(path).is_some());
    let shown = super::tables::shown(path);
    match is_there {
        true => format!("{shown} is written without a header of its own; edit it in an editor."),
        false => format!("There is no {shown} in this file."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# About the file.\n\n[system]\ntitle = \"t\" # here\n\n# The chain.\n# Of two lines.\n[materials.chain]\nea_n = 1.0\n\
                        [materials.chain.bore]\n\n# Apart.\n\n[[lines]]\nname = \"a\"\nx.y = 1\n\n[[lines.sections]]\nlength_m = 3\n\n[[lines]]\nname = \"b\"\n";

    #[test]
    fn headers_with_their_comments_and_keys() {
        let blocks = blocks(TEXT);
        let shown: Vec<(String, &str)> = blocks
            .iter()
            .map(|block| (block.path.join("."), &TEXT[block.range.clone()]))
            .collect();
        assert_eq!(
            shown,
            [
                ("system".to_owned(), "[system]\ntitle = \"t\" # here\n"),
                (
                    "materials.chain".to_owned(),
                    "# The chain.\n# Of two lines.\n[materials.chain]\nea_n = 1.0\n"
                ),
                (
                    "materials.chain.bore".to_owned(),
                    "[materials.chain.bore]\n"
                ),
                ("lines.a".to_owned(), "[[lines]]\nname = \"a\"\nx.y = 1\n"),
                (
                    "lines.a.sections.1".to_owned(),
                    "[[lines.sections]]\nlength_m = 3\n"
                ),
                ("lines.b".to_owned(), "[[lines]]\nname = \"b\"\n"),
            ]
        );
        let extent = |path: &[&str]| {
            let path: Vec<String> = path.iter().map(|part| (*part).to_owned()).collect();
            extent(TEXT, &blocks, &path).map(|range| TEXT[range].to_owned())
        };
        assert!(extent(&["lines", "a"]).unwrap().ends_with("length_m = 3\n"));
        assert!(
            extent(&["materials", "chain"])
                .unwrap()
                .ends_with("bore]\n")
        );
        assert!(
            extent(&["lines", "c"])
                .unwrap_err()
                .contains("There is no lines.c")
        );
    }
}
