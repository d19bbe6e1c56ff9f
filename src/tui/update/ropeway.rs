//! A ropeway on the screen: the cargo moved along it, its panes, other spans, and handing it over to a line.

use std::path::PathBuf;

use super::{edit, overlay, runs};
use crate::reference;
use crate::report::chart::Glyphs;
use crate::ropeway::exact::Carrier;
use crate::ropeway::{held, line, text};
use crate::tui::backend;
use crate::tui::command::{Id, Place};
use crate::tui::msg::{Effect, RopewayRead};
use crate::tui::state::ropeway::{LEAVES, SPANS};
use crate::tui::state::{OpenRopeway, Overlay, Question, Sheet, State};

/// Parts of the span that the cargo goes at a key, and at a key for large steps.
const STEP: f64 = 0.01;
const LEAP: f64 = 0.1;

pub(super) fn opened(state: &mut State, read: RopewayRead) -> Vec<Effect> {
    state.open = None;
    state.section = None;
    let sheet = Sheet::new(read.path, read.text);
    state.ropeway = Some(Box::new(OpenRopeway::new(sheet, read.worked)));
    edit::refresh(state);
    if let Some(text) = read.recovered {
        state.overlay = Some(Overlay::Ask(Question::Recover { text }));
    }
    Vec::new()
}

/// Takes over what the text comes to.
pub(super) fn refreshed(ropeway: &mut OpenRopeway, worked: crate::ropeway::Worked) {
    ropeway.sheet.rows = backend::ropeway_rows(&ropeway.sheet.text, &worked);
    // Where the file's own place changes, the cargo goes there.
    let moved = ropeway.worked.ropeway.cargo.position != worked.ropeway.cargo.position;
    let position = if moved {
        worked.ropeway.cargo.position
    } else {
        ropeway.position
    };
    ropeway.worked = worked;
    ropeway.checks = held::rows(&ropeway.worked, &ropeway.sheet.text);
    ropeway.put(position);
}

/// What a command does to a ropeway; absent: the same as everywhere.
pub(super) fn command(state: &mut State, id: Id) -> Option<Vec<Effect>> {
    let glyphs = state.looks.glyphs;
    let ropeway = state.ropeway.as_mut()?;
    let leaf = |by: usize| (ropeway.leaf + by) % LEAVES.len();
    match id {
        Id::CursorLeft => ropeway.put(ropeway.position - STEP),
        Id::CursorRight => ropeway.put(ropeway.position + STEP),
        Id::LeapLeft => ropeway.put(ropeway.position - LEAP),
        Id::LeapRight => ropeway.put(ropeway.position + LEAP),
        Id::Fit => ropeway.put(ropeway.worked.ropeway.cargo.position),
        Id::NextTable => ropeway.leaf = leaf(1),
        Id::PreviousTable => ropeway.leaf = leaf(LEAVES.len() - 1),
        Id::ScrollLeft | Id::ScrollRight | Id::Sort => act(ropeway, id),
        Id::NextSpan => return Some(span(state, true)),
        Id::PreviousSpan => return Some(span(state, false)),
        Id::KeepPlace => return Some(keep_place(state)),
        Id::LineCase => return Some(line_case(ropeway)),
        Id::Write => return Some(write(ropeway, glyphs)),
        _ => return None,
    }
    Some(Vec::new())
}

fn act(ropeway: &mut OpenRopeway, id: Id) {
    if ropeway.pane == Place::RopewayChecks {
        let table = reference::table(&ropeway.checks);
        ropeway.checks_pane.act(runs::table_verb(id), &table);
    } else {
        let (_, table) = ropeway.shown();
        ropeway.panes[ropeway.leaf].act(runs::table_verb(id), &table);
    }
}

/// The next or previous of the paper's spans; an edit like any other.
fn span(state: &mut State, forward: bool) -> Vec<Effect> {
    let Some(ropeway) = &state.ropeway else {
        return Vec::new();
    };
    let now = ropeway.worked.span.gap.span_m;
    let next = if forward {
        let longer = SPANS.iter().find(|span| **span > now + 1e-9);
        longer.copied().unwrap_or(SPANS[0])
    } else {
        let shorter = SPANS.iter().rev().find(|span| **span < now - 1e-9);
        shorter.copied().unwrap_or(SPANS[SPANS.len() - 1])
    };
    edit::set(state, "ropeway.span_m", &format!("{next:?}"))
}

/// Writes the place of the cargo into the text.
fn keep_place(state: &mut State) -> Vec<Effect> {
    let place = state.ropeway.as_ref().map(|ropeway| ropeway.position);
    let value = place.map(|place| format!("{:?}", (place * 1e4).round() / 1e4));
    value.map_or_else(Vec::new, |value| edit::set(state, "cargo.position", &value))
}

/// Hands the rope with its cargo over: a line case in a file of its own.
fn line_case(ropeway: &OpenRopeway) -> Vec<Effect> {
    let stem = ropeway.sheet.file.trim_end_matches(".toml");
    let text = ropeway
        .readings
        .as_ref()
        .ok()
        .filter(|readings| readings.exact.carrier == Carrier::Rope)
        .map(|readings| {
            line::case_text(
                &ropeway.worked.ropeway,
                readings.length_m,
                readings.exact.arc_m,
            )
        });
    runs::write(
        PathBuf::from(format!("{stem}-line.toml")),
        text,
        "The rope with its cargo as a line case",
    )
}

/// Writes the report, or from its pane the validation table.
fn write(ropeway: &OpenRopeway, glyphs: Glyphs) -> Vec<Effect> {
    let stem = ropeway.sheet.file.trim_end_matches(".toml");
    if ropeway.pane == Place::RopewayChecks {
        let words = crate::report::text::validation(&ropeway.checks);
        let path = PathBuf::from(format!("{stem}-validation.txt"));
        return runs::write(path, Some(words), "The validation table");
    }
    let words = ropeway
        .readings
        .as_ref()
        .ok()
        .map(|readings| text::text(&ropeway.worked, readings, &ropeway.sheet.text, glyphs));
    let path = PathBuf::from(format!("{stem}-report.txt"));
    runs::write(path, words, "The report")
}

/// Goes to another pane.
pub(super) fn pane(state: &mut State, id: Id) -> Vec<Effect> {
    if let Some(ropeway) = &mut state.ropeway {
        let panes = Place::OF_ROPEWAY;
        let now = panes.iter().position(|p| *p == ropeway.pane).unwrap_or(0);
        ropeway.pane = panes[match id {
            Id::NextPane => (now + 1) % panes.len(),
            Id::PreviousPane => (now + panes.len() - 1) % panes.len(),
            Id::Pane(n) => usize::from(n.saturating_sub(1)).min(panes.len() - 1),
            _ => now,
        }];
    }
    Vec::new()
}

/// Moves the cursor of the pane.
pub(super) fn move_by(state: &mut State, by: isize) -> Vec<Effect> {
    if let Some(ropeway) = &mut state.ropeway {
        match ropeway.pane {
            Place::RopewayChecks => {
                let table = reference::table(&ropeway.checks);
                ropeway.checks_pane.act(overlay::by_rows(by), &table);
            }
            Place::RopewayTables => {
                let (_, table) = ropeway.shown();
                ropeway.panes[ropeway.leaf].act(overlay::by_rows(by), &table);
            }
            _ => {
                let sheet = &mut ropeway.sheet;
                sheet.field = super::moved(sheet.field, by, sheet.fields().count());
            }
        }
    }
    Vec::new()
}
