//! Submerged fraction of segments and bodies, and the buoyancy they lose above the surface.
//!
//! The submerged fraction of a point at height d above the surface is `(r - d) / 2r`, between 0 and 1, with the radius r of the
//! line: a line afloat sinks by its thickness. The height is linear between nodes, and the fraction of half a segment is the mean
//! along it in closed form: continuous, and smooth if the line is not level. All forces are so continuous in the height of the
//! surface.
//!
//! The lost buoyancy derives from a potential of the heights of both nodes, so that no cycle through the surface gains or loses
//! energy, and a straight spar has the exact lift and moment.

use crate::numerics::V3;

/// Submerged fraction, and its derivatives by the positions of the nodes \[1/m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Submergence {
    pub(super) share: f64,
    /// By the position of the first node of the segment, then of its second.
    pub(super) by: [V3; 2],
}

/// Height of a node above the surface \[m\], and its derivative by the position of the node.
#[derive(Debug, Clone, Copy)]
pub(super) struct NodeHeight {
    pub(super) above: f64,
    pub(super) by_place: V3,
}

/// Buoyancy lost by the dry part of a segment.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LostBuoyancy {
    /// Potential per weight of the water displaced by the segment \[m\].
    pub energy: f64,
    /// Fractions of the buoyancy of the segment lost at its first and second node.
    pub lost: [f64; 2],
    /// Their derivatives by the heights of first and second node \[1/m\].
    pub by: [[f64; 2]; 2],
}

/// Buoyancy lost by a segment of radius r \[m\] between nodes at these heights above the surface \[m\].
pub fn lost_buoyancy(r: f64, [p, q]: [f64; 2]) -> LostBuoyancy {
    if p.max(q) <= -r {
        return LostBuoyancy::default();
    }
    let half = LostBuoyancy {
        energy: 0.5 * (p + q),
        lost: [0.5; 2],
        by: [[0.0; 2]; 2],
    };
    if p.min(q) >= r {
        return half;
    }
    let span = q - p;
    if span.abs() < 1e-4 * r {
        let (share, slope) = point(r, half.energy);
        let turn = slope * span / 12.0;
        return LostBuoyancy {
            energy: lifted(r, half.energy),
            lost: [0.5 * (1.0 - share) + turn, 0.5 * (1.0 - share) - turn],
            by: [[-slope / 3.0, -slope / 6.0], [-slope / 6.0, -slope / 3.0]],
        };
    }
    let energy = (lifted_sum(r, q) - lifted_sum(r, p)) / span;
    let first = (energy - lifted(r, p)) / span;
    let second = (lifted(r, q) - energy) / span;
    let [dry_p, dry_q] = [p, q].map(|d| 1.0 - point(r, d).0);
    let across = (second - first) / span;
    LostBuoyancy {
        energy,
        lost: [first, second],
        by: [
            [(2.0 * first - dry_p) / span, across],
            [across, (dry_q - 2.0 * second) / span],
        ],
    }
}

/// Submerged fraction of each half of a segment of radius r \[m\] between nodes at these heights.
pub(super) fn halves(r: f64, nodes: [&NodeHeight; 2]) -> [Submergence; 2] {
    let [first, second] = nodes;
    let middle = 0.5 * (first.above + second.above);
    let (one, one_p, one_q) = mean(r, first.above, middle);
    let (two, two_p, two_q) = mean(r, middle, second.above);
    [
        Submergence {
            share: one,
            by: [
                first.by_place * (one_p + 0.5 * one_q),
                second.by_place * (0.5 * one_q),
            ],
        },
        Submergence {
            share: two,
            by: [
                first.by_place * (0.5 * two_p),
                second.by_place * (0.5 * two_p + two_q),
            ],
        },
    ]
}

/// Submerged fraction of a sphere of radius r \[m\] with its centre at this height, and its derivative by the height \[1/m\].
pub(super) fn sphere(r: f64, above: f64) -> (f64, f64) {
    let x = (r - above) / (2.0 * r);
    if x <= 0.0 {
        (0.0, 0.0)
    } else if x >= 1.0 {
        (1.0, 0.0)
    } else {
        (x * x * (3.0 - 2.0 * x), -3.0 * x * (1.0 - x) / r)
    }
}

/// Potential of the lost buoyancy of a sphere of radius r with its centre at this height, per weight of the water it displaces
/// \[m\].
pub(super) fn sphere_lost_energy(r: f64, above: f64) -> f64 {
    let x = (r + above) / (2.0 * r);
    if x <= 0.0 {
        0.0
    } else if x >= 1.0 {
        above
    } else {
        r * x * x * x * (2.0 - x)
    }
}

/// Mean submerged fraction between the heights p and q, and its derivatives by both.
fn mean(r: f64, p: f64, q: f64) -> (f64, f64, f64) {
    if p.min(q) >= r {
        return (0.0, 0.0, 0.0);
    }
    if p.max(q) <= -r {
        return (1.0, 0.0, 0.0);
    }
    let span = q - p;
    if span.abs() < 1e-4 * r {
        let (share, slope) = point(r, 0.5 * (p + q));
        return (share, 0.5 * slope, 0.5 * slope);
    }
    let share = (cumulated(r, q) - cumulated(r, p)) / span;
    (
        share,
        (share - point(r, p).0) / span,
        (point(r, q).0 - share) / span,
    )
}

/// Submerged fraction of a point at height d, and its derivative.
fn point(r: f64, d: f64) -> (f64, f64) {
    if d >= r {
        (0.0, 0.0)
    } else if d <= -r {
        (1.0, 0.0)
    } else {
        ((r - d) / (2.0 * r), -0.5 / r)
    }
}

