//! Where the nodes are at time zero, or a first guess at the equilibrium that the line starts from.

use super::Scene;
use super::build::SceneError;
use super::guess::{Guess, between};
use crate::case::{Case, EndKind, StartShape};
use crate::linalg::V3;

/// Positions of the nodes \[m\] and tensions of the segments \[N\]; where the line starts in equilibrium, a guess.
pub(super) fn start(case: &Case, scene: &Scene) -> Result<Guess, SceneError> {
    let held = |kind| !matches!(kind, EndKind::Payload | EndKind::Free);
    let (a, b) = (&case.ends.a, &case.ends.b);
    let equilibrium = case.start.shape == StartShape::Equilibrium;
    let anchored_at = |position: Option<[f64; 3]>, key: &str| {
        position.map(V3::from).ok_or_else(|| SceneError::Missing {
            key: format!("ends.{key}.position_m"),
            why: "the line must start somewhere",
        })
    };
    let arc = &scene.arc;
    let straight = |nodes: Vec<V3>| Guess {
        nodes,
        tension: vec![scene.force_scale; scene.segments.len()],
    };
    let direction = start_direction(case);
    Ok(match (held(a.kind), held(b.kind)) {
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
    })
}

/// Unit vector of a straight start.
fn start_direction(case: &Case) -> V3 {
    direction(
        case.start.azimuth_deg.to_radians(),
        case.start.elevation_deg.to_radians(),
    )
}

/// Unit vector of an azimuth from +x towards +y and an elevation \[rad\].
pub(super) fn direction(azimuth: f64, elevation: f64) -> V3 {
    V3::new(
        azimuth.cos() * elevation.cos(),
        azimuth.sin() * elevation.cos(),
        elevation.sin(),
    )
}
