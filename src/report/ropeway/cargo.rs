//! The cargo's own motion in tables and charts: one degree of freedom, and the crossing over the discretised line.

use std::f64::consts::TAU;

use super::tables::{METRES, NEWTONS};
use crate::report::chart::{Axis, Chart, Series};
use crate::report::number::percent;
use crate::report::table::{Align, Format, Table};
use crate::ropeway::Worked;
use crate::ropeway::full::Hauled;
use crate::ropeway::swing::{Swing, Swung, string_rad_per_s};

/// A period.
const SECONDS: Format = Format::Decimals(3, "s");

/// The cargo's own motion: periods, and what the ship's motion makes of it.
#[must_use]
pub fn cargo(worked: &Worked) -> Table {
    let position = worked.ropeway.cargo.position;
    let mass = worked.span.weight_n_per_m / worked.ropeway.about.gravity_m_per_s2;
    let share = worked.ropeway.cargo.mass_kg / (mass * worked.length_m);
    let (rows, note) = match worked.swing() {
        Ok(swing) if position > 0.0 && position < 1.0 => (
            facts(worked, &swing, mass),
            format!(
                "Eq. (12) takes the rope as weightless and its pull as kept; the cargo's mass is {} of the rope's.",
                percent(share)
            ),
        ),
        Ok(_) => (
            Vec::new(),
            "The cargo hangs on a support and does not move.".to_owned(),
        ),
        Err(trouble) => (Vec::new(), format!("No answer: {trouble}.")),
    };
    let title = "The cargo's own motion, one degree of freedom (eq. 12)";
    Table::of(title, &rows)
        .text("", |row| row.0)
        .cell("value", Align::Decimal, |row| row.1.cell(Some(row.2)))
        .build()
        .noted([note])
}

/// Names, formats and values of the motion; `mass` is that of the rope per length \[kg/m\].
fn facts(worked: &Worked, swing: &Swing, mass: f64) -> Vec<(&'static str, Format, f64)> {
    let hang = worked.hang(worked.ropeway.cargo.position);
    let natural = swing.natural_rad_per_s(&hang);
    let mut facts = vec![
        ("horizontal pull, kept", NEWTONS, swing.horizontal_n),
        ("natural period, rope without mass", SECONDS, TAU / natural),
    ];
    if let Ok(w) = string_rad_per_s(swing, &hang, mass) {
        let name = "natural period, taut string with its mass";
        facts.push((name, SECONDS, TAU / w));
    }
    facts.extend([
        (
            "damping ratio",
            Format::Decimals(3, ""),
            swing.damping_ratio,
        ),
        (
            "depth at rest below the platform's hang point",
            METRES,
            swing.settled_m(&hang),
        ),
    ]);
    if worked.ropeway.motion.is_some()
        && let Ok(swung) = worked.swung(worked.ropeway.dynamics.duration_s, 0.1)
    {
        let (low, high) = range(swung.iter().map(|s| s.depth_m));
        let (least, greatest) = range(swung.iter().map(most));
        facts.extend([
            ("depth while the ship moves, least", METRES, low),
            ("depth while the ship moves, greatest", METRES, high),
            ("tension while the ship moves, least", NEWTONS, least),
            ("tension while the ship moves, greatest", NEWTONS, greatest),
        ]);
    }
    facts
}

/// The greater of the tensions on both sides of the cargo \[N\].
fn most(swung: &Swung) -> f64 {
    swung.platform_n.max(swung.ship_n)
}

/// Least and greatest.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
}

/// The crossing by one of its models; absent where a model has no value.
#[derive(Debug, Clone, Copy, Default)]
struct Crossing {
    period_s: Option<f64>,
    lowest_m: Option<f64>,
    greatest_n: Option<f64>,
}

impl Crossing {
    /// Lowest height and greatest tension of places on the way.
    fn of(places: impl Iterator<Item = (f64, f64)>) -> Self {
        let (lowest, greatest) = places.fold((f64::INFINITY, 0.0_f64), |(low, high), (z, n)| {
            (low.min(z), high.max(n))
        });
        Self {
            lowest_m: Some(lowest),
            greatest_n: Some(greatest),
            period_s: None,
        }
    }
}

