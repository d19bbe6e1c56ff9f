//! Motion analysis of a ship in a chart and tables: motions in time, target and realised statistics, spectra.

use std::f64::consts::TAU;

use seacable_base::number::{digits, percent};
use seacable_display::chart::{Axis, Chart, Series};
use seacable_display::table::{Align, Cell, CellStyle, NumberFormat, Table};
use seacable_numerics::statistics::{Statistics, expected_gaussian_maximum};
use seacable_physics::sea::{DEGREES, Moments};
use seacable_systems::ship::motion::{DegreeOfFreedom, SparseBand};
use seacable_systems::ship::quantities::{UNITS, scale};
use seacable_systems::ship::{MotionAnalysis, WaveRealisation};

/// Time that is drawn \[s\].
pub(super) const DRAWN: f64 = 300.0;

/// Fraction of wave energy beyond the periods of the RAOs that deserves a warning.
const ENERGY_OUTSIDE: f64 = 0.02;

const FOUR: NumberFormat = NumberFormat::Digits(4, "");

/// The motions over the first minutes of the record: all six, or one alone.
#[must_use]
pub fn motions(analysis: &MotionAnalysis, alone: Option<usize>) -> Chart {
    let motion = &analysis.motion;
    let drawn = motion.instants.min((DRAWN / motion.step) as usize + 1);
    let series = DEGREES.iter().enumerate().map(|(degree, name)| {
        let values = &analysis.records[degree].x;
        let points = (0..drawn).map(|i| (motion.time(i), scale(degree) * values[i]));
        let label = format!("{name} [{}]", UNITS[degree / 3][0]);
        Series {
            visible: alone.is_none_or(|one| one == degree),
            ..Series::new(&label, degree, points.collect())
        }
    });
    Chart::new(
        "Motion of the ship",
        Axis::new("time", "s"),
        Axis::new("motion", ""),
        series.collect(),
    )
}

/// Target and realised statistics of a displacement, velocity or acceleration.
struct RealisedMotion<'a> {
    name: String,
    scale: f64,
    target_rms: f64,
    record: &'a Statistics,
}

impl RealisedMotion<'_> {
    fn scaled(&self, value: f64) -> f64 {
        value * self.scale
    }

    fn error(&self) -> Cell {
        let target = self.scaled(self.target_rms);
        if target <= 0.0 {
            return Cell::none();
        }
        let error = self.scaled(self.record.rms) / target - 1.0;
        let ink = if error.abs() < 0.01 {
            CellStyle::Good
        } else {
            CellStyle::Warn
        };
        Cell::new(relative(error), ink)
    }

    /// The mean, zero where it is small beside the root mean square.
    fn mean(&self) -> f64 {
        let zero = self.record.mean.abs() < 1e-3 * self.record.rms;
        if zero {
            0.0
        } else {
            self.scaled(self.record.mean)
        }
    }

    fn expected_maximum(&self) -> Cell {
        let upcrossings = self.record.crossings as f64;
        let maximum = expected_gaussian_maximum(self.record.deviation, upcrossings);
        Cell::plain(format!(
            "{} ± {}",
            digits(self.scaled(self.record.mean + maximum.expected), 4),
            digits(self.scaled(maximum.spread), 2)
        ))
    }
}

/// Target and realised root mean squares, means, extremes and the expected maximum of each motion and its derivatives.
#[must_use]
pub fn statistics(analysis: &MotionAnalysis, seed: u64) -> Table {
    let motion = &analysis.motion;
    let degrees = motion.degrees.iter().enumerate();
    let rows: Vec<RealisedMotion<'_>> = degrees
        .flat_map(|(i, degree)| {
            (0..3).map(move |rate| RealisedMotion {
                name: format!("{} [{}]", DEGREES[i], UNITS[i / 3][rate]),
                scale: scale(i),
                target_rms: degree.target_rms(rate),
                record: &analysis.statistics[i][rate],
            })
        })
        .collect();
    let title = format!(
        "Motion over {} s, seed {seed}: target and record",
        digits(motion.time(motion.instants), 6)
    );
    let source = if analysis.waves.is_some() {
        "Motions are the response to one sea by the RAOs of the ship. Targets are the moments of the wave spectrum times the squared response."
    } else {
        "Motions of different degrees of freedom are independent: their statistics do not determine their phases."
    };
    Table::of_records(title, &rows)
        .text("motion", |row| row.name.as_str())
        .number("target rms", FOUR, |row| row.scaled(row.target_rms))
        .number("rms", FOUR, |row| row.scaled(row.record.rms))
        .cell("error", Align::Decimal, RealisedMotion::error)
        .number("mean", FOUR, RealisedMotion::mean)
        .number("min", FOUR, |row| row.scaled(row.record.min))
        .number("max", FOUR, |row| row.scaled(row.record.max))
        .cell("expected max", Align::Decimal, RealisedMotion::expected_maximum)
        .build()
        .noted([
            "Root mean squares are about zero, the mean included. The expected maximum is the mean, over many records of this length, of the maximum of a Gaussian record, with its standard deviation from record to record (Cartwright and Longuet-Higgins 1956).",
            source,
        ])
}

/// A relative error, zero where it is rounding.
fn relative(error: f64) -> String {
    percent(if error.abs() < 1e-6 { 0.0 } else { error })
}

/// Target and realised moments of a spectrum.
struct SpectrumComparison<'a> {
    name: String,
    target: Moments,
    realised: Moments,
    record: &'a Statistics,
}

