//! What the file is made of: its tables as a list, with the scene drawn beside it.

use ratatui::layout::{Constraint, Layout, Rect};
use unicode_width::UnicodeWidthStr;

use super::interface::{Pane, PaneInfo, about};
use crate::case::structure::OutlineRow;
use crate::command::{self, Command, CommandId, FILTER, LIST, main, other};
use crate::msg::Effect;
use crate::plots;
use crate::report::figures::FigureId;
use crate::state::parts::ScreenPart;
use crate::state::{AppState, DocumentContent};
use crate::update::build;
use crate::update::motion::{moved, step};
use crate::view::paint::{rest, span, wrap};
use crate::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::Open, &["enter"], "keys", "Open all keys of the table under the cursor as a form; on a heading: add one"),
    main(CommandId::Add, &["a"], "add", "Add a table here or to the file, a line type of the library, a parameter"),
    main(CommandId::Remove, &["d"], "remove", "Remove the table under the cursor with all tables in it"),
    main(CommandId::CopyTable, &["c"], "copy", "Copy the table under the cursor under another name"),
    main(CommandId::Rename, &["n"], "rename", "Give the table under the cursor another name wherever the file uses it"),
    main(CommandId::Divide, &["|"], "divide", "Divide the line or section under the cursor into two"),
    other(CommandId::MoveUp, &["<"], "up", "Move the table under the cursor before the one before it"),
    other(CommandId::MoveDown, &[">"], "down", "Move the table under the cursor behind the one behind it"),
    FILTER,
    command::command(command::CommandOrder::Document, CommandId::Back, &["esc", "b"], "back", "Back to the first pane"),
    command::command(command::CommandOrder::Setup, CommandId::Model, &["B"], "", "Back to the first pane"),
    command::DOWN,
];

/// Columns of the list where the scene is drawn beside it, and those that the scene needs.
const LIST_COLUMNS: u16 = 44;
const DRAWING_COLUMNS: u16 = 30;

/// Lines of help below the list.
const HELP: u16 = 3;

pub(super) struct ModelPane;

impl Pane for ModelPane {
    fn about(&self) -> PaneInfo {
        about("Model", "Go to the model", &[COMMANDS, LIST])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let row = state.editor()?.model.current();
        let of_table = matches!(
            id,
            CommandId::Remove
                | CommandId::CopyTable
                | CommandId::Rename
                | CommandId::Divide
                | CommandId::MoveUp
                | CommandId::MoveDown
        );
        match row {
            None if of_table || id == CommandId::Open => Some("The file has no tables."),
            Some(row) if of_table && row.is_heading => {
                Some("This is a heading; the tables are below it.")
            }
            Some(row) if id == CommandId::Divide && !can_be_divided(row) => {
                Some("Lines and their sections are divided; the cursor is on neither.")
            }
            _ => None,
        }
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        Some(match id {
            CommandId::Open => build::open(state),
            CommandId::Add => build::add(state),
            CommandId::Remove => build::remove(state),
            CommandId::CopyTable => build::copy(state),
            CommandId::Rename => build::rename(state),
            CommandId::Divide => build::divide(state),
            CommandId::MoveUp => build::shift(state, false),
            CommandId::MoveDown => build::shift(state, true),
            CommandId::Back | CommandId::Model => {
                let document = state.document.as_mut()?;
                document.pane = document.kind().info().first;
                Vec::new()
            }
            _ => {
                let by = step(state, id)?;
                let model = &mut state.editor_mut()?.model;
                let lines = model.shown().len();
                model.cursor = moved(model.cursor, by, lines);
                Vec::new()
            }
        })
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(document) = &painter.state.document else {
            return;
        };
        let model = &document.editor.model;
        let drawn = area.width >= LIST_COLUMNS + DRAWING_COLUMNS;
        let [left, right] = match drawn {
            true => Layout::horizontal([
                Constraint::Length(LIST_COLUMNS.max(area.width * 2 / 5)),
                Constraint::Min(0),
            ])
            .areas(area),
            false => [area, Rect::default()],
        };
        let [list, help] =
            Layout::vertical([Constraint::Min(0), Constraint::Length(HELP)]).areas(left);
        let shown = model.shown();
        let list = painter.filter_line(list, &model.filter, (shown.len(), model.rows.len()));
        painter.list(list, model.cursor, shown.len(), |painter, line, i| {
            row_line(painter, line, shown[i], i == model.cursor);
        });
        if let Some(row) = model.current() {
            let words = match row.summary.is_empty() {
                true => row.help.to_owned(),
                false => format!("{}\n{}", row.summary, row.help),
            };
            let faint = painter.theme.faint();
            let width = usize::from(help.width.saturating_sub(1));
            let lines = wrap(&words, width).into_iter();
            painter.lines(help, lines.map(|line| (line, faint)));
        }
        if drawn {
            scene(painter, rest(right, right.x + 1));
        }
    }
}

/// Whether a table is a line or a section of one.
fn can_be_divided(row: &OutlineRow) -> bool {
    let parts: Vec<&str> = row.path.split('.').collect();
    matches!(
        parts.as_slice(),
        ["line" | "lines", _] | ["lines", .., "sections", _]
    )
}

fn row_line(painter: &mut Painter, line: Rect, row: &OutlineRow, selected: bool) {
    let style = painter.line_style(selected);
    painter.buf.set_style(line, style);
    let indent = u16::try_from(2 * row.depth + 1).unwrap_or(1);
    let at = span(line, indent, line.width);
    let name = match row.is_heading {
        true => style.patch(painter.theme.faint()),
        false => style.patch(painter.theme.strong()),
    };
    painter.text(at, &row.name, name);
    let used = u16::try_from(row.name.width()).unwrap_or(0);
    let from = (indent + used + 2).max(indent + 14).min(line.width);
    painter.text(rest(line, line.x + from), &row.summary, style);
}

/// The scene as it is: the line at rest or in motion, or the view of the model.
fn scene(painter: &mut Painter, area: Rect) {
    let state = painter.state;
    let Some(document) = &state.document else {
        return;
    };
    match &document.content {
        DocumentContent::Line(_) => {
            let Some(on) = state.charted() else { return };
            painter.chart(&plots::chart(on, FigureId::Shape), area);
        }
        DocumentContent::Section(section) => {
            painter.part(area, ScreenPart::Drawing, |painter, view| {
                if let Some(base) = &view.chart {
                    painter.chart(&section.view.chart(base), area);
                }
            });
        }
        _ => painter.part(area, ScreenPart::Drawing, |painter, view| {
            match &view.chart {
                Some(chart) => painter.chart(chart, area),
                None => painter.paragraph(area, "There is nothing to be drawn."),
            }
        }),
    }
}
