//! Checks of the bed of a system: keys of a grid of depths without one, places below a level bed.

use super::model::SystemKeys;
use crate::case::schema::Key;
use crate::case::{BedInterpolation, Finding};

/// Keys of a bed without a grid of depths that have no effect.
pub(super) fn bed(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let Some(bed) = &keys.seabed else {
        return Vec::new();
    };
    if !bed.depth_file.is_given() {
        let problem = "has no effect: the bed has no file of depths";
        let remedy = "add `depth_file = ...`, or remove this key";
        let given = bed.interpolation.if_given(problem, remedy);
        let differs = !bed.interpolation.is(&BedInterpolation::Smooth);
        return given.filter(|_| differs).into_iter().collect();
    }
    Vec::new()
}

/// A place below a level bed; over a grid that is found with the depths.
pub(super) fn below_bed(keys: &SystemKeys<'_>, place: &Key<'_, [f64; 3]>) -> Option<Finding> {
    let bed = keys.seabed.as_ref()?;
    if bed.depth_file.is_given() {
        return None;
    }
    let depth = bed.depth_m.value()?;
    let [_, _, z] = place.value()?;
    (z < -depth).then(|| {
        let problem = format!(
            "lies {} m below the bed, which is {depth} m deep",
            -depth - z
        );
        place.finding(problem, format!("give a z of {} or more", -depth))
    })
}
