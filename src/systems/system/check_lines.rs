//! Checks of the lines of a system: what they end at, what they are made of, their clamps.

use std::collections::{HashMap, HashSet};

use super::check_bed::friction_of_line;
use super::check_start;
use super::model::{BodyKeys, LineKeys, LineSectionKeys, PointKeys, PointKind, SystemKeys};
use super::motion::check as motion;
use super::rods;
use crate::case::model::MaterialKeys;
use crate::case::schema::Key;
use crate::case::{CheckedSection, Finding, of_attachments, stated_twice, unknown, used_twice};

/// Parts of a system by their names, so that many lines are checked in proportion to them.
pub(super) struct ByName<'k, 'a> {
    keys: &'k SystemKeys<'a>,
    points: HashMap<&'k str, &'k PointKeys<'a>>,
    bodies: HashMap<&'k str, &'k BodyKeys<'a>>,
    materials: HashMap<&'k str, &'k MaterialKeys<'a>>,
    /// The names of the points at the ends of rods.
    rod_ends: HashSet<String>,
    /// Lines by the points that they end at.
    lines_at: HashMap<&'k str, Vec<&'k LineKeys<'a>>>,
}

/// Tables by their names.
fn by_name<T>(tables: &[(String, T)]) -> HashMap<&str, &T> {
    let named = tables.iter().map(|(name, table)| (name.as_str(), table));
    named.collect()
}

impl<'k, 'a> ByName<'k, 'a> {
    /// The parts of a system.
    pub(super) fn of_keys(keys: &'k SystemKeys<'a>) -> Self {
        let mut lines_at: HashMap<&str, Vec<&LineKeys<'a>>> = HashMap::new();
        for (_, line) in &keys.lines {
            for end in [&line.from, &line.to] {
                if let Some(point) = end.get() {
                    lines_at.entry(point).or_default().push(line);
                }
            }
        }
        let rod_ends = keys.rods.iter().flat_map(|(name, _)| rods::ends(name));
        Self {
            keys,
            points: by_name(&keys.points),
            bodies: by_name(&keys.bodies),
            materials: by_name(&keys.materials),
            rod_ends: rod_ends.collect(),
            lines_at,
        }
    }

    /// What is wrong with each line by itself.
    pub(super) fn check_lines(&self) -> Vec<Finding> {
        let mut found = Vec::new();
        for (_, line) in &self.keys.lines {
            found.extend(self.ends(line));
            found.extend(self.make_up(line));
            found.extend(attached(line));
            found.extend(repeats(line));
            found.extend(self.clamps(line));
            found.extend(check_start::of_line(self.keys, line));
            found.extend(motion::breaks(self.keys, line));
            found.extend(friction_of_line(self.keys, line));
        }
        found
    }

    /// Whether this is the name of a body or rod.
    pub(super) fn is_body(&self, name: &str) -> bool {
        self.bodies.contains_key(name) || self.rod_ends.contains(&rods::ends(name)[0])
    }

