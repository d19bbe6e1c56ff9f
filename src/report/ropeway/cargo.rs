//! Motion of the cargo in tables and charts: one degree of freedom, and the crossing over the discretised line.

use std::f64::consts::TAU;

use super::tables::{METRES, NEWTONS};
use seacable_base::number::percent;
use seacable_display::chart::{Axis, Chart, Series};
use seacable_display::table::{Align, NumberFormat, Table};
use seacable_systems::ropeway::SolvedRopeway;
use seacable_systems::ropeway::dynamic_crossing::CrossingState;
use seacable_systems::ropeway::oscillator::{CargoOscillator, CargoState, taut_string_rad_per_s};

/// A period.
const SECONDS: NumberFormat = NumberFormat::Decimals(3, "s");

/// Motion of the cargo with one degree of freedom: periods, and ranges over the ship's motion.
#[must_use]
pub fn cargo(solved: &SolvedRopeway) -> Table {
    let position = solved.ropeway.cargo.position;
    let mass = solved.rope.weight_n_per_m / solved.ropeway.about.gravity_m_per_s2;
    let share = solved.ropeway.cargo.mass_kg / (mass * solved.length_m);
    let (rows, note) = match solved.oscillator() {
        Ok(swing) if position > 0.0 && position < 1.0 => (
            facts(solved, &swing, mass),
            format!(
                "Eq. (12) assumes a weightless rope and constant horizontal tension; the mass of the cargo is {} of that of the rope.",
                percent(share)
            ),
        ),
        Ok(_) => (
            Vec::new(),
            "The cargo hangs on a support and does not move.".to_owned(),
        ),
        Err(error) => (Vec::new(), format!("No solution: {error}.")),
    };
    let title = "Motion of the cargo, one degree of freedom (eq. 12)";
    Table::of_records(title, &rows)
        .text("", |row| row.0)
        .cell("value", Align::Decimal, |row| row.1.cell(Some(row.2)))
        .build()
        .noted([note])
}

/// Names, formats and values of the motion; `mass` is that of the rope per length \[kg/m\].
fn facts(
    solved: &SolvedRopeway,
    swing: &CargoOscillator,
    mass: f64,
) -> Vec<(&'static str, NumberFormat, f64)> {
    let hang = solved.cargo_position(solved.ropeway.cargo.position);
    let natural = swing.natural_rad_per_s(&hang);
    let mut facts = vec![
        ("horizontal tension, constant", NEWTONS, swing.horizontal_n),
        ("natural period, massless rope", SECONDS, TAU / natural),
    ];
    if let Ok(w) = taut_string_rad_per_s(swing, &hang, mass) {
        let name = "natural period, taut string with mass";
        facts.push((name, SECONDS, TAU / w));
    }
    facts.extend([
        (
            "damping ratio",
            NumberFormat::Decimals(3, ""),
            swing.damping_ratio,
        ),
        (
            "equilibrium depth below the platform",
            METRES,
            swing.equilibrium_depth_m(&hang),
        ),
    ]);
    if solved.ropeway.motion.is_some()
        && let Ok(swung) = solved.cargo_motion(solved.ropeway.dynamics.duration_s, 0.1)
    {
        let (low, high) = range(swung.iter().map(|s| s.depth_m));
        let (least, greatest) = range(swung.iter().map(most));
        facts.extend([
            ("depth, ship moving, minimum", METRES, low),
            ("depth, ship moving, maximum", METRES, high),
            ("tension, ship moving, minimum", NEWTONS, least),
            ("tension, ship moving, maximum", NEWTONS, greatest),
        ]);
    }
    facts
}

/// The greater of the tensions on both sides of the cargo \[N\].
fn most(swung: &CargoState) -> f64 {
    swung.platform_n.max(swung.ship_n)
}

/// Least and greatest value.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    })
}

/// The crossing by one of its models; absent where a model has no value.
#[derive(Debug, Clone, Copy, Default)]
struct CrossingSummary {
    period_s: Option<f64>,
    lowest_m: Option<f64>,
    greatest_n: Option<f64>,
}

