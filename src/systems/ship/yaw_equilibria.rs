//! Yaw equilibria of a ship at a single-point mooring: all zeros of the moment about the mooring point, eq. (2), with the
//! mooring force and the static stability in yaw of each.
//!
//! The line runs from the anchor along the total force, so the bow lies in that direction from the anchor, at the horizontal
//! extent of the line under that pull. The stiffness of the moored ship against small displacements of the mooring point along
//! and across the line and against small yaw angles is triangular, because the loads depend on the heading alone. Its
//! eigenvalues are the stiffness of the line in its own direction, pull over horizontal extent across it, and `-dM/dψ` in yaw:
//! the equilibrium is statically stable where all three are positive. Dynamic instability, such as fishtailing, is the subject
//! of [`stability`](super::stability).

use std::f64::consts::{PI, TAU};

use super::loads::{EnvironmentalLoads, PlanarLoad};
use crate::numerics::root_isolation::{BoundedCurvature, IsolatedRoot, isolate_roots};

/// A heading at which the moment about the mooring point vanishes.
#[derive(Debug, Clone, PartialEq)]
pub struct YawEquilibrium {
    /// Heading of the bow, from +x towards +y, in (-π, π] \[rad\].
    pub heading: f64,
    /// Width of the range of headings over which the moment vanishes; zero at a simple root \[rad\].
    pub width: f64,
    /// Static stability in yaw.
    pub stability: YawStability,
    /// Stiffness in yaw about the mooring point, `-dM/dψ` \[N m/rad\].
    pub yaw_stiffness: f64,
    /// Total load, in ship axes.
    pub load: PlanarLoad,
    /// Horizontal mooring force, the magnitude of the total force \[N\].
    pub pull: f64,
    /// Direction of the total force, from +x towards +y, and of the bow from the anchor \[rad\].
    pub force_direction: f64,
}

/// Static stability in yaw, by the sign of the moment to either side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum YawStability {
    /// The moment restores the heading.
    Stable,
    /// The moment diverges from the heading.
    Unstable,
    /// The moment touches zero: it restores from one side only.
    SemiStable,
    /// The moment vanishes over a range of headings.
    Neutral,
}

impl YawStability {
    /// In a word.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Unstable => "unstable",
            Self::SemiStable => "semi-stable",
            Self::Neutral => "neutral",
        }
    }
}

/// Why there are no yaw equilibria.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum YawEquilibriumError {
    /// The moment has no root.
    #[error(
        "the moment about the mooring point never vanishes: the ship rotates without end and has no equilibrium heading"
    )]
    None,
    /// The moment is not finite, or its second derivative is too large.
    #[error(
        "the moment about the mooring point is not finite at every heading, or varies too fast for its roots to be isolated"
    )]
    Unbounded,
}

struct YawMoment<'a> {
    loads: &'a EnvironmentalLoads,
    rounding: f64,
}

impl BoundedCurvature for YawMoment<'_> {
    fn at(&self, x: f64) -> (f64, f64) {
        self.loads.moment(x)
    }

    fn second_derivative_bound(&self, x: f64) -> f64 {
        self.loads.second_derivative_bound(x)
    }

    fn rounding(&self) -> f64 {
        self.rounding
    }
}

/// All equilibrium headings in (-π, π], none missed.
///
/// # Errors
/// [`YawEquilibriumError`] where there is none, or the moment is not bounded.
pub fn yaw_equilibria(
    loads: &EnvironmentalLoads,
) -> Result<Vec<YawEquilibrium>, YawEquilibriumError> {
    let rounding = 1e-13 * loads.moment_bound();
    let moment = YawMoment { loads, rounding };
    let found =
        isolate_roots(&moment, &loads.breakpoints()).ok_or(YawEquilibriumError::Unbounded)?;
    let mut equilibria: Vec<YawEquilibrium> = merged_at_pi(found)
        .into_iter()
        .map(|(from, to)| equilibrium(loads, from, to))
        .collect();
    if equilibria.is_empty() {
        return Err(YawEquilibriumError::None);
    }
    equilibria.sort_by(|a, b| a.heading.total_cmp(&b.heading));
    Ok(equilibria)
}

