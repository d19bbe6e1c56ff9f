//! Morison drag of a segment, split into normal and tangential parts and into its two halves.
//!
//! Jia et al. 2019, eqs (2) and (3), their first terms: with u the velocity of the water relative to
//! the line, `F_n = 1/2 C_Dn rho D |u_n| u_n` and `F_t = 1/2 C_Dt rho D |u_t| u_t` per length. Each
//! node carries the drag of the halves of its segments at its own velocity (as it carries their
//! mass), so that no motion of the nodes goes undamped. The length is the stretched one when taut.
//!
//! # Where the coefficient jumps
//! A drag crisis (1.27 falling to 0.3 in eq. 4) would make the force of a whole half segment jump when
//! its node passes the critical speed. On the line itself the place where the speed is critical moves
//! along steadily. So between two nodes on either side of the crisis the speed is taken as linear,
//! and each half counts the two coefficients by the lengths that lie on either side. The printed law is
//! not smoothed: only the place where it jumps is found within the segment instead of at its nodes.

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
    /// Speed at which the normal coefficient jumps \[m/s\]; infinite where it does not.
    pub crisis: f64,
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
    /// Its direction, zero at rest.
    direction: V3,
    /// Its size \[m/s\].
    speed: f64,
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
    /// d|F_n| / d|u_n| of the other half, through the place of the crisis between them.
    by_other: f64,
}

/// A coefficient and its slopes by the speeds \[s/m\] at the own and at the other node.
#[derive(Debug, Clone, Copy)]
struct Coefficient {
    value: f64,
    by_own: f64,
    by_other: f64,
}

/// Normal and tangential part of a relative velocity.
#[derive(Debug, Clone, Copy)]
struct Split {
    un: V3,
    speed: f64,
    ut: f64,
}

impl Split {
    #[inline(always)]
    fn new(t: &V3, u: &V3) -> Self {
        let ut = t.dot(u);
        let un = u - t * ut;
        Self {
            un,
            speed: un.norm(),
            ut,
        }
    }
}

impl Profile {
    /// Drag of both halves of a segment, each of this length \[m\], with tangent t, at the relative velocities of
    /// the water at its two nodes \[m/s\]; with the normal coefficients `held`, where they are.
    #[inline(always)]
    #[must_use]
    pub fn drag(&self, t: &V3, u: [&V3; 2], length: f64, held: Option<&[f64; 2]>) -> [Drag; 2] {
        let split = [Split::new(t, u[0]), Split::new(t, u[1])];
        let normal = match held {
            Some(held) => held.map(|value| Coefficient {
                value,
                by_own: 0.0,
                by_other: 0.0,
            }),
            None => self.normal([split[0].speed, split[1].speed]),
        };
        [
            self.half(t, &split[0], normal[0], length),
            self.half(t, &split[1], normal[1], length),
        ]
    }

    /// Drag per length and speed squared \[kg/m²\], no less than it is whichever way the water passes at this
    /// speed \[m/s\].
    #[must_use]
    pub fn greatest(&self, speed: f64) -> f64 {
        let re = self.reynolds * speed;
        let normal = self.normal * self.normal_law.greatest(re) + self.floats;
        normal.max(self.tangential * self.tangential_law.greatest(re))
    }

    /// The normal coefficients of both halves at the relative velocities of the water at its nodes \[m/s\].
    #[must_use]
    pub fn normal_coefficients(&self, t: &V3, u: [&V3; 2]) -> [f64; 2] {
        self.normal([Split::new(t, u[0]).speed, Split::new(t, u[1]).speed])
            .map(|c| c.value)
    }

    #[inline(always)]
    fn normal(&self, speeds: [f64; 2]) -> [Coefficient; 2] {
        let astride = (speeds[0] > self.crisis) != (speeds[1] > self.crisis);
        if astride {
            self.astride(speeds)
        } else {
            self.each(speeds)
        }
    }

    #[inline(always)]
    fn each(&self, speeds: [f64; 2]) -> [Coefficient; 2] {
        [self.one_sided(speeds[0]), self.one_sided(speeds[1])]
    }

    /// The coefficient where the whole segment is on one side of the crisis.
    #[inline(always)]
    fn one_sided(&self, speed: f64) -> Coefficient {
        let (value, by_re) = self.normal_law.coefficient(self.reynolds * speed);
        Coefficient {
            value,
            by_own: by_re * self.reynolds,
            by_other: 0.0,
        }
    }

