//! The ship's motion in tables: statistics asked for and made, spectra, and what to expect in the time of a record.

use crate::numerics::statistics::{Statistics, expected_gaussian_maximum};
use crate::physics::sea::{DEGREES, Moments};
use crate::report::number::{digits, percent, rounded};
use crate::report::table::{Cell, CellInk, Column, Table};
use crate::ship::MotionAnalysis;
use crate::ship::motion::DegreeOfFreedom;
use crate::ship::motion::spectral_band::MotionRms;

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
pub fn statistics(motion: &MotionAnalysis, seed: u64) -> Table {
    let mut rows = Vec::new();
    for (i, degree) in motion.motions.degrees.iter().enumerate() {
        for (rate, unit) in UNITS[i / 3].into_iter().enumerate() {
            let asked = asked(&degree.asked, degree.mean, rate);
            let name = format!("{} [{unit}]", DEGREES[i]);
            rows.push(row(
                &name,
                asked * scale(i),
                &motion.statistics[i][rate],
                scale(i),
            ));
        }
    }
    let duration = motion.motions.time(motion.motions.instants);
    Table {
        title: format!(
            "Motion over {} s, seed {seed}: what is asked for and what is made",
            digits(duration, 6)
        ),
        columns: vec![
            Column::left("motion"),
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
            if motion.sea.is_some() {
                "Made by the ship's responses to one sea. Asked for are the moments of its spectrum times the square of the response."
            } else {
                "Motions in different degrees of freedom are independent: statistics of each alone do not tell their phases."
            }
            .to_owned(),
        ],
    }
}

fn asked(scatter: &MotionRms, mean: f64, rate: usize) -> f64 {
    match rate {
        0 => scatter.displacement.hypot(mean),
        1 => scatter.velocity,
        _ => scatter.acceleration,
    }
}

fn row(name: &str, asked: f64, made: &Statistics, scale: f64) -> Vec<Cell> {
    let with = |value: f64| digits(value * scale, 4);
    let off = made.rms * scale / asked - 1.0;
    let crossings = made.crossings as f64;
    let greatest = expected_gaussian_maximum(made.deviation, crossings);
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
        Cell::plain(name),
        Cell::plain(digits(asked, 4)),
        Cell::plain(with(made.rms)),
        off,
        Cell::plain(if made.mean.abs() < 1e-3 * made.rms {
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

/// A line of the test of the spectra: what is asked for and what is made.
struct Tested<'a> {
    name: String,
    asked: Moments,
    made: Moments,
    record: &'a Statistics,
}

/// The test of the spectra: bands, variance asked for and made, mean periods, and how far the records are from Gaussian; with
/// the sea first where the ship answers one.
#[must_use]
pub fn spectra(motion: &MotionAnalysis) -> Table {
    let mut rows = Vec::new();
    if let Some(sea) = &motion.sea {
        rows.push(tested(&Tested {
            name: "waves".to_owned(),
            asked: sea.asked,
            made: sea.made,
            record: &sea.elevation,
        }));
    }
    let degrees = motion.motions.degrees.iter().zip(&motion.statistics);
    rows.extend(degrees.enumerate().map(|(i, (degree, made))| {
        let square = scale(i).powi(2);
        let moments = |x: f64, v: f64| Moments {
            m0: x * x * square,
            m2: v * v * square,
        };
        tested(&Tested {
            name: format!("{}{}", DEGREES[i], bands(degree)),
            asked: moments(degree.asked.displacement, degree.asked.velocity),
            made: moments(made[0].deviation, made[1].deviation),
            record: &made[0],
        })
    }));
    Table {
        title: "Test of the spectra".to_owned(),
        columns: vec![
            Column::left("motion"),
            Column::decimal("m0 asked"),
            Column::decimal("m0 made"),
            Column::decimal("off by"),
            Column::decimal("Tz asked"),
            Column::decimal("Tz made"),
            Column::decimal("skewness"),
            Column::decimal("excess"),
            Column::right("crossings"),
        ],
        rows,
        notes: notes(motion),
    }
}

fn bands(degree: &DegreeOfFreedom) -> String {
    let intervals = degree.bands.iter().map(|band| {
        let (low, high) = band.edges();
        let period = |omega: f64| digits(std::f64::consts::TAU / omega, 3);
        format!("{}-{}", period(high), period(low))
    });
    let intervals = intervals.collect::<Vec<_>>().join(", ");
    if intervals.is_empty() {
        intervals
    } else {
        format!(", bands {intervals} s")
    }
}

fn tested(row: &Tested<'_>) -> Vec<Cell> {
    let period = |moments: &Moments| {
        if moments.m2 > 0.0 {
            digits(moments.crossing_period(), 4)
        } else {
            "-".to_owned()
        }
    };
    let off = if row.asked.m0 > 0.0 {
        apart(row.made.m0 / row.asked.m0 - 1.0)
    } else {
        "-".to_owned()
    };
    vec![
        Cell::plain(&row.name),
        Cell::plain(format!("{:.4e}", row.asked.m0)),
        Cell::plain(format!("{:.4e}", row.made.m0)),
        Cell::plain(off),
        Cell::plain(period(&row.asked)),
        Cell::plain(period(&row.made)),
        Cell::plain(rounded(row.record.skewness, 3)),
        Cell::plain(rounded(row.record.excess, 3)),
        Cell::plain(row.record.crossings.to_string()),
    ]
}

fn notes(motion: &MotionAnalysis) -> Vec<String> {
    let gauss = "m0 in m² and deg²; Tz is 2 pi sqrt(m0/m2), in s. A Gaussian record has skewness and excess (kurtosis less 3) near nought; of n independent swings their standard errors are sqrt(6/n) and sqrt(24/n).";
    let Some(sea) = &motion.sea else {
        return vec![
            format!("The record is of the seed told above; its frequencies are whole multiples of its own, so that the moments asked for are those of this record. {gauss}"),
            "Spectra are flat over their bands: three moments of each motion are known, the shape is not.".to_owned(),
        ];
    };
    let answer = &sea.answer;
    let mut notes = vec![
        format!(
            "Significant height {} m asked, {} m made; mean period {} s asked, {} s made; waves meet the ship {} from the bow (180 deg: from ahead), heading {}; {} components.",
            digits(sea.asked.significant_height(), 4),
            digits(sea.made.significant_height(), 4),
            digits(sea.asked.crossing_period(), 4),
            digits(sea.made.crossing_period(), 4),
            degrees(answer.angle),
            degrees(answer.heading),
            motion.motions.sea.len()
        ),
        format!(
            "Asked for are the integrals of the spectrum, and of it times the square of the response; made is the record of the seed told above. A record of three hours is some thousand waves: m0 scatters by some per cent. {gauss}"
        ),
    ];
    if answer.beyond > MUCH_BEYOND {
        notes.push(format!(
            "WARNING: {} of the energy of the waves lies beyond the periods of the responses; the last response holds there.",
            percent(answer.beyond)
        ));
    }
    notes
}

/// Share of a sea beyond the periods of the responses that is worth a warning.
const MUCH_BEYOND: f64 = 0.02;

fn degrees(radians: f64) -> String {
    format!("{} deg", digits(radians.to_degrees(), 4))
}
