//! Response amplitude operators (RAOs) of a ship from a file.
//!
//! CSV: a line of column names in any order, then a line an entry. `period_s`, then an amplitude and a phase for each degree
//! of freedom: `surge_m_per_m,surge_phase_deg` ... `roll_deg_per_m,roll_phase_deg` ... A phase is the lead over the wave crest
//! at the ship's reference point. `heading_deg`, which is optional, is the angle from the bow to the direction that the waves
//! go to (0: following seas, 180: head seas), as in the tables of mean drift: one block of periods a heading. Real and imaginary
//! part are interpolated linearly in heading and period; headings up to 180 define the other side by symmetry.

use std::cmp::Ordering;
use std::f64::consts::{PI, TAU};

use super::response_entry;
use crate::case::attachments::{PlacedNumber, placed, response_columns, without_mark};
use crate::case::{Diagnostic, Finding};
use crate::number::digits;
use crate::physics::sea::{DEGREES, Rao};
use crate::work_log::{self, Task};

/// Upper limits of amplitudes that are physical: metres and degrees per metre of wave amplitude.
const LIMITS: [f64; 2] = [20.0, 90.0];

/// Entries of the file at one heading.
pub struct HeadingRao {
    /// Angle from the bow \[rad\]; none in a file without headings.
    heading: Option<f64>,
    rao: Rao,
}

/// The RAOs of a file by ascending heading; a single one for a file without headings.
pub fn read(text: &str, file: &str) -> Result<Vec<HeadingRao>, Diagnostic> {
    work_log::log(Task::Parse, file);
    let has_headings = has_headings(text);
    let rows = rows(text, file, has_headings)?;
    let rao = |block: &[Vec<PlacedNumber>]| {
        let entry = |row: &Vec<PlacedNumber>| {
            let numbers: Vec<f64> = row.iter().skip(1).map(|placed| placed.value).collect();
            response_entry(&numbers)
        };
        let rao = Rao::new(block.iter().map(entry).collect()).map_err(|error| {
            Diagnostic::whole_file(file, error.to_string(), "give positive periods")
        })?;
        Ok(HeadingRao {
            heading: has_headings.then(|| block[0][0].value.to_radians()),
            rao,
        })
    };
    rows.chunk_by(|a, b| a[0].value == b[0].value)
        .map(rao)
        .collect()
}

fn has_headings(text: &str) -> bool {
    let (_, text) = without_mark(text);
    let mut lines = text.lines();
    let names = lines.find(|line| !line.trim().is_empty() && !line.trim_start().starts_with('#'));
    names.is_some_and(|line| line.split(',').any(|name| name.trim() == "heading_deg"))
}

/// The rows of the file with a heading first, zero in a file without, sorted by heading and descending period.
fn rows(text: &str, file: &str, has_headings: bool) -> Result<Vec<Vec<PlacedNumber>>, Diagnostic> {
    let mut columns = vec!["heading_deg".to_owned()];
    columns.extend(response_columns());
    let mut rows = placed(text, file, &columns[usize::from(!has_headings)..])?;
    for row in &mut rows {
        if !has_headings {
            let heading = PlacedNumber {
                value: 0.0,
                span: 0..0,
            };
            row.insert(0, heading);
        }
        check(row, &columns).map_err(|finding| finding.at(file, text))?;
    }
    if rows.is_empty() {
        let remedy = "give a line for each period";
        return Err(Diagnostic::whole_file(
            file,
            "the table has no entry",
            remedy,
        ));
    }
    let key = |row: &[PlacedNumber]| (row[0].value, -row[1].value);
    rows.sort_by(|a, b| key(a).partial_cmp(&key(b)).unwrap_or(Ordering::Equal));
    if let Some(pair) = rows.windows(2).find(|pair| key(&pair[0]) == key(&pair[1])) {
        let spans = [&pair[0][1].span, &pair[1][1].span];
        let span = if spans[0].start > spans[1].start {
            spans[0]
        } else {
            spans[1]
        };
        let remedy = "give every period of a heading once";
        let finding = Finding::new(span, "period_s", "the period is given twice", remedy);
        return Err(finding.at(file, text));
    }
    Ok(rows)
}

/// Rejects values that are not physical.
fn check(row: &[PlacedNumber], columns: &[String]) -> Result<(), Finding> {
    let error = |i: usize, problem: String, remedy: &str| {
        Err(Finding::new(&row[i].span, &columns[i], problem, remedy))
    };
    if !(0.0..360.0).contains(&row[0].value) {
        let problem = format!("the heading is out of range: {}", digits(row[0].value, 6));
        return error(0, problem, "give headings from 0 to below 360 degrees");
    }
    if row[1].value <= 0.0 {
        let problem = format!("the period must be positive: {} s", digits(row[1].value, 6));
        return error(1, problem, "give a positive period");
    }
    for (i, degree) in DEGREES.iter().enumerate() {
        let at = 2 + 2 * i;
        let amplitude = row[at].value;
        if amplitude < 0.0 {
            let problem = format!(
                "the amplitude of {degree} is negative: {}",
                digits(amplitude, 6)
            );
            let remedy = "give the amplitude without sign and change the phase by 180 degrees";
            return error(at, problem, remedy);
        }
        let limit = LIMITS[i / 3];
        if amplitude > limit {
            let problem = format!(
                "the amplitude of {degree} is not physical: {} is more than {limit}",
                digits(amplitude, 6)
            );
            let remedy = "give metres or degrees per metre of wave amplitude";
            return error(at, problem, remedy);
        }
    }
    Ok(())
}

