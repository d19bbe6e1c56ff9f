//! The size of what a file says, before it is held against its keys: numbers of entries, lengths of names and texts.

use super::diagnostic::Finding;
use super::tree::{TomlData, TomlEntry, TomlNode};
use crate::limits::TABLES;

/// Longest key, and name of a table \[bytes\].
const LONGEST_KEY: usize = 200;
/// Longest text \[bytes\].
const LONGEST_TEXT: usize = 20_000;
/// Longest number, as it is written \[bytes\].
const LONGEST_NUMBER: usize = 400;

/// The table of the files that a stored case carries, whole, by their names.
const FILES: &str = "files";

/// The first entry that is too much for a file.
pub fn check(root: &TomlNode) -> Option<Finding> {
    let said = root.entries().iter().filter(|entry| entry.key != FILES);
    entries(&said.collect::<Vec<_>>())
}

fn entries(entries: &[&TomlEntry]) -> Option<Finding> {
    let key = entries.iter().find(|entry| entry.key.len() > LONGEST_KEY);
    let long = key.map(|entry| too_long("key", entry.key.len(), LONGEST_KEY, &entry.key_span));
    let nodes = || entries.iter().map(|entry| &entry.node);
    long.or_else(|| too_many(nodes(), entries.len()))
        .or_else(|| nodes().find_map(value))
}

fn value(node: &TomlNode) -> Option<Finding> {
    match &node.data {
        TomlData::Table(_, inner) => entries(&inner.iter().collect::<Vec<_>>()),
        TomlData::List(items) => {
            let many = node.is_list_of_tables();
            let many = many.then(|| too_many(items.iter(), items.len()));
            many.flatten().or_else(|| items.iter().find_map(value))
        }
        TomlData::Text(text) if text.len() > LONGEST_TEXT => {
            Some(too_long("text", text.len(), LONGEST_TEXT, &node.span))
        }
        TomlData::Float(_) | TomlData::Integer(_) if node.span.len() > LONGEST_NUMBER => Some(
            too_long("number", node.span.len(), LONGEST_NUMBER, &node.span),
        ),
        _ => None,
    }
}

/// More entries of a table, or tables of a list, than allowed.
fn too_many<'a>(mut nodes: impl Iterator<Item = &'a TomlNode>, count: usize) -> Option<Finding> {
    let count = count as f64;
    if !TABLES.is_exceeded_by(count) {
        return None;
    }
    let first = nodes.nth(TABLES.greatest() as usize)?;
    let problem = format!("one table or list of tables has {count} entries");
    let remedy = TABLES.remedy("a scene has fewer", count);
    Some(Finding::new(&first.span, "", problem, remedy))
}

fn too_long(what: &str, length: usize, most: usize, span: &std::ops::Range<usize>) -> Finding {
    let problem = format!("a {what} is {length} bytes long");
    Finding::new(span, "", problem, format!("give at most {most}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Option<String> {
        check(&TomlNode::parse(text).unwrap()).map(|finding| finding.problem)
    }

    #[test]
    fn counts_and_lengths_are_bounded_wherever_they_stand() {
        let points = |count: usize| "[[points]]\nx = 1\n".repeat(count);
        assert_eq!(found(&points(10_000)), None);
        assert_eq!(
            found(&points(10_001)).unwrap(),
            "one table or list of tables has 10001 entries"
        );
        let keys: String = (0..10_001).map(|i| format!("k{i} = 1\n")).collect();
        assert!(found(&format!("[a.b]\n{keys}")).is_some());
        // A list of numbers is data, not work.
        let numbers = "1.0, ".repeat(100_000);
        assert_eq!(found(&format!("x = [{numbers}]")), None);
        let word = "a".repeat(20_001);
        assert_eq!(
            found(&format!("a.b = [{{ c = \"{word}\" }}]")).unwrap(),
            "a text is 20001 bytes long"
        );
        assert_eq!(
            found(&format!("[a.{}]", &word[..201])).unwrap(),
            "a key is 201 bytes long"
        );
        let digits = "1".repeat(399);
        assert_eq!(
            found(&format!("x = [0.{digits}]")).unwrap(),
            "a number is 401 bytes long"
        );
        assert_eq!(found(&format!("x = 0.{}", &digits[1..])), None);
        assert_eq!(found(&format!("[files.a]\ntext = \"{word}\"")), None);
    }
}
