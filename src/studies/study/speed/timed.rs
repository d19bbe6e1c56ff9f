//! What steps are measured on: a case of a line, or a system of lines in time.

use std::sync::Arc;

use crate::case::{Case, Method};
use crate::run::accuracy::searchable::Searchable;
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
    /// Generalized-alpha, or left to the program.
    Alpha,
    /// Runge-Kutta of order 4.
    Rk4,
}

/// A method with its steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steps {
    /// The method.
    pub method: TimeMethod,
    /// Length of constant steps \[s\]; none where they vary.
    pub length: Option<f64>,
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

/// A scene in time whose steps are measured.
pub trait Timed: Searchable {
    /// Its method with its own steps.
    fn steps(&self) -> Steps;

    /// What bounds its steps.
    ///
    /// # Errors
    /// Why it cannot be computed.
    fn bounds(&self) -> Result<StepBounds, String>;

    /// The same in other steps, without companions.
    fn stepped(&self, steps: Steps) -> Self;

    /// The same with companions.
    fn with_companions(&self) -> Self;

    /// The same with so many times the segments.
    ///
    /// # Errors
    /// Why it does not come to rest then.
    fn divided(&self, by: usize) -> Result<Self, String>;

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
                Method::Alpha | Method::Auto => TimeMethod::Alpha,
            },
            length: solver.time_step_s,
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
        };
        solver.time_step_s = steps.length;
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

    fn divided(&self, by: usize) -> Result<Self, String> {
        let mut case = self.clone();
        for section in &mut case.line {
            section.segments *= by;
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
                MotionMethod::Alpha | MotionMethod::Auto => TimeMethod::Alpha,
            },
            length: self.motion.time_step_s,
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
            },
            time_step_s: steps.length,
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

    fn divided(&self, by: usize) -> Result<Self, String> {
        let mut file = self.solved.file.clone();
        for (line, own) in file.lines.iter_mut().zip(self.segments()) {
            line.segments = Some(by * own);
        }
        of_file(file, &self.motion)
    }

    fn heavier(&self, by: f64) -> Result<Self, String> {
        let mut file = self.solved.file.clone();
        file.environment.gravity_m_per_s2 *= by;
        of_file(file, &self.motion)
    }
}

fn of_file(file: SystemFile, motion: &MotionInputs) -> Result<SystemInTime, String> {
    let solved = solve(file).map_err(|why| why.problem)?;
    Ok(SystemInTime::new(Arc::new(solved), motion.clone()))
}
