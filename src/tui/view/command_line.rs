//! The line on which a command is typed, and what may complete it.

use ratatui::layout::{Constraint, Layout, Rect};

use super::paint::{below_head, row, wrap};
use super::painter::Painter;
use crate::bindings::BoundCommand;
use crate::command_line::arguments::meaning;
use crate::command_line::candidates::{Argument, CompletionCandidate, candidates};
use crate::command_line::{LineWord, typed};
use crate::panes;
use crate::state::command_line::CommandLine;

/// Size of its box.
const SIZE: (u16, u16) = (90, 20);

impl Painter<'_> {
    pub(super) fn palette(&mut self, screen: Rect, line: &CommandLine) {
        let found = candidates(self.state, line.input.value());
        let title = "Commands (Tab completes, Enter does it, Up recalls, Esc closes)";
        let area = self.boxed(screen, SIZE, title);
        let [head, below] = below_head(area);
        self.prompt(head, ":", &line.input, true);
        let below = self.about_line(below, line);
        self.list(below, line.cursor, found.len(), |painter, at, i| {
            let selected = i == line.cursor;
            match &found[i] {
                CompletionCandidate::Command(command) => {
                    painter.command_line(at, command, selected);
                }
                CompletionCandidate::Word(word) => painter.word_line(at, word, selected),
                CompletionCandidate::Argument(argument) => {
                    painter.argument_line(at, argument, selected);
                }
            }
        });
    }

    /// Why what is typed cannot be done, or what the argument is; returns the rest of the area.
    fn about_line(&mut self, area: Rect, line: &CommandLine) -> Rect {
        let (words, style) = match (&line.problem, typed(line.input.value())) {
            (problem, _) if !problem.is_empty() => (problem.clone(), self.theme.error()),
            (_, Some(typed)) => (meaning(self.state, typed), self.theme.faint()),
            _ => return area,
        };
        let lines = wrap(&words, area.width.into());
        let height = u16::try_from(lines.len())
            .unwrap_or(1)
            .min(3)
            .min(area.height);
        for (at, words) in (0..height).zip(&lines) {
            self.text(row(area, at), words, style);
        }
        let [_, below] =
            Layout::vertical([Constraint::Length(height), Constraint::Min(0)]).areas(area);
        below
    }

    /// Keys and meaning; a command that cannot be done now says why.
    fn command_line(&mut self, at: Rect, command: &BoundCommand, selected: bool) {
        let doc = self.state.worded(command.doc);
        let name = crate::bindings::names::name(command.id);
        let words = match panes::enabled(self.state, command.id) {
            Ok(()) => doc,
            Err(why) => format!("{doc} (not now: {why})"),
        };
        self.candidate_line(at, (&name, &command.keys.joined(), &words), selected);
    }

    fn word_line(&mut self, at: Rect, word: &LineWord, selected: bool) {
        let name = format!("{} {}", word.name, word.argument);
        self.candidate_line(at, (&name, "", word.doc), selected);
    }

    fn argument_line(&mut self, at: Rect, argument: &Argument, selected: bool) {
        let style = self.line_style(selected);
        self.buf.set_style(at, style);
        let share = if argument.help.is_empty() {
            at.width
        } else {
            at.width * 9 / 20
        };
        let [_, text, _, help] = Layout::horizontal([
            Constraint::Length(1),
            Constraint::Length(share),
            Constraint::Length(1),
            Constraint::Min(0),
        ])
        .areas(at);
        self.text(text, &argument.text, style.patch(self.theme.strong()));
        self.text(help, &argument.help, style);
    }

    /// Name, keys and meaning of a command.
    fn candidate_line(
        &mut self,
        at: Rect,
        (name, keys, words): (&str, &str, &str),
        selected: bool,
    ) {
        let style = self.line_style(selected);
        self.buf.set_style(at, style);
        let [_, first, _, second, _, rest] = Layout::horizontal([
            Constraint::Length(1),
            Constraint::Length(17),
            Constraint::Length(1),
            Constraint::Length(11),
            Constraint::Length(1),
            Constraint::Min(0),
        ])
        .areas(at);
        self.text(first, name, style.patch(self.theme.strong()));
        self.text(second, keys, style);
        self.text(rest, words, style);
    }
}
