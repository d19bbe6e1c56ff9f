//! Rigid rods as the bodies that they are: slender, with a point at each end.

use super::model::{BodyInputs, MemberInputs, PointInputs, PointKind, RodInputs, SystemFile};
use crate::numerics::V3;

/// Names of the points at the ends of a rod.
#[must_use]
pub fn ends(rod: &str) -> [String; 2] {
    [format!("{rod}-a"), format!("{rod}-b")]
}

/// The file with each rod written out as a body and the points at its ends.
#[must_use]
pub fn written_out(file: &SystemFile) -> SystemFile {
    let mut whole = file.clone();
    for (name, rod) in &file.rods {
        let half = 0.5 * length(rod);
        whole.bodies.insert(name.clone(), body(rod));
        for (end, x) in ends(name).into_iter().zip([-half, half]) {
            whole.points.insert(end, point(name, x));
        }
    }
    whole
}

fn length(rod: &RodInputs) -> f64 {
    (V3::from(rod.end_b_m) - V3::from(rod.end_a_m)).norm()
}

fn point(rod: &str, x: f64) -> PointInputs {
    PointInputs {
        position_m: Some([x, 0.0, 0.0]),
        body: Some(rod.to_owned()),
        ..PointInputs::of(PointKind::Body)
    }
}

/// The body of a rod: its x axis from end A to end B, its origin in the middle; mass evenly along it.
fn body(rod: &RodInputs) -> BodyInputs {
    let (a, b) = (V3::from(rod.end_a_m), V3::from(rod.end_b_m));
    let long = length(rod);
    let axis = (b - a) / long;
    let radius2 = 0.25 * rod.diameter_m * rod.diameter_m;
    let across = rod.mass_kg * (3.0 * radius2 + long * long) / 12.0;
    BodyInputs {
        kind: rod.kind,
        position_m: a.lerp(&b, 0.5).into(),
        pitch_deg: -axis.z.clamp(-1.0, 1.0).asin().to_degrees(),
        yaw_deg: axis.y.atan2(axis.x).to_degrees(),
        mass_kg: Some(rod.mass_kg),
        inertia_kg_m2: vec![0.5 * rod.mass_kg * radius2, across, across],
        load_n: rod.load_n,
        members: vec![MemberInputs {
            from_m: [-0.5 * long, 0.0, 0.0],
            to_m: [0.5 * long, 0.0, 0.0],
            diameter_m: rod.diameter_m,
            to_diameter_m: None,
            drag_normal: rod.drag_normal,
            added_mass_normal: rod.added_mass_normal,
            drag_only: false,
            repeat_at_deg: Vec::new(),
        }],
        ..BodyInputs::default()
    }
}
