//! A field over both axes of a plot: the darker a place, the greater the value there. Least and greatest shade mean
//! values of the same size and opposite sign, so that crests are dark, troughs light and what rests is between them; inks
//! repeat the sign where there is colour.

use super::picture::{Picture, PicturePart, PlotFrame};
use super::{Axis, AxisScale, Glyphs};
use crate::number;

/// Values on a grid; between its points they are interpolated along both axes as these are drawn.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct GridMap {
    /// Places along the x axis, increasing.
    pub x: Vec<f64>,
    /// Places along the y axis, increasing.
    pub y: Vec<f64>,
    /// Values, all those of the first x first: as many as both axes have points.
    pub values: Vec<f64>,
    /// What the values are, and their unit; the darkest shade means the upper end of the range, where there is one, and
    /// for all beyond it.
    pub of: Axis,
}

/// Shades in ASCII, from the least value to the greatest.
const RAMP: &[u8; 10] = b" .:-=+*#%@";
/// Order in which the dots of four by four are set as a shade darkens (Bayer 1973).
const ORDER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
/// Cells of the scale beside the name of the y axis.
const SCALE: usize = 10;

impl GridMap {
    /// The value at a place on axes of these scales; nothing outside the grid, or where the values around are not finite.
    #[must_use]
    pub fn at(&self, (x, along): (f64, AxisScale), (y, up): (f64, AxisScale)) -> Option<f64> {
        let x = bracket(&places(&self.x, along), along.place(x))?;
        let y = bracket(&places(&self.y, up), up.place(y))?;
        self.between(x, y)
    }

    /// What the darkest shade means: the greatest size of any value unless the map says otherwise.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        let sizes = self.values.iter().map(|v| v.abs());
        let most = sizes.filter(|v| v.is_finite()).fold(0.0, f64::max);
        self.of.range.map_or(most, |range| range.1)
    }

    /// The grid as CSV, every digit kept: a row an x, a column a y.
    #[must_use]
    pub fn csv(&self) -> String {
        let heads = self
            .y
            .iter()
            .map(|y| format!(",{} [{}] at {y}", self.of.label, self.of.unit));
        let mut text = format!("x{}\n", heads.collect::<String>());
        for (x, row) in self.x.iter().zip(self.values.chunks(self.y.len().max(1))) {
            let values: String = row.iter().map(|v| format!(",{v}")).collect();
            text.push_str(&format!("{x}{values}\n"));
        }
        text
    }

    fn between(&self, (i, across): (usize, f64), (j, up): (usize, f64)) -> Option<f64> {
        let value = |i: usize, j: usize| self.values.get(i * self.y.len() + j).copied();
        let column = |i: usize| {
            let low = value(i, j)?;
            // A grid of one row is read there.
            let high = if up > 0.0 { value(i, j + 1)? } else { low };
            Some(low + up * (high - low))
        };
        let left = column(i)?;
        let right = if across > 0.0 { column(i + 1)? } else { left };
        Some(left + across * (right - left)).filter(|v| v.is_finite())
    }

    /// Shades the plot.
    pub(super) fn draw(&self, frame: PlotFrame, glyphs: Glyphs, on: &mut Picture) {
        let (nx, ny) = frame.dot_count();
        let spread = |range: (f64, f64), scale: AxisScale, n: usize, grid: &[f64]| {
            let (from, to) = scale.places(range);
            let step = (to - from) / (n.max(2) - 1) as f64;
            let grid = places(grid, scale);
            let dots = (0..n).map(|i| bracket(&grid, from + step * i as f64));
            dots.collect::<Vec<Option<(usize, f64)>>>()
        };
        let along = spread(frame.x, frame.x_scale, nx, &self.x);
        let up = spread(frame.y, frame.y_scale, ny, &self.y);
        let whole = self.greatest();
        let level = |column: usize, dot: usize| {
            let value = self.between((*along.get(column)?)?, (*up.get(dot)?)?)?;
            Some(level(value, whole))
        };
        let (wide, tall) = frame.dots;
        for row in 0..frame.height {
            for column in 0..frame.width {
                let dots = (0..tall).flat_map(|r| (0..wide).map(move |c| (c, r)));
                // Rows count from the top, dots of the frame from below.
                let levels = dots.map(|(c, r)| level(column * wide + c, ny - 1 - row * tall - r));
                let levels: Vec<Option<f64>> = levels.collect();
                let known: Vec<f64> = levels.iter().copied().flatten().collect();
                if known.is_empty() {
                    continue;
                }
                let mean = known.iter().sum::<f64>() / known.len() as f64;
                let ch = match glyphs {
                    Glyphs::Ascii => letter(mean),
                    Glyphs::Braille => dithered(&levels, (column * wide, row * tall)),
                };
                on.put(frame.left + column, frame.top + row, ch, ink(mean));
            }
        }
    }

    /// Writes the scale from a column on, where there is room: least value, shades, greatest value.
    pub(super) fn scale(&self, column: usize, row: usize, glyphs: Glyphs, on: &mut Picture) {
        let whole = self.greatest();
        let name = format!("{} {}", self.of.label, number::si(-whole, &self.of.unit));
        let end = number::si(whole, &self.of.unit);
        if column + name.chars().count() + SCALE + end.chars().count() + 2 > on.width {
            return;
        }
        let mut at = on.write(column, row, &name, PicturePart::Legend) + 1;
        for cell in 0..SCALE {
            let level = (cell as f64 + 0.5) / SCALE as f64;
            let ch = match glyphs {
                Glyphs::Ascii => letter(level),
                Glyphs::Braille => dithered(&[Some(level); 8], (2 * cell, 0)),
            };
            on.put(at, row, ch, ink(level));
            at += 1;
        }
        on.write(at + 1, row, &end, PicturePart::Legend);
    }
}

