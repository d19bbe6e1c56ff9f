//! Every field a case can have: unit, range, default, help. The one source for the checks, the
//! parameter editor and the printed reference.
//!
//! A field is known by a path pattern in which `*` stands for a name the user chose:
//! `materials.*.ea_n`, `line.*.length_m` (sections by their `name`), `floats.*.lift_kg` (by their
//! `section`), `ends.*.kind`. A coordinate of a position goes by its letter: `ends.b.position_m.x`.

mod json_schema;
mod range;
mod rows;
mod tables;
mod value;
mod words;

use std::sync::LazyLock;

use super::model::Case;
use super::schema::{Declared, TableType};
pub use json_schema::json_schema;
pub use range::Range;
pub(crate) use range::{number, of, positive, quantity};
pub(crate) use rows::Lister;
pub use rows::{FieldRow, rows};
pub use tables::{Table, TableShape};
pub(crate) use value::{check as check_value, text as value_text};
pub(crate) use words::{join, nearest, split, unknown_key};

/// A kind of file: what it is called, and every table and field it can have.
#[derive(Debug, Clone, PartialEq)]
pub struct Schema {
    /// What a file of this kind is, in a word: "case".
    pub what: &'static str,
    /// What it holds at the least, as a sentence for somebody with an empty one.
    pub least: &'static str,
    /// Its fields.
    pub fields: Vec<Field>,
    /// The numbers within values that can be set one by one.
    pub parts: Vec<Field>,
    /// Its tables.
    pub tables: Vec<Table>,
}

/// The case file.
pub static CASE: LazyLock<Schema> = LazyLock::new(|| {
    let least = "a case has at least [case], [materials.<name>], [[line]] and [ends.a], [ends.b]";
    Schema::of::<Case>("case", least).with_coordinates("ends.*.position_m")
});

impl Schema {
    /// The schema of a kind of file, of the declaration of its tables.
    pub(crate) fn of<T: TableType>(what: &'static str, least: &'static str) -> Self {
        let mut declared = Declared::default();
        T::declare("", &mut declared);
        Self {
            what,
            least,
            fields: declared.fields,
            parts: Vec::new(),
            tables: declared.tables,
        }
    }

    /// The same, with key paths for each coordinate of a field that takes three.
    fn with_coordinates(mut self, path: &str) -> Self {
        let whole = self.fields.iter().find(|field| field.path == path);
        let parts = whole.map_or_else(Vec::new, |whole| {
            let parts = [
                ("x", "position x"),
                ("y", "position y"),
                ("z", "position z"),
            ];
            let part = |(axis, label)| Field {
                path: format!("{path}.{axis}"),
                label,
                kind: Kind::Number,
                absent: Absent::Required,
                help: "Coordinate of the position.",
                ..whole.clone()
            };
            parts.map(part).to_vec()
        });
        self.parts = parts;
        self
    }

    /// The fields of a table, by the table's pattern.
    pub fn fields_of(&'static self, table: &str) -> impl Iterator<Item = &'static Field> {
        self.fields
            .iter()
            .filter(move |field| field.table() == table)
    }

    /// The tables that stand in a table of this pattern.
    pub fn tables_in(&'static self, pattern: &str) -> impl Iterator<Item = &'static Table> {
        self.tables
            .iter()
            .filter(move |table| match table.path.rsplit_once('.') {
                Some((parent, _)) => parent == pattern,
                None => pattern.is_empty(),
            })
    }

    /// The fields that a key path may mean; more than one where tables of several kinds share a key.
    pub fn fields_at<S: AsRef<str>>(
        &'static self,
        path: &[S],
    ) -> impl Iterator<Item = &'static Field> {
        self.fields
            .iter()
            .chain(self.parts.iter())
            .filter(move |field| {
                let mut pattern = field.path.split('.');
                let same = path.iter().all(|part| {
                    pattern
                        .next()
                        .is_some_and(|p| p == "*" || p == part.as_ref())
                });
                same && pattern.next().is_none()
            })
    }
}

/// A key of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Path pattern: `materials.*.ea_n`.
    pub path: String,
    /// What it is, in a few words.
    pub label: &'static str,
    /// What may be written.
    pub kind: Kind,
    /// Unit as shown; empty for words, "-" for pure numbers.
    pub unit: &'static str,
    /// Range of every number in it.
    pub range: Range,
    /// What holds when the key is absent.
    pub absent: Absent,
    /// One line of help.
    pub help: &'static str,
    /// A key of the same table and the value it needs for this field to exist: the dimensions of a
    /// payload's shape depend on its `kind`.
    pub only_if: Option<(&'static str, &'static str)>,
    /// Keys of the same table and the words of which each must be one for this field to have an effect: the motion of an
    /// end that does not move has no period. Such a key may be given all the same.
    pub matters: Needs,
}

