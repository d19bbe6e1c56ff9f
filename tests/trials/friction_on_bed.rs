//! Friction of lines that lie on the bed: one rule whichever end is written first, and the equilibrium that a line slides to in a current
//! across it.
//!
//! The ground chain weighs (20 - 1025 pi/4 0.06²) 9.80665 = 167.72 N/m in water: friction of 0.8 takes 20.126 kN off along 150 m of it.
//! The cable in a current across is that of CableDyn 0.3.0 (64,342 N with 115 elements, 64,347 N with 460; 58,980.5 N with a friction of
//! 1); at other currents a program written for this purpose, with friction by the same rule, gives the tensions of `SLID`.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use seacable::case::{kind, parse_keys};
use seacable::import::{self, ImportOptions};
use seacable::scene::{self, Scene};
use seacable::solve::{Kinematics, State};
use seacable::statics::equilibrium::{EquilibriumError, EquilibriumSearch};
use seacable::system::motion::run::run;
use seacable::system::{SolvedSystem, SystemFile};

const FROM_ANCHOR: &str = include_str!("files/ground_chain_from_anchor.toml");
const TO_ANCHOR: &str = include_str!("files/ground_chain_to_anchor.toml");
const LAID: &str = include_str!("files/laid_cross_current_mu0.3.toml");
const LAID_ROUGH: &str = include_str!("files/laid_cross_current_mu1_n230.toml");

/// Weight of the ground chain in water \[N/m\].
fn chain_weight() -> f64 {
    (20.0 - 1025.0 * PI / 4.0 * 0.06 * 0.06) * 9.80665
}

fn solved(text: &str) -> SolvedSystem {
    kind::parse::<SystemFile>(text, "system.toml").unwrap_or_else(|all| panic!("{text}\n{all:#?}"))
}

/// Tension of a line at the end that is at this point \[N\].
fn tension_at(system: &SolvedSystem, line: &str, point: &str) -> f64 {
    let index = system.network.line(line).unwrap();
    let [a, b] = system.rest.balance.lines[index].tensions();
    let at = system.network.point(point).unwrap();
    if system.network.lines[index].from == at {
        a
    } else {
        b
    }
}

fn assert_near(found: f64, wanted: f64, share: f64, what: &str) {
    let off = (found / wanted - 1.0).abs();
    assert!(off < share, "{what}: {found} for {wanted}, {off:.1e} off");
}

#[test]
fn a_ground_chain_is_the_same_written_from_either_end() {
    for (text, what) in [(FROM_ANCHOR, "from"), (TO_ANCHOR, "to")] {
        let system = solved(text);
        let anchor = tension_at(&system, "ground", "anchor");
        let clump = tension_at(&system, "ground", "clump");
        assert_near(anchor, 6256.0, 1e-3, what);
        assert_near(clump, 26_380.0, 1e-3, what);
        let lost = 0.8 * chain_weight() * 150.0;
        assert!((clump - anchor - lost).abs() < 1e-6 * clump, "{what}");
    }
}

/// The ground chain divided by free points without mass, each piece written either way.
#[test]
fn a_ground_chain_divided_by_free_points_is_the_same() {
    let whole = solved(FROM_ANCHOR);
    let wanted = tension_at(&whole, "ground", "anchor");
    let line = "name = \"ground\"\nfrom = \"anchor\"\nto = \"clump\"\nmaterial = \"w\"\nlength_m = 150.0\nsegments = 20";
    for turned in [false, true] {
        let piece = |name: &str, from: &str, to: &str, length: f64| {
            let (from, to) = if turned { (to, from) } else { (from, to) };
            format!(
                "name = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"w\"\nlength_m = {length:?}\nsegments = 20"
            )
        };
        let pieces = format!(
            "{}\n[[lines]]\n{}\n[[lines]]\n{}\n[points.j]\nkind = \"free\"\nposition_m = [-240.0, 0.0, -100.0]\n[points.k]\nkind = \"free\"\nposition_m = [-190.0, 0.0, -100.0]",
            piece("ground", "anchor", "j", 60.0),
            piece("second", "j", "k", 50.0),
            piece("third", "k", "clump", 40.0),
        );
        let divided = solved(&FROM_ANCHOR.replace(line, &pieces));
        let anchor = tension_at(&divided, "ground", "anchor");
        assert_near(anchor, wanted, 1e-8, "anchor");
        let clump = tension_at(&divided, "third", "clump");
        assert_near(clump, tension_at(&whole, "ground", "clump"), 1e-8, "clump");
    }
}

