//! Unused inputs: keys without effect in this run. They may be intended, as when a run is shortened or another method tried, and so
//! give a remark only; certain mistakes are errors of `case/check`.

use super::vectors::per_axis;
use crate::case::{Case, Current, EndKind, Method, MotionName, OneOrMany, StartShape};
use crate::numerics::V3;

/// Remarks on unused inputs.
pub(super) fn remarks(case: &Case) -> Vec<String> {
    let mut list = if case.solver.method == Method::Static {
        in_statics(case)
    } else {
        beyond_the_run(case)
    };
    list.extend(held_ends(case));
    list.extend(start(case));
    list.extend(spin(case));
    list.extend(traveller(case));
    list.extend(loads_without_effect(case));
    list
}

/// Bodies that the current does not act on, for want of a drag area.
pub fn loads_without_effect(case: &Case) -> Option<String> {
    let flows = |current: &Current| match &current.speed_m_per_s {
        Some(OneOrMany::One(speed)) => *speed != 0.0,
        Some(OneOrMany::Many(speeds)) => speeds.iter().any(|speed| *speed != 0.0),
        None => current.file.is_some(),
    };
    case.current.as_ref().filter(|current| flows(current))?;
    let without = |area: &OneOrMany| per_axis(area) == V3::zeros();
    let payload = case.payload.as_ref().filter(|body| {
        let area = body.drag_area_m2.as_ref();
        body.shape.is_none() && area.is_none_or(without)
    });
    let payload = payload.map(|_| case.ends.b.name.as_str());
    let clumps = case
        .clumps
        .iter()
        .filter(|clump| without(&clump.drag_area_m2) && !clump.has_aligned_drag());
    let traveller = case
        .traveller
        .as_ref()
        .filter(|body| without(&body.drag_area_m2));
    let names: Vec<&str> = payload
        .into_iter()
        .chain(clumps.map(|clump| clump.name.as_str()))
        .chain(traveller.map(|body| body.name.as_str()))
        .collect();
    (!names.is_empty()).then(|| {
        let names = names.join("`, `");
        format!("the current does not act on `{names}`: give drag_area_m2")
    })
}

/// Keys with the time of an event, and the event.
fn times(case: &Case) -> Vec<(String, f64, &'static str)> {
    let mut list = Vec::new();
    for (letter, end) in [("a", &case.ends.a), ("b", &case.ends.b)] {
        let time = end.release_s;
        list.extend(time.map(|t| (format!("ends.{letter}.release_s"), t, "the end is let go")));
    }
    let cut = case.payload.as_ref().and_then(|body| body.release_s);
    list.extend(cut.map(|t| ("payload.release_s".to_owned(), t, "the payload is cut off")));
    let sets_out = case
        .traveller
        .as_ref()
        .filter(|body| body.speed_m_per_s > 0.0);
    list.extend(sets_out.map(|body| {
        let name = "traveller.start_s".to_owned();
        (name, body.start_s, "the traveller sets out")
    }));
    let from = case.output.response_from_s;
    list.extend(from.map(|t| {
        let name = "output.response_from_s".to_owned();
        (name, t, "displacements along the line are taken")
    }));
    list
}

fn in_statics(case: &Case) -> Vec<String> {
    let remarks = times(case).into_iter().map(|(key, _, what)| {
        format!("`{key}` has no effect on statics, which have no time at which {what}")
    });
    remarks.collect()
}

/// Events after the end of the run, and ramps longer than it.
fn beyond_the_run(case: &Case) -> Vec<String> {
    let end = case.solver.duration_s;
    let after = times(case).into_iter().filter(|(_, time, _)| *time >= end);
    let mut list: Vec<String> = after
        .map(|(key, time, what)| {
            format!("`{key}` has no effect: the run ends at {end} s, before {what} at {time} s")
        })
        .collect();
    let moves = |kind| kind == EndKind::Moving;
    let (a, b) = (&case.ends.a, &case.ends.b);
    let ramps = [
        ("waves", case.waves.as_ref().map(|waves| waves.ramp_s)),
        ("ends.a", moves(a.kind).then_some(a.ramp_s)),
        ("ends.b", moves(b.kind).then_some(b.ramp_s)),
        ("traveller", case.traveller.as_ref().map(|body| body.ramp_s)),
    ];
    let longer = ramps
        .into_iter()
        .filter_map(|(table, ramp)| Some((table, ramp.filter(|ramp| *ramp > end)?)));
    list.extend(longer.map(|(table, ramp)| {
        format!("`{table}.ramp_s` of {ramp} s is longer than the run of {end} s: its full amplitude is never reached")
    }));
    list
}

