//! A system whose mesh and steps are searched for.

use std::sync::Arc;

use super::system_in_time::SystemInTime;
use crate::case::Solver;
use crate::run::accuracy::searchable::{Asked, Searchable};
use crate::run::accuracy::steps::Steps;
use crate::system::discretised::{FEWEST, keeps_its_places};
use crate::system::solved::solve;

impl Searchable for SystemInTime {
    fn asked(&self) -> Option<Asked> {
        let budget_s = self.motion.budget_s;
        let asked = |accuracy| Asked { accuracy, budget_s };
        self.motion.accuracy.map(asked)
    }

    fn steps(&self) -> Steps {
        Steps {
            method: self.motion.method,
            length: self.motion.time_step_s,
            longest: self.motion.longest_step_s,
            tolerance: self.motion.step_tolerance,
            rho: self.motion.rho_inf,
        }
    }

    fn chosen_step(&self) -> Result<f64, String> {
        let begun = self.begun().map_err(|why| why.problem)?;
        Ok(self.plan(begun).settings.time_step_s)
    }

    fn stepped(&self, steps: Steps) -> Self {
        self.with(Solver {
            method: steps.method,
            time_step_s: steps.length,
            longest_step_s: steps.longest,
            step_tolerance: steps.tolerance,
            rho_inf: steps.rho,
            ..self.motion.clone()
        })
    }

    fn segments(&self) -> Vec<usize> {
        let lines = self.solved.file.lines.iter().zip(self.fewest());
        lines
            .map(|(line, fewest)| line.wanted_segments().max(fewest))
            .collect()
    }

    fn fewest(&self) -> Vec<usize> {
        let lines = self.solved.file.lines.iter();
        lines
            .map(|line| FEWEST * line.sections.len().max(1))
            .collect()
    }

    fn segment_keys(&self) -> Vec<String> {
        let lines = self.solved.file.lines.iter();
        lines
            .map(|line| format!("lines.{}.segments", line.name))
            .collect()
    }

    fn with_segments(&self, segments: &[usize]) -> Result<Self, String> {
        let mut file = self.solved.file.clone();
        for (line, segments) in file.lines.iter_mut().zip(segments) {
            line.segments = Some(*segments);
        }
        let solved = solve(file).map_err(|why| why.problem)?;
        Ok(Self::new(Arc::new(solved), self.motion.clone()))
    }

    /// Where sections of a line meet is a node of every mesh.
    fn keeps_its_places(&self, coarser: usize) -> bool {
        let file = &self.solved.file;
        let mut lines = file.lines.iter();
        lines.all(|line| keeps_its_places(file, line, coarser))
    }

    fn companions(&self) -> &[String] {
        self.motion.companions.as_deref().unwrap_or_default()
    }

    fn found_with(&self, companions: &[String]) -> Self {
        self.with(Solver {
            companions: Some(companions.to_vec()),
            accuracy: None,
            budget_s: None,
            ..self.motion.clone()
        })
    }
}
