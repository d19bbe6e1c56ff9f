//! A study of one result: the effect of every input on it, or of every effect of the scene.

use std::sync::atomic::AtomicBool;

use super::study_of::StudyOf;
use crate::case::{Case, QuantityId};
use crate::kinds::FileType;
use crate::number::duration;
use crate::report::effects::TornadoView;
use crate::report::physics;
use crate::study::points::{BaseCase, PointProgress};
use crate::study::{effects, physics as scene_physics};
use crate::system::SystemFile;

/// A study of one result.
#[derive(Debug, Clone)]
pub struct StudyRequest {
    /// What it varies.
    pub of: StudyOf,
    /// The kind of its file: a line case, or a system in time or at rest.
    pub kind: FileType,
    /// The case or system.
    pub base: BaseCase,
    /// The result.
    pub result: QuantityId,
    /// Columns of the page.
    pub width: usize,
}

/// Told of each variant that is computed.
type Told<'t> = &'t (dyn Fn(PointProgress<'_>) + Sync);

impl StudyRequest {
    /// Computes it, and writes its page.
    ///
    /// # Errors
    /// Why the scene itself could not be computed, or that it does not have the result.
    pub fn page(&self, cancel: &AtomicBool, told: Told<'_>) -> Result<String, String> {
        match self.of {
            StudyOf::Inputs => self.inputs(cancel, told),
            StudyOf::Physics => self.physics(cancel, told),
        }
    }

    fn physics(&self, cancel: &AtomicBool, told: Told<'_>) -> Result<String, String> {
        let compute = match self.kind {
            FileType::System => scene_physics::compute::<SystemFile>,
            _ => scene_physics::compute::<Case>,
        };
        let found = compute(&self.base, cancel, told)?;
        let table = physics::table(&found, std::slice::from_ref(&self.result));
        Ok(table.to_text(self.width))
    }

    fn inputs(&self, cancel: &AtomicBool, told: Told<'_>) -> Result<String, String> {
        let compute = match self.kind {
            FileType::System => effects::compute::<SystemFile>,
            _ => effects::compute::<Case>,
        };
        let found = compute(&self.base, cancel, told)?;
        let Some(view) = TornadoView::of_result(&found, &self.result) else {
            let what = format!("The run of the case does not have `{}`.", self.result);
            return Err(what);
        };
        let (chart, table) = (view.chart(self.width), view.table());
        Ok(format!(
            "{}\n{}\nCost: {} of CPU time.\n",
            chart.to_text(self.width),
            table.to_text(self.width),
            duration(found.cpu_s())
        ))
    }
}
