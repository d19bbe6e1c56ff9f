//! The runs of what is open: a table of what differs among them, their results, their cost.

use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use super::interface::{Pane, PaneInfo, about};
use crate::command::{
    self, COLUMNS, Command, CommandId, EXPLAIN, FILTER, HIDE_COLUMN, LIST, SHOW_COLUMNS, SORT,
    main, other,
};
use crate::msg::{Effect, RunCaseUse};
use crate::pane::PaneId;
use crate::run_cells::{cell, head, live_cell};
use crate::state::overlay::RunText;
use crate::state::{
    AppState, Charted, JobState, RunColumn, RunEntry, RunList, RunStatus, RunsView,
};
use crate::update::motion::{moved, step};
use crate::update::{column_plot, pages, results, resume, run_table, runs, tables};
use crate::view::layout;
use crate::view::paint::{below_head, first_line, rest, span};
use crate::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::ShowAlone, &["enter"], "show", "Show this run alone on the charts, in the table and in the report"),
    main(CommandId::Select, &["space"], "overlay", "Add this run to the charts or take it off"),
    main(CommandId::Mark, &["m"], "mark", "Mark this run for what is done to several, or take the mark off"),
    main(CommandId::Compare, &["="], "compare", "Compare the marked runs: inputs that differ, every result, validation; one run alone: with the run held"),
    FILTER,
    SORT,
    other(CommandId::PlotColumns, &["p"], "plot", "Plot a result of the runs of the table against an input; ] and [ change the result, } and { the input, w writes chart and values"),
    other(CommandId::HoldAgainst, &["v"], "hold", "Hold the results beside the inputs against this run"),
    other(CommandId::Delete, &["d"], "delete", "Delete the marked runs, or this one (asks first)"),
    other(CommandId::TagRuns, &["#"], "tag", "Tag the marked runs, or this one"),
    other(CommandId::NameRun, &["n"], "name", "Give this run a name of your own"),
    other(CommandId::RunCase, &["e"], "its case", "Edit the exact case of this run in place of the open one; `:undo` takes it back"),
    other(CommandId::Resume, &["c"], "resume", "Resume this stored run from its last checkpoint, up to a time that is asked for"),
    other(CommandId::RunAgain, &["X"], "again", "Compute the exact case of this run again, as a run of its own"),
    EXPLAIN,
    HIDE_COLUMN,
    SHOW_COLUMNS,
    other(CommandId::NoteRun, &["N"], "note", "Write a note about this run"),
    other(CommandId::MarkAll, &["*"], "", "Mark all runs of the table; where any is marked: none"),
    other(CommandId::SortAround, &["O"], "", "Sort the other way round"),
    other(CommandId::SelectNone, &["a"], "live only", "Show the live run only, and take all marks off"),
    command::DOWN,
];

/// What is done to the run under the cursor.
const OF_RUN: [CommandId; 12] = [
    CommandId::ShowAlone,
    CommandId::Select,
    CommandId::Mark,
    CommandId::Compare,
    CommandId::HoldAgainst,
    CommandId::Delete,
    CommandId::TagRuns,
    CommandId::NameRun,
    CommandId::RunCase,
    CommandId::Resume,
    CommandId::RunAgain,
    CommandId::NoteRun,
];

pub(super) struct RunsPane;

impl Pane for RunsPane {
    fn about(&self) -> PaneInfo {
        about("Runs", "Go to the runs", &[COMMANDS, LIST, COLUMNS])
    }

