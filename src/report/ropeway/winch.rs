//! Hauling the rope out and the winch on the moving ship, in tables and charts.

use super::tables::{METRES, NEWTONS, metres, newtons};
use seacable_base::number::{percent, si};
use seacable_display::chart::{Axis, Chart, Series};
use seacable_display::table::{NumberFormat, Table};
use seacable_numerics::statistics::Statistics;
use seacable_systems::ropeway::hauling::{HaulingPoint, haul};
use seacable_systems::ropeway::rope_motion::{MovingRope, RopeMotion};
use seacable_systems::ropeway::winch::{WinchSample, WinchState, statistics};
use seacable_systems::ropeway::{SolvedRopeway, WinchRun};

/// Steps of the chart of hauling.
const HAULS: usize = 80;

/// End tension against distance from the platform, the length of the rope fixed.
#[must_use]
pub fn hauling_chart(solved: &SolvedRopeway) -> Chart {
    let hauls = haul(&solved.rope, solved.length_m, HAULS);
    let series = |label: &str, slot: usize, of: fn(&HaulingPoint) -> f64| {
        let points = hauls.iter().map(|h| (h.distance_m, of(h)));
        Series::new(label, slot, points.collect())
    };
    Chart::new(
        "Hauling the unloaded rope out to the ship",
        Axis::new("distance from the platform", "m"),
        Axis::new("tension at the ship", "N"),
        vec![
            series("end tension", 0, |h| h.ship_n),
            series("horizontal component", 1, |h| h.horizontal_n),
        ],
    )
}

/// The same in numbers.
#[must_use]
pub fn hauling(solved: &SolvedRopeway) -> Table {
    let title = format!(
        "Hauling the unloaded rope out to the ship, length {}",
        metres(solved.length_m)
    );
    Table::of_records(title, &haul(&solved.rope, solved.length_m, 8))
        .number("from the platform", METRES, |haul| haul.distance_m)
        .number("end tension", NEWTONS, |haul| haul.ship_n)
        .number("horizontal component", NEWTONS, |haul| haul.horizontal_n)
        .build()
        .noted([
            "Possibly the paper's lost fig. 9, described as little change within 40 m, then linear growth. The former holds; the growth is convex.",
        ])
}

/// Names of the ways in which the rope is held.
const WAYS: [&str; 2] = ["made fast", "on the winch"];

/// The rope made fast and on the constant-tension winch; absent where it has no solution.
fn ways(run: &WinchRun) -> [Option<&[WinchSample]>; 2] {
    let kept = run.constant_tension.as_ref();
    let kept = kept.and_then(|kept| kept.as_deref().ok());
    [run.made_fast.as_deref().ok(), kept]
}

/// Tension at the ship against time, made fast and on the winch, up to a time \[s\].
pub(crate) fn tensions(run: &WinchRun, until: f64) -> Vec<Series> {
    let series = |(slot, (label, samples)): (usize, (&str, Option<&[WinchSample]>))| {
        let drawn = samples?.iter().take_while(|s| s.ship.time_s <= until);
        let points = drawn.map(|s| (s.ship.time_s, s.ship_n)).collect();
        Some(Series::new(label, slot, points))
    };
    let ways = WAYS.into_iter().zip(ways(run));
    ways.enumerate().filter_map(series).collect()
}

/// Tension at the ship against time, made fast and on the winch, in equilibrium and in motion.
#[must_use]
pub fn winch_chart(run: &WinchRun, motion: Option<&RopeMotion>) -> Chart {
    let mut series = tensions(run, f64::INFINITY);
    for (way, rope) in WAYS.into_iter().zip(moving(motion)) {
        if let Some(rope) = rope {
            let points = rope.times.iter().zip(&rope.ship_n);
            let points = points.map(|(time, tension)| (*time, *tension)).collect();
            series.push(Series::new(
                &format!("{way}, in motion"),
                series.len(),
                points,
            ));
        }
    }
    Chart::new(
        "Tension at the moving ship",
        Axis::new("time", "s"),
        Axis::new("tension", "N"),
        series,
    )
}

