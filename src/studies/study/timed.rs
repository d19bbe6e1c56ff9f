//! What studies compute in other steps and on other meshes: a case of a line, or a system of lines in time.

use std::sync::Arc;

use crate::case::{Case, Method, kind};
use crate::run::accuracy::searchable::{Asked, Searchable};
use crate::run::outlook::StepLengths;
use crate::scene;
use crate::system::SystemFile;
use crate::system::model::{MotionInputs, MotionMethod};
use crate::system::motion::system_in_time::SystemInTime;
use crate::system::solved::solve;

/// How a scene is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TimeMethod {
    /// At rest.
    Static,
    /// In equilibrium at every instant.
    Quasi,
    /// Generalized-alpha.
    Alpha,
    /// Runge-Kutta of order 4.
    Rk4,
    /// Left to the program.
    Auto,
}

/// A method with its steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steps {
    /// The method.
    pub method: TimeMethod,
    /// Length of constant steps \[s\]; none where they vary.
    pub length: Option<f64>,
    /// The longest of those that vary \[s\]; chosen by the program where it is none.
    pub longest: Option<f64>,
    /// Error allowed in a step that varies.
    pub tolerance: f64,
    /// Spectral radius.
    pub rho: f64,
}

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
    /// Its method with its own steps.
    fn steps(&self) -> Steps;

    /// What bounds its steps.
    ///
    /// # Errors
    /// Why it cannot be computed.
    fn bounds(&self) -> Result<StepBounds, String>;

    /// The same in other steps, without companions, asked for no accuracy.
    fn stepped(&self, steps: Steps) -> Self;

    /// The same with companions.
    fn with_companions(&self) -> Self;

    /// The same asked for an accuracy.
    fn asking(&self, asked: Asked) -> Self;

    /// What a run stored as this text, of a file of this name, computed.
    fn of_stored(text: &str, file: &str) -> Option<Self>;

    /// The same with these segments of every part that is divided by itself.
    ///
    /// # Errors
    /// Why it does not come to rest then.
    fn with_segments(&self, segments: &[usize]) -> Result<Self, String>;

    /// The same with so many times the gravity.
    ///
    /// # Errors
    /// Why it does not come to rest then.
    fn heavier(&self, by: f64) -> Result<Self, String>;
}

impl Timed for Case {
    fn steps(&self) -> Steps {
        let solver = &self.solver;
        Steps {
            method: match solver.method {
                Method::Static => TimeMethod::Static,
                Method::Quasi => TimeMethod::Quasi,
                Method::Rk4 => TimeMethod::Rk4,
                Method::Alpha => TimeMethod::Alpha,
                Method::Auto => TimeMethod::Auto,
            },
            length: solver.time_step_s,
            longest: solver.longest_step_s,
            tolerance: solver.step_tolerance,
            rho: solver.rho_inf,
        }
    }

    fn bounds(&self) -> Result<StepBounds, String> {
        let scene = scene::build(self, 1).map_err(|error| error.to_string())?;
        let chosen = |method| {
            let mut open = self.clone();
            (open.solver.method, open.solver.time_step_s) = (method, None);
            crate::run::settings::settings(&open, &scene).time_step_s
        };
        let (explicit_step, chosen) = (chosen(Method::Rk4), chosen(Method::Alpha));
        Ok(StepBounds {
            explicit: scene.explicit_limit().0,
            explicit_step,
            longest: self
                .solver
                .time_step_s
                .map_or(chosen, |own| own.max(chosen)),
            nodes: scene.line.mass.len(),
        })
    }

    fn stepped(&self, steps: Steps) -> Self {
        let mut case = self.clone();
        let solver = &mut case.solver;
        solver.method = match steps.method {
            TimeMethod::Static => Method::Static,
            TimeMethod::Quasi => Method::Quasi,
            TimeMethod::Alpha => Method::Alpha,
            TimeMethod::Rk4 => Method::Rk4,
            TimeMethod::Auto => Method::Auto,
        };
        solver.time_step_s = steps.length;
        solver.longest_step_s = steps.longest;
        (solver.accuracy, solver.budget_s) = (None, None);
        solver.step_tolerance = steps.tolerance;
        solver.rho_inf = steps.rho;
        solver.error_estimate = false;
        case
    }

