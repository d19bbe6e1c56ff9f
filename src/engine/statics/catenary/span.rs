//! The elastic catenary: a span of uniform line suspended in still water, from the force at its end towards A to the position of
//! its other end. The other modules invert these two formulas.
//!
//! For a span of unstretched length `L`, weight `w` per unstretched length, stiffness `EA`,
//! horizontal force `H`, vertical force `V(s) = V_a + w s`, tension `T = sqrt(H² + V²)`. A piece `ds`
//! stretches to `(1 + T/EA) ds` and points along the force, so (Irvine, *Cable Structures*, 1981, ch. 1)
//!
//! ```text
//! dx = ∫ H/T + H/EA ds = H L/EA + (H/w) (asinh V_b/H - asinh V_a/H)
//! dz = ∫ V/T + V/EA ds = (T_b - T_a)/w + (V_b² - V_a²)/(2 w EA)
//! ```
//!
//! Both lose digits when `w` is small beside `T`. With the mean tension `T_m = (T_a + T_b)/2`, the mean
//! vertical force `V_m` and `u = w L/(T_a + T_b)`, addition theorems give the same without differences:
//!
//! ```text
//! asinh V_b/H - asinh V_a/H = 2 atanh u          (since wL = 2H cosh μ sinh ξ, T_a + T_b = 2H cosh μ cosh ξ)
//! dx = (H L/T_m) (1 + T_m/EA + (atanh u)/u - 1)
//! dz = (V_m L/T_m) (1 + T_m/EA)                   (since T_b² - T_a² = V_b² - V_a² = 2 V_m w L)
//! ```

use crate::numerics::double_double::DoubleDouble;
use crate::numerics::hyperbolic::atanh_ratio_minus_1;

/// A uniform span of line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    /// Unstretched length.
    pub length: f64,
    /// Weight per unstretched length, of any sign.
    pub weight: f64,
    /// Axial stiffness.
    pub ea: f64,
}

/// The forces in a span with quantities derived from them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Forces {
    va: f64,
    vb: f64,
    ta: f64,
    tb: f64,
    /// wL / (T_a + T_b)
    u: f64,
    /// 1 - u
    one_less_u: f64,
    /// 2 atanh u
    delta: f64,
}

/// Displacement of one end per force on it; symmetric \[m/N\].
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Compliance {
    /// ∂x/∂H
    pub hh: f64,
    /// ∂x/∂V = ∂z/∂H
    pub hv: f64,
    /// ∂z/∂V
    pub vv: f64,
}

impl Span {
    /// The forces along a sinking (w >= 0) span whose end towards A carries (`h`, `va`).
    fn forces(&self, h: f64, va: f64) -> Forces {
        let load = self.weight * self.length;
        // Where a span ends level its force there is zero, not the rounding of the difference: without
        // horizontal force the sign of that rounding would decide which way the line points.
        let sum = va + load;
        let vb = if sum.abs() > 4.0 * f64::EPSILON * load {
            sum
        } else {
            0.0
        };
        let (ta, tb) = (length(h, va), length(h, vb));
        // T_a + V_a and T_b - V_b add up to T_a + T_b - wL; neither may be a difference.
        let low = if va >= 0.0 {
            ta + va
        } else {
            h * (h / (ta - va))
        };
        let high = if vb <= 0.0 {
            tb - vb
        } else {
            h * (h / (tb + vb))
        };
        let sum = ta + tb;
        let (u, one_less_u) = (load / sum, (low + high) / sum);
        let delta = (2.0 * u / one_less_u).ln_1p();
        Forces {
            va,
            vb,
            ta,
            tb,
            u,
            one_less_u,
            delta,
        }
    }

