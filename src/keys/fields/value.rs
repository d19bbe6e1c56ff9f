//! One value against its field: type, finiteness, range.

use std::ops::Range as Span;

use super::typed_number::TypedNumber;
use super::words::{LONGEST_NAME, is_name_letter, nearest};
use super::{Field, ValueType, either, number, quantity};
use crate::tree::{TomlData, TomlNode};

/// What is wrong with a value, and where.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueError {
    pub span: Span<usize>,
    pub problem: String,
    pub remedy: String,
}

/// Holds a value against its field.
pub fn check(field: &Field, node: &TomlNode) -> Result<(), ValueError> {
    match field.kind {
        ValueType::Number => one_number(field, node),
        ValueType::Integer => whole_number(field, node),
        ValueType::Boolean => match node.data {
            TomlData::Boolean(_) => Ok(()),
            _ => Err(wrong_type(field, node, "true or false")),
        },
        ValueType::Text => a_text(field, node).map(|_| ()),
        ValueType::Name => name(field, node),
        ValueType::Choice(words) => choice(field, node, words),
        ValueType::NumberOrChoice(words) => match node.data {
            TomlData::Text(_) => choice(field, node, words),
            _ => one_number(field, node),
        },
        ValueType::NumberOrList => match node.data {
            TomlData::List(_) => list(field, node, None),
            _ => one_number(field, node),
        },
        ValueType::NumberOrTriple => match node.data {
            TomlData::List(_) => list(field, node, Some(3)),
            _ => one_number(field, node),
        },
        ValueType::List => list(field, node, None),
        ValueType::Pair => list(field, node, Some(2)),
        ValueType::Triple => list(field, node, Some(3)),
        ValueType::Words => words(field, node),
        ValueType::NumberOrText => match node.data {
            TomlData::Text(_) => Ok(()),
            _ => one_number(field, node),
        },
        ValueType::NumbersOrWords
            if node
                .items()
                .first()
                .is_some_and(|first| first.text().is_some()) =>
        {
            words(field, node)
        }
        ValueType::NumbersOrWords => list(field, node, None),
    }
}

/// A value as the user sees and types it: text without its quotes, anything else as in the file.
pub fn text(file: &str, node: &TomlNode) -> String {
    match node.text() {
        Some(text) => text.to_owned(),
        None => file.get(node.span.clone()).unwrap_or_default().to_owned(),
    }
}

fn fault(node: &TomlNode, problem: impl Into<String>, remedy: impl Into<String>) -> ValueError {
    ValueError {
        span: node.span.clone(),
        problem: problem.into(),
        remedy: remedy.into(),
    }
}

/// A value that its field cannot have, and what it can.
fn unfit(field: &Field, node: &TomlNode, problem: impl Into<String>) -> ValueError {
    fault(node, problem, format!("give {}", field.range_text()))
}

fn wrong_type(field: &Field, node: &TomlNode, wanted: &str) -> ValueError {
    let problem = format!("must be {wanted}, and is {}", node.describe());
    unfit(field, node, problem)
}

fn one_number(field: &Field, node: &TomlNode) -> Result<(), ValueError> {
    let value = match node.data {
        TomlData::Integer(value) => value as f64,
        TomlData::Float(value) => value,
        TomlData::Text(ref text) => return Err(number_in_quotes(field, node, text)),
        _ => return Err(wrong_type(field, node, "a number")),
    };
    if !value.is_finite() {
        let shown = if value.is_nan() { "nan" } else { "inf" };
        let problem = format!("must be a finite number, and is {shown}");
        return Err(unfit(field, node, problem));
    }
    if !field.range.contains(value) {
        let shown = quantity(value, field.unit);
        return Err(unfit(field, node, format!("is out of range: {shown}")));
    }
    Ok(())
}

