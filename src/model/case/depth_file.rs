//! The file of depths that a sea bed names.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::attachments::{FileSource, placed};
use super::depth_formats::foreign_depths;
use super::diagnostic::{Diagnostic, Finding};
use super::model::{Attachment, BedInterpolation, Seabed};
use crate::numerics::{DepthGrid, DepthInterpolation};
use crate::work_log::{self, Task};

/// Columns of a table of depths.
const COLUMNS: [&str; 3] = ["x_m", "y_m", "depth_m"];

/// Depths and places are within these \[m\], as keys of the bed are.
const FARTHEST: f64 = 1e6;

/// The grid of depths that a bed names, from the files that its case carries; nothing where it names none.
///
/// # Errors
/// The file is not carried, is no table of x_m, y_m and depth_m, or its places make no rectangular grid.
pub fn depth_grid(
    (depth_file, interpolation): (Option<&str>, BedInterpolation),
    files: &BTreeMap<String, Attachment>,
) -> Result<Option<Arc<DepthGrid>>, Diagnostic> {
    let Some(name) = depth_file else {
        return Ok(None);
    };
    let Some(file) = files.get(name) else {
        return Err(Diagnostic::whole_file(
            name,
            "is not there",
            "name a file of depths beside the case",
        ));
    };
    grid_of(file, name, interpolation).map(Some)
}

/// The grid of a carried file, which is parsed once.
fn grid_of(
    carried: &Attachment,
    file: &str,
    interpolation: BedInterpolation,
) -> Result<Arc<DepthGrid>, Diagnostic> {
    let text = &carried.text;
    text.parsed(interpolation, |text| read(text, file, interpolation))
}

fn read(text: &str, file: &str, interpolation: BedInterpolation) -> Result<DepthGrid, Diagnostic> {
    work_log::log(Task::Parse, file);
    let foreign = foreign_depths(text).map_err(|fault| fault.at(file, text))?;
    let table = match foreign {
        Some(rows) => rows.into_iter().map(Vec::from).collect(),
        None => placed(text, file, &COLUMNS.map(str::to_owned))?,
    };
    for number in table.iter().flatten() {
        if number.value.abs() > FARTHEST {
            let problem = format!("{} m is too far", number.value);
            let remedy = format!("give places and depths up to {FARTHEST} m");
            return Err(Finding::new(&number.span, "", problem, remedy).at(file, text));
        }
    }
    let rows: Vec<[f64; 3]> = table
        .iter()
        .map(|row| [row[0].value, row[1].value, row[2].value])
        .collect();
    let how = match interpolation {
        BedInterpolation::Bilinear => DepthInterpolation::Bilinear,
        BedInterpolation::Smooth => DepthInterpolation::Smooth,
    };
    DepthGrid::of_rows(&rows, how).map_err(|error| {
        Diagnostic::whole_file(
            file,
            format!("makes no grid: {error}"),
            "give a depth for every pair of x and y, each once",
        )
    })
}

impl Seabed {
    /// The file of depths that it names, and how the depth goes between its places.
    #[must_use]
    pub fn depths(&self) -> (Option<&str>, BedInterpolation) {
        (self.depth_file.as_deref(), self.interpolation)
    }
}

impl FileSource<'_> {
    /// Sees to it that the file of depths of a bed at this key is carried, and that it is a grid.
    pub fn take_depths(
        &self,
        files: &mut BTreeMap<String, Attachment>,
        (depth_file, interpolation): (Option<&str>, BedInterpolation),
        table: &str,
    ) -> Result<(), Diagnostic> {
        if let Some(name) = depth_file {
            let shown = self.take(files, name, &[table, "depth_file"])?;
            grid_of(&files[name], &shown, interpolation)?;
        }
        Ok(())
    }
}
