//! Where keys go: the places of the screen, and those that a command may be for.

/// Where the keys go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Place {
    /// The list of cases.
    Cases,
    /// The parameter editor.
    Inputs,
    /// The charts.
    Charts,
    /// The runs of the case.
    Runs,
    /// The validation table.
    Validation,
    /// The text report.
    Report,
    /// The jobs.
    Jobs,
    /// Trials of hard cases.
    Trials,
    /// The line node by node.
    Nodes,
    /// Natural modes of the line.
    Modes,
    /// The keys of a file that is no line case.
    Keys,
    /// Its tables and charts.
    Tables,
    /// What it is held against.
    Checks,
    /// A cross-section drawn.
    Drawing,
    /// A ropeway drawn, with its readings.
    Ropeway,
    /// A ship from above, with its headings.
    Ship,
}

impl Place {
    /// All of them.
    pub const ALL: [Self; 16] = [
        Self::Trials,
        Self::Modes,
        Self::Cases,
        Self::Inputs,
        Self::Charts,
        Self::Runs,
        Self::Validation,
        Self::Report,
        Self::Jobs,
        Self::Nodes,
        Self::Keys,
        Self::Tables,
        Self::Checks,
        Self::Drawing,
        Self::Ropeway,
        Self::Ship,
    ];

    /// The panes of an open case, in the order of their numbers.
    pub const PANES: [Self; 8] = [
        Self::Inputs,
        Self::Charts,
        Self::Runs,
        Self::Validation,
        Self::Report,
        Self::Jobs,
        Self::Nodes,
        Self::Modes,
    ];

    /// The name shown on its frame and tab.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Cases => "Cases",
            Self::Inputs | Self::Keys => "Inputs",
            Self::Charts => "Charts",
            Self::Runs => "Runs",
            Self::Validation | Self::Checks => "Validation",
            Self::Report => "Report",
            Self::Jobs => "Jobs",
            Self::Trials => "Trials",
            Self::Nodes => "Nodes",
            Self::Modes => "Modes",
            Self::Drawing => "Drawing",
            Self::Tables => "Tables",
            Self::Ropeway => "Ropeway",
            Self::Ship => "Ship",
        }
    }
}

/// Wherever keys go.
pub(super) const EVERYWHERE: &[Place] = &Place::ALL;
/// Panes of an open line case.
pub(super) const IN_CASE: &[Place] = &Place::PANES;
/// The trials.
pub(super) const TRIALS: &[Place] = &[Place::Trials];
/// What scrolls or has a cursor that goes up and down.
pub(super) const LISTS: &[Place] = &[
    Place::Trials,
    Place::Modes,
    Place::Cases,
    Place::Inputs,
    Place::Runs,
    Place::Validation,
    Place::Report,
    Place::Jobs,
    Place::Nodes,
    Place::Keys,
    Place::Tables,
    Place::Checks,
    Place::Ship,
];
/// As [`LISTS`], without the pane that has a word of its own for it.
pub(super) const DOWN: &[Place] = &[
    Place::Trials,
    Place::Cases,
    Place::Inputs,
    Place::Runs,
    Place::Validation,
    Place::Report,
    Place::Jobs,
    Place::Nodes,
    Place::Keys,
    Place::Tables,
    Place::Checks,
    Place::Ship,
];
/// Panes of a file that is no line case.
pub(super) const IN_SHEET: &[Place] = &[
    Place::Keys,
    Place::Tables,
    Place::Checks,
    Place::Drawing,
    Place::Ropeway,
    Place::Ship,
];
/// The ropeway drawn.
pub(super) const ROPEWAY: &[Place] = &[Place::Ropeway];
/// The list of cases.
pub(super) const CASES: &[Place] = &[Place::Cases];
/// Keys of a file, of any kind.
pub(super) const INPUTS: &[Place] = &[Place::Inputs, Place::Keys];
/// The cross-section drawn.
pub(super) const DRAWING: &[Place] = &[Place::Drawing];
/// Tables and charts of a file that is no line case.
pub(super) const TABLES: &[Place] = &[Place::Tables];
/// Natural modes.
pub(super) const MODES: &[Place] = &[Place::Modes];
/// The line node by node.
pub(super) const NODES: &[Place] = &[Place::Nodes];
/// Panes of an open file, of any kind.
pub(super) const IN_FILE: &[Place] = &[
    Place::Modes,
    Place::Inputs,
    Place::Charts,
    Place::Runs,
    Place::Validation,
    Place::Report,
    Place::Jobs,
    Place::Nodes,
    Place::Keys,
    Place::Tables,
    Place::Checks,
    Place::Drawing,
    Place::Ropeway,
    Place::Ship,
];
/// Charts of a line case.
pub(super) const CHARTS: &[Place] = &[Place::Charts];
/// Its runs.
pub(super) const RUNS: &[Place] = &[Place::Runs];
/// Its jobs.
pub(super) const JOBS: &[Place] = &[Place::Jobs];
/// What may be wider than the screen.
pub(super) const WIDE: &[Place] = &[
    Place::Trials,
    Place::Modes,
    Place::Validation,
    Place::Report,
    Place::Nodes,
    Place::Tables,
    Place::Checks,
];
/// What `w` writes of a line case.
pub(super) const WRITABLE: &[Place] = &[
    Place::Charts,
    Place::Validation,
    Place::Report,
    Place::Nodes,
];
