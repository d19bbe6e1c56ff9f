//! Trials of hard cases: how far they are, and their table.

use std::path::PathBuf;

use ratatui::layout::{Constraint, Layout, Rect};

use super::interface::{Pane, PaneInfo, about};
use crate::command::{COLUMNS, Command, CommandId, DOWN, LIST, TABLE, main};
use crate::msg::Effect;
use crate::state::trials::{self as data, Trials, TrialsOf};
use crate::state::{AppState, Filter};
use crate::study::{hard_cases, tally};
use crate::update::motion::table_verb;
use crate::update::notice::info;
use crate::update::{export, trials};
use crate::view::paint::{below_head, wrap};
use crate::view::painter::Painter;

/// Columns of the table in a file.
const TEXT_WIDTH: usize = 160;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::CancelJob, &["x"], "stop", "Stop computing the trials"),
    main(CommandId::Sort, &["o"], "sort", "Sort by the next column; after the last: in the original order"),
    main(CommandId::Write, &["w"], "write", "Write the table to a text file"),
    main(CommandId::Trials, &["T"], "anew", "Compute the trials again"),
    main(CommandId::Back, &["esc", "b"], "back", "Back to where you were; the trials continue"),
    DOWN,
];

pub(super) struct TrialsPane;

impl Pane for TrialsPane {
    fn about(&self) -> PaneInfo {
        about("Trials", "", &[COMMANDS, LIST, TABLE, COLUMNS])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let trials = state.trials.as_ref()?;
        let when = |condition: bool, reason: &'static str| condition.then_some(reason);
        match id {
            CommandId::CancelJob => when(!trials.running(), "All trials are computed already."),
            CommandId::Write => when(
                trials.progress.findings.is_empty(),
                "No trial is computed yet.",
            ),
            _ => None,
        }
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let (verb, columns) = (table_verb(state, id), state.size.0);
        let trials = state.trials.as_mut()?;
        match id {
            CommandId::Trials => {
                let of = trials.of.clone();
                return Some(trials::begin(state, of));
            }
            CommandId::Back if !trials.pane.filter.is_empty() => {
                trials.pane.filter = Filter::default();
            }
            CommandId::Back => trials.shown = false,
            CommandId::CancelJob | CommandId::Interrupt if trials.running() => {
                let effects = trials::stop(state);
                info(state, "Stopped; `:trials` computes the trials again.");
                return Some(effects);
            }
            CommandId::Write => {
                let tally = tally(&trials.progress.findings);
                let table = trials.table(u16::MAX).to_text(TEXT_WIDTH);
                let text = format!("{table}\n{tally}\n");
                let path = PathBuf::from("hard-cases.txt");
                return Some(export::write(path, Some(text), "The table of trials"));
            }
            _ => {
                let table = trials.table(columns);
                trials.pane.act(verb?, &table);
            }
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(trials) = &painter.state.trials else {
            return;
        };
        let [head, rest] = below_head(area);
        headline(painter, head, trials);
        if trials.progress.findings.is_empty() {
            let words = if trials.running() || trials.stopped {
                "Nothing is computed yet."
            } else {
                "None of these cases has trials. A `[[trial]]` table in a case file makes one."
            };
            painter.text(rest, words, painter.theme.plain());
            return;
        }
        let table = trials.table(area.width);
        let narrow = area.width < data::WIDE;
        let [list, detail] = Layout::vertical([
            Constraint::Min(0),
            Constraint::Length(if narrow { rest.height * 2 / 5 } else { 0 }),
        ])
        .areas(rest);
        painter.table(&trials.pane, &table, list);
        if narrow && let Some(finding) = trials.selected(&table) {
            let (strong, plain) = (painter.theme.strong(), painter.theme.plain());
            let styles = std::iter::once(strong).chain(std::iter::repeat(plain));
            let story = hard_cases::description(finding);
            let lines = story
                .iter()
                .flat_map(|line| wrap(line, detail.width.into()));
            painter.lines(detail, lines.zip(styles));
        }
    }
}

/// Whose trials, how far they are, and how many passed.
fn headline(painter: &mut Painter, line: Rect, trials: &Trials) {
    let progress = &trials.progress;
    let whose = match &trials.of {
        TrialsOf::Case { file, .. } => format!("Trials of {file}"),
        TrialsOf::Files(_) => "All hard cases".to_owned(),
    };
    let far = match (trials.running(), trials.stopped) {
        (true, _) => format!(", {} of {}", progress.done, progress.all),
        (false, true) => format!(", stopped at {} of {}", progress.done, progress.all),
        (false, false) => format!(", {}", progress.all),
    };
    let tally = tally(&progress.findings);
    let counts = tally.to_string();
    let counts = counts.split_once(": ").map_or("", |(_, counts)| counts);
    let rest = painter.text(line, &format!("{whose}{far}: "), painter.theme.strong());
    let style = match (tally.holds(), trials.running()) {
        (false, _) => painter.theme.error(),
        (true, true) => painter.theme.plain(),
        (true, false) => painter.theme.good(),
    };
    painter.text(rest, counts, style);
}
