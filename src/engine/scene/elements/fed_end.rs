//! An end of the line that is paid out or hauled in: the unstretched length l of its segment changes at the rate q.
//!
//! The nodes of the line stay with their material; what comes in at the end node f lengthens the segment between f and its neighbour
//! g alone. With the chord `d = x_g - x_f` and `w = v_g - v_f` the material enters at the velocity `V = v_f + q d / l`. The half
//! of the segment at f has the momentum `m l V / 2` and that at g `m l v_g / 2`, m the mass per length, so that Lagrange's equations
//! of the segment, for what comes from a drum that moves with f, are the inertia of the kernel and
//!
//! ```text
//! R_f = m/2 (q w + q' d + q² d / l)        R_g = m/2 (q w - q² d / l)
//! ```
//!
//! and by the length paid out, with the tension T and the weight per length p,
//!
//! ```text
//! R_l = m/2 (a_f.d + q' d²/l + 2 q w.d/l - q² d²/2l² - w²/2) + p/2 (z_g - z_f) - T,
//! ```
//!
//! which is the pull at the drum, negative. They follow from the kinetic energy of the segment by Hamilton's principle for systems
//! of changing mass (McIver 1973, doi 10.1007/BF01535285).

use super::bed::BedContact;
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::tension::Chord;
use crate::scene::element::{At, Element};
use crate::scene::{LumpedLine, Scene, Segment};
use crate::solve::{Factors, State};

/// How much is paid out of an end, and how fast.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PaidOut {
    /// Unstretched length of the end segment \[m\].
    pub length: f64,
    /// Its rate \[m/s\], positive paid out.
    pub rate: f64,
    /// The rate of that \[m/s²\].
    pub acceleration: f64,
}

/// What the nodes of the end segment bear without it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct NodeLoads {
    mass: f64,
    weight: f64,
    footprint: f64,
}

/// An end of the line that is paid out.
#[derive(Debug, Clone, PartialEq)]
pub struct FedEnd {
    /// Which end: 0 for A, 1 for B.
    end: usize,
    /// Its segment as the mesh has it.
    whole: Segment,
    /// Displaced mass of half of it, where the line is in water that moves \[kg\].
    displaced: f64,
    /// Loads of its end node and of its neighbour.
    others: [NodeLoads; 2],
    now: PaidOut,
}

/// The pull at the drum, by the equation of the length paid out, and its derivatives, weighted by the factors.
#[derive(Debug, Clone, Copy, Default)]
pub struct DrumPull {
    /// `R_l` \[N\].
    pub residual: f64,
    /// By the end node.
    pub by_end: V3,
    /// By its neighbour.
    pub by_neighbour: V3,
    /// By the length paid out.
    pub by_length: f64,
    /// The tension on the end node \[N\], as a vector.
    pub pull: V3,
    /// Its derivative by the neighbour; by the end node it is the opposite.
    pub pull_by_neighbour: M3,
    /// By the length paid out.
    pub pull_by_length: V3,
}

/// The end segment in motion.
struct FedEndMotion {
    chord: Chord,
    /// From the end node to its neighbour \[m\].
    d: V3,
    t: V3,
    w: V3,
    /// Velocity at which its material opens \[m/s\].
    opening: V3,
    m: f64,
}

impl FedEnd {
    /// The end node and its neighbour.
    #[must_use]
    pub fn nodes(&self, line: &LumpedLine) -> [usize; 2] {
        let last = line.nodes() - 1;
        [[0, 1], [last, last - 1]][self.end]
    }

    /// Its segment.
    fn segment(&self, line: &LumpedLine) -> usize {
        self.end * (line.segments.len() - 1)
    }

    /// What is paid out now.
    #[must_use]
    pub fn now(&self) -> PaidOut {
        self.now
    }

    /// Half of its weight by its length \[N/m\].
    fn weight_per_length(&self) -> f64 {
        self.whole.half_weight / self.whole.axial.length
    }

    fn motion(&self, line: &LumpedLine, state: &State) -> FedEndMotion {
        let (i, [f, g]) = (self.segment(line), self.nodes(line));
        let chord = line.chord(i, state);
        let sign = [1.0, -1.0][self.end];
        FedEndMotion {
            d: chord.tangent * (chord.length * sign),
            t: chord.tangent * sign,
            w: state.v[g] - state.v[f],
            opening: chord.opening * sign,
            chord,
            m: 2.0 * self.whole.half_mass / self.whole.axial.length,
        }
    }

