//! What a case says about itself: where inputs come from, studies, published values, trends.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Where an input comes from when the source does not print it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mark {
    /// Its standing.
    pub status: Standing,
    /// Why this value.
    pub reason: String,
}

/// Standing of a number, from best to worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Standing {
    /// Printed in the source.
    Published,
    /// Follows from printed numbers by algebra.
    Derived,
    /// Fitted so that printed outputs come out.
    Calibrated,
    /// An engineering choice.
    Assumed,
}

/// One key, or several together, varied over a list of values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// Name, referred to by `published` and `trend`.
    pub name: String,
    /// The key path varied (`current.speed_m_per_s`).
    pub key: String,
    /// Its values, in the unit of the key, or words.
    pub values: Vec<StudyValue>,
    /// What the study shows, one line.
    #[serde(default)]
    pub title: String,
}

/// A value of a study: a number, or one of the words that the key takes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum StudyValue {
    /// A number, in the unit of the key.
    Number(f64),
    /// A word.
    Word(String),
}

impl StudyValue {
    /// The number, if it is one.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Word(_) => None,
        }
    }
}

impl fmt::Display for StudyValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => value.fmt(f),
            Self::Word(word) => f.pad(word),
        }
    }
}

/// A published value and how a run is held against it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// What it is, in words.
    pub name: String,
    /// Channel of the history (`tension_n[wire|payload]`), or a quantity of the whole line (`tension_n`).
    pub channel: String,
    /// What is taken of the channel.
    pub statistic: Statistic,
    /// Window of time \[s\] for the statistic; absent: the whole run.
    pub window_s: Option<[f64; 2]>,
    /// Stretch of the line \[m\], arc length from end A, for a quantity of the whole line; absent: all of it.
    pub stretch_m: Option<[f64; 2]>,
    /// The published value, in the unit of the channel (seconds for times).
    pub value: f64,
    /// Tolerance relative to the value \[-\]. One of the two tolerances is needed.
    pub tolerance_rel: Option<f64>,
    /// Tolerance in the unit of the value.
    pub tolerance_abs: Option<f64>,
    /// Where it is printed ("sec. 2.1, fig. 5").
    pub source: String,
    /// Standing of the inputs behind the computed value, at worst.
    pub inputs: Standing,
    /// True when an input was fitted to this very number: agreement is then no evidence.
    #[serde(default)]
    pub fitted: bool,
    /// The study and the value of its key this row belongs to; absent: the case as it stands.
    pub at: Option<At>,
    /// The value is the change from this point of a study to the point above.
    pub change_from: Option<At>,
    /// The value is that of the point above by that of this point of a study \[-\].
    pub ratio_to: Option<At>,
    /// The value is that of the stretch above by that of this stretch of the same line \[m\].
    pub by_stretch_m: Option<[f64; 2]>,
    /// Why the number is out of reach; the row then reads DIFFERS instead of FAIL.
    pub out_of_reach: Option<String>,
}

/// A published curve over time and how a channel of a run is held against it: by the root mean square of their differences
/// at the output times, the curve straight between its points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedCurve {
    /// What it is, in words.
    pub name: String,
    /// Channel of the history (`tension_n[wire|payload]`).
    pub channel: String,
    /// CSV file beside the case with the points, in the place of the two lists below, which then are those of the file.
    pub points_file: Option<String>,
    /// Times of the curve's points, increasing \[s\].
    #[serde(default)]
    pub time_s: Vec<f64>,
    /// Values there, in the unit of the channel.
    #[serde(default)]
    pub value: Vec<f64>,
    /// The curve repeats itself after this time \[s\], and where in it a run begins is free: the shift that fits best counts.
    pub period_s: Option<f64>,
    /// Window of time of the run \[s\]; absent: all of it.
    pub window_s: Option<[f64; 2]>,
    /// Greatest root mean square of the differences \[% of the curve's greatest size\].
    pub tolerance_percent: f64,
    /// Where it is printed.
    pub source: String,
    /// Standing of the inputs behind the computed curve, at worst.
    pub inputs: Standing,
    /// The point of a study it belongs to; absent: the case as it stands.
    pub at: Option<At>,
    /// Why it is out of reach; the row then reads DIFFERS instead of FAIL.
    pub out_of_reach: Option<String>,
}