/// Where the points of a grid lie along an axis of this scale.
fn places(grid: &[f64], scale: AxisScale) -> Vec<f64> {
    grid.iter().map(|value| scale.place(*value)).collect()
}

/// Between which points of a grid a place lies, as the number of the first and the part of the way to the next.
fn bracket(grid: &[f64], place: f64) -> Option<(usize, f64)> {
    let (first, last) = (*grid.first()?, *grid.last()?);
    // Ranges are rounded: their ends belong to the grid.
    let slop = 1e-9 * (last - first).abs();
    if !(first - slop..=last + slop).contains(&place) {
        return None;
    }
    let after = grid.partition_point(|g| *g <= place).min(grid.len() - 1);
    let Some(before) = after.checked_sub(1) else {
        return Some((0, 0.0));
    };
    let part = (place - grid[before]) / (grid[after] - grid[before]);
    Some((before, part.clamp(0.0, 1.0)))
}

/// From 0 for the least value to 1 for the greatest.
fn level(value: f64, greatest: f64) -> f64 {
    if greatest > 0.0 {
        0.5 * (1.0 + (value / greatest).clamp(-1.0, 1.0))
    } else {
        0.5
    }
}

fn letter(level: f64) -> char {
    let steps = RAMP.len();
    let step = ((level * steps as f64) as usize).min(steps - 1);
    char::from(RAMP[step])
}

/// A braille character with as many of its dots as its levels ask for; `corner` is its upper left dot in the plot.
fn dithered(levels: &[Option<f64>], corner: (usize, usize)) -> char {
    let mut bits = 0;
    for (i, level) in levels.iter().enumerate() {
        let (column, row) = (i % 2, i / 2);
        let order = ORDER[(corner.1 + row) % 4][(corner.0 + column) % 4];
        let threshold = (f64::from(order) + 0.5) / 16.0;
        if level.is_some_and(|level| level > threshold) {
            bits |= super::canvas::braille_bit(column, row);
        }
    }
    char::from_u32(0x2800 + u32::from(bits)).unwrap_or(' ')
}

fn ink(level: f64) -> PicturePart {
    PicturePart::Shade(match level {
        l if l < 0.2 => -2,
        l if l < 0.4 => -1,
        l if l < 0.6 => 0,
        l if l < 0.8 => 1,
        _ => 2,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn saddle() -> GridMap {
        GridMap {
            x: vec![0.0, 1.0, 3.0],
            y: vec![0.0, 2.0],
            values: vec![0.0, 2.0, 1.0, 4.0, -3.0, f64::NAN],
            of: Axis::new("displacement", "m"),
        }
    }

    #[test]
    fn values_are_read_between_the_points() {
        let map = saddle();
        let at = |map: &GridMap, x, y| map.at((x, AxisScale::Linear), (y, AxisScale::Linear));
        assert_eq!(at(&map, 0.0, 1.0), Some(1.0));
        assert_eq!(at(&map, 0.5, 2.0), Some(3.0));
        assert_eq!(at(&map, 2.0, 0.0), Some(-1.0));
        assert_eq!(at(&map, 3.0, 2.0), None);
        assert_eq!(at(&map, 3.1, 0.0), None);
        assert!((map.greatest() - 4.0).abs() < 1e-15);
        let row = GridMap {
            x: vec![0.0, 1.0],
            y: vec![5.0],
            values: vec![1.0, 2.0],
            ..GridMap::default()
        };
        assert_eq!(at(&row, 0.5, 5.0), Some(1.5));
        assert_eq!(at(&GridMap::default(), 0.0, 0.0), None);
    }

    #[test]
    fn on_a_logarithmic_axis_the_middle_is_the_geometric_mean() {
        let map = GridMap {
            x: vec![1.0, 100.0],
            y: vec![0.0, 1.0],
            values: vec![1.0, 1.0, 3.0, 3.0],
            ..GridMap::default()
        };
        let found = map.at((10.0, AxisScale::Log), (0.5, AxisScale::Linear));
        assert!((found.unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(
            map.at((-1.0, AxisScale::Log), (0.5, AxisScale::Linear)),
            None
        );
    }

    #[test]
    fn shades_darken_with_the_value() {
        let dots = |level: f64| {
            let ch = u32::from(dithered(&[Some(level); 8], (0, 0)));
            (ch - 0x2800).count_ones()
        };
        let counts: Vec<u32> = (0..=10).map(|i| dots(f64::from(i) / 10.0)).collect();
        assert!(counts.is_sorted() && counts[0] == 0 && counts[10] == 8);
        let letters: String = (0..=10).map(|i| letter(f64::from(i) / 10.0)).collect();
        assert_eq!(letters, " .:-=+*#%@@");
    }
}
