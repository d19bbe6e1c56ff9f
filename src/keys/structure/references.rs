//! Which keys name tables of the same file: what forms offer, and what a new name changes.

use std::collections::HashSet;

use super::tables::declaration;
use crate::fields::{Schema, join, split};
use crate::tree::{TomlData, TomlEntry, TomlNode, element_names};

/// A key that holds the name of a table, by the pattern of its path, and the tables that it may name: those in a table are named in that alone.
type TableReference = (&'static str, &'static [&'static str]);

/// Of line cases.
const OF_CASES: &[TableReference] = &[
    ("line.*.material", &["materials"]),
    ("floats.*.section", &["line"]),
    ("clumps.*.section", &["line"]),
    ("modules.*.section", &["line"]),
    ("published_curve.*.at.study", &["study"]),
];

/// Of line cases and of systems.
const OF_STUDIES: &[TableReference] = &[
    ("published.*.at.study", &["study"]),
    ("published.*.change_from.study", &["study"]),
    ("published.*.ratio_to.study", &["study"]),
    ("trend.*.study", &["study"]),
];

/// Of systems.
const OF_SYSTEMS: &[TableReference] = &[
    ("points.*.body", &["bodies", "rods"]),
    ("bodies.*.pinned_to", &["bodies", "rods"]),
    ("rods.*.pinned_to", &["bodies", "rods"]),
    ("lines.*.from", &["points"]),
    ("lines.*.to", &["points"]),
    ("lines.*.material", &["materials"]),
    ("lines.*.sections.*.material", &["materials"]),
    ("lines.*.floats.*.section", &["lines.*.sections"]),
    ("lines.*.modules.*.section", &["lines.*.sections"]),
    ("lines.*.clumps.*.section", &["lines.*.sections"]),
    ("payouts.*.line", &["lines"]),
    ("sliding_points.*.point", &["points"]),
    ("sliding_points.*.line", &["lines"]),
    ("sliding_points.*.other", &["lines"]),
    ("offset_curves.*.body", &["bodies", "rods"]),
    ("watch_circles.*.body", &["bodies", "rods"]),
    ("damage.lost_line", &["lines"]),
    ("ageing.growth.*.material", &["materials"]),
    ("ageing.corrosion.*.material", &["materials"]),
    ("checks.*.of", &["bodies", "lines", "points"]),
    ("start.parts", &["bodies", "rods", "points"]),
];

/// Of cross-sections.
const OF_SECTIONS: &[TableReference] = &[
    ("layer.*.unit", &["units"]),
    ("layer.*.units", &["units"]),
    ("centre.unit", &["units"]),
];

fn references(schema: &Schema) -> impl Iterator<Item = &'static TableReference> {
    let (own, of_studies) = match schema.what {
        "case" => (OF_CASES, OF_STUDIES),
        "system" => (OF_SYSTEMS, OF_STUDIES),
        "section" => (OF_SECTIONS, &[][..]),
        _ => (&[][..], &[][..]),
    };
    own.iter().chain(of_studies)
}

/// The names that a key of this pattern may hold in a file; nothing where the key names no table.
#[must_use]
pub fn names(schema: &Schema, text: &str, pattern: &str) -> Option<Vec<String>> {
    let (_, tables) = references(schema).find(|(known, _)| *known == pattern)?;
    let tree = TomlNode::parse(text).ok()?;
    let mut all: Vec<String> = tables
        .iter()
        .flat_map(|table| names_of(&tree, table))
        .collect();
    let mut known = HashSet::new();
    all.retain(|name| known.insert(name.clone()));
    // The ends of a rod are points too.
    if tables.contains(&"points") {
        let rods = tree.get("rods").map_or(Vec::new(), TomlNode::names);
        all.extend(
            rods.iter()
                .flat_map(|rod| [format!("{rod}-a"), format!("{rod}-b")]),
        );
    }
    Some(all)
}

/// The names of the tables of a pattern, `materials` or `lines.*.sections`.
fn names_of(node: &TomlNode, pattern: &str) -> Vec<String> {
    match pattern.split_once(".*.") {
        Some((outer, inner)) => {
            let lists = node.get(outer).map_or(&[][..], TomlNode::items);
            lists
                .iter()
                .flat_map(|item| names_of(item, inner))
                .collect()
        }
        None => node.get(pattern).map_or(Vec::new(), TomlNode::names),
    }
}

/// Places of a text that name a table, and their new text.
pub(super) type Replacements = Vec<(std::ops::Range<usize>, String)>;

/// Every value that names a table of this path, with the new name: keys that hold names, and keys that hold key paths. The headers of marks
/// are others' business.
pub(super) fn uses(
    schema: &'static Schema,
    text: &str,
    tree: &TomlNode,
    path: &[String],
    to: &str,
) -> Replacements {
    let Some(table) = declaration(schema, path) else {
        return Vec::new();
    };
    let sought = Use {
        schema,
        text,
        table: &table.path,
        path,
        to,
    };
    let mut found = Vec::new();
    for entry in tree.entries() {
        let mut here = vec![entry.key.clone()];
        walk(&sought, entry, &entry.key, &mut here, &mut found);
    }
    found
}

/// What is looked for.
struct Use<'a> {
    schema: &'a Schema,
    text: &'a str,
    /// The pattern of the table, `lines.*.sections`.
    table: &'a str,
    path: &'a [String],
    to: &'a str,
}

