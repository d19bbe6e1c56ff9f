//! The discretised line and its equation of motion.

use std::ops::Range;

use crate::linalg::{BlockBand, M3, V3};
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::{Drag, Profile};
use crate::physics::tension::{Axial, Chord, Tension};
use crate::physics::{Body, Current, EndMotion, Seabed};

use super::Flexure;
use crate::solve::{Factors, State, System};

/// A segment between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Axial constants.
    pub axial: Axial,
    /// Drag per length.
    pub drag: Profile,
    /// Added mass of half the segment.
    pub added: AddedMass,
    /// Mass of half the segment \[kg\].
    pub half_mass: f64,
    /// Weight in water of half the segment \[N\], positive down.
    pub half_weight: f64,
    /// Bending stiffness EI \[N m²\].
    pub ei: f64,
    /// Hydrodynamic diameter \[m\].
    pub diameter: f64,
}

/// One end of the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// Prescribed.
    Held(EndMotion),
    /// Moves by its equation of motion.
    Free,
}

/// A body and the node it hangs on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hung {
    /// The node.
    pub node: usize,
    /// The body; its mass and weight are those of the node already.
    pub body: Body,
}

/// A named place where the tension is reported.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Joint {
    /// As in channel names: `chain|polyester`.
    pub name: String,
    /// Its node.
    pub node: usize,
}

/// A line ready to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Segments from A to B; node i lies before segment i.
    pub segments: Vec<Segment>,
    /// Masses of the nodes without added mass, bodies included \[kg\].
    pub mass: Vec<f64>,
    /// Weights of the nodes in water, bodies included \[N\], positive down.
    pub weight: Vec<f64>,
    /// Names of the ends A and B.
    pub end_names: [String; 2],
    /// What holds the ends A and B.
    pub ends: [End; 2],
    /// Bodies on the line, by their nodes, the payload last.
    pub bodies: Vec<Hung>,
    /// Nodes of the clumps, in the order of the case.
    pub clumps: Vec<usize>,
    /// Bending, where any material has a bending stiffness.
    pub flexure: Option<Flexure>,
    /// The sea bed, if there is one.
    pub bed: Option<Seabed>,
    /// Area of line that each node rests on the bed with \[m²\].
    pub footprint: Vec<f64>,
    /// The current.
    pub current: Current,
    /// Where tension is reported, from A to B.
    pub joints: Vec<Joint>,
    /// Unstretched arc length of the nodes from A \[m\].
    pub arc: Vec<f64>,
    /// Positions at time zero, or a first guess where the start is an equilibrium \[m\].
    pub start: Vec<V3>,
    /// What the user should know of how the case was made into this line.
    pub remarks: Vec<String>,
    /// Tensions of the segments that go with the start \[N\].
    pub start_tension: Vec<f64>,
    /// Whether the line starts in equilibrium.
    pub start_in_equilibrium: bool,
    /// A force typical of this line \[N\]: its whole weight, or what its drag can be.
    pub force_scale: f64,
}

impl Scene {
    /// The state at time zero, ends where their motion has them.
    #[must_use]
    pub fn initial_state(&self) -> State {
        let mut state = State::at_rest(self.start.clone());
        self.prescribe(0.0, &mut state);
        state
    }

    /// The chord of segment i.
    #[inline(always)]
    #[must_use]
    pub fn chord(&self, i: usize, state: &State) -> Chord {
        Chord::new(
            (&state.x[i], &state.x[i + 1]),
            (&state.v[i], &state.v[i + 1]),
            self.segments[i].axial.length,
        )
    }

    /// Stretched length that the water sees \[m\], and 1 / chord length where it grows with the chord.
    #[inline(always)]
    fn wetted(&self, i: usize, chord: &Chord) -> (f64, f64) {
        let unstretched = self.segments[i].axial.length;
        if chord.length > unstretched {
            (chord.length, 1.0 / chord.length)
        } else {
            (unstretched, 0.0)
        }
    }

