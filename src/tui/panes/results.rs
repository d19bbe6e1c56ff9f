//! The results of what is open: all of them in a pane; of a line case those that matter in a band of the cockpit.

use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use super::interface::{Pane, PaneInfo, about};
use crate::chart::Glyphs;
use crate::command::{self, Command, CommandId, LIST, main, other};
use crate::msg::Effect;
use crate::result_lines::{self, ResultLine};
use crate::state::study_of::StudyOf;
use crate::state::{AppState, DocumentContent};
use crate::update::motion::{moved, step};
use crate::update::{pages, results};
use crate::view::paint::{below_head, right, span};
use crate::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::Select, &["space", "enter"], "choose", "Show this result beside the inputs, or take it off"),
    main(CommandId::HoldAgainst, &["v"], "hold", "Hold these results: later ones are shown with their difference from them"),
    main(CommandId::InputEffects, &["i"], "what matters", "Vary every input by its tolerance, and rank the inputs by what that does to this result"),
    main(CommandId::Physics, &["P"], "what it needs", "Leave out every effect of the scene in turn, and show what that changes in this result, and its cost"),
    other(CommandId::Fit, &["0"], "main ones", "Show the main results of the case beside the inputs again"),
    command::DOWN,
];

pub(super) struct ResultsPane;

impl Pane for ResultsPane {
    fn about(&self) -> PaneInfo {
        about("Results", "Go to the results", &[COMMANDS, LIST])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        match id {
            CommandId::HoldAgainst => results::why_not_held(state),
            CommandId::Select => results::why_not_beside(state),
            CommandId::InputEffects | CommandId::Physics => results::why_no_result(state),
            CommandId::Fit => results::why_not_beside(state).or_else(|| {
                results::shows_main_ones(state)
                    .then_some("The main results stand beside the inputs already.")
            }),
            _ => None,
        }
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let by = step(state, id);
        match id {
            CommandId::Select => return Some(results::choose(state)),
            CommandId::HoldAgainst => return Some(results::hold_live(state)),
            CommandId::InputEffects => return Some(pages::study(state, StudyOf::Inputs)),
            CommandId::Physics => return Some(pages::study(state, StudyOf::Physics)),
            CommandId::Fit => results::main_ones(state),
            _ => {
                let document = state.document.as_mut()?;
                let count = result_lines::listed(document).len();
                document.result = moved(document.result, by?, count);
            }
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(document) = &painter.state.document else {
            return;
        };
        let [head, list] = below_head(area);
        let lines = result_lines::all(document);
        let widths = Widths::of_lines(&lines, area.width);
        title(painter, head);
        let (cursor, of_line) = (document.result, document.line().is_some());
        painter.list(list, cursor, lines.len(), |painter, at, i| {
            let style = painter.line_style(i == cursor);
            painter.buf.set_style(at, style);
            // Those of a line case alone stand beside the inputs.
            let mark = match (of_line, lines[i].chosen) {
                (false, _) => "",
                (true, true) => "[x] ",
                (true, false) => "[ ] ",
            };
            let rest = painter.text(at, mark, style);
            widths.line(painter, rest, &lines[i], style);
        });
    }
}

/// The band of the cockpit: the results chosen, below a line that says what they are held against and how old they are.
pub fn band(painter: &mut Painter, area: Rect) {
    let Some(line) = painter.state.line() else {
        return;
    };
    let [head, list] = below_head(area);
    title(painter, head);
    let lines = result_lines::chosen(line);
    let widths = Widths::of_lines(&lines, area.width);
    // What is coarse says so by its numbers.
    let stale = staleness(painter.state).is_some_and(|words| !words.starts_with("coarse:"));
    for (words, y) in lines.iter().zip(list.top()..list.bottom()) {
        let at = Rect::new(list.x, y, list.width, 1);
        let style = if stale {
            painter.theme.faint()
        } else {
            painter.theme.plain()
        };
        widths.line(painter, span(at, 2, at.width), words, style);
    }
}

/// What the results are of, when not of the inputs as they are.
fn staleness(state: &AppState) -> Option<&'static str> {
    let document = state.document.as_ref()?;
    if let DocumentContent::System(system) = &document.content {
        let run = result_lines::system_run(document, system);
        let lacks_run = system.has_runs() && run.is_none();
        return lacks_run.then_some("not computed yet");
    }
    let (line, editor) = (document.line()?, &document.editor);
    let live = &line.runs_view.live;
    if let Some(coarse) = &live.coarse {
        let of_inputs = coarse.text == editor.text && editor.pending.is_empty();
        return Some(match (of_inputs, live.ticket.is_some()) {
            (true, true) => "coarse: the full solve goes on",
            (true, false) => "coarse: the full solve was cancelled",
            (false, true) => "coarse, older than the inputs: solving",
            (false, false) => "coarse, older than the inputs",
        });
    }
    if live.done.is_none() {
        return Some(if live.failure.is_some() {
            "no results: the solve failed"
        } else {
            "solving"
        });
    }
    if live.done_text == editor.text && live.ticket.is_none() && editor.pending.is_empty() {
        return None;
    }
    let solving = live.ticket.is_some() || !editor.pending.is_empty();
    Some(match (solving, &live.failure) {
        (true, _) => "older than the inputs: solving",
        (false, Some(_)) => "older than the inputs: the last solve failed",
        (false, None) => "older than the inputs",
    })
}

