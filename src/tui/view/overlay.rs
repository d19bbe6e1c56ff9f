//! What lies over the screen: help, palette, questions.

use std::path::PathBuf;

use ratatui::layout::{Constraint, Layout, Rect};
use tui_input::Input;
use unicode_width::UnicodeWidthStr;

use super::paint::{over, row, wrap};
use super::painter::Painter;
use crate::bindings::BoundCommand;
use crate::bindings::names::name;
use crate::chart::marker;
use crate::column_plot::ColumnPair;
use crate::fuzzy::FuzzyFilter;
use crate::state::overlay::RunText;
use crate::state::{AppState, Filter, Overlay, PromptPurpose, Question};
use crate::{panes, plots};

/// Columns of the help, and size of the box of messages.
const HELP: u16 = 96;
const MESSAGES: (u16, u16) = (100, 20);

/// The furthest that an overlay scrolls: its last line is at its foot.
#[must_use]
pub(crate) fn last_scroll(state: &AppState, overlay: &Overlay) -> usize {
    let (columns, rows) = state.size;
    let (lines, most) = match overlay {
        Overlay::Help { filter, .. } => {
            let lines = help_lines(state, HELP.min(columns), filter).len();
            (lines + usize::from(filter.is_in_use()), rows)
        }
        Overlay::Messages { filter, .. } => {
            let width = MESSAGES.0.min(columns).saturating_sub(2);
            let lines = message_lines(state, width, filter).len();
            (lines + usize::from(filter.is_in_use()), MESSAGES.1)
        }
        Overlay::Text { text, .. } | Overlay::Page { text, .. } => (text.lines().count(), rows),
        _ => (0, rows),
    };
    lines.saturating_sub(most.min(rows).saturating_sub(2).into())
}

/// The commands of the pane with the focus that have keys, as far as they pass a filter.
fn help_commands(state: &AppState, filter: &Filter) -> Vec<BoundCommand> {
    let mut all = panes::commands(state);
    all.retain(|command| !command.keys.is_empty());
    let parts = |command: &BoundCommand| {
        let doc = state.worded(command.doc);
        vec![command.keys.joined(), name(command.id), doc]
    };
    let lines: Vec<Vec<String>> = all.iter().map(parts).collect();
    let places = FuzzyFilter::new(filter.input.value()).places(&lines);
    places.into_iter().map(|place| all[place].clone()).collect()
}

/// The keys of the pane with the focus, as the help shows them.
fn help_lines(state: &AppState, width: u16, filter: &Filter) -> Vec<String> {
    let mut lines = Vec::new();
    for command in help_commands(state, filter) {
        let words = match panes::enabled(state, command.id) {
            Ok(()) => state.worded(command.doc),
            Err(why) => format!("{}. Not now: {why}", state.worded(command.doc)),
        };
        let parts = wrap(&words, usize::from(width.saturating_sub(21)));
        let keys = std::iter::once(command.keys.joined()).chain(std::iter::repeat(String::new()));
        lines.extend(
            keys.zip(parts)
                .map(|(keys, part)| format!(" {keys:<16} {part}")),
        );
    }
    lines
}

/// The messages that pass a filter, the newest first.
fn messages<'a>(state: &'a AppState, filter: &Filter) -> Vec<&'a str> {
    let lines: Vec<Vec<&str>> = state
        .log
        .iter()
        .rev()
        .map(|note| vec![note.text.as_str()])
        .collect();
    let places = FuzzyFilter::new(filter.input.value()).places(&lines);
    places.into_iter().map(|place| lines[place][0]).collect()
}

fn message_lines(state: &AppState, width: u16, filter: &Filter) -> Vec<String> {
    let messages = messages(state, filter).into_iter();
    messages.flat_map(|text| wrap(text, width.into())).collect()
}

/// Title and prompt of a text about runs.
fn run_text_words(what: RunText, dirs: &[PathBuf]) -> (String, &'static str) {
    let (title, prompt) = match what {
        RunText::Name => ("Name", "Name: "),
        RunText::Tags => ("Tags", "Tags: "),
        RunText::Note => ("Note", "Note: "),
    };
    let of = match dirs {
        [dir] => dir
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned(),
        _ => format!("{} runs", dirs.len()),
    };
    (format!("{title} of {of}"), prompt)
}

