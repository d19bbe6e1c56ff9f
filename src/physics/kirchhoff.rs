//! The water that a body symmetric about an axis sets in motion as it moves and turns: Kirchhoff's equations.
//!
//! The kinetic energy of that water is `T = 1/2 A_n |v|² + 1/2 (A_t - A_n) (t.v)² + 1/2 I |t'|²`, with v the velocity of the
//! centre of the added mass relative to the water, t the axis and t' its rate (Lamb 1932, art. 124; Fossen 2011, sec. 6.3.1).
//! The force and couple on the body follow by Lagrange's equations: at that centre the rate of the momentum
//! `A_n v + (A_t - A_n) (t.v) t`, and about it the couple `I t''` across the axis less Munk's `(A_t - A_n) (t.v) v`, which
//! turns an elongated body across the flow. A sphere, with one added mass in all directions, has none of it.
//!
//! A couple is given as the vector C across the axis that its moment `t x C` is of \[N m\]: forces -C/d and C/d on the ends of a
//! rod of length d.

use super::added_mass::AddedMass;
use crate::numerics::{M3, V3};

/// Added mass and added moment of inertia.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct KirchhoffAddedMass {
    /// Across the axis \[kg\].
    pub normal: f64,
    /// Along the axis \[kg\].
    pub tangential: f64,
    /// About an axis across, through the centre of the added mass \[kg m²\].
    pub inertia: f64,
}

/// How the body moves. Of both rates of the axis only the part across it counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeMotion {
    /// The axis, a unit vector.
    pub t: V3,
    /// Velocity of the centre relative to the water \[m/s\].
    pub v: V3,
    /// Acceleration of the centre relative to the water \[m/s²\].
    pub a: V3,
    /// Rate of the axis \[1/s\].
    pub turn: V3,
    /// Rate of that \[1/s²\].
    pub gain: V3,
}

/// Derivatives of a force or a couple by each quantity of [`RelativeMotion`], taken as independent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionDerivatives {
    /// By the axis.
    pub t: M3,
    /// By the velocity.
    pub v: M3,
    /// By the acceleration.
    pub a: M3,
    /// By the rate of the axis.
    pub turn: M3,
    /// By the rate of that.
    pub gain: M3,
}

impl KirchhoffAddedMass {
    /// The added mass alone.
    #[must_use]
    pub fn mass(&self) -> AddedMass {
        AddedMass {
            normal: self.normal,
            tangential: self.tangential,
        }
    }

    /// The added mass as a matrix \[kg\].
    #[must_use]
    pub fn matrix(&self, t: &V3) -> M3 {
        M3::from_diagonal_element(self.normal) + t * t.transpose() * self.anisotropy()
    }

    fn anisotropy(&self) -> f64 {
        self.tangential - self.normal
    }

    /// Force at the centre \[N\] and couple \[N m\] that the motion needs.
    #[must_use]
    pub fn force_and_couple(&self, of: &RelativeMotion) -> (V3, V3) {
        let (force, couple) = self.velocity_terms(of);
        let gain = of.gain - of.t * of.t.dot(&of.gain);
        (
            force + self.mass().force(&of.t, &of.a),
            couple + gain * self.inertia,
        )
    }

    /// The terms of that in velocities alone: `(A_t - A_n) [(t'.v) t + (t.v) t']` and Munk's couple.
    #[must_use]
    pub fn velocity_terms(&self, of: &RelativeMotion) -> (V3, V3) {
        let (t, more) = (&of.t, self.anisotropy());
        let ahead = t.dot(&of.v);
        let (aside, turn) = (of.v - t * ahead, of.turn - t * t.dot(&of.turn));
        (
            (t * turn.dot(&of.v) + turn * ahead) * more,
            aside * (-more * ahead),
        )
    }

    /// Kinetic energy of the water \[J\].
    #[must_use]
    pub fn energy(&self, of: &RelativeMotion) -> f64 {
        let turn = of.turn - of.t * of.t.dot(&of.turn);
        0.5 * of.v.dot(&(self.matrix(&of.t) * of.v)) + 0.5 * self.inertia * turn.norm_squared()
    }

