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

use nalgebra::{Matrix3, Vector3};

use super::DragLaw;
use crate::numerics::V3;
use crate::numerics::lanes::{self, Number, Two, TwoM3, TwoV3, dot, outer, plus_diagonal};

/// Drag of a material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DragProperties {
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
    /// The same along the line \[kg/m²\].
    pub floats_tangential: f64,
}

/// Drag of half a segment, or of both halves side by side, with what its tangents are built from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drag<T = f64> {
    /// The force \[N\].
    pub force: Vector3<T>,
    /// Normal part of the relative velocity \[m/s\].
    un: Vector3<T>,
    /// Its direction, zero at rest.
    direction: Vector3<T>,
    /// Its size \[m/s\].
    speed: T,
    /// Tangential part of the relative velocity \[m/s\].
    ut: T,
    /// F_n = a u_n \[N s/m\].
    a: T,
    /// F_t = b u_t \[N s/m\].
    b: T,
    /// d|F_n| / d|u_n|.
    by_un: T,
    /// d F_t / d u_t.
    by_ut: T,
    /// d|F_n| / d|u_n| of the other half, through the place of the crisis between them.
    by_other: T,
}

/// The coefficients of both halves and their slopes by the speeds \[s/m\] at the own and at the other node.
#[derive(Debug, Clone, Copy)]
struct HalfCoefficients {
    value: Two,
    by_own: Two,
    by_other: Two,
}

/// The relative velocities of the water at both nodes of a segment in parts, normal and tangential to it.
#[derive(Debug, Clone, Copy, Default)]
pub struct VelocityParts {
    /// Normal parts \[m/s\].
    un: TwoV3,
    /// Their sizes \[m/s\].
    speed: Two,
    /// One over these \[s/m\], 0 at rest.
    inverse_speed: Two,
    /// Tangential parts \[m/s\].
    ut: Two,
}

impl VelocityParts {
    /// Of the relative velocities at both nodes \[m/s\], along and across the tangent t.
    #[inline(always)]
    pub fn new(t: &V3, u: [&V3; 2]) -> Self {
        let (t, u) = (lanes::twice(t), lanes::vectors(u[0], u[1]));
        let ut = dot(&t, &u);
        let un = u - t * ut;
        let speed = dot(&un, &un).sqrt();
        let moving = speed.simd_gt(Two::ZERO);
        Self {
            un,
            speed,
            inverse_speed: moving.select(Two::ONE / speed, Two::ZERO),
            ut,
        }
    }
}

impl DragProperties {
    /// Of a body with an axis, by `1/2 rho C_D A` across and along it \[kg/m\]: the drag of a length of 1 is that of the body.
    #[must_use]
    pub fn of_body(across: f64, along: f64) -> Self {
        Self {
            reynolds: 0.0,
            normal: across,
            tangential: along,
            normal_law: DragLaw::Constant(1.0),
            tangential_law: DragLaw::Constant(1.0),
            crisis: f64::INFINITY,
            floats: 0.0,
            floats_tangential: 0.0,
        }
    }

    /// Drag of both halves of a segment side by side, each of this length \[m\], with tangent t, at the relative velocities of
    /// the water at its two nodes \[m/s\]; with the normal coefficients `held`, where they are.
    #[inline(always)]
    #[must_use]
    pub fn drag(&self, t: &V3, u: [&V3; 2], length: f64, held: Option<&[f64; 2]>) -> Drag<Two> {
        self.by_parts(t, &VelocityParts::new(t, u), length, held)
    }

    /// The same by relative velocities in parts.
    #[inline(always)]
    pub fn by_parts(
        &self,
        t: &V3,
        parts: &VelocityParts,
        length: f64,
        held: Option<&[f64; 2]>,
    ) -> Drag<Two> {
        let normal = match held {
            Some(held) => HalfCoefficients {
                value: Two::new(*held),
                by_own: Two::ZERO,
                by_other: Two::ZERO,
            },
            None => self.normal(parts.speed),
        };
        self.both_halves(&lanes::twice(t), parts, &normal, length)
    }

