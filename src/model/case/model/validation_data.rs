//! What a case says about itself: where inputs come from, studies, published values, trends.

use std::fmt;

use crate::case::TomlNode;
use crate::case::channel_id::ChannelId;
use crate::case::fields::ValueType::{self, Name};
use crate::case::fields::{of, positive};
use crate::case::schema::{KeyValue, ListElement, table, words};
use crate::case::subject::Subject;

table! {
    /// Where an input comes from when the source does not print it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Mark => MarkKeys {
        /// Where the number stands, from best to worst: published, derived, calibrated, assumed.
        status: Provenance, "standing";
        /// Why this value.
        reason: String, "reason";
        /// The value that the mark is for; the mark is void where the key has another.
        value: Option<StudyValue>, "value", absent "whatever the key has";
        /// How far the value may be off, as a share of it; studies of effects vary it by so much.
        tolerance_rel: Option<f64>, "relative tolerance", range positive(10.0), absent "10 % in studies of effects";
        /// How far the value may be off, in its unit; with both tolerances given, the wider one counts.
        tolerance_abs: Option<f64>, "absolute tolerance", unit "", range positive(f64::INFINITY), absent "10 % in studies of effects";
    }
}

words! {
    /// Provenance of a number, from best to worst.
    pub enum Provenance {
        /// Printed in the source.
        Published = "published",
        /// Follows from printed numbers by algebra.
        Derived = "derived",
        /// Fitted so that printed outputs come out.
        Calibrated = "calibrated",
        /// An engineering choice.
        Assumed = "assumed",
    }
}

words! {
    /// What an agreement with a published number is worth as evidence.
    pub enum Evidence {
        /// Computed from inputs none of which was fitted to it.
        Predicted = "predicted",
        /// An input was fitted to this very number: agreement is no evidence.
        Fitted = "fitted",
        /// An input, or an exact consequence of inputs: agreement is no evidence.
        Echoed = "echoed",
        /// A formula worked out beside the source: it checks the program, not the source.
        ClosedForm = "closed-form",
    }
}

table! {
    /// One key, or several together, varied over a list of values.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Study => StudyKeys {
        /// Name of the study, referred to by published values and trends.
        name: String, "name", kind Name;
        /// The key path that is varied, such as current.speed_m_per_s.
        key: String, "key";
        /// Its values, in the unit of the key, or words that the key takes.
        values: Vec<StudyValue>, "values";
        /// What the study shows, in one line.
        title: String = "", "title";
    }
}

/// A value of a study: a number, or one of the words that the key takes.
#[derive(Debug, Clone, PartialEq)]
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

impl KeyValue for StudyValue {
    const KIND: ValueType = ValueType::NumberOrText;

    fn blank() -> Self {
        Self::Number(0.0)
    }

    fn read(node: &TomlNode) -> Option<Self> {
        let number = node.number().map(Self::Number);
        number.or_else(|| String::read(node).map(Self::Word))
    }

    /// A whole number is written as one: the key that a study varies may want it so.
    fn write(&self) -> toml_edit::Value {
        match self {
            Self::Number(value) if value.fract() == 0.0 && value.abs() < 1e15 => {
                (*value as i64).into()
            }
            Self::Number(value) => value.write(),
            Self::Word(word) => word.write(),
        }
    }
}

impl ListElement for StudyValue {
    const LIST: ValueType = ValueType::NumbersOrWords;
}

impl fmt::Display for StudyValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value) => value.fmt(f),
            Self::Word(word) => f.pad(word),
        }
    }
}

