//! The case that is converted: what it says, and where each of its keys is.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::case::{Case, Method, TomlNode};
use crate::import::fault::Fault;

/// The letters of the ends.
pub(super) const LETTERS: [&str; 2] = ["a", "b"];

/// The name of the line in the system.
pub(super) const LINE: &str = "line";

/// The names of the lines on either side of a body that travels, from end A and to end B.
pub(super) const BESIDE: [&str; 2] = ["line-1", "line-2"];

/// The key of the density of the water, which volumes follow from.
pub(super) const DENSITY: [&str; 2] = ["environment", "water_density_kg_per_m3"];

/// A case with its text.
pub(super) struct LineSource<'t> {
    /// Its text.
    pub(super) text: &'t str,
    /// What it says, expressions evaluated.
    pub(super) case: Case,
    /// Its tree, expressions as they are written.
    root: TomlNode,
}

impl<'t> LineSource<'t> {
    /// A case that was read from a text.
    pub(super) fn new(text: &'t str, case: Case) -> Self {
        // It was parsed before.
        let root =
            TomlNode::parse(text).unwrap_or_else(|_| TomlNode::of_table(&Default::default()));
        Self { text, case, root }
    }

    /// Its tree.
    pub(super) fn root(&self) -> &TomlNode {
        &self.root
    }

    /// The value at a key path.
    pub(super) fn node(&self, path: &[&str]) -> Option<&TomlNode> {
        self.root.find(path)
    }

    /// The bytes of the value at a key path.
    pub(super) fn span(&self, path: &[&str]) -> Option<&Range<usize>> {
        self.node(path).map(|node| &node.span)
    }

    /// Whether the number at a key path is an expression of parameters.
    pub(super) fn is_expression(&self, path: &[&str]) -> bool {
        self.node(path).is_some_and(|node| node.text().is_some())
    }

    /// A fault at a key path, or at the nearest table above it that the file has.
    pub(super) fn fault(&self, path: &[&str], problem: &str, remedy: &str) -> Fault {
        let mut above = (0..=path.len()).rev().map(|count| &path[..count]);
        let span = above.find_map(|path| self.span(path)).cloned();
        Fault::new(span.unwrap_or(0..0), path.join("."), problem, remedy)
    }

    /// A fault where the number at a key path is an expression: a system states it by another number.
    pub(super) fn fault_of_expression(&self, path: &[&str]) -> Option<Fault> {
        self.is_expression(path).then(|| {
            let problem =
                "is an expression, and a system states another number that follows from it";
            self.fault(path, problem, "give the number itself")
        })
    }

    /// Whether the case is computed in time.
    pub(super) fn is_in_time(&self) -> bool {
        self.case.solver.method != Method::Static
    }

    /// Whether a material of the line bends.
    pub(super) fn bends(&self) -> bool {
        let mut sections = self.case.line.iter();
        sections.any(|section| {
            let material = self.case.materials.get(&section.material);
            material.is_some_and(|of| of.ei_n_m2 > 0.0)
        })
    }

    /// Key paths by the byte where their values begin.
    pub(super) fn keys(&self) -> BTreeMap<usize, String> {
        let mut keys = BTreeMap::new();
        add_keys(&self.root, "", &mut keys);
        keys
    }
}

/// The key paths of all values below a table or list of tables.
fn add_keys(node: &TomlNode, path: &str, keys: &mut BTreeMap<usize, String>) {
    let below = |name: &str| match path {
        "" => name.to_owned(),
        path => format!("{path}.{name}"),
    };
    if !path.is_empty() {
        keys.entry(node.span.start)
            .or_insert_with(|| path.to_owned());
    }
    for entry in node.entries() {
        add_keys(&entry.node, &below(&entry.key), keys);
    }
    if node.is_list_of_tables() {
        for (name, item) in node.names().iter().zip(node.items()) {
            add_keys(item, &below(name), keys);
        }
    }
}
