//! Files in the form of WAMIT (WAMIT User Manual 7.4, chapter 4): one row a number, words apart by blanks.
//!
//! | file | columns | scaled by |
//! |---|---|---|
//! | `.1` | period, i, j, added mass, damping | rho L^k, rho omega L^k; k = 3, 4, 5 |
//! | `.3` | period, heading, i, modulus, phase, real, imaginary | rho g L^m; m = 2, 3 |
//! | `.8`, `.9` | period, heading, heading, i, modulus, phase, real, imaginary | rho g L^m; m = 1, 2 |
//! | `.12d` | period, period, then as above | the same |
//!
//! A period of 0 is an infinite frequency, a negative one an infinite period.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::Range;

use nalgebra::{Complex, Matrix6, Vector6};

use super::{DriftTable, ExcitationTable, RadiationTable, Scales};
use crate::case::{Diagnostic, Finding};
use crate::work_log::{self, Task};

/// A row of numbers and where it is in the text.
struct NumberRow {
    numbers: Vec<f64>,
    span: Range<usize>,
}

/// A number as the key of a map; its order is that of numbers that are not negative.
type Bits = u64;

/// The rows of a file, whose first line may be a heading in words; rows of another length than these are refused.
fn rows(text: &str, file: &str, columns: &[usize]) -> Result<Vec<NumberRow>, Diagnostic> {
    work_log::log(Task::Parse, file);
    let mut rows: Vec<NumberRow> = Vec::new();
    let mut start = 0;
    for (number, line) in text.split_inclusive('\n').enumerate() {
        let span = start..start + line.trim_end().len();
        start += line.len();
        let words: Vec<&str> = line.split_whitespace().collect();
        let read = |word: &&str| {
            let word = word.replace(['D', 'd'], "e");
            word.parse::<f64>().ok().filter(|value| value.is_finite())
        };
        let numbers: Option<Vec<f64>> = words.iter().map(read).collect();
        match numbers {
            Some(numbers) if numbers.is_empty() => {}
            Some(numbers) if columns.contains(&numbers.len()) => {
                rows.push(NumberRow { numbers, span });
            }
            None if number == 0 => {}
            other => {
                let problem = match other {
                    Some(numbers) => format!("the row has {} numbers", numbers.len()),
                    None => "the row is not one of numbers".to_owned(),
                };
                let wanted = columns.iter().map(ToString::to_string);
                let wanted = wanted.collect::<Vec<_>>().join(" or ");
                let remedy = format!("give rows of {wanted} numbers, as WAMIT writes this file");
                return Err(Finding::new(&span, "", problem, remedy).at(file, text));
            }
        }
    }
    if rows.is_empty() {
        let remedy = "give a file as WAMIT writes it";
        return Err(Diagnostic::whole_file(
            file,
            "the file has no row of numbers",
            remedy,
        ));
    }
    Ok(rows)
}

/// A mode from 1 to 6 of a row, as an index.
fn mode(row: &NumberRow, column: usize, (text, file): (&str, &str)) -> Result<usize, Diagnostic> {
    let given = row.numbers[column];
    (1..=6)
        .find(|mode| f64::from(*mode as u8) == given)
        .map(|mode| mode - 1)
        .ok_or_else(|| {
            let problem = format!("{given} is no mode of a body");
            let remedy = "modes are 1 to 6: surge, sway, heave, roll, pitch, yaw of one body";
            Finding::new(&row.span, "", problem, remedy).at(file, text)
        })
}

/// Whether a mode is a turn.
fn turns(mode: usize) -> i32 {
    i32::from(mode >= 3)
}

