//! Where keys go: the places of the screen, and those that a command may be for.

/// Where the keys go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PaneId {
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

impl PaneId {
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
pub(super) const EVERYWHERE: &[PaneId] = &PaneId::ALL;
/// Panes of an open line case.
pub(super) const IN_CASE: &[PaneId] = &PaneId::PANES;
/// The trials.
pub(super) const TRIALS: &[PaneId] = &[PaneId::Trials];
/// What scrolls or has a cursor that goes up and down.
pub(super) const LISTS: &[PaneId] = &[
    PaneId::Trials,
    PaneId::Modes,
    PaneId::Cases,
    PaneId::Inputs,
    PaneId::Runs,
    PaneId::Validation,
    PaneId::Report,
    PaneId::Jobs,
    PaneId::Nodes,
    PaneId::Keys,
    PaneId::Tables,
    PaneId::Checks,
    PaneId::Ship,
];
/// As [`LISTS`], without the pane that has a word of its own for it.
pub(super) const DOWN: &[PaneId] = &[
    PaneId::Trials,
    PaneId::Cases,
    PaneId::Inputs,
    PaneId::Runs,
    PaneId::Validation,
    PaneId::Report,
    PaneId::Jobs,
    PaneId::Nodes,
    PaneId::Keys,
    PaneId::Tables,
    PaneId::Checks,
    PaneId::Ship,
];
/// Panes of a file that is no line case.
pub(super) const IN_SHEET: &[PaneId] = &[
    PaneId::Keys,
    PaneId::Tables,
    PaneId::Checks,
    PaneId::Drawing,
    PaneId::Ropeway,
    PaneId::Ship,
];
/// The ropeway drawn.
pub(super) const ROPEWAY: &[PaneId] = &[PaneId::Ropeway];
/// The list of cases.
pub(super) const CASES: &[PaneId] = &[PaneId::Cases];
/// Keys of a file, of any kind.
pub(super) const INPUTS: &[PaneId] = &[PaneId::Inputs, PaneId::Keys];
/// The cross-section drawn.
pub(super) const DRAWING: &[PaneId] = &[PaneId::Drawing];
/// Tables and charts of a file that is no line case.
pub(super) const TABLES: &[PaneId] = &[PaneId::Tables];
/// Natural modes.
pub(super) const MODES: &[PaneId] = &[PaneId::Modes];
/// The line node by node.
pub(super) const NODES: &[PaneId] = &[PaneId::Nodes];
/// Panes of an open file, of any kind.
pub(super) const IN_FILE: &[PaneId] = &[
    PaneId::Modes,
    PaneId::Inputs,
    PaneId::Charts,
    PaneId::Runs,
    PaneId::Validation,
    PaneId::Report,
    PaneId::Jobs,
    PaneId::Nodes,
    PaneId::Keys,
    PaneId::Tables,
    PaneId::Checks,
    PaneId::Drawing,
    PaneId::Ropeway,
    PaneId::Ship,
];
/// Charts of a line case.
pub(super) const CHARTS: &[PaneId] = &[PaneId::Charts];
/// Its runs.
pub(super) const RUNS: &[PaneId] = &[PaneId::Runs];
/// Its jobs.
pub(super) const JOBS: &[PaneId] = &[PaneId::Jobs];
/// What may be wider than the screen.
pub(super) const WIDE: &[PaneId] = &[
    PaneId::Trials,
    PaneId::Modes,
    PaneId::Validation,
    PaneId::Report,
    PaneId::Nodes,
    PaneId::Tables,
    PaneId::Checks,
];
/// What `w` writes of a line case.
pub(super) const WRITABLE: &[PaneId] = &[
    PaneId::Charts,
    PaneId::Validation,
    PaneId::Report,
    PaneId::Nodes,
];
