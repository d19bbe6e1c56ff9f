//! Dynamic stability of a moored ship in the horizontal plane: surge, sway and yaw linearised about an equilibrium,
//! `M q̈ + D q̇ + K q = 0` (eq. 4 of the ropeway paper with the mooring stiffness in K), and its eigenvalues. A positive real
//! eigenvalue is divergence (static instability), a complex pair with positive real part is fishtailing (a Hopf bifurcation),
//! which depends on inertia and on the damping by wind and current on the moving ship as well as on stiffness.
//!
//! Axes along the ship at equilibrium, about its reference point. The line is quasi-static: its own stiffness in its
//! direction, pull over horizontal extent across; the moment of its pull about the reference point turns with the ship.

use std::f64::consts::{LN_2, TAU};

use nalgebra::{Complex, Matrix2, Matrix3, Matrix6, Vector2, Vector3};

use super::hull::HullMatrices;
use super::loads::EnvironmentalLoads;
use super::mooring::MooringSolution;
use super::yaw_equilibria::YawEquilibrium;

/// Response to a small disturbance, by the eigenvalue of largest real part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DynamicStability {
    /// All modes decay; period and half-life of the mode that decays slowest.
    Stable {
        /// Period \[s\]; absent where it is overdamped.
        period: Option<f64>,
        /// Time to half the amplitude \[s\].
        half_life: f64,
    },
    /// It neither grows nor decays.
    Neutral,
    /// It grows without oscillation.
    Divergence {
        /// Time to twice the amplitude \[s\].
        doubling_time: f64,
    },
    /// It grows in oscillations.
    Fishtailing {
        /// Period \[s\].
        period: f64,
        /// Time to twice the amplitude \[s\].
        doubling_time: f64,
    },
}

impl DynamicStability {
    /// In a word.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Stable { .. } => "stable",
            Self::Neutral => "neutral",
            Self::Divergence { .. } => "diverges",
            Self::Fishtailing { .. } => "fishtails",
        }
    }

    /// Period of an oscillation, and the half-life or doubling time of the amplitude \[s\].
    #[must_use]
    pub fn times(self) -> (Option<f64>, Option<f64>) {
        match self {
            Self::Stable { period, half_life } => (period, Some(half_life)),
            Self::Neutral => (None, None),
            Self::Divergence { doubling_time } => (None, Some(doubling_time)),
            Self::Fishtailing {
                period,
                doubling_time,
            } => (Some(period), Some(doubling_time)),
        }
    }
}

/// Surge, sway and yaw linearised about an equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanarDynamics {
    /// Mass and added mass.
    pub mass: Matrix3<f64>,
    /// Damping of the hull, and of wind and current on the moving ship.
    pub damping: Matrix3<f64>,
    /// Stiffness of mooring, hydrostatics, and loads that vary with the heading.
    pub stiffness: Matrix3<f64>,
}

/// Real parts below this fraction of the largest eigenvalue are rounding.
const ROUNDING: f64 = 1e-9;

impl PlanarDynamics {
    /// About a yaw equilibrium, on the mooring line at its pull.
    #[must_use]
    pub fn new(
        hull: &HullMatrices,
        loads: &EnvironmentalLoads,
        yaw: &YawEquilibrium,
        line: &MooringSolution,
    ) -> Self {
        let linearised = loads.linearised(yaw.heading, 0.0, [0.0; 2]);
        let slope = linearised.by_yaw;
        let by_load = Matrix3::from_columns(&[Vector3::zeros(), Vector3::zeros(), slope.into()]);
        let by_velocity = Matrix3::from_columns(&[
            linearised.by_velocity[0].into(),
            linearised.by_velocity[1].into(),
            Vector3::zeros(),
        ]);
        Self {
            mass: HullMatrices::planar(&hull.mass),
            damping: HullMatrices::planar(&hull.damping) - by_velocity,
            stiffness: HullMatrices::planar(&hull.restoring) - by_load
                + mooring_stiffness(loads.arm, yaw, line),
        }
    }

