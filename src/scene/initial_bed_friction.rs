//! Initial bed friction: the equilibrium on a rough bed depends on how the line was laid.
//!
//! A line with an end on the bed is taken as laid from that end straight towards the other, without tension, and then pulled to
//! the position of its other end: friction is fully mobilised along the pulled part, so that tension falls from the touchdown
//! towards the end on the bed by the friction on every metre until it vanishes. The closed form makes the same assumption
//! (J. M. Jonkman, NREL/TP-500-41958, 2007, sec. 2.6). Line not yet pulled is held where it was laid, far more stiffly than by its
//! own stiffness.
//!
//! If neither end is on the bed, or where the line touches down a second time, this does not determine the tension: friction is
//! then left out of the equilibrium.

use super::Scene;
use crate::numerics::V3;
use crate::physics::bed_friction::{Friction, FrictionAnchor, FrictionModel};

/// Stiffness of the friction springs of line just laid, relative to that of its segments.
const HOLD: f64 = 10.0;
/// Height relative to the length of the line up to which an end counts as on the bed.
const ON_BED: f64 = 1e-3;

/// The friction springs of a line in equilibrium, and a remark on them.
pub(super) struct InitialFriction {
    pub(super) grips: Vec<FrictionAnchor>,
    pub(super) remark: Option<String>,
}

impl Scene {
    /// The friction springs for the initial guess at an equilibrium.
    pub(super) fn initial_friction(&self, guess: &[V3], tension: &[f64]) -> InitialFriction {
        let mut grips = self.grips_at(guess);
        let remark = match self.seabed().and_then(|bed| bed.friction) {
            None => None,
            Some(Friction {
                law: FrictionModel::Regularised(_),
                ..
            }) => Some(
                "friction by `zhu-2017` holds nothing at rest: it is left out of the equilibrium"
                    .to_owned(),
            ),
            Some(_) => Some(self.lay(guess, tension, &mut grips)),
        };
        InitialFriction { grips, remark }
    }

    /// Attaches the friction springs where the line was laid; returns a remark.
    fn lay(&self, guess: &[V3], tension: &[f64], grips: &mut [FrictionAnchor]) -> String {
        let last = guess.len() - 1;
        let end = [0, last].into_iter().find(|end| self.lies(&guess[*end]));
        let Some(end) = end else {
            return self.lay_between_lifted_ends(guess, tension, grips);
        };
        let name = &self.labels.end_names[usize::from(end > 0)];
        let first = if end == 0 { 0 } else { last - 1 };
        let chord = (guess[first + 1] - guess[first]).norm();
        let heaped =
            tension[first] <= 0.0 && chord < (1.0 - 1e-6) * self.line.segments[first].axial.length;
        if !heaped {
            self.lay_straight(end, guess[last - end], grips);
        }
        for (i, grip) in grips.iter_mut().enumerate() {
            grip.stiffness = self.hold(i);
            grip.laid = !heaped;
        }
        self.hold_weight_on_slope(grips);
        let again = self.release_beyond_first_contact(end, guess, grips);
        let mut words = if heaped {
            format!(
                "more line than needed lies on the bed at `{name}`, without tension; friction keeps it from sliding"
            )
        } else {
            format!(
                "the line is taken as laid straight from `{name}` and then pulled: along what was pulled, friction on the \
                 bed is at its full"
            )
        };
        if again {
            words +=
                "; where it comes down on the bed again, friction is left out of the equilibrium";
        }
        words
    }

    /// On a slope, moves the springs uphill so that they carry the weight of the line laid, up to the friction limit.
    fn hold_weight_on_slope(&self, grips: &mut [FrictionAnchor]) {
        let Some((bed, friction)) = self.seabed().and_then(|b| Some((b, b.friction?))) else {
            return;
        };
        let Some(first) = grips.first() else { return };
        let normal = bed.normal(&first.at);
        let uphill = V3::z() - normal * normal.z;
        let most =
            friction.axial.min(friction.lateral) * normal.z / uphill.norm().max(f64::MIN_POSITIVE);
        for (grip, weight) in grips.iter_mut().zip(&self.line.weight) {
            grip.at += uphill * (weight.max(0.0) * most.min(1.0) / grip.stiffness);
        }
    }

