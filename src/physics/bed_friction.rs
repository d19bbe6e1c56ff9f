//! Friction of the sea bed on a node, along the bed, no more than a coefficient times the bed's push N.
//!
//! Two laws. The **grip** holds at rest: a spring from the place where the bed has hold of the node, with a damper beside
//! it; what they pull, `e = k (g - x) - c v` along the bed, is the force while it is no more than friction bears, and
//! is cut back to that where it is more (an elastic-plastic return mapping, as usual in contact mechanics). The place g is dragged along then, but only once a step is accepted:
//! within a step every trial starts from the same g. With different coefficients along and across the line the
//! limit is an ellipse:
//!
//! ```text
//! s = sqrt((e_a/mu_a)² + (e_l/mu_l)²)     F = e where s <= N, else e N/s
//! ```
//!
//! The **regularised** law of Zhu, Yin and Shen (2017, Journal of Harbin Engineering University, eq. 9 as rebuilt from its
//! symbols), `F = -mu N v/max(|v|, v_lim)`, remembers nothing and holds nothing: a node under load creeps.

use super::bed_reaction::BedReaction;
use serde::{Deserialize, Serialize};

use crate::numerics::lanes::outer;
use crate::numerics::{M3, V3};

/// Friction between bed and line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// Coefficient along the line \[-\].
    pub axial: f64,
    /// Coefficient across the line \[-\].
    pub lateral: f64,
    /// How it acts.
    pub law: FrictionModel,
}

/// How friction acts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrictionModel {
    /// Elastic-plastic: an anchor that holds as a spring of this stiffness per area \[N/m³\], and is dragged along at the limit.
    ElasticPlastic(f64),
    /// Against the velocity, in full above this speed \[m/s\] and in proportion below it.
    Regularised(f64),
}

/// The anchor of a node on the bed, about which friction acts as a spring.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FrictionAnchor {
    /// The place \[m\]; only its part along the bed counts.
    pub at: V3,
    /// Unit vector along the line there, in the bed.
    pub along: V3,
    /// Stiffness of the hold \[N/m\].
    pub stiffness: f64,
    /// Damping beside it \[N s/m\].
    pub damping: f64,
    /// Whether the line was laid here and has only been pulled since, along `along`: friction then resists that pull and
    /// no other, and a push back is borne without limit. (A line at rest is found with this, since a limit on one side
    /// leaves Newton no way to go back and forth.)
    pub laid: bool,
    /// How far it was dragged along in the last accepted step \[m\]: the node slid, against the force that friction bears.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub slip: f64,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks by reference")]
fn is_zero(slip: &f64) -> bool {
    *slip == 0.0
}

/// Friction on a node and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionForce {
    /// Force \[N\].
    pub force: V3,
    /// Derivative by the node's position \[N/m\].
    pub by_position: M3,
    /// Derivative by the node's velocity \[N s/m\].
    pub by_velocity: M3,
    /// Whether the node slides.
    pub slides: bool,
}

/// The pull of a grip and what of it friction bears.
#[derive(Debug, Clone, Copy, Default)]
struct MobilisedGrip {
    /// What spring and damper pull \[N\].
    pull: V3,
    /// The push that bears it \[N\].
    s: f64,
    /// What is borne of it \[N\].
    force: V3,
    /// Whether that is less.
    slides: bool,
}

/// A coefficient below this counts as zero.
const LEAST: f64 = 1e-9;

/// What the bed and the node are like.
#[derive(Debug, Clone, Copy)]
pub struct FrictionContact<'a> {
    /// Normal of the bed.
    pub normal: &'a V3,
    /// Push of the bed.
    pub push: &'a BedReaction,
    /// Position of the node \[m\].
    pub x: &'a V3,
    /// Velocity of the node \[m/s\].
    pub v: &'a V3,
    /// How the bed turns below the node, over a grid of depths; nothing on a plane.
    pub curved: Option<CurvedContact>,
}

