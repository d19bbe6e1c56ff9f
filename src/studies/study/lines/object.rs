//! One JSON object: a line of several sections at rest in still water, or in a current.
//!
//! Keys and values are kept as the text they are written in, so that the answer repeats them to the letter.

use std::fmt;
use std::ops::RangeInclusive;

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;

use super::answered::{END_FORCES_AND_STATUS, shown};
use super::in_current::LineInCurrent;
use crate::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties};

/// A line of text with its answer.
pub(super) struct AnsweredLine {
    pub text: String,
    pub is_line: bool,
    pub refused: bool,
}

/// Why a line has no answer; with the value that is at fault, where it is one.
struct LineAnswerError<'a> {
    value: Option<(&'a str, &'a RawValue)>,
    problem: String,
}

type LineResult<'a, T> = Result<T, LineAnswerError<'a>>;

/// Names and values of an answer, in JSON.
type AnswerValues = Vec<(&'static str, String)>;

/// Keys of a line in still water with their short names.
const STILL: [&str; 10] = [
    "sections",
    "segs",
    "x_m",
    "radius",
    "z_m",
    "depth",
    "friction",
    "bed_below_a_m",
    "bed_slope_deg",
    "surface_above_a_m",
];
/// Keys that only a line in a current has.
const IN_CURRENT: [&str; 7] = [
    "a_m",
    "b_m",
    "current",
    "diameter_m",
    "drag_normal",
    "drag_tangential",
    "water_density_kg_per_m3",
];
const AT_REST: [&str; 5] = ["h_b_n", "v_b_n", "h_a_n", "v_a_n", "on_bed_m"];

/// The keys, in their quotes, and values of an object in their order, as they are written.
struct JsonObject<'a>(Vec<(&'a RawValue, &'a RawValue)>);

impl<'de> Deserialize<'de> for JsonObject<'de> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Entries;
        impl<'de> Visitor<'de> for Entries {
            type Value = JsonObject<'de>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a JSON object: {\"key\": value, ...}")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(JsonObject(entries))
            }
        }
        from.deserialize_map(Entries)
    }
}

/// A key without its quotes.
fn plain(key: &RawValue) -> &str {
    key.get().trim_matches('"')
}

/// Answers one line of text; `number` counts from 1.
pub(super) fn answer(text: &str, number: usize) -> AnsweredLine {
    let unchanged = || AnsweredLine {
        text: text.to_owned(),
        is_line: false,
        refused: false,
    };
    if text.trim().is_empty() {
        return unchanged();
    }
    let object: JsonObject = match serde_json::from_str(text) {
        Ok(object) => object,
        Err(error) => {
            let byte = if error.is_eof() {
                text.len()
            } else {
                error.column().saturating_sub(1)
            };
            let status = format!("{}: {}", place(text, number, byte), problem(&error));
            return AnsweredLine {
                text: format!("{{\"status\": {}}}", quoted(&status)),
                is_line: true,
                refused: true,
            };
        }
    };
    let has = |known: &[&str]| object.0.iter().any(|(key, _)| known.contains(&plain(key)));
    if !has(&STILL) && !has(&IN_CURRENT) {
        return unchanged();
    }
    let solved = if has(&IN_CURRENT) {
        in_current(&object)
    } else {
        at_rest(&object)
    };
    let (values, status) = match solved {
        Ok(values) => (values, "ok".to_owned()),
        Err(error) => (Vec::new(), error.status(text, number)),
    };
    AnsweredLine {
        refused: status != "ok",
        text: object.with(&values, &status),
        is_line: true,
    }
}

/// Line and column of a byte of a line of text.
fn place(text: &str, number: usize, byte: usize) -> String {
    let before = text.get(..byte).unwrap_or(text);
    format!("line {number}, column {}", before.chars().count() + 1)
}

/// What a syntax error says, without the place, which counts from the line's own beginning.
fn problem(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let end = text.rfind(" at line ").unwrap_or(text.len());
    text[..end].to_owned()
}

fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

impl<'a> LineAnswerError<'a> {
    fn new(problem: impl Into<String>) -> Self {
        Self {
            value: None,
            problem: problem.into(),
        }
    }

    fn missing(key: &str) -> Self {
        Self::new(format!("the key {key} is missing"))
    }

    fn at(key: &'a str, value: &'a RawValue, problem: impl Into<String>) -> Self {
        Self {
            value: Some((key, value)),
            problem: problem.into(),
        }
    }

