//! What is read of every accepted step: the tensions of the line and, in the same pass, its energy and the powers that
//! change it. Chord, tension, drag and added mass of a segment are computed once for all of them.
//!
//! The terms of the energy balance are those of `scene/energy.rs`, with drag split in two: what the relative velocity
//! dissipates, `F (u - v)`, which is not negative, and what moving water puts in, `F u`.

use serde::{Deserialize, Serialize};

use super::node_tensions::BothSides;
use super::segment_block::{NodeKinematics, SegmentPass};
use super::submergence::Submergence;
use super::{EndCondition, Scene};
use crate::numerics::V3;
use crate::numerics::lanes::{self, Two, dot};
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::Drag;
use crate::physics::tension::Chord;
use crate::solve::State;

/// Energy of a line and the powers that change it: `d(energy)/dt = supplied - dissipated + growth`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyRates {
    /// Kinetic, potential and elastic energy \[J\], the traveller's included.
    pub energy: f64,
    /// The kinetic part of it \[J\], without the added mass of bodies.
    pub kinetic: f64,
    /// Power of ends, waves, current and traveller \[W\].
    pub supplied: f64,
    /// Power dissipated by drag, axial damping, ropes and the bed \[W\].
    pub dissipated: f64,
    /// `v' (dM/dt) v / 2` of the added mass as it turns and submerges \[W\], the power of no force.
    pub growth: f64,
    /// Power of the tension on what meshing left too much in end segments that are paid out \[W\].
    #[serde(default)]
    pub remeshed: f64,
}

impl EnergyRates {
    /// Adds those of another part.
    pub fn add(&mut self, other: &Self) {
        self.energy += other.energy;
        self.kinetic += other.kinetic;
        self.supplied += other.supplied;
        self.dissipated += other.dissipated;
        self.growth += other.growth;
        self.remeshed += other.remeshed;
    }
}

/// A segment as it is read.
struct SegmentReading<'a> {
    i: usize,
    chord: &'a Chord,
    /// Tension \[N\].
    tension: f64,
    /// Drag on both halves \[N\].
    drag: &'a Drag<Two>,
    /// Their submerged fractions; none if all of the line counts as submerged.
    wet: Option<&'a [Submergence; 2]>,
    /// Their added mass.
    added: [AddedMass; 2],
    /// Both nodes.
    nodes: [&'a NodeKinematics; 2],
}

impl Scene {
    /// Reads the tensions at the nodes of the line \[N\], as [`Scene::tension_at`], and where `energy` is set the energy balance at time
    /// t \[s\]. Does not allocate.
    pub fn read_step(
        &self,
        t: f64,
        state: &State,
        energy: bool,
        tensions: &mut [f64],
    ) -> EnergyRates {
        match (self.line.is_plain(state), energy) {
            (true, true) => self.read_as::<true, true>(t, state, tensions),
            (true, false) => self.read_as::<true, false>(t, state, tensions),
            (false, true) => self.read_as::<false, true>(t, state, tensions),
            (false, false) => self.read_as::<false, false>(t, state, tensions),
        }
    }

    /// The energy balance alone, at time t \[s\].
    #[must_use]
    pub fn energy_rates(&self, t: f64, state: &State) -> EnergyRates {
        self.read_step(t, state, true, &mut [])
    }

    fn read_as<const PLAIN: bool, const ENERGY: bool>(
        &self,
        t: f64,
        state: &State,
        tensions: &mut [f64],
    ) -> EnergyRates {
        let line = &self.line;
        let last = self.line_nodes() - 1;
        let mut rates = EnergyRates::default();
        let mut pass = SegmentPass::<PLAIN>::new(line, state);
        let mut both_sides = BothSides::default();
        for i in 0..line.segments.len() {
            let kinematics = pass.segment(i, line, state);
            let chord = kinematics.chord;
            let (wet, drag) = line.drag_as::<PLAIN>(i, &kinematics, state);
            let segment = SegmentReading {
                i,
                chord,
                tension: line.tension_now(i, chord, state).value,
                drag: &drag,
                wet: wet.as_ref(),
                added: line.added(i, wet.as_ref()),
                nodes: kinematics.nodes,
            };
            match &self.elements.flexure {
                _ if i >= last || tensions.is_empty() => {}
                None => {
                    tensions[i] = self.tension_of(&segment, 0, state);
                    if i + 1 == last {
                        tensions[last] = self.tension_of(&segment, 1, state);
                    }
                }
                Some(flexure) => {
                    let along = [0, 1].map(|half| self.tension_of(&segment, half, state));
                    let length = line.segments[i].axial.length;
                    both_sides.add(flexure, (i, length), along, tensions);
                }
            }
            if ENERGY {
                self.add_segment(&segment, state, &mut rates);
            }
        }
        if ENERGY {
            self.add_nodes(state, &mut rates);
            self.add_elements(t, state, &mut rates);
        }
        rates
    }