table! {
    /// A published value and how a run is held against it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Published => PublishedKeys {
        /// What the value is, in words.
        name: String, "name";
        /// Channel of the history, such as tension_n[wire|payload], or of the whole line, such as tension_n.
        channel: Subject, "channel";
        /// What is taken of the channel.
        statistic: Statistic, "statistic";
        /// Of the statistics peak and valley: which of them, counted from 1 at the end of the stretch towards A.
        nth: Option<usize>, "number of the peak or valley", range of(1.0, 1e4), absent "not used";
        /// Window of time for the statistic.
        window_s: Option<[f64; 2]>, "window", range of(0.0, f64::INFINITY), absent "the whole run";
        /// Stretch of the line, arc length from end A, for a quantity of the whole line.
        stretch_m: Option<[f64; 2]>, "stretch", range of(0.0, f64::INFINITY), absent "the whole line";
        /// The value is that of stretch_m by that of this stretch of the same line.
        by_stretch_m: Option<[f64; 2]>, "by the stretch", range of(0.0, f64::INFINITY), absent "not used";
        /// The published value, in the unit of the channel; seconds for times.
        value: f64, "value", unit "";
        /// Tolerance relative to the value.
        tolerance_rel: Option<f64>, "relative tolerance", range positive(10.0), absent "not used";
        /// Tolerance in the unit of the value.
        tolerance_abs: Option<f64>, "absolute tolerance", unit "", range positive(f64::INFINITY), absent "not used";
        /// Where it is printed.
        source: String, "source";
        /// Provenance of the inputs behind the computed value, at worst.
        inputs: Provenance, "inputs";
        /// What an agreement with it is worth.
        kind: Evidence = Evidence::Predicted, "kind";
        /// What else the reader must know: what was fitted to it, which input it repeats.
        note: Option<String>, "note", absent "no note";
        /// Why the tolerance is what it is.
        tolerance_reason: Option<String>, "reason of the tolerance", absent "the one that the file states for all";
        /// Why the number cannot be reached; the row then reads DIFFERS instead of FAIL.
        out_of_reach: Option<String>, "out of reach", absent "not used";
    }
    tables {
        /// The point of a study this row belongs to.
        at: Option<StudyPoint>;
        /// The point of a study from which this row's value is the change.
        change_from: Option<StudyPoint>;
        /// The point of a study by which this row's value is divided.
        ratio_to: Option<StudyPoint>;
    }
}

table! {
    /// A published curve over time and how a channel of the run in time is held against it: by the root mean square of their
    /// differences at the curve's points, the channel straight between its output times.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PublishedCurve => PublishedCurveKeys {
        /// What the curve is, in words.
        name: String, "name";
        /// Channel of the history, such as tension_n[wire|payload].
        channel: ChannelId, "channel";
        /// CSV file beside this one with the curve's points: time_s,value. In the place of time_s and value.
        points_file: Option<String>, "points file", absent "not used";
        /// Times of the curve's points, increasing.
        time_s: Vec<f64>, "times", range of(0.0, 1e6), unless points_file;
        /// Values there, in the unit of the channel.
        value: Vec<f64>, "values", unit "", unless points_file;
        /// The curve repeats after this time, and the shift that fits best counts.
        period_s: Option<f64>, "period", range positive(1e6), absent "not used";
        /// Window of time of the run.
        window_s: Option<[f64; 2]>, "window", range of(0.0, f64::INFINITY), absent "the whole run";
        /// Greatest root mean square of the differences, in percent of the curve's greatest size.
        tolerance_percent: f64, "tolerance", unit "", range positive(100.0);
        /// Greatest difference at a point, in percent of the curve's range.
        greatest_percent: Option<f64>, "greatest difference", unit "", range positive(100.0), absent "not held";
        /// Where it is printed, or what computed it and how.
        source: String, "source";
        /// Provenance of the inputs behind the computed curve, at worst.
        inputs: Provenance, "inputs";
        /// What an agreement with it is worth.
        kind: Evidence = Evidence::Predicted, "kind";
        /// What else the reader must know: what was fitted to it, which input it repeats.
        note: Option<String>, "note", absent "no note";
        /// Why the tolerance is what it is.
        tolerance_reason: Option<String>, "reason of the tolerance", absent "the one that the file states for all";
        /// Why the curve cannot be reached; the row then reads DIFFERS instead of FAIL.
        out_of_reach: Option<String>, "out of reach", absent "not used";
    }
    tables {
        /// The point of a study this curve belongs to.
        at: Option<StudyPoint>;
    }
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

table! {
    /// A point of a study.
    #[derive(Debug, Clone, PartialEq)]
    pub struct StudyPoint => AtKeys {
        /// Name of the study.
        study: String, "study";
        /// Value of its key.
        value: StudyValue, "value";
    }
}

