//! `[parameters]`: named numbers of a file, and values of other keys that are computed from them.
//!
//! ```toml
//! [parameters]
//! depth_m = 200
//! radius_m = "4 * depth_m"
//!
//! [[lines]]
//! length_m = "1.02 * sqrt(radius_m^2 + depth_m^2)"
//! ```
//!
//! Expressions are evaluated where a file is read: what checks and solvers see are numbers.

mod expression;
mod resolution;
mod tokens;
mod vocabulary;

use std::collections::BTreeMap;

use super::check::fields_here;
use super::diagnostic::{Finding, MOST_DIAGNOSTICS};
use super::fields::parameters_table::{ANY_KEY, PARAMETERS};
use super::fields::{
    Field, Schema, TableSchema, TableShape, TypedNumber, ValueType, join, nearest, number,
};
use super::tree::{TomlData, TomlNode, element_names};
use expression::{Expression, NotFinite};
use resolution::ParameterResolution;

/// Greatest number of names that a message lists.
const MOST_NAMES: usize = 20;

/// The parameters of a file with their values.
#[derive(Debug, Clone, Default)]
pub struct Parameters {
    values: BTreeMap<String, f64>,
}

/// Replaces the expressions of a file by their values; what cannot be evaluated stays and is reported. A file without parameters is left as
/// it is.
pub fn evaluate(schema: &'static Schema, root: &mut TomlNode) -> Vec<Finding> {
    let Some(node) = root.get(PARAMETERS).filter(|node| node.is_table()) else {
        return Vec::new();
    };
    let (parameters, mut found) = Parameters::of_table(node);
    if found.is_empty() {
        let mut walk = Evaluation {
            schema,
            parameters: &parameters,
            found: Vec::new(),
        };
        walk.table(root, "", &mut Vec::new());
        found = walk.found;
    }
    found.sort_by_key(|finding| finding.span.start);
    found
}

/// The number of a text typed for a field of a file, where it is an expression of the file's parameters; nothing where it is none.
///
/// # Errors
/// What is wrong with the expression, and what would be right.
pub fn typed(root: &TomlNode, field: &Field, node: &TomlNode) -> Result<Option<TomlNode>, Finding> {
    let Some(table) = root.get(PARAMETERS).filter(|node| node.is_table()) else {
        return Ok(None);
    };
    let (parameters, _) = Parameters::of_table(table);
    let mut evaluated = node.clone();
    parameters.replace(field, &mut evaluated, (&field.path, UnknownNames::Compared))?;
    Ok((evaluated != *node).then_some(evaluated))
}

