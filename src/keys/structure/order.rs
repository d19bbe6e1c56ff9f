//! Tables put in another order.

use super::blocks::{blocks, extent};
use super::tables::{shown, table_of};
use crate::fields::{Schema, TableShape};
use crate::tree::{TomlNode, element_names};

/// The text with a table before the one before it, or behind the one behind it.
pub(super) fn shift(
    schema: &'static Schema,
    text: &str,
    path: &[String],
    down: bool,
) -> Result<String, String> {
    let several = table_of(schema, path)
        .is_some_and(|(table, named)| named && table.shape != TableShape::One);
    let Some((name, parent)) = path.split_last().filter(|_| several) else {
        return Err(format!("{} is one table: it has no order.", shown(path)));
    };
    let tree = TomlNode::parse(text).map_err(|error| error.to_string())?;
    let names = tree
        .find(parent)
        .map_or(Vec::new(), |node| match node.items() {
            [] => node.names(),
            items => element_names(items),
        });
    let at = names.iter().position(|one| one == name);
    let at = at.ok_or_else(|| format!("There is no {} in this file.", shown(path)))?;
    let other = if down {
        at.checked_add(1)
    } else {
        at.checked_sub(1)
    };
    let Some(other) = other.and_then(|other| names.get(other)) else {
        let end = if down { "last" } else { "first" };
        return Err(format!("{} is the {end} one.", shown(path)));
    };
    let all = blocks(text);
    let own = extent(text, &all, path)?;
    let other = extent(text, &all, &[parent, std::slice::from_ref(other)].concat())?;
    let (first, second) = match own.start < other.start {
        true => (own, other),
        false => (other, own),
    };
    Ok([
        &text[..first.start],
        &text[second.clone()],
        &text[first.end..second.start],
        &text[first.clone()],
        &text[second.end..],
    ]
    .concat())
}
