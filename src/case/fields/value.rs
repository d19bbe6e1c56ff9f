//! One value against its field: type, finiteness, range.

use std::ops::Range as Span;

use super::words::{is_name_letter, nearest};
use super::{Field, Kind, either, number, quantity};
use crate::case::tree::{Data, Node};

/// What is wrong with a value, and where.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fault {
    pub(crate) span: Span<usize>,
    pub(crate) problem: String,
    pub(crate) remedy: String,
}

/// Holds a value against its field.
pub(crate) fn check(field: &Field, node: &Node) -> Result<(), Fault> {
    match field.kind {
        Kind::Number => one_number(field, node),
        Kind::Integer => whole_number(field, node),
        Kind::Boolean => match node.data {
            Data::Boolean(_) => Ok(()),
            _ => Err(wrong_type(field, node, "true or false")),
        },
        Kind::Text => a_text(field, node).map(|_| ()),
        Kind::Name => name(field, node),
        Kind::Choice(words) => choice(field, node, words),
        Kind::NumberOrChoice(words) => match node.data {
            Data::Text(_) => choice(field, node, words),
            _ => one_number(field, node),
        },
        Kind::NumberOrList => match node.data {
            Data::List(_) => list(field, node, None),
            _ => one_number(field, node),
        },
        Kind::NumberOrTriple => match node.data {
            Data::List(_) => list(field, node, Some(3)),
            _ => one_number(field, node),
        },
        Kind::List => list(field, node, None),
        Kind::Pair => list(field, node, Some(2)),
        Kind::Triple => list(field, node, Some(3)),
        Kind::Words => words(field, node),
        Kind::NumberOrText => match node.data {
            Data::Text(_) => Ok(()),
            _ => one_number(field, node),
        },
        Kind::NumbersOrWords
            if node
                .items()
                .first()
                .is_some_and(|first| first.text().is_some()) =>
        {
            words(field, node)
        }
        Kind::NumbersOrWords => list(field, node, None),
    }
}

/// A value as the user sees and types it: text without its quotes, anything else as in the file.
pub(crate) fn text(file: &str, node: &Node) -> String {
    match node.text() {
        Some(text) => text.to_owned(),
        None => file.get(node.span.clone()).unwrap_or_default().to_owned(),
    }
}

fn fault(node: &Node, problem: impl Into<String>, remedy: impl Into<String>) -> Fault {
    Fault {
        span: node.span.clone(),
        problem: problem.into(),
        remedy: remedy.into(),
    }
}

fn wrong_type(field: &Field, node: &Node, wanted: &str) -> Fault {
    let problem = format!("must be {wanted}, and is {}", node.describe());
    fault(node, problem, format!("give {}", field.range_text()))
}

fn one_number(field: &Field, node: &Node) -> Result<(), Fault> {
    let value = match node.data {
        Data::Integer(value) => value as f64,
        Data::Float(value) => value,
        Data::Text(ref text) => return Err(number_in_quotes(field, node, text)),
        _ => return Err(wrong_type(field, node, "a number")),
    };
    let wanted = format!("give {}", field.range_text());
    if !value.is_finite() {
        let shown = if value.is_nan() { "nan" } else { "inf" };
        return Err(fault(
            node,
            format!("must be a finite number, and is {shown}"),
            wanted,
        ));
    }
    if !field.range.contains(value) {
        let shown = quantity(value, field.unit);
        return Err(fault(node, format!("is out of range: {shown}"), wanted));
    }
    Ok(())
}

/// `length_m = "25 m"`: says how to write the number that stands in the text.
fn number_in_quotes(field: &Field, node: &Node, text: &str) -> Fault {
    let digits = text
        .trim()
        .trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.');
    let Ok(value) = digits.parse::<f64>() else {
        return wrong_type(field, node, "a number");
    };
    let in_unit = match field.unit {
        "" | "-" => String::new(),
        unit => format!(", with the value in {unit}"),
    };
    let remedy = format!(
        "write it without quotes and without a unit{in_unit}: {} = {}",
        field.key(),
        number(value)
    );
    fault(node, "must be a number, and is text", remedy)
}

fn whole_number(field: &Field, node: &Node) -> Result<(), Fault> {
    match node.data {
        Data::Integer(value) if field.range.contains(value as f64) => Ok(()),
        Data::Integer(value) => Err(fault(
            node,
            format!("is out of range: {value}"),
            format!("give {}", field.range_text()),
        )),
        Data::Float(value) if !value.is_finite() => one_number(field, node),
        Data::Float(_) => Err(wrong_type(
            field,
            node,
            "a whole number without a decimal point",
        )),
        _ => Err(wrong_type(field, node, "a whole number")),
    }
}

fn a_text<'a>(field: &Field, node: &'a Node) -> Result<&'a str, Fault> {
    node.text()
        .ok_or_else(|| wrong_type(field, node, "text in quotes"))
}

fn name(field: &Field, node: &Node) -> Result<(), Fault> {
    let text = a_text(field, node)?;
    if !text.is_empty() && text.chars().all(is_name_letter) {
        return Ok(());
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

fn choice(field: &Field, node: &Node, words: &[&str]) -> Result<(), Fault> {
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

fn list(field: &Field, node: &Node, count: Option<usize>) -> Result<(), Fault> {
    let Data::List(items) = &node.data else {
        return Err(wrong_type(field, node, "a list of numbers in brackets"));
    };
    let wrong_count = count.filter(|count| *count != items.len());
    if let Some(count) = wrong_count {
        let problem = format!("must hold {count} numbers, and holds {}", items.len());
        return Err(fault(node, problem, format!("give {}", field.range_text())));
    }
    if items.is_empty() {
        return Err(fault(
            node,
            "is an empty list",
            format!("give {}", field.range_text()),
        ));
    }
    items.iter().try_for_each(|item| one_number(field, item))
}

fn words(field: &Field, node: &Node) -> Result<(), Fault> {
    let Data::List(items) = &node.data else {
        return Err(wrong_type(field, node, "a list of words in brackets"));
    };
    if items.is_empty() {
        return Err(fault(
            node,
            "is an empty list",
            format!("give {}", field.range_text()),
        ));
    }
    items
        .iter()
        .try_for_each(|item| a_text(field, item).map(|_| ()))
}