    /// Loads on the end node and its neighbour by the flow of mass \[N\], as residuals.
    fn momentum(&self, motion: &FedEndMotion) -> [V3; 2] {
        let PaidOut {
            length,
            rate,
            acceleration,
        } = self.now;
        let FedEndMotion { d, w, m, .. } = motion;
        let half = 0.5 * m;
        let by_place = d * (rate * rate / length);
        [
            (w * rate + d * acceleration + by_place) * half,
            (w * rate - by_place) * half,
        ]
    }

    /// Derivatives of the residuals of the end node and its neighbour by the length paid out, weighted by the factors; the push of
    /// a bed on these nodes is left out.
    #[must_use]
    pub(in crate::scene) fn by_length(&self, at: At<'_>, c: Factors) -> [V3; 2] {
        let (line, state) = (at.line, at.state);
        let (i, nodes) = (self.segment(line), self.nodes(line));
        let motion = self.motion(line, state);
        let FedEndMotion {
            d, t, w, m, chord, ..
        } = &motion;
        let (k, half) = (c.stiffness, 0.5 * m);
        let PaidOut { length, rate, .. } = self.now;
        let pull = t * self.tension_by_length(at, &motion, c);
        let wet = line.wet(i, state);
        let drag = line.submerged_drag(i, chord, state, wet.as_ref()).forces();
        let added = line.added(i, wet.as_ref());
        let grows = f64::from(line.wetted_length(i, chord).1 == 0.0);
        let own = |half_node: usize| {
            let (node, side) = (nodes[half_node], [half_node, 1 - half_node][self.end]);
            let water = added[side].force(&chord.tangent, &line.relative_acceleration(node, state))
                - drag[side] * grows
                - line.pressure(i, side, wet.as_ref(), state);
            let dry = state.a[node] * half + V3::z() * self.weight_per_length();
            (dry + water / length) * k
        };
        let square = d * (rate / length * half);
        let flow = w * (half * c.damping);
        let by_place = square * (2.0 * c.damping - rate / length * k);
        [
            own(0) - pull + flow + by_place + d * (half * c.mass),
            own(1) + pull + flow - by_place,
        ]
    }

    /// Derivative of the tension by the length paid out, weighted by the factors.
    fn tension_by_length(&self, at: At<'_>, motion: &FedEndMotion, c: Factors) -> f64 {
        let tension = at
            .line
            .pull(self.segment(at.line), &motion.chord, at.t, at.state);
        let PaidOut { length, rate, .. } = self.now;
        let (span, speed) = (motion.chord.length, tension.by_speed);
        let viscous = speed * motion.t.dot(&motion.opening);
        let by_place = -tension.by_length * span / length - viscous / length
            + speed * rate * span / length.powi(2);
        by_place * c.stiffness - speed * span / length * c.damping
    }

    /// The pull at the drum.
    #[must_use]
    pub(in crate::scene) fn drum_pull(&self, at: At<'_>, c: Factors) -> DrumPull {
        let (line, state) = (at.line, at.state);
        let [f, g] = self.nodes(line);
        let motion = self.motion(line, state);
        let tension = line.pull(self.segment(line), &motion.chord, at.t, state);
        let FedEndMotion { d, t, w, m, .. } = &motion;
        let PaidOut {
            length: l,
            rate: q,
            acceleration,
        } = self.now;
        let (half, weight) = (0.5 * m, self.weight_per_length());
        let (square, along) = (d.norm_squared(), w.dot(d));
        let kinetic = state.a[f].dot(d) + acceleration * square / l + 2.0 * q * along / l
            - 0.5 * (q / l).powi(2) * square
            - 0.5 * w.norm_squared();
        let rise = state.x[g].z - state.x[f].z;
        let across = motion.opening - t * t.dot(&motion.opening);
        let (speed, span) = (tension.by_speed, motion.chord.length);
        let by_chord = t * (tension.by_length - speed * q / l) + across * (speed / span);
        let changes = by_chord * c.stiffness + t * (speed * c.damping);
        let turning = M3::identity() - t * t.transpose();
        let of_length = self.tension_by_length(at, &motion, c);
        let by_place =
            (state.a[f] + d * ((2.0 * acceleration - q * q / l) / l) + w * (2.0 * q / l)) * half
                + V3::z() * weight
                - by_chord;
        let by_speed = (d * (2.0 * q / l) - w) * half - t * speed;
        let by_neighbour = by_place * c.stiffness + by_speed * c.damping;
        let by_length = (q * q * square / l - acceleration * square - 2.0 * q * along) / (l * l);
        let by_rate = (2.0 * along - q * square / l) / l;
        DrumPull {
            residual: kinetic * half + rise * weight - tension.value,
            by_neighbour,
            by_end: d * (half * c.mass) - by_neighbour,
            by_length: half * (by_length * c.stiffness + by_rate * c.damping + square / l * c.mass)
                - of_length,
            pull: t * tension.value,
            pull_by_neighbour: t * changes.transpose()
                + turning * (tension.value / span * c.stiffness),
            pull_by_length: t * of_length,
        }
    }

