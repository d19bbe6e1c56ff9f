//! The inputs of a case as keys with values, and what of them differs between two texts.

use std::collections::BTreeMap;

use crate::case::{NO_INPUTS, TextDigest};
use crate::files::shallow::shallow;

/// Inputs by key: `line.polyester.length_m` and `1326`.
pub(super) type Inputs = BTreeMap<String, String>;

/// Longer values, such as tables of a motion, are known by their digest.
const LONGEST: usize = 100;

/// The inputs of a text; none where it is no TOML.
pub(super) fn inputs(text: &str) -> Inputs {
    let mut inputs = Inputs::new();
    let table = shallow(text).parse::<toml::Table>().unwrap_or_default();
    for (name, value) in &table {
        if !NO_INPUTS.contains(&name.as_str()) {
            flatten(name, value, &mut inputs);
        }
    }
    inputs
}

fn flatten(path: &str, value: &toml::Value, into: &mut Inputs) {
    match value {
        toml::Value::Table(table) => {
            for (name, value) in table {
                flatten(&format!("{path}.{name}"), value, into);
            }
        }
        toml::Value::Array(rows) if rows.iter().any(toml::Value::is_table) => {
            for (number, row) in rows.iter().enumerate() {
                let name = row.get("name").and_then(toml::Value::as_str);
                let name = name.map_or_else(|| (number + 1).to_string(), str::to_owned);
                flatten(&format!("{path}.{name}"), row, into);
            }
        }
        _ => {
            let text = match value {
                toml::Value::String(text) => text.clone(),
                // `2` and `2.0` are one number.
                toml::Value::Integer(number) => (*number as f64).to_string(),
                toml::Value::Float(number) => number.to_string(),
                other => other.to_string(),
            };
            into.insert(path.to_owned(), shortened(text));
        }
    }
}

fn shortened(text: String) -> String {
    if text.chars().count() <= LONGEST {
        return text;
    }
    let digest = TextDigest::of_text(&text).0;
    let start: String = text.chars().take(20).collect();
    format!("{start}... ({digest:08x})")
}

/// What differs from a baseline: each key with its value, or nothing where the key is left out.
pub(super) fn differences(baseline: &Inputs, inputs: &Inputs) -> Vec<(String, Option<String>)> {
    let changed = inputs
        .iter()
        .filter(|(key, value)| baseline.get(*key) != Some(value))
        .map(|(key, value)| (key.clone(), Some(value.clone())));
    let left_out = baseline
        .keys()
        .filter(|key| !inputs.contains_key(*key))
        .map(|key| (key.clone(), None));
    changed.chain(left_out).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "
        [case]
        title = 'a'
        [current]
        speed_m_per_s = 0.5
        depth_m = [0.0, 10.0]
        [[line]]
        name = 'rope'
        length_m = 10
        [[published]]
        value = 3.0
    ";

    #[test]
    fn inputs_have_the_keys_of_the_case_file() {
        let inputs = inputs(TEXT);
        let keys: Vec<_> = inputs.keys().map(String::as_str).collect();
        assert_eq!(
            keys,
            [
                "current.depth_m",
                "current.speed_m_per_s",
                "line.rope.length_m",
                "line.rope.name"
            ]
        );
        assert_eq!(inputs["line.rope.length_m"], "10");
    }

    #[test]
    fn differences_are_what_is_changed_added_and_left_out() {
        let base = inputs(TEXT);
        assert!(differences(&base, &inputs(&TEXT.replace("= 10\n", "= 10.0\n"))).is_empty());
        let other = TEXT.replace("speed_m_per_s = 0.5", "direction_deg = 3.0");
        let found = differences(&base, &inputs(&other));
        let expected = [
            ("current.direction_deg".to_owned(), Some("3".to_owned())),
            ("current.speed_m_per_s".to_owned(), None),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn a_long_value_is_known_by_its_digest() {
        let of = |last: f64| inputs(&format!("a = {:?}", [vec![1.0; 200], vec![last]].concat()));
        assert_ne!(of(1.0)["a"], of(2.0)["a"]);
        assert!(of(1.0)["a"].len() < 60);
    }
}