/// The crossing over the full line on the dynamic solver beside eq. (12): its path drawn, its numbers in a table. It takes a
/// fraction of a second, which is too long for every key.
#[must_use]
pub fn full(worked: &Worked) -> (Chart, Table) {
    let mut chart = crossing_chart(worked);
    let hauled = worked.hauled();
    if let Ok(hauled) = &hauled {
        let path = hauled.iter().map(|h| (h.x_m, h.z_m)).collect();
        let series = Series::new("full line, hauled in", 2, path);
        chart.series.push(series);
    }
    let [one, line, rest] = crossings(worked, hauled.as_deref().unwrap_or_default());
    let models = [
        ("eq. (12)", Some(one)),
        ("full line", Some(line)),
        ("at rest", Some(rest)),
    ];
    let title =
        "One degree of freedom beside the full line, the rope made fast and the ship lying still";
    let table = Table::compare(title, "", &models)
        .number("natural period", SECONDS, |m| m.period_s)
        .when(hauled.is_ok(), |table| {
            table
                .number("lowest on the way, above still water", METRES, |m| {
                    m.lowest_m
                })
                .number("greatest tension on the way", NEWTONS, |m| m.greatest_n)
        })
        .build();
    let failed = hauled.err();
    let failed = failed.map(|trouble| format!("No crossing of the full line: {trouble}."));
    let note = "Eq. (12) leaves out the rope's weight and mass and keeps the pull of the cargo's place in the file, with the ship moving where the file moves it.";
    (chart, table.noted(failed).noted([note]))
}

/// The crossing by eq. (12), over the full line, and at rest at the places of the full line.
fn crossings(worked: &Worked, hauled: &[Hauled]) -> [Crossing; 3] {
    let height = worked.ropeway.platform.height_m;
    let position = worked.ropeway.cargo.position;
    let inside = position > 0.0 && position < 1.0;
    let swing = worked.swing().ok().filter(|_| inside);
    let own = worked.crossing(400).unwrap_or_default();
    let rest = hauled.iter().filter_map(|h| {
        let rest = worked.rest(h.x_m / worked.span.gap.span_m).ok()?;
        Some((
            height + rest.cargo_m.1,
            rest.platform_n().max(rest.ship_n()),
        ))
    });
    let one = if own.is_empty() {
        Crossing::default()
    } else {
        Crossing::of(own.iter().map(|s| (height - s.depth_m, most(s))))
    };
    [
        Crossing {
            period_s: swing.map(|swing| TAU / swing.natural_rad_per_s(&worked.hang(position))),
            ..one
        },
        Crossing {
            period_s: worked.full_hz(position).ok().map(|hz| TAU / (TAU * hz)),
            ..Crossing::of(hauled.iter().map(|h| (h.z_m, h.platform_n.max(h.ship_n))))
        },
        Crossing::of(rest),
    ]
}

/// Depth of the cargo on its way across: eq. (12) with the ship moving, the exact rope with the ship lying still.
#[must_use]
pub fn crossing_chart(worked: &Worked) -> Chart {
    let height = worked.ropeway.platform.height_m;
    let at = |i: usize| {
        let rest = worked.rest(i as f64 / 40.0).ok()?;
        Some((rest.cargo_m.0, height + rest.cargo_m.1))
    };
    let rests = (1..40).filter_map(at).collect();
    let mut series = vec![Series::new("exact, at rest", 0, rests)];
    if let Ok(swung) = worked.crossing(400) {
        let points = swung.iter().map(|s| (s.hang.x_m, height - s.depth_m));
        series.push(Series::new("eq. (12), hauled in", 1, points.collect()));
    }
    Chart {
        title: "Path of the cargo from the ship to the platform".to_owned(),
        x: Axis::new("from the platform", "m"),
        y: Axis::new("height", "m"),
        series,
        legend: true,
        ..Chart::default()
    }
}
