//! CSV of single lines in a uniform current.

use crate::limits::LINES_IN_CURRENT;
use csv::StringRecord;

use super::answered::END_FORCES_AND_STATUS;
use super::in_current::LineInCurrent;
use super::table::{LineTableFormat, NumberColumn, RowAnswer, RowError, RowNumbers, names, reader};
use crate::statics::catenary::SectionProperties;

/// Column of the current along x.
const CURRENT_X: usize = 13;
/// Column of the current along z: may be left out, since a current is level.
const CURRENT_Z: usize = 15;

/// Columns by name, and by a short name.
pub(super) const LAYOUT: LineTableFormat = LineTableFormat {
    limit: &LINES_IN_CURRENT,
    columns: &[
        NumberColumn::required(&["a_x_m", "ax"]),
        NumberColumn::required(&["a_y_m", "ay"]),
        NumberColumn::required(&["a_z_m", "az"]),
        NumberColumn::required(&["b_x_m", "bx"]),
        NumberColumn::required(&["b_y_m", "by"]),
        NumberColumn::required(&["b_z_m", "bz"]),
        NumberColumn::required(&["length_m", "l"]),
        NumberColumn::required(&["weight_n_per_m", "w_npm"]),
        NumberColumn::required(&["ea_n"]),
        NumberColumn::required(&["diameter_m", "d_m"]),
        NumberColumn::required(&["drag_normal", "cd"]),
        NumberColumn::required(&["drag_tangential", "cdax"]),
        NumberColumn::required(&["water_density_kg_per_m3", "rho"]),
        NumberColumn::required(&["current_x_m_per_s", "ux"]),
        NumberColumn::required(&["current_y_m_per_s", "uy"]),
        NumberColumn::optional(&["current_z_m_per_s", "uz"]),
    ],
    answers: &END_FORCES_AND_STATUS,
    answer,
};

/// Whether the columns are those of lines in a current.
pub(super) fn recognises(input: &[u8]) -> bool {
    let Ok(head) = reader(input).byte_headers().cloned() else {
        return false;
    };
    let known = LAYOUT.columns[CURRENT_X].names;
    names(&StringRecord::from_byte_record_lossy(head))
        .iter()
        .any(|name| known.contains(&name.as_str()))
}

fn answer(numbers: &RowNumbers) -> Result<RowAnswer, RowError> {
    let wrong = |column: Option<usize>, problem: String| RowError {
        column: column.map(|i| LAYOUT.columns[i].names[0]),
        problem,
    };
    if let Some(i) = numbers
        .iter()
        .position(|n| n.is_some_and(|n| !n.is_finite()))
    {
        return Err(wrong(Some(i), "a finite number is needed".to_owned()));
    }
    let n = |i: usize| numbers[i].unwrap_or(0.0);
    if n(CURRENT_Z) != 0.0 {
        let problem = "a current is level here; 0 is needed".to_owned();
        return Err(wrong(Some(CURRENT_Z), problem));
    }
    let line = LineInCurrent {
        a_m: [n(0), n(1), n(2)],
        b_m: [n(3), n(4), n(5)],
        sections: vec![SectionProperties::new(n(6), n(7), n(8))],
        diameter_m: n(9),
        drag_normal: n(10),
        drag_tangential: n(11),
        water_density_kg_per_m3: n(12),
        current: vec![[0.0, n(CURRENT_X), n(CURRENT_X + 1)]],
    };
    let forces = line.solve().map_err(|problem| wrong(None, problem))?;
    Ok(RowAnswer {
        numbers: Vec::from(forces.numbers()),
        shape: "",
    })
}
