//! A grounded span: a line of one section suspended from A, grounded in the middle on a level, frictionless bed, and
//! suspended to B.
//!
//! Along the bed and in both suspended legs the horizontal force H is the same. A leg that leaves the
//! bed level and rises by `d` carries at its top the vertical force `v = w s`; with `y = T - H`,
//!
//! ```text
//! w d = y + y (y + 2H)/(2 EA)   →   y = 2 w d / (p + sqrt(p² + 2 w d/EA)),  p = 1 + H/EA
//! v = sqrt(y (y + 2H))
//! ```
//!
//! and the lengths add up when (Jonkman, NREL/TP-500-41958, 2007, eqs 2-37 and 2-38, for one leg)
//!
//! ```text
//! (L - x) + H L/EA = Σ over legs (H/w) (σ - asinh σ),   σ = v/H
//! ```
//!
//! The left side less the right rises with H. The right side is the length that sag takes out.

use super::planar_line::PlanarLine;
use super::span::length;
use crate::numerics::double_double::DoubleDouble;
use crate::numerics::hyperbolic::{asinh_minus_sine, x_minus_asinh};
use crate::numerics::log_newton::{FunctionSample, increasing_root};

/// The line in the local frame: weight downwards, B to the right, both ends above the bed.
#[derive(Debug, Clone, Copy)]
pub(super) struct GroundedSpan {
    pub line: PlanarLine,
    /// Heights of A and B above the bed.
    pub rise: [f64; 2],
}

/// A leg rising from the bed.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Leg {
    /// Vertical force at its top.
    pub v: f64,
    /// T - H at its top.
    y: f64,
}

/// Forces of the line on the bed.
#[derive(Debug, Clone, Copy)]
pub(super) struct GroundedForces {
    /// Horizontal force; zero when slack.
    pub h: f64,
    /// Legs at A and at B.
    pub legs: [Leg; 2],
    pub iterations: u32,
}

impl GroundedSpan {
    /// The leg rising by `d` at horizontal force `h`.
    pub(super) fn leg(&self, h: f64, d: f64) -> Leg {
        let p = 1.0 + h / self.line.ea;
        let load = 2.0 * self.line.w * d;
        let y = load / (p + (p * p + load / self.line.ea).sqrt());
        Leg {
            v: (y * (y + 2.0 * h)).sqrt(),
            y,
        }
    }

    fn legs(&self, h: f64) -> [Leg; 2] {
        self.rise.map(|d| self.leg(h, d))
    }

    /// Suspended length.
    fn suspended_length(&self, legs: &[Leg; 2]) -> f64 {
        (legs[0].v + legs[1].v) / self.line.w
    }

    /// The forces, or `None` when the line does not come down to the bed.
    pub(super) fn solve(&self, seed: Option<f64>) -> Option<GroundedForces> {
        let straight = self.legs(0.0);
        let hanging = self.suspended_length(&straight);
        if hanging > self.line.length {
            return None;
        }
        let surplus = self.line.length - self.line.x - hanging;
        if surplus >= 0.0 {
            return Some(GroundedForces {
                h: 0.0,
                legs: straight,
                iterations: 0,
            });
        }
        let guess = seed.unwrap_or_else(|| self.guess(&straight, surplus));
        let mut clear = false;
        let root = increasing_root(guess, f64::INFINITY, |h| {
            let legs = self.legs(h);
            let mut found = self.value(h, &legs);
            // More than the whole line is suspended, and the force is still too small.
            if found.value < 0.0 && self.suspended_length(&legs) > self.line.length {
                clear = true;
                found.value = f64::NAN;
            }
            found
        });
        let root = root.filter(|_| !clear)?;
        let legs = self.legs(root.x);
        (self.suspended_length(&legs) <= self.line.length).then_some(GroundedForces {
            h: root.x,
            legs,
            iterations: root.evaluations,
        })
    }

    /// Length beyond the distance less length taken out by sag.
    fn value(&self, h: f64, legs: &[Leg; 2]) -> FunctionSample {
        let spare = self.line.length - self.line.x;
        let mut value = spare + h * self.line.length / self.line.ea;
        let mut scale = spare.abs() + h * self.line.length / self.line.ea;
        let mut slope = self.line.length / self.line.ea;
        for leg in legs.iter().filter(|leg| leg.v > 0.0) {
            let (t, sigma) = (h + leg.y, leg.v / h);
            let dv = leg.y / leg.v / (1.0 + t / self.line.ea);
            let lost = h / self.line.w * x_minus_asinh(sigma);
            value -= lost;
            scale += lost;
            slope -= (dv * leg.y / t - asinh_minus_sine(sigma)) / self.line.w;
        }
        FunctionSample {
            value,
            log_slope: h * slope,
            scale,
        }
    }