    fn commands(&self, state: &AppState) -> Vec<Command> {
        let mut all = self.about().commands.concat();
        let has_live = state.runs_view().is_none_or(|view| view.runs.has_live());
        all.retain(|command| has_live || command.id != CommandId::SelectNone);
        all
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let view = state.runs_view()?;
        let run = view.current_run();
        if !view.runs.has_live() && run.is_none() && OF_RUN.contains(&id) {
            return Some("There is no run yet; `:run` computes one.");
        }
        let any_marked = || state.runs_view().is_some_and(|view| view.runs.any_marked());
        match id {
            CommandId::PlotColumns => column_plot::why_not(&state.runs_view()?.runs),
            CommandId::Delete if any_marked() => None,
            CommandId::Delete => match run {
                None => Some("The live run is in memory only; there is nothing to delete."),
                Some(run) => run_table::why_not_deleted(run),
            },
            CommandId::Resume => why_not_resumed(run),
            CommandId::Compare => pages::why_not_compared(state),
            CommandId::HoldAgainst => match run {
                None => results::why_no_result(state),
                Some(run) => why_not_stored(Some(run)),
            },
            CommandId::SelectNone => {
                let alone = !view.live.hidden && view.runs.on_charts().next().is_none();
                (alone && !any_marked()).then_some("The live run is shown alone already.")
            }
            CommandId::HideColumn => match view.runs.current_column() {
                None => Some("No column has the cursor; `:column_right` puts it on one."),
                Some(RunColumn::Name) => Some("The names of the runs stay."),
                Some(_) => None,
            },
            CommandId::ShowColumns => view
                .runs
                .hidden
                .is_empty()
                .then_some("All columns are shown."),
            CommandId::TagRuns if any_marked() => None,
            CommandId::Mark
            | CommandId::NameRun
            | CommandId::TagRuns
            | CommandId::NoteRun
            | CommandId::RunCase
            | CommandId::RunAgain => why_not_stored(run),
            _ => None,
        }
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let by = step(state, id);
        let view = state.runs_view_mut()?;
        match id {
            CommandId::ShowAlone => return Some(runs::show_alone(state)),
            CommandId::Select => return Some(runs::select(view)),
            CommandId::Resume => return Some(resume::ask(state)),
            CommandId::HoldAgainst => return Some(results::hold_run(state)),
            CommandId::Compare => return Some(pages::compare(state)),
            CommandId::SelectNone => run_table::live_only(state),
            CommandId::Mark => run_table::mark(state),
            CommandId::MarkAll => return Some(run_table::mark_all(state)),
            CommandId::Delete => return Some(run_table::ask_to_delete(state)),
            CommandId::NameRun => return Some(run_table::ask_text(state, RunText::Name)),
            CommandId::TagRuns => return Some(run_table::ask_text(state, RunText::Tags)),
            CommandId::NoteRun => return Some(run_table::ask_text(state, RunText::Note)),
            CommandId::RunCase => return Some(run_table::read_case(state, RunCaseUse::Edit)),
            CommandId::RunAgain => return Some(run_table::read_case(state, RunCaseUse::RunAgain)),
            CommandId::Filter => view.runs.filter.typing = true,
            CommandId::PlotColumns => return Some(column_plot::open(state)),
            CommandId::Sort | CommandId::SortAround => {
                run_table::sort(state, id == CommandId::SortAround);
                let sorted = state.runs_view()?.runs.sort;
                show_column(state, sorted.map(|(column, _)| column));
            }
            CommandId::ColumnRight | CommandId::ColumnLeft => {
                let by = if id == CommandId::ColumnRight { 1 } else { -1 };
                view.runs.turn_column(by);
                let column = view.runs.current_column();
                show_column(state, column);
            }
            CommandId::Explain => {
                let effects = tables::explain_run_column(state);
                let column = state.runs_view()?.runs.current_column();
                show_column(state, column);
                return Some(effects);
            }
            CommandId::HideColumn => view.runs.hide_column(),
            CommandId::ShowColumns => view.runs.hide_only(Vec::new()),
            _ => view.runs.cursor = moved(view.runs.cursor, by?, view.runs.lines()),
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let state = painter.state;
        let Some(on) = state.charted() else {
            return;
        };
        let view = on.view;
        let area = filter_line(painter, area, &view.runs);
        let [heads, list] = below_head(area);
        let rows = rows_in_sight(view, list.height);
        let table = TableView::new(on, &rows, area.width);
        let strong = painter.theme.strong();
        table.line(painter, heads, strong, 0);
        table.mark(painter, heads, view.runs.current_column());
        let focused = state.focus() == PaneId::Runs;
        for (place, (number, y)) in rows.into_iter().zip(list.top()..).enumerate() {
            let at = Rect::new(list.x, y, list.width, 1);
            let style = painter.line_style(number == view.runs.cursor && focused);
            painter.buf.set_style(at, style);
            let run = run_of(view, number);
            let style = run.map_or(style, |run| run_style(painter, run, style));
            table.line(painter, at, style, place + 1);
        }
    }
}

/// The lines of the table around its cursor, as many as there is room for.
fn rows_in_sight(view: &RunsView, height: u16) -> Vec<usize> {
    let first = first_line(view.runs.cursor, view.runs.lines(), height.into());
    (first..view.runs.lines()).take(height.into()).collect()
}

/// Scrolls the table sideways until a column is in sight.
fn show_column(state: &mut AppState, column: Option<RunColumn>) {
    let area = layout::pane_area(state, PaneId::Runs).unwrap_or_default();
    let Some(view) = state.runs_view_mut() else {
        return;
    };
    let columns = view.runs.shown_columns();
    // The first column is always there.
    let place = column.and_then(|column| columns.iter().position(|shown| *shown == column));
    let furthest = place.map_or(0, |place| place.saturating_sub(1));
    view.runs.scroll = view.runs.scroll.min(furthest);
    let rows = rows_in_sight(view, area.height.saturating_sub(1));
    let seen = |state: &AppState| {
        let on = state.charted();
        on.is_none_or(|on| {
            on.view.runs.scroll >= furthest || is_in_sight(on, &rows, area.width, column)
        })
    };
    while !seen(state) {
        if let Some(view) = state.runs_view_mut() {
            view.runs.scroll += 1;
        }
    }
}

/// Whether a column is seen, and not cut.
fn is_in_sight(on: Charted<'_>, rows: &[usize], room: u16, column: Option<RunColumn>) -> bool {
    let seen = TableView::new(on, rows, room).columns;
    let mut whole = seen.iter().filter(|seen| seen.width >= seen.widest());
    whole.any(|seen| Some(seen.column) == column)
}

/// The run of a line of the table; nothing for the live run.
fn run_of(view: &RunsView, number: usize) -> Option<&RunEntry> {
    let at = *view.runs.rows().get(view.runs.row_of(number)?)?;
    view.runs.all().get(at)
}

fn run_style(painter: &Painter, run: &RunEntry, style: Style) -> Style {
    match run.state {
        RunStatus::Job(JobState::Failed(_)) | RunStatus::Unreadable(_) => {
            style.patch(painter.theme.error())
        }
        _ => style,
    }
}

/// What is typed as a filter, and how far the index is; the rest of the area.
fn filter_line(painter: &mut Painter, area: Rect, runs: &RunList) -> Rect {
    let filtered = runs.filter.typing || !runs.filter.is_empty();
    if !filtered && runs.indexing.is_none() {
        return area;
    }
    let [line, below] = below_head(area);
    let half = span(line, 0, line.width / 2);
    if filtered {
        painter.prompt(half, "filter: ", &runs.filter.input, runs.filter.typing);
    }
    let words = match runs.indexing {
        Some(now) => format!("reading the runs: {} of {}", now.done, now.all),
        None => format!("{} of {} runs", runs.rows().len(), runs.len()),
    };
    let faint = painter.theme.faint();
    painter.text(rest(line, half.right() + 1), &words, faint);
    below
}

/// Blanks between columns.
const GAP: u16 = 2;

/// The columns that fit.
struct TableView {
    columns: Vec<ColumnView>,
}

/// A column as it is seen.
struct ColumnView {
    column: RunColumn,
    /// Head and cells in sight.
    cells: Vec<String>,
    width: u16,
}

impl ColumnView {
    fn new(on: Charted<'_>, rows: &[usize], column: RunColumn) -> Self {
        let cells = rows.iter().map(|number| match run_of(on.view, *number) {
            Some(run) => cell(&on.view.runs, run, column),
            None => live_cell(on, column),
        });
        let mut view = Self {
            column,
            cells: std::iter::once(head(&on.view.runs, column))
                .chain(cells)
                .collect(),
            width: 0,
        };
        view.width = view.widest();
        view
    }

