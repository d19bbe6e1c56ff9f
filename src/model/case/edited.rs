//! Inputs that are the user's: their values are not those of the file that states them, so neither its marks nor its published
//! values hold for them.

use std::collections::HashMap;

use super::fields::ValueType;
use super::model::Provenance;
use super::replaced_value::{Origin, ReplacedValue, YOURS, same_value, with_unit};
use super::rows::FieldRow;
use super::tree::TomlNode;

/// An input whose value is the user's.
#[derive(Debug, Clone, PartialEq)]
pub struct EditedKey {
    /// Key path.
    pub path: String,
    /// The value now, with its unit; empty where the key is left out.
    pub value: String,
    /// The value in whose place it is.
    pub replaced: ReplacedValue,
}

impl EditedKey {
    /// A key that was set on top of a file, as `key=value`; what the file had is not known.
    #[must_use]
    pub fn set(word: &str) -> Self {
        let (path, value) = word.split_once('=').unwrap_or((word, ""));
        Self {
            path: path.trim().to_owned(),
            value: value.trim().to_owned(),
            replaced: ReplacedValue {
                value: String::new(),
                standing: None,
                origin: Origin::Unknown,
            },
        }
    }

    /// Whether it was set to this value.
    #[must_use]
    pub fn has_value(&self, value: &str) -> bool {
        let bare = self.value.split_whitespace().next();
        bare.is_some_and(|bare| same_value(bare, value))
    }

    /// `current.speed_m_per_s is yours: 0.45 m/s for 0.3 m/s`.
    #[must_use]
    pub fn words(&self) -> String {
        let or_none = |value: &str| match value {
            "" => "none".to_owned(),
            value => value.to_owned(),
        };
        let now = or_none(&self.value);
        let before = match self.replaced.origin {
            Origin::Unknown => String::new(),
            _ => format!(" for {}", or_none(&self.replaced.value)),
        };
        format!("{} is {YOURS}: {now}{before}", self.path)
    }
}

/// The inputs of a file whose values differ from those of `before`, and those whose mark is for another value; `sourced` when
/// what carries no mark is printed in the source of the file.
#[must_use]
pub fn edited(
    rows: &[FieldRow],
    before: &[FieldRow],
    origin: Origin,
    sourced: bool,
) -> Vec<EditedKey> {
    let replaced = |row: &FieldRow| ReplacedValue {
        value: row.value_with_unit(),
        standing: row.provenance(sourced),
        origin,
    };
    // Large systems have a row for every key of thousands of lines.
    let by_path = |rows: &[FieldRow]| -> HashMap<String, usize> {
        let paths = rows.iter().enumerate().rev();
        paths
            .map(|(number, row)| (row.path.clone(), number))
            .collect()
    };
    let (now, olds) = (by_path(rows), by_path(before));
    let changed = rows.iter().filter_map(|row| {
        let old = olds.get(&row.path).map(|number| &before[*number]);
        let replaced = match old {
            Some(old) if same(old, row) => row.replaced.clone()?,
            Some(old) => replaced(old),
            None => ReplacedValue {
                value: String::new(),
                standing: None,
                origin,
            },
        };
        let changed = EditedKey {
            path: row.path.clone(),
            value: row.value_with_unit(),
            replaced,
        };
        // A key of a table that is new matters where it is given.
        (old.is_some() || row.given).then_some(changed)
    });
    let gone = before
        .iter()
        .filter(|old| old.given && !now.contains_key(&old.path))
        .map(|old| EditedKey {
            path: old.path.clone(),
            value: String::new(),
            replaced: replaced(old),
        });
    changed.chain(gone).collect()
}

/// The edited keys among rows that are marked.
#[must_use]
pub fn of_rows(rows: &[FieldRow]) -> Vec<EditedKey> {
    let key = |row: &FieldRow| {
        Some(EditedKey {
            path: row.path.clone(),
            value: row.value_with_unit(),
            replaced: row.replaced.clone()?,
        })
    };
    rows.iter().filter_map(key).collect()
}

