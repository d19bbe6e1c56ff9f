//! What moves, in tables and charts: hauling the rope out, the winch on the moving ship, the cargo's own motion.

use std::f64::consts::TAU;

use super::full::Hauled;
use super::hauling::haul;
use super::service::Followed;
use super::swing::{Swung, string_rad_per_s};
use super::tables::{metres, newtons, titled};
use super::winch::{Held, Moment, extremes};
use super::work::Worked;
use crate::report::chart::{Axis, Chart, Series};
use crate::report::number::{percent, rounded, si};
use crate::report::table::{Cell, CellInk, Column, Table};

/// Steps of the chart of hauling.
const HAULS: usize = 80;

/// Hauling tension against distance off the platform, the rope's length fixed.
#[must_use]
pub fn hauling_chart(worked: &Worked) -> Chart {
    let hauls = haul(&worked.span, worked.length_m, HAULS);
    let series = |label: &str, slot: usize, of: fn(&super::hauling::Haul) -> f64| {
        let points = hauls.iter().map(|h| (h.distance_m, of(h)));
        Series::new(label, slot, points.collect())
    };
    Chart {
        title: "Hauling the bare rope out to the ship".to_owned(),
        x: Axis::new("distance off the platform", "m"),
        y: Axis::new("tension at the ship", "N"),
        series: vec![
            series("end tension", 0, |h| h.ship_n),
            series("horizontal part", 1, |h| h.horizontal_n),
        ],
        legend: true,
        ..Chart::default()
    }
}

/// The same in numbers.
#[must_use]
pub fn hauling(worked: &Worked) -> Table {
    let mut table = titled(
        &format!(
            "Hauling the bare rope out to the ship, {} of it",
            metres(worked.length_m)
        ),
        vec![
            Column::decimal("off the platform"),
            Column::decimal("end tension"),
            Column::decimal("horizontal part"),
        ],
    );
    for haul in haul(&worked.span, worked.length_m, 8) {
        table.rows.push(vec![
            Cell::plain(metres(haul.distance_m)),
            Cell::plain(newtons(haul.ship_n)),
            Cell::plain(newtons(haul.horizontal_n)),
        ]);
    }
    table.notes.push(
        "A candidate for the paper's lost fig. 9, whose words are: little change within 40 m, then linear growth. The first holds; the growth is convex."
            .to_owned(),
    );
    table
}

/// Tension at the ship against time, fast and kept.
#[must_use]
pub fn winch_chart(followed: &Followed) -> Chart {
    let tension = |moments: &[Moment]| moments.iter().map(|m| (m.ship.time_s, m.ship_n)).collect();
    let mut series = Vec::new();
    if let Ok(fast) = &followed.fast {
        series.push(Series::new("made fast", 0, tension(fast)));
    }
    if let Some(Ok(kept)) = &followed.kept {
        series.push(Series::new("held by the winch", 1, tension(kept)));
    }
    Chart {
        title: "Tension at the moving ship".to_owned(),
        x: Axis::new("time", "s"),
        y: Axis::new("tension", "N"),
        series,
        legend: true,
        ..Chart::default()
    }
}

/// What the ship's motion does to the rope, made fast and held by the winch, and what the winch must do.
#[must_use]
pub fn winch(worked: &Worked, followed: &Followed) -> Table {
    let mut table = titled(
        "The rope on the moving ship",
        vec![
            Column::left(""),
            Column::decimal("made fast"),
            Column::decimal("held by the winch"),
        ],
    );
    let fast = followed.fast.as_ref().ok();
    let kept = followed.kept.as_ref().and_then(|kept| kept.as_ref().ok());
    let mut row = |name: &str, of: &dyn Fn(&[Moment]) -> String| {
        let word = |moments: Option<&Vec<Moment>>| {
            moments.map_or_else(|| Cell::new("-", CellInk::Dim), |m| Cell::plain(of(m)))
        };
        table
            .rows
            .push(vec![Cell::plain(name), word(fast), word(kept)]);
    };
    row("tension at the ship, least", &|m| {
        newtons(extremes(m, |x| x.ship_n).least)
    });
    row("tension at the ship, greatest", &|m| {
        newtons(extremes(m, |x| x.ship_n).most)
    });
    row("tension at the ship, mean", &|m| {
        newtons(extremes(m, |x| x.ship_n).mean)
    });
    row("tension at the ship, scatter", &|m| {
        newtons(extremes(m, |x| x.ship_n).deviation)
    });
    row("cargo's depth, range", &|m| {
        let depth = extremes(m, |x| x.depth_m);
        metres(depth.most - depth.least)
    });
    row("rope, shortest", &|m| {
        metres(extremes(m, |x| x.length_m).least)
    });
    row("rope, longest", &|m| {
        metres(extremes(m, |x| x.length_m).most)
    });
    row("fastest paying out", &|m| {
        si(extremes(m, |x| x.speed_m_per_s).most.max(0.0), "m/s")
    });
    row("fastest hauling in", &|m| {
        si(-extremes(m, |x| x.speed_m_per_s).least.min(0.0), "m/s")
    });
    row("greatest power, hauling in", &|m| {
        si(extremes(m, |x| x.power_w).most.max(0.0), "W")
    });
    row("greatest power, braking", &|m| {
        si(-extremes(m, |x| x.power_w).least.min(0.0), "W")
    });
    table.notes = notes(followed);
    table.notes.extend(breaks(worked, followed));
    table
}

