//! A line that lies on the bed from A and rises to B; the bed flat or evenly sloping, with friction.
//!
//! The slope is `θ`, `tan θ = sinh a`. The line leaves the bed along it, so with `β` the growth of
//! `asinh(V/H)` from there to B everything hangs on H and β (V = H sinh(a + β) at B):
//!
//! ```text
//! s   = (H/w) q            q = sinh(a+β) - sinh a              = sinh a (cosh β - 1) + cosh a sinh β
//! ζ   = (H/w) P + H² q²/(2wEA)   P = cosh(a+β) - cosh a - β sinh a   = cosh a (cosh β - 1) + sinh a (sinh β - β)
//! x/cos θ = L + e_bed + H s cosh a/EA - (H/w) R   R = sinh(a+β) - sinh a - β cosh a = sinh a (cosh β - 1) + cosh a (sinh β - β)
//! ```
//!
//! where s is the hanging length and ζ the height of B above the bed's line, measured vertically. The
//! second is quadratic in H, so β is the only unknown; the third falls with β. `R` is the length that
//! sag takes out, free of cancellation. On a level bed (a = 0) these are Jonkman's (2007) eqs 2-37, 2-38.
//!
//! On the bed tension falls from `T_0 = H cosh a` towards A by `w (sin θ + μ cos θ)` per metre and, where
//! friction can hold the line (μ >= |tan θ|), stays at zero once it gets there.

use super::error::CatenaryError;
use super::solution::lying_sum;
use super::span::Span;
use crate::numerics::double_double::DoubleDouble;
use crate::numerics::hyperbolic::hyperbolic;
use crate::numerics::log_newton::{Sample, increasing_root};

/// The line in the solver's plane: sunk, B to the right, A on the bed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Incline {
    pub x: f64,
    pub z: f64,
    pub length: f64,
    pub w: f64,
    pub ea: f64,
    /// Of the slope.
    pub sin: f64,
    pub cos: f64,
    pub tan: f64,
    pub friction: f64,
    /// Height of B above the bed's line.
    pub height: f64,
}

/// What the line does.
#[derive(Debug, Clone, Copy)]
pub(super) enum Outcome {
    /// Lies on the bed, then rises.
    Partly(State, u32),
    /// Lies all the way, with this tension at B.
    Wholly(f64),
    /// Hangs straight down from B with this length; the rest lies slack.
    Slack(f64),
    /// Does not touch the bed but at A.
    Lifted,
}

/// The two unknowns.
#[derive(Debug, Clone, Copy)]
pub(super) struct State {
    pub h: f64,
    pub beta: f64,
}

/// Everything at one state, with derivatives by (H, β).
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    /// Hanging length.
    pub s: f64,
    /// Along-bed gain e_bed + H s cosh a/EA - (H/w) R, so that x/cos θ = L + gain.
    gain: f64,
    /// Jacobian \[\[∂gain/∂H, ∂gain/∂β\], \[∂ζ/∂H, ∂ζ/∂β\]\].
    jacobian: [[f64; 2]; 2],
    /// sinh and cosh of a + β.
    sinh_b: f64,
    cosh_b: f64,
}

/// Beyond this β the horizontal force is 1e-130 of the weight.
const STEEPEST: f64 = 300.0;

impl Incline {
    fn cosh_a(&self) -> f64 {
        1.0 / self.cos
    }

    /// 1/cos θ - 1
    pub(super) fn longer(&self) -> f64 {
        self.tan * self.tan / (1.0 + self.cosh_a())
    }

    /// Unstretched length beyond the distance along the bed.
    pub(super) fn spare(&self) -> f64 {
        (self.length - self.x) - self.x * self.longer()
    }

    /// Loss of tension per metre of bed towards A.
    pub(super) fn loss(&self) -> f64 {
        self.w * (self.sin + self.friction * self.cos)
    }

    /// Whether friction holds slack line on the slope.
    fn holds(&self) -> bool {
        self.friction >= self.tan.abs()
    }

    fn slides(&self) -> CatenaryError {
        CatenaryError::SlackOnSlope {
            needed: self.tan.abs(),
        }
    }

