//! A line at rest in a current: the discretised line on finer and finer meshes, until two of them agree.

use crate::case::field_at;
use crate::case::{
    Case, Clump, Current, DragCoefficient, End, Ends, Environment, Material, Method, OneOrMany,
    Section,
};
use crate::numerics::V3;
use crate::scene;
use crate::statics::catenary::SectionProperties;
use crate::statics::equilibrium::{EquilibriumSearch, instabilities};

/// A line between two points in a current.
#[derive(Debug, Clone, PartialEq)]
pub struct LineInCurrent {
    /// Ends, z up from still water \[m\].
    pub a_m: [f64; 3],
    /// As `a_m`.
    pub b_m: [f64; 3],
    /// Sections from A to B; bodies between them have no drag.
    pub sections: Vec<SectionProperties>,
    /// Width that drag refers to \[m\].
    pub diameter_m: f64,
    /// Drag coefficient across the line \[-\].
    pub drag_normal: f64,
    /// Drag coefficient along the line, on the diameter \[-\].
    pub drag_tangential: f64,
    /// Density of the water \[kg/m³\].
    pub water_density_kg_per_m3: f64,
    /// Current by depth: depth below still water \[m\] and velocity along x and y \[m/s\]; depths rise, straight lines
    /// in between, constant beyond. One entry is a uniform current.
    pub current: Vec<[f64; 3]>,
}

/// The line's pull on its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EndForces {
    /// On end A \[N\].
    pub a_n: V3,
    /// On end B \[N\].
    pub b_n: V3,
    /// Estimated error of any of these components, from the mesh \[N\].
    pub error_n: f64,
    /// Segments of the finest mesh.
    pub segments: usize,
}

impl EndForces {
    /// Components at A and B, tensions at A and B, error \[N\]; segments.
    pub(super) fn numbers(&self) -> [f64; 10] {
        let (a, b) = (self.a_n, self.b_n);
        let segments = self.segments as f64;
        let (ta, tb) = (a.norm(), b.norm());
        [a.x, a.y, a.z, b.x, b.y, b.z, ta, tb, self.error_n, segments]
    }
}

/// Segments of the first mesh, and of the finest.
const SEGMENTS: usize = 60;
const MOST_SEGMENTS: usize = 1920;
/// Error over the larger end tension: the target, and the greatest that is accepted.
const TARGET: f64 = 1e-5;
const ACCEPTED: f64 = 2e-4;
/// Greatest distance of the ends over the line's length.
const MOST_STRETCH: f64 = 1.5;

const GRAVITY: f64 = 9.806_65;

impl LineInCurrent {
    /// The end forces at rest, by Richardson extrapolation from two meshes whose error falls with the square of the
    /// segment.
    ///
    /// # Errors
    /// What is wrong with the line, or why it has no answer.
    pub fn solve(&self) -> Result<EndForces, String> {
        self.check()?;
        let mut coarse = self.on_mesh(SEGMENTS)?;
        let mut segments = SEGMENTS;
        loop {
            segments *= 2;
            let fine = self.on_mesh(segments)?;
            let part = [0, 1].map(|end| (fine[end] - coarse[end]) / 3.0);
            let error_n = part.iter().map(V3::amax).fold(0.0, f64::max);
            let size = fine[0].norm().max(fine[1].norm());
            if error_n <= TARGET * size || segments >= MOST_SEGMENTS {
                if error_n > ACCEPTED * size {
                    return Err(format!(
                        "not solved: the mesh of {segments} segments still leaves an error of {:.1e} of the end tension",
                        error_n / size
                    ));
                }
                return Ok(EndForces {
                    a_n: fine[0] + part[0],
                    b_n: fine[1] + part[1],
                    error_n,
                    segments,
                });
            }
            coarse = fine;
        }
    }

    /// Every number within the range of its key in a case file, the ends within reach, depths in ascending order.
    fn check(&self) -> Result<(), String> {
        let material = |key, value| in_range(&["materials", "m", key], value);
        material("diameter_m", self.diameter_m)?;
        material("drag_normal", self.drag_normal)?;
        material("drag_tangential", self.drag_tangential)?;
        let density = "water_density_kg_per_m3";
        in_range(&["environment", density], self.water_density_kg_per_m3)?;
        for s in &self.sections {
            in_range(&["line", "s", "length_m"], s.length_m)?;
            material("ea_n", s.ea_n)?;
            material("wet_weight_kg_per_m", s.weight_n_per_m / GRAVITY)?;
            in_range(&["clumps", "c", "wet_mass_kg"], s.clump_n / GRAVITY)?;
        }
        for at in self.a_m.iter().chain(&self.b_m) {
            in_range(&["ends", "b", "position_m"], *at)?;
        }
        for u in &self.current {
            in_range(&["current", "depth_m"], u[0])?;
            in_range(&["current", "speed_m_per_s"], u[1].hypot(u[2]))?;
        }
        if let Some(pair) = self.current.windows(2).find(|u| u[1][0] <= u[0][0]) {
            let (depth, next) = (pair[0][0], pair[1][0]);
            return Err(format!(
                "current: the depths must increase: {next} m follows {depth} m"
            ));
        }
        let (length, distance) = (self.length(), (self.between()).norm());
        if distance > MOST_STRETCH * length {
            return Err(format!(
                "b_m: the ends are {distance:.6} m apart and the line is {length} m long; move them to within {:.6} m",
                MOST_STRETCH * length
            ));
        }
        Ok(())
    }

