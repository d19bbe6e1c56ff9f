//! Contact of bodies with the sea bed: every body bears on its bottom with the stiffness, damping and friction of the bed.
//!
//! The bottom is a place below the hang point: straight below a point body, on the axis of one that rotates. Of the normal
//! force `N = k A d - c A v` (Zhu, Yin and Shen 2017, eq. 8, with the area A of the body in the place of diameter times length)
//! the law is that of the line; see [`ElasticBed::push_at`]. Friction is the same along all directions.
//!
//! Suction, where a body has it, holds it once it has borne on the bed: see [`Suction`].

use super::bed::seabed;
use super::rigid_payload::RigidPayload;
use crate::case::{self, Case, EndKind};
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::bed_friction::{
    Friction, FrictionAnchor, FrictionContact, FrictionForce, FrictionModel,
};
use crate::physics::bed_reaction::BedReaction;
use crate::physics::{ElasticBed, RigidBody, Suction};
use crate::scene::LumpedLine;
use crate::scene::bodies;
use crate::scene::element::{At, Element};
use crate::solve::{BodyOnBed, Factors, State};

/// The bodies that may bear on the bed.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyContact {
    /// The sea bed; its friction is that along the line, in all directions.
    pub seabed: ElasticBed,
    /// The bodies, clumps in the order of the case and then the payload.
    pub bodies: Vec<BearingBody>,
}

/// A body and the part of it that bears on the bed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingBody {
    /// The node of its hang point.
    pub node: usize,
    /// Place of its bottom on the rod from that node to the next one \[-\]; 0 for a point body.
    pub place: f64,
    /// Height of the node above the bottom of a point body \[m\].
    pub below: f64,
    /// Area that bears \[m²\].
    pub area: f64,
    /// Suction of the bed on it.
    pub suction: Suction,
}

/// Normal and tangential force on a body, with its derivatives.
struct Reaction {
    force: V3,
    by_position: M3,
    by_velocity: M3,
}

impl Element for BodyContact {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        for (number, body) in self.bodies.iter().enumerate() {
            if let Some(reaction) = self.reaction(number, at.state) {
                for (node, share) in body.nodes() {
                    r[node] -= reaction.force * share;
                }
            }
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        for (number, body) in self.bodies.iter().enumerate() {
            let Some(reaction) = self.reaction(number, at.state) else {
                continue;
            };
            let block = reaction.by_position * c.stiffness + reaction.by_velocity * c.damping;
            for (node, share) in body.nodes() {
                r[node] -= reaction.force * share;
                tangent.diag[node] -= block * (share * share);
            }
            if body.place != 0.0 {
                let [near, far] = RigidBody::shares(body.place);
                let coupled = block * (near * far);
                tangent.upper[body.node] -= coupled;
                tangent.lower[body.node + 1] -= coupled;
            }
        }
    }

    fn decay_rate(&self, at: At<'_>, node: usize) -> f64 {
        let rate = |(number, body): (usize, &BearingBody)| {
            let (_, share) = body.nodes().find(|(own, _)| *own == node)?;
            let reaction = self.reaction(number, at.state)?;
            Some(-reaction.by_velocity.trace() * share * share / at.line.mass[node])
        };
        let bodies = self.bodies.iter().enumerate();
        bodies.filter_map(rate).sum()
    }

    fn node_stiffness(&self, node: usize) -> f64 {
        let stiffness = |body: &BearingBody| {
            let (_, share) = body.nodes().find(|(own, _)| *own == node)?;
            Some(self.stiffness(body) * share * share)
        };
        self.bodies.iter().filter_map(stiffness).sum()
    }

    fn equivalent_displacement(&self, at: At<'_>, d: &[V3], stiffest: f64) -> f64 {
        let touching = |body: &&BearingBody| self.height(body, at.state) < body.suction.distance;
        let bodies = self.bodies.iter().filter(touching);
        let moved =
            |body: &BearingBody| body.motion(d).amax() * (self.stiffness(body) / stiffest).max(1.0);
        bodies.map(moved).fold(0.0, f64::max)
    }

    fn add_energy(&self, at: At<'_>, energy: &mut f64) {
        for body in &self.bodies {
            let depth = (-self.height(body, at.state)).max(0.0);
            *energy += 0.5 * self.seabed.stiffness * body.area * depth * depth;
        }
    }

    /// Normal damping, friction and suction; their springs count as dissipated, as for the line. A body that leaves faster than
    /// the damping lets the bed follow has no reaction, and the energy of the spring is lost.
    fn add_dissipation(&self, at: At<'_>, power: &mut f64) {
        for (number, body) in self.bodies.iter().enumerate() {
            let gradient = self.gradient(body, at.state);
            let force = self.reaction(number, at.state).map(|r| r.force);
            let depth = (-self.height(body, at.state)).max(0.0);
            if force.is_none() && depth == 0.0 {
                continue;
            }
            let elastic = gradient * (self.seabed.stiffness * body.area * depth);
            let viscous = force.unwrap_or_else(V3::zeros) - elastic;
            *power -= viscous.dot(&body.motion(&at.state.v));
        }
    }

