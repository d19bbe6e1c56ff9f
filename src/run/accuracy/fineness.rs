//! How fine mesh and steps are, by those of the case.

use crate::case::Case;

/// Mesh and steps by those of the case.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Fineness {
    /// Segments of every section by those of the case.
    pub(super) mesh: Vec<f64>,
    /// Length of the steps by that of the case.
    pub(super) steps: f64,
}

impl Fineness {
    /// As the case sets it.
    pub(super) fn own(case: &Case) -> Self {
        Self {
            mesh: vec![1.0; case.line.len()],
            steps: 1.0,
        }
    }

    /// With so many times the segments on each section, and steps so many times shorter; nothing coarser than the case.
    pub(super) fn finer(&self, mesh: &[f64], steps: f64) -> Self {
        let mesh = self.mesh.iter().zip(mesh);
        Self {
            mesh: mesh.map(|(now, by)| (now * by).max(1.0)).collect(),
            steps: (self.steps / steps).min(1.0),
        }
    }

    /// The case with this mesh and these steps. On a section with clumps the number of segments stays a multiple of its own, so that
    /// they stay where they hang.
    pub(super) fn applied_to(&self, case: &Case) -> Case {
        let mut case = case.clone();
        for (section, mesh) in case.line.iter_mut().zip(&self.mesh) {
            let own = section.segments;
            let mut clumps = case.clumps.iter();
            section.segments = if clumps.any(|clump| clump.section == section.name) {
                own * mesh.ceil() as usize
            } else {
                (own as f64 * mesh).round() as usize
            };
        }
        let solver = &mut case.solver;
        solver.time_step_s = solver.time_step_s.map(|step| self.steps * step);
        solver.step_tolerance *= self.steps.powi(3);
        case
    }
}
