//! Lines and sections divided into two.

use super::add::{free_name, inserted};
use super::blocks::{blocks, extent};
use super::{StructureEdit, apply, tables::shown, tables::table_of};
use crate::edit;
use crate::fields::{Field, Schema, join};
use crate::read::evaluated_tree;
use crate::tree::TomlNode;

/// The text with a section of a line, or a line of a system, divided at a length from its start. A section becomes two sections, a line of a
/// system two lines with a free point between them.
pub(super) fn divide(
    schema: &'static Schema,
    text: &str,
    path: &[String],
    at_m: &str,
) -> Result<String, String> {
    let tree = evaluated_tree(schema, text).map_err(|_| "The file has faults.".to_owned())?;
    let node = tree
        .find(path)
        .ok_or_else(|| format!("There is no {} in this file.", shown(path)))?;
    let parts = DividedLengths::of_node(node, path, at_m)?;
    match (schema.what, path) {
        ("case", [line, _]) if line == "line" => section_of_case(schema, text, path, &parts),
        ("system", [lines, _, sections, _]) if lines == "lines" && sections == "sections" => {
            section_of_line(schema, text, path, &parts)
        }
        ("system", [lines, name]) if lines == "lines" => {
            line_of_system(schema, text, node, name, &parts)
        }
        _ => Err(format!(
            "{} cannot be divided: lines and their sections can.",
            shown(path)
        )),
    }
}

/// Lengths \[m\] and numbers of segments of the two parts.
struct DividedLengths {
    lengths: [String; 2],
    segments: Option<[u32; 2]>,
}

impl DividedLengths {
    fn of_node(node: &TomlNode, path: &[String], at_m: &str) -> Result<Self, String> {
        let whole = node.get("length_m").and_then(TomlNode::number);
        let whole = whole.ok_or_else(|| {
            format!(
                "{} has no length of its own; divide one of its sections.",
                shown(path)
            )
        })?;
        let at: Option<f64> = at_m.trim().parse().ok();
        let at = at.filter(|at| *at > 0.0 && *at < whole).ok_or_else(|| {
            format!(
                "Give a length between 0 and {whole} m, from the start of {}.",
                shown(path)
            )
        })?;
        let segments = node.get("segments").and_then(TomlNode::number);
        Ok(Self {
            lengths: [at, whole - at].map(rounded),
            segments: segments.map(|all| shared(all, at / whole)),
        })
    }

    /// Keys of the first and of the second part.
    fn values(&self) -> [Vec<(String, Option<String>)>; 2] {
        [0, 1].map(|part| {
            let mut values = vec![("length_m".to_owned(), Some(self.lengths[part].clone()))];
            if let Some(segments) = self.segments {
                values.push(("segments".to_owned(), Some(segments[part].to_string())));
            }
            values
        })
    }
}

/// Segments shared out by length, at least two for each part.
fn shared(all: f64, share: f64) -> [u32; 2] {
    let first = (all * share).round().clamp(2.0, (all - 2.0).max(2.0));
    [first as u32, (all - first).max(2.0) as u32]
}

/// A length without the noise of a difference \[m\].
fn rounded(length: f64) -> String {
    let text = format!("{length:.6}");
    let text = text.trim_end_matches('0');
    match text.strip_suffix('.') {
        Some(whole) => format!("{whole}.0"),
        None => text.to_owned(),
    }
}

/// A section of a line case: what is at a place of it would change its place with it.
fn section_of_case(
    schema: &'static Schema,
    text: &str,
    path: &[String],
    parts: &DividedLengths,
) -> Result<String, String> {
    let name = path.last().map_or("", String::as_str);
    let tree = TomlNode::parse(text).map_err(|error| error.to_string())?;
    without_places(&tree, Some(name), &format!("section {name}"))?;
    let second = free_name(text, &["line".to_owned()], name);
    let [first_values, second_values] = parts.values();
    let edits = StructureEdit::All(vec![
        StructureEdit::Copy {
            path: join(path),
            name: Some(second.clone()),
        },
        StructureEdit::Fill {
            path: join(path),
            values: first_values,
        },
        StructureEdit::Fill {
            path: join(&["line", &second]),
            values: second_values,
        },
    ]);
    apply(schema, text, &edits)
}

/// What has places on a section of a line, or on all of it, which a division would make other places.
///
/// # Errors
/// That it has to be removed first.
fn without_places(line: &TomlNode, section: Option<&str>, shown: &str) -> Result<(), String> {
    for table in ["floats", "clumps", "modules"] {
        let on_it = |item: &TomlNode| {
            let own = item.get("section").and_then(TomlNode::text);
            own.is_none() || section.is_none() || own == section
        };
        let list = line.get(table).map_or(&[][..], TomlNode::items);
        if list.iter().any(on_it) {
            return Err(format!(
                "[[{table}]] have places on the {shown}, which would be other places then; remove them first."
            ));
        }
    }
    Ok(())
}

/// What the keys of the body at the end of a section of a line of a system begin with.
const OF_CLUMP: &str = "clump_";

