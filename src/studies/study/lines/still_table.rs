//! CSV of single lines in still water.

use super::answered::at_rest;
use super::table::{LineTableFormat, NumberColumn, RowAnswer, RowError, RowNumbers};
use crate::limits::LINES;
use crate::statics::catenary::{
    CatenaryError, CatenaryLine, EndOffset, RigidBed, SectionProperties,
};

/// `bed_below_a_m` empty: no bed; `bed_slope_deg` positive uphill from A to B; `surface_above_a_m` for buoyant lines.
pub(super) const LAYOUT: LineTableFormat = LineTableFormat {
    limit: &LINES,
    columns: &[
        NumberColumn::required(&["x_m"]),
        NumberColumn::required(&["z_m"]),
        NumberColumn::required(&["length_m"]),
        NumberColumn::required(&["ea_n"]),
        NumberColumn::required(&["weight_n_per_m"]),
        NumberColumn::optional(&["friction"]),
        NumberColumn::optional(&["bed_below_a_m"]),
        NumberColumn::optional(&["bed_slope_deg"]),
        NumberColumn::optional(&["surface_above_a_m"]),
    ],
    answers: &[
        "h_b_n", "v_b_n", "h_a_n", "v_a_n", "on_bed_m", "status", "shape",
    ],
    answer,
};

fn answer(numbers: &RowNumbers) -> Result<RowAnswer, RowError> {
    let required = |i: usize| numbers[i].unwrap_or(f64::NAN);
    let [friction, below, slope, surface_above_a_m] = [5, 6, 7, 8].map(|i: usize| numbers[i]);
    if below.is_none() && slope.is_some_and(|slope| slope != 0.0) {
        return Err(RowError {
            column: Some("bed_slope_deg"),
            problem: "there is a slope but no bed; give bed_below_a_m, 0 for a bed through A"
                .to_owned(),
        });
    }
    let section = [SectionProperties::new(
        required(2),
        required(4),
        required(3),
    )];
    let line = CatenaryLine {
        ends: EndOffset {
            x_m: required(0),
            z_m: required(1),
        },
        sections: &section,
        bed: below.map(|below_a_m| RigidBed {
            below_a_m,
            slope_rad: slope.unwrap_or(0.0).to_radians(),
            friction: friction.unwrap_or(0.0),
        }),
        surface_above_a_m,
    };
    let solved = line.solve().map_err(|error| RowError {
        column: column(&error),
        problem: error.to_string(),
    })?;
    Ok(RowAnswer {
        numbers: Vec::from(at_rest(&solved)),
        shape: solved.shape_name(),
    })
}

/// The column of an invalid number.
fn column(error: &CatenaryError) -> Option<&'static str> {
    let CatenaryError::Input { quantity, .. } = error else {
        return None;
    };
    Some(match quantity.split(" [").next()? {
        "x of end B" => "x_m",
        "z of end B" => "z_m",
        "the unstretched length" => "length_m",
        "the weight per metre" => "weight_n_per_m",
        "the axial stiffness EA" => "ea_n",
        "the depth of the bed below A" => "bed_below_a_m",
        "the slope of the bed" => "bed_slope_deg",
        "the friction of the bed" => "friction",
        _ => return None,
    })
}
