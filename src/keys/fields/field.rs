//! A key of a file: what may be written, in which unit and range, and what holds without it.

use super::parameters_table::ANY_KEY;
use super::range::Range;

/// A key of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// Path pattern: `materials.*.ea_n`.
    pub path: String,
    /// What it is, in a few words.
    pub label: &'static str,
    /// What may be written.
    pub kind: ValueType,
    /// Unit as shown; empty for words, "-" for pure numbers.
    pub unit: &'static str,
    /// Range of every number in it.
    pub range: Range,
    /// What holds when the key is absent.
    pub absent: AbsentValue,
    /// One line of help.
    pub help: &'static str,
    /// A key of the same table and the value it needs for this field to exist: the dimensions of a
    /// payload's shape depend on its `kind`.
    pub only_if: Option<(&'static str, &'static str)>,
    /// Keys of the same table and the words of which each must be one for this field to have an effect: the motion of an
    /// end that does not move has no period. Such a key may be given all the same.
    pub matters: Conditions,
}

/// What a key needs: each of these keys of its table, as one of these words.
pub type Conditions = &'static [(&'static str, &'static [&'static str])];

/// What may be written for a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ValueType {
    /// A number.
    Number,
    /// A whole number.
    Integer,
    /// `true` or `false`.
    Boolean,
    /// Text.
    Text,
    /// Text of letters, digits, `-` and `_`: it becomes part of channel names and key paths.
    Name,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A number, or one of these words.
    NumberOrChoice(&'static [&'static str]),
    /// A number, or a list of numbers.
    NumberOrList,
    /// A number, or one for each of x, y, z.
    NumberOrTriple,
    /// A list of numbers.
    List,
    /// Two numbers.
    Pair,
    /// Three numbers, along x, y, z.
    Triple,
    /// A list of words.
    Words,
    /// A number, or text.
    NumberOrText,
    /// A list of numbers, or of words.
    NumbersOrWords,
}

impl ValueType {
    /// Whether it is made of numbers.
    fn holds_numbers(self) -> bool {
        !matches!(
            self,
            Self::Boolean
                | Self::Text
                | Self::Name
                | Self::Choice(_)
                | Self::Words
                | Self::NumberOrText
                | Self::NumbersOrWords
        )
    }
}

