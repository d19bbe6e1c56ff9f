//! The line node by node: the tables of a run's line, and what its sections bear.

use std::path::PathBuf;

use ratatui::layout::{Constraint, Layout, Rect};

use super::interface::{Pane, PaneInfo, about};
use crate::command::{self, COLUMNS, Command, CommandId, DOWN, LIST, SORT, TABLE, main, other};
use crate::line_tables::LineTable;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::report::limits;
use crate::state::parts::ScreenPart;
use crate::state::text_request::TextOf;
use crate::state::{AppState, LineView};
use crate::table::Table;
use crate::table_pane::TablePane;
use crate::update::motion::table_verb;
use crate::update::{export, parts};
use crate::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::NextTable, &["]", "n"], "table", "Show the next table of the line"),
    command::write("Write the table to a CSV file"),
    SORT,
    other(CommandId::PreviousTable, &["[", "p"], "", "Show the previous table of the line"),
    DOWN,
];

pub(super) struct NodesPane;

impl Pane for NodesPane {
    fn about(&self) -> PaneInfo {
        about(
            "Nodes",
            "Go to the line node by node",
            &[COMMANDS, LIST, TABLE, COLUMNS],
        )
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let of_table = matches!(
            id,
            CommandId::Write | CommandId::Sort | CommandId::NextTable | CommandId::PreviousTable
        );
        let Some((_, run, _)) = state.line()?.runs_view.reported() else {
            return of_table.then_some("There is no finished run. `:run` runs the case.");
        };
        let next = matches!(id, CommandId::NextTable | CommandId::PreviousTable);
        (next && LineTable::of_run(&run).len() < 2).then_some("This run has one table of the line.")
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let verb = table_verb(state, id);
        let document = state.document.as_mut()?;
        let part = parts::of_pane(document, PaneId::Nodes);
        let shown = part.and_then(|part| document.parts.last(part)).cloned();
        let (line, editor) = document.line_and_editor()?;
        match id {
            CommandId::NextTable => next_table(line, true),
            CommandId::PreviousTable => next_table(line, false),
            CommandId::Write => {
                let (_, run, _) = line.runs_view.reported()?;
                let table = line.line_table.or_nodes(&run);
                let path = PathBuf::from(format!("{}-{}.csv", editor.stem(), table.name()));
                return Some(export::write_made(TextOf::Line(table, run), path));
            }
            _ => {
                let verb = verb?;
                if let Some(view) = shown.filter(|view| !view.table.rows.is_empty()) {
                    line.nodes_pane.act(verb, &view.table);
                }
            }
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(line) = painter.state.line() else {
            return;
        };
        let Some((_, run, _)) = line.runs_view.reported() else {
            return painter.paragraph(area, "There is no finished run yet. `:run` runs the case.");
        };
        let part = ScreenPart::Line(line.line_table.or_nodes(&run));
        painter.part(area, part, |painter, view| {
            let below = limits_above(painter, area, view.limits.as_ref());
            painter.table(&line.nodes_pane, &view.table, below);
        });
    }
}

fn next_table(line: &mut LineView, forward: bool) {
    if let Some((_, run, _)) = line.runs_view.reported() {
        line.line_table = line.line_table.or_nodes(&run).beside(&run, forward);
        line.nodes_pane = TablePane::default();
    }
}

/// What the sections bear, where the case states limits and there is room; returns the area below.
fn limits_above(painter: &mut Painter, area: Rect, table: Option<&Table>) -> Rect {
    let lines = table.map_or_else(String::new, |table| table.to_text(area.width.into()));
    let height = u16::try_from(lines.lines().count()).unwrap_or(u16::MAX);
    // The nodes keep at least half of the room.
    if height == 0 || height >= area.height / 2 {
        return area;
    }
    let theme = painter.theme;
    let style = |line: &str| {
        if line.contains(limits::EXCEEDED) {
            theme.error()
        } else {
            theme.plain()
        }
    };
    painter.lines(area, lines.lines().map(|line| (line, style(line))));
    let [_, below] =
        Layout::vertical([Constraint::Length(height + 1), Constraint::Min(0)]).areas(area);
    below
}
