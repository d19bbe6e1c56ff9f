//! How fine mesh and steps are on a level of the search, and the case as fine as that.

use super::super::companions::Coarsening;
use super::super::settings::settings;
use crate::case::{Case, Clump, Method};
use crate::scene;

/// Mesh and steps of a level.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Fineness {
    /// Segments of every section.
    pub(super) segments: Vec<usize>,
    /// Length of the steps by that which the case would take.
    pub(super) steps: f64,
}

/// Segments and steps of the first level, by those of the case. Runs much coarser than this agree with each other although none is
/// right.
pub(super) const COARSEST: usize = 16;

impl Fineness {
    /// That of the first level, or this many times finer where that does not come to its end.
    pub(super) fn first(case: &Case, finer: usize) -> Self {
        let coarsest = (COARSEST / finer).max(1);
        let mut mesh = coarsest;
        while mesh > 1 && !keeps_clumps(case, mesh) {
            mesh /= 2;
        }
        let mut steps = coarsest as f64;
        // A step may err by the size of the line at most.
        while steps > 1.0 && case.solver.step_tolerance * steps.powi(3) > 1.0 {
            steps /= 2.0;
        }
        let segments = case.line.iter();
        Self {
            segments: segments
                .map(|section| section.segments.div_ceil(mesh))
                .collect(),
            steps,
        }
    }

    /// That of the case as it is set.
    pub(super) fn as_set(case: &Case) -> Self {
        Self {
            segments: case.line.iter().map(|section| section.segments).collect(),
            steps: 1.0,
        }
    }

    /// What a run as fine as this takes, by another of the same case \[-\].
    pub(super) fn work(&self) -> f64 {
        self.segments.iter().sum::<usize>() as f64 / self.steps
    }

    /// Twice as fine in this.
    pub(super) fn finer(&self, what: Coarsening) -> Self {
        let mut finer = self.clone();
        match what {
            Coarsening::Steps => finer.steps *= 0.5,
            Coarsening::Mesh => finer.segments.iter_mut().for_each(|n| *n *= 2),
        }
        finer
    }

    /// The case with this mesh and these steps. Explicit steps go with the segments.
    ///
    /// # Errors
    /// Why no scene can be built of the case.
    pub(super) fn applied_to(&self, own: &Case) -> Result<Case, String> {
        let mut case = own.clone();
        for (section, segments) in case.line.iter_mut().zip(&self.segments) {
            section.segments = *segments;
        }
        let solver = &mut case.solver;
        match solver.method {
            Method::Static => {}
            Method::Rk4 => {
                let finest = own.line.iter().zip(&self.segments);
                let finer = finest.map(|(own, now)| *now as f64 / own.segments as f64);
                let finer = finer.fold(0.0, f64::max);
                solver.time_step_s = own.solver.time_step_s.map(|step| step / finer);
            }
            _ => {
                let step = automatic_step(own)? * self.steps;
                if solver.method == Method::Alpha && own.solver.time_step_s.is_none() {
                    solver.longest_step_s = Some(step);
                    solver.step_tolerance *= self.steps.powi(3);
                } else {
                    solver.time_step_s = Some(step);
                }
            }
        }
        Ok(case)
    }
}

/// Whether all clumps hang at nodes of a mesh so many times coarser: one that is moved by half a segment is an error of first order.
fn keeps_clumps(case: &Case, coarser: usize) -> bool {
    const ROUNDING: f64 = 1e-9;
    let is_at_node = |clump: &Clump| {
        let mut sections = case.line.iter();
        let Some(section) = sections.find(|section| section.name == clump.section) else {
            return true;
        };
        let segments = section.segments.div_ceil(coarser) as f64;
        let place = clump.at_m / section.length_m * segments;
        (place - place.round()).abs() < ROUNDING * segments
    };
    case.clumps.iter().all(is_at_node)
}

/// The step of the case as it is, or the longest of those that vary \[s\].
fn automatic_step(own: &Case) -> Result<f64, String> {
    let scene = scene::build(own, 1).map_err(|error| error.to_string())?;
    Ok(settings(own, &scene).time_step_s)
}
