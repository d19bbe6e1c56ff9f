//! Every input of a case with the value that holds, defaults included, as one flat list: what cases are compared by.

use super::fields::{join, number};
use super::model::field_at;
use super::tree::{TomlData, TomlNode, element_names};
use super::write::write_all;
use super::{Case, Diagnostic, TextDigest, parse};

/// An input of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct EffectiveInput {
    /// Key path: `materials.chain.ea_n`.
    pub path: String,
    /// The value as text, without its unit; of a file that goes with the case its size and digest.
    pub value: String,
    /// Unit as shown; empty for words, "-" for pure numbers.
    pub unit: &'static str,
    /// True when the file gives it, false when its default holds.
    pub given: bool,
}

/// Tables that describe, record or judge a case and are no input of it.
const NO_INPUTS: [&str; 7] = [
    "case",
    "marks",
    "study",
    "published",
    "published_curve",
    "trend",
    "trial",
];

/// Every input of a case text with the value that holds, in the order of the declarations. Keys without a value and without a
/// default are not listed.
///
/// # Errors
/// Everything that is wrong with the text.
pub fn effective_inputs(text: &str, file: &str) -> Result<Vec<EffectiveInput>, Vec<Diagnostic>> {
    let case = parse(text, file)?;
    Ok(inputs_of(&case, text))
}

fn inputs_of(case: &Case, text: &str) -> Vec<EffectiveInput> {
    let (Ok(all), Ok(given)) = (TomlNode::parse(&write_all(case)), TomlNode::parse(text)) else {
        return Vec::new();
    };
    let mut list = Vec::new();
    for entry in all.entries() {
        if !NO_INPUTS.contains(&entry.key.as_str()) {
            collect(&entry.node, &mut vec![entry.key.clone()], &given, &mut list);
        }
    }
    list
}

/// Adds the values below a node.
fn collect(
    node: &TomlNode,
    path: &mut Vec<String>,
    given: &TomlNode,
    list: &mut Vec<EffectiveInput>,
) {
    let inner: Vec<(String, &TomlNode)> = match &node.data {
        TomlData::Table(_, entries) => {
            let entries = entries.iter();
            entries.map(|e| (e.key.clone(), &e.node)).collect()
        }
        TomlData::List(items) if !items.is_empty() && node.is_list_of_tables() => {
            element_names(items).into_iter().zip(items).collect()
        }
        _ => {
            list.push(EffectiveInput {
                value: shown(path, node),
                unit: field_at(path).map_or("", |field| field.unit),
                given: given.find(path).is_some(),
                path: join(path),
            });
            return;
        }
    };
    for (name, node) in inner {
        path.push(name);
        collect(node, path, given, list);
        path.pop();
    }
}

/// A value as text.
fn shown(path: &[String], node: &TomlNode) -> String {
    match &node.data {
        TomlData::Text(text) if path.first().is_some_and(|table| table == "files") => {
            let digest = TextDigest::of(text).0;
            format!("{} bytes, digest {digest:016x}", text.len())
        }
        TomlData::Text(text) => text.clone(),
        TomlData::Integer(value) => value.to_string(),
        TomlData::Float(value) => number(*value),
        TomlData::Boolean(value) => value.to_string(),
        TomlData::List(items) => {
            let items: Vec<String> = items.iter().map(|item| shown(path, item)).collect();
            format!("[{}]", items.join(", "))
        }
        TomlData::Table(..) | TomlData::Date => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::shipped::SHIPPED;

    #[test]
    fn given_values_and_defaults_are_listed_with_their_units() {
        let (path, text) = SHIPPED
            .iter()
            .find(|(path, _)| path.ends_with("pendulous/manifold.toml"))
            .unwrap();
        let inputs = effective_inputs(text, path).unwrap();
        let of = |path: &str| inputs.iter().find(|input| input.path == path).unwrap();
        let speed = of("current.speed_m_per_s");
        assert_eq!(
            (speed.value.as_str(), speed.unit, speed.given),
            ("0.3", "m/s", true)
        );
        let direction = of("current.direction_deg");
        assert_eq!((direction.value.as_str(), direction.given), ("0", false));
        assert_eq!(of("ends.a.position_m").value, "[0, 0, 0]");
        assert_eq!(of("line.wire.segments").value, "2");
        assert!(
            inputs
                .iter()
                .all(|input| !input.path.starts_with("published"))
        );
    }
}