    /// Whether lines end at a point, and all of them are without weight.
    pub(super) fn bears_no_weight(&self, point: &str) -> bool {
        let weightless = |line: &&LineKeys<'_>| {
            let material = line.material.given().map(String::as_str);
            let material = material.and_then(|name| self.materials.get(name));
            material.is_some_and(|of| of.wet_weight_kg_per_m.value() == Some(0.0))
        };
        let lines = self.lines_at.get(point);
        lines.is_some_and(|lines| lines.iter().all(weightless))
    }

    fn ends(&self, line: &LineKeys<'_>) -> Vec<Finding> {
        let ends = [&line.from, &line.to].into_iter();
        let mut found: Vec<Finding> = ends.filter_map(|end| self.unknown_point(end)).collect();
        if let (Some(from), Some(to)) = (line.from.get(), line.to.get())
            && from == to
        {
            let problem = format!("the line begins and ends at \"{to}\"");
            found.push(line.to.finding(problem, "give another point"));
        }
        found
    }

    /// An end of a line that is neither a point nor the end of a rod.
    fn unknown_point(&self, end: &Key<'_, String>) -> Option<Finding> {
        let name = end.get()?;
        if self.points.contains_key(name.as_str()) || self.rod_ends.contains(name) {
            return None;
        }
        let rods = self.keys.rods.iter();
        let of_rods: Vec<String> = rods.flat_map(|(name, _)| rods::ends(name)).collect();
        let points = self.keys.points.iter().map(|(name, _)| name.as_str());
        let names: Vec<&str> = points.chain(of_rods.iter().map(String::as_str)).collect();
        unknown(end, &names, "point", "system")
    }

    fn unknown_material(&self, material: &Key<'_, String>) -> Option<Finding> {
        if self.materials.contains_key(material.get()?.as_str()) {
            return None;
        }
        let names = self.keys.materials.iter().map(|(name, _)| name);
        let names: Vec<&String> = names.collect();
        unknown(material, &names, "material", "system")
    }

    /// One material and length, or sections.
    fn make_up(&self, line: &LineKeys<'_>) -> Vec<Finding> {
        let mut found = Vec::from_iter(self.unknown_material(&line.material));
        if line.sections.is_empty() {
            found.extend(
                line.material
                    .if_missing("give `material` and `length_m`, or [[lines.sections]]"),
            );
            found.extend(
                line.length_m
                    .if_missing("give the unstretched length: `length_m`"),
            );
            return found;
        }
        let problem = "is given beside sections";
        let remedy = "leave it out, or leave out the sections";
        found.extend(line.material.if_given(problem, remedy));
        found.extend(line.length_m.if_given(problem, remedy));
        let sections = line.sections.iter();
        found.extend(sections.filter_map(|(_, section)| self.unknown_material(&section.material)));
        found.extend(segments_of_some(line));
        found.extend(names_of_sections(line));
        for (_, section) in line.sections.iter() {
            found.extend(clump_twice(section).into_iter().flatten());
        }
        if let Some((_, last)) = line.sections.last() {
            found.extend(clump_at_end(last));
        }
        found
    }

    /// Clamps hold the direction of a line that bends: in space at a point, with the body at a point on one.
    fn clamps(&self, line: &LineKeys<'_>) -> Vec<Finding> {
        let mut found = Vec::new();
        for (elevation, azimuth, point) in [
            (
                &line.clamp_a_elevation_deg,
                &line.clamp_a_azimuth_deg,
                &line.from,
            ),
            (
                &line.clamp_b_elevation_deg,
                &line.clamp_b_azimuth_deg,
                &line.to,
            ),
        ] {
            if !elevation.is_given() {
                let problem = "has no effect: the end is hinged";
                let remedy = "give the elevation of the clamp as well, or remove it";
                found.extend(azimuth.if_given(problem, remedy));
                continue;
            }
            if !self.holds_directions(point.get()) {
                let problem = "has nothing that holds it: a free point has no directions";
                let remedy = "clamp the line at a fixed or moved point or on a body or rod, or remove the clamp";
                found.extend(elevation.if_given(problem, remedy));
            } else if !self.bends(line) {
                let problem = "has no effect: the line does not bend";
                let remedy = "give its material a bending stiffness `ei_n_m2`, or remove the clamp";
                found.extend(elevation.if_given(problem, remedy));
            }
        }
        found
    }

    /// Whether a point holds directions: it is held or moved, or on a body; ends of rods are.
    fn holds_directions(&self, name: Option<&String>) -> bool {
        let point = name.and_then(|name| self.points.get(name.as_str()));
        // A name that is not known has a finding of its own.
        point.is_none_or(|point| point.kind.get() != Some(&PointKind::Free))
    }

    /// Whether a line has a material with bending stiffness.
    fn bends(&self, line: &LineKeys<'_>) -> bool {
        let sections = line.sections.iter().map(|(_, section)| &section.material);
        let mut names = sections.chain([&line.material]).filter_map(Key::get);
        names.any(|name| {
            let material = self.materials.get(name.as_str());
            material.is_some_and(|of| of.ei_n_m2.value().is_some_and(|ei| ei > 0.0))
        })
    }
}

/// Segments that some sections of a line state and others do not.
fn segments_of_some(line: &LineKeys<'_>) -> Option<Finding> {
    let mut keys = line.sections.iter().map(|(_, section)| &section.segments);
    let given = keys.clone().find(|key| key.is_given())?;
    let all = keys.all(Key::is_given);
    (!all).then(|| {
        let problem = "is given for some sections of the line and not for others";
        given.finding(problem, "give every section its segments, or none")
    })
}