    /// Shear of the current at both nodes of segment i \[1/s\]; nothing where the current is uniform.
    #[inline(always)]
    fn shear(&self, i: usize, state: &State) -> Option<[V3; 2]> {
        match &self.current {
            Current::Uniform(_) => None,
            Current::Table { .. } => {
                Some([i, i + 1].map(|node| self.current.at(state.x[node].z).1))
            }
        }
    }

    /// Drag on both halves of segment i.
    #[inline(always)]
    pub(super) fn drag(&self, i: usize, chord: &Chord, state: &State) -> [Drag; 2] {
        let u = self.relative_velocities(i, state);
        let length = self.wetted(i, chord).0;
        self.segments[i].drag.drag(
            &chord.tangent,
            [&u[0], &u[1]],
            0.5 * length,
            state.memory.get(i),
        )
    }

    /// Velocities of the water relative to both nodes of segment i \[m/s\].
    #[inline(always)]
    fn relative_velocities(&self, i: usize, state: &State) -> [V3; 2] {
        [
            self.current.at(state.x[i].z).0 - state.v[i],
            self.current.at(state.x[i + 1].z).0 - state.v[i + 1],
        ]
    }

    /// Takes the push of the bed from the residual.
    fn add_bed(&self, state: &State, r: &mut [V3]) {
        if let Some(bed) = &self.bed {
            for (i, out) in r.iter_mut().enumerate() {
                out.z -= bed
                    .push(state.x[i].z, state.v[i].z, self.footprint[i])
                    .force;
            }
        }
    }

    /// Takes the derivatives of that push from the tangent.
    fn add_bed_tangent(&self, state: &State, c: Factors, tangent: &mut BlockBand) {
        if let Some(bed) = &self.bed {
            for (i, block) in tangent.diag.iter_mut().enumerate() {
                let push = bed.push(state.x[i].z, state.v[i].z, self.footprint[i]);
                block[(2, 2)] -= c.stiffness * push.by_z + c.damping * push.by_speed;
            }
        }
    }

    /// Adds what half a segment contributes to its node, pull, drag and added mass, and returns the block that couples the
    /// node to the segment's other one.
    #[inline(always)]
    fn add_half(half: &Half<'_>, c: Factors, r: &mut V3, diag: &mut M3) -> M3 {
        let Half {
            segment,
            chord,
            pull,
            drag,
            other,
            a,
            shear,
            stretch,
            sign,
        } = *half;
        let (t, n) = (&chord.tangent, drag.direction());
        let added = &segment.added;
        *r += added.force(t, a) - drag.force;
        // R depends on the chord through the pull, the added mass and, with a minus, the drag: s I + t p' + n q'.
        let (s_m, p_m) = added.by_chord(t, a, chord.inverse);
        let (s_d, p_d, q_d) = drag.by_chord(other, t, chord.inverse, stretch);
        let k = sign * c.stiffness;
        let (s, p, q) = ((s_m - s_d) * k + pull.0, (p_m - p_d) * k + pull.1, q_d * -k);
        // Of its own node: the same, its acceleration, and its velocity, with which drag falls.
        let (v_i, v_t, v_n) = drag.by_velocity();
        let tt = c.damping * v_t + c.mass * (added.tangential - added.normal);
        add_outer(diag, t, &(p + t * tt));
        add_outer(diag, n, &(q + n * (c.damping * v_n)));
        add_diagonal(diag, s + c.damping * v_i + c.mass * added.normal);
        let mut coupling = M3::zeros();
        add_outer(&mut coupling, t, &-p);
        add_outer(&mut coupling, n, &-q);
        add_diagonal(&mut coupling, -s);
        let by_other = drag.by_other_velocity(other);
        if let Some(block) = by_other {
            coupling += block * c.damping;
        }
        if let Some([own_shear, other_shear]) = shear {
            let change =
                own_shear * v_i + t * (v_t * t.dot(own_shear)) + n * (v_n * n.dot(own_shear));
            add_to_last_column(diag, &(change * -c.stiffness));
            if let Some(block) = by_other {
                add_to_last_column(&mut coupling, &(block * other_shear * -c.stiffness));
            }
        }
        coupling
    }
}

