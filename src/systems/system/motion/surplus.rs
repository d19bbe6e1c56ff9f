//! What meshing an end anew leaves too much in its segment.
//!
//! Straight segments are shorter than what hangs between: of one segment less a line has a little slack, of one more it lacks a little. In
//! a stiff line that is many times its tension, and it would snap. The end segment is therefore as long as leaves the tension as it was, and
//! comes to the length that is paid out as it runs on by the length of a segment, out or in.

use serde::{Deserialize, Serialize};

/// What meshing left too much in an end segment.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Surplus {
    /// Length just after \[m\], negative where it lacks it.
    length: f64,
    /// What was paid out then \[m\].
    since: f64,
}

/// Greatest surplus by the length of the mesh: what was bent further becomes slack.
const MOST: f64 = 0.1;

impl Surplus {
    /// With so much paid out \[m\], at an end with segments of this length \[m\].
    pub(super) fn new(length: f64, since: f64, mesh: f64) -> Self {
        let most = MOST * mesh;
        Self {
            length: length.clamp(-most, most),
            since,
        }
    }

    /// What is left of it \[m\], its rate and the rate of that, by those of what is paid out.
    pub(super) fn at(&self, [out, rate, acceleration]: [f64; 3], mesh: f64) -> [f64; 3] {
        let way = out - self.since;
        let run = way.abs() / mesh;
        if run >= 1.0 || self.length == 0.0 {
            return [0.0; 3];
        }
        let left = 1.0 - run.powi(3) * (10.0 - run * (15.0 - 6.0 * run));
        let slope = -30.0 * (run * (1.0 - run)).powi(2) * way.signum() / mesh;
        let curvature = -60.0 * run * (1.0 - run) * (1.0 - 2.0 * run) / (mesh * mesh);
        let rates = [
            left,
            slope * rate,
            slope * acceleration + curvature * rate * rate,
        ];
        rates.map(|part| self.length * part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_runs_off_smoothly_over_a_segment_either_way() {
        let (mesh, since, h) = (2.0, 3.0, 1e-4);
        let surplus = Surplus::new(0.01, since, mesh);
        for way in [-1.0, 1.0] {
            let left = |out: f64| surplus.at([since + way * out, way, 0.0], mesh);
            assert_eq!(left(0.0), [0.01, 0.0, 0.0]);
            assert_eq!(left(mesh), [0.0; 3]);
            for out in [0.3, 1.0, 1.7] {
                let [before, now, after] = [out - h, out, out + h].map(left);
                assert!(((after[0] - before[0]) / (2.0 * h) - now[1]).abs() < 1e-9);
                assert!(((after[1] - before[1]) / (2.0 * h) - now[2]).abs() < 1e-9);
            }
        }
        assert_eq!(
            Surplus::new(1.0, 0.0, mesh).at([0.0; 3], mesh)[0],
            MOST * mesh
        );
    }
}
