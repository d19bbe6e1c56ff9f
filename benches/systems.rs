//! What systems of lines at rest cost: `cargo bench --bench systems`. Least of many repeats.
#![expect(clippy::print_stdout, reason = "a bench prints its table")]

use std::hint::black_box;
use std::time::Instant;

use seacable::case::kind;
use seacable::numerics::V3;
use seacable::numerics::random::Random;
use seacable::statics::catenary::SectionProperties;
use seacable::system::SystemFile;
use seacable::system::analysis::clearance::distances;
use seacable::system::analysis::offset::HeldAway;
use seacable::system::analysis::periods::periods;
use seacable::system::bed::Bed;
use seacable::system::equilibrium::search;
use seacable::system::network::{FreePoint, Held, Line, Network, Point, StatedSection, reversed};
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
    growth("bridled lines", &[100, 300, 1000, 3000], bridles);
    growth("free points", &[100, 200, 400, 1000, 2000], chain);
}

/// Bridles of three lines around a circle, which share nothing with each other.
fn bridles(lines: usize) -> Network {
    let mut network = sea();
    let add = |network: &mut Network, place: Option<V3>| {
        let number = network.points.len();
        network.points.push(Point {
            name: format!("p{number}"),
            held: place.map_or_else(|| Held::Free(mass(500.0)), Held::At),
            motion: None,
        });
        number
    };
    let count = lines / 3;
    for k in 0..count {
        let (sin, cos) = (std::f64::consts::TAU * k as f64 / count as f64).sin_cos();
        let at = |out: f64, across: f64, z: f64| {
            V3::new(out * cos - across * sin, out * sin + across * cos, z)
        };
        let middle = add(&mut network, None);
        for (end, length) in [
            (at(300.0, 0.0, 0.0), 120.0),
            (at(300.0, -40.0, -200.0), 95.0),
            (at(300.0, 40.0, -200.0), 95.0),
        ] {
            let end = add(&mut network, Some(end));
            join(&mut network, (middle, end), length);
        }
    }
    network
}

/// A chain of free points, each on a line of its own.
fn chain(points: usize) -> Network {
    let mut network = sea();
    for k in 0..points {
        let top = V3::new(50.0 * k as f64, 0.0, 0.0);
        for (name, held) in [("f", Held::Free(mass(100.0))), ("x", Held::At(top))] {
            network.points.push(Point {
                name: format!("{name}{k}"),
                held,
                motion: None,
            });
        }
        join(&mut network, (2 * k, 2 * k + 1), 100.0);
        if k > 0 {
            join(&mut network, (2 * k - 2, 2 * k), 60.0);
        }
    }
    network
}

/// What a call takes of systems of these sizes, and the exponent by which it grows from the first to the last.
fn growth(what: &str, sizes: &[usize], build: fn(usize) -> Network) {
    let mut first = None;
    for size in sizes {
        let network = build(*size);
        let mut rest = None;
        let search = least(3, || rest = search(&network, &start(&network)).ok());
        let Some(rest) = rest else { continue };
        let modes = least(3, || {
            let _ = black_box(periods(&network, &rest));
        });
        let near = least(3, || {
            let _ = black_box(distances(&network, &rest));
        });
        let all = search + modes + near;
        let (from, least) = *first.get_or_insert((*size, all));
        let exponent = (all / least).ln() / (*size as f64 / from as f64).ln();
        println!(
            "{size:5} {what}: rest {:7.1} ms, periods {:7.1}, clearances {:7.1}; exponent {exponent:.2}",
            1e3 * search,
            1e3 * modes,
            1e3 * near
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

/// Still water without a bed.
fn sea() -> Network {
    Network {
        gravity: 9.806_65,
        density: 1025.0,
        ..Network::default()
    }
}

/// A point of a mass \[kg\] that displaces no water.
fn mass(mass: f64) -> FreePoint {
    FreePoint {
        weight: mass * 9.806_65,
        moving_mass: V3::repeat(mass),
        ..FreePoint::default()
    }
}

/// Joins two points by a line of a length \[m\].
fn join(network: &mut Network, (from, to): (usize, usize), length: f64) {
    let sections = vec![SectionProperties::new(length, 150.0, 3e8)];
    network.lines.push(Line {
        name: format!("l{}", network.lines.len()),
        from,
        to,
        reversed: reversed(&sections),
        parts: vec![StatedSection {
            length_m: length,
            ..StatedSection::default()
        }],
        sections,
        bed_contact: true,
        displaced: vec![0.0],
        displaced_reversed: vec![0.0],
        ..Line::default()
    });
}

/// A net of chains over the bed: rows of free points between anchors.
fn web(lines: usize, free: usize) -> Network {
    let mut random = Random::new(7, lines as u64);
    let mut network = sea();
    network.bed = Some(Bed::Level(-200.0));
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
    for k in 0..=free {
        let distance = (places[k + 1] - places[k]).norm();
        join(&mut network, (k, k + 1), 1.03 * distance);
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
        join(&mut network, (at, k), 1.05 * (anchor - place).norm());
    }
    network
}
