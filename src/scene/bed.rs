//! The sea bed under the whole line: its push and friction on every node, what it remembers, energy and loss.

use super::{End, Scene};
use crate::case::{self, FrictionLaw};
use crate::numerics::{BlockBand, V3};
use crate::physics::Seabed;
use crate::physics::bed_reaction::BedReaction;
use crate::physics::friction::{Contact, Friction, FrictionForce, FrictionModel, Grip};
use crate::solve::{Factors, Kinematics, State};

/// The bed of the case.
pub(super) fn seabed(bed: &case::Seabed) -> Seabed {
    let (slope, azimuth) = (
        bed.slope_deg.to_radians(),
        bed.slope_azimuth_deg.to_radians(),
    );
    let [x, y] = bed.depth_at_m;
    let friction = bed
        .friction
        .filter(|axial| *axial > 0.0 || bed.friction_lateral.is_some_and(|lateral| lateral > 0.0));
    Seabed {
        z: -bed.depth_m - slope.tan() * (x * azimuth.cos() + y * azimuth.sin()),
        slope: Seabed::sloping(slope, azimuth),
        stiffness: bed.stiffness_n_per_m3,
        damping: bed.damping_n_s_per_m3,
        friction: friction.map(|axial| Friction {
            axial,
            lateral: bed.friction_lateral.unwrap_or(axial),
            law: match bed.friction_law {
                FrictionLaw::Grip => FrictionModel::Grip(
                    bed.grip_stiffness_n_per_m3
                        .unwrap_or(bed.stiffness_n_per_m3),
                ),
                FrictionLaw::Zhu2017 => FrictionModel::Regularised(bed.slip_speed_m_per_s),
            },
        }),
    }
}

impl Scene {
    /// The speed \[m/s\] within which friction of the bed turns round, where it goes with the velocity.
    #[must_use]
    pub fn slip_speed(&self) -> Option<f64> {
        match self.bed?.friction?.law {
            FrictionModel::Regularised(slip) => Some(slip),
            FrictionModel::Grip(_) => None,
        }
    }

    /// Takes the forces of the bed from the residual.
    pub(super) fn add_bed(&self, state: &State, r: &mut [V3]) {
        let Some(bed) = &self.bed else { return };
        if bed.is_plain() {
            for (i, out) in r.iter_mut().enumerate() {
                out.z -= self.push(bed, i, state).force;
            }
        } else {
            for (i, out) in r.iter_mut().enumerate() {
                *out -= self.bed_force(bed, i, state);
            }
        }
    }

    /// Takes the derivatives of those forces from the tangent.
    pub(super) fn add_bed_tangent(&self, state: &State, c: Factors, tangent: &mut BlockBand) {
        let Some(bed) = &self.bed else { return };
        let normal = bed.normal();
        // The line's own nodes: a ship at its end has more.
        for (i, block) in tangent.diag[..self.footprint.len()].iter_mut().enumerate() {
            let push = self.push(bed, i, state);
            let k = c.stiffness * push.by_height + c.damping * push.by_speed;
            if bed.is_plain() {
                block[(2, 2)] -= k;
                continue;
            }
            *block -= normal * (normal * k).transpose();
            if push.force > 0.0
                && let Some(friction) = &bed.friction
                && let Some(held) =
                    self.held(friction, &contact(&normal, &push, i, state), i, state)
            {
                *block -= held.by_position * c.stiffness + held.by_velocity * c.damping;
            }
        }
    }

    /// Push of the bed on node i.
    #[inline]
    pub(super) fn push(&self, bed: &Seabed, i: usize, state: &State) -> BedReaction {
        bed.push(&state.x[i], &state.v[i], self.footprint[i])
    }

    /// Push and friction of the bed on node i \[N\].
    pub(super) fn bed_force(&self, bed: &Seabed, i: usize, state: &State) -> V3 {
        let push = self.push(bed, i, state);
        if push.force <= 0.0 {
            return V3::zeros();
        }
        let normal = bed.normal();
        let along = bed.friction.as_ref().map_or_else(V3::zeros, |friction| {
            self.friction(friction, &contact(&normal, &push, i, state), i, state)
        });
        normal * push.force + along
    }

