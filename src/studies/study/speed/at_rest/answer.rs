//! The answer of a scene at rest in one way, and how far it is from another.

use crate::numerics::V3;

/// What a scene at rest comes to in one way, and what it took.
#[derive(Debug, Clone)]
pub struct RestAnswer {
    /// Its results by name.
    pub results: Vec<RestResult>,
    /// Places along its lines \[m\], each at a share of the unstretched length from A.
    pub lines: Vec<Vec<(f64, V3)>>,
    /// Unstretched length of the longest line \[m\].
    pub length_m: f64,
    /// CPU time \[s\].
    pub cpu_s: f64,
    /// Newton steps: of the system or, of a line by itself, of its nodes.
    pub steps: u64,
    /// Solutions of a line between its ends.
    pub solutions: u64,
    /// Newton iterations of lines in segments, each by its segments.
    pub work: u64,
    /// Segments in all.
    pub segments: usize,
}

/// A result by name.
#[derive(Debug, Clone, PartialEq)]
pub struct RestResult {
    /// Its name.
    pub name: String,
    /// Its unit: N or m.
    pub unit: &'static str,
    /// Its value.
    pub value: f64,
}

/// Errors against a reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestErrors {
    /// The greatest of a force by the greatest tension \[-\].
    pub tension: f64,
    /// The greatest of a place by the length of the longest line \[-\], results and nodes of lines together.
    pub place: f64,
    /// The same \[m\].
    pub place_m: f64,
}

impl RestErrors {
    /// The greater share.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        self.tension.max(self.place)
    }
}

impl RestAnswer {
    /// The errors of this by a reference.
    #[must_use]
    pub fn errors(&self, reference: &Self) -> RestErrors {
        let of_unit = |unit: &str| {
            let own = self.results.iter().filter(|result| result.unit == unit);
            let apart = own.filter_map(|own| Some((own.value - reference.value(&own.name)?).abs()));
            apart.fold(0.0, f64::max)
        };
        let along = self.lines.iter().zip(&reference.lines);
        let along = along.flat_map(|(own, finer)| {
            own.iter()
                .map(|(share, place)| (place - at(finer, *share)).norm())
        });
        let place_m = along.fold(of_unit("m"), f64::max);
        RestErrors {
            tension: of_unit("N") / reference.scale("N"),
            place: place_m / reference.scale("m"),
            place_m,
        }
    }

    /// The value of a result.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<f64> {
        let found = self.results.iter().find(|result| result.name == name);
        found.map(|result| result.value)
    }

    /// What results in a unit are a share of: the greatest force \[N\], the length of the longest line \[m\].
    #[must_use]
    pub fn scale(&self, unit: &str) -> f64 {
        let own = self.results.iter().filter(|result| result.unit == unit);
        let greatest = match unit {
            "m" => self.length_m,
            _ => own.map(|result| result.value.abs()).fold(0.0, f64::max),
        };
        greatest.max(f64::MIN_POSITIVE)
    }
}

/// A place of a line at a share of its length, on the chord between nodes.
fn at(nodes: &[(f64, V3)], share: f64) -> V3 {
    let next = nodes.partition_point(|(at, _)| *at < share);
    match (nodes.get(next.wrapping_sub(1)), nodes.get(next)) {
        (Some((from, a)), Some((to, b))) if to > from => a.lerp(b, (share - from) / (to - from)),
        (_, Some((_, only))) | (Some((_, only)), _) => *only,
        (None, None) => V3::zeros(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(tension: f64, nodes: &[(f64, V3)]) -> RestAnswer {
        RestAnswer {
            results: vec![RestResult {
                name: "tension".to_owned(),
                unit: "N",
                value: tension,
            }],
            lines: vec![nodes.to_vec()],
            length_m: 50.0,
            cpu_s: 0.0,
            steps: 0,
            solutions: 0,
            work: 0,
            segments: 0,
        }
    }

    #[test]
    fn places_are_compared_at_the_nodes_of_the_coarser_mesh() {
        let finer = [0.0, 5.0, 8.0].map(|z| V3::new(0.0, 0.0, z));
        let finer: Vec<(f64, V3)> = [0.0, 0.5, 1.0].into_iter().zip(finer).collect();
        let coarse = [(0.0, V3::zeros()), (1.0, V3::new(0.0, 0.0, 7.0))];
        let errors = answer(90.0, &coarse).errors(&answer(100.0, &finer));
        assert_eq!(errors.tension, 0.1);
        assert_eq!((errors.place_m, errors.place), (1.0, 0.02));
        assert_eq!(errors.greatest(), 0.1);
        assert_eq!(at(&finer, 0.75), V3::new(0.0, 0.0, 6.5));
    }
}