    fn add_end_force(&self, at: At<'_>, node: usize, force: &mut V3) {
        for (number, body) in self.bodies.iter().enumerate() {
            if let Some((_, share)) = body.nodes().find(|(own, _)| *own == node) {
                let reaction = self.reaction(number, at.state);
                *force += reaction.map_or_else(V3::zeros, |reaction| reaction.force * share);
            }
        }
    }

    fn commit(&self, _: &LumpedLine, state: &mut State) {
        if state.memory.bodies.len() < self.bodies.len() {
            let all = 0..self.bodies.len();
            state.memory.bodies = all.map(|number| self.history(number, state)).collect();
            return;
        }
        for number in 0..self.bodies.len() {
            state.memory.bodies[number] = self.history(number, state);
        }
    }
}

impl BodyContact {
    /// The bodies of the case, clumps at these nodes; none without a bed or without bodies.
    pub(super) fn of_case(
        case: &Case,
        clumps: &[usize],
        payload: Option<&RigidPayload>,
        last: usize,
    ) -> Option<Self> {
        let mut seabed = seabed(case.seabed.as_ref()?, &case.files);
        if let Some(friction) = &mut seabed.friction {
            friction.lateral = friction.axial;
        }
        let water = &case.environment;
        let clumps = case.clumps.iter().zip(clumps);
        let mut bodies: Vec<BearingBody> = clumps
            .map(|(clump, node)| BearingBody {
                node: *node,
                place: 0.0,
                below: clump.bottom_m,
                area: bodies::clump_bed_area(clump, water),
                suction: Suction {
                    greatest: clump.breakout_n,
                    distance: clump.breakout_distance_m,
                },
            })
            .collect();
        let hung = case.payload.as_ref();
        let hung = hung.filter(|_| case.ends.b.kind == EndKind::Payload);
        bodies.extend(hung.map(|body| BearingBody::payload(body, payload, last, water)));
        (!bodies.is_empty()).then_some(Self { seabed, bodies })
    }

    /// The history of bodies that nothing holds yet.
    pub(in crate::scene) fn history_at_start(&self, state: &State) -> Vec<BodyOnBed> {
        let at_start = |number: usize| {
            let history = self.history(number, state);
            BodyOnBed {
                grip: FrictionAnchor {
                    stiffness: 0.0,
                    damping: 0.0,
                    ..history.grip
                },
                stuck: false,
                landing_speed: 0.0,
                ..history
            }
        };
        (0..self.bodies.len()).map(at_start).collect()
    }

    /// The same without friction.
    pub(in crate::scene) fn without_friction(&self) -> Self {
        Self {
            seabed: ElasticBed {
                friction: None,
                ..self.seabed.clone()
            },
            bodies: self.bodies.clone(),
        }
    }

    /// Normal force of the bed on a body by its number \[N\], negative where suction holds it.
    pub(in crate::scene) fn normal_force(&self, number: usize, state: &State) -> f64 {
        let body = &self.bodies[number];
        let push = self.push(body, state);
        push.force - self.suction(body, state.memory.bodies.get(number), state).0
    }

    /// The same on all bodies at a node.
    pub(in crate::scene) fn normal_force_at(&self, node: usize, state: &State) -> f64 {
        let here = self
            .bodies
            .iter()
            .enumerate()
            .filter(|(_, body)| body.node == node);
        here.map(|(number, _)| self.normal_force(number, state))
            .sum()
    }

    /// Height of the bottom of a body above the bed \[m\].
    fn height(&self, body: &BearingBody, state: &State) -> f64 {
        self.seabed.height(&body.bottom(&state.x))
    }

    /// Normal of the bed below a body.
    fn normal(&self, body: &BearingBody, state: &State) -> V3 {
        self.seabed.normal(&body.bottom(&state.x))
    }

    /// Derivative of the height of a body above the bed by its place.
    fn gradient(&self, body: &BearingBody, state: &State) -> V3 {
        self.seabed.gradient(&body.bottom(&state.x))
    }

    fn push(&self, body: &BearingBody, state: &State) -> BedReaction {
        let (x, v) = (body.bottom(&state.x), body.motion(&state.v));
        self.seabed.push(&x, &v, body.area)
    }

    /// Pull of suction \[N\] and its derivative by the height \[N/m\].
    fn suction(
        &self,
        body: &BearingBody,
        history: Option<&BodyOnBed>,
        state: &State,
    ) -> (f64, f64) {
        match history.is_some_and(|history| history.stuck) {
            true => body.suction.pull(self.height(body, state)),
            false => (0.0, 0.0),
        }
    }

    fn friction_on(&self, number: usize, state: &State) -> Option<FrictionForce> {
        let body = &self.bodies[number];
        let friction = self.seabed.friction.as_ref()?;
        let push = self.push(body, state);
        let grip = state.memory.bodies.get(number).map(|h| &h.grip);
        if push.force <= 0.0 {
            return None;
        }
        self.with_contact(body, &push, state, |c| friction.with_tangent(c, grip))
    }