    /// Friction on node i, which the bed pushes \[N\].
    fn friction(&self, friction: &Friction, c: &Contact<'_>, i: usize, state: &State) -> V3 {
        match friction.law {
            FrictionModel::Grip(_) => match state.memory.grips.get(i) {
                Some(grip) => friction.grip_force(c, grip).0,
                None => V3::zeros(),
            },
            FrictionModel::Regularised(slip) => friction.regularised(c, slip).force,
        }
    }

    /// The same with its derivatives; nothing where the bed has no hold.
    fn held(
        &self,
        friction: &Friction,
        c: &Contact<'_>,
        i: usize,
        state: &State,
    ) -> Option<FrictionForce> {
        match friction.law {
            FrictionModel::Grip(_) => Some(friction.grip(c, state.memory.grips.get(i)?)),
            FrictionModel::Regularised(slip) => Some(friction.regularised(c, slip)),
        }
    }

    /// Has the bed take hold of every node as it stands: an accepted state.
    pub(super) fn update_grips(&self, state: &mut State) {
        let Some(bed) = &self.bed else { return };
        let Some(friction) = &bed.friction else {
            return;
        };
        let FrictionModel::Grip(stiffness) = friction.law else {
            return;
        };
        let normal = bed.normal();
        for i in 0..state.memory.grips.len() {
            let push = self.push(bed, i, state);
            let (before, after) = (i.saturating_sub(1), (i + 1).min(state.x.len() - 1));
            let along = state.x[after] - state.x[before];
            let area = self.footprint[i];
            let hold = (stiffness * area, bed.damping * area);
            let c = contact(&normal, &push, i, state);
            let grip = friction.slide_grip(&c, &state.memory.grips[i], hold, &along);
            state.memory.grips[i] = grip;
        }
    }

    /// Grips at these places, free of force, as stiff as the bed is along itself; none where it does not hold by grips.
    pub(super) fn grips_at(&self, nodes: &[V3]) -> Vec<Grip> {
        let Some(bed) = &self.bed else {
            return Vec::new();
        };
        let Some(Friction {
            law: FrictionModel::Grip(stiffness),
            ..
        }) = bed.friction
        else {
            return Vec::new();
        };
        let whole = nodes[nodes.len() - 1] - nodes[0];
        let normal = bed.normal();
        let flat = whole - normal * normal.dot(&whole);
        let along = flat.try_normalize(1e-12).unwrap_or_else(|| across(&normal));
        let grip = |(at, area): (&V3, &f64)| Grip {
            at: *at,
            along,
            stiffness: stiffness * area,
            damping: bed.damping * area,
            laid: false,
        };
        nodes.iter().zip(&self.footprint).map(grip).collect()
    }

    /// What the bed bears of the half of segment i at one of its nodes \[N\], with the pull of the segment on that node and its
    /// other load. A held end that lies on the bed does not sink into it and so is not pushed by its springs; the bed
    /// bears there what presses it down, and has friction as on the neighbouring node, no more than what it resists.
    pub(super) fn bed_force_on_half(
        &self,
        i: usize,
        node: usize,
        (pull, load): (&V3, &V3),
        state: &State,
    ) -> V3 {
        let Some(bed) = &self.bed else {
            return V3::zeros();
        };
        let segment = &self.segments[i];
        let half = 0.5 * segment.axial.length * segment.diameter;
        let last = self.segments.len();
        let end = match node {
            0 => 0,
            n if n == last => 1,
            _ => return self.bed_force(bed, node, state) * (half / self.footprint[node]),
        };
        let tall = 1e-9 * self.arc[last];
        let lies = matches!(self.ends[end], End::Prescribed(_))
            && bed.height(&state.x[node]).abs() <= tall;
        if !lies {
            return self.bed_force(bed, node, state);
        }
        let normal = bed.normal();
        let push = normal * (-normal.dot(&(pull + load))).max(0.0);
        let beside = if node == i { i + 1 } else { i };
        if beside == 0 || beside == last {
            return push;
        }
        let force = self.bed_force(bed, beside, state);
        let borne = normal.dot(&force);
        if borne <= 0.0 {
            return push;
        }
        let along = (force - normal * borne) * (normal.dot(&push) / borne);
        let (size, resisted) = (along.norm_squared(), -(pull + load).dot(&along));
        let share = if resisted > 0.0 && size > resisted {
            resisted / size
        } else {
            1.0
        };
        push + along * share
    }

