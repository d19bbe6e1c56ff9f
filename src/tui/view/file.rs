//! A file that is no line case: its inputs, its drawing, its tables with their charts, its validation.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Painter;
use super::paint::text;
use super::results::NO_PUBLISHED_VALUES;
use crate::reference;
use crate::report::section::drawing;
use crate::tui::pane::PaneId;
use crate::tui::plot_pane::draw_chart;
use crate::tui::state::{Content, OpenFile};

impl Painter<'_> {
    pub(super) fn file(&mut self, place: PaneId, area: Rect, file: &OpenFile) {
        let glyphs = self.state.capabilities.glyphs;
        match (place, &file.content) {
            (PaneId::Tables, _) => self.tab(area, file),
            (PaneId::Checks, _) if file.checks.is_empty() => {
                self.paragraph(area, NO_PUBLISHED_VALUES);
            }
            (PaneId::Checks, _) => {
                let table = reference::table(&file.checks);
                file.checks_pane
                    .draw(&table, area, self.buf, glyphs, self.theme);
            }
            (PaneId::Drawing, Content::Section(section)) => {
                let chart = section.view.chart(&drawing::chart(&section.design));
                draw_chart(&chart, area, self.buf, glyphs, self.theme);
            }
            (PaneId::Ropeway, Content::Ropeway(ropeway)) => self.ropeway_picture(area, ropeway),
            (PaneId::Ship, Content::Ship(ship)) => self.ship_from_above(area, ship),
            _ => self.inputs(area, &file.editor),
        }
    }

    /// The names of the tabs, and the one that is shown: its chart above its table.
    fn tab(&mut self, area: Rect, file: &OpenFile) {
        let [names, rest] =
            Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
        let tabs = file.content.view().tabs();
        let mut x = names.x;
        for (i, name) in tabs.iter().enumerate() {
            let style = if i == file.tab {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            let room = names.right().saturating_sub(x);
            x = text(self.buf, (x, names.y), room, &format!(" {name} "), style);
        }
        let (chart, table) = file.shown();
        let glyphs = self.state.capabilities.glyphs;
        let below = match chart {
            None => rest,
            Some(chart) => {
                let [upper, lower] =
                    Layout::vertical([Constraint::Fill(1), Constraint::Fill(1)]).areas(rest);
                draw_chart(&chart, upper, self.buf, glyphs, self.theme);
                lower
            }
        };
        if let Some(pane) = file.panes.get(file.tab) {
            pane.draw(&table, below, self.buf, glyphs, self.theme);
        }
    }
}