/// Half a segment: where it is, and what acts on it.
struct Half<'a> {
    segment: &'a Segment,
    chord: &'a Chord,
    /// Derivative of the pull, see [`pull_by_chord`].
    pull: (f64, V3),
    drag: &'a Drag,
    /// Drag of the other half.
    other: &'a Drag,
    /// Acceleration of its node.
    a: &'a V3,
    /// Shear of the current at its own node and at the other \[1/s\], where there is any.
    shear: Option<[&'a V3; 2]>,
    /// 1 / chord length where the wetted length grows with the chord.
    stretch: f64,
    /// Derivative of the chord by the node's position: -1 at the first node, 1 at the second.
    sign: f64,
}

fn add_to_last_column(m: &mut M3, v: &V3) {
    for i in 0..3 {
        m[(i, 2)] += v[i];
    }
}

/// `m += a b'`.
#[inline(always)]
fn add_outer(m: &mut M3, a: &V3, b: &V3) {
    for j in 0..3 {
        for i in 0..3 {
            m[(i, j)] += a[i] * b[j];
        }
    }
}

#[inline(always)]
fn add_diagonal(m: &mut M3, s: f64) {
    m[(0, 0)] += s;
    m[(1, 1)] += s;
    m[(2, 2)] += s;
}

impl System for Scene {
    fn nodes(&self) -> usize {
        self.mass.len()
    }

    fn free(&self) -> Range<usize> {
        let held = |end: usize| usize::from(matches!(self.ends[end], End::Held(_)));
        held(0)..self.nodes() - held(1)
    }

    fn bends(&self) -> bool {
        self.flexure.is_some()
    }

    fn folded(&self, state: &State) -> Option<usize> {
        self.flexure.as_ref()?.folded(self, state)
    }

    fn prescribe(&self, t: f64, state: &mut State) {
        let last = self.nodes() - 1;
        for (end, node) in [(0, 0), (1, last)] {
            if let End::Held(motion) = &self.ends[end] {
                (state.x[node], state.v[node], state.a[node]) = motion.at(t);
            }
        }
    }

