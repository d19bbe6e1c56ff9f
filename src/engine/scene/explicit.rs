//! Explicit right-hand side: accelerations, and the stability limits of the time step.

use std::ops::Range;

use nalgebra::Vector6;

use super::body_added_mass::BodyAddedMass;
use super::segment_block::SegmentPass;
use super::water::BodyInWater;
use super::{AttachedBody, EndCondition, LumpedLine, Scene};
use crate::numerics::{M3, V3};
use crate::solve::State;

impl Scene {
    /// Accelerations of the free nodes, `a = M(x)^-1 f(x, v)`: the mass of a node is a 3 x 3 block, since added mass is lumped.
    /// Elements that couple nodes by their mass are corrected for afterwards.
    pub(super) fn accelerations(&self, t: f64, state: &mut State) {
        let last = self.line.nodes() - 1;
        let held = [state.a[0], state.a[last]];
        if self.line.is_plain(state) {
            self.accelerations_as::<true>(t, state);
        } else {
            self.accelerations_as::<false>(t, state);
        }
        let free = self.line.free();
        for (end, node) in [0, last].into_iter().enumerate() {
            if !free.contains(&node) {
                state.a[node] = held[end];
            }
        }
    }

    /// The same for all nodes; see [`LumpedLine::is_plain`].
    #[inline(always)]
    fn accelerations_as<const PLAIN: bool>(&self, t: f64, state: &mut State) {
        let preloaded = self.preload(t, state);
        let mut bodies = self.line.bodies.iter().enumerate().peekable();
        let (mut f, mut m) = (V3::zeros(), SymmetricBlock::default());
        let mut pass = SegmentPass::<PLAIN>::new(&self.line, state);
        for i in 0..self.line.nodes() {
            // Force and mass of node i: from the segment before, then from the segment after.
            let (mut beyond, mut next) = (V3::zeros(), SymmetricBlock::default());
            f.z -= self.line.weight[i];
            m.add_diagonal(self.line.mass[i]);
            if preloaded {
                f -= state.a[i];
            }
            if let Some(bed) = &self.elements.bed {
                f += bed.force(i, state);
            }
            if i < self.line.segments.len() {
                let segment = pass.segment(i, &self.line, state);
                let (chord, along) = (segment.chord, &segment.chord.tangent);
                let pull = along * self.line.tension_as::<PLAIN>(i, chord, t, state).0.value;
                let (wet, drag) = self.line.drag_as::<PLAIN>(i, &segment, state);
                let [here, there] = drag.forces();
                let added = self.line.added(i, wet.as_ref());
                m.add_directed(along, added[0].normal, added[0].tangential);
                next.add_directed(along, added[1].normal, added[1].tangential);
                f += pull + here;
                beyond = there - pull;
                if !PLAIN && self.line.water.is_some() {
                    f += self.line.wave_force(i, 0, along, wet.as_ref(), state);
                    beyond += self.line.wave_force(i, 1, along, wet.as_ref(), state);
                }
            }
            while let Some((number, AttachedBody { body, .. })) =
                bodies.next_if(|(_, h)| h.node == i)
            {
                let BodyInWater {
                    u,
                    carried,
                    share,
                    load,
                    ..
                } = self.line.body_in_water(number, state);
                let added = self.line.body_added_mass(number, state);
                f += (body.drag(&u) + added.force(&carried)) * share + load;
                m.add_body(&added, share);
            }
            state.a[i] = m.solve(&f);
            (f, m) = (beyond, next);
        }
    }

    /// Acceleration of a free node by a force on it, with added mass and bodies, without a traveller \[1/kg\].
    #[must_use]
    pub fn inverse_mass(&self, node: usize, state: &State) -> M3 {
        if let Some(rigid_payload) = self
            .elements
            .rigid_payload
            .as_ref()
            .filter(|t| t.node == node)
        {
            return rigid_payload.inverse_mass(&self.line, state)[0];
        }
        let m = self.line.mass_of(node, state);
        M3::from_columns(&[V3::x(), V3::y(), V3::z()].map(|axis| m.solve(&axis)))
    }

    /// Writes the residual of the elements without an explicit form of their own to where the accelerations will be: it must be
    /// complete before the first node is solved for. Whether there are any.
    fn preload(&self, t: f64, state: &mut State) -> bool {
        let mut r = std::mem::take(&mut state.a);
        let mut any = false;
        for element in self.elements.iter().filter(|e| !e.has_explicit_form()) {
            if !any {
                r.fill(V3::zeros());
                any = true;
            }
            element.add_residual(self.at(t, state), &mut r);
        }
        state.a = r;
        any
    }

