//! Floating bodies by the coefficients of a potential-flow code: files, memory, and the frequency domain in time.

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, Matrix6};
use seacable::case::kind;
use seacable::system::SystemFile;
use seacable::system::body_loads::body_loads;
use seacable::system::line_physics::LinePhysics;
use seacable::system::motion::body_equation::MovingBody;
use seacable::system::motion::run::{MotionRun, run};
use seacable::system::potential_flow::RadiationTable;
use seacable::system::potential_flow::retardation::Retardation;
use seacable::system::stiffness::of_body;

use crate::motion::{moved, refused};
use crate::waves::{SOFT, solver, swing};
use crate::{HEAD, solved};

const RADIUS: f64 = 10.0;
const DENSITY: f64 = 1025.0;
const G: f64 = 9.80665;

/// Heave of a floating hemisphere, added mass and damping by the displaced mass, over K a (Hulme 1982, table 1).
const HULME: [(f64, f64, f64); 25] = [
    (0.05, 0.8764, 0.1036),
    (0.1, 0.8627, 0.1816),
    (0.2, 0.7938, 0.2793),
    (0.3, 0.7157, 0.3254),
    (0.4, 0.6452, 0.3410),
    (0.5, 0.5861, 0.3391),
    (0.6, 0.5381, 0.3271),
    (0.7, 0.4999, 0.3098),
    (0.8, 0.4698, 0.2899),
    (0.9, 0.4464, 0.2691),
    (1.0, 0.4284, 0.2484),
    (1.2, 0.4047, 0.2096),
    (1.4, 0.3924, 0.1756),
    (1.6, 0.3871, 0.1469),
    (1.8, 0.3864, 0.1229),
    (2.0, 0.3884, 0.1031),
    (2.5, 0.3988, 0.0674),
    (3.0, 0.4111, 0.0452),
    (4.0, 0.4322, 0.0219),
    (5.0, 0.4471, 0.0116),
    (6.0, 0.4574, 0.0066),
    (7.0, 0.4647, 0.0040),
    (8.0, 0.4700, 0.0026),
    (9.0, 0.4740, 0.0017),
    (10.0, 0.4771, 0.0012),
];

fn displaced() -> f64 {
    2.0 / 3.0 * PI * RADIUS.powi(3) * DENSITY
}

fn omega(row: &(f64, f64, f64)) -> f64 {
    (G * row.0 / RADIUS).sqrt()
}

/// Load of the first order per amplitude, by Haskind's relation for a body of revolution: `X² = 2 rho g³ B / omega³`.
fn load(row: &(f64, f64, f64)) -> f64 {
    let w = omega(row);
    (2.0 * DENSITY * G.powi(3) * row.2 * displaced() * w / w.powi(3)).sqrt()
}

/// The files of the hemisphere: every mode but heave without radiation.
fn files() -> String {
    let volume = displaced() / DENSITY;
    let mut radiation = format!("0 3 3 {}\n", 0.5 * volume);
    let mut excitation = String::new();
    for row in &HULME {
        let period = TAU / omega(row);
        radiation.push_str(&format!(
            "{period:?} 3 3 {:?} {:?}\n",
            row.1 * volume,
            row.2 * volume
        ));
        let x = load(row) / (DENSITY * G);
        // A quarter of a period before the crest.
        excitation.push_str(&format!("{period:?} 0.0 3 {x:?} 90.0 0.0 {x:?}\n"));
    }
    format!(
        "[files.\"h.1\"]\ntext = \"\"\"{radiation}\"\"\"\n[files.\"h.3\"]\ntext = \"\"\"{excitation}\"\"\"\n"
    )
}

fn hemisphere(keys: &str, tables: &str) -> String {
    let stiffness = DENSITY * G * PI * RADIUS * RADIUS;
    format!(
        "{SOFT}[environment]\nwater_density_kg_per_m3 = {DENSITY:?}\n{tables}
        [bodies.ball]\nkind = \"free\"\nmass_kg = {:?}\nvolume_m3 = {:?}\ninertia_kg_m2 = [1e8, 1e8, 1e8]
        centre_of_gravity_m = [0.0, 0.0, -4.0]\ncentre_of_buoyancy_m = [0.0, 0.0, -3.75]
        waterplane_stiffness = [0.0, 0.0, {stiffness:?}, 8.05e7, 8.05e7, 0.0]\ndamping = [1e5, 1e5, 0.0, 1e8, 1e8, 1e8]
        radiation_file = \"h.1\"\n{keys}
        [points.anchor]\nkind = \"fixed\"\nposition_m = [150.0, 0.0, -5.0]
        [points.fairlead]\nkind = \"body\"\nbody = \"ball\"\nposition_m = [3.0, 0.0, -5.0]
        [[lines]]\nname = \"soft\"\nfrom = \"anchor\"\nto = \"fairlead\"\nmaterial = \"soft\"\nlength_m = 140.0\nsegments = 4
        repeat_at_deg = [0.0, 120.0, 240.0]\n",
        displaced(),
        displaced() / DENSITY,
    )
}

