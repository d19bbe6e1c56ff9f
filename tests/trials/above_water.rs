//! Lines, points and springs above the water: they weigh there what they weigh in air, where the file asks for it.

use std::f64::consts::PI;

use seacable::audit::audit;
use seacable::audit::finding::Topic;
use seacable::import::ImportOptions;
use seacable::statics::catenary::{
    CatenaryLine, CrossingLine, EndOffset, RigidBed, SectionProperties, Solution,
};
use seacable::system::warnings::warnings;

use crate::trial::{channel, imported, imported_with, moved, path, solved, tension_at_b, text};

const HANGOFF: &str = "h02_hangoff_above_water.txt";
const SPRINGS: &str = "h12_linear_spring.map";

/// Tension at the top of the pipe string of `HANGOFF` \[N\]: 30 m are in air, with the stretch under their own weight and that below (closed form).
fn hangoff() -> f64 {
    let (g, rho, ea) = (9.81, 1025.0, 2e9);
    let (in_air, buoyancy) = (120.0 * g, rho * g * 0.25 * PI * 0.09);
    let mut dry = 30.0;
    let mut top = 0.0;
    for _ in 0..50 {
        top = 2000.0 * g + in_air * 130.0 - buoyancy * (130.0 - dry);
        dry = 30.0 / (1.0 + (top - 0.5 * in_air * dry) / ea);
    }
    top
}

/// A pipe string that hangs from 30 m above the water: 2000 g + 130 m in air less the buoyancy of 100 m, 101,580 N (public report MoorPy#14).
/// MoorDyn 2.7.2 has 98,612 N in the middle of its last segment, 101,555 N at the node.
#[test]
fn a_line_that_hangs_from_above_the_water_weighs_there_what_it_weighs_in_air() {
    let case = imported(HANGOFF);
    let system = solved(&case);
    let tension = tension_at_b(&system, "line1");
    let expected = hangoff();
    assert!((expected - 101_580.0).abs() < 3.0, "{expected}");
    assert!(
        (tension - expected).abs() < 1e-6 * expected,
        "{tension} {expected}"
    );
    let all = warnings(&system).join("\n");
    assert!(!all.contains("counts as under water"), "{all}");
    // An own file that does not ask for it has the pipe under water at any height, and says so.
    let own = case.replace("water_surface = \"crossed\"", "water_surface = \"ignored\"");
    let system = solved(&own);
    assert!((tension_at_b(&system, "line1") - 80_256.7).abs() < 0.1);
    let all = warnings(&system).join("\n");
    assert!(
        all.contains("30.0 m above the water and counts as under water"),
        "{all}"
    );
}

/// A run begins where the line rests.
#[test]
fn at_rest_a_line_above_the_water_is_as_its_motion_begins() {
    let case = imported(HANGOFF);
    let rest = tension_at_b(&solved(&case), "line1");
    let moving = format!("{case}\n[solver]\nduration_s = 0.5\nerror_estimate = false\n");
    let run = moved(&solved(&moving));
    for value in channel(&run, "tension_n[line1|b]") {
        assert!((value - rest).abs() < 2e-5 * rest, "{value} {rest}");
    }
}

/// MoorDyn weighs each segment by its share under water: the audit has what MoorDyn has, and finds nothing in the segments.
#[test]
fn an_audit_has_the_tension_of_moordyn_above_the_water() {
    let audit = audit(&text(HANGOFF), &path(HANGOFF), &ImportOptions::default()).unwrap();
    let lumped = audit.lines[0].lumped.unwrap();
    assert!((lumped / 98_612.0 - 1.0).abs() < 1e-3, "{lumped}");
    let mut meshes = audit.findings.iter().filter(|one| one.topic == Topic::Mesh);
    assert_eq!(meshes.next(), None);
}

/// A chain from an anchor on the bed to a fairlead above the water, by its closed form and divided (a current without speed divides it): the
/// difference is the error that the divided one states. The bed is stiff: a soft one lets the chain sink, and is as if it were lower by half of that.
#[test]
fn a_catenary_partly_in_air_is_that_of_many_segments() {
    for friction in [0.0, 0.4] {
        let closed = solved(&chain(12.0, "", friction));
        let fine = solved(&chain(12.0, "[current]\nspeed_m_per_s = 0.0\n", 0.0));
        assert!(!closed.is_discretised() && fine.is_discretised());
        let [one, other] = [&closed, &fine].map(|system| tension_at_b(system, "chain"));
        let stated = fine.errors.lines[0].unwrap();
        if friction == 0.0 {
            assert!(
                (one - other).abs() < 2.0 * stated + 1e-5 * one,
                "{one} {other} {stated}"
            );
        }
        assert!(closed.errors.lines[0].unwrap() < 1e-9 * one);
        // All of it under water it pulls less.
        let wet = chain(12.0, "", friction).replace("\"crossed\"", "\"ignored\"");
        let wet = wet.replace("kind = \"fixed\" # top", "kind = \"body\"\nbody = \"deck\"");
        let wet = format!("{wet}\n[bodies.deck]\nkind = \"held\"\n");
        let wet = tension_at_b(&solved(&wet), "chain");
        assert!(wet < 0.999 * one, "{wet} {one}");
    }
}

