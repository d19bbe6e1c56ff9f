//! The discretised line and its equation of motion.

use std::ops::Range;

use crate::linalg::{BlockTri, M3, V3};
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::{Drag, Profile};
use crate::physics::tension::{Axial, Chord};
use crate::physics::{Body, Current, EndMotion};
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
}

/// One end of the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// Prescribed.
    Held(EndMotion),
    /// Moves by its equation of motion.
    Free,
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
    /// Masses of the nodes without added mass, payload included \[kg\].
    pub mass: Vec<f64>,
    /// Weights of the nodes in water, payload included \[N\], positive down.
    pub weight: Vec<f64>,
    /// Names of the ends A and B.
    pub end_names: [String; 2],
    /// What holds the ends A and B.
    pub ends: [End; 2],
    /// The payload, at the last node.
    pub payload: Option<Body>,
    /// The current.
    pub current: Current,
    /// Where tension is reported, from A to B.
    pub joints: Vec<Joint>,
    /// Unstretched arc length of the nodes from A \[m\].
    pub arc: Vec<f64>,
    /// Positions at time zero, or a first guess where the start is an equilibrium \[m\].
    pub start: Vec<V3>,
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

    /// Drag on the half of segment i at one of its nodes, and the shear of the current there \[1/s\].
    #[inline(always)]
    pub(super) fn half_drag(
        &self,
        i: usize,
        chord: &Chord,
        node: usize,
        state: &State,
    ) -> (Drag, V3, f64) {
        let (water, shear) = self.current.at(state.x[node].z);
        let (length, stretch) = self.wetted(i, chord);
        let u = water - state.v[node];
        (
            self.segments[i].drag.drag(&chord.tangent, &u, 0.5 * length),
            shear,
            stretch,
        )
    }

    /// Adds what segment i contributes at `node` (its drag, added mass) to residual and tangent. `sign` is
    /// the derivative of the chord by the node's position, -1 at the first node and 1 at the second.
    /// Returns the block that couples the node to the segment's other node.
    #[inline(always)]
    fn half(
        &self,
        i: usize,
        chord: &Chord,
        node: usize,
        sign: f64,
        c: Factors,
        out: &mut HalfOut<'_>,
    ) -> M3 {
        let (state, t) = (out.state, &chord.tangent);
        let (drag, shear, stretch) = self.half_drag(i, chord, node, state);
        let added = &self.segments[i].added;
        let a = &state.a[node];
        *out.r += added.force(t, a) - drag.force;
        // R depends on the chord through the added mass and, with a minus, the drag.
        let (s_m, p_m) = added.by_chord(t, a, chord.length);
        let (s_d, p_d, q) = drag.by_chord(t, chord.length, stretch);
        let k = sign * c.stiffness;
        let mut by_chord =
            t * ((p_m - p_d) * k).transpose() - drag.normal_velocity() * (q * k).transpose();
        add_diagonal(&mut by_chord, (s_m - s_d) * k);
        // Drag falls with the node's own velocity.
        let by_velocity = drag.by_velocity(t);
        let mut own = by_velocity * c.damping
            + t * t.transpose() * (c.mass * (added.tangential - added.normal));
        add_diagonal(&mut own, c.mass * added.normal);
        if shear != V3::zeros() {
            let column = own.column(2) - by_velocity * shear * c.stiffness;
            own.set_column(2, &column);
        }
        *out.diag += own + by_chord;
        -by_chord
    }
}

/// Where half a segment adds to.
struct HalfOut<'a> {
    state: &'a State,
    r: &'a mut V3,
    diag: &'a mut M3,
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
            let pull = t * self.segments[i].axial.tension(&chord).value;
            r[i] -= pull;
            r[i + 1] += pull;
            for node in [i, i + 1] {
                let (drag, _, _) = self.half_drag(i, &chord, node, state);
                r[node] += self.segments[i].added.force(t, &state.a[node]) - drag.force;
            }
        }
        if let Some(body) = &self.payload {
            let last = self.nodes() - 1;
            let (water, _) = self.current.at(state.x[last].z);
            r[last] +=
                body.added.component_mul(&state.a[last]) - body.drag(&(water - state.v[last]));
        }
    }

    fn linearise(&self, _t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockTri) {
        for i in 0..self.nodes() {
            r[i] = state.a[i] * self.mass[i];
            r[i].z += self.weight[i];
            tangent.diag[i] = M3::from_diagonal_element(c.mass * self.mass[i]);
        }
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let t = &chord.tangent;
            let tension = self.segments[i].axial.tension(&chord);
            let pull = t * tension.value;
            r[i] -= pull;
            r[i + 1] += pull;
            let elastic = elastic_block(&chord, &tension, c);
            let (head, tail) = tangent.diag.split_at_mut(i + 1);
            let (r_head, r_tail) = r.split_at_mut(i + 1);
            let mut first = HalfOut {
                state,
                r: &mut r_head[i],
                diag: &mut head[i],
            };
            let upper = self.half(i, &chord, i, -1.0, c, &mut first);
            *first.diag += elastic;
            let mut second = HalfOut {
                state,
                r: &mut r_tail[0],
                diag: &mut tail[0],
            };
            let lower = self.half(i, &chord, i + 1, 1.0, c, &mut second);
            *second.diag += elastic;
            tangent.upper[i] = upper - elastic;
            tangent.lower[i + 1] = lower - elastic;
        }
        if let Some(body) = &self.payload {
            let last = self.nodes() - 1;
            let (water, shear) = self.current.at(state.x[last].z);
            let u = water - state.v[last];
            r[last] += body.added.component_mul(&state.a[last]) - body.drag(&u);
            let by_velocity = body.drag_by_velocity(&u);
            let mut own = by_velocity * c.damping + M3::from_diagonal(&(body.added * c.mass));
            let column = own.column(2) - by_velocity * shear * c.stiffness;
            own.set_column(2, &column);
            tangent.diag[last] += own;
        }
    }

    fn accelerate(&self, _t: f64, state: &mut State) {
        self.accelerations(state);
    }

    fn force_scale(&self) -> f64 {
        self.force_scale
    }

    fn position_tolerance(&self, relative: f64) -> f64 {
        let stiffest = self
            .segments
            .iter()
            .map(|s| s.axial.ea / s.axial.length)
            .fold(0.0, f64::max);
        let reach = self.start.iter().map(V3::amax).fold(1.0, f64::max);
        // Positions themselves carry no more digits than this.
        (relative * self.force_scale / stiffest).max(8.0 * f64::EPSILON * reach)
    }
}

/// Derivative of the pull of a segment by its chord, stiffness and damping in their shares:
/// `dT/dl tt' + T/l (I - tt')` and, through the turning of the chord, `C/l (I - tt') w` along t.
#[inline(always)]
fn elastic_block(chord: &Chord, tension: &crate::physics::tension::Tension, c: Factors) -> M3 {
    let t = &chord.tangent;
    let across = c.stiffness * tension.value / chord.length;
    let along = c.stiffness * tension.by_length + c.damping * tension.by_speed;
    let turning = (chord.opening - t * t.dot(&chord.opening))
        * (c.stiffness * tension.by_speed / chord.length);
    let mut block = t * (t * (along - across) + turning).transpose();
    add_diagonal(&mut block, across);
    block
}
