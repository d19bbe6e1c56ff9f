//! The suspended line: an elastic catenary that touches nothing between its ends.
//!
//! Two equations in the unknown forces (see `span`) become one. With `ξ = atanh(w L/(T_a + T_b))`, that
//! is `T_m = (wL/2) coth ξ`, the formulas for dx and dz give the mean forces straight away,
//!
//! ```text
//! e = T_m/EA,  c = ξ coth ξ,  H = (x/L) T_m/(c + e),  V_m = (z/L) T_m/(1 + e)
//! ```
//!
//! and what is left, `T_m² = H² cosh²ξ + V_m²`, reads
//!
//! ```text
//! (x/L)² (g² - 1) + (z/L)² (k² - 1) = 1 - (x² + z²)/L²,   g = cosh ξ/(c + e),   k = 1/(1 + e)
//! ```
//!
//! g and k both increase with ξ (e falls, and tanh ξ exceeds the relative growth of c), so there is one root.
//! `g² - 1` is sag and `k² - 1` is stretch; written as differences from 1 they keep their digits
//! however taut or stiff the line, and the right side is formed with 32 digits. For EA → ∞ this is the
//! textbook `sqrt(L² - z²) = (2H/w) sinh(wx/2H)`.

use crate::numerics::double_double::DoubleDouble;
use crate::numerics::hyperbolic::hyperbolic;
use crate::numerics::log_newton::{FunctionSample, Root, increasing_root};

/// The forces of a suspended line: horizontal, and the mean of the vertical ones.
#[derive(Debug, Clone, Copy)]
pub(super) struct SuspendedForces {
    pub h: f64,
    pub v_mean: f64,
    /// The root ξ, to start a neighbouring line from.
    pub xi: f64,
    pub iterations: u32,
}

/// A sinking line made dimensionless.
#[derive(Debug, Clone, Copy)]
struct Dimensionless {
    /// x/L, z/L
    x: f64,
    z: f64,
    /// wL/(2 EA)
    kappa: f64,
    /// 1 - (x² + z²)/L²
    excess: f64,
}

/// Ends nearer to a vertical than this share of the length are above each other.
const PLUMB: f64 = 1e-120;
/// No root lies beyond: cosh ξ would exceed what [`PLUMB`] allows.
const STEEPEST: f64 = 300.0;

/// Forces of a line with weight `w` > 0, `x` >= 0, any `z`; `seed` is a ξ to start from.
///
/// `None` when no tension in the range of numbers reaches the other end (inextensible and too short).
pub(super) fn solve(
    x: f64,
    z: f64,
    length: f64,
    w: f64,
    ea: f64,
    seed: Option<f64>,
) -> Option<SuspendedForces> {
    let p = Dimensionless {
        x: x / length,
        z: z / length,
        kappa: 0.5 * w * length / ea,
        excess: excess(x, z, length),
    };
    if p.x < PLUMB {
        return Some(plumb(z, length, w, ea));
    }
    let root = p.root(seed)?;
    Some(p.forces(root, w * length))
}

/// A line with one end straight above the other: taut, or doubled over with its parts hanging straight.
fn plumb(z: f64, length: f64, w: f64, ea: f64) -> SuspendedForces {
    let half = 0.5 * w * length;
    let taut = ea * ((z.abs() - length) / length);
    SuspendedForces {
        h: 0.0,
        v_mean: if taut >= half {
            taut.copysign(z)
        } else {
            z / length * half / (1.0 + half / ea)
        },
        xi: 1.0,
        iterations: 0,
    }
}

/// `1 - (x² + z²)/L²` without cancellation.
fn excess(x: f64, z: f64, length: f64) -> f64 {
    let square = |a: f64| DoubleDouble::from(a) * a;
    (square(length) - square(x) - square(z)).value() / (length * length)
}

impl Dimensionless {
    fn root(&self, seed: Option<f64>) -> Option<Root> {
        let guess = seed.unwrap_or_else(|| self.guess());
        increasing_root(guess, STEEPEST, |xi| self.value(xi))
    }