    /// By how much the tension of an accepted state exceeds that of its chord: see
    /// [`correct_chord_lengths`](crate::solve::MidstepBalance::correct_chord_lengths).
    fn corrected(&self, line: &LumpedLine, state: &State) -> f64 {
        let i = self.segment(line);
        let chord = line.chord(i, state);
        let raw = line.pull(i, &chord, state.memory.time, state);
        line.tension_now(i, &chord, state).value - raw.value
    }

    /// Loads of the two nodes with the segment as long as it is now.
    fn loads(&self) -> [NodeLoads; 2] {
        let share = self.now.length / self.whole.axial.length;
        let half = &self.whole;
        self.others.map(|others| NodeLoads {
            mass: others.mass + half.half_mass * share,
            weight: others.weight + half.half_weight * share,
            footprint: others.footprint + 0.5 * half.bearing_width * self.now.length,
        })
    }
}

impl Element for FedEnd {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        let load = self.momentum(&self.motion(at.line, at.state));
        for (node, load) in self.nodes(at.line).into_iter().zip(load) {
            r[node] += load;
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.add_residual(at, r);
        let motion = self.motion(at.line, at.state);
        let [f, g] = self.nodes(at.line);
        let PaidOut {
            length,
            rate,
            acceleration,
        } = self.now;
        let half = 0.5 * motion.m;
        let (flow, square) = (
            half * rate * c.damping,
            half * rate * rate / length * c.stiffness,
        );
        let grown = half * acceleration * c.stiffness;
        // The rate at which the material opens falls as the chord grows.
        let tension = at
            .line
            .pull(self.segment(at.line), &motion.chord, at.t, at.state);
        let damped =
            motion.t * motion.t.transpose() * (tension.by_speed * rate / length * c.stiffness);
        let by_f = M3::from_diagonal_element(flow + grown + square) + damped;
        let by_g = M3::from_diagonal_element(flow - square) - damped;
        tangent.diag[f] -= by_f;
        tangent.diag[g] += by_g;
        if f < g {
            tangent.upper[f] += by_f;
            tangent.lower[g] -= by_g;
        } else {
            tangent.lower[f] += by_f;
            tangent.upper[g] -= by_g;
        }
    }

    /// The material at the end node moves on from it.
    fn add_energy(&self, at: At<'_>, energy: &mut f64) {
        let FedEndMotion { d, m, .. } = self.motion(at.line, at.state);
        let [f, _] = self.nodes(at.line);
        let runs = d * (self.now.rate / self.now.length);
        *energy +=
            0.25 * m * self.now.length * (2.0 * at.state.v[f].dot(&runs) + runs.norm_squared());
    }

    /// Energy that comes in with the material, less the work of the tension on it.
    fn add_growth(&self, at: At<'_>, power: &mut f64) {
        let (line, state) = (at.line, at.state);
        let (i, [f, g]) = (self.segment(line), self.nodes(line));
        let motion = self.motion(line, state);
        let FedEndMotion { d, w, m, .. } = &motion;
        let PaidOut {
            length: l,
            rate: q,
            acceleration,
        } = self.now;
        let tension = line.tension_now(i, &motion.chord, state).value;
        let stored = line.elastic_energy(i, &motion.chord, state);
        *power += q / l * (stored - tension * motion.chord.length);
        let weight = self.weight_per_length();
        *power += q * weight * (state.x[f].z + state.x[g].z);
        *power += q / l * line.surface_energy_of(i, state);
        let share = q / self.whole.axial.length;
        for node in [f, g] {
            let v = &state.v[node];
            *power += 0.5 * share * v.dot(&self.whole.added.force(&motion.chord.tangent, v));
        }
        let (v, a) = ([state.v[f], state.v[g]], [state.a[f], state.a[g]]);
        let enters = v[0] + d * (q / l);
        let changes = a[0] + d * (acceleration / l) + (w - d * (q / l)) * (q / l);
        let half = 0.5 * m;
        let kinetic = 0.5 * q * (enters.norm_squared() + v[1].norm_squared())
            + l * (enters.dot(&changes) + v[1].dot(&a[1]));
        let flow = self.momentum(&motion);
        *power += half * (kinetic - l * (v[0].dot(&a[0]) + v[1].dot(&a[1])))
            - flow[0].dot(&v[0])
            - flow[1].dot(&v[1]);
    }

