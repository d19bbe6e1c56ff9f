//! What systems of lines at rest cost: `cargo bench --bench systems`. Least of many repeats.
#![expect(clippy::print_stdout, reason = "a bench prints its table")]

use std::hint::black_box;
use std::time::Instant;

use seacable::case::kind;
use seacable::numerics::V3;
use seacable::numerics::random::Random;
use seacable::statics::catenary::SectionProperties;
use seacable::system::SystemFile;
use seacable::system::analysis::offset::HeldAway;
use seacable::system::bed::Bed;
use seacable::system::equilibrium::search;
use seacable::system::network::{FreePoint, Held, Line, Network, Point, reversed};
use seacable::system::start::start;

/// Headings and radii of the watch circle.
const HEADINGS: u32 = 72;
const RADII: u32 = 91;

fn main() {
    let text = include_str!("../cases/systems/oc3_spar.toml");
    let Ok(solved) = kind::parse::<SystemFile>(text, "oc3_spar.toml") else {
        return;
    };
    let (network, rest) = (&solved.network, &solved.rest);
    let mut held = HeldAway::new(network, rest, 0);
    let mut far = 0.0;
    let pose = least(20_000, || {
        far = if far > 5.0 { 0.0 } else { far + 0.01 };
        let _ = black_box(held.at([far, 0.0]));
    });
    println!(
        "a pose of three catenaries, started from the one before  {:8.2} us",
        1e6 * pose
    );
    let circle = least(20, || {
        std::thread::scope(|scope| {
            for half in 0..2 {
                let mut held = HeldAway::new(network, rest, 0);
                scope.spawn(move || {
                    for heading in (half * HEADINGS / 2)..((half + 1) * HEADINGS / 2) {
                        let angle =
                            std::f64::consts::TAU * f64::from(heading) / f64::from(HEADINGS);
                        for radius in 0..RADII {
                            let far = 20.0 * f64::from(radius) / f64::from(RADII);
                            let _ = black_box(held.at([far * angle.cos(), far * angle.sin()]));
                        }
                    }
                });
            }
        });
    });
    println!(
        "{} poses of three lines on two cores                   {:8.2} ms",
        HEADINGS * RADII,
        1e3 * circle
    );
    for (lines, points) in [(25, 12), (50, 25), (100, 50), (200, 100), (400, 200)] {
        let network = web(lines, points);
        let (mut steps, mut evaluations) = (0, 0);
        let cold = least(20, || {
            if let Ok(rest) = search(&network, &start(&network)) {
                (steps, evaluations) = (rest.steps, rest.evaluations);
            }
        });
        println!(
            "cold start, {lines:3} lines with {points:3} free points: {:6.2} ms in {steps} steps; {:5.2} us by line and evaluation of {evaluations}",
            1e3 * cold,
            1e6 * cold / (lines * evaluations) as f64
        );
    }
}

/// The least time of one call, in s.
fn least(repeats: u32, mut call: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..repeats {
        let begun = Instant::now();
        call();
        least = least.min(begun.elapsed().as_secs_f64());
    }
    least
}

/// A net of chains over the bed: rows of free points between anchors.
fn web(lines: usize, free: usize) -> Network {
    let mut random = Random::new(7, lines as u64);
    let mut network = Network {
        gravity: 9.806_65,
        density: 1025.0,
        bed: Some(Bed::Level(-200.0)),
        ..Network::default()
    };
    let mut places = Vec::new();
    for k in 0..free + 2 {
        let end = k == 0 || k == free + 1;
        let z = if end {
            -200.0
        } else {
            -60.0 - 40.0 * random.uniform()
        };
        let place = V3::new(100.0 * k as f64, 20.0 * random.uniform(), z);
        places.push(place);
        let held = if end {
            Held::At(place)
        } else {
            let (mass, volume) = (100.0, 8.0);
            Held::Free(FreePoint {
                weight: mass * 9.806_65,
                buoyancy: volume * 1025.0 * 9.806_65,
                ..FreePoint::default()
            })
        };
        network.points.push(Point {
            name: format!("p{k}"),
            held,
            motion: None,
        });
    }
    // A chain from point to point, and an anchor line from as many as are left.
    let join = |network: &mut Network, from: usize, to: usize, length: f64| {
        let sections = vec![SectionProperties::new(length, 150.0, 3e8)];
        network.lines.push(Line {
            name: format!("l{}", network.lines.len()),
            from,
            to,
            reversed: reversed(&sections),
            added_weight: 0.0,
            break_loads: vec![None],
            sections,
            still_water: false,
            friction: 0.0,
            releases: Default::default(),
            discretised: None,
            closed_where_known: false,
            bed_contact: true,
            displaced: vec![0.0],
            displaced_reversed: vec![0.0],
        });
    };
    for k in 0..=free {
        let distance = (places[k + 1] - places[k]).norm();
        join(&mut network, k, k + 1, 1.03 * distance);
    }
    let anchored = lines.saturating_sub(free + 1);
    for (k, place) in places.iter().enumerate().skip(1).take(anchored) {
        let side = if k % 2 == 0 { 150.0 } else { -150.0 };
        let anchor = V3::new(place.x, side, -200.0);
        network.points.push(Point {
            name: format!("a{k}"),
            held: Held::At(anchor),
            motion: None,
        });
        let at = network.points.len() - 1;
        join(&mut network, at, k, 1.05 * (anchor - place).norm());
    }
    network
}