/// A contact on a bed that curves: its push acts along the gradient g of the height above the bed, whose length is not 1, and the normal
/// turns with the place.
#[derive(Debug, Clone, Copy)]
pub struct CurvedContact {
    /// Force of the bed along its normal, `|g| P` \[N\].
    pub push: f64,
    /// Its derivative by the position \[N/m\].
    pub push_by_position: V3,
    /// Its derivative by the velocity \[N s/m\].
    pub push_by_velocity: V3,
    /// Derivative of the normal by the position \[1/m\].
    pub normal_by_position: M3,
}

/// The least that a node slides in a step, by the distance over which its grip comes to its limit, and by what the fastest of its line does: less is
/// rest at the limit, which waves along the line disturb.
const LEAST_SLIP: f64 = 1e-6;
const LEAST_OF_FASTEST: f64 = 1e-2;

impl FrictionAnchor {
    /// Whether its node, at x \[m\], slid in the last step, where the fastest of its line did so far \[m\].
    #[must_use]
    pub fn slides(&self, x: &V3, fastest: f64) -> bool {
        let stretch = (self.at - x).norm();
        self.slip > LEAST_SLIP * stretch && self.slip > LEAST_OF_FASTEST * fastest
    }
}

impl FrictionContact<'_> {
    /// Force of the bed along its normal \[N\].
    #[inline]
    fn limit(&self) -> f64 {
        self.curved.map_or(self.push.force, |curved| curved.push)
    }

    /// Derivatives of that force by position \[N/m\] and velocity \[N s/m\].
    #[inline]
    fn limit_slopes(&self) -> [V3; 2] {
        match &self.curved {
            Some(curved) => [curved.push_by_position, curved.push_by_velocity],
            None => [self.push.by_height, self.push.by_speed].map(|slope| self.normal * slope),
        }
    }

    /// What the turning of the bed below the node adds to the derivative by its position of the part of `vector` along the bed:
    /// with the normal n and its derivative D, `-(n.w) D - n (D' w)'`.
    fn turning(&self, vector: &V3) -> Option<M3> {
        let by_position = self.curved?.normal_by_position;
        let across = outer(self.normal, &(by_position.transpose() * vector));
        Some(-(by_position * self.normal.dot(vector) + across))
    }

    /// The part of a vector along the bed.
    #[inline]
    fn along_bed(&self, vector: &V3) -> V3 {
        vector - self.normal * self.normal.dot(vector)
    }

    fn projector(&self) -> M3 {
        M3::identity() - outer(self.normal, self.normal)
    }

    /// A vector along the bed, but for the direction of a line laid elsewhere on a bed that curves, without that part.
    #[inline]
    fn in_bed(&self, vector: V3) -> V3 {
        match self.curved {
            Some(_) => self.along_bed(&vector),
            None => vector,
        }
    }
}

impl Friction {
    /// Force by whichever law \[N\]; a grip law without a grip holds nothing.
    #[inline]
    #[must_use]
    pub fn force(&self, c: &FrictionContact<'_>, grip: Option<&FrictionAnchor>) -> V3 {
        match self.law {
            FrictionModel::ElasticPlastic(_) => {
                grip.map_or_else(V3::zeros, |grip| self.grip_force(c, grip).0)
            }
            FrictionModel::Regularised(slip) => self.regularised(c, slip).force,
        }
    }

    /// The same with its derivatives; none without a grip that holds.
    #[inline]
    #[must_use]
    pub fn with_tangent(
        &self,
        c: &FrictionContact<'_>,
        grip: Option<&FrictionAnchor>,
    ) -> Option<FrictionForce> {
        match self.law {
            FrictionModel::ElasticPlastic(_) => grip.map(|grip| self.grip(c, grip)),
            FrictionModel::Regularised(slip) => Some(self.regularised(c, slip)),
        }
    }

    /// The same with the secant of a grip that slides: see [`Friction::grip_with_secant`].
    #[must_use]
    pub fn with_secant(
        &self,
        c: &FrictionContact<'_>,
        grip: Option<&FrictionAnchor>,
    ) -> Option<FrictionForce> {
        match self.law {
            FrictionModel::ElasticPlastic(_) => grip.map(|grip| self.grip_with_secant(c, grip)),
            FrictionModel::Regularised(_) => self.with_tangent(c, grip),
        }
    }

