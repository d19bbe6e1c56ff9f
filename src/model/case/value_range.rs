//! The values that a key is varied over, as a user types them: `0.2..0.8/4` (so many values, in even steps, both ends among them),
//! `1..100/3log` (in even ratios), `0.2,0.5,0.8`. Numbers may carry a unit, as in a field: `0.1..0.5 km/3`; a unit behind the last number
//! alone is that of all.

use super::fields::{Field, TypedNumber, ValueType, either, nearest, quantity};
use super::model::StudyValue;
use crate::limits::POINTS;

/// What is wrong with the values of a key, and what would be right.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RangeError {
    /// Nothing is given.
    #[error("there are no values; write A..B/N, such as 0.2..0.8/4, or a,b,c")]
    Empty,
    /// A range without a count.
    #[error("`{0}` lacks the number of values; write A..B/N, such as 0.2..0.8/4")]
    NoCount(String),
    /// A count that is none.
    #[error(
        "`{0}` is no number of values; give a whole number from 2 on, with `log` behind it for even ratios"
    )]
    Count(String),
    /// A count above the limit.
    #[error("it has {count} values; {remedy}", count = .0, remedy = POINTS.remedy("give fewer", *.0 as f64))]
    TooMany(usize),
    /// A text that is no number.
    #[error("`{text}` is no number{of_unit}; {remedy}")]
    NoNumber {
        /// The text.
        text: String,
        /// " of m", or nothing.
        of_unit: String,
        /// What would be right.
        remedy: String,
    },
    /// Ratios between numbers of unlike sign.
    #[error(
        "even ratios need two numbers above zero, and go from {0} to {1}; leave `log` out for even steps"
    )]
    NotPositive(String, String),
    /// Both ends are the same.
    #[error("the range begins and ends at {0}; give two different numbers, or the value alone")]
    NoLength(String),
    /// A value that the key does not take.
    #[error("{value} is out of range; the key takes {range}")]
    OutOfRange {
        /// The value with its unit.
        value: String,
        /// What it takes.
        range: String,
    },
    /// A key of whole numbers.
    #[error(
        "{0} is not a whole number, which the key takes; choose ends and count so that every step is whole"
    )]
    NotWhole(String),
    /// A value given twice.
    #[error("{0} is given twice; give each value once")]
    Twice(String),
    /// A word that the key does not take.
    #[error("`{word}` is not known; {remedy}")]
    Word {
        /// The word.
        word: String,
        /// What would be right.
        remedy: String,
    },
}

/// By how much steps or ratios that are even may differ.
const EVEN: f64 = 1e-6;

/// Values of a key, in its unit.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueRange {
    /// The values, in the order given.
    pub values: Vec<StudyValue>,
    /// How they are spaced.
    pub spacing: Spacing,
}

/// How values are spaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// As listed.
    Listed,
    /// In even steps.
    Linear,
    /// In even ratios.
    Logarithmic,
}

impl ValueRange {
    /// Reads the values of a key.
    ///
    /// # Errors
    /// What is wrong with them, and what would be right.
    pub fn parse(text: &str, field: &Field) -> Result<Self, RangeError> {
        let text = text.trim();
        if text.is_empty() {
            return Err(RangeError::Empty);
        }
        // Words may be paths.
        let ends = text.split_once("..").filter(|_| field.takes_number());
        let range = match ends {
            Some((from, rest)) => spaced(text, from, rest, field)?,
            None => Self {
                values: listed(text, field)?,
                spacing: Spacing::Listed,
            },
        };
        range
            .values
            .iter()
            .try_for_each(|value| fits(value, field))?;
        for (index, value) in range.values.iter().enumerate() {
            if range.values[..index].contains(value) {
                return Err(RangeError::Twice(shown(value, field)));
            }
        }
        Ok(range)
    }

