//! Contact of the line with the sea bed: normal springs and dampers and friction at every node.

use std::collections::BTreeMap;

use crate::case::{self, FrictionLaw};
use crate::numerics::lanes::outer;
use crate::numerics::{BlockBand, V3};
use crate::physics::ElasticBed;
use crate::physics::bed_friction::{
    Friction, FrictionAnchor, FrictionContact, FrictionForce, FrictionModel,
};
use crate::physics::bed_reaction::BedReaction;
use crate::scene::element::{At, Element};
use crate::scene::{EndCondition, LumpedLine, Segment};
use crate::solve::{Factors, State};

/// The files that a case carries, by their names.
pub(super) type Attachments = BTreeMap<String, case::Attachment>;

/// The sea bed and the area of line on it.
#[derive(Debug, Clone, PartialEq)]
pub struct BedContact {
    /// The sea bed.
    pub seabed: ElasticBed,
    /// Contact area of every node, diameter times length \[m²\].
    pub footprint: Vec<f64>,
    /// Whether iterations take the secant of friction for its derivative, as where line slides far at rest.
    pub secant: bool,
}

/// The half of a segment at one of its nodes, and what acts on it beside the bed.
pub(in crate::scene) struct HalfSegment {
    /// The segment.
    pub(in crate::scene) segment: usize,
    /// The node.
    pub(in crate::scene) node: usize,
    /// Unit vector along the segment.
    pub(in crate::scene) tangent: V3,
    /// Pull of the segment on the node \[N\].
    pub(in crate::scene) pull: V3,
    /// Weight, drag and (negative) inertia of the half \[N\].
    pub(in crate::scene) load: V3,
}

/// The bed of the case.
pub(super) fn seabed(bed: &case::Seabed, files: &Attachments) -> ElasticBed {
    let angles = [bed.slope_deg, bed.slope_azimuth_deg].map(f64::to_radians);
    let plane = ElasticBed::plane((bed.depth_m, bed.depth_at_m), angles);
    let friction = bed
        .friction
        .filter(|axial| *axial > 0.0 || bed.friction_lateral.is_some_and(|lateral| lateral > 0.0));
    ElasticBed {
        z: plane.map_or(-bed.depth_m, |(z, _)| z),
        slope: plane.map(|(_, normal)| normal),
        // Its file was read with the case.
        grid: case::depth_grid(bed.depths(), files).ok().flatten(),
        stiffness: bed.stiffness_n_per_m3,
        damping: bed.damping_n_s_per_m3,
        friction: friction.map(|axial| Friction {
            axial,
            lateral: bed.friction_lateral.unwrap_or(axial),
            law: match bed.friction_law {
                FrictionLaw::Grip => FrictionModel::ElasticPlastic(
                    bed.grip_stiffness_n_per_m3
                        .unwrap_or(bed.stiffness_n_per_m3),
                ),
                FrictionLaw::Zhu2017 => FrictionModel::Regularised(bed.slip_speed_m_per_s),
            },
        }),
    }
}

