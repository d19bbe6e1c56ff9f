//! Fewer points, the same picture: what falls into one column of dots is reduced to where it comes
//! in, its lowest, its highest and where it goes out. A peak one sample wide stays.

use super::clip::Dot;

/// Neighbouring dots of one column.
#[derive(Debug, Clone, Copy)]
struct DotColumn {
    number: f64,
    first: Dot,
    /// Lowest and highest, each with its place in the order of points.
    low: (usize, Dot),
    high: (usize, Dot),
    last: (usize, Dot),
}

impl DotColumn {
    fn begin(dot: Dot) -> Self {
        Self {
            number: dot.0.round(),
            first: dot,
            low: (0, dot),
            high: (0, dot),
            last: (0, dot),
        }
    }

    fn add(&mut self, dot: Dot) {
        let order = self.last.0 + 1;
        self.last = (order, dot);
        if dot.1 < self.low.1.1 {
            self.low = (order, dot);
        }
        if dot.1 > self.high.1.1 {
            self.high = (order, dot);
        }
    }

    /// What is kept, in the order of the points, each once.
    fn keep(&self, into: &mut Vec<Dot>) {
        into.push(self.first);
        let (early, late) = if self.low.0 <= self.high.0 {
            (self.low, self.high)
        } else {
            (self.high, self.low)
        };
        let mut before = 0;
        for (order, dot) in [early, late, self.last] {
            if order > before {
                into.push(dot);
                before = order;
            }
        }
    }
}

/// The dots reduced column by column; the line through them covers the same dots.
pub(super) fn decimate(dots: impl Iterator<Item = Dot>) -> Vec<Dot> {
    let mut kept = Vec::new();
    let mut column: Option<DotColumn> = None;
    for dot in dots {
        match &mut column {
            Some(open) if same(open.number, dot.0.round()) => open.add(dot),
            _ => {
                if let Some(done) = column.replace(DotColumn::begin(dot)) {
                    done.keep(&mut kept);
                }
            }
        }
    }
    if let Some(done) = column {
        done.keep(&mut kept);
    }
    kept
}

/// Column numbers are whole, so half is a safe distance.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_high_sample_survives() {
        let dots = (0..10_000).map(|i| (f64::from(i) * 0.01, if i == 5_000 { 9.0 } else { 0.0 }));
        let kept = decimate(dots);
        assert!(kept.len() <= 4 * 101, "{}", kept.len());
        assert!(kept.iter().any(|dot| dot.1 > 8.0));
    }

    #[test]
    fn order_is_kept_and_nothing_comes_twice() {
        let dots = [(0.0, 1.0), (0.1, 5.0), (0.2, -2.0), (0.3, 0.0), (1.0, 4.0)];
        assert_eq!(decimate(dots.into_iter()), dots);
        let dots = [(0.0, 1.0), (0.1, 2.0), (0.2, 3.0)];
        assert_eq!(decimate(dots.into_iter()), [(0.0, 1.0), (0.2, 3.0)]);
    }
}
