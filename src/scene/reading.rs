//! What is read off a state: tensions at nodes, loads, energies, and the explicit accelerations.

use super::{End, Hung, Scene};
use crate::linalg::V3;
use crate::physics::tension::Chord;
use crate::solve::{State, System};

impl Scene {
    /// Tension at node i \[N\], from the segment after it (before it at the last node): its pull, with the
    /// weight, drag and inertia of the half segment between the node and the segment's middle. So a
    /// hanging line's top tension is its whole weight, whatever the mesh.
    #[must_use]
    pub fn tension_at(&self, node: usize, state: &State) -> f64 {
        let last = self.segments.len();
        let (i, sign) = if node < last {
            (node, 1.0)
        } else {
            (last - 1, -1.0)
        };
        let chord = self.chord(i, state);
        let pull = chord.tangent * self.segments[i].axial.tension(&chord).value;
        let load = self.half_load(i, node, &chord, state);
        // A slack segment has no direction to speak of: its half's load is then no tension.
        if pull == V3::zeros() {
            return 0.0;
        }
        let force = pull + load * sign;
        // With bending the force at a node has a shear part as well; the tension is the part along the line.
        if self.flexure.is_some() {
            force.dot(&chord.tangent)
        } else {
            force.norm()
        }
    }

    /// Weight, drag and (negative) inertia of the half of segment i at one of its nodes \[N\].
    fn half_load(&self, i: usize, node: usize, chord: &Chord, state: &State) -> V3 {
        let segment = &self.segments[i];
        let drag = self.drag(i, chord, state)[node - i];
        let a = &state.a[node];
        let inertia = a * segment.half_mass + segment.added.force(&chord.tangent, a);
        drag.force - inertia - V3::z() * segment.half_weight
    }

    /// Tensions at all nodes \[N\].
    #[must_use]
    pub fn tensions(&self, state: &State) -> Vec<f64> {
        (0..self.nodes())
            .map(|i| self.tension_at(i, state))
            .collect()
    }

    /// The line's pull on its first or last node's holder \[N\]: all forces on that node, less its inertia.
    #[must_use]
    pub fn end_force(&self, node: usize, state: &State) -> V3 {
        let (i, sign) = if node == 0 {
            (0, 1.0)
        } else {
            (node - 1, -1.0)
        };
        let segment = &self.segments[i];
        let chord = self.chord(i, state);
        let (t, a) = (&chord.tangent, &state.a[node]);
        let mut force = t * (segment.axial.tension(&chord).value * sign)
            + self.drag(i, &chord, state)[node - i].force
            - V3::z() * self.weight[node]
            - a * self.mass[node]
            - segment.added.force(t, a);
        for Hung { body, .. } in self.bodies.iter().filter(|hung| hung.node == node) {
            let (water, _) = self.current.at(state.x[node].z);
            force += body.drag(&(water - state.v[node])) - body.added.component_mul(a);
        }
        if let Some(bed) = &self.bed {
            let (x, v) = (&state.x[node], &state.v[node]);
            force.z += bed.push(x.z, v.z, self.footprint[node]).force;
        }
        if let Some(flexure) = &self.flexure {
            force += flexure.end_force(self, node, state);
        }
        force
    }

