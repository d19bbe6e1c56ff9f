//! A ship on the screen: which heading and which motion are shown, and the thread that works it out at sea.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::{info, moved};
use crate::physics::sea::DEGREES;
use crate::ship::DynamicAnalysis;
use crate::tui::command::Id;
use crate::tui::msg::Effect;
use crate::tui::state::{AppState, Content, FileView, ShipView};

fn open(state: &mut AppState) -> Option<&mut ShipView> {
    match &mut state.file.as_mut()?.content {
        Content::Ship(ship) => Some(ship),
        _ => None,
    }
}

/// What a command does to a ship alone; absent: the same as to every file.
pub(super) fn command(state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
    let ship = open(state)?;
    match id {
        Id::NextTrace => {
            ship.trace = match ship.trace {
                None => Some(0),
                Some(last) if last + 1 >= DEGREES.len() => None,
                Some(trace) => Some(trace + 1),
            };
        }
        Id::Write | Id::HandOver if ship.working.is_some() => {
            let words = "The ship at sea is still being worked out; it can be written in a moment.";
            return Some(info(state, words));
        }
        _ => return None,
    }
    Some(Vec::new())
}

/// Shows another heading in full.
pub(super) fn choose(ship: &mut ShipView, by: isize) {
    let count = ship.rest.equilibria.as_ref().map_or(0, Vec::len);
    ship.equilibrium = moved(ship.equilibrium, by, count);
}

/// Works the ship out at sea, as its text now says; what is under way is stopped.
pub(super) fn resolve(state: &mut AppState) -> Option<Effect> {
    let path = state.editor().map(|editor| editor.path.clone())?;
    let ship = open(state)?;
    ship.stop();
    let stop = Arc::new(AtomicBool::new(false));
    ship.working = Some(Arc::clone(&stop));
    let folder = path.parent().map_or_else(PathBuf::new, PathBuf::from);
    Some(Effect::ComputeShip(
        Box::new(ship.rest.clone()),
        folder,
        stop,
    ))
}

/// Takes a ship at sea over, unless the text has changed since.
pub(super) fn worked(
    state: &mut AppState,
    by: &Arc<AtomicBool>,
    sea: Option<Arc<DynamicAnalysis>>,
) -> Vec<Effect> {
    let text = state.editor().map(|editor| editor.text.clone());
    let Some(ship) = open(state) else {
        return Vec::new();
    };
    let newest = ship
        .working
        .as_ref()
        .is_some_and(|own| Arc::ptr_eq(own, by));
    if !newest {
        return Vec::new();
    }
    ship.working = None;
    ship.sea = sea;
    let checks = ship.checks(&text.unwrap_or_default());
    if let Some(file) = &mut state.file {
        file.checks = checks;
    }
    Vec::new()
}
