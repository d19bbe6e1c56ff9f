//! Checks of the keys of a system against each other: names, ends, places, what holds what.

use super::ageing::check::ageing;
use super::build::{angles as angles_of, copy_name};
use super::check_bed::{bearing, bed, below_bed, suction};
use super::check_lines::ByName;
use super::check_matrix::matrix;
use super::check_start::{not_free, of_body, of_rod, parts};
use super::file::SYSTEM;
use super::model::{
    BodyKeys, BodyKind, MemberKeys, NO_LINE, PointKeys, PointKind, RodKeys, SystemKeys,
};
use super::motion::{check as motion, check_payout};
use super::{quantities, results_in_time, rods};
use crate::case::schema::{Key, TableNode};
use crate::case::{
    ChannelId, Finding, nearest, of_checks, of_current, of_load_cases, of_material,
    of_published_curves, of_studies, of_trials, unknown, used_twice,
};
use crate::published::{number as published_number, trend as published_trend};

/// Checks of a system.
pub(super) fn check(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let by_name = ByName::of_keys(keys);
    for (name, point) in &keys.points {
        found.extend(place_of(point));
        found.extend(wet_mass(keys, point));
        found.extend(bearing(keys, point));
        found.extend(body_of(keys, point, &by_name));
        found.extend(outside_water(keys, name, point, &by_name));
    }
    for (name, body) in &keys.bodies {
        found.extend(body_with_others(keys, name, body));
    }
    for (name, rod) in &keys.rods {
        found.extend(rod_of(keys, name, rod));
        found.extend(not_free(&rod.kind, &of_rod(rod)));
        found.extend(pinned_to(keys, name, &rod.kind, &rod.pinned_to));
    }
    found.extend(by_name.check_lines());
    found.extend(bodies_asked(keys));
    for (_, goal) in &keys.goals {
        found.extend(quantities::unknown(&goal.result, keys));
    }
    let names = keys.lines.iter().map(|(_, line)| &line.name);
    found.extend(used_twice(names, "give every line a name of its own"));
    for (_, material) in &keys.materials {
        found.extend(of_material(material));
    }
    found.extend(lost_line(keys));
    found.extend(parts(keys));
    found.extend(without_unknowns(keys));
    found.extend(keys.current.iter().flat_map(of_current));
    found.extend(bed(keys));
    found.extend(wind_without_loads(keys));
    found.extend(motion::waves(keys));
    found.extend(motion::motion(keys));
    found.extend(check_payout::payouts(keys));
    found.extend(ageing(keys));
    found.extend(of_load_cases(&SYSTEM, keys.place.node, &keys.load_cases));
    found.extend(of_checks(&keys.checks));
    let unknown = |key: &Key<'_, String>| results_in_time::unknown(key, keys);
    let named = rows_of_trials(keys);
    found.extend(published_number::check(
        &keys.published,
        unknown,
        &keys.study,
        &named,
    ));
    found.extend(published_trend::check(&keys.trend, unknown, &keys.study));
    let unknown = |key: &Key<'_, ChannelId>| results_in_time::unknown_channel(key, keys);
    found.extend(of_published_curves(
        &keys.published_curve,
        unknown,
        &keys.study,
    ));
    found.extend(of_studies(&SYSTEM, keys.place.node, &keys.study));
    found.extend(trials(keys));
    found
}

/// A body by itself, how it is held, and its coefficients of potential flow.
fn body_with_others(keys: &SystemKeys<'_>, name: &str, body: &BodyKeys<'_>) -> Vec<Finding> {
    let mut found = body_alone(body);
    found.extend(not_free(&body.kind, &of_body(body)));
    found.extend(pinned_to(keys, name, &body.kind, &body.pinned_to));
    if body.pinned_to.is_given() {
        let problem = "is not covered for a body that is pinned to another";
        let remedy = "leave it out, or pin the body to the earth";
        found.extend(body.amplitude_m.if_given(problem, remedy));
        found.extend(body.table_time_s.if_given(problem, remedy));
    }
    found.extend(motion::potential_flow(body));
    found
}

/// The bodies of offset curves and of watch circles.
fn bodies_asked(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let curves = keys.offset_curves.iter();
    let curves = curves.map(|(_, curve)| (&curve.body, &curve.place));
    let circles = keys.watch_circles.iter();
    let circles = circles.map(|(_, circle)| (&circle.body, &circle.place));
    let asked = curves.chain(circles);
    asked
        .flat_map(|(body, place)| body_asked(keys, body, place))
        .collect()
}

