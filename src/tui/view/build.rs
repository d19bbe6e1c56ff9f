//! Forms, and lists to choose from.

use ratatui::layout::{Constraint, Layout, Rect};

use super::paint::{below_head, row, span, wrap};
use super::painter::Painter;
use crate::state::form::{Form, FormLine};
use crate::state::picker::Picker;

/// Size of the box of a list.
const PICKER: (u16, u16) = (90, 20);

/// Columns of a form, and the lines below its list.
const FORM: u16 = 92;
const FOOT: u16 = 6;

/// Columns of labels and units of a form.
const LABEL: u16 = 26;
const UNIT: u16 = 9;

impl Painter<'_> {
    pub(super) fn picker(&mut self, screen: Rect, picker: &Picker) {
        let area = self.boxed(screen, PICKER, &picker.title);
        let [head, list] = below_head(area);
        self.prompt(head, "> ", &picker.input, true);
        let shown = picker.shown();
        if shown.is_empty() {
            self.paragraph(list, "Nothing here has that name.");
        }
        let names = shown.iter().map(|item| item.name.chars().count());
        let widest = u16::try_from(names.max().unwrap_or(0)).unwrap_or(20);
        let column = widest.clamp(12, 34) + 2;
        self.list(list, picker.cursor, shown.len(), |painter, at, i| {
            let style = painter.line_style(i == picker.cursor);
            painter.buf.set_style(at, style);
            let strong = style.patch(painter.theme.strong());
            painter.text(span(at, 1, column - 1), &shown[i].name, strong);
            painter.text(span(at, column + 1, at.width), &shown[i].help, style);
        });
    }

    pub(super) fn form(&mut self, screen: Rect, form: &Form) {
        let shown = form.shown();
        let lines = u16::try_from(shown.len()).unwrap_or(u16::MAX);
        let height = lines.saturating_add(FOOT + 3);
        let area = self.boxed(screen, (FORM, height), &form.title);
        let [list, rule, foot, keys] = Layout::vertical([
            Constraint::Min(1),
            Constraint::Length(1),
            Constraint::Length(FOOT - 1),
            Constraint::Length(1),
        ])
        .areas(area);
        self.list(list, form.cursor, shown.len(), |painter, at, i| {
            let line = &form.lines[shown[i]];
            painter.form_line(at, line, i == form.cursor);
        });
        self.folded(rule, form, shown.len());
        self.form_help(foot, form);
        let words = "arrows: field, choice   tab: all keys   Enter: take all   Esc: close";
        self.text(keys, words, self.theme.faint());
    }

    /// How many keys are not shown.
    fn folded(&mut self, line: Rect, form: &Form, shown: usize) {
        let hidden = form.lines.len().saturating_sub(shown);
        if hidden > 0 && !form.whole {
            let words = format!(" + {hidden} keys with defaults (tab)");
            self.text(line, &words, self.theme.faint());
        }
    }

    fn form_line(&mut self, at: Rect, line: &FormLine, selected: bool) {
        let style = self.line_style(selected);
        self.buf.set_style(span(at, 0, LABEL), style);
        let mark = if line.required { "* " } else { "  " };
        self.text(span(at, 0, LABEL), &format!("{mark}{}", line.label), style);
        let room = at.width.saturating_sub(LABEL + UNIT + 2);
        let value = span(at, LABEL + 1, room);
        if selected {
            self.input(value, &line.input, true);
        } else if !line.input.value().is_empty() {
            self.text(value, line.input.value(), self.theme.strong());
        }
        if line.input.value().is_empty() && !line.absent.is_empty() {
            let from = if selected { 2 } else { 0 };
            let shown = span(value, from, room);
            self.text(shown, &line.absent, self.theme.faint());
        }
        let unit = span(at, LABEL + room + 2, UNIT);
        self.text(unit, &line.unit, self.theme.plain());
    }

    /// Why the form is refused; else help on the line under the cursor, and its words.
    fn form_help(&mut self, area: Rect, form: &Form) {
        let width = usize::from(area.width);
        let (words, style) = match (form.problem.is_empty(), form.current()) {
            (false, _) => (format!("Refused: {}", form.problem), self.theme.error()),
            (true, Some(line)) => (help_of(line), self.theme.plain()),
            (true, None) => (String::new(), self.theme.plain()),
        };
        let lines = wrap(&words, width);
        for (i, words) in (0..area.height).zip(lines) {
            self.text(row(area, i), &words, style);
        }
    }
}

fn help_of(line: &FormLine) -> String {
    match line.choices.is_empty() {
        true => line.help.clone(),
        false => format!("{}\nOne of: {}.", line.help, line.choices.join(", ")),
    }
}
