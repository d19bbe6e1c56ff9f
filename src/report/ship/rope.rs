//! The rope between the moving ship and a platform in charts and tables.

use super::motion::DRAWN;
use crate::ropeway::winch;
use seacable_base::number::{digits, percent, si};
use seacable_display::chart::{Axis, Chart, Series};
use seacable_display::table::{Columns, NumberFormat, Table};
use seacable_numerics::statistics::Statistics;
use seacable_systems::ropeway::RopewayError;
use seacable_systems::ropeway::winch::{WinchSample, statistics as samples_statistics};
pub use seacable_systems::ship::rope::RopeAnalysis;
use seacable_systems::ship::rope::dynamic::DynamicRope;

const FORCE: NumberFormat = NumberFormat::Si("N");

fn tension_chart(title: &str, series: Vec<Series>) -> Chart {
    let tension = Axis::new("tension at the ship", "N");
    Chart::new(title, Axis::new("time", "s"), tension, series)
}

/// Tension at the ship over the first minutes, made fast and on the winch.
#[must_use]
pub fn chart(rope: &RopeAnalysis) -> Chart {
    let series = winch::tensions(&rope.winch, DRAWN);
    tension_chart("Tension of the rope at the ship", series)
}

/// Statistics of a tension \[N\], a column each.
fn statistics<'a, R>(
    columns: Columns<'a, R>,
    of: impl Fn(&'a R) -> Option<[f64; 5]> + Copy,
) -> Columns<'a, R> {
    let heads = ["mean", "rms", "std dev", "min", "max"];
    heads
        .into_iter()
        .enumerate()
        .fold(columns, |columns, (i, head)| {
            columns.number(head, FORCE, move |row| Some(of(row)?[i]))
        })
}

fn values(statistics: &Statistics) -> [f64; 5] {
    let Statistics {
        mean,
        rms,
        deviation,
        min,
        max,
        ..
    } = *statistics;
    [mean, rms, deviation, min, max]
}

/// Statistics of the tension, made fast and on the winch, and the expected maximum.
#[must_use]
pub fn table(rope: &RopeAnalysis) -> Table {
    let title = format!(
        "Rope at the moving ship: {}",
        rope.ropeway.ropeway.about.title
    );
    let kept = rope.winch.constant_tension.as_ref();
    let rows: Vec<(&str, &Result<Vec<WinchSample>, RopewayError>)> =
        std::iter::once(("made fast", &rope.winch.made_fast))
            .chain(kept.map(|kept| ("on the winch", kept)))
            .collect();
    let of = |row: &(&str, &Result<Vec<WinchSample>, RopewayError>)| {
        let samples = row.1.as_ref().ok()?;
        Some(values(&samples_statistics(samples, |s| s.ship_n)))
    };
    let failures = rows.iter().filter_map(|(name, samples)| {
        let error = samples.as_ref().err()?;
        Some(format!("WARNING: {name}: {error}."))
    });
    let winch = kept.and_then(|kept| kept.as_ref().ok());
    let winch = winch.map(|samples| winch_notes(samples, rope.winch.tension_n));
    statistics(Table::of_records(title, &rows).text("rope", |row| row.0), of)
        .build()
        .noted(failures)
        .noted(winch.into_iter().flatten())
        .noted(expected_maximum(rope))
        .noted([
            "Each instant is an equilibrium of the exact rope with its cargo; the table of the dynamic solver includes inertia.",
        ])
}

fn expected_maximum(rope: &RopeAnalysis) -> Option<String> {
    if let Some(gumbel) = &rope.gumbel {
        return Some(format!(
            "Expected maximum tension with the rope made fast: {} ± {} from record to record, by a Gumbel distribution fitted by moments to the maxima of {} records of as many seeds; standard error of the mean {}; exceeded by one record in ten: {}.",
            si(gumbel.greatest.expected, "N"),
            si(gumbel.greatest.spread, "N"),
            rope.maxima_n.len(),
            si(gumbel.error, "N"),
            si(gumbel.quantile(0.9), "N"),
        ));
    }
    if !rope.more_seeds {
        return Some("No expected maximum: there is one record of ship and anchor line in the time domain, that of its seed.".to_owned());
    }
    let short = "No expected maximum: slightly beyond the motion of this record, the rope made fast is too short.";
    rope.winch.made_fast.is_ok().then(|| short.to_owned())
}

