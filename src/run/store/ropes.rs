//! What ropes with dynamic stiffness stand at, as rows of `ropes.csv`.

use super::{
    StoreError,
    number::text,
    shapes::numbers,
    table::{Csv, Rows},
};
use crate::run::RopeProfile;

/// Columns of `ropes.csv`.
pub(super) const ROPE_COLUMNS: [&str; 7] = [
    "arc_m",
    "mean_load_percent",
    "deviation_min_percent",
    "deviation_max_percent",
    "stiffness_k",
    "stiffness_min_k",
    "stiffness_max_k",
];

/// The ropes as a table.
pub(super) fn ropes(ropes: &RopeProfile) -> Result<Vec<u8>, StoreError> {
    let mut csv = Csv::new(ROPE_COLUMNS)?;
    for (i, arc) in ropes.arc.iter().enumerate() {
        let of = |column: &[f64]| column.get(i).copied().map(text).unwrap_or_default();
        csv.row([
            text(*arc),
            of(&ropes.mean_load),
            of(&ropes.deviation_min),
            of(&ropes.deviation_max),
            of(&ropes.stiffness),
            of(&ropes.stiffness_min),
            of(&ropes.stiffness_max),
        ])?;
    }
    csv.bytes()
}

/// The ropes from their rows.
pub(super) fn read_ropes(table: &mut Rows, name: &str) -> RopeProfile {
    let mut ropes = RopeProfile::default();
    for (line, fields) in &table.rows {
        let Some([arc, mean, low, high, k, k_low, k_high]) = numbers(fields) else {
            table.trouble = Some(format!(
                "{name}, line {line} holds something that is no number; read up to there."
            ));
            break;
        };
        ropes.arc.push(arc);
        ropes.mean_load.push(mean);
        ropes.deviation_min.push(low);
        ropes.deviation_max.push(high);
        ropes.stiffness.push(k);
        ropes.stiffness_min.push(k_low);
        ropes.stiffness_max.push(k_high);
    }
    ropes
}
