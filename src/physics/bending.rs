//! Bending between neighbouring segments, and at clamped ends.
//!
//! A slender rod's bending moment is EI times curvature (Garrett 1982; Lin, Guo, Niu and Zhang 2016, eq. 3
//! without twist). On a line of straight segments the curvature sits at the nodes: with unit tangents t1 and
//! t2 meeting at an angle theta and the mean of their unstretched lengths l, the energy
//! `E = EI (1 - t1.t2) / l` is `EI theta² / (2 l)` up to fourth order, the moment EI sin(theta) / l. It couples
//! nodes two apart, hence the five bands of the tangent. Where stiffness changes at the node, l / EI is the mean of both
//! segments' (their halves bend in series); a segment with EI = 0 makes it a hinge.

use crate::linalg::{BlockBand, M3, V3};

/// Forces and tangent of the bend between two segments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// Gradient of the energy by the first chord \[N\].
    pub by_first: V3,
    /// Gradient of the energy by the second chord \[N\].
    pub by_second: V3,
}

/// Second derivatives of the energy by the chords \[N/m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendTangent {
    /// By the first chord twice.
    pub first: M3,
    /// By the first, then the second.
    pub mixed: M3,
    /// By the second chord twice.
    pub second: M3,
}

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

/// Gradient of `k (1 - t1.t2)`; each chord by its unit tangent and 1 / length \[1/m\].
#[inline(always)]
#[must_use]
pub fn bend(k: f64, first: (&V3, f64), second: (&V3, f64)) -> Bend {
    let ((t1, i1), (t2, i2)) = (first, second);
    let cos = t1.dot(t2);
    Bend {
        by_first: (t2 - t1 * cos) * (-k * i1),
        by_second: (t1 - t2 * cos) * (-k * i2),
    }
}

/// Second derivatives of `k (1 - t1.t2)`. With `c = t1.t2`, `P = I - tt'` and `w = t2 - c t1`, the first is
/// `k / l1² (t1 w' + w t1' + c P1)` and the mixed one `-k / (l1 l2) P1 P2`; both multiplied out.
#[inline(always)]
#[must_use]
pub fn bend_tangent(k: f64, first: (&V3, f64), second: (&V3, f64)) -> BendTangent {
    let ((t1, i1), (t2, i2)) = (first, second);
    let c = t1.dot(t2);
    let cross = M3::from_columns(&[t1 * t2.x, t1 * t2.y, t1 * t2.z]);
    let square = |t: &V3| M3::from_columns(&[t * t.x, t * t.y, t * t.z]);
    let (s1, s2) = (square(t1), square(t2));
    let both = cross + cross.transpose();
    let own = |s: &M3, i: f64| {
        let k = k * i * i;
        with_diagonal((both - s * (3.0 * c)) * k, c * k)
    };
    let m = -k * i1 * i2;
    BendTangent {
        first: own(&s1, i1),
        mixed: with_diagonal((cross * c - s1 - s2) * m, m),
        second: own(&s2, i2),
    }
}

#[inline(always)]
fn with_diagonal(mut m: M3, s: f64) -> M3 {
    m[(0, 0)] += s;
    m[(1, 1)] += s;
    m[(2, 2)] += s;
    m
}

impl Bend {
    /// Adds the forces of the bend at node i to the residual.
    #[inline(always)]
    pub fn add(&self, i: usize, r: &mut [V3]) {
        r[i - 1] -= self.by_first;
        r[i] += self.by_first - self.by_second;
        r[i + 1] += self.by_second;
    }
}

impl BendTangent {
    /// Adds their derivatives to the tangent; sets its far blocks.
    #[inline(always)]
    pub fn add(&self, i: usize, tangent: &mut BlockBand) {
        let Self {
            first,
            mixed,
            second,
        } = self;
        let back = mixed.transpose();
        let (near, far) = (mixed - first, mixed - second);
        tangent.diag[i - 1] += first;
        tangent.diag[i] -= near + far.transpose();
        tangent.diag[i + 1] += second;
        tangent.upper[i - 1] += near;
        tangent.lower[i] += back - first;
        tangent.upper[i] += far;
        tangent.lower[i + 1] += back - second;
        tangent.far_upper[i - 1] = -mixed;
        tangent.far_lower[i + 1] = -back;
    }
}

/// Curvature \[1/m\] at the node between two segments of these unit tangents and mean unstretched length \[m\]: the one
/// whose EI multiple is the moment of the energy above.
#[must_use]
pub fn curvature(t1: &V3, t2: &V3, length: f64) -> f64 {
    t1.cross(t2).norm() / length
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
                (
                    bend(k, (&a.0, a.1), (&b.0, b.1)),
                    bend_tangent(k, (&a.0, a.1), (&b.0, b.1)),
                )
            };
            let (force, tangent) = both(&d1, &d2);
            for axis in 0..3 {
                let mut h = V3::zeros();
                h[axis] = 1e-6;
                let slope = (energy(k, &(d1 + h), &d2) - energy(k, &(d1 - h), &d2)) / 2e-6;
                assert!((slope - force.by_first[axis]).abs() < 1e-8);
                let (up, down) = (both(&(d1 + h), &d2).0, both(&(d1 - h), &d2).0);
                assert!(
                    ((up.by_first - down.by_first) / 2e-6 - tangent.first.column(axis)).norm()
                        < 1e-8
                );
                let mixed = (up.by_second - down.by_second) / 2e-6;
                assert!((mixed - tangent.mixed.transpose().column(axis)).norm() < 1e-8);
                let (up, down) = (both(&d1, &(d2 + h)).0, both(&d1, &(d2 - h)).0);
                assert!(
                    ((up.by_second - down.by_second) / 2e-6 - tangent.second.column(axis)).norm()
                        < 1e-8
                );
            }
        }
    }
}
