//! Elevation of a ropeway as a chart: platform, ship, water, the rope and the cargo on it.

use seacable_display::chart::{Axis, Chart, LimitLine, Outline, ReferenceLine, Series};
use seacable_systems::ropeway::unloaded::UnloadedRope;
use seacable_systems::ropeway::{ModelResults, SolvedRopeway};

/// Points that a rope is drawn with.
const POINTS: usize = 80;

/// Widths of platform and ship relative to the span.
const ASIDE: f64 = 0.12;

const BREAK: (f64, f64) = (f64::NAN, f64::NAN);

/// The ropeway at the position of the results: x from the platform, heights above still water, not to equal scale.
#[must_use]
pub fn chart(solved: &SolvedRopeway, results: &ModelResults) -> Chart {
    let (rope, cargo) = (rope(solved, results), cargo(solved, results));
    let lowest = rope.iter().chain(&cargo).map(|p| p.1);
    let low = lowest.filter(|z| z.is_finite()).fold(0.0, f64::min);
    let top = solved
        .ropeway
        .platform
        .height_m
        .max(solved.ropeway.ship.height_m);
    let room = 0.12 * (top - low).max(1.0);
    let (from, to) = (low - room, top + room);
    let span = solved.rope.geometry.span_m;
    let (left, right) = (-ASIDE * span, (1.0 + ASIDE) * span);
    let mut unloaded_rope = Series::new("unloaded rope", 5, unloaded(solved));
    unloaded_rope.dimmed = true;
    let crest = solved.ropeway.water.crest_m;
    let crests = ReferenceLine::new("wave crest", LimitLine::Horizontal(crest));
    let mut chart = Chart::new(
        &solved.ropeway.about.title,
        Axis::new("from the platform", "m").over((left, right)),
        Axis::new("height", "m").over((from, to)),
        vec![
            unloaded_rope,
            Series::new("water", 3, vec![(left, 0.0), (right, 0.0)]),
            Series::new("platform", 2, platform(solved, from)),
            Series::new("ship", 4, ship(solved)),
            Series::new("rope", 0, rope),
            Series::new("cargo", 1, cargo),
        ],
    );
    chart.limits.extend((crest > 0.0).then_some(crests));
    chart
}

fn rope(solved: &SolvedRopeway, results: &ModelResults) -> Outline {
    let (rest, height) = (&results.exact, solved.ropeway.platform.height_m);
    let at = |i: usize| {
        let point = rest.solution.at(rest.length_m * i as f64 / POINTS as f64);
        (point.x_m, height + point.z_m)
    };
    let mut points: Outline = (0..=POINTS).map(at).collect();
    points.push((rest.cargo_m.0, height + rest.cargo_m.1));
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// The unloaded rope of the inextensible model.
fn unloaded(solved: &SolvedRopeway) -> Outline {
    let Ok(inextensible) = &solved.inextensible else {
        return Vec::new();
    };
    let rope: &UnloadedRope = &inextensible.rope;
    let at = |i: usize| {
        let x = rope.geometry.span_m * i as f64 / POINTS as f64;
        (x, solved.ropeway.platform.height_m + rope.height_m(x))
    };
    (0..=POINTS).map(at).collect()
}

/// A box below the rope, at least 0.5 m high to be visible.
fn cargo(solved: &SolvedRopeway, results: &ModelResults) -> Outline {
    let (x, below) = results.exact.cargo_m;
    let z = solved.ropeway.platform.height_m + below;
    let half = 0.012 * solved.rope.geometry.span_m;
    let deep = solved.ropeway.cargo.drop_m.max(0.5);
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
fn platform(solved: &SolvedRopeway, bottom: f64) -> Outline {
    let (deck, wide) = (
        solved.ropeway.platform.height_m,
        ASIDE * solved.rope.geometry.span_m,
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
fn ship(solved: &SolvedRopeway) -> Outline {
    let (span, top) = (solved.rope.geometry.span_m, solved.ropeway.ship.height_m);
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