/// The rope in motion, made fast and on the winch; absent where it was not computed.
fn moving(motion: Option<&RopeMotion>) -> [Option<&MovingRope>; 2] {
    let Some(motion) = motion else {
        return [None; 2];
    };
    let kept = motion.constant_tension.as_ref();
    let kept = kept.and_then(|kept| kept.as_ref().ok());
    [motion.made_fast.as_ref().ok(), kept]
}

/// The rope held in one way: its equilibria, and in motion.
#[derive(Clone, Copy)]
struct HeldRope<'a> {
    samples: &'a [WinchSample],
    moving: Option<&'a MovingRope>,
}

impl HeldRope<'_> {
    fn statistics(&self, quantity: fn(&WinchSample) -> f64) -> Statistics {
        statistics(self.samples, quantity)
    }

    /// A result in motion by its place among those.
    fn moving(&self, result: usize) -> Option<f64> {
        Some(self.moving?.results[result])
    }
}

const SPEED: NumberFormat = NumberFormat::Si("m/s");
const POWER: NumberFormat = NumberFormat::Si("W");

/// Statistics of the rope over the ship's motion, made fast and on the winch, in equilibrium and in motion, and the duty of the winch.
#[must_use]
pub fn winch(solved: &SolvedRopeway, run: &WinchRun, motion: Option<&RopeMotion>) -> Table {
    let held = ways(run).into_iter().zip(moving(motion));
    let held = held.map(|(samples, moving)| samples.map(|samples| HeldRope { samples, moving }));
    let columns: Vec<(&str, Option<HeldRope<'_>>)> = WAYS.into_iter().zip(held).collect();
    let ship = |m: HeldRope<'_>| m.statistics(|x| x.ship_n);
    let length = |m: HeldRope<'_>| m.statistics(|x| x.length_m);
    let speed = |m: HeldRope<'_>| m.statistics(|x| x.speed_m_per_s);
    let power = |m: HeldRope<'_>| m.statistics(|x| x.power_w);
    let range = |of: Statistics| of.max - of.min;
    let mut table = Table::compare("The rope on the moving ship", "", &columns)
        .number("tension at the ship, minimum", NEWTONS, |m| ship(m).min)
        .number("tension at the ship, maximum", NEWTONS, |m| ship(m).max)
        .number("tension at the ship, mean", NEWTONS, |m| ship(m).mean)
        .number("tension at the ship, std deviation", NEWTONS, |m| {
            ship(m).deviation
        });
    if moving(motion).into_iter().flatten().next().is_some() {
        // In the order of the same rows of equilibria.
        table = table
            .number("in motion, minimum", NEWTONS, |m| m.moving(2))
            .number("in motion, maximum", NEWTONS, |m| m.moving(3))
            .number("in motion, mean", NEWTONS, |m| m.moving(0))
            .number("in motion, std deviation", NEWTONS, |m| m.moving(1))
            .number("in motion, greatest rope speed", SPEED, |m| m.moving(4));
    }
    table
        .number("cargo depth, range", METRES, |m| {
            range(m.statistics(|x| x.depth_m))
        })
        .number("rope length, minimum", METRES, |m| length(m).min)
        .number("rope length, maximum", METRES, |m| length(m).max)
        .number("paying out speed, maximum", SPEED, |m| {
            speed(m).max.max(0.0)
        })
        .number("hauling in speed, maximum", SPEED, |m| {
            -speed(m).min.min(0.0)
        })
        .number("hauling power, maximum", POWER, |m| power(m).max.max(0.0))
        .number("braking power, maximum", POWER, |m| -power(m).min.min(0.0))
        .build()
        .noted(notes(run))
        .noted(motion_notes(motion))
        .noted(breaks(solved, run, motion))
}

/// What the rope in motion was computed with, how exact that is, and how far off equilibria are.
fn motion_notes(motion: Option<&RopeMotion>) -> Vec<String> {
    let Some(motion) = motion else {
        return Vec::new();
    };
    let runs = [Some(&motion.made_fast), motion.constant_tension.as_ref()];
    let mut notes = vec![
        "In motion: rope and cargo with their inertia, without drag of the air; a drum as heavy as the rope, at the lesser of the speed limit and power by tension."
            .to_owned(),
    ];
    for (way, run) in WAYS.into_iter().zip(runs) {
        match run {
            Some(Ok(rope)) => {
                notes.push(off(way, rope));
                notes.extend(errors(way, rope));
                let warnings = rope.warnings.iter();
                notes.extend(warnings.map(|why| format!("In motion, {way}: {why}.")));
            }
            Some(Err(error)) => notes.push(format!("In motion, {way}: {error}.")),
            None => {}
        }
    }
    notes
}

/// By how much equilibria are off.
fn off(way: &str, rope: &MovingRope) -> String {
    let [mean, deviation, least, greatest, _] =
        std::array::from_fn(|k| rope.quasi_static[k] - rope.results[k]);
    let off = |what: &str, by: f64| {
        let sign = if by < 0.0 { "-" } else { "+" };
        format!("{what} {sign}{}", si(by.abs(), "N"))
    };
    let all = [
        off("minimum", least),
        off("maximum", greatest),
        off("mean", mean),
        off("std deviation", deviation),
    ];
    format!(
        "Equilibria are off from the rope in motion, {way}: {} ({} of the maximum).",
        all.join(", "),
        percent(greatest.abs() / rope.results[3].abs().max(f64::MIN_POSITIVE))
    )
}

/// The numerical errors.
fn errors(way: &str, rope: &MovingRope) -> Option<String> {
    let of = |[mean, deviation, least, greatest, speed]: [f64; 5]| {
        format!(
            "minimum {}, maximum {}, mean {}, std deviation {}, speed {}",
            si(least, "N"),
            si(greatest, "N"),
            si(mean, "N"),
            si(deviation, "N"),
            si(speed, "m/s")
        )
    };
    let [time, mesh] = rope.errors?.map(of);
    Some(format!(
        "Numerical errors in motion, {way}: by time steps {time}; by the mesh {mesh}."
    ))
}

fn notes(run: &WinchRun) -> Vec<String> {
    let mut notes = Vec::new();
    if let Err(error) = &run.made_fast {
        notes.push(format!("Made fast: {error}."));
    }
    match &run.constant_tension {
        None => notes.push("The ropeway has no winch; add [winch].".to_owned()),
        Some(Err(error)) => notes.push(format!("On the winch: {error}.")),
        Some(Ok(kept)) => {
            notes.push(format!("Constant tension: {}.", newtons(run.tension_n)));
            notes.extend(limits(kept));
        }
    }
    notes.push(
        "Quasi-static, but for the rows in motion: each sample is an equilibrium without the inertia of the rope.".to_owned(),
    );
    notes
}

/// Warnings of how often the winch is at a limit.
pub(crate) fn limits(kept: &[WinchSample]) -> impl Iterator<Item = String> {
    let limits = [
        (WinchState::SpeedLimit, "its maximum speed"),
        (WinchState::PowerLimit, "its maximum power"),
        (WinchState::RopeOut, "the end of its rope"),
    ];
    limits.into_iter().filter_map(|(held, limit)| {
        let count = kept.iter().filter(|m| m.state == held).count();
        let part = percent(count as f64 / kept.len() as f64);
        (count > 0).then(|| {
            format!("WARNING: the winch is at {limit} for {part} of the time and does not keep its tension.")
        })
    })
}

/// That the maximum tension, in equilibrium or in motion, exceeds the breaking load of a rope.
fn breaks(
    solved: &SolvedRopeway,
    run: &WinchRun,
    motion: Option<&RopeMotion>,
) -> impl Iterator<Item = String> {
    let names = ["Made fast", "On the winch"].into_iter();
    let ways = names.zip(ways(run).into_iter().zip(moving(motion)));
    ways.filter_map(|(way, (moments, moving))| {
        let still = statistics(moments?, |m| m.ship_n.max(m.platform_n)).max;
        let most = moving.map_or(still, |rope| still.max(rope.results[3]));
        let part = solved.breaking_load_ratio(most)?;
        (part > 1.0).then(|| {
            format!(
                "{way}, the ropes break: the maximum tension {} is {} of their breaking load.",
                newtons(most),
                percent(part)
            )
        })
    })
}
