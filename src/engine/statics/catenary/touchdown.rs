//! Touchdown: a line of one section grounded from A to the touchdown point and suspended from there to B, on a level or
//! sloping bed with friction.
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
//! where s is the suspended length and ζ the height of B above the bed's line, measured vertically. The
//! second is quadratic in H, so β is the only unknown; the third falls with β. `R`, the length that
//! sag takes out, is free of cancellation. On a level bed (a = 0) these are Jonkman's (2007) eqs 2-37, 2-38.
//!
//! On the bed tension falls from `T_0 = H cosh a` towards A by `w (sin θ + μ cos θ)` per metre and, where
//! friction can hold the line (μ >= |tan θ|), stays at zero once it gets there.

use super::error::CatenaryError;
use super::planar_line::PlanarLine;
use super::profile::grounded_tension_sum;
use super::slope::Slope;
use crate::numerics::double_double::DoubleDouble;
use crate::numerics::hyperbolic::hyperbolic;
use crate::numerics::log_newton::{FunctionSample, increasing_root};

/// The line in the local frame: weight downwards, B to the right, A on the bed.
#[derive(Debug, Clone, Copy)]
pub(super) struct TouchdownLine {
    pub line: PlanarLine,
    pub slope: Slope,
    /// Height of B above the bed's line.
    pub height: f64,
}

/// How the line touches the bed.
#[derive(Debug, Clone, Copy)]
pub(super) enum TouchdownState {
    /// Grounded from A to the touchdown point, then suspended.
    Partial(TouchdownUnknowns, u32),
    /// Grounded from end to end, with this tension at B.
    Full(f64),
    /// Suspended vertically from B over this length; the rest is slack on the bed.
    Slack(f64),
    /// Clear of the bed but at A.
    Clear,
}

/// Horizontal force at B, and the growth β of asinh(V/H) from touchdown to B.
#[derive(Debug, Clone, Copy)]
pub(super) struct TouchdownUnknowns {
    pub h: f64,
    pub beta: f64,
}

/// The suspended leg and the line's reach, with derivatives by (H, β).
#[derive(Debug, Clone, Copy)]
pub(super) struct SuspendedLeg {
    /// Suspended length.
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

impl TouchdownLine {
    fn cosh_a(&self) -> f64 {
        1.0 / self.slope.cos
    }

    /// Unstretched length beyond the distance along the bed.
    pub(super) fn excess_length(&self) -> f64 {
        (self.line.length - self.line.x) - self.line.x * self.slope.secant_minus_1()
    }

    /// Loss of tension per metre of bed towards A.
    pub(super) fn loss(&self) -> f64 {
        self.line.w * self.slope.drop()
    }

