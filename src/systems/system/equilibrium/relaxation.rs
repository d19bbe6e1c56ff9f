//! Pseudo-transient continuation of the search, where Newton's method ends at a kink of the forces or would go back to an unstable equilibrium.

use nalgebra::DVector;

use super::step::solved;
use super::{SystemEquilibriumSearch, SystemError};
use crate::system::balance::Balance;
use crate::system::bounds::Contact;
use crate::system::freedoms::Placement;

/// Stiffness that holds the unknowns back where they are relaxed, by the greatest of the system: at first and at most.
const HELD_BACK: f64 = 1e-2;
const MOST_HELD_BACK: f64 = 1e6;
/// By how much a relaxed step may leave more out of balance than there was.
const WORSE: f64 = 2.0;

impl SystemEquilibriumSearch<'_> {
    /// Pseudo-transient continuation (Kelley and Keyes 1998, doi 10.1137/S0036142996304796): steps `(K + m) d = F` of a system whose unknowns are
    /// held back by m, which grows where a step leaves more out of balance than there was and falls with the forces out of balance. Newton's method
    /// with a search along the step ends where the forces have a kink, at a node that touches down or a segment that slackens.
    pub(super) fn relax(&mut self, most_steps: usize) -> Result<(), SystemError> {
        let stiffest = self.here.stiffness.diagonal().component_div(&self.lever);
        let stiffest = stiffest.component_div(&self.lever).amax();
        let (mut held_back, most) = (HELD_BACK * stiffest, MOST_HELD_BACK * stiffest);
        for _ in 0..most_steps {
            let force = self.unbalanced(&self.here, &self.placement);
            if self.size(&force) <= self.accepted() {
                return self.run(most_steps);
            }
            if held_back > most {
                break;
            }
            self.steps += 1;
            let before = force.component_div(&self.lever).norm();
            let after = self.relaxed_step(&force, held_back);
            held_back *= match after {
                Some((place, balance, after)) if after <= WORSE * before => {
                    (self.placement, self.here) = (place, balance);
                    (after / before).clamp(0.1, 1.0)
                }
                _ => 10.0,
            };
        }
        let force = self.unbalanced(&self.here, &self.placement);
        Err(self.not_converged(&force))
    }

    /// Where a step of [`Self::relax`] leads, and what is out of balance there \[N\].
    fn relaxed_step(
        &mut self,
        force: &DVector<f64>,
        held_back: f64,
    ) -> Option<(Placement, Balance, f64)> {
        self.contacts = self
            .bounds
            .contacts(&self.freedoms, &self.placement, &self.here.force);
        let contacts = self.contacts.iter();
        let held: Vec<bool> = contacts.map(|on| *on != Contact::None).collect();
        let mut stiffness = self.stiffness(&held);
        for (unknown, lever) in self.lever.iter().enumerate() {
            stiffness.add(unknown, unknown, held_back * lever * lever);
        }
        let step = solved(&stiffness, force)?;
        let far = step.component_mul(&self.lever).amax();
        let share = (self.reach / far).min(1.0);
        let (place, _, balance) = self.probe(&step, share).ok()?;
        let after = self.unbalanced(&balance, &place);
        let after = after.component_div(&self.lever).norm();
        (place != self.placement).then_some((place, balance, after))
    }
}