/// What a key needs: each of these keys of its table, as one of these words.
pub type Needs = &'static [(&'static str, &'static [&'static str])];

/// What may be written for a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number,
    /// A whole number.
    Integer,
    /// `true` or `false`.
    Boolean,
    /// Text.
    Text,
    /// Text of letters, digits, `-` and `_`: it becomes part of channel names and key paths.
    Name,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A number, or one of these words.
    NumberOrChoice(&'static [&'static str]),
    /// A number, or a list of numbers.
    NumberOrList,
    /// A number, or one for each of x, y, z.
    NumberOrTriple,
    /// A list of numbers.
    List,
    /// Two numbers.
    Pair,
    /// Three numbers, along x, y, z.
    Triple,
    /// A list of words.
    Words,
    /// A number, or text.
    NumberOrText,
    /// A list of numbers, or of words.
    NumbersOrWords,
}

impl Kind {
    /// Whether it is made of numbers.
    fn holds_numbers(self) -> bool {
        !matches!(
            self,
            Self::Boolean
                | Self::Text
                | Self::Name
                | Self::Choice(_)
                | Self::Words
                | Self::NumberOrText
                | Self::NumbersOrWords
        )
    }
}

/// What holds when a key is absent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Absent {
    /// The key must be there.
    Required,
    /// The key must be there unless this other one of its table is, which says the same in another way.
    RequiredWithout(&'static str),
    /// This value, written as in a case file.
    Default(&'static str),
    /// Something else, in words.
    Means(&'static str),
}

/// A field as it is declared, piece by piece.
impl Field {
    /// A required field without a range, known by its key alone; its unit is the one in which the key ends.
    pub(crate) fn new(
        key: &'static str,
        kind: Kind,
        label: &'static str,
        help: &'static str,
    ) -> Self {
        let unit = match unit_of_key(key) {
            Some(unit) if kind.holds_numbers() => unit,
            None if kind.holds_numbers() => "-",
            _ => "",
        };
        Self {
            path: key.to_owned(),
            label,
            kind,
            unit,
            range: Range::ANY,
            absent: Absent::Required,
            help,
            only_if: None,
            matters: &[],
        }
    }

    /// The same field in tables of this pattern.
    pub(crate) fn below(&self, pattern: &str) -> Self {
        let mut field = self.clone();
        if !pattern.is_empty() {
            field.path = format!("{pattern}.{}", self.path);
        }
        field
    }

    pub(crate) fn default(mut self, text: &'static str) -> Self {
        self.absent = Absent::Default(text);
        self
    }

    pub(crate) fn kind(mut self, kind: Kind) -> Self {
        self.kind = kind;
        self
    }

    pub(crate) fn unit(mut self, unit: &'static str) -> Self {
        self.unit = unit;
        self
    }

    pub(crate) fn range(mut self, range: Range) -> Self {
        self.range = range;
        self
    }

    pub(crate) fn absent(mut self, means: &'static str) -> Self {
        self.absent = Absent::Means(means);
        self
    }

    pub(crate) fn unless(mut self, other: &'static str) -> Self {
        self.absent = Absent::RequiredWithout(other);
        self
    }

    pub(crate) fn only(mut self, tag: (&'static str, &'static str)) -> Self {
        self.only_if = Some(tag);
        self
    }

    pub(crate) fn matters(mut self, needs: Needs) -> Self {
        self.matters = needs;
        self
    }
}

impl Field {
    /// The last part of the path: the key itself.
    #[must_use]
    pub fn key(&self) -> &str {
        self.path.rsplit('.').next().unwrap_or(&self.path)
    }

    /// The pattern of the table it stands in.
    #[must_use]
    pub fn table(&self) -> &str {
        self.path.rsplit_once('.').map_or("", |(table, _)| table)
    }

    /// The key without its unit: `length` for `length_m`.
    #[must_use]
    pub fn stem(&self) -> &str {
        let key = self.key();
        unit_suffix(self.unit)
            .and_then(|suffix| key.strip_suffix(suffix)?.strip_suffix('_'))
            .unwrap_or(key)
    }

    /// What may be written, with range and unit, for people: "greater than 0 m, up to 1e5 m".
    #[must_use]
    pub fn range_text(&self) -> String {
        let numbers = self.range.text(self.unit);
        match self.kind {
            Kind::Number => numbers,
            Kind::Integer => self.range.whole_text(),
            Kind::Boolean => "true or false".to_owned(),
            Kind::Text => "text".to_owned(),
            Kind::Name => "a name of letters, digits, - and _".to_owned(),
            Kind::Choice(words) => either(words),
            Kind::NumberOrChoice(words) => format!("{numbers}; or {}", either(words)),
            Kind::NumberOrList => format!("{numbers}; or a list of such numbers"),
            Kind::NumberOrTriple => format!("{numbers}; or three such numbers, along x, y, z"),
            Kind::List => format!("a list, each {numbers}"),
            Kind::Pair => format!("two numbers, each {numbers}"),
            Kind::Triple => format!("three numbers along x, y, z, each {numbers}"),
            Kind::Words => "a list of words in quotes".to_owned(),
            Kind::NumberOrText => format!("{numbers}; or a word in quotes"),
            Kind::NumbersOrWords => {
                format!("a list, each {numbers}; or a list of words in quotes")
            }
        }
    }

    /// What holds when the key is absent, in words: "required", "default 0.4".
    #[must_use]
    pub fn absent_text(&self) -> String {
        match self.absent {
            Absent::Required => "required".to_owned(),
            Absent::RequiredWithout(other) => format!("required without {other}"),
            Absent::Default("\"\"") => "default: empty".to_owned(),
            Absent::Default(value) => format!("default {value}"),
            Absent::Means(meaning) => format!("without it: {meaning}"),
        }
    }

    /// Where the key exists or has an effect, if not everywhere: "only where kind is `box`".
    #[must_use]
    pub fn condition(&self) -> Option<String> {
        if let Some((key, word)) = self.only_if {
            return Some(format!("only where {key} is `{word}`"));
        }
        let words = self.matters.iter();
        let words = words.map(|(key, words)| format!("{key} is {}", either(words)));
        let words: Vec<String> = words.collect();
        (!words.is_empty()).then(|| format!("matters only where {}", words.join(" and ")))
    }

    /// True when the value is text, so that a bare word typed by the user is meant as text.
    #[must_use]
    pub fn takes_words(&self) -> bool {
        matches!(
            self.kind,
            Kind::Text | Kind::Name | Kind::Choice(_) | Kind::NumberOrChoice(_)
        )
    }

    /// True when one number may be written, so that a study can vary the field.
    #[must_use]
    pub fn takes_number(&self) -> bool {
        matches!(
            self.kind,
            Kind::Number
                | Kind::Integer
                | Kind::NumberOrChoice(_)
                | Kind::NumberOrList
                | Kind::NumberOrTriple
        )
    }
}

/// The field of a key path given as its parts, if there is one; `ends.b.position_m.x` is a number of its own.
#[must_use]
pub fn field_at<S: AsRef<str>>(path: &[S]) -> Option<&'static Field> {
    CASE.fields_at(path).next()
}

/// The fields of a table of the case file, by the table's pattern.
pub fn fields_of(table: &str) -> impl Iterator<Item = &'static Field> {
    CASE.fields_of(table)
}

