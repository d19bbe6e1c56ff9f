//! Points and lines of a design, whose tables RAFT and the IEA ontology name differently.

use std::ops::Range;

use super::mapping::{Lookup, Mapping, find, unique};
use super::tree::shortened;
use crate::import::fault::Fault;
use crate::import::mooring::{Attachment, Given, Hold, MooringLine, MooringLineType, MooringPoint};

/// The word for a line.
const LINE: &str = "line";

/// How a design names its tables and keys.
#[derive(Debug, Clone, Copy)]
pub struct Dialect {
    /// The table of points, and one of them in a word.
    pub points: (&'static str, &'static str),
    /// What holds a point.
    pub hold: &'static str,
    /// Mass \[kg\] and volume \[m³\] of a point.
    pub mass: [&'static str; 2],
    /// The ends of a line.
    pub ends: [&'static str; 2],
    /// The type of a line.
    pub line_type: &'static str,
    /// The length of a line without tension \[m\].
    pub length: &'static str,
}

/// The entries of a table with their names, those that are faulty too: what names them is then not at fault.
#[derive(Debug, Clone)]
pub struct Named<T> {
    /// The names.
    pub names: Vec<String>,
    /// The entries; nothing where one is faulty.
    pub entries: Vec<Option<T>>,
}

impl<T> Named<T> {
    /// Reads the entries of a table, whose names must differ.
    pub fn read<'d>(
        rows: &[Mapping<'d>],
        what: &str,
        path: &str,
        faults: &mut Vec<Fault>,
        mut read: impl FnMut(&Mapping<'d>, &str, &mut Vec<Fault>) -> Option<T>,
    ) -> Self {
        let mut named: Vec<(String, Range<usize>)> = Vec::new();
        let mut entries = Vec::new();
        for (number, row) in rows.iter().enumerate() {
            let name = match what {
                // Nothing refers to a line: it may have no name.
                LINE if row.get("name").is_none() => {
                    Some(Given::new((number + 1).to_string(), row.node.span()))
                }
                _ => row.word(
                    "name",
                    &format!("name the {what}, as others refer to it"),
                    faults,
                ),
            };
            let text = name.as_ref().map_or("", |name| &name.value);
            entries.push(read(row, text, faults));
            if let Some(name) = name {
                named.push((name.value, name.span));
            } else {
                named.push((String::new(), row.node.span()));
            }
        }
        let given: Vec<_> = named
            .iter()
            .filter(|one| !one.0.is_empty())
            .cloned()
            .collect();
        unique(&given, what, path, faults);
        Self {
            names: named.into_iter().map(|(name, _)| name).collect(),
            entries,
        }
    }

    /// The entries that are not faulty: all of them where the file has no fault.
    #[must_use]
    pub fn valid(self) -> Vec<T> {
        self.entries.into_iter().flatten().collect()
    }
}

/// What holds a point, by the words of both formats.
pub fn hold_of(word: &Given<String>, key: String, faults: &mut Vec<Fault>) -> Option<Given<Hold>> {
    let lower = word.value.to_lowercase();
    let has = |parts: &[&str]| parts.iter().any(|part| lower.contains(part));
    let hold = if has(&["anch", "fix"]) {
        Hold::Fixed
    } else if has(&["fair", "ves"]) {
        Hold::Coupled
    } else if has(&["con", "free"]) {
        Hold::Free
    } else {
        let problem = format!("`{}` is not a type of point", shortened(&word.value));
        let remedy =
            "it is fixed (an anchor), vessel (on the platform), or free (also `connection`)";
        faults.push(Fault::new(word.span.clone(), key, problem, remedy));
        return None;
    };
    Some(Given::new(hold, word.span.clone()))
}

/// A point at a place.
pub fn point(
    row: &Mapping<'_>,
    name: &str,
    dialect: &Dialect,
    place: Option<[Given<f64>; 3]>,
    faults: &mut Vec<Fault>,
) -> Option<MooringPoint> {
    let remedy = "it is fixed, vessel or free";
    let word = row.word(dialect.hold, remedy, faults);
    let hold = word.and_then(|word| hold_of(&word, row.key(dialect.hold), faults));
    let [mass, volume] = dialect.mass.map(|key| row.or_zero(key, faults));
    let drag_area = row.or_zero("drag_area", faults);
    let added_mass = row.or_zero("added_mass", faults);
    let none = || Given::new(0.0, row.node.span());
    Some(MooringPoint {
        id: name.to_owned(),
        span: row.node.span(),
        hold: hold?,
        place: place?,
        mass: mass?,
        volume: volume?,
        drag_area: drag_area?,
        added_mass: added_mass?,
        load: [none(), none(), none()],
    })
}

/// The lines between the points.
pub fn lines(
    table: &Mapping<'_>,
    dialect: &Dialect,
    types: &Named<MooringLineType>,
    points: &Named<MooringPoint>,
    faults: &mut Vec<Fault>,
) -> Vec<MooringLine> {
    let rows = table.mappings("lines", LINE, faults);
    let path = table.key("lines");
    let [by_point, by_type] = [&points.names, &types.names].map(|names| Lookup::of_names(names));
    let read = |row: &Mapping<'_>, name: &str, faults: &mut Vec<Fault>| {
        let what = dialect.points.1;
        let ends = dialect.ends.map(|key| {
            let word = row.word(key, &format!("name the {what} at this end"), faults)?;
            find(&word, &by_point, what, row.key(key), faults)
        });
        let word = row.word(dialect.line_type, "name its line type", faults);
        let of_type = word.and_then(|word| {
            let key = row.key(dialect.line_type);
            find(&word, &by_type, "line type", key, faults)
        });
        let length = row.positive(dialect.length, faults);
        let [Some(a), Some(b)] = ends else {
            return None;
        };
        if a.value == b.value {
            let problem = format!("both ends of the line are at the same {what}");
            let key = row.key(dialect.ends[1]);
            faults.push(Fault::new(
                b.span,
                key,
                problem,
                format!("name two {what}s"),
            ));
            return None;
        }
        let at = |end: Given<usize>| Given::new(Attachment::Point(end.value), end.span);
        Some(MooringLine {
            id: name.to_owned(),
            span: row.node.span(),
            of_type: of_type?,
            ends: [at(a), at(b)],
            length: length?,
            segments: Given::new(0, row.node.span()),
            without_bed: None,
        })
    };
    Named::read(&rows, LINE, &path, faults, read).valid()
}
