//! A file that is no line case: its inputs, its drawing, its tables with their charts, its validation.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Canvas;
use super::paint::text;
use super::papers::NO_PUBLISHED_VALUES;
use crate::reference;
use crate::section::picture;
use crate::tui::inks::Inks;
use crate::tui::place::Place;
use crate::tui::plot_pane::draw_chart;
use crate::tui::state::{Content, OpenFile};

impl Canvas<'_> {
    pub(super) fn file(&mut self, place: Place, area: Rect, file: &OpenFile) {
        let inks = Inks::new(self.state.looks.colour);
        let glyphs = self.state.looks.glyphs;
        match (place, &file.content) {
            (Place::Tables, _) => self.leaf(area, file),
            (Place::Checks, _) if file.checks.is_empty() => {
                self.paragraph(area, NO_PUBLISHED_VALUES);
            }
            (Place::Checks, _) => {
                let table = reference::table(&file.checks);
                file.checks_pane.draw(&table, area, self.buf, glyphs, inks);
            }
            (Place::Drawing, Content::Section(section)) => {
                let chart = section.view.chart(&picture::chart(&section.design));
                draw_chart(&chart, area, self.buf, glyphs, inks);
            }
            (Place::Ropeway, Content::Ropeway(ropeway)) => self.ropeway_picture(area, ropeway),
            (Place::Ship, Content::Ship(ship)) => self.ship_from_above(area, ship),
            _ => self.inputs(area, &file.sheet),
        }
    }

    /// The names of the leaves, and the one that is shown: its chart above its table.
    fn leaf(&mut self, area: Rect, file: &OpenFile) {
        let [tabs, rest] =
            Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
        let leaves = file.content.view().leaves();
        let mut x = tabs.x;
        for (i, name) in leaves.iter().enumerate() {
            let style = if i == file.leaf {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            let room = tabs.right().saturating_sub(x);
            x = text(self.buf, (x, tabs.y), room, &format!(" {name} "), style);
        }
        let (chart, table) = file.shown();
        let inks = Inks::new(self.state.looks.colour);
        let glyphs = self.state.looks.glyphs;
        let below = match chart {
            None => rest,
            Some(chart) => {
                let [upper, lower] =
                    Layout::vertical([Constraint::Fill(1), Constraint::Fill(1)]).areas(rest);
                draw_chart(&chart, upper, self.buf, glyphs, inks);
                lower
            }
        };
        if let Some(pane) = file.panes.get(file.leaf) {
            pane.draw(&table, below, self.buf, glyphs, inks);
        }
    }
}
