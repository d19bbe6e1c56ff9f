//! A ropeway: the slider, its picture, the results.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Painter;
use super::paint::{row, text};
use crate::report::chart::Glyphs;
use crate::report::number::{percent, rounded};
use crate::report::ropeway::{drawing, tables};
use crate::report::table::Table;
use crate::ropeway::ModelResults;
use crate::ropeway::elastic::Carrier;
use crate::tui::plot_pane::draw_chart;
use crate::tui::state::RopewayView;

/// Lines that the results take: head, rule, and a line each.
const READINGS: u16 = 9;

impl Painter<'_> {
    pub(super) fn ropeway_picture(&mut self, area: Rect, ropeway: &RopewayView) {
        let results = match &ropeway.results {
            Ok(results) => results,
            Err(error) => {
                let words = format!("No solution with the cargo here: {error}.");
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
        let mut chart = drawing::chart(&ropeway.worked, results);
        // Its title stands beside the tabs; every line counts here.
        chart.title.clear();
        draw_chart(
            &chart,
            drawing,
            self.buf,
            self.state.capabilities.glyphs,
            self.theme,
        );
        self.rope_readout(readout, ropeway, results);
        let bare = Table {
            title: String::new(),
            notes: Vec::new(),
            ..tables::models(&ropeway.worked, results)
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
    fn slider(&mut self, line: Rect, ropeway: &RopewayView) {
        let span = ropeway.worked.rope.geometry.span_m;
        let words = format!(
            " ship  cargo {} m of {} m, {}",
            rounded(ropeway.position * span, 2),
            rounded(span, 1),
            percent(ropeway.position)
        );
        let head = "platform ";
        let used = head.len() + words.len();
        let room = usize::from(line.width).saturating_sub(used).max(3);
        let (bar, mark) = match self.state.capabilities.glyphs {
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
    fn rope_readout(&mut self, line: Rect, ropeway: &RopewayView, results: &ModelResults) {
        let exact = &results.exact;
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
}
