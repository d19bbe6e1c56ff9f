//! A bed that slopes.

use std::fmt::Write;

/// An inclined plane as a grid of depths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::laboratory::invariants) struct Plane {
    /// Over x = y = 0 \[m\].
    pub(in crate::laboratory::invariants) depth: f64,
    /// Change of the depth along x and y \[-\].
    pub(in crate::laboratory::invariants) by_x: f64,
    /// See `by_x`.
    pub(in crate::laboratory::invariants) by_y: f64,
}

impl Plane {
    /// Half of the side of the grid \[m\].
    const REACH: f64 = 4e3;

    /// The CSV file.
    pub(crate) fn text(&self) -> String {
        let mut text = "x_m,y_m,depth_m\n".to_owned();
        for x in [-1.0, 0.0, 1.0].map(|k| k * Self::REACH) {
            for y in [-1.0, 0.0, 1.0].map(|k| k * Self::REACH) {
                let depth = self.depth + self.by_x * x + self.by_y * y;
                // Writing to a string cannot fail.
                let _ = writeln!(text, "{x:?},{y:?},{depth:?}");
            }
        }
        text
    }

    /// The plane of such a file.
    pub(in crate::laboratory::invariants) fn read(text: &str) -> Option<Self> {
        let depth = |x: f64, y: f64| {
            let rows = text.lines().filter_map(|row| {
                let mut numbers = row.split(',').map(str::parse::<f64>);
                let mut next = || numbers.next()?.ok();
                Some((next()?, next()?, next()?))
            });
            let mut rows = rows.filter(|row| row.0 == x && row.1 == y);
            rows.next().map(|row| row.2)
        };
        let middle = depth(0.0, 0.0)?;
        Some(Self {
            depth: middle,
            by_x: (depth(Self::REACH, 0.0)? - middle) / Self::REACH,
            by_y: (depth(0.0, Self::REACH)? - middle) / Self::REACH,
        })
    }

    /// The depth over a place \[m\].
    pub(super) fn at(&self, x: f64, y: f64) -> f64 {
        self.depth + self.by_x * x + self.by_y * y
    }
}