    /// Derivatives of force and couple.
    #[must_use]
    pub fn derivatives(&self, of: &RelativeMotion) -> [MotionDerivatives; 2] {
        let RelativeMotion {
            t,
            v,
            a,
            turn,
            gain,
        } = of;
        let more = self.anisotropy();
        let (ahead, sigma) = (t.dot(v), t.dot(turn));
        let across = M3::identity() - t * t.transpose();
        let (aside, turned) = (across * v, across * turn);
        let eye = M3::from_diagonal_element;
        let force_t = eye(turned.dot(v)) - t * (v * sigma + turn * ahead).transpose()
            + turned * v.transpose()
            - (eye(sigma) + t * turn.transpose()) * ahead
            + eye(t.dot(a))
            + t * a.transpose();
        let couple_t = (eye(ahead) + t * v.transpose()) * ahead - aside * v.transpose();
        let force = MotionDerivatives {
            t: force_t * more,
            v: (t * turned.transpose() + turned * t.transpose()) * more,
            a: self.matrix(t),
            turn: (t * aside.transpose() + across * ahead) * more,
            gain: M3::zeros(),
        };
        let couple = MotionDerivatives {
            t: couple_t * more - (eye(t.dot(gain)) + t * gain.transpose()) * self.inertia,
            v: (aside * t.transpose() + across * ahead) * -more,
            a: M3::zeros(),
            turn: M3::zeros(),
            gain: across * self.inertia,
        };
        [force, couple]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WATER: KirchhoffAddedMass = KirchhoffAddedMass {
        normal: 700.0,
        tangential: 250.0,
        inertia: 180.0,
    };

    fn moving() -> RelativeMotion {
        RelativeMotion {
            t: V3::new(0.48, -0.6, 0.64),
            v: V3::new(0.3, -0.7, 1.1),
            a: V3::new(-1.0, 0.4, 0.2),
            turn: V3::new(0.5, 0.1, -0.9),
            gain: V3::new(0.2, -1.3, 0.6),
        }
    }

    #[test]
    fn slopes_are_finite_differences() {
        let slopes = WATER.derivatives(&moving());
        for j in 0..3 {
            let mut h = V3::zeros();
            h[j] = 1e-6;
            let shifted: [fn(&mut RelativeMotion, V3); 5] = [
                |m, h| m.t += h,
                |m, h| m.v += h,
                |m, h| m.a += h,
                |m, h| m.turn += h,
                |m, h| m.gain += h,
            ];
            for (which, shift) in shifted.into_iter().enumerate() {
                let (mut up, mut down) = (moving(), moving());
                shift(&mut up, h);
                shift(&mut down, -h);
                let (up, down) = (WATER.force_and_couple(&up), WATER.force_and_couple(&down));
                for (slopes, column) in slopes
                    .iter()
                    .zip([(up.0 - down.0) / 2e-6, (up.1 - down.1) / 2e-6])
                {
                    let all = [slopes.t, slopes.v, slopes.a, slopes.turn, slopes.gain];
                    let off = column - all[which].column(j);
                    assert!(off.norm() < 1e-5, "{which} {j}: {off}");
                }
            }
        }
    }

    /// The rate of the energy is what force and couple do: they follow from it.
    #[test]
    fn the_push_does_the_work_that_the_energy_gains() {
        let mut of = moving();
        of.turn -= of.t * of.t.dot(&of.turn);
        let later = |h: f64| {
            let mut then = of;
            then.t = (of.t + of.turn * h).normalize();
            then.v += of.a * h;
            then.turn += of.gain * h;
            WATER.energy(&then)
        };
        let rate = (later(1e-6) - later(-1e-6)) / 2e-6;
        let (force, couple) = WATER.force_and_couple(&of);
        let work = force.dot(&of.v) + couple.dot(&of.turn);
        assert!((rate - work).abs() < 1e-5 * work.abs(), "{rate} {work}");
    }

    /// Lamb 1932, art. 124: a body held at an angle to a stream feels the couple `(A_n - A_t) U² sin cos` across it.
    #[test]
    fn a_body_held_askew_feels_munks_moment() {
        let angle = 0.4_f64;
        let held = RelativeMotion {
            t: V3::x(),
            v: V3::new(-angle.cos(), -angle.sin(), 0.0) * 3.0,
            a: V3::zeros(),
            turn: V3::zeros(),
            gain: V3::zeros(),
        };
        let (force, couple) = WATER.force_and_couple(&held);
        assert_eq!(force, V3::zeros());
        let munk = (700.0 - 250.0) * 9.0 * angle.sin() * angle.cos();
        assert!((couple - V3::y() * munk).norm() < 1e-9, "{couple}");
    }
}
