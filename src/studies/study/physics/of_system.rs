//! The effects of a system of lines in time.

use std::collections::BTreeMap;

use super::of_line::{
    clear, clear_given, flatten, without_added_mass_on_line, without_drag_on_line,
};
use super::of_material::{self, HasMaterials};
use super::{HasEffects, ScenePart};
use crate::case::Method;
use crate::case::{Material, WaterSurface};
use crate::system::SystemFile;
use crate::system::model::{BodyInputs, LineSection, PointInputs};

impl HasMaterials for SystemFile {
    fn materials(&mut self) -> &mut BTreeMap<String, Material> {
        &mut self.materials
    }
}

impl HasEffects for SystemFile {
    const KEPT: &'static [(&'static str, &'static str)] = &[
        (
            "weight and buoyancy",
            "they hold the system in its place; without them nothing is left to compute",
        ),
        (
            "elasticity",
            "segments have a finite stiffness; lines with ten times the stiffness stand for ones that do not stretch",
        ),
        (
            "sea bed",
            "without it another system is computed; its friction and damping are left out one by one",
        ),
        (
            "bodies and points",
            "their weight is a load of the system; their drag, added mass and damping are left out one by one",
        ),
    ];

    fn parts() -> Vec<ScenePart<Self>> {
        [&of_material::parts()[..], &PARTS].concat()
    }

    fn forget_what_it_says_of_itself(&mut self) {
        self.marks.clear();
        self.published.clear();
        self.published_curve.clear();
        self.study.clear();
        self.trend.clear();
        self.trial.clear();
        self.load_cases.clear();
        self.checks.clear();
        self.goals.clear();
        self.offset_curves.clear();
        self.watch_circles.clear();
    }
}

const PARTS: [ScenePart<SystemFile>; 15] = [
    ScenePart::new(
        "drag of bodies",
        "drag areas of points, clumps and bodies, drag of members and rods = 0",
        without_body_drag,
    ),
    ScenePart::new(
        "added mass of bodies",
        "added masses of points, clumps, bodies, members and rods = 0",
        without_body_added_mass,
    ),
    ScenePart::new(
        "damping of bodies",
        "bodies.*.damping, quadratic_damping left out",
        |system| {
            for body in system.bodies.values_mut() {
                body.damping.clear();
                body.quadratic_damping.clear();
            }
        },
    ),
    ScenePart::new(
        "bed friction",
        "friction of the bed under lines, points and bodies = 0",
        without_friction,
    ),
    ScenePart::new("bed damping", "seabed.damping_n_s_per_m3 = 0", |system| {
        let bed = system.seabed.iter_mut();
        bed.for_each(|bed| bed.damping_n_s_per_m3 = 0.0);
    }),
    ScenePart::new(
        "current",
        "current, and the loads of bodies by it, left out",
        |system| {
            system.current = None;
            let bodies = system.bodies.values_mut();
            bodies.for_each(|body| body.current_loads.clear());
        },
    ),
    ScenePart::new(
        "wind",
        "wind, and the loads of bodies by it, left out",
        |system| {
            system.wind = None;
            let bodies = system.bodies.values_mut();
            bodies.for_each(|body| body.wind_loads.clear());
        },
    ),
    ScenePart::new("waves", "height of the waves = 0", |system| {
        system.waves.iter_mut().for_each(flatten);
    }),
    ScenePart::new(
        "mean drift of waves",
        "bodies.*.drift_file, drift_loads left out",
        |system| {
            for body in system.bodies.values_mut() {
                body.drift_file = None;
                body.drift_loads.clear();
            }
        },
    ),
    ScenePart::new(
        "water surface",
        "environment.water_surface = ignored",
        |system| system.environment.water_surface = WaterSurface::Ignored,
    ),
    ScenePart::new(
        "prescribed motion",
        "amplitudes and tables of points and bodies left out: they stay",
        |system| {
            system.points.values_mut().for_each(still_point);
            system.bodies.values_mut().for_each(still_body);
        },
    ),
    ScenePart::new("ageing", "[ageing] left out", |system| system.ageing = None),
    ScenePart::new("inertia", "solver.method = quasi", |system| {
        let motion = system
            .solver
            .iter_mut()
            .filter(|solver| solver.is_in_time());
        motion.for_each(|motion| motion.method = Method::Quasi);
    }),
    ScenePart::new("mesh halved", "lines.*.segments halved", |system| {
        divide(system, |segments| segments.div_ceil(2));
    }),
    ScenePart::new("mesh doubled", "lines.*.segments doubled", |system| {
        divide(system, |segments| 2 * segments);
    }),
];

/// The sections of all lines, with the clumps at their ends.
fn sections(system: &mut SystemFile) -> impl Iterator<Item = &mut LineSection> {
    let lines = system.lines.iter_mut();
    lines.flat_map(|line| line.sections.iter_mut())
}

