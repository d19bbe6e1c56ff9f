//! The file of a current over time and place.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::attachments::{FileSource, PlacedNumber, placed, without_mark};
use super::current_formats::{CurrentRow, foreign_current};
use super::diagnostic::{Diagnostic, Finding};
use super::model::{Attachment, Current};
use crate::numerics::V3;
use crate::physics::CurrentGrid;
use crate::work_log::{self, Task};

/// Columns of a table of the current over time and place; those that it does not change with are left out.
const PLACES: [&str; 4] = ["t_s", "x_m", "y_m", "z_m"];
/// Columns of its velocity; the last may be left out.
const VELOCITY: [&str; 3] = ["u_m_per_s", "v_m_per_s", "w_m_per_s"];

/// Times and places are within these \[s, m\], velocities within these \[m/s\], as those of the keys are.
const FARTHEST: f64 = 1e9;
const FASTEST: f64 = 20.0;

/// The current of a file that is named, from the files that the case carries; nothing where none is named.
///
/// # Errors
/// The file is not carried, has a fault, or its times and places make no rectangular grid.
pub fn current_grid(
    current: &Current,
    files: &BTreeMap<String, Attachment>,
) -> Result<Option<Arc<CurrentGrid>>, Diagnostic> {
    let Some(name) = &current.file else {
        return Ok(None);
    };
    let Some(file) = files.get(name) else {
        return Err(Diagnostic::whole_file(
            name,
            "is not there",
            "name a file of the current beside the case",
        ));
    };
    grid_of(file, name).map(Some)
}

/// The grid of a carried file, which is parsed once.
fn grid_of(carried: &Attachment, file: &str) -> Result<Arc<CurrentGrid>, Diagnostic> {
    carried.text.parsed((), |text| read_current(text, file))
}

/// Reads a file of the current: a table, or a file of MoorDyn.
///
/// # Errors
/// The first fault, with its line and column.
pub fn read_current(text: &str, file: &str) -> Result<CurrentGrid, Diagnostic> {
    work_log::log(Task::Parse, file);
    let rows = match head(text) {
        Some(columns) => of_table(placed(text, file, &columns)?, &columns),
        None => foreign_current(text).map_err(|fault| fault.at(file, text))?,
    };
    for (at, velocity) in &rows {
        let far = at.iter().map(|number| (number, FARTHEST, "is too far"));
        let fast = velocity
            .iter()
            .map(|number| (number, FASTEST, "is too fast, in m/s"));
        for (number, most, what) in far.chain(fast) {
            if number.value.abs() > most {
                let problem = format!("{} {what}", number.value);
                let remedy = format!("give numbers from -{most} to {most}");
                return Err(Finding::new(&number.span, "", problem, remedy).at(file, text));
            }
        }
    }
    let numbers: Vec<([f64; 4], V3)> = rows
        .iter()
        .map(|(at, velocity)| {
            let velocity = V3::from_fn(|k, _| velocity[k].value);
            ([0, 1, 2, 3].map(|k: usize| at[k].value), velocity)
        })
        .collect();
    CurrentGrid::of_rows(&numbers).map_err(|error| {
        Diagnostic::whole_file(
            file,
            format!("makes no grid: {error}"),
            "give a velocity for every time at every place, each once",
        )
    })
}

/// The columns that the first line of a table names, in their order here; nothing where it is no table with names.
fn head(text: &str) -> Option<Vec<String>> {
    let (_, text) = without_mark(text);
    let mut lines = text.lines().map(str::trim);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with('#'))?;
    let names: Vec<&str> = first.split(',').map(str::trim).collect();
    let known = PLACES.iter().chain(&VELOCITY).copied();
    if !known.clone().any(|name| names.contains(&name)) {
        return None;
    }
    let needed = |name: &str| name == VELOCITY[0] || name == VELOCITY[1];
    let columns = known.filter(|name| names.contains(name) || needed(name));
    Some(columns.map(str::to_owned).collect())
}

/// The rows of a table with these columns; what it does not name is zero.
fn of_table(rows: Vec<Vec<PlacedNumber>>, columns: &[String]) -> Vec<CurrentRow> {
    let number = |row: &[PlacedNumber], name: &str| {
        let column = columns.iter().position(|column| column == name);
        let given = column.and_then(|column| row.get(column));
        given.cloned().unwrap_or(PlacedNumber {
            value: 0.0,
            span: 0..0,
        })
    };
    let row = |row: Vec<PlacedNumber>| {
        (
            PLACES.map(|name| number(&row, name)),
            VELOCITY.map(|name| number(&row, name)),
        )
    };
    rows.into_iter().map(row).collect()
}

impl FileSource<'_> {
    /// Sees to it that the file of a current is carried, and that it is a grid, which it returns.
    pub fn take_current(
        &self,
        files: &mut BTreeMap<String, Attachment>,
        current: &Current,
    ) -> Result<Option<Arc<CurrentGrid>>, Diagnostic> {
        let Some(name) = &current.file else {
            return Ok(None);
        };
        let shown = self.take(files, name, &["current", "file"])?;
        grid_of(&files[name], &shown).map(Some)
    }
}
