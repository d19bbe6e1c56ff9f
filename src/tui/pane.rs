//! The panes of the screen by name. What a pane does is in [`panes`](super::panes).

/// A pane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PaneId {
    /// The list of cases.
    Cases,
    /// The parameter editor.
    Inputs,
    /// The charts of a line case.
    Charts,
    /// The results of the live run.
    Results,
    /// Its runs.
    Runs,
    /// The validation table.
    Validation,
    /// The text report of a run.
    Report,
    /// The jobs.
    Jobs,
    /// The load cases of a file: heat map, table, checks.
    Sweep,
    /// Trials of hard cases.
    Trials,
    /// The line node by node.
    Nodes,
    /// Natural modes of the line.
    Modes,
    /// Tables and charts of a file other than a line case.
    Tables,
    /// A cross-section drawn.
    Drawing,
    /// A ropeway drawn, with its readings.
    Ropeway,
    /// A ship from above, with its headings.
    Ship,
    /// A system of lines drawn.
    System,
    /// What the file is made of, to be built.
    Model,
}

impl PaneId {
    /// All panes.
    pub const ALL: [Self; 18] = [
        Self::Cases,
        Self::Inputs,
        Self::Charts,
        Self::Results,
        Self::Runs,
        Self::Validation,
        Self::Report,
        Self::Jobs,
        Self::Sweep,
        Self::Trials,
        Self::Nodes,
        Self::Modes,
        Self::Tables,
        Self::Drawing,
        Self::Ropeway,
        Self::Ship,
        Self::System,
        Self::Model,
    ];
}
