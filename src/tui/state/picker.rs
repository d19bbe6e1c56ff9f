//! A list to choose one thing from, narrowed by what is typed.

use tui_input::Input;

use crate::fuzzy::{FuzzyFilter, Looking};
use crate::templates::Template;

/// What is chosen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Choice {
    /// A new table at this path.
    Table(String),
    /// A line type of the library, as a material.
    LineType,
    /// A named parameter.
    Parameter,
    /// A file of a template.
    File(&'static Template),
}

/// A thing to choose.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PickerItem {
    /// What it is.
    pub name: String,
    /// What it is for.
    pub help: String,
    /// What follows.
    pub choice: Choice,
}

/// A list to choose from.
#[derive(Debug, Clone)]
pub struct Picker {
    /// What is chosen, and the keys for it.
    pub title: String,
    /// All of its items.
    pub items: Vec<PickerItem>,
    /// What is typed.
    pub input: Input,
    /// Cursor among the items that pass.
    pub cursor: usize,
}

impl Picker {
    /// A list with nothing typed.
    #[must_use]
    pub fn new(title: &str, items: Vec<PickerItem>) -> Self {
        Self {
            title: title.to_owned(),
            items,
            input: Input::default(),
            cursor: 0,
        }
    }

    /// The items that hold every word typed.
    #[must_use]
    pub fn shown(&self) -> Vec<&PickerItem> {
        let filter = FuzzyFilter::new(self.input.value());
        let lines = self.items.iter().map(|item| vec![&item.name, &item.help]);
        let places = filter.places(&lines.collect::<Vec<_>>());
        let mut found: Vec<&PickerItem> = places.iter().map(|at| &self.items[*at]).collect();
        // Names before what is only said of others.
        let typed = self.input.value().to_lowercase();
        found.sort_by_key(|item| {
            let name = item.name.to_lowercase();
            let last = name.rsplit(" > ").next().unwrap_or(&name);
            match () {
                () if last == typed => 0,
                () if last.starts_with(&typed) => 1,
                () if filter.passes(&[&name], Looking::Words) => 2,
                () => 3,
            }
        });
        found
    }
}