    fn status(&self, text: &str, number: usize) -> String {
        match self.value {
            Some((key, value)) => {
                // The value is part of the text: its distance from the beginning is its place.
                let byte = value.get().as_ptr() as usize - text.as_ptr() as usize;
                format!("{}, {key}: {}", place(text, number, byte), self.problem)
            }
            None => format!("line {number}: {}", self.problem),
        }
    }
}

impl<'a> JsonObject<'a> {
    /// The object as it was, answers of an earlier time left out, and these added.
    fn with(&self, values: &AnswerValues, status: &str) -> String {
        let old = |key: &str| {
            AT_REST.contains(&key) || END_FORCES_AND_STATUS.contains(&key) || key == "shape"
        };
        let given = self.0.iter().filter(|(key, _)| !old(plain(key)));
        let mut parts: Vec<String> = given
            .map(|(key, value)| format!("{}: {}", key.get(), value.get()))
            .collect();
        let answers = values.iter();
        parts.extend(answers.map(|(name, value)| format!("\"{name}\": {value}")));
        parts.push(format!("\"status\": {}", quoted(status)));
        format!("{{{}}}", parts.join(", "))
    }

    /// The value of the one key of these that is there.
    fn find(&self, keys: &[&str]) -> LineResult<'a, Option<(&'a str, &'a RawValue)>> {
        let each = self.0.iter().map(|(key, value)| (plain(key), *value));
        let mut found = each.filter(|(key, _)| keys.contains(key));
        let first = found.next();
        match found.next() {
            Some((key, value)) => Err(LineAnswerError::at(key, value, "given twice")),
            None => Ok(first),
        }
    }

    /// A number; `None` where the key is absent or, with one name, its value is null.
    fn number(&self, keys: &[&str]) -> LineResult<'a, Option<f64>> {
        match self.find(keys)? {
            None => Ok(None),
            Some((_, value))
                if keys.len() == 1 && ["null", "true", "false"].contains(&value.get()) =>
            {
                Ok(None)
            }
            Some((key, value)) => number(key, value).map(Some),
        }
    }

    fn required(&self, keys: &[&str]) -> LineResult<'a, f64> {
        self.number(keys)?
            .ok_or_else(|| LineAnswerError::missing(keys[0]))
    }

    /// Lists of numbers in a list.
    fn rows(
        &self,
        keys: &[&str],
        counts: &RangeInclusive<usize>,
        form: &str,
    ) -> LineResult<'a, Vec<Vec<f64>>> {
        let (key, value) = self
            .find(keys)?
            .ok_or_else(|| LineAnswerError::missing(keys[0]))?;
        match items(value) {
            Some(items) if !items.is_empty() => items
                .into_iter()
                .map(|item| numbers(key, item, counts, form))
                .collect(),
            _ => Err(LineAnswerError::at(
                key,
                value,
                format!("a list of {form} is needed"),
            )),
        }
    }

    fn point(&self, key: &str) -> LineResult<'a, [f64; 3]> {
        let (key, value) = self
            .find(&[key])?
            .ok_or_else(|| LineAnswerError::missing(key))?;
        let list = numbers(key, value, &(3..=3), "[x, y, z]")?;
        Ok([list[0], list[1], list[2]])
    }

    fn sections(&self) -> LineResult<'a, Vec<SectionProperties>> {
        let form = "[length_m, weight_n_per_m, ea_n] or [length_m, weight_n_per_m, ea_n, body_n]";
        let section = |n: Vec<f64>| SectionProperties {
            clump_n: n.get(3).copied().unwrap_or(0.0),
            ..SectionProperties::new(n[0], n[1], n[2])
        };
        let lists = self.rows(&["sections", "segs"], &(3..=4), form)?;
        Ok(lists.into_iter().map(section).collect())
    }
}

fn number<'a>(key: &'a str, value: &'a RawValue) -> LineResult<'a, f64> {
    serde_json::from_str(value.get())
        .map_err(|_| LineAnswerError::at(key, value, "a number is needed"))
}

/// The items of a list; `None` where the value is no list.
fn items(value: &RawValue) -> Option<Vec<&RawValue>> {
    serde_json::from_str(value.get()).ok()
}