fn without_body_drag(system: &mut SystemFile) {
    for point in system.points.values_mut() {
        clear_given(&mut point.drag_area_m2, point.shape.as_ref());
    }
    for section in sections(system) {
        clear(&mut section.clump_drag_area_m2);
        section.clump_drag_area_normal_m2 = 0.0;
        section.clump_drag_area_tangential_m2 = 0.0;
    }
    for line in &mut system.lines {
        without_drag_on_line(&mut line.clumps, &mut line.floats, &mut line.modules);
    }
    for body in system.bodies.values_mut() {
        body.drag_area_m2 = [0.0; 3];
        for member in &mut body.members {
            (member.drag_normal, member.drag_end) = (0.0, 0.0);
            member.to_drag_end = None;
        }
    }
    for rod in system.rods.values_mut() {
        (rod.drag_normal, rod.drag_end) = (0.0, 0.0);
    }
}

fn without_body_added_mass(system: &mut SystemFile) {
    for point in system.points.values_mut() {
        clear_given(&mut point.added_mass_kg, point.shape.as_ref());
    }
    for section in sections(system) {
        clear(&mut section.clump_added_mass_kg);
        section.clump_added_mass_normal_kg = 0.0;
        section.clump_added_mass_tangential_kg = 0.0;
    }
    for line in &mut system.lines {
        without_added_mass_on_line(&mut line.clumps, &mut line.floats);
    }
    for body in system.bodies.values_mut() {
        body.added_mass.clear();
        for member in &mut body.members {
            (member.added_mass_normal, member.added_mass_end) = (0.0, 0.0);
            member.to_added_mass_end = None;
        }
    }
    for rod in system.rods.values_mut() {
        (rod.added_mass_normal, rod.added_mass_end) = (0.0, 0.0);
    }
}

fn without_friction(system: &mut SystemFile) {
    let bed = system.seabed.iter_mut();
    bed.for_each(|bed| (bed.friction, bed.friction_lateral) = (bed.friction.map(|_| 0.0), None));
    for line in &mut system.lines {
        (line.friction, line.friction_lateral) = (line.friction.map(|_| 0.0), None);
    }
    for point in system.points.values_mut() {
        point.bed_friction = 0.0;
    }
    for body in system.bodies.values_mut() {
        body.bed_friction = 0.0;
    }
}

fn still_point(point: &mut PointInputs) {
    point.amplitude_m = [0.0; 3];
    point.period_s = None;
    (point.rms_m, point.peak_period_s) = ([0.0; 3], None);
    let columns = [
        &mut point.table_time_s,
        &mut point.table_x_m,
        &mut point.table_y_m,
        &mut point.table_z_m,
    ];
    columns.into_iter().for_each(Vec::clear);
}

fn still_body(body: &mut BodyInputs) {
    (body.amplitude_m, body.amplitude_deg) = ([0.0; 3], [0.0; 3]);
    let columns = [
        &mut body.period_s,
        &mut body.phase_deg,
        &mut body.table_time_s,
        &mut body.table_x_m,
        &mut body.table_y_m,
        &mut body.table_z_m,
        &mut body.table_roll_deg,
        &mut body.table_pitch_deg,
        &mut body.table_yaw_deg,
    ];
    columns.into_iter().for_each(Vec::clear);
}

fn divide(system: &mut SystemFile, segments: impl Fn(usize) -> usize) {
    for line in &mut system.lines {
        line.segments = Some(segments(line.wanted_segments()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::read_file::read_with;
    use crate::case::shipped::SYSTEMS;

    /// What is left of every shipped system is a system, or refused with a reason; leaving out twice changes nothing more.
    #[test]
    fn effects_of_shipped_systems_are_left_out() {
        let parts = SystemFile::parts();
        let mut seen = vec![0; parts.len()];
        for (path, text) in SYSTEMS {
            let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/");
            let read = read_with::<SystemFile>(text, &[], format!("{folder}{path}").as_ref());
            let system = read.unwrap().content;
            for (place, part) in parts.iter().enumerate() {
                let mut without = system.clone();
                (part.leave_out)(&mut without);
                seen[place] += usize::from(without != system);
                if !["elasticity", "mesh halved", "mesh doubled"].contains(&part.effect.name) {
                    let mut twice = without.clone();
                    (part.leave_out)(&mut twice);
                    assert!(twice == without, "{path}: {}", part.effect.name);
                }
            }
        }
        let unseen: Vec<&str> = parts
            .iter()
            .zip(seen)
            .filter(|(_, seen)| *seen == 0)
            .map(|(part, _)| part.effect.name)
            .collect();
        // No system that is shipped bends, is damped by its mass, or is in a wind.
        let absent = [
            "bending stiffness",
            "mass damping",
            "dynamic stiffness",
            "wind",
        ];
        assert_eq!(unseen, absent);
    }
}
