//! The charts: one with tabs, or all at once where there is room.

use ratatui::layout::Rect;

use super::Canvas;
use super::layout;
use super::paint::{right, text};
use crate::tui::command::Place;
use crate::tui::inks::Inks;
use crate::tui::plot_pane::{PlotPane, draw_chart};
use crate::tui::plots;
use crate::tui::state::{ChartKind, OpenCase};
use crate::tui::update::readout_words;

impl Canvas<'_> {
    pub(super) fn charts(&mut self, area: Rect, open: &OpenCase) {
        let parts = layout::charts(area, open.chart);
        let all = parts.charts.len() > 1;
        if !all {
            self.chart_tabs(parts.tabs, open);
        }
        let inks = Inks::new(self.state.looks.colour);
        let glyphs = self.state.looks.glyphs;
        for (kind, place) in &parts.charts {
            let mut chart = plots::viewed(open, *kind);
            if all && *kind == open.chart && open.pane == Place::Charts {
                chart.title = format!("> {} <", chart.title);
            }
            if chart.series.iter().all(|s| s.points.is_empty()) {
                self.nothing_yet(*place, open, &chart.title);
                continue;
            }
            draw_chart(&chart, *place, self.buf, glyphs, inks);
        }
        self.readout(parts.readout, open);
    }

    fn chart_tabs(&mut self, line: Rect, open: &OpenCase) {
        let mut x = line.x;
        for kind in ChartKind::ALL {
            let style = if kind == open.chart {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            let words = format!(" {} ", kind.title());
            x = text(
                self.buf,
                (x, line.y),
                line.right().saturating_sub(x),
                &words,
                style,
            );
        }
        let frozen = open.views.iter().any(PlotPane::is_frozen);
        if frozen {
            let rest = Rect::new(x, line.y, line.right().saturating_sub(x), 1);
            right(self.buf, rest, "frozen", self.theme.warning());
        }
    }

    fn nothing_yet(&mut self, area: Rect, open: &OpenCase, title: &str) {
        text(
            self.buf,
            (area.x, area.y),
            area.width,
            title,
            self.theme.strong(),
        );
        let words = match (&open.live.failure, plots::runs_shown(open)) {
            (Some(why), _) => format!("The last solve gave nothing: {why}"),
            (None, 0) => "No run is shown. `3` goes to the runs, space shows one.".to_owned(),
            (None, _) => "Nothing to draw yet.".to_owned(),
        };
        if area.height > 2 {
            text(
                self.buf,
                (area.x, area.y + 2),
                area.width,
                &words,
                self.theme.plain(),
            );
        }
    }

    fn readout(&mut self, line: Rect, open: &OpenCase) {
        let words = readout_words(open, open.chart);
        let words = if words.is_empty() {
            open.instant
                .map_or_else(String::new, |t| format!("t = {t:.1} s"))
        } else {
            words.join("   ")
        };
        text(
            self.buf,
            (line.x, line.y),
            line.width,
            &words,
            self.theme.plain(),
        );
    }
}