#[test]
fn a_ground_chain_in_motion_starts_with_the_friction_of_rest() {
    for text in [FROM_ANCHOR, TO_ANCHOR] {
        let text = format!("{text}\n[solver]\nduration_s = 2.0\n[output]\ninterval_s = 0.5\n");
        let system = solved(&text);
        let given = system.file.solver.clone().unwrap();
        let moved = run(&system, &given, &AtomicBool::new(false), &mut |_| {}).unwrap();
        assert_eq!(moved.failure, None);
        let end = if text.contains("to = \"anchor\"") {
            "b"
        } else {
            "a"
        };
        let name = format!("tension_n[ground|{end}]");
        for tension in &moved.history.channel(&name).unwrap().values {
            assert_near(*tension, 6800.0, 0.02, &name);
        }
    }
}

/// A chain on the bed between what these two points are, pulled at B by a riser, and at A if that is free.
fn ground(a: &str, b: &str, extra: &str) -> SolvedSystem {
    solved(&format!(
        "[system]\ntitle = \"ground\"\n[seabed]\ndepth_m = 100.0\nfriction = 0.8\n
[materials.w]\nmass_kg_per_m = 20.0\ndiameter_m = 0.06\nea_n = 1e8\n
[points.a]\n{a}\nposition_m = [-75.0, 0.0, -100.0]\n[points.b]\n{b}\nposition_m = [75.01, 0.0, -100.0]\n
[[lines]]\nname = \"ground\"\nfrom = \"a\"\nto = \"b\"\nmaterial = \"w\"\nlength_m = 150.0\nsegments = 20\n{extra}"
    ))
}

/// A riser from a point to a held top 150 m aside of the end at the bed.
fn riser(name: &str, point: &str, x: f64) -> String {
    format!(
        "[points.{name}]\nkind = \"fixed\"\nposition_m = [{x:?}, 0.0, 0.0]\n
[[lines]]\nname = \"rise_{name}\"\nfrom = \"{point}\"\nto = \"{name}\"\nmaterial = \"w\"\nlength_m = 185.0\nsegments = 20\n"
    )
}

#[test]
fn between_held_ends_friction_takes_nothing_off() {
    let held = ground("kind = \"fixed\"", "kind = \"fixed\"", "");
    let [a, b] = ["a", "b"].map(|point| tension_at(&held, "ground", point));
    assert_near(a, 1e8 * 0.01 / 150.0, 1e-9, "a");
    assert_near(b, a, 1e-12, "b");
}

#[test]
fn between_ends_that_are_pulled_friction_takes_off_from_both_towards_the_middle() {
    let free = "kind = \"free\"\nmass_kg = 500.0";
    let risers = format!(
        "{}{}",
        riser("left", "a", -225.0),
        riser("right", "b", 225.0)
    );
    let pulled = ground(free, free, &risers);
    let [a, b] = ["a", "b"].map(|point| tension_at(&pulled, "ground", point));
    assert_near(a, b, 1e-8, "both ends");
    let index = pulled.network.line("ground").unwrap();
    let ends =
        ["a", "b"].map(|name| &pulled.rest.placement.points[pulled.network.point(name).unwrap()]);
    let middle = pulled.rest.balance.lines[index].at(0.5, ends).1;
    assert_near(a - middle, 0.8 * chain_weight() * 75.0, 1e-6, "middle");
    // Divided off the middle it is the same.
    let text = format!(
        "{risers}[points.j]\nkind = \"free\"\nposition_m = [-25.0, 0.0, -100.0]\n
[[lines]]\nname = \"rest\"\nfrom = \"b\"\nto = \"j\"\nmaterial = \"w\"\nlength_m = 100.0\nsegments = 20\n"
    );
    let divided = solved(&format!(
        "[system]\ntitle = \"ground\"\n[seabed]\ndepth_m = 100.0\nfriction = 0.8\n
[materials.w]\nmass_kg_per_m = 20.0\ndiameter_m = 0.06\nea_n = 1e8\n
[points.a]\n{free}\nposition_m = [-75.0, 0.0, -100.0]\n[points.b]\n{free}\nposition_m = [75.01, 0.0, -100.0]\n
[[lines]]\nname = \"ground\"\nfrom = \"a\"\nto = \"j\"\nmaterial = \"w\"\nlength_m = 50.0\nsegments = 20\n{text}"
    ));
    assert_near(tension_at(&divided, "ground", "a"), a, 1e-7, "divided, a");
    assert_near(tension_at(&divided, "rest", "b"), b, 1e-7, "divided, b");
}

