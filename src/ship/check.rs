//! Validation of a ship file beyond types and ranges: consistent coefficient tables, possible motions, tables that need each
//! other, provenance of inputs that exist.

use std::f64::consts::PI;

use super::hull;
use super::model::{Coefficients, Follows, MotionSource, Ship};
use super::motion::ShipMotion;
use super::quantities::parts;
use crate::case::{InvalidValue, Node};
use crate::number::digits;
use crate::physics::sea::DEGREES;
use crate::reference::published_number;

/// Greatest number of instants of a record, and of steps of the coupled analysis.
const MAX_INSTANTS: f64 = 1e6;
const MAX_STEPS: f64 = 2e6;

/// Names of the coefficients in a table, and in Fourier series.
const TABLE: [&str; 3] = ["surge", "sway", "yaw"];
const SERIES: [&str; 3] = ["surge_cosines", "sway_sines", "yaw_sines"];

/// Everything that is invalid.
pub(super) fn invalid_values(ship: &Ship, tree: &Node) -> Vec<InvalidValue> {
    let mut wrong = loads(ship);
    wrong.extend(motion(ship));
    if let Some(hull) = &ship.hull {
        wrong.extend(hull::invalid_values(hull, ship.coupled.as_ref()));
    }
    wrong.extend(coupled(ship));
    wrong.extend(rope(ship));
    wrong.extend(published_number::invalid_values(
        &ship.published,
        |quantity| {
            parts(quantity).is_none().then(|| {
                (
                    format!("is not known: \"{}\"", quantity.escape_default()),
                    "name a motion, a derivative and a statistic, such as pitch.velocity.rms"
                        .to_owned(),
                )
            })
        },
    ));
    wrong.extend(marks(ship, tree));
    wrong
}

fn loads(ship: &Ship) -> Vec<InvalidValue> {
    let loads = [
        ("wind", ship.wind.as_ref().map(|load| load.coefficients())),
        (
            "current",
            ship.current.as_ref().map(|load| load.coefficients()),
        ),
        ("drift", ship.drift.as_ref().map(|load| load.coefficients())),
    ];
    if loads.iter().all(|(_, load)| load.is_none()) {
        let remedy = "add [wind], [current] or [drift]";
        return vec![InvalidValue::at("ship", "no load acts on the ship", remedy)];
    }
    let given = loads
        .iter()
        .filter_map(|(table, load)| load.as_ref().map(|load| (*table, load)));
    given
        .flat_map(|(table, load)| coefficients(table, load))
        .collect()
}

/// Either a consistent table or series.
fn coefficients(table: &str, load: &Coefficients<'_>) -> Vec<InvalidValue> {
    let first_given = |names: [&'static str; 3], lists: [&[f64]; 3]| {
        let mut named = names.into_iter().zip(lists);
        named
            .find(|(_, values)| !values.is_empty())
            .map(|(name, _)| name)
    };
    let has_table = !load.angle_deg.is_empty() || first_given(TABLE, load.table).is_some();
    match (has_table, first_given(SERIES, load.series)) {
        (false, None) => vec![InvalidValue::new(
            &[table],
            "has no coefficients",
            "give angle_deg with surge, sway and yaw, or the series surge_cosines, sway_sines, yaw_sines",
        )],
        (true, Some(series)) => vec![InvalidValue::new(
            &[table, series],
            "is a series, and there is a table too",
            "give one of both",
        )],
        (false, Some(_)) => Vec::new(),
        (true, None) => match angles(table, load.angle_deg) {
            Some(invalid) => vec![invalid],
            None => columns(table, load),
        },
    }
}

/// Columns of one coefficient an angle, odd ones zero at the ends of a half turn.
fn columns(table: &str, load: &Coefficients<'_>) -> Vec<InvalidValue> {
    let last = load.angle_deg.last();
    let half = last.is_some_and(|last| (last.to_radians() - PI).abs() < 1e-9);
    let check = |(name, values): (&str, &[f64])| {
        if values.len() != load.angle_deg.len() {
            return Some(InvalidValue::new(
                &[table, name],
                format!(
                    "holds {} numbers for {} angles",
                    values.len(),
                    load.angle_deg.len()
                ),
                "give one number for each angle",
            ));
        }
        let ends = [values[0], values[values.len() - 1]];
        let nonzero = name != "surge" && half && ends.iter().any(|v| v.abs() > 1e-12);
        nonzero.then(|| {
            InvalidValue::new(
                &[table, name],
                "must be zero at 0 and 180 degrees, because the other side follows by symmetry",
                "begin and end with 0, or give the table up to below 360 degrees",
            )
        })
    };
    TABLE
        .into_iter()
        .zip(load.table)
        .filter_map(check)
        .collect()
}

