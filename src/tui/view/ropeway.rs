//! A ropeway: the slider, its picture, the readings, tables with their charts.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Canvas;
use super::paint::{row, text};
use crate::reference;
use crate::report::chart::Glyphs;
use crate::report::number::{percent, rounded};
use crate::report::table::Table;
use crate::ropeway::exact::Carrier;
use crate::ropeway::{Readings, picture, tables};
use crate::tui::command::Place;
use crate::tui::inks::Inks;
use crate::tui::plot_pane::draw_chart;
use crate::tui::state::OpenRopeway;
use crate::tui::state::ropeway::LEAVES;

/// Lines that the readings take: head, rule, and a line each.
const READINGS: u16 = 9;

impl Canvas<'_> {
    pub(super) fn ropeway(&mut self, place: Place, area: Rect, ropeway: &OpenRopeway) {
        match place {
            Place::Ropeway => self.ropeway_picture(area, ropeway),
            Place::RopewayTables => self.ropeway_leaf(area, ropeway),
            Place::RopewayChecks => {
                let table = reference::table(&ropeway.checks);
                let inks = Inks::new(self.state.looks.colour);
                let glyphs = self.state.looks.glyphs;
                ropeway
                    .checks_pane
                    .draw(&table, area, self.buf, glyphs, inks);
            }
            _ => self.inputs(area, &ropeway.sheet),
        }
    }

    fn ropeway_picture(&mut self, area: Rect, ropeway: &OpenRopeway) {
        let readings = match &ropeway.readings {
            Ok(readings) => readings,
            Err(trouble) => {
                let words = format!("No answer with the cargo here: {trouble}.");
                let style = self.theme.warning();
                text(self.buf, (area.x, area.y), area.width, &words, style);
                return;
            }
        };
        let [slider, drawing, readout, table] = Layout::vertical([
            Constraint::Length(1),
            Constraint::Min(4),
            Constraint::Length(1),
            Constraint::Length(READINGS),
        ])
        .areas(area);
        self.slider(slider, ropeway);
        let mut chart = picture::chart(&ropeway.worked, readings);
        // Its title stands beside the tabs; every line counts here.
        chart.title.clear();
        let inks = Inks::new(self.state.looks.colour);
        draw_chart(&chart, drawing, self.buf, self.state.looks.glyphs, inks);
        self.rope_readout(readout, ropeway, readings);
        let bare = Table {
            title: String::new(),
            notes: Vec::new(),
            ..tables::readings(&ropeway.worked, readings)
        };
        for (i, line) in bare.to_text(table.width.into()).lines().enumerate() {
            let at = u16::try_from(i).unwrap_or(u16::MAX);
            if at < table.height {
                let place = row(table, at);
                text(
                    self.buf,
                    (place.x, place.y),
                    place.width,
                    line,
                    self.theme.plain(),
                );
            }
        }
    }

    /// Where the cargo is between platform and ship.
    fn slider(&mut self, line: Rect, ropeway: &OpenRopeway) {
        let span = ropeway.worked.span.gap.span_m;
        let words = format!(
            " ship  cargo {} m of {} m, {}",
            rounded(ropeway.position * span, 2),
            rounded(span, 1),
            percent(ropeway.position)
        );
        let head = "platform ";
        let used = head.len() + words.len();
        let room = usize::from(line.width).saturating_sub(used).max(3);
        let (bar, mark) = match self.state.looks.glyphs {
            Glyphs::Braille => ('─', '█'),
            Glyphs::Ascii => ('-', '#'),
        };
        let at = (ropeway.position * (room - 1) as f64).round() as usize;
        let rail: String = (0..room)
            .map(|i| if i == at { mark } else { bar })
            .collect();
        let mut x = text(
            self.buf,
            (line.x, line.y),
            line.width,
            head,
            self.theme.plain(),
        );
        for (part, style) in [
            (rail.as_str(), self.theme.strong()),
            (words.as_str(), self.theme.plain()),
        ] {
            x = text(
                self.buf,
                (x, line.y),
                line.right().saturating_sub(x),
                part,
                style,
            );
        }
    }

    /// The exact rope in a line, and whether the cargo is dry.
    fn rope_readout(&mut self, line: Rect, ropeway: &OpenRopeway, readings: &Readings) {
        let exact = &readings.exact;
        let clear = ropeway.worked.clearance_m(exact);
        let words = format!(
            "exact: platform {} N  ship {} N  sag {} m  ",
            rounded(exact.platform_n(), 1),
            rounded(exact.ship_n(), 1),
            rounded(exact.sag_m, 2)
        );
        let (told, style) = match exact.carrier {
            Carrier::Rope if clear < 0.0 => (
                format!("IN THE WATER by {} m", rounded(-clear, 2)),
                self.theme.error(),
            ),
            Carrier::Rope => (
                format!("clear by {} m", rounded(clear, 2)),
                self.theme.good(),
            ),
            Carrier::Platform => ("on the platform".to_owned(), self.theme.plain()),
            Carrier::Ship => ("on the ship".to_owned(), self.theme.plain()),
        };
        let x = text(
            self.buf,
            (line.x, line.y),
            line.width,
            &words,
            self.theme.strong(),
        );
        text(
            self.buf,
            (x, line.y),
            line.right().saturating_sub(x),
            &told,
            style,
        );
    }

    fn ropeway_leaf(&mut self, area: Rect, ropeway: &OpenRopeway) {
        let [tabs, rest] =
            Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
        let mut x = tabs.x;
        for (i, name) in LEAVES.iter().enumerate() {
            let style = if i == ropeway.leaf {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            let room = tabs.right().saturating_sub(x);
            x = text(self.buf, (x, tabs.y), room, &format!(" {name} "), style);
        }
        let (chart, table) = ropeway.shown();
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
        ropeway.panes[ropeway.leaf].draw(&table, below, self.buf, glyphs, inks);
    }
}
