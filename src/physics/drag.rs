//! Morison drag of a segment's half, split into normal and tangential parts.
//!
//! Jia et al. 2019, eqs (2) and (3), their first terms: with u the velocity of the water relative to
//! the line, `F_n = 1/2 C_Dn rho D |u_n| u_n` and `F_t = 1/2 C_Dt rho D |u_t| u_t` per length. Each
//! node carries the drag of the halves of its segments at its own velocity (as it carries their
//! mass), so that no motion of the nodes goes undamped. The length is the stretched one when taut.

use super::DragLaw;
use crate::linalg::{M3, V3};

/// Drag of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// Reynolds number per speed, D / nu \[s/m\].
    pub reynolds: f64,
    /// `1/2 rho D` \[kg/m²\], force per length, coefficient and speed squared.
    pub normal: f64,
    /// `1/2 rho D` or `1/2 rho pi D` \[kg/m²\], as the tangential law is referred to.
    pub tangential: f64,
    /// The law of the normal coefficient.
    pub normal_law: DragLaw,
    /// The law of the tangential coefficient.
    pub tangential_law: DragLaw,
    /// Further normal drag at a constant coefficient, `1/2 rho C_D A / L` \[kg/m²\]: floats.
    pub floats: f64,
}

/// Drag of half a segment, with what its tangents are built from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drag {
    /// The force \[N\].
    pub force: V3,
    /// Normal part of the relative velocity \[m/s\].
    un: V3,
    /// 1 / |u_n|² \[s²/m²\], 0 at rest.
    inverse_un2: f64,
    /// Tangential part of the relative velocity \[m/s\].
    ut: f64,
    /// F_n = a u_n \[N s/m\].
    a: f64,
    /// F_t = b u_t \[N s/m\].
    b: f64,
    /// d|F_n| / d|u_n|.
    by_un: f64,
    /// d F_t / d u_t.
    by_ut: f64,
}

impl Profile {
    /// Drag over a length \[m\] of line with tangent t, at relative velocity u of the water \[m/s\].
    #[inline(always)]
    #[must_use]
    pub fn drag(&self, t: &V3, u: &V3, length: f64) -> Drag {
        let ut = t.dot(u);
        let un = u - t * ut;
        let un2 = un.norm_squared();
        let speed = un2.sqrt();
        let (re_n, re_t) = (self.reynolds * speed, self.reynolds * ut.abs());
        let (cn, cn_re) = self.normal_law.coefficient(re_n);
        let (ct, ct_re) = self.tangential_law.coefficient(re_t);
        let kn = length * self.normal;
        let kt = length * self.tangential;
        let a = (kn * cn + length * self.floats) * speed;
        let b = kt * ct * ut.abs();
        Drag {
            force: un * a + t * (b * ut),
            un,
            inverse_un2: if un2 > 0.0 { 1.0 / un2 } else { 0.0 },
            ut,
            a,
            b,
            by_un: 2.0 * a + kn * cn_re * re_n * speed,
            by_ut: 2.0 * b + kt * ct_re * re_t * ut.abs(),
        }
    }
}

impl Drag {
    /// Derivative of the force by the relative velocity \[N s/m\].
    #[inline(always)]
    #[must_use]
    pub fn by_velocity(&self, t: &V3) -> M3 {
        // a (I - tt') + (by_un - a) nn' + by_ut tt'
        let mut m = t * (t.transpose() * (self.by_ut - self.a));
        m += self.un * (self.un.transpose() * ((self.by_un - self.a) * self.inverse_un2));
        m[(0, 0)] += self.a;
        m[(1, 1)] += self.a;
        m[(2, 2)] += self.a;
        m
    }

    /// Derivative of the force by the chord d (the second node's position less the first's) \[N/m\],
    /// in the form `s I + t p' + u_n q'` with the numbers (s, p, q). `stretch` is 1 / chord length where the
    /// wetted length grows with the chord (taut) and 0 where it does not (slack).
    ///
    /// From u_n = u - t u_t and dt = (I - tt') dd / l:
    /// `dF = [ (by_ut - a) t u_n' - (a - b) u_t (I - tt') - (by_un - a) u_t u_n u_n' / u_n² ] dd / l + F t' dd stretch`.
    #[inline(always)]
    #[must_use]
    pub fn by_chord(&self, t: &V3, chord_length: f64, stretch: f64) -> (f64, V3, V3) {
        let inverse = 1.0 / chord_length;
        let s = -(self.a - self.b) * self.ut * inverse;
        let p = self.un * ((self.by_ut - self.a) * inverse) + t * (self.b * self.ut * stretch - s);
        let q = self.un * (-(self.by_un - self.a) * self.ut * self.inverse_un2 * inverse)
            + t * (self.a * stretch);
        (s, p, q)
    }

    /// Normal part of the relative velocity \[m/s\], the direction of q's partner in [`Drag::by_chord`].
    #[inline(always)]
    #[must_use]
    pub fn normal_velocity(&self) -> &V3 {
        &self.un
    }
}