/// The hemisphere in a regular wave.
fn in_wave(period: f64) -> MotionRun {
    let wave = format!(
        "[[waves]]\nkind = \"regular\"\nheight_m = 0.2\nperiod_s = {period:?}\nramp_s = 20.0\n"
    );
    moved(&format!(
        "{}{}{}",
        hemisphere("excitation_file = \"h.3\"", &wave),
        solver(period * 30.0, period / 100.0, period / 50.0),
        files()
    ))
}

#[test]
fn a_hemisphere_comes_back_as_it_was() {
    let table = hemisphere_table();
    let made = Retardation::new(&table);
    assert!(made.error < 0.01, "{}", made.error);
    // One half at infinite frequency, from the finite ones.
    let infinite = made.at_infinity[(2, 2)] / displaced();
    assert!((infinite / 0.5 - 1.0).abs() < 1e-3, "{infinite}");
    for (w, row) in table.omega.iter().zip(&HULME) {
        let found = made.transformed_back(*w).0[(2, 2)] / displaced();
        assert!(
            (found / row.1 - 1.0).abs() < 0.01,
            "{}: {found} {}",
            row.0,
            row.1
        );
    }
}

/// Its added mass and damping, without that at infinite frequency.
fn hemisphere_table() -> RadiationTable {
    let heave = |value: f64| {
        let mut matrix = Matrix6::zeros();
        matrix[(2, 2)] = value * displaced();
        matrix
    };
    RadiationTable {
        omega: HULME.iter().map(omega).collect(),
        added: HULME.iter().map(|row| heave(row.1)).collect(),
        damping: HULME.iter().map(|row| heave(row.2 * omega(row))).collect(),
        at_zero: None,
        at_infinity: None,
    }
}

#[test]
fn regular_waves_give_the_response_of_the_frequency_domain() {
    for row in [&HULME[3], &HULME[7], &HULME[10], &HULME[15]] {
        let w = omega(row);
        let period = TAU / w;
        let run = in_wave(period);
        let (found, lead) = swing(&run, "z_m[ball]", period, 4.0);
        let mass = displaced() * (1.0 + row.1);
        let stiffness = DENSITY * G * PI * RADIUS * RADIUS;
        let impedance = Complex::new(stiffness - w * w * mass, w * w * row.2 * displaced());
        let exact = Complex::new(0.0, 0.1 * load(row)) / impedance;
        assert!(
            (found / exact.norm() - 1.0).abs() < 0.01,
            "{}: {found} {}",
            row.0,
            exact.norm()
        );
        let off = (lead - exact.arg() + PI).rem_euclid(TAU) - PI;
        assert!(off.abs() < 0.01, "{}: {lead} {}", row.0, exact.arg());
        assert!(run.warnings.is_empty(), "{:?}", run.warnings);
    }
}

/// Heave of the hemisphere let go by a line that held it down, at a time.
fn decay(step: f64) -> f64 {
    let run = moved(&format!(
        "{}{}{}",
        hemisphere(
            "load_n = [0.0, 0.0, 0.0]\n[points.below]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]
            [points.keel]\nkind = \"body\"\nbody = \"ball\"\nposition_m = [0.0, 0.0, -10.0]
            [materials.pull]\nmass_kg_per_m = 1.0\ndiameter_m = 0.03\nea_n = 4e7
            [[lines]]\nname = \"pull\"\nfrom = \"below\"\nto = \"keel\"\nmaterial = \"pull\"\nlength_m = 86.0\nsegments = 2\nrelease_b_s = 0.0\n",
            ""
        ),
        solver(12.0, step, 1.0),
        files()
    ));
    run.history.channel("z_m[ball]").unwrap().values[12]
}

#[test]
fn the_memory_is_of_second_order_in_time() {
    let [coarse, middle, fine] = [0.2, 0.1, 0.05].map(decay);
    let order = ((coarse - middle) / (middle - fine)).abs().log2();
    assert!(
        (1.7..2.6).contains(&order),
        "{order}: {coarse} {middle} {fine}"
    );
}

#[test]
fn files_that_do_not_fit_are_refused() {
    let with = |keys: &str, tables: &str, files: &str| {
        refused(&format!("{}{files}", hemisphere(keys, tables)))
    };
    let wave =
        "[[waves]]\nkind = \"regular\"\nheight_m = 0.2\nperiod_s = 9.0\ndirection_deg = 40.0\n";
    let heading = with("excitation_file = \"h.3\"", wave, &files());
    assert!(heading.contains("40.0 deg from the bow"), "{heading}");
    let twice = with("added_mass = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]", "", &files());
    assert!(twice.contains("given twice"), "{twice}");
    let counted = with(
        "excitation_file = \"h.3\"\n[[bodies.ball.members]]\nfrom_m = [0.0, 0.0, -9.0]\nto_m = [0.0, 0.0, 0.0]\ndiameter_m = 2.0",
        "",
        &files(),
    );
    assert!(counted.contains("drag_only"), "{counted}");
    let absent = with("drift_file = \"h.8\"", "", &files());
    assert!(absent.contains("cannot be read"), "{absent}");
    let bad = with("", "", &files().replace("0 3 3", "0 3 9"));
    assert!(bad.contains("h.1") && bad.contains("no mode"), "{bad}");
}

