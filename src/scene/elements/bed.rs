//! Contact of the line with the sea bed: normal springs and dampers and friction at every node.

use crate::case::{self, FrictionLaw};
use crate::numerics::{BlockBand, V3};
use crate::physics::Seabed;
use crate::physics::bed_reaction::BedReaction;
use crate::physics::friction::{Contact, Friction, FrictionForce, FrictionModel, Grip};
use crate::scene::element::{At, Element};
use crate::scene::{End, LumpedLine, Segment};
use crate::solve::{Factors, State};

/// The sea bed and the area of line on it.
#[derive(Debug, Clone, PartialEq)]
pub struct BedContact {
    /// The sea bed.
    pub seabed: Seabed,
    /// Contact area of every node, diameter times length \[m²\].
    pub footprint: Vec<f64>,
}

/// The bed of the case.
fn seabed(bed: &case::Seabed) -> Seabed {
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

/// Contact area of every node: the diameter times the halves of its segments.
fn footprint(segments: &[Segment]) -> Vec<f64> {
    let mut area = vec![0.0; segments.len() + 1];
    for (i, segment) in segments.iter().enumerate() {
        let half = 0.5 * segment.axial.length * segment.diameter;
        area[i] += half;
        area[i + 1] += half;
    }
    area
}

impl Element for BedContact {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        if self.seabed.is_plain() {
            for (i, out) in r.iter_mut().enumerate() {
                out.z -= self.push(i, at.state).force;
            }
        } else {
            for (i, out) in r.iter_mut().enumerate() {
                *out -= self.force(i, at.state);
            }
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.add_residual(at, r);
        let (bed, state) = (&self.seabed, at.state);
        let normal = bed.normal();
        // The nodes of the line: a ship at its end has more.
        for (i, block) in tangent.diag[..self.footprint.len()].iter_mut().enumerate() {
            let push = self.push(i, state);
            let k = c.stiffness * push.by_height + c.damping * push.by_speed;
            if bed.is_plain() {
                block[(2, 2)] -= k;
                continue;
            }
            *block -= normal * (normal * k).transpose();
            if push.force > 0.0
                && let Some(friction) = &bed.friction
                && let Some(held) =
                    friction_with_tangent(friction, &contact(&normal, &push, i, state), i, state)
            {
                *block -= held.by_position * c.stiffness + held.by_velocity * c.damping;
            }
        }
    }

    fn has_explicit_form(&self) -> bool {
        true
    }

    fn decay_rate(&self, at: At<'_>, node: usize) -> f64 {
        let push = self.push(node, at.state);
        if push.force <= 0.0 {
            return 0.0;
        }
        let along = match self.seabed.friction {
            Some(Friction {
                axial,
                law: FrictionModel::Regularised(slip),
                ..
            }) => axial * push.force / slip,
            _ => 0.0,
        };
        (self.seabed.damping * self.footprint[node]).max(along) / at.line.mass[node]
    }

    fn segment_stiffness(&self, _: &LumpedLine, i: usize) -> f64 {
        self.stiffness(i).max(self.stiffness(i + 1))
    }

    /// The greatest displacement of a node in contact. Each counts in full: friction adds up along the line and is kept.
    fn equivalent_displacement(&self, at: At<'_>, d: &[V3], _: f64) -> f64 {
        let in_contact = |i: &usize| self.push(*i, at.state).force > 0.0;
        let nodes = (0..self.footprint.len()).filter(in_contact);
        nodes.map(|i| d[i].amax()).fold(0.0, f64::max)
    }

    /// Normal damping and friction. The work of a friction spring that still holds counts as dissipated.
    fn add_dissipation(&self, at: At<'_>, power: &mut f64) {
        let (bed, state) = (&self.seabed, at.state);
        let normal = bed.normal();
        let mut taken = 0.0;
        for i in 0..self.footprint.len() {
            let (x, v) = (&state.x[i], &state.v[i]);
            let push = self.push(i, state);
            let elastic = bed.stiffness * self.footprint[i] * (-bed.height(x)).max(0.0);
            taken -= (push.force - elastic) * normal.dot(v);
            let Some(law) = bed.friction.as_ref().filter(|_| push.force > 0.0) else {
                continue;
            };
            let force = friction(law, &contact(&normal, &push, i, state), i, state);
            taken -= force.dot(v);
        }
        *power += taken;
    }

    /// Moves the friction springs that slip.
    fn commit(&self, _: &LumpedLine, state: &mut State) {
        let bed = &self.seabed;
        let Some((friction, stiffness)) = self.friction_springs() else {
            return;
        };
        let normal = bed.normal();
        for i in 0..state.memory.grips.len() {
            let push = self.push(i, state);
            let (before, after) = (i.saturating_sub(1), (i + 1).min(state.x.len() - 1));
            let along = state.x[after] - state.x[before];
            let area = self.footprint[i];
            let hold = (stiffness * area, bed.damping * area);
            let c = contact(&normal, &push, i, state);
            let grip = friction.slide_grip(&c, &state.memory.grips[i], hold, &along);
            state.memory.grips[i] = grip;
        }
    }
}

impl BedContact {
    /// The bed of the case under these segments.
    pub(super) fn new(bed: &case::Seabed, segments: &[Segment]) -> Self {
        Self {
            seabed: seabed(bed),
            footprint: footprint(segments),
        }
    }

    /// Height of a point above the bed, normal to it \[m\].
    #[must_use]
    pub fn height(&self, x: &V3) -> f64 {
        self.seabed.height(x)
    }

    /// Friction by springs and their stiffness per area \[N/m³\]; none for other laws.
    fn friction_springs(&self) -> Option<(Friction, f64)> {
        let friction = self.seabed.friction?;
        match friction.law {
            FrictionModel::Grip(stiffness) => Some((friction, stiffness)),
            FrictionModel::Regularised(_) => None,
        }
    }

    /// Speed of full slip \[m/s\], for friction that depends on velocity.
    pub(in crate::scene) fn slip_speed(&self) -> Option<f64> {
        match self.seabed.friction?.law {
            FrictionModel::Regularised(slip) => Some(slip),
            FrictionModel::Grip(_) => None,
        }
    }

    /// Normal contact force on node i.
    #[inline]
    pub(in crate::scene) fn push(&self, i: usize, state: &State) -> BedReaction {
        self.seabed
            .push(&state.x[i], &state.v[i], self.footprint[i])
    }

    /// Normal contact force and friction on node i \[N\].
    pub(in crate::scene) fn force(&self, i: usize, state: &State) -> V3 {
        let push = self.push(i, state);
        if push.force <= 0.0 {
            return V3::zeros();
        }
        let normal = self.seabed.normal();
        let along = self.seabed.friction.as_ref().map_or_else(V3::zeros, |law| {
            friction(law, &contact(&normal, &push, i, state), i, state)
        });
        normal * push.force + along
    }

    /// Friction springs without force at these positions; none for other laws.
    pub(in crate::scene) fn grips_at(&self, nodes: &[V3]) -> Vec<Grip> {
        let Some((_, stiffness)) = self.friction_springs() else {
            return Vec::new();
        };
        let whole = nodes[nodes.len() - 1] - nodes[0];
        let normal = self.seabed.normal();
        let flat = whole - normal * normal.dot(&whole);
        let along = flat
            .try_normalize(1e-12)
            .unwrap_or_else(|| tangent_of(&normal));
        let grip = |(at, area): (&V3, &f64)| Grip {
            at: *at,
            along,
            stiffness: stiffness * area,
            damping: self.seabed.damping * area,
            laid: false,
        };
        nodes.iter().zip(&self.footprint).map(grip).collect()
    }

    /// Reaction of the bed on the half of segment i at one of its nodes \[N\], from the tension of the segment on that node and
    /// its other load. A prescribed end on the bed does not penetrate it, so that its springs carry nothing: the bed there
    /// bears the load normal to it, with the friction of the neighbouring node, no more than resists.
    pub(in crate::scene) fn force_on_half(
        &self,
        i: usize,
        node: usize,
        (pull, load): (&V3, &V3),
        at: At<'_>,
    ) -> V3 {
        let At { line, state, .. } = at;
        let last = line.segments.len();
        let end = match node {
            0 => 0,
            n if n == last => 1,
            _ => {
                let segment = &line.segments[i];
                let half = 0.5 * segment.axial.length * segment.diameter;
                return self.force(node, state) * (half / self.footprint[node]);
            }
        };
        let tolerance = 1e-9 * line.arc[last];
        let on_bed = matches!(line.ends[end], End::Prescribed(_))
            && self.height(&state.x[node]).abs() <= tolerance;
        if !on_bed {
            return self.force(node, state);
        }
        let normal = self.seabed.normal();
        let push = normal * (-normal.dot(&(pull + load))).max(0.0);
        let beside = if node == i { i + 1 } else { i };
        if beside == 0 || beside == last {
            return push;
        }
        let force = self.force(beside, state);
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

    /// Energy of the normal springs \[J\].
    pub(in crate::scene) fn energy(&self, state: &State) -> f64 {
        let mut energy = 0.0;
        for (x, area) in state.x.iter().zip(&self.footprint) {
            let depth = (-self.height(x)).max(0.0);
            energy += 0.5 * self.seabed.stiffness * area * depth.powi(2);
        }
        energy
    }

    /// The first of these nodes that needs more than the friction there is: line pushed back along a slope, which slides.
    pub(in crate::scene) fn sliding_node(
        &self,
        mut nodes: std::ops::Range<usize>,
        state: &State,
    ) -> Option<usize> {
        let friction = self.seabed.friction.as_ref()?;
        let normal = self.seabed.normal();
        nodes.find(|&i| {
            let push = self.push(i, state);
            let grip = state.memory.grips.get(i);
            push.force > 0.0
                && grip.is_some_and(|grip| {
                    friction.exceeds_friction(&contact(&normal, &push, i, state), grip)
                })
        })
    }

    /// Stiffness of the bed at node i, the greater of normal and tangential \[N/m\].
    fn stiffness(&self, i: usize) -> f64 {
        let along = self.friction_springs().map_or(0.0, |(_, k)| k);
        self.seabed.stiffness.max(along) * self.footprint[i]
    }
}

/// Friction on node i in contact \[N\].
fn friction(friction: &Friction, c: &Contact<'_>, i: usize, state: &State) -> V3 {
    match friction.law {
        FrictionModel::Grip(_) => match state.memory.grips.get(i) {
            Some(grip) => friction.grip_force(c, grip).0,
            None => V3::zeros(),
        },
        FrictionModel::Regularised(slip) => friction.regularised(c, slip).force,
    }
}

/// The same with its derivatives; none without a friction spring.
fn friction_with_tangent(
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

/// Contact at node i.
fn contact<'a>(normal: &'a V3, push: &'a BedReaction, i: usize, state: &'a State) -> Contact<'a> {
    Contact {
        normal,
        push,
        x: &state.x[i],
        v: &state.v[i],
    }
}

/// A unit vector in the bed.
fn tangent_of(normal: &V3) -> V3 {
    let x = V3::x() - normal * normal.x;
    x.try_normalize(1e-3).unwrap_or_else(V3::y)
}