    /// The coefficients of both halves where the crisis lies at a share x of the segment: the half that holds it
    /// mixes both sides, the other half is wholly on its own side.
    #[cold]
    fn astride(&self, speeds: [f64; 2]) -> [Coefficient; 2] {
        let span = speeds[1] - speeds[0];
        let x = (self.crisis - speeds[0]) / span;
        let x_by = [-(1.0 - x) / span, -x / span];
        let mut own = self.each(speeds);
        let difference = own[0].value - own[1].value;
        // The share of the mixed half that lies on the first node's side is 2x, or 2x - 1.
        let (mixed, share) = if x < 0.5 {
            (0, 2.0 * x)
        } else {
            (1, 2.0 * x - 1.0)
        };
        let other = 1 - mixed;
        own[mixed] = Coefficient {
            value: own[1].value + difference * share,
            // The branches are flat on both sides of the crisis, so only its place has slopes.
            by_own: 2.0 * difference * x_by[mixed],
            by_other: 2.0 * difference * x_by[other],
        };
        own
    }

    #[inline(always)]
    fn half(&self, t: &V3, split: &Split, normal: Coefficient, length: f64) -> Drag {
        let Split { un, speed, ut } = *split;
        let re_t = self.reynolds * ut.abs();
        let (ct, ct_re) = self.tangential_law.coefficient(re_t);
        let kn = length * self.normal;
        let kt = length * self.tangential;
        let a = (kn * normal.value + length * self.floats) * speed;
        let b = kt * ct * ut.abs();
        let inverse_speed = if speed > 0.0 { 1.0 / speed } else { 0.0 };
        Drag {
            force: un * a + t * (b * ut),
            un,
            direction: un * inverse_speed,
            speed,
            ut,
            a,
            b,
            by_un: 2.0 * a + kn * normal.by_own * speed * speed,
            by_ut: 2.0 * b + kt * ct_re * re_t * ut.abs(),
            by_other: kn * normal.by_other * speed * speed,
        }
    }
}

impl Drag {
    /// A share of it.
    #[inline(always)]
    #[must_use]
    pub fn scaled(&self, share: f64) -> Self {
        Self {
            force: self.force * share,
            a: self.a * share,
            b: self.b * share,
            by_un: self.by_un * share,
            by_ut: self.by_ut * share,
            by_other: self.by_other * share,
            ..*self
        }
    }

    /// Derivative of the force by the relative velocity at its own node \[N s/m\], as a matrix.
    #[must_use]
    pub fn matrix(&self, t: &V3) -> M3 {
        let (i, along, across) = self.by_velocity();
        M3::from_diagonal_element(i)
            + t * (t * along).transpose()
            + self.direction * (self.direction * across).transpose()
    }

    /// Derivative of the force by the relative velocity at its own node \[N s/m\], in the form
    /// `i I + t_t tt' + n_n nn'`, the numbers (i, t_t, n_n).
    #[inline(always)]
    #[must_use]
    pub fn by_velocity(&self) -> (f64, f64, f64) {
        (self.a, self.by_ut - self.a, self.by_un - self.a)
    }

    /// Derivative of the force by the relative velocity at the segment's other node \[N s/m\]; nothing unless
    /// the crisis lies between.
    #[inline(always)]
    #[must_use]
    pub fn by_other_velocity(&self, other: &Self) -> Option<M3> {
        (self.by_other != 0.0)
            .then(|| self.direction * (other.direction * self.by_other).transpose())
    }

    /// Derivative of the force by the chord d (the second node's position less the first's) \[N/m\],
    /// in the form `s I + t p' + n q'`, n the direction of u_n, with the numbers (s, p, q). `inverse` is
    /// 1 / chord length; `stretch` is the same where the wetted length grows with the chord (taut) and 0 where it does not (slack).
    ///
    /// From u_n = u - t u_t and dt = (I - tt') dd / l, and likewise at the other node:
    /// `dF = [ (by_ut - a) t u_n' - (a - b) u_t (I - tt') - (by_un - a) u_t n n' - by_other u_t,other n n_other' ] dd / l
    ///  + F t' dd stretch`.
    #[inline(always)]
    #[must_use]
    pub fn by_chord(&self, other: &Self, t: &V3, inverse: f64, stretch: f64) -> (f64, V3, V3) {
        let s = -(self.a - self.b) * self.ut * inverse;
        let p = self.un * ((self.by_ut - self.a) * inverse) + t * (self.b * self.ut * stretch - s);
        let mut q = self.direction * (-(self.by_un - self.a) * self.ut * inverse)
            + t * (self.a * self.speed * stretch);
        if self.by_other != 0.0 {
            q -= other.direction * (self.by_other * other.ut * inverse);
        }
        (s, p, q)
    }

    /// Direction of the normal part of the relative velocity, q's partner in [`Drag::by_chord`]; zero at rest.
    #[inline(always)]
    #[must_use]
    pub fn direction(&self) -> &V3 {
        &self.direction
    }
}
