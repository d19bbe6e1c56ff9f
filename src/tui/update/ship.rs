//! A ship on the screen: which equilibrium and which motion are shown, and the thread of its dynamic analysis.

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
        Id::Write | Id::HandOver if ship.running.is_some() => {
            let words = "The dynamic analysis is still running; it can be written in a moment.";
            return Some(info(state, words));
        }
        _ => return None,
    }
    Some(Vec::new())
}

/// Shows another equilibrium in full.
pub(super) fn choose(ship: &mut ShipView, by: isize) {
    let count = ship.statics.equilibria.as_ref().map_or(0, Vec::len);
    ship.equilibrium = moved(ship.equilibrium, by, count);
}

/// Starts the dynamic analysis of the current text, and stops the one that is running.
pub(super) fn resolve(state: &mut AppState) -> Option<Effect> {
    let path = state.editor().map(|editor| editor.path.clone())?;
    let ship = open(state)?;
    ship.stop();
    let stop = Arc::new(AtomicBool::new(false));
    ship.running = Some(Arc::clone(&stop));
    let folder = path.parent().map_or_else(PathBuf::new, PathBuf::from);
    Some(Effect::ComputeShip(
        Box::new(ship.statics.clone()),
        folder,
        stop,
    ))
}

/// Takes a dynamic analysis over, unless the text has changed since.
pub(super) fn worked(
    state: &mut AppState,
    by: &Arc<AtomicBool>,
    dynamic: Option<Arc<DynamicAnalysis>>,
) -> Vec<Effect> {
    let text = state.editor().map(|editor| editor.text.clone());
    let Some(ship) = open(state) else {
        return Vec::new();
    };
    let newest = ship
        .running
        .as_ref()
        .is_some_and(|own| Arc::ptr_eq(own, by));
    if !newest {
        return Vec::new();
    }
    ship.running = None;
    ship.dynamic = dynamic;
    let checks = ship.checks(&text.unwrap_or_default());
    if let Some(file) = &mut state.file {
        file.checks = checks;
    }
    Vec::new()
}
