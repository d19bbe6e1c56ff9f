//! What mesh and steps are searched for: a case of a line, or a system of lines in time.

use super::super::computation::Computation;
use super::super::settings::{method_name, settings};
use super::Fineness;
use crate::case::{Case, Clump, Method};
use crate::scene;

/// Steps in time, as a search makes them finer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stepping {
    /// None: at rest.
    None,
    /// Explicit ones, as short as the segments want them.
    BySegments,
    /// Apart from the mesh.
    OfTheirOwn,
}

/// What a search is asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    /// Greatest error of a result by what the result is a part of.
    pub accuracy: f64,
    /// Wall time \[s\]; none where the file sets none.
    pub budget_s: Option<f64>,
}

/// What has a mesh and steps that can be searched for.
pub trait Searchable: Computation {
    /// What its file asks, if it asks for an accuracy.
    fn asked(&self) -> Option<Asked>;

    /// Its steps.
    fn stepping(&self) -> Stepping;

    /// Error that its file allows in a step.
    fn step_tolerance(&self) -> f64;

    /// Segments of every part that is divided by itself.
    fn segments(&self) -> Vec<usize>;

    /// Fewest segments of each of them.
    fn fewest(&self) -> Vec<usize>;

    /// Whether everything stays where it is on a mesh so many times coarser: what is moved by half a segment is an error of first order.
    fn keeps_its_places(&self, coarser: usize) -> bool;

    /// The same as fine as this, with companions coarser in these; asked for no accuracy.
    ///
    /// # Errors
    /// Why it cannot be computed so.
    fn refined(&self, fineness: &Fineness, companions: &[String]) -> Result<Self, String>;

    /// The keys in which one as fine as was found differs, with their values.
    fn found_keys(&self, found: &Self) -> Vec<(String, String)>;
}

impl Searchable for Case {
    fn asked(&self) -> Option<Asked> {
        let budget_s = self.solver.budget_s;
        let asked = |accuracy| Asked { accuracy, budget_s };
        self.solver.accuracy.map(asked)
    }

    fn stepping(&self) -> Stepping {
        match self.solver.method {
            Method::Static => Stepping::None,
            Method::Rk4 => Stepping::BySegments,
            Method::Quasi | Method::Alpha | Method::Auto => Stepping::OfTheirOwn,
        }
    }

    fn step_tolerance(&self) -> f64 {
        self.solver.step_tolerance
    }

    fn segments(&self) -> Vec<usize> {
        self.line.iter().map(|section| section.segments).collect()
    }

    fn fewest(&self) -> Vec<usize> {
        vec![1; self.line.len()]
    }

    fn keeps_its_places(&self, coarser: usize) -> bool {
        const ROUNDING: f64 = 1e-9;
        let is_at_node = |clump: &Clump| {
            let mut sections = self.line.iter();
            let Some(section) = sections.find(|section| section.name == clump.section) else {
                return true;
            };
            let segments = section.segments.div_ceil(coarser) as f64;
            let place = clump.at_m / section.length_m * segments;
            (place - place.round()).abs() < ROUNDING * segments
        };
        self.clumps.iter().all(is_at_node)
    }

    fn refined(&self, fineness: &Fineness, companions: &[String]) -> Result<Self, String> {
        let mut case = self.clone();
        for (section, segments) in case.line.iter_mut().zip(&fineness.segments) {
            section.segments = *segments;
        }
        let solver = &mut case.solver;
        match solver.method {
            Method::Static => {}
            Method::Rk4 => {
                let finer = fineness.finest_by(&self.segments());
                solver.time_step_s = self.solver.time_step_s.map(|step| step / finer);
            }
            _ => {
                let step = automatic_step(self)? * fineness.steps;
                if solver.method == Method::Alpha && self.solver.time_step_s.is_none() {
                    solver.longest_step_s = Some(step);
                    solver.step_tolerance *= fineness.steps.powi(3);
                } else {
                    solver.time_step_s = Some(step);
                }
            }
        }
        solver.companions = Some(companions.to_vec());
        (solver.accuracy, solver.budget_s) = (None, None);
        Ok(case)
    }

    fn found_keys(&self, found: &Self) -> Vec<(String, String)> {
        let sections = self.line.iter().zip(&found.line);
        let divided = sections.filter(|(own, found)| own.segments != found.segments);
        let divided = divided.map(|(_, section)| {
            let key = format!("line.{}.segments", section.name);
            (key, section.segments.to_string())
        });
        let solver = &found.solver;
        let method = (
            "solver.method".to_owned(),
            method_name(solver.method).to_owned(),
        );
        let varies = solver.method == Method::Alpha && solver.time_step_s.is_none();
        divided
            .chain(step_keys(
                varies.then_some(solver.step_tolerance),
                [solver.time_step_s, solver.longest_step_s],
                solver.companions.as_deref(),
            ))
            .chain([method])
            .collect()
    }
}

/// The keys of steps and companions, with their values: the error allowed in a step where steps vary, length of a step and the longest
/// \[s\].
pub fn step_keys(
    step_tolerance: Option<f64>,
    [step, longest]: [Option<f64>; 2],
    companions: Option<&[String]>,
) -> impl Iterator<Item = (String, String)> {
    let numbers = [
        ("solver.step_tolerance", step_tolerance),
        ("solver.time_step_s", step),
        ("solver.longest_step_s", longest),
    ];
    let numbers = numbers
        .into_iter()
        .filter_map(|(key, value)| Some((key.to_owned(), format!("{:?}", value?))));
    let companions = companions.unwrap_or_default();
    numbers.chain([("solver.companions".to_owned(), format!("{companions:?}"))])
}

/// The step of the case as it is, or the longest of those that vary \[s\].
fn automatic_step(own: &Case) -> Result<f64, String> {
    let scene = scene::build(own, 1).map_err(|error| error.to_string())?;
    Ok(settings(own, &scene).time_step_s)
}