/// Integral of the dry fraction of a point from far below up to the height d \[m\].
fn lifted(r: f64, d: f64) -> f64 {
    if d >= r {
        d
    } else if d <= -r {
        0.0
    } else {
        (r + d) * (r + d) / (4.0 * r)
    }
}

/// Integral of that \[m²\].
fn lifted_sum(r: f64, d: f64) -> f64 {
    if d >= r {
        0.5 * d * d + r * r / 6.0
    } else if d <= -r {
        0.0
    } else {
        (r + d).powi(3) / (12.0 * r)
    }
}

/// Integral of the submerged fraction of a point from far above down to the height d, negative.
fn cumulated(r: f64, d: f64) -> f64 {
    if d >= r {
        0.0
    } else if d <= -r {
        d
    } else {
        -(r - d) * (r - d) / (4.0 * r)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(above: f64) -> NodeHeight {
        NodeHeight {
            above,
            by_place: V3::z(),
        }
    }

    #[test]
    fn an_upright_spar_is_wet_by_its_draught() {
        // From 3 m above to 7 m below: 30 % dry, all of it in the upper half.
        let [upper, lower] = halves(1e-3, [&at(3.0), &at(-7.0)]);
        assert!((upper.share - 0.4).abs() < 1e-12);
        assert_eq!(lower.share, 1.0);
    }

    #[test]
    fn continuous_with_its_derivatives() {
        for (p, q) in [
            (0.1, -0.3),
            (0.02, 0.02),
            (-0.04, 0.5),
            (0.3, -2.0),
            (0.01, 0.0100001),
        ] {
            let share = |p: f64, q: f64| halves(0.05, [&at(p), &at(q)]).map(|w| w.share);
            let h = 1e-7;
            let both = halves(0.05, [&at(p), &at(q)]);
            for (half, wet) in both.iter().enumerate() {
                let by_p = (share(p + h, q)[half] - share(p - h, q)[half]) / (2.0 * h);
                let by_q = (share(p, q + h)[half] - share(p, q - h)[half]) / (2.0 * h);
                assert!((by_p - wet.by[0].z).abs() < 2e-5, "{p} {q} {half}");
                assert!((by_q - wet.by[1].z).abs() < 2e-5, "{p} {q} {half}");
            }
        }
        let mut before = 1.0;
        for i in 0..2000 {
            let height = -1.0 + 1e-3 * f64::from(i);
            let [a, b] = halves(0.05, [&at(height), &at(height + 0.2)]);
            let all = 0.5 * (a.share + b.share);
            assert!(all <= before && before - all < 6e-3);
            before = all;
        }
        assert_eq!(before, 0.0);
    }

    /// What is lost is the derivative of the energy, in sum what is dry, and its lever that of the dry part.
    #[test]
    fn buoyancy_is_lost_as_an_energy_is() {
        let r = 0.05;
        for (p, q) in [
            (0.1, -0.3),
            (0.02, 0.02),
            (-0.04, 0.5),
            (0.3, -2.0),
            (0.01, 0.010001),
            (40.0, -60.0),
            (0.2, 0.3),
        ] {
            let dry = lost_buoyancy(r, [p, q]);
            let h = 1e-6;
            for node in 0..2 {
                let at = |h: f64| {
                    let mut heights = [p, q];
                    heights[node] += h;
                    lost_buoyancy(r, heights)
                };
                let (up, down) = (at(h), at(-h));
                let slope = (up.energy - down.energy) / (2.0 * h);
                assert!(
                    (slope - dry.lost[node]).abs() < 1e-6,
                    "{p} {q} {slope} {dry:?}"
                );
                for of in 0..2 {
                    let slope = (up.lost[of] - down.lost[of]) / (2.0 * h);
                    assert!(
                        (slope - dry.by[of][node]).abs() < 1e-4,
                        "{p} {q} {slope} {dry:?}"
                    );
                }
            }
            let wet = halves(r, [&at(p), &at(q)]);
            let all = 1.0 - 0.5 * (wet[0].share + wet[1].share);
            assert!((dry.lost[0] + dry.lost[1] - all).abs() < 1e-9, "{p} {q}");
        }
        // 40 % of a thin spar is out: its middle is at 20 %.
        let dry = lost_buoyancy(1e-6, [4.0, -6.0]);
        assert!((dry.lost[0] + dry.lost[1] - 0.4).abs() < 1e-6);
        assert!((dry.lost[1] - 0.4 * 0.2).abs() < 1e-6);
    }

    #[test]
    fn a_sphere_is_lifted_as_it_gets_dry() {
        let h = 1e-6;
        for above in [-2.5, -1.9, -0.3, 0.0, 1.2, 1.99, 2.5] {
            let slope = (sphere_lost_energy(2.0, above + h) - sphere_lost_energy(2.0, above - h))
                / (2.0 * h);
            assert!(
                (slope - (1.0 - sphere(2.0, above).0)).abs() < 1e-8,
                "{above}"
            );
        }
    }

    #[test]
    fn a_sphere_is_wet_by_its_volume() {
        let (share, slope) = sphere(2.0, 0.5);
        // Cap of height 1.5 m: pi h² (3r - h) / 3 over 4/3 pi r³.
        assert!((share - 1.5 * 1.5 * 4.5 / 32.0).abs() < 1e-14);
        let h = 1e-6;
        let by = (sphere(2.0, 0.5 + h).0 - sphere(2.0, 0.5 - h).0) / (2.0 * h);
        assert!((by - slope).abs() < 1e-9);
        assert_eq!(sphere(2.0, 2.0).0, 0.0);
        assert_eq!(sphere(2.0, -2.0).0, 1.0);
    }
}
