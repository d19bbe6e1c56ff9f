//! Lines that are paid out, and points that slide or are hauled along them: what drives the length that passes.

use std::f64::consts::PI;

use crate::physics::EndMotion;

/// Line that passes an end of it, or from one line through a point into another.
#[derive(Debug, Clone, PartialEq)]
pub struct Payout {
    /// The ends it passes, and its sign there: 1 where the line grows.
    pub ends: Vec<PaidEnd>,
    /// What drives it.
    pub drive: Drive,
    /// Share of the heave of its end that is paid out besides \[-\].
    pub heave: f64,
}

/// An end of a line that another length of it comes out of at every time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaidEnd {
    /// The line.
    pub line: usize,
    /// Which end: 0 for A, 1 for B.
    pub end: usize,
    /// 1 where the line grows with the length that passes, -1 where it shrinks.
    pub sign: f64,
}

/// What drives a payout.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// A rate from a time to another, growing and falling over a ramp.
    Rate(RateCourse),
    /// A table, growing in over a ramp.
    Table(EndMotion),
    /// A winch.
    Winch(Winch),
    /// Nothing but the line and friction: a point slides along it.
    Slide(PointFriction),
}

/// A rate from a time to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RateCourse {
    pub(super) rate: f64,
    pub(super) start: f64,
    pub(super) stop: f64,
    pub(super) ramp: f64,
}

/// A winch: a drum that turns against its drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Winch {
    /// Moment of inertia of drum and drive by the square of the radius \[kg\].
    pub mass: f64,
    /// Least and greatest force of the drive \[N\].
    pub(super) limits: [f64; 2],
    /// Rate at which the drive has the least force \[m/s\], and its slope there \[N s/m\].
    pub(super) rate: f64,
    pub(super) slope: f64,
    /// Greatest rate either way \[m/s\], beyond which it brakes.
    pub(super) fastest: Option<f64>,
    /// Time over which it is let go \[s\].
    pub ramp: f64,
}

/// Friction of a point on a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointFriction {
    /// That which does not depend on the tension \[N\].
    pub constant: f64,
    /// By the force of the line across the point \[-\].
    pub coefficient: f64,
    /// Time over which it is let go \[s\].
    pub ramp: f64,
}

/// Share of its rate by which the load slows a winch that hauls in, or drives one that pays out, from nothing to its greatest tension.
pub(super) const SLIP: f64 = 0.02;
/// The same of the brake at the greatest rate, at twice the tension that is kept.
const BRAKE_SLIP: f64 = 1e-3;
/// Least rate that slip is counted by \[m/s\].
pub(super) const LEAST_RATE: f64 = 0.1;
/// By how much an iteration passes a corner of a force, by its rate.
const CORNER: f64 = 1e-6;
/// Speed at which friction is full but for 30 % \[m/s\]: below it a point creeps.
const CREEP: f64 = 1e-3;

impl RateCourse {
    /// Length paid out \[m\] at time t \[s\], its rate and the rate of that.
    #[must_use]
    pub fn at(&self, t: f64) -> [f64; 3] {
        let since = |begin: f64| {
            let (tau, ramp) = (t - begin, self.ramp);
            let turn = PI / ramp;
            if tau <= 0.0 {
                [0.0; 3]
            } else if tau >= ramp {
                [tau - 0.5 * ramp, 1.0, 0.0]
            } else {
                let (sin, cos) = (turn * tau).sin_cos();
                [
                    0.5 * (tau - sin / turn),
                    0.5 * (1.0 - cos),
                    0.5 * turn * sin,
                ]
            }
        };
        let (on, off) = (since(self.start), since(self.stop));
        std::array::from_fn(|k| self.rate * (on[k] - off[k]))
    }
}

