//! Tables of a run's line.

use crate::facade;
use crate::line_tables::LineTable;
use crate::report::limits;
use crate::run::Run;
use crate::state::parts::PartView;

pub(crate) fn view(name: &str, run: &Run, which: LineTable) -> PartView {
    let mut table = which.table(run);
    table.title = match (which, LineTable::of_run(run).len()) {
        (LineTable::Nodes, 1) => format!("Nodes of {name}; `:write` writes them as CSV."),
        (which, count) => {
            let number = 1 + which as usize;
            let what = which.title();
            format!(
                "{what} of {name}, table {number} of {count}; `:next_table` shows the next, `:write` writes it."
            )
        }
    };
    // A stored run may be of another text than the one that is open.
    let case = facade::parse(&run.case_text, &run.info.case_file);
    PartView {
        table,
        limits: case
            .ok()
            .and_then(|case| limits::of_run(&case, run.profile())),
        ..PartView::default()
    }
}