impl Published {
    /// Over what the statistic goes: a window of time \[s\] or, of a quantity of the whole line, a stretch of it \[m\].
    #[must_use]
    pub fn within(&self) -> Option<[f64; 2]> {
        self.stretch_m.or(self.window_s)
    }
}

impl Trend {
    /// Over what the statistic goes: a window of time \[s\] or, of a quantity of the whole line, a stretch of it \[m\].
    #[must_use]
    pub fn within(&self) -> Option<[f64; 2]> {
        self.stretch_m.or(self.window_s)
    }
}

/// A point of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct At {
    /// Name of the study.
    pub study: String,
    /// Value of its key.
    pub value: StudyValue,
}

impl super::Case {
    /// Whether the case as it stands is at this point of a study: its key has that value here.
    #[must_use]
    pub fn stands_at(&self, at: &At) -> bool {
        let study = self.study.iter().find(|study| study.name == at.study);
        let whole = toml::Value::try_from(self).ok();
        let Some((study, mut here)) = study.zip(whole) else {
            return false;
        };
        for part in study.key.split('.') {
            // Elements of a list go by their names.
            let named =
                |item: &toml::Value| item.get("name").and_then(toml::Value::as_str) == Some(part);
            let next = match &here {
                toml::Value::Array(items) => items.iter().find(|item| named(item)),
                table => table.get(part),
            };
            let Some(next) = next.cloned() else {
                return false;
            };
            here = next;
        }
        match (&here, &at.value) {
            (toml::Value::String(word), StudyValue::Word(wanted)) => word == wanted,
            (toml::Value::Float(number), StudyValue::Number(wanted)) => number == wanted,
            (toml::Value::Integer(number), StudyValue::Number(wanted)) => *number as f64 == *wanted,
            _ => false,
        }
    }
}

/// A number taken of a channel over a window of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Statistic {
    /// Average over time or, of a quantity of the whole line, over arc length; over a stretch without length: the value
    /// there.
    Mean,
    /// Greatest value, over every step of the solver.
    Max,
    /// Smallest value, over every step of the solver.
    Min,
    /// Value at the end of the window.
    Final,
    /// First value less the smallest (the paper's travel distance).
    Travel,
    /// Time of the greatest value \[s\].
    TimeOfMax,
    /// Time of the smallest value \[s\].
    TimeOfMin,
    /// First time after which the channel stays within 2 % of its whole range from its final value \[s\].
    SettlingTime,
    /// First time at which the channel has gone 90 % of the way from its first to its final value \[s\].
    RiseTime,
    /// Magnitude of the mean rate of change: |final value less first value| over the window's length
    /// \[unit of the channel per second\].
    Rate,
    /// Mean of the greatest values of whole cycles, counted from one rise through the mean to the next.
    MeanPeak,
    /// Mean of the smallest values of the same cycles.
    MeanTrough,
    /// Along the line: arc length from end A of the greatest value \[m\].
    ArcOfMax,
    /// Along the line: arc length from end A of the smallest value \[m\].
    ArcOfMin,
    /// Along the line at the end of the run: the most that the value falls between one place and any later one, going
    /// from A to B. Of heights: how far the line comes down again after a hog.
    GreatestFall,
    /// Along the line at the end of the run: how often the value turns from rising to falling or back, going from A to
    /// B \[-\]. A turn by less than 1 % of the whole range is not counted.
    Turns,
    /// Along the line at the end of the run: how many times the value rises and falls again \[-\], ripples left out as
    /// for turns.
    Peaks,
}

