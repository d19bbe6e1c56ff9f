//! Tables of a file other than a line case, each with its chart, behind tabs.

use ratatui::layout::{Constraint, Layout, Rect};

use super::interface::{Pane, PaneInfo, about};
use crate::command::{COLUMNS, Command, CommandId, DOWN, LIST, SORT, TABLE, main, other};
use crate::msg::Effect;
use crate::state::parts::ScreenPart;
use crate::state::ship::MOTIONS;
use crate::state::{AppState, DocumentContent};
use crate::update::motion::table_verb;
use crate::update::ship;
use crate::view::paint::below_head;
use crate::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::NextTable, &["]", "n"], "table", "Show the next table"),
    main(CommandId::NextTrace, &["c"], "motion", "Draw the next of a ship's six motions alone; after the last: all of them"),
    other(CommandId::PreviousTable, &["[", "p"], "", "Show the previous table"),
    SORT,
    DOWN,
];

pub(super) struct TablesPane;

impl Pane for TablesPane {
    fn about(&self) -> PaneInfo {
        about(
            "Tables",
            "Go to the tables",
            &[COMMANDS, LIST, TABLE, COLUMNS],
        )
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let document = state.document.as_ref()?;
        let of_motions = match &document.content {
            DocumentContent::Ship(ship) => document.tab == MOTIONS && ship.has_motion(),
            _ => return (id == CommandId::NextTrace).then_some("Only a ship has six motions."),
        };
        (id == CommandId::NextTrace && !of_motions).then_some(
            "The motions of the ship have a table of their own; `:next_table` goes there.",
        )
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let verb = table_verb(state, id);
        let document = state.document.as_mut()?;
        let tabs = document.tables.len().max(1);
        match (id, &mut document.content) {
            (CommandId::NextTable, _) => document.tab = (document.tab + 1) % tabs,
            (CommandId::PreviousTable, _) => document.tab = (document.tab + tabs - 1) % tabs,
            (CommandId::NextTrace, DocumentContent::Ship(ship)) => ship::next_motion(ship),
            _ => {
                let verb = verb?;
                let shown = document.parts.last(ScreenPart::Tab(document.tab));
                if let Some(view) = shown
                    && let Some(pane) = document.tables.get_mut(document.tab)
                {
                    pane.act(verb, &view.table);
                }
            }
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(document) = &painter.state.document else {
            return;
        };
        let [names, rest] = below_head(area);
        painter.tabs(names, document.kind().info().tabs, Some(document.tab));
        painter.part(rest, ScreenPart::Tab(document.tab), |painter, view| {
            let below = match &view.chart {
                None => rest,
                Some(chart) => {
                    let [upper, lower] =
                        Layout::vertical([Constraint::Fill(1), Constraint::Fill(1)]).areas(rest);
                    painter.chart(chart, upper);
                    lower
                }
            };
            if let Some(pane) = document.tables.get(document.tab) {
                painter.table(pane, &view.table, below);
            }
        });
    }
}