    fn residual(&self, _t: f64, state: &State, r: &mut [V3]) {
        for (i, out) in r.iter_mut().enumerate() {
            *out = state.a[i] * self.mass[i];
            out.z += self.weight[i];
        }
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let t = &chord.tangent;
            let pull = t * self.tension(i, &chord, state).0.value;
            r[i] -= pull;
            r[i + 1] += pull;
            for (node, drag) in [i, i + 1].into_iter().zip(self.drag(i, &chord, state)) {
                r[node] += self.segments[i].added.force(t, &state.a[node]) - drag.force;
            }
        }
        self.add_bed(state, r);
        if let Some(flexure) = &self.flexure {
            flexure.add_forces(self, state, r);
        }
        for Hung { node: i, body } in &self.bodies {
            let (water, _) = self.current.at(state.x[*i].z);
            r[*i] += body.added.component_mul(&state.a[*i]) - body.drag(&(water - state.v[*i]));
        }
    }

    fn linearise(&self, _t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        for (i, (out, diag)) in r.iter_mut().zip(&mut tangent.diag).enumerate() {
            *out = state.a[i] * self.mass[i];
            out.z += self.weight[i];
            *diag = M3::from_diagonal_element(c.mass * self.mass[i]);
        }
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let t = &chord.tangent;
            let (tension, foretold) = self.tension(i, &chord, state);
            let pull = t * tension.value;
            r[i] -= pull;
            r[i + 1] += pull;
            let by_chord = pull_by_chord(&chord, &foretold, c);
            let drag = self.drag(i, &chord, state);
            let sheared = self.shear(i, state);
            let (shear, back) = match &sheared {
                Some([first, second]) => (Some([first, second]), Some([second, first])),
                None => (None, None),
            };
            let stretch = self.wetted(i, &chord).1;
            let segment = &self.segments[i];
            let half = |drag, other, a, shear, sign| Half {
                segment,
                chord: &chord,
                pull: by_chord,
                drag,
                other,
                a,
                shear,
                stretch,
                sign,
            };
            let first = half(&drag[0], &drag[1], &state.a[i], shear, -1.0);
            tangent.upper[i] = Self::add_half(&first, c, &mut r[i], &mut tangent.diag[i]);
            let second = half(&drag[1], &drag[0], &state.a[i + 1], back, 1.0);
            tangent.lower[i + 1] =
                Self::add_half(&second, c, &mut r[i + 1], &mut tangent.diag[i + 1]);
        }
        self.add_bed(state, r);
        self.add_bed_tangent(state, c, tangent);
        if let Some(flexure) = &self.flexure {
            flexure.add_forces(self, state, r);
            flexure.add_tangent(self, state, c.stiffness, tangent);
        }
        for Hung { node: i, body } in &self.bodies {
            let (water, shear) = self.current.at(state.x[*i].z);
            let u = water - state.v[*i];
            r[*i] += body.added.component_mul(&state.a[*i]) - body.drag(&u);
            let by_velocity = body.drag_by_velocity(&u);
            let mut own = by_velocity * c.damping + M3::from_diagonal(&(body.added * c.mass));
            let column = own.column(2) - by_velocity * shear * c.stiffness;
            own.set_column(2, &column);
            tangent.diag[*i] += own;
        }
    }

    fn fastest_decay(&self, state: &State) -> (f64, usize) {
        self.decay_by_drag(state)
    }

    fn remember(&self, state: &mut State) {
        state.memory.resize(self.segments.len(), [0.0; 2]);
        for i in 0..self.segments.len() {
            let u = self.relative_velocities(i, state);
            let tangent = self.chord(i, state).tangent;
            state.memory[i] = self.segments[i]
                .drag
                .normal_coefficients(&tangent, [&u[0], &u[1]]);
        }
    }

    fn guess_tensions(&self, state: &mut State) {
        self.begin_foretelling(state);
    }

    fn foretell(&self, d: &[V3], state: &mut State) {
        self.foretell_tensions(d, state);
    }

    fn accelerate(&self, _t: f64, state: &mut State) {
        self.accelerations(state);
    }

    fn force_scale(&self) -> f64 {
        self.force_scale
    }

    fn rounding_force(&self) -> f64 {
        self.stiffest() * self.rounding()
    }

    fn position_tolerance(&self, relative: f64) -> f64 {
        (relative * self.force_scale / self.stiffest()).max(self.rounding())
    }
}

impl Scene {
    /// Greatest axial stiffness of a segment \[N/m\].
    fn stiffest(&self) -> f64 {
        self.segments
            .iter()
            .map(|s| s.axial.ea / s.axial.length)
            .fold(0.0, f64::max)
    }

    /// Positions carry no more digits than this \[m\].
    fn rounding(&self) -> f64 {
        8.0 * f64::EPSILON * self.start.iter().map(V3::amax).fold(1.0, f64::max)
    }
}

/// Derivative of the pull of a segment by its chord, stiffness and damping in their shares, in the form
/// `s I + t p'`, the numbers (s, p): `dT/dl tt' + T/l (I - tt')` and, through the turning of the chord,
/// `C/l (I - tt') w` along t.
#[inline(always)]
fn pull_by_chord(chord: &Chord, tension: &Tension, c: Factors) -> (f64, V3) {
    let t = &chord.tangent;
    let across = c.stiffness * tension.value * chord.inverse;
    let along = c.stiffness * tension.by_length + c.damping * tension.by_speed;
    let turning = c.stiffness * tension.by_speed * chord.inverse;
    (
        across,
        t * (along - across - turning * t.dot(&chord.opening)) + chord.opening * turning,
    )
}