/// A list of numbers, as many as these.
fn numbers<'a>(
    key: &'a str,
    value: &'a RawValue,
    counts: &RangeInclusive<usize>,
    form: &str,
) -> LineResult<'a, Vec<f64>> {
    let wrong = || LineAnswerError::at(key, value, format!("{form} is needed"));
    let items = items(value).ok_or_else(wrong)?;
    let list: Vec<f64> = items
        .into_iter()
        .map(|item| number(key, item))
        .collect::<LineResult<_>>()?;
    if counts.contains(&list.len()) {
        Ok(list)
    } else {
        Err(wrong())
    }
}

fn at_rest<'a>(object: &JsonObject<'a>) -> LineResult<'a, AnswerValues> {
    let sections = object.sections()?;
    let anchored = object.find(&["depth"])?.is_some() || object.find(&["radius"])?.is_some();
    let below = object
        .number(&["bed_below_a_m"])?
        .or(anchored.then_some(0.0));
    let (friction, slope) = (
        object.number(&["friction"])?,
        object.number(&["bed_slope_deg"])?,
    );
    if below.is_none() && (friction.unwrap_or(0.0) != 0.0 || slope.unwrap_or(0.0) != 0.0) {
        return Err(LineAnswerError::new(
            "there is a slope or friction but no bed; give bed_below_a_m, 0 for a bed through A",
        ));
    }
    let line = CatenaryLine {
        ends: EndOffset {
            x_m: object.required(&["x_m", "radius"])?,
            z_m: object.required(&["z_m", "depth"])?,
        },
        sections: &sections,
        bed: below.map(|below_a_m| RigidBed {
            below_a_m,
            slope_rad: slope.unwrap_or(0.0).to_radians(),
            friction: friction.unwrap_or(0.0),
        }),
        surface_above_a_m: object.number(&["surface_above_a_m"])?,
    };
    let solved = line
        .solve()
        .map_err(|error| LineAnswerError::new(error.to_string()))?;
    let mut values: AnswerValues = AT_REST
        .into_iter()
        .zip(super::answered::at_rest(&solved).map(shown))
        .collect();
    values.push(("shape", quoted(solved.shape_name())));
    Ok(values)
}

fn in_current<'a>(object: &JsonObject<'a>) -> LineResult<'a, AnswerValues> {
    let still = |key: &str| STILL[2..].contains(&key);
    if let Some((key, value)) = object.0.iter().find(|(key, _)| still(plain(key))) {
        let problem = "a line in a current goes from a_m to b_m and has no bed; leave this key out";
        return Err(LineAnswerError::at(plain(key), value, problem));
    }
    let current = object.rows(&["current"], &(3..=3), "[depth_m, x_m_per_s, y_m_per_s]")?;
    let line = LineInCurrent {
        a_m: object.point("a_m")?,
        b_m: object.point("b_m")?,
        sections: object.sections()?,
        diameter_m: object.required(&["diameter_m"])?,
        drag_normal: object.required(&["drag_normal"])?,
        drag_tangential: object.number(&["drag_tangential"])?.unwrap_or(0.0),
        water_density_kg_per_m3: object
            .number(&["water_density_kg_per_m3"])?
            .unwrap_or(1025.0),
        current: current.into_iter().map(|u| [u[0], u[1], u[2]]).collect(),
    };
    let forces = line.solve().map_err(LineAnswerError::new)?;
    let values = forces.numbers().map(shown);
    Ok(END_FORCES_AND_STATUS.into_iter().zip(values).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_and_values_keep_their_text() {
        let text = r#"{"b \" é": [1, [-2.50e3]],"x_m":1.0e0,  "null": null}"#;
        let object: JsonObject = serde_json::from_str(text).unwrap();
        let expected = r#"{"b \" é": [1, [-2.50e3]], "x_m": 1.0e0, "null": null, "status": "ok"}"#;
        assert_eq!(object.with(&Vec::new(), "ok"), expected);
    }

    #[test]
    fn syntax_errors_name_their_place() {
        for (text, column, words) in [
            ("[1]", 1, "expected a JSON object"),
            ("{\"a\": 1 \"b\": 2}", 9, "expected `,`"),
            ("{\"a\": 1} 2", 10, "trailing characters"),
            ("{\"a\": 1e}", 9, "invalid number"),
            ("{\"é", 4, "EOF while parsing a string"),
            ("{\"a\": NaN}", 7, "expected value"),
            ("{a: 1}", 2, "key must be a string"),
        ] {
            let answer = answer(text, 3).text;
            assert!(
                answer.contains(&format!("line 3, column {column}:")),
                "{answer}"
            );
            assert!(answer.contains(words), "{answer}");
        }
        assert!(answer(&"[".repeat(1000), 1).refused);
    }
}