/// An anchor a hair above the bed, by rounding, lies on it: written whole, turned, and divided.
#[test]
fn an_end_that_is_on_the_bed_but_for_rounding_has_its_friction() {
    let text = |z: f64, lines: &str| {
        format!(
            "[system]\ntitle = \"hair\"\n[seabed]\ndepth_m = 1000.0\nfriction = 0.3\n
[materials.w]\nmass_kg_per_m = 20.0\ndiameter_m = 0.06\nea_n = 1e8\n
[points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, {z:?}]\n[points.b]\nkind = \"fixed\"\nposition_m = [28.2, 0.0, -995.0]\n{lines}"
        )
    };
    let line = |name: &str, from: &str, to: &str, length: f64| {
        format!(
            "[[lines]]\nname = \"{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"w\"\nlength_m = {length:?}\n"
        )
    };
    let on_bed = solved(&text(-1000.0, &line("l", "a", "b", 30.0)));
    let [anchor, top] = ["a", "b"].map(|point| tension_at(&on_bed, "l", point));
    // Pulled as far as the anchor.
    assert!(anchor > 0.0 && anchor < top, "{anchor} {top}");
    let between = "[points.between]\nkind = \"free\"\n";
    for hair in [1e-12, 2e-11, 1e-10, 5e-10, 1e-7] {
        let z = -1000.0 + hair;
        for (from, to) in [("a", "b"), ("b", "a")] {
            let whole = solved(&text(z, &line("l", from, to, 30.0)));
            for (point, wanted) in [("a", anchor), ("b", top)] {
                let what = format!("{hair} {point}");
                let off = (tension_at(&whole, "l", point) - wanted).abs();
                assert!(off < 1e-7 * top, "{what}: {off} N off {wanted}");
            }
        }
        let pieces = [
            line("low", "a", "between", 12.0),
            line("l", "between", "b", 18.0),
        ];
        let divided = solved(&text(z, &format!("{between}{}", pieces.concat())));
        for (line, point, wanted) in [("low", "a", anchor), ("l", "b", top)] {
            let off = (tension_at(&divided, line, point) - wanted).abs();
            assert!(
                off < 1e-7 * top,
                "{hair} divided {point}: {off} N off {wanted}"
            );
        }
    }
}

/// The cable at rest.
fn at_rest(text: &str) -> Result<(Scene, State), EquilibriumError> {
    let scene = scene::build(&parse_keys(text).unwrap(), 1).unwrap();
    let mut state = scene.initial_state();
    EquilibriumSearch::default().run(&scene, 0.0, &mut state)?;
    Ok((scene, state))
}

/// Tensions of the cable at fairlead and anchor \[N\].
fn cable_tensions(text: &str) -> [f64; 2] {
    let (scene, state) = at_rest(text).unwrap_or_else(|why| panic!("{why}\n{text}"));
    [0, scene.nodes() - 1].map(|node| scene.end_force(node, &state).norm())
}

/// The cable with this friction, current \[m/s\] and count of segments.
fn cable(friction: f64, speed: f64, segments: usize) -> String {
    LAID.replace("friction = 0.3", &format!("friction = {friction:?}"))
        .replace("speed_m_per_s = 1.2", &format!("speed_m_per_s = {speed:?}"))
        .replace("segments = 115", &format!("segments = {segments}"))
}

