//! Natural modes of what is open: what was found last, and what of it is seen.

use std::sync::Arc;

use crate::case::Case;
use crate::modes::{LineModes, of_case};
use crate::system::SolvedSystem;
use crate::system::motion::modes::modes_of_system;
use crate::table_pane::TablePane;

/// How many modes are looked for.
pub const COUNT: usize = 12;

/// What natural modes are looked for of.
#[derive(Debug, Clone)]
pub enum ModesOf {
    /// The line of a case.
    Line(Box<Case>),
    /// A system.
    System(Arc<SolvedSystem>),
}

impl ModesOf {
    /// The modes; for the threads behind the screen.
    ///
    /// # Errors
    /// Why there are none, in words.
    pub fn find(&self) -> Result<Arc<LineModes>, String> {
        let found = match self {
            Self::Line(case) => of_case(case, COUNT).map_err(|why| why.to_string()),
            Self::System(solved) => modes_of_system(solved, COUNT)
                .map_err(|why| format!("{}; {}", why.problem, why.remedy)),
        };
        found.map(Arc::new)
    }
}

/// The modes of a file on the screen.
#[derive(Debug, Clone, Default)]
pub struct ModesView {
    /// The modes found last, or why there are none; absent before the first answer.
    pub found: Option<Result<Arc<LineModes>, String>>,
    /// The text of the file that they are of.
    pub text: String,
    /// The text that is worked on in the background.
    pub going: Option<String>,
    /// Whether they were looked at last, so that they stay beside the inputs.
    pub beside: bool,
    /// Whether the shape is drawn over the line at rest, where there is no room for both; else along the line.
    pub over: bool,
    /// The mode selected, and scrolling of the table.
    pub pane: TablePane,
}
