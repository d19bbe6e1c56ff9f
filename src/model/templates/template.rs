//! What a template asks for, and how its file is filled in.

use crate::line_types::{self, LINE_TYPES, nominal_diameter, properties};

/// A number or word that a template asks for.
#[derive(Debug, Clone, Copy)]
pub struct TemplateInput {
    /// What it is known by in the text of the template.
    pub key: &'static str,
    /// What it is, in a few words.
    pub label: &'static str,
    /// Unit; empty for words and pure numbers.
    pub unit: &'static str,
    /// What is proposed.
    pub value: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// Words to choose from.
    pub choices: Choices,
}

/// The words that an input may be.
#[derive(Debug, Clone, Copy)]
pub enum Choices {
    /// A number or text.
    Free,
    /// The names of the library of line types.
    LineTypes,
}

impl Choices {
    /// The words.
    pub fn iter(self) -> impl Iterator<Item = &'static &'static str> {
        let types = LINE_TYPES.iter().map(|line_type| &line_type.name);
        types.filter(move |_| matches!(self, Self::LineTypes))
    }
}

/// A template.
#[derive(Debug, Clone, Copy)]
pub struct Template {
    /// Its name in a word or two.
    pub name: &'static str,
    /// What it makes, in a sentence.
    pub about: &'static str,
    /// What it asks for.
    pub inputs: &'static [TemplateInput],
    /// The text of the file.
    pub(super) make: fn(&Answers<'_>) -> Result<String, String>,
}

impl PartialEq for Template {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Template {}

impl Template {
    /// The text of the file for what was typed, by key; what is left out is as proposed.
    ///
    /// # Errors
    /// What is not a number, out of range, or not a line type, as a full sentence.
    pub fn text(&self, typed: &[(&str, String)]) -> Result<String, String> {
        let answers = Answers {
            inputs: self.inputs,
            typed,
        };
        (self.make)(&answers)
    }
}

/// What was typed for the inputs of a template.
pub(super) struct Answers<'a> {
    pub(super) inputs: &'static [TemplateInput],
    pub(super) typed: &'a [(&'a str, String)],
}

impl Answers<'_> {
    /// What was typed, or what is proposed.
    pub(super) fn text(&self, key: &str) -> &str {
        let typed = self.typed.iter().find(|(known, _)| *known == key);
        let typed = typed
            .map(|(_, text)| text.trim())
            .filter(|text| !text.is_empty());
        let proposed = || {
            let input = self.inputs.iter().find(|input| input.key == key);
            input.map_or("", |input| input.value)
        };
        typed.unwrap_or_else(proposed)
    }

    /// A number within a range.
    pub(super) fn number(&self, key: &str, least: f64, most: f64) -> Result<f64, String> {
        let text = self.text(key);
        let label = self
            .inputs
            .iter()
            .find(|input| input.key == key)
            .map_or(key, |input| input.label);
        let value: Option<f64> = text.parse().ok();
        value
            .filter(|value| (least..=most).contains(value))
            .ok_or_else(|| {
                format!("{label} must be a number from {least} to {most}, and is `{text}`.")
            })
    }

    /// A whole number within a range.
    pub(super) fn count(&self, key: &str, least: u32, most: u32) -> Result<u32, String> {
        let value = self.number(key, f64::from(least), f64::from(most))?;
        match value.fract() == 0.0 {
            true => Ok(value as u32),
            false => Err(format!("{key} must be a whole number, and is {value}.")),
        }
    }

    /// The table of a material of the library, by the answers for its type and its diameter \[mm\], under this name.
    pub(super) fn material(&self, name: &str) -> Result<String, String> {
        let wanted = self.text("line_type");
        let line_type = line_types::find(wanted).ok_or_else(|| {
            format!("There is no line type `{wanted}`; the arrows left and right choose one.")
        })?;
        let diameter = nominal_diameter(&format!("{}mm", self.text("diameter_mm")));
        let line = diameter.and_then(|diameter| properties(line_type, diameter));
        let line = line.map_err(|error| format!("{error}."))?;
        Ok(line_types::material_table(&line, name))
    }

    /// A title in quotes, as TOML writes it.
    pub(super) fn title(&self) -> String {
        toml_edit::Value::from(self.text("title")).to_string()
    }
}

/// A text with the values of its names in braces.
pub(super) fn filled(text: &str, values: &[(&str, String)]) -> String {
    let mut text = text.to_owned();
    for (name, value) in values {
        text = text.replace(&format!("{{{name}}}"), value);
    }
    text
}

/// A number as a file has it.
pub(super) fn number(value: f64) -> String {
    format!("{value:?}")
}

/// The input of a title.
pub(super) const fn title(value: &'static str) -> TemplateInput {
    text(
        "title",
        "title",
        value,
        "What the file is called in lists and reports.",
    )
}

pub(super) const fn text(
    key: &'static str,
    label: &'static str,
    value: &'static str,
    help: &'static str,
) -> TemplateInput {
    TemplateInput {
        key,
        label,
        unit: "",
        value,
        help,
        choices: Choices::Free,
    }
}

pub(super) const fn length(
    key: &'static str,
    label: &'static str,
    value: &'static str,
    help: &'static str,
) -> TemplateInput {
    TemplateInput {
        unit: "m",
        ..text(key, label, value, help)
    }
}

/// The inputs of a line type and its nominal diameter.
pub(super) const fn line_type(value: &'static str) -> TemplateInput {
    TemplateInput {
        choices: Choices::LineTypes,
        ..text(
            "line_type",
            "line type",
            value,
            "Type of the library; left and right choose.",
        )
    }
}

pub(super) const fn diameter(value: &'static str) -> TemplateInput {
    TemplateInput {
        unit: "mm",
        ..text(
            "diameter_mm",
            "nominal diameter",
            value,
            "Of the bar of a chain, of the steel of a wire rope, of a fibre rope.",
        )
    }
}
