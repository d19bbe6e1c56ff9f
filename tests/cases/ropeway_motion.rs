//! The ropeway in motion: the crossing of its cargo.

use seacable::case::kind::{self, parse};
use seacable::ropeway::{Ropeway, SolvedRopeway};

const SPAN_80: &str = include_str!("../../cases/ropeway/span_80.toml");

fn with(text: &str, edits: &[(&str, &str)]) -> SolvedRopeway {
    parse::<Ropeway>(&kind::set_all::<Ropeway>(text, edits).unwrap(), "edited").unwrap()
}

/// Greatest differences of a slow crossing from the rope at rest at the same places, relative: tensions, and depth of the cargo.
fn off_rest(segments: &str) -> [f64; 2] {
    let edits = [
        ("ropeway.segments", segments),
        ("cargo.speed_m_per_s", "0.5"),
    ];
    let solved = with(SPAN_80, &edits);
    let (span, height) = (80.0, solved.ropeway.platform.height_m);
    let crossing = solved.dynamic_crossing().unwrap();
    let (first, last) = (&crossing[0], &crossing[crossing.len() - 1]);
    assert!((first.x_m / span - 0.95).abs() < 1e-3, "{first:?}");
    assert!((last.x_m / span - 0.05).abs() < 5e-3, "{last:?}");
    // The cargo gathers speed over 2 s.
    let hauled = crossing.iter().filter(|at| at.time_s > 3.0);
    hauled.fold([0.0_f64; 2], |[tension, depth], at| {
        let rest = solved.equilibrium(at.x_m / span).unwrap();
        let tensions = [at.platform_n / rest.platform_n(), at.ship_n / rest.ship_n()];
        let off = tensions.map(|ratio| (ratio - 1.0).abs());
        [
            tension.max(off[0]).max(off[1]),
            depth.max(((at.z_m - height) / rest.cargo_m.1 - 1.0).abs()),
        ]
    })
}

#[test]
fn the_cargo_crosses_on_the_exact_rope() {
    for segments in ["50", "100"] {
        let [tension, depth] = off_rest(segments);
        assert!(
            tension < 1e-3 && depth < 2e-3,
            "{segments}: {tension} {depth}"
        );
    }
}

#[test]
fn a_crossing_needs_no_more_segments_than_a_file_may_have_at_least() {
    let [tension, depth] = off_rest("4");
    assert!(tension < 1e-3 && depth < 2e-3, "{tension} {depth}");
}