    /// Tension integrated along the bed, with its derivatives by the tension at touchdown and by the grounded length. Where
    /// friction does not hold the line this tension may be negative; the caller refuses that.
    fn bed_sum(&self, t0: f64, on_bed: f64) -> (f64, f64, f64) {
        let loss = self.loss();
        if self.slope.holds() && loss > 0.0 && t0 < loss * on_bed {
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
        let (ca, sa) = (self.cosh_a(), self.slope.tan);
        let q = sa * f.cosh_minus_1 + ca * f.sinh;
        let p = ca * f.cosh_minus_1 + sa * f.sinh_minus_x;
        let load = 2.0 * self.height * self.line.w;
        load / (p + (p * p + load / self.line.ea * q * q).sqrt())
    }

    pub(super) fn leg(&self, state: TouchdownUnknowns) -> SuspendedLeg {
        let TouchdownUnknowns { h, beta } = state;
        let f = hyperbolic(beta);
        let (ca, sa, w, ea) = (self.cosh_a(), self.slope.tan, self.line.w, self.line.ea);
        let q = sa * f.cosh_minus_1 + ca * f.sinh;
        let p = ca * f.cosh_minus_1 + sa * f.sinh_minus_x;
        let r = sa * f.cosh_minus_1 + ca * f.sinh_minus_x;
        let dr = sa * f.sinh + ca * f.cosh_minus_1;
        let (sinh_b, cosh_b) = (sa + q, ca + dr);
        let s = h * q / w;
        let (sum, by_t0, by_length) = self.bed_sum(h * ca, self.line.length - s);
        let gain = (sum + h * s * ca) / ea - h / w * r;
        let gain_h = (by_t0 * ca + (2.0 * h * ca - by_length) * q / w) / ea - r / w;
        let gain_beta = h / w * (cosh_b * (h * ca - by_length) / ea - dr);
        SuspendedLeg {
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

    /// The contact with the bed; `seed` is a β to start from.
    pub(super) fn solve(&self, seed: Option<f64>) -> Result<TouchdownState, CatenaryError> {
        if self.height <= 0.0 {
            return self.wholly();
        }
        // Suspended vertically: w ζ = v + v²/(2EA)
        let load = 2.0 * self.line.w * self.height;
        let straight = load / (1.0 + (1.0 + load / self.line.ea).sqrt()) / self.line.w;
        if straight <= self.line.length {
            let on_bed = self.line.length - straight;
            let slack =
                self.excess_length() - straight + self.bed_sum(0.0, on_bed).0 / self.line.ea;
            if slack >= 0.0 {
                return if self.slope.holds() {
                    Ok(TouchdownState::Slack(straight))
                } else {
                    Err(self.slope.slides())
                };
            }
        }
        self.partly(seed.unwrap_or_else(|| self.guess(straight)))
    }

    fn partly(&self, guess: f64) -> Result<TouchdownState, CatenaryError> {
        let excess = self.excess_length();
        let mut clear = false;
        let root = increasing_root(guess, STEEPEST, |beta| {
            let h = self.force(beta);
            let leg = self.leg(TouchdownUnknowns { h, beta });
            let value = -excess - leg.gain;
            // More than the whole line is suspended, and a greater β suspends more (not so down a steep slope).
            if value > 0.0 && leg.s > self.line.length && self.slope.sin >= 0.0 {
                clear = true;
                return FunctionSample {
                    value: f64::NAN,
                    log_slope: 1.0,
                    scale: 0.0,
                };
            }
            let [[gain_h, gain_beta], [z_h, z_beta]] = leg.jacobian;
            let slope = -beta * (gain_beta - gain_h * z_beta / z_h);
            FunctionSample {
                value,
                log_slope: slope,
                scale: excess.abs() + leg.gain.abs(),
            }
        });
        let Some(root) = root else {
            return if clear {
                Ok(TouchdownState::Clear)
            } else {
                Err(CatenaryError::NotVerified {
                    error: f64::INFINITY,
                    iterations: 200,
                })
            };
        };
        let state = TouchdownUnknowns {
            h: self.force(root.x),
            beta: root.x,
        };
        let s = self.leg(state).s;
        if s > self.line.length {
            return Ok(TouchdownState::Clear);
        }
        let at_a = state.h * self.cosh_a() - self.loss() * (self.line.length - s);
        if at_a < 0.0 && !self.slope.holds() {
            return Err(self.slope.slides());
        }
        Ok(TouchdownState::Partial(state, root.evaluations))
    }

    /// B on the bed: a bar on a slope, with friction.
    fn wholly(&self) -> Result<TouchdownState, CatenaryError> {
        let stretch = -self.line.ea * self.excess_length();
        let loss = self.loss();
        let whole = stretch / self.line.length + 0.5 * loss * self.line.length;
        if whole >= loss * self.line.length && whole >= 0.0 {
            return Ok(TouchdownState::Full(whole));
        }
        if !self.slope.holds() {
            return Err(self.slope.slides());
        }
        if stretch > 0.0 {
            return Ok(TouchdownState::Full((2.0 * loss * stretch).sqrt()));
        }
        Ok(TouchdownState::Slack(0.0))
    }

    /// A starting β: parabola when flat, exponential when steep, stretch when too short.
    fn guess(&self, straight: f64) -> f64 {
        let excess = self.excess_length() / straight;
        let soft = 2.0 * self.line.w * self.height * self.line.length / self.line.ea;
        let taut = (3.0 * soft / straight).cbrt();
        if excess <= 0.0 {
            let short = -self.excess_length();
            return taut.min((soft / short).sqrt()).clamp(1e-150, 20.0);
        }
        // R/P goes from tanh a + β/3 to 1, where it lacks 2(β - 1) exp(-β).
        let part = ((excess - self.slope.sin) / (1.0 - self.slope.sin)).clamp(0.0, 1.0);
        let slack = if part < 0.6 {
            3.0 * part * (1.0 + 0.4 * part)
        } else {
            let big = (2.0 / (1.0 - part).max(1e-120)).ln() + 1.0;
            big + big.ln() - 1.0
        };
        slack.max(taut.min(3.0)).clamp(1e-150, 290.0)
    }

    /// Distance from the end that the forces of `state` reach to B, to 30 digits on a level bed.
    pub(super) fn residual(&self, state: TouchdownUnknowns, leg: &SuspendedLeg) -> (f64, f64) {
        let va = DoubleDouble::from(state.h) * self.slope.tan;
        let (dx, dz) = self.line.span(leg.s).reach_exactly(state.h, va);
        let t0 = state.h / self.slope.cos;
        let on_bed = self.line.length - leg.s;
        let along = DoubleDouble::from(self.line.length)
            + -leg.s
            + self.bed_sum(t0, on_bed).0 / self.line.ea;
        // cos θ = 1 - (1/cos θ - 1) cos θ
        let x = dx
            + along
            + -(along.value() * self.slope.secant_minus_1() * self.slope.cos)
            + -self.line.x;
        let z = dz + along * self.slope.sin + -self.line.z;
        (x.value(), z.value())
    }

    /// Error of force from the rounding of the slope's sine and cosine: on a slope the position of B has 16 digits.
    pub(super) fn slope_rounding(&self, state: TouchdownUnknowns, leg: &SuspendedLeg) -> f64 {
        if self.slope.sin == 0.0 {
            return 0.0;
        }
        let size = f64::EPSILON * self.line.x * self.slope.secant_minus_1();
        let step = self.step(leg, size * self.slope.cos, size * self.slope.sin);
        let (h, v) = Self::force_step(state, leg, step);
        (h * h + v * v).sqrt()
    }

    /// Changes of H and β that move B by (x, z).
    pub(super) fn step(&self, leg: &SuspendedLeg, x: f64, z: f64) -> (f64, f64) {
        let (along, height) = (x * self.cosh_a(), z - x * self.slope.tan);
        let [[a, b], [c, d]] = leg.jacobian;
        let det = a * d - b * c;
        (
            (along * d - b * height) / det,
            (a * height - c * along) / det,
        )
    }

    /// Change of (H, V) at B for a step of (H, β).
    pub(super) fn force_step(
        state: TouchdownUnknowns,
        leg: &SuspendedLeg,
        step: (f64, f64),
    ) -> (f64, f64) {
        (step.0, leg.sinh_b * step.0 + state.h * leg.cosh_b * step.1)
    }

    /// Vertical force at B.
    pub(super) fn v_b(&self, state: TouchdownUnknowns, leg: &SuspendedLeg) -> f64 {
        self.slope.tan * state.h + self.line.w * leg.s
    }

    /// Tension at A of the grounded part whose end towards B carries `t0`.
    pub(super) fn tension_a(&self, t0: f64, on_bed: f64) -> f64 {
        (t0 - self.loss() * on_bed).max(0.0)
    }

    /// Stretched length of the grounded part.
    pub(super) fn grounded_length(&self, t0: f64, on_bed: f64) -> f64 {
        on_bed + grounded_tension_sum(t0, self.loss(), on_bed) / self.line.ea
    }
}
