//! A payload that turns about the end of the line, as a free body of a system: its origin is its centre of gravity, its z axis points to the
//! point that it hangs from.

use super::bearing;
use super::copied::{bare, value_of};
use super::payload::{hydrodynamics, write_volume};
use super::places::{bottom_point, hang_point};
use super::source::{DENSITY, LineSource};
use super::start;
use crate::case::{Payload, Rotation};
use crate::import::fault::Fault;
use crate::import::to_case::case_text::{CaseText, numbers, text};
use crate::numerics::V3;
use crate::scene::{Hydrodynamics, payload_bed_area};

/// What of it a body cannot state.
pub(super) fn faults(source: &LineSource<'_>, rotation: &Rotation) -> Vec<Fault> {
    let mut found = Vec::new();
    let table = source.node(&["payload", "rotation"]);
    let entries = table.map_or(&[][..], |node| node.entries());
    for entry in entries {
        found.extend(source.fault_of_expression(&["payload", "rotation", &entry.key]));
    }
    let given = ["drag_area_m2", "added_mass_kg", "bottom_m"];
    found.extend(
        given
            .iter()
            .filter_map(|key| source.fault_of_expression(&["payload", key])),
    );
    if source
        .case
        .payload
        .as_ref()
        .is_some_and(|payload| payload.added_mass_kg.is_none())
    {
        found.extend(source.fault_of_expression(&DENSITY));
    }
    let leans = !start::is_in_shape(source) && source.case.current.is_some();
    if rotation.spin_deg_per_s != 0.0 && leans {
        let problem = "is about an axis that leans in the current, and a system states it about the axes of the earth";
        let path = ["payload", "rotation", "spin_deg_per_s"];
        found.push(source.fault(&path, problem, "begin in a shape, or leave the current out"));
    }
    found
}

/// Writes the body, whose hang point is there \[m\], and the points on it.
pub(super) fn write(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    (payload, rotation): (&Payload, &Rotation),
    hang: [f64; 3],
) {
    let name = &source.case.ends.b.name;
    let header = format!("[points.{}]", bare(&hang_point(source)));
    system.table(&header, source.span(&["ends", "b"]));
    system.line("kind = \"body\"", source.span(&["ends", "b", "kind"]));
    system.line(&format!("body = {}", text(name)), None);
    let eye = [0.0, 0.0, rotation.centre_of_gravity_m];
    derived(system, source, "position_m", &eye, "centre_of_gravity_m");
    let header = format!("[bodies.{}]", bare(name));
    system.table(&header, source.span(&["payload"]));
    system.line("kind = \"free\"", source.span(&["ends", "b", "kind"]));
    pose(system, source, rotation, hang);
    if let Some(node) = source.node(&["payload", "dry_mass_kg"]) {
        let mass = value_of(source, node);
        system.given("mass_kg", &mass, &node.span, "");
    }
    let across = rotation.inertia_kg_m2;
    let along = rotation.spin_inertia_kg_m2.unwrap_or(across);
    let inertia = [across, across, along];
    derived(system, source, "inertia_kg_m2", &inertia, "inertia_kg_m2");
    write_volume(system, source, payload);
    in_water(system, source, (payload, rotation));
    bottom(system, source, (payload, rotation));
}

/// Writes a list that follows from a key of the rotation.
fn derived(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    key: &str,
    value: &[f64],
    from: &str,
) {
    let own = source.span(&["payload", "rotation", from]);
    let span = own.or_else(|| source.span(&["payload", "rotation"]));
    system.given(key, &numbers(value), span.unwrap_or(&(0..0)), from);
}