/// Friction, current \[m/s\] and tension at the fairlead \[N\].
const SLID: [(f64, f64, f64); 8] = [
    (0.3, 0.3, 55_330.0),
    (0.3, 0.9, 56_758.0),
    (0.3, 1.2, 64_345.0),
    (0.3, 1.6, 85_880.0),
    (1.0, 0.3, 55_333.0),
    (1.0, 0.9, 56_422.0),
    (1.0, 1.2, 58_982.0),
    (1.0, 1.6, 69_149.0),
];

#[test]
fn a_laid_cable_slides_across_until_tension_and_friction_hold_it() {
    for (text, fairlead) in [(LAID, 64_342.0), (LAID_ROUGH, 58_980.5)] {
        let [found, _] = cable_tensions(text);
        assert_near(found, fairlead, 5e-4, "fairlead");
    }
    let [_, anchor] = cable_tensions(LAID);
    // Read at the node, with half a segment's friction: of second order.
    assert_near(anchor, 32_460.0, 2e-3, "anchor");
    for (friction, speed, fairlead) in SLID {
        for segments in [115, 230] {
            let [found, _] = cable_tensions(&cable(friction, speed, segments));
            let what = format!("{friction} {speed} m/s {segments}");
            assert_near(found, fairlead, 3e-4, &what);
        }
    }
}

#[test]
fn a_cable_that_slides_converges_with_its_mesh() {
    for friction in [0.3, 1.0] {
        let tensions: Vec<[f64; 2]> = [115, 230, 460, 920]
            .map(|segments| cable_tensions(&cable(friction, 1.2, segments)))
            .to_vec();
        let [last, anchor] = tensions[3];
        for (found, share) in tensions.iter().zip([2e-4, 1e-4, 5e-5]) {
            assert_near(found[0], last, share, "fairlead");
            // With a friction of 1 nothing reaches the anchor.
            assert!(
                (found[1] - anchor).abs() < 10.0 * share * last,
                "{found:?} {anchor}"
            );
        }
    }
}

#[test]
fn a_cable_that_slides_is_the_same_turned_mirrored_and_reversed() {
    let text = cable(0.3, 0.9, 115);
    let wanted = cable_tensions(&text);
    let assert_same = |text: &str, ends: [usize; 2], what: &str| {
        let found = cable_tensions(text);
        for (end, wanted) in ends.into_iter().zip(wanted) {
            assert_near(found[end], wanted, 1e-6, what);
        }
    };
    let at = |x: f64, y: f64, z: f64| format!("position_m = [{x:?}, {y:?}, {z:?}]");
    let (fairlead, anchor) = (at(5.0, 0.0, -14.0), at(205.0, 0.0, -80.0));
    for degrees in [37.0_f64, -120.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let turned = text
            .replace(&fairlead, &at(5.0 * cos, 5.0 * sin, -14.0))
            .replace(&anchor, &at(205.0 * cos, 205.0 * sin, -80.0))
            .replace(
                "direction_deg = 90.0",
                &format!("direction_deg = {:?}", 90.0 + degrees),
            );
        assert_same(&turned, [0, 1], "turned");
    }
    let mirrored = text.replace("direction_deg = 90.0", "direction_deg = -90.0");
    assert_same(&mirrored, [0, 1], "mirrored");
    let reversed = text
        .replace(
            "[ends.a]\nname = \"fairlead\"",
            "[ends.other]\nname = \"fairlead\"",
        )
        .replace("[ends.b]", "[ends.a]")
        .replace("[ends.other]", "[ends.b]");
    assert_same(&reversed, [1, 0], "reversed");
}

