//! What panes draw with: text in lines, lists, tables, charts, and a line that is typed into.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;
use tui_input::Input;
use unicode_width::UnicodeWidthStr;

use super::paint::{below_head, cut, first_line, rest, right, row, span, tabs_seen, text, wrap};
use crate::chart::{Chart, Glyphs};
use crate::plain::ascii;
use crate::plot_pane::draw_chart;
use crate::state::parts::{PartView, ScreenPart};
use crate::state::{AppState, Filter};
use crate::table::Table;
use crate::table_pane::TablePane;
use crate::theme::Theme;
use crate::visible;

/// What drawing a pane needs.
pub struct Painter<'a> {
    /// What is drawn.
    pub state: &'a AppState,
    /// Styles by meaning.
    pub theme: Theme,
    /// Where it is drawn.
    pub buf: &'a mut Buffer,
    /// Where the terminal's own cursor goes, when something is typed.
    pub cursor: Option<(u16, u16)>,
}

impl Painter<'_> {
    /// Characters of charts and frames.
    #[must_use]
    pub fn glyphs(&self) -> Glyphs {
        self.state.capabilities.glyphs
    }

    /// Writes text at the left of a line, with a mark at its end where it does not fit; returns the rest of the line.
    pub fn text(&mut self, line: Rect, words: &str, style: Style) -> Rect {
        // Escapes are longer than what they stand for, so they come before the cut.
        let words = visible::line(words);
        let words = match self.glyphs() {
            Glyphs::Braille => words,
            Glyphs::Ascii => ascii(&words).into_owned().into(),
        };
        let words = cut(&words, line.width.into(), self.glyphs());
        let x = text(self.buf, (line.x, line.y), line.width, &words, style);
        rest(line, x)
    }

    /// Writes lines from the top of an area down, as many as it has.
    pub fn lines<T: AsRef<str>>(
        &mut self,
        area: Rect,
        lines: impl IntoIterator<Item = (T, Style)>,
    ) {
        let rows = (0..area.height).map(|i| row(area, i));
        for (line, (words, style)) in rows.zip(lines) {
            self.text(line, words.as_ref(), style);
        }
    }

    /// Plain words in an area, broken between words, as many lines as it has.
    pub fn paragraph(&mut self, area: Rect, words: &str) {
        let plain = self.theme.plain();
        let lines = wrap(&self.state.worded(words), area.width.into());
        self.lines(area, lines.into_iter().map(|line| (line, plain)));
    }

    /// A title with words below it, one line apart.
    pub fn titled(&mut self, area: Rect, title: &str, words: &str) {
        self.text(area, title, self.theme.strong());
        let [_, below] = Layout::vertical([Constraint::Length(2), Constraint::Min(0)]).areas(area);
        self.paragraph(below, words);
    }

    /// The style of a line of a list.
    #[must_use]
    pub fn line_style(&self, selected: bool) -> Style {
        if selected {
            self.theme.selected()
        } else {
            self.theme.plain()
        }
    }

    /// The lines of a list around its cursor: `draw` gets area and number of each.
    pub fn list(
        &mut self,
        area: Rect,
        cursor: usize,
        count: usize,
        mut draw: impl FnMut(&mut Self, Rect, usize),
    ) {
        let first = first_line(cursor, count, area.height.into());
        for (i, number) in (0..area.height).zip(first..count) {
            draw(self, row(area, i), number);
        }
    }

    /// Names beside each other, one of them selected; returns the rest of the line. Where there is no room for all, the selected one
    /// is among those seen, and `<` and `>` say that there are more.
    pub fn tabs<T: AsRef<str>>(
        &mut self,
        line: Rect,
        names: impl IntoIterator<Item = T>,
        selected: Option<usize>,
    ) -> Rect {
        let names: Vec<String> = names
            .into_iter()
            .map(|name| format!(" {} ", name.as_ref()))
            .collect();
        let widths: Vec<usize> = names.iter().map(|name| name.width()).collect();
        let seen = tabs_seen(&widths, selected.unwrap_or(0), line.width.into());
        let faint = self.theme.faint();
        let mut rest = line;
        if seen.start > 0 {
            rest = self.text(rest, "<", faint);
        }
        for i in seen.clone() {
            let style = self.line_style(Some(i) == selected);
            rest = self.text(rest, &names[i], style);
        }
        if seen.end < names.len() {
            rest = self.text(rest, ">", faint);
        }
        rest
    }

    /// Draws a part that is worked out behind the screen as it is known, with a mark where that is older than what it is of.
    pub fn part(&mut self, area: Rect, part: ScreenPart, draw: impl FnOnce(&mut Self, &PartView)) {
        let Some(document) = &self.state.document else {
            return;
        };
        let Some(view) = document.parts.last(part) else {
            return self.paragraph(area, "Computing.");
        };
        draw(self, view);
        if document.editor.draft.is_some() {
            let words = " before the file was a draft";
            right(self.buf, row(area, 0), words, self.theme.warning());
        } else if !document.is_shown(part) || document.kind().is_behind(part) {
            self.older(area);
        }
    }

    /// Says at the top of an area that it is older than the inputs, and is being made anew.
    pub fn older(&mut self, area: Rect) {
        let words = " older than the inputs: computing";
        right(self.buf, row(area, 0), words, self.theme.warning());
    }

    /// A chart over an area.
    pub fn chart(&mut self, chart: &Chart, area: Rect) {
        draw_chart(chart, area, self.buf, self.glyphs(), self.theme);
    }

    /// A table over an area, below its filter where it has one. Its title may name commands, which are shown by their keys.
    pub fn table(&mut self, pane: &TablePane, table: &Table, area: Rect) {
        let title = self.state.worded(&table.title);
        if title != table.title {
            let worded = Table {
                title,
                ..table.clone()
            };
            return self.table(pane, &worded, area);
        }
        let area = match pane.filter.is_in_use() {
            true => self.filter_line(area, &pane.filter, (pane.count(table), table.rows.len())),
            false => area,
        };
        pane.draw(table, area, self.buf, self.glyphs(), self.theme);
    }

    /// The filter of a list with how many of its lines pass, where it has one; returns the rest of the area.
    pub fn filter_line(
        &mut self,
        area: Rect,
        filter: &Filter,
        (shown, all): (usize, usize),
    ) -> Rect {
        if !filter.is_in_use() {
            return area;
        }
        let [line, below] = below_head(area);
        let words = format!("{shown} of {all}");
        let count = u16::try_from(words.width())
            .unwrap_or(0)
            .min(line.width / 2);
        let [typed, _, far] = Layout::horizontal([
            Constraint::Min(0),
            Constraint::Length(1),
            Constraint::Length(count),
        ])
        .areas(line);
        self.prompt(typed, "filter: ", &filter.input, filter.typing);
        self.text(far, &words, self.theme.faint());
        below
    }

    /// What is typed after a prompt, scrolled to the cursor; the terminal's own cursor is there while `typing`.
    pub fn prompt(&mut self, line: Rect, prompt: &str, input: &Input, typing: bool) {
        let rest = self.text(line, prompt, self.theme.strong());
        self.input(rest, input, typing);
    }

    /// What is typed, scrolled to the cursor.
    pub fn input(&mut self, line: Rect, input: &Input, typing: bool) {
        let room = line.width.saturating_sub(1);
        let scroll = input.visual_scroll(room.into());
        let value: String = input.value().chars().skip(scroll).collect();
        // What scrolls under a cursor carries no mark.
        let at = span(line, 0, room);
        text(self.buf, (at.x, at.y), at.width, &value, self.theme.plain());
        if typing {
            let at = u16::try_from(input.visual_cursor().saturating_sub(scroll)).unwrap_or(0);
            self.cursor = Some((line.x.saturating_add(at), line.y));
        }
    }
}
