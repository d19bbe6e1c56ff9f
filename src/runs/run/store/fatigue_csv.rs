//! `fatigue.csv`: the damage along the line, a row for each place and, of a cross-section, each unit and angle.

use std::path::Path;

use super::number::{parse, text};
use super::table::{CsvReader, CsvWriter, not_a_number};
use super::{FATIGUE, StoreError};
use crate::run::along::FatigueSpot;

const COLUMNS: [&str; 12] = [
    "check",
    "line",
    "arc_m",
    "unit",
    "angle_deg",
    "duration_s",
    "damage",
    "cycles",
    "greatest_range",
    "damage_by_range",
    "by_tension",
    "by_curvature",
];

/// Writes the table.
pub(super) fn write_fatigue(spots: &[FatigueSpot]) -> Result<Vec<u8>, StoreError> {
    let mut csv = CsvWriter::new(COLUMNS)?;
    for spot in spots {
        let numbers = [
            spot.arc_m,
            spot.angle_deg,
            spot.duration_s,
            spot.damage,
            spot.cycles,
            spot.greatest_range,
            spot.damage_by_range,
            spot.by_tension,
            spot.by_curvature,
        ];
        let [arc, angle, rest @ ..] = numbers.map(text);
        let words = [
            spot.check.clone(),
            spot.line.clone(),
            arc,
            spot.unit.clone(),
            angle,
        ];
        csv.row(words.into_iter().chain(rest))?;
    }
    csv.bytes()
}

/// Reads the damage along the line of a stored run; nothing where its checks count none.
///
/// # Errors
/// A table that cannot be understood.
pub fn fatigue_spots(dir: &Path) -> Result<Vec<FatigueSpot>, StoreError> {
    if !dir.join(FATIGUE).exists() {
        return Ok(Vec::new());
    }
    let mut csv = CsvReader::open(dir, FATIGUE);
    csv.require(&COLUMNS);
    let places = COLUMNS.map(|name| csv.position(name));
    let mut spots = Vec::new();
    while let Some((line, fields)) = csv.next() {
        let word = |column: usize| places[column].and_then(|place| fields.get(place));
        let number = |column: usize| parse(word(column).unwrap_or_default());
        let read = || {
            Some(FatigueSpot {
                check: word(0)?.to_owned(),
                line: word(1)?.to_owned(),
                arc_m: number(2)?,
                unit: word(3)?.to_owned(),
                angle_deg: number(4)?,
                duration_s: number(5)?,
                damage: number(6)?,
                cycles: number(7)?,
                greatest_range: number(8)?,
                damage_by_range: number(9)?,
                by_tension: number(10)?,
                by_curvature: number(11)?,
            })
        };
        match read() {
            Some(spot) => spots.push(spot),
            None => {
                csv.give_up(not_a_number(FATIGUE, line));
                break;
            }
        }
    }
    match csv.problem() {
        None => Ok(spots),
        Some(reason) => Err(StoreError::Damaged {
            file: dir.join(FATIGUE),
            reason,
        }),
    }
}