#[test]
fn loads_by_waves_without_waves_are_said_to_have_no_effect() {
    let body = hemisphere("excitation_file = \"h.3\"", "");
    let system = solved(&format!("{HEAD}{body}{}", files()));
    let warnings = seacable::system::warnings::warnings(&system);
    let said = "Body ball: excitation_file has no effect without [[waves]].";
    assert_eq!(warnings, [said]);
}

/// The shipped platform in one regular wave, without viscous damping, on lines whose inertia is nothing beside it.
fn platform(period: f64) -> String {
    let text = include_str!("../../cases/systems/volturnus_in_waves.toml");
    let (system, _) = text.split_once("[[waves]]").unwrap();
    let (before, rest) = system.split_once("quadratic_damping").unwrap();
    let (_, after) = rest.split_once("\n]\n").unwrap();
    let after = after.replace("segments = 50", "segments = 12");
    let before = before.replace(
        "diameter_m = 0.333\nmass_kg_per_m = 685.0",
        "diameter_m = 0.05\nmass_kg_per_m = 12.0",
    );
    let before = before.replace(
        "ea_n = 3.27e9\ndrag_normal = 1.11\ndrag_tangential = 0.2\n",
        "ea_n = 1e7\n",
    );
    // A little damping: what is not of the wave dies away.
    format!(
        "{before}damping = [4e5, 4e5, 0.0, 2e9, 2e9, 2e9]\n{after}
        [[waves]]\nkind = \"regular\"\nheight_m = 0.02\nperiod_s = {period:?}\nramp_s = {:?}\n{}",
        5.0 * period,
        solver(40.0 * period, period / 80.0, period / 40.0)
    )
}

#[test]
fn a_platform_answers_in_time_as_in_the_frequency_domain() {
    let at = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/systems/test.toml");
    for period in [9.0, 14.0] {
        let solved = kind::parse::<SystemFile>(&platform(period), at).unwrap();
        let given = solved.file.solver.clone().unwrap();
        let run = run(&solved, &given, &Default::default(), &mut |_| {}).unwrap();
        assert_eq!(run.failure, None);
        let (network, w) = (&solved.network, TAU / period);
        let pose = solved.rest.placement.bodies[0];
        let flow = network.bodies[0].potential_flow.as_ref().unwrap();
        let table = flow.radiation.as_ref().unwrap();
        let next = table.omega.partition_point(|known| *known < w);
        let share = (w - table.omega[next - 1]) / (table.omega[next] - table.omega[next - 1]);
        let between =
            |list: &[Matrix6<f64>]| list[next - 1] + (list[next] - list[next - 1]) * share;
        let mut bare = network.clone();
        bare.bodies[0].added_mass = between(&table.added);
        let mass = MovingBody::new(&bare, 0, &pose).mass;
        let damping = between(&table.damping) + network.bodies[0].damping;
        let lines = of_body(network, &solved.rest, 0).unwrap();
        let water = body_loads(network, &network.bodies[0], &pose, LinePhysics::Full).1;
        let stiffness = lines + water;
        let impedance = Matrix6::from_fn(|i, j| {
            Complex::new(
                stiffness[(i, j)] - w * w * mass[(i, j)],
                w * damping[(i, j)],
            )
        });
        let load = flow.excitation.as_ref().unwrap().at(0.0, w);
        let exact = impedance.lu().solve(&load).unwrap() * Complex::from(0.01);
        for (name, mode, unit) in [
            ("x_m", 0, 1.0),
            ("z_m", 2, 1.0),
            ("pitch_deg", 4, TAU / 360.0),
        ] {
            let (found, lead) = swing(&run, &format!("{name}[platform]"), period, 6.0);
            let wanted = exact[mode];
            assert!(
                (found * unit / wanted.norm() - 1.0).abs() < 0.01,
                "{period} {name}: {} {}",
                found * unit,
                wanted.norm()
            );
            let off = (lead - wanted.arg() + PI).rem_euclid(TAU) - PI;
            assert!(off.abs() < 0.02, "{period} {name}: {lead} {}", wanted.arg());
        }
    }
}

#[test]
fn a_system_with_files_can_be_edited_anywhere() {
    let text = include_str!("../../cases/systems/volturnus_in_waves.toml");
    let at = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/systems/test.toml");
    let edits = [("seabed.depth_m", "201.0")];
    assert!(kind::set_all::<SystemFile>(text, &edits).is_err());
    let whole = kind::whole_text::<SystemFile>(text, at).unwrap();
    let edited = kind::set_all::<SystemFile>(&whole, &edits).unwrap();
    assert!(edited.contains("depth_m = 201.0"));
}