/// A section of a line of a system: its clump stays at its end.
fn section_of_line(
    schema: &'static Schema,
    text: &str,
    path: &[String],
    parts: &DividedLengths,
) -> Result<String, String> {
    let tree = TomlNode::parse(text).map_err(|error| error.to_string())?;
    let (Some(line), Some(section)) = (tree.find(&path[..2]), tree.find(path)) else {
        return Err(format!("There is no {} in this file.", shown(path)));
    };
    let name = section.get("name").and_then(TomlNode::text);
    without_places(line, name, &format!("section {}", path[3]))?;
    let (text, next) = match name {
        Some(name) => {
            let second = free_name(text, &path[..3], name);
            let edit = StructureEdit::Copy {
                path: join(path),
                name: Some(second.clone()),
            };
            (apply(schema, text, &edit)?, second)
        }
        None => {
            let number: usize = path[3].parse().unwrap_or(1);
            let range = extent(text, &blocks(text), path)?;
            let copied = &text[range.clone()];
            (inserted(text, range.end, copied), (number + 1).to_string())
        }
    };
    let next = [&path[..3], &[next]].concat();
    let [mut first, second] = parts.values();
    let pattern = table_of(schema, path).map(|(table, _)| table.pattern());
    let pattern = pattern.unwrap_or_default();
    let keys = schema.fields_of(&pattern).map(Field::key);
    let of_clump = keys.filter(|key| key.starts_with(OF_CLUMP));
    first.extend(of_clump.map(|key| (key.to_owned(), None)));
    let edits = StructureEdit::All(vec![
        StructureEdit::Fill {
            path: join(path),
            values: first,
        },
        StructureEdit::Fill {
            path: join(&next),
            values: second,
        },
    ]);
    apply(schema, &text, &edits)
}

/// A line of a system: two lines with a free point between them, which begins on the straight line from end to end.
fn line_of_system(
    schema: &'static Schema,
    text: &str,
    node: &TomlNode,
    name: &str,
    parts: &DividedLengths,
) -> Result<String, String> {
    if let Some(entry) = node.entries().iter().find(|entry| {
        let key = entry.key.as_str();
        let of_ends = ["clamp_", "release_", "break_", "repeat_"];
        of_ends.iter().any(|begin| key.starts_with(begin))
    }) {
        return Err(format!(
            "The line {name} has `{}`, which belongs to the whole of it; remove that first.",
            entry.key
        ));
    }
    without_places(node, None, &format!("line {name}"))?;
    let word = |key: &str| node.get(key).and_then(TomlNode::text).map(str::to_owned);
    let (Some(from), Some(to)) = (word("from"), word("to")) else {
        return Err(format!("The line {name} has no ends."));
    };
    let share = {
        let [first, second] = &parts.lengths;
        let length = |text: &String| text.parse::<f64>().unwrap_or(1.0);
        length(first) / (length(first) + length(second))
    };
    let point = free_name(text, &["points".to_owned()], &format!("{name}-joint"));
    let second = free_name(text, &["lines".to_owned()], name);
    let place = between(schema, text, &from, &to, share)?;
    let [mut first_values, mut second_values] = parts.values();
    first_values.push(("to".to_owned(), Some(point.clone())));
    second_values.push(("from".to_owned(), Some(point.clone())));
    let edits = StructureEdit::All(vec![
        StructureEdit::Add {
            table: "points".to_owned(),
            name: Some(point),
            values: vec![
                ("kind".to_owned(), "free".to_owned()),
                ("position_m".to_owned(), place),
            ],
        },
        StructureEdit::Copy {
            path: join(&["lines", name]),
            name: Some(second.clone()),
        },
        StructureEdit::Fill {
            path: join(&["lines", name]),
            values: first_values,
        },
        StructureEdit::Fill {
            path: join(&["lines", &second]),
            values: second_values,
        },
    ]);
    apply(schema, text, &edits)
}

/// A place between two points, at a share of the way. Points of bodies lie in the frame of their body, which is taken as upright.
fn between(
    schema: &'static Schema,
    text: &str,
    from: &str,
    to: &str,
    share: f64,
) -> Result<String, String> {
    let tree = evaluated_tree(schema, text).map_err(|_| "The file has faults.".to_owned())?;
    let numbers = |path: &[&str]| tree.find(path).and_then(TomlNode::numbers);
    let place = |point: &str| {
        let own = numbers(&["points", point, "position_m"])
            .ok_or_else(|| format!("Where the point {point} is cannot be told."))?;
        let body = edit::get(text, &join(&["points", point, "body"]));
        let origin = body.and_then(|body| numbers(&["bodies", &body, "position_m"]));
        let origin = origin.unwrap_or_else(|| vec![0.0; 3]);
        Ok::<Vec<f64>, String>(own.iter().zip(&origin).map(|(a, b)| a + b).collect())
    };
    let (from, to) = (place(from)?, place(to)?);
    let on_the_way = from.iter().zip(&to).map(|(a, b)| a + (b - a) * share);
    let words: Vec<String> = on_the_way.map(rounded).collect();
    Ok(format!("[{}]", words.join(", ")))
}
