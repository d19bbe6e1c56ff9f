//! A chain dragged sideways over a rough bed: as a line and as a system of it alone, on a slope and on the same slope by a grid of depths.

use std::fmt::Write as _;

use seacable::run::Run;

use crate::one_line::{line_run, system_run};

const CHAIN: &str = r"
[materials.chain]
diameter_m = 0.1
mass_kg_per_m = 180.0
ea_n = 8e8
drag_normal = 1.2
drag_tangential = 0.1
added_mass_normal = 1.0
";

const MOTION: &str = "amplitude_m = [0.0, 15.0, 0.0]\nperiod_s = 24.0\nramp_s = 4.0\n";

/// The chain from an anchor at this height, on a bed of these keys, as a line.
fn as_line(anchor_z: f64, bed: &str, solver: &str) -> Run {
    line_run(format!(
        "[case]\ntitle = \"A chain, as a line\"\n\
         [[line]]\nname = \"chain\"\nmaterial = \"chain\"\nlength_m = 202.0\nsegments = 50\n\
         [ends.a]\nname = \"anchor\"\nkind = \"anchor\"\nposition_m = [180.0, 0.0, {anchor_z:?}]\n\
         [ends.b]\nname = \"fairlead\"\nkind = \"moving\"\nposition_m = [0.0, 0.0, 0.0]\n{MOTION}\
         [seabed]\ndepth_m = 50.0\n{bed}{CHAIN}[start]\nshape = \"equilibrium\"\n{solver}"
    ))
}

/// The same as a system.
fn as_system(anchor_z: f64, bed: &str, solver: &str) -> Run {
    system_run(&system_text(anchor_z, bed, solver))
}

fn system_text(anchor_z: f64, bed: &str, solver: &str) -> String {
    format!(
        "[system]\ntitle = \"A chain, as a system\"\n\
         [points.anchor]\nkind = \"fixed\"\nposition_m = [180.0, 0.0, {anchor_z:?}]\n\
         [points.fairlead]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\n{MOTION}\
         [[lines]]\nname = \"chain\"\nfrom = \"anchor\"\nto = \"fairlead\"\nmaterial = \"chain\"\nlength_m = 202.0\nsegments = 50\n\
         [seabed]\ndepth_m = 50.0\n{bed}{CHAIN}{solver}"
    )
}

fn solver(method: &str, step: f64) -> String {
    format!(
        "[solver]\nduration_s = 8.0\nmethod = \"{method}\"\ntime_step_s = {step:?}\nerror_estimate = false\n\
         [output]\ninterval_s = 0.1\nshape_interval_s = 2.0\n"
    )
}

/// The greatest difference of the tensions at the ends \[N\], and of places of the line \[m\].
fn apart(line: &Run, system: &Run) -> (f64, f64) {
    let of = |run: &Run, name: &str| run.history.channel(name).unwrap().values.clone();
    let pairs = [
        ("tension_n[anchor|chain]", "tension_n[chain|a]"),
        ("tension_n[chain|fairlead]", "tension_n[chain|b]"),
    ];
    let mut tension = 0.0_f64;
    for (own, other) in pairs {
        let (own, other) = (of(line, own), of(system, other));
        assert_eq!((own.len(), other.len()), (81, 81));
        for (own, other) in own.iter().zip(&other) {
            tension = tension.max((own - other).abs());
        }
    }
    assert_eq!((line.shapes.len(), system.shapes.len()), (5, 5));
    let shapes = line.shapes.iter().zip(&system.shapes);
    let nodes = shapes.flat_map(|(own, other)| own.nodes.iter().zip(&other.nodes));
    let place = nodes.flat_map(|(own, other)| (0..3).map(|k| (own[k] - other[k]).abs()));
    (tension, place.fold(0.0, f64::max))
}

/// How far the nodes of the last shape went aside in all \[m\].
fn dragged(run: &Run) -> f64 {
    let nodes = &run.shapes.last().unwrap().nodes;
    nodes.iter().map(|node| node[1]).sum()
}

const LEVEL: &str = "stiffness_n_per_m3 = 1e5\ndamping_n_s_per_m3 = 1e4\n";

#[test]
fn a_line_and_its_system_are_dragged_alike() {
    for law in [
        "friction = 0.3\nfriction_lateral = 0.8\n",
        "friction = 0.3\nfriction_lateral = 0.8\ngrip_stiffness_n_per_m3 = 3e5\n",
        "friction = 0.4\nfriction_law = \"zhu-2017\"\nslip_speed_m_per_s = 0.05\n",
    ] {
        let rough = format!("{LEVEL}{law}");
        for (method, step) in [("alpha", 0.02), ("rk4", 5e-4), ("quasi", 0.05)] {
            let solver = solver(method, step);
            let line = as_line(-50.0, &rough, &solver);
            let system = as_system(-50.0, &rough, &solver);
            let (tension, place) = apart(&line, &system);
            println!("{law}{method}: {tension:e} N, {place:e} m");
            assert!(
                tension < 1e-2 && place < 1e-8,
                "{law}{method}: {tension} N, {place} m"
            );
        }
    }
}