/// What is said of a parameter that a file does not have.
pub fn absent(root: &TomlNode, name: &str) -> (String, String) {
    let known = root.get(PARAMETERS).map_or(Vec::new(), TomlNode::names);
    let problem = format!("there is no parameter `{name}` in this file");
    let remedy = match nearest(name, known.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{near}`?"),
        None if known.is_empty() => format!("add [{PARAMETERS}] with it to the file"),
        None => {
            let first = known.len().min(MOST_NAMES);
            let further = match known.len() - first {
                0 => String::new(),
                count => format!(" and {count} more"),
            };
            format!("[{PARAMETERS}] has {}{further}", known[..first].join(", "))
        }
    };
    (problem, remedy)
}

impl Parameters {
    /// The values of a table of parameters, and what is wrong with it.
    fn of_table(node: &TomlNode) -> (Self, Vec<Finding>) {
        let (values, found) = ParameterResolution::values_of_table(node);
        (Self { values }, found)
    }

    /// Replaces a value of a field, or those of its list, where it is an expression.
    fn replace(
        &self,
        field: &Field,
        node: &mut TomlNode,
        (path, names): (&str, UnknownNames),
    ) -> Result<(), Finding> {
        if !holds_numbers(field.kind) {
            return Ok(());
        }
        let node_span = node.span.clone();
        match &mut node.data {
            TomlData::List(items) => items
                .iter_mut()
                .try_for_each(|item| self.replace(field, item, (path, names))),
            TomlData::Text(text) => {
                let fault = |(problem, remedy)| Finding::new(&node_span, path, problem, remedy);
                let value = self.number(field, text, names).map_err(fault)?;
                if let Some(value) = value {
                    node.data = value;
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// The number of an expression that names parameters; nothing where the text is something else.
    fn number(
        &self,
        field: &Field,
        text: &str,
        names: UnknownNames,
    ) -> Result<Option<TomlData>, (String, String)> {
        let is_word =
            matches!(field.kind, ValueType::NumberOrChoice(words) if words.contains(&text));
        let names_one = words_of(text).any(|word| self.values.contains_key(word));
        let is_number = TypedNumber::read(text, field.unit).is_some();
        if is_word || (is_number && !names_one) {
            return Ok(None);
        }
        let read = match Expression::read(text) {
            Ok(read) if read.names().is_empty() => return Ok(None),
            Ok(read) => read,
            Err(fault) if names_one => return Err(unreadable(text, &fault)),
            Err(_) => return Ok(None),
        };
        let of_names = read.names().iter().map(|name| {
            let value = self.values.get(name).copied();
            value.ok_or_else(|| unknown(name, self.values.keys().map(String::as_str), names))
        });
        let of_names: Vec<f64> = of_names.collect::<Result<_, _>>()?;
        let value = read.value(&of_names);
        let value = value.map_err(|found| not_finite(text, &found))?;
        as_data(field, value).map(Some)
    }
}

/// Whether a name that the file lacks is compared with all that it has, which takes time by the product of both.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum UnknownNames {
    Compared,
    Listed,
}

impl UnknownNames {
    /// As many names are compared as faults are shown.
    fn after(faults: usize) -> Self {
        match faults < MOST_DIAGNOSTICS {
            true => Self::Compared,
            false => Self::Listed,
        }
    }
}

/// What is said of a name in an expression that the file does not define, of those that it does.
fn unknown<'n>(
    name: &str,
    known: impl Iterator<Item = &'n str> + Clone,
    names: UnknownNames,
) -> (String, String) {
    let problem = format!("names `{name}`, which is no parameter of this file");
    let near = match names {
        UnknownNames::Compared => nearest(name, known.clone()),
        UnknownNames::Listed => None,
    };
    let first: Vec<&str> = known.clone().take(MOST_NAMES).collect();
    let further = match known.skip(MOST_NAMES).count() {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    let remedy = match near {
        Some(near) => format!("did you mean `{near}`?"),
        None if first.is_empty() => format!("add `{name} = ...` to [{PARAMETERS}]"),
        None => format!(
            "add `{name} = ...` to [{PARAMETERS}], which has {}{further}",
            first.join(", ")
        ),
    };
    (problem, remedy)
}

/// What is said of an expression with a part that is no finite number.
fn not_finite(text: &str, found: &NotFinite) -> (String, String) {
    let NotFinite { part, value } = found;
    let problem = match part == text.trim() {
        true => format!("is {value} by its expression"),
        false => format!("has no value by its expression: `{part}` is {value}"),
    };
    let remedy = "look for a division by zero or a root of a negative number";
    (problem, remedy.to_owned())
}

/// A number as the value of a field.
fn as_data(field: &Field, value: f64) -> Result<TomlData, (String, String)> {
    if field.kind != ValueType::Integer {
        return Ok(TomlData::Float(value));
    }
    let whole = value.round();
    if (value - whole).abs() > 1e-9 * whole.abs().max(1.0) || whole.abs() > 1e15 {
        let problem = format!("is {} by its expression, and must be whole", number(value));
        let remedy = "write round(...), floor(...) or ceil(...) around it";
        return Err((problem, remedy.to_owned()));
    }
    Ok(TomlData::Integer(whole as i64))
}

fn unreadable(text: &str, fault: &str) -> (String, String) {
    let problem = format!("is no expression that can be read: \"{text}\": {fault}");
    let remedy = format!("known are {}", vocabulary::vocabulary());
    (problem, remedy)
}

/// The words of a text that may be names.
fn words_of(text: &str) -> impl Iterator<Item = &str> {
    text.split(|letter: char| !(letter.is_alphanumeric() || letter == '_'))
}

/// Whether a value of this type is made of numbers.
fn holds_numbers(kind: ValueType) -> bool {
    matches!(
        kind,
        ValueType::Number
            | ValueType::Integer
            | ValueType::NumberOrChoice(_)
            | ValueType::NumberOrList
            | ValueType::NumberOrTriple
            | ValueType::List
            | ValueType::Pair
            | ValueType::Triple
    )
}

/// The way through a file that replaces expressions, along its schema as the check of its keys goes.
struct Evaluation<'a> {
    schema: &'static Schema,
    parameters: &'a Parameters,
    found: Vec<Finding>,
}

impl Evaluation<'_> {
    fn table(&mut self, node: &mut TomlNode, pattern: &str, path: &mut Vec<String>) {
        let known = fields_here(self.schema, node, pattern);
        let TomlData::Table(_, entries) = &mut node.data else {
            return;
        };
        for entry in entries {
            path.push(entry.key.clone());
            let same =
                |field: &&&'static Field| [entry.key.as_str(), ANY_KEY].contains(&field.key());
            if let Some(field) = known.iter().find(same) {
                self.value(field, &mut entry.node, path);
            } else if let Some(table) = super::check::subtable(self.schema, pattern, &entry.key) {
                self.subtables(table, &mut entry.node, path);
            }
            path.pop();
        }
    }

    fn value(&mut self, field: &Field, node: &mut TomlNode, path: &[String]) {
        let [.., key] = path else { return };
        if field.table() == PARAMETERS {
            if let Some(value) = self.parameters.values.get(key) {
                node.data = TomlData::Float(*value);
            }
            return;
        }
        let names = UnknownNames::after(self.found.len());
        let replaced = self.parameters.replace(field, node, (&join(path), names));
        if let Err(fault) = replaced {
            self.found.push(fault);
        }
    }

    fn subtables(&mut self, table: &TableSchema, node: &mut TomlNode, path: &mut Vec<String>) {
        let inner = table.pattern();
        match (table.shape, &mut node.data) {
            (TableShape::One, TomlData::Table(..)) => self.table(node, &inner, path),
            (TableShape::ByName, TomlData::Table(_, entries)) => {
                for entry in entries {
                    path.push(entry.key.clone());
                    self.table(&mut entry.node, &inner, path);
                    path.pop();
                }
            }
            (TableShape::List, TomlData::List(items)) => {
                let names = element_names(items);
                for (item, name) in items.iter_mut().zip(names) {
                    path.push(name);
                    self.table(item, &inner, path);
                    path.pop();
                }
            }
            _ => {}
        }
    }
}