/// Angles that ascend from 0 to 180 or to below 360 degrees.
fn angles(table: &str, angles: &[f64]) -> Option<InvalidValue> {
    let invalid = |problem: String| {
        let remedy = "give ascending angles from 0 to 180, or from 0 to below 360";
        Some(InvalidValue::new(&[table, "angle_deg"], problem, remedy))
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
fn motion(ship: &Ship) -> Option<InvalidValue> {
    let settings = ship.motion.as_ref()?;
    if settings.duration_s / settings.step_s > MAX_INSTANTS {
        return Some(too_many(
            "motion.step_s",
            MAX_INSTANTS,
            "instants",
            settings.duration_s,
        ));
    }
    if settings.by == MotionSource::Responses {
        return None;
    }
    let error = ShipMotion::new(settings, None, settings.seed()).err()?;
    let key = if error.degree < 3 {
        "motion.translation_rms_m"
    } else {
        "motion.rotation_rms_deg"
    };
    Some(InvalidValue::at(
        key,
        format!("{}: {}", DEGREES[error.degree], error.why),
        "give displacement, velocity and acceleration of the same record, and a longer slow_period_s where that is needed",
    ))
}

fn too_many(key: &str, max: f64, what: &str, duration_s: f64) -> InvalidValue {
    InvalidValue::at(
        key,
        format!(
            "gives more than {max:e} {what} in {} s",
            digits(duration_s, 6)
        ),
        "give a longer step or a shorter duration_s",
    )
}

/// What the coupled analysis needs.
fn coupled(ship: &Ship) -> Vec<InvalidValue> {
    let Some(settings) = &ship.coupled else {
        return Vec::new();
    };
    let needs = [
        ("[hull]", ship.hull.is_none()),
        ("[mooring]", ship.mooring.is_none()),
    ];
    let missing = needs.into_iter().filter(|(_, missing)| *missing);
    let mut wrong: Vec<InvalidValue> = missing
        .map(|(table, _)| {
            let remedy = format!("add {table}, or remove [coupled]");
            InvalidValue::at("coupled", format!("needs {table}"), remedy)
        })
        .collect();
    if settings.from_s >= settings.duration_s {
        wrong.push(InvalidValue::at(
            "coupled.from_s",
            format!(
                "leaves nothing of {} s for statistics",
                digits(settings.duration_s, 6)
            ),
            "give a time before duration_s, or a longer duration_s",
        ));
    }
    if settings.segments % 2 == 1 {
        wrong.push(InvalidValue::at(
            "coupled.segments",
            format!("is odd: {}", settings.segments),
            "give an even number, because half the segments give the mesh error",
        ));
    }
    if settings.duration_s / settings.step_s > MAX_STEPS {
        wrong.push(too_many(
            "coupled.step_s",
            MAX_STEPS,
            "steps",
            settings.duration_s,
        ));
    }
    wrong
}

/// The motion that the rope follows.
fn rope(ship: &Ship) -> Option<InvalidValue> {
    let rope = ship.rope.as_ref()?;
    if ship.motion.is_none() {
        let remedy = "add [motion], or remove [rope]";
        return Some(InvalidValue::at("rope", "needs [motion]", remedy));
    }
    let missing = rope.follows == Follows::Coupled && ship.coupled.is_none();
    let remedy = "add [coupled], or follow \"motion\"";
    missing.then(|| InvalidValue::at("rope.follows", "needs [coupled]", remedy))
}

/// Provenance of inputs that the file has.
fn marks(ship: &Ship, tree: &Node) -> Vec<InvalidValue> {
    let unknown = ship.marks.keys().filter(|key| {
        let parts = crate::case::split(key).unwrap_or_default();
        parts.is_empty() || tree.find(&parts).is_none()
    });
    unknown
        .map(|key| {
            InvalidValue::new(
                &["marks", key],
                "the file has no such key",
                "name a key path of the file, such as \"ship.length_m\"",
            )
        })
        .collect()
}
