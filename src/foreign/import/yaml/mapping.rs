//! A mapping of a design with its path, and its values as the reader needs them: numbers, names, places.
//!
//! Each function puts down what is wrong and returns nothing then, so that all faults of a file are found at once.

use std::collections::HashMap;
use std::ops::Range;

use super::tree::{YamlNode, shortened};
use crate::import::fault::Fault;
use crate::import::mooring::Given;
use crate::import::size;

/// A mapping and the path of keys to it.
#[derive(Debug, Clone)]
pub struct Mapping<'d> {
    /// The node; not always a mapping: it then has no keys.
    pub node: YamlNode<'d>,
    /// Its path, `mooring.lines.line1`.
    pub path: String,
}

impl<'d> Mapping<'d> {
    /// A mapping at a path; nothing, with its fault, if the node is none.
    pub fn of_node(
        node: YamlNode<'d>,
        path: impl Into<String>,
        faults: &mut Vec<Fault>,
    ) -> Option<Self> {
        let path = path.into();
        if node.is_mapping() {
            return Some(Self { node, path });
        }
        faults.push(Fault::new(
            node.span(),
            path,
            format!(
                "{} where keys with their values are expected",
                node.description()
            ),
            "write `key: value` rows below it",
        ));
        None
    }

    /// The path of a key.
    #[must_use]
    pub fn key(&self, key: &str) -> String {
        match self.path.is_empty() {
            true => key.to_owned(),
            false => format!("{}.{key}", self.path),
        }
    }