/// The published values that trials name.
fn rows_of_trials(keys: &SystemKeys<'_>) -> Vec<String> {
    let named = keys.trial.iter().filter_map(|(_, trial)| trial.rows.get());
    named.flatten().cloned().collect()
}

/// Trials, which name published numbers and curves.
fn trials(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let numbers = keys.published.iter().map(|(name, _)| name.as_str());
    let curves = keys.published_curve.iter().map(|(name, _)| name.as_str());
    let rows: Vec<&str> = numbers.chain(curves).collect();
    of_trials(&SYSTEM, keys.place.node, &rows, &keys.trial)
}

/// A body by itself: mass, matrices, members, loads by heading.
fn body_alone(body: &BodyKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let needs_mass = match body.kind.value() {
        Some(BodyKind::Free) => Some("a free body needs its mass: add `mass_kg`"),
        Some(BodyKind::Pinned) => Some("a pinned body needs its mass: add `mass_kg`"),
        _ => None,
    };
    found.extend(needs_mass.and_then(|remedy| body.mass_kg.if_missing(remedy)));
    if body.kind.is(&BodyKind::Pinned) {
        found.extend(pinned(body));
    }
    for of_six in [
        &body.waterplane_stiffness,
        &body.added_mass,
        &body.damping,
        &body.quadratic_damping,
    ] {
        let right = "6 numbers, a diagonal, or 36, row by row";
        found.extend(matrix(of_six, &[6, 36], right));
    }
    found.extend(matrix(
        &body.inertia_kg_m2,
        &[3, 6],
        "Ixx, Iyy, Izz, or these and Ixy, Ixz, Iyz",
    ));
    found.extend(
        body.members
            .iter()
            .filter_map(|(_, member)| without_length(member)),
    );
    for rows in [&body.wind_loads, &body.current_loads] {
        found.extend(headings(rows.iter().map(|(_, row)| &row.heading_deg)));
    }
    let drift = body.drift_loads.iter();
    found.extend(headings(drift.map(|(_, row)| &row.heading_deg)));
    if body.drift_loads.is_empty() {
        let problem = "has no effect: the body has no drift loads";
        let remedy = "add [[bodies.NAME.drift_loads]], or remove it";
        found.extend(body.drift_towards_deg.if_given(problem, remedy));
    }
    if !body.bottom_m.is_given() {
        let problem = "has no effect: nothing of the body bears on the bed";
        let remedy = "say how far below its origin it bears: `bottom_m`, or remove it";
        found.extend(body.bed_friction.if_given(problem, remedy));
    }
    found.extend(in_flow(body));
    if !body.kind.is(&BodyKind::Moved) || !body.response_file.is_given() {
        let problem = "has no effect: no responses move the body";
        let remedy = "make it a moved body with a `response_file`, or remove it";
        found.extend(body.response_at_m.if_given(problem, remedy));
    }
    found
}

/// A centre of added mass beside other loads of the flow, or keys of drag without a drag area.
fn in_flow(body: &BodyKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let centre = &body.centre_of_added_mass_m;
    let problem = "counts the flow twice: added mass is about a centre of its own where nothing else says how current and waves act on the body";
    let remedy = "leave it out, or the files, loads and members that say that";
    let by_files = [
        &body.radiation_file,
        &body.excitation_file,
        &body.response_file,
    ];
    let displaces = |member: &MemberKeys<'_>| member.drag_only.value() != Some(true);
    let by_members = body.members.iter().any(|(_, member)| displaces(member));
    if by_files.iter().any(|file| file.is_given()) || !body.current_loads.is_empty() || by_members {
        found.extend(centre.if_given(problem, remedy));
    }
    let drags = body
        .drag_area_m2
        .value()
        .is_some_and(|area| area != [0.0; 3]);
    if !drags {
        let problem = "has no effect: the body has no drag area";
        let remedy = "add `drag_area_m2 = [...]`, or remove it";
        found.extend(body.centre_of_drag_m.if_given(problem, remedy));
        found.extend(body.drag_length_m.if_given(problem, remedy));
    }
    found
}

