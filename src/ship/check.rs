//! What cannot be as a ship file says, beyond types and ranges: coefficients that contradict themselves, marks that point
//! nowhere, nothing that acts.

use std::f64::consts::PI;

use super::hull;
use super::model::{Coefficients, Follows, MotionSource, Ship};
use super::motion::ShipMotion;
use super::quantities::parts;
use crate::case::{Misfit, Node};
use crate::physics::sea::DEGREES;
use crate::reference::published_number::misfits as misfits_of;
use crate::report::number::digits;

/// Everything that cannot be.
pub(super) fn misfits(ship: &Ship, tree: &Node) -> Vec<Misfit> {
    let mut wrong = Vec::new();
    let loads = [
        ("wind", ship.wind.as_ref().map(|l| &l.coefficients)),
        ("current", ship.current.as_ref().map(|l| &l.coefficients)),
        ("drift", ship.drift.as_ref().map(|l| &l.coefficients)),
    ];
    if loads.iter().all(|(_, settings)| settings.is_none()) {
        wrong.push(Misfit::at(
            "ship",
            "nothing acts on the ship",
            "add [wind], [current] or [drift]",
        ));
    }
    for (table, settings) in loads {
        if let Some(settings) = settings {
            wrong.extend(coefficients(table, settings));
        }
    }
    wrong.extend(motion(ship));
    if let Some(hull) = &ship.hull {
        wrong.extend(hull::misfits(hull, ship.coupled.as_ref()));
    }
    wrong.extend(coupled(ship));
    wrong.extend(rope(ship));
    wrong.extend(misfits_of(&ship.published, |quantity| {
        parts(quantity).is_none().then(|| {
            (
                format!("is not known: \"{}\"", quantity.escape_default()),
                "name a motion, a rate and a statistic, such as pitch.velocity.rms".to_owned(),
            )
        })
    }));
    wrong.extend(marks(ship, tree));
    wrong
}

