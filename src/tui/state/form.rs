//! A form: the keys of one table, or the inputs of a template, filled in and taken together.

use tui_input::Input;

use crate::case::fields::{AbsentValue, Field, Schema, ValueType, join};
use crate::case::structure::{OutlineRow, StructureEdit, references};
use crate::templates::Template;

/// What becomes of a form once it is filled in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FormPurpose {
    /// A new table; with a name of its own where it is one of several by name.
    Add {
        /// Its path without the name.
        table: String,
    },
    /// The keys of a table that is there.
    Fill {
        /// Its path.
        path: String,
    },
    /// A copy of a table.
    Copy {
        /// Its path.
        path: String,
    },
    /// Another name.
    Rename {
        /// Its path.
        path: String,
    },
    /// Two in its place.
    Divide {
        /// Its path.
        path: String,
    },
    /// A new file of a template.
    NewFile(&'static Template),
}

/// The key of the line that takes the name of a table.
pub const NAME_OF_TABLE: &str = "(name)";

/// The key of the line that takes the name of a file.
pub const NAME_OF_FILE: &str = "(file)";

/// A line of a form.
#[derive(Debug, Clone)]
pub struct FormLine {
    /// The key that it is for.
    pub key: String,
    /// What it is, in a few words.
    pub label: String,
    /// Unit as shown.
    pub unit: String,
    /// Help, and what may be written.
    pub help: String,
    /// What is typed.
    pub input: Input,
    /// What the file has.
    pub before: String,
    /// What holds where nothing is typed.
    pub absent: String,
    /// Words to choose from.
    pub choices: Vec<String>,
    /// Whether it must be given.
    pub required: bool,
    /// The line and the word of it that this one needs to be there.
    pub only_if: Option<(&'static str, &'static str)>,
}

impl FormLine {
    /// A line that must be filled in.
    #[must_use]
    pub fn required(key: &str, label: &str, value: &str, help: &str) -> Self {
        Self {
            key: key.to_owned(),
            label: label.to_owned(),
            unit: String::new(),
            help: help.to_owned(),
            input: Input::new(value.to_owned()),
            before: String::new(),
            absent: String::new(),
            choices: Vec::new(),
            required: true,
            only_if: None,
        }
    }

    /// What holds: what is typed, or the default.
    #[must_use]
    pub fn value(&self) -> &str {
        match self.input.value().trim() {
            "" => &self.absent,
            typed => typed,
        }
    }
}

/// A form.
#[derive(Debug, Clone)]
pub struct Form {
    /// What is filled in.
    pub title: String,
    /// What becomes of it.
    pub purpose: FormPurpose,
    /// All of its lines.
    pub lines: Vec<FormLine>,
    /// Cursor among the lines shown.
    pub cursor: usize,
    /// Whether lines are shown too that are neither needed nor given.
    pub whole: bool,
    /// Why what was typed is refused; empty where nothing is.
    pub problem: String,
}

impl Form {
    /// A form of one line.
    #[must_use]
    pub fn of_one(title: String, purpose: FormPurpose, line: FormLine) -> Self {
        Self {
            title,
            purpose,
            lines: vec![line],
            cursor: 0,
            whole: true,
            problem: String::new(),
        }
    }

    /// The lines shown, by their numbers: those that exist for what is typed into the others.
    #[must_use]
    pub fn shown(&self) -> Vec<usize> {
        let exists = |line: &FormLine| {
            line.only_if.is_none_or(|(key, word)| {
                let other = self.lines.iter().find(|other| other.key == key);
                other.is_some_and(|other| other.value() == word)
            })
        };
        let is_needed = |line: &FormLine| {
            self.whole || line.required || !line.before.is_empty() || !line.input.value().is_empty()
        };
        let lines = self.lines.iter().enumerate();
        lines
            .filter(|(_, line)| exists(line) && is_needed(line))
            .map(|(number, _)| number)
            .collect()
    }

    /// The line under the cursor.
    #[must_use]
    pub fn current(&self) -> Option<&FormLine> {
        self.lines.get(*self.shown().get(self.cursor)?)
    }

    /// The same, to be typed into.
    pub fn current_mut(&mut self) -> Option<&mut FormLine> {
        let number = *self.shown().get(self.cursor)?;
        self.lines.get_mut(number)
    }

