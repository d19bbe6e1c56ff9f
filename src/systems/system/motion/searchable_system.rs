//! A system whose mesh and steps are searched for.

use std::sync::Arc;

use super::settings::MotionSettings;
use super::system_in_time::SystemInTime;
use crate::run::accuracy::fineness::Fineness;
use crate::run::accuracy::searchable::{Asked, Searchable, Stepping, step_keys};
use crate::system::discretised::{FEWEST, SEGMENTS};
use crate::system::model::MotionMethod;
use crate::system::solved::solve;

impl Searchable for SystemInTime {
    fn asked(&self) -> Option<Asked> {
        let budget_s = self.motion.budget_s;
        let asked = |accuracy| Asked { accuracy, budget_s };
        self.motion.accuracy.map(asked)
    }

    fn stepping(&self) -> Stepping {
        match self.motion.method {
            MotionMethod::Rk4 => Stepping::BySegments,
            MotionMethod::Alpha | MotionMethod::Auto | MotionMethod::Quasi => Stepping::OfTheirOwn,
        }
    }

    fn step_tolerance(&self) -> f64 {
        self.motion.step_tolerance
    }

    fn segments(&self) -> Vec<usize> {
        let lines = self.solved.file.lines.iter().zip(self.fewest());
        lines
            .map(|(line, fewest)| line.segments.unwrap_or(SEGMENTS).max(fewest))
            .collect()
    }

    fn fewest(&self) -> Vec<usize> {
        let lines = self.solved.file.lines.iter();
        lines
            .map(|line| FEWEST * line.sections.len().max(1))
            .collect()
    }

    /// What hangs on a line hangs where its sections meet, which are nodes of every mesh.
    fn keeps_its_places(&self, _: usize) -> bool {
        true
    }

    fn refined(&self, fineness: &Fineness, companions: &[String]) -> Result<Self, String> {
        let begun = self.begun().map_err(|why| why.problem)?;
        let own = MotionSettings::new(&self.motion, 1.0, &begun.system).time_step_s;
        let mut file = self.solved.file.clone();
        for (line, segments) in file.lines.iter_mut().zip(&fineness.segments) {
            line.segments = Some(*segments);
        }
        let mut motion = self.motion.clone();
        match motion.method {
            MotionMethod::Rk4 => {
                let finer = fineness.finest_by(&self.segments());
                motion.time_step_s = motion.time_step_s.map(|step| step / finer);
            }
            MotionMethod::Alpha if motion.time_step_s.is_none() => {
                motion.longest_step_s = Some(own * fineness.steps);
                motion.step_tolerance *= fineness.steps.powi(3);
            }
            _ => motion.time_step_s = Some(own * fineness.steps),
        }
        motion.companions = Some(companions.to_vec());
        (motion.accuracy, motion.budget_s) = (None, None);
        file.solver = Some(motion.clone());
        let solved = solve(file).map_err(|why| why.problem)?;
        Ok(Self::new(Arc::new(solved), motion))
    }

    fn found_keys(&self, found: &Self) -> Vec<(String, String)> {
        let lines = self.solved.file.lines.iter().zip(found.segments());
        let divided = lines.filter(|(own, found)| own.segments != Some(*found));
        let divided = divided
            .map(|(line, found)| (format!("lines.{}.segments", line.name), found.to_string()));
        let motion = &found.motion;
        let varies = motion.method == MotionMethod::Alpha && motion.time_step_s.is_none();
        let method = ("solver.method".to_owned(), motion.method.name().to_owned());
        divided
            .chain(step_keys(
                varies.then_some(motion.step_tolerance),
                [motion.time_step_s, motion.longest_step_s],
                motion.companions.as_deref(),
            ))
            .chain([method])
            .collect()
    }
}