/// Raised through the surface by steps a line changes by its weight at most, without a jump where its end leaves the water.
#[test]
fn a_line_moves_through_the_surface_without_a_jump() {
    let tension = |z: f64| tension_at_b(&solved(&chain(z, "", 0.0)), "chain");
    let heights: Vec<f64> = (-8..=8).map(|k| 0.002 * f64::from(k)).collect();
    let tensions: Vec<f64> = heights.iter().map(|z| tension(*z)).collect();
    let slopes: Vec<f64> = tensions
        .windows(2)
        .map(|pair| (pair[1] - pair[0]) / 0.002)
        .collect();
    // In air there are 15 % more of weight to lift with each metre.
    for pair in slopes.windows(2) {
        assert!((pair[1] / pair[0] - 1.0).abs() < 0.2, "{slopes:?}");
    }
}

fn chain(z: f64, flow: &str, friction: f64) -> String {
    format!(
        "[system]\ntitle = \"t\"\n[environment]\nwater_surface = \"crossed\"\n[seabed]\ndepth_m = 100.0\nstiffness_n_per_m3 = 1e7\nfriction = {friction}\n{flow}\
         [materials.chain]\ndiameter_m = 0.16\nmass_kg_per_m = 160.0\nea_n = 7e8\n\
         [points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]\n\
         [points.top]\nkind = \"fixed\" # top\nposition_m = [480.0, 0.0, {z:?}]\n\
         [[lines]]\nname = \"chain\"\nfrom = \"anchor\"\nto = \"top\"\nmaterial = \"chain\"\nlength_m = 520.0\nsegments = 400\n"
    )
}

/// A clump is lifted out of the water, a buoy floats with the part of it under water that bears it: forces balance.
#[test]
fn points_weigh_what_they_weigh_above_the_water() {
    let hung = "[system]\ntitle = \"t\"\n[environment]\nwater_surface = \"crossed\"\ngravity_m_per_s2 = 10.0\nwater_density_kg_per_m3 = 1000.0\n\
         [materials.wire]\ndiameter_m = 0.02\nmass_kg_per_m = 1.0\nea_n = 1e8\n\
         [points.crane]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 20.0]\n\
         [points.load]\nkind = \"free\"\nposition_m = [0.0, 0.0, 5.0]\nmass_kg = 1000.0\nvolume_m3 = 0.4\n\
         [[lines]]\nname = \"wire\"\nfrom = \"crane\"\nto = \"load\"\nmaterial = \"wire\"\nlength_m = 10.0\n";
    let system = solved(hung);
    let [top, low] = system.rest.balance.lines[0].tensions();
    assert!((low - 10_000.0).abs() < 1e-3, "{low}");
    assert!((top - 10_100.0).abs() < 1e-3, "{top}");
    // Lowered until the wire is longer than its height it is under water: less by 4 kN, and by the wire's own.
    let system = solved(&hung.replace("length_m = 10.0", "length_m = 30.0"));
    let low = system.rest.balance.lines[0].tensions()[1];
    assert!((low - 6000.0).abs() < 1e-3, "{low}");
    // A buoy of 2 m3 and 900 kg floats on a chain that lies on the bed.
    let buoy = "[system]\ntitle = \"t\"\n[environment]\nwater_surface = \"crossed\"\ngravity_m_per_s2 = 10.0\nwater_density_kg_per_m3 = 1000.0\n\
         [seabed]\ndepth_m = 30.0\n[materials.chain]\ndiameter_m = 0.04\nmass_kg_per_m = 20.0\nwet_weight_kg_per_m = 18.0\nea_n = 1e8\n\
         [points.anchor]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -30.0]\n\
         [points.buoy]\nkind = \"free\"\nposition_m = [5.0, 0.0, 0.0]\nmass_kg = 900.0\nvolume_m3 = 2.0\n\
         [[lines]]\nname = \"chain\"\nfrom = \"anchor\"\nto = \"buoy\"\nmaterial = \"chain\"\nlength_m = 40.0\n";
    let system = solved(buoy);
    let buoy = system.network.point("buoy").unwrap();
    let z = system.rest.placement.points[buoy].z;
    let r = (0.75 * 2.0 / PI).cbrt();
    let share = (r - z).powi(2) * (2.0 * r + z) / (4.0 * r.powi(3));
    let pull = system.rest.balance.lines[0].force_b.z;
    assert!(
        (20_000.0 * share - 9000.0 + pull).abs() < 1e-3,
        "{z} {share} {pull}"
    );
    assert!(system.is_afloat(buoy) && z.abs() < r && share > 0.6);
}

