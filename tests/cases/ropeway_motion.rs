//! The ropeway in motion: the crossing of its cargo, and the rope at the moving ship.

use seacable::case::kind::{self, parse};
use seacable::report::ropeway::winch;
use seacable::ropeway::rope_motion::MovingRope;
use seacable::ropeway::{Ropeway, SolvedRopeway};

const SPAN_80: &str = include_str!("../../cases/ropeway/span_80.toml");
const TENSION: &str = include_str!("../../cases/ropeway/constant_tension.toml");

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

/// The rope at the moving ship, made fast and on the winch.
fn at_ship(solved: &SolvedRopeway) -> [MovingRope; 2] {
    let motion = solved.rope_motion().unwrap();
    [
        motion.made_fast.unwrap(),
        motion.constant_tension.unwrap().unwrap(),
    ]
}

#[test]
fn slow_ships_have_the_tension_of_equilibria() {
    // Periods twenty times as long.
    let slow = [
        ("motion.surge_period_s", "577.6"),
        ("motion.heave_period_s", "96.8"),
        ("dynamics.duration_s", "300.0"),
    ];
    let limited = [&slow[..], &[("winch.speed_m_per_s", "0.01")]].concat();
    // A winch at its limits remembers how the motion grew over 20 s, which is not slow, until it has its tension again.
    for (edits, share) in [(&slow[..], 0.01), (&limited, 0.02)] {
        for rope in at_ship(&with(TENSION, edits)) {
            let [mean, deviation, least, greatest, speed] = rope.quasi_static;
            let limits = [mean, mean, least, greatest].map(|size| share * size);
            for (k, wanted) in [mean, deviation, least, greatest].into_iter().enumerate() {
                let off = (rope.results[k] - wanted).abs();
                assert!(off < limits[k], "{k}: {off} of {wanted}");
            }
            assert!((rope.results[4] - speed).abs() < 1e-3, "{speed}");
            let [time, mesh] = rope.errors.unwrap();
            assert!(time[3] + mesh[3] < 5e-3 * greatest);
        }
    }
}

#[test]
fn equilibria_hide_what_a_winch_cannot_follow() {
    let solved = with(TENSION, &[]);
    let [_, kept] = at_ship(&solved);
    // In equilibria it keeps its tension; in motion it comes to its greatest speed, 2 kW by 6 kN.
    assert!((kept.quasi_static[3] / 6000.0 - 1.0).abs() < 1e-6);
    let fastest = 2000.0 / 6000.0;
    assert!(
        (kept.results[4] / fastest - 1.0).abs() < 0.01,
        "{:?}",
        kept.results
    );
    assert!(
        (6500.0..7700.0).contains(&kept.results[3]),
        "{:?}",
        kept.results
    );
    assert!((kept.results[0] / 6000.0 - 1.0).abs() < 2e-3);
    let [time, mesh] = kept.errors.unwrap();
    let errors: [f64; 5] = std::array::from_fn(|k| time[k] + mesh[k]);
    assert!(
        errors[0] < 10.0 && errors[1] < 10.0 && errors[3] < 500.0,
        "{errors:?}"
    );
}

#[test]
fn the_report_shows_the_winch_in_motion() {
    let solved = with(TENSION, &[]);
    let followed = solved.run_winch(&solved.ship_motion().unwrap()).unwrap();
    let motion = solved.rope_motion();
    let text = winch::winch(&solved, &followed, motion.as_ref()).to_text(80);
    for part in [
        "in motion, maximum",
        "in motion, std deviation",
        "Equilibria are off from the rope in motion, on the winch",
        "Numerical errors in motion, on the winch",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let still = with(
        TENSION,
        &[("motion.surge_m", "0.0"), ("motion.heave_m", "0.0")],
    );
    assert!(still.rope_motion().is_none());
}

#[test]
fn what_is_not_covered_in_motion_says_so() {
    let short = with(TENSION, &[("rope.carrier.length_m", "81.0")]);
    let kept = short.rope_motion().unwrap().constant_tension;
    let why = kept.unwrap().unwrap_err().to_string();
    assert!(why.contains("runs out of rope"), "{why}");
    let at_support = with(TENSION, &[("cargo.position", "1.0")]);
    let fast = at_support.rope_motion().unwrap().made_fast;
    assert!(fast.unwrap_err().to_string().contains("support"));
}
