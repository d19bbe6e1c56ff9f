//! Key paths of a case by the paths that its system has them at.

use super::bears::{bears_by_mass, bears_by_shape, bears_by_volume};
use super::lines::{line_at, line_of};
use super::places::{end_of, is_on_vessel, moves_at_rest, on_free_end, vessel_name};
use super::source::{LETTERS, LineSource};
use crate::case::{Case, Clump, EndKind, LineEnd, MotionName, Payload, split};

/// The key path of the system whose value is that of a key of the case; nothing where no key of the system is.
pub(super) fn translated(source: &LineSource<'_>, path: &str) -> Option<String> {
    let parts = split(path)?;
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    match parts.as_slice() {
        ["environment", "water_density_kg_per_m3"] if is_derived_by_density(source) => None,
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
        ["payload", "shape", key] => of_shape(source, key),
        _ => None,
    }
}

/// Whether a number of the system was computed by the density of the water.
fn is_derived_by_density(source: &LineSource<'_>) -> bool {
    let derives = |payload: &Payload| {
        let turns = payload.rotation.is_some();
        let by_shape = turns && payload.shape.is_some() && payload.added_mass_kg.is_none();
        let by_mass = turns || bears_by_volume(source, payload);
        by_shape || (payload.wet_mass_kg.is_some() && by_mass)
    };
    let mut clumps = LETTERS
        .iter()
        .filter_map(|letter| on_free_end(source, letter));
    source.case.payload.as_ref().is_some_and(derives)
        || clumps.any(|clump| bears_by_mass(source, clump))
}

fn of_section(source: &LineSource<'_>, section: &str, key: &str) -> Option<String> {
    let line = line_of(&source.case, section, LineEnd::A)?;
    let mut own = line.sections.iter().filter(|own| own.of.name == section);
    own.next().filter(|own| own.part.is_none())?;
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
            match end_of(case, clump) {
                None => name.to_owned(),
                Some(letter) => return of_end_clump(source, (letter, clump), key),
            }
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

/// A key of the clump that is the body of a free end, where nothing else of the system follows from it.
fn of_end_clump(
    source: &LineSource<'_>,
    (letter, clump): (&str, &Clump),
    key: &str,
) -> Option<String> {
    on_free_end(source, letter)?;
    let keys = ["mass_kg", "wet_mass_kg", "drag_area_m2", "added_mass_kg"];
    let by_mass = bears_by_mass(source, clump) && keys[..2].contains(&key);
    let ends = &source.case.ends;
    let name = if letter == LETTERS[0] {
        &ends.a.name
    } else {
        &ends.b.name
    };
    (keys.contains(&key) && !by_mass).then(|| format!("points.{name}.{key}"))
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
    let both = &source.case.ends;
    let end = if letter == "a" { &both.a } else { &both.b };
    let of_point = [
        "amplitude_m",
        "period_s",
        "phase_deg",
        "ramp_s",
        "position_m",
    ];
    // At rest a moving end is held where its motion begins.
    let is_put = end.kind == EndKind::Moving && !source.is_in_time();
    let is_put = is_put && (key != "position_m" || moves_at_rest(source, end));
    if of_point.contains(&key) && end.kind.is_held() && !is_put {
        let vessel = vessel_name(end);
        let part = match is_on_vessel(source, end) {
            true => ["bodies", &*vessel, key],
            false => ["points", &*end.name, key],
        };
        let path = [&part, axis].concat();
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

/// A key of the payload, where nothing else of the system follows from it.
fn of_payload(source: &LineSource<'_>, key: &str) -> Option<String> {
    let payload = source.case.payload.as_ref()?;
    let name = &source.case.ends.b.name;
    let by_volume = bears_by_volume(source, payload);
    let wet = payload.wet_mass_kg.is_some();
    let (table, own) = match (key, payload.rotation.is_some()) {
        ("breakout_n" | "breakout_distance_m", _) => return of_suction(source, payload, key),
        ("dry_mass_kg", true) if !wet => ("bodies", "mass_kg"),
        ("volume_m3", true) if !wet => ("bodies", key),
        ("dry_mass_kg", false) if !(wet && by_volume) => ("points", "mass_kg"),
        ("wet_mass_kg", false) if wet && !by_volume => ("points", key),
        ("volume_m3", false) if !wet && !by_volume => ("points", key),
        ("drag_area_m2" | "added_mass_kg", false) => ("points", key),
        _ => return None,
    };
    Some(format!("{table}.{name}.{own}"))
}

/// A key of the shape of the payload, where nothing else follows from that.
fn of_shape(source: &LineSource<'_>, key: &str) -> Option<String> {
    let payload = source.case.payload.as_ref()?;
    let is_number = payload.rotation.is_some() || bears_by_shape(source, payload);
    let name = &source.case.ends.b.name;
    (!is_number).then(|| format!("points.{name}.shape.{key}"))
}