/// A table or series, and a table that is one.
fn coefficients(table: &str, settings: &Coefficients) -> Vec<Misfit> {
    let columns = [
        ("surge", &settings.surge),
        ("sway", &settings.sway),
        ("yaw", &settings.yaw),
    ];
    let series = [
        ("surge_cosines", &settings.surge_cosines),
        ("sway_sines", &settings.sway_sines),
        ("yaw_sines", &settings.yaw_sines),
    ];
    let given = |list: &[(&'static str, &Vec<f64>)]| {
        let named = list.iter().find(|(_, values)| !values.is_empty());
        named.map(|(name, _)| *name)
    };
    let of_table = if settings.angle_deg.is_empty() {
        given(&columns)
    } else {
        Some("angle_deg")
    };
    match (of_table, given(&series)) {
        (None, None) => vec![Misfit::new(
            &[table],
            "has no coefficients",
            "give angle_deg with surge, sway and yaw, or the series surge_cosines, sway_sines, yaw_sines",
        )],
        (Some(_), Some(extra)) => vec![Misfit::new(
            &[table, extra],
            "is a series, and there is a table too",
            "give one of both",
        )],
        (None, Some(_)) => Vec::new(),
        (Some(_), None) => whole_table(table, &settings.angle_deg, &columns),
    }
}

fn whole_table(table: &str, angles: &[f64], columns: &[(&str, &Vec<f64>)]) -> Vec<Misfit> {
    let mut wrong = Vec::new();
    if let Some(misfit) = rising(table, angles) {
        return vec![misfit];
    }
    let half = angles
        .last()
        .is_some_and(|last| (last.to_radians() - PI).abs() < 1e-9);
    for (name, values) in columns {
        if values.len() != angles.len() {
            wrong.push(Misfit::new(
                &[table, name],
                format!("holds {} numbers for {} angles", values.len(), angles.len()),
                "give one number for each angle",
            ));
            continue;
        }
        let odd = *name != "surge" && half;
        let ends = [values[0], values[values.len() - 1]];
        if odd && ends.iter().any(|v| v.abs() > 1e-12) {
            wrong.push(Misfit::new(
                &[table, name],
                "is not nought at 0 and at 180 degrees, though the other side is to follow by symmetry",
                "begin and end with 0, or give the table around to below 360 degrees",
            ));
        }
    }
    wrong
}

fn rising(table: &str, angles: &[f64]) -> Option<Misfit> {
    let path = [table, "angle_deg"];
    let remedy = "give angles that rise from 0 to 180, or from 0 to below 360";
    if angles.len() < 3 {
        return Some(Misfit::new(&path, "holds fewer than 3 angles", remedy));
    }
    if angles[0].abs() > 1e-9 {
        let problem = format!("begins at {} degrees", digits(angles[0], 6));
        return Some(Misfit::new(&path, problem, remedy));
    }
    if let Some(pair) = angles.windows(2).find(|pair| pair[1] - pair[0] < 1e-6) {
        let problem = format!(
            "does not rise from {} to {} degrees",
            digits(pair[0], 6),
            digits(pair[1], 6)
        );
        return Some(Misfit::new(&path, problem, remedy));
    }
    let last = angles[angles.len() - 1];
    let fine = (last - 180.0).abs() < 1e-9 || (last > 180.0 && last < 360.0 - 1e-6);
    (!fine).then(|| {
        let problem = format!("ends at {} degrees", digits(last, 6));
        Misfit::new(&path, problem, remedy)
    })
}

/// Statistics that a motion has, and a record that is none too long.
fn motion(ship: &Ship) -> Vec<Misfit> {
    const MOST: f64 = 1e6;
    let Some(settings) = &ship.motion else {
        return Vec::new();
    };
    if settings.duration_s / settings.step_s > MOST {
        return vec![Misfit::at(
            "motion.step_s",
            format!(
                "makes more than {MOST} instants of {} s",
                digits(settings.duration_s, 6)
            ),
            "give a longer step or a shorter duration_s",
        )];
    }
    if settings.by == MotionSource::Responses {
        return Vec::new();
    }
    let Err(error) = ShipMotion::new(settings, None, settings.seed()) else {
        return Vec::new();
    };
    let table = if error.degree < 3 {
        "motion.translation_rms_m"
    } else {
        "motion.rotation_rms_deg"
    };
    let problem = format!("{}: {}", DEGREES[error.degree], error.why);
    vec![Misfit::at(
        table,
        problem,
        "give displacement, velocity and acceleration of one and the same record, and a longer slow_period_s where that is asked for",
    )]
}

/// What ship and line in time need.
fn coupled(ship: &Ship) -> Vec<Misfit> {
    const MOST: f64 = 2e6;
    let Some(settings) = &ship.coupled else {
        return Vec::new();
    };
    let mut wrong = Vec::new();
    let needs = [
        ("[hull]", ship.hull.is_none()),
        ("[mooring]", ship.mooring.is_none()),
    ];
    for (table, missing) in needs {
        if missing {
            wrong.push(Misfit::at(
                "coupled",
                format!("has no {table} to work with"),
                format!("add {table}, or remove [coupled]"),
            ));
        }
    }
    if settings.from_s >= settings.duration_s {
        wrong.push(Misfit::at(
            "coupled.from_s",
            format!(
                "leaves nothing of {} s to count",
                digits(settings.duration_s, 6)
            ),
            "give a time before duration_s, or a longer duration_s",
        ));
    }
    if settings.segments % 2 == 1 {
        wrong.push(Misfit::at(
            "coupled.segments",
            format!("is odd: {}", settings.segments),
            "give an even number, as half the segments tell the error of the mesh",
        ));
    }
    if settings.duration_s / settings.step_s > MOST {
        wrong.push(Misfit::at(
            "coupled.step_s",
            format!(
                "makes more than {MOST:e} steps of {} s",
                digits(settings.duration_s, 6)
            ),
            "give a longer step or a shorter duration_s",
        ));
    }
    wrong
}

/// What the rope follows.
fn rope(ship: &Ship) -> Option<Misfit> {
    let rope = ship.rope.as_ref()?;
    if ship.motion.is_none() {
        return Some(Misfit::at(
            "rope",
            "has no motion to follow",
            "add [motion], or remove [rope]",
        ));
    }
    (rope.follows == Follows::Coupled && ship.coupled.is_none()).then(|| {
        Misfit::at(
            "rope.follows",
            "is to follow ship and anchor line in time, and there is no [coupled]",
            "add [coupled], or follow \"motion\"",
        )
    })
}

/// Marks point to inputs that the file has.
fn marks(ship: &Ship, tree: &Node) -> Vec<Misfit> {
    let lost = ship.marks.keys().filter(|key| {
        let parts = crate::case::split(key).unwrap_or_default();
        parts.is_empty() || tree.find(&parts).is_none()
    });
    lost.map(|key| {
        Misfit::new(
            &["marks", key],
            "the file has no such key",
            "name a key path of the file, such as \"ship.length_m\"",
        )
    })
    .collect()
}