impl Winch {
    /// Force of the drive against paying out \[N\] at a rate \[m/s\], and its slope \[N s/m\].
    #[must_use]
    pub fn force(&self, rate: f64) -> (f64, f64) {
        let [least, greatest] = self.limits;
        let driven = least + self.slope * (rate - self.rate);
        let (mut force, mut slope) = if driven >= greatest {
            (greatest, 0.0)
        } else if driven <= least {
            (least, 0.0)
        } else {
            (driven, self.slope)
        };
        if let Some(fastest) = self.fastest
            && rate.abs() > fastest
        {
            let brake = greatest / (BRAKE_SLIP * fastest);
            force += brake * (rate - fastest.copysign(rate));
            slope += brake;
        }
        (force, slope)
    }

    /// The rates at which its force has a corner \[m/s\].
    fn corners(&self) -> [Option<f64>; 4] {
        let [least, greatest] = self.limits;
        let driven = (self.slope > 0.0).then(|| (greatest - least) / self.slope);
        [
            driven.map(|_| self.rate),
            driven.map(|slip| self.rate + slip),
            self.fastest,
            self.fastest.map(|fastest| -fastest),
        ]
    }
}

impl PointFriction {
    /// Friction by that of full sliding at a rate \[m/s\], from -1 to 1, and its slope \[s/m\].
    #[must_use]
    pub fn share(rate: f64) -> (f64, f64) {
        let root = rate.hypot(CREEP);
        (rate / root, CREEP * CREEP / root.powi(3))
    }
}

impl Drive {
    /// Whether the length that passes is an unknown.
    #[must_use]
    pub fn is_free(&self) -> bool {
        matches!(self, Self::Winch(_) | Self::Slide(_))
    }

    /// Mass of the drum \[kg\] and greatest slope of its force by the rate \[N s/m\], where the length is an unknown; friction that
    /// depends on the tension counts by none.
    #[must_use]
    pub fn mass_and_slope(&self) -> Option<(f64, f64)> {
        match self {
            Self::Winch(winch) => {
                let brake = winch
                    .fastest
                    .map_or(0.0, |fastest| winch.limits[1] / (BRAKE_SLIP * fastest));
                Some((winch.mass, winch.slope.max(brake)))
            }
            Self::Slide(friction) => Some((0.0, friction.constant / CREEP)),
            Self::Rate(_) | Self::Table(_) => None,
        }
    }

    /// How far an iteration may go from a rate towards another \[m/s\]: just beyond the first corner of the force between. From a flat piece on
    /// one side of a steep one Newton's method goes to the flat piece on the other side, and back.
    #[must_use]
    pub fn towards(&self, from: f64, to: f64) -> f64 {
        let corner = match self {
            Self::Winch(winch) => {
                let corners = winch.corners().into_iter().flatten();
                let beyond = corners.map(|corner| {
                    corner + (CORNER * corner.abs().max(LEAST_RATE)).copysign(to - from)
                });
                beyond
                    .filter(|rate| (rate - from) * (to - rate) > 0.0)
                    .min_by(|one, other| (one - from).abs().total_cmp(&(other - from).abs()))
            }
            Self::Slide(_) => (from * to < 0.0 && from.abs() > CORNER * CREEP).then_some(0.0),
            Self::Rate(_) | Self::Table(_) => None,
        };
        corner.unwrap_or(to)
    }

    /// Time over which it is let go \[s\].
    #[must_use]
    pub fn ramp(&self) -> f64 {
        match self {
            Self::Winch(winch) => winch.ramp,
            Self::Slide(friction) => friction.ramp,
            Self::Rate(course) => course.ramp,
            Self::Table(motion) => motion.ramp,
        }
    }

    /// What of the force that held it at rest still acts at time t \[s\], from 1 down to 0.
    #[must_use]
    pub fn held(&self, t: f64) -> f64 {
        let share = (t / self.ramp()).clamp(0.0, 1.0);
        0.5 * (1.0 + (PI * share).cos())
    }

    /// Length, rate and the rate of that at time t \[s\] where they are prescribed by themselves.
    #[must_use]
    pub fn prescribed(&self, t: f64) -> Option<[f64; 3]> {
        match self {
            Self::Rate(course) => Some(course.at(t)),
            Self::Table(motion) => {
                let (x, v, a) = motion.at(t);
                Some([x.x, v.x, a.x])
            }
            Self::Winch(_) | Self::Slide(_) => None,
        }
    }
}
