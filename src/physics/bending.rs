//! Bending between neighbouring segments, and at clamped ends.
//!
//! A slender rod's bending moment is EI times curvature (Garrett 1982; Lin, Guo, Niu and Zhang 2016, eq. 3
//! without twist). On a line of straight segments the curvature sits at the nodes: with unit tangents t1 and
//! t2 meeting at an angle theta and the mean of their unstretched lengths l, the energy
//! `E = EI (1 - t1.t2) / l` is `EI theta² / (2 l)` up to fourth order, the moment EI sin(theta) / l. It couples
//! nodes two apart, hence the five bands of the tangent. Where stiffness changes at the node, l / EI is the mean of both
//! segments' (their halves bend in series); a segment with EI = 0 makes it a hinge.

use crate::numerics::lanes::{self, Two, TwoM3, TwoV3, dot};
use crate::numerics::{M3, V3};

/// Stiffness of the bend between two segments, EI / l \[N m\], from each one's EI \[N m²\] and unstretched
/// length \[m\].
#[must_use]
pub fn stiffness(first: (f64, f64), second: (f64, f64)) -> f64 {
    if first.0 <= 0.0 || second.0 <= 0.0 {
        return 0.0;
    }
    2.0 / (first.1 / first.0 + second.1 / second.0)
}

/// Stiffness of the bend between a clamp and the first half of its segment, 2 EI / l \[N m\].
#[must_use]
pub fn clamp_stiffness(ei: f64, length: f64) -> f64 {
    2.0 * ei / length
}

/// The part of the moment at a clamp that a mesh leaves out, by the difference of that moment from the one at the next node, for segments
/// of a length `x` in units of `sqrt(EI / T)`, over which a clamp bends a line under the tension `T` (Plunkett 1967, static bending
/// stresses in catenaries and drill strings).
///
/// The exact moment falls as `exp(-s / sqrt(EI / T))`; that of a mesh by a factor `r` from node to node with `r + 1/r - 2 = x²`, from
/// `(x² + 1 - r) / (x² + 3 - r)` times `2 EI / l` times the angle that the clamp is turned by. What is exact is so that of the mesh
/// and `x/4 (1 - (1 - x/2) / (1 + sqrt(1 + x²/4)))` times the difference: `x / 8` on fine meshes, so that their order of two stays, and
/// `x / 2` on coarse ones.
#[must_use]
pub fn unresolved_at_clamp(x: f64) -> f64 {
    0.25 * x * (1.0 - (1.0 - 0.5 * x) / (1.0 + (1.0 + 0.25 * x * x).sqrt()))
}

/// The angle between two chords, both side by side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendAngle {
    /// Unit tangents.
    t: TwoV3,
    /// 1 / length \[1/m\].
    inverse: Two,
    /// `t1.t2`.
    cos: Two,
    /// Of each tangent what the other has across it: `t2 - c t1` and `t1 - c t2`.
    across: TwoV3,
}

/// Second derivatives of the energy by the chords \[N/m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendTangent {
    /// By each chord twice.
    pub own: TwoM3,
    /// By the first, then the second.
    pub mixed: M3,
}

impl BendAngle {
    /// Between two chords, each by its unit tangent and 1 / length \[1/m\].
    #[inline(always)]
    #[must_use]
    pub fn new(first: (&V3, f64), second: (&V3, f64)) -> Self {
        let t = lanes::vectors(first.0, second.0);
        let other = lanes::vectors(second.0, first.0);
        let cos = dot(&t, &other);
        Self {
            t,
            inverse: Two::new([first.1, second.1]),
            cos,
            across: other - t * cos,
        }
    }

    /// Gradient of `k (1 - t1.t2)` by each chord \[N\].
    #[inline(always)]
    #[must_use]
    pub fn forces(&self, k: f64) -> [V3; 2] {
        let both = self.across * (self.inverse * -k);
        [0, 1].map(|chord| lanes::vector(&both, chord))
    }