    /// The value of a key, if it has one.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<YamlNode<'d>> {
        self.node.get(key).filter(|node| !node.is_null())
    }

    /// A fault about a value of this mapping.
    #[must_use]
    pub fn fault(
        &self,
        node: &YamlNode<'_>,
        key: &str,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Fault {
        Fault::new(node.span(), self.key(key), problem, remedy)
    }

    /// The value of a key that must be there.
    pub fn required(
        &self,
        key: &str,
        remedy: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<YamlNode<'d>> {
        if let Some(node) = self.get(key) {
            return Some(node);
        }
        let (span, problem) = match self.node.get(key) {
            Some(node) => (node.key_span(), format!("`{key}` has no value")),
            None => (self.node.key_span(), format!("there is no `{key}`")),
        };
        faults.push(Fault::new(span, self.key(key), problem, remedy));
        None
    }

    /// The mapping of a key that must be there.
    pub fn mapping(&self, key: &str, remedy: &str, faults: &mut Vec<Fault>) -> Option<Self> {
        let node = self.required(key, remedy, faults)?;
        Self::of_node(node, self.key(key), faults)
    }

    /// The mapping of a key, if there is one.
    #[must_use]
    pub fn optional_mapping(&self, key: &str) -> Option<Self> {
        let node = self.get(key).filter(YamlNode::is_mapping)?;
        Some(Self {
            node,
            path: self.key(key),
        })
    }

    /// The mappings of a list, each with its `name` in its path; `what` is one of them in a word.
    pub fn mappings(&self, key: &str, what: &str, faults: &mut Vec<Fault>) -> Vec<Self> {
        let remedy = format!("a mooring has one {what} at least, each as `- name: ...`");
        let Some(list) = self.required(key, &remedy, faults) else {
            return Vec::new();
        };
        let Some(items) = list.items() else {
            let problem = format!("{} where a list of {what}s is expected", list.description());
            faults.push(self.fault(&list, key, problem, "write `- name: ...` for each"));
            return Vec::new();
        };
        if items.is_empty() {
            let span = list.key_span();
            let problem = format!("there is no {what} in this list");
            faults.push(Fault::new(span, self.key(key), problem, remedy));
        }
        if size::too_many(items.len()) {
            let at = items.get(size::most()).map_or(list.span(), YamlNode::span);
            faults.push(size::fault(&self.key(key), items.len(), at));
            return Vec::new();
        }
        let numbered = items.into_iter().enumerate();
        let named = numbered.filter_map(|(number, node)| {
            let name = node.get("name").and_then(|name| name.text());
            let path = match name {
                Some(name) => format!("{}.{}", self.key(key), shortened(name)),
                None => format!("{}[{}]", self.key(key), number + 1),
            };
            Self::of_node(node, path, faults)
        });
        named.collect()
    }

    /// A word or text that must be there.
    pub fn word(&self, key: &str, remedy: &str, faults: &mut Vec<Fault>) -> Option<Given<String>> {
        let node = self.required(key, remedy, faults)?;
        let Some(text) = node.text() else {
            let problem = format!("{} where a word is expected", node.description());
            faults.push(self.fault(&node, key, problem, remedy));
            return None;
        };
        Some(Given::new(text.trim().to_owned(), node.span()))
    }

    /// A number that must be there.
    pub fn number(&self, key: &str, faults: &mut Vec<Fault>) -> Option<Given<f64>> {
        let node = self.required(key, "give a number", faults)?;
        self.number_of(&node, key, faults)
    }

    /// A number above 0 that must be there.
    pub fn positive(&self, key: &str, faults: &mut Vec<Fault>) -> Option<Given<f64>> {
        let given = self.number(key, faults)?;
        self.above_zero(given, key, faults)
    }

    /// A number not below 0 that must be there.
    pub fn not_negative(&self, key: &str, faults: &mut Vec<Fault>) -> Option<Given<f64>> {
        let given = self.number(key, faults)?;
        self.not_below_zero(given, key, faults)
    }

    /// A number, if there is one; the outer nothing is a fault.
    pub fn optional(&self, key: &str, faults: &mut Vec<Fault>) -> Option<Option<Given<f64>>> {
        match self.get(key) {
            Some(node) => self.number_of(&node, key, faults).map(Some),
            None => Some(None),
        }
    }

    /// A number not below 0; 0 at the place of the mapping where there is none.
    pub fn or_zero(&self, key: &str, faults: &mut Vec<Fault>) -> Option<Given<f64>> {
        match self.optional(key, faults)? {
            Some(given) => self.not_below_zero(given, key, faults),
            None => Some(Given::new(0.0, self.node.span())),
        }
    }

    /// A number above 0, if there is one; the outer nothing is a fault.
    pub fn optional_positive(
        &self,
        key: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<Option<Given<f64>>> {
        match self.optional(key, faults)? {
            Some(given) => self.above_zero(given, key, faults).map(Some),
            None => Some(None),
        }
    }

    /// Three coordinates \[m\] that must be there.
    pub fn place(&self, key: &str, faults: &mut Vec<Fault>) -> Option<[Given<f64>; 3]> {
        const REMEDY: &str = "give x, y and z in m: `[837.6, 0, -200]`";
        let node = self.required(key, REMEDY, faults)?;
        let Some(items) = node.items() else {
            let problem = format!("{} where a list of x, y, z is expected", node.description());
            faults.push(self.fault(&node, key, problem, REMEDY));
            return None;
        };
        let Ok(items): Result<[YamlNode<'_>; 3], _> = items.as_slice().try_into() else {
            let problem = format!("the list has {} numbers where 3 are read", items.len());
            faults.push(self.fault(&node, key, problem, REMEDY));
            return None;
        };
        let [x, y, z] = items.map(|item| self.number_of(&item, key, faults));
        Some([x?, y?, z?])
    }

    /// The number that a node of this mapping is.
    pub fn number_of(
        &self,
        node: &YamlNode<'_>,
        key: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<Given<f64>> {
        let remedy = "write a number such as 0.25 or 3.84e8";
        if node.is_octal() {
            let what = node.description();
            let problem = format!("{what} begins with 0, by which YAML means an octal number");
            faults.push(self.fault(node, key, problem, "write it without the leading 0"));
            return None;
        }
        let Some(value) = node.number() else {
            let problem = format!("{} is not a number", node.description());
            faults.push(self.fault(node, key, problem, remedy));
            return None;
        };
        Some(Given::new(value, node.span()))
    }

    fn above_zero(
        &self,
        given: Given<f64>,
        key: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<Given<f64>> {
        if given.value > 0.0 {
            return Some(given);
        }
        let problem = format!("{} is not above 0", given.value);
        let remedy = "give a positive number";
        faults.push(Fault::new(given.span, self.key(key), problem, remedy));
        None
    }

    fn not_below_zero(
        &self,
        given: Given<f64>,
        key: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<Given<f64>> {
        if given.value >= 0.0 {
            return Some(given);
        }
        let problem = format!("{} is below 0", given.value);
        faults.push(Fault::new(
            given.span,
            self.key(key),
            problem,
            "give 0 or more",
        ));
        None
    }

    /// Keys that are neither of these, in the order of the file.
    #[must_use]
    pub fn others(&self, known: &[&str]) -> Vec<(&'d str, YamlNode<'d>)> {
        let entries = self.node.entries().unwrap_or_default();
        let is_other = |(key, _): &(&str, YamlNode<'_>)| !known.contains(key);
        entries.into_iter().filter(is_other).collect()
    }
}

/// A list of names, and the place of each.
#[derive(Debug, Clone)]
pub struct Lookup<'n> {
    names: &'n [String],
    places: HashMap<&'n str, usize>,
}

impl<'n> Lookup<'n> {
    /// Of a list; of two names that are the same the first counts.
    #[must_use]
    pub fn of_names(names: &'n [String]) -> Self {
        let mut places = HashMap::new();
        for (place, name) in names.iter().enumerate() {
            places.entry(name.as_str()).or_insert(place);
        }
        Self { names, places }
    }
}

/// The place of a name in a list; nothing, with a fault that lists the names, if it is not there.
pub fn find(
    name: &Given<String>,
    lookup: &Lookup<'_>,
    what: &str,
    key: String,
    faults: &mut Vec<Fault>,
) -> Option<Given<usize>> {
    if let Some(number) = lookup.places.get(name.value.as_str()) {
        return Some(Given::new(*number, name.span.clone()));
    }
    let problem = format!("there is no {what} `{}`", shortened(&name.value));
    faults.push(Fault::new(
        name.span.clone(),
        key,
        problem,
        listed(what, lookup.names),
    ));
    None
}

/// The names that there are, in words.
#[must_use]
pub fn listed(what: &str, names: &[String]) -> String {
    if names.is_empty() {
        return format!("give a list of {what}s with their names");
    }
    format!("{what}s are {}", crate::import::listing::listed(names))
}

/// Faults for names that occur twice.
pub fn unique(named: &[(String, Range<usize>)], what: &str, path: &str, faults: &mut Vec<Fault>) {
    let mut seen = std::collections::HashSet::new();
    for (name, span) in named {
        if !seen.insert(name) {
            let name = shortened(name);
            faults.push(Fault::new(
                span.clone(),
                format!("{path}.{name}.name"),
                format!("there is a second {what} `{name}`"),
                "give it a name of its own",
            ));
        }
    }
}