/// Floats, modules and bodies off their sections, bodies of one name, and bodies at the ends of the line.
fn attached(line: &LineKeys<'_>) -> Vec<Finding> {
    let sections = line.sections.iter().map(|(_, section)| {
        let name = section.name.given().map(String::as_str);
        (name, section.length_m.value())
    });
    let mut sections: Vec<CheckedSection<'_>> = sections.collect();
    if sections.is_empty() {
        sections.push((None, line.length_m.value()));
    }
    let all = (&line.floats[..], &line.modules[..], &line.clumps[..]);
    let mut found = of_attachments(&sections, "line", all);
    let names = line.clumps.iter().map(|(_, clump)| &clump.name);
    found.extend(used_twice(
        names,
        "give every body on the line a name of its own",
    ));
    for (_, clump) in &line.clumps {
        let own = clump.section.given().map(String::as_str);
        let of = |section: Option<&CheckedSection<'_>>| {
            section
                .filter(|(name, _)| own.is_none() || *name == own)
                .map(|(_, length)| *length)
        };
        let at = clump.at_m.value();
        let at_a = of(sections.first()).is_some() && at == Some(0.0);
        let at_b = at.is_some() && of(sections.last()) == Some(at);
        if at_a || at_b {
            let problem = "is at the end of the line";
            found.push(
                clump
                    .at_m
                    .finding(problem, "give the mass to the point there"),
            );
        }
    }
    found
}

/// Drag area and added mass of the clump of a section, all around and across and along the line.
fn clump_twice(section: &LineSectionKeys<'_>) -> [Option<Finding>; 2] {
    let drag = [
        &section.clump_drag_area_normal_m2,
        &section.clump_drag_area_tangential_m2,
    ];
    let added_mass = [
        &section.clump_added_mass_normal_kg,
        &section.clump_added_mass_tangential_kg,
    ];
    [
        stated_twice("drag", &section.clump_drag_area_m2, drag),
        stated_twice("added mass", &section.clump_added_mass_kg, added_mass),
    ]
}

/// A clump of the last section, which is where the line ends.
fn clump_at_end(last: &LineSectionKeys<'_>) -> impl Iterator<Item = Finding> {
    let problem = "is at the end of the line";
    let remedy = "give the mass to the point there, or to the section before";
    let found = [
        last.clump_kg.if_given(problem, remedy),
        last.clump_mass_kg.if_given(problem, remedy),
        last.clump_drag_area_m2.if_given(problem, remedy),
        last.clump_drag_area_normal_m2.if_given(problem, remedy),
        last.clump_drag_area_tangential_m2.if_given(problem, remedy),
        last.clump_added_mass_kg.if_given(problem, remedy),
        last.clump_added_mass_normal_kg.if_given(problem, remedy),
        last.clump_added_mass_tangential_kg
            .if_given(problem, remedy),
        last.clump_bed_area_m2.if_given(problem, remedy),
        last.clump_bottom_m.if_given(problem, remedy),
        last.clump_breakout_n.if_given(problem, remedy),
        last.clump_breakout_distance_m.if_given(problem, remedy),
    ];
    found.into_iter().flatten()
}

/// Names that sections of a line share, or that some of them have and others do not.
fn names_of_sections(line: &LineKeys<'_>) -> Vec<Finding> {
    let names = line.sections.iter().map(|(_, section)| &section.name);
    let mut found = used_twice(
        names.clone(),
        "give every section of the line a name of its own",
    );
    let given = names.clone().find(|key| key.is_given());
    if let Some(given) = given.filter(|_| names.clone().any(|key| !key.is_given())) {
        let problem = "is given for some sections of the line and not for others";
        found.push(given.finding(problem, "give every section a name, or none"));
    }
    found
}

fn repeats(line: &LineKeys<'_>) -> Option<Finding> {
    let angles = line.repeat_at_deg.given()?;
    let twice = angles.iter().enumerate().find(|(index, angle)| {
        angles[..*index]
            .iter()
            .any(|before| (before - **angle).rem_euclid(360.0) == 0.0)
    });
    twice.map(|(index, angle)| {
        let problem = format!("has {angle} twice");
        line.repeat_at_deg
            .finding_at_item(index, problem, "give every angle once")
    })
}