impl Painter<'_> {
    pub(super) fn overlay(&mut self, screen: Rect, overlay: &Overlay) {
        self.cursor = None;
        match overlay {
            Overlay::Help { scroll, filter } => self.help(screen, *scroll, filter),
            Overlay::Explanation { title, text } => self.explanation(screen, title, text),
            Overlay::Palette(line) => self.palette(screen, line),
            Overlay::Messages { scroll, filter } => self.messages(screen, *scroll, filter),
            Overlay::Page {
                title,
                text,
                scroll,
            } => self.page(screen, title, text, *scroll),
            Overlay::Text {
                title,
                text,
                scroll,
                ..
            } => {
                let title = format!("{title} (E opens it in your editor)");
                self.long_text(screen, &title, text, *scroll);
            }
            Overlay::Ask(question) => self.ask(screen, question),
            Overlay::Columns(pair) => self.columns(screen, pair),
            Overlay::Picker(picker) => self.picker(screen, picker),
            Overlay::Form(form) => self.form(screen, form),
            Overlay::LineTypes(picker) => self.line_types(screen, picker),
            Overlay::Curves { cursor } => self.curves(screen, *cursor),
            Overlay::Studies { items, cursor } => self.choose(screen, items, *cursor),
            Overlay::Prompt {
                purpose,
                input,
                words,
            } => {
                let (title, prompt) = match purpose {
                    PromptPurpose::SaveAs => ("Save under another name".to_owned(), "File: "),
                    PromptPurpose::RunText { what, dirs } => run_text_words(*what, dirs),
                    PromptPurpose::Resume(dir) => {
                        let name = dir.file_name().unwrap_or_default().to_string_lossy();
                        (format!("Resume {name}"), "Until [s]: ")
                    }
                };
                self.one_line(screen, &title, words, prompt, input);
            }
        }
    }

    pub(super) fn boxed(&mut self, screen: Rect, size: (u16, u16), title: &str) -> Rect {
        let (glyphs, style) = (self.glyphs(), self.theme.head());
        over(self.buf, screen, size, title, glyphs, style)
    }

    fn scrolled(&mut self, area: Rect, lines: &[String], scroll: usize) {
        let first = scroll.min(lines.len().saturating_sub(area.height.into()));
        let plain = self.theme.plain();
        self.lines(area, lines.iter().skip(first).map(|line| (line, plain)));
    }

    fn help(&mut self, screen: Rect, scroll: usize, filter: &Filter) {
        let width = HELP.min(screen.width);
        let lines = help_lines(self.state, width, filter);
        let all = help_commands(self.state, &Filter::default()).len();
        let height = lines.len() + 2 + usize::from(filter.is_in_use());
        let title = format!(
            "Keys: {} (j and k scroll, / filters, any other key closes)",
            panes::pane(self.state.focus()).about().title
        );
        let height = u16::try_from(height).unwrap_or(u16::MAX);
        let area = self.boxed(screen, (width, height), &title);
        let shown = help_commands(self.state, filter).len();
        let area = self.filter_line(area, filter, (shown, all));
        self.scrolled(area, &lines, scroll);
    }

    /// What a column is, in a box that is as high as it needs to be.
    fn explanation(&mut self, screen: Rect, title: &str, text: &str) {
        let width = 76.min(screen.width);
        let lines = wrap(text, width.saturating_sub(4).into());
        let height = u16::try_from(lines.len() + 2).unwrap_or(u16::MAX);
        let area = self.boxed(screen, (width, height), title);
        let inside = Rect::new(
            area.x + 1,
            area.y,
            area.width.saturating_sub(2),
            area.height,
        );
        self.scrolled(inside, &lines, 0);
    }

    fn messages(&mut self, screen: Rect, scroll: usize, filter: &Filter) {
        let area = self.boxed(screen, MESSAGES, "Messages, newest first (/ filters)");
        let lines = message_lines(self.state, area.width, filter);
        let of = (messages(self.state, filter).len(), self.state.log.len());
        let area = self.filter_line(area, filter, of);
        self.scrolled(area, &lines, scroll);
    }

    /// A page over the whole screen, as its lines were laid out for it.
    fn page(&mut self, screen: Rect, title: &str, text: &str, scroll: usize) {
        let title = format!("{title} (j and k scroll, w writes it, Esc closes)");
        let area = self.boxed(screen, (screen.width, screen.height), &title);
        let inside = Rect::new(
            area.x + 1,
            area.y,
            area.width.saturating_sub(1),
            area.height,
        );
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        self.scrolled(inside, &lines, scroll);
    }

    fn long_text(&mut self, screen: Rect, title: &str, words: &str, scroll: usize) {
        let height = u16::try_from(words.lines().count() + 4).unwrap_or(u16::MAX);
        let area = self.boxed(screen, (110, height), title);
        // Lines that point at a place in a file keep their columns.
        let lines: Vec<String> = words.lines().map(str::to_owned).collect();
        self.scrolled(area, &lines, scroll);
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
        self.scrolled(area, &lines, 0);
        for (i, (key, meaning)) in answers.iter().enumerate() {
            let at = row(area, u16::try_from(lines.len() + 1 + i).unwrap_or(u16::MAX));
            let rest = self.text(at, &key.to_string(), self.theme.selected());
            self.text(rest, &format!(" {meaning}"), self.theme.plain());
        }
    }

    fn choose(&mut self, screen: Rect, items: &[String], cursor: usize) {
        let height = u16::try_from(items.len() + 2).unwrap_or(u16::MAX);
        let area = self.boxed(
            screen,
            (90, height),
            "Which study? Enter runs it, Esc closes",
        );
        self.list(area, 0, items.len(), |painter, at, i| {
            let style = painter.line_style(i == cursor);
            painter.buf.set_style(at, style);
            painter.text(at, &items[i], style);
        });
    }

    /// The curves of the chart with their markers, beside what is left of the chart.
    fn curves(&mut self, screen: Rect, cursor: usize) {
        let Some(on) = self.state.charted() else {
            return;
        };
        let chart = plots::chart(on, on.view.chart);
        let widest = chart.series.iter().map(|series| series.label.width());
        let width = u16::try_from(widest.max().unwrap_or(0)).unwrap_or(u16::MAX);
        let height = u16::try_from(chart.series.len() + 3).unwrap_or(u16::MAX);
        let size = (width.saturating_add(10).clamp(42, 60), height);
        let area = self.boxed(screen, size, "Curves");
        let [list, foot] =
            Layout::vertical([Constraint::Min(0), Constraint::Length(1)]).areas(area);
        self.list(list, cursor, chart.series.len(), |painter, at, i| {
            let series = &chart.series[i];
            let style = painter.line_style(i == cursor);
            painter.buf.set_style(at, style);
            let shown = if series.visible { 'x' } else { ' ' };
            let words = format!("[{shown}] {} {}", marker(series.slot), series.label);
            painter.text(at, &words, style);
        });
        self.text(
            foot,
            "space shows or hides, a all, esc closes",
            self.theme.faint(),
        );
    }

    /// A column of the table of runs against another, over the whole screen.
    fn columns(&mut self, screen: Rect, pair: &ColumnPair) {
        let Some(view) = self.state.runs_view() else {
            return;
        };
        let title = pair.title(&view.runs);
        let area = self.boxed(screen, (screen.width, screen.height), &title);
        let [chart, foot] =
            Layout::vertical([Constraint::Min(0), Constraint::Length(1)]).areas(area);
        self.chart(&pair.chart(&view.runs), chart);
        let words = format!(
            "{} of {} runs   ] [ what is up   }} {{ along   g G log   w write   esc close",
            pair.count(&view.runs),
            view.runs.rows().len()
        );
        self.text(foot, &words, self.theme.faint());
    }

    /// Words, and a line to type.
    fn one_line(&mut self, screen: Rect, title: &str, words: &str, prompt: &str, input: &Input) {
        let area = self.boxed(screen, (76, 8), title);
        let lines = wrap(&self.state.worded(words), area.width.into());
        self.scrolled(area, &lines, 0);
        let used = u16::try_from(lines.len())
            .unwrap_or(0)
            .min(area.height.saturating_sub(1));
        self.prompt(row(area, used), prompt, input, true);
    }
}
