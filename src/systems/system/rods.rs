//! Rigid rods as the bodies that they are: slender, with a point at each end.

use super::model::{
    BodyInputs, BodyKind, MemberInputs, PointInputs, PointKind, RodInputs, SystemFile,
};
use super::straight_ends;
use crate::numerics::V3;

/// Names of the points at the ends of a rod.
#[must_use]
pub fn ends(rod: &str) -> [String; 2] {
    [format!("{rod}-a"), format!("{rod}-b")]
}

/// The file with each rod written out as a body and the points at its ends, and the ends of lines that begin straight where they are.
#[must_use]
pub fn written_out(file: &SystemFile) -> SystemFile {
    let mut whole = file.clone();
    straight_ends::put(&mut whole);
    for (name, rod) in &file.rods {
        whole.bodies.insert(name.clone(), body(rod));
        for (end, x) in ends(name).into_iter().zip(reach(rod)) {
            whole.points.insert(end, point(name, x));
        }
    }
    whole
}

fn length(rod: &RodInputs) -> f64 {
    (V3::from(rod.end_b_m) - V3::from(rod.end_a_m)).norm()
}

/// Where its ends are along its axis \[m\]: its origin is in the middle, or where it is pinned.
fn reach(rod: &RodInputs) -> [f64; 2] {
    let long = length(rod);
    match rod.kind {
        BodyKind::Pinned => [0.0, long],
        BodyKind::Held | BodyKind::Free | BodyKind::Moved => [-0.5 * long, 0.5 * long],
    }
}

fn point(rod: &str, x: f64) -> PointInputs {
    PointInputs {
        position_m: Some([x, 0.0, 0.0]),
        body: Some(rod.to_owned()),
        ..PointInputs::of(PointKind::Body)
    }
}

/// The body of a rod: its x axis from end A to end B; mass evenly along it.
fn body(rod: &RodInputs) -> BodyInputs {
    let (a, b) = (V3::from(rod.end_a_m), V3::from(rod.end_b_m));
    let long = length(rod);
    let axis = (b - a) / long;
    let radius2 = 0.25 * rod.diameter_m * rod.diameter_m;
    let across = rod.mass_kg * (3.0 * radius2 + long * long) / 12.0;
    let [from, to] = reach(rod);
    let centre = 0.5 * (from + to);
    BodyInputs {
        kind: rod.kind,
        pinned_to: rod.pinned_to.clone(),
        position_m: Some(a.lerp(&b, -from / long).into()),
        pitch_deg: -axis.z.clamp(-1.0, 1.0).asin().to_degrees(),
        yaw_deg: axis.y.atan2(axis.x).to_degrees(),
        mass_kg: Some(rod.mass_kg),
        centre_of_gravity_m: [centre, 0.0, 0.0],
        inertia_kg_m2: vec![0.5 * rod.mass_kg * radius2, across, across],
        load_n: rod.load_n,
        start_offset_m: rod.start_offset_m,
        start_velocity_m_per_s: rod.start_velocity_m_per_s,
        start_angular_velocity_deg_per_s: rod.start_angular_velocity_deg_per_s,
        members: vec![MemberInputs {
            from_m: [from, 0.0, 0.0],
            to_m: [to, 0.0, 0.0],
            diameter_m: rod.diameter_m,
            to_diameter_m: None,
            drag_normal: rod.drag_normal,
            added_mass_normal: rod.added_mass_normal,
            drag_end: rod.drag_end,
            to_drag_end: None,
            added_mass_end: rod.added_mass_end,
            to_added_mass_end: None,
            drag_only: false,
            repeat_at_deg: Vec::new(),
        }],
        ..BodyInputs::default()
    }
}