/// Marks the rows of edited keys as the user's: what the file says of them is void.
pub fn mark(rows: &mut [FieldRow], edited: &[EditedKey]) {
    for row in rows {
        let of_row = |key: &&EditedKey| {
            let rest = key.path.strip_prefix(row.path.as_str());
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        if let Some(key) = edited.iter().find(of_row) {
            row.standing = None;
            row.replaced = Some(key.replaced.clone());
        }
    }
}

/// Whether a text names its source: what carries no mark is then printed there.
#[must_use]
pub fn is_sourced(text: &str) -> bool {
    let root = TomlNode::parse(text).ok();
    let heads = ["case", "section", "ropeway", "ship"];
    heads.iter().any(|head| {
        let source = root.as_ref().and_then(|root| root.find(&[*head, "source"]));
        source
            .and_then(TomlNode::text)
            .is_some_and(|words| !words.trim().is_empty())
    })
}

fn same(old: &FieldRow, new: &FieldRow) -> bool {
    // What follows from an edited parameter is the user's as well.
    same_value(&old.value, &new.value) && old.computed == new.computed
}

impl FieldRow {
    /// The value with its unit; empty where there is none.
    #[must_use]
    pub fn value_with_unit(&self) -> String {
        match &self.computed {
            Some(number) => format!("{} = {}", with_unit(number, self.unit), self.value),
            None => with_unit(&self.value, self.unit),
        }
    }

    /// The value as a number where it is an expression of parameters, else as the file gives it.
    #[must_use]
    pub fn shown_value(&self) -> &str {
        self.computed.as_deref().unwrap_or(&self.value)
    }

    /// Whether it is a setting of the computation and not an input of the scene.
    #[must_use]
    pub fn is_setting(&self) -> bool {
        let tables = ["solver", "output", "start"];
        tables.iter().any(|table| self.path.starts_with(table))
    }

    /// Where its value comes from, as far as the file says: by its mark or, where the file is `sourced`, printed in the source.
    #[must_use]
    pub fn provenance(&self, sourced: bool) -> Option<Provenance> {
        if let Some(mark) = &self.standing {
            return Some(mark.status);
        }
        let number = !matches!(
            self.field.kind,
            ValueType::Name | ValueType::Text | ValueType::Choice(_) | ValueType::Integer
        );
        let printed = self.given && sourced && number && !self.is_setting();
        (printed && self.replaced.is_none()).then_some(Provenance::Published)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{Case, edit, kind, shipped};

    const TEXT: &str = include_str!("../../../cases/pendulous/manifold.toml");

    fn changed(text: &str, base: &str) -> Vec<EditedKey> {
        let rows = |text: &str| kind::rows::<Case>(text);
        edited(&rows(text), &rows(base), Origin::File, true)
    }

    #[test]
    fn an_edited_input_says_what_the_file_says() {
        let text = edit::set(TEXT, "current.speed_m_per_s", "0.45").unwrap();
        let keys = changed(&text, TEXT);
        let words: Vec<String> = keys.iter().map(EditedKey::words).collect();
        assert_eq!(
            words,
            ["current.speed_m_per_s is yours: 0.45 m/s for 0.3 m/s"]
        );
        assert_eq!(
            keys[0].replaced.words(),
            "yours; the file says 0.3 m/s (published)"
        );
        let mut rows = kind::rows::<Case>(&text);
        mark(&mut rows, &keys);
        let row = rows.iter().find(|row| row.path == "current.speed_m_per_s");
        assert!(row.unwrap().replaced.is_some());
        assert_eq!(row.unwrap().provenance(true), None);
    }

    #[test]
    fn another_spelling_of_a_number_is_no_edit() {
        let text = edit::set(TEXT, "current.speed_m_per_s", "0.30").unwrap();
        assert!(changed(&text, TEXT).is_empty());
    }

    #[test]
    fn a_mark_for_another_value_is_void() {
        let marked = |value: &str| {
            format!(
                "{TEXT}\n[marks.\"current.speed_m_per_s\"]\nstatus = \"calibrated\"\nreason = \"r\"\nvalue = {value}\n"
            )
        };
        let standing = |text: &str| {
            let rows = kind::rows::<Case>(text);
            let row = rows.iter().find(|row| row.path == "current.speed_m_per_s");
            let row = row.unwrap();
            let replaced = row.replaced.as_ref().map(ReplacedValue::words);
            (row.provenance(true), replaced)
        };
        let calibrated = Some(Provenance::Calibrated);
        assert_eq!(standing(&marked("0.3")), (calibrated, None));
        let words = "yours; its mark is for 0.5 m/s (calibrated)".to_owned();
        let void = marked("0.5");
        assert_eq!(standing(&void), (None, Some(words)));
        assert_eq!(changed(&void, &void).len(), 1);
    }

    #[test]
    fn a_copy_of_a_shipped_file_is_known_by_its_title() {
        let copy = edit::set(TEXT, "current.speed_m_per_s", "0.45").unwrap();
        assert_eq!(shipped::of_title(&copy), Some(TEXT));
        assert_eq!(shipped::of_title("[case]\ntitle = \"mine\"\n"), None);
    }

    #[test]
    fn no_two_shipped_files_have_one_title() {
        for (path, text) in shipped::BY_KIND.iter().flat_map(|(_, list)| *list) {
            assert_eq!(shipped::of_title(text), Some(*text), "{path}");
        }
    }
}