    /// The greatest angle between taut neighbouring segments \[rad\] and its node, those with a body left out: it must be
    /// small where straight segments are to stand for a curve.
    #[must_use]
    pub fn sharpest_turn(&self, state: &State) -> (f64, usize) {
        let taut = |i: usize| {
            let chord = self.chord(i, state);
            let pulls = self.segments[i].axial.tension(&chord).value > 0.0;
            pulls.then_some(chord.tangent)
        };
        let turn = |node: usize| {
            let bare = self.bodies.iter().all(|hung| hung.node != node);
            let cos = taut(node - 1)?.dot(&taut(node)?);
            bare.then(|| (cos.clamp(-1.0, 1.0).acos(), node))
        };
        (1..self.segments.len())
            .filter_map(turn)
            .fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a })
    }

    /// Kinetic, potential (weight in water) and elastic energy \[J\]. Added mass counts as mass.
    #[must_use]
    pub fn energy(&self, state: &State) -> f64 {
        let mut energy = 0.0;
        for i in 0..self.nodes() {
            energy +=
                0.5 * self.mass[i] * state.v[i].norm_squared() + self.weight[i] * state.x[i].z;
        }
        for (i, segment) in self.segments.iter().enumerate() {
            let chord = self.chord(i, state);
            let stretch = chord.length - segment.axial.length;
            let stretch = if segment.axial.rod {
                stretch
            } else {
                stretch.max(0.0)
            };
            energy += 0.5 * segment.axial.ea / segment.axial.length * stretch * stretch;
            for node in [i, i + 1] {
                let v = &state.v[node];
                energy += 0.5 * v.dot(&segment.added.force(&chord.tangent, v));
            }
        }
        if let Some(flexure) = &self.flexure {
            energy += flexure.energy(self, state);
        }
        if let Some(bed) = &self.bed {
            for (x, area) in state.x.iter().zip(&self.footprint) {
                energy += 0.5 * bed.stiffness * area * (bed.z - x.z).max(0.0).powi(2);
            }
        }
        for Hung { node, body } in &self.bodies {
            let v = &state.v[*node];
            energy += 0.5 * v.dot(&body.added.component_mul(v));
        }
        energy
    }

    /// Power that drag and axial damping take out of the line \[W\], positive when energy is lost.
    #[must_use]
    pub fn dissipation(&self, state: &State) -> f64 {
        let mut power = 0.0;
        for (i, segment) in self.segments.iter().enumerate() {
            let chord = self.chord(i, state);
            let strain = chord.length / segment.axial.length - 1.0;
            let strain = if segment.axial.rod {
                strain
            } else {
                strain.max(0.0)
            };
            let elastic = segment.axial.ea * strain;
            let viscous = segment.axial.tension(&chord).value - elastic;
            power += viscous * chord.tangent.dot(&chord.opening);
            for (node, drag) in [i, i + 1].into_iter().zip(self.drag(i, &chord, state)) {
                power -= drag.force.dot(&state.v[node]);
            }
        }
        if let Some(bed) = &self.bed {
            for ((x, v), area) in state.x.iter().zip(&state.v).zip(&self.footprint) {
                let elastic = bed.stiffness * area * (bed.z - x.z).max(0.0);
                power -= (bed.push(x.z, v.z, *area).force - elastic) * v.z;
            }
        }
        for Hung { node, body } in &self.bodies {
            let v = &state.v[*node];
            let (water, _) = self.current.at(state.x[*node].z);
            power -= body.drag(&(water - v)).dot(v);
        }
        power
    }

    /// Accelerations of the free nodes, `a = M(x)^-1 f(x, v)`: the mass of a node is a 3 x 3 block of its
    /// own, since added mass is lumped with the rest.
    pub(super) fn accelerations(&self, state: &mut State) {
        let free = self.free();
        let last = self.nodes() - 1;
        let held = [state.a[0], state.a[last]];
        let bending = self.preload_bending(state);
        let mut bodies = self.bodies.iter().peekable();
        let mut before: Option<(V3, Symmetric)> = None;
        for i in 0..self.nodes() {
            // Force and mass of node i: what the segment before left here, then the segment after.
            let (mut f, mut m) = before.take().unwrap_or((V3::zeros(), Symmetric::default()));
            f.z -= self.weight[i];
            m.add_diagonal(self.mass[i]);
            if bending {
                f -= state.a[i];
            }
            if let Some(bed) = &self.bed {
                f.z += bed
                    .push(state.x[i].z, state.v[i].z, self.footprint[i])
                    .force;
            }
            if i < last {
                let segment = &self.segments[i];
                let chord = self.chord(i, state);
                let t = &chord.tangent;
                let pull = t * segment.axial.tension(&chord).value;
                let [here, there] = self.drag(i, &chord, state);
                f += pull + here.force;
                let (normal, tangential) = (segment.added.normal, segment.added.tangential);
                m.add_directed(t, normal, tangential);
                let mut next = Symmetric::default();
                next.add_directed(t, normal, tangential);
                before = Some((there.force - pull, next));
            }
            while let Some(Hung { body, .. }) = bodies.next_if(|hung| hung.node == i) {
                let (water, _) = self.current.at(state.x[i].z);
                f += body.drag(&(water - state.v[i]));
                m.add_axes(&body.added);
            }
            if free.contains(&i) {
                state.a[i] = m.solve(&f);
            }
        }
        for (end, node) in [0, last].into_iter().enumerate() {
            if !free.contains(&node) {
                state.a[node] = held[end];
            }
        }
    }

    /// Puts the residual forces of bending where the accelerations will stand: they couple nodes two apart, and so
    /// must be complete before the first node is solved for. Whether there are any.
    fn preload_bending(&self, state: &mut State) -> bool {
        let Some(flexure) = &self.flexure else {
            return false;
        };
        let mut forces = std::mem::take(&mut state.a);
        forces.fill(V3::zeros());
        flexure.add_forces(self, state, &mut forces);
        state.a = forces;
        true
    }

    /// The fastest rate at which drag slows a node \[1/s\], and the node: `dF/du / m` with all the relative velocity
    /// counted as normal or as tangential, whichever gives more, and without added mass; so no less than it is.
    pub(super) fn decay_by_drag(&self, state: &State) -> (f64, usize) {
        let last = self.nodes() - 1;
        let mut fastest = (0.0, 0);
        for node in self.free() {
            let speed = (self.current.at(state.x[node].z).0 - state.v[node]).norm();
            let halves = self.segments[node.saturating_sub(1)..(node + 1).min(last)].iter();
            let mut drag: f64 = halves
                .map(|s| 0.5 * s.axial.length * s.drag.greatest(speed))
                .sum();
            let here = self.bodies.iter().filter(|hung| hung.node == node);
            drag += here.map(|hung| hung.body.drag.amax()).sum::<f64>();
            let rate = 2.0 * drag * speed / self.mass[node];
            if rate > fastest.0 {
                fastest = (rate, node);
            }
        }
        fastest
    }

    /// What bending and the bed add to the stiffness of segment i in its highest mode \[N/m\]: `8 EI / l³` as two
    /// neighbouring bends resist a zigzag, and the springs under its nodes.
    fn other_stiffness(&self, i: usize) -> f64 {
        let length = self.segments[i].axial.length;
        let bending = self.flexure.as_ref().map_or(0.0, |f| {
            8.0 * f.joints[i].max(f.joints[i + 1]) / (length * length)
        });
        let bed = self.bed.map_or(0.0, |b| {
            b.stiffness * self.footprint[i].max(self.footprint[i + 1])
        });
        bending + bed
    }

    /// The largest explicit time step \[s\] that classical Runge-Kutta of order 4 bears, and the segment that
    /// sets it. Highest axial frequency of a segment between nodes of masses m1, m2:
    /// `omega² = 2 (EA/l) (1/m1 + 1/m2)` (Gershgorin, exact for a uniform line; added mass does not count along
    /// the line), damping ratio `zeta = C omega / (2 EA)`. The limit is 2.785 / omega, less with damping:
    /// both roots of `s² + 2 zeta omega s + omega²` must lie in the stability region, whose real axis
    /// ends at -2.785 too.
    #[must_use]
    pub fn explicit_limit(&self) -> (f64, usize) {
        let mut limit = (f64::INFINITY, 0);
        for (i, segment) in self.segments.iter().enumerate() {
            let lightness =
                |node: usize, held: bool| if held { 0.0 } else { 1.0 / self.mass[node] };
            let held = |end: usize| matches!(self.ends[end], End::Held(_));
            let last = self.segments.len();
            let sum = lightness(i, i == 0 && held(0)) + lightness(i + 1, i + 1 == last && held(1));
            let axial = 2.0 * segment.axial.ea / segment.axial.length;
            let omega = ((axial + self.other_stiffness(i)) * sum).sqrt();
            let zeta = 0.5 * segment.axial.damping * omega / segment.axial.ea;
            let fastest = omega * (zeta + (zeta * zeta + 1.0).sqrt()).max(1.0);
            let step = 2.785 / fastest;
            if step < limit.0 {
                limit = (step, i);
            }
        }
        limit
    }
}

/// A symmetric positive definite 3 x 3 block.
#[derive(Debug, Clone, Copy, Default)]
struct Symmetric {
    xx: f64,
    xy: f64,
    xz: f64,
    yy: f64,
    yz: f64,
    zz: f64,
}

impl Symmetric {
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

    /// By LDL', which no positive definite block needs pivoting for.
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
