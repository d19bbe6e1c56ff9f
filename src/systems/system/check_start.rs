//! Checks of where a run in time begins: of what is free, and by its name.

use super::model::{BodyKeys, BodyKind, PointKind, RodKeys, StartPlacement, SystemKeys};
use crate::case::schema::Key;
use crate::case::{Finding, nearest};

/// Keys of the start of a part.
pub(super) type StartKeys<'k, 'n> = [&'k Key<'n, [f64; 3]>; 4];

/// Those of a body.
pub(super) fn of_body<'k, 'n>(body: &'k BodyKeys<'n>) -> StartKeys<'k, 'n> {
    [
        &body.start_offset_m,
        &body.start_offset_deg,
        &body.start_velocity_m_per_s,
        &body.start_angular_velocity_deg_per_s,
    ]
}

/// Those of a rod.
pub(super) fn of_rod<'k, 'n>(rod: &'k RodKeys<'n>) -> StartKeys<'k, 'n> {
    [
        &rod.start_offset_m,
        &rod.start_turn_deg,
        &rod.start_velocity_m_per_s,
        &rod.start_angular_velocity_deg_per_s,
    ]
}

/// Keys of the start of a body or rod that is held or moved.
pub(super) fn not_free(kind: &Key<'_, BodyKind>, keys: &StartKeys<'_, '_>) -> Vec<Finding> {
    if !kind.is(&BodyKind::Held) && !kind.is(&BodyKind::Moved) {
        return Vec::new();
    }
    let problem = "has no effect: the body begins where it is held or moved";
    let remedy = "remove it, or make the body free or pinned";
    let found = keys.iter().map(|key| key.if_given(problem, remedy));
    found.flatten().collect()
}

/// Parts that `[start]` places: free or pinned ones of the file.
pub(super) fn parts(keys: &SystemKeys<'_>) -> Option<Finding> {
    let start = keys.start.as_ref()?;
    let names = start.parts.given()?;
    if !start.placement.is(&StartPlacement::Given) {
        let problem = "has no effect: everything begins at rest";
        return Some(start.parts.finding(problem, "add `placement = \"given\"`"));
    }
    let known = unknowns(keys);
    let wrong = names
        .iter()
        .position(|name| !known.contains(&name.as_str()));
    wrong.map(|at| {
        let name = &names[at];
        let problem = format!("there is no free point, free or pinned body or rod `{name}`");
        let remedy = match nearest(name, known.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("those of the file are {}", known.join(", ")),
        };
        start.parts.finding_at_item(at, problem, remedy)
    })
}

/// Names of what is free or pinned.
fn unknowns<'a>(keys: &'a SystemKeys<'_>) -> Vec<&'a str> {
    let turns = |kind: &Key<'_, BodyKind>| kind.is(&BodyKind::Free) || kind.is(&BodyKind::Pinned);
    let bodies = keys.bodies.iter().filter(|(_, body)| turns(&body.kind));
    let rods = keys.rods.iter().filter(|(_, rod)| turns(&rod.kind));
    let points = keys.points.iter();
    let points = points.filter(|(_, point)| point.kind.is(&PointKind::Free));
    let bodies = bodies.map(|(name, _)| name.as_str());
    let rods = rods.map(|(name, _)| name.as_str());
    let points = points.map(|(name, _)| name.as_str());
    bodies.chain(rods).chain(points).collect()
}
