//! Irregular seas and motions against the spectra they were asked for.

use super::table::{NumberFormat, Table};
use seacable_engine::scene::{IrregularRecord, records};
use seacable_model::case::Case;
use seacable_numerics::statistics;
use seacable_physics::sea::{Component, Moments};

/// Samples of the shortest component's period.
const SAMPLES: f64 = 20.0;

/// Every irregular record of a case: variance, significant height or root mean square, and mean period between upward
/// crossings, as asked for by the spectrum, as its components make it, and as it comes out over the time of the run, where
/// chance has its part. Empty where nothing is irregular.
#[must_use]
pub fn table(case: &Case) -> Table {
    let records = records(case);
    if records.is_empty() {
        return Table::default();
    }
    let duration = case.solver.duration_s;
    let rows: Vec<MomentsRow> = records.iter().flat_map(|r| rows(r, duration)).collect();
    let digits = NumberFormat::Digits(4, "");
    Table::of_records("", &rows)
        .text("record", |row| &row.name)
        .text("quantity", |row| row.quantity)
        .number("asked for", digits, |row| row.spectrum)
        .number("components", digits, |row| row.components)
        .number("this run", digits, |row| row.run)
        .build()
        .noted([
            "Asked for: of the whole spectrum. Components: of the regular ones it is made of, over all time; they leave out \
             its thin upper end, which the period between crossings feels. This run: over its time, one sample of chance; \
             without the ramp that it may begin with.",
        ])
}

/// A quantity of a record by its spectrum, by its components, and over the time of the run.
struct MomentsRow {
    name: String,
    quantity: &'static str,
    spectrum: f64,
    components: f64,
    run: Option<f64>,
}

fn rows(record: &IrregularRecord, duration: f64) -> [MomentsRow; 3] {
    let (asked, made) = (
        record.spectrum.moments(),
        Moments::of_components(&record.components),
    );
    let run = over(&record.components, duration);
    let (quantity, factor) = if record.of_waves {
        ("Hs = 4 sqrt(m0) [m]", 4.0)
    } else {
        ("rms [m]", 1.0)
    };
    let size = |m0: f64| factor * m0.sqrt();
    let m0 = run.map(|(m0, _)| m0);
    [
        MomentsRow {
            name: record.name.clone(),
            quantity: "m0 [m2]",
            spectrum: asked.m0,
            components: made.m0,
            run: m0,
        },
        MomentsRow {
            name: format!("seed {}, {} parts", record.seed, record.components.len()),
            quantity,
            spectrum: size(asked.m0),
            components: size(made.m0),
            run: m0.map(size),
        },
        MomentsRow {
            name: String::new(),
            quantity: "Tz [s]",
            spectrum: asked.crossing_period(),
            components: made.crossing_period(),
            run: run.and_then(|(_, period)| period),
        },
    ]
}

/// Variance of a record over a time, and its mean period between upward crossings of the mean where it crosses at least
/// twice; nothing where there is no time.
fn over(components: &[Component], duration: f64) -> Option<(f64, Option<f64>)> {
    let fastest = components.iter().map(|c| c.omega).fold(0.0, f64::max);
    if fastest <= 0.0 || duration <= 0.0 {
        return None;
    }
    let count = (duration * fastest / std::f64::consts::TAU * SAMPLES).ceil();
    let step = duration / count.max(1.0);
    let value = |i: usize| -> f64 {
        let t = step * i as f64;
        let each = components.iter();
        each.map(|c| c.amplitude * (c.omega * t + c.phase).cos())
            .sum()
    };
    let values: Vec<f64> = (0..=count as usize).map(value).collect();
    let mean = statistics::mean(&values);
    let variance = statistics::variance(&values, mean);
    // Where the straight line between two samples crosses the mean.
    let pairs = values.windows(2).enumerate();
    let upward = pairs.filter(|(_, v)| v[0] < mean && v[1] >= mean);
    let crossings: Vec<f64> = upward
        .map(|(i, v)| step * (i as f64 + (mean - v[0]) / (v[1] - v[0])))
        .collect();
    let period = match crossings[..] {
        [first, .., last] => Some((last - first) / (crossings.len() - 1) as f64),
        _ => None,
    };
    Some((variance, period))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_regular_record_has_its_variance_and_period() {
        let wave = Component {
            amplitude: 1.5,
            omega: std::f64::consts::TAU / 8.0,
            phase: 0.3,
        };
        let (variance, period) = over(&[wave], 800.0).unwrap();
        assert!((variance - 1.125).abs() < 1e-3);
        assert!((period.unwrap() - 8.0).abs() < 1e-4);
        assert!(over(&[wave], 0.0).is_none());
        assert!(over(&[], 10.0).is_none());
    }

    #[test]
    fn a_long_irregular_sea_comes_out_as_asked_for() {
        let text = include_str!("../../cases/double_stepped/regular_wave.toml")
            .replace("kind = \"regular\"", "kind = \"irregular\"")
            .replace("height_m = 3.0", "significant_height_m = 5.0")
            .replace("\"waves.height_m\"", "\"waves.significant_height_m\"")
            .replace("period_s = 10.0", "peak_period_s = 11.0");
        let mut case = seacable_model::case::parse(&text, "irregular.toml").unwrap();
        case.solver.duration_s = 20_000.0;
        let table = table(&case);
        let number = |column: usize| -> f64 { table.cell(1, column).text.parse().unwrap() };
        assert!((number(2) - 5.0).abs() < 1e-2);
        assert!((number(3) - 5.0).abs() < 1e-2);
        assert!((number(4) - 5.0).abs() < 0.25, "{}", number(4));
        assert_eq!(table.rows.len(), 3);
    }
}
