//! What the state looks like. Nothing here changes anything.

mod build;
mod command_line;
pub mod layout;
mod line_types;
mod overlay;
pub(super) mod paint;
pub mod painter;
mod tutorial;

use crate::{number, visible};
use ratatui::backend::TestBackend;
use ratatui::buffer::Cell;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::widgets::{Clear, Widget};
use ratatui::{Frame, Terminal};

pub(super) use self::overlay::last_scroll;
use self::painter::Painter;
use super::bindings::BoundCommand;
use super::command::CommandId;
use super::pane::PaneId;
use super::panes;
use super::state::study_of::{RunningStudy, StudyOf};
use super::state::{AppState, JobPurpose, JobState, Severity};
use super::theme::Theme;
use crate::chart::Glyphs;

/// Draws the whole screen.
pub fn draw(state: &AppState, frame: &mut Frame) {
    let screen = frame.area();
    let mut canvas = Painter {
        state,
        theme: Theme::new(state.capabilities),
        buf: frame.buffer_mut(),
        cursor: None,
    };
    let work = layout::screen_of(state).intersection(screen);
    canvas.screen(work);
    canvas.tutorial(screen, work);
    let cursor = canvas.cursor;
    if state.capabilities.glyphs == Glyphs::Ascii {
        paint::only_ascii(frame.buffer_mut());
    }
    if let Some(at) = cursor.filter(|at| screen.contains((*at).into())) {
        frame.set_cursor_position(at);
    }
}

/// The screen as plain text, without the line of keys.
#[must_use]
pub(super) fn last_screen(state: &AppState) -> String {
    let (width, height) = state.size;
    let Ok(mut terminal) = Terminal::new(TestBackend::new(width, height));
    let Ok(_) = terminal.draw(|frame| draw(state, frame));
    let cells = terminal.backend().buffer().content();
    let rows = cells.chunks(usize::from(width).max(1)).map(|row| {
        let line: String = row.iter().map(Cell::symbol).collect();
        format!("{}\n", line.trim_end())
    });
    rows.take(usize::from(height.saturating_sub(1))).collect()
}