    /// The width of the widest cell, within reason.
    fn widest(&self) -> u16 {
        let widest = self.cells.iter().map(|words| words.width()).max();
        u16::try_from(widest.unwrap_or(0))
            .unwrap_or(u16::MAX)
            .min(48)
    }
}

impl TableView {
    /// The name of the run always, then what fits to the right of what is hidden.
    fn new(on: Charted<'_>, rows: &[usize], room: u16) -> Self {
        let mut all = on.view.runs.shown_columns().iter().copied();
        let name = all.next();
        let mut columns = Vec::new();
        let mut used = 0;
        for column in name.into_iter().chain(all.skip(on.view.runs.scroll)) {
            // The last column may be cut, but not to nothing.
            let left = room.saturating_sub(used);
            if left < 4 {
                break;
            }
            let mut view = ColumnView::new(on, rows, column);
            let width = view.width;
            if left < width && width > 12 && used > 0 && left < 8 {
                break;
            }
            view.width = width.min(left);
            columns.push(view);
            used += width + GAP;
        }
        Self { columns }
    }

    /// Marks the head of the column under the cursor.
    fn mark(&self, painter: &mut Painter, heads: Rect, column: Option<RunColumn>) {
        let mut from = 0;
        for view in &self.columns {
            if Some(view.column) == column {
                let selected = painter.theme.selected();
                painter
                    .buf
                    .set_style(span(heads, from, view.width), selected);
            }
            from += view.width + GAP;
        }
    }

    /// Writes the heads, the first row of cells, or a line of the table.
    fn line(&self, painter: &mut Painter, at: Rect, style: Style, row: usize) {
        let mut from = 0;
        for view in &self.columns {
            let (words, width) = (view.cells.get(row).map_or("", String::as_str), view.width);
            // Numbers are at the right of their column.
            let indent = match view.column.has_numbers() {
                true => width.saturating_sub(u16::try_from(words.width()).unwrap_or(width)),
                false => 0,
            };
            painter.text(span(at, from + indent, width - indent), words, style);
            from += width + GAP;
        }
    }
}

/// Why nothing can be done to a run that is not stored.
fn why_not_stored(run: Option<&RunEntry>) -> Option<&'static str> {
    match run {
        None => Some("The live run is in memory only; `:keep` keeps it."),
        Some(run) if run.dir.is_none() => Some("This run has no directory yet."),
        Some(_) => None,
    }
}

fn why_not_resumed(run: Option<&RunEntry>) -> Option<&'static str> {
    let Some(run) = run else {
        return Some("The live run is in memory only; `:run` makes one that can be resumed.");
    };
    match &run.state {
        RunStatus::Job(state) if state.is_open() => {
            Some("This run is still running; `ctrl+c` stops it.")
        }
        RunStatus::Elsewhere => Some("Another program is still computing this run."),
        RunStatus::Unreadable(_) => Some("This run cannot be read."),
        _ if run.dir.is_none() => Some("This run has no directory to resume from."),
        _ => None,
    }
}