impl Use<'_> {
    /// The new text of a value of a key at a path, where it names the table.
    fn replaced(&self, pattern: &str, here: &[String], text: &str) -> Option<String> {
        let (name, table) = self.path.split_last()?;
        let (_, outer) = table.split_last()?;
        let names_it = here.starts_with(outer)
            && references(self.schema)
                .any(|(known, tables)| *known == pattern && tables.contains(&self.table));
        if names_it && text == name {
            return Some(self.to.to_owned());
        }
        // `chain@120` is a copy of the line `chain`.
        if let Some(copy) = text
            .strip_prefix(name.as_str())
            .filter(|rest| names_it && rest.starts_with('@'))
        {
            return Some(format!("{}{copy}", self.to));
        }
        if !matches!(pattern.rsplit('.').next(), Some("key" | "vary")) {
            return None;
        }
        let parts = split(text).filter(|parts| parts.len() > self.path.len())?;
        parts.starts_with(self.path).then(|| {
            let mut parts = parts;
            parts[self.path.len() - 1] = self.to.to_owned();
            join(&parts)
        })
    }
}

fn walk(
    sought: &Use<'_>,
    entry: &TomlEntry,
    pattern: &str,
    here: &mut Vec<String>,
    found: &mut Replacements,
) {
    values(sought, &entry.node, (pattern, &*here), found);
    let tables = sought.schema.tables.iter();
    let by_name = tables
        .filter(|table| table.shape == crate::fields::TableShape::ByName)
        .any(|table| table.path == pattern);
    for inner in entry.node.entries() {
        let key = if by_name { "*" } else { inner.key.as_str() };
        here.push(inner.key.clone());
        walk(sought, inner, &format!("{pattern}.{key}"), here, found);
        here.pop();
    }
    let items = entry.node.items();
    for (item, name) in items.iter().zip(element_names(items)) {
        here.push(name);
        for inner in item.entries() {
            let pattern = format!("{pattern}.*.{}", inner.key);
            here.push(inner.key.clone());
            walk(sought, inner, &pattern, here, found);
            here.pop();
        }
        here.pop();
    }
}

fn values(
    sought: &Use<'_>,
    node: &TomlNode,
    (pattern, here): (&str, &[String]),
    found: &mut Replacements,
) {
    let quoted = |text: &str| toml_edit::Value::from(text).to_string();
    match &node.data {
        TomlData::Text(text) => {
            let in_file = sought.text.get(node.span.clone()).is_some();
            if let Some(new) = sought.replaced(pattern, here, text).filter(|_| in_file) {
                found.push((node.span.clone(), quoted(&new)));
            }
        }
        TomlData::List(items) => {
            for item in items.iter().filter(|item| !item.is_table()) {
                values(sought, item, (pattern, here), found);
            }
        }
        _ => {}
    }
}
