//! What MoorDyn files may have besides the plain form: remarks, exponents, units, other words and orders; and what follows from a fault.

use seacable::case::{Diagnostic, kind};
use seacable::import::{self, ImportOptions, Imported};
use seacable::numerics::V3;
use seacable::system::quantities::value;
use seacable::system::{SolvedSystem, SystemFile};

/// A chain between two points, a body and a rod.
const PLAIN: &str = "\
--- LINE TYPES ---
TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)
chain 0.2 300 1.2e9 -1 0 1.2 1.0 0.1 0.25
--- BODIES ---
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 Fixed 10 20 -30 0 0 0 0 0 0 0 0 0
--- POINTS ---
ID Attachment X Y Z Mass Volume CdA Ca
(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)
1 Fixed 300 0 -100 0 0 0 0
2 Body1 10 -5 3 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (name) (#) (#) (m) (-) (-)
1 chain 1 2 310 20 -
--- OPTIONS ---
100 WtrDpth
";

fn read(text: &str) -> Result<Imported, Vec<Diagnostic>> {
    import::read(text, "file.dat", &ImportOptions::default())
}

fn solved(text: &str) -> SolvedSystem {
    let case = read(text).unwrap_or_else(|all| panic!("{text}\n{all:#?}"));
    kind::parse::<SystemFile>(&case.text, "case.toml").unwrap_or_else(|all| panic!("{all:#?}"))
}

fn tension(text: &str) -> f64 {
    value(&solved(text), "tension_n[line1|b]").unwrap()
}

/// The plain file with another text in the place of one.
fn with(of: &str, by: &str) -> String {
    assert!(PLAIN.contains(of), "{of}");
    PLAIN.replacen(of, by, 1)
}

#[test]
fn other_ways_to_write_the_same_file_are_the_same_system() {
    let plain = tension(PLAIN);
    for (of, by) in [
        ("300 1.2e9", "300 1.2+9"),
        ("1.2e9", "1.2D+09"),
        ("20 -\n", "20 - % a remark of Fortran\n"),
        ("310 20 -", "310 20 -!remark"),
        (
            "(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)",
            "name m kg/m N N-s N-m2 - - - -",
        ),
        ("100 WtrDpth", "100 WaterDepth"),
        ("--- LINE TYPES", "\u{feff}--- LINE TYPES"),
        ("2 Body1 10", "2 Body1Pinned 10"),
    ] {
        assert_eq!(tension(&with(of, by)).to_bits(), plain.to_bits(), "{by}");
    }
    let length_first = with(
        "ID LineType AttachA AttachB UnstrLen NumSegs",
        "ID LineType Length NumSegs NodeAnch NodeFair",
    );
    let length_first = length_first.replace("chain 1 2 310 20", "chain 310 20 1 2");
    assert_eq!(tension(&length_first).to_bits(), plain.to_bits());
}

/// A depth of 0 is that of the deepest fixed point, as in MoorDyn.
#[test]
fn a_depth_of_zero_is_none() {
    let text = with("100 WtrDpth", "0 WtrDpth");
    assert_eq!(tension(&text).to_bits(), tension(PLAIN).to_bits());
    let remarks = read(&text).unwrap().text;
    assert!(
        remarks.contains("that of the deepest fixed point"),
        "{remarks}"
    );
}

/// Where MoorDyn 2.7.2 has the point (`GetPointPos`) of a body with three angles.
#[test]
fn angles_of_bodies_are_taken_roll_first() {
    let system = solved(&with("-30 0 0 0 0 0 0 0 0", "-30 10 20 30 0 0 0 0 0"));
    let point = system.network.point("p2").unwrap();
    let known = V3::new(21.513, 20.833, -30.866);
    let found = system.rest.placement.points[point];
    assert!((found - known).norm() < 1e-3, "{found}");
}

/// A buoyant body on a vertical line: its points add mass and volume, and the line holds the rest.
#[test]
fn points_on_free_bodies_have_mass_and_volume() {
    let text = with(
        "1 Fixed 10 20 -30 0 0 0 0 0 0 0 0 0",
        "1 Free 300 0 -60 0 0 0 2000 0|0|-1 1e4 4 1 1",
    )
    .replace(
        "2 Body1 10 -5 3 0 0 0 0",
        "2 Body1 0 0 -2 500 0.5 1 1\n3 Body1 0 0 1 0 1.5 0 0",
    )
    .replace("chain 1 2 310", "chain 1 2 40")
    .replace("chain 0.2 300 1.2e9", "chain 0.05 5 1e8");
    let found = tension(&text);
    let expected = 9.80665 * (1025.0 * 6.0 - 2500.0);
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
    let loaded = text
        .replace("Mass Volume CdA Ca", "Mass Volume FX FY FZ CdA Ca")
        .replace("-100 0 0 0 0", "-100 0 0 0 0 0 0 0")
        .replace("500 0.5 1 1", "500 0.5 0 0 900 1 1")
        .replace("0 1.5 0 0", "0 1.5 0 0 0 0 0");
    let refused = read(&loaded).unwrap_err();
    assert!(
        refused[0].remedy.contains("--without loads"),
        "{refused:#?}"
    );
    assert_eq!((refused[0].line, refused[0].column), (13, 28));
}

/// A change of the plain file, the line of its only fault, and a part of the problem.
const FAULTS: [(&str, &str, u32, &str); 12] = [
    ("chain 0.2", "chain 0.2x", 4, "not a number"),
    ("1 Fixed 300", "1 Fixed 3oo", 12, "not a number"),
    ("1 Fixed 10", "1 Floating 10", 8, "what holds it"),
    ("2 Body1 10", "2 Pinned 10", 13, "cannot be pinned"),
    (
        "-100 0 0 0 0\n",
        "-100 0 0 5 5 5 0 0\n",
        12,
        "the header names 9",
    ),
    (
        "Cd Ca CdAx CaAx",
        "Cd CdAx Ca CaAx",
        2,
        "an order that MoorDyn does not read",
    ),
    (
        "Cd Ca CdAx CaAx",
        "Can Cdn Cat Cdt",
        2,
        "an order that MoorDyn does not read",
    ),
    (
        "BA/-zeta EI Cd Ca",
        "BA/-zeta Cd Ca",
        4,
        "more columns than the 9",
    ),
    ("--- LINES ---", "-- LINES --", 14, "three dashes"),
    (
        "chain 1 2 310",
        "chain 1 R1C 310",
        17,
        "which end of the rod",
    ),
    (
        "chain 1 2 310",
        "chain 1 R1BB 310",
        17,
        "which end of the rod",
    ),
    (
        "2 Body1 10 -5 3",
        "2 Turbine1 10 -5 -3 0 0 0 0\n3 Turbine2 10 -5 -3",
        14,
        "about another",
    ),
];

#[test]
fn a_fault_is_named_once_without_what_follows_from_it() {
    for (of, by, line, problem) in FAULTS {
        let all = read(&with(of, by)).expect_err(by);
        assert!(
            all.iter().any(|one| one.problem.contains(problem)),
            "{by}: {all:#?}"
        );
        let others = all.iter().filter(|one| one.line != line);
        // A section that is not found leaves its rows to the one before.
        assert!(
            by.contains("LINES") || others.count() == 0,
            "{by}: {all:#?}"
        );
    }
}

#[test]
fn a_line_comes_off_only_where_it_ends() {
    let text = with(
        "--- OPTIONS",
        "--- FAILURE ---\nFailID Point Lines FailTime FailTen\n() () () (s) (N)\n1 P2 1 10 0\n--- OPTIONS",
    );
    assert!(read(&text).is_ok());
    let elsewhere = text.replace("2 Body1 10", "3 Body1 1 1 1 0 0 0 0\n2 Body1 10");
    let all = read(&elsewhere.replace("1 P2 1", "1 P3 1")).unwrap_err();
    assert_eq!((all[0].line, all.len()), (22, 1), "{all:#?}");
    assert!(all[0].problem.contains("does not end at `P3`"), "{all:#?}");
}

/// Rows of the files that a file names: what is wrong with one is shown where it is named, with its line.
#[test]
fn files_beside_are_read_row_by_row() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file.dat");
    let read = |option: &str, file: &str, rows: &str| {
        std::fs::write(folder.path().join(file), rows).unwrap();
        let text = format!("{PLAIN}{option}\n");
        import::read(
            &text,
            &path.display().to_string(),
            &ImportOptions::default(),
        )
    };
    let profile = read(
        "1 Currents",
        "current_profile.txt",
        "a title\nz u\n0 0.5\n-100 0.1\n",
    );
    assert!(profile.unwrap().text.contains("speed_m_per_s = [0.5, 0.1]"));
    // A direction of a quarter turn; sines of the phase at nodes, cosines over a grid.
    for (mode, phase) in [(7, "-90.0"), (2, "0.0")] {
        let option = format!("{mode} WaveKin");
        let waves = read(
            &option,
            "wave_frequencies.txt",
            "0 0 0\n0.7 1.5 0 1.5707963267948966\n",
        );
        let text = waves.unwrap().text;
        assert!(text.contains(&format!("phase_deg = {phase} ")), "{text}");
        assert!(text.contains("direction_deg = 90.0"), "{text}");
    }
    for (option, file, rows, problem) in [
        (
            "1 Currents",
            "current_profile.txt",
            "0 0.5 0\n-100 0.x 0\n",
            "line 2: `0.x` is not",
        ),
        (
            "1 Currents",
            "current_profile.txt",
            "title\n0\n",
            "line 2 has 1 numbers",
        ),
        (
            "7 WaveKin",
            "wave_frequencies.txt",
            "0 0 0\n-0.5 1 0\n",
            "line 2: the frequency",
        ),
        (
            "2 WaveKin",
            "wave_frequencies.txt",
            "no numbers\n",
            "no rows of numbers",
        ),
        ("abc Currents", "x", "", "`abc` is not a number"),
    ] {
        let all = read(option, file, rows).unwrap_err();
        assert_eq!((all[0].line, all.len()), (20, 1), "{all:#?}");
        assert!(all[0].problem.contains(problem), "{all:#?}");
    }
}