/// The RAO at an angle \[rad\] from the bow, between 0 and 2π, interpolated between the headings of the file.
pub fn at_angle(raos: &[HeadingRao], angle: f64, file: &str) -> Result<Rao, Diagnostic> {
    let headings: Vec<f64> = raos.iter().filter_map(|one| one.heading).collect();
    let (Some(first), Some(last)) = (headings.first(), headings.last()) else {
        // Without headings the RAO is that of the ship as it lies.
        return Ok(raos[0].rao.clone());
    };
    let half = *last <= PI + 1e-9;
    let mirrored = half && angle > PI;
    let sought = if mirrored { TAU - angle } else { angle };
    let next = headings.partition_point(|heading| *heading < sought - 1e-9);
    let between = |i: usize, j: usize, to: f64| {
        let fraction = (sought - headings[i]) / (to - headings[i]);
        raos[i].rao.between(&raos[j].rao, fraction)
    };
    let rao = match headings.get(next) {
        Some(heading) if (heading - sought).abs() <= 1e-9 => raos[next].rao.clone(),
        Some(heading) if next > 0 => between(next - 1, next, *heading),
        // Across 2π.
        None if !half && *first == 0.0 => between(next - 1, 0, TAU),
        _ => {
            let degrees = |angle: f64| digits(angle.to_degrees(), 4);
            let problem = format!(
                "the wave direction is {} deg from the bow; the table covers {} to {} deg",
                degrees(sought),
                degrees(*first),
                degrees(*last)
            );
            let remedy = "give headings on both sides of it: from 0 to 180, or over 360 degrees";
            return Err(Diagnostic::whole_file(file, problem, remedy));
        }
    };
    Ok(if mirrored { rao.mirrored() } else { rao })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Complex;

    /// A file of these headings and two periods, with surge 1 m/m and sway of the index of the heading.
    fn file(headings: &[f64]) -> String {
        let mut text = format!("heading_deg,{}\n", response_columns().join(","));
        for (n, heading) in headings.iter().enumerate() {
            for period in [5.0, 10.0] {
                text.push_str(&format!("{heading},{period},1,0,{n},90,1,0,0,0,0,0,0,0\n"));
            }
        }
        text
    }

    fn at(text: &str, degrees: f64) -> Result<Rao, String> {
        let raos = read(text, "r.csv").map_err(|d| d.to_string())?;
        at_angle(&raos, f64::to_radians(degrees), "r.csv").map_err(|d| d.to_string())
    }

    #[test]
    fn between_headings_and_on_the_other_side() {
        let text = file(&[0.0, 90.0, 180.0]);
        let sway = |degrees: f64| at(&text, degrees).unwrap().response(1.0)[1];
        assert!((sway(45.0) - Complex::new(0.0, 0.5)).norm() < 1e-12);
        assert!((sway(180.0) - Complex::new(0.0, 2.0)).norm() < 1e-12);
        // To starboard sway has the opposite sign.
        assert!((sway(315.0) + Complex::new(0.0, 0.5)).norm() < 1e-12);
        let around = file(&[0.0, 120.0, 240.0]);
        let sway = at(&around, 300.0).unwrap().response(1.0)[1];
        assert!((sway - Complex::new(0.0, 1.0)).norm() < 1e-12);
    }

    #[test]
    fn invalid_values_are_reported_with_line_and_column() {
        let good = file(&[0.0, 180.0]);
        let error = |from: &str, to: &str| at(&good.replacen(from, to, 1), 10.0).unwrap_err();
        assert!(
            error("0,5,1,", "0,5,-1,").starts_with("r.csv:2:5"),
            "{}",
            error("0,5,1,", "0,5,-1,")
        );
        assert!(error("180,10,", "180,5,").contains("given twice"));
        assert!(error("0,10,1,", "0,10,400,").contains("not physical"));
        assert!(error("0,5,", "0,-5,").contains("must be positive"));
        assert!(error("0,5,", "400,5,").contains("out of range"));
        assert!(error("0,5,1,", "0,5,").contains("13 values for 14 columns"));
        let aft = file(&[0.0, 60.0]);
        assert!(
            at(&aft, 100.0)
                .unwrap_err()
                .contains("100 deg from the bow")
        );
        assert!(at("", 0.0).unwrap_err().contains("empty"));
        assert!(
            at(&format!("{}\n", response_columns().join(",")), 0.0)
                .unwrap_err()
                .contains("no entry")
        );
    }
}
