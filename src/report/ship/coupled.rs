//! The ship and its anchor line in time, in charts and tables.

use crate::report::chart::{Axis, Chart, Series};
use crate::report::number::{digits, percent};
use crate::report::table::{Cell, Column, Table};
use crate::ship::coupled::free_decay::FreeDecay;
use crate::ship::coupled::{CHANNELS, CoupledAnalysis};

/// Time that is drawn \[s\].
const MINUTES: f64 = 300.0;

/// Channels on the chart of the ship, and of the line.
const SHIP: [usize; 3] = [0, 1, 5];
const LINE: [usize; 2] = [9, 10];

/// The slow motions of the ship over the first minutes that count.
#[must_use]
pub fn motions(coupled: &CoupledAnalysis) -> Chart {
    drawn(
        coupled,
        &SHIP,
        "Ship on its anchor line: motions in the plane",
        "motion",
        "",
    )
}

/// The tension of the anchor line over the same time.
#[must_use]
pub fn tension(coupled: &CoupledAnalysis) -> Chart {
    drawn(coupled, &LINE, "Tension of the anchor line", "tension", "N")
}

fn drawn(
    coupled: &CoupledAnalysis,
    channels: &[usize],
    title: &str,
    axis: &str,
    unit: &str,
) -> Chart {
    let from = (coupled.settings.from_s / coupled.step).round() as usize;
    let count = (MINUTES / coupled.step) as usize;
    let series = channels.iter().enumerate().map(|(slot, channel)| {
        let record = coupled.records.get(*channel).map_or(&[][..], Vec::as_slice);
        let shown = record.iter().enumerate().skip(from).take(count + 1);
        let points = shown.map(|(i, value)| (coupled.step * i as f64, *value));
        let (name, of) = CHANNELS[*channel];
        let label = if unit.is_empty() {
            format!("{name} [{of}]")
        } else {
            name.to_owned()
        };
        Series::new(&label, slot, points.collect())
    });
    Chart {
        title: title.to_owned(),
        x: Axis::new("time", "s"),
        y: Axis::new(axis, unit),
        series: series.collect(),
        legend: true,
        ..Chart::default()
    }
}

/// Statistics of every channel, with the errors of step and mesh.
#[must_use]
pub fn statistics(coupled: &CoupledAnalysis) -> Table {
    let row = |(i, (name, unit)): (usize, &(&str, &str))| {
        let of = &coupled.statistics[i];
        let error = |errors: &Option<Vec<f64>>| {
            errors
                .as_ref()
                .map_or_else(|| "-".to_owned(), |list| digits(list[i], 2))
        };
        let mut cells = vec![Cell::plain(format!("{name} [{unit}]"))];
        let values = [of.mean, of.deviation, of.min, of.max];
        cells.extend(values.map(|value| Cell::plain(digits(value, 4))));
        cells.push(Cell::plain(error(&coupled.time_errors)));
        cells.push(Cell::plain(error(&coupled.mesh_errors)));
        cells
    };
    Table {
        title: format!(
            "Ship and anchor line in time, from {} s to {} s",
            digits(coupled.settings.from_s, 6),
            digits(coupled.settings.duration_s, 6)
        ),
        columns: vec![
            Column::left("channel"),
            Column::decimal("mean"),
            Column::decimal("deviation"),
            Column::decimal("least"),
            Column::decimal("greatest"),
            Column::decimal("step error"),
            Column::decimal("mesh error"),
        ],
        rows: CHANNELS.iter().enumerate().map(row).collect(),
        notes: notes(coupled),
    }
}

fn notes(coupled: &CoupledAnalysis) -> Vec<String> {
    let settings = &coupled.settings;
    let work = &coupled.work;
    let mut notes = vec![
        "Displacements are from the place at which the ship rests, along and across its heading there. Errors are root mean squares over the record, by a companion with half the step and one with half the segments (Richardson, order two).".to_owned(),
        format!(
            "Step {} s, {} segments: {} steps, {} of them halved, {} Newton iterations.",
            digits(settings.step_s, 4),
            settings.segments,
            work.steps,
            work.halved,
            work.iterations
        ),
        "Ship and line are solved in one Newton. Rotations are of first order; wind, current and drift act by their coefficients on the ship as it turns and moves; the line hangs in still water.".to_owned(),
    ];
    notes.push(if coupled.waves {
        "Waves act by the loads that make the free ship answer them as its responses say."
            .to_owned()
    } else {
        "No waves act: [motion] made from responses brings them.".to_owned()
    });
    if coupled.time_errors.is_none() || coupled.mesh_errors.is_none() {
        notes.push("WARNING: a companion gave up, so that not all errors are told.".to_owned());
    }
    notes
}

/// The free decay against the linearised equations.
#[must_use]
pub fn decay(coupled: &CoupledAnalysis) -> Table {
    let columns = vec![
        Column::left("slowest swinging motion"),
        Column::decimal("period"),
        Column::decimal("left after a period"),
    ];
    let title = "Free decay: the ship let go, no waves".to_owned();
    let FreeDecay {
        linear_s,
        measured_s,
        linear_left,
        measured_left,
    } = match &coupled.decay {
        Ok(decay) => *decay,
        Err(why) => {
            return Table {
                title,
                notes: vec![format!("No check: {why}.")],
                ..Table::default()
            };
        }
    };
    let row = |name: &str, period: f64, left: f64| {
        vec![
            Cell::plain(name),
            Cell::plain(format!("{} s", digits(period, 5))),
            Cell::plain(percent(left)),
        ]
    };
    Table {
        title,
        columns,
        rows: vec![
            row("linearised, closed form", linear_s, linear_left),
            row("ship and line in time", measured_s, measured_left),
            vec![
                Cell::plain("off by"),
                Cell::plain(percent(measured_s / linear_s - 1.0)),
                Cell::plain(""),
            ],
        ],
        notes: vec![
            "Linearised: surge, sway and yaw on a quasi-static line (eq. 4). In time the line has its own inertia and drag, and its mesh.".to_owned(),
        ],
    }
}