    /// Drag per length and speed squared \[kg/m²\], no less than it is whichever way the water passes at this
    /// speed \[m/s\].
    #[must_use]
    pub fn greatest(&self, speed: f64) -> f64 {
        let re = self.reynolds * speed;
        let normal = self.normal * self.normal_law.greatest(re) + self.floats;
        normal.max(self.tangential * self.tangential_law.greatest(re) + self.floats_tangential)
    }

    /// The normal coefficients of both halves at the relative velocities of the water at its nodes \[m/s\].
    #[must_use]
    pub fn normal_coefficients(&self, t: &V3, u: [&V3; 2]) -> [f64; 2] {
        self.normal(VelocityParts::new(t, u).speed).value.to_array()
    }

    #[inline(always)]
    fn normal(&self, speeds: Two) -> HalfCoefficients {
        let mut each = self.each(speeds);
        let beyond = speeds.simd_gt(Two::splat(self.crisis));
        if beyond.any() && !beyond.all() {
            // Numbers go in and out, so that lanes stay in registers where there is no crisis.
            let [value, by_own, by_other] = self.astride(
                speeds.to_array(),
                each.value.to_array(),
                each.by_own.to_array(),
            );
            each = HalfCoefficients {
                value: Two::new(value),
                by_own: Two::new(by_own),
                by_other: Two::new(by_other),
            };
        }
        each
    }

    /// The coefficients where the whole segment is on one side of the crisis.
    #[inline(always)]
    fn each(&self, speeds: Two) -> HalfCoefficients {
        let (value, by_re) = coefficients(self.normal_law, speeds * self.reynolds);
        HalfCoefficients {
            value,
            by_own: by_re * self.reynolds,
            by_other: Two::ZERO,
        }
    }

    /// The coefficients of both halves where the crisis lies at a share x of the segment: the half that holds it
    /// mixes both sides, the other half is wholly on its own side, as `each` has them.
    #[cold]
    #[inline(never)]
    fn astride(&self, speeds: [f64; 2], sides: [f64; 2], by_own: [f64; 2]) -> [[f64; 2]; 3] {
        let span = speeds[1] - speeds[0];
        let x = (self.crisis - speeds[0]) / span;
        let x_by = [-(1.0 - x) / span, -x / span];
        let difference = sides[0] - sides[1];
        // The share of the mixed half that lies on the first node's side is 2x, or 2x - 1.
        let (mixed, share) = if x < 0.5 {
            (0, 2.0 * x)
        } else {
            (1, 2.0 * x - 1.0)
        };
        let (mut value, mut by_own, mut by_other) = (sides, by_own, [0.0; 2]);
        value[mixed] = sides[1] + difference * share;
        // The branches are flat on both sides of the crisis, so only its place has slopes.
        by_own[mixed] = 2.0 * difference * x_by[mixed];
        by_other[mixed] = 2.0 * difference * x_by[1 - mixed];
        [value, by_own, by_other]
    }

    #[inline(always)]
    fn both_halves(
        &self,
        t: &TwoV3,
        parts: &VelocityParts,
        normal: &HalfCoefficients,
        length: f64,
    ) -> Drag<Two> {
        let VelocityParts {
            un,
            speed,
            inverse_speed,
            ut,
        } = *parts;
        let sliding = ut.abs();
        let re_t = sliding * self.reynolds;
        let (ct, ct_re) = coefficients(self.tangential_law, re_t);
        let (kn, kt) = (length * self.normal, length * self.tangential);
        let a = (normal.value * kn + length * self.floats) * speed;
        let b = ct * sliding * kt + sliding * (length * self.floats_tangential);
        let faster = speed * speed * kn;
        Drag {
            force: un * a + t * (b * ut),
            un,
            direction: un * inverse_speed,
            speed,
            ut,
            a,
            b,
            by_un: a * 2.0 + faster * normal.by_own,
            by_ut: b * 2.0 + ct_re * re_t * sliding * kt,
            by_other: faster * normal.by_other,
        }
    }
}