/// Keys that a body which turns about its origin has no use for, or that are not covered for it.
fn pinned(body: &BodyKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let problem = "is not covered for a pinned body";
    let remedy = "leave it out, or make the body free";
    for file in [
        &body.radiation_file,
        &body.excitation_file,
        &body.drift_file,
        &body.response_file,
    ] {
        found.extend(file.if_given(problem, remedy));
    }
    found.extend(body.bottom_m.if_given(problem, remedy));
    let problem =
        "has no effect: the origin of a pinned body is where its position and its motion have it";
    found.extend(body.start_offset_m.if_given(problem, "remove it"));
    found.extend(body.start_velocity_m_per_s.if_given(problem, "remove it"));
    let problem = "has no effect: a pinned body is free to turn";
    let remedy = "remove it, or make the body moved";
    found.extend(body.amplitude_deg.if_given(problem, remedy));
    for column in [
        &body.table_roll_deg,
        &body.table_pitch_deg,
        &body.table_yaw_deg,
    ] {
        found.extend(column.if_given(problem, remedy));
    }
    found
}

/// What a body or rod is pinned to: another one, which is not pinned to a third.
fn pinned_to(
    keys: &SystemKeys<'_>,
    name: &str,
    kind: &Key<'_, BodyKind>,
    to: &Key<'_, String>,
) -> Option<Finding> {
    let known = to.get()?;
    if !kind.is(&BodyKind::Pinned) {
        let problem = "is given for a body that is not pinned";
        return Some(to.finding(problem, "set kind = \"pinned\", or remove it"));
    }
    if known == name {
        return Some(to.finding("is the body itself", "name another body, or remove it"));
    }
    let bodies = keys
        .bodies
        .iter()
        .map(|(name, body)| (name, &body.pinned_to));
    let rods = keys.rods.iter().map(|(name, rod)| (name, &rod.pinned_to));
    let third = bodies.chain(rods).find(|(other, _)| *other == known);
    if third.is_some_and(|(_, third)| third.is_given()) {
        let problem = "is pinned to a third body, which is not covered";
        return Some(to.finding(problem, "pin both to the same body"));
    }
    unknown(to, &body_names(keys), "body", "system")
}

/// A system in which nothing has an equilibrium to be found.
fn without_unknowns(keys: &SystemKeys<'_>) -> Option<Finding> {
    let is_held = |kind: &Key<'_, BodyKind>| kind.is(&BodyKind::Held);
    let bodies = keys.bodies.iter().map(|(_, body)| &body.kind);
    let rods = keys.rods.iter().map(|(_, rod)| &rod.kind);
    let all_held = bodies.chain(rods).all(is_held);
    let mut points = keys.points.iter();
    let no_point = !points.any(|(_, point)| point.kind.is(&PointKind::Free));
    (keys.lines.is_empty() && all_held && no_point).then(|| {
        keys.place.finding(
            "nothing in the system moves or comes to an equilibrium",
            "add [[lines]] with [points.<name>] and [materials.<name>], or a point, a body or rod that is free",
        )
    })
}

/// A rod without length, or one with the name of a body.
fn rod_of(keys: &SystemKeys<'_>, name: &str, rod: &RodKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    if let (Some(a), Some(b)) = (rod.end_a_m.value(), rod.end_b_m.value())
        && a == b
    {
        let problem = "the rod begins and ends there";
        found.push(rod.end_b_m.finding(problem, "give ends that lie apart"));
    }
    if keys.bodies.iter().any(|(known, _)| known == name) {
        let problem = format!("there is a body named \"{name}\" too");
        found.push(rod.place.finding(problem, "give the rod another name"));
    }
    if rod.kind.is(&BodyKind::Pinned) {
        let problem = "is not covered for a pinned rod";
        let remedy = "make it a body of one member, with `load_n` and `moment_n_m`";
        found.extend(rod.load_n.if_given(problem, remedy));
        let problem = "has no effect: end A of a pinned rod is where the file puts it";
        found.extend(rod.start_offset_m.if_given(problem, "remove it"));
        found.extend(rod.start_velocity_m_per_s.if_given(problem, "remove it"));
    }
    for end in rods::ends(name) {
        if keys.points.iter().any(|(known, _)| *known == end) {
            let problem = format!("its end is named \"{end}\", as a point is");
            found.push(
                rod.place
                    .finding(problem, "give the rod or the point another name"),
            );
        }
    }
    // Ends in the frame of another body are checked where that has them.
    for end in [&rod.end_a_m, &rod.end_b_m] {
        found.extend(below_bed(keys, end).filter(|_| !rod.pinned_to.is_given()));
    }
    found
}

