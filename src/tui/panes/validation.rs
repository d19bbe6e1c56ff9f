//! The validation table, of every kind of file.

use std::path::PathBuf;

use ratatui::layout::Rect;

use super::interface::{Pane, PaneInfo, about};
use crate::command::{self, COLUMNS, Command, CommandId, DOWN, LIST, SORT, TABLE};
use crate::msg::Effect;
use crate::report::text;
use crate::state::AppState;
use crate::update::export::{self, TEXT_WIDTH};
use crate::update::motion::table_verb;
use crate::view::painter::Painter;

/// What is shown in the place of a validation table that would be empty.
const NO_PUBLISHED_VALUES: &str = "This file states no published values to compare with.";

const COMMANDS: &[Command] = &[
    command::write("Write the validation table to a text file"),
    SORT,
    DOWN,
];

pub(super) struct ValidationPane;

impl Pane for ValidationPane {
    fn about(&self) -> PaneInfo {
        about(
            "Validation",
            "Go to the validation table",
            &[COMMANDS, LIST, TABLE, COLUMNS],
        )
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let checks = state.document.as_ref()?.kind().checks();
        let empty = checks.is_none_or(|checks| checks.rows.is_empty());
        (id == CommandId::Write && empty).then_some(NO_PUBLISHED_VALUES)
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let verb = table_verb(state, id);
        let document = state.document.as_mut()?;
        let checks = document.content.kind().checks()?;
        if id == CommandId::Write {
            let words = match document.line() {
                Some(_) => checks.table.to_text(TEXT_WIDTH),
                None => text::validation(&checks.rows),
            };
            let path = PathBuf::from(format!("{}-validation.txt", document.editor.stem()));
            return Some(export::write(path, Some(words), "The validation table"));
        }
        document.checks_pane.act(verb?, &checks.table);
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(document) = &painter.state.document else {
            return;
        };
        let checks = document.kind().checks();
        let line = document.line();
        let is_open = line.is_some_and(|line| line.checking.is_open());
        let Some(checks) = checks.filter(|checks| !checks.rows.is_empty()) else {
            let words = if is_open {
                "Computing."
            } else {
                NO_PUBLISHED_VALUES
            };
            return painter.paragraph(area, words);
        };
        painter.table(&document.checks_pane, &checks.table, area);
        if is_open {
            painter.older(area);
        }
    }
}