/// The coefficients of a law and their derivatives at two Reynolds numbers.
#[inline(always)]
fn coefficients(law: DragLaw, re: Two) -> (Two, Two) {
    let [first, second] = re.to_array().map(|re| law.coefficient(re));
    (Two::new([first.0, second.0]), Two::new([first.1, second.1]))
}

impl<T: Number> Drag<T> {
    /// Derivative of the force by the relative velocity at its own node \[N s/m\], as a matrix.
    #[must_use]
    pub fn matrix(&self, t: &Vector3<T>) -> Matrix3<T> {
        let (i, along, across) = self.by_velocity();
        let n = &self.direction;
        plus_diagonal(outer(t, &(t * along)) + outer(n, &(n * across)), i)
    }

    /// Derivative of the force by the relative velocity at its own node \[N s/m\], in the form
    /// `i I + t_t tt' + n_n nn'`, the numbers (i, t_t, n_n).
    #[inline(always)]
    #[must_use]
    pub fn by_velocity(&self) -> (T, T, T) {
        (self.a, self.by_ut - self.a, self.by_un - self.a)
    }

    /// Direction of the normal part of the relative velocity, q's partner in [`Drag::by_chord`]; zero at rest.
    #[inline(always)]
    #[must_use]
    pub fn direction(&self) -> &Vector3<T> {
        &self.direction
    }
}

impl Drag<Two> {
    /// The forces on both halves \[N\].
    #[inline(always)]
    #[must_use]
    pub fn forces(&self) -> [V3; 2] {
        [0, 1].map(|half| lanes::vector(&self.force, half))
    }

    /// A share of it.
    #[inline(always)]
    #[must_use]
    pub fn scaled(&self, share: Two) -> Self {
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

    /// Derivative of the force by the relative velocity at the segment's other node \[N s/m\]; nothing unless
    /// the crisis lies between.
    #[inline(always)]
    #[must_use]
    pub fn by_other_velocity(&self) -> Option<TwoM3> {
        let astride = self.by_other != Two::ZERO;
        let other = || self.direction.map(lanes::swapped);
        astride.then(|| outer(&self.direction, &(other() * self.by_other)))
    }

    /// Derivative of the force by the chord d (the second node's position less the first's) \[N/m\],
    /// in the form `s I + t p' + n q'`, n the direction of u_n, with the numbers (s, p, q). `inverse` is
    /// 1 / chord length; `stretch` is the same where the wetted length grows with the chord (taut) and 0 where it does not (slack).
    ///
    /// From u_n = u - t u_t and dt = (I - tt') dd / l:
    /// `dF = [ (by_ut - a) t u_n' - (a - b) u_t (I - tt') - (by_un - a) u_t n n' ] dd / l + F t' dd stretch`.
    /// Where the crisis lies between the nodes, [`Drag::by_other_velocity`] times [`Drag::turning_of_other`] is to be
    /// taken off.
    #[inline(always)]
    #[must_use]
    pub fn by_chord(&self, t: &TwoV3, inverse: f64, stretch: f64) -> (Two, TwoV3, TwoV3) {
        let turning = self.ut * inverse;
        let s = (self.b - self.a) * turning;
        let p = self.un * ((self.by_ut - self.a) * inverse) + t * (self.b * self.ut * stretch - s);
        let q = self.direction * ((self.a - self.by_un) * turning)
            + t * (self.a * self.speed * stretch);
        (s, p, q)
    }

    /// Derivative of the force by the tangent t \[N\], which stays a unit vector: [`Drag::by_chord`] of a chord of unit length that is wetted
    /// over the same length however it turns.
    #[must_use]
    pub fn by_direction(&self, t: &TwoV3) -> TwoM3 {
        let (s, p, q) = self.by_chord(t, 1.0, 0.0);
        plus_diagonal(outer(t, &p) + outer(&self.direction, &q), s)
    }

    /// How fast the normal part of the relative velocity at the segment's other node falls as the chord turns its way,
    /// u_t / l \[1/s\].
    #[must_use]
    pub fn turning_of_other(&self, inverse: f64) -> Two {
        lanes::swapped(self.ut) * inverse
    }
}
