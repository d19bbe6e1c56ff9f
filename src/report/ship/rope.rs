//! The rope at sea in a chart and a table.

use crate::numerics::statistics::Statistics;
use crate::report::chart::{Axis, Chart, Series};
use crate::report::number::{digits, percent, si};
use crate::report::table::{Cell, CellInk, Column, Table};
use crate::ropeway::RopewayError;
use crate::ropeway::winch::WinchSample;
use crate::ship::rope::RopeAnalysis;

/// Time that is drawn \[s\].
const MINUTES: f64 = 300.0;

/// Tension at the ship over the first minutes, made fast and held by the winch.
#[must_use]
pub fn chart(rope: &RopeAnalysis) -> Chart {
    let points = |moments: &[WinchSample]| -> Vec<(f64, f64)> {
        moments
            .iter()
            .take_while(|moment| moment.ship.time_s <= MINUTES)
            .map(|moment| (moment.ship.time_s, moment.ship_n))
            .collect()
    };
    let mut series = Vec::new();
    if let Ok(fast) = &rope.followed.made_fast {
        series.push(Series::new("made fast", 0, points(fast)));
    }
    if let Some(Ok(kept)) = &rope.followed.constant_tension {
        series.push(Series::new("with the winch", 1, points(kept)));
    }
    Chart {
        title: "Tension of the rope at the ship".to_owned(),
        x: Axis::new("time", "s"),
        y: Axis::new("tension", "N"),
        series,
        legend: true,
        ..Chart::default()
    }
}

/// Statistics of the tension, made fast and held by the winch, and the greatest to expect.
#[must_use]
pub fn table(rope: &RopeAnalysis) -> Table {
    let mut notes = Vec::new();
    let mut rows = vec![row("made fast", &rope.followed.made_fast, &mut notes)];
    if let Some(kept) = &rope.followed.constant_tension {
        rows.push(row("with the winch", kept, &mut notes));
        if let Ok(moments) = kept {
            notes.extend(winch(moments, rope.followed.tension_n));
        }
    }
    if let Some(law) = &rope.law {
        notes.push(format!(
            "Greatest tension to expect with the rope made fast: {} ± {} from record to record, by Gumbel's law fitted by moments to the greatest of {} records of as many seeds; its mean is known to {}; one record in ten goes beyond {}.",
            si(law.greatest.expected, "N"),
            si(law.greatest.spread, "N"),
            rope.maxima_n.len(),
            si(law.error, "N"),
            si(law.quantile(0.9), "N"),
        ));
    }
    if !rope.others {
        notes.push("No greatest tension to expect is told: there is one record of ship and anchor line in time, and it is that of its seed.".to_owned());
    } else if rope.law.is_none() && rope.followed.made_fast.is_ok() {
        notes.push("No greatest tension to expect is told: a little further than this record goes, the rope made fast no longer reaches.".to_owned());
    }
    notes.push("Each instant is an equilibrium of the exact rope with its cargo; what its inertia adds stands in the table of the rope on the dynamic solver.".to_owned());
    Table {
        title: format!(
            "The rope at the moving ship: {}",
            rope.worked.ropeway.about.title
        ),
        columns: vec![
            Column::left("rope"),
            Column::decimal("mean"),
            Column::decimal("rms"),
            Column::decimal("deviation"),
            Column::decimal("least"),
            Column::decimal("greatest"),
        ],
        rows,
        notes,
    }
}

/// Both readings of the rope made fast over the stretch that the dynamic solver follows; absent where there is none.
#[must_use]
pub fn dynamic_chart(rope: &RopeAnalysis) -> Option<Chart> {
    let beside = rope.dynamic.as_ref()?.as_ref().ok()?;
    let points = |values: &[f64]| -> Vec<(f64, f64)> {
        let pairs = beside.times.iter().zip(values).skip(beside.counted);
        pairs.map(|(t, value)| (*t, *value)).collect()
    };
    Some(Chart {
        title: "Rope made fast, around its greatest tension".to_owned(),
        x: Axis::new("time", "s"),
        y: Axis::new("tension at the ship", "N"),
        series: vec![
            Series::new("equilibria", 0, points(&beside.still)),
            Series::new("dynamic solver", 1, points(&beside.dynamic)),
        ],
        legend: true,
        ..Chart::default()
    })
}

