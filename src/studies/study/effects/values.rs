//! The numbers that the value of a key holds, and the value with some of them changed.

use crate::case::TomlNode;
use crate::case::fields::{ValueType, number};

/// Axes of values with three numbers.
const AXES: [&str; 3] = ["x", "y", "z"];

/// A number of a key, or all numbers of its list together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct KeyNumber {
    /// `.x` of three coordinates; empty for the whole value.
    pub(super) suffix: String,
    /// The number; of a list its greatest by size.
    pub(super) value: f64,
    numbers: Vec<f64>,
    /// The number's place in the list; absent where all are scaled together.
    place: Option<usize>,
    is_list: bool,
}

impl KeyNumber {
    /// The value of the key with this number changed, as in a file; a list that varies as a whole is scaled.
    pub(super) fn written(&self, value: f64) -> String {
        let scaled = |(place, old): (usize, &f64)| match self.place {
            Some(own) if own == place => value,
            Some(_) => *old,
            None => old * value / self.value,
        };
        let numbers: Vec<String> = self
            .numbers
            .iter()
            .enumerate()
            .map(scaled)
            .map(number)
            .collect();
        match self.is_list {
            true => format!("[{}]", numbers.join(", ")),
            false => numbers.concat(),
        }
    }

    /// Whether the value is a list that varies as a whole.
    pub(super) fn is_scaled_list(&self) -> bool {
        self.is_list && self.place.is_none()
    }
}

/// The numbers of a value that vary: one; each of three coordinates; all of a list together. None where it is a word.
pub(super) fn parts(text: &str, kind: ValueType) -> Vec<KeyNumber> {
    let Some(node) = TomlNode::parse_value(text) else {
        return Vec::new();
    };
    if let Some(value) = node.number() {
        return vec![KeyNumber {
            suffix: String::new(),
            value,
            numbers: vec![value],
            place: Some(0),
            is_list: false,
        }];
    }
    let Some(numbers) = node.numbers().filter(|numbers| !numbers.is_empty()) else {
        return Vec::new();
    };
    let part = |suffix: &str, value: f64, place: Option<usize>| KeyNumber {
        suffix: suffix.to_owned(),
        value,
        numbers: numbers.clone(),
        place,
        is_list: true,
    };
    if matches!(kind, ValueType::Triple | ValueType::NumberOrTriple) && numbers.len() == 3 {
        let each = AXES.iter().zip(&numbers).enumerate();
        return each
            .map(|(place, (axis, value))| part(&format!(".{axis}"), *value, Some(place)))
            .collect();
    }
    let greatest = numbers
        .iter()
        .copied()
        .reduce(|a, b| if b.abs() > a.abs() { b } else { a });
    greatest
        .map(|value| part("", value, None))
        .into_iter()
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_coordinates_and_lists() {
        let one = &parts("3.5e2", ValueType::Number)[0];
        assert_eq!((one.value, one.written(400.0).as_str()), (350.0, "400"));
        let three = parts("[0.0, -2.0, 5]", ValueType::Triple);
        assert_eq!(three.len(), 3);
        assert_eq!((three[1].suffix.as_str(), three[1].value), (".y", -2.0));
        assert_eq!(three[1].written(-2.2), "[0, -2.2, 5]");
        let list = &parts("[0.5, 1.0]", ValueType::NumberOrList)[0];
        assert!(list.is_scaled_list());
        assert_eq!(list.written(1.1), "[0.55, 1.1]");
        assert!(parts("word", ValueType::NumberOrChoice(&["word"])).is_empty());
    }
}