    fn with_companions(&self) -> Self {
        let mut case = self.clone();
        case.solver.error_estimate = true;
        case
    }

    fn asking(&self, asked: Asked) -> Self {
        let mut case = self.clone();
        case.solver.accuracy = Some(asked.accuracy);
        case.solver.budget_s = asked.budget_s;
        case
    }

    fn of_stored(text: &str, file: &str) -> Option<Self> {
        crate::case::parse(text, file).ok()
    }

    fn with_segments(&self, segments: &[usize]) -> Result<Self, String> {
        let mut case = self.clone();
        for (section, segments) in case.line.iter_mut().zip(segments) {
            section.segments = *segments;
        }
        Ok(case)
    }

    fn heavier(&self, by: f64) -> Result<Self, String> {
        let mut case = self.clone();
        case.environment.gravity_m_per_s2 *= by;
        Ok(case)
    }
}

impl Timed for SystemInTime {
    fn steps(&self) -> Steps {
        Steps {
            method: match self.motion.method {
                MotionMethod::Quasi => TimeMethod::Quasi,
                MotionMethod::Rk4 => TimeMethod::Rk4,
                MotionMethod::Alpha => TimeMethod::Alpha,
                MotionMethod::Auto => TimeMethod::Auto,
            },
            length: self.motion.time_step_s,
            longest: self.motion.longest_step_s,
            tolerance: self.motion.step_tolerance,
            rho: self.motion.rho_inf,
        }
    }

    fn bounds(&self) -> Result<StepBounds, String> {
        let (lengths, chosen, nodes) = self.step_bounds()?;
        let of = |length: fn(&StepLengths) -> f64| lengths.as_ref().map_or(f64::INFINITY, length);
        let own = self.motion.time_step_s;
        Ok(StepBounds {
            explicit: of(|lengths| lengths.limit),
            explicit_step: of(|lengths| lengths.explicit),
            longest: own.map_or(chosen, |own| own.max(chosen)),
            nodes,
        })
    }

    fn stepped(&self, steps: Steps) -> Self {
        self.with(MotionInputs {
            method: match steps.method {
                TimeMethod::Static | TimeMethod::Quasi => MotionMethod::Quasi,
                TimeMethod::Alpha => MotionMethod::Alpha,
                TimeMethod::Rk4 => MotionMethod::Rk4,
                TimeMethod::Auto => MotionMethod::Auto,
            },
            time_step_s: steps.length,
            longest_step_s: steps.longest,
            accuracy: None,
            budget_s: None,
            step_tolerance: steps.tolerance,
            rho_inf: steps.rho,
            error_estimate: false,
            ..self.motion.clone()
        })
    }

    fn with_companions(&self) -> Self {
        self.with(MotionInputs {
            error_estimate: true,
            ..self.motion.clone()
        })
    }

    fn asking(&self, asked: Asked) -> Self {
        self.with(MotionInputs {
            accuracy: Some(asked.accuracy),
            budget_s: asked.budget_s,
            ..self.motion.clone()
        })
    }

    fn of_stored(text: &str, file: &str) -> Option<Self> {
        let solved = kind::parse_stored::<SystemFile>(text, file).ok()?;
        let motion = solved.file.solver.clone()?;
        Some(Self::new(Arc::new(solved), motion))
    }

    fn with_segments(&self, segments: &[usize]) -> Result<Self, String> {
        let mut file = self.solved.file.clone();
        for (line, segments) in file.lines.iter_mut().zip(segments) {
            line.segments = Some(*segments);
        }
        of_file(file, &self.motion)
    }

    fn heavier(&self, by: f64) -> Result<Self, String> {
        let mut file = self.solved.file.clone();
        file.environment.gravity_m_per_s2 *= by;
        of_file(file, &self.motion)
    }
}

/// A scene with so many times the segments.
///
/// # Errors
/// Why it does not come to rest then.
pub fn refined<C: Timed>(scene: &C, by: usize) -> Result<C, String> {
    let segments: Vec<usize> = scene.segments().into_iter().map(|own| by * own).collect();
    scene.with_segments(&segments)
}

fn of_file(file: SystemFile, motion: &MotionInputs) -> Result<SystemInTime, String> {
    let solved = solve(file).map_err(|why| why.problem)?;
    Ok(SystemInTime::new(Arc::new(solved), motion.clone()))
}