fn notes(followed: &Followed) -> Vec<String> {
    let mut notes = Vec::new();
    if let Err(trouble) = &followed.fast {
        notes.push(format!("Made fast: {trouble}."));
    }
    match &followed.kept {
        None => notes.push("The ropeway has no winch; [winch] gives it one.".to_owned()),
        Some(Err(trouble)) => notes.push(format!("Held by the winch: {trouble}.")),
        Some(Ok(kept)) => {
            notes.push(format!("The winch keeps {}.", newtons(followed.tension_n)));
            let share = |held: Held| {
                let count = kept.iter().filter(|m| m.held == held).count();
                count as f64 / kept.len().max(1) as f64
            };
            for (held, words) in [
                (Held::AtSpeed, "it is at its greatest speed"),
                (Held::AtPower, "it is at its greatest power"),
                (
                    Held::RopeOut,
                    "all its rope is out: the ship is beyond its reach",
                ),
            ] {
                let part = share(held);
                if part > 0.0 {
                    notes.push(format!(
                        "For {} of the time {words}, and the tension is not kept.",
                        percent(part)
                    ));
                }
            }
        }
    }
    notes.push("Each instant is an equilibrium; the rope's own inertia is left out.".to_owned());
    notes
}

/// That the greatest tension is more than a rope's share of it may be.
fn breaks(worked: &Worked, followed: &Followed) -> Vec<String> {
    let ways = [
        ("Made fast", followed.fast.as_ref().ok()),
        (
            "Held by the winch",
            followed.kept.as_ref().and_then(|kept| kept.as_ref().ok()),
        ),
    ];
    let broken = ways.into_iter().filter_map(|(way, moments)| {
        let most = extremes(moments?, |m| m.ship_n.max(m.platform_n)).most;
        let part = worked.of_breaking(most)?;
        (part > 1.0).then(|| {
            format!(
                "{way} the ropes would break: {} is {} of what they bear.",
                newtons(most),
                percent(part)
            )
        })
    });
    broken.collect()
}

/// The cargo's own motion: periods, and what the ship's motion makes of it.
#[must_use]
pub fn cargo(worked: &Worked) -> Table {
    let mut table = titled(
        "The cargo's own motion, one degree of freedom (eq. 12)",
        vec![Column::left(""), Column::decimal("value")],
    );
    let position = worked.ropeway.cargo.position;
    let swing = match worked.swing() {
        Ok(swing) if position > 0.0 && position < 1.0 => swing,
        Ok(_) => {
            table
                .notes
                .push("The cargo hangs on a support and does not move.".to_owned());
            return table;
        }
        Err(trouble) => {
            table.notes.push(format!("No answer: {trouble}."));
            return table;
        }
    };
    let hang = worked.hang(position);
    let mut row = |name: &str, value: String| {
        table.rows.push(vec![Cell::plain(name), Cell::plain(value)]);
    };
    let seconds = |w: f64| format!("{} s", rounded(TAU / w, 3));
    let mass = worked.span.weight_n_per_m / worked.ropeway.about.gravity_m_per_s2;
    row("horizontal pull, kept", newtons(swing.horizontal_n));
    row(
        "natural period, rope without mass",
        seconds(swing.natural_rad_per_s(&hang)),
    );
    if let Ok(w) = string_rad_per_s(&swing, &hang, mass) {
        row("natural period, taut string with its mass", seconds(w));
    }
    row("damping ratio", rounded(swing.damping_ratio, 3));
    row(
        "depth at rest below the platform's hang point",
        metres(swing.settled_m(&hang)),
    );
    if worked.ropeway.motion.is_some()
        && let Ok(swung) = worked.swung(worked.ropeway.dynamics.duration_s, 0.1)
    {
        let (low, high) = range(&swung, |s| s.depth_m);
        row("depth while the ship moves, least", metres(low));
        row("depth while the ship moves, greatest", metres(high));
        let (low, high) = range(&swung, |s| s.platform_n.max(s.ship_n));
        row("tension while the ship moves, least", newtons(low));
        row("tension while the ship moves, greatest", newtons(high));
    }
    let share = worked.ropeway.cargo.mass_kg / (mass * worked.length_m);
    table.notes.push(format!(
        "Eq. (12) takes the rope as weightless and its pull as kept; the cargo's mass is {} of the rope's.",
        percent(share)
    ));
    table
}