    /// Where the far end is, seen from the near end that carries (`h`, `va`).
    pub(super) fn reach(&self, h: f64, va: f64) -> (f64, f64) {
        if self.weight < 0.0 {
            let (x, z) = self.mirrored().reach(h, -va);
            return (x, -z);
        }
        let f = self.forces(h, va);
        let tm = 0.5 * (f.ta + f.tb);
        if tm <= 0.0 {
            return (0.0, 0.0);
        }
        let excess = atanh_ratio_minus_1(f.u, f.delta);
        let x = if h > 0.0 && excess.is_finite() {
            h * self.length * (1.0 / self.ea + (1.0 + excess) / tm)
        } else {
            0.0
        };
        let vm = 0.5 * (f.va + f.vb);
        (x, vm * self.length * (1.0 / self.ea + 1.0 / tm))
    }

    /// [`Span::reach`] to about 30 digits where the formulas are ill-conditioned (taut lines), and to
    /// 16 digits of the sag elsewhere. `va` may itself carry more digits than an `f64`.
    pub(super) fn reach_exactly(&self, h: f64, va: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
        if self.weight < 0.0 {
            let (x, z) = self.mirrored().reach_exactly(h, -va);
            return (x, -z);
        }
        let f = self.forces(h, va.value());
        let load = DoubleDouble::from(self.weight) * self.length;
        let vb = va + load;
        let h2 = DoubleDouble::from(h) * h;
        let tm = ((h2 + va * va).sqrt() + (h2 + vb * vb).sqrt()) * 0.5;
        let vm = va + load * 0.5;
        if tm.value() <= 0.0 {
            return (0.0.into(), 0.0.into());
        }
        let per_tension = DoubleDouble::from(self.length) / tm;
        let strain = tm / DoubleDouble::from(self.ea);
        let excess = atanh_ratio_minus_1(f.u, f.delta);
        let x = if h > 0.0 && excess.is_finite() {
            per_tension * h * (strain + 1.0 + excess)
        } else {
            0.0.into()
        };
        (x, per_tension * vm * (strain + 1.0))
    }

    /// Displacement of the far end per force on it, the near end held.
    ///
    /// The integrals of `V²/T³`, `HV/T³` and `H²/T³` over the span, plus `L/EA`; each written so that
    /// no difference of nearly equal numbers is left when the line is taut.
    pub(super) fn compliance(&self, h: f64, va: f64) -> Compliance {
        if self.weight < 0.0 {
            let c = self.mirrored().compliance(h, -va);
            return Compliance { hv: -c.hv, ..c };
        }
        let f = self.forces(h, va);
        let stretch = self.length / self.ea;
        let tm = 0.5 * (f.ta + f.tb);
        let vm = 0.5 * (f.va + f.vb);
        if self.weight * self.length <= 1e-9 * tm {
            // Straight as far as stiffness is concerned: the neglected part is u² of these terms.
            let (c, s, l) = (h / tm, vm / tm, self.length / tm);
            let sag = c * c * f.u * f.u / 3.0;
            return Compliance {
                hh: stretch + l * (s * s + sag),
                hv: -l * c * s,
                vv: stretch + l * c * c,
            };
        }
        let product = f.ta * f.tb;
        let one_less_u2 = f.one_less_u * (1.0 + f.u);
        // ∫ H²/T³ ds = (V_b/T_b - V_a/T_a)/w = H² sinh δ/(w T_a T_b), sinh δ = 2u/(1 - u²)
        let cos = if f.u > 0.5 {
            (sine(f.vb, f.tb) - sine(f.va, f.ta)) / self.weight
        } else {
            h * h * 2.0 * f.u / (one_less_u2 * self.weight * product)
        };
        // ∫ V²/T³ ds = δ/w - ∫ H²/T³ ds
        let sin = if f.delta > 1.0 {
            f.delta / self.weight - cos
        } else {
            (f.delta * vm * vm * one_less_u2 + 0.5 * h * h * cosh_excess(f.delta))
                / (self.weight * product)
        };
        Compliance {
            hh: stretch + sin,
            hv: if h > 0.0 {
                -h * self.length * vm / (tm * product)
            } else {
                0.0
            },
            vv: stretch + cos,
        }
    }

