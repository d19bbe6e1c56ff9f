//! A line at rest in a current: the discretised line on finer and finer meshes, until two of them agree.

use std::fmt::Write;

use crate::case;
use crate::numerics::V3;
use crate::scene;
use crate::statics::catenary::SectionProps;
use crate::statics::equilibrium::{EquilibriumSearch, instabilities};

/// A line between two points in a current.
#[derive(Debug, Clone, PartialEq)]
pub struct InCurrent {
    /// Ends, z up from still water \[m\].
    pub a_m: [f64; 3],
    /// As `a_m`.
    pub b_m: [f64; 3],
    /// Sections from A to B; bodies between them have no drag.
    pub sections: Vec<SectionProps>,
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
pub struct Pulls {
    /// On end A \[N\].
    pub a_n: V3,
    /// On end B \[N\].
    pub b_n: V3,
    /// Estimated error of any of these components, from the mesh \[N\].
    pub error_n: f64,
    /// Segments of the finest mesh.
    pub segments: usize,
}

/// Segments of the first mesh, and the most that are tried.
const SEGMENTS: usize = 60;
const MOST: usize = 1920;
/// Error over the larger end tension that is gone for, and that is given out at all.
const AIM: f64 = 1e-5;
const BELIEVED: f64 = 2e-4;

impl InCurrent {
    /// The pulls at rest, from two meshes whose error falls with the square of the segment.
    ///
    /// # Errors
    /// What is wrong with the line, or why it has no answer, in words.
    pub fn solve(&self) -> Result<Pulls, String> {
        let mut coarse = self.on_mesh(SEGMENTS)?;
        let mut segments = SEGMENTS;
        loop {
            segments *= 2;
            let fine = self.on_mesh(segments)?;
            let part = [0, 1].map(|end| (fine[end] - coarse[end]) / 3.0);
            let error_n = part.iter().map(V3::amax).fold(0.0, f64::max);
            let size = fine[0].norm().max(fine[1].norm());
            if error_n <= AIM * size || segments >= MOST {
                if error_n > BELIEVED * size {
                    return Err(format!(
                        "not solved: the mesh of {segments} segments still leaves an error of {:.1e} of the end tension",
                        error_n / size
                    ));
                }
                return Ok(Pulls {
                    a_n: fine[0] + part[0],
                    b_n: fine[1] + part[1],
                    error_n,
                    segments,
                });
            }
            coarse = fine;
        }
    }

    /// Pulls on the ends of the line of about so many segments.
    fn on_mesh(&self, segments: usize) -> Result<[V3; 2], String> {
        let case = case::parse(&self.case(segments), "line").map_err(|found| {
            let told = found
                .first()
                .map(|d| format!("{}: {}; {}", d.key, d.problem, d.remedy));
            told.unwrap_or_default()
        })?;
        let scene = scene::build(&case, 1).map_err(|e| e.to_string())?;
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

    /// The line in the words of a case.
    fn case(&self, segments: usize) -> String {
        const G: f64 = 9.806_65;
        let mut text = format!(
            "[case]\ntitle = \"line\"\n[environment]\ngravity_m_per_s2 = {G:?}\nwater_density_kg_per_m3 = {:?}\n",
            self.water_density_kg_per_m3
        );
        text += "[solver]\nmethod = \"static\"\n";
        text += &self.current_in_words();
        let whole: f64 = self.sections.iter().map(|s| s.length_m).sum();
        for (i, s) in self.sections.iter().enumerate() {
            let share = (segments as f64 * s.length_m / whole).round().max(2.0);
            let wet = s.weight_n_per_m / G;
            // Mass is for the search alone: any will do.
            let _ = write!(
                text,
                "[materials.m{i}]\ndiameter_m = {:?}\nmass_kg_per_m = {:?}\nwet_weight_kg_per_m = {wet:?}\nea_n = {:?}\n\
                 drag_normal = {:?}\ndrag_tangential = {:?}\n[[line]]\nname = \"s{i}\"\nmaterial = \"m{i}\"\n\
                 length_m = {:?}\nsegments = {share:.0}\n",
                self.diameter_m,
                wet.abs().max(1e-3),
                s.ea_n,
                self.drag_normal,
                self.drag_tangential,
                s.length_m
            );
            if s.clump_n != 0.0 {
                let wet = s.clump_n / G;
                let _ = write!(
                    text,
                    "[[clumps]]\nname = \"c{i}\"\nsection = \"s{i}\"\nat_m = {:?}\nmass_kg = {:?}\nwet_mass_kg = {wet:?}\n",
                    s.length_m,
                    wet.abs()
                );
            }
        }
        for (end, at) in [("a", self.a_m), ("b", self.b_m)] {
            let _ = write!(
                text,
                "[ends.{end}]\nname = \"{end}\"\nkind = \"fixed\"\nposition_m = {at:?}\n"
            );
        }
        text
    }

    fn current_in_words(&self) -> String {
        let speed = |u: &[f64; 3]| u[1].hypot(u[2]);
        let turn = |u: &[f64; 3]| u[2].atan2(u[1]).to_degrees();
        match self.current.as_slice() {
            [] => String::new(),
            [one] => format!(
                "[current]\nspeed_m_per_s = {:?}\ndirection_deg = {:?}\n",
                speed(one),
                turn(one)
            ),
            many => {
                // Between two depths velocity goes straight from one to the other, whatever the words.
                let list =
                    |of: &dyn Fn(&[f64; 3]) -> f64| many.iter().map(of).collect::<Vec<f64>>();
                format!(
                    "[current]\ndepth_m = {:?}\nspeed_m_per_s = {:?}\ndirection_deg = {:?}\n",
                    list(&|u| u[0]),
                    list(&speed),
                    list(&turn)
                )
            }
        }
    }
}
