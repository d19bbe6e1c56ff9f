//! Checks of the keys of a ship against each other: consistent coefficient tables, possible motions, tables that need each
//! other.

use std::f64::consts::PI;

use super::hull;
use super::model::{CoefficientKeys, CoupledSettingsKeys, Follows, MotionKeys, MotionSettings};
use super::model::{MotionSource, RopeKeys, ShipKeys};
use super::motion::ShipMotion;
use super::quantities::parts;
use crate::case::Finding;
use crate::case::schema::{Key, TableType};
use crate::number::digits;
use crate::physics::sea::DEGREES;
use crate::published::number as published_number;

/// Greatest number of instants of a record, and of steps of the coupled analysis.
const MAX_INSTANTS: f64 = 1e6;
const MAX_STEPS: f64 = 2e6;

/// Checks of a ship.
pub(super) fn check(ship: &ShipKeys<'_>) -> Vec<Finding> {
    let mut found = loads(ship);
    found.extend(ship.motion.as_ref().and_then(motion));
    if let Some(hull) = &ship.hull {
        found.extend(hull::check(hull, has(ship, "coupled")));
    }
    if let Some(settings) = &ship.coupled {
        found.extend(coupled(ship, settings));
    }
    found.extend(ship.rope.as_ref().and_then(|keys| rope(ship, keys)));
    found.extend(published_number::check(
        &ship.published,
        unknown_quantity,
        &[],
        &[],
    ));
    found
}

/// Whether the file has a table, faulty or not.
fn has(ship: &ShipKeys<'_>, table: &str) -> bool {
    ship.place.node.get(table).is_some()
}

fn unknown_quantity(key: &Key<'_, String>) -> Option<Finding> {
    let quantity = key.get().filter(|name| parts(name).is_none())?;
    Some(key.finding(
        format!("is not known: \"{}\"", quantity.escape_default()),
        "name a motion, a derivative and a statistic, such as pitch.velocity.rms",
    ))
}

fn loads(ship: &ShipKeys<'_>) -> Vec<Finding> {
    if !["wind", "current", "drift"]
        .iter()
        .any(|load| has(ship, load))
    {
        let remedy = "add [wind], [current] or [drift]";
        let about = ship.ship.iter();
        return about
            .map(|ship| ship.place.finding("no load acts on the ship", remedy))
            .collect();
    }
    let loads = [
        ship.wind.as_ref().map(|load| load.coefficients()),
        ship.current.as_ref().map(|load| load.coefficients()),
        ship.drift.as_ref().map(|load| load.coefficients()),
    ];
    loads.iter().flatten().flat_map(coefficients).collect()
}

/// Either a consistent table or series.
fn coefficients(load: &CoefficientKeys<'_, '_>) -> Vec<Finding> {
    let has_table = load.angle_deg.is_given() || load.table.iter().any(|key| key.is_given());
    let series = load.series.iter().find(|key| key.is_given());
    match (has_table, series) {
        (false, None) => vec![load.place.finding(
            "has no coefficients",
            "give angle_deg with surge, sway and yaw, or the series surge_cosines, sway_sines, yaw_sines",
        )],
        (true, Some(series)) => {
            vec![series.finding("is a series, and there is a table too", "give one of both")]
        }
        (false, Some(_)) => Vec::new(),
        (true, None) => match list(load.angle_deg) {
            None => Vec::new(),
            Some(list) => match angles(load.angle_deg, list) {
                Some(invalid) => vec![invalid],
                None => columns(load, list),
            },
        },
    }
}

/// The numbers of a list, none where it is not given; nothing where it is faulty.
fn list<'k>(key: &'k Key<'_, Vec<f64>>) -> Option<&'k [f64]> {
    match key.is_given() {
        true => key.get().map(Vec::as_slice),
        false => Some(&[]),
    }
}

/// Columns of one coefficient an angle, odd ones zero at the ends of a half turn.
fn columns(load: &CoefficientKeys<'_, '_>, angles: &[f64]) -> Vec<Finding> {
    let last = angles.last();
    let half = last.is_some_and(|last| (last.to_radians() - PI).abs() < 1e-9);
    let check = |(degree, key): (usize, &&Key<'_, Vec<f64>>)| {
        let values = list(key)?;
        if values.len() != angles.len() {
            let count = values.len();
            return Some(key.finding(
                format!("holds {count} numbers for {} angles", angles.len()),
                "give one number for each angle",
            ));
        }
        let ends = [values[0], values[values.len() - 1]];
        let nonzero = degree > 0 && half && ends.iter().any(|v| v.abs() > 1e-12);
        nonzero.then(|| {
            key.finding(
                "must be zero at 0 and 180 degrees, because the other side follows by symmetry",
                "begin and end with 0, or give the table up to below 360 degrees",
            )
        })
    };
    load.table.iter().enumerate().filter_map(check).collect()
}