/// Roots as intervals of headings; one that crosses ±π is one interval.
fn merged_at_pi(found: Vec<IsolatedRoot>) -> Vec<(f64, f64)> {
    const SAME: f64 = 1e-9;
    let mut ranges: Vec<(f64, f64)> = found
        .into_iter()
        .map(|root| match root {
            IsolatedRoot::Point(x) => (x, x),
            IsolatedRoot::Interval(a, b) => (a, b),
        })
        .collect();
    if let ([first, .., last], true) = (ranges.as_slice(), ranges.len() > 1)
        && first.0 + PI < SAME
        && PI - last.1 < SAME
    {
        let joined = (last.0 - TAU, first.1);
        ranges.pop();
        ranges[0] = joined;
    }
    ranges
}

fn equilibrium(loads: &EnvironmentalLoads, from: f64, to: f64) -> YawEquilibrium {
    let middle = 0.5 * (from + to);
    let (load, _) = loads.total(middle);
    let (sin, cos) = middle.sin_cos();
    let force = (load[0] * cos - load[1] * sin, load[0] * sin + load[1] * cos);
    let (stability, yaw_stiffness) = static_stability(loads, from, to);
    let heading = (middle + PI).rem_euclid(TAU) - PI;
    YawEquilibrium {
        // Of the equal headings -180 and 180 degrees the latter is reported.
        heading: if heading + PI < 1e-9 {
            heading + TAU
        } else {
            heading
        },
        width: to - from,
        stability,
        yaw_stiffness,
        load,
        pull: force.0.hypot(force.1),
        force_direction: force.1.atan2(force.0),
    }
}

