//! What the screen showed last, so that the next session in the same directory opens as it ended: the case, the pane, cursors, filters,
//! sorting, hidden columns, zoom.

pub mod file;
mod of_state;
mod of_tables;
mod tables;

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use self::tables::{RunsMemory, TableMemory};

/// What the screen showed.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ScreenMemory {
    /// The file that was open; absent: the list of cases.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub case: Option<PathBuf>,
    /// The pane that had the focus.
    pub pane: String,
    /// The filter of the list of cases.
    pub cases_filter: String,
    /// The key under the cursor of the inputs.
    pub input: String,
    /// The filter of the inputs.
    pub input_filter: String,
    /// Whether the defaults were folded.
    pub folded: bool,
    /// Whether the inputs had the whole screen.
    pub zoomed: bool,
    /// The tab of the tables.
    pub tab: usize,
    /// The charts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub charts: Option<ChartsMemory>,
    /// The table of runs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub runs: Option<RunsMemory>,
    /// The other tables, as far as the user changed them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tables: Vec<TableMemory>,
}

/// What the charts showed.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ChartsMemory {
    /// The title of the chart.
    pub chart: String,
    /// What was shown along x, in the chart's own unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub x: Option<[f64; 2]>,
    /// What was shown along y.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub y: Option<[f64; 2]>,
}