/// Keys end in this when their value has the unit: `m` for metres, `kg_per_m` for kg/m.
#[must_use]
pub fn unit_suffix(unit: &str) -> Option<&'static str> {
    UNITS
        .iter()
        .find(|(shown, _)| *shown == unit)
        .map(|(_, suffix)| *suffix)
}

/// The unit of a key, by its end: the longest that fits.
fn unit_of_key(key: &str) -> Option<&'static str> {
    let ends = |(_, suffix): &&(&str, &str)| {
        let stem = key.strip_suffix(suffix);
        stem.is_some_and(|stem| stem.is_empty() || stem.ends_with('_'))
    };
    let fitting = UNITS.iter().filter(ends);
    fitting
        .max_by_key(|(_, suffix)| suffix.len())
        .map(|(unit, _)| *unit)
}

/// Units as shown, and as they stand in key names.
const UNITS: &[(&str, &str)] = &[
    ("m", "m"),
    ("s", "s"),
    ("N", "n"),
    ("kg", "kg"),
    ("deg", "deg"),
    ("m/s", "m_per_s"),
    ("deg/s", "deg_per_s"),
    ("deg/s²", "deg_per_s2"),
    ("m/s²", "m_per_s2"),
    ("m²", "m2"),
    ("m³", "m3"),
    ("m²/s", "m2_per_s"),
    ("kg/m", "kg_per_m"),
    ("kg m²", "kg_m2"),
    ("Hz", "hz"),
    ("kg/m³", "kg_per_m3"),
    ("N s", "n_s"),
    ("N m²", "n_m2"),
    ("N/m³", "n_per_m3"),
    ("N s/m³", "n_s_per_m3"),
    ("Pa", "pa"),
    ("W", "w"),
];

