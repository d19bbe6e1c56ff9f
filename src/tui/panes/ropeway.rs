//! A ropeway: the slider that moves its cargo, its picture, the results.

use ratatui::layout::{Constraint, Layout, Rect};

use super::interface::{Pane, PaneInfo, about};
use crate::chart::Glyphs;
use crate::command::{Command, CommandId, main, other};
use crate::msg::Effect;
use crate::number::{percent, rounded};
use crate::state::parts::{PartView, ScreenPart};
use crate::state::{AppState, DocumentContent, RopewayView};
use crate::table::CellStyle;
use crate::update::edit;
use crate::view::paint::below_head;
use crate::view::painter::Painter;

/// Lines that the results take: head, rule, and a line each.
const RESULTS: u16 = 9;

/// Parts of the span that the cargo moves at a key, and at a key for large steps.
const STEP: f64 = 0.01;
const LEAP: f64 = 0.1;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::CursorRight, &["l", "right"], "to ship", "Move the cargo towards the ship"),
    main(CommandId::CursorLeft, &["h", "left"], "to platform", "Move the cargo towards the platform"),
    main(CommandId::Fit, &["0"], "file's place", "Put the cargo back to its position in the file"),
    main(CommandId::KeepPosition, &["K"], "keep place", "Set cargo.position in the file to the position of the cargo"),
    other(CommandId::LeapRight, &["L", "pgdn"], "", "Move the cargo towards the ship by a tenth of the span"),
    other(CommandId::LeapLeft, &["H", "pgup"], "", "Move the cargo towards the platform by a tenth of the span"),
];

pub(super) struct RopewayPane;

impl Pane for RopewayPane {
    fn about(&self) -> PaneInfo {
        about("Ropeway", "Go to the drawing", &[COMMANDS])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let DocumentContent::Ropeway(ropeway) = &state.document.as_ref()?.content else {
            return None;
        };
        let moved = (ropeway.position - ropeway.worked.ropeway.cargo.position).abs() > 0.0;
        let of_place = matches!(id, CommandId::Fit | CommandId::KeepPosition);
        (of_place && !moved).then_some("The cargo is where the file has it.")
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let DocumentContent::Ropeway(ropeway) = &mut state.document.as_mut()?.content else {
            return None;
        };
        match id {
            CommandId::CursorLeft => ropeway.put(ropeway.position - STEP),
            CommandId::CursorRight => ropeway.put(ropeway.position + STEP),
            CommandId::LeapLeft => ropeway.put(ropeway.position - LEAP),
            CommandId::LeapRight => ropeway.put(ropeway.position + LEAP),
            CommandId::Fit => ropeway.put(ropeway.worked.ropeway.cargo.position),
            CommandId::KeepPosition => {
                let value = format!("{:?}", (ropeway.position * 1e4).round() / 1e4);
                return Some(edit::set(state, "cargo.position", &value));
            }
            _ => return None,
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let document = painter.state.document.as_ref();
        let Some(DocumentContent::Ropeway(ropeway)) = document.map(|document| &document.content)
        else {
            return;
        };
        let [bar, below] = below_head(area);
        slider(painter, bar, ropeway);
        painter.part(below, ScreenPart::Drawing, |painter, view| {
            let Some(chart) = &view.chart else {
                return words(painter, below, view);
            };
            let [drawing, readout, table] = Layout::vertical([
                Constraint::Min(4),
                Constraint::Length(1),
                Constraint::Length(RESULTS),
            ])
            .areas(below);
            painter.chart(chart, drawing);
            words(painter, readout, view);
            let plain = painter.theme.plain();
            let lines = view.table.to_text(table.width.into());
            painter.lines(table, lines.lines().map(|line| (line, plain)));
        });
    }
}

/// What is said of the rope, one after the other.
fn words(painter: &mut Painter, line: Rect, view: &PartView) {
    let mut rest = line;
    for (i, (words, style)) in view.words.iter().enumerate() {
        let style = match style {
            CellStyle::Plain if i == 0 => painter.theme.strong(),
            style => painter.theme.cell(*style),
        };
        rest = painter.text(rest, words, style);
    }
}

/// Where the cargo is between platform and ship.
fn slider(painter: &mut Painter, line: Rect, ropeway: &RopewayView) {
    let span = ropeway.worked.rope.geometry.span_m;
    let words = format!(
        " ship  cargo {} m of {} m, {}",
        rounded(ropeway.position * span, 2),
        rounded(span, 1),
        percent(ropeway.position)
    );
    let head = "platform ";
    let used = head.len() + words.len();
    let room = usize::from(line.width).saturating_sub(used).max(3);
    let (bar, mark) = match painter.glyphs() {
        Glyphs::Braille => ('─', '█'),
        Glyphs::Ascii => ('-', '#'),
    };
    let at = (ropeway.position * (room - 1) as f64).round() as usize;
    let rail: String = (0..room)
        .map(|i| if i == at { mark } else { bar })
        .collect();
    let rest = painter.text(line, head, painter.theme.plain());
    let rest = painter.text(rest, &rail, painter.theme.strong());
    painter.text(rest, &words, painter.theme.plain());
}
