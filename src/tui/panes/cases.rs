//! The list of cases.

use ratatui::layout::{Constraint, Layout, Rect};

use super::interface::{Pane, PaneInfo, about};
use crate::chart::Glyphs;
use crate::command::{self, Command, CommandId, FILTER, LIST, main, other};
use crate::msg::Effect;
use crate::state::{AppState, CaseEntry, CaseList};
use crate::update::build::new_file;
use crate::update::motion::{moved, step};
use crate::update::trials;
use crate::view::paint::{span, wrap};
use crate::view::painter::Painter;
use crate::visible;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::Open, &["enter", "l", "right"], "open", "Open the case under the cursor"),
    FILTER,
    main(CommandId::NewFile, &["n"], "new", "Make a new file of a template: mooring line, spread mooring, lowering, umbilical, ropeway and others"),
    other(CommandId::Trials, &["T"], "trials", "Compute the trials of all hard cases listed, and compare them with the results required"),
    other(CommandId::ExternalEditor, &["E"], "editor", "Open the file under the cursor in $VISUAL or $EDITOR, also one that cannot be read, at its first fault"),
    other(CommandId::Reload, &["ctrl+r"], "", "Read the list of cases again"),
    command::DOWN,
];

pub(super) struct CasesPane;

impl Pane for CasesPane {
    fn about(&self) -> PaneInfo {
        about("Cases", "", &[COMMANDS, LIST])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let of_file = matches!(id, CommandId::Open | CommandId::ExternalEditor);
        (of_file && state.cases.current().is_none()).then_some(match state.cases.is_read {
            true => "There is no case here. `:reload` reads the directory again.",
            false => "The cases are still being read.",
        })
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        match id {
            CommandId::Open => {
                let entry = state.cases.current()?;
                Some(vec![Effect::ReadCase(entry.path.clone())])
            }
            CommandId::ExternalEditor => {
                let entry = state.cases.current()?;
                Some(vec![Effect::EditFile(entry.path.clone())])
            }
            CommandId::NewFile => Some(new_file::choose(state)),
            CommandId::Reload => Some(vec![Effect::ReadCases]),
            CommandId::Trials => Some(trials::show(state)),
            CommandId::Filter => {
                state.cases.filter.typing = true;
                Some(Vec::new())
            }
            _ => {
                let by = step(state, id)?;
                let lines = state.cases.shown().len();
                state.cases.cursor = moved(state.cases.cursor, by, lines);
                Some(Vec::new())
            }
        }
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let [head, list, rule, about] = Layout::vertical([
            Constraint::Length(1),
            Constraint::Min(3),
            Constraint::Length(1),
            Constraint::Length(if area.height > 16 { 6 } else { 3 }),
        ])
        .areas(area);
        let cases = &painter.state.cases;
        let entries: Vec<&CaseEntry> = cases.shown();
        if cases.filter.typing || !cases.filter.is_empty() {
            painter.filter_line(head, &cases.filter, (entries.len(), cases.entries.len()));
        } else {
            let words = format!("Cases ({})", cases.entries.len());
            painter.text(head, &words, painter.theme.strong());
        }
        if entries.is_empty() {
            painter.paragraph(list, &without_entries(cases));
        }
        let widths = entries.iter().map(|entry| entry.name.chars().count());
        let widest = u16::try_from(widths.max().unwrap_or(0)).unwrap_or(30);
        let name_width = widest.clamp(16, 40).min(area.width / 2);
        painter.list(list, cases.cursor, entries.len(), |painter, line, i| {
            case_line(painter, line, entries[i], i == cases.cursor, name_width);
        });
        let rule_char = match painter.glyphs() {
            Glyphs::Braille => "─",
            Glyphs::Ascii => "-",
        };
        let words = rule_char.repeat(rule.width.into());
        painter.text(rule, &words, painter.theme.faint());
        if let Some(entry) = entries.get(cases.cursor) {
            about_case(painter, about, entry);
        }
    }
}

/// What is said in the place of entries.
fn without_entries(cases: &CaseList) -> String {
    if let Some(file) = &cases.opening {
        let file = visible::path(file);
        return format!(
            "{file} is being read, and its equilibrium searched. The list of cases comes after it."
        );
    }
    let words = match cases.entries.is_empty() {
        true if !cases.is_read => "The cases of the directory are being read.",
        true => "There is no case file (*.toml) here. `seacable DIR` opens another directory.",
        false => "No case passes the filter. `:filter` and Esc drop it.",
    };
    words.to_owned()
}

fn case_line(painter: &mut Painter, line: Rect, entry: &CaseEntry, selected: bool, width: u16) {
    let style = painter.line_style(selected);
    painter.buf.set_style(line, style);
    painter.text(span(line, 1, width), &entry.name, style);
    let rest = span(line, width + 3, u16::MAX);
    match &entry.about {
        Ok((title, _)) => painter.text(rest, title, style),
        Err((problem, _)) => {
            let words = format!("cannot be read: {problem}");
            painter.text(rest, &words, style.patch(painter.theme.error()))
        }
    };
}

/// More about the case under the cursor.
fn about_case(painter: &mut Painter, area: Rect, entry: &CaseEntry) {
    let words = match &entry.about {
        Ok((title, source)) if source.is_empty() => title.clone(),
        Ok((title, source)) => format!("{title}\nSource: {source}"),
        Err((_, whole)) => whole.clone(),
    };
    let plain = painter.theme.plain();
    let lines = words.lines().flat_map(|line| {
        if line.starts_with(' ') {
            vec![line.to_owned()]
        } else {
            wrap(line, area.width.into())
        }
    });
    painter.lines(area, lines.map(|line| (line, plain)));
}