/// Springs without weight of a MAP++ file (OpenFAST#1750) between a carriage 5 cm above the water and a model: `EA (l/L - 1)` = 120.384 N each,
/// which pull the model up with 4.63 N together.
#[test]
fn springs_without_weight_may_end_above_the_water() {
    let options = ImportOptions {
        depth: Some(3.0),
        gravity: Some(9.81),
        density: Some(1000.0),
        ..ImportOptions::default()
    };
    let system = solved(&imported_with(SPRINGS, &options));
    let (mut up, mut lines) = (0.0, 0);
    for line in &system.rest.balance.lines {
        for tension in line.tensions() {
            assert!((tension - 120.384).abs() < 1e-3, "{tension}");
        }
        up += line.force_b.z;
        lines += 1;
    }
    assert_eq!(lines, 3);
    assert!(
        (up.abs() - 4.63 * 3.0).abs() < 0.03 || (up.abs() - 4.63).abs() < 0.01,
        "{up}"
    );
}

/// Sections, the weight of the water that each displaces, height of end A above the water with the place of end B, and the bed.
type Crossing<'a> = (
    &'a [SectionProperties],
    &'a [f64],
    [f64; 3],
    Option<RigidBed>,
);

/// The end stiffness of lines that leave the water against differences: an end in air on either side or both, several sections, on a bed with
/// and without friction, slack.
#[test]
fn the_stiffness_of_a_line_that_leaves_the_water_is_exact() {
    let one = |length: f64, weight: f64, ea: f64| SectionProperties::new(length, weight, ea);
    let bed = |below_a_m: f64, friction: f64| {
        Some(RigidBed {
            below_a_m,
            slope_rad: 0.0,
            friction,
        })
    };
    let single = [one(500.0, 1000.0, 5e8)];
    let light = [one(405.0, 300.0, 5e8)];
    let laid = [one(900.0, 1000.0, 5e8)];
    let three = [
        one(300.0, 1500.0, 5e8),
        one(200.0, -300.0, 3e8),
        one(250.0, 800.0, 5e8),
    ];
    let cases: [Crossing; 8] = [
        (&single, &[150.0], [-200.0, 400.0, 230.0], None),
        (&single, &[150.0], [30.0, 400.0, -230.0], None),
        (&single, &[600.0], [20.0, 400.0, 10.0], None),
        (&light, &[900.0], [20.0, 400.0, 10.0], None),
        (&light, &[900.0], [60.0, 400.0, 10.0], None),
        (&three, &[100.0, 600.0, 150.0], [-150.0, 500.0, 180.0], None),
        (&laid, &[150.0], [-200.0, 830.0, 220.0], bed(0.0, 0.0)),
        (&laid, &[150.0], [-200.0, 830.0, 220.0], bed(0.0, 0.5)),
    ];
    for (number, (sections, displaced, [above, x, z], bed)) in cases.into_iter().enumerate() {
        let at = |dx: f64, a: f64, b: f64| {
            let below = bed.map(|bed| RigidBed {
                below_a_m: bed.below_a_m + a,
                ..bed
            });
            let line = CatenaryLine {
                ends: EndOffset {
                    x_m: x + dx,
                    z_m: z + b - a,
                },
                sections,
                bed: below,
                surface_above_a_m: None,
            };
            let crossing = CrossingLine {
                line,
                displaced_n_per_m: displaced,
                a_above_m: above + a,
            };
            crossing.solve().unwrap()
        };
        let forces = |line: &Solution| [line.h_a_n, line.v_a_n, line.h_b_n, line.v_b_n];
        let stiffness = at(0.0, 0.0, 0.0).end_stiffness(bed.map_or(0.0, |bed| bed.friction));
        let d = 1e-4;
        for column in 0..3 {
            if bed.is_some() && column == 1 {
                continue;
            }
            let step = |by: f64| match column {
                0 => at(by, 0.0, 0.0),
                1 => at(0.0, by, 0.0),
                _ => at(0.0, 0.0, by),
            };
            let (up, down) = (forces(&step(d)), forces(&step(-d)));
            let exact = [stiffness.h_a, stiffness.v_a, stiffness.h_b, stiffness.v_b];
            let scale = exact
                .iter()
                .map(|row| row[column].abs())
                .fold(1.0, f64::max);
            for k in 0..4 {
                let slope = (up[k] - down[k]) / (2.0 * d);
                assert!(
                    (slope - exact[k][column]).abs() < 1e-6 * scale,
                    "{number} {column} {k}: {slope} {}",
                    exact[k][column]
                );
            }
        }
    }
}