    /// Stiffness of the friction spring of node i of a line just laid \[N/m\].
    fn hold(&self, i: usize) -> f64 {
        let beside =
            self.line.segments[i.saturating_sub(1)..(i + 1).min(self.line.segments.len())].iter();
        HOLD * beside
            .map(|s| s.axial.ea / s.axial.length)
            .fold(0.0, f64::max)
    }

    /// Friction springs if neither end is on the bed: only on line that lies there without tension; returns a remark.
    fn lay_between_lifted_ends(
        &self,
        guess: &[V3],
        tension: &[f64],
        grips: &mut [FrictionAnchor],
    ) -> String {
        let last = guess.len() - 1;
        let tall = 1e-9 * self.line.arc[last];
        let heap = |i: usize| {
            let slack = tension[i.saturating_sub(1)] <= 0.0 && tension[i.min(last - 1)] <= 0.0;
            slack
                && self
                    .seabed()
                    .is_some_and(|bed| bed.height(&guess[i]) <= tall)
        };
        let mut heaped = false;
        for (i, grip) in grips.iter_mut().enumerate() {
            grip.stiffness = if heap(i) { self.hold(i) } else { 0.0 };
            heaped |= heap(i);
        }
        let words = if heaped {
            "more line than needed lies on the bed, without tension; friction keeps it from sliding"
        } else {
            "neither end of the line lies on the bed: how friction acts on it depends on how it was laid, and it is left out \
             of the equilibrium (from there on it holds)"
        };
        words.to_owned()
    }

    fn lies(&self, end: &V3) -> bool {
        let whole = self.line.arc[self.line.arc.len() - 1];
        self.seabed()
            .is_some_and(|bed| bed.height(end) <= ON_BED * whole)
    }

    /// Positions of the springs of a line laid straight from one end towards the other, at rest under its weight.
    fn lay_straight(&self, end: usize, to: V3, grips: &mut [FrictionAnchor]) {
        let Some(bed) = self.seabed() else { return };
        let from = grips[end].at;
        let normal = bed.normal(&from);
        let flat = (to - from) - normal * normal.dot(&(to - from));
        let Some(direction) = flat.try_normalize(1e-9 * self.line.arc[self.line.arc.len() - 1])
        else {
            return;
        };
        let last = grips.len() - 1;
        let mut at = from;
        let mut height = bed.height(&from);
        for k in 1..=last {
            let (i, segment) = if end == 0 {
                (k, k - 1)
            } else {
                (last - k, last - k)
            };
            let rest =
                -(self.line.weight[i] * normal.z).max(0.0) / (bed.stiffness * self.footprint(i));
            let length = self.line.segments[segment].axial.length;
            let step = (length * length - (rest - height).powi(2)).max(0.0).sqrt();
            at += direction * step;
            height = rest;
            grips[i].at = at;
            grips[i].along = direction;
        }
    }

    /// Removes the springs where the line touches down a second time, seen from the end on the bed; whether it does.
    fn release_beyond_first_contact(
        &self,
        end: usize,
        guess: &[V3],
        grips: &mut [FrictionAnchor],
    ) -> bool {
        let Some(bed) = self.seabed() else {
            return false;
        };
        let last = guess.len() - 1;
        let tall = 1e-9 * self.line.arc[last];
        let order = |k: usize| if end == 0 { k } else { last - k };
        let lies = |k: usize| bed.height(&guess[order(k)]) <= tall;
        let lifted = (1..=last).find(|k| !lies(*k)).unwrap_or(last + 1);
        let Some(again) = (lifted + 1..last).find(|k| lies(*k)) else {
            return false;
        };
        for k in again..=last {
            grips[order(k)].stiffness = 0.0;
        }
        true
    }
}
