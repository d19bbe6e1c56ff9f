//! Plan view of a ship, with a list of its equilibria.

use ratatui::layout::{Constraint, Layout, Rect};

use super::interface::{Pane, PaneInfo, about};
use crate::command::{self, CommandId, DOWN};
use crate::msg::Effect;
use crate::part_views::ship::LIST;
use crate::state::parts::ScreenPart;
use crate::state::{AppState, DocumentContent};
use crate::update::motion::{moved, step};
use crate::view::painter::Painter;

pub(super) struct ShipPane;

impl Pane for ShipPane {
    fn about(&self) -> PaneInfo {
        about("Ship", "Go to the drawing", &[&[DOWN], command::LIST])
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let by = step(state, id)?;
        if let DocumentContent::Ship(ship) = &mut state.document.as_mut()?.content {
            let count = ship.statics.equilibria.as_ref().map_or(0, Vec::len);
            ship.equilibrium = moved(ship.equilibrium, by, count);
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        painter.part(area, ScreenPart::Drawing, |painter, view| {
            let [drawing, list] =
                Layout::horizontal([Constraint::Min(0), Constraint::Length(LIST)]).areas(area);
            if let Some(chart) = &view.chart {
                painter.chart(chart, drawing);
            }
            let theme = painter.theme;
            let words = view.words.iter();
            painter.lines(
                list,
                words.map(|(words, style)| (words, theme.cell(*style))),
            );
        });
    }
}
