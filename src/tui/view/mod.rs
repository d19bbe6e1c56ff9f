//! What the state looks like. Nothing here changes anything.

mod cases;
mod chart_pane;
mod file;
mod inputs;
pub mod layout;
mod lists;
mod modes;
mod overlay;
mod paint;
mod results;
mod ropeway;
mod ship;
mod text;
mod trials;

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::command::{self, Command, Id};
use super::pane::PaneId;
use super::state::{AppState, JobState, Level, Purpose};
use super::theme::Theme;
use super::update::enabled;
use crate::report::chart::Glyphs;
use crate::report::number;

/// What drawing a pane needs.
struct Painter<'a> {
    state: &'a AppState,
    theme: Theme,
    buf: &'a mut Buffer,
    /// Where the terminal's own cursor goes, when something is typed.
    cursor: Option<(u16, u16)>,
}

/// Draws the whole screen.
pub fn draw(state: &AppState, frame: &mut Frame) {
    let screen = frame.area();
    let mut canvas = Painter {
        state,
        theme: Theme::new(state.capabilities),
        buf: frame.buffer_mut(),
        cursor: None,
    };
    canvas.screen(screen);
    let cursor = canvas.cursor;
    if state.capabilities.glyphs == Glyphs::Ascii {
        paint::only_ascii(frame.buffer_mut());
    }
    if let Some(at) = cursor.filter(|at| screen.contains((*at).into())) {
        frame.set_cursor_position(at);
    }
}