/// Writes what the water does to it: centres, added mass and drag.
fn in_water(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    (payload, rotation): (&Payload, &Rotation),
) {
    let centre = rotation.centre_of_gravity_m;
    let place = |below: f64| [0.0, 0.0, centre - below];
    let buoyancy_at = rotation.centre_of_buoyancy_m.unwrap_or(centre);
    let drag_at = rotation.centre_of_drag_m.unwrap_or(buoyancy_at);
    let Hydrodynamics {
        drag_area,
        added_mass,
    } = hydrodynamics(source, payload);
    let turning = rotation.added_inertia_kg_m2;
    let [x, y, z] = added_mass.into();
    let mass = [x, y, z, turning, turning, 0.0];
    let mut list = |key: &str, value: &[f64], from: &str| {
        derived(system, source, key, value, from);
    };
    let of_buoyancy = place(buoyancy_at);
    list("centre_of_buoyancy_m", &of_buoyancy, "centre_of_buoyancy_m");
    list("added_mass", &mass, "added_inertia_kg_m2");
    list(
        "centre_of_added_mass_m",
        &of_buoyancy,
        "centre_of_buoyancy_m",
    );
    list("drag_area_m2", drag_area.as_slice(), "drag_area_m2");
    if drag_area != V3::zeros() {
        list("centre_of_drag_m", &place(drag_at), "centre_of_drag_m");
    }
    let path = ["payload", "rotation", "drag_length_m"];
    if let Some(node) = source.node(&path).filter(|_| drag_area != V3::zeros()) {
        system.given("drag_length_m", &value_of(source, node), &node.span, "");
    }
}

/// Writes the point of it that bears on the bed, where there is one.
fn bottom(
    system: &mut CaseText<'_>,
    source: &LineSource<'_>,
    (payload, rotation): (&Payload, &Rotation),
) {
    let area = payload_bed_area(payload, &source.case.environment);
    if source.case.seabed.is_none() || area <= 0.0 {
        return;
    }
    system.table(
        &format!("[points.{}]", bare(&bottom_point(source))),
        source.span(&["payload"]),
    );
    system.line("kind = \"body\"", None);
    system.line(&format!("body = {}", text(&source.case.ends.b.name)), None);
    let below = payload
        .bottom_m
        .map_or(0.0, |bottom| rotation.centre_of_gravity_m - bottom);
    let span = source.span(&["payload", "bottom_m"]);
    let place = numbers(&[0.0, 0.0, below]);
    match span {
        Some(span) => system.given("position_m", &place, span, ""),
        None => system.assumed("position_m", &place, "its centre of gravity"),
    }
    bearing::write(system, source, &["payload"], area);
}

/// Where it begins, and how it moves there.
fn pose(system: &mut CaseText<'_>, source: &LineSource<'_>, rotation: &Rotation, hang: [f64; 3]) {
    let begins = start::is_in_shape(source);
    let tilt = if begins { rotation.start_tilt_deg } else { 0.0 };
    let azimuth = if begins {
        rotation.start_azimuth_deg
    } else {
        0.0
    };
    let (sin, cos) = tilt.to_radians().sin_cos();
    let (across, along) = azimuth.to_radians().sin_cos();
    let axis = [sin * along, sin * across, -cos];
    let place: Vec<f64> = (0..3)
        .map(|k| hang[k] + rotation.centre_of_gravity_m * axis[k])
        .collect();
    let why = if begins {
        "where it begins"
    } else {
        "its search begins here"
    };
    if !start::follows_from_length(source) {
        system.assumed("position_m", &numbers(&place), why);
    }
    let span = source.span(&["payload", "rotation", "start_tilt_deg"]);
    if tilt != 0.0 {
        let (roll, pitch) = upright(tilt);
        for (key, value) in [
            ("roll_deg", roll),
            ("pitch_deg", pitch),
            ("yaw_deg", azimuth),
        ] {
            if value != 0.0 {
                system.line(&format!("{key} = {value:?}"), span);
            }
        }
    }
    if start::is_moving(source)
        && let Some(node) = source.node(&["start", "velocity_m_per_s"])
    {
        system.given(
            "start_velocity_m_per_s",
            &value_of(source, node),
            &node.span,
            "",
        );
    }
    if rotation.spin_deg_per_s != 0.0 {
        let spin = axis.map(|part| part * rotation.spin_deg_per_s);
        let span = source.span(&["payload", "rotation", "spin_deg_per_s"]);
        let why = "spin_deg_per_s";
        system.given(
            "start_angular_velocity_deg_per_s",
            &numbers(&spin),
            span.unwrap_or(&(0..0)),
            why,
        );
    }
}

/// Roll and pitch of a body, whose z axis is opposite to an axis tilted by this angle from straight down \[deg\].
fn upright(tilt: f64) -> (f64, f64) {
    match tilt {
        _ if tilt.abs() <= 90.0 => (0.0, -tilt),
        _ => (180.0, tilt.signum() * 180.0 - tilt),
    }
}