/// The rope made fast on the dynamic solver beside the equilibria; absent where the rope has no answer at all.
#[must_use]
pub fn dynamic_table(rope: &RopeAnalysis) -> Option<Table> {
    let title = "The rope made fast on the dynamic solver".to_owned();
    let beside = match rope.dynamic.as_ref()? {
        Ok(beside) => beside,
        Err(trouble) => {
            return Some(Table {
                title,
                notes: vec![format!("WARNING: no answer: {trouble}.")],
                ..Table::default()
            });
        }
    };
    let [still, dynamic] = beside.statistics();
    let row = |name: &str, of: [f64; 5]| {
        let mut cells = vec![Cell::plain(name)];
        cells.extend(of.map(|value| Cell::plain(si(value, "N"))));
        cells
    };
    let five = |s: &Statistics| [s.mean, s.rms, s.deviation, s.min, s.max];
    let (a, b) = (five(&still), five(&dynamic));
    let differ = std::array::from_fn(|i| b[i] - a[i]);
    let first = beside.times.get(beside.counted).copied().unwrap_or(0.0);
    let last = beside.times.last().copied().unwrap_or(0.0);
    let told = |error: Option<f64>| error.map_or_else(|| "-".to_owned(), |e| si(e, "N"));
    Some(Table {
        title,
        columns: vec![
            Column::left("tension at the ship"),
            Column::decimal("mean"),
            Column::decimal("rms"),
            Column::decimal("deviation"),
            Column::decimal("least"),
            Column::decimal("greatest"),
        ],
        rows: vec![
            row("from equilibrium to equilibrium", a),
            row("dynamic solver", b),
            row("difference", differ),
        ],
        notes: vec![
            format!(
                "From {} s to {} s of the record, around its greatest tension; the two are {} apart (root mean square), {} of the deviation. The winch pays out rope, which the line of the dynamic solver does not: it is made fast here.",
                digits(first, 6),
                digits(last, 6),
                si(beside.apart(), "N"),
                percent(beside.apart() / still.deviation.max(f64::MIN_POSITIVE))
            ),
            format!(
                "Error of the greatest tension by the step {}, by the mesh {}; {} steps, {} Newton iterations.",
                told(beside.errors.0),
                told(beside.errors.1),
                beside.work.0,
                beside.work.1
            ),
        ],
    })
}

fn row(
    name: &str,
    moments: &Result<Vec<WinchSample>, RopewayError>,
    notes: &mut Vec<String>,
) -> Vec<Cell> {
    let mut cells = vec![Cell::plain(name)];
    match moments {
        Ok(moments) => {
            let Statistics {
                mean,
                rms,
                deviation,
                min,
                max,
                ..
            } = RopeAnalysis::tension(moments);
            let each = [mean, rms, deviation, min, max];
            cells.extend(each.map(|value| Cell::plain(si(value, "N"))));
        }
        Err(trouble) => {
            cells.push(Cell::new("no answer", CellInk::Bad));
            notes.push(format!("WARNING: {name}, {trouble}."));
        }
    }
    cells
}

/// What the winch must do, and where it cannot.
fn winch(moments: &[WinchSample], tension: f64) -> Vec<String> {
    let most = |of: &dyn Fn(&WinchSample) -> f64| moments.iter().map(of).fold(0.0, f64::max);
    let length = |m: &WinchSample| m.length_m;
    let least = moments.iter().map(length).fold(f64::INFINITY, f64::min);
    let mut notes = vec![format!(
        "The winch keeps {}: its rope runs at up to {} m/s and takes up to {}; {} m of rope go in and out.",
        si(tension, "N"),
        digits(most(&|m| m.speed_m_per_s.abs()), 3),
        si(most(&|m| m.power_w.abs()), "W"),
        digits(most(&length) - least, 3),
    )];
    let winch_limits = RopeAnalysis::winch_limits(moments);
    let all = moments.len() as f64;
    for (count, why) in [
        (winch_limits.at_speed, "at its greatest speed"),
        (winch_limits.at_power, "at its greatest power"),
        (winch_limits.rope_out, "out of rope"),
    ] {
        if count > 0 {
            notes.push(format!(
                "WARNING: the motion is beyond the winch for {} of the time: it is {why}.",
                percent(count as f64 / all)
            ));
        }
    }
    notes
}