    /// Eigenvalues \[1/s\] by descending real part: roots of `det(M λ² + D λ + K)`. None where the mass matrix is singular or
    /// they are not finite.
    #[must_use]
    pub fn eigenvalues(&self) -> Option<Vec<Complex<f64>>> {
        let inverse = self.mass.try_inverse()?;
        let mut companion = Matrix6::zeros();
        let mut put = |i: usize, j: usize, block: Matrix3<f64>| {
            companion
                .fixed_view_mut::<3, 3>(3 * i, 3 * j)
                .copy_from(&block);
        };
        put(0, 1, Matrix3::identity());
        put(1, 0, -inverse * self.stiffness);
        put(1, 1, -inverse * self.damping);
        let found = companion.complex_eigenvalues();
        let mut list: Vec<Complex<f64>> = found.iter().copied().collect();
        list.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
        let finite = list.iter().all(|l| l.re.is_finite() && l.im.is_finite());
        finite.then_some(list)
    }

    /// Stability of the mode that grows fastest or decays slowest.
    #[must_use]
    pub fn stability(&self) -> Option<DynamicStability> {
        let list = self.eigenvalues()?;
        let fastest = list.iter().map(|l| l.norm()).fold(0.0, f64::max);
        let last = list.first()?;
        let rounding = ROUNDING * fastest;
        let oscillates = last.im.abs() > rounding.max(1e-6 * last.re.abs());
        let period = oscillates.then(|| TAU / last.im.abs());
        Some(if last.re.abs() <= rounding {
            DynamicStability::Neutral
        } else if last.re < 0.0 {
            DynamicStability::Stable {
                period,
                half_life: -LN_2 / last.re,
            }
        } else {
            let doubling_time = LN_2 / last.re;
            match period {
                Some(period) => DynamicStability::Fishtailing {
                    period,
                    doubling_time,
                },
                None => DynamicStability::Divergence { doubling_time },
            }
        })
    }
}