    /// Second derivatives of `k (1 - t1.t2)`. With `c = t1.t2`, `P = I - tt'` and `w = t2 - c t1`, the first is
    /// `k / l1² (t1 w' + w t1' + c P1)` and the mixed one
    /// `-k / (l1 l2) P1 P2 = k / (l1 l2) (t1 (t1 - c t2)' + t2 t2' - I)`.
    #[inline(always)]
    #[must_use]
    pub fn tangent(&self, k: f64) -> BendTangent {
        let (t, stiffness) = (&self.t, self.inverse * self.inverse * k);
        let z = (self.across - t * (self.cos * 0.5)) * stiffness;
        let own = |i: usize, j: usize| t[i] * z[j] + z[i] * t[j];
        let on_diagonal = |i: usize| own(i, i) + self.cos * stiffness;
        let (xy, xz, yz) = (own(0, 1), own(0, 2), own(1, 2));
        #[rustfmt::skip]
        let own = TwoM3::new(
            on_diagonal(0), xy, xz,
            xy, on_diagonal(1), yz,
            xz, yz, on_diagonal(2),
        );
        let [first, second] = self.inverse.to_array();
        let m = k * first * second;
        let [t1, t2] = [0, 1].map(|chord| lanes::vector(t, chord));
        let across = lanes::vector(&self.across, 1);
        let mixed = lanes::outer(&(t1 * m), &across) + lanes::outer(&(t2 * m), &t2);
        BendTangent {
            own,
            mixed: lanes::plus_diagonal(mixed, -m),
        }
    }
}

/// Curvature \[1/m\] at the node between two segments of these unit tangents and mean unstretched length \[m\], about its axis: the one
/// whose EI multiple is the moment of the energy above.
#[must_use]
pub fn curvature(t1: &V3, t2: &V3, length: f64) -> V3 {
    t1.cross(t2) / length
}

#[cfg(test)]
mod tests {
    use super::*;

    fn energy(k: f64, d1: &V3, d2: &V3) -> f64 {
        k * (1.0 - d1.normalize().dot(&d2.normalize()))
    }

    #[test]
    fn forces_and_tangents_are_finite_differences() {
        let k = 3.0;
        for (d1, d2) in [
            (V3::new(1.0, 0.2, -0.3), V3::new(0.7, -0.5, 0.4)),
            (V3::new(1.0, 0.0, 0.0), V3::new(-0.2, 2.0, 0.1)),
        ] {
            let parts = |d: &V3| (d.normalize(), 1.0 / d.norm());
            let both = |d1: &V3, d2: &V3| {
                let (a, b) = (parts(d1), parts(d2));
                let bend = BendAngle::new((&a.0, a.1), (&b.0, b.1));
                (bend.forces(k), bend.tangent(k))
            };
            let (force, tangent) = both(&d1, &d2);
            let [first, second] = [0, 1].map(|chord| lanes::block(&tangent.own, chord));
            for axis in 0..3 {
                let mut h = V3::zeros();
                h[axis] = 1e-6;
                let slope = (energy(k, &(d1 + h), &d2) - energy(k, &(d1 - h), &d2)) / 2e-6;
                assert!((slope - force[0][axis]).abs() < 1e-8);
                let (up, down) = (both(&(d1 + h), &d2).0, both(&(d1 - h), &d2).0);
                assert!(((up[0] - down[0]) / 2e-6 - first.column(axis)).norm() < 1e-8);
                let mixed = (up[1] - down[1]) / 2e-6;
                assert!((mixed - tangent.mixed.transpose().column(axis)).norm() < 1e-8);
                let (up, down) = (both(&d1, &(d2 + h)).0, both(&d1, &(d2 - h)).0);
                assert!(((up[1] - down[1]) / 2e-6 - second.column(axis)).norm() < 1e-8);
            }
        }
    }
}