/// `length_m = "25 m"`: says how to write the number that stands in the text.
fn number_in_quotes(field: &Field, node: &TomlNode, text: &str) -> ValueError {
    let Some(typed) = TypedNumber::read(text, field.unit) else {
        return wrong_type(field, node, "a number");
    };
    let in_unit = match field.unit {
        "" | "-" => String::new(),
        unit => format!(" in {unit}"),
    };
    let (how, value) = match typed {
        TypedNumber::Plain(value) if in_unit.is_empty() => (
            "write it without quotes and without a unit".to_owned(),
            value,
        ),
        TypedNumber::Plain(value) => {
            let how =
                format!("write it without quotes and without a unit, with the value{in_unit}");
            (how, value)
        }
        TypedNumber::Converted(value) => (
            format!("write the value{in_unit}, without quotes and without a unit"),
            value,
        ),
        TypedNumber::Comma(value) => ("write it with a decimal point".to_owned(), value),
        TypedNumber::Computed(value) => (
            "write the result, nothing is computed here".to_owned(),
            value,
        ),
        TypedNumber::UnknownUnit => {
            let remedy = format!("write the value{in_unit}, without quotes and without a unit");
            return fault(node, "must be a number, and is text", remedy);
        }
    };
    let remedy = format!("{how}: {} = {}", field.key(), number(value));
    match typed {
        TypedNumber::Comma(_) | TypedNumber::Computed(_) => {
            let shown = text.trim().escape_default();
            fault(node, format!("is not a number: {shown}"), remedy)
        }
        _ => fault(node, "must be a number, and is text", remedy),
    }
}

fn whole_number(field: &Field, node: &TomlNode) -> Result<(), ValueError> {
    match node.data {
        TomlData::Integer(value) if field.range.contains(value as f64) => Ok(()),
        TomlData::Integer(value) => Err(unfit(field, node, format!("is out of range: {value}"))),
        TomlData::Float(value) if !value.is_finite() => one_number(field, node),
        TomlData::Float(_) => Err(wrong_type(
            field,
            node,
            "a whole number without a decimal point",
        )),
        _ => Err(wrong_type(field, node, "a whole number")),
    }
}

fn a_text<'a>(field: &Field, node: &'a TomlNode) -> Result<&'a str, ValueError> {
    node.text()
        .ok_or_else(|| wrong_type(field, node, "text in quotes"))
}

fn name(field: &Field, node: &TomlNode) -> Result<(), ValueError> {
    let text = a_text(field, node)?;
    if !text.is_empty() && text.chars().all(is_name_letter) {
        // It stands in the name of every channel of its part.
        let length = text.chars().count();
        return match length > LONGEST_NAME {
            true => Err(fault(
                node,
                format!("is a name of {length} characters"),
                format!("give at most {LONGEST_NAME}"),
            )),
            false => Ok(()),
        };
    }
    let problem = format!("is not a usable name: \"{}\"", text.escape_default());
    Err(fault(
        node,
        problem,
        format!(
            "give {}, it becomes part of channel names",
            field.range_text()
        ),
    ))
}

fn choice(field: &Field, node: &TomlNode, words: &[&str]) -> Result<(), ValueError> {
    let text = a_text(field, node)?;
    if words.contains(&text) {
        return Ok(());
    }
    let remedy = match nearest(text, words.iter().copied()) {
        Some(near) => format!(
            "did you mean \"{near}\"? Known are {}",
            either(words).replace(" or ", " and ")
        ),
        None => format!("give {}", field.range_text()),
    };
    Err(fault(
        node,
        format!("is not known: \"{}\"", text.escape_default()),
        remedy,
    ))
}

fn list(field: &Field, node: &TomlNode, count: Option<usize>) -> Result<(), ValueError> {
    let TomlData::List(items) = &node.data else {
        return Err(wrong_type(field, node, "a list of numbers in brackets"));
    };
    let wrong_count = count.filter(|count| *count != items.len());
    if let Some(count) = wrong_count {
        let problem = format!("must hold {count} numbers, and holds {}", items.len());
        return Err(unfit(field, node, problem));
    }
    if items.is_empty() {
        return Err(unfit(field, node, "is an empty list"));
    }
    items.iter().try_for_each(|item| one_number(field, item))
}

fn words(field: &Field, node: &TomlNode) -> Result<(), ValueError> {
    let TomlData::List(items) = &node.data else {
        return Err(wrong_type(field, node, "a list of words in brackets"));
    };
    if items.is_empty() {
        return Err(unfit(field, node, "is an empty list"));
    }
    items
        .iter()
        .try_for_each(|item| a_text(field, item).map(|_| ()))
}