    /// An upper bound of the rate at which damping slows one of these nodes \[1/s\], and the node: `dF/du / m` with the whole relative
    /// velocity counted as normal or as tangential, whichever gives more, and without added mass; for ropes, at least their
    /// present axial frequency.
    #[must_use]
    pub fn fastest_drag_decay(&self, nodes: Range<usize>, state: &State) -> (f64, usize) {
        let (line, at) = (&self.line, self.at(state.memory.time, state));
        let last = line.nodes() - 1;
        let mut fastest = (0.0, 0);
        for node in nodes {
            let speed = (line.water_at(node, state) - state.v[node]).norm();
            let halves = line.segments[node.saturating_sub(1)..(node + 1).min(last)].iter();
            let mut drag: f64 = halves
                .map(|s| 0.5 * s.axial.length * s.drag.greatest(speed))
                .sum();
            let here = line.bodies.iter().filter(|hung| hung.node == node);
            drag += here.map(|hung| hung.body.drag.amax()).sum::<f64>();
            let by_elements = self.elements.iter().map(|e| e.decay_rate(at, node));
            let mut rate = by_elements.fold(2.0 * drag * speed / line.mass[node], |a, b| a + b);
            if !line.laws.is_empty() {
                rate = rate.max(line.rope_frequency(node, state));
            }
            if rate > fastest.0 {
                fastest = (rate, node);
            }
        }
        if let Some(payload) = &self.elements.rigid_payload {
            let rate = payload.decay(line, state);
            if rate > fastest.0 {
                fastest = (rate, payload.node);
            }
        }
        fastest
    }

    /// Stiffness of the elements at segment i in its highest mode \[N/m\].
    fn other_stiffness(&self, i: usize) -> f64 {
        let elements = self.elements.iter();
        elements.map(|e| e.segment_stiffness(&self.line, i)).sum()
    }

    /// Square of the frequency of a node on what the elements add to it alone \[rad²/s²\]: eigenvalues of a sum are no more than
    /// the sums of the greatest (Weyl).
    fn own_frequency_squared(&self, node: usize) -> f64 {
        let stiffness: f64 = self.elements.iter().map(|e| e.node_stiffness(node)).sum();
        stiffness / self.line.mass[node]
    }

    /// The stability limit of the time step of classical Runge-Kutta of order 4 \[s\], and the segment that
    /// sets it. Highest axial frequency of a segment between nodes of masses m1, m2:
    /// `omega² = 2 (EA/l) (1/m1 + 1/m2)` (Gershgorin, exact for a uniform line; added mass does not count along
    /// the line), damping ratio `zeta = C omega / (2 EA)`. The limit is 2.785 / omega, less with damping:
    /// both roots of `s² + 2 zeta omega s + omega²` must lie in the stability region, whose real axis
    /// ends at -2.785 too.
    #[must_use]
    pub fn explicit_limit(&self) -> (f64, usize) {
        let ends = [0, 1].map(|end| match self.line.ends[end] {
            EndCondition::Prescribed(_) => f64::INFINITY,
            _ => self.line.mass[end * self.line.segments.len()],
        });
        self.explicit_limit_between(ends)
    }

    /// The same with these masses at the ends \[kg\], infinite where they are prescribed: with what else moves with them.
    #[must_use]
    pub fn explicit_limit_between(&self, ends: [f64; 2]) -> (f64, usize) {
        let mut limit = (f64::INFINITY, 0);
        let last = self.line.segments.len();
        let mass = |node: usize| match node {
            0 => ends[0],
            node if node == last => ends[1],
            node => self.line.mass[node],
        };
        for (i, segment) in self.line.segments.iter().enumerate() {
            let sum = 1.0 / mass(i) + 1.0 / mass(i + 1);
            let axial = 2.0 * segment.axial.ea / segment.axial.length;
            let own = self
                .own_frequency_squared(i)
                .max(self.own_frequency_squared(i + 1));
            let omega = ((axial + self.other_stiffness(i)) * sum + own).sqrt();
            let zeta = 0.5 * segment.axial.damping * omega / segment.axial.ea;
            let fastest = omega * (zeta + (zeta * zeta + 1.0).sqrt()).max(1.0);
            let step = 2.785 / fastest;
            if step < limit.0 {
                limit = (step, i);
            }
        }
        limit
    }

    /// Corrects the accelerations of both nodes of a rigid payload, which it couples.
    pub(super) fn accelerate_rigid_payload(&self, state: &mut State) {
        let Some(payload) = &self.elements.rigid_payload else {
            return;
        };
        let node = payload.node;
        let balance = payload.balance(&self.line, state, [V3::zeros(); 2]);
        let mut force = Vector6::zeros();
        for (i, balance) in balance.into_iter().enumerate() {
            let own = self.line.own_mass(node + i, state) * state.a[node + i] - balance;
            force.fixed_rows_mut::<3>(3 * i).copy_from(&own);
        }
        let mass = payload.coupled_mass(&self.line, state);
        if let Some(a) = mass.lu().solve(&force) {
            for i in 0..2 {
                state.a[node + i] = a.fixed_rows::<3>(3 * i).into_owned();
            }
        }
    }

