//! Energy balance of a dynamic run: `work put in + growth of the added mass = dissipated + stored + drift`.
//!
//! The powers of every accepted step ([`Scene::energy_rates`](crate::scene::Scene::energy_rates)) are integrated between the
//! steps by the parabola of [`StepInterval`]. What is stored is the change of the energy between events: what a release takes along
//! is neither work nor stored. The drift is numerical only, since every force has its term: it is the error of the method in
//! time, and falls with its order. Where segments at ends that are paid out are parted and joined, what comes and goes by it is kept
//! apart: it is the error of the mesh, which shorter steps leave as it is.

use serde::{Deserialize, Serialize};

use super::step_interval::StepInterval;
use super::{Quantity, QuantityId, Subject};
use crate::case::{Case, EnergyQuantity, Method};

/// Share of all that passes through a run that it may drift without a warning: less than this the numerical damping of
/// generalized-alpha takes on purpose, of axial waves at the start of a swing for instance.
const ALLOWED: f64 = 0.02;
/// The most that its error from the time step adds to that.
const OF_TIME_ERROR: f64 = 0.01;
/// Share of all that passes through from which on a drift is held against its own estimate.
const NOTABLE: f64 = 0.01;
/// By how many times errors in time are stated larger at most.
const GROWTH: f64 = 1e3;
/// Share of the energy itself that counts as passed through: in a line at rest rounding is all that does.
const AT_REST: f64 = 1e-6;

/// Energies of a run so far \[J\].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyBalance {
    /// Work of ends, waves, current and traveller.
    supplied: f64,
    /// Dissipated by drag, axial damping, ropes and the bed.
    dissipated: f64,
    /// Growth of the added mass as it turns and submerges.
    growth: f64,
    /// Change of the energy of the line between events.
    stored: f64,
    /// Work and dissipation without their signs.
    passed: f64,
    /// The greatest kinetic energy.
    kinetic: f64,
    /// The greatest energy without its sign.
    greatest: f64,
    /// What of the drift came and went where segments at ends that are paid out were parted and joined.
    remeshed: f64,
}

/// Whether runs of a case have an energy balance: those in time with inertia.
pub(super) fn is_stated(case: &Case) -> bool {
    match case.solver.method {
        Method::Alpha | Method::Auto | Method::Rk4 => true,
        Method::Static | Method::Quasi => false,
    }
}

impl EnergyBalance {
    /// Takes in what lies between two accepted steps.
    pub(super) fn update(&mut self, between: &StepInterval<'_>) {
        let [from, to] = between.energy();
        let [t0, t1] = between.time();
        self.supplied += between.integral(|sample| sample.energy.supplied);
        self.dissipated += between.integral(|sample| sample.energy.dissipated);
        self.growth += between.integral(|sample| sample.energy.growth);
        self.remeshed += between.integral(|sample| sample.energy.remeshed);
        self.stored += to.energy - from.energy;
        let size =
            |rates: &crate::scene::EnergyRates| rates.supplied.abs() + rates.dissipated.abs();
        self.passed += 0.5 * (t1 - t0) * (size(from) + size(to));
        self.kinetic = self.kinetic.max(from.kinetic).max(to.kinetic);
        let size = from.energy.abs().max(to.energy.abs());
        self.greatest = self.greatest.max(size);
    }

    /// Takes in what a change of the mesh adds to the energy \[J\].
    pub(super) fn jump(&mut self, more: f64) {
        self.stored += more;
        self.remeshed += more;
    }

    /// Whether more than half of what does not add up is due to the mesh.
    #[must_use]
    pub fn is_of_mesh(&self) -> bool {
        (self.drift() - self.remeshed).abs() < 0.5 * self.drift().abs()
    }

    /// Dissipated by drag, axial damping, ropes, the bed and friction \[J\].
    #[must_use]
    pub const fn dissipated(&self) -> f64 {
        self.dissipated
    }

    /// What does not add up by all that passed through \[-\].
    #[must_use]
    pub fn relative_drift(&self) -> f64 {
        self.drift().abs() / self.passed_through().max(f64::MIN_POSITIVE)
    }

    /// What does not add up \[J\].
    #[must_use]
    pub fn drift(&self) -> f64 {
        self.stored + self.dissipated - self.supplied - self.growth
    }

    /// All that passed through \[J\]: work and dissipation without their signs, the greatest kinetic energy, and a millionth of the
    /// greatest energy.
    fn passed_through(&self) -> f64 {
        self.passed + self.kinetic + AT_REST * self.greatest
    }

