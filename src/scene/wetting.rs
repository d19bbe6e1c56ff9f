//! How much of a segment, or of a body, is under the surface of the water.
//!
//! A point of a line at the height d above the surface counts as wet by `(r - d) / 2r`, between 0 and 1: r is the
//! line's radius, so that a line that floats flat sinks in by its own thickness. The height goes straight from node to
//! node. The share of half a segment is the mean along it, in closed form: continuous, and smooth wherever the line
//! is not level. So every force on it is continuous in the height of the surface.

use crate::linalg::V3;

/// A share that is wet, and its derivatives by the places of the nodes \[1/m\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wet {
    pub(super) share: f64,
    /// By the place of the segment's first node, then of its second.
    pub(super) by: [V3; 2],
}

/// Height of a node above the surface \[m\], and its derivative by the node's place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Height {
    pub(super) above: f64,
    pub(super) by_place: V3,
}

/// The share of each half of a segment of radius r \[m\] between nodes at these heights.
pub(super) fn halves(r: f64, nodes: [&Height; 2]) -> [Wet; 2] {
    let [first, second] = nodes;
    let middle = 0.5 * (first.above + second.above);
    let (one, one_p, one_q) = mean(r, first.above, middle);
    let (two, two_p, two_q) = mean(r, middle, second.above);
    [
        Wet {
            share: one,
            by: [
                first.by_place * (one_p + 0.5 * one_q),
                second.by_place * (0.5 * one_q),
            ],
        },
        Wet {
            share: two,
            by: [
                first.by_place * (0.5 * two_p),
                second.by_place * (0.5 * two_p + two_q),
            ],
        },
    ]
}

/// The share of a sphere of radius r \[m\] with its centre at this height, and its derivative by the height \[1/m\].
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

/// Mean share between the heights p and q, and its derivatives by both.
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

/// Share of a point at the height d, and its derivative.
fn point(r: f64, d: f64) -> (f64, f64) {
    if d >= r {
        (0.0, 0.0)
    } else if d <= -r {
        (1.0, 0.0)
    } else {
        ((r - d) / (2.0 * r), -0.5 / r)
    }
}

/// Integral of the share of a point from far above down to the height d, negative.
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

    fn at(above: f64) -> Height {
        Height {
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
    fn continuous_with_the_derivatives_told() {
        for (p, q) in [
            (0.1, -0.3),
            (0.02, 0.02),
            (-0.04, 0.5),
            (0.3, -2.0),
            (0.01, 0.0100001),
        ] {
            let share = |p: f64, q: f64| halves(0.05, [&at(p), &at(q)]).map(|w| w.share);
            let h = 1e-7;
            let told = halves(0.05, [&at(p), &at(q)]);
            for (half, wet) in told.iter().enumerate() {
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
