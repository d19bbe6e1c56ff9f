//! The tables of a run's line: its nodes and, where it was recorded, its response.

use super::facade;
use crate::report::{nodes, response};
use crate::run::Run;
use crate::table::Table;

/// The tables, in the order in which they are leafed through.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum LineTable {
    /// Node by node.
    #[default]
    Nodes,
    /// Peaks and valleys of the root mean square displacement.
    Response,
    /// Waves on each section.
    Waves,
}

impl LineTable {
    /// Its name, for titles and files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nodes => "nodes",
            Self::Response => "response",
            Self::Waves => "waves",
        }
    }

    /// Its title.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Nodes => "Nodes",
            Self::Response => "Peaks and valleys",
            Self::Waves => "Waves",
        }
    }

    /// Those that a run has something for.
    #[must_use]
    pub fn of_run(run: &Run) -> Vec<Self> {
        let told = |table: &Self| match table {
            Self::Nodes => true,
            Self::Response => !run.profile().rms.is_empty(),
            Self::Waves => !run.profile().wkb_number.is_empty(),
        };
        let all = [Self::Nodes, Self::Response, Self::Waves];
        all.into_iter().filter(told).collect()
    }

    /// This one where the run has it, else the nodes.
    #[must_use]
    pub fn or_nodes(self, run: &Run) -> Self {
        if Self::of_run(run).contains(&self) {
            self
        } else {
            Self::Nodes
        }
    }

    /// The next or the previous one that the run has something for.
    #[must_use]
    pub fn beside(self, run: &Run, forward: bool) -> Self {
        let all = Self::of_run(run);
        let at = all.iter().position(|t| *t == self).unwrap_or(0);
        let step = if forward { 1 } else { all.len() - 1 };
        all[(at + step) % all.len()]
    }

    /// The table of a run; for the threads behind the screen.
    #[must_use]
    pub fn table(self, run: &Run) -> Table {
        match self {
            Self::Nodes => nodes::table(run.profile()),
            Self::Response => response::peaks(run.profile()),
            Self::Waves => {
                let case = facade::parse(&run.case_text, &run.info.case_file);
                case.map_or_else(|_| Table::default(), |c| response::waves(&c, run.profile()))
            }
        }
    }

    /// The same as CSV, with every digit of the nodes; for the threads behind the screen.
    #[must_use]
    pub fn csv(self, run: &Run) -> String {
        if self == Self::Nodes {
            return nodes::csv(run.profile());
        }
        let mut text = Vec::new();
        // Writing to memory does not fail; what is no text would be shown as such.
        let _ = self.table(run).write_csv(&mut text);
        String::from_utf8_lossy(&text).into_owned()
    }
}