/// A wind that no body states its loads by.
fn wind_without_loads(keys: &SystemKeys<'_>) -> Option<Finding> {
    let wind = keys.wind.as_ref()?;
    let felt = keys
        .bodies
        .iter()
        .any(|(_, body)| !body.wind_loads.is_empty());
    let remedy = "add [[bodies.NAME.wind_loads]], or leave [wind] out";
    (!felt).then(|| {
        wind.place
            .finding("acts on nothing: no body has wind loads", remedy)
    })
}

/// A member without length.
fn without_length(member: &MemberKeys<'_>) -> Option<Finding> {
    let (from, to) = (member.from_m.value()?, member.to_m.value()?);
    let remedy = "give ends that lie apart";
    (from == to).then(|| {
        member
            .to_m
            .finding("the member begins and ends there", remedy)
    })
}

/// Headings that do not increase, or go round more than once.
fn headings<'k, 'n: 'k>(rows: impl Iterator<Item = &'k Key<'n, f64>>) -> Option<Finding> {
    let rows: Vec<_> = rows.collect();
    let first = rows.first()?.value()?;
    let mut before = first;
    for row in &rows[1..] {
        let here = row.value()?;
        if here <= before || here >= first + 360.0 {
            let problem = format!("{here} does not follow {before}");
            let remedy = "give the headings in increasing order, each once around";
            return Some(row.finding(problem, remedy));
        }
        before = here;
    }
    None
}

/// A shape of a point.
fn shape(point: &PointKeys<'_>, problem: &str, remedy: &str) -> Option<Finding> {
    point.shape.as_ref()?;
    Some(point.place.finding_at("shape", problem, remedy))
}

/// Held points need a place; they have no mass.
fn place_of(point: &PointKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let kind = point.kind.value();
    match kind {
        Some(PointKind::Fixed | PointKind::Moved) => {
            found.extend(
                point
                    .position_m
                    .if_missing("add where the point is held: `position_m = [x, y, z]`"),
            );
        }
        Some(PointKind::Body) => {
            let remedy = "add its place in the body's frame: `position_m = [forward, to port, up]`";
            found.extend(point.position_m.if_missing(remedy));
            found.extend(
                point
                    .body
                    .if_missing("name the body that the point is on: `body = \"...\"`"),
            );
        }
        Some(PointKind::Free) | None => {}
    }
    let on_body = kind == Some(PointKind::Body);
    if on_body && !point.bed_area_m2.is_given() {
        let remedy = "add the area that bears: `bed_area_m2`, or remove it";
        found.extend(
            point
                .bed_friction
                .if_given("has no effect: the point does not bear on the bed", remedy),
        );
        for key in suction(point) {
            found.extend(key.if_given("has no effect: the point does not bear on the bed", remedy));
        }
    }
    if matches!(
        kind,
        Some(PointKind::Fixed | PointKind::Body | PointKind::Moved)
    ) {
        let problem = "has no effect on a point that is held";
        let remedy = "leave it out, or make the point free";
        found.extend(point.mass_kg.if_given(problem, remedy));
        found.extend(point.volume_m3.if_given(problem, remedy));
        found.extend(point.wet_mass_kg.if_given(problem, remedy));
        found.extend(point.load_n.if_given(problem, remedy));
        found.extend(point.added_mass_kg.if_given(problem, remedy));
        found.extend(point.drag_area_m2.if_given(problem, remedy));
        found.extend(shape(point, problem, remedy));
        if !on_body {
            found.extend(point.bed_friction.if_given(problem, remedy));
            found.extend(point.bed_area_m2.if_given(problem, remedy));
            for key in suction(point) {
                found.extend(key.if_given(problem, remedy));
            }
        }
        found.extend(point.bottom_m.if_given(problem, remedy));
        found.extend(point.start_offset_m.if_given(problem, remedy));
        found.extend(point.start_velocity_m_per_s.if_given(problem, remedy));
    }
    found
}

/// A wet mass beside a volume, or in water above the mass.
fn wet_mass(keys: &SystemKeys<'_>, point: &PointKeys<'_>) -> Option<Finding> {
    let wet = &point.wet_mass_kg;
    if point.volume_m3.is_given() {
        let problem = "says what the water bears, and so does `volume_m3`";
        return wet.if_given(problem, "keep one of them");
    }
    let density = keys
        .environment
        .as_ref()
        .and_then(|around| around.water_density_kg_per_m3.value());
    let is_heavier = wet.value()? > point.mass_kg.value().unwrap_or(0.0);
    (is_heavier && density != Some(0.0)).then(|| {
        let problem = "is more than the mass, and a point displaces no less than nothing";
        wet.finding(problem, "give `mass_kg` or less")
    })
}

