//! A ropeway drawn: platform, ship, water, the rope and the cargo on it, as a chart like any other.

use super::bare::Bare;
use super::work::{Readings, Worked};
use crate::report::chart::{Axis, Chart, Glyphs, Limit, LimitLine, Series, draw};

/// Points that a rope is drawn with.
const POINTS: usize = 80;

/// Parts of the span that platform and ship take beside it.
const ASIDE: f64 = 0.12;

type Points = Vec<(f64, f64)>;

const BREAK: (f64, f64) = (f64::NAN, f64::NAN);

/// The ropeway with the cargo where the readings have it: x from the platform, heights above still water. Heights are
/// drawn larger than lengths.
#[must_use]
pub fn chart(worked: &Worked, readings: &Readings) -> Chart {
    let (rope, cargo) = (rope(worked, readings), cargo(worked, readings));
    let lowest = rope.iter().chain(&cargo).map(|p| p.1);
    let low = lowest.filter(|z| z.is_finite()).fold(0.0, f64::min);
    let top = worked
        .ropeway
        .platform
        .height_m
        .max(worked.ropeway.ship.height_m);
    let room = 0.12 * (top - low).max(1.0);
    let (from, to) = (low - room, top + room);
    let span = worked.span.gap.span_m;
    let (left, right) = (-ASIDE * span, (1.0 + ASIDE) * span);
    let mut bare = Series::new("bare rope", 5, bare(worked));
    bare.dimmed = true;
    let crest = worked.ropeway.water.crest_m;
    let crests = Limit {
        label: "wave crest".to_owned(),
        line: LimitLine::Horizontal(crest),
    };
    Chart {
        title: worked.ropeway.about.title.clone(),
        x: Axis {
            range: Some((left, right)),
            ..Axis::new("from the platform", "m")
        },
        y: Axis {
            range: Some((from, to)),
            ..Axis::new("height", "m")
        },
        series: vec![
            bare,
            Series::new("water", 3, vec![(left, 0.0), (right, 0.0)]),
            Series::new("platform", 2, platform(worked, from)),
            Series::new("ship", 4, ship(worked)),
            Series::new("rope", 0, rope),
            Series::new("cargo", 1, cargo),
        ],
        limits: if crest > 0.0 {
            vec![crests]
        } else {
            Vec::new()
        },
        legend: true,
        ..Chart::default()
    }
}

/// The picture in characters, at most this wide and high.
#[must_use]
pub fn picture(
    worked: &Worked,
    readings: &Readings,
    size: (usize, usize),
    glyphs: Glyphs,
) -> String {
    draw(&chart(worked, readings), size.0, size.1, glyphs).to_text()
}

fn rope(worked: &Worked, readings: &Readings) -> Points {
    let (rest, height) = (&readings.exact, worked.ropeway.platform.height_m);
    let at = |i: usize| {
        let point = rest.solution.at(rest.length_m * i as f64 / POINTS as f64);
        (point.x_m, height + point.z_m)
    };
    let mut points: Points = (0..=POINTS).map(at).collect();
    points.push((rest.cargo_m.0, height + rest.cargo_m.1));
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// The bare rope of the paper's model.
fn bare(worked: &Worked) -> Points {
    let Ok(tabled) = &worked.tabled else {
        return Vec::new();
    };
    let rope: &Bare = &tabled.rope;
    let at = |i: usize| {
        let x = rope.gap.span_m * i as f64 / POINTS as f64;
        (x, worked.ropeway.platform.height_m + rope.height_m(x))
    };
    (0..=POINTS).map(at).collect()
}

/// A box that hangs below the rope, at least so deep that it is seen.
fn cargo(worked: &Worked, readings: &Readings) -> Points {
    let (x, below) = readings.exact.cargo_m;
    let z = worked.ropeway.platform.height_m + below;
    let half = 0.012 * worked.span.gap.span_m;
    let deep = worked.ropeway.cargo.drop_m.max(0.5);
    let corners = [
        (0.0, 0.0),
        (half, -0.2 * deep),
        (half, -deep),
        (-half, -deep),
        (-half, -0.2 * deep),
        (0.0, 0.0),
    ];
    corners.map(|(dx, dz)| (x + dx, z + dz)).to_vec()
}

/// A deck on two legs, beside the span.
fn platform(worked: &Worked, bottom: f64) -> Points {
    let (deck, wide) = (
        worked.ropeway.platform.height_m,
        ASIDE * worked.span.gap.span_m,
    );
    vec![
        (-wide, deck),
        (0.0, deck),
        BREAK,
        (-0.2 * wide, deck),
        (-0.2 * wide, bottom),
        BREAK,
        (-0.8 * wide, deck),
        (-0.8 * wide, bottom),
    ]
}

/// A hull with a mast that holds the rope, beside the span.
fn ship(worked: &Worked) -> Points {
    let (span, top) = (worked.span.gap.span_m, worked.ropeway.ship.height_m);
    let (deck, wide) = (0.35 * top, ASIDE * span);
    let keel = -0.25 * top;
    vec![
        (span, top),
        (span + 0.15 * wide, deck),
        (span, deck),
        (span + 0.2 * wide, keel),
        (span + wide, keel),
        BREAK,
        (span + 0.15 * wide, deck),
        (span + wide, deck),
    ]
}