/// Added mass and damping.
///
/// # Errors
/// A row that is none, with its line; a file without a finite period.
pub fn radiation(text: &str, file: &str, scales: &Scales) -> Result<RadiationTable, Diagnostic> {
    let mut finite: BTreeMap<Bits, (Matrix6<f64>, Matrix6<f64>)> = BTreeMap::new();
    let (mut at_zero, mut at_infinity) = (None, None);
    for row in rows(text, file, &[4, 5])? {
        let period = row.numbers[0];
        let (i, j) = (mode(&row, 1, (text, file))?, mode(&row, 2, (text, file))?);
        let unit = scales.density * scales.length.powi(3 + turns(i) + turns(j));
        let added = row.numbers[3] * unit;
        if period <= 0.0 {
            let matrix: &mut Option<Matrix6<f64>> = match period < 0.0 {
                true => &mut at_zero,
                false => &mut at_infinity,
            };
            matrix.get_or_insert_with(Matrix6::zeros)[(i, j)] = added;
            continue;
        }
        let omega = TAU / period;
        let matrices = finite.entry(omega.to_bits()).or_default();
        matrices.0[(i, j)] = added;
        matrices.1[(i, j)] = row.numbers.get(4).unwrap_or(&0.0) * unit * omega;
    }
    if finite.len() < 2 {
        let remedy = "give two periods or more between 0 and infinity";
        return Err(Diagnostic::whole_file(
            file,
            "the file has no finite periods",
            remedy,
        ));
    }
    let omega = finite.keys().map(|bits| f64::from_bits(*bits)).collect();
    let (added, damping) = finite.into_values().unzip();
    Ok(RadiationTable {
        omega,
        added,
        damping,
        at_zero,
        at_infinity,
    })
}

/// Values by heading and frequency, while they are read.
type HeadingRows<T> = BTreeMap<i64, BTreeMap<Bits, T>>;

/// A heading in millionths of a degree, from -180 to 180: the key of a map.
fn heading_key(degrees: f64) -> i64 {
    let turned = (degrees + 180.0).rem_euclid(360.0) - 180.0;
    #[expect(clippy::cast_possible_truncation, reason = "at most 180e6")]
    let key = (turned * 1e6).round() as i64;
    key
}

/// Headings \[rad\], frequencies \[rad/s\] and the values of a table, all headings at the same frequencies.
#[expect(clippy::type_complexity, reason = "the parts of a table")]
fn table<T: Copy>(
    read: HeadingRows<T>,
    file: &str,
) -> Result<(Vec<f64>, Vec<f64>, Vec<Vec<T>>), Diagnostic> {
    let first: Vec<Bits> = read
        .values()
        .next()
        .into_iter()
        .flat_map(BTreeMap::keys)
        .copied()
        .collect();
    let even = read.values().all(|row| row.keys().eq(first.iter()));
    if first.is_empty() || !even {
        let remedy = "give every heading at the same finite periods";
        let problem = "headings differ in their periods, or there are none";
        return Err(Diagnostic::whole_file(file, problem, remedy));
    }
    let headings = read.keys().map(|key| (*key as f64 * 1e-6).to_radians());
    let omega = first.iter().map(|bits| f64::from_bits(*bits)).collect();
    let headings = headings.collect();
    let values = read.into_values().map(|row| row.into_values().collect());
    Ok((headings, omega, values.collect()))
}

/// Loads of the first order.
///
/// # Errors
/// A row that is none, with its line; headings at different periods.
pub fn excitation(text: &str, file: &str, scales: &Scales) -> Result<ExcitationTable, Diagnostic> {
    let mut read: HeadingRows<Vector6<Complex<f64>>> = BTreeMap::new();
    for row in rows(text, file, &[7])? {
        let [period, heading] = [row.numbers[0], row.numbers[1]];
        if period <= 0.0 {
            continue;
        }
        let i = mode(&row, 2, (text, file))?;
        let unit = scales.density * scales.gravity * scales.length.powi(2 + turns(i));
        let loads = read.entry(heading_key(heading)).or_default();
        let loads = loads.entry((TAU / period).to_bits()).or_default();
        loads[i] = Complex::new(row.numbers[5], row.numbers[6]) * unit;
    }
    let (headings, omega, values) = table(read, file)?;
    Ok(ExcitationTable::new(headings, omega, values))
}