/// Mirrored, turned by a right angle and written from the other end.
#[test]
fn a_system_turned_mirrored_and_reversed_is_dragged_alike() {
    let rough = format!("{LEVEL}friction = 0.3\nfriction_lateral = 0.8\n");
    let text = system_text(-50.0, &rough, &solver("alpha", 0.02));
    let run = |edits: &[(&str, &str)]| {
        let edited = edits.iter().fold(text.clone(), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        });
        system_run(&edited)
    };
    let tensions = |run: &Run, ends: [&str; 2]| {
        let of = |end: &str| {
            run.history
                .channel(&format!("tension_n[chain|{end}]"))
                .unwrap()
                .values
                .clone()
        };
        ends.map(of).concat()
    };
    let given = tensions(&run(&[]), ["a", "b"]);
    let aside = "[0.0, 15.0, 0.0]";
    let ends = "from = \"anchor\"\nto = \"fairlead\"";
    let turned = [
        (aside, "[-15.0, 0.0, 0.0]"),
        ("[180.0, 0.0, -50.0]", "[0.0, 180.0, -50.0]"),
    ];
    let cases: [(&[(&str, &str)], _); 3] = [
        (&[(aside, "[0.0, -15.0, 0.0]")], ["a", "b"]),
        (&turned, ["a", "b"]),
        (
            &[(ends, "from = \"fairlead\"\nto = \"anchor\"")],
            ["b", "a"],
        ),
    ];
    for (edits, ends) in cases {
        let other = tensions(&run(edits), ends);
        let apart = given.iter().zip(&other).map(|(a, b)| (a - b).abs());
        let apart = apart.fold(0.0, f64::max);
        println!("{edits:?}: {apart:e} N");
        assert!(apart < 2e-3, "{edits:?}: {apart} N");
    }
}

#[test]
fn friction_across_a_line_of_a_system_is_as_along_unless_given() {
    let solver = solver("alpha", 0.05);
    let run = |keys: &str| as_system(-50.0, &format!("{LEVEL}friction = 0.3\n{keys}"), &solver);
    let (silent, same) = (run(""), run("friction_lateral = 0.3\n"));
    assert_eq!(apart_of_systems(&silent, &same), 0.0);
    let rougher = run("friction_lateral = 0.8\n");
    let smooth = run("friction_lateral = 0.0\n");
    let moved = [&rougher, &silent, &smooth].map(dragged);
    assert!(
        moved[0] + 5.0 < moved[1] && moved[1] + 5.0 < moved[2],
        "{moved:?}"
    );
}

/// The greatest difference of the tensions at the fairlead \[N\].
fn apart_of_systems(one: &Run, other: &Run) -> f64 {
    let of = |run: &Run| {
        run.history
            .channel("tension_n[chain|b]")
            .unwrap()
            .values
            .clone()
    };
    let (one, other) = (of(one), of(other));
    let apart = one.iter().zip(&other).map(|(a, b)| (a - b).abs());
    apart.fold(0.0, f64::max)
}

/// Depths of a plane that rises by 0.1 towards an azimuth, every 100 m.
fn plane(azimuth: f64) -> String {
    let (sin, cos) = azimuth.sin_cos();
    let mut table = "x_m,y_m,depth_m\\n".to_owned();
    for i in -4..=4 {
        for j in -4..=4 {
            let (x, y) = (100.0 * f64::from(i), 100.0 * f64::from(j));
            let depth = 50.0 - 0.1 * (x * cos + y * sin);
            write!(table, "{x:?},{y:?},{depth:?}\\n").unwrap();
        }
    }
    format!("[files.\"bed.csv\"]\ntext = \"{table}\"\n")
}

/// Heights over a grid are vertical, those over a slope normal to it: springs under a slope of angle a are those over a grid by cos² a. A line
/// is laid as deep in the bed as it comes to rest, vertically below a grid and not below a slope: its places differ by that depth times the
/// slope, and ever less on a stiffer bed.
#[test]
fn a_grid_that_is_a_plane_is_the_slope() {
    let azimuth = 60.0_f64;
    let anchor_z = -50.0 + 0.1 * 180.0 * azimuth.to_radians().cos();
    let rough = "friction = 0.3\nfriction_lateral = 0.8\n";
    for (way, stiffness) in [("smooth", 1e6), ("bilinear", 1e6), ("smooth", 1e7)] {
        let by_slope = format!(
            "slope_deg = {:?}\nslope_azimuth_deg = {azimuth:?}\nstiffness_n_per_m3 = {:?}\ngrip_stiffness_n_per_m3 = {stiffness:?}\n{rough}",
            0.1_f64.atan().to_degrees(),
            stiffness * 1.01
        );
        let by_grid = format!(
            "depth_file = \"bed.csv\"\ninterpolation = \"{way}\"\nstiffness_n_per_m3 = {stiffness:?}\n{rough}"
        );
        let solver = solver("alpha", 0.02);
        let line = as_line(anchor_z, &by_slope, &solver);
        let solver = format!("{solver}{}", plane(azimuth.to_radians()));
        let system = as_system(anchor_z, &by_grid, &solver);
        let (tension, place) = apart(&line, &system);
        // The chain weighs 1,687 N/m in water and is 0.1 m wide.
        let depth = 1687.0 / (0.1 * stiffness);
        println!("{way} {stiffness}: {tension:e} N, {place:e} m");
        assert!(
            place < 0.1 * depth && tension < 1e3 * depth,
            "{way} {stiffness}: {tension} N, {place} m"
        );
    }
}
