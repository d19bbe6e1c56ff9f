//! The list of cases.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Painter;
use super::paint::{first_line, row, text, wrap};
use crate::tui::state::CaseEntry;

impl Painter<'_> {
    pub(super) fn cases(&mut self, area: Rect) {
        let [head, list, rule, about] = Layout::vertical([
            Constraint::Length(1),
            Constraint::Min(3),
            Constraint::Length(1),
            Constraint::Length(if area.height > 16 { 6 } else { 3 }),
        ])
        .areas(area);
        self.cases_head(head);
        let entries: Vec<&CaseEntry> = self.state.cases.shown().collect();
        let height = usize::from(list.height);
        let cursor = self.state.cases.cursor;
        let first = first_line(cursor, entries.len(), height);
        if entries.is_empty() {
            self.no_cases(list);
        }
        let wide = entries
            .iter()
            .map(|e| e.name.chars().count())
            .max()
            .unwrap_or(0);
        let name_width = u16::try_from(wide)
            .unwrap_or(30)
            .clamp(16, 40)
            .min(area.width / 2);
        for (line, (i, entry)) in entries
            .iter()
            .enumerate()
            .skip(first)
            .take(height)
            .enumerate()
        {
            let line = row(list, u16::try_from(line).unwrap_or(u16::MAX));
            self.case_line(line, entry, i == cursor, name_width);
        }
        let rule_char = match self.state.capabilities.glyphs {
            crate::report::chart::Glyphs::Braille => "─",
            crate::report::chart::Glyphs::Ascii => "-",
        };
        text(
            self.buf,
            (rule.x, rule.y),
            rule.width,
            &rule_char.repeat(rule.width.into()),
            self.theme.faint(),
        );
        if let Some(entry) = entries.get(cursor) {
            self.about(about, entry);
        }
    }

    fn cases_head(&mut self, line: Rect) {
        let cases = &self.state.cases;
        if cases.typing || !cases.filter.value().is_empty() {
            self.prompt(line, "filter: ", &cases.filter, cases.typing);
        } else {
            let words = format!("Cases ({})", cases.entries.len());
            text(
                self.buf,
                (line.x, line.y),
                line.width,
                &words,
                self.theme.strong(),
            );
        }
    }

    fn no_cases(&mut self, list: Rect) {
        let words = if self.state.cases.entries.is_empty() {
            "There is no case file (*.toml) here. `seacable DIR` opens another directory."
        } else {
            "No case passes the filter. `/` and Esc drop it."
        };
        self.paragraph(list, words);
    }

    fn case_line(&mut self, line: Rect, entry: &CaseEntry, selected: bool, name_width: u16) {
        let style = if selected {
            self.theme.selected()
        } else {
            self.theme.plain()
        };
        self.buf.set_style(line, style);
        text(
            self.buf,
            (line.x + 1, line.y),
            name_width,
            &entry.name,
            style,
        );
        let x = line.x + name_width + 3;
        let room = line.right().saturating_sub(x);
        match &entry.about {
            Ok((title, _)) => text(self.buf, (x, line.y), room, title, style),
            Err((problem, _)) => {
                let words = format!("cannot be read: {problem}");
                text(
                    self.buf,
                    (x, line.y),
                    room,
                    &words,
                    style.patch(self.theme.error()),
                )
            }
        };
    }

    /// More about the case under the cursor.
    fn about(&mut self, area: Rect, entry: &CaseEntry) {
        let words = match &entry.about {
            Ok((title, source)) if source.is_empty() => title.clone(),
            Ok((title, source)) => format!("{title}\nSource: {source}"),
            Err((_, whole)) => whole.clone(),
        };
        let lines = words.lines().flat_map(|l| {
            if l.starts_with(' ') {
                vec![l.to_owned()]
            } else {
                wrap(l, area.width.into())
            }
        });
        for (i, line) in lines.take(area.height.into()).enumerate() {
            let at = row(area, u16::try_from(i).unwrap_or(u16::MAX));
            text(self.buf, (at.x, at.y), at.width, &line, self.theme.plain());
        }
    }
}
