//! The parameter editor.

use ratatui::layout::{Constraint, Layout, Rect};

use super::Painter;
use super::paint::{first_line, row, text, wrap};
use crate::case::Standing;
use crate::tui::facade::FieldRow;
use crate::tui::state::ParameterEditor;
use crate::tui::update::can_go;

/// A line of the list.
enum Line<'a> {
    Group(&'a str),
    Field(usize, &'a FieldRow),
}

/// The word for where a value comes from.
pub(super) fn standing_word(standing: Standing) -> &'static str {
    match standing {
        Standing::Published => "published",
        Standing::Derived => "derived",
        Standing::Calibrated => "calibrated",
        Standing::Assumed => "assumed",
    }
}

impl Painter<'_> {
    pub(super) fn inputs(&mut self, area: Rect, editor: &ParameterEditor) {
        let help_rows = if area.height > 14 { 5 } else { 3 };
        let [list, help] =
            Layout::vertical([Constraint::Min(0), Constraint::Length(help_rows)]).areas(area);
        let list = self.filter_line(list, editor);
        let mut lines = Vec::new();
        let mut group = "";
        let mut cursor = 0;
        for (i, field) in editor.fields().enumerate() {
            if field.group != group {
                group = &field.group;
                lines.push(Line::Group(group));
            }
            if i == editor.field {
                cursor = lines.len();
            }
            lines.push(Line::Field(i, field));
        }
        if lines.is_empty() {
            text(
                self.buf,
                (list.x, list.y),
                list.width,
                "No field passes the filter.",
                self.theme.plain(),
            );
        }
        let height = usize::from(list.height);
        let first = first_line(cursor, lines.len(), height);
        for (at, line) in lines.iter().skip(first).take(height).enumerate() {
            let at = row(list, u16::try_from(at).unwrap_or(u16::MAX));
            match line {
                Line::Group(name) => {
                    text(self.buf, (at.x, at.y), at.width, name, self.theme.head());
                }
                Line::Field(i, field) => self.field_line(at, field, *i == editor.field),
            }
        }
        match &editor.editing {
            Some(_) => self.edit_lines(help, editor),
            None => self.help_lines(help, editor),
        }
    }

    fn filter_line(&mut self, list: Rect, editor: &ParameterEditor) -> Rect {
        if !editor.filtering && editor.filter.value().is_empty() {
            return list;
        }
        let [line, rest] =
            Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(list);
        self.prompt(line, "filter: ", &editor.filter, editor.filtering);
        rest
    }

    /// Label, value, unit, and where the value comes from.
    fn field_line(&mut self, line: Rect, field: &FieldRow, selected: bool) {
        let base = if selected {
            self.theme.selected()
        } else {
            self.theme.plain()
        };
        self.buf.set_style(line, base);
        let note = match &field.standing {
            Some(mark) => standing_word(mark.status),
            None if !field.applies => "no effect",
            None if !field.given => "default",
            None => "",
        };
        let note_width = 11.min(line.width / 4);
        let unit_width = 9.min(line.width / 6);
        let room = line.width.saturating_sub(note_width + unit_width + 4);
        let label_width = 25.min(room / 2);
        let value_width = room - label_width;
        let mut x = line.x + 2;
        text(
            self.buf,
            (x, line.y),
            label_width.saturating_sub(1),
            field.label,
            base,
        );
        x += label_width;
        let (value, style) = match field.absent {
            Some(words) if field.value.is_empty() => (words, base.patch(self.theme.faint())),
            _ if !field.applies => (field.value.as_str(), base.patch(self.theme.faint())),
            _ if field.given => (field.value.as_str(), base.patch(self.theme.strong())),
            _ => (field.value.as_str(), base),
        };
        text(self.buf, (x, line.y), value_width, value, style);
        x += value_width + 1;
        text(self.buf, (x, line.y), unit_width, field.unit, base);
        x += unit_width + 1;
        let style = if field.standing.is_some() {
            base.patch(self.theme.warning())
        } else {
            base.patch(self.theme.faint())
        };
        text(
            self.buf,
            (x, line.y),
            line.right().saturating_sub(x),
            note,
            style,
        );
    }

    /// Help, range, and why a value is assumed.
    fn help_lines(&mut self, area: Rect, editor: &ParameterEditor) {
        let Some(field) = editor.current_field() else {
            return;
        };
        let mut words = format!("{}: {}\n{}", field.path, field.help, range_words(field));
        if let Some(mark) = &field.standing {
            words.push_str(&format!(
                "\n{}: {}",
                standing_word(mark.status),
                mark.reason
            ));
        }
        let lines = wrap(&words, area.width.into());
        for (i, line) in lines.iter().take(area.height.into()).enumerate() {
            let at = row(area, u16::try_from(i).unwrap_or(u16::MAX));
            let style = if i == 0 {
                self.theme.plain()
            } else {
                self.theme.faint()
            };
            text(self.buf, (at.x, at.y), at.width, line, style);
        }
    }

    /// The value being typed, and why it is refused.
    fn edit_lines(&mut self, area: Rect, editor: &ParameterEditor) {
        let (Some(editing), Some(field)) = (&editor.editing, editor.current_field()) else {
            return;
        };
        let line = row(area, 0);
        let unit = if field.unit.is_empty() {
            String::new()
        } else {
            format!(" [{}]", field.unit)
        };
        let prompt = format!("{}{unit} = ", field.label);
        let x = text(
            self.buf,
            (line.x, line.y),
            line.width / 2,
            &prompt,
            self.theme.strong(),
        );
        let room = line.right().saturating_sub(x + 1);
        let scroll = editing.input.visual_scroll(room.into());
        let value: String = editing.input.value().chars().skip(scroll).collect();
        text(self.buf, (x, line.y), room, &value, self.theme.plain());
        let at = u16::try_from(editing.input.visual_cursor().saturating_sub(scroll)).unwrap_or(0);
        self.cursor = Some((x.saturating_add(at), line.y));
        let (words, style) = match &editing.problem {
            Some(problem) => (format!("Refused: {problem}"), self.theme.error()),
            None => (
                format!(
                    "{}\nEnter takes it, Esc leaves it as it was{}.",
                    range_words(field),
                    if self.state.open.is_some() && can_go(field) {
                        "; nothing typed: not given"
                    } else {
                        ""
                    }
                ),
                self.theme.faint(),
            ),
        };
        for (i, words) in wrap(&words, area.width.into()).iter().enumerate() {
            let at = row(area, u16::try_from(i + 1).unwrap_or(u16::MAX));
            text(self.buf, (at.x, at.y), at.width, words, style);
        }
    }
}

fn range_words(field: &FieldRow) -> String {
    if field.range.is_empty() {
        String::new()
    } else {
        format!("May be: {}", field.range)
    }
}
