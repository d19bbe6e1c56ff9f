//! A system of lines drawn: from above, from the side, obliquely; the lines below the view.

use ratatui::layout::{Constraint, Layout, Rect};

use super::interface::{Pane, PaneInfo, about};
use crate::command::{Command, CommandId, main};
use crate::msg::Effect;
use crate::state::parts::ScreenPart;
use crate::state::{AppState, DocumentContent, SystemView};
use crate::view::painter::Painter;

/// Lines of the screen that a view has at least.
const VIEW: u16 = 9;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::CursorRight, &["l", "right"], "next view", "From above, from the side, obliquely"),
    main(CommandId::CursorLeft, &["h", "left"], "view before", "The view before"),
];

pub(super) struct SystemPane;

impl Pane for SystemPane {
    fn about(&self) -> PaneInfo {
        about("System", "Go to the views", &[COMMANDS])
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let DocumentContent::System(system) = &mut state.document.as_mut()?.content else {
            return None;
        };
        match id {
            CommandId::CursorRight => system.turn(1),
            CommandId::CursorLeft => system.turn(SystemView::VIEWS - 1),
            _ => return None,
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        painter.part(area, ScreenPart::Drawing, |painter, view| {
            let text = view.table.to_text(area.width.into());
            let wanted = u16::try_from(text.lines().count()).unwrap_or(u16::MAX);
            let rows = wanted.min(area.height.saturating_sub(VIEW));
            let [drawing, table] =
                Layout::vertical([Constraint::Min(VIEW), Constraint::Length(rows)]).areas(area);
            if let Some(chart) = &view.chart {
                painter.chart(chart, drawing);
            }
            let plain = painter.theme.plain();
            painter.lines(table, text.lines().map(|line| (line, plain)));
        });
    }
}