impl CrossingSummary {
    /// Lowest height and greatest tension of a path.
    fn of_path(places: impl Iterator<Item = (f64, f64)>) -> Self {
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

/// The crossing over the discretised line on the dynamic solver compared with eq. (12). It takes a fraction of a second, too
/// long to repeat at every key.
#[must_use]
pub fn dynamic_crossing(solved: &SolvedRopeway) -> (Chart, Table) {
    let mut chart = crossing_chart(solved);
    let hauled = solved.dynamic_crossing();
    if let Ok(hauled) = &hauled {
        let path = hauled.iter().map(|h| (h.x_m, h.z_m)).collect();
        let series = Series::new("line, dynamic", 2, path);
        chart.series.push(series);
    }
    let [one, line, rest] = crossings(solved, hauled.as_deref().unwrap_or_default());
    let models = [
        ("eq. (12)", Some(one)),
        ("line, dynamic", Some(line)),
        ("exact, static", Some(rest)),
    ];
    let title = "Crossing by one degree of freedom and by the line, rope made fast, ship fixed";
    let table = Table::compare(title, "", &models)
        .number("natural period", SECONDS, |m| m.period_s)
        .when(hauled.is_ok(), |table| {
            table
                .number("lowest height above still water", METRES, |m| m.lowest_m)
                .number("greatest tension", NEWTONS, |m| m.greatest_n)
        })
        .build();
    let failed = hauled.err();
    let failed = failed.map(|error| format!("The line has no crossing: {error}."));
    let note = "Eq. (12) neglects the weight and mass of the rope and takes the horizontal tension at the position in the file, with the ship moving by [motion].";
    (chart, table.noted(failed).noted([note]))
}

/// The crossing by eq. (12), over the line, and at rest at the positions of the line.
fn crossings(solved: &SolvedRopeway, hauled: &[CrossingState]) -> [CrossingSummary; 3] {
    let height = solved.ropeway.platform.height_m;
    let position = solved.ropeway.cargo.position;
    let inside = position > 0.0 && position < 1.0;
    let swing = solved.oscillator().ok().filter(|_| inside);
    let own = solved.oscillator_crossing(400).unwrap_or_default();
    let rest = hauled.iter().filter_map(|h| {
        let rest = solved
            .equilibrium(h.x_m / solved.rope.geometry.span_m)
            .ok()?;
        Some((
            height + rest.cargo_m.1,
            rest.platform_n().max(rest.ship_n()),
        ))
    });
    let one = if own.is_empty() {
        CrossingSummary::default()
    } else {
        CrossingSummary::of_path(own.iter().map(|s| (height - s.depth_m, most(s))))
    };
    [
        CrossingSummary {
            period_s: swing
                .map(|swing| TAU / swing.natural_rad_per_s(&solved.cargo_position(position))),
            ..one
        },
        CrossingSummary {
            period_s: solved
                .line_frequency_hz(position)
                .ok()
                .map(|hz| TAU / (TAU * hz)),
            ..CrossingSummary::of_path(hauled.iter().map(|h| (h.z_m, h.platform_n.max(h.ship_n))))
        },
        CrossingSummary::of_path(rest),
    ]
}

/// Path of the cargo: by eq. (12) with the ship moving, by the elastic rope with the ship fixed.
#[must_use]
pub fn crossing_chart(solved: &SolvedRopeway) -> Chart {
    let height = solved.ropeway.platform.height_m;
    let at = |i: usize| {
        let rest = solved.equilibrium(i as f64 / 40.0).ok()?;
        Some((rest.cargo_m.0, height + rest.cargo_m.1))
    };
    let rests = (1..40).filter_map(at).collect();
    let mut series = vec![Series::new("exact, static", 0, rests)];
    if let Ok(swung) = solved.oscillator_crossing(400) {
        let points = swung.iter().map(|s| (s.position.x_m, height - s.depth_m));
        series.push(Series::new("eq. (12)", 1, points.collect()));
    }
    Chart::new(
        "Path of the cargo from the ship to the platform",
        Axis::new("from the platform", "m"),
        Axis::new("height", "m"),
        series,
    )
}
