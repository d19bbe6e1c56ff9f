//! Natural modes: their table, and the shape of the one selected.

use std::path::PathBuf;
use std::sync::Arc;

use ratatui::layout::{Constraint, Layout, Rect};

use super::interface::{Pane, PaneInfo, about};
use crate::command::{COLUMNS, Command, CommandId, LIST, TABLE, main, other};
use crate::modes::LineModes;
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::report::modes as views;
use crate::state::AppState;
use crate::state::modes::ModesView;
use crate::table::Table;
use crate::update::export;
use crate::update::motion::table_verb;
use crate::view::layout;
use crate::view::painter::Painter;

/// From this room on both pictures are seen at once.
const BOTH: (u16, u16) = (110, 24);

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::Down, &["j", "down"], "mode", "Select the next mode"),
    main(CommandId::NextChart, &["]", "n"], "picture", "Show the mode along the lines, or over the lines at rest"),
    main(CommandId::Write, &["w"], "write", "Write the modes with their shapes as CSV"),
    other(CommandId::PreviousChart, &["[", "p"], "", "Show the mode along the lines, or over the lines at rest"),
];

pub(super) struct ModesPane;

/// Whether the table of the modes has its narrow form.
#[must_use]
pub fn is_narrow(state: &AppState) -> bool {
    let area = layout::pane_area(state, PaneId::Modes);
    area.is_none_or(|area| area.width < BOTH.0)
}

/// The modes computed last, if any.
fn computed(view: &ModesView) -> Option<Arc<LineModes>> {
    match &view.found {
        Some(Ok(found)) => Some(Arc::clone(found)),
        _ => None,
    }
}

impl Pane for ModesPane {
    fn about(&self) -> PaneInfo {
        about(
            "Modes",
            "Go to the natural modes",
            &[COMMANDS, LIST, TABLE, COLUMNS],
        )
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let of_modes = matches!(
            id,
            CommandId::Write
                | CommandId::Down
                | CommandId::Up
                | CommandId::NextChart
                | CommandId::PreviousChart
        );
        let none = of_modes && computed(state.modes()?).is_none();
        none.then_some("There are no modes yet.")
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let (verb, narrow) = (table_verb(state, id), is_narrow(state));
        let (view, editor) = state.document.as_mut()?.modes_and_editor()?;
        match id {
            CommandId::NextChart | CommandId::PreviousChart => view.over = !view.over,
            CommandId::Write => {
                let path = PathBuf::from(format!("{}-modes.csv", editor.stem()));
                let text = computed(view).map(|modes| views::csv(&modes));
                return Some(export::write(path, text, "The table of modes"));
            }
            _ => {
                let verb = verb?;
                let modes = computed(view)?;
                let table = match narrow {
                    true => views::narrow(&modes),
                    false => views::table(&modes),
                };
                view.pane.act(verb, &table);
            }
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let (Some(view), Some(editor)) = (painter.state.modes(), painter.state.editor()) else {
            return;
        };
        let modes = match &view.found {
            Some(Ok(modes)) => modes,
            Some(Err(why)) => {
                return painter.paragraph(area, &format!("There are no modes: {why}"));
            }
            None => return painter.paragraph(area, "The modes are computed in the background."),
        };
        let both = area.width >= BOTH.0 && area.height >= BOTH.1;
        let lines = u16::try_from(modes.modes.len() + 2).unwrap_or(u16::MAX);
        let most = if both {
            area.height / 2
        } else {
            area.height * 9 / 20
        };
        let [table, note, pictures] = Layout::vertical([
            Constraint::Length(lines.min(most)),
            Constraint::Length(1),
            Constraint::Min(0),
        ])
        .areas(area);
        let whole = if area.width < BOTH.0 {
            views::narrow(modes)
        } else {
            views::table(modes)
        };
        let bare = Table {
            notes: Vec::new(),
            ..whole
        };
        painter.table(&view.pane, &bare, table);
        status(
            painter,
            note,
            view.text != editor.text,
            &views::instability_notes(modes),
        );
        let number = view.pane.selected(&bare).unwrap_or(0);
        shapes(painter, pictures, modes, number, both, view.over);
    }
}

/// What must be known of the modes, the most pressing first.
fn status(painter: &mut Painter, line: Rect, old: bool, problems: &[String]) {
    let (words, style) = match (old, problems.first()) {
        (true, _) => (
            "Of the file before the last edit; being computed again.",
            painter.theme.warning(),
        ),
        (false, Some(note)) => (note.as_str(), painter.theme.warning()),
        (false, None) => (
            "About the line at rest; added mass in, drag out; errors from half the mesh.",
            painter.theme.faint(),
        ),
    };
    painter.text(line, words, style);
}

fn shapes(
    painter: &mut Painter,
    area: Rect,
    modes: &LineModes,
    number: usize,
    both: bool,
    over: bool,
) {
    let along = views::chart(modes, &[number]);
    let shape = views::over_line(modes, number);
    if both {
        let [left, right] =
            Layout::horizontal([Constraint::Fill(1), Constraint::Fill(1)]).areas(area);
        painter.chart(&along, left);
        painter.chart(&shape, right);
    } else {
        painter.chart(if over { &shape } else { &along }, area);
    }
}
