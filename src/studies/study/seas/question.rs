//! What is asked of the seas of a file: its checks, resolved and held against the names of its scene, and its statistics.

use std::collections::BTreeMap;

use super::{CheckedScene, SeaQuestion};
use crate::case::{Attachment, Case, CheckInputs, StatisticsInputs};
use crate::checks::resolved::resolved;
use crate::system::SolvedSystem;

impl SeaQuestion {
    /// What the file of a line asks.
    ///
    /// # Errors
    /// A check that cannot be used, and why.
    pub fn of_line(case: &Case) -> Result<Self, String> {
        let scene = CheckedScene::of_case(case);
        Self::of_inputs(scene, (&case.statistics, &case.checks), &case.files)
    }

    /// What the file of a system asks.
    ///
    /// # Errors
    /// A check that cannot be used, and why.
    pub fn of_system(solved: &SolvedSystem) -> Result<Self, String> {
        let (scene, file) = (CheckedScene::of_system(solved), &solved.file);
        Self::of_inputs(scene, (&file.statistics, &file.checks), &file.files)
    }

    fn of_inputs(
        scene: CheckedScene,
        (statistics, checks): (&StatisticsInputs, &[CheckInputs]),
        files: &BTreeMap<String, Attachment>,
    ) -> Result<Self, String> {
        let checks = resolved(checks, files).map_err(|error| format!("[[checks]]: {error}."))?;
        for check in &checks {
            if let Some((name, near)) = scene.unknown(check) {
                let near = near.map_or_else(String::new, |near| format!(" Did you mean `{near}`?"));
                return Err(format!(
                    "[[checks]]: {} holds `{name}`, which is no line, point, body or end.{near}",
                    check.name
                ));
            }
        }
        Ok(Self {
            scene,
            statistics: statistics.clone(),
            checks,
        })
    }
}