    fn add_end_force(&self, at: At<'_>, node: usize, force: &mut V3) {
        let [f, _] = self.nodes(at.line);
        if node == f {
            *force -= self.momentum(&self.motion(at.line, at.state))[0];
        }
    }
}

impl Scene {
    /// Lets an end be paid out, 0 for A and 1 for B, its segment as long as the mesh has it.
    pub fn feed(&mut self, end: usize) {
        let line = &self.line;
        let i = end * (line.segments.len() - 1);
        let whole = line.segments[i];
        let last = line.nodes() - 1;
        let nodes = [[0, 1], [last, last - 1]][end];
        let bed = self.elements.bed.as_ref();
        let others = nodes.map(|node| NodeLoads {
            mass: line.mass[node] - whole.half_mass,
            weight: line.weight[node] - whole.half_weight,
            footprint: bed.map_or(0.0, |bed| {
                bed.footprint[node] - 0.5 * whole.bearing_width * whole.axial.length
            }),
        });
        let now = PaidOut {
            length: whole.axial.length,
            ..PaidOut::default()
        };
        self.elements.fed_ends[end] = Some(FedEnd {
            end,
            whole,
            displaced: line.water.as_ref().map_or(0.0, |water| water.displaced[i]),
            others,
            now,
        });
    }

    /// Sets the end segment of an end that is paid out.
    pub fn pay_out(&mut self, end: usize, now: PaidOut) {
        let Some(fed) = &mut self.elements.fed_ends[end] else {
            return;
        };
        fed.now = now;
        let share = now.length / fed.whole.axial.length;
        let (i, nodes) = (fed.segment(&self.line), fed.nodes(&self.line));
        let segment = &mut self.line.segments[i];
        segment.axial = fed.whole.axial.of_length(now.length, now.rate);
        segment.added = fed.whole.added.scaled(share);
        segment.half_mass = fed.whole.half_mass * share;
        segment.half_weight = fed.whole.half_weight * share;
        if let Some(water) = &mut self.line.water {
            water.displaced[i] = fed.displaced * share;
        }
        for (node, loads) in nodes.into_iter().zip(fed.loads()) {
            self.line.mass[node] = loads.mass;
            self.line.weight[node] = loads.weight;
            if let Some(bed) = &mut self.elements.bed {
                bed.footprint[node] = loads.footprint;
            }
        }
    }

    /// The same as in a copy of this scene.
    pub fn pay_out_as(&mut self, other: &Self) {
        for (end, fed) in other.elements.fed_ends.iter().enumerate() {
            if let Some(fed) = fed {
                self.pay_out(end, fed.now);
            }
        }
    }

    /// An end that is paid out.
    #[must_use]
    pub fn fed_end(&self, end: usize) -> Option<&FedEnd> {
        self.elements.fed_ends[end].as_ref()
    }

    /// The pull at the drum of an end that is paid out, and how the residuals of its end node and the neighbour change with the length
    /// paid out; nothing at another end.
    #[must_use]
    pub fn drum(
        &self,
        end: usize,
        t: f64,
        state: &State,
        c: Factors,
    ) -> Option<(DrumPull, [V3; 2])> {
        let fed = self.fed_end(end)?;
        let at = self.at(t, state);
        let mut by_length = fed.by_length(at, c);
        if let Some(damping) = &self.elements.mass_damping {
            let i = fed.segment(&self.line);
            for (by, node) in by_length.iter_mut().zip(fed.nodes(&self.line)) {
                *by += damping.by_length(&self.line, i, node, state) * c.stiffness;
            }
        }
        Some((fed.drum_pull(at, c), by_length))
    }

    /// Energy that the springs of the bed gain as more line bears on them \[W\]: the power of no force.
    pub(in crate::scene) fn growth_on_bed(&self, bed: &BedContact, state: &State) -> f64 {
        let fed = self.elements.fed_ends.iter().flatten();
        fed.map(|fed| {
            let grows = 0.5 * fed.now.rate * fed.whole.bearing_width;
            let nodes = fed.nodes(&self.line).map(|node| &state.x[node]);
            nodes
                .map(|x| bed.energy_under(x, grows))
                .iter()
                .sum::<f64>()
        })
        .sum()
    }

    /// The pull at the drum in an accepted state, negative, for the balance of energy \[N\].
    #[must_use]
    pub fn drum_now(&self, end: usize, t: f64, state: &State) -> f64 {
        const FORCES: Factors = Factors {
            mass: 0.0,
            damping: 0.0,
            stiffness: 0.0,
        };
        self.fed_end(end).map_or(0.0, |fed| {
            let pull = fed.drum_pull(self.at(t, state), FORCES).residual;
            pull - fed.corrected(&self.line, state)
        })
    }
}
