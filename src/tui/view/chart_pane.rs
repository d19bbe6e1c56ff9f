//! The charts: one with tabs, or all at once where there is room.

use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use super::Painter;
use super::layout;
use super::paint::{right, text};
use crate::report::number;
use crate::tui::pane::PaneId;
use crate::tui::plot_pane::{PlotPane, draw_chart};
use crate::tui::plots;
use crate::tui::state::{ChartKind, OpenCase};
use crate::tui::update::readout_words;

impl Painter<'_> {
    pub(super) fn charts(&mut self, area: Rect, open: &OpenCase) {
        let parts = layout::charts(area, &ChartKind::of(&open.case), open.chart);
        let all = parts.charts.len() > 1;
        if !all {
            self.chart_tabs(parts.tabs, open);
        }
        let glyphs = self.state.capabilities.glyphs;
        for (kind, place) in &parts.charts {
            let mut chart = plots::viewed(open, *kind);
            if all && *kind == open.chart && open.pane == PaneId::Charts {
                chart.title = format!("> {} <", chart.title);
            }
            let empty = chart.is_empty();
            if empty && *kind == ChartKind::Study {
                self.titled(
                    *place,
                    &chart.title,
                    "`V` computes what the case states along its studies.",
                );
                continue;
            }
            if empty {
                self.nothing_yet(*place, open, &chart.title);
                continue;
            }
            draw_chart(&chart, *place, self.buf, glyphs, self.theme);
        }
        self.readout(parts.readout, open);
    }

    fn chart_tabs(&mut self, line: Rect, open: &OpenCase) {
        let mut x = line.x;
        for kind in ChartKind::of(&open.case) {
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
        let words = match (&open.live.failure, plots::runs_shown(open)) {
            (Some(why), _) => format!("The last solve gave nothing: {why}"),
            (None, 0) => "No run is shown. `3` goes to the runs, space shows one.".to_owned(),
            (None, _) => "Nothing to draw yet.".to_owned(),
        };
        self.titled(area, title, &words);
    }

    /// Where the cursor is and every value there, as many lines as the area has.
    fn readout(&mut self, area: Rect, open: &OpenCase) {
        let chart = plots::viewed(open, open.chart);
        let mut words = readout_words(open, open.chart);
        let at = match chart.cursor {
            Some(x) if !words.is_empty() => Some(number::si(x, &chart.x.unit)),
            _ => open.instant.map(|t| format!("t = {t:.1} s")),
        };
        if let Some(at) = at {
            words.insert(0, at);
        }
        for (row, line) in wrapped(&words, usize::from(area.width)).iter().enumerate() {
            if row < usize::from(area.height) {
                let y = area.y + row as u16;
                text(self.buf, (area.x, y), area.width, line, self.theme.plain());
            }
        }
    }
}

/// Words on lines of this width, three spaces apart, none broken.
fn wrapped(words: &[String], width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words {
        match lines.last_mut() {
            Some(line) if line.width() + 3 + word.width() <= width => {
                line.push_str("   ");
                line.push_str(word);
            }
            _ => lines.push(word.clone()),
        }
    }
    lines
}
