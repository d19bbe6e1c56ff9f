//! The load cases of a file: a heat map of two axes, a table, the verdict of the checks; from each to the run behind it.

mod list;
mod map;
mod shade;

use ratatui::layout::Rect;

use super::interface::{Pane, PaneInfo, about};
use crate::command::{Command, CommandId, CommandOrder, DOWN, LIST, TABLE, command, main, other};
use crate::msg::Effect;
use crate::state::AppState;
use crate::state::sweeps::{OpenSweep, SweepTab, SweepsView};
use crate::update::tables::{self, OF_TABLE};
use crate::update::{sweep_view, sweeps};
use crate::view::layout;
use crate::view::paint::{rest, right, row, wrap};
use crate::view::painter::Painter;
use crate::visible;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::Open, &["enter"], "open", "From a cell or a sea to its load cases, from a load case to its run, from a check to its governing run"),
    main(CommandId::NextTable, &["]"], "view", "Show the next view: heat map, load cases, checks, seas"),
    main(CommandId::NextResult, &["n"], "result", "Show the next result; after those of the runs the share that each check uses"),
    main(CommandId::AxisAcross, &["x"], "across", "Another axis across"),
    main(CommandId::AxisDown, &["y"], "down", "Another axis down"),
    main(CommandId::Rule, &["m"], "rule", "The next rule for the load cases of a cell: greatest, least, mean"),
    main(CommandId::HoldNext, &[">"], "hold", "Hold an axis that is not shown at its next value; after the last: all of its values"),
    main(CommandId::Sort, &["o"], "sort", "Sort by the result shown, the greatest first; again: in the order of the load cases; checks and seas by a column"),
    other(CommandId::HoldPrevious, &["<"], "", "Hold an axis that is not shown at its previous value"),
    other(CommandId::OtherAxis, &["t"], "other axis", "Choose which of the axes that are not shown is held"),
    other(CommandId::NextSweep, &["}"], "next", "Show the next stored sweep of this file, an older one"),
    other(CommandId::Reload, &["r"], "read", "Read the sweep anew: another program may compute it"),
    other(CommandId::PreviousResult, &["p"], "", "Show the previous result"),
    other(CommandId::PreviousTable, &["["], "", "Show the previous view"),
    other(CommandId::PreviousSweep, &["{"], "", "Show the previous stored sweep of this file, a newer one"),
    command(CommandOrder::Document, CommandId::Back, &["esc", "b"], "back", "From the load cases of a cell back to the map; else to the list of cases"),
    command(CommandOrder::Motion, CommandId::CursorRight, &["l", "right"], "", "To the cell on the right; in the table: the next result"),
    command(CommandOrder::Motion, CommandId::CursorLeft, &["h", "left"], "", "To the cell on the left; in the table: the previous result"),
    DOWN,
];

/// What is of the heat map alone.
const OF_MAP: [CommandId; 6] = [
    CommandId::AxisAcross,
    CommandId::AxisDown,
    CommandId::Rule,
    CommandId::HoldNext,
    CommandId::HoldPrevious,
    CommandId::OtherAxis,
];

pub(super) struct SweepPane;

impl Pane for SweepPane {
    fn about(&self) -> PaneInfo {
        about("Sweep", "Go to the load cases", &[COMMANDS, LIST, TABLE])
    }