/// Motions of ends that do not move, or move in another way.
fn held_ends(case: &Case) -> Vec<String> {
    let mut list = Vec::new();
    for (letter, end) in [("a", &case.ends.a), ("b", &case.ends.b)] {
        let (moves, motion) = (end.kind == EndKind::Moving, end.motion);
        let from_file = matches!(motion, MotionName::Table | MotionName::Vessel);
        let given = [
            (
                "amplitude_m",
                end.amplitude_m != [0.0; 3],
                motion == MotionName::Harmonic,
            ),
            (
                "rms_m",
                end.rms_m.is_some(),
                motion == MotionName::Irregular,
            ),
            ("motion_file", end.motion_file.is_some(), from_file),
        ];
        let unused = given
            .into_iter()
            .filter(|(_, given, taken)| *given && !(moves && *taken));
        list.extend(unused.map(|(key, ..)| {
            let how = if moves {
                "moves in another way (motion)"
            } else {
                "does not move (kind)"
            };
            format!("`ends.{letter}.{key}` has no effect: `{}` {how}", end.name)
        }));
    }
    list
}

/// Start directions, which an equilibrium determines itself.
fn start(case: &Case) -> Vec<String> {
    if case.start.shape != StartShape::Equilibrium || case.start.from_run.is_some() {
        return Vec::new();
    }
    let rotation = case
        .payload
        .as_ref()
        .and_then(|body| body.rotation.as_ref());
    let given = [
        ("start.azimuth_deg", case.start.azimuth_deg),
        ("start.elevation_deg", case.start.elevation_deg),
        (
            "payload.rotation.start_tilt_deg",
            rotation.map_or(0.0, |body| body.start_tilt_deg),
        ),
    ];
    let given = given.into_iter().filter(|(_, angle)| *angle != 0.0);
    given
        .map(|(key, _)| {
            format!("`{key}` has no effect: the line starts in equilibrium (start.shape)")
        })
        .collect()
}

/// A spin inertia without spin.
fn spin(case: &Case) -> Option<String> {
    let body = case.payload.as_ref()?.rotation.as_ref()?;
    let unused = body.spin_deg_per_s == 0.0 && body.spin_inertia_kg_m2.is_some();
    unused.then(|| {
        "`payload.rotation.spin_inertia_kg_m2` has no effect: the body does not spin".to_owned()
    })
}

/// A destination without speed.
fn traveller(case: &Case) -> Option<String> {
    let body = case.traveller.as_ref()?;
    let stays = body.speed_m_per_s == 0.0 && body.to_m.is_some();
    stays.then(|| {
        "`traveller.to_m` has no effect: at a speed of 0 the body stays where it is".to_owned()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CASE: &str = r#"
        case.title = "unused"
        line = [{ name = "rope", material = "rope", length_m = 20.0, segments = 4 }]
        materials.rope = { diameter_m = 0.1, mass_kg_per_m = 5.0, ea_n = 1e6 }
        ends.a = { name = "a", kind = "moving", position_m = [0, 0, 0], amplitude_m = [1, 0, 0], period_s = 5.0, ramp_s = 20.0 }
        ends.b = { name = "b", kind = "fixed", position_m = [15, 0, 0], release_s = 15.0, amplitude_m = [1, 0, 0] }
        traveller = { name = "t", mass_kg = 1.0, wet_mass_kg = 1.0, speed_m_per_s = 1.0, start_s = 11.0 }
        start.elevation_deg = 20.0
        output.response_from_s = 30.0
        solver.duration_s = 10.0
    "#;

    fn remarks_of(text: &str) -> Vec<String> {
        remarks(&crate::case::parse_keys(text).unwrap())
    }

    #[test]
    fn events_beyond_the_run_give_a_remark_and_those_within_do_not() {
        let short = remarks_of(CASE);
        let keys = [
            "ends.b.release_s",
            "traveller.start_s",
            "output.response_from_s",
            "ends.a.ramp_s",
            "ends.b.amplitude_m",
            "start.elevation_deg",
        ];
        for key in keys {
            assert_eq!(
                short.iter().filter(|line| line.contains(key)).count(),
                1,
                "{key}: {short:?}"
            );
        }
        assert_eq!(short.len(), keys.len(), "{short:?}");
        let long = CASE.replace("duration_s = 10.0", "duration_s = 100.0");
        assert_eq!(remarks_of(&long).len(), 2, "{:?}", remarks_of(&long));
        let statics = CASE.replace("duration_s = 10.0", "method = \"static\"");
        assert!(
            remarks_of(&statics)
                .iter()
                .any(|line| line.contains("no effect on statics"))
        );
    }

    #[test]
    fn a_traveller_without_speed_stays() {
        let stays = CASE.replace(
            "speed_m_per_s = 1.0, start_s = 11.0",
            "speed_m_per_s = 0.0, to_m = 9.0",
        );
        assert!(
            remarks_of(&stays)
                .iter()
                .any(|line| line.contains("traveller.to_m"))
        );
    }
}