    /// Energy in the springs that push \[J\].
    pub(super) fn bed_energy(&self, state: &State) -> f64 {
        let Some(bed) = &self.bed else { return 0.0 };
        let mut energy = 0.0;
        for (x, area) in state.x.iter().zip(&self.footprint) {
            energy += 0.5 * bed.stiffness * area * (-bed.height(x)).max(0.0).powi(2);
        }
        energy
    }

    /// Power that the bed takes out of the line \[W\]. What a grip holds for a while counts as taken.
    pub(super) fn bed_dissipation(&self, state: &State) -> f64 {
        let Some(bed) = &self.bed else { return 0.0 };
        let normal = bed.normal();
        let mut power = 0.0;
        for i in 0..self.footprint.len() {
            let (x, v) = (&state.x[i], &state.v[i]);
            let push = self.push(bed, i, state);
            let elastic = bed.stiffness * self.footprint[i] * (-bed.height(x)).max(0.0);
            power -= (push.force - elastic) * normal.dot(v);
            let Some(friction) = bed.friction.as_ref().filter(|_| push.force > 0.0) else {
                continue;
            };
            let force = self.friction(friction, &contact(&normal, &push, i, state), i, state);
            power -= force.dot(v);
        }
        power
    }

    /// A node that the bed would have to hold by more than friction bears, if there is one: line that has been pushed back
    /// along a slope, and slides.
    #[must_use]
    pub fn sliding_node(&self, state: &State) -> Option<usize> {
        let bed = self.bed.as_ref()?;
        let friction = bed.friction.as_ref()?;
        let normal = bed.normal();
        self.free().find(|&i| {
            let push = self.push(bed, i, state);
            let grip = state.memory.grips.get(i);
            push.force > 0.0
                && grip.is_some_and(|grip| {
                    friction.exceeds_friction(&contact(&normal, &push, i, state), grip)
                })
        })
    }

    /// The fastest rate at which the bed slows node i \[1/s\].
    pub(super) fn bed_decay_rate(&self, i: usize, state: &State) -> f64 {
        let Some(bed) = &self.bed else { return 0.0 };
        let push = self.push(bed, i, state);
        if push.force <= 0.0 {
            return 0.0;
        }
        let along = match bed.friction {
            Some(Friction {
                axial,
                law: FrictionModel::Regularised(slip),
                ..
            }) => axial * push.force / slip,
            _ => 0.0,
        };
        (bed.damping * self.footprint[i]).max(along) / self.mass[i]
    }

    /// Stiffness of the bed under node i, across or along itself \[N/m\].
    pub(super) fn bed_stiffness(&self, i: usize) -> f64 {
        self.bed.map_or(0.0, |bed| {
            let along = match bed.friction {
                Some(Friction {
                    law: FrictionModel::Grip(stiffness),
                    ..
                }) => stiffness,
                _ => 0.0,
            };
            bed.stiffness.max(along) * self.footprint[i]
        })
    }
}

/// Node i on the bed.
fn contact<'a>(normal: &'a V3, push: &'a BedReaction, i: usize, state: &'a State) -> Contact<'a> {
    Contact {
        normal,
        push,
        x: &state.x[i],
        v: &state.v[i],
    }
}

/// A unit vector in the bed.
fn across(normal: &V3) -> V3 {
    let x = V3::x() - normal * normal.x;
    x.try_normalize(1e-3).unwrap_or_else(V3::y)
}
