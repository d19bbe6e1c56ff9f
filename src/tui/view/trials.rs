//! Trials of hard cases: how far they are, and their table.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Painter;
use super::paint::{row, text, wrap};
use crate::study::{hard, tally};
use crate::tui::state::trials::{Trials, TrialsOf, WIDE};

impl Painter<'_> {
    pub(super) fn trials(&mut self, area: Rect, trials: &Trials) {
        let [head, rest] =
            Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
        let progress = &trials.progress;
        let whose = match &trials.of {
            TrialsOf::Case { file, .. } => format!("Trials of {file}"),
            TrialsOf::Files(_) => "All hard cases".to_owned(),
        };
        let far = match (trials.running(), trials.stopped) {
            (true, _) => format!(", {} of {}", progress.done, progress.all),
            (false, true) => format!(", stopped at {} of {}", progress.done, progress.all),
            (false, false) => format!(", {}", progress.all),
        };
        let tally = tally(&progress.findings);
        let counts = tally.to_string();
        let counts = counts.split_once(": ").map_or("", |(_, counts)| counts);
        let x = text(
            self.buf,
            (head.x, head.y),
            head.width,
            &format!("{whose}{far}: "),
            self.theme.strong(),
        );
        let ink = match (tally.holds(), trials.running()) {
            (false, _) => self.theme.error(),
            (true, true) => self.theme.plain(),
            (true, false) => self.theme.good(),
        };
        let room = head.right().saturating_sub(x);
        text(self.buf, (x, head.y), room, counts, ink);
        if progress.findings.is_empty() {
            let words = if trials.running() || trials.stopped {
                "Nothing is computed yet."
            } else {
                "None of these cases has trials. A `[[trial]]` table in a case file makes one."
            };
            let plain = self.theme.plain();
            text(self.buf, (rest.x, rest.y), rest.width, words, plain);
            return;
        }
        let glyphs = self.state.capabilities.glyphs;
        let table = trials.table(area.width);
        let narrow = area.width < WIDE;
        let [list, detail] = Layout::vertical([
            Constraint::Min(0),
            Constraint::Length(if narrow { rest.height * 2 / 5 } else { 0 }),
        ])
        .areas(rest);
        trials.pane.draw(&table, list, self.buf, glyphs, self.theme);
        if narrow && let Some(finding) = trials.selected(&table) {
            let lines = hard::story(finding);
            let width = usize::from(detail.width);
            let lines = lines.iter().flat_map(|line| wrap(line, width));
            for (i, line) in lines.take(detail.height.into()).enumerate() {
                let at = row(detail, u16::try_from(i).unwrap_or(u16::MAX));
                let style = if i == 0 {
                    self.theme.strong()
                } else {
                    self.theme.plain()
                };
                text(self.buf, (at.x, at.y), at.width, &line, style);
            }
        }
    }
}