    /// Values that are listed, and how they happen to be spaced.
    #[must_use]
    pub fn of_values(values: Vec<StudyValue>) -> Self {
        let numbers: Vec<f64> = values.iter().filter_map(StudyValue::number).collect();
        let even = |steps: &dyn Fn(f64, f64) -> f64| {
            let steps: Vec<f64> = numbers.windows(2).map(|w| steps(w[0], w[1])).collect();
            steps
                .windows(2)
                .all(|w| (w[1] - w[0]).abs() <= EVEN * w[0].abs())
        };
        let spacing = match numbers.len() == values.len() && numbers.len() > 2 {
            true if even(&|a, b| b - a) => Spacing::Linear,
            true if numbers.iter().all(|n| *n > 0.0) && even(&|a, b| b / a) => Spacing::Logarithmic,
            _ => Spacing::Listed,
        };
        Self { values, spacing }
    }

    /// The values as numbers; none where one is a word.
    #[must_use]
    pub fn numbers(&self) -> Option<Vec<f64>> {
        self.values.iter().map(StudyValue::number).collect()
    }
}

/// `A..B/N` and `A..B/Nlog`.
fn spaced(whole: &str, from: &str, rest: &str, field: &Field) -> Result<ValueRange, RangeError> {
    let no_count = || RangeError::NoCount(whole.to_owned());
    let (to, count) = rest.rsplit_once('/').ok_or_else(no_count)?;
    let count = count.trim();
    if !count.starts_with(|c: char| c.is_ascii_digit() || c == '-') {
        // The slash of a unit, as in m/s.
        return Err(no_count());
    }
    let (digits, spacing) = match count.strip_suffix("log") {
        Some(digits) => (digits.trim(), Spacing::Logarithmic),
        None => (count, Spacing::Linear),
    };
    let number = digits.parse::<usize>().ok().filter(|n| *n >= 2);
    let number = number.ok_or_else(|| RangeError::Count(count.to_owned()))?;
    if POINTS.is_exceeded_by(number as f64) {
        return Err(RangeError::TooMany(number));
    }
    let unit = TypedNumber::unit_text(to).unwrap_or_default();
    let (a, b) = (typed(from, unit, field)?, typed(to, unit, field)?);
    let show = |value: f64| quantity(value, field.unit);
    if a == b {
        return Err(RangeError::NoLength(show(a)));
    }
    if spacing == Spacing::Logarithmic && (a <= 0.0 || b <= 0.0) {
        return Err(RangeError::NotPositive(show(a), show(b)));
    }
    let values = (0..number).map(|i| StudyValue::Number(at((a, b), i, number, spacing)));
    Ok(ValueRange {
        values: values.collect(),
        spacing,
    })
}