    /// Tension at a node of a segment: see [`Scene::tension_at`].
    #[inline(always)]
    fn tension_of(&self, segment: &SegmentReading<'_>, half: usize, state: &State) -> f64 {
        let (i, chord) = (segment.i, segment.chord);
        let sign = if half == 0 { 1.0 } else { -1.0 };
        let pull = chord.tangent * (segment.tension * sign);
        if pull == V3::zeros() {
            return 0.0;
        }
        let own = &self.line.segments[i];
        let relative = segment.nodes[half].a;
        let added = segment.added[half].force(&chord.tangent, &relative);
        let inertia = state.a[i + half] * own.half_mass + added;
        let mut load = segment.drag.forces()[half] - inertia - V3::z() * own.half_weight;
        if self.line.water.is_some() {
            load += self.line.pressure(i, half, segment.wet, state);
        }
        self.tension_from((i, half), chord, (&pull, load), state)
    }

    /// Energy and powers of a segment: strain, axial damping, drag, added mass. Both halves in the two lanes of a register.
    #[inline(always)]
    fn add_segment(&self, segment: &SegmentReading<'_>, state: &State, rates: &mut EnergyRates) {
        let (line, i, chord) = (&self.line, segment.i, segment.chord);
        let (stored, damped) = line.strain_energy(i, chord, segment.tension, state);
        rates.energy += stored;
        rates.dissipated += damped;
        let [near, far] = segment.nodes;
        let v = lanes::vectors(&state.v[i], &state.v[i + 1]);
        let u = lanes::vectors(&near.u, &far.u);
        rates.dissipated += dot(&segment.drag.force, &u).reduce_add();
        rates.supplied += dot(&segment.drag.force, &(u + v)).reduce_add();
        let closing = chord.tangent.dot(&chord.opening);
        let turn = (chord.opening - chord.tangent * closing) * chord.inverse;
        let added = AddedMass::of_halves(segment.added);
        let along = dot(&lanes::twice(&chord.tangent), &v);
        let lopsided = along * (added.tangential - added.normal);
        rates.kinetic += 0.5 * (added.normal * dot(&v, &v) + lopsided * along).reduce_add();
        rates.growth += (lopsided * dot(&lanes::twice(&turn), &v)).reduce_add();
        for (half, wet) in segment.wet.into_iter().flatten().enumerate() {
            let v = &state.v[i + half];
            let whole = line.segments[i].added.force(&chord.tangent, v);
            rates.growth += 0.5 * self.wetting_rate(i, wet, state) * v.dot(&whole);
        }
    }

    /// Rate of the submerged fraction of half of segment i \[1/s\].
    fn wetting_rate(&self, i: usize, wet: &Submergence, state: &State) -> f64 {
        let by_node = wet.by.iter().zip([i, i + 1]);
        by_node
            .map(|(by, node)| by.dot(&state.v[node]) - by.z * self.line.elevation_rate(node, state))
            .sum()
    }

    /// Mass and weight of the nodes.
    fn add_nodes(&self, state: &State, rates: &mut EnergyRates) {
        let line = &self.line;
        let nodes = state.x.iter().zip(&state.v);
        for ((x, v), (mass, weight)) in nodes.zip(line.mass.iter().zip(&line.weight)) {
            rates.kinetic += 0.5 * mass * v.norm_squared();
            rates.energy += weight * x.z;
        }
        rates.energy += rates.kinetic;
    }

    /// Elements, ends and the traveller.
    fn add_elements(&self, t: f64, state: &State, rates: &mut EnergyRates) {
        let (line, at) = (&self.line, self.at(t, state));
        let payload = self.elements.rigid_payload.as_ref();
        rates.energy += line.surface_energy(state);
        rates.energy += payload.map_or(0.0, |payload| payload.surface_energy(line, state));
        if let Some(bed) = &self.elements.bed {
            rates.energy += bed.energy(state);
            rates.growth += self.growth_on_bed(bed, state);
        }
        let mut by_water = 0.0;
        for element in self.elements.iter() {
            element.add_energy(at, &mut rates.energy);
            element.add_dissipation(at, &mut rates.dissipated);
            element.add_water_drag_power(at, &mut by_water);
            element.add_growth(at, &mut rates.growth);
        }
        rates.dissipated += by_water;
        rates.supplied +=
            by_water + self.power_of_waves(state) + self.power_of_moving_ends(t, state);
        if let Some((energy, power)) = self.traveller_energy(t, state) {
            rates.energy += energy;
            rates.supplied += power;
        }
    }

    /// [`Scene::power_of_ends`] without the force on ends at rest.
    fn power_of_moving_ends(&self, t: f64, state: &State) -> f64 {
        let ends = self.line.ends.iter().zip([0, self.line.nodes() - 1]);
        let moves = |(end, node): &(&EndCondition, usize)| {
            matches!(end, EndCondition::Prescribed(_)) && state.v[*node] != V3::zeros()
        };
        if ends.filter(moves).count() == 0 {
            return 0.0;
        }
        self.power_of_ends(t, state)
    }
}