    /// Parabolic legs when flat, `H ln(2σ)` when steep, stretch when too short: the nearest of them.
    fn guess(&self, straight: &[Leg; 2], surplus: f64) -> f64 {
        let spare = self.line.length - self.line.x;
        let sag = 0.4714 * self.line.w.sqrt() * self.rise.iter().map(|d| d * d.sqrt()).sum::<f64>();
        let soft = (sag * self.line.ea / self.line.length).powf(2.0 / 3.0);
        if spare <= 0.0 {
            return soft.max(-spare * self.line.ea / self.line.length);
        }
        let flat = soft.min((sag / spare).powi(2));
        let v = straight[0].v.max(straight[1].v);
        if flat < 0.3 * v {
            // Σ (H/w) asinh(v/H) = length short of being slack
            let legs = self.rise.iter().filter(|d| **d > 0.0).count().max(1);
            let each = -surplus * self.line.w / f64::from(u32::try_from(legs).unwrap_or(1));
            let first = each / (2.0 + 2.0 * v / each).ln();
            return each / (2.0 + 2.0 * v / first).ln();
        }
        flat
    }
}

/// The response of a leg to small changes of H and of its own length, and the residual of its height.
struct LegResponse {
    /// Change of reach x - s with length and with H.
    x_s: f64,
    x_h: f64,
    /// Change of rise with length and with H.
    z_s: f64,
    z_h: f64,
    /// Height of the end minus height reached.
    miss: f64,
}

impl GroundedSpan {
    fn response(&self, h: f64, leg: &Leg, rise: f64) -> (LegResponse, DoubleDouble) {
        let s = leg.v / self.line.w;
        let t = length(h, leg.v);
        let (dx, dz) = self.line.span(s).reach_exactly(h, 0.0.into());
        // H/T - 1 without the difference
        let fall = -leg.v * leg.v / (t * (t + h));
        let response = LegResponse {
            x_s: fall,
            x_h: asinh_minus_sine(leg.v / h) / self.line.w,
            z_s: leg.v / self.line.ea + leg.v / t,
            z_h: fall / self.line.w,
            miss: (-dz + rise).value(),
        };
        (response, dx)
    }

    /// Error of force over end tension from the residuals of position, and the stiffness of end B.
    pub(super) fn verify(&self, lying: &GroundedForces) -> (f64, [[f64; 2]; 2]) {
        let h = lying.h;
        let on_bed = DoubleDouble::from(self.line.length)
            + -(lying.legs[0].v / self.line.w)
            + -(lying.legs[1].v / self.line.w);
        let bed = on_bed * (DoubleDouble::from(h) / DoubleDouble::from(self.line.ea) + 1.0);
        let (mut reached, mut responses) = (bed, [None, None]);
        let mut by_h = self.line.length / self.line.ea;
        let bed_stretch = (lying.legs[0].v + lying.legs[1].v) / self.line.w / self.line.ea;
        by_h -= bed_stretch;
        for (i, leg) in lying.legs.iter().enumerate().filter(|(_, leg)| leg.v > 0.0) {
            let (response, dx) = self.response(h, leg, self.rise[i]);
            reached = reached + dx;
            by_h += response.x_h + leg.v / self.line.w / self.line.ea
                - response.x_s * response.z_h / response.z_s;
            responses[i] = Some(response);
        }
        let miss = (-reached + self.line.x).value();
        // Legs keep their heights by changing length: ds = (dz - z_h dH)/z_s.
        let force = |x: f64, rise: [f64; 2]| {
            let give = |i: usize| {
                let response: &Option<LegResponse> = &responses[i];
                response.as_ref().map_or(0.0, |a| a.x_s * rise[i] / a.z_s)
            };
            let dh = (x - give(0) - give(1)) / by_h;
            let dv = |i: usize| {
                let response: &Option<LegResponse> = &responses[i];
                response
                    .as_ref()
                    .map_or(0.0, |a| self.line.w * (rise[i] - a.z_h * dh) / a.z_s)
            };
            (dh, dv(0), dv(1))
        };
        let missed = |i: usize| {
            let response: &Option<LegResponse> = &responses[i];
            response.as_ref().map_or(0.0, |a| a.miss)
        };
        let (dh, dva, dvb) = force(miss, [missed(0), missed(1)]);
        let top = length(h, lying.legs[0].v.max(lying.legs[1].v));
        let error = length(dh, length(dva, dvb)) / top;
        let (by_x, by_z) = (force(1.0, [0.0, 0.0]), force(0.0, [0.0, 1.0]));
        (error, [[by_x.0, by_z.0], [by_x.2, by_z.2]])
    }
}
