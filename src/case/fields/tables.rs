//! Tables of a file, and those that a case file has.

use std::borrow::Cow;

use TableShape::{ByName, List as ListOf, One};

/// A table of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Table {
    /// Path pattern: `materials`, `ends.a`.
    pub path: &'static str,
    /// How many there are.
    pub shape: TableShape,
    /// Whether it must be there.
    pub required: bool,
    /// One line of help.
    pub help: &'static str,
    /// The pattern of its fields where several tables share them: `ends.*`.
    shared: Option<&'static str>,
}

/// A table with fields of its own.
pub(crate) const fn table(
    path: &'static str,
    shape: TableShape,
    required: bool,
    help: &'static str,
) -> Table {
    Table {
        path,
        shape,
        required,
        help,
        shared: None,
    }
}

impl Table {
    /// The same table with the fields of this pattern.
    const fn with_fields(mut self, pattern: &'static str) -> Self {
        self.shared = Some(pattern);
        self
    }

    /// The pattern of its fields: `solver`, `materials.*`.
    #[must_use]
    pub fn pattern(&self) -> Cow<'static, str> {
        match (self.shared, self.shape) {
            (Some(pattern), _) => pattern.into(),
            (None, One) => self.path.into(),
            (None, ByName | ListOf) => format!("{}.*", self.path).into(),
        }
    }
}

/// How many tables stand under a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableShape {
    /// One: `[solver]`.
    One,
    /// Any number, by name: `[materials.chain]`.
    ByName,
    /// A list: `[[line]]`.
    List,
}

/// Every table of the case file.
#[rustfmt::skip] // one table a line
pub static TABLES: &[Table] = &[
    table("case", One, true, "What the case is, for people."),
    table("environment", One, false, "Water and gravity."),
    table("current", One, false, "The current; absent means still water."),
    table("waves", One, false, "Waves; absent means a calm sea."),
    table("seabed", One, false, "The sea bed under the line, level or sloping."),
    table("materials", ByName, true, "What the sections of the line are made of, by name."),
    table("line", ListOf, true, "The sections of the line, from end A to end B."),
    table("ends", One, true, "The two ends of the line."),
    table("ends.a", One, true, "The end where the first section begins.").with_fields("ends.*"),
    table("ends.b", One, true, "The end where the last section stops.").with_fields("ends.*"),
    table("payload", One, false, "The body hung on an end of kind payload."),
    table("payload.shape", One, false, "The form of the payload, for what its other keys leave out."),
    table("payload.rotation", One, false, "How the payload turns about the end of the line; absent means that it is a point."),
    table("floats", ListOf, false, "Floats spread evenly over a stretch of a section."),
    table("clumps", ListOf, false, "A body hung on the line at one place: a clump weight, or a buoy."),
    table("modules", ListOf, false, "Buoyancy modules clamped on a stretch of a section, one a pitch."),
    table("files", ByName, false, "Files that the case names, carried with it, by their names."),
    table("traveller", One, false, "A body that travels along the line at a given speed."),
    table("start", One, false, "Where the line is at time zero, at rest."),
    table("solver", One, false, "Which solver, and its settings."),
    table("output", One, false, "What is recorded and how often."),
    table("modes", One, false, "Natural modes about the static shape, told beside the results of a run."),
    table("marks", ByName, false, "Where an input comes from when the source does not print it, by key path."),
    table("study", ListOf, false, "One key varied over a list of values."),
    table("published", ListOf, false, "A published value the case is held against."),
    table("published.*.at", One, false, "The point of a study this row belongs to."),
    table("published.*.change_from", One, false, "The point of a study from which this row's value is the change."),
    table("published.*.ratio_to", One, false, "The point of a study by which this row's value is divided."),
    table("published_curve", ListOf, false, "A published curve over time that a channel is held against."),
    table("published_curve.*.at", One, false, "The point of a study this curve belongs to."),
    table("trend", ListOf, false, "A published statement of trend, checked along a study."),
    table("trial", ListOf, false, "One way in which a hard case is computed, and what must come of it."),
];
