//! The motion of what a mooring is coupled to, from a table of time and coordinates.

use crate::visible;
use std::path::Path;

use super::case_text::{CaseText, number, numbers};
use crate::files::read;
use crate::import::mooring::{Hold, Mooring};
use crate::numerics::V3;
use crate::system::pose::Pose;

/// Greatest distance \[m\] of the first row from the places in the file, for coordinates to be those of the parts.
const NEAR: f64 = 0.5;

/// What a column of coordinates belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum CoupledPart {
    Body(usize),
    Rod(usize),
    /// The end A of a rod that is pinned.
    PinnedRod(usize),
    Point(usize),
}

/// How the columns are laid out.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Layout {
    /// Nothing moves.
    Still,
    /// Six motions of the whole about its origin.
    Vessel,
    /// The coordinates of each coupled part, from this column on.
    Each(Vec<(CoupledPart, usize)>),
}

/// The motion of coupled parts.
#[derive(Debug, Clone, PartialEq)]
pub struct CoupledMotion {
    layout: Layout,
    /// Times from 0 \[s\].
    times: Vec<f64>,
    /// Columns behind the time: m and degrees.
    columns: Vec<Vec<f64>>,
    /// What was put down about it.
    pub remarks: Vec<String>,
}

impl CoupledMotion {
    /// Nothing moves.
    #[must_use]
    pub fn none() -> Self {
        Self {
            layout: Layout::Still,
            times: Vec::new(),
            columns: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// The motion in a file: a row for each time, with blanks or commas between; a first row may name the columns.
    ///
    /// # Errors
    /// The file cannot be read, has other columns than the coupled parts, or times that do not rise.
    pub fn read(path: &Path, mooring: &Mooring) -> Result<Self, String> {
        let file = visible::path(path);
        let text = read::text(path).map_err(|error| format!("{file} cannot be read: {error}"))?;
        let (heads, rows) = table(&text).map_err(|why| format!("{file}, {why}"))?;
        let Some(width) = rows.first().map(Vec::len) else {
            return Err(format!("{file} has no rows of numbers"));
        };
        let parts = coupled(mooring);
        let layout = layout(&parts, mooring, &rows[0], width - 1).ok_or_else(|| {
            let each: usize = parts.iter().map(|part| degrees(*part)).sum();
            format!(
                "{file} has {width} columns; there are {each} coupled coordinates, so it needs the time and {each} columns, or the time and the 6 \
                 motions of the whole"
            )
        })?;
        let start = rows[0][0];
        let times: Vec<f64> = rows.iter().map(|row| row[0] - start).collect();
        if let Some(at) = times.windows(2).position(|pair| pair[1] <= pair[0]) {
            return Err(format!(
                "{file}: the time {} in row {} does not rise",
                rows[at + 1][0],
                at + 2
            ));
        }
        let columns = (1..width).map(|column| rows.iter().map(|row| row[column]).collect());
        let mut motion = Self {
            layout,
            times,
            columns: columns.collect(),
            remarks: Vec::new(),
        };
        motion.angles_in_degrees(&heads);
        if start != 0.0 {
            motion.remarks.push(format!(
                "The table of the motion begins at {start} s; times here are from its beginning."
            ));
        }
        Ok(motion)
    }

    /// Whether coupled parts move.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.layout != Layout::Still
    }

    /// Whether the whole moves as one body.
    #[must_use]
    pub fn is_of_one_body(&self) -> bool {
        self.layout == Layout::Vessel
    }

    /// Whether parts move by themselves.
    #[must_use]
    pub fn is_of_each(&self) -> bool {
        matches!(self.layout, Layout::Each(_))
    }

    /// Writes the motion of the whole.
    pub fn write_vessel(&self, case: &mut CaseText<'_>) {
        if self.is_of_one_body() {
            self.write_table(case, 0, [0.0; 6]);
        }
    }

    /// Writes the motion of a body; of one that is pinned that of its origin.
    pub fn write_body(&self, case: &mut CaseText<'_>, body: usize, is_pinned: bool) {
        match &self.layout {
            Layout::Vessel => self.write_table(case, 0, [0.0; 6]),
            Layout::Each(_) => {
                let Some((first, rest)) = self.start_of_part(CoupledPart::Body(body)) else {
                    return;
                };
                match is_pinned {
                    true => self.write_places(case, first, rest),
                    false => self.write_table(case, first, rest),
                }
            }
            Layout::Still => {}
        }
    }

    /// Writes the motion of a point.
    pub fn write_point(&self, case: &mut CaseText<'_>, point: usize) {
        if let Some((first, rest)) = self.start_of_part(CoupledPart::Point(point)) {
            self.write_places(case, first, rest);
        }
    }

    /// Writes the motion of a place.
    fn write_places(&self, case: &mut CaseText<'_>, first: usize, rest: [f64; 6]) {
        case.assumed(
            "table_time_s",
            &numbers(&self.times),
            "the table of the motion",
        );
        for (axis, name) in ["x", "y", "z"].iter().enumerate() {
            self.write_column(case, &format!("table_{name}_m"), first + axis, rest[axis]);
        }
    }

    /// Writes the run in time.
    pub fn write_run(&self, case: &mut CaseText<'_>) {
        let Some(duration) = self.times.last().filter(|_| self.moves()) else {
            return;
        };
        case.table("[solver]", None);
        case.assumed("duration_s", &number(*duration), "the table of the motion");
    }

    /// The first column of a part, and where the part is at first, which its table is relative to.
    fn start_of_part(&self, part: CoupledPart) -> Option<(usize, [f64; 6])> {
        let Layout::Each(parts) = &self.layout else {
            return None;
        };
        let (_, first) = parts.iter().find(|(known, _)| *known == part)?;
        let at = |column: usize| self.columns.get(first + column).map_or(0.0, |all| all[0]);
        let count = degrees(part);
        let rest = std::array::from_fn(|axis| if axis < count { at(axis) } else { 0.0 });
        Some((*first, rest))
    }

    fn write_table(&self, case: &mut CaseText<'_>, first: usize, rest: [f64; 6]) {
        case.assumed(
            "table_time_s",
            &numbers(&self.times),
            "the table of the motion",
        );
        let keys = ["x_m", "y_m", "z_m", "roll_deg", "pitch_deg", "yaw_deg"];
        for (axis, key) in keys.iter().enumerate() {
            self.write_column(case, &format!("table_{key}"), first + axis, rest[axis]);
        }
    }

    fn write_column(&self, case: &mut CaseText<'_>, key: &str, column: usize, rest: f64) {
        let values: Vec<f64> = self.columns[column]
            .iter()
            .map(|value| value - rest)
            .collect();
        if values.iter().any(|value| *value != 0.0) {
            case.line(&format!("{key} = {}", numbers(&values)), None);
        }
    }

    /// Turns angles that are in radians into degrees.
    fn angles_in_degrees(&mut self, heads: &[String]) {
        let in_degrees = heads.iter().any(|head| head.to_lowercase().contains("deg"));
        let angles: Vec<usize> = match &self.layout {
            Layout::Still => Vec::new(),
            Layout::Vessel => vec![3, 4, 5],
            Layout::Each(parts) => parts
                .iter()
                .filter(|(part, _)| degrees(*part) == 6)
                .flat_map(|(_, first)| first + 3..first + 6)
                .collect(),
        };
        if angles.is_empty() {
            return;
        }
        if in_degrees {
            return self.angles_yaw_first(&angles);
        }
        let mut turns = false;
        for column in &angles {
            for value in &mut self.columns[*column] {
                turns |= *value != 0.0;
                *value = value.to_degrees();
            }
        }
        self.angles_yaw_first(&angles);
        if turns {
            self.remarks.push(
                "Angles of the table of the motion are taken in radians; a head with `deg` says otherwise."
                    .to_owned(),
            );
        }
    }
}

impl CoupledMotion {
    /// Turns the angles in these columns \[deg\], three a body, from roll first, as MoorDyn takes them, into yaw first.
    fn angles_yaw_first(&mut self, columns: &[usize]) {
        for three in columns.chunks_exact(3) {
            let &[roll, pitch, yaw] = three else { continue };
            for row in 0..self.times.len() {
                let given = [roll, pitch, yaw].map(|column| self.columns[column][row]);
                if given.iter().filter(|angle| **angle != 0.0).count() < 2 {
                    continue;
                }
                let pose = Pose::of_roll_first(V3::zeros(), given.map(f64::to_radians));
                let angles = pose.angles().map(f64::to_degrees);
                for (column, angle) in three.iter().zip(angles) {
                    self.columns[*column][row] = angle;
                }
            }
        }
    }
}

/// Coupled coordinates of a part.
fn degrees(part: CoupledPart) -> usize {
    match part {
        CoupledPart::Body(_) | CoupledPart::Rod(_) => 6,
        CoupledPart::PinnedRod(_) | CoupledPart::Point(_) => 3,
    }
}

/// Coupled parts in the order of MoorDyn: bodies, rods, points.
fn coupled(mooring: &Mooring) -> Vec<CoupledPart> {
    let bodies = mooring.bodies.iter().enumerate();
    let bodies = bodies.filter(|(_, body)| body.hold.value.is_coupled());
    let rods = mooring.rods.iter().enumerate();
    let rods = rods.filter(|(_, rod)| rod.hold.value.is_coupled());
    let points = mooring.points.iter().enumerate();
    let points = points.filter(|(_, point)| point.hold.value == Hold::Coupled);
    bodies
        .map(|(number, _)| CoupledPart::Body(number))
        .chain(rods.map(|(number, rod)| match rod.hold.value {
            Hold::Coupled => CoupledPart::Rod(number),
            _ => CoupledPart::PinnedRod(number),
        }))
        .chain(points.map(|(number, _)| CoupledPart::Point(number)))
        .collect()
}

/// The layout of so many columns; by the first row where both would do.
fn layout(parts: &[CoupledPart], mooring: &Mooring, first: &[f64], count: usize) -> Option<Layout> {
    if parts.is_empty() {
        return None;
    }
    let mut column = 0;
    let mut each = Vec::new();
    for part in parts {
        each.push((*part, column));
        column += degrees(*part);
    }
    let fits = column == count;
    let is_near = |(part, column): &(CoupledPart, usize)| {
        let place = match part {
            CoupledPart::Body(body) => &mooring.bodies[*body].place,
            CoupledPart::Rod(rod) | CoupledPart::PinnedRod(rod) => &mooring.rods[*rod].ends[0],
            CoupledPart::Point(point) => &mooring.points[*point].place,
        };
        let here = first.get(1 + column..4 + column);
        here.is_some_and(|here| {
            let pairs = here.iter().zip(place);
            pairs.fold(0.0_f64, |worst, (here, place)| {
                worst.max((here - place.value).abs())
            }) < NEAR
        })
    };
    match (fits, count == 6) {
        (true, true) if !each.iter().all(is_near) => Some(Layout::Vessel),
        (true, _) => Some(Layout::Each(each)),
        (false, true) => Some(Layout::Vessel),
        (false, false) => None,
    }
}

/// The names of the columns, if any, and the rows.
fn table(text: &str) -> Result<(Vec<String>, Vec<Vec<f64>>), String> {
    let mut heads = Vec::new();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let text = text.trim_start_matches('\u{feff}');
    for (line, row) in text.lines().enumerate() {
        let words: Vec<&str> = row
            .split(|letter: char| letter.is_whitespace() || letter == ',' || letter == ';')
            .filter(|word| !word.is_empty())
            .collect();
        if words.is_empty() || words[0].starts_with('#') {
            continue;
        }
        let numbers: Option<Vec<f64>> = words
            .iter()
            .map(|word| word.parse().ok().filter(|value: &f64| value.is_finite()))
            .collect();
        match numbers {
            Some(numbers) => {
                if rows
                    .first()
                    .is_some_and(|first| first.len() != numbers.len())
                {
                    let first = rows[0].len();
                    return Err(format!(
                        "line {}: {} columns where the first row has {first}",
                        line + 1,
                        numbers.len()
                    ));
                }
                rows.push(numbers);
            }
            None if rows.is_empty() => heads = words.iter().map(|&word| word.to_owned()).collect(),
            None => {
                return Err(format!(
                    "line {}: `{}` is not a row of numbers",
                    line + 1,
                    row.trim()
                ));
            }
        }
    }
    Ok((heads, rows))
}