/// Contact area of every node: the width that bears times the halves of its segments.
fn footprint(segments: &[Segment]) -> Vec<f64> {
    let mut area = vec![0.0; segments.len() + 1];
    for (i, segment) in segments.iter().enumerate() {
        let half = 0.5 * segment.axial.length * segment.bearing_width;
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
        let (bed, state) = (&self.seabed, at.state);
        // The nodes of the line: a ship at its end has more.
        let nodes = tangent.diag[..self.footprint.len()].iter_mut().zip(r);
        for (i, (block, out)) in nodes.enumerate() {
            let push = self.push(i, state);
            if bed.is_plain() {
                out.z -= push.force;
                block[(2, 2)] -= c.stiffness * push.by_height + c.damping * push.by_speed;
                continue;
            }
            if push.force <= 0.0 {
                continue;
            }
            let (x, v) = (&state.x[i], &state.v[i]);
            let mut force = bed.gradient(x) * push.force;
            let normal = bed.normal(x);
            if bed.grid.is_none() {
                let k = c.stiffness * push.by_height + c.damping * push.by_speed;
                *block -= outer(&normal, &(normal * k));
            } else {
                let [by_position, by_velocity] = bed.slopes(x, v, &push);
                *block -= by_position * c.stiffness + by_velocity * c.damping;
            }
            if let Some(held) = self.friction_on(i, (&normal, &push), state) {
                force += held.force;
                *block -= held.by_position * c.stiffness + held.by_velocity * c.damping;
            }
            *out -= force;
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
        let mut taken = 0.0;
        for i in 0..self.footprint.len() {
            let (x, v) = (&state.x[i], &state.v[i]);
            let depth = -bed.height(x);
            if depth <= 0.0 {
                continue;
            }
            let push = self.push(i, state);
            let normal = bed.normal(x);
            let elastic = bed.stiffness * self.footprint[i] * depth;
            taken -= (push.force - elastic) * bed.gradient(x).dot(v);
            let Some(law) = bed.friction.as_ref().filter(|_| push.force > 0.0) else {
                continue;
            };
            let force = law.force(
                &contact(bed, (&normal, &push), i, state),
                state.memory.grips.get(i),
            );
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
        for i in 0..state.memory.grips.len() {
            let push = self.push(i, state);
            let normal = bed.normal(&state.x[i]);
            let (before, after) = (i.saturating_sub(1), (i + 1).min(state.x.len() - 1));
            let along = state.x[after] - state.x[before];
            let area = self.footprint[i];
            let hold = (stiffness * area, bed.damping * area);
            let c = contact(bed, (&normal, &push), i, state);
            let grip = friction.slide_grip(&c, &state.memory.grips[i], hold, &along);
            state.memory.grips[i] = grip;
        }
    }
}

impl BedContact {
    /// The bed of the case under these segments.
    pub(super) fn new((bed, files): (&case::Seabed, &Attachments), segments: &[Segment]) -> Self {
        Self {
            seabed: seabed(bed, files),
            footprint: footprint(segments),
            secant: false,
        }
    }

    /// Height of a point above the bed, normal to it \[m\].
    #[must_use]
    pub fn height(&self, x: &V3) -> f64 {
        self.seabed.height(x)
    }

    /// Whether its friction holds at rest, about anchors.
    pub(in crate::scene) fn holds_at_rest(&self) -> bool {
        self.friction_springs().is_some()
    }

    /// Friction by springs and their stiffness per area \[N/m³\]; none for other laws.
    fn friction_springs(&self) -> Option<(Friction, f64)> {
        let friction = self.seabed.friction?;
        match friction.law {
            FrictionModel::ElasticPlastic(stiffness) => Some((friction, stiffness)),
            FrictionModel::Regularised(_) => None,
        }
    }

    /// Friction on node i with its derivatives, or with its secant; nothing without friction, or where nothing holds.
    #[inline]
    pub(super) fn friction_on(
        &self,
        i: usize,
        (normal, push): (&V3, &BedReaction),
        state: &State,
    ) -> Option<FrictionForce> {
        let friction = self.seabed.friction.as_ref()?;
        let contact = contact(&self.seabed, (normal, push), i, state);
        let grip = state.memory.grips.get(i);
        match self.secant {
            true => friction.with_secant(&contact, grip),
            false => friction.with_tangent(&contact, grip),
        }
    }

    /// Speed of full slip \[m/s\], for friction that depends on velocity.
    pub(in crate::scene) fn slip_speed(&self) -> Option<f64> {
        match self.seabed.friction?.law {
            FrictionModel::Regularised(slip) => Some(slip),
            FrictionModel::ElasticPlastic(_) => None,
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
        let normal = self.seabed.normal(&state.x[i]);
        let along = self.seabed.friction.as_ref().map_or_else(V3::zeros, |law| {
            law.force(
                &contact(&self.seabed, (&normal, &push), i, state),
                state.memory.grips.get(i),
            )
        });
        self.seabed.gradient(&state.x[i]) * push.force + along
    }

    /// Friction springs without force at these positions; none for other laws.
    pub(in crate::scene) fn grips_at(&self, nodes: &[V3]) -> Vec<FrictionAnchor> {
        let Some((_, stiffness)) = self.friction_springs() else {
            return Vec::new();
        };
        let whole = nodes[nodes.len() - 1] - nodes[0];
        let normal = self.seabed.normal(&nodes[0]);
        let flat = whole - normal * normal.dot(&whole);
        let along = flat
            .try_normalize(1e-12)
            .unwrap_or_else(|| tangent_of(&normal));
        let grip = |(at, area): (&V3, &f64)| FrictionAnchor {
            at: *at,
            along,
            stiffness: stiffness * area,
            damping: self.seabed.damping * area,
            laid: false,
            slip: 0.0,
        };
        nodes.iter().zip(&self.footprint).map(grip).collect()
    }

    /// Reaction of the bed that bears the half of a segment at one of its nodes \[N\]: the node's by the share of the half in
    /// its footprint, but no more than bears the load of the half across it. What the bed bears beyond that is a body at the
    /// node, or a line that stands on its end: no tension. An end held on the bed has no penetration: see
    /// [`BedContact::force_on_end`].
    pub(in crate::scene) fn reaction_on_half(&self, half: &HalfSegment, at: At<'_>) -> V3 {
        if self.end_held_on_bed(half.node, at).is_some() {
            return self.force_on_end(half.node, (&half.pull, &half.load), at);
        }
        let whole = self.force(half.node, at.state);
        if whole == V3::zeros() {
            return whole;
        }
        let segment = &at.line.segments[half.segment];
        let share = 0.5 * segment.axial.length * segment.bearing_width / self.footprint[half.node];
        let force = whole * share;
        let normal = self.seabed.normal(&at.state.x[half.node]);
        let borne = normal.dot(&force);
        let upright = normal.dot(&half.tangent).powi(2);
        let needed = (-normal.dot(&half.load)).max(0.0) * (1.0 - upright);
        if borne > needed {
            force * (needed / borne)
        } else {
            force
        }
    }

    /// Which end is held at a node, where it is held on the bed: it does not penetrate, so that its springs carry nothing.
    pub(super) fn end_held_on_bed(&self, node: usize, at: At<'_>) -> Option<usize> {
        let last = at.line.segments.len();
        let end = match node {
            0 => 0,
            n if n == last => 1,
            _ => return None,
        };
        let tolerance = 1e-9 * at.line.arc[last];
        let held = matches!(at.line.ends[end], EndCondition::Prescribed(_))
            && self.height(&at.state.x[node]).abs() <= tolerance;
        held.then_some(end)
    }

    /// Reaction of the bed on the first or last node \[N\], from the tension of its segment and the other load on it. Where an
    /// end is held on the bed, the bed bears the load normal to it, with the friction of the neighbouring node, no more than
    /// resists.
    pub(in crate::scene) fn force_on_end(
        &self,
        node: usize,
        (pull, load): (&V3, &V3),
        at: At<'_>,
    ) -> V3 {
        let Some(end) = self.end_held_on_bed(node, at) else {
            return self.force(node, at.state);
        };
        let last = at.line.segments.len();
        let normal = self.seabed.normal(&at.state.x[node]);
        let push = normal * (-normal.dot(&(pull + load))).max(0.0);
        let beside = if end == 0 { 1 } else { last - 1 };
        // Over a grid that node is pushed another way, which is no friction.
        if beside == 0 || beside == last || self.seabed.is_smooth_grid() {
            return push;
        }
        let force = self.force(beside, at.state);
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
        let nodes = state.x.iter().zip(&self.footprint);
        nodes.map(|(x, area)| self.energy_under(x, *area)).sum()
    }

    /// The same under a node on this area \[m²\].
    pub(super) fn energy_under(&self, x: &V3, area: f64) -> f64 {
        let depth = (-self.height(x)).max(0.0);
        0.5 * self.seabed.stiffness * area * depth.powi(2)
    }

    /// The first of these nodes that needs more than the friction there is: line pushed back along a slope, which slides.
    pub(in crate::scene) fn sliding_node(
        &self,
        mut nodes: std::ops::Range<usize>,
        state: &State,
    ) -> Option<usize> {
        let friction = self.seabed.friction.as_ref()?;
        nodes.find(|&i| {
            let push = self.push(i, state);
            let normal = self.seabed.normal(&state.x[i]);
            let grip = state.memory.grips.get(i);
            push.force > 0.0
                && grip.is_some_and(|grip| {
                    let contact = contact(&self.seabed, (&normal, &push), i, state);
                    friction.exceeds_friction(&contact, grip)
                })
        })
    }

    /// Stiffness of the bed at node i, the greater of normal and tangential \[N/m\].
    fn stiffness(&self, i: usize) -> f64 {
        let along = self.friction_springs().map_or(0.0, |(_, k)| k);
        self.seabed.stiffness.max(along) * self.footprint[i]
    }
}

/// Contact at node i, with the normal of the bed there and its push.
fn contact<'a>(
    bed: &ElasticBed,
    (normal, push): (&'a V3, &'a BedReaction),
    i: usize,
    state: &'a State,
) -> FrictionContact<'a> {
    let (x, v) = (&state.x[i], &state.v[i]);
    FrictionContact {
        normal,
        push,
        x,
        v,
        curved: bed.curved(x, v, push),
    }
}

/// A unit vector in the bed.
fn tangent_of(normal: &V3) -> V3 {
    let x = V3::x() - normal * normal.x;
    x.try_normalize(1e-3).unwrap_or_else(V3::y)
}
