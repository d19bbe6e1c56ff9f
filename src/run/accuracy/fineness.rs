//! How fine mesh and steps are, by those of the case.

use crate::case::Case;

/// Mesh and steps by those of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fineness {
    /// Segments by those of the case.
    pub(super) mesh: f64,
    /// Length of the steps by that of the case.
    pub(super) steps: f64,
}

/// Where a search begins.
pub(super) const OWN: Fineness = Fineness {
    mesh: 1.0,
    steps: 1.0,
};
impl Fineness {
    /// With so many times the segments, and steps so many times shorter.
    pub(super) fn finer(self, mesh: f64, steps: f64) -> Self {
        Self {
            mesh: self.mesh * mesh,
            steps: self.steps / steps,
        }
    }

    /// The case with this mesh and these steps. On a section with clumps the number of segments stays a multiple of its own, so that
    /// they stay where they hang.
    pub(super) fn applied_to(self, case: &Case) -> Case {
        let mut case = case.clone();
        for section in &mut case.line {
            let own = section.segments;
            let hung = case
                .clumps
                .iter()
                .any(|clump| clump.section == section.name);
            section.segments = if hung {
                own * (self.mesh.ceil() as usize).max(1)
            } else {
                (own as f64 * self.mesh).round() as usize
            };
        }
        let solver = &mut case.solver;
        solver.time_step_s = solver.time_step_s.map(|step| self.steps * step);
        solver.step_tolerance *= self.steps.powi(3);
        case
    }
}