    /// Force by the grip, without derivatives \[N\], and whether the node slides.
    #[inline]
    #[must_use]
    pub fn grip_force(&self, c: &FrictionContact<'_>, grip: &FrictionAnchor) -> (V3, bool) {
        let mobilised = self.mobilise(c, grip);
        (mobilised.force, mobilised.slides)
    }

    /// Force by the grip, with its exact derivatives: where the node slides the limit moves with the push, which makes
    /// them unsymmetric.
    #[inline]
    #[must_use]
    pub fn grip(&self, c: &FrictionContact<'_>, grip: &FrictionAnchor) -> FrictionForce {
        self.linearised(c, grip, false)
    }

    /// The same with the secant of a grip that slides in the place of its derivative: `limit/s` in all directions along the bed,
    /// also in that of the pull, in which the force itself does not change. Iterations with it do not overshoot (Kačanov's
    /// method), but converge in proportion only.
    #[must_use]
    pub fn grip_with_secant(
        &self,
        c: &FrictionContact<'_>,
        grip: &FrictionAnchor,
    ) -> FrictionForce {
        self.linearised(c, grip, true)
    }

    #[inline(always)]
    fn linearised(
        &self,
        c: &FrictionContact<'_>,
        grip: &FrictionAnchor,
        secant: bool,
    ) -> FrictionForce {
        let MobilisedGrip {
            pull,
            s,
            force,
            slides,
        } = self.mobilise(c, grip);
        let limit = c.limit();
        if limit <= 0.0 {
            return FrictionForce {
                force,
                by_position: M3::zeros(),
                by_velocity: M3::zeros(),
                slides,
            };
        }
        let mut by_pull = c.projector();
        if !slides {
            let mut held = FrictionForce {
                force,
                by_position: by_pull * -grip.stiffness,
                by_velocity: by_pull * -grip.damping,
                slides,
            };
            if let Some(turning) = c.turning(&free_pull(c, grip)) {
                held.by_position += turning;
            }
            return held;
        }
        let turned = match secant {
            true => V3::zeros(),
            false => self.turned(&pull, grip) / (s * s),
        };
        by_pull = (by_pull - outer(&pull, &c.in_bed(turned))) * (limit / s);
        let [by_position, by_velocity] = c.limit_slopes();
        let by_push = pull / s;
        let mut found = FrictionForce {
            force,
            by_position: outer(&by_push, &by_position) - by_pull * grip.stiffness,
            by_velocity: outer(&by_push, &by_velocity) - by_pull * grip.damping,
            slides,
        };
        if let Some(turning) = c.turning(&free_pull(c, grip)) {
            let across = outer(&pull, &(turning.transpose() * turned));
            found.by_position += (turning - across) * (limit / s);
        }
        found
    }

    /// Half the derivative of `s²` by the pull.
    #[inline]
    fn turned(&self, pull: &V3, grip: &FrictionAnchor) -> V3 {
        let (mut a, l) = (1.0 / self.axial.max(LEAST), 1.0 / self.lateral.max(LEAST));
        if grip.laid && pull.dot(&grip.along) > 0.0 {
            a = 0.0;
        }
        pull * (l * l) + grip.along * (pull.dot(&grip.along) * (a * a - l * l))
    }

    /// What of the pull of a grip friction bears.
    #[inline(always)]
    fn mobilise(&self, c: &FrictionContact<'_>, grip: &FrictionAnchor) -> MobilisedGrip {
        let limit = c.limit();
        if limit <= 0.0 {
            return MobilisedGrip {
                slides: true,
                ..MobilisedGrip::default()
            };
        }
        let pull = pull(c, grip);
        let s = self.mobilised(&pull, grip);
        let slides = s > limit;
        let force = if slides { pull * (limit / s) } else { pull };
        MobilisedGrip {
            pull,
            s,
            force,
            slides,
        }
    }