/// Quasi-static and dynamic tension of the rope made fast around its maximum; absent where the rope has no solution.
#[must_use]
pub fn dynamic_chart(rope: &RopeAnalysis) -> Option<Chart> {
    let dynamic = rope.dynamic.as_ref()?.as_ref().ok()?;
    let series = |label: &str, slot: usize, values: &[f64]| {
        let pairs = dynamic.times.iter().zip(values).skip(dynamic.first);
        Series::new(label, slot, pairs.map(|(t, value)| (*t, *value)).collect())
    };
    let series = vec![
        series("equilibria", 0, &dynamic.quasi_static),
        series("dynamic solver", 1, &dynamic.dynamic),
    ];
    Some(tension_chart(
        "Rope made fast, around its maximum tension",
        series,
    ))
}

/// The rope made fast, dynamic against quasi-static; absent where the rope has no solution.
#[must_use]
pub fn dynamic_table(rope: &RopeAnalysis) -> Option<Table> {
    let title = "Rope made fast: dynamic against quasi-static";
    let dynamic = match rope.dynamic.as_ref()? {
        Ok(dynamic) => dynamic,
        Err(error) => {
            let warning = format!("WARNING: no solution: {error}.");
            return Some(Table::titled(title).noted([warning]));
        }
    };
    let [quasi_static, inertial] = dynamic.statistics();
    let (a, b) = (values(&quasi_static), values(&inertial));
    let rows = [
        ("quasi-static, equilibria", a),
        ("dynamic solver", b),
        ("difference", std::array::from_fn(|i| b[i] - a[i])),
    ];
    let columns = Table::of_records(title, &rows).text("tension at the ship", |row| row.0);
    let table = statistics(columns, |row: &(&str, [f64; 5])| Some(row.1))
        .build()
        .noted(dynamic_notes(dynamic, quasi_static.deviation));
    Some(table)
}

fn dynamic_notes(dynamic: &DynamicRope, deviation: f64) -> [String; 2] {
    let first = dynamic.times.get(dynamic.first).copied().unwrap_or(0.0);
    let last = dynamic.times.last().copied().unwrap_or(0.0);
    let error = |error: Option<f64>| error.map_or_else(|| "-".to_owned(), |error| si(error, "N"));
    let difference = dynamic.rms_difference();
    [
        format!(
            "From {} s to {} s of the record, around its maximum tension; root mean square difference {}, {} of the standard deviation. The winch, which changes the length of the rope, is not modelled in the dynamic solver: the rope is made fast.",
            digits(first, 6),
            digits(last, 6),
            si(difference, "N"),
            percent(difference / deviation.max(f64::MIN_POSITIVE))
        ),
        format!(
            "Errors of the maximum tension: time step {}, mesh {}; {} steps, {} Newton iterations.",
            error(dynamic.time_error),
            error(dynamic.mesh_error),
            dynamic.work.steps,
            dynamic.work.iterations
        ),
    ]
}

/// What the winch does, and how often it is at a limit.
fn winch_notes(samples: &[WinchSample], tension: f64) -> Vec<String> {
    let of = |quantity: fn(&WinchSample) -> f64| samples_statistics(samples, quantity);
    let length = of(|s| s.length_m);
    let mut notes = vec![format!(
        "The winch keeps {}: rope speed up to {} m/s, power up to {}, {} m of rope paid out and hauled in.",
        si(tension, "N"),
        digits(of(|s| s.speed_m_per_s.abs()).max, 3),
        si(of(|s| s.power_w.abs()).max, "W"),
        digits(length.max - length.min, 3),
    )];
    notes.extend(winch::limits(samples));
    notes
}
