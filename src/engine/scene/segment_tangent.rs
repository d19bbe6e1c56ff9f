//! Tangent of both halves of a segment in two lanes: tension, drag and added mass.

use crate::numerics::V3;
use crate::numerics::lanes::{self, Two, TwoM3, TwoV3, apply, dot, outer, plus_diagonal};
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::Drag;
use crate::physics::tension::{Chord, Tension};
use crate::solve::Factors;

/// Both halves of a segment and the forces on them.
pub(super) struct SegmentHalves<'a> {
    /// Added mass of their submerged fractions.
    pub(super) added: AddedMass<Two>,
    pub(super) chord: &'a Chord,
    /// Derivative of the tension, see [`pull_by_chord`].
    pub(super) pull: (f64, V3),
    pub(super) drag: &'a Drag<Two>,
    /// Accelerations of their nodes relative to the water.
    pub(super) a: TwoV3,
    /// Shear of the current at their nodes \[1/s\], if any.
    pub(super) shear: Option<TwoV3>,
    /// 1 / chord length if the wetted length grows with the chord, else 0.
    pub(super) stretch: f64,
}

/// Derivatives of the residuals of both nodes of a segment.
#[derive(Clone, Copy)]
pub(super) struct SegmentTangent {
    /// By the position of the node itself.
    pub(super) own: TwoM3,
    /// By that of the other node.
    pub(super) coupling: TwoM3,
}

/// Derivative of the chord by the positions of the nodes.
const SIGNS: [f64; 2] = [-1.0, 1.0];

impl SegmentHalves<'_> {
    /// Inertia of the added mass less drag \[N\].
    #[inline(always)]
    pub(super) fn load(&self) -> TwoV3 {
        let t = lanes::twice(&self.chord.tangent);
        self.added.force(&t, &self.a) - self.drag.force
    }

    /// Derivatives of both residuals: tension, drag and added mass together.
    #[inline(always)]
    pub(super) fn slopes(&self, c: Factors) -> SegmentTangent {
        let (added, chord, drag) = (&self.added, self.chord, self.drag);
        let (t, n) = (lanes::twice(&chord.tangent), drag.direction());
        // By the chord, through tension, added mass and (negative) drag: s I + t p' + n q'. The derivative by the other node
        // has the opposite sign.
        let (s_m, p_m) = added.by_chord(&t, &self.a, chord.inverse.into());
        let (s_d, p_d, q_d) = drag.by_chord(&t, chord.inverse, self.stretch);
        let k = Two::new(SIGNS) * c.stiffness;
        let s = (s_d - s_m) * k - self.pull.0;
        let p = (p_d - p_m) * k - lanes::twice(&self.pull.1);
        let q = q_d * k;
        let coupling = plus_diagonal(outer(&t, &p) + outer(n, &q), s);
        // By its own node: the same, with its acceleration, and its velocity, which reduces drag.
        let (v_i, v_t, v_n) = drag.by_velocity();
        let v_t = v_t * c.damping + (added.tangential - added.normal) * c.mass;
        let moving = symmetric(&t, v_t, n, v_n * c.damping);
        let moving = plus_diagonal(moving, v_i * c.damping + added.normal * c.mass);
        let mut slopes = SegmentTangent {
            own: moving - coupling,
            coupling,
        };
        if let Some(block) = drag.by_other_velocity() {
            slopes = self.astride(slopes, &block, c);
        }
        if let Some(shear) = &self.shear {
            self.add_shear(shear, c, &mut slopes);
        }
        slopes
    }

    /// Adds the derivative `block` of drag by the velocity at the other node (drag crisis within the segment), whose normal part
    /// rotates with the chord.
    #[cold]
    fn astride(&self, slopes: SegmentTangent, block: &TwoM3, c: Factors) -> SegmentTangent {
        let turning =
            self.drag.turning_of_other(self.chord.inverse) * Two::new(SIGNS) * c.stiffness;
        let by_chord = block * turning;
        SegmentTangent {
            own: slopes.own + by_chord,
            coupling: slopes.coupling + block * Two::splat(c.damping) - by_chord,
        }
    }

    /// Adds the derivative of drag by the shear of the current.
    #[inline(always)]
    fn add_shear(&self, shear: &TwoV3, c: Factors, slopes: &mut SegmentTangent) {
        let (v_i, v_t, v_n) = self.drag.by_velocity();
        let (t, n) = (lanes::twice(&self.chord.tangent), self.drag.direction());
        let change = shear * v_i + t * (v_t * dot(&t, shear)) + n * (v_n * dot(n, shear));
        add_to_last_column(&mut slopes.own, &(change * Two::splat(-c.stiffness)));
        if let Some(block) = self.drag.by_other_velocity() {
            let change = apply(&block, &shear.map(lanes::swapped));
            add_to_last_column(&mut slopes.coupling, &(change * Two::splat(-c.stiffness)));
        }
    }
}

#[inline(always)]
fn add_to_last_column(m: &mut TwoM3, v: &TwoV3) {
    for i in 0..3 {
        m[(i, 2)] += v[i];
    }
}

/// `a tt' + b nn'`.
#[inline(always)]
fn symmetric(t: &TwoV3, a: Two, n: &TwoV3, b: Two) -> TwoM3 {
    let (ta, nb) = (t * a, n * b);
    let entry = |i: usize, j: usize| ta[i] * t[j] + nb[i] * n[j];
    let (xy, xz, yz) = (entry(0, 1), entry(0, 2), entry(1, 2));
    #[rustfmt::skip]
    let matrix = TwoM3::new(
        entry(0, 0), xy, xz,
        xy, entry(1, 1), yz,
        xz, yz, entry(2, 2),
    );
    matrix
}

/// Derivative (s, p) of the force `T t` of a segment by its chord, `s I + t p'`, weighted by the factors: axial and geometric
/// stiffness `dT/dl tt' + T/l (I - tt')`, and by the rotation of the chord with opening velocity w, `t ((I - tt') w)' C/l`.
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