    /// What is typed into the line of a key.
    #[must_use]
    pub fn typed(&self, key: &str) -> Option<&str> {
        let line = self.lines.iter().find(|line| line.key == key)?;
        Some(line.input.value().trim()).filter(|typed| !typed.is_empty())
    }

    /// The edit that the form asks for.
    ///
    /// # Errors
    /// What is still to be filled in.
    pub fn edit(&self) -> Result<StructureEdit, String> {
        let shown = self.shown();
        let lines = || shown.iter().map(|number| &self.lines[*number]);
        if let Some(line) = lines().find(|line| line.required && line.value().is_empty()) {
            return Err(format!("{} is needed: {}", line.label, line.help));
        }
        let name = || self.typed(NAME_OF_TABLE).unwrap_or_default().to_owned();
        Ok(match &self.purpose {
            FormPurpose::Add { table } => {
                let given = lines().filter(|line| !line.key.starts_with('('));
                let typed =
                    given.map(|line| (line.key.clone(), line.input.value().trim().to_owned()));
                StructureEdit::Add {
                    table: table.clone(),
                    name: self.typed(NAME_OF_TABLE).map(str::to_owned),
                    values: typed.filter(|(_, value)| !value.is_empty()).collect(),
                }
            }
            FormPurpose::Fill { path } => {
                let changed = |line: &&FormLine| line.input.value().trim() != line.before;
                let gone =
                    self.lines.iter().enumerate().filter(|(number, line)| {
                        !shown.contains(number) && !line.before.is_empty()
                    });
                let gone = gone.map(|(_, line)| (line.key.clone(), None));
                let values = lines().filter(changed).map(|line| {
                    let value = line.input.value().trim();
                    let value = (!value.is_empty()).then(|| value.to_owned());
                    (line.key.clone(), value)
                });
                StructureEdit::Fill {
                    path: path.clone(),
                    values: values.chain(gone).collect(),
                }
            }
            FormPurpose::Copy { path } => StructureEdit::Copy {
                path: path.clone(),
                name: self.typed(NAME_OF_TABLE).map(str::to_owned),
            },
            FormPurpose::Rename { path } => StructureEdit::Rename {
                path: path.clone(),
                to: name(),
            },
            FormPurpose::Divide { path } => StructureEdit::Divide {
                path: path.clone(),
                at_m: self.typed("at_m").unwrap_or_default().to_owned(),
            },
            FormPurpose::NewFile(_) => return Err("This makes a file, not an edit.".to_owned()),
        })
    }
}

/// The line of a field: with the value of the file, or what the file should be given.
#[must_use]
pub fn line_of(
    schema: &'static Schema,
    text: &str,
    field: &'static Field,
    before: &str,
) -> FormLine {
    let (absent, required) = match field.absent {
        AbsentValue::Default(value) => (value.trim_matches('"').to_owned(), false),
        AbsentValue::Means(_) => (String::new(), false),
        AbsentValue::Required => (String::new(), true),
        AbsentValue::RequiredWithout(_) => (String::new(), true),
    };
    let meaning = match field.absent {
        AbsentValue::Means(meaning) => format!(" Without it: {meaning}."),
        _ => String::new(),
    };
    let condition = field
        .condition()
        .map_or_else(String::new, |words| format!(" {words}."));
    let choices = match field.kind {
        ValueType::Choice(words) => words.iter().map(|word| (*word).to_owned()).collect(),
        ValueType::Boolean => vec!["true".to_owned(), "false".to_owned()],
        _ => references::names(schema, text, &field.path).unwrap_or_default(),
    };
    FormLine {
        key: field.key().to_owned(),
        label: field.label.to_owned(),
        unit: match field.unit {
            "-" => String::new(),
            unit => unit.to_owned(),
        },
        help: format!(
            "{} May be: {}.{meaning}{condition}",
            field.help,
            field.range_text()
        ),
        input: Input::new(before.to_owned()),
        before: before.to_owned(),
        absent,
        choices,
        required: required && !matches!(field.absent, AbsentValue::RequiredWithout(_)),
        only_if: field.only_if,
    }
}

/// The title of a form of a table.
#[must_use]
pub fn title_of(row: &OutlineRow) -> String {
    format!("[{}] {}", row.path, row.help)
}

/// A path with a name behind it.
#[must_use]
pub fn below(path: &str, name: &str) -> String {
    format!("{path}.{}", join(&[name]))
}