/// Angles that ascend from 0 to 180 or to below 360 degrees.
fn angles(key: &Key<'_, Vec<f64>>, angles: &[f64]) -> Option<Finding> {
    let invalid = |problem: String| {
        let remedy = "give ascending angles from 0 to 180, or from 0 to below 360";
        Some(key.finding(problem, remedy))
    };
    if angles.len() < 3 {
        return invalid("holds fewer than 3 angles".to_owned());
    }
    if angles[0].abs() > 1e-9 {
        return invalid(format!("begins at {} degrees", digits(angles[0], 6)));
    }
    if let Some(pair) = angles.windows(2).find(|pair| pair[1] - pair[0] < 1e-6) {
        let (from, to) = (digits(pair[0], 6), digits(pair[1], 6));
        return invalid(format!("does not ascend from {from} to {to} degrees"));
    }
    let last = angles[angles.len() - 1];
    let valid = (last - 180.0).abs() < 1e-9 || (last > 180.0 && last < 360.0 - 1e-6);
    if valid {
        return None;
    }
    invalid(format!("ends at {} degrees", digits(last, 6)))
}

/// Statistics that a motion can have, and a record of acceptable length.
fn motion(keys: &MotionKeys<'_>) -> Option<Finding> {
    let too_long = too_many(&keys.step_s, &keys.duration_s, MAX_INSTANTS, "instants");
    if too_long.is_some() || !keys.by.is(&MotionSource::Statistics) {
        return too_long;
    }
    let rms = [
        &keys.translation_rms_m,
        &keys.rotation_rms_deg,
        &keys.translation_velocity_rms_m_per_s,
        &keys.rotation_velocity_rms_deg_per_s,
        &keys.translation_acceleration_rms_m_per_s2,
        &keys.rotation_acceleration_rms_deg_per_s2,
    ];
    if rms.iter().any(|key| key.is_faulty()) {
        return None;
    }
    let settings = MotionSettings::from_keys(keys).ok()?;
    let error = ShipMotion::new(&settings, None, settings.seed()).err()?;
    let key = if error.degree < 3 {
        &keys.translation_rms_m
    } else {
        &keys.rotation_rms_deg
    };
    Some(key.finding(
        format!("{}: {}", DEGREES[error.degree], error.why),
        "give displacement, velocity and acceleration of the same record, and a longer slow_period_s where that is needed",
    ))
}

/// A step that gives more than `max` of what is computed.
fn too_many(step: &Key<'_, f64>, duration: &Key<'_, f64>, max: f64, what: &str) -> Option<Finding> {
    let (step_s, duration_s) = (step.value()?, duration.value()?);
    (duration_s / step_s > max).then(|| {
        let duration = digits(duration_s, 6);
        step.finding(
            format!("gives more than {max:e} {what} in {duration} s"),
            "give a longer step or a shorter duration_s",
        )
    })
}

/// What the coupled analysis needs.
fn coupled(ship: &ShipKeys<'_>, settings: &CoupledSettingsKeys<'_>) -> Vec<Finding> {
    let missing = ["hull", "mooring"].into_iter().filter(|t| !has(ship, t));
    let mut found: Vec<Finding> = missing
        .map(|table| {
            let remedy = format!("add [{table}], or remove [coupled]");
            settings.place.finding(format!("needs [{table}]"), remedy)
        })
        .collect();
    let (from, duration) = (settings.from_s.value(), settings.duration_s.value());
    if let (Some(from), Some(duration)) = (from, duration)
        && from >= duration
    {
        let duration = digits(duration, 6);
        found.push(settings.from_s.finding(
            format!("leaves nothing of {duration} s for statistics"),
            "give a time before duration_s, or a longer duration_s",
        ));
    }
    if let Some(segments) = settings.segments.value().filter(|count| count % 2 == 1) {
        found.push(settings.segments.finding(
            format!("is odd: {segments}"),
            "give an even number, because half the segments give the mesh error",
        ));
    }
    let (step, duration) = (&settings.step_s, &settings.duration_s);
    found.extend(too_many(step, duration, MAX_STEPS, "steps"));
    found
}

/// The motion that the rope follows.
fn rope(ship: &ShipKeys<'_>, rope: &RopeKeys<'_>) -> Option<Finding> {
    if !has(ship, "motion") {
        let remedy = "add [motion], or remove [rope]";
        return Some(rope.place.finding("needs [motion]", remedy));
    }
    let missing = rope.follows.is(&Follows::Coupled) && !has(ship, "coupled");
    let remedy = "add [coupled], or follow \"motion\"";
    missing.then(|| rope.follows.finding("needs [coupled]", remedy))
}
