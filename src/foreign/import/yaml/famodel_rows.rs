//! Tables of `FAModel` with a list of `keys` and rows of `data`.

use std::ops::Range;

use super::mapping::Mapping;
use super::tree::YamlNode;
use crate::import::fault::Fault;
use crate::import::mooring::Given;

/// A row of a table of `keys` and `data`.
pub struct DataRow<'d> {
    /// Its values with their keys.
    pub cells: Vec<(&'d str, YamlNode<'d>)>,
    /// Its bytes.
    pub span: Range<usize>,
    mapping: Mapping<'d>,
    path: String,
}

impl<'d> DataRow<'d> {
    /// The value of a key, if it has one.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<YamlNode<'d>> {
        let cell = self.cells.iter().find(|(name, _)| *name == key);
        cell.map(|(_, node)| *node).filter(|node| !node.is_null())
    }

    fn key(&self, key: &str) -> String {
        format!("{}.{key}", self.path)
    }

    /// The value of a key that must be there.
    pub fn required(
        &self,
        key: &str,
        remedy: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<YamlNode<'d>> {
        let found = self.get(key);
        if found.is_none() {
            let problem = format!("there is no `{key}`");
            faults.push(Fault::new(
                self.span.clone(),
                self.key(key),
                problem,
                remedy,
            ));
        }
        found
    }

    /// A number that must be there.
    pub fn number(&self, key: &str, faults: &mut Vec<Fault>) -> Option<Given<f64>> {
        let node = self.required(key, "give a number", faults)?;
        self.mapping
            .number_of(&node, &format!("data.{key}"), faults)
    }

    /// A word that must be there.
    pub fn word(&self, key: &str, remedy: &str, faults: &mut Vec<Fault>) -> Option<Given<String>> {
        let node = self.required(key, remedy, faults)?;
        let Some(text) = node.text() else {
            let problem = format!("{} where a word is expected", node.description());
            faults.push(Fault::new(node.span(), self.key(key), problem, remedy));
            return None;
        };
        Some(Given::new(text.trim().to_owned(), node.span()))
    }
}

/// The rows of a table of `keys` and `data`.
pub fn rows<'d>(table: &Mapping<'d>, remedy: &str, faults: &mut Vec<Fault>) -> Vec<DataRow<'d>> {
    let lists = ["keys", "data"].map(|key| {
        let node = table.required(key, remedy, faults)?;
        let items = node.items();
        if items.is_none() {
            let problem = format!("{} where a list is expected", node.description());
            faults.push(table.fault(&node, key, problem, remedy));
        }
        items
    });
    let [Some(keys), Some(data)] = lists else {
        return Vec::new();
    };
    let names: Vec<&str> = keys
        .iter()
        .map(|key| key.text().unwrap_or_default())
        .collect();
    let mut rows = Vec::new();
    for (number, node) in data.into_iter().enumerate() {
        let path = format!("{}[{}]", table.key("data"), number + 1);
        let cells = node.items().unwrap_or_default();
        if cells.len() != names.len() {
            let problem = format!(
                "the row has {} values for {} keys",
                cells.len(),
                names.len()
            );
            faults.push(Fault::new(
                node.span(),
                path,
                problem,
                "give a value for each key",
            ));
            continue;
        }
        rows.push(DataRow {
            cells: names.iter().copied().zip(cells).collect(),
            span: node.span(),
            mapping: table.clone(),
            path,
        });
    }
    rows
}
