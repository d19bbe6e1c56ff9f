//! How what hangs at an end of the line bears on the bed.

use super::copied::value_of;
use super::source::LineSource;
use super::turning_payload::turning;
use crate::case::Payload;
use crate::import::to_case::case_text::{CaseText, number};

/// Whether the area on the bed of a payload follows from its volume.
pub(super) fn bears_by_volume(source: &LineSource<'_>, payload: &Payload) -> bool {
    let given = payload.bed_area_m2.is_some() || payload.shape.is_some();
    source.case.seabed.is_some() && !given
}

/// Whether it follows from its shape.
pub(super) fn bears_by_shape(source: &LineSource<'_>, payload: &Payload) -> bool {
    source.case.seabed.is_some() && payload.bed_area_m2.is_none() && payload.shape.is_some()
}

/// Writes the area that bears \[m²\], how far it is below the point, its suction and its friction.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>, table: &[&str], area: f64) {
    if source.case.seabed.is_none() {
        return;
    }
    let at = |key| source.node(&[table, &[key]].concat());
    match at("bed_area_m2") {
        Some(node) => system.given("bed_area_m2", &value_of(source, node), &node.span, ""),
        None => system.assumed("bed_area_m2", &number(area), "by its shape or volume"),
    }
    if let Some(node) = at("bottom_m").filter(|_| turning(source).is_none()) {
        system.given("bottom_m", &value_of(source, node), &node.span, "");
    }
    for key in ["breakout_n", "breakout_distance_m"] {
        if let Some(node) = at(key) {
            system.given(key, &value_of(source, node), &node.span, "");
        }
    }
    if let Some(node) = source.node(&["seabed", "friction"]) {
        let value = value_of(source, node);
        system.given("bed_friction", &value, &node.span, "");
    }
}
