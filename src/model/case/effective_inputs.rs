//! Every input of a file with the value that holds, defaults included, as one flat list: what runs are compared by.

use super::fields::{Schema, join, number};
use super::file_kind::FileKind;
use super::read::checked;
use super::schema::WrittenKeys;
use super::tree::{TomlData, TomlNode, element_names};
use super::{Diagnostic, TextDigest};

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
pub const NO_INPUTS: [&str; 11] = [
    "case",
    "system",
    "marks",
    "study",
    "load_cases",
    "statistics",
    "checks",
    "published",
    "published_curve",
    "trend",
    "trial",
];

/// Every input of the text of a file with the value that holds, in the order of the declarations. Keys without a value and without a
/// default are not listed.
///
/// # Errors
/// Everything that is wrong with the text.
pub fn effective_inputs<K: FileKind>(
    text: &str,
    file: &str,
) -> Result<Vec<EffectiveInput>, Vec<Diagnostic>> {
    let (given, content) = checked::<K>(text, file)?;
    let all = TomlNode::of_table(&content.write(WrittenKeys::All));
    let mut inputs = EffectiveInputs {
        schema: K::schema(),
        given: &given,
        list: Vec::new(),
    };
    for entry in all.entries() {
        if !NO_INPUTS.contains(&entry.key.as_str()) {
            inputs.collect(&entry.node, &mut vec![entry.key.clone()]);
        }
    }
    Ok(inputs.list)
}

/// The inputs found so far.
struct EffectiveInputs<'a> {
    schema: &'static Schema,
    given: &'a TomlNode,
    list: Vec<EffectiveInput>,
}

impl EffectiveInputs<'_> {
    /// Adds the values below a node.
    fn collect(&mut self, node: &TomlNode, path: &mut Vec<String>) {
        let inner: Vec<(String, &TomlNode)> = match &node.data {
            TomlData::Table(_, entries) => {
                let entries = entries.iter();
                entries.map(|e| (e.key.clone(), &e.node)).collect()
            }
            TomlData::List(items) if !items.is_empty() && node.is_list_of_tables() => {
                element_names(items).into_iter().zip(items).collect()
            }
            _ => {
                let field = self.schema.fields_at(path).next();
                self.list.push(EffectiveInput {
                    value: shown(path, node),
                    unit: field.map_or("", |field| field.unit),
                    given: self.given.find(path).is_some(),
                    path: join(path),
                });
                return;
            }
        };
        for (name, node) in inner {
            path.push(name);
            self.collect(node, path);
            path.pop();
        }
    }
}

/// A value as text.
fn shown(path: &[String], node: &TomlNode) -> String {
    match &node.data {
        TomlData::Text(text) if path.first().is_some_and(|table| table == "files") => {
            let digest = TextDigest::of_text(text).0;
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
    use crate::case::Case;
    use crate::case::shipped::SHIPPED;

    #[test]
    fn given_values_and_defaults_are_listed_with_their_units() {
        let (path, text) = SHIPPED
            .iter()
            .find(|(path, _)| path.ends_with("pendulous/manifold.toml"))
            .unwrap();
        let inputs = effective_inputs::<Case>(text, path).unwrap();
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