impl Painter<'_> {
    fn screen(&mut self, screen: Rect) {
        let (width, height) = layout::SMALLEST;
        if screen.width < width || screen.height < height {
            let style = self.theme.plain();
            paint::text(
                self.buf,
                (0, 0),
                screen.width,
                &format!("need {width}x{height}"),
                style,
            );
            return;
        }
        let areas = layout::areas(screen);
        self.head(areas.head);
        let focus = self.state.focus();
        let trials = self.state.trials.as_ref().filter(|t| t.shown);
        if let Some(trials) = trials {
            self.trials(areas.tabs.union(areas.body), trials);
        } else if focus == PaneId::Cases {
            self.cases(areas.tabs.union(areas.body));
        } else {
            self.tabs(areas.tabs);
            for (place, area) in layout::panes(screen, self.state) {
                self.pane(screen, place, area);
            }
        }
        self.note(areas.note);
        self.foot(areas.foot);
        if let Some(overlay) = &self.state.overlay {
            self.overlay(screen, overlay);
        }
    }

    fn pane(&mut self, screen: Rect, place: PaneId, area: Rect) {
        let focused = self.state.focus() == place;
        let inside = if layout::framed(screen) {
            let style = if focused {
                self.theme.head()
            } else {
                self.theme.faint()
            };
            let number = self
                .state
                .panes()
                .iter()
                .position(|p| *p == place)
                .map_or(0, |i| i + 1);
            let mark = if focused { "*" } else { "" };
            let title = format!("{number} {}{mark}", place.title());
            paint::framed(
                self.buf,
                area,
                &title,
                self.state.capabilities.glyphs,
                style,
            )
        } else {
            area
        };
        let state = self.state;
        if let Some(file) = &state.file {
            self.file(place, inside, file);
        }
        let Some(open) = &state.open else {
            return;
        };
        match place {
            PaneId::Inputs => self.inputs(inside, &open.editor),
            PaneId::Charts => self.charts(inside, open),
            PaneId::Runs => self.runs(inside, open),
            PaneId::Validation => self.validation(inside, open),
            PaneId::Report => self.report(inside, open),
            PaneId::Jobs => self.jobs(inside),
            PaneId::Nodes => self.nodes(inside, open),
            PaneId::Modes => self.modes(inside, open),
            _ => {}
        }
    }

    fn head(&mut self, line: Rect) {
        let mut x = paint::text(
            self.buf,
            (line.x, line.y),
            line.width,
            "seacable",
            self.theme.head(),
        );
        if let Some(open) = &self.state.open {
            let unsaved = if open.editor.unsaved() {
                " *unsaved"
            } else {
                ""
            };
            let method = super::facade::method_word(open.case.solver.method);
            let words = format!("  {}{unsaved}  solver {method}", open.editor.file);
            x = paint::text(
                self.buf,
                (x, line.y),
                line.right() - x,
                &words,
                self.theme.strong(),
            );
        } else if let Some(file) = &self.state.file {
            let editor = &file.editor;
            let unsaved = if editor.unsaved() { " *unsaved" } else { "" };
            let kind = file.content.view().word();
            let words = format!("  {}{unsaved}  {kind}", editor.file);
            let room = line.right() - x;
            x = paint::text(self.buf, (x, line.y), room, &words, self.theme.strong());
        } else {
            let words = format!("  {}", self.state.cases.dir.display());
            x = paint::text(
                self.buf,
                (x, line.y),
                line.right() - x,
                &words,
                self.theme.plain(),
            );
        }
        let room = line.right().saturating_sub(x + 2);
        let busy = self
            .state
            .file
            .as_ref()
            .and_then(|f| f.content.view().busy());
        let words = match busy {
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
        let Some(line) = running.max_by_key(|l| (l.purpose == Purpose::Run, l.ticket)) else {
            return String::new();
        };
        let p = line.progress;
        let what = match line.purpose {
            Purpose::Live => "live".to_owned(),
            Purpose::Run => format!("{} to go", jobs.open()),
            Purpose::Trials => {
                let words = format!("{:.0} of {:.0} trials", p.time, p.duration);
                return fitting(room, &[words]);
            }
        };
        if p.estimating {
            return fitting(room, &[format!("{what}: estimating errors"), what]);
        }
        if p.steps == 0 {
            return fitting(room, &[format!("{what}: starting"), what]);
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

    fn tabs(&mut self, line: Rect) {
        let mut x = line.x;
        for (i, place) in self.state.panes().iter().enumerate() {
            let style = if *place == self.state.focus() {
                self.theme.selected()
            } else {
                self.theme.plain()
            };
            let words = format!(" {} {} ", i + 1, place.title());
            x = paint::text(
                self.buf,
                (x, line.y),
                line.right().saturating_sub(x),
                &words,
                style,
            );
        }
        let room = line.right().saturating_sub(x + 2);
        let rest = Rect::new(line.right() - room, line.y, room, 1);
        let state = self.state;
        let title = match (&state.file, &state.open) {
            (Some(file), _) => file.content.view().title(),
            (None, Some(open)) => &open.case.case.title,
            (None, None) => return,
        };
        if room > 20 {
            paint::text(self.buf, (rest.x, rest.y), room, title, self.theme.faint());
        }
    }

    fn note(&mut self, line: Rect) {
        let Some(note) = &self.state.note else {
            return;
        };
        let (word, style) = match note.level {
            Level::Info => ("", self.theme.plain()),
            Level::Warning => ("Note: ", self.theme.warning()),
            Level::Error => ("Error: ", self.theme.error()),
        };
        let words = format!("{word}{}", note.text.replace('\n', " "));
        paint::text(self.buf, (line.x, line.y), line.width, &words, style);
    }

    /// The keys of the place, from the table: those that work now, then `?` and `q`.
    fn foot(&mut self, line: Rect) {
        let place = self.state.focus();
        let last = |c: &Command| matches!(c.id, Id::Help | Id::Quit);
        let ends: Vec<&Command> = command::at(place).filter(|c| last(c)).collect();
        let room: u16 = ends.iter().map(|c| key_width(c)).sum();
        let mut x = line.x;
        let limit = line.right().saturating_sub(room);
        let labelled = command::at(place).filter(|c| !c.label.is_empty() && !last(c));
        for command in labelled.filter(|c| enabled(self.state, c.id).is_ok()) {
            if x + key_width(command) > limit {
                break;
            }
            x = self.key(x, line.y, command);
        }
        for command in ends {
            x = self.key(x, line.y, command);
        }
    }

    fn key(&mut self, x: u16, y: u16, command: &Command) -> u16 {
        let Some(key) = command.keys.first() else {
            return x;
        };
        let room = self.buf.area().right().saturating_sub(x);
        let next = paint::text(self.buf, (x, y), room, key, self.theme.selected());
        let room = self.buf.area().right().saturating_sub(next);
        let next = paint::text(
            self.buf,
            (next, y),
            room,
            &format!(" {}", command.label),
            self.theme.plain(),
        );
        next + 2
    }
}

fn key_width(command: &Command) -> u16 {
    let key = command.keys.first().map_or(0, |k| k.len());
    u16::try_from(key + command.label.len() + 3).unwrap_or(u16::MAX)
}

/// The first of the wordings that fits.
fn fitting(room: usize, wordings: &[String]) -> String {
    let found = wordings.iter().find(|w| w.len() <= room);
    found.cloned().unwrap_or_default()
}
