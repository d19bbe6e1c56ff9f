//! A ropeway on the screen: the cargo moved along it, and other spans.

use super::edit;
use crate::tui::command::Id;
use crate::tui::msg::Effect;
use crate::tui::state::ropeway::SPANS;
use crate::tui::state::{AppState, Content, RopewayView};

/// Parts of the span that the cargo goes at a key, and at a key for large steps.
const STEP: f64 = 0.01;
const LEAP: f64 = 0.1;

/// What a command does to a ropeway alone; absent: the same as to every file.
pub(super) fn command(state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
    let ropeway = open(state)?;
    match id {
        Id::CursorLeft => ropeway.put(ropeway.position - STEP),
        Id::CursorRight => ropeway.put(ropeway.position + STEP),
        Id::LeapLeft => ropeway.put(ropeway.position - LEAP),
        Id::LeapRight => ropeway.put(ropeway.position + LEAP),
        Id::Fit => ropeway.put(ropeway.worked.ropeway.cargo.position),
        Id::NextSpan => return Some(span(state, true)),
        Id::PreviousSpan => return Some(span(state, false)),
        Id::KeepPlace => return Some(keep_place(state)),
        _ => return None,
    }
    Some(Vec::new())
}

fn open(state: &mut AppState) -> Option<&mut RopewayView> {
    match &mut state.file.as_mut()?.content {
        Content::Ropeway(ropeway) => Some(ropeway),
        _ => None,
    }
}

/// The next or previous of the paper's spans; an edit like any other.
fn span(state: &mut AppState, forward: bool) -> Vec<Effect> {
    let Some(ropeway) = open(state) else {
        return Vec::new();
    };
    let now = ropeway.worked.rope.geometry.span_m;
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
fn keep_place(state: &mut AppState) -> Vec<Effect> {
    let place = open(state).map(|ropeway| ropeway.position);
    let value = place.map(|place| format!("{:?}", (place * 1e4).round() / 1e4));
    value.map_or_else(Vec::new, |value| edit::set(state, "cargo.position", &value))
}
