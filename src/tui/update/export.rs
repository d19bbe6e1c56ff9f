//! The export made of a run: validation table, report, charts and tables as text and as CSV.

use std::path::PathBuf;
use std::sync::Arc;

use super::{moved, reported};
use crate::report::chart::Map;
use crate::report::table::Table;
use crate::tui::command::Id;
use crate::tui::facade;
use crate::tui::msg::Effect;
use crate::tui::pane::PaneId;
use crate::tui::plots;
use crate::tui::state::{AppState, OpenCase};
use crate::tui::table_pane::{TablePane, TableVerb};

/// Width of texts that are written to files.
const PAPER_WIDTH: usize = 100;

/// The table of the line that is shown of the chosen run.
pub(super) fn line_table(open: &OpenCase) -> Option<Table> {
    let (_, run, _) = reported(open).filter(|(_, run, _)| !run.profile.nodes.is_empty())?;
    Some(open.line_table.or_nodes(&run).table(&run))
}

/// Leafs through the tables of the line.
pub(super) fn next_table(state: &mut AppState, forward: bool) -> Vec<Effect> {
    if let Some(open) = &mut state.open
        && let Some((_, run, _)) = reported(open)
    {
        open.line_table = open.line_table.or_nodes(&run).beside(&run, forward);
        open.nodes_pane = TablePane::default();
    }
    Vec::new()
}

/// Words the report of the chosen run.
pub(super) fn write_report(state: &mut AppState) {
    let Some(open) = &mut state.open else {
        return;
    };
    let Some((name, run, _)) = reported(open) else {
        open.report = None;
        return;
    };
    let text = match facade::parse(&run.case_text, &open.editor.file) {
        Ok(case) => {
            let variants = vec![(None, Arc::clone(&run))];
            let same = run.case_text == open.editor.text;
            let rows = if same {
                open.checks.clone()
            } else {
                facade::checks(&case, &variants)
            };
            facade::report(&run, &case, &rows)
        }
        Err(problem) => problem,
    };
    open.report = Some((name, text));
}

/// What the panes with text on them do: write to a file, scroll sideways.
pub(super) fn paper(state: &mut AppState, id: Id) -> Vec<Effect> {
    let glyphs = state.capabilities.glyphs;
    let Some(open) = &mut state.open else {
        return Vec::new();
    };
    let stem = open.editor.file.trim_end_matches(".toml").to_owned();
    match (id, open.pane) {
        (Id::Write, PaneId::Report) => {
            let dir = reported(open).and_then(|(_, _, dir)| dir);
            let path = dir.map_or_else(
                || PathBuf::from(format!("{stem}-report.txt")),
                |dir| dir.join("report.txt"),
            );
            write(
                path,
                open.report.as_ref().map(|(_, t)| t.clone()),
                "The report",
            )
        }
        (Id::Write, PaneId::Validation) => {
            let text = facade::checks_table(&open.checks).to_text(PAPER_WIDTH);
            write(
                PathBuf::from(format!("{stem}-validation.txt")),
                Some(text),
                "The validation table",
            )
        }
        (Id::Write, PaneId::Nodes) => {
            let shown = reported(open).map(|(_, run, _)| {
                let table = open.line_table.or_nodes(&run);
                (table.name(), table.csv(&run))
            });
            let name = shown.as_ref().map_or("nodes", |(name, _)| name);
            let path = PathBuf::from(format!("{stem}-{name}.csv"));
            write(path, shown.map(|(_, text)| text), "The table")
        }
        (Id::Write, _) => {
            let chart = open.views[open.chart.index()].chart(&plots::chart(open, open.chart));
            let text = crate::report::chart::draw(&chart, PAPER_WIDTH, 30, glyphs).to_text();
            let name = open.chart.title().to_lowercase();
            let path = |end: &str| PathBuf::from(format!("{stem}-{name}.{end}"));
            let mut effects = write(path("txt"), Some(text), "The chart");
            // A map is worth more as numbers.
            let csv = chart.map.as_ref().map(Map::csv);
            effects.extend(write(path("csv"), csv, "The map"));
            effects
        }
        (_, PaneId::Validation) => {
            let table = facade::checks_table(&open.checks);
            open.checks_pane.act(table_verb(id), &table);
            Vec::new()
        }
        (_, PaneId::Nodes) => {
            if let Some(table) = line_table(open) {
                open.nodes_pane.act(table_verb(id), &table);
            }
            Vec::new()
        }
        _ => {
            let across = &mut open.report_scroll.1;
            *across = moved(*across, if id == Id::ScrollRight { 8 } else { -8 }, 400);
            Vec::new()
        }
    }
}

pub(super) fn table_verb(id: Id) -> TableVerb {
    match id {
        Id::ScrollLeft => TableVerb::Left,
        Id::ScrollRight => TableVerb::Right,
        _ => TableVerb::SortNext,
    }
}

pub(super) fn write(path: PathBuf, text: Option<String>, what: &'static str) -> Vec<Effect> {
    text.map(|text| Effect::WriteText { path, text, what })
        .into_iter()
        .collect()
}