    /// Left side less right side.
    fn value(&self, xi: f64) -> FunctionSample {
        let f = hyperbolic(xi);
        let (sh, ch) = (f.sinh, 1.0 + f.cosh_minus_1);
        let coth = ch / sh;
        let (e, c) = (self.kappa * coth, xi * coth);
        let g = ch / (c + e);
        // cosh ξ - ξ coth ξ = coth ξ (sinh ξ - ξ)
        let sag = (coth * f.sinh_minus_x - e) / (c + e);
        let k = 1.0 / (1.0 + e);
        let stretch = -e * (2.0 + e) * k * k;
        let (x2, xg) = (self.x * self.x, self.x * g);
        let sag_term = if g > 2.0 {
            xg * xg - x2
        } else {
            x2 * sag * (g + 1.0)
        };
        let (zk, quotient) = (self.z * k, xi / sh);
        let de = -self.kappa * quotient / sh;
        let dc = xi * (coth - quotient / sh);
        let dlng = xi * sh / ch - (de + dc) / (c + e);
        let stretch_term = self.z * self.z * stretch;
        FunctionSample {
            value: sag_term + stretch_term - self.excess,
            log_slope: 2.0 * (xg * xg * dlng - zk * zk * k * de),
            scale: sag_term.abs() - stretch_term + self.excess.abs(),
        }
    }

    /// A start within a factor of two or so: the stiff, the taut and the exactly taut limits compared.
    fn guess(&self) -> f64 {
        let (x2, z2) = (self.x * self.x, self.z * self.z);
        let most = 1.0 + 1.2 * (2.0 * (1.0 + self.kappa) / self.x).ln_1p();
        // Neither too long nor too short: sag ξ²x²/3 pays for stretch 2κ/ξ.
        let cube = 6.0 * self.kappa * (x2 + z2) / x2;
        let at_rest = if cube < 1.0 {
            cube.cbrt()
        } else {
            stiff_guess(cube / 15.0)
        };
        let guess = if self.excess > 0.0 {
            stiff_guess(self.excess / x2).max(at_rest)
        } else {
            let strain = -self.excess / (1.0 + (1.0 - self.excess).sqrt());
            let ratio = self.kappa / strain;
            if ratio < 0.95 {
                ratio.atanh().min(at_rest)
            } else {
                // Stretched by little more than its own weight: as steep as the excess length allows.
                let hung = 1.0 + self.kappa;
                stiff_guess(((hung * hung - z2) / x2).max(1.0)).min(at_rest.max(2.0))
            }
        };
        guess.min(most)
    }

    fn forces(&self, root: Root, load: f64) -> SuspendedForces {
        let f = hyperbolic(root.x);
        let coth = if root.x < 30.0 {
            (1.0 + f.cosh_minus_1) / f.sinh
        } else {
            1.0
        };
        let tm = 0.5 * load * coth;
        let e = self.kappa * coth;
        SuspendedForces {
            h: self.x * tm / (root.x * coth + e),
            v_mean: self.z * tm / (1.0 + e),
            xi: root.x,
            iterations: root.evaluations,
        }
    }
}

/// Where `sinh²ξ/ξ² - 1 = y`, within a few percent.
fn stiff_guess(y: f64) -> f64 {
    if y < 8.0 {
        // sinh²ξ/ξ² - 1 = ξ²/3 + 2ξ⁴/45 + ...
        return (3.0 * y / (1.0 + 0.28 * y.sqrt())).sqrt();
    }
    let big = (2.0 * (1.0 + y).sqrt()).ln();
    let once = big + big.ln();
    big + once.ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_rising_function_and_its_slope() {
        for (x, z, kappa) in [
            (0.9, 0.1, 1e-3),
            (0.1, 0.8, 1e-8),
            (0.9, 0.9, 0.1),
            (1e-4, 0.3, 2.0),
        ] {
            let excess = 1.0 - x * x - z * z;
            let p = Dimensionless {
                x,
                z,
                kappa,
                excess,
            };
            for xi in [1e-3_f64, 0.1, 0.9, 1.1, 5.0, 12.0] {
                let d = 1e-5;
                let (up, down) = (p.value(xi * (1.0 + d)).value, p.value(xi * (1.0 - d)).value);
                let slope = p.value(xi).log_slope;
                assert!(slope > 0.0);
                assert!(
                    ((up - down) / (2.0 * d) / slope - 1.0).abs() < 1e-4,
                    "{p:?} {xi}"
                );
            }
        }
    }

    #[test]
    fn the_guess_is_close_for_stiff_lines() {
        for xi in [1e-3, 0.1, 0.5, 1.0, 2.0, 3.0, 6.0, 20.0] {
            let f = hyperbolic(xi);
            let y = (f.sinh / xi).powi(2) - 1.0;
            assert!(
                (stiff_guess(y) / xi - 1.0).abs() < 0.15,
                "{xi} {}",
                stiff_guess(y)
            );
        }
    }
}
