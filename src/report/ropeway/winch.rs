//! Hauling the rope out, and the winch on the moving ship, in tables and charts.

use super::tables::{METRES, NEWTONS, metres, newtons};
use crate::report::chart::{Axis, Chart, Series};
use crate::report::number::percent;
use crate::report::table::{Format, Table};
use crate::ropeway::hauling::{Haul, haul};
use crate::ropeway::winch::{Extremes, Held, Moment, extremes};
use crate::ropeway::{Followed, Worked};

/// Steps of the chart of hauling.
const HAULS: usize = 80;

/// Hauling tension against distance off the platform, the rope's length fixed.
#[must_use]
pub fn hauling_chart(worked: &Worked) -> Chart {
    let hauls = haul(&worked.span, worked.length_m, HAULS);
    let series = |label: &str, slot: usize, of: fn(&Haul) -> f64| {
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
    let title = format!(
        "Hauling the bare rope out to the ship, {} of it",
        metres(worked.length_m)
    );
    Table::of(title, &haul(&worked.span, worked.length_m, 8))
        .number("off the platform", METRES, |haul| haul.distance_m)
        .number("end tension", NEWTONS, |haul| haul.ship_n)
        .number("horizontal part", NEWTONS, |haul| haul.horizontal_n)
        .build()
        .noted([
            "A candidate for the paper's lost fig. 9, whose words are: little change within 40 m, then linear growth. The first holds; the growth is convex.",
        ])
}

/// The rope made fast, and held by the winch; absent where it has no answer.
fn ways(followed: &Followed) -> [Option<&[Moment]>; 2] {
    let kept = followed.kept.as_ref().and_then(|kept| kept.as_deref().ok());
    [followed.fast.as_deref().ok(), kept]
}

/// Tension at the ship against time, fast and kept.
#[must_use]
pub fn winch_chart(followed: &Followed) -> Chart {
    let tension = |moments: &[Moment]| moments.iter().map(|m| (m.ship.time_s, m.ship_n)).collect();
    let labels = ["made fast", "held by the winch"];
    let ways = labels.into_iter().zip(ways(followed)).enumerate();
    let series = ways
        .filter_map(|(slot, (label, moments))| Some(Series::new(label, slot, tension(moments?))));
    Chart {
        title: "Tension at the moving ship".to_owned(),
        x: Axis::new("time", "s"),
        y: Axis::new("tension", "N"),
        series: series.collect(),
        legend: true,
        ..Chart::default()
    }
}

/// What the ship's motion does to the rope, made fast and held by the winch, and what the winch must do.
#[must_use]
pub fn winch(worked: &Worked, followed: &Followed) -> Table {
    const SPEED: Format = Format::Si("m/s");
    const POWER: Format = Format::Si("W");
    let [fast, kept] = ways(followed);
    let ways = [("made fast", fast), ("held by the winch", kept)];
    let ship = |m: &[Moment]| extremes(m, |x| x.ship_n);
    let length = |m: &[Moment]| extremes(m, |x| x.length_m);
    let speed = |m: &[Moment]| extremes(m, |x| x.speed_m_per_s);
    let power = |m: &[Moment]| extremes(m, |x| x.power_w);
    let range = |of: Extremes| of.most - of.least;
    Table::compare("The rope on the moving ship", "", &ways)
        .number("tension at the ship, least", NEWTONS, |m| ship(m).least)
        .number("tension at the ship, greatest", NEWTONS, |m| ship(m).most)
        .number("tension at the ship, mean", NEWTONS, |m| ship(m).mean)
        .number("tension at the ship, scatter", NEWTONS, |m| {
            ship(m).deviation
        })
        .number("cargo's depth, range", METRES, |m| {
            range(extremes(m, |x| x.depth_m))
        })
        .number("rope, shortest", METRES, |m| length(m).least)
        .number("rope, longest", METRES, |m| length(m).most)
        .number("fastest paying out", SPEED, |m| speed(m).most.max(0.0))
        .number("fastest hauling in", SPEED, |m| -speed(m).least.min(0.0))
        .number("greatest power, hauling in", POWER, |m| {
            power(m).most.max(0.0)
        })
        .number("greatest power, braking", POWER, |m| {
            -power(m).least.min(0.0)
        })
        .build()
        .noted(notes(followed))
        .noted(breaks(worked, followed))
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
            notes.extend(limits(kept));
        }
    }
    notes.push("Each instant is an equilibrium; the rope's own inertia is left out.".to_owned());
    notes
}

/// How often the winch is at one of its limits.
fn limits(kept: &[Moment]) -> impl Iterator<Item = String> {
    let limits = [
        (Held::AtSpeed, "it is at its greatest speed"),
        (Held::AtPower, "it is at its greatest power"),
        (
            Held::RopeOut,
            "all its rope is out: the ship is beyond its reach",
        ),
    ];
    limits.into_iter().filter_map(|(held, words)| {
        let count = kept.iter().filter(|m| m.held == held).count();
        let part = count as f64 / kept.len().max(1) as f64;
        (part > 0.0).then(|| {
            format!(
                "For {} of the time {words}, and the tension is not kept.",
                percent(part)
            )
        })
    })
}

/// That the greatest tension is more than a rope's share of it may be.
fn breaks(worked: &Worked, followed: &Followed) -> impl Iterator<Item = String> {
    let ways = ["Made fast", "Held by the winch"]
        .into_iter()
        .zip(ways(followed));
    ways.filter_map(|(way, moments)| {
        let most = extremes(moments?, |m| m.ship_n.max(m.platform_n)).most;
        let part = worked.of_breaking(most)?;
        (part > 1.0).then(|| {
            format!(
                "{way} the ropes would break: {} is {} of what they bear.",
                newtons(most),
                percent(part)
            )
        })
    })
}
