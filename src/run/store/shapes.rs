//! Shapes of the line as rows of `shapes.csv`, and the profile as `profile.csv`.

use super::{
    StoreError,
    number::{self, text},
    readers::not_a_number,
    table::{Csv, Rows},
};
use crate::run::{LineShape, Profile};

/// Columns of `shapes.csv`.
pub(super) const SHAPE_COLUMNS: [&str; 6] = ["time_s", "node", "x_m", "y_m", "z_m", "tension_n"];

/// Columns of `profile.csv`.
pub(super) const PROFILE_COLUMNS: [&str; 10] = [
    "node",
    "arc_m",
    "x_m",
    "y_m",
    "z_m",
    "tension_n",
    "tension_min_n",
    "tension_max_n",
    "z_min_m",
    "z_max_m",
];

/// Further columns of `profile.csv`, for a line that bends.
pub(super) const BENDING_COLUMNS: [&str; 4] = [
    "curvature_per_m",
    "curvature_max_per_m",
    "moment_nm",
    "moment_max_nm",
];

/// Further columns of `profile.csv`, for a run that recorded how far its nodes move.
pub(super) const RESPONSE_COLUMNS: [&str; 11] = [
    "rms_displacement_m",
    "rms_displacement_d",
    "wave_cos_m",
    "wave_sin_m",
    "wave_phase_deg",
    "rms_error_m",
    "wave_number_per_m",
    "wkb_number_per_m",
    "wkb_amplitude",
    "towards_a_m",
    "towards_b_m",
];

/// The last of these columns, which a run may lack.
const WAVES: usize = 6;

/// Adds a shape to a table.
pub(super) fn write_shape(csv: &mut Csv, shape: &LineShape) -> Result<(), StoreError> {
    for (node, ([x, y, z], tension)) in shape.nodes.iter().zip(&shape.tension).enumerate() {
        let fields = [*x, *y, *z, *tension].map(text);
        let [x, y, z, tension] = fields;
        csv.row([text(shape.time), node.to_string(), x, y, z, tension])?;
    }
    Ok(())
}

/// The columns that a run may lack, in their order.
fn waves(profile: &Profile) -> [&[f64]; WAVES] {
    [
        &profile.rms_error,
        &profile.wave_number,
        &profile.wkb_number,
        &profile.wkb_amplitude,
        &profile.towards_a,
        &profile.towards_b,
    ]
}

/// The profile as a table.
pub(super) fn profile(profile: &Profile) -> Result<Vec<u8>, StoreError> {
    let further: &[&str] = if profile.bends() {
        &BENDING_COLUMNS
    } else {
        &[]
    };
    let moved: &[&str] = if profile.rms.is_empty() {
        &[]
    } else {
        &RESPONSE_COLUMNS
    };
    let mut csv = Csv::new(PROFILE_COLUMNS.iter().chain(further).chain(moved))?;
    for (i, [x, y, z]) in profile.nodes.iter().enumerate() {
        let of = |column: &[f64]| column.get(i).copied().map(text).unwrap_or_default();
        let mut row = vec![
            i.to_string(),
            of(&profile.arc),
            text(*x),
            text(*y),
            text(*z),
            of(&profile.tension),
            of(&profile.tension_min),
            of(&profile.tension_max),
            of(&profile.z_min),
            of(&profile.z_max),
        ];
        if profile.bends() {
            row.extend([
                of(&profile.curvature),
                of(&profile.curvature_max),
                of(&profile.moment),
                of(&profile.moment_max),
            ]);
        }
        if !moved.is_empty() {
            let (cos, sin) = (profile.wave_cos.get(i), profile.wave_sin.get(i));
            let phase = sin.zip(cos).map(|(s, c)| s.atan2(*c).to_degrees());
            row.extend([
                of(&profile.rms),
                of(&profile.rms_diameters),
                of(&profile.wave_cos),
                of(&profile.wave_sin),
                phase.map(text).unwrap_or_default(),
            ]);
            row.extend(waves(profile).map(of));
        }
        csv.row(row)?;
    }
    csv.bytes()
}

/// All numbers of a row; absent when one of them is none.
pub(super) fn numbers<const N: usize>(
    fields: impl IntoIterator<Item = impl AsRef<str>>,
) -> Option<[f64; N]> {
    let all = fields.into_iter().map(|f| number::parse(f.as_ref()));
    let all: Option<Vec<f64>> = all.collect();
    all?.try_into().ok()
}

fn waves_mut(profile: &mut Profile) -> [&mut Vec<f64>; WAVES] {
    [
        &mut profile.rms_error,
        &mut profile.wave_number,
        &mut profile.wkb_number,
        &mut profile.wkb_amplitude,
        &mut profile.towards_a,
        &mut profile.towards_b,
    ]
}

/// The profile from its rows, with or without the columns of bending.
pub(super) fn read_profile(table: &mut Rows, name: &str) -> Profile {
    let mut profile = Profile::default();
    for (line, fields) in &table.rows {
        let (line_fields, bending_fields) =
            fields.split_at(PROFILE_COLUMNS.len().min(fields.len()));
        // Bending has four columns and the response eleven, in this order.
        let bends = matches!(bending_fields.len(), 4 | 15);
        let (bending_fields, moved_fields) = bending_fields.split_at(if bends { 4 } else { 0 });
        let told = moved_fields.len().saturating_sub(WAVES);
        let (moved_fields, wave_fields) = moved_fields.split_at(told);
        let (bending, moved) = (numbers(bending_fields), numbers(moved_fields));
        let whole = (bending.is_some() || bending_fields.is_empty())
            && (moved.is_some() || moved_fields.is_empty());
        let Some(
            [
                _,
                arc,
                x,
                y,
                z,
                tension,
                tension_min,
                tension_max,
                z_min,
                z_max,
            ],
        ) = numbers(line_fields).filter(|_| whole)
        else {
            table.trouble = Some(not_a_number(name, *line));
            break;
        };
        profile.arc.push(arc);
        profile.nodes.push([x, y, z]);
        profile.tension.push(tension);
        profile.tension_min.push(tension_min);
        profile.tension_max.push(tension_max);
        profile.z_min.push(z_min);
        profile.z_max.push(z_max);
        if let Some([curvature, curvature_max, moment, moment_max]) = bending {
            profile.curvature.push(curvature);
            profile.curvature_max.push(curvature_max);
            profile.moment.push(moment);
            profile.moment_max.push(moment_max);
        }
        if let Some([rms, by_diameter, cos, sin, _]) = moved {
            profile.rms.push(rms);
            profile.rms_diameters.push(by_diameter);
            profile.wave_cos.push(cos);
            profile.wave_sin.push(sin);
        }
        for (column, field) in waves_mut(&mut profile).into_iter().zip(wave_fields) {
            column.extend(number::parse(field));
        }
    }
    profile
}
