//! What half a segment contributes to its node: pull, drag and added mass, and their tangents.

use crate::linalg::{M3, V3};
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::Drag;
use crate::physics::tension::{Chord, Tension};
use crate::solve::Factors;

/// Half a segment: where it is, and what acts on it.
pub(super) struct Half {
    /// Its added mass, as far as it is wet.
    pub(super) added: AddedMass,
    pub(super) chord: Chord,
    /// Derivative of the pull, see [`pull_by_chord`].
    pub(super) pull: (f64, V3),
    pub(super) drag: Drag,
    /// Drag of the other half.
    pub(super) other: Drag,
    /// Acceleration of its node relative to the water.
    pub(super) a: V3,
    /// Shear of the current at its own node and at the other \[1/s\], where there is any.
    pub(super) shear: Option<[V3; 2]>,
    /// 1 / chord length where the wetted length grows with the chord.
    pub(super) stretch: f64,
    /// Derivative of the chord by the node's position: -1 at the first node, 1 at the second.
    pub(super) sign: f64,
}

impl Half {
    /// Adds what half a segment contributes to its node, pull, drag and added mass, and returns the block that couples the
    /// node to the segment's other one.
    #[inline(always)]
    pub(super) fn add(&self, c: Factors, r: &mut V3, diag: &mut M3) -> M3 {
        let (added, chord, drag, other) = (&self.added, &self.chord, &self.drag, &self.other);
        let (t, n) = (&chord.tangent, drag.direction());
        *r += added.force(t, &self.a) - drag.force;
        // R depends on the chord through the pull, the added mass and, with a minus, the drag: s I + t p' + n q'.
        let (s_m, p_m) = added.by_chord(t, &self.a, chord.inverse);
        let (s_d, p_d, q_d) = drag.by_chord(other, t, chord.inverse, self.stretch);
        let k = self.sign * c.stiffness;
        let (s, p, q) = (
            (s_m - s_d) * k + self.pull.0,
            (p_m - p_d) * k + self.pull.1,
            q_d * -k,
        );
        // Of its own node: the same, its acceleration, and its velocity, with which drag falls.
        let (v_i, v_t, v_n) = drag.by_velocity();
        let tt = c.damping * v_t + c.mass * (added.tangential - added.normal);
        add_outer(diag, t, &(p + t * tt));
        add_outer(diag, n, &(q + n * (c.damping * v_n)));
        add_diagonal(diag, s + c.damping * v_i + c.mass * added.normal);
        let mut coupling = outer(t, &-p);
        add_outer(&mut coupling, n, &-q);
        add_diagonal(&mut coupling, -s);
        let by_other = drag.by_other_velocity(other);
        if let Some(block) = by_other {
            coupling += block * c.damping;
        }
        if let Some([own_shear, other_shear]) = &self.shear {
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

fn add_to_last_column(m: &mut M3, v: &V3) {
    for i in 0..3 {
        m[(i, 2)] += v[i];
    }
}

/// `a b'`.
#[inline(always)]
fn outer(a: &V3, b: &V3) -> M3 {
    M3::from_columns(&[a * b.x, a * b.y, a * b.z])
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

/// Derivative of the pull of a segment by its chord, stiffness and damping in their shares, in the form
/// `s I + t p'`, the numbers (s, p): `dT/dl tt' + T/l (I - tt')` and, through the turning of the chord,
/// `C/l (I - tt') w` along t.
#[inline(always)]
pub(super) fn pull_by_chord(chord: &Chord, tension: &Tension, c: Factors) -> (f64, V3) {
    let t = &chord.tangent;
    let across = c.stiffness * tension.value * chord.inverse;
    let along = c.stiffness * tension.by_length + c.damping * tension.by_speed;
    let turning = c.stiffness * tension.by_speed * chord.inverse;
    (
        across,
        t * (along - across - turning * t.dot(&chord.opening)) + chord.opening * turning,
    )
}