/// Value `i` of `count` from `a` to `b`, without the rounding noise of its computation.
fn at((a, b): (f64, f64), i: usize, count: usize, spacing: Spacing) -> f64 {
    if i == 0 {
        return a;
    }
    if i + 1 == count {
        return b;
    }
    let share = i as f64 / (count - 1) as f64;
    let value = match spacing {
        Spacing::Logarithmic => a * (b / a).powf(share),
        Spacing::Linear | Spacing::Listed => a + (b - a) * share,
    };
    if value.abs() < 1e-12 * a.abs().max(b.abs()) {
        return 0.0;
    }
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// `a,b,c`.
fn listed(text: &str, field: &Field) -> Result<Vec<StudyValue>, RangeError> {
    let items: Vec<&str> = text.split(',').map(str::trim).collect();
    if POINTS.is_exceeded_by(items.len() as f64) {
        return Err(RangeError::TooMany(items.len()));
    }
    let unit = items.last().and_then(|last| TypedNumber::unit_text(last));
    let one = |item: &&str| match word(item, field) {
        Some(word) => word.map(StudyValue::Word),
        None => typed(item, unit.unwrap_or_default(), field).map(StudyValue::Number),
    };
    items.iter().map(one).collect()
}

/// A word, where the key takes words and the text is no number; wrong where the key does not know it.
fn word(text: &str, field: &Field) -> Option<Result<String, RangeError>> {
    let words: &[&str] = match field.kind {
        ValueType::Choice(words) | ValueType::NumberOrChoice(words) => words,
        ValueType::Boolean => &["true", "false"],
        // The file itself checks what it names.
        ValueType::Text => return Some(Ok(text.to_owned())),
        _ => return None,
    };
    if field.takes_number() && TypedNumber::read(text, field.unit).is_some() {
        return None;
    }
    if words.contains(&text) {
        return Some(Ok(text.to_owned()));
    }
    let remedy = match nearest(text, words.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("give {}", either(words)),
    };
    let word = text.to_owned();
    Some(Err(RangeError::Word { word, remedy }))
}

/// A number in the unit of the field; one without a unit has that of all.
fn typed(text: &str, unit: &str, field: &Field) -> Result<f64, RangeError> {
    let text = text.trim();
    let bare = TypedNumber::unit_text(text).is_some_and(str::is_empty);
    let is_unit = unit.starts_with(|c: char| c.is_alphabetic() || c == '°');
    let whole = match bare && is_unit {
        true => format!("{text} {unit}"),
        false => text.to_owned(),
    };
    let wrong = |remedy: String| RangeError::NoNumber {
        text: text.to_owned(),
        of_unit: match field.unit {
            "" | "-" => String::new(),
            unit => format!(" of {unit}"),
        },
        remedy,
    };
    match TypedNumber::read(&whole, field.unit) {
        Some(TypedNumber::Plain(value) | TypedNumber::Converted(value)) => Ok(value),
        Some(TypedNumber::Computed(value)) => {
            Err(wrong(format!("write the result: {}", quantity(value, ""))))
        }
        Some(TypedNumber::Comma(value)) => Err(wrong(format!(
            "write a decimal point: {}",
            quantity(value, "")
        ))),
        Some(TypedNumber::UnknownUnit) => Err(wrong(match field.unit {
            "" | "-" => "write the number without a unit".to_owned(),
            unit => format!("give it in {unit}"),
        })),
        None => Err(wrong("write a number, such as 1.5 or -2e3".to_owned())),
    }
}

/// Whether a key may have a value.
fn fits(value: &StudyValue, field: &Field) -> Result<(), RangeError> {
    let StudyValue::Number(number) = value else {
        return Ok(());
    };
    if field.kind == ValueType::Integer && number.fract() != 0.0 {
        return Err(RangeError::NotWhole(shown(value, field)));
    }
    if !field.range.contains(*number) {
        return Err(RangeError::OutOfRange {
            value: shown(value, field),
            range: field.range_text(),
        });
    }
    Ok(())
}

fn shown(value: &StudyValue, field: &Field) -> String {
    match value {
        StudyValue::Number(number) => quantity(*number, field.unit),
        StudyValue::Word(word) => word.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::field_at;
    use proptest::prelude::*;

    fn field(path: &str) -> &'static Field {
        field_at(&path.split('.').collect::<Vec<_>>()).unwrap()
    }

    fn numbers(text: &str, path: &str) -> Vec<f64> {
        let range = ValueRange::parse(text, field(path)).unwrap_or_else(|e| panic!("{text}: {e}"));
        range.numbers().unwrap()
    }

    #[test]
    fn ranges_and_lists() {
        let speed = "current.speed_m_per_s";
        for (text, path, values) in [
            ("0.2..0.8/4", speed, &[0.2, 0.4, 0.6, 0.8][..]),
            (" 0.8 .. 0.2 / 3 ", speed, &[0.8, 0.5, 0.2]),
            (
                "-0.3..0.3/7",
                speed,
                &[-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3],
            ),
            ("1..2 m/s/2", speed, &[1.0, 2.0]),
            ("3.6..7.2 km/h/2", speed, &[1.0, 2.0]),
            ("0.1, 0.7,0.3", speed, &[0.1, 0.7, 0.3]),
            ("0.5", speed, &[0.5]),
            (
                "0.1..0.5 km/3",
                "line.wire.length_m",
                &[100.0, 300.0, 500.0],
            ),
            ("100 m..0.3 km/2", "line.wire.length_m", &[100.0, 300.0]),
            (
                "100,200 m,0.3 km",
                "line.wire.length_m",
                &[100_000.0, 200.0, 300.0],
            ),
            ("2..8/4", "line.wire.segments", &[2.0, 4.0, 6.0, 8.0]),
            (
                "2..32/5log",
                "line.wire.segments",
                &[2.0, 4.0, 8.0, 16.0, 32.0],
            ),
            ("1e6..1e8/3log", "materials.m.ea_n", &[1e6, 1e7, 1e8]),
            ("1..3 MN/2", "materials.m.ea_n", &[1e6, 3e6]),
            ("0..10/2", "ends.b.position_m.x", &[0.0, 10.0]),
        ] {
            assert_eq!(numbers(text, path), values, "{text}");
        }
    }

    #[test]
    fn words_where_the_key_takes_them() {
        let of = |text: &str, path: &str| ValueRange::parse(text, field(path));
        let word = |word: &str| StudyValue::Word(word.to_owned());
        let methods = of("alpha,rk4", "solver.method").unwrap();
        assert_eq!(methods.values, [word("alpha"), word("rk4")]);
        assert_eq!(methods.numbers(), None);
        let drag = of("1.2,jia-2019-normal", "materials.m.drag_normal").unwrap();
        assert_eq!(
            drag.values,
            [StudyValue::Number(1.2), word("jia-2019-normal")]
        );
        let wrong = of("alpha,rk5", "solver.method").unwrap_err().to_string();
        assert!(wrong.contains("did you mean `rk4`"), "{wrong}");
        assert!(of("true,false", "output.energy").is_ok());
    }

    #[test]
    fn what_is_wrong_is_said_with_what_would_be_right() {
        for (text, path, why) in [
            ("", "current.speed_m_per_s", "write A..B/N"),
            (
                "0.2..0.8",
                "current.speed_m_per_s",
                "lacks the number of values",
            ),
            (
                "0.2..0.8 m/s",
                "current.speed_m_per_s",
                "lacks the number of values",
            ),
            ("0.2..0.8/1", "current.speed_m_per_s", "from 2 on"),
            ("0.2..0.8/4.5", "current.speed_m_per_s", "from 2 on"),
            ("0.2..0.8/3lin", "current.speed_m_per_s", "from 2 on"),
            (
                "0.2..30/2",
                "current.speed_m_per_s",
                "30 m/s is out of range",
            ),
            (
                "0.2..0.2/3",
                "current.speed_m_per_s",
                "two different numbers",
            ),
            ("-1..1/3log", "current.speed_m_per_s", "above zero"),
            (
                "0.2..x/3",
                "current.speed_m_per_s",
                "`x` is no number of m/s",
            ),
            (
                "0.2,0.3 furlongs",
                "current.speed_m_per_s",
                "give it in m/s",
            ),
            ("0.2,2*3", "current.speed_m_per_s", "write the result: 6"),
            ("0.2,0.2", "current.speed_m_per_s", "given twice"),
            ("1..4/3", "line.wire.segments", "2.5 is not a whole number"),
        ] {
            let found = ValueRange::parse(text, field(path))
                .unwrap_err()
                .to_string();
            assert!(found.contains(why), "{text}: {found}");
        }
    }

    proptest! {
        /// Both ends are exact, the values are as many as asked for, they are monotone, and a text is never a panic.
        #[test]
        fn ranges_hold_both_ends(a in 1e-3..1e3f64, b in 1e-3..1e3f64, n in 2usize..50, log: bool) {
            prop_assume!((a - b).abs() > 1e-6 * a.max(b));
            let text = format!("{a}..{b}/{n}{}", if log { "log" } else { "" });
            let values = numbers(&text, "payload.wet_mass_kg");
            prop_assert_eq!(values.len(), n);
            prop_assert_eq!((values[0], values[n - 1]), (a, b));
            let rises = values.windows(2).all(|pair| pair[0] < pair[1]);
            let falls = values.windows(2).all(|pair| pair[0] > pair[1]);
            let monotone = if a < b { rises } else { falls };
            prop_assert!(monotone);
        }

        #[test]
        fn any_text_is_read_or_refused(text in "[-0-9./,a-z ]{0,20}") {
            let _ = ValueRange::parse(&text, field("current.speed_m_per_s"));
            let _ = ValueRange::parse(&text, field("line.wire.segments"));
            let _ = ValueRange::parse(&text, field("materials.m.drag_normal"));
        }
    }
}
