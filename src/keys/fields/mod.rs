//! Every field a case can have: unit, range, default, help. The one source for the checks, the
//! parameter editor and the printed reference.
//!
//! A field is known by a path pattern in which `*` stands for a name the user chose:
//! `materials.*.ea_n`, `line.*.length_m` (sections by their `name`), `floats.*.lift_kg` (by their
//! `section`), `ends.*.kind`. A coordinate of a position goes by its letter: `ends.b.position_m.x`.

mod field;
mod json_schema;
pub mod parameters_table;
mod range;
mod tables;
mod typed_number;
mod value;
mod words;

pub use field::{AbsentValue, Conditions, Field, ValueType, either, in_words, unit_suffix};
pub use json_schema::json_schema;
pub use range::{Range, number, of, positive, quantity};
pub use tables::{TableSchema, TableShape};
pub use typed_number::TypedNumber;
pub use value::{check as check_value, text as value_text};
pub use words::{is_name, join, nearest, split, unknown_key};

/// A kind of file: what it is called, and every table and field it can have.
#[derive(Debug, Clone, PartialEq)]
pub struct Schema {
    /// What a file of this kind is, in a word: "case".
    pub what: &'static str,
    /// What it holds at the least, as a sentence for somebody with an empty one.
    pub least: &'static str,
    /// How a key is named, as a remedy.
    pub example: &'static str,
    /// Its fields.
    pub fields: Vec<Field>,
    /// The numbers within values that can be set one by one.
    pub parts: Vec<Field>,
    /// Its tables.
    pub tables: Vec<TableSchema>,
    /// Keys that tables do not have for a reason.
    pub absent: &'static [AbsentKey],
}

/// A key that other tables have and this one does not, for a reason that its name does not tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AbsentKey {
    /// The pattern of the table: `points.*`.
    pub table: &'static str,
    /// The key.
    pub key: &'static str,
    /// Why the table does not have it, as a predicate: "goes along ...".
    pub problem: &'static str,
    /// What would be right.
    pub remedy: &'static str,
}

/// Labels and help of the coordinates of a position.
pub const POSITION: ([&str; 3], &str) = (
    ["position x", "position y", "position z"],
    "Coordinate of the position.",
);

impl Schema {
    /// The same, with key paths for each coordinate of a field that takes three.
    pub fn with_coordinates(
        mut self,
        path: &str,
        labels: [&'static str; 3],
        help: &'static str,
    ) -> Self {
        if let Some(whole) = self.fields.iter().find(|field| field.path == path) {
            let part = |(axis, label): (&str, &'static str)| Field {
                path: format!("{path}.{axis}"),
                label,
                kind: ValueType::Number,
                absent: AbsentValue::Required,
                help,
                ..whole.clone()
            };
            let parts: Vec<Field> = ["x", "y", "z"].into_iter().zip(labels).map(part).collect();
            self.parts.extend(parts);
        }
        self
    }

    /// The same, with keys of its own as an example of how keys are named.
    #[must_use]
    pub fn with_example(self, example: &'static str) -> Self {
        Self { example, ..self }
    }

    /// The same, of files that may have named parameters.
    pub fn with_parameters(mut self) -> Self {
        // Behind the table that says what the file is.
        self.tables
            .insert(1.min(self.tables.len()), parameters_table::table());
        self.fields.push(parameters_table::field());
        self
    }

    /// The same, with keys that tables do not have for a reason.
    #[must_use]
    pub fn without_keys(mut self, absent: &'static [AbsentKey]) -> Self {
        self.absent = absent;
        self
    }

    /// The fields of a table, by the table's pattern.
    pub fn fields_of(&'static self, table: &str) -> impl Iterator<Item = &'static Field> {
        self.fields
            .iter()
            .filter(move |field| stands_in(&field.path, table))
    }

    /// The tables that stand in a table of this pattern.
    pub fn tables_in(&'static self, pattern: &str) -> impl Iterator<Item = &'static TableSchema> {
        self.tables
            .iter()
            .filter(move |table| stands_in(&table.path, pattern))
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

/// Whether a path is a key of this table, not of a table within it. Asked of all paths for every table of a file: most differ
/// from the first letter on.
fn stands_in(path: &str, table: &str) -> bool {
    let key = match table {
        "" => Some(path),
        _ => path
            .strip_prefix(table)
            .and_then(|rest| rest.strip_prefix('.')),
    };
    key.is_some_and(|key| !key.contains('.'))
}