/// The cable as a line of a system.
fn as_system(friction: f64, speed: f64, turned: bool) -> SolvedSystem {
    let (from, to) = if turned {
        ("anchor", "fairlead")
    } else {
        ("fairlead", "anchor")
    };
    solved(&format!(
        "[system]\ntitle = \"laid\"\n[environment]\nwater_density_kg_per_m3 = 1025.0\ngravity_m_per_s2 = 9.80665
[current]\nspeed_m_per_s = {speed:?}\ndirection_deg = 90.0
[seabed]\ndepth_m = 80.0\nstiffness_n_per_m3 = 1e5\ndamping_n_s_per_m3 = 1e4\nfriction = {friction:?}
[materials.cable]\ndiameter_m = 0.2\nmass_kg_per_m = 80.0\nea_n = 8e8\ndrag_normal = 1.2\ndrag_tangential = 0.1\ndrag_tangential_width = \"perimeter\"
[points.fairlead]\nkind = \"fixed\"\nposition_m = [5.0, 0.0, -14.0]
[points.anchor]\nkind = \"fixed\"\nposition_m = [205.0, 0.0, -80.0]
[[lines]]\nname = \"s1\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"cable\"\nlength_m = 230.0\nsegments = 115\n"
    ))
}

#[test]
fn a_line_of_a_system_slides_as_a_line_does() {
    for turned in [false, true] {
        for (friction, speed) in [(0.3, 1.2), (1.0, 1.2), (0.3, 0.6)] {
            let system = as_system(friction, speed, turned);
            let wanted = cable_tensions(&cable(friction, speed, 115));
            for (point, at) in ["fairlead", "anchor"].into_iter().zip(wanted) {
                let off = (tension_at(&system, "s1", point) - at).abs();
                assert!(
                    off < 1e-6 * wanted[0],
                    "{point} {friction} {speed}: {off} N off {at}"
                );
            }
        }
    }
}

#[test]
fn a_moordyn_line_in_a_current_lies_with_its_friction() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/trials/files/laid_md/laid_md.txt");
    let text = fs::read_to_string(&path).unwrap();
    let read = import::read(
        &text,
        &path.display().to_string(),
        &ImportOptions::default(),
    )
    .unwrap();
    let system = solved(&read.text);
    let [fairlead, anchor] = system.rest.balance.lines[0].tensions();
    assert_near(fairlead, 64_342.0, 5e-4, "fairlead");
    assert_near(anchor, 32_460.0, 2e-3, "anchor");
}

/// The cable in a current over a plane, sloping or as a grid of depths, along and across it.
#[test]
fn a_cable_slides_on_slopes_and_over_grids_of_depths() {
    let text = cable(0.3, 0.9, 115);
    let seabed = "depth_m = 80.0\n";
    let level = cable_tensions(&text);
    for (slope, azimuth) in [
        (0.0, 0.0),
        (3.0, 0.0),
        (3.0, 180.0),
        (4.0, 90.0),
        (4.0, -90.0),
    ] {
        let (tan, azimuth) = (f64::to_radians(slope).tan(), f64::to_radians(azimuth));
        let depth = |x: f64, y: f64| 80.0 - tan * ((x - 205.0) * azimuth.cos() + y * azimuth.sin());
        let plane = text.replace(
            seabed,
            &format!("depth_m = 80.0\nslope_deg = {slope:?}\nslope_azimuth_deg = {:?}\ndepth_at_m = [205.0, 0.0]\n", azimuth.to_degrees()),
        );
        let plane = if slope == 0.0 {
            level
        } else {
            cable_tensions(&plane)
        };
        assert!((level[0] / plane[0] - 1.0).abs() < 0.3);
        let mut table = "x_m,y_m,depth_m\\n".to_owned();
        for x in (-200..=400).step_by(50) {
            for y in (-200..=200).step_by(50) {
                let (x, y) = (f64::from(x), f64::from(y));
                table += &format!("{x:?},{y:?},{:?}\\n", depth(x, y));
            }
        }
        for way in ["smooth", "bilinear"] {
            let grid = text.replace(
                seabed,
                &format!("depth_m = 80.0\ndepth_file = \"bed.csv\"\ninterpolation = \"{way}\"\n"),
            );
            let grid = format!("{grid}\n[files.\"bed.csv\"]\ntext = \"{table}\"\n");
            let grid = cable_tensions(&grid);
            // The bed gives way by 25 mm, along the normal of a plane, over a grid vertically.
            for ((found, wanted), share) in grid.iter().zip(plane).zip([1e-5, 1e-3]) {
                let off = (found - wanted).abs();
                assert!(
                    off < share * plane[0],
                    "{way} {slope} {azimuth}: {off} N off {wanted}"
                );
            }
        }
    }
}
