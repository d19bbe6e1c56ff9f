//! Natural modes among the single numbers of a run, where its case asks for them.

use super::{ModePlane, Quantity, QuantityId, Subject};
use crate::case::{Case, Modes};
use crate::modes::{Mode, ModeKind, of_scene_at_rest};
use crate::scene::Scene;

/// Modes found beyond those wanted, so that both planes have as many as are named.
const BEYOND: usize = 4;

/// How many modes to look for, so that both planes have as many as a file asks for.
#[must_use]
pub const fn wanted(asked: &Modes) -> usize {
    2 * asked.count + BEYOND
}

/// Frequencies of modes in and out of the plane of the line, and which one lies nearest to the frequency given, as a file asks for them. Values
/// only, without errors.
#[must_use]
pub fn numbers(asked: &Modes, modes: &[Mode]) -> Vec<Quantity> {
    let mut list = Vec::new();
    for (kind, plane) in [
        (ModeKind::InPlane, ModePlane::InPlane),
        (ModeKind::OutOfPlane, ModePlane::OutOfPlane),
    ] {
        let found = modes.iter().filter(|mode| mode.kind == kind);
        let frequencies: Vec<f64> = found.map(Mode::frequency_hz).collect();
        let named = frequencies.iter().take(asked.count).enumerate();
        list.extend(named.map(|(i, hz)| quantity(Subject::ModeFrequency(plane, i + 1), *hz)));
        if let Some(near) = asked.near_hz
            && let Some(number) = nearest(&frequencies, near)
        {
            list.push(quantity(Subject::NearestMode(plane), number as f64));
        }
    }
    list
}

/// The same of the line of a case; nothing unless it asks for them.
///
/// # Errors
/// Why there are none, in words.
pub(super) fn frequencies(case: &Case, scene: &Scene) -> Result<Vec<Quantity>, String> {
    let Some(asked) = &case.modes else {
        return Ok(Vec::new());
    };
    let found = of_scene_at_rest(scene, wanted(asked));
    let (_, modes) = found.map_err(|error| error.to_string())?;
    Ok(numbers(asked, &modes))
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