    /// Evaluates a friction law at the contact of a body.
    fn with_contact<T>(
        &self,
        body: &BearingBody,
        push: &BedReaction,
        state: &State,
        law: impl FnOnce(&FrictionContact<'_>) -> T,
    ) -> T {
        let (x, v) = (&body.bottom(&state.x), &body.motion(&state.v));
        law(&FrictionContact {
            normal: &self.normal(body, state),
            push,
            x,
            v,
            curved: self.seabed.curved(x, v, push),
        })
    }

    /// Force on a body by its number, with its derivatives by position and velocity of its bottom.
    fn reaction(&self, number: usize, state: &State) -> Option<Reaction> {
        let body = &self.bodies[number];
        let push = self.push(body, state);
        let suction = self.suction(body, state.memory.bodies.get(number), state);
        if push.force <= 0.0 && suction == (0.0, 0.0) {
            return None;
        }
        let (x, v) = (body.bottom(&state.x), body.motion(&state.v));
        let held = BedReaction {
            force: push.force - suction.0,
            by_height: push.by_height - suction.1,
            ..push
        };
        let [by_position, by_velocity] = self.seabed.slopes(&x, &v, &held);
        let mut reaction = Reaction {
            force: self.seabed.gradient(&x) * held.force,
            by_position,
            by_velocity,
        };
        if let Some(held) = self.friction_on(number, state) {
            reaction.force += held.force;
            reaction.by_position += held.by_position;
            reaction.by_velocity += held.by_velocity;
        }
        Some(reaction)
    }

    /// The friction spring of a body from now on.
    fn grip(&self, number: usize, state: &State) -> FrictionAnchor {
        let body = &self.bodies[number];
        let x = body.bottom(&state.x);
        let (hold, damping) = self.hold(body);
        let known = state.memory.bodies.get(number).map(|h| h.grip);
        let push = self.push(body, state);
        match (self.seabed.friction, known) {
            (Some(friction), Some(grip)) if push.force > 0.0 && grip.stiffness > 0.0 => self
                .with_contact(body, &push, state, |c| {
                    friction.slide_grip(c, &grip, (hold, damping), &V3::x())
                }),
            _ => FrictionAnchor {
                at: x,
                along: V3::x(),
                stiffness: hold,
                damping,
                laid: false,
                slip: 0.0,
            },
        }
    }

    /// Stiffness \[N/m\] and damping \[N s/m\] of the friction spring of a body; 0 without one.
    fn hold(&self, body: &BearingBody) -> (f64, f64) {
        match self.seabed.friction {
            Some(Friction {
                law: FrictionModel::ElasticPlastic(stiffness),
                ..
            }) => (stiffness * body.area, self.seabed.damping * body.area),
            _ => (0.0, 0.0),
        }
    }

    /// The history of a body after a step that is accepted.
    fn history(&self, number: usize, state: &State) -> BodyOnBed {
        let body = &self.bodies[number];
        let normal = self.gradient(body, state);
        let height = self.height(body, state);
        let known = state.memory.bodies.get(number);
        let stuck = known.is_some_and(|history| history.stuck);
        let mut history = BodyOnBed {
            grip: self.grip(number, state),
            stuck: body.suction.holds(stuck, height),
            height: known.map_or([0.0; 3], |h| h.height),
            landing_speed: known.map_or(0.0, |h| h.landing_speed),
        };
        history.update([
            height,
            normal.dot(&body.motion(&state.v)),
            normal.dot(&body.motion(&state.a)),
        ]);
        history
    }

    /// Elastic stiffness of a body in contact \[N/m\], along or across the bed.
    fn stiffness(&self, body: &BearingBody) -> f64 {
        (self.seabed.stiffness * body.area)
            .max(self.hold(body).0)
            .max(body.suction.stiffness())
    }
}

impl BearingBody {
    /// The payload at the last node of the line.
    fn payload(
        body: &case::Payload,
        rigid: Option<&RigidPayload>,
        node: usize,
        water: &case::Environment,
    ) -> Self {
        let (place, below) = match (rigid, body.bottom_m) {
            (None, bottom) => (0.0, bottom.unwrap_or(0.0)),
            (Some(rigid), Some(bottom)) => (bottom / rigid.body.reach, 0.0),
            (Some(rigid), None) => (rigid.body.centre, 0.0),
        };
        Self {
            node,
            place,
            below,
            area: bodies::payload_bed_area(body, water),
            suction: Suction {
                greatest: body.breakout_n,
                distance: body.breakout_distance_m,
            },
        }
    }

    /// The nodes that move with its bottom, each with its share.
    fn nodes(&self) -> impl Iterator<Item = (usize, f64)> + use<> {
        let nodes = (self.node..).zip(RigidBody::shares(self.place));
        nodes.take(if self.place == 0.0 { 1 } else { 2 })
    }

    /// Velocity or acceleration of its bottom from those of the nodes.
    fn motion(&self, values: &[V3]) -> V3 {
        self.nodes().map(|(node, share)| values[node] * share).sum()
    }

    /// Position of its bottom \[m\].
    fn bottom(&self, x: &[V3]) -> V3 {
        self.motion(x) - V3::z() * self.below
    }
}