/// Zero-upcrossing period Tz = 2π √(m0/m2) \[s\]; none without motion.
fn period(moments: &Moments) -> Option<f64> {
    (moments.m2 > 0.0).then(|| moments.crossing_period())
}

/// Target and realised variance and mean period of every motion, and how far the records are from Gaussian; of the waves
/// first where the motion is a response to them.
#[must_use]
pub fn spectra(analysis: &MotionAnalysis) -> Table {
    const MOMENT: NumberFormat = NumberFormat::With(|m0| format!("{m0:.4e}"));
    const THREE: NumberFormat = NumberFormat::Decimals(3, "");
    let waves = analysis.waves.iter().map(|waves| SpectrumComparison {
        name: "waves".to_owned(),
        target: waves.target,
        realised: waves.realised,
        record: &waves.elevation,
    });
    let degrees = analysis.motion.degrees.iter().zip(&analysis.statistics);
    let motions = degrees.enumerate().map(|(i, (degree, record))| {
        let square = scale(i).powi(2);
        let moments = |x: f64, v: f64| Moments {
            m0: x * x * square,
            m2: v * v * square,
        };
        SpectrumComparison {
            name: format!("{}{}", DEGREES[i], bands(degree)),
            target: moments(degree.target.displacement, degree.target.velocity),
            realised: moments(record[0].deviation, record[1].deviation),
            record: &record[0],
        }
    });
    let rows: Vec<SpectrumComparison<'_>> = waves.chain(motions).collect();
    let error = |row: &SpectrumComparison<'_>| {
        (row.target.m0 > 0.0).then(|| row.realised.m0 / row.target.m0 - 1.0)
    };
    Table::of_records("Spectra: target and record", &rows)
        .text("motion", |row| row.name.as_str())
        .number("target m0", MOMENT, |row| row.target.m0)
        .number("m0", MOMENT, |row| row.realised.m0)
        .number("error", NumberFormat::With(relative), error)
        .number("target Tz", FOUR, |row| period(&row.target))
        .number("Tz", FOUR, |row| period(&row.realised))
        .number("skewness", THREE, |row| row.record.skewness)
        .number("excess", THREE, |row| row.record.excess)
        .count("crossings", |row| row.record.crossings)
        .build()
        .noted(notes(analysis))
}

/// The periods of the bands of a motion.
fn bands(degree: &DegreeOfFreedom) -> String {
    let intervals = degree.bands.iter().map(|band| {
        let (low, high) = band.edges();
        let period = |omega: f64| digits(TAU / omega, 3);
        format!("{}-{}", period(high), period(low))
    });
    let intervals = intervals.collect::<Vec<_>>().join(", ");
    if intervals.is_empty() {
        intervals
    } else {
        format!(", bands {intervals} s")
    }
}

fn notes(analysis: &MotionAnalysis) -> Vec<String> {
    const GAUSSIAN: &str = "m0 in m² and deg²; Tz = 2 pi sqrt(m0/m2) in s. A Gaussian record has zero skewness and excess kurtosis; of n independent cycles their standard errors are sqrt(6/n) and sqrt(24/n).";
    match &analysis.waves {
        Some(waves) => wave_notes(analysis, waves, GAUSSIAN),
        None => {
            let mut notes = vec![
                format!(
                    "Component frequencies are multiples of that of the record, so that its moments are the targets. {GAUSSIAN}"
                ),
                "Spectra are constant over their bands: three moments of each motion are known, the shape is not."
                    .to_owned(),
            ];
            notes.extend(analysis.motion.narrow_bands().iter().map(too_narrow));
            notes
        }
    }
}

/// The warning that a band has too few frequencies in the record.
fn too_narrow(narrow: &SparseBand) -> String {
    let (low, high) = narrow.band.edges();
    let frequencies = match narrow.frequencies {
        1 => "1 frequency".to_owned(),
        n => format!("{n} frequencies"),
    };
    format!(
        "WARNING: {}: its band, {} to {} s, has {frequencies} in this record, too few for a Gaussian record: extremes are at most {} standard deviations, and the expected maximum of {} does not apply. A longer record has more.",
        DEGREES[narrow.degree],
        digits(TAU / high, 4),
        digits(TAU / low, 4),
        digits(narrow.greatest, 3),
        digits(narrow.expected, 3),
    )
}

fn wave_notes(analysis: &MotionAnalysis, waves: &WaveRealisation, gaussian: &str) -> Vec<String> {
    let response = &waves.response;
    let degrees = |radians: f64| format!("{} deg", digits(radians.to_degrees(), 4));
    let sea = |moments: &Moments| {
        format!(
            "{} m and {} s",
            digits(moments.significant_height(), 4),
            digits(moments.crossing_period(), 4)
        )
    };
    let mut notes = vec![
        format!(
            "Significant height and mean period: target {}, record {}. Wave direction {} from the bow (180 deg: head seas), heading {}; {} components.",
            sea(&waves.target),
            sea(&waves.realised),
            degrees(response.relative_direction),
            degrees(response.heading),
            analysis.motion.waves.len()
        ),
        format!(
            "Targets are integrals of the wave spectrum, and of it times the squared response. A record of three hours holds about a thousand waves: its m0 scatters by some per cent. {gaussian}"
        ),
    ];
    if response.energy_outside > ENERGY_OUTSIDE {
        notes.push(format!(
            "WARNING: {} of the wave energy is outside the periods of the RAOs; the RAO of the nearest period applies there.",
            percent(response.energy_outside)
        ));
    }
    notes
}