    /// Corrects the accelerations of the nodes beside a traveller, which its mass couples.
    pub(super) fn accelerate_traveller(&self, t: f64, state: &mut State) {
        let Some(traveller) = &self.elements.traveller else {
            return;
        };
        let point = traveller.path_point(&self.line, t, state);
        let held = |node: usize| !self.line.free().contains(&node);
        let mut give = M3::zeros();
        for (node, by) in point.nodes().filter(|(node, _)| !held(*node)) {
            give += self.inverse_mass(node, state) * (by.share * by.share);
        }
        let system = M3::identity() + give * traveller.mass;
        let load = traveller.load(&point, &self.line, state);
        let Some(load) = system.lu().solve(&load) else {
            return;
        };
        for (node, by) in point.nodes().filter(|(node, _)| !held(*node)) {
            let push = load * by.share;
            let payload = self.elements.rigid_payload.as_ref();
            if let Some(payload) = payload.filter(|payload| payload.node == node) {
                let far = payload.inverse_mass(&self.line, state)[1];
                state.a[node + 1] -= far * push;
            }
            let near = self.inverse_mass(node, state);
            state.a[node] -= near * push;
        }
    }
}

impl LumpedLine {
    /// Mass of a node with added mass and bodies, without those that couple it to others \[kg\].
    pub(super) fn own_mass(&self, node: usize, state: &State) -> M3 {
        self.mass_of(node, state).matrix()
    }

    fn mass_of(&self, node: usize, state: &State) -> SymmetricBlock {
        let mut m = SymmetricBlock::default();
        m.add_diagonal(self.mass[node]);
        let halves = [(node.checked_sub(1), 1), (Some(node), 0)];
        for (i, half) in halves.into_iter().filter_map(|(i, half)| Some((i?, half))) {
            if i < self.segments.len() {
                let along = self.chord(i, state).tangent;
                let added = self.added(i, self.wet(i, state).as_ref())[half];
                m.add_directed(&along, added.normal, added.tangential);
            }
        }
        for (number, _) in self
            .bodies
            .iter()
            .enumerate()
            .filter(|(_, h)| h.node == node)
        {
            let share = self.body_in_water(number, state).share;
            m.add_body(&self.body_added_mass(number, state), share);
        }
        m
    }

    /// Fastest axial frequency of the ropes at a node at their present stiffness \[rad/s\]: `Scene::explicit_limit` covers half the
    /// breaking load only.
    pub(super) fn rope_frequency(&self, node: usize, state: &State) -> f64 {
        let last = self.segments.len();
        let stiffest = (node.saturating_sub(1)..(node + 1).min(last))
            .filter(|i| self.segments[*i].axial.law.is_some())
            .map(|i| self.tension_now(i, &self.chord(i, state), state).by_length)
            .fold(0.0, f64::max);
        2.0 * (stiffest / self.mass[node]).sqrt()
    }
}

/// A symmetric positive definite 3 x 3 block.
#[derive(Debug, Clone, Copy, Default)]
struct SymmetricBlock {
    xx: f64,
    xy: f64,
    xz: f64,
    yy: f64,
    yz: f64,
    zz: f64,
}

impl SymmetricBlock {
    #[inline(always)]
    fn add_diagonal(&mut self, m: f64) {
        self.xx += m;
        self.yy += m;
        self.zz += m;
    }

    #[inline(always)]
    fn add_axes(&mut self, m: &V3) {
        self.xx += m.x;
        self.yy += m.y;
        self.zz += m.z;
    }

    /// `normal (I - tt') + tangential tt'`.
    #[inline(always)]
    fn add_directed(&mut self, t: &V3, normal: f64, tangential: f64) {
        let k = tangential - normal;
        self.xx += normal + k * t.x * t.x;
        self.yy += normal + k * t.y * t.y;
        self.zz += normal + k * t.z * t.z;
        self.xy += k * t.x * t.y;
        self.xz += k * t.x * t.z;
        self.yz += k * t.y * t.z;
    }

    /// A share of the added mass of a body.
    #[inline(always)]
    fn add_body(&mut self, added: &BodyAddedMass<'_>, share: f64) {
        match added {
            BodyAddedMass::Axes(m) => self.add_axes(&(*m * share)),
            BodyAddedMass::Aligned(m, direction) => {
                self.add_directed(&direction.d, m.normal * share, m.tangential * share);
            }
        }
    }

    fn matrix(&self) -> M3 {
        M3::new(
            self.xx, self.xy, self.xz, self.xy, self.yy, self.yz, self.xz, self.yz, self.zz,
        )
    }

    /// By LDL', without pivoting since the block is positive definite.
    #[inline(always)]
    fn solve(&self, f: &V3) -> V3 {
        let d0 = 1.0 / self.xx;
        let l10 = self.xy * d0;
        let l20 = self.xz * d0;
        let d1 = 1.0 / (self.yy - l10 * self.xy);
        let l21 = (self.yz - l20 * self.xy) * d1;
        let d2 = 1.0 / (self.zz - l20 * self.xz - l21 * (self.yz - l20 * self.xy));
        let y1 = f.y - l10 * f.x;
        let y2 = f.z - l20 * f.x - l21 * y1;
        let z = y2 * d2;
        let y = y1 * d1 - l21 * z;
        let x = f.x * d0 - l10 * y - l20 * z;
        V3::new(x, y, z)
    }
}
