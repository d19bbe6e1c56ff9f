//! Initial shape: positions at time zero, or the initial guess at the equilibrium.

use std::f64::consts::FRAC_PI_2;

use super::Scene;
use super::error::SceneError;
use super::initial_guess::{InitialGuess, between};
use super::vectors::direction;
use crate::case::{Case, EndKind, Payload, Start, StartShape};
use crate::numerics::V3;
use crate::numerics::interpolation::linear;

/// Positions of the nodes \[m\] and tensions of the segments \[N\]; where the line starts in equilibrium, a guess.
pub(super) fn start(case: &Case, scene: &Scene) -> Result<InitialGuess, SceneError> {
    let held = |kind| !matches!(kind, EndKind::Payload | EndKind::Free);
    let (a, b) = (&case.ends.a, &case.ends.b);
    let equilibrium = case.start.shape == StartShape::Equilibrium;
    let anchored_at = |position: Option<[f64; 3]>, key: &str| {
        position.map(V3::from).ok_or_else(|| SceneError::Missing {
            key: format!("ends.{key}.position_m"),
            why: "the line must start somewhere",
        })
    };
    let arc = &scene.line.arc;
    let straight = |nodes: Vec<V3>| InitialGuess {
        nodes,
        tension: vec![scene.line.force_scale; scene.line.segments.len()],
    };
    let direction = start_direction(case);
    let given = given(&case.start, arc);
    let mut guess = match (held(a.kind), held(b.kind)) {
        _ if given.is_some() => straight(given.unwrap_or_default()),
        (true, true) => {
            let from = anchored_at(a.position_m, "a")?;
            let to = anchored_at(b.position_m, "b")?;
            if equilibrium {
                scene.guess_between(from, to)
            } else {
                straight(between(from, to, arc))
            }
        }
        (true, false) if equilibrium => scene.guess_hanging(anchored_at(a.position_m, "a")?, false),
        (false, true) if equilibrium => scene.guess_hanging(anchored_at(b.position_m, "b")?, true),
        (false, true) => {
            let to = anchored_at(b.position_m, "b")?;
            let whole = arc[arc.len() - 1];
            let from_b = |s: &f64| to - direction * (whole - s);
            straight(arc.iter().map(from_b).collect())
        }
        (_, false) => {
            if equilibrium && !held(a.kind) {
                let key = "start.shape".into();
                let why = "a line that nothing holds has no equilibrium; start it straight";
                return Err(SceneError::Impossible { key, why });
            }
            let from = anchored_at(a.position_m, "a")?;
            straight(arc.iter().map(|s| from + direction * *s).collect())
        }
    };
    if let (false, Some(rigid_payload), Some(payload)) =
        (equilibrium, &scene.elements.rigid_payload, &case.payload)
    {
        // Upright, or tilted by the case, whatever the direction of the line.
        let axis = start_axis(payload);
        guess.nodes[rigid_payload.node + 1] =
            guess.nodes[rigid_payload.node] + axis * rigid_payload.body.reach;
    }
    Ok(guess)
}

/// Axis of a rigid payload at time zero.
fn start_axis(payload: &Payload) -> V3 {
    let Some(rotation) = &payload.rotation else {
        return -V3::z();
    };
    let azimuth = rotation.start_azimuth_deg.to_radians();
    direction(azimuth, rotation.start_tilt_deg.to_radians() - FRAC_PI_2)
}

/// The shape of a line between two places \[m\] that does not begin at rest, at these arc lengths: straight, or as given by coordinates.
#[must_use]
pub fn shape_between(start: &Start, (from, to): (V3, V3), arc: &[f64]) -> Option<Vec<V3>> {
    match start.shape {
        StartShape::Equilibrium => None,
        StartShape::Straight => Some(between(from, to, arc)),
        StartShape::Given => given(start, arc),
    }
}

/// The shape given by coordinates, interpolated at the arc lengths of the nodes.
fn given(start: &Start, arc: &[f64]) -> Option<Vec<V3>> {
    if start.shape == StartShape::Straight {
        return None;
    }
    let known = start.arc_m.as_ref()?;
    let (x, z) = (start.x_m.as_ref()?, start.z_m.as_ref()?);
    let at = |list: &[f64], s: f64| linear(known, list, s);
    let full = |list: &[f64]| list.len() == known.len();
    let enough = known.len() > 1 && full(x) && full(z) && start.y_m.as_deref().is_none_or(full);
    let y = |s: f64| start.y_m.as_ref().map_or(0.0, |y| at(y, s));
    enough.then(|| {
        arc.iter()
            .map(|&s| V3::new(at(x, s), y(s), at(z, s)))
            .collect()
    })
}

/// Unit vector of a straight start.
fn start_direction(case: &Case) -> V3 {
    direction(
        case.start.azimuth_deg.to_radians(),
        case.start.elevation_deg.to_radians(),
    )
}