/// A few words as a sentence.
fn capital(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(char::to_uppercase);
    format!(
        "{}{}.",
        first.into_iter().flatten().collect::<String>(),
        letters.as_str()
    )
}

/// "a, b or c", each in backquotes.
pub(crate) fn either(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    match quoted.split_last() {
        None => "nothing".to_owned(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_finds_its_field() {
        let field = field_at(&["line", "polyester", "length_m"]).unwrap();
        assert_eq!(field.path, "line.*.length_m");
        assert_eq!(field.stem(), "length");
        assert!(field_at(&["line", "polyester"]).is_none());
        assert!(field_at(&["line", "a", "b", "length_m"]).is_none());
    }

    #[test]
    fn a_coordinate_is_a_number_in_the_range_of_its_position() {
        let field = field_at(&["ends", "b", "position_m", "y"]).unwrap();
        let whole = field_at(&["ends", "b", "position_m"]).unwrap();
        assert!(field.takes_number() && !whole.takes_number());
        assert_eq!((field.range, field.unit), (whole.range, whole.unit));
        assert!(field_at(&["ends", "b", "position_m", "w"]).is_none());
    }

    /// The schemas of all kinds of file.
    fn all() -> [&'static Schema; 4] {
        use crate::{ropeway, section, ship};
        [
            &CASE,
            &section::model::SECTION,
            &ropeway::model::ROPEWAY,
            &ship::SHIP,
        ]
    }

    #[test]
    fn every_unit_stands_in_its_key() {
        for field in all().iter().flat_map(|schema| schema.fields.iter()) {
            match unit_suffix(field.unit) {
                Some(suffix) => assert!(field.key().ends_with(suffix), "{}", field.path),
                None => assert!(matches!(field.unit, "" | "-"), "{}", field.path),
            }
        }
    }

    #[test]
    fn every_field_stands_in_a_known_table() {
        for (schema, field) in all()
            .iter()
            .flat_map(|s| s.fields.iter().map(move |f| (s, f)))
        {
            let known = schema
                .tables
                .iter()
                .any(|table| field.table() == table.pattern());
            assert!(known, "{}", field.path);
        }
    }
}