/// The body of an analysis: known, or the only one.
fn body_asked(
    keys: &SystemKeys<'_>,
    body: &Key<'_, String>,
    place: &TableNode<'_>,
) -> Option<Finding> {
    let names = body_names(keys);
    if body.is_given() {
        return unknown(body, &names, "body", "system");
    }
    let problem = match names.len() {
        1 => return None,
        0 => "the system has no body to move".to_owned(),
        many => format!("the system has {many} bodies"),
    };
    Some(place.finding(problem, "name the body: `body = \"...\"`"))
}

/// Names of bodies and rods.
fn body_names<'a>(keys: &'a SystemKeys<'_>) -> Vec<&'a str> {
    let bodies = keys.bodies.iter().map(|(name, _)| name.as_str());
    let rods = keys.rods.iter().map(|(name, _)| name.as_str());
    bodies.chain(rods).collect()
}

fn body_of(
    keys: &SystemKeys<'_>,
    point: &PointKeys<'_>,
    by_name: &ByName<'_, '_>,
) -> Option<Finding> {
    if point.body.is_given() && !point.kind.is(&PointKind::Body) {
        let remedy = "make the point of kind \"body\", or leave the body out";
        return Some(
            point
                .body
                .finding("is given for a point that is not on a body", remedy),
        );
    }
    let name = point.body.get()?;
    if by_name.is_body(name) {
        return None;
    }
    unknown(&point.body, &body_names(keys), "body", "system")
}

/// Points above the water or below the bed.
fn outside_water(
    keys: &SystemKeys<'_>,
    name: &str,
    point: &PointKeys<'_>,
    by_name: &ByName<'_, '_>,
) -> Option<Finding> {
    if point.kind.is(&PointKind::Body) {
        return None;
    }
    let [_, _, z] = point.position_m.value()?;
    if let Some(below) = below_bed(keys, &point.position_m) {
        return Some(below);
    }
    let water = keys
        .environment
        .as_ref()
        .and_then(|e| e.water_density_kg_per_m3.value());
    // Whoever says what becomes of lines above the water knows of it.
    let surface = keys.environment.as_ref().map(|e| &e.water_surface);
    let is_said = surface.is_some_and(Key::is_given);
    if z > 0.0 && water.unwrap_or(1025.0) > 0.0 && !is_said && !by_name.bears_no_weight(name) {
        let problem = format!("lies {z} m above the water, where lines have another weight");
        let remedy = "set environment.water_surface = \"crossed\", which gives them their weight in air there, or \"ignored\" where all counts as under water, give a z of 0 or less, or, for lines in air, set environment.water_density_kg_per_m3 = 0";
        return Some(point.position_m.finding(problem, remedy));
    }
    None
}

/// A line that is lost is one of the system, and nothing else needs it.
fn lost_line(keys: &SystemKeys<'_>) -> Option<Finding> {
    let key = &keys.damage.as_ref()?.lost_line;
    let lost = key.given().filter(|name| *name != NO_LINE)?;
    let copies = keys.lines.iter().flat_map(|(_, line)| {
        let angles = line.repeat_at_deg.value().unwrap_or_default();
        let name = line.name.value().unwrap_or_default();
        let copies = angles_of(&angles).iter();
        copies
            .map(|angle| copy_name(&name, *angle))
            .collect::<Vec<_>>()
    });
    let known: Vec<String> = copies.collect();
    if !known.contains(lost) {
        let problem = format!("there is no line `{lost}` in this system");
        let remedy = match nearest(lost, known.iter().map(String::as_str)) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!(
                "its lines are {}; `{NO_LINE}` leaves it intact",
                known.join(", ")
            ),
        };
        return Some(key.finding(problem, remedy));
    }
    let paid = keys.payouts.iter().map(|(_, payout)| &payout.line);
    let slid = keys.sliding_points.iter();
    let slid = slid.flat_map(|(_, sliding)| [&sliding.line, &sliding.other]);
    let needed = paid.chain(slid).any(|line| line.get() == Some(lost));
    needed.then(|| {
        let problem = format!("line `{lost}` is paid out, or a point slides along it");
        key.finding(problem, "leave that out, or let another line be lost")
    })
}
