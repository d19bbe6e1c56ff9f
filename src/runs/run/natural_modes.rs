//! Natural modes among the single numbers of a run, where its case asks for them.

use super::{ModePlane, Quantity, QuantityId, Subject};
use crate::case::Case;
use crate::modes::{Mode, ModeKind, ModePencil, ModesError, lowest, modes_of};
use crate::scene::Scene;
use crate::statics::equilibrium::EquilibriumSearch;

/// Modes found beyond those wanted, so that both planes have as many as are named.
const BEYOND: usize = 4;

/// Frequencies of the modes in and out of the plane of the line, and which one lies nearest to the frequency given;
/// nothing unless the case asks for it. Values only, without errors.
///
/// # Errors
/// Why there are none, in words.
pub(super) fn frequencies(case: &Case, scene: &Scene) -> Result<Vec<Quantity>, String> {
    let Some(wanted) = &case.modes else {
        return Ok(Vec::new());
    };
    if scene.elements.rigid_payload.is_some() {
        return Err(ModesError::RigidPayload.to_string());
    }
    let mut rest = scene.initial_state();
    let search = EquilibriumSearch::default().run(scene, 0.0, &mut rest);
    search.map_err(|error| error.to_string())?;
    let mut pencil = ModePencil::new(scene, &rest);
    let pairs =
        lowest(&mut pencil, 2 * wanted.count + BEYOND).map_err(|error| error.to_string())?;
    let modes = modes_of(&pencil, &rest.x, pairs);
    let mut list = Vec::new();
    for (kind, plane) in [
        (ModeKind::InPlane, ModePlane::InPlane),
        (ModeKind::OutOfPlane, ModePlane::OutOfPlane),
    ] {
        let found = modes.iter().filter(|mode| mode.kind == kind);
        let frequencies: Vec<f64> = found.map(Mode::frequency_hz).collect();
        let named = frequencies.iter().take(wanted.count).enumerate();
        list.extend(named.map(|(i, hz)| quantity(Subject::ModeFrequency(plane, i + 1), *hz)));
        if let Some(near) = wanted.near_hz
            && let Some(number) = nearest(&frequencies, near)
        {
            list.push(quantity(Subject::NearestMode(plane), number as f64));
        }
    }
    Ok(list)
}

fn quantity(of: Subject, value: f64) -> Quantity {
    Quantity::new(QuantityId::single(of), value)
}

/// The number, from 1, of the frequency nearest to this one; nothing where the list ends below it.
fn nearest(frequencies: &[f64], near: f64) -> Option<usize> {
    if frequencies.last().is_none_or(|last| *last < near) {
        return None;
    }
    let off = |f: &f64| (f - near).abs();
    let all = frequencies.iter().enumerate();
    let best = all.min_by(|a, b| off(a.1).total_cmp(&off(b.1)));
    best.map(|(i, _)| i + 1)
}