    fn mirrored(&self) -> Self {
        Self {
            weight: -self.weight,
            ..*self
        }
    }
}

impl Compliance {
    /// The inverse: force per displacement \[\[H/x, H/z\], \[V/x, V/z\]\].
    pub(super) fn stiffness(&self) -> [[f64; 2]; 2] {
        if !self.hh.is_finite() || self.hh > 1e200 {
            // Hanging doubled over: no resistance at all sideways.
            return [[0.0, 0.0], [0.0, 1.0 / self.vv]];
        }
        let det = self.hh * self.vv - self.hv * self.hv;
        let off = -self.hv / det;
        [[self.vv / det, off], [off, self.hh / det]]
    }
}

/// The two-dimensional length of a force, without the cost of guarding against overflow.
pub(super) fn length(h: f64, v: f64) -> f64 {
    (h * h + v * v).sqrt()
}

/// V/T; level where there is no tension at all.
fn sine(v: f64, t: f64) -> f64 {
    if t > 0.0 { v / t } else { 0.0 }
}

/// `δ cosh δ + δ - 2 sinh δ` for 0 <= δ <= 1, by its series δ³/6 + δ⁵/40 + δ⁷/1008 + ...
fn cosh_excess(delta: f64) -> f64 {
    let q = delta * delta;
    let tail = 1.0 / 362_880.0 * 7.0 + q * (9.0 / 39_916_800.0 + q * 11.0 / 6_227_020_800.0);
    delta * q * (1.0 / 6.0 + q * (1.0 / 40.0 + q * (5.0 / 5040.0 + q * tail)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPAN: Span = Span {
        length: 100.0,
        weight: 7.0,
        ea: 1e6,
    };

    fn numeric(span: &Span, h: f64, va: f64) -> Compliance {
        let e = 1e-6 * (h + va.abs());
        let (x1, z1) = span.reach(h + e, va);
        let (x0, z0) = span.reach(h - e, va);
        let (x3, z3) = span.reach(h, va + e);
        let (x2, z2) = span.reach(h, va - e);
        assert!(((z1 - z0) - (x3 - x2)).abs() < 1e-7 * ((x1 - x0).abs() + (z3 - z2).abs()));
        Compliance {
            hh: (x1 - x0) / (2.0 * e),
            hv: (x3 - x2) / (2.0 * e),
            vv: (z3 - z2) / (2.0 * e),
        }
    }

    #[test]
    fn compliance_is_the_derivative_of_reach() {
        for weight in [7.0, -7.0, 0.7, 1e-3, 0.0] {
            for (h, va) in [(300.0, -350.0), (3e3, 500.0), (50.0, 900.0), (1e3, -2e3)] {
                let span = Span { weight, ..SPAN };
                let (c, n) = (span.compliance(h, va), numeric(&span, h, va));
                let scale = n.hh.abs() + n.vv.abs();
                for (a, b) in [(c.hh, n.hh), (c.hv, n.hv), (c.vv, n.vv)] {
                    assert!(
                        (a - b).abs() < 2e-7 * scale,
                        "{weight} {h} {va}: {c:?} {n:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_weightless_span_is_straight() {
        let span = Span {
            weight: 0.0,
            ..SPAN
        };
        let (x, z) = span.reach(3.0, 4.0);
        let stretched = 100.0 * (1.0 + 5.0 / 1e6);
        assert!((x - 0.6 * stretched).abs() < 1e-12 && (z - 0.8 * stretched).abs() < 1e-12);
    }

    #[test]
    fn the_exact_reach_agrees_with_the_plain_one() {
        for (h, va) in [(300.0, -350.0), (3e7, 500.0), (1e-30, -350.0), (0.0, 30.0)] {
            let (x, z) = SPAN.reach(h, va);
            let (xe, ze) = SPAN.reach_exactly(h, va.into());
            assert!((x - xe.value()).abs() < 1e-11 && (z - ze.value()).abs() < 1e-11);
        }
    }
}