    /// Tension summed along the bed, and its derivatives by the tension at the lift-off and by the
    /// length on the bed. Without enough friction tension may run negative here; refused afterwards.
    fn bed_sum(&self, t0: f64, on_bed: f64) -> (f64, f64, f64) {
        let loss = self.loss();
        if self.holds() && loss > 0.0 && t0 < loss * on_bed {
            return (0.5 * t0 * t0 / loss, t0 / loss, 0.0);
        }
        (
            on_bed * (t0 - 0.5 * loss * on_bed),
            on_bed,
            t0 - loss * on_bed,
        )
    }

    /// The horizontal force that lifts B to its height at this β.
    fn force(&self, beta: f64) -> f64 {
        let f = hyperbolic(beta);
        let (ca, sa) = (self.cosh_a(), self.tan);
        let q = sa * f.cosh_minus_1 + ca * f.sinh;
        let p = ca * f.cosh_minus_1 + sa * f.sinh_minus_x;
        let load = 2.0 * self.height * self.w;
        load / (p + (p * p + load / self.ea * q * q).sqrt())
    }

    pub(super) fn leg(&self, state: State) -> Leg {
        let State { h, beta } = state;
        let f = hyperbolic(beta);
        let (ca, sa, w, ea) = (self.cosh_a(), self.tan, self.w, self.ea);
        let q = sa * f.cosh_minus_1 + ca * f.sinh;
        let p = ca * f.cosh_minus_1 + sa * f.sinh_minus_x;
        let r = sa * f.cosh_minus_1 + ca * f.sinh_minus_x;
        let dr = sa * f.sinh + ca * f.cosh_minus_1;
        let (sinh_b, cosh_b) = (sa + q, ca + dr);
        let s = h * q / w;
        let (sum, by_t0, by_length) = self.bed_sum(h * ca, self.length - s);
        let gain = (sum + h * s * ca) / ea - h / w * r;
        let gain_h = (by_t0 * ca + (2.0 * h * ca - by_length) * q / w) / ea - r / w;
        let gain_beta = h / w * (cosh_b * (h * ca - by_length) / ea - dr);
        Leg {
            s,
            gain,
            jacobian: [
                [gain_h, gain_beta],
                [
                    (p + h * q * q / ea) / w,
                    h / w * q * (1.0 + h * cosh_b / ea),
                ],
            ],
            sinh_b,
            cosh_b,
        }
    }

    /// What the line does; `seed` is a β to start from.
    pub(super) fn solve(&self, seed: Option<f64>) -> Result<Outcome, CatenaryError> {
        if self.height <= 0.0 {
            return self.wholly();
        }
        // Hanging straight: w ζ = v + v²/(2EA)
        let load = 2.0 * self.w * self.height;
        let straight = load / (1.0 + (1.0 + load / self.ea).sqrt()) / self.w;
        if straight <= self.length {
            let on_bed = self.length - straight;
            let slack = self.spare() - straight + self.bed_sum(0.0, on_bed).0 / self.ea;
            if slack >= 0.0 {
                return if self.holds() {
                    Ok(Outcome::Slack(straight))
                } else {
                    Err(self.slides())
                };
            }
        }
        self.partly(seed.unwrap_or_else(|| self.guess(straight)))
    }

    fn partly(&self, guess: f64) -> Result<Outcome, CatenaryError> {
        let spare = self.spare();
        let mut lifted = false;
        let root = increasing_root(guess, STEEPEST, |beta| {
            let h = self.force(beta);
            let leg = self.leg(State { h, beta });
            let value = -spare - leg.gain;
            // Too much line off the bed already, and tauter takes more. (Not so down a steep slope.)
            if value > 0.0 && leg.s > self.length && self.sin >= 0.0 {
                lifted = true;
                return Sample {
                    value: f64::NAN,
                    log_slope: 1.0,
                    scale: 0.0,
                };
            }
            let [[gain_h, gain_beta], [z_h, z_beta]] = leg.jacobian;
            let slope = -beta * (gain_beta - gain_h * z_beta / z_h);
            Sample {
                value,
                log_slope: slope,
                scale: spare.abs() + leg.gain.abs(),
            }
        });
        let Some(root) = root else {
            return if lifted {
                Ok(Outcome::Lifted)
            } else {
                Err(CatenaryError::NotVerified {
                    error: f64::INFINITY,
                    iterations: 200,
                })
            };
        };
        let state = State {
            h: self.force(root.x),
            beta: root.x,
        };
        let s = self.leg(state).s;
        if s > self.length {
            return Ok(Outcome::Lifted);
        }
        let at_a = state.h * self.cosh_a() - self.loss() * (self.length - s);
        if at_a < 0.0 && !self.holds() {
            return Err(self.slides());
        }
        Ok(Outcome::Partly(state, root.evaluations))
    }

