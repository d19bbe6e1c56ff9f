//! Direction of a line at a node: the mean of the unit tangents of both segments beside it, as a unit vector; at an end the tangent of
//! its only segment.
//!
//! With `s = t1 + t2`, `d = s / |s|`: `dd = (I - dd') / |s| sum_k (I - t_k t_k') / l_k (dx_second - dx_first)`.

use super::tension::Chord;
use crate::numerics::{M3, V3};

/// The direction, with what its derivatives are built from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeDirection {
    /// The direction, from end A to end B.
    pub d: V3,
    /// Derivatives by the chords of the segments before and after the node \[1/m\].
    by_chords: [M3; 2],
}

/// Length of the sum of two unit tangents below which the line is folded back on itself, so that it has no mean direction.
const FOLDED: f64 = 1e-9;

impl NodeDirection {
    /// By the segments before and after the node, as far as there are any. Of a line that is folded back at the node: that of the
    /// segment after it.
    #[must_use]
    pub fn new(before: Option<&Chord>, after: Option<&Chord>) -> Self {
        let of = |chord: Option<&Chord>| chord.map_or_else(V3::zeros, |chord| chord.tangent);
        let mut beside = [before, after];
        if (of(before) + of(after)).norm() < FOLDED {
            beside[0] = beside[0].filter(|_| after.is_none());
        }
        let sum = of(beside[0]) + of(beside[1]);
        let inverse = 1.0 / sum.norm().max(FOLDED);
        let d = sum * inverse;
        let across = |t: &V3| M3::identity() - t * t.transpose();
        let turned = across(&d) * inverse;
        let by_chord = |chord: &Chord| turned * across(&chord.tangent) * chord.inverse;
        Self {
            d,
            by_chords: beside.map(|chord| chord.map_or_else(M3::zeros, by_chord)),
        }
    }

    /// Derivatives by the positions of the node before, of the node itself and of the node after it \[1/m\].
    #[must_use]
    pub fn by_positions(&self) -> [M3; 3] {
        let [before, after] = self.by_chords;
        [-before, before - after, after]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chord(from: &V3, to: &V3) -> Chord {
        Chord::new((from, to), (&V3::zeros(), &V3::zeros()), 1.0)
    }

    fn direction(x: &[V3; 3], sides: [bool; 2]) -> NodeDirection {
        let chords = [chord(&x[0], &x[1]), chord(&x[1], &x[2])];
        let of = |side: usize| sides[side].then_some(&chords[side]);
        NodeDirection::new(of(0), of(1))
    }

    #[test]
    fn derivatives_are_the_finite_differences() {
        let x = [
            V3::new(0.1, -0.4, 0.2),
            V3::new(1.3, 0.5, -0.6),
            V3::new(1.1, 2.9, 0.7),
        ];
        for sides in [[true, true], [true, false], [false, true]] {
            let by = direction(&x, sides).by_positions();
            assert!((direction(&x, sides).d.norm() - 1.0).abs() < 1e-15);
            for node in 0..3 {
                for axis in 0..3 {
                    let moved = |h: f64| {
                        let mut x = x;
                        x[node][axis] += h;
                        direction(&x, sides).d
                    };
                    let column = (moved(1e-6) - moved(-1e-6)) / 2e-6;
                    assert!((column - by[node].column(axis)).norm() < 1e-9, "{sides:?}");
                }
            }
        }
    }

    #[test]
    fn a_line_folded_back_has_the_direction_of_the_segment_after() {
        let x = [V3::zeros(), V3::x(), V3::zeros()];
        let folded = direction(&x, [true, true]);
        assert_eq!(folded, direction(&x, [false, true]));
        assert_eq!(folded.d, -V3::x());
    }
}
