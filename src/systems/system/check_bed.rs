//! Checks of the bed of a system: keys of its shape without effect, places below a level bed.

use super::model::{LineKeys, PointKeys, SystemKeys};
use crate::case::schema::Key;
use crate::case::{BedShapeKeys, Finding, FrictionKeys, SeabedKeys};

/// Keys of a bed without a grid of depths that have no effect.
pub(super) fn bed(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let Some(bed) = &keys.seabed else {
        return Vec::new();
    };
    let mut found = friction(keys, bed);
    let shape = BedShapeKeys {
        depth_at: &bed.depth_at_m,
        slope: &bed.slope_deg,
        azimuth: &bed.slope_azimuth_deg,
        depth_file: &bed.depth_file,
        interpolation: &bed.interpolation,
    };
    found.extend(shape.without_effect());
    found
}

/// Keys of the bed's friction that have no effect where neither it nor a line has any.
fn friction(keys: &SystemKeys<'_>, bed: &SeabedKeys<'_>) -> Vec<Finding> {
    let mut lines = keys.lines.iter();
    let is_rough = bed.friction.is_given() || lines.any(|(_, line)| line.friction.is_given());
    let across = keys.lines.iter().map(|(_, line)| &line.friction_lateral);
    let mut of_grip = vec![&bed.friction_lateral, &bed.grip_stiffness_n_per_m3];
    if is_rough {
        of_grip.extend(across);
    }
    let keys = FrictionKeys {
        law: &bed.friction_law,
        of_grip,
        slip_speed: &bed.slip_speed_m_per_s,
    };
    keys.without_effect(is_rough)
}

/// Friction across a line that has none along itself.
pub(super) fn friction_of_line(keys: &SystemKeys<'_>, line: &LineKeys<'_>) -> Option<Finding> {
    let bed = keys.seabed.as_ref();
    if line.friction.is_given() || bed.is_some_and(|bed| bed.friction.is_given()) {
        return None;
    }
    let problem = "has no effect: neither the line nor the bed has friction";
    let remedy = "add `friction = ...`, the coefficient along the line, or remove this key";
    line.friction_lateral.if_given(problem, remedy)
}

/// How a point bears on a bed that is not there.
pub(super) fn bearing(keys: &SystemKeys<'_>, point: &PointKeys<'_>) -> Vec<Finding> {
    if keys.seabed.is_some() {
        return Vec::new();
    }
    let problem = "has no effect: there is no bed";
    let remedy = "add a table `[seabed]`, or remove this key";
    let area = point.bed_area_m2.if_given(problem, remedy);
    let bottom = point.bottom_m.if_given(problem, remedy);
    let suction = suction(point).map(|key| key.if_given(problem, remedy));
    let found = [area, bottom].into_iter().chain(suction);
    found.flatten().collect()
}

/// Keys of suction under a point.
pub(super) fn suction<'k, 'n>(point: &'k PointKeys<'n>) -> [&'k Key<'n, f64>; 2] {
    [&point.breakout_n, &point.breakout_distance_m]
}

/// How far below the bed a place may be, as the end of a line that has sunk into a bed that yields \[m\].
const SUNK: f64 = 1e-3;

/// A place below a level bed; over a grid that is found with the depths.
pub(super) fn below_bed(keys: &SystemKeys<'_>, place: &Key<'_, [f64; 3]>) -> Option<Finding> {
    let bed = keys.seabed.as_ref()?;
    // Below another one it is found when that is built.
    if bed.depth_file.is_given() || bed.slope_deg.is_given() {
        return None;
    }
    let depth = bed.depth_m.value()?;
    let [_, _, z] = place.value()?;
    (z < -depth - SUNK).then(|| {
        let problem = format!(
            "lies {} m below the bed, which is {depth} m deep",
            -depth - z
        );
        place.finding(problem, format!("give a z of {} or more", -depth))
    })
}