impl Painter<'_> {
    fn screen(&mut self, screen: Rect) {
        let (width, height) = layout::SMALLEST;
        if screen.width < width || screen.height < height {
            let words = format!("need {width}x{height}");
            // No mark: it would take the place of the last letter.
            let at = (screen.x, screen.y);
            paint::text(self.buf, at, screen.width, &words, self.theme.plain());
            return;
        }
        let areas = layout::areas(screen);
        self.head(areas.head);
        let focus = self.state.focus();
        if matches!(focus, PaneId::Cases | PaneId::Trials) {
            panes::pane(focus).view(self, areas.tabs.union(areas.body));
        } else {
            self.pane_tabs(areas.tabs);
            for (id, area) in layout::panes(screen, self.state) {
                self.pane(screen, id, area);
            }
        }
        self.note(areas.note);
        self.foot(areas.foot);
        if let Some(overlay) = &self.state.overlay {
            self.overlay(screen, overlay);
        }
    }

    fn pane(&mut self, screen: Rect, id: PaneId, area: Rect) {
        let pane = panes::pane(id);
        if layout::is_band(id, self.state) {
            panes::results::band(self, area);
            return;
        }
        let inside = if layout::framed(screen) {
            let focused = self.state.focus() == id;
            let (style, mark) = if focused {
                (self.theme.head(), "*")
            } else {
                (self.theme.faint(), "")
            };
            let mut panes = self.state.panes().iter();
            let number = panes.position(|other| *other == id).map_or(0, |i| i + 1);
            let title = match number {
                0 => format!("{}{mark}", pane.about().title),
                _ => format!("{number} {}{mark}", pane.about().title),
            };
            let glyphs = self.glyphs();
            paint::framed(self.buf, area, &title, glyphs, style)
        } else {
            area
        };
        pane.view(self, inside);
    }

    /// The file that is open, and what is being computed.
    fn head(&mut self, line: Rect) {
        let state = self.state;
        let rest = self.text(line, "seacable", self.theme.head());
        let rest = match &state.document {
            Some(document) => {
                let editor = &document.editor;
                let unsaved = if editor.unsaved() { " *unsaved" } else { "" };
                let draft = if editor.draft.is_some() { " draft" } else { "" };
                let words = format!(
                    "  {}{unsaved}{draft}  {}",
                    editor.file,
                    document.kind().headline()
                );
                self.text(rest, &words, self.theme.strong())
            }
            None => {
                let words = format!("  {}", visible::path(&state.cases.dir));
                self.text(rest, &words, self.theme.plain())
            }
        };
        let room = rest.width.saturating_sub(2);
        let busy = state.document.as_ref().and_then(|d| d.kind().busy());
        let checking = state
            .editor()
            .is_some_and(|editor| !editor.pending.is_empty());
        let study = state.document.as_ref();
        let study = study.and_then(|document| document.study.as_ref());
        let words = match busy {
            _ if study.is_some() => study_words(room.into(), study),
            _ if checking => fitting(room.into(), &["checking the edit".to_owned()]),
            Some(words) => fitting(room.into(), &[words.to_owned()]),
            None => self.progress(room.into()),
        };
        let rest = Rect::new(line.right() - room, line.y, room, 1);
        paint::right(self.buf, rest, &words, self.theme.good());
    }

    /// How far the newest job is, in as many words as fit.
    fn progress(&self, room: usize) -> String {
        let jobs = &self.state.jobs;
        let running = jobs.lines.iter().filter(|l| l.state == JobState::Running);
        let Some(line) = running.max_by_key(|l| {
            (
                l.purpose == JobPurpose::Run,
                l.purpose == JobPurpose::Sweep,
                l.ticket,
            )
        }) else {
            return String::new();
        };
        let p = line.progress;
        let what = match line.purpose {
            JobPurpose::Live => "live".to_owned(),
            JobPurpose::Run => format!("{} to go", jobs.open()),
            JobPurpose::Trials => {
                let words = format!("{:.0} of {:.0} trials", p.time, p.duration);
                return fitting(room, &[words]);
            }
            JobPurpose::Sweep => return fitting(room, &[panes::load_cases(p)]),
        };
        if p.estimating {
            return fitting(room, &[format!("{what}: estimating errors"), what]);
        }
        if p.steps == 0 {
            let doing = p
                .search
                .map_or_else(|| "starting".to_owned(), |search| search.to_string());
            return fitting(room, &[format!("{what}: {doing}"), what]);
        }
        let left = p.remaining_s().map_or_else(
            || "starting".to_owned(),
            |s| format!("{} left", number::duration(s)),
        );
        let share = format!("{:.0} %", 100.0 * p.fraction());
        fitting(
            room,
            &[
                format!(
                    "{what}: step {}, {:.0} of {:.0} s, {share}, {left}",
                    p.steps, p.time, p.duration
                ),
                format!("{what}: {:.0} of {:.0} s, {left}", p.time, p.duration),
                format!("{what}: {share}"),
            ],
        )
    }

    fn pane_tabs(&mut self, line: Rect) {
        let state = self.state;
        let panes = state.panes();
        let selected = panes.iter().position(|id| *id == state.focus());
        let names = panes.iter().enumerate();
        let names = names.map(|(i, id)| format!("{} {}", i + 1, panes::pane(*id).about().title));
        let rest = self.tabs(line, names, selected);
        let room = rest.width.saturating_sub(2);
        if let Some(document) = state.document.as_ref().filter(|_| room > 20) {
            let rest = Rect::new(line.right() - room, line.y, room, 1);
            self.text(rest, document.kind().info().title, self.theme.faint());
        }
    }

    fn note(&mut self, line: Rect) {
        let Some(note) = &self.state.note else {
            return;
        };
        let (word, style) = match note.level {
            Severity::Info => ("", self.theme.plain()),
            Severity::Warning => ("Note: ", self.theme.warning()),
            Severity::Error => ("Error: ", self.theme.error()),
        };
        let words = format!("{word}{}", note.text.replace('\n', " "));
        self.message(line, &words, style);
    }

    /// A message on the line of messages or, where it is longer, on the line above too; what is longer still is cut, with the key
    /// that shows all of it.
    fn message(&mut self, line: Rect, words: &str, style: Style) {
        let mut lines = paint::wrap(words, line.width.into()).into_iter();
        let (Some(first), Some(second)) = (lines.next(), lines.next()) else {
            self.text(line, words, style);
            return;
        };
        let above = Rect::new(line.x, line.y.saturating_sub(1), line.width, 1);
        Clear.render(above, self.buf);
        self.text(above, &first, style);
        if lines.next().is_none() {
            self.text(line, &second, style);
            return;
        }
        let more = " (! shows all)";
        let room = line.width.saturating_sub(width(more));
        let second = format!("{second} {}", lines.collect::<String>());
        let rest = self.text(paint::span(line, 0, room), &second, style);
        self.text(paint::rest(line, rest.x), more, self.theme.faint());
    }

    /// The keys that work now, then `?` and `q`.
    fn foot(&mut self, line: Rect) {
        let (ends, others): (Vec<BoundCommand>, Vec<BoundCommand>) = offered(self.state)
            .into_iter()
            .partition(|command| matches!(command.id, CommandId::Help | CommandId::Quit));
        let mut room = line.width.saturating_sub(ends.iter().map(key_width).sum());
        let mut rest = line;
        let now = others
            .iter()
            .filter(|c| panes::enabled(self.state, c.id).is_ok());
        for command in now.take_while(|command| {
            let fits = key_width(command) <= room;
            room = room.saturating_sub(key_width(command));
            fits
        }) {
            rest = self.key(rest, command);
        }
        for command in &ends {
            rest = self.key(rest, command);
        }
    }

    fn key(&mut self, line: Rect, command: &BoundCommand) -> Rect {
        let Some(key) = command.keys.first() else {
            return line;
        };
        let rest = self.text(line, key, self.theme.selected());
        let rest = self.text(rest, &format!(" {}", command.label), self.theme.plain());
        paint::rest(line, rest.x + 2)
    }
}

/// The commands that the footer offers, as far as there is room: those that can be done now.
#[must_use]
pub fn offered(state: &AppState) -> Vec<BoundCommand> {
    let mut commands = panes::commands(state);
    commands
        .retain(|command| !command.label.is_empty() && panes::enabled(state, command.id).is_ok());
    commands
}

/// How far a study is.
fn study_words(room: usize, study: Option<&RunningStudy>) -> String {
    let Some(study) = study else {
        return String::new();
    };
    let what = match study.of {
        StudyOf::Inputs => "inputs varied",
        StudyOf::Physics => "effects left out",
    };
    let share = format!("{} of {}", study.done, study.all);
    fitting(room, &[format!("{what}: {share}"), share])
}

fn key_width(command: &BoundCommand) -> u16 {
    let key = command.keys.first().map_or(0, str::len);
    u16::try_from(key + command.label.len() + 3).unwrap_or(u16::MAX)
}

fn width(words: &str) -> u16 {
    u16::try_from(words.len()).unwrap_or(u16::MAX)
}

/// The first of the wordings that fits.
fn fitting(room: usize, wordings: &[String]) -> String {
    let found = wordings.iter().find(|w| w.len() <= room);
    found.cloned().unwrap_or_default()
}
