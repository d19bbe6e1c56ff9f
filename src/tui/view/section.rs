//! A cross-section: drawing and tables.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Canvas;
use super::paint::text;
use crate::section::picture;
use crate::tui::command::Place;
use crate::tui::inks::Inks;
use crate::tui::plot_pane::draw_chart;
use crate::tui::state::OpenSection;
use crate::tui::state::section::TABLES;

impl Canvas<'_> {
    pub(super) fn section(&mut self, place: Place, area: Rect, section: &OpenSection) {
        match place {
            Place::Drawing => {
                let chart = section.view.chart(&picture::chart(&section.design));
                let inks = Inks::new(self.state.looks.colour);
                draw_chart(&chart, area, self.buf, self.state.looks.glyphs, inks);
            }
            Place::Tables => self.section_tables(area, section),
            _ => self.inputs(area, &section.sheet),
        }
    }

    fn section_tables(&mut self, area: Rect, section: &OpenSection) {
        let [tabs, rest] =
            Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
        let mut x = tabs.x;
        for (i, name) in TABLES.iter().enumerate() {
            let style = if i == section.table {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            let room = tabs.right().saturating_sub(x);
            x = text(self.buf, (x, tabs.y), room, &format!(" {name} "), style);
        }
        let inks = Inks::new(self.state.looks.colour);
        let glyphs = self.state.looks.glyphs;
        let pane = &section.panes[section.table];
        pane.draw(&section.shown(), rest, self.buf, glyphs, inks);
    }
}
