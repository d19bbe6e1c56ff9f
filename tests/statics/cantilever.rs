//! A cantilever that bends over in a flow, by its one-dimensional equation.
//!
//! A slender rod clamped upright in a uniform flow, drag normal to it only, with buoyancy along it and a float at one place
//! (Luhar and Nepf 2011; the double-stepped cable's paper, its eqs 6 to 12, has the same). With the angle theta from the
//! upright and s from clamp to tip, both by the length L:
//! `theta'' = [B (1 - s) + B_f (s < s_f)] sin theta - C_Y Int_s^1 cos² theta' cos(theta' - theta) ds'`,
//! `theta(0) = 0`, `theta'(1) = 0`, `C_Y = rho U² C_D D L³ / (2 EI)`, `B = L³ b / EI` of the net lift b a length, and
//! `B_f = L² F / EI` of a float of lift F. The drag by that of the upright rod is `R = Int_0^1 cos³ theta ds`; where
//! `F ~ U^(2 + nu)`, nu is the Vogel exponent: 0 of a rigid rod, -2/3 where bending alone resists.

/// What the shape depends on, all without unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cantilever {
    /// Drag against bending, C_Y (the Cauchy number).
    pub(crate) drag: f64,
    /// Net lift along the rod against bending, B.
    pub(crate) lift: f64,
    /// Lift of the float against bending, B_f.
    pub(crate) float_lift: f64,
    /// Where the float sits, from the clamp by the length.
    pub(crate) float_at: f64,
}

/// Steps from the tip to the clamp.
const STEPS: usize = 2000;

/// Angle, its slope, and the drag beyond the place along and across the flow.
type CantileverState = [f64; 4];

impl Cantilever {
    /// The reconfiguration number R: drag by that of the same rod, rigid. Nothing where no shape was found: a lift of
    /// thousands makes the angle grow beyond all numbers on the way to the clamp.
    pub(crate) fn reconfiguration(&self) -> Option<f64> {
        // The tip's angle is the unknown: from upright to all but along the flow.
        let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
        if self.at_clamp(high)?.0 < 0.0 {
            return None;
        }
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if self.at_clamp(middle)?.0 < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let (_, drag) = self.at_clamp(0.5 * (low + high))?;
        Some(drag)
    }

    /// The Vogel exponent nu: twice the slope of log R over log C_Y.
    pub(crate) fn vogel_exponent(&self) -> Option<f64> {
        let at = |factor: f64| {
            let drag = self.drag * factor;
            Self { drag, ..*self }.reconfiguration()
        };
        let step: f64 = 1.02;
        Some((at(step)? / at(1.0 / step)?).ln() / step.ln())
    }

    /// The angle at the clamp, and R, when the tip leans by `tip` \[rad\].
    fn at_clamp(&self, tip: f64) -> Option<(f64, f64)> {
        let h = 1.0 / STEPS as f64;
        let mut y: CantileverState = [tip, 0.0, 0.0, 0.0];
        for k in 0..STEPS {
            y = self.back(1.0 - k as f64 * h, h, &y);
        }
        y.iter().all(|v| v.is_finite()).then_some((y[0], y[2]))
    }

    /// One step of Runge-Kutta of order 4 towards the clamp.
    fn back(&self, s: f64, h: f64, y: &CantileverState) -> CantileverState {
        let moved = |k: &CantileverState, by: f64| std::array::from_fn(|i| y[i] - k[i] * by);
        let k1 = self.slope(s, y);
        let k2 = self.slope(s - 0.5 * h, &moved(&k1, 0.5 * h));
        let k3 = self.slope(s - 0.5 * h, &moved(&k2, 0.5 * h));
        let k4 = self.slope(s - h, &moved(&k3, h));
        std::array::from_fn(|i| y[i] - h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    }

    /// Derivatives along s. Drag beyond a place falls towards the tip.
    fn slope(&self, s: f64, [theta, turn, along, across]: &CantileverState) -> CantileverState {
        let (sin, cos) = theta.sin_cos();
        let float = if s < self.float_at {
            self.float_lift
        } else {
            0.0
        };
        let lift = self.lift * (1.0 - s) + float;
        let bend = lift * sin - self.drag * (cos * along + sin * across);
        [*turn, bend, -cos.powi(3), -cos * cos * sin]
    }
}

mod tests {
    use super::*;

    fn bare(drag: f64) -> Cantilever {
        Cantilever {
            drag,
            lift: 0.0,
            float_lift: 0.0,
            float_at: 0.0,
        }
    }

    #[test]
    fn exponents_run_from_rigid_to_bending() {
        // A stiff rod leans by its moment: R = 1 - O(C_Y²).
        let stiff = bare(0.01);
        assert!((stiff.reconfiguration().unwrap() - 1.0).abs() < 1e-5);
        assert!(stiff.vogel_exponent().unwrap().abs() < 1e-4);
        let soft = bare(1e4).vogel_exponent().unwrap();
        assert!((soft + 2.0 / 3.0).abs() < 0.02, "{soft}");
    }

    #[test]
    fn lift_and_floats_hold_the_rod_upright() {
        let r = |lift, float_lift| {
            let with = Cantilever {
                lift,
                float_lift,
                float_at: 1.0,
                ..bare(50.0)
            };
            with.reconfiguration().unwrap()
        };
        assert!(r(0.0, 0.0) < r(20.0, 0.0));
        assert!(r(20.0, 0.0) < r(20.0, 20.0));
    }
}
