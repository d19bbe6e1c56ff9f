//! A system drawn: from above, from the side, and obliquely from above.

use seacable_display::chart::{Axis, Chart, Outline, Series};
use seacable_numerics::V3;
use seacable_systems::system::SolvedSystem;
use seacable_systems::system::network::Held;

/// Points that a line is drawn with.
const POINTS: u32 = 60;
/// Lines drawn in an ink of their own; more share them.
const INKS: usize = 6;
const BREAK: (f64, f64) = (f64::NAN, f64::NAN);

/// A direction of view: what is drawn to the right and what upwards, and their names.
struct View {
    title: &'static str,
    right: V3,
    up: V3,
    names: (&'static str, &'static str),
}

/// From above: x to the right, y up.
#[must_use]
pub fn plan(solved: &SolvedSystem) -> Chart {
    draw(
        solved,
        &View {
            title: "From above",
            right: V3::x(),
            up: V3::y(),
            names: ("x", "y"),
        },
    )
}

/// From the side: x to the right, z up, not to equal scale where the system is flat.
#[must_use]
pub fn side(solved: &SolvedSystem) -> Chart {
    let mut chart = draw(
        solved,
        &View {
            title: "From the side",
            right: V3::x(),
            up: V3::z(),
            names: ("x", "z"),
        },
    );
    chart.equal_scale = false;
    chart
}

/// Obliquely from the south-west, 25 degrees above the horizon.
#[must_use]
pub fn oblique(solved: &SolvedSystem) -> Chart {
    let (turn, tilt) = (-30.0_f64.to_radians(), 25.0_f64.to_radians());
    let right = V3::new(turn.cos(), -turn.sin(), 0.0);
    let away = V3::new(turn.sin(), turn.cos(), 0.0);
    let up = away * tilt.sin() + V3::z() * tilt.cos();
    draw(
        solved,
        &View {
            title: "Obliquely, from 25 degrees above",
            right,
            up,
            names: ("right", "up"),
        },
    )
}

fn draw(solved: &SolvedSystem, view: &View) -> Chart {
    let flat = |place: &V3| (place.dot(&view.right), place.dot(&view.up));
    let mut series = Vec::new();
    let places = &solved.rest.placement.points;
    let greatest = solved.rest.balance.tension;
    for (index, line) in solved.network.lines.iter().enumerate() {
        let ends = [&places[line.from], &places[line.to]];
        let at_rest = &solved.rest.balance.lines[index];
        let points: Outline = (0..=POINTS)
            .map(|k| flat(&at_rest.at(f64::from(k) / f64::from(POINTS), ends).0))
            .collect();
        let tension = at_rest.tensions().into_iter().fold(0.0, f64::max);
        let mut drawn = Series::new(
            &format!("{} {}", index + 1, line.name),
            index % INKS,
            points,
        );
        // The less a line pulls, the fainter it is drawn.
        drawn.dimmed = tension < 0.25 * greatest;
        series.push(drawn);
    }
    if view.up.z != 0.0 {
        series.extend(bed(solved, &flat));
    }
    let mut marks = Outline::new();
    let size = spread(solved);
    for (index, point) in solved.network.points.iter().enumerate() {
        let (x, y) = flat(&places[index]);
        let arm = if matches!(point.held, Held::Free(_)) {
            0.012
        } else {
            0.006
        } * size;
        marks.extend([
            (x - arm, y),
            (x + arm, y),
            BREAK,
            (x, y - arm),
            (x, y + arm),
            BREAK,
        ]);
    }
    series.push(Series::new("points", INKS, marks));
    let (x, y) = (Axis::new(view.names.0, "m"), Axis::new(view.names.1, "m"));
    Chart {
        equal_scale: true,
        legend: solved.network.lines.len() <= INKS,
        ..Chart::new(view.title, x, y, series)
    }
}

/// The bed below every line, where it is not level.
fn bed(solved: &SolvedSystem, flat: &impl Fn(&V3) -> (f64, f64)) -> Option<Series> {
    let bed = solved.network.bed.as_ref().filter(|bed| !bed.is_level())?;
    let places = &solved.rest.placement.points;
    let mut drawn = Outline::new();
    for (line, at_rest) in solved.network.lines.iter().zip(&solved.rest.balance.lines) {
        let ends = [&places[line.from], &places[line.to]];
        drawn.extend((0..=POINTS).map(|k| {
            let (place, _) = at_rest.at(f64::from(k) / f64::from(POINTS), ends);
            flat(&V3::new(place.x, place.y, bed.z_below(&place)))
        }));
        drawn.push(BREAK);
    }
    Some(Series {
        dimmed: true,
        ..Series::new("sea bed", INKS, drawn)
    })
}

/// The greatest distance along an axis between two points.
fn spread(solved: &SolvedSystem) -> f64 {
    let places = &solved.rest.placement.points;
    let along = |axis: usize| {
        let values = places.iter().map(|place| place[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
            (low.min(v), high.max(v))
        });
        high - low
    };
    (0..3).map(along).fold(1.0, f64::max)
}