/// What holds when a key is absent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AbsentValue {
    /// The key must be there.
    Required,
    /// The key must be there unless this other one of its table is, which says the same in another way.
    RequiredWithout(&'static str),
    /// This value, written as in a case file.
    Default(&'static str),
    /// Something else, in words.
    Means(&'static str),
}

impl Field {
    /// A required field without a range, known by its key alone; its unit is the one in which the key ends.
    pub fn new(
        key: &'static str,
        kind: ValueType,
        label: &'static str,
        help: &'static str,
    ) -> Self {
        let unit = match unit_of_key(key) {
            Some(unit) if kind.holds_numbers() => unit,
            None if kind.holds_numbers() => "-",
            _ => "",
        };
        Self {
            path: key.to_owned(),
            label,
            kind,
            unit,
            range: Range::ANY,
            absent: AbsentValue::Required,
            help,
            only_if: None,
            matters: &[],
        }
    }

    /// The same field in tables of this pattern.
    pub fn below(&self, pattern: &str) -> Self {
        let mut field = self.clone();
        if !pattern.is_empty() {
            field.path = format!("{pattern}.{}", self.path);
        }
        field
    }

    /// The last part of the path: the key itself.
    #[must_use]
    pub fn key(&self) -> &str {
        self.path.rsplit('.').next().unwrap_or(&self.path)
    }

    /// The pattern of the table it stands in.
    #[must_use]
    pub fn table(&self) -> &str {
        self.path.rsplit_once('.').map_or("", |(table, _)| table)
    }

    /// Label and unit for the key of this path: a key that the user names has them in its name.
    #[must_use]
    pub fn in_words(&self, path: &str) -> (String, &'static str) {
        if self.key() != ANY_KEY {
            return (self.label.to_owned(), self.unit);
        }
        let (words, unit) = in_words(path.rsplit('.').next().unwrap_or(path));
        (words, unit.unwrap_or("-"))
    }

    /// The key without its unit: `length` for `length_m`.
    #[must_use]
    pub fn stem(&self) -> &str {
        let key = self.key();
        unit_suffix(self.unit)
            .and_then(|suffix| key.strip_suffix(suffix)?.strip_suffix('_'))
            .unwrap_or(key)
    }

    /// What may be written, with range and unit, for people: "greater than 0 m, up to 1e5 m".
    #[must_use]
    pub fn range_text(&self) -> String {
        let numbers = self.range.text(self.unit);
        match self.kind {
            ValueType::Number => numbers,
            ValueType::Integer => self.range.whole_text(),
            ValueType::Boolean => "true or false".to_owned(),
            ValueType::Text => "text".to_owned(),
            ValueType::Name => "a name of letters, digits, - and _".to_owned(),
            ValueType::Choice(words) => either(words),
            ValueType::NumberOrChoice(words) => format!("{numbers}; or {}", either(words)),
            ValueType::NumberOrList => format!("{numbers}; or a list of such numbers"),
            ValueType::NumberOrTriple => format!("{numbers}; or three such numbers, along x, y, z"),
            ValueType::List => format!("a list, each {numbers}"),
            ValueType::Pair => format!("two numbers, each {numbers}"),
            ValueType::Triple => format!("three numbers along x, y, z, each {numbers}"),
            ValueType::Words => "a list of words in quotes".to_owned(),
            ValueType::NumberOrText => format!("{numbers}; or a word in quotes"),
            ValueType::NumbersOrWords => {
                format!("a list, each {numbers}; or a list of words in quotes")
            }
        }
    }

    /// What holds when the key is absent, in words: "required", "default 0.4".
    #[must_use]
    pub fn absent_text(&self) -> String {
        match self.absent {
            AbsentValue::Required => "required".to_owned(),
            AbsentValue::RequiredWithout(other) => format!("required without {other}"),
            AbsentValue::Default("\"\"") => "default: empty".to_owned(),
            AbsentValue::Default(value) => format!("default {value}"),
            AbsentValue::Means(meaning) => format!("without it: {meaning}"),
        }
    }

    /// Where the key exists or has an effect, if not everywhere: "only where kind is `box`".
    #[must_use]
    pub fn condition(&self) -> Option<String> {
        if let Some((key, word)) = self.only_if {
            return Some(format!("only where {key} is `{word}`"));
        }
        let words = self.matters.iter();
        let words = words.map(|(key, words)| format!("{key} is {}", either(words)));
        let words: Vec<String> = words.collect();
        (!words.is_empty()).then(|| format!("matters only where {}", words.join(" and ")))
    }

    /// True when the value is text, so that a bare word typed by the user is meant as text.
    #[must_use]
    pub fn takes_words(&self) -> bool {
        matches!(
            self.kind,
            ValueType::Text | ValueType::Name | ValueType::Choice(_) | ValueType::NumberOrChoice(_)
        )
    }

    /// True when one number may be written, so that a study can vary the field.
    #[must_use]
    pub fn takes_number(&self) -> bool {
        matches!(
            self.kind,
            ValueType::Number
                | ValueType::Integer
                | ValueType::NumberOrChoice(_)
                | ValueType::NumberOrList
                | ValueType::NumberOrTriple
        )
    }
}

/// Keys end in this when their value has the unit: `m` for metres, `kg_per_m` for kg/m.
#[must_use]
pub fn unit_suffix(unit: &str) -> Option<&'static str> {
    UNITS
        .iter()
        .find(|(shown, _)| *shown == unit)
        .map(|(_, suffix)| *suffix)
}

/// The unit of a key, by its end: the longest that fits.
fn unit_of_key(key: &str) -> Option<&'static str> {
    let ends = |(_, suffix): &&(&str, &str)| {
        let stem = key.strip_suffix(suffix);
        stem.is_some_and(|stem| stem.is_empty() || stem.ends_with('_'))
    };
    let fitting = UNITS.iter().filter(ends);
    fitting
        .max_by_key(|(_, suffix)| suffix.len())
        .map(|(unit, _)| *unit)
}

/// A key in words, and its unit where it ends in one: `significant height` and `m`.
#[must_use]
pub fn in_words(key: &str) -> (String, Option<&'static str>) {
    let unit = unit_of_key(key).filter(|unit| unit_suffix(unit) != Some(key));
    let suffix = unit
        .and_then(unit_suffix)
        .map(|suffix| format!("_{suffix}"));
    let stem = suffix.and_then(|suffix| key.strip_suffix(&suffix).map(str::to_owned));
    (
        stem.unwrap_or_else(|| key.to_owned()).replace('_', " "),
        unit,
    )
}

/// Units as shown, and as they stand in key names.
const UNITS: &[(&str, &str)] = &[
    ("m", "m"),
    ("s", "s"),
    ("h", "hours"),
    ("years", "years"),
    ("N", "n"),
    ("kg", "kg"),
    ("deg", "deg"),
    ("1/s", "per_s"),
    ("m/s", "m_per_s"),
    ("deg/s", "deg_per_s"),
    ("deg/s²", "deg_per_s2"),
    ("m/s²", "m_per_s2"),
    ("m²", "m2"),
    ("m³", "m3"),
    ("m²/s", "m2_per_s"),
    ("kg/m", "kg_per_m"),
    ("kg m²", "kg_m2"),
    ("Hz", "hz"),
    ("kg/m³", "kg_per_m3"),
    ("N s", "n_s"),
    ("N m²", "n_m2"),
    ("N/m³", "n_per_m3"),
    ("N s/m³", "n_s_per_m3"),
    ("Pa", "pa"),
    ("W", "w"),
];

/// A few words as a sentence.
pub(super) fn capital(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(char::to_uppercase);
    format!(
        "{}{}.",
        first.into_iter().flatten().collect::<String>(),
        letters.as_str()
    )
}

/// "a, b or c", each in backquotes.
pub fn either(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    match quoted.split_last() {
        None => "nothing".to_owned(),
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
    }
}
