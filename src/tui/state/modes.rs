//! Natural modes of the open case: what was found last, and what of it is seen.

use std::sync::Arc;

use crate::modes::LineModes;
use crate::table_pane::TablePane;

/// How many modes are looked for.
pub const COUNT: usize = 12;

/// The modes of a case on the screen.
#[derive(Debug, Clone, Default)]
pub struct ModesView {
    /// The modes found last, or why there are none; absent before the first answer.
    pub found: Option<Result<Arc<LineModes>, String>>,
    /// The text of the case that they are of.
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
