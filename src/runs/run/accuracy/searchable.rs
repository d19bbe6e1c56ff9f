//! What mesh and steps are searched for: a case of a line, or a system of lines in time.

use super::super::computation::Computation;
use super::super::line_bounds::settings;
use super::Fineness;
use super::steps::Steps;
use crate::case::{Case, Clump, Method, OnSection};
use crate::scene;

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
    fn steps(&self) -> Steps;

    /// Length of the steps that it takes, or of the longest of those that vary \[s\].
    ///
    /// # Errors
    /// Why it cannot be computed.
    fn chosen_step(&self) -> Result<f64, String>;

    /// The same in other steps.
    fn stepped(&self, steps: Steps) -> Self;

    /// Segments of every part that is divided by itself.
    fn segments(&self) -> Vec<usize>;

    /// Fewest segments of each of them.
    fn fewest(&self) -> Vec<usize>;

    /// The key of the segments of each of them.
    fn segment_keys(&self) -> Vec<String>;

    /// The same with these segments of each of them.
    ///
    /// # Errors
    /// Why it does not come to rest then.
    fn with_segments(&self, segments: &[usize]) -> Result<Self, String>;

    /// Whether everything stays where it is on a mesh so many times coarser: what is moved by half a segment is an error of first order.
    fn keeps_its_places(&self, coarser: usize) -> bool;

    /// The companions that its file names, from the finest, each by what is coarser in it.
    fn companions(&self) -> &[String];

    /// The same with these companions, asked for no accuracy.
    fn found_with(&self, companions: &[String]) -> Self;

    /// Whether it has steps that are refined beside the mesh: at rest there are none, and explicit ones go with the segments, where there
    /// are any.
    fn has_own_steps(&self) -> bool {
        match self.steps().method {
            Method::Static => false,
            Method::Rk4 => self.segments().is_empty(),
            Method::Quasi | Method::Alpha | Method::Auto => true,
        }
    }

    /// The same as fine as this, with companions coarser in these; asked for no accuracy.
    ///
    /// # Errors
    /// Why it cannot be computed so.
    fn refined(&self, fineness: &Fineness, companions: &[String]) -> Result<Self, String> {
        let mut steps = self.steps();
        if self.has_own_steps() {
            let step = self.chosen_step()? * fineness.steps;
            if steps.vary() {
                steps.longest = Some(step);
                steps.tolerance *= fineness.steps.powi(3);
            } else {
                steps.length = Some(step);
            }
        } else {
            let finer = fineness.finest_by(&self.segments());
            steps.length = steps.length.map(|step| step / finer);
        }
        let divided = self.with_segments(&fineness.segments)?;
        Ok(divided.stepped(steps).found_with(companions))
    }

    /// The keys that make it so many times as fine, in segments and in steps of its own, with their values.
    ///
    /// # Errors
    /// Why it cannot be computed so.
    fn finer_keys(&self, finer: usize) -> Result<Vec<(String, String)>, String> {
        let own = self.segments();
        let fineness = Fineness {
            segments: own.iter().map(|segments| segments * finer).collect(),
            steps: 1.0 / finer as f64,
        };
        let found = self.refined(&fineness, self.companions())?;
        let divided = self.segment_keys().into_iter().zip(&fineness.segments);
        let divided = divided.map(|(key, segments)| (key, segments.to_string()));
        let steps = found.steps();
        let steps = steps.keys().filter(|_| self.is_stepped());
        Ok(divided.chain(steps).collect())
    }

    /// Whether it takes steps.
    fn is_stepped(&self) -> bool {
        self.steps().method != Method::Static
    }

    /// The keys in which one as fine as was found differs, with their values.
    fn found_keys(&self, found: &Self) -> Vec<(String, String)> {
        let parts = self.segments().into_iter().zip(found.segments());
        let divided = self.segment_keys().into_iter().zip(parts);
        let divided = divided.filter(|(_, (own, found))| own != found);
        let divided = divided.map(|(key, (_, found))| (key, found.to_string()));
        let companions = format!("{:?}", found.companions());
        divided
            .chain(found.steps().keys())
            .chain([
                ("solver.companions".to_owned(), companions),
                ("solver.method".to_owned(), found.method().to_owned()),
            ])
            .collect()
    }
}

impl Searchable for Case {
    fn asked(&self) -> Option<Asked> {
        let budget_s = self.solver.budget_s;
        let asked = |accuracy| Asked { accuracy, budget_s };
        self.solver.accuracy.map(asked)
    }

    fn steps(&self) -> Steps {
        let solver = &self.solver;
        Steps {
            method: solver.method,
            length: solver.time_step_s,
            longest: solver.longest_step_s,
            tolerance: solver.step_tolerance,
            rho: solver.rho_inf,
        }
    }

    fn chosen_step(&self) -> Result<f64, String> {
        let scene = scene::build(self, 1).map_err(|error| error.to_string())?;
        Ok(settings(self, &scene).time_step_s)
    }

    fn stepped(&self, steps: Steps) -> Self {
        let mut case = self.clone();
        let solver = &mut case.solver;
        solver.method = steps.method;
        solver.time_step_s = steps.length;
        solver.longest_step_s = steps.longest;
        solver.step_tolerance = steps.tolerance;
        solver.rho_inf = steps.rho;
        case
    }

    fn segments(&self) -> Vec<usize> {
        self.line.iter().map(|section| section.segments).collect()
    }

    fn fewest(&self) -> Vec<usize> {
        vec![1; self.line.len()]
    }

    fn segment_keys(&self) -> Vec<String> {
        let sections = self.line.iter();
        sections
            .map(|section| format!("line.{}.segments", section.name))
            .collect()
    }

    fn with_segments(&self, segments: &[usize]) -> Result<Self, String> {
        let mut case = self.clone();
        for (section, segments) in case.line.iter_mut().zip(segments) {
            section.segments = *segments;
        }
        Ok(case)
    }

    fn keeps_its_places(&self, coarser: usize) -> bool {
        const ROUNDING: f64 = 1e-9;
        let is_at_node = |clump: &Clump| {
            let mut sections = self.line.iter();
            let Some(section) = sections.find(|section| clump.is_on(Some(&section.name))) else {
                return true;
            };
            let segments = section.segments.div_ceil(coarser) as f64;
            let place = clump.at_m / section.length_m * segments;
            (place - place.round()).abs() < ROUNDING * segments
        };
        self.clumps.iter().all(is_at_node)
    }

    fn companions(&self) -> &[String] {
        self.solver.companions.as_deref().unwrap_or_default()
    }

    fn found_with(&self, companions: &[String]) -> Self {
        let mut case = self.clone();
        case.solver.companions = Some(companions.to_vec());
        (case.solver.accuracy, case.solver.budget_s) = (None, None);
        case
    }
}
