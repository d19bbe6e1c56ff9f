//! A table taken out of the text.

use super::blocks::blocks;
use super::tables::shown;
use crate::fields::split;
use crate::tree::TomlNode;

/// The text without a table and all tables in it, and without the marks of their keys.
pub(super) fn remove(text: &str, path: &[String]) -> Result<String, String> {
    let all = blocks(text);
    let gone: Vec<_> = all
        .iter()
        .filter(|block| block.is_in(path) || is_mark_of(&block.path, path))
        .collect();
    if !gone.iter().any(|block| block.is_in(path)) {
        let tree = TomlNode::parse(text).ok();
        let is_there = tree.is_some_and(|tree| tree.find(path).is_some());
        return Err(match is_there {
            true => format!(
                "{} is written without a header of its own; edit it in an editor.",
                shown(path)
            ),
            false => format!("There is no {} in this file.", shown(path)),
        });
    }
    let mut out = text.to_owned();
    for block in gone.iter().rev() {
        out.replace_range(with_empty_line(&out, block.range.clone()), "");
    }
    Ok(out)
}

/// Whether a table is the mark of a key of another: `marks."lines.a.length_m"`.
fn is_mark_of(block: &[String], path: &[String]) -> bool {
    match block {
        [marks, key, ..] if marks == "marks" => split(key).is_some_and(|key| key.starts_with(path)),
        _ => false,
    }
}

/// A range of lines with one of the empty lines about it, where it has one on either side.
fn with_empty_line(text: &str, range: std::ops::Range<usize>) -> std::ops::Range<usize> {
    let behind = &text[range.end..];
    let ends = ["\r\n", "\n"];
    let below = ends.iter().find(|end| behind.starts_with(**end));
    let before = &text[..range.start];
    let is_above = before.is_empty() || before.ends_with("\n\n") || before.ends_with("\r\n\r\n");
    match below {
        Some(end) if is_above => range.start..range.end + end.len(),
        _ => range,
    }
}
