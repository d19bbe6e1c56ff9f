//! What lies over the screen: help, palette, questions.

use ratatui::layout::Rect;
use tui_input::Input;

use super::Painter;
use super::paint::{first_line, over, row, text, wrap};
use crate::tui::command::{self, Command};
use crate::tui::state::{Overlay, Question};
use crate::tui::update::{enabled, palette_matches};

impl Painter<'_> {
    pub(super) fn overlay(&mut self, screen: Rect, overlay: &Overlay) {
        self.cursor = None;
        match overlay {
            Overlay::Help { scroll } => self.help(screen, *scroll),
            Overlay::Palette { input, cursor } => self.palette(screen, input, *cursor),
            Overlay::Messages { scroll } => self.messages(screen, *scroll),
            Overlay::Text {
                title,
                text,
                scroll,
            } => self.long_text(screen, title, text, *scroll),
            Overlay::Ask(question) => self.ask(screen, question),
            Overlay::Choose { items, cursor, .. } => self.choose(screen, items, *cursor),
            Overlay::SaveAs { input, why } => {
                let why = format!("Not saved to the file itself: {why}");
                self.one_line(screen, "Save under another name", &why, "File: ", input);
            }
            Overlay::Until { dir, input, words } => {
                let name = dir.file_name().unwrap_or_default().to_string_lossy();
                let title = format!("Go on with {name}");
                self.one_line(screen, &title, words, "Until [s]: ", input);
            }
        }
    }

    fn boxed(&mut self, screen: Rect, size: (u16, u16), title: &str) -> Rect {
        let style = self.theme.head();
        over(
            self.buf,
            screen,
            size,
            title,
            self.state.capabilities.glyphs,
            style,
        )
    }

    fn lines(&mut self, area: Rect, lines: &[String], scroll: usize) {
        let height = usize::from(area.height);
        let first = scroll.min(lines.len().saturating_sub(height));
        for (i, line) in lines.iter().skip(first).take(height).enumerate() {
            let at = row(area, u16::try_from(i).unwrap_or(u16::MAX));
            text(self.buf, (at.x, at.y), at.width, line, self.theme.plain());
        }
    }

    fn help(&mut self, screen: Rect, scroll: usize) {
        let place = self.state.focus();
        let width = 96.min(screen.width);
        let mut lines = Vec::new();
        for command in command::at(place).filter(|c| !c.keys.is_empty()) {
            let words = match enabled(self.state, command.id) {
                Ok(()) => command.doc.to_owned(),
                Err(why) => format!("{}. Not now: {why}", command.doc),
            };
            for (i, part) in wrap(&words, usize::from(width.saturating_sub(21)))
                .iter()
                .enumerate()
            {
                let keys = if i == 0 {
                    command.keys.join(" ")
                } else {
                    String::new()
                };
                lines.push(format!(" {keys:<16} {part}"));
            }
        }
        let height = u16::try_from(lines.len() + 2).unwrap_or(u16::MAX);
        let title = format!(
            "Keys: {} (j and k scroll, any other key closes)",
            place.title()
        );
        let area = self.boxed(screen, (width, height), &title);
        self.lines(area, &lines, scroll);
    }

    /// Keys and meaning; a command that cannot be done now says why.
    fn command_line(&mut self, at: Rect, command: &Command, selected: bool) {
        let style = if selected {
            self.theme.selected()
        } else {
            self.theme.plain()
        };
        self.buf.set_style(at, style);
        let keys = command.keys.join(" ");
        text(
            self.buf,
            (at.x + 1, at.y),
            16,
            &keys,
            style.patch(self.theme.strong()),
        );
        let x = at.x + 18;
        let room = at.right().saturating_sub(x);
        match enabled(self.state, command.id) {
            Ok(()) => text(self.buf, (x, at.y), room, command.doc, style),
            Err(why) => {
                let words = format!("{} (not now: {why})", command.doc);
                text(
                    self.buf,
                    (x, at.y),
                    room,
                    &words,
                    style.patch(self.theme.faint()),
                )
            }
        };
    }

    fn palette(&mut self, screen: Rect, input: &Input, cursor: usize) {
        let found = palette_matches(self.state.focus(), input.value());
        let area = self.boxed(
            screen,
            (90, 18),
            "Commands (type a word, Enter does it, Esc closes)",
        );
        self.prompt(row(area, 0), ":", input, true);
        let list = Rect::new(
            area.x,
            area.y + 1,
            area.width,
            area.height.saturating_sub(1),
        );
        let height = usize::from(list.height);
        let first = first_line(cursor, found.len(), height);
        for (i, (n, command)) in found
            .iter()
            .enumerate()
            .skip(first)
            .take(height)
            .enumerate()
        {
            let at = row(list, u16::try_from(i).unwrap_or(u16::MAX));
            self.command_line(at, command, n == cursor);
        }
    }

    fn messages(&mut self, screen: Rect, scroll: usize) {
        let area = self.boxed(screen, (100, 20), "Messages, newest first");
        let lines: Vec<String> = self
            .state
            .log
            .iter()
            .rev()
            .flat_map(|note| wrap(&note.text, area.width.into()))
            .collect();
        self.lines(area, &lines, scroll);
    }

    fn long_text(&mut self, screen: Rect, title: &str, words: &str, scroll: usize) {
        let height = u16::try_from(words.lines().count() + 4).unwrap_or(u16::MAX);
        let area = self.boxed(screen, (110, height), title);
        // Lines that point at a place in a file keep their columns.
        let lines: Vec<String> = words.lines().map(str::to_owned).collect();
        self.lines(area, &lines, scroll);
    }

    fn ask(&mut self, screen: Rect, question: &Question) {
        let (words, answers) = question.wording();
        let width = 66.min(screen.width);
        let lines = wrap(&words, usize::from(width.saturating_sub(4)));
        let height = u16::try_from(lines.len() + answers.len() + 3).unwrap_or(u16::MAX);
        let area = self.boxed(screen, (width, height), "Question");
        let area = Rect::new(
            area.x + 1,
            area.y,
            area.width.saturating_sub(2),
            area.height,
        );
        self.lines(area, &lines, 0);
        for (i, (key, meaning)) in answers.iter().enumerate() {
            let at = row(area, u16::try_from(lines.len() + 1 + i).unwrap_or(u16::MAX));
            let x = text(
                self.buf,
                (at.x, at.y),
                at.width,
                &key.to_string(),
                self.theme.selected(),
            );
            let room = at.right().saturating_sub(x);
            text(
                self.buf,
                (x, at.y),
                room,
                &format!(" {meaning}"),
                self.theme.plain(),
            );
        }
    }

    fn choose(&mut self, screen: Rect, items: &[String], cursor: usize) {
        let height = u16::try_from(items.len() + 2).unwrap_or(u16::MAX);
        let area = self.boxed(
            screen,
            (90, height),
            "Which study? Enter runs it, Esc closes",
        );
        for (i, item) in items.iter().enumerate() {
            let at = row(area, u16::try_from(i).unwrap_or(u16::MAX));
            let style = if i == cursor {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            self.buf.set_style(at, style);
            text(self.buf, (at.x, at.y), at.width, item, style);
        }
    }

    /// Words, and a line to type.
    fn one_line(&mut self, screen: Rect, title: &str, words: &str, prompt: &str, input: &Input) {
        let area = self.boxed(screen, (76, 8), title);
        let lines = wrap(words, area.width.into());
        self.lines(area, &lines, 0);
        let used = u16::try_from(lines.len())
            .unwrap_or(0)
            .min(area.height.saturating_sub(1));
        self.prompt(row(area, used), prompt, input, true);
    }
}