/// Stiffness of the mooring line at the bow, about the reference point.
fn mooring_stiffness(arm: f64, yaw: &YawEquilibrium, line: &MooringSolution) -> Matrix3<f64> {
    let (sin, cos) = (yaw.force_direction - yaw.heading).sin_cos();
    let away = Vector2::new(cos, sin);
    let stiffness_at_bow = away * away.transpose() * line.stiffness_along
        + (Matrix2::identity() - away * away.transpose()) * line.stiffness_across;
    // Displacement of the bow by surge, sway and yaw.
    let bow = nalgebra::Matrix2x3::new(1.0, 0.0, 0.0, 0.0, 1.0, arm);
    let force = stiffness_at_bow * bow;
    let ahead = -yaw.pull * cos;
    let mut stiffness = Matrix3::zeros();
    for j in 0..3 {
        stiffness[(0, j)] = force[(0, j)];
        stiffness[(1, j)] = force[(1, j)];
        stiffness[(2, j)] = arm * force[(1, j)];
    }
    stiffness[(2, 2)] += arm * ahead;
    stiffness
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn planar(mass: [f64; 3], damping: Matrix3<f64>, stiffness: Matrix3<f64>) -> PlanarDynamics {
        PlanarDynamics {
            mass: Matrix3::from_diagonal(&Vector3::from(mass)),
            damping,
            stiffness,
        }
    }

    #[test]
    fn separate_motions_have_the_roots_of_their_own_quadratics() {
        let diagonal = |a: f64, b: f64, c: f64| Matrix3::from_diagonal(&Vector3::new(a, b, c));
        let one = planar(
            [2.0, 3.0, 5.0],
            diagonal(0.4, 30.0, 1.0),
            diagonal(8.0, 3.0, 20.0),
        );
        let found = one.eigenvalues().unwrap();
        // λ = (-d ± √(d² - 4 m k)) / 2m.
        for (m, d, k) in [(2.0, 0.4, 8.0), (3.0, 30.0, 3.0), (5.0, 1.0, 20.0)] {
            let root = Complex::new(d * d - 4.0 * m * k, 0.0).sqrt();
            for sign in [1.0, -1.0] {
                let expected = (root * sign - d) / (2.0 * m);
                assert!(
                    found.iter().any(|l| (l - expected).norm() < 1e-9),
                    "{found:?}"
                );
            }
        }
        let Some(DynamicStability::Stable {
            period: Some(p),
            half_life,
        }) = one.stability()
        else {
            panic!("{:?}", one.stability());
        };
        assert!((half_life - LN_2 / 0.1).abs() < 1e-9, "{half_life}");
        let expected = [(4.0 - 0.01_f64).sqrt()];
        assert!(expected.iter().any(|w| (p - TAU / w).abs() < 1e-9), "{p}");
    }

    #[test]
    fn a_skew_stiffness_is_fishtailing_and_a_negative_one_is_divergence() {
        // Two motions of unit mass with skew coupling k ± c: λ² = -k ± i c.
        let mut stiffness = Matrix3::identity() * 4.0;
        stiffness[(1, 2)] = 0.5;
        stiffness[(2, 1)] = -0.5;
        let dynamic_stability = planar([1.0; 3], Matrix3::zeros(), stiffness)
            .stability()
            .unwrap();
        let root = Complex::new(-4.0, 0.5).sqrt();
        let DynamicStability::Fishtailing {
            period,
            doubling_time,
        } = dynamic_stability
        else {
            panic!("{dynamic_stability:?}");
        };
        assert!((period - TAU / f64::abs(root.im)).abs() < 1e-9);
        assert!((doubling_time - LN_2 / f64::abs(root.re)).abs() < 1e-9);
        let down = planar([1.0; 3], Matrix3::zeros(), Matrix3::identity() * -4.0);
        let Some(DynamicStability::Divergence { doubling_time }) = down.stability() else {
            panic!("{:?}", down.stability());
        };
        assert!((doubling_time - LN_2 / 2.0).abs() < 1e-12);
        let still = planar([1.0; 3], Matrix3::zeros(), Matrix3::identity());
        assert_eq!(still.stability(), Some(DynamicStability::Neutral));
        assert_eq!(
            planar([1.0, 0.0, 1.0], Matrix3::zeros(), stiffness).stability(),
            None
        );
    }

    proptest! {
        /// Sway and yaw against the Routh-Hurwitz criterion on their quartic.
        #[test]
        fn stability_is_that_of_the_routh_hurwitz_criterion(
            d in prop::array::uniform4(-1.0..3.0f64), k in prop::array::uniform4(-2.0..4.0f64),
        ) {
            let mut damping = Matrix3::identity();
            let mut stiffness = Matrix3::identity();
            for (at, (i, j)) in [(1, 1), (1, 2), (2, 1), (2, 2)].into_iter().enumerate() {
                damping[(i, j)] = d[at];
                stiffness[(i, j)] = k[at];
            }
            let dynamic_stability = planar([1.0; 3], damping, stiffness).stability().unwrap();
            // det(λ² + Dλ + K) = λ⁴ + a1 λ³ + a2 λ² + a3 λ + a4.
            let a1 = d[0] + d[3];
            let a2 = d[0] * d[3] - d[1] * d[2] + k[0] + k[3];
            let a3 = d[0] * k[3] + d[3] * k[0] - d[1] * k[2] - d[2] * k[1];
            let a4 = k[0] * k[3] - k[1] * k[2];
            let hurwitz = [a1, a4, a1 * a2 - a3, a3 * (a1 * a2 - a3) - a1 * a1 * a4];
            prop_assume!(hurwitz.iter().all(|h| h.abs() > 1e-6));
            let stable = hurwitz.iter().all(|h| *h > 0.0);
            prop_assert_eq!(matches!(dynamic_stability, DynamicStability::Stable { .. }), stable, "{:?}", dynamic_stability);
        }
    }
}