fn range(swung: &[Swung], of: fn(&Swung) -> f64) -> (f64, f64) {
    let values = || swung.iter().map(of);
    (
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    )
}

/// The crossing over the full line on the dynamic solver beside eq. (12): its path drawn, its numbers in a table. It takes a
/// fraction of a second, which is too long for every key.
#[must_use]
pub fn full(worked: &Worked) -> (Chart, Table) {
    let mut chart = crossing_chart(worked);
    let mut table = titled(
        "One degree of freedom beside the full line, the rope made fast and the ship lying still",
        vec![
            Column::left(""),
            Column::decimal("eq. (12)"),
            Column::decimal("full line"),
            Column::decimal("at rest"),
        ],
    );
    let position = worked.ropeway.cargo.position;
    let period = |w: f64| format!("{} s", rounded(TAU / w, 3));
    let swing = worked.swing().ok();
    let inside = position > 0.0 && position < 1.0;
    let one = swing
        .filter(|_| inside)
        .map(|swing| period(swing.natural_rad_per_s(&worked.hang(position))));
    let line = worked.full_hz(position).ok().map(|hz| period(TAU * hz));
    table.rows.push(cells("natural period", [one, line, None]));
    match worked.hauled() {
        Ok(hauled) => {
            let path = hauled.iter().map(|h| (h.x_m, h.z_m));
            chart
                .series
                .push(Series::new("full line, hauled in", 2, path.collect()));
            table.rows.extend(on_the_way(worked, &hauled));
        }
        Err(trouble) => table
            .notes
            .push(format!("No crossing of the full line: {trouble}.")),
    }
    table.notes.push(
        "Eq. (12) leaves out the rope's weight and mass and keeps the pull of the cargo's place in the file, with the ship moving where the file moves it."
            .to_owned(),
    );
    (chart, table)
}

/// How low the cargo comes and how much the rope bears, by each reading of the crossing.
fn on_the_way(worked: &Worked, hauled: &[Hauled]) -> [Vec<Cell>; 2] {
    let height = worked.ropeway.platform.height_m;
    let rest: Vec<(f64, f64)> = hauled
        .iter()
        .filter_map(|h| {
            let rest = worked.rest(h.x_m / worked.span.gap.span_m).ok()?;
            let most = rest.platform_n().max(rest.ship_n());
            Some((height + rest.cargo_m.1, most))
        })
        .collect();
    let low = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
    let high = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let own = worked.crossing(400).ok();
    let deepest = own.as_ref().map(|own| range(own, |s| s.depth_m).1);
    let pull = |s: &Swung| s.platform_n.max(s.ship_n);
    let lowest = [
        deepest.map(|depth| height - depth),
        Some(low(&mut hauled.iter().map(|h| h.z_m))),
        Some(low(&mut rest.iter().map(|r| r.0))),
    ];
    let greatest = [
        own.as_ref().map(|own| range(own, pull).1),
        Some(high(&mut hauled.iter().map(|h| h.platform_n.max(h.ship_n)))),
        Some(high(&mut rest.iter().map(|r| r.1))),
    ];
    [
        cells(
            "lowest on the way, above still water",
            lowest.map(|z| z.map(metres)),
        ),
        cells(
            "greatest tension on the way",
            greatest.map(|n| n.map(newtons)),
        ),
    ]
}

fn cells(name: &str, values: [Option<String>; 3]) -> Vec<Cell> {
    let mut row = vec![Cell::plain(name)];
    row.extend(values.map(|value| match value {
        Some(words) => Cell::plain(words),
        None => Cell::new("-", CellInk::Dim),
    }));
    row
}

/// Depth of the cargo on its way across: eq. (12) with the ship moving, the exact rope with the ship lying still.
#[must_use]
pub fn crossing_chart(worked: &Worked) -> Chart {
    let height = worked.ropeway.platform.height_m;
    let mut series = Vec::new();
    let at = |i: usize| {
        let rest = worked.rest(i as f64 / 40.0).ok()?;
        Some((rest.cargo_m.0, height + rest.cargo_m.1))
    };
    series.push(Series::new(
        "exact, at rest",
        0,
        (1..40).filter_map(at).collect(),
    ));
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