    /// The grip after an accepted step: unchanged, or slid to the limit of friction. `hold` and `damping` are
    /// the stiffness \[N/m\] and damping \[N s/m\] of the grip from now on.
    #[must_use]
    pub fn slide_grip(
        &self,
        c: &FrictionContact<'_>,
        grip: &FrictionAnchor,
        (hold, damping): (f64, f64),
        along: &V3,
    ) -> FrictionAnchor {
        let (force, slides) = self.grip_force(c, grip);
        let is_other = grip.laid || grip.stiffness != hold;
        let at = if slides || is_other {
            c.x + force / hold
        } else {
            grip.at
        };
        let slip = match slides && !is_other && c.limit() > 0.0 {
            true => (at - grip.at).norm(),
            false => 0.0,
        };
        FrictionAnchor {
            at,
            along: self.axis(c.normal, along, &grip.along),
            stiffness: hold,
            damping,
            laid: false,
            slip,
        }
    }

    /// Unit vector of the line's direction in the bed, or the one before where the line is vertical.
    fn axis(&self, normal: &V3, along: &V3, before: &V3) -> V3 {
        let flat = along - normal * normal.dot(along);
        flat.try_normalize(1e-6).unwrap_or(*before)
    }

    /// The push that bears this force \[N\].
    #[inline]
    fn mobilised(&self, force: &V3, grip: &FrictionAnchor) -> f64 {
        if self.axial == self.lateral && !grip.laid {
            return force.norm() / self.axial.max(LEAST);
        }
        let a = force.dot(&grip.along);
        let l = (force.norm_squared() - a * a).max(0.0);
        let a = if grip.laid { a.min(0.0) } else { a };
        let (mu_a, mu_l) = (self.axial.max(LEAST), self.lateral.max(LEAST));
        (a * a / (mu_a * mu_a) + l / (mu_l * mu_l)).sqrt()
    }

    /// Whether a grip bears more than friction does: only one that was laid may.
    #[must_use]
    pub fn exceeds_friction(&self, c: &FrictionContact<'_>, grip: &FrictionAnchor) -> bool {
        let free = FrictionAnchor {
            laid: false,
            ..*grip
        };
        let (force, _) = self.grip_force(c, grip);
        self.mobilised(&force, &free) > c.limit() * (1.0 + 1e-6)
    }

    /// Force by the regularised law, with its derivatives.
    #[must_use]
    pub fn regularised(&self, c: &FrictionContact<'_>, slip: f64) -> FrictionForce {
        let v = c.along_bed(c.v);
        let speed = v.norm();
        let (slides, size) = (speed > slip, speed.max(slip));
        let share = v * (-self.axial / size);
        let mut by_v = c.projector();
        if slides {
            by_v -= v * v.transpose() / (speed * speed);
        }
        let limit = c.limit();
        let [by_position, by_velocity] = c.limit_slopes();
        let mut found = FrictionForce {
            force: share * limit,
            by_position: outer(&share, &by_position),
            by_velocity: outer(&share, &by_velocity) - by_v * (self.axial * limit / size),
            slides,
        };
        if let Some(turning) = c.turning(c.v) {
            let across = if slides {
                v * (v.transpose() * turning) / (speed * speed)
            } else {
                M3::zeros()
            };
            found.by_position -= (turning - across) * (self.axial * limit / size);
        }
        found
    }
}

/// What spring and damper of a grip would pull \[N\].
#[inline]
fn pull(c: &FrictionContact<'_>, grip: &FrictionAnchor) -> V3 {
    c.along_bed(&free_pull(c, grip))
}