    fn commands(&self, state: &AppState) -> Vec<Command> {
        let mut all = self.about().commands.concat();
        let Some(view) = view(state) else {
            return all;
        };
        let is_listed = view.open.as_ref().is_some_and(|open| open.cell.is_some());
        let is_table = matches!(view.tab, SweepTab::Checks | SweepTab::Seas);
        let (tab, has_results) = (view.tab, [SweepTab::Map, SweepTab::LoadCases]);
        all.retain(|command| match command.id {
            CommandId::Sort => tab != SweepTab::Map,
            CommandId::Filter => is_listed || tab != SweepTab::Map,
            CommandId::Explain => tab != SweepTab::Map,
            id if OF_TABLE.contains(&id) => !is_listed && is_table,
            CommandId::NextResult | CommandId::PreviousResult => has_results.contains(&tab),
            id if OF_MAP.contains(&id) => tab == SweepTab::Map && !is_listed,
            _ => true,
        });
        all
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let view = view(state)?;
        let needs_sweep = match id {
            CommandId::Open | CommandId::NextResult | CommandId::PreviousResult => true,
            CommandId::Sort => true,
            id => OF_MAP.contains(&id),
        };
        if needs_sweep && view.open.is_none() {
            return Some("No sweep is shown; `:start_sweep` computes the load cases of the file.");
        }
        let open = view.open.as_ref();
        let others = open.map_or(0, |open| open.choice.others().count());
        match id {
            CommandId::HoldNext | CommandId::HoldPrevious if others == 0 => {
                Some("All axes of the load cases are shown.")
            }
            CommandId::OtherAxis if others < 2 => Some("At most one axis is not shown."),
            CommandId::AxisAcross | CommandId::AxisDown
                if open.is_some_and(|open| open.table.axes.len() < 2) =>
            {
                Some("The load cases have one axis only.")
            }
            CommandId::Sweep => Some("The load cases are shown."),
            CommandId::NextSweep | CommandId::PreviousSweep if view.stored.len() < 2 => {
                Some("No other sweep of this file is stored below runs.")
            }
            _ => None,
        }
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        match id {
            CommandId::Open => return Some(sweep_view::enter(state)),
            CommandId::OtherAxis => return Some(sweep_view::turn_other(state)),
            CommandId::HoldNext => return Some(sweep_view::hold(state, 1)),
            CommandId::HoldPrevious => return Some(sweep_view::hold(state, -1)),
            CommandId::NextSweep => return Some(sweeps::turn(state, 1)),
            CommandId::PreviousSweep => return Some(sweeps::turn(state, -1)),
            CommandId::Reload => return Some(sweeps::reload(state)),
            // Where no cell is open it goes back to the list of cases, as everywhere.
            CommandId::Back => {
                let left = tables::drop_filter(state) || sweep_view::leave(state);
                return left.then(Vec::new);
            }
            CommandId::NextTable => sweeps::turn_tab(state, 1),
            CommandId::PreviousTable => sweeps::turn_tab(state, SweepTab::ALL.len() - 1),
            CommandId::NextResult => sweep_view::turn_result(state, 1),
            CommandId::PreviousResult => sweep_view::turn_result(state, -1),
            CommandId::AxisAcross => sweep_view::turn_axis(state, false),
            CommandId::AxisDown => sweep_view::turn_axis(state, true),
            CommandId::Rule => sweep_view::turn_rule(state),
            CommandId::Sort if state.focused_table().is_some() => return None,
            CommandId::Sort => sweep_view::sort(state),
            CommandId::Explain if state.focused_table().is_none() => {
                return Some(tables::explain_result(state));
            }
            _ => sweep_view::go(state, id)?,
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(view) = view(painter.state) else {
            return;
        };
        let areas = layout::sweep(area);
        head(painter, areas.head, view);
        let wanted = view.wanted.as_deref();
        let open = view.open.as_ref();
        let Some(open) = open.filter(|open| Some(open.snapshot.dir.as_path()) == wanted) else {
            return painter.paragraph(areas.view, &without_sweep(view));
        };
        match (&open.cell, view.tab) {
            (Some(cell), _) => list::of_cell(painter, areas.view, open, cell),
            (None, SweepTab::Map) => map::draw(painter, areas.view, open),
            (None, SweepTab::LoadCases) => list::table(painter, areas.view, open),
            (None, SweepTab::Checks) => checks(painter, areas.view, view, open),
            (None, SweepTab::Seas) => seas(painter, areas.view, view, open),
        }
        if let Some(below) = areas.cell {
            list::under_cursor(painter, below, open);
        }
        if let Some(below) = areas.verdict.filter(|_| view.tab != SweepTab::Checks) {
            checks(painter, below, view, open);
        }
    }
}

fn view(state: &AppState) -> Option<&SweepsView> {
    state.document.as_ref()?.sweeps()
}

/// The names of the views, and how far the sweep is.
fn head(painter: &mut Painter, line: Rect, view: &SweepsView) {
    let after = painter.tabs(line, SweepTab::NAMES, Some(view.tab.place()));
    let far = view.open.as_ref().map_or_else(String::new, |open| {
        let (done, of) = (open.table.done(), open.table.states.len());
        let failed = match open.table.failed() {
            0 => String::new(),
            failed => format!(", {failed} failed"),
        };
        format!("{done} of {of} done{failed}")
    });
    let count = view.stored.len();
    let which = match view.place() {
        Some(place) if count > 1 => format!("  sweep {} of {count}", place + 1),
        _ => String::new(),
    };
    let faint = painter.theme.faint();
    painter.text(rest(line, after.x + 1), &format!("{far}{which}"), faint);
    let text = painter.state.editor().map_or("", |editor| &editor.text);
    let open = view.open.as_ref();
    if open.is_some_and(|open| view.comparison.differs(&open.snapshot.dir, text)) {
        let style = painter.theme.warning();
        right(painter.buf, line, " not of these inputs", style);
    }
}

/// Why no sweep is shown.
fn without_sweep(view: &SweepsView) -> String {
    if let Some(why) = &view.failure {
        return why.clone();
    }
    match (&view.wanted, &view.job) {
        (Some(dir), _) => format!("Reading {}.", visible::path(dir)),
        (None, Some(_)) => "The load cases are read.".to_owned(),
        (None, None) => {
            "No sweep of this file is stored below runs. `:start_sweep` computes all load cases in the background.".to_owned()
        }
    }
}

/// The verdict, and what governs the check under the cursor.
fn checks(painter: &mut Painter, area: Rect, view: &SweepsView, open: &OpenSweep) {
    let Some(verdict) = &open.verdict else {
        let words = if view.checking { "Computing." } else { "" };
        return painter.paragraph(area, words);
    };
    if verdict.governing.is_empty() {
        let words = "No check is for these load cases. `[[checks]]` tables in the file hold them to limits.";
        return painter.paragraph(area, words);
    }
    let selected = open.checks_pane.selected(&verdict.checks);
    let governing = selected.and_then(|place| verdict.governing.get(place));
    let words = governing.map_or(&[][..], |of| &of.words);
    let lines: Vec<String> = words
        .iter()
        .flat_map(|line| wrap(line, area.width.into()))
        .collect();
    let height = u16::try_from(lines.len())
        .unwrap_or(0)
        .min(area.height * 2 / 5);
    let above = Rect {
        height: area.height.saturating_sub(height),
        ..area
    };
    painter.table(&open.checks_pane, &verdict.checks, above);
    let plain = painter.theme.plain();
    for (at, line) in (above.height..area.height).zip(&lines) {
        painter.text(row(area, at), line, plain);
    }
    older(painter, area, open);
}

/// What the seeds of each sea say together.
fn seas(painter: &mut Painter, area: Rect, view: &SweepsView, open: &OpenSweep) {
    match &open.verdict {
        Some(verdict) if !verdict.seas.rows.is_empty() => {
            painter.table(&open.seas_pane, &verdict.seas, area);
            older(painter, area, open);
        }
        Some(_) => painter.paragraph(area, "Equilibria without checks have no seas."),
        None if view.checking => painter.paragraph(area, "Computing."),
        None => {}
    }
}

/// Says that runs have ended since.
fn older(painter: &mut Painter, area: Rect, open: &OpenSweep) {
    let known = open.verdict.as_ref().map(|verdict| verdict.done);
    if let Some(known) = known.filter(|known| *known != open.table.done()) {
        let style = painter.theme.warning();
        let words = format!(" of the first {known} load cases done");
        right(painter.buf, row(area, 0), &words, style);
    }
}
