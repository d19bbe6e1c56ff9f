//! What studies compute in other steps and on other meshes: a case of a line, or a system of lines in time or at rest.

use std::sync::Arc;

use crate::case::{Case, Method, Solver};
use crate::run::accuracy::searchable::{Asked, Searchable};
use crate::run::line_bounds::bounds;
use crate::run::settings::SceneBounds;
use crate::scene;
use crate::system::at_rest::SystemAtRest;
use crate::system::motion::system_in_time::SystemInTime;
use crate::system::solved::solve;

/// What bounds the steps of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepBounds {
    /// The stability limit of explicit steps \[s\]; infinite where no segment binds them.
    pub explicit: f64,
    /// The explicit step chosen for it \[s\].
    pub explicit_step: f64,
    /// The longest step that suits it \[s\]: its own, or the one chosen for it.
    pub longest: f64,
    /// Number of nodes.
    pub nodes: usize,
}

/// A scene that is computed in other steps.
pub trait Timed: Searchable {
    /// What bounds its steps.
    ///
    /// # Errors
    /// Why it cannot be computed.
    fn bounds(&self) -> Result<StepBounds, String>;

    /// The same with companions or without, asked for no accuracy.
    fn estimating(&self, errors: bool) -> Self;

    /// The same asked for an accuracy.
    fn asking(&self, asked: Asked) -> Self;

    /// The same with so many times the gravity.
    ///
    /// # Errors
    /// Why it does not come to rest then.
    fn heavier(&self, by: f64) -> Result<Self, String>;
}

impl StepBounds {
    /// By what bounds the steps of a scene, and what its file asks.
    fn new(scene: &SceneBounds, solver: &Solver) -> Self {
        let alpha = Solver {
            method: Method::Alpha,
            ..solver.clone()
        };
        let chosen = scene.chosen_step(&alpha);
        let is_bound = scene.nodes > 0;
        let explicit = |of: f64| if is_bound { of } else { f64::INFINITY };
        let limit = scene.stability.as_ref().map_or(f64::INFINITY, |own| own.0);
        Self {
            explicit: explicit(limit),
            explicit_step: explicit(scene.explicit_step()),
            longest: solver.time_step_s.map_or(chosen, |own| own.max(chosen)),
            nodes: scene.nodes,
        }
    }
}

impl Timed for Case {
    fn bounds(&self) -> Result<StepBounds, String> {
        let scene = scene::build(self, 1).map_err(|error| error.to_string())?;
        Ok(StepBounds::new(&bounds(self, &scene), &self.solver))
    }

    fn estimating(&self, errors: bool) -> Self {
        let mut case = self.clone();
        case.solver.error_estimate = errors;
        (case.solver.accuracy, case.solver.budget_s) = (None, None);
        case
    }

    fn asking(&self, asked: Asked) -> Self {
        let mut case = self.clone();
        case.solver.accuracy = Some(asked.accuracy);
        case.solver.budget_s = asked.budget_s;
        case
    }

    fn heavier(&self, by: f64) -> Result<Self, String> {
        let mut case = self.clone();
        case.environment.gravity_m_per_s2 *= by;
        Ok(case)
    }
}

impl Timed for SystemInTime {
    fn bounds(&self) -> Result<StepBounds, String> {
        Ok(StepBounds::new(&self.step_bounds()?, &self.motion))
    }

    fn estimating(&self, errors: bool) -> Self {
        self.with(Solver {
            error_estimate: errors,
            accuracy: None,
            budget_s: None,
            ..self.motion.clone()
        })
    }

    fn asking(&self, asked: Asked) -> Self {
        self.with(Solver {
            accuracy: Some(asked.accuracy),
            budget_s: asked.budget_s,
            ..self.motion.clone()
        })
    }

    fn heavier(&self, by: f64) -> Result<Self, String> {
        let mut file = self.solved.file.clone();
        file.environment.gravity_m_per_s2 *= by;
        let solved = solve(file).map_err(|why| why.problem)?;
        Ok(Self::new(Arc::new(solved), self.motion.clone()))
    }
}

impl Timed for SystemAtRest {
    /// Nothing is marched, and nothing bounds a step.
    fn bounds(&self) -> Result<StepBounds, String> {
        Ok(StepBounds {
            explicit: f64::INFINITY,
            explicit_step: f64::INFINITY,
            longest: f64::INFINITY,
            nodes: self.segments().into_iter().sum(),
        })
    }

    fn estimating(&self, errors: bool) -> Self {
        Self::asking(self, None, errors)
    }

    fn asking(&self, asked: Asked) -> Self {
        Self::asking(self, Some(asked), true)
    }

    fn heavier(&self, by: f64) -> Result<Self, String> {
        Ok(self.with_file(|file| file.environment.gravity_m_per_s2 *= by))
    }
}

/// A scene with so many times the segments.
///
/// # Errors
/// Why it does not come to rest then.
pub fn divided<C: Timed>(scene: &C, by: usize) -> Result<C, String> {
    let segments: Vec<usize> = scene.segments().into_iter().map(|own| by * own).collect();
    scene.with_segments(&segments)
}
