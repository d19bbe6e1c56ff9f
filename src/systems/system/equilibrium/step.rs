//! One step of the search: Newton's, or along the nearest direction in which the energy falls, as far as the forces point along it.

use nalgebra::DVector;

use super::{LinePhysics, SystemEquilibriumSearch, SystemError};
use crate::numerics::envelope::EnvelopeMatrix;
use crate::numerics::envelope_factors::EnvelopeCholesky;
use crate::system::along_bed::stiffness_along;
use crate::system::balance::Balance;
use crate::system::bounds::Contact;
use crate::system::freedoms::Placement;

/// Halvings of a Newton step before another way is tried.
const HALVINGS: usize = 8;

/// A direction and what it does.
struct Direction {
    step: DVector<f64>,
    /// Force along it \[N m\].
    slope: f64,
}

impl SystemEquilibriumSearch<'_> {
    /// One step; whether anything moved.
    pub(super) fn step(&mut self, force: &DVector<f64>) -> Result<bool, SystemError> {
        self.contacts = self
            .bounds
            .contacts(&self.freedoms, &self.placement, &self.here.force);
        let held: Vec<bool> = self
            .contacts
            .iter()
            .map(|contact| *contact != Contact::None)
            .collect();
        if self.physics == LinePhysics::Full && self.newton_step(force, &held) {
            return Ok(true);
        }
        let mut direction = self.direction(force, &held);
        let far = direction.step.component_mul(&self.lever).amax();
        let clipped = far > self.reach;
        if clipped {
            direction.step *= self.reach / far;
            direction.slope *= self.reach / far;
        }
        self.move_along(&direction, clipped)
    }

    /// Newton's step for forces without energy, halved until less is out of balance; whether one was taken. A ship turns into
    /// the wind along a way that the energy of its lines does not fall on.
    fn newton_step(&mut self, force: &DVector<f64>, held: &[bool]) -> bool {
        let stiffness = self.stiffness(held);
        let newton = is_oblique(&stiffness).then(|| solved(&stiffness, force));
        let newton = newton.flatten();
        let Some(step) = newton.filter(|step| step.iter().all(|part| part.is_finite())) else {
            return false;
        };
        let far = step.component_mul(&self.lever).amax();
        let mut share = (self.reach / far).min(1.0);
        let before = force.component_div(&self.lever).norm();
        for _ in 0..HALVINGS {
            if let Ok((place, _, balance)) = self.probe(&step, share) {
                let after = self.unbalanced(&balance, &place);
                let after = after.component_div(&self.lever).norm();
                if after < (1.0 - 0.1 * share) * before && place != self.placement {
                    (self.placement, self.here) = (place, balance);
                    return true;
                }
            }
            share *= 0.5;
        }
        false
    }

    /// The stiffness with the unknowns that are held standing for themselves.
    pub(super) fn stiffness(&self, held: &[bool]) -> EnvelopeMatrix {
        let mut stiffness = self.here.stiffness.clone();
        let lying = self.on_slope(&self.placement, &self.contacts);
        let bed = self.network.bed.as_ref();
        stiffness_along(bed, &lying, &self.here.force, &mut stiffness);
        stiffness.hold(held, 1.0);
        stiffness
    }

    /// Newton's direction, or the nearest one in which the energy falls.
    fn direction(&self, force: &DVector<f64>, held: &[bool]) -> Direction {
        let stiffness = self.stiffness(held);
        let most = stiffness.diagonal().component_div(&self.lever);
        let most = most
            .component_div(&self.lever)
            .amax()
            .max(1e-9 * self.force_scale());
        // Friction, and moments out of balance, make it oblique.
        let oblique = is_oblique(&stiffness);
        let mut added = 0.0;
        for _ in 0..40 {
            let diagonal = self.lever.component_mul(&self.lever) * added;
            if let Some(factors) = EnvelopeCholesky::new(&stiffness, &diagonal) {
                let plain = factors.solve(force);
                let newton = (added == 0.0 && oblique)
                    .then(|| solved(&stiffness, force))
                    .flatten();
                let downhill =
                    |step: &DVector<f64>| force.dot(step) > 0.0 && step.amax().is_finite();
                if let Some(step) = newton.filter(downhill) {
                    let slope = force.dot(&step);
                    return Direction { step, slope };
                }
                // What was barely made positive definite leads far along the one direction that it was not in.
                let far = plain.component_mul(&self.lever).amax();
                let within = added == 0.0 || far <= 2.0 * self.reach;
                if within && downhill(&plain) {
                    let slope = force.dot(&plain);
                    return Direction { step: plain, slope };
                }
            }
            added = if added == 0.0 {
                1e-12 * most
            } else {
                10.0 * added
            };
        }
        let step = force.component_div(&self.lever).component_div(&self.lever);
        let slope = force.dot(&step);
        Direction { step, slope }
    }

    /// Moves along a direction as far as the forces still point along it.
    fn move_along(&mut self, direction: &Direction, clipped: bool) -> Result<bool, SystemError> {
        let (mut low, mut high) = (0.0_f64, f64::INFINITY);
        let mut slopes = (direction.slope, f64::NAN);
        let mut share = 1.0_f64;
        let mut reached: Option<(f64, Placement, Balance)> = None;
        let mut failure = None;
        for _ in 0..60 {
            let (place, slope, balance) = match self.probe(&direction.step, share) {
                Ok(found) => found,
                Err(error) => {
                    failure = Some(error);
                    (high, slopes.1) = (share, f64::NAN);
                    share = 0.5 * (low + share);
                    continue;
                }
            };
            let enough = slope.abs() <= 0.5 * direction.slope;
            let undershot = slope > 0.5 * direction.slope;
            if !undershot {
                (high, slopes.1) = (share, slope);
            } else {
                (low, slopes.0) = (share, slope);
            }
            if slope >= -0.5 * direction.slope {
                reached = Some((share, place, balance));
            }
            let may_grow = clipped && undershot && high.is_infinite() && share < 64.0;
            if enough || (undershot && high.is_infinite() && !may_grow) || high - low < 1e-12 * high
            {
                break;
            }
            share = next_share((low, slopes.0), (high, slopes.1));
        }
        let Some((share, place, balance)) = reached else {
            return failure.map_or(Ok(false), Err);
        };
        if clipped {
            self.reach *= share.max(0.25);
        } else {
            let far = direction.step.component_mul(&self.lever).amax() * share;
            self.reach = self.reach.max(2.0 * far);
        }
        let moved = place != self.placement;
        (self.placement, self.here) = (place, balance);
        Ok(moved)
    }

    /// The system a share of a step further, and the force along the step there; unknowns that came to a bound count no more.
    pub(super) fn probe(
        &self,
        step: &DVector<f64>,
        share: f64,
    ) -> Result<(Placement, f64, Balance), SystemError> {
        let mut place = self
            .placement
            .moved(self.network, &self.freedoms, &(step * share));
        self.bounds
            .follow_bed(&self.freedoms, &self.contacts, &mut place);
        self.bounds.keep(self.network, &self.freedoms, &mut place);
        let balance = self.evaluate(&place)?;
        let force = self.unbalanced(&balance, &place);
        let slope = force.dot(step);
        if !slope.is_finite() {
            return Err(SystemError::NotConverged {
                residual: f64::NAN,
                at: String::new(),
                steps: self.steps,
            });
        }
        Ok((place, slope, balance))
    }
}

/// Where to look next between two shares of a step: the secant, kept off both ends; twice as far where there is no upper one.
fn next_share((low, at_low): (f64, f64), (high, at_high): (f64, f64)) -> f64 {
    if high.is_infinite() {
        return 2.0 * low;
    }
    let width = high - low;
    let secant = low + width * at_low / (at_low - at_high);
    if secant.is_finite() {
        secant.clamp(low + 0.1 * width, high - 0.1 * width)
    } else {
        low + 0.5 * width
    }
}

/// Whether a stiffness is not symmetric by more than rounding.
fn is_oblique(stiffness: &EnvelopeMatrix) -> bool {
    stiffness.asymmetry() > 1e-9
}

pub(super) fn solved(stiffness: &EnvelopeMatrix, force: &DVector<f64>) -> Option<DVector<f64>> {
    stiffness.solve(std::slice::from_ref(force))?.pop()
}
