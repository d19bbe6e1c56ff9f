//! Key paths of a case by the paths that its system has them at.

use super::bearing::bears_by_volume;
use super::lines::{line_at, line_of};
use super::places::{end_of, on_free_end};
use super::source::{LETTERS, LineSource};
use super::start;
use crate::case::{Case, EndKind, LineEnd, MotionName, Payload, split};

/// The key path of the system whose value is that of a key of the case; nothing where no key of the system is.
pub(super) fn translated(source: &LineSource<'_>, path: &str) -> Option<String> {
    let parts = split(path)?;
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    match parts.as_slice() {
        ["environment", "water_density_kg_per_m3"] if is_derived_by_density(source) => None,
        ["environment", "gravity_m_per_s2"] if has_lift_in_air(source) => None,
        [
            "parameters" | "environment" | "current" | "statistics" | "materials",
            ..,
        ] => Some(path.to_owned()),
        ["seabed", ..] => Some(path.to_owned()),
        ["waves", rest @ ..] => Some(format!("waves.1.{}", rest.join("."))),
        ["solver" | "modes", ..] => Some(path.to_owned()),
        [
            "output",
            "interval_s" | "shape_interval_s" | "response_from_s" | "energy",
        ] => Some(path.to_owned()),
        ["line", section, key @ ("length_m" | "segments")] => of_section(source, section, key),
        [table @ ("floats" | "modules" | "clumps"), name, key] => {
            of_attached(source, (table, name), key)
        }
        ["ends", letter @ ("a" | "b"), key, axis @ ..] => of_end(source, letter, key, axis),
        ["payload", key] => of_payload(source, key),
        _ => None,
    }
}

/// Whether a number of the system was computed by the density of the water.
fn is_derived_by_density(source: &LineSource<'_>) -> bool {
    let payload = source.case.payload.as_ref();
    let by_shape = |payload: &Payload| payload.shape.is_some() && payload.added_mass_kg.is_none();
    payload.is_some_and(|payload| payload.wet_mass_kg.is_some() || by_shape(payload))
        || LETTERS
            .iter()
            .any(|letter| on_free_end(source, letter).is_some())
        || source.case.traveller.is_some()
}

/// Whether a load was computed by gravity: of a body in air that weighs another than its mass.
fn has_lift_in_air(source: &LineSource<'_>) -> bool {
    let case = &source.case;
    let payload = case.payload.iter();
    let mut payload = payload.filter_map(|one| Some((one.dry_mass_kg, one.wet_mass_kg?)));
    let mut clumps = case.clumps.iter().map(|one| (one.mass_kg, one.wet_mass_kg));
    let differs = |(mass, wet): (f64, f64)| mass != wet;
    let travellers = case.traveller.iter();
    let mut travellers = travellers.map(|one| (one.mass_kg, one.wet_mass_kg));
    let is_lifted = payload.any(differs) || clumps.any(differs) || travellers.any(differs);
    case.environment.water_density_kg_per_m3 == 0.0 && is_lifted
}

fn of_section(source: &LineSource<'_>, section: &str, key: &str) -> Option<String> {
    let line = line_of(&source.case, section, LineEnd::A)?;
    let mut own = line.sections.iter().filter(|own| own.of.name == section);
    own.next().filter(|own| own.part.is_none())?;
    if key == "length_m" && start::follows_from_length(source) {
        return None;
    }
    let name = line.name;
    Some(match line.is_one() {
        true => format!("lines.{name}.{key}"),
        false => format!("lines.{name}.sections.{section}.{key}"),
    })
}

/// A key of floats, modules or a clump between the ends, by the name of its table.
fn of_attached(source: &LineSource<'_>, (table, name): (&str, &str), key: &str) -> Option<String> {
    let case = &source.case;
    let section = section_of(source, (table, name))?;
    let line = line_of(case, section, LineEnd::A)?;
    let own = match table {
        "clumps" => {
            let clump = case.clumps.iter().find(|clump| clump.name == name)?;
            end_of(case, clump).is_none().then(|| name.to_owned())?
        }
        _ if !line.is_one() => name.to_owned(),
        _ => {
            let names = source.node(&[table])?.names();
            let number = names.iter().position(|one| one == name)?;
            (number + 1).to_string()
        }
    };
    Some(format!("lines.{}.{table}.{own}.{key}", line.name))
}

/// The section that floats, modules or a clump are on, by the name of their table.
fn section_of<'c>(source: &'c LineSource<'_>, (table, name): (&str, &str)) -> Option<&'c str> {
    let node = source.node(&[table, name])?;
    let given = node.get("section").and_then(|section| section.text());
    let of = |case: &'c Case| {
        let mut sections = case.line.iter();
        match given {
            Some(given) => sections.find(|one| one.name == given),
            None => sections.next(),
        }
    };
    of(&source.case).map(|section| &*section.name)
}

fn of_end(source: &LineSource<'_>, letter: &str, key: &str, axis: &[&str]) -> Option<String> {
    let ends = &source.case.ends;
    let end = if letter == "a" { &ends.a } else { &ends.b };
    let of_point = [
        "amplitude_m",
        "period_s",
        "phase_deg",
        "ramp_s",
        "position_m",
    ];
    let waves = source.case.waves.as_ref();
    let moves_gauge = waves.is_some_and(|waves| waves.gauge_m.is_none());
    let moves_more = key == "position_m" && (moves_gauge || start::follows_from_length(source));
    if of_point.contains(&key) && end.kind.is_held() && !moves_more {
        let path = [&["points", &*end.name, key], axis].concat();
        return Some(path.join("."));
    }
    let by_table = end.kind == EndKind::Moving && end.motion == MotionName::Table;
    if by_table && source.is_in_time() {
        match key {
            "motion_file" => return Some(format!("points.{}.motion_file", end.name)),
            "motion_interpolation" => {
                return Some(format!("points.{}.table_interpolation", end.name));
            }
            _ => {}
        }
    }
    let name = line_at(
        &source.case,
        match letter {
            "a" => LineEnd::A,
            _ => LineEnd::B,
        },
    );
    match key {
        "release_s" => Some(format!("lines.{name}.release_{letter}_s")),
        "clamp_elevation_deg" | "clamp_azimuth_deg" => Some(format!(
            "lines.{name}.{}",
            key.replacen("clamp", &format!("clamp_{letter}"), 1)
        )),
        _ => None,
    }
}

/// A key of the suction under the payload.
fn of_suction(source: &LineSource<'_>, payload: &Payload, key: &str) -> Option<String> {
    let name = &source.case.ends.b.name;
    let acts = source.case.seabed.is_some() && payload.rotation.is_none();
    acts.then(|| format!("points.{name}.{key}"))
}

/// A key of the payload; its mass where its volume does not follow from that.
fn of_payload(source: &LineSource<'_>, key: &str) -> Option<String> {
    let payload = source.case.payload.as_ref()?;
    let own = match key {
        "dry_mass_kg" if payload.wet_mass_kg.is_none() => "mass_kg",
        "volume_m3" if payload.wet_mass_kg.is_none() && !bears_by_volume(source, payload) => {
            "volume_m3"
        }
        "breakout_n" | "breakout_distance_m" => return of_suction(source, payload, key),
        _ => return None,
    };
    let table = match payload.rotation {
        Some(_) => "bodies",
        None => "points",
    };
    Some(format!("{table}.{}.{own}", source.case.ends.b.name))
}