/// Mean drift: of a file of difference frequencies its diagonal, where both periods and both headings are the same.
///
/// # Errors
/// A row that is none, with its line; headings at different periods.
pub fn drift(text: &str, file: &str, scales: &Scales) -> Result<DriftTable, Diagnostic> {
    let mut read: HeadingRows<[f64; 3]> = BTreeMap::new();
    for row in rows(text, file, &[8, 9])? {
        let shift = row.numbers.len() - 8;
        let period = row.numbers[0];
        let headings = [row.numbers[1 + shift], row.numbers[2 + shift]];
        let same = shift == 0 || (period - row.numbers[1]).abs() <= 1e-5 * period;
        if period <= 0.0 || !same || heading_key(headings[0]) != heading_key(headings[1]) {
            continue;
        }
        let i = mode(&row, 3 + shift, (text, file))?;
        let axis = match i {
            0 | 1 => i,
            5 => 2,
            _ => continue,
        };
        let unit = scales.density * scales.gravity * scales.length.powi(1 + turns(i));
        let loads = read.entry(heading_key(headings[0])).or_default();
        let loads = loads.entry((TAU / period).to_bits()).or_default();
        loads[axis] = row.numbers[6 + shift] * unit;
    }
    let (headings, omega, values) = table(read, file)?;
    Ok(DriftTable::new(headings, omega, values))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCALES: Scales = Scales {
        density: 1000.0,
        gravity: 10.0,
        length: 2.0,
    };

    #[test]
    fn numbers_are_scaled_by_the_manual() {
        let text = "PER I J A B\n-1 1 1 9.0\n0 1 1 4.0\n 6.283185307179586 1 1 1.0 0.5\n 6.283185307179586 1 5 1.0D0 0.5\n3.0 5 5 1 1\n";
        let table = radiation(text, "a.1", &SCALES).unwrap();
        assert_eq!(table.omega.len(), 2);
        assert_eq!(table.at_zero.unwrap()[(0, 0)], 9e3 * 8.0);
        assert_eq!(table.at_infinity.unwrap()[(0, 0)], 4e3 * 8.0);
        assert!((table.damping[0][(0, 0)] - 0.5 * 8e3).abs() < 1e-9);
        assert!((table.added[0][(0, 4)] - 16e3).abs() < 1e-9);
        assert!((table.damping[1][(4, 4)] - 32e3 * TAU / 3.0).abs() < 1e-9);

        let text = "5 0 1 2 90 0 2\n4 0 1 2 90 0 4\n5 90 1 0 0 0 0\n4 90 1 0 0 0 0\n";
        let table = excitation(text, "a.3", &SCALES).unwrap();
        let middle = table.at(f64::to_radians(45.0), 0.5 * (TAU / 5.0 + TAU / 4.0));
        assert!((middle[0] - Complex::new(0.0, 1.5 * 10e3 * 4.0)).norm() < 1e-6);
        assert!(table.covers(f64::to_radians(30.0)) && !table.covers(f64::to_radians(180.0)));

        let text = "5 5 0 0 1 3 0 3 0\n5 4 0 0 1 9 0 9 9\n4 4 0 0 6 2 0 2 0\n";
        let table = drift(text, "a.12d", &SCALES).unwrap();
        assert_eq!(table.at(0.0, TAU / 5.0), [3.0 * 10e3 * 2.0, 0.0, 0.0]);
        assert_eq!(table.at(0.0, 9.0)[2], 2.0 * 10e3 * 4.0);
    }

    #[test]
    fn what_is_no_row_is_refused_with_its_line() {
        let why = |text: &str| radiation(text, "a.1", &SCALES).unwrap_err().to_string();
        let short = why("5 1 1 1 1\n5 1 1\n");
        assert!(
            short.contains("a.1:2") && short.contains("3 numbers"),
            "{short}"
        );
        assert!(why("5 1 1 1 1\n5 1 7 1 1\n").contains("no mode"));
        assert!(why("5 1 1 1 1\nhere 1 1 1 1\n").contains("not one of numbers"));
        assert!(why("").contains("no row"));
        assert!(why("5 1 1 1 1\n").contains("no finite periods"));
    }
}