words! {
    /// A number taken of a channel over a window of time.
    pub enum Statistic {
        /// Average over time or, of a quantity of the whole line, over arc length; over a stretch without length: the value
        /// there.
        Mean = "mean",
        /// Greatest value, over every step of the solver.
        Max = "max",
        /// Smallest value, over every step of the solver.
        Min = "min",
        /// Value at the end of the window.
        Final = "final",
        /// First value less the smallest (the paper's travel distance).
        Travel = "travel",
        /// Time of the greatest value \[s\].
        TimeOfMax = "time_of_max",
        /// Time of the smallest value \[s\].
        TimeOfMin = "time_of_min",
        /// First time after which the channel stays within 2 % of its whole range from its final value \[s\].
        SettlingTime = "settling_time",
        /// First time at which the channel has gone 90 % of the way from its first to its final value \[s\].
        RiseTime = "rise_time",
        /// Magnitude of the mean rate of change: |final value less first value| over the window's length
        /// \[unit of the channel per second\].
        Rate = "rate",
        /// Mean of the greatest values of whole cycles, counted from one rise through the mean to the next.
        MeanPeak = "mean_peak",
        /// Mean of the smallest values of the same cycles.
        MeanTrough = "mean_trough",
        /// Along the line: arc length from end A of the greatest value \[m\].
        ArcOfMax = "arc_of_max",
        /// Along the line: arc length from end A of the smallest value \[m\].
        ArcOfMin = "arc_of_min",
        /// Along the line at the end of the run: the most that the value falls between one place and any later one, going
        /// from A to B. Of heights: how far the line comes down again after a hog.
        GreatestFall = "greatest_fall",
        /// Along the line at the end of the run: how often the value turns from rising to falling or back, going from A to
        /// B \[-\]. A turn by less than 1 % of the whole range is not counted.
        Turns = "turns",
        /// Along the line at the end of the run: how many times the value rises and falls again \[-\], ripples left out as
        /// for turns.
        Peaks = "peaks",
        /// Along the line at the end of the run: the value at its `nth` local maximum, going from A to B, ripples left out as
        /// for turns.
        Peak = "peak",
        /// Along the line at the end of the run: the value at its `nth` local minimum, likewise.
        Valley = "valley",
    }
}

impl Statistic {
    /// True where it can be taken of a channel, over time.
    #[must_use]
    pub const fn over_time(self) -> bool {
        !matches!(
            self,
            Self::ArcOfMax
                | Self::ArcOfMin
                | Self::GreatestFall
                | Self::Turns
                | Self::Peaks
                | Self::Peak
                | Self::Valley
        )
    }

    /// True where `nth` says which of several it is.
    #[must_use]
    pub const fn is_numbered(self) -> bool {
        matches!(self, Self::Peak | Self::Valley)
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
            | Self::GreatestFall
            | Self::Peak
            | Self::Valley => channel.to_owned(),
            Self::TimeOfMax | Self::TimeOfMin | Self::SettlingTime | Self::RiseTime => {
                "s".to_owned()
            }
            Self::Rate => format!("{channel}/s"),
            Self::ArcOfMax | Self::ArcOfMin => "m".to_owned(),
            Self::Turns | Self::Peaks => "-".to_owned(),
        }
    }
}

table! {
    /// One way a hard case is computed, and what must come of it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Trial => TrialKeys {
        /// What the trial is, in words.
        name: String, "name";
        /// Keys set on top of the file, each as key=value.
        set: Option<Vec<String>>, "set", absent "the file as it stands";
        /// Names of the published values the trial is held against.
        rows: Option<Vec<String>>, "rows", absent "all published values";
        /// Words of the reason for which the trial must be refused.
        refused: Option<String>, "refused", absent "it must be computed";
        /// Words of a warning that the trial must give.
        told: Option<String>, "told", absent "not used";
        /// A trial further up whose numbers must come out again.
        same_as: Option<String>, "same as", absent "not used";
        /// How far they may be apart, relative to the number.
        same_rel: Option<f64>, "same within", range positive(1.0), absent "not used";
    }
}

table! {
    /// A published statement of trend, checked along a study.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Trend => TrendKeys {
        /// The statement, in words.
        name: String, "name";
        /// The study it is checked along.
        study: String, "study";
        /// Channel of the history, or quantity of the whole line.
        channel: Subject, "channel";
        /// What is taken of the channel.
        statistic: Statistic, "statistic";
        /// Of the statistics peak and valley: which of them, counted from 1 at the end of the stretch towards A.
        nth: Option<usize>, "number of the peak or valley", range of(1.0, 1e4), absent "not used";
        /// Window of time for the statistic.
        window_s: Option<[f64; 2]>, "window", range of(0.0, f64::INFINITY), absent "the whole run";
        /// Stretch of the line, arc length from end A, for a quantity of the whole line.
        stretch_m: Option<[f64; 2]>, "stretch", range of(0.0, f64::INFINITY), absent "the whole line";
        /// What the statistic does as the study's values grow.
        expect: Direction, "expect";
        /// Where it is printed.
        source: String, "source";
        /// What else the reader must know.
        note: Option<String>, "note", absent "no note";
        /// Why the statement cannot be reached; the row then reads DIFFERS instead of FAIL.
        out_of_reach: Option<String>, "out of reach", absent "not used";
    }
}

words! {
    /// What a statistic does along a study.
    pub enum Direction {
        /// Grows at every step.
        Rises = "rises",
        /// Shrinks at every step.
        Falls = "falls",
    }
}