/// Stability and stiffness by the moment on either side, which also decides at a kink and at a multiple root.
fn static_stability(loads: &EnvironmentalLoads, from: f64, to: f64) -> (YawStability, f64) {
    const WIDE: f64 = 1e-3;
    const ASIDE: f64 = 1e-6;
    let stiffness = -loads.moment(0.5 * (from + to)).1;
    if to - from > WIDE {
        return (YawStability::Neutral, 0.0);
    }
    let aside = ASIDE.max(4.0 * (to - from));
    let (before, after) = (loads.moment(from - aside).0, loads.moment(to + aside).0);
    let stability = match (before > 0.0, after > 0.0) {
        (true, false) => YawStability::Stable,
        (false, true) => YawStability::Unstable,
        _ => YawStability::SemiStable,
    };
    (stability, stiffness)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ship::loads::EnvironmentalLoad;
    use crate::ship::periodic_curve::PeriodicCurve;
    use proptest::prelude::*;

    /// A load with these sway amplitudes on sin α, at an arm of one metre: the moment is `-a sin(towards - ψ)`.
    fn side(towards: f64, sines: Vec<f64>) -> EnvironmentalLoad {
        let sines = std::iter::once(0.0).chain(sines).collect();
        EnvironmentalLoad {
            name: "wind",
            towards,
            reference: [1.0; 3],
            curves: [
                PeriodicCurve::Fourier {
                    cos: vec![0.0, 1.0],
                    sin: vec![],
                },
                PeriodicCurve::Fourier {
                    cos: vec![],
                    sin: sines,
                },
                PeriodicCurve::Fourier {
                    cos: vec![],
                    sin: vec![],
                },
            ],
            speed: None,
        }
    }

    #[test]
    fn one_flow_turns_the_bow_into_it() {
        for towards in [-3.0, -1.0, 0.0, 0.5, PI] {
            let loads = EnvironmentalLoads {
                each: vec![side(towards, vec![2.0])],
                arm: 1.0,
            };
            let found = yaw_equilibria(&loads).unwrap();
            assert_eq!(found.len(), 2, "{towards}");
            for one in &found {
                let angle = (one.heading - towards).cos();
                match one.stability {
                    YawStability::Stable => assert!((angle + 1.0).abs() < 1e-12),
                    YawStability::Unstable => assert!((angle - 1.0).abs() < 1e-12),
                    _ => panic!("{one:?}"),
                }
                assert!((one.pull - 1.0).abs() < 1e-12);
                assert!((one.yaw_stiffness.abs() - 2.0).abs() < 1e-12);
                assert!(((one.force_direction - towards).cos() - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn two_flows_across_meet_at_the_angle_of_their_sum() {
        // -a sin(-ψ) - b sin(π/2 - ψ) = a sin ψ - b cos ψ: zero where tan ψ = b / a.
        let (a, b) = (3.0, 4.0_f64);
        let loads = EnvironmentalLoads {
            each: vec![side(0.0, vec![a]), side(0.5 * PI, vec![b])],
            arm: 1.0,
        };
        let found = yaw_equilibria(&loads).unwrap();
        let headings: Vec<f64> = found.iter().map(|f| f.heading).collect();
        assert_eq!(found.len(), 2);
        assert!((headings[1] - b.atan2(a)).abs() < 1e-12);
        assert!((headings[0] - (b.atan2(a) - PI)).abs() < 1e-12);
    }

    #[test]
    fn a_second_harmonic_brings_two_more_headings() {
        // sin x (1 + 2 c cos x) = 0 with c = 1: x = 0, π, ±120°.
        let loads = EnvironmentalLoads {
            each: vec![side(0.0, vec![1.0, 1.0])],
            arm: 1.0,
        };
        let degrees: Vec<f64> = yaw_equilibria(&loads)
            .unwrap()
            .iter()
            .map(|f| f.heading.to_degrees())
            .collect();
        assert_eq!(degrees.len(), 4, "{degrees:?}");
        for (found, expected) in degrees.iter().zip([-120.0, 0.0, 120.0, 180.0]) {
            assert!((found - expected).abs() < 1e-9, "{degrees:?}");
        }
    }

    #[test]
    fn no_root_a_vanishing_moment_and_a_double_root_are_classified() {
        let mut turning = side(0.0, vec![0.0]);
        turning.curves[2] = PeriodicCurve::Fourier {
            cos: vec![2.0, 1.0],
            sin: vec![],
        };
        let with = |load: EnvironmentalLoad| {
            yaw_equilibria(&EnvironmentalLoads {
                each: vec![load],
                arm: 1.0,
            })
        };
        assert_eq!(with(turning.clone()), Err(YawEquilibriumError::None));
        let calm = with(side(0.0, vec![0.0])).unwrap();
        assert_eq!(calm.len(), 1);
        assert_eq!(calm[0].stability, YawStability::Neutral);
        turning.curves[2] = PeriodicCurve::Fourier {
            cos: vec![1.0, 1.0],
            sin: vec![],
        };
        let touching = with(turning).unwrap();
        assert_eq!(touching.len(), 1, "{touching:?}");
        assert_eq!(touching[0].stability, YawStability::SemiStable);
        assert!((touching[0].heading - PI).abs() < 1e-5);
    }

    proptest! {
        /// A trigonometric polynomial built from its roots has those roots and no others.
        #[test]
        fn no_root_is_missed(mut roots in prop::collection::vec(-3.1..3.1f64, 1..4), towards in -3.0..3.0f64) {
            roots.sort_by(f64::total_cmp);
            roots.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
            // Π sin((x - r)/2) over pairs (r, r + π): Π ½ sin(x - r) has roots at r and r + π.
            let product = |x: f64| roots.iter().map(|r| (x - r).sin()).product::<f64>();
            let n = roots.len();
            let points = 4 * n + 4;
            let mut cos = vec![0.0; n + 1];
            let mut sin = vec![0.0; n + 1];
            for i in 0..points {
                let x = TAU * i as f64 / points as f64;
                for k in 0..=n {
                    let share = if k == 0 { 1.0 } else { 2.0 } / points as f64;
                    cos[k] += share * product(x) * (k as f64 * x).cos();
                    sin[k] += share * product(x) * (k as f64 * x).sin();
                }
            }
            let mut load = side(towards, vec![0.0]);
            load.curves[2] = PeriodicCurve::Fourier { cos, sin };
            let found = yaw_equilibria(&EnvironmentalLoads { each: vec![load], arm: 1.0 }).unwrap();
            let mut expected: Vec<f64> = roots.iter().flat_map(|r| [*r, r + PI])
                .map(|r| (towards - r + PI).rem_euclid(TAU) - PI).collect();
            expected.sort_by(f64::total_cmp);
            expected.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
            prop_assert_eq!(found.len(), expected.len(), "{:?} {:?}", found, expected);
            for (f, e) in found.iter().zip(&expected) {
                prop_assert!((f.heading - e).sin().abs() < 1e-6);
            }
        }
    }
}
