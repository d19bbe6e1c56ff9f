//! A ship: which motion is drawn, and the thread of its dynamic analysis.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::msg::Effect;
use crate::physics::sea::DEGREES;
use crate::ship::DynamicAnalysis;
use crate::state::ship::ShipAtSea;
use crate::state::value_check::ValidationTable;
use crate::state::{AppState, Document, DocumentContent, DocumentKind, ShipView};

fn ship(document: &mut Document) -> Option<&mut ShipView> {
    match &mut document.content {
        DocumentContent::Ship(ship) => Some(ship),
        _ => None,
    }
}

/// Draws the next motion alone; after the last: all of them.
pub fn next_motion(ship: &mut ShipView) {
    let next = ship.trace.map_or(0, |trace| trace + 1);
    ship.trace = (next < DEGREES.len()).then_some(next);
}

/// Starts the dynamic analysis of the current text, and stops the one that is running.
pub(super) fn resolve(state: &mut AppState) -> Option<Effect> {
    let document = state.document.as_mut()?;
    let path = document.editor.path.clone();
    let edited = document.editor.edited.clone();
    let ship = ship(document)?;
    ship.stop();
    let stop = Arc::new(AtomicBool::new(false));
    ship.running = Some(Arc::clone(&stop));
    let folder = path.parent().map_or_else(PathBuf::new, PathBuf::from);
    Some(Effect::ComputeShip(Box::new(ShipAtSea {
        statics: Arc::clone(&ship.statics),
        folder,
        edited,
        stop,
    })))
}

/// Takes a dynamic analysis over, unless the text has changed since.
pub(super) fn computed(
    state: &mut AppState,
    by: &Arc<AtomicBool>,
    computed: Option<(Arc<DynamicAnalysis>, Box<ValidationTable>)>,
) -> Option<()> {
    let document = state.document.as_mut()?;
    let ship = ship(document)?;
    if !Arc::ptr_eq(ship.running.as_ref()?, by) {
        return None;
    }
    ship.running = None;
    ship.dynamic = None;
    if let Some((dynamic, checks)) = computed {
        ship.dynamic = Some(dynamic);
        ship.checks = *checks;
    }
    document.parts.outdate();
    Some(())
}