/// The same with its part across the bed, which does not count \[N\].
#[inline]
fn free_pull(c: &FrictionContact<'_>, grip: &FrictionAnchor) -> V3 {
    (grip.at - c.x) * grip.stiffness - c.v * grip.damping
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticBed;

    fn bed() -> ElasticBed {
        ElasticBed {
            z: -10.0,
            slope: ElasticBed::sloping(0.2, 0.7),
            grid: None,
            stiffness: 1e4,
            damping: 50.0,
            friction: None,
        }
    }

    /// The largest difference between the derivatives and central differences, by the largest derivative.
    fn mismatch(force: impl Fn(&V3, &V3) -> FrictionForce, x: V3, v: V3) -> f64 {
        let held = force(&x, &v);
        let size = held.by_position.amax().max(held.by_velocity.amax());
        let mut worst = 0.0_f64;
        for axis in 0..3 {
            let h = V3::ith(axis, 1e-6);
            let by_x = (force(&(x + h), &v).force - force(&(x - h), &v).force) / 2e-6;
            let by_v = (force(&x, &(v + h)).force - force(&x, &(v - h)).force) / 2e-6;
            worst = worst.max((held.by_position.column(axis) - by_x).amax() / size);
            worst = worst.max((held.by_velocity.column(axis) - by_v).amax() / size);
        }
        worst
    }

    #[test]
    fn derivatives_are_differences_holding_and_sliding() {
        let bed = bed();
        let normal = bed.normal(&V3::zeros());
        let along = (V3::x() - normal * normal.x).normalize();
        for (axial, lateral) in [(0.4, 0.4), (0.3, 0.8)] {
            let friction = Friction {
                axial,
                lateral,
                law: FrictionModel::ElasticPlastic(1e4),
            };
            for (off, slides, laid) in [
                (1e-3, false, false),
                (0.5, true, false),
                (0.5, true, true),
                (-0.5, true, true),
            ] {
                let sideways = if slides { 1.5 } else { 1e-3 };
                let x =
                    V3::new(1.0, 2.0, 0.0) - normal * (bed.height(&V3::new(1.0, 2.0, 0.0)) + 0.1);
                let grip = FrictionAnchor {
                    at: x + V3::new(off, sideways, -0.2 * off),
                    along,
                    stiffness: 3e3,
                    damping: 20.0,
                    laid,
                    slip: 0.0,
                };
                let v = V3::new(0.02, -0.05, 0.01);
                let force = |x: &V3, v: &V3| {
                    let push = bed.push(x, v, 0.7);
                    let contact = FrictionContact {
                        normal: &normal,
                        push: &push,
                        curved: None,
                        x,
                        v,
                    };
                    friction.grip(&contact, &grip)
                };
                assert_eq!(force(&x, &v).slides, slides);
                assert!(mismatch(force, x, v) < 1e-6, "{}", mismatch(force, x, v));
                let regularised = |x: &V3, v: &V3| {
                    let push = bed.push(x, v, 0.7);
                    let contact = FrictionContact {
                        normal: &normal,
                        push: &push,
                        curved: None,
                        x,
                        v,
                    };
                    friction.regularised(&contact, if slides { 0.01 } else { 1.0 })
                };
                assert!(mismatch(regularised, x, v) < 1e-6);
            }
        }
    }

    #[test]
    fn what_slides_is_dragged_along_and_what_holds_is_not() {
        let bed = bed();
        let normal = bed.normal(&V3::zeros());
        let friction = Friction {
            axial: 0.5,
            lateral: 0.5,
            law: FrictionModel::ElasticPlastic(1e4),
        };
        let x = -normal * (bed.height(&V3::zeros()) + 0.1);
        let v = V3::zeros();
        let push = bed.push(&x, &v, 1.0);
        let contact = FrictionContact {
            normal: &normal,
            push: &push,
            x: &x,
            v: &v,
            curved: None,
        };
        let along = (V3::x() - normal * normal.x).normalize();
        for (off, slides) in [(0.01, false), (0.2, true)] {
            let grip = FrictionAnchor {
                at: x + along * off,
                along,
                stiffness: 1e4,
                damping: 0.0,
                laid: false,
                slip: 0.0,
            };
            let (force, slid) = friction.grip_force(&contact, &grip);
            assert_eq!(slid, slides);
            assert!(force.norm() <= 0.5 * push.force * (1.0 + 1e-12));
            let next = friction.slide_grip(&contact, &grip, (1e4, 0.0), &along);
            assert_eq!(next.at == grip.at, !slides);
            let again = friction.grip_force(&contact, &next).0;
            assert!(
                (again - force).norm() < 1e-9 * push.force,
                "the force stays as it was"
            );
        }
    }
}