fn title(painter: &mut Painter, head: Rect) {
    let rule = if painter.glyphs() == Glyphs::Braille {
        "\u{2500}"
    } else {
        "-"
    };
    let faint = painter.theme.faint();
    painter.text(head, &rule.repeat(head.width.into()), faint);
    let style = painter.theme.head();
    painter.text(span(head, 2, head.width), " results ", style);
    let view = painter.state.runs_view();
    let against = view.and_then(|view| view.against.as_ref());
    let against = against.map(|(name, _)| format!(" against {name} "));
    let words = match (staleness(painter.state), against) {
        (Some(stale), _) => format!(" {stale} "),
        (None, Some(against)) => against,
        (None, None) => String::new(),
    };
    let style = if staleness(painter.state).is_some() {
        painter.theme.warning()
    } else {
        faint
    };
    right(
        painter.buf,
        span(head, 12, head.width.saturating_sub(14)),
        &words,
        style,
    );
}

/// A name of so many columns: its end says which statistic of which window it is, as its beginning says of what.
fn cut_in_the_middle(name: &str, width: usize, glyphs: Glyphs) -> String {
    let letters: Vec<char> = name.chars().collect();
    let mark = if glyphs == Glyphs::Braille {
        "\u{2026}"
    } else {
        "~"
    };
    if letters.len() <= width || width < 5 {
        return name.to_owned();
    }
    let tail = (width - 1) * 3 / 5;
    let head: String = letters[..width - 1 - tail].iter().collect();
    let tail: String = letters[letters.len() - tail..].iter().collect();
    format!("{head}{mark}{tail}")
}

/// Columns of the results.
struct Widths {
    name: u16,
    value: u16,
    difference: u16,
}

impl Widths {
    fn of_lines(lines: &[ResultLine], room: u16) -> Self {
        let widest = |of: fn(&ResultLine) -> &str| {
            let width = lines.iter().map(|line| of(line).width()).max().unwrap_or(0);
            u16::try_from(width).unwrap_or(u16::MAX)
        };
        let (difference, share) = (widest(|line| &line.difference), widest(|line| &line.share));
        // Where nothing stands behind them, values have the room to say that they have no error.
        let widest_value = if difference + share > 0 { 27 } else { 40 };
        let value = widest(|line| &line.value).min(widest_value);
        let difference = difference.max(6);
        let taken = value + difference + share + 6 + 4;
        let name = widest(|line| &line.name).min(room.saturating_sub(taken).max(12));
        Self {
            name,
            value,
            difference,
        }
    }

    fn line(&self, painter: &mut Painter, at: Rect, line: &ResultLine, style: Style) {
        let name = cut_in_the_middle(&line.name, self.name.into(), painter.glyphs());
        painter.text(span(at, 0, self.name), &name, style);
        let mut from = self.name + 2;
        right(painter.buf, span(at, from, self.value), &line.value, style);
        from += self.value + 2;
        right(
            painter.buf,
            span(at, from, self.difference),
            &line.difference,
            style,
        );
        from += self.difference + 2;
        let style = if line.exceeded {
            painter.theme.error()
        } else {
            style
        };
        painter.text(span(at, from, at.width), &line.share, style);
    }
}
