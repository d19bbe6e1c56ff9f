//! Checks of where a run in time begins: of what is free, and by its name.

use super::model::{BodyKeys, BodyKind, LineKeys, PointKind, RodKeys, StartPlacement, SystemKeys};
use crate::case::schema::Key;
use crate::case::{Finding, StartShape, nearest, of_line_start};

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

/// How a line begins; one that may break, is paid out or has copies begins at rest.
pub(super) fn of_line(keys: &SystemKeys<'_>, line: &LineKeys<'_>) -> Vec<Finding> {
    let Some(start) = &line.start else {
        return Vec::new();
    };
    let leads = start.shape.is(&StartShape::Straight) && waits(keys, line);
    let mut found = of_line_start(start, length(line), leads);
    let names = |key: &Key<'_, String>| line.name.get().is_some_and(|name| key.is(name));
    let of_break = line.break_at_m.is_given().then_some("may break");
    let mut payouts = keys.payouts.iter();
    let is_paid = payouts.any(|(_, payout)| names(&payout.line));
    let of_payout = is_paid.then_some("is paid out or hauled in");
    let of_copies = line.repeat_at_deg.is_given().then_some("has copies");
    for what in [of_break, of_payout, of_copies].into_iter().flatten() {
        let problem = format!("a line that {what} begins at rest");
        found.push(start.place.finding(problem, "leave its start out"));
    }
    found
}

/// Whether an end of a line is free, or on a free body, without a position.
fn waits(keys: &SystemKeys<'_>, line: &LineKeys<'_>) -> bool {
    let waits = |end: &Key<'_, String>| {
        let mut points = keys.points.iter();
        let point = points.find(|(name, _)| end.is(name));
        point.is_some_and(|(_, point)| match point.kind.value() {
            Some(PointKind::Free) => !point.position_m.is_given(),
            Some(PointKind::Body) => {
                let mut bodies = keys.bodies.iter();
                let body = bodies.find(|(name, _)| point.body.is(name));
                body.is_some_and(|(_, body)| {
                    body.kind.is(&BodyKind::Free) && !body.position_m.is_given()
                })
            }
            _ => false,
        })
    };
    waits(&line.from) || waits(&line.to)
}

/// Unstretched length of a line \[m\], where that of every section is known.
fn length(line: &LineKeys<'_>) -> Option<f64> {
    match line.sections.is_empty() {
        true => line.length_m.value(),
        false => line
            .sections
            .iter()
            .map(|(_, part)| part.length_m.value())
            .sum(),
    }
}
