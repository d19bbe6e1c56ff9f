//! The plot as dots: lines between points, each cell owned by the series drawn last.

use super::clip::{Dot, clip};
use super::decimate::decimate;
use super::picture::{DotAxis, PicturePart, PlotFrame};
use super::{Glyphs, Series, marker};

/// Dots of a broken line: so many on, as many off.
const DASH: usize = 2;

/// Markers along a line are at least this many columns apart.
const MARKER_SPACING: usize = 14;

/// One cell of the plot.
#[derive(Debug, Clone, Copy, Default)]
struct DotCell {
    /// Braille bits, or 1 in ASCII.
    bits: u8,
    /// What the cell's dots belong to.
    ink: PicturePart,
    /// A marker that covers the dots.
    marker: Option<char>,
}

/// The plot as dots.
pub(super) struct DotCanvas {
    frame: PlotFrame,
    glyphs: Glyphs,
    cells: Vec<DotCell>,
}

/// The cells a line passes, in order, without repeats in a row.
pub(super) type DotPath = Vec<(usize, usize)>;

impl DotCanvas {
    pub(super) fn new(frame: PlotFrame, glyphs: Glyphs) -> Self {
        Self {
            frame,
            glyphs,
            cells: vec![DotCell::default(); frame.width * frame.height],
        }
    }

    /// Draws the line of a series over what is there; returns the cells it passes.
    pub(super) fn line(&mut self, series: &Series) -> DotPath {
        let mut pen = Pen {
            ink: ink(series),
            dimmed: series.dimmed && self.glyphs == Glyphs::Braille,
            dots: 0,
            path: Vec::new(),
        };
        let (along, up) = (self.frame.x_scale, self.frame.y_scale);
        for piece in series.points.split(|p| !along.shows(p.0) || !up.shows(p.1)) {
            self.piece(piece, &mut pen);
        }
        pen.path
    }

    /// One unbroken piece of a line; a single point is one dot.
    fn piece(&mut self, points: &[(f64, f64)], pen: &mut Pen) {
        let (nx, ny) = self.frame.dot_count();
        // Far outside, exact places do not matter, only that arithmetic stays finite.
        let far = |v: f64| v.clamp(-1e12, 1e12);
        let along = DotAxis::new(self.frame.x, self.frame.x_scale, nx);
        let up = DotAxis::new(self.frame.y, self.frame.y_scale, ny);
        let dots = points
            .iter()
            .map(|(x, y)| (far(along.dot(*x)), far(up.dot(*y))));
        let dots = decimate(dots);
        if let [only] = dots[..] {
            self.segment(only, only, pen);
        }
        for pair in dots.windows(2) {
            self.segment(pair[0], pair[1], pen);
        }
    }

    /// A straight line between two dots, cut at the plot's edges, by Bresenham.
    fn segment(&mut self, from: Dot, to: Dot, pen: &mut Pen) {
        let (nx, ny) = self.frame.dot_count();
        // Almost half a dot beyond the range still rounds to its last dot.
        let high = (nx as f64 - 0.51, ny as f64 - 0.51);
        let Some((from, to)) = clip(from, to, -0.49, high) else {
            return;
        };
        let whole = |v: f64| v.round() as i64;
        let (mut x, mut y) = (whole(from.0), whole(from.1));
        let (x1, y1) = (whole(to.0), whole(to.1));
        let (dx, dy) = ((x1 - x).abs(), -(y1 - y).abs());
        let (sx, sy) = ((x1 - x).signum(), (y1 - y).signum());
        let mut error = dx + dy;
        loop {
            self.dot(x, y, pen);
            if x == x1 && y == y1 {
                return;
            }
            let twice = 2 * error;
            if twice >= dy {
                error += dy;
                x += sx;
            }
            if twice <= dx {
                error += dx;
                y += sy;
            }
        }
    }

    /// One dot. A cell that belonged to another series is taken over whole: dots of two series in
    /// one cell could only have one colour, which would be wrong for one of them.
    fn dot(&mut self, x: i64, y: i64, pen: &mut Pen) {
        let (nx, ny) = self.frame.dot_count();
        let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y)) else {
            return;
        };
        if x >= nx || y >= ny {
            return;
        }
        let (across, up) = self.frame.dots;
        let (column, row) = (x / across, (ny - 1 - y) / up);
        if pen.path.last() != Some(&(column, row)) {
            pen.path.push((column, row));
        }
        pen.dots += 1;
        if pen.dimmed && (pen.dots / DASH) % 2 == 1 {
            return;
        }
        let cell = &mut self.cells[row * self.frame.width + column];
        if cell.ink != pen.ink {
            *cell = DotCell {
                ink: pen.ink,
                ..DotCell::default()
            };
        }
        cell.bits |= match self.glyphs {
            Glyphs::Braille => braille_bit(x % across, (ny - 1 - y) % up),
            Glyphs::Ascii => 1,
        };
    }

    /// Sets the series' marker along its path, also where another series lies on top, so that lines
    /// that coincide show the markers of both in turn.
    pub(super) fn markers(&mut self, series: &Series, path: &DotPath, turn: usize, of: usize) {
        let spacing = MARKER_SPACING.max(self.frame.width / 5);
        let offset = spacing * (2 * turn + 1) / (2 * of.max(1));
        let mut placed: Vec<(usize, usize)> = Vec::new();
        let Some(start) = path.first() else { return };
        // A short path gets its marker in the middle.
        let reach = path.iter().map(|cell| distance(*cell, *start)).max();
        let short = reach.is_none_or(|reach| reach < offset);
        for (i, cell) in path.iter().enumerate() {
            let due = match placed.last() {
                None if short => i >= path.len() / 2,
                None => distance(*cell, *start) >= offset,
                Some(_) => placed.iter().all(|p| distance(*cell, *p) >= spacing),
            };
            let taken = &mut self.cells[cell.1 * self.frame.width + cell.0];
            if due && taken.marker.is_none() {
                taken.marker = Some(marker(series.slot));
                taken.ink = ink(series);
                placed.push(*cell);
            }
        }
    }

    /// What is drawn in a cell, if anything.
    pub(super) fn get(&self, column: usize, row: usize) -> Option<(char, PicturePart)> {
        let cell = self.cells.get(row * self.frame.width + column)?;
        let ch = match (cell.marker, self.glyphs, cell.ink) {
            (Some(marker), _, _) => marker,
            (None, _, _) if cell.bits == 0 => return None,
            (None, Glyphs::Braille, _) => char::from_u32(0x2800 + u32::from(cell.bits))?,
            (None, Glyphs::Ascii, PicturePart::Series(slot)) => marker(slot),
            (None, Glyphs::Ascii, _) => '.',
        };
        Some((ch, cell.ink))
    }
}

/// How a line is being drawn.
struct Pen {
    ink: PicturePart,
    /// Broken.
    dimmed: bool,
    /// Dots passed so far, drawn or not.
    dots: usize,
    path: DotPath,
}

/// The ink of a series.
pub(super) fn ink(series: &Series) -> PicturePart {
    if series.dimmed {
        PicturePart::Dimmed(series.slot)
    } else {
        PicturePart::Series(series.slot)
    }
}

/// Distance of two cells in columns; a cell is twice as tall as it is wide.
fn distance(a: (usize, usize), b: (usize, usize)) -> usize {
    a.0.abs_diff(b.0).max(2 * a.1.abs_diff(b.1))
}

/// The bit of a braille character for the dot at this column (0, 1) and row (0 at the top).
pub(super) fn braille_bit(column: usize, row: usize) -> u8 {
    const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
    BITS[row % 4][column % 2]
}
