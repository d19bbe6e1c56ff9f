//! Tables of a file other than a line case, each with its chart, behind tabs.

use ratatui::layout::{Constraint, Layout, Rect};

use super::{About, Pane, about};
use crate::tui::command::{Command, DOWN, Id, LIST, SORT, WIDE, main, other};
use crate::tui::msg::Effect;
use crate::tui::state::{AppState, Content};
use crate::tui::update::motion::table_verb;
use crate::tui::update::ship;
use crate::tui::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(Id::NextTable, &["]", "n"], "table", "Show the next table"),
    main(Id::NextTrace, &["c"], "motion", "Draw the next of a ship's six motions alone; after the last: all of them"),
    other(Id::PreviousTable, &["[", "p"], "", "Show the previous table"),
    SORT,
    DOWN,
];

pub(super) struct Tables;

impl Pane for Tables {
    fn about(&self) -> About {
        about("Tables", "Go to the tables", &[COMMANDS, LIST, WIDE])
    }

    fn reason(&self, state: &AppState, id: Id) -> Option<&'static str> {
        let ship = matches!(state.document.as_ref()?.content, Content::Ship(_));
        (id == Id::NextTrace && !ship).then_some("Only a ship has six motions.")
    }

    fn update(&self, state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
        let verb = table_verb(state, id);
        let document = state.document.as_mut()?;
        let tabs = document.tables.len().max(1);
        match (id, &mut document.content) {
            (Id::NextTable, _) => document.tab = (document.tab + 1) % tabs,
            (Id::PreviousTable, _) => document.tab = (document.tab + tabs - 1) % tabs,
            (Id::NextTrace, Content::Ship(ship)) => ship::next_motion(ship),
            _ => {
                let verb = verb?;
                let (_, table) = document.shown();
                if let Some(pane) = document.tables.get_mut(document.tab) {
                    pane.act(verb, &table);
                }
            }
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(document) = &painter.state.document else {
            return;
        };
        let [names, rest] =
            Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
        painter.tabs(names, document.kind().tabs(), Some(document.tab));
        let (chart, table) = document.shown();
        let below = match chart {
            None => rest,
            Some(chart) => {
                let [upper, lower] =
                    Layout::vertical([Constraint::Fill(1), Constraint::Fill(1)]).areas(rest);
                painter.chart(&chart, upper);
                lower
            }
        };
        if let Some(pane) = document.tables.get(document.tab) {
            painter.table(pane, &table, below);
        }
    }
}