impl Statistic {
    /// Every statistic, in the order in which they are explained to users.
    pub const ALL: [Self; 17] = [
        Self::Mean,
        Self::Max,
        Self::Min,
        Self::Final,
        Self::Travel,
        Self::TimeOfMax,
        Self::TimeOfMin,
        Self::SettlingTime,
        Self::RiseTime,
        Self::Rate,
        Self::MeanPeak,
        Self::MeanTrough,
        Self::ArcOfMax,
        Self::ArcOfMin,
        Self::GreatestFall,
        Self::Turns,
        Self::Peaks,
    ];

    /// The word for it, in case files and in names of quantities (`tension_n[wire|payload].mean`).
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mean => "mean",
            Self::Max => "max",
            Self::Min => "min",
            Self::Final => "final",
            Self::Travel => "travel",
            Self::TimeOfMax => "time_of_max",
            Self::TimeOfMin => "time_of_min",
            Self::SettlingTime => "settling_time",
            Self::RiseTime => "rise_time",
            Self::Rate => "rate",
            Self::MeanPeak => "mean_peak",
            Self::MeanTrough => "mean_trough",
            Self::ArcOfMax => "arc_of_max",
            Self::ArcOfMin => "arc_of_min",
            Self::GreatestFall => "greatest_fall",
            Self::Turns => "turns",
            Self::Peaks => "peaks",
        }
    }

    /// True where it can be taken of a channel, over time.
    #[must_use]
    pub const fn over_time(self) -> bool {
        !matches!(
            self,
            Self::ArcOfMax | Self::ArcOfMin | Self::GreatestFall | Self::Turns | Self::Peaks
        )
    }

    /// True where it can be taken of a quantity of the whole line, over arc length.
    #[must_use]
    pub const fn along_line(self) -> bool {
        matches!(self, Self::Max | Self::Min | Self::Mean) || !self.over_time()
    }

    /// Unit of the statistic of a channel that has the unit `channel` ("N" gives "N", "s" or "N/s").
    #[must_use]
    pub fn unit(self, channel: &str) -> String {
        match self {
            Self::Mean
            | Self::Max
            | Self::Min
            | Self::Final
            | Self::Travel
            | Self::MeanPeak
            | Self::MeanTrough
            | Self::GreatestFall => channel.to_owned(),
            Self::TimeOfMax | Self::TimeOfMin | Self::SettlingTime | Self::RiseTime => {
                "s".to_owned()
            }
            Self::Rate => format!("{channel}/s"),
            Self::ArcOfMax | Self::ArcOfMin => "m".to_owned(),
            Self::Turns | Self::Peaks => "-".to_owned(),
        }
    }
}

/// One way a hard case is computed, and what must come of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trial {
    /// Name, in words.
    pub name: String,
    /// Keys set on top of the case, as `key=value`; absent: the case as it stands.
    pub set: Option<Vec<String>>,
    /// Names of the published values it is held against; absent: all of them.
    pub rows: Option<Vec<String>>,
    /// Words of the reason for which it must be refused; absent: it must be computed.
    pub refused: Option<String>,
    /// Words of a warning that it must give; absent: none is asked for.
    pub told: Option<String>,
    /// Another trial, further up, whose numbers must come out again.
    pub same_as: Option<String>,
    /// How far they may be apart, relative to the number \[-\].
    pub same_rel: Option<f64>,
}

/// A published statement of trend, checked along a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trend {
    /// The statement, in words.
    pub name: String,
    /// The study it is checked along.
    pub study: String,
    /// Channel of the history, or a quantity of the whole line.
    pub channel: String,
    /// What is taken of the channel.
    pub statistic: Statistic,
    /// Window of time \[s\].
    pub window_s: Option<[f64; 2]>,
    /// Stretch of the line \[m\], arc length from end A, for a quantity of the whole line; absent: all of it.
    pub stretch_m: Option<[f64; 2]>,
    /// What the statistic does as the study's values grow.
    pub expect: Direction,
    /// Where it is printed.
    pub source: String,
    /// Why it is out of reach; the row then reads DIFFERS instead of FAIL.
    pub out_of_reach: Option<String>,
}

/// What a statistic does along a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// Grows at every step.
    Rises,
    /// Shrinks at every step.
    Falls,
}
