//! Systems written as files of other programs: read again they are the same system, and written again the same text.

use std::fs;
use std::path::Path;

use seacable::case::kind;
use seacable::export::{ExportOptions, Exported, Target, export};
use seacable::import::ImportOptions;
use seacable::system::line_at_rest::LineAtRest;
use seacable::system::quantities::value;
use seacable::system::{SolvedSystem, SystemFile};

fn folder(name: &str) -> std::path::PathBuf {
    let folder =
        std::env::temp_dir().join(format!("seacable-export-{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn load(path: &Path, options: &ImportOptions) -> SolvedSystem {
    let loaded = seacable::open::load_as::<SystemFile>(path, options);
    loaded
        .unwrap_or_else(|found| panic!("{}: {found:?}", path.display()))
        .computed
}

/// What MAP++ is told from outside.
fn outside(solved: &SolvedSystem) -> ImportOptions {
    let environment = &solved.file.environment;
    ImportOptions {
        depth: solved
            .file
            .seabed
            .as_ref()
            .map(|bed| bed.depth_m)
            .or(Some(5000.0)),
        density: Some(environment.water_density_kg_per_m3),
        gravity: Some(environment.gravity_m_per_s2),
        ..ImportOptions::default()
    }
}

/// The system that was written and read again.
fn again(made: &Exported, folder: &Path, options: &ImportOptions) -> SolvedSystem {
    for (name, text) in &made.files {
        fs::write(folder.join(name), text).unwrap();
    }
    let path = folder.join("written.dat");
    fs::write(&path, &made.text).unwrap();
    load(&path, options)
}

fn written(solved: &SolvedSystem, target: Target) -> Exported {
    export(solved, target, ExportOptions::default()).unwrap_or_else(|refused| panic!("{refused:?}"))
}

#[test]
fn every_shipped_system_is_refused_or_read_again_as_the_same() {
    let mut tried = 0;
    let mut paths: Vec<_> = fs::read_dir("cases/systems")
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    paths.sort();
    for path in paths {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let solved = load(&path, &ImportOptions::default());
        for target in [Target::MoorDyn, Target::MapPlusPlus] {
            let Ok(made) = export(&solved, target, ExportOptions::default()) else {
                continue;
            };
            let folder = folder(&format!("{name}-{}", target.name().len()));
            let options = match target {
                Target::MoorDyn => ImportOptions::default(),
                Target::MapPlusPlus => outside(&solved),
            };
            let read = again(&made, &folder, &options);
            let twice = written(&read, target).text;
            assert_eq!(twice, made.text, "{name} {target:?}");
            same_tensions(&name, &solved, &read);
            tried += 1;
            fs::remove_dir_all(&folder).unwrap();
        }
    }
    assert!(tried >= 25, "{tried}");
}

/// The greatest end tensions of two systems, whose lines may be divided otherwise, and drag in a current by another length.
fn same_tensions(name: &str, one: &SolvedSystem, other: &SolvedSystem) {
    let greatest = |solved: &SolvedSystem| {
        let lines = solved.rest.balance.lines.iter();
        lines.flat_map(LineAtRest::tensions).fold(0.0, f64::max)
    };
    let [one, other] = [one, other].map(greatest);
    assert!((one / other - 1.0).abs() < 5e-3, "{name}: {one} {other}");
}

#[test]
fn places_at_rest_are_where_the_search_ends_at_once() {
    let text = "\
[system]
title = \"A clump in a chain\"
[seabed]
depth_m = 200.0
[materials.chain]
diameter_m = 0.09
mass_kg_per_m = 77.7066
ea_n = 384.243e6
[points.anchor]
kind = \"fixed\"
position_m = [400.0, 0.0, -200.0]
[points.clump]
kind = \"free\"
position_m = [200.0, 0.0, -110.0]
mass_kg = 20e3
volume_m3 = 2.0
[points.top]
kind = \"fixed\"
position_m = [0.0, 0.0, -20.0]
[[lines]]
name = \"lower\"
from = \"anchor\"
to = \"clump\"
material = \"chain\"
length_m = 230.0
[[lines]]
name = \"upper\"
from = \"clump\"
to = \"top\"
material = \"chain\"
length_m = 225.0
";
    let solved = kind::parse::<SystemFile>(text, "clump.toml").unwrap();
    let options = ExportOptions { at_rest: true };
    let made = export(&solved, Target::MoorDyn, options).unwrap();
    let rests = solved.rest.placement.points[1];
    let row = made.text.lines().find(|row| row.contains("Free")).unwrap();
    let z: f64 = row.split_whitespace().nth(4).unwrap().parse().unwrap();
    assert!((z - rests.z).abs() < 1e-6, "{row}");
    let folder = folder("at-rest");
    let read = again(&made, &folder, &ImportOptions::default());
    let tension =
        |solved: &SolvedSystem, line: &str| value(solved, &format!("tension_n[{line}|b]"));
    let (Ok(one), Ok(other)) = (tension(&solved, "upper"), tension(&read, "line2")) else {
        panic!("tensions are known");
    };
    assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
    // The audit of what was written finds its points at rest.
    let audit =
        seacable::audit::audit(&made.text, "written.dat", &ImportOptions::default()).unwrap();
    let starts = audit.findings.iter();
    assert!(
        starts.clone().all(|one| !one.subject.starts_with("point")),
        "{:?}",
        audit.findings
    );
    fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn what_cannot_be_said_is_refused_all_at_once() {
    let text = fs::read_to_string("cases/systems/winch_lowering.toml").unwrap();
    let solved = kind::parse::<SystemFile>(&text, "cases/systems/winch_lowering.toml").unwrap();
    let refused = export(&solved, Target::MoorDyn, ExportOptions::default()).unwrap_err();
    assert!(
        refused.iter().any(|one| one.key.starts_with("payouts.")),
        "{refused:?}"
    );
}

#[test]
fn weights_in_water_become_diameters() {
    let text = "\
[system]
title = \"A chain by its weight in water\"
[materials.chain]
diameter_m = 0.12
mass_kg_per_m = 100.0
wet_weight_kg_per_m = 87.0
ea_n = 1e9
drag_normal = 2.4
added_mass_normal = 1.0
[points.a]
kind = \"fixed\"
position_m = [0.0, 0.0, -10.0]
[points.b]
kind = \"fixed\"
position_m = [80.0, 0.0, -10.0]
[[lines]]
name = \"chain\"
from = \"a\"
to = \"b\"
material = \"chain\"
length_m = 100.0
";
    let solved = kind::parse::<SystemFile>(text, "chain.toml").unwrap();
    let made = written(&solved, Target::MoorDyn);
    assert!(
        made.remarks.iter().any(|one| one.contains("diameter")),
        "{:?}",
        made.remarks
    );
    let folder = folder("wet");
    let read = again(&made, &folder, &ImportOptions::default());
    same_tensions("chain", &solved, &read);
    let material = read.file.materials.values().next().unwrap();
    let expected = (4.0 * 13.0 / (std::f64::consts::PI * 1025.0)).sqrt();
    assert!((material.diameter_m / expected - 1.0).abs() < 1e-11);
    // Drag by length stays what it is.
    let drag = match material.drag_normal {
        seacable::case::DragCoefficient::Constant(drag) => drag,
        seacable::case::DragCoefficient::Named(_) => panic!("a number"),
    };
    assert!((drag * material.diameter_m / (2.4 * 0.12) - 1.0).abs() < 1e-10);
    fs::remove_dir_all(&folder).unwrap();
}

/// A line from a held rod of no segments, and one that lies over a bed of depths over a grid.
const CLAMPED: &str = "\
--- LINE TYPES ---
TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)
cable 0.2 60 7e8 -1 1e4 1.2 1 .1 0
--- ROD TYPES ---
TypeName Diam Mass/m Cd Ca CdEnd CaEnd
(name) (m) (kg/m) (-) (-) (-) (-)
conn 0.2 0 0 0 0 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 conn Coupled 0 0 -20 0 0 -21 0 -
2 conn Fixed 150 0 -200 151 0 -200 0 -
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (name) (#) (#) (m) (-) (-)
1 cable R1B R2A 250 40 p
--- OPTIONS ---
200 WtrDpth
9.81 g
";

#[test]
fn clamps_at_held_points_are_rods_of_no_segments() {
    let folder = folder("clamped");
    let path = folder.join("clamped.dat");
    fs::write(&path, CLAMPED).unwrap();
    let solved = load(&path, &ImportOptions::default());
    let clamps = |solved: &SolvedSystem| {
        let line = &solved.file.lines[0];
        [line.clamp_a_elevation_deg, line.clamp_b_elevation_deg]
    };
    assert_eq!(clamps(&solved), [Some(-90.0), Some(0.0)]);
    let made = written(&solved, Target::MoorDyn);
    let read = again(&made, &folder, &ImportOptions::default());
    assert_eq!(clamps(&read), clamps(&solved), "{}", made.text);
    same_tensions("clamped", &solved, &read);
    fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn depths_over_a_grid_are_written_beside_the_file() {
    let folder = folder("grid");
    let path = folder.join("grid.dat");
    let points = "--- POINTS ---\nID Attachment X Y Z Mass Volume CdA Ca\n1 Fixed 600 0 -200 0 0 0 0\n2 Coupled 20 0 -14 0 0 0 0\n";
    let (types, rest) = CLAMPED.split_once("--- ROD TYPES").unwrap();
    let (_, lines) = rest.split_once("--- LINES").unwrap();
    let lines = lines
        .replace("R1B R2A 250", "1 2 640")
        .replace("200 WtrDpth", "200 WtrDpth\ndepths.txt SeafloorFile");
    fs::write(&path, format!("{types}{points}--- LINES{lines}")).unwrap();
    let depths = "3 2\n-1000 0 1000\n-1000 1000\n-1000 -1000 -200\n0 -1000 -200\n1000 -1000 -200\n-1000 1000 -200\n0 1000 -200\n1000 1000 -200\n";
    fs::write(folder.join("depths.txt"), depths).unwrap();
    let solved = load(&path, &ImportOptions::default());
    let made = written(&solved, Target::MoorDyn);
    assert!(
        made.text.contains("seafloor.txt  SeafloorFile"),
        "{}",
        made.text
    );
    assert_eq!(made.files[0].0, "seafloor.txt");
    let words = |text: &str| -> Vec<f64> {
        text.split_whitespace()
            .map(|word| word.parse().unwrap())
            .collect()
    };
    assert_eq!(words(&made.files[0].1), words(depths));
    let read = again(&made, &folder, &ImportOptions::default());
    assert_eq!(written(&read, Target::MoorDyn).text, made.text);
    same_tensions("grid", &solved, &read);
    let refused = export(&solved, Target::MapPlusPlus, ExportOptions::default()).unwrap_err();
    assert!(
        refused
            .iter()
            .any(|one| one.what.contains("has no depths over a grid")),
        "{refused:?}"
    );
    fs::remove_dir_all(&folder).unwrap();
}

/// Waves and a friction that all lines have, read again: the same to the last digits written, and the same text and files.
#[test]
fn waves_and_friction_are_read_again_as_the_same() {
    let text = "\
[system]
title = \"Waves from two sides\"
[seabed]
depth_m = 100.0
[[waves]]
kind = \"components\"
heights_m = [1.0, 0.5]
periods_s = [12.0, 8.0]
phases_deg = [30.0, 0.0]
[[waves]]
kind = \"regular\"
height_m = 2.0
period_s = 9.0
direction_deg = 60.0
phase_deg = -120.0
[materials.chain]
diameter_m = 0.1
mass_kg_per_m = 50.0
ea_n = 5e8
drag_normal = 1.2
added_mass_normal = 1.0
[points.anchor]
kind = \"fixed\"
position_m = [200.0, 0.0, -100.0]
[points.top]
kind = \"moved\"
position_m = [0.0, 0.0, -10.0]
[[lines]]
name = \"line\"
from = \"anchor\"
to = \"top\"
material = \"chain\"
length_m = 230.0
friction = 0.4
";
    let solved = kind::parse::<SystemFile>(text, "waves.toml").unwrap();
    let first = written(&solved, Target::MoorDyn);
    let folder = folder("waves");
    let read = again(&first, &folder, &ImportOptions::default());
    let second = written(&read, Target::MoorDyn);
    assert_eq!(first.text, second.text);
    assert_eq!(first.files, second.files);
    // The elevation at the origin at time 0 is that of the crests' leads.
    let elevation = |solved: &SolvedSystem| -> f64 {
        let of = |waves: &seacable::case::Waves| match (&waves.heights_m, &waves.phases_deg) {
            (Some(heights), Some(phases)) => {
                let pairs = heights.iter().zip(phases);
                pairs
                    .map(|(h, p)| 0.5 * h * p.to_radians().cos())
                    .sum::<f64>()
            }
            _ => 0.5 * waves.height_m.unwrap() * waves.phase_deg.to_radians().cos(),
        };
        solved.file.waves.iter().map(of).sum()
    };
    assert!((elevation(&solved) - elevation(&read)).abs() < 1e-10);
    assert_eq!(read.file.waves.len(), 3);
    assert_eq!(read.file.seabed.as_ref().unwrap().friction, Some(0.4));
    fs::remove_dir_all(&folder).unwrap();
    // MoorDyn has one coefficient.
    let text = format!("{text}friction_lateral = 0.8\n");
    let solved = kind::parse::<SystemFile>(&text, "waves.toml").unwrap();
    let refused = export(&solved, Target::MoorDyn, ExportOptions::default()).unwrap_err();
    let across = |one: &seacable::export::Unsayable| one.key == "lines.line.friction_lateral";
    assert!(refused.iter().any(across), "{refused:?}");
}

/// A point of MoorDyn has one drag area; MAP++ has no current, in which lines at rest have drag.
#[test]
fn drag_across_and_along_a_line_is_refused_where_a_file_has_none() {
    let text = r#"
system.title = "modules"
environment.gravity_m_per_s2 = 9.80665
materials.rope = { diameter_m = 0.1, mass_kg_per_m = 20.0, ea_n = 1e7 }
points.a = { kind = "fixed", position_m = [0.0, 0.0, -90.0] }
points.b = { kind = "fixed", position_m = [80.0, 0.0, -10.0] }
[[lines]]
name = "riser"
from = "a"
to = "b"
[[lines.sections]]
material = "rope"
length_m = 60.0
clump_kg = -50.0
clump_drag_area_normal_m2 = 2.0
clump_drag_area_tangential_m2 = 0.5
clump_added_mass_normal_kg = 30.0
[[lines.sections]]
material = "rope"
length_m = 60.0
"#;
    let solved = kind::parse::<SystemFile>(text, "modules.toml").unwrap();
    let refused = export(&solved, Target::MoorDyn, ExportOptions::default()).unwrap_err();
    let keys: Vec<&str> = refused.iter().map(|one| one.key.as_str()).collect();
    assert_eq!(
        keys,
        [
            "lines.riser.sections.1.clump_drag_area_normal_m2",
            "lines.riser.sections.1.clump_drag_area_tangential_m2",
            "lines.riser.sections.1.clump_added_mass_normal_kg"
        ]
    );
    written(&solved, Target::MapPlusPlus);
}