    fn between(&self) -> V3 {
        V3::from(self.b_m) - V3::from(self.a_m)
    }

    fn length(&self) -> f64 {
        self.sections.iter().map(|s| s.length_m).sum()
    }

    /// Forces on the ends of the line of about so many segments.
    fn on_mesh(&self, segments: usize) -> Result<[V3; 2], String> {
        let scene = scene::build(&self.case(segments), 1).map_err(|e| e.to_string())?;
        let mut state = scene.initial_state();
        EquilibriumSearch::default()
            .run(&scene, 0.0, &mut state)
            .map_err(|e| e.to_string())?;
        match instabilities(&scene, 0.0, &state) {
            Some(0) => {}
            Some(_) => return Err("the equilibrium found is not stable".into()),
            None => return Err("part of the line lies slack; nothing holds it in one shape".into()),
        }
        let last = scene.line_nodes() - 1;
        Ok([scene.end_force(0, &state), scene.end_force(last, &state)])
    }

    /// The line as a case.
    fn case(&self, segments: usize) -> Case {
        let ends = Ends {
            a: End::fixed("a", self.a_m),
            b: End::fixed("b", self.b_m),
        };
        let mut case = Case::new("line", ends);
        case.environment = Environment {
            gravity_m_per_s2: GRAVITY,
            water_density_kg_per_m3: self.water_density_kg_per_m3,
            ..Environment::default()
        };
        case.solver.method = Method::Static;
        case.current = self.current();
        let whole = self.length();
        for (i, s) in self.sections.iter().enumerate() {
            let (name, material) = (format!("s{i}"), format!("m{i}"));
            let share = (segments as f64 * s.length_m / whole).round().max(2.0);
            case.materials.insert(material.clone(), self.material(s));
            if s.clump_n != 0.0 {
                case.clumps.push(clump(i, s));
            }
            let section = Section::new(&name, &material, s.length_m, share as usize);
            case.line.push(section);
        }
        case
    }

    fn material(&self, section: &SectionProperties) -> Material {
        let wet = section.weight_n_per_m / GRAVITY;
        // Mass is for the search alone: any will do.
        let mass = wet.abs().max(1e-3);
        Material {
            wet_weight_kg_per_m: Some(wet),
            drag_normal: DragCoefficient::Constant(self.drag_normal),
            drag_tangential: DragCoefficient::Constant(self.drag_tangential),
            ..Material::new(self.diameter_m, mass, section.ea_n)
        }
    }

    fn current(&self) -> Option<Current> {
        let speed = |u: &[f64; 3]| u[1].hypot(u[2]);
        let direction = |u: &[f64; 3]| u[2].atan2(u[1]).to_degrees();
        match self.current.as_slice() {
            [] => None,
            [one] => Some(Current {
                speed_m_per_s: Some(OneOrMany::One(speed(one))),
                direction_deg: OneOrMany::One(direction(one)),
                depth_m: None,
                file: None,
            }),
            many => Some(Current {
                speed_m_per_s: Some(OneOrMany::Many(many.iter().map(speed).collect())),
                direction_deg: OneOrMany::Many(many.iter().map(direction).collect()),
                depth_m: Some(many.iter().map(|u| u[0]).collect()),
                file: None,
            }),
        }
    }
}

/// The body at the end of a section.
fn clump(i: usize, section: &SectionProperties) -> Clump {
    let wet = section.clump_n / GRAVITY;
    Clump {
        name: format!("c{i}"),
        section: Some(format!("s{i}")),
        at_m: section.length_m,
        mass_kg: wet.abs(),
        wet_mass_kg: wet,
        ..Clump::default()
    }
}

/// `Ok` when a number lies in the range of a key of a case file.
fn in_range(path: &[&str], value: f64) -> Result<(), String> {
    match field_at(path) {
        Some(field) if !field.range.contains(value) => Err(format!(
            "{} is out of range: {value}; give {}",
            field.key(),
            field.range.text(field.unit)
        )),
        _ => Ok(()),
    }
}