    /// Its single numbers, without errors.
    pub(super) fn quantities(&self) -> Vec<Quantity> {
        let drift = self.drift();
        let through = self.passed_through();
        let share = if through > 0.0 { drift / through } else { 0.0 };
        let value = |quantity| match quantity {
            EnergyQuantity::Supplied => self.supplied,
            EnergyQuantity::Dissipated => self.dissipated,
            EnergyQuantity::Stored => self.stored,
            EnergyQuantity::Drift => drift,
            EnergyQuantity::DriftShare => 100.0 * share,
        };
        let all = EnergyQuantity::ALL.into_iter();
        all.map(|quantity| {
            let id = QuantityId::single(Subject::Energy(quantity));
            Quantity::new(id, value(quantity))
        })
        .collect()
    }
}

/// By how many times the errors in time are larger than companions show, which are damped alike and agree. The drift of the energy is
/// the one result whose exact value is known: where it is notable and exceeds its own estimate, the others exceed theirs as well. What its
/// own error of the mesh accounts for does not count.
pub(super) fn time_error_growth(energy: &[Quantity]) -> f64 {
    let growth = |[drift, share]: [&Quantity; 2]| {
        let stated = drift.time_error.filter(|stated| *stated > 0.0)?;
        let by_time = drift.value.abs() - drift.mesh_error.unwrap_or(0.0);
        let is_notable = share.value.abs() > 100.0 * NOTABLE;
        is_notable.then_some(by_time / stated)
    };
    drift_and_share(energy)
        .and_then(growth)
        .map_or(1.0, |growth| growth.clamp(1.0, GROWTH))
}

/// The drift and its share of all that passed through.
fn drift_and_share(list: &[Quantity]) -> Option<[&Quantity; 2]> {
    let find = |wanted| {
        let is = |q: &&Quantity| q.id == QuantityId::single(Subject::Energy(wanted));
        list.iter().find(is)
    };
    Some([
        find(EnergyQuantity::Drift)?,
        find(EnergyQuantity::DriftShare)?,
    ])
}

/// That errors in time are stated larger than companions show.
pub(super) fn growth_warning(growth: f64) -> Option<String> {
    (growth > 1.0).then(|| {
        format!(
            "the errors from the time step are stated {growth:.1} times as large as other steps show them, since the energy drifts by so \
             many times more than they show; try a smaller time_step_s or step_tolerance"
        )
    })
}

/// The warning where the drift exceeds what is stated of it: a share of all that passed through, and its error from the time
/// step. Of that a part counts only: at second order it is as large as any drift.
#[must_use]
pub fn warning(summary: &[Quantity], balance: Option<&EnergyBalance>) -> Option<String> {
    let [drift, share] = drift_and_share(summary)?;
    let (percent, allowed) = (share.value.abs(), 100.0 * ALLOWED);
    let by_time = share.time_error.unwrap_or(0.0);
    let stated = allowed + by_time.min(100.0 * OF_TIME_ERROR);
    if percent <= stated {
        return None;
    }
    let remedy = match balance.is_some_and(EnergyBalance::is_of_mesh) {
        true => "segments at ends that are paid out are too long: give these lines more `segments`",
        false => "try a smaller time_step_s or step_tolerance",
    };
    let way = if drift.value > 0.0 { "gains" } else { "loses" };
    Some(format!(
        "the energy balance does not close: the run {way} {:.3e} J that no force accounts for, {percent:.2} % of all that passed \
         through it; {remedy}",
        drift.value.abs()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A drift and its share, with the errors in time that companions show.
    fn drifts(drift: f64, stated: Option<f64>, percent: f64) -> Vec<Quantity> {
        let quantity = |quantity, value, time_error| Quantity {
            time_error,
            ..Quantity::new(QuantityId::single(Subject::Energy(quantity)), value)
        };
        vec![
            quantity(EnergyQuantity::Drift, drift, stated),
            quantity(EnergyQuantity::DriftShare, percent, None),
        ]
    }

    #[test]
    fn errors_in_time_grow_by_what_the_drift_exceeds_its_own() {
        let growth = |drift, stated, percent| time_error_growth(&drifts(drift, stated, percent));
        assert_eq!(growth(-700.0, Some(100.0), -1.8), 7.0);
        // Within its error, too small to matter, and without an error.
        assert_eq!(growth(-700.0, Some(900.0), -1.8), 1.0);
        assert_eq!(growth(-700.0, Some(100.0), -0.9), 1.0);
        assert_eq!(growth(-700.0, Some(0.0), -1.8), 1.0);
        assert_eq!(growth(-700.0, None, -1.8), 1.0);
        assert_eq!(time_error_growth(&[]), 1.0);
        assert_eq!(growth(-700.0, Some(1e-300), -1.8), GROWTH);
        let mut by_mesh = drifts(-700.0, Some(100.0), -1.8);
        by_mesh[0].mesh_error = Some(300.0);
        assert_eq!(time_error_growth(&by_mesh), 4.0);
    }

    #[test]
    fn a_growth_gives_a_warning() {
        assert_eq!(growth_warning(1.0), None);
        assert!(growth_warning(7.0).unwrap().contains("7.0 times"));
    }
}
