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
        roll_deg: 0.0,
        pitch_deg: -axis.z.clamp(-1.0, 1.0).asin().to_degrees(),
        yaw_deg: axis.y.atan2(axis.x).to_degrees(),
        mass_kg: Some(rod.mass_kg),
        centre_of_gravity_m: [0.0; 3],
        inertia_kg_m2: vec![0.5 * rod.mass_kg * radius2, across, across],
        volume_m3: 0.0,
        centre_of_buoyancy_m: [0.0; 3],
        waterplane_stiffness: Vec::new(),
        added_mass: Vec::new(),
        damping: Vec::new(),
        quadratic_damping: Vec::new(),
        load_n: rod.load_n,
        moment_n_m: [0.0; 3],
        bottom_m: None,
        bed_friction: 0.0,
        drag_area_m2: [0.0; 3],
        amplitude_m: [0.0; 3],
        amplitude_deg: [0.0; 3],
        period_s: Vec::new(),
        phase_deg: Vec::new(),
        table_time_s: Vec::new(),
        table_x_m: Vec::new(),
        table_y_m: Vec::new(),
        table_z_m: Vec::new(),
        table_roll_deg: Vec::new(),
        table_pitch_deg: Vec::new(),
        table_yaw_deg: Vec::new(),
        ramp_s: 0.0,
        response_file: None,
        start_offset_m: [0.0; 3],
        start_offset_deg: [0.0; 3],
        drift_towards_deg: 0.0,
        radiation_file: None,
        excitation_file: None,
        drift_file: None,
        wamit_length_m: 1.0,
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
        wind_loads: Vec::new(),
        current_loads: Vec::new(),
        drift_loads: Vec::new(),
    }
}
