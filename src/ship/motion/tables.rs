//! The ship's motion in tables: statistics asked for and made, spectra, and what to expect in the time of a record.

use super::band::Scatter;
use crate::physics::sea::DEGREES;
use crate::report::number::{digits, percent, rounded};
use crate::report::table::{Cell, CellInk, Column, Table};
use crate::ship::Voyage;
use crate::ship::statistics::{Statistics, greatest_of_gaussian};

/// Units of a degree of freedom's displacement, velocity, acceleration.
const UNITS: [[&str; 3]; 2] = [["m", "m/s", "m/s²"], ["deg", "deg/s", "deg/s²"]];

fn scale(degree: usize) -> f64 {
    if degree < 3 {
        1.0
    } else {
        1.0_f64.to_degrees()
    }
}

/// Root mean squares asked for and made, means, extremes, and the greatest to expect.
#[must_use]
pub fn statistics(voyage: &Voyage, seed: u64) -> Table {
    let mut rows = Vec::new();
    for (i, degree) in voyage.motions.degrees.iter().enumerate() {
        for (rate, unit) in UNITS[i / 3].into_iter().enumerate() {
            let asked = asked(&degree.asked, degree.mean, rate);
            let name = if rate == 0 { DEGREES[i] } else { "" };
            rows.push(row(
                [name, unit],
                asked * scale(i),
                &voyage.statistics[i][rate],
                scale(i),
            ));
        }
    }
    let duration = voyage.motions.time(voyage.motions.instants);
    Table {
        title: format!(
            "Motion over {} s, seed {seed}: what is asked for and what is made",
            digits(duration, 6)
        ),
        columns: vec![
            Column::left("motion"),
            Column::left("unit"),
            Column::decimal("rms asked"),
            Column::decimal("rms made"),
            Column::decimal("off by"),
            Column::decimal("mean"),
            Column::decimal("least"),
            Column::decimal("greatest"),
            Column::decimal("to expect"),
        ],
        rows,
        notes: vec![
            "Root mean squares are about nothing, the mean counted in. To expect is the mean, over many records of this length, of a Gaussian record's greatest, and its scatter from record to record (Cartwright and Longuet-Higgins 1956), from the moments asked for.".to_owned(),
            "Motions in different degrees of freedom are independent: statistics of each alone do not tell their phases.".to_owned(),
        ],
    }
}

fn asked(scatter: &Scatter, mean: f64, rate: usize) -> f64 {
    match rate {
        0 => scatter.displacement.hypot(mean),
        1 => scatter.velocity,
        _ => scatter.acceleration,
    }
}

fn row(names: [&str; 2], asked: f64, made: &Statistics, scale: f64) -> Vec<Cell> {
    let with = |value: f64| digits(value * scale, 4);
    let off = made.rms * scale / asked - 1.0;
    let crossings = made.crossings as f64;
    let greatest = greatest_of_gaussian(made.deviation, crossings);
    let off = if asked > 0.0 {
        let ink = if off.abs() < 0.01 {
            CellInk::Good
        } else {
            CellInk::Warn
        };
        Cell::new(apart(off), ink)
    } else {
        Cell::plain("-")
    };
    vec![
        Cell::plain(names[0]),
        Cell::plain(names[1]),
        Cell::plain(digits(asked, 4)),
        Cell::plain(with(made.rms)),
        off,
        Cell::plain(if made.mean.abs() < 1e-9 * made.rms {
            "0".to_owned()
        } else {
            with(made.mean)
        }),
        Cell::plain(with(made.min)),
        Cell::plain(with(made.max)),
        Cell::plain(format!(
            "{} ± {}",
            with(made.mean + greatest.expected),
            digits(greatest.spread * scale, 2)
        )),
    ]
}

/// A relative difference; what rounding makes of none is none.
fn apart(difference: f64) -> String {
    percent(if difference.abs() < 1e-6 {
        0.0
    } else {
        difference
    })
}

/// The test of the spectra: bands, variance asked for and made, mean periods, and how far the records are from Gaussian.
#[must_use]
pub fn spectra(voyage: &Voyage) -> Table {
    let degrees = voyage.motions.degrees.iter().zip(&voyage.statistics);
    let rows = degrees.enumerate().map(|(i, (degree, made))| {
        let bands: Vec<String> = degree
            .bands
            .iter()
            .map(|band| {
                let (low, high) = band.edges();
                let period = |omega: f64| digits(std::f64::consts::TAU / omega, 3);
                format!("{}-{}", period(high), period(low))
            })
            .collect();
        let asked = degree.asked.displacement.powi(2) * scale(i).powi(2);
        let got = made[0].deviation.powi(2) * scale(i).powi(2);
        let period = |x: f64, v: f64| std::f64::consts::TAU * x / v;
        vec![
            Cell::plain(DEGREES[i]),
            Cell::plain(bands.join(", ")),
            Cell::plain(format!("{asked:.4e}")),
            Cell::plain(format!("{got:.4e}")),
            Cell::plain(apart(got / asked - 1.0)),
            Cell::plain(digits(
                period(degree.asked.displacement, degree.asked.velocity),
                4,
            )),
            Cell::plain(digits(period(made[0].deviation, made[1].deviation), 4)),
            Cell::plain(rounded(made[0].skewness, 3)),
            Cell::plain(rounded(made[0].excess, 3)),
            Cell::plain(made[0].crossings.to_string()),
        ]
    });
    Table {
        title: "Test of the spectra".to_owned(),
        columns: vec![
            Column::left("motion"),
            Column::left("bands [s]"),
            Column::decimal("m0 asked"),
            Column::decimal("m0 made"),
            Column::decimal("off by"),
            Column::decimal("mean period asked"),
            Column::decimal("made"),
            Column::decimal("skewness"),
            Column::decimal("excess"),
            Column::right("crossings"),
        ],
        rows: rows.collect(),
        notes: vec![
            "The record is of the seed told above; its frequencies are whole multiples of its own, so that the moments asked for are those of this record. m0 in m² and deg²; mean periods are 2 pi sqrt(m0/m2), in s. A Gaussian record has skewness and excess (kurtosis less 3) near nought; of n independent swings their standard errors are sqrt(6/n) and sqrt(24/n).".to_owned(),
            "Spectra are flat over their bands: three moments of each motion are known, the shape is not.".to_owned(),
        ],
    }
}
