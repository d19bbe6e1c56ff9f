//! Coupled analysis of ship and anchor line in charts and tables.

use super::motion::DRAWN;
use seacable_base::number::{digits, percent};
use seacable_display::chart::{Axis, Chart, Series};
use seacable_display::table::{NumberFormat, Table};
use seacable_systems::ship::coupled::{CHANNELS, CoupledAnalysis};

/// Channels of the charts of ship and line.
const SHIP: [usize; 3] = [0, 1, 5];
const LINE: [usize; 2] = [9, 10];

/// Surge, sway and yaw over the first minutes of the statistics.
#[must_use]
pub fn motions(coupled: &CoupledAnalysis) -> Chart {
    let label = |(name, unit): (&str, &str)| format!("{name} [{unit}]");
    let title = "Ship on its anchor line: motions in the horizontal plane";
    let series = series(coupled, &SHIP, label);
    Chart::new(
        title,
        Axis::new("time", "s"),
        Axis::new("motion", ""),
        series,
    )
}

/// Tension of the anchor line over the same time.
#[must_use]
pub fn tension(coupled: &CoupledAnalysis) -> Chart {
    let series = series(coupled, &LINE, |(name, _)| name.to_owned());
    let (time, tension) = (Axis::new("time", "s"), Axis::new("tension", "N"));
    Chart::new("Tension of the anchor line", time, tension, series)
}

fn series(
    coupled: &CoupledAnalysis,
    channels: &[usize],
    label: impl Fn((&str, &str)) -> String,
) -> Vec<Series> {
    let from = (coupled.settings.from_s / coupled.step).round() as usize;
    let count = (DRAWN / coupled.step) as usize;
    let one = |(slot, channel): (usize, &usize)| {
        let record = coupled.records.get(*channel).map_or(&[][..], Vec::as_slice);
        let drawn = record.iter().enumerate().skip(from).take(count + 1);
        let points = drawn.map(|(i, value)| (coupled.step * i as f64, *value));
        Series::new(&label(CHANNELS[*channel]), slot, points.collect())
    };
    channels.iter().enumerate().map(one).collect()
}

/// Statistics of every channel with time-step and mesh errors.
#[must_use]
pub fn statistics(coupled: &CoupledAnalysis) -> Table {
    const FOUR: NumberFormat = NumberFormat::Digits(4, "");
    const TWO: NumberFormat = NumberFormat::Digits(2, "");
    let title = format!(
        "Ship and anchor line in the time domain, from {} s to {} s",
        digits(coupled.settings.from_s, 6),
        digits(coupled.settings.duration_s, 6)
    );
    let channels: Vec<usize> = (0..CHANNELS.len()).collect();
    let of = |i: &usize| &coupled.statistics[*i];
    let error = |errors: &Option<Vec<f64>>, i: usize| errors.as_ref().map(|errors| errors[i]);
    Table::of_records(title, &channels)
        .text("channel", |i| {
            format!("{} [{}]", CHANNELS[*i].0, CHANNELS[*i].1)
        })
        .number("mean", FOUR, |i| of(i).mean)
        .number("std dev", FOUR, |i| of(i).deviation)
        .number("min", FOUR, |i| of(i).min)
        .number("max", FOUR, |i| of(i).max)
        .number("time error", TWO, |i| error(&coupled.time_errors, *i))
        .number("mesh error", TWO, |i| error(&coupled.mesh_errors, *i))
        .build()
        .noted(notes(coupled))
}

fn notes(coupled: &CoupledAnalysis) -> Vec<String> {
    let (settings, work) = (&coupled.settings, &coupled.work);
    let mut notes = vec![
        "Displacements from the equilibrium position, along and across the equilibrium heading. Errors are root mean squares over the record, by Richardson extrapolation from half the step and from half the segments (second order).".to_owned(),
        format!(
            "Step {} s, {} segments: {} steps, {} of them halved, {} Newton iterations.",
            digits(settings.step_s, 4),
            settings.segments,
            work.steps,
            work.halved,
            work.iterations
        ),
        "A system of a free body and a line, solved in one Newton iteration. The added mass acts to first order, as the wave loads do; wind, current and drift act by their coefficients on the moving ship; the line is in still water.".to_owned(),
        if coupled.waves {
            "First-order wave loads are those that give the free ship its RAOs."
        } else {
            "No wave loads: they need [motion] by responses."
        }
        .to_owned(),
    ];
    if coupled.time_errors.is_none() || coupled.mesh_errors.is_none() {
        notes.push(
            "WARNING: a run for the error estimate failed; its errors are missing.".to_owned(),
        );
    }
    notes
}

/// Free decay against the linearised equations.
#[must_use]
pub fn decay(coupled: &CoupledAnalysis) -> Table {
    let title = "Free decay in the slowest oscillating mode, no waves";
    let decay = match &coupled.decay {
        Ok(decay) => decay,
        Err(error) => return Table::titled(title).noted([format!("No free decay: {error}.")]),
    };
    let error = decay.measured_s / decay.linear_s - 1.0;
    let rows = [
        ("linearised (eq. 4)", decay.linear_s, decay.linear_ratio),
        ("time domain", decay.measured_s, decay.measured_ratio),
    ];
    Table::of_records(title, &rows)
        .text("model", |row| row.0)
        .number("period", NumberFormat::Digits(5, "s"), |row| row.1)
        .number("amplitude ratio of a period", NumberFormat::Percent, |row| row.2)
        .build()
        .noted([
            format!("The periods differ by {}.", percent(error)),
            "Linearised: surge, sway and yaw on a quasi-static line. In the time domain the line has inertia, drag and a mesh.".to_owned(),
        ])
}