    /// B on the bed: a bar on a slope.
    fn wholly(&self) -> Result<Outcome, CatenaryError> {
        let stretch = -self.ea * self.spare();
        let loss = self.loss();
        let whole = stretch / self.length + 0.5 * loss * self.length;
        if whole >= loss * self.length && whole >= 0.0 {
            return Ok(Outcome::Wholly(whole));
        }
        if !self.holds() {
            return Err(self.slides());
        }
        if stretch > 0.0 {
            return Ok(Outcome::Wholly((2.0 * loss * stretch).sqrt()));
        }
        Ok(Outcome::Slack(0.0))
    }

    /// Start: parabola when flat, exponential when steep, stretch when too short.
    fn guess(&self, straight: f64) -> f64 {
        let spare = self.spare() / straight;
        let soft = 2.0 * self.w * self.height * self.length / self.ea;
        let taut = (3.0 * soft / straight).cbrt();
        if spare <= 0.0 {
            let short = -self.spare();
            return taut.min((soft / short).sqrt()).clamp(1e-150, 20.0);
        }
        // R/P goes from tanh a + β/3 to 1, where it lacks 2(β - 1) exp(-β).
        let part = ((spare - self.sin) / (1.0 - self.sin)).clamp(0.0, 1.0);
        let slack = if part < 0.6 {
            3.0 * part * (1.0 + 0.4 * part)
        } else {
            let big = (2.0 / (1.0 - part).max(1e-120)).ln() + 1.0;
            big + big.ln() - 1.0
        };
        slack.max(taut.min(3.0)).clamp(1e-150, 290.0)
    }

    /// How far the forces of `state` miss the end, to 30 digits on a level bed.
    pub(super) fn miss(&self, state: State, leg: &Leg) -> (f64, f64) {
        let va = DoubleDouble::from(state.h) * self.tan;
        let span = Span {
            length: leg.s,
            weight: self.w,
            ea: self.ea,
        };
        let (dx, dz) = span.reach_exactly(state.h, va);
        let t0 = state.h / self.cos;
        let on_bed = self.length - leg.s;
        let along = DoubleDouble::from(self.length) + -leg.s + self.bed_sum(t0, on_bed).0 / self.ea;
        // cos θ = 1 - (1/cos θ - 1) cos θ
        let x = dx + along + -(along.value() * self.longer() * self.cos) + -self.x;
        let z = dz + along * self.sin + -self.z;
        (x.value(), z.value())
    }

    /// Force that the rounding of the slope's sine and cosine stands for: on a slope end B is where it is
    /// asked for only to 16 digits of the distance.
    pub(super) fn blur(&self, state: State, leg: &Leg) -> f64 {
        if self.sin == 0.0 {
            return 0.0;
        }
        let size = f64::EPSILON * self.x * self.longer();
        let step = self.step(leg, size * self.cos, size * self.sin);
        let (h, v) = Self::force_step(state, leg, step);
        (h * h + v * v).sqrt()
    }

    /// Changes of H and β that move B by (x, z).
    pub(super) fn step(&self, leg: &Leg, x: f64, z: f64) -> (f64, f64) {
        let (along, height) = (x * self.cosh_a(), z - x * self.tan);
        let [[a, b], [c, d]] = leg.jacobian;
        let det = a * d - b * c;
        (
            (along * d - b * height) / det,
            (a * height - c * along) / det,
        )
    }

    /// Change of (H, V) at B for a step of (H, β).
    pub(super) fn force_step(state: State, leg: &Leg, step: (f64, f64)) -> (f64, f64) {
        (step.0, leg.sinh_b * step.0 + state.h * leg.cosh_b * step.1)
    }

    /// Vertical force at B.
    pub(super) fn v_b(&self, state: State, leg: &Leg) -> f64 {
        self.tan * state.h + self.w * leg.s
    }

    /// Tension at A of the lying part whose upper end carries `t0`.
    pub(super) fn tension_a(&self, t0: f64, on_bed: f64) -> f64 {
        (t0 - self.loss() * on_bed).max(0.0)
    }

    /// Stretched length of the lying part.
    pub(super) fn lying_length(&self, t0: f64, on_bed: f64) -> f64 {
        on_bed + lying_sum(t0, self.loss(), on_bed) / self.ea
    }
}
