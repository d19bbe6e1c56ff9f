//! What acts in a case and a system cannot state.

use super::payload;
use super::places::moves_at_rest;
use super::source::{LETTERS, LineSource};
use super::traveller;
use crate::case::{End, EndKind, MotionName};
use crate::import::fault::Fault;

/// All of it, but for what the mesh and the results show.
pub(super) fn faults(source: &LineSource<'_>) -> Vec<Fault> {
    let mut found = Vec::new();
    if let Some(body) = &source.case.traveller {
        found.extend(traveller::faults(source, body));
    }
    for (letter, end) in LETTERS
        .into_iter()
        .zip([&source.case.ends.a, &source.case.ends.b])
    {
        found.extend(motion(source, letter, end));
    }
    if source.case.ends.b.kind == EndKind::Payload {
        found.extend(payload::faults(source));
    }
    found.extend(start(source));
    found
}

/// The motion of an end.
fn motion(source: &LineSource<'_>, letter: &str, end: &End) -> Vec<Fault> {
    let path = |key| ["ends", letter, key];
    let mut found = Vec::new();
    if end.kind != EndKind::Moving {
        return found;
    }
    if end.motion == MotionName::Vessel && source.is_in_time() {
        found.extend(source.fault_of_expression(&path("hang_point_m")));
        let waves = source.case.waves.as_ref();
        if waves.is_some_and(|waves| waves.ramp_s > end.ramp_s) {
            let problem = "is shorter than that of the waves, with which the motion of a body of a system grows";
            let remedy = "give the ramp_s of the waves, or a longer one";
            found.push(source.fault(&path("ramp_s"), problem, remedy));
        }
    }
    if !source.is_in_time() && moves_at_rest(source, end) {
        let keys = ["position_m", "amplitude_m", "phase_deg"];
        found.extend(
            keys.iter()
                .filter_map(|key| source.fault_of_expression(&path(key))),
        );
    }
    found
}

/// A start that is no equilibrium.
fn start(source: &LineSource<'_>) -> Vec<Fault> {
    let start = &source.case.start;
    let mut found = Vec::new();
    if start.from_run.is_some() {
        // Its state is of the nodes of a line alone: no joints, points and bodies, and other digests than those of a system's text.
        let problem = "names a stored run of a line, whose last state is none of a system of points and lines";
        let remedy = "start in equilibrium, or carry a run of the system itself on with `seacable run --resume`";
        found.push(source.fault(&["start", "from_run"], problem, remedy));
    }
    found
}
