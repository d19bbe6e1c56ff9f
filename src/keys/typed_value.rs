//! Values as a user types them, and as a file has them.

use super::edit::EditError;
use super::fields::parameters_table::ANY_KEY;
use super::fields::{Field, ValueType, check_value};
use super::parameters;
use super::tree::{TomlData, TomlNode};

/// A value typed for a field as it stands in a file. Lists need no brackets.
pub fn written(field: &Field, value: &str) -> String {
    typed(field, &bracketed(field, value)).0
}

/// A value typed for a field of a table that is new in a file, as it stands in the file.
///
/// # Errors
/// What is wrong with it, and what would be right.
pub fn checked_value(root: &TomlNode, field: &Field, value: &str) -> Result<String, EditError> {
    let (written, node) = typed(field, &bracketed(field, value));
    let number = parameters::typed(root, field, &node)
        .map_err(|fault| (fault.problem, fault.remedy.to_string()))?;
    let node = number.as_ref().unwrap_or(&node);
    // An expression of parameters is checked with all of them, in the file.
    if field.key() == ANY_KEY && node.text().is_some() {
        return Ok(written);
    }
    check_value(field, node).map_err(|fault| (fault.problem, fault.remedy))?;
    Ok(written)
}

/// A list typed as `0 0 -200` or `0, 0, -200`, in its brackets.
pub(super) fn bracketed(field: &Field, value: &str) -> String {
    let value = value.trim();
    let numbers = matches!(
        field.kind,
        ValueType::List | ValueType::Pair | ValueType::Triple
    );
    let words = field.kind == ValueType::Words;
    let may_be_one = matches!(
        field.kind,
        ValueType::NumberOrList | ValueType::NumberOrTriple
    );
    // One number, which may have a decimal comma, is left as it is.
    let several = value.split_whitespace().count() > 1
        && value
            .split([',', ' '])
            .filter(|part| !part.is_empty())
            .all(|part| part.parse::<f64>().is_ok());
    let numbers = numbers || (may_be_one && several);
    if value.starts_with('[') || !(numbers || words) {
        return value.to_owned();
    }
    let parts = value
        .split(|letter: char| letter == ',' || (letter.is_whitespace() && !value.contains(',')));
    let parts = parts.map(str::trim).filter(|part| !part.is_empty());
    let written = parts.map(|part| {
        let is_plain = part.parse::<f64>().is_ok() || part.starts_with(['"', '\'']);
        match is_plain && !words || part.starts_with(['"', '\'']) {
            true => part.to_owned(),
            false => toml_edit::Value::from(part).to_string(),
        }
    });
    format!("[{}]", written.collect::<Vec<_>>().join(", "))
}

/// A value as it will stand in the file, and as a tree.
pub(super) fn typed(field: &Field, value: &str) -> (String, TomlNode) {
    let value = value.trim();
    let as_text = || {
        let written = toml_edit::Value::from(value).to_string();
        let node = TomlNode {
            span: 0..written.len(),
            data: TomlData::Text(value.to_owned()),
        };
        (written, node)
    };
    let numbers_too = matches!(field.kind, ValueType::NumberOrChoice(_));
    match TomlNode::parse_value(value) {
        Some(node) if node.text().is_some() || !field.takes_words() || numbers_too => {
            let written = value.get(node.span.clone()).unwrap_or(value);
            (written.to_owned(), node)
        }
        _ => as_text(),
    }
}
