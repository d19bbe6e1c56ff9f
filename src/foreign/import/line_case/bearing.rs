//! How what hangs at an end of the line bears on the bed.

use super::copied::value_of;
use super::source::LineSource;
use crate::case::{FrictionLaw, Payload};
use crate::import::fault::Fault;
use crate::import::to_case::case_text::{CaseText, number};

/// What of it acts and a free point cannot state, of a table with this greatest pull of the bed \[N\].
pub(super) fn faults(source: &LineSource<'_>, table: &[&str], breakout_n: f64) -> Vec<Fault> {
    let mut found = Vec::new();
    let Some(bed) = &source.case.seabed else {
        return found;
    };
    if breakout_n > 0.0 {
        let path = [table, &["breakout_n"]].concat();
        let problem = "holds back what leaves the bed, and a point of a system leaves it freely";
        let remedy = "leave it out where nothing leaves the bed";
        found.push(source.fault(&path, problem, remedy));
    }
    let rubs = bed.friction.is_some_and(|friction| friction > 0.0);
    if rubs && source.is_in_time() && bed.friction_law == FrictionLaw::Zhu2017 {
        let problem = "goes with the velocity, and the friction of points of a system by a grip";
        let path = ["seabed", "friction_law"];
        found.push(source.fault(&path, problem, "leave it out"));
    }
    found
}

/// Whether the area on the bed of a payload follows from its volume.
pub(super) fn bears_by_volume(source: &LineSource<'_>, payload: &Payload) -> bool {
    let given = payload.bed_area_m2.is_some() || payload.shape.is_some();
    source.case.seabed.is_some() && !given
}

/// Writes the area that bears \[m²\], how far it is below the point, and its friction.
pub(super) fn write(system: &mut CaseText<'_>, source: &LineSource<'_>, table: &[&str], area: f64) {
    if source.case.seabed.is_none() {
        return;
    }
    let at = |key| source.node(&[table, &[key]].concat());
    match at("bed_area_m2") {
        Some(node) => system.given("bed_area_m2", &value_of(source, node), &node.span, ""),
        None => system.assumed("bed_area_m2", &number(area), "by its shape or volume"),
    }
    if let Some(node) = at("bottom_m") {
        system.given("bottom_m", &value_of(source, node), &node.span, "");
    }
    if let Some(node) = source.node(&["seabed", "friction"]) {
        let value = value_of(source, node);
        system.given("bed_friction", &value, &node.span, "seabed.friction");
    }
}
