//! Files of other programs whose words are odd but clear, and what of them is said.
//!
//! Answers are those of MoorPy 1.3.0, MoorDyn 2.7.2, MAP++ 1.30, CableDyn 0.3.0 or a closed form, as said; g is 9.80665 m/s² where the file is
//! silent.

use std::path::Path;
use std::time::{Duration, Instant};

use seacable::case::{Diagnostic, kind};
use seacable::import::{self, ImportOptions, Imported, yaml::library};
use seacable::numerics::V3;
use seacable::system::quantities::value;
use seacable::system::{SolvedSystem, SystemFile};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/trials/files/importers");

fn text_of(name: &str) -> String {
    std::fs::read_to_string(Path::new(FOLDER).join(name)).unwrap()
}

/// The case of a text that stands in the folder.
fn read(text: &str, options: &ImportOptions) -> Result<Imported, Vec<Diagnostic>> {
    import::read(text, &format!("{FOLDER}/changed.dat"), options)
}

fn case_of(text: &str, options: &ImportOptions) -> String {
    let case = read(text, options).unwrap_or_else(|all| panic!("{text}\n{all:#?}"));
    case.text
}

fn solved(text: &str, options: &ImportOptions) -> SolvedSystem {
    let case = case_of(text, options);
    let found = kind::parse::<SystemFile>(&case, "case.toml");
    found.unwrap_or_else(|all| panic!("{case}\n{all:#?}"))
}

fn tension(text: &str, options: &ImportOptions, end: &str) -> f64 {
    value(&solved(text, options), &format!("tension_n[line1|{end}]")).unwrap()
}

fn refused(text: &str, options: &ImportOptions) -> Diagnostic {
    let Err(all) = read(text, options) else {
        panic!("read: {text}");
    };
    all.into_iter().next().unwrap()
}

fn plain() -> ImportOptions {
    ImportOptions::default()
}

/// What the program that calls MAP++ says.
fn of_map(depth: f64) -> ImportOptions {
    ImportOptions {
        depth: Some(depth),
        density: Some(1025.0),
        gravity: Some(9.80665),
        ..plain()
    }
}

fn without(name: &str) -> ImportOptions {
    ImportOptions {
        without: vec![name.to_owned()],
        ..plain()
    }
}

fn near(found: f64, right: f64, share: f64) {
    assert!((found / right - 1.0).abs() < share, "{found} {right}");
}

/// A text with another in the place of a part that it has.
fn with(text: &str, of: &str, by: &str) -> String {
    assert!(text.contains(of), "{of}");
    text.replacen(of, by, 1)
}

/// As `Coupled`, 25,983.3 N (MoorDyn 2.7.2 takes Coupled1, Vessel1, Free1, Connect1 for points, rods and bodies, Pinned1 for rods).
#[test]
fn numbers_behind_words_that_hold_are_passed_over() {
    let text = text_of("coupled1.txt");
    near(tension(&text, &plain(), "b"), 25_983.3, 1e-5);
    let bits = tension(&text, &plain(), "b").to_bits();
    for word in [
        "Coupled",
        "Vessel1",
        "Ves2",
        "Cpld1",
        "Fairlead1",
        "Fixed1",
        "Anchor3",
    ] {
        let other = with(&text, "Coupled1", word);
        assert_eq!(tension(&other, &plain(), "b").to_bits(), bits, "{word}");
    }
    let said = "The number in Coupled1 has no effect, as in MoorDyn.";
    assert_eq!(case_of(&text, &plain()).matches(said).count(), 1);
    assert!(!case_of(&with(&text, "Coupled1", "Coupled"), &plain()).contains("has no effect"));
    // What stands behind the number MoorDyn leaves out: which is meant is not clear.
    let fault = refused(&with(&text, "Coupled1", "Coupled1Pinned"), &plain());
    assert_eq!((fault.line, fault.column), (10, 3));
    assert!(fault.problem.contains("`pinned`"), "{fault}");
    let fault = refused(&with(&text, "Coupled1", "Tied1"), &plain());
    assert!(
        fault.problem.contains("does not say what holds it"),
        "{fault}"
    );
}

#[test]
fn rods_and_bodies_have_such_words_too() {
    const PARTS: &str = "--- ROD TYPES ---\nName Diam Mass/m Cd Ca CdEnd CaEnd\n(-) (m) (kg/m) (-) (-) (-) (-)\nr 0.2 60 1 1 0 0\n\
        --- BODIES ---\nID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*\n\
        (#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)\n1 Fixed1 0 0 -30 0 0 0 0 0 0 0 0 0\n\
        --- RODS ---\nID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs\n(#) (-) (-) (m) (m) (m) (m) (m) (m) (-) (-)\n\
        1 r Pinned1 0 0 -10 0 0 -15 5 -\n--- OPTIONS ---\n50 WtrDpth\n";
    let case = case_of(PARTS, &plain());
    assert!(case.contains("kind = \"pinned\""), "{case}");
    assert!(
        case.contains("The number in Fixed1 has no effect"),
        "{case}"
    );
    assert!(
        case.contains("The number in Pinned1 has no effect"),
        "{case}"
    );
    for word in ["Free1", "Con2", "Point3"] {
        let case = case_of(&with(PARTS, "Pinned1", word), &plain());
        assert!(case.contains("kind = \"free\""), "{word}: {case}");
    }
}

/// 895,014.9 N at the fairlead, 707,787.5 at the anchor (MoorPy).
#[test]
fn the_first_version_is_known_by_more_than_one_word() {
    let text = text_of("v1_numnodes.txt");
    near(tension(&text, &plain(), "b"), 895_014.9, 1e-6);
    near(tension(&text, &plain(), "a"), 707_787.5, 1e-6);
    let case = case_of(&text, &plain());
    assert!(case.contains("a file of MoorDyn 1"), "{case}");
    assert!(
        case.contains("NumNodes is the number of segments"),
        "{case}"
    );
    let bits = tension(&text, &plain(), "b").to_bits();
    let named = with(&text, "NumNodes", "NumSegs");
    assert_eq!(tension(&named, &plain(), "b").to_bits(), bits);
    // Sections in another order, blank rows and remarks between.
    let lines = text.find("---------------------- LINE PROPERTIES").unwrap();
    let options = text.find("---------------------- SOLVER OPTIONS").unwrap();
    let first = text.find("---------------------- LINE DICTIONARY").unwrap();
    let moved = [
        &text[..first],
        &text[lines..options],
        &text[first..lines],
        &text[options..],
    ]
    .concat();
    let remarked = moved.replace(
        "LineType  Diam",
        "# the line types\n\n! of the leg\nLineType  Diam",
    );
    assert_eq!(tension(&remarked, &plain(), "b").to_bits(), bits);
}

/// 3,079,061.7 N each (MAP++); T = EA (z - L)/L + w L/2 = 3,079,058 N.
#[test]
fn line_types_of_map_need_five_columns() {
    let text = text_of("map_five_columns.map");
    let found = solved(&text, &of_map(150.0));
    let tensions = &found.rest.balance.lines;
    assert_eq!(tensions.len(), 4);
    let weight = (140.0 - 1025.0 * 0.25 * std::f64::consts::PI * 0.15 * 0.15) * 9.80665;
    let exact = 1.2e9 * (120.0 - 119.7) / 119.7 + 0.5 * weight * 119.7;
    for line in tensions {
        near(line.tensions()[1], exact, 1e-10);
        near(line.tensions()[1], 3_079_061.7, 2e-6);
    }
    let case = case_of(&text, &of_map(150.0));
    assert!(case.contains("Cdt of tendon (not given)"), "{case}");
    let more = with(&text, "1.2E9     1.0", "1.2E9     1.0  -999.9 0.8");
    let case = case_of(&more, &of_map(150.0));
    assert!(case.contains("added_mass_normal = 0.8"), "{case}");
    let fewer = with(&text, "1.2E9     1.0", "1.2E9");
    let fault = refused(&fewer, &of_map(150.0));
    assert_eq!((fault.line, fault.key.as_str()), (4, "LINE TYPES"));
}

/// 1,264,294.87 N (MAP++ 1.30); nothing of the line lies on the bed, and the flag does nothing.
#[test]
fn a_line_of_map_may_have_no_contact_with_the_bed() {
    let text = text_of("omit_contact.map");
    near(tension(&text, &of_map(180.0), "b"), 1_264_294.87, 1e-8);
    let borne = text.replace("omit_contact", "");
    near(tension(&borne, &of_map(180.0), "b"), 1_264_294.87, 1e-8);
    // A longer line lies on the bed, or hangs through it, as where the bed is far below.
    let through = text.replace("326.5", "345.0");
    let borne = borne.replace("326.5", "345.0");
    let [a, b, deep] = [
        tension(&through, &of_map(180.0), "b"),
        tension(&borne, &of_map(180.0), "b"),
        tension(&borne, &of_map(1000.0), "b"),
    ];
    near(a, deep, 1e-12);
    assert!((a / b - 1.0).abs() > 1e-3, "{a} {b}");
    // The same of a line divided into segments, in a current.
    let current = "\n[current]\nspeed_m_per_s = 0.5\n";
    let divided = |text: &str, depth: f64| {
        let case = case_of(text, &of_map(depth)) + current;
        let found = kind::parse::<SystemFile>(&case, "case.toml").unwrap();
        value(&found, "tension_n[line1|b]").unwrap()
    };
    near(divided(&through, 180.0), divided(&borne, 1000.0), 1e-9);
}

#[test]
fn friction_below_zero_is_none_where_nothing_lies_on_the_bed() {
    let text = text_of("omit_contact.map").replace("omit_contact", "");
    let negative = with(&text, "350000000  1.0", "350000000  -1.0");
    near(tension(&negative, &of_map(180.0), "b"), 1_264_294.87, 1e-8);
    let fault = refused(&negative.replace("326.5", "345.0"), &of_map(180.0));
    assert_eq!((fault.line, fault.key.as_str()), (4, "LINE TYPES, CB"));
    assert!(fault.problem.contains("lies on the bed"), "{fault}");
}

/// T = sqrt((5000 g)^2 + 20000^2) = 52,970.77 N, the point at (18.928, 0, -56.422); g 9.81.
#[test]
fn external_loads_act_on_points() {
    let text = text_of("external_loads.txt");
    let found = solved(&text, &plain());
    near(
        value(&found, "tension_n[line1|b]").unwrap(),
        52_970.77,
        1e-7,
    );
    let mut points = found
        .network
        .points
        .iter()
        .zip(&found.rest.placement.points);
    let (_, place) = points.find(|(point, _)| point.name == "p2").unwrap();
    assert!(
        (place - V3::new(18.928, 0.0, -56.422)).norm() < 1e-3,
        "{place}"
    );
    // Loads of a point add up, in the two orders of columns.
    let half = "1 P2 10000|0|0 0 0 -\n2 Point2 - 10000|0|0 0|0|0 0|0|0";
    let two = with(&text, "1 Point2 20000|0|0 0|0|0 0|0|0 G", half);
    near(tension(&two, &plain(), "b"), 52_970.77, 1e-7);
    let damped = with(&text, "20000|0|0 0|0|0", "20000|0|0 100");
    let fault = refused(&damped, &plain());
    assert_eq!((fault.line, fault.column), (18, 20));
    assert!(fault.problem.contains("damping of a point"), "{fault}");
    for (of, by, said) in [
        (
            "Point2 20000|0|0",
            "Point7 20000|0|0",
            "there is no point `7`",
        ),
        (
            "Point2 20000|0|0",
            "Line1 20000|0|0",
            "is no point, rod or body",
        ),
        ("20000|0|0 ", "20000 ", "is not read so"),
        ("0|0|0 0|0|0", "0|0|0 0|-1|0", "negative"),
    ] {
        let fault = refused(&with(&text, of, by), &plain());
        assert!(
            fault.problem.contains(said) && fault.line == 18,
            "{by}: {fault}"
        );
    }
    let held = with(&text, "1 Point2 20000", "1 Point1 20000");
    let said = "Mass, volume, drag, added mass and loads act on nothing at the points 1";
    assert!(case_of(&held, &plain()).contains(said));
}

#[test]
fn external_loads_act_on_bodies() {
    let text = text_of("external_loads.txt");
    let body = "--- BODIES ---\nID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*\n\
        (#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)\n1 Free 0 0 -60 0 0 0 5000 0 1e4 0 0|2 0\n--- POINTS";
    let on_body = with(&text, "---------------------- POINTS", body);
    let on_body = with(
        &on_body,
        "2 Free 0 0 -60 5000 0 0 0",
        "2 Body1 0 0 0 0 0 0 0",
    );
    let loaded = |row: &str| with(&on_body, "1 Point2 20000|0|0 0|0|0 0|0|0 G", row);
    let earth = loaded("1 Body1 20000|0|0 50 7|8|9 G");
    near(tension(&earth, &plain(), "b"), 52_970.77, 1e-6);
    let case = case_of(&earth, &plain());
    for key in [
        "load_n = [20000.0, 0.0, 0.0]",
        "damping = [50.0, 50.0, 50.0, 0.0, 0.0, 0.0]",
        "quadratic_damping = [7.0, 8.0, 9.0, 1025.0, 1025.0, 1025.0]",
    ] {
        assert!(case.contains(key), "{key}\n{case}");
    }
    let fault = refused(&loaded("1 Body1 20000|0|0 0 0 L"), &plain());
    assert!(fault.problem.contains("turns with its body"), "{fault}");
    let damped = loaded("1 Body1 0 1|2|3 0 L");
    assert!(case_of(&damped, &plain()).contains("damping = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]"));
    let fault = refused(&loaded("1 Body1 0 0 0 -"), &plain());
    assert!(fault.problem.contains("along which axes"), "{fault}");
}

/// A free rod without length is a point: 20,000 N pull at a wire that weighs nothing in the water. What the force on another rod does is said.
#[test]
fn external_loads_on_rods_act_on_nothing_or_are_named() {
    const RODS: &str = "--- ROD TYPES ---\nName Diam Mass/m Cd Ca CdEnd CaEnd\n(-) (m) (kg/m) (-) (-) (-) (-)\nr 0.2 60 1 1 0 0\n\
        --- RODS ---\nID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs\n(#) (-) (-) (m) (m) (m) (m) (m) (m) (-) (-)\n\
        1 r Free 0 0 -60 0 0 -60 0 -\n--- POINTS";
    let text = text_of("external_loads.txt");
    let text = with(&text, "---------------------- POINTS", RODS);
    let text = with(&text, "2 Free 0 0 -60 5000 0 0 0\n", "");
    let text = with(&text, "1 wire 1 2 50", "1 wire 1 R1A 50");
    let joint = with(
        &text,
        "1 Point2 20000|0|0 0|0|0 0|0|0 G",
        "1 Rod1 20000|0|0 0|0 0|0 -",
    );
    near(tension(&joint, &plain(), "b"), 20_000.0, 1e-6);
    let damped = with(&joint, "0|0 0|0 -", "5 0|0 -");
    let fault = refused(&damped, &plain());
    assert!(
        fault
            .problem
            .contains("damping over ground of a rod without length"),
        "{fault}"
    );
    let long = with(&joint, "0 0 -60 0 0 -60 0 -", "0 0 -60 0 0 -70 5 -");
    let fault = refused(&long, &plain());
    assert!(
        fault
            .problem
            .contains("a steady force on end A of a rod that is not held"),
        "{fault}"
    );
    let said = "EXTERNAL LOADS act on nothing at end A of the rods 1: it is held.";
    for hold in ["Fixed", "Pinned"] {
        let held = with(&long, "r Free", &format!("r {hold}"));
        assert!(case_of(&held, &plain()).contains(said), "{hold}");
    }
    let pinned = with(&with(&long, "r Free", "r Pinned"), "0|0 0|0 -", "3|4 0|0 -");
    let fault = refused(&pinned, &plain());
    assert!(
        fault
            .problem
            .contains("damping of a rod, across it or along it"),
        "{fault}"
    );
}

/// As `1 Currents` with the same profile: 186,113.8 N at B, 78,577.9 at A.
#[test]
fn a_current_in_a_file_of_water_kinematics_acts() {
    let text = text_of("waterkin_current.txt");
    // The figures are of a line that is under water to its end at the surface; MoorDyn's has half of its last place out of it, 15 N.
    near(tension(&text, &plain(), "b"), 186_113.8, 1e-4);
    near(tension(&text, &plain(), "a"), 78_577.9, 1e-4);
    let case = case_of(&text, &plain());
    assert!(
        case.contains("WaterKin.dat") && case.contains("[current]"),
        "{case}"
    );
    let still = solved(&text, &without("currents"));
    assert!(value(&still, "tension_n[line1|b]").unwrap() < 120_000.0);
    // A file that is not there was left out with the waves.
    let absent = with(&text, "\"WaterKin.dat\"", "Kinematics.dat");
    let fault = refused(&absent, &plain());
    assert!(fault.problem.contains("not beside this one"), "{fault}");
    assert!(read(&absent, &without("waves")).is_ok());
    let fault = refused(&with(&text, "\"WaterKin.dat\"", "SEASTATE"), &plain());
    assert!(fault.problem.contains("SEASTATE"), "{fault}");
}

/// `EAD_LM` is MoorPy 1.3.0's name (helpers.py 717) of the slope of the stiffness in motion by the mean load.
#[test]
fn a_library_of_moorpy_1_3_is_read() {
    let text = text_of("library_eadlm.yaml");
    let found = library::read(&text, "library.yaml").unwrap();
    assert_eq!(found.types.len(), 2);
    assert_eq!(found.types[1].dynamic, [11.6, 40.0]);
    let before = library::read(&text.replace("EAD_LM", "EAd_MBL_Lm"), "library.yaml").unwrap();
    assert_eq!(before.types, found.types);
    // One type with a fault is named, and the others are read.
    let odd = text.replace("EAD_LM", "EAD_LN");
    let found = library::read(&odd, "library.yaml").unwrap();
    let names: Vec<&str> = found.types.iter().map(|of| of.name.as_str()).collect();
    assert_eq!(names, ["chain_b"]);
    let unread = found.find_unread("Poly_b").unwrap();
    assert_eq!((unread.faults.len(), unread.faults[0].line), (1, 13));
    let twice = text.replace(
        "EAD_LM    :  40.0",
        "EAD_LM    :  40.0\n    EAd_MBL_Lm: 40.0",
    );
    let found = library::read(&twice, "library.yaml").unwrap();
    let fault = &found.not_read[0].faults[0];
    assert!(fault.problem.contains("two names"), "{fault}");
}

/// FairTen1 69,823.98 N, FairTen2 and FairTen3 79,437.5 N, AnchTen1 66,984.5 N, the first point at (1.5858, 0, -21.975) (CableDyn 0.3.0).
#[test]
fn a_deck_of_cable_dyn_with_a_body() {
    let found = solved(&text_of("rigid6_buoy.dat"), &plain());
    let tension = |id: &str| value(&found, &format!("tension_n[{id}]")).unwrap();
    near(tension("line1|a"), 69_823.98, 2e-4);
    near(tension("line2|a"), 79_437.5, 2e-4);
    near(tension("line3|a"), 79_437.5, 2e-4);
    near(tension("line1|b"), 66_984.5, 2e-4);
    let case = case_of(&text_of("rigid6_buoy.dat"), &plain());
    for said in [
        "a file of CableDyn",
        "TMax",
        "speed_m_per_s = 0.6",
        "drag_tangential = 0.2",
    ] {
        assert!(case.contains(said), "{said}\n{case}");
    }
}

/// FairTen1 9,320.17 N, AnchTen1 1,326.90 N (CableDyn 0.3.0): a line of three sections.
#[test]
fn a_deck_of_cable_dyn_with_sections() {
    let text = text_of("lazy_modes.dat");
    let found = solved(&text, &plain());
    assert_eq!(found.network.lines.len(), 1);
    near(value(&found, "tension_n[line1|a]").unwrap(), 9_320.17, 5e-4);
    near(value(&found, "tension_n[line1|b]").unwrap(), 1_326.90, 2e-3);
    let fault = refused(
        &with(&text, "1 bare 68.114 448", "2 bare 68.114 448"),
        &plain(),
    );
    assert!(fault.problem.contains("there is no line `2`"), "{fault}");
    let rows = "1 bare 68.114 448\n1 buoy 50.0 320\n1 bare 52.101 256\n";
    let fault = refused(&with(&text, rows, ""), &plain());
    assert!(fault.problem.contains("has no sections"), "{fault}");
}

#[test]
fn what_is_passed_over_is_said_once() {
    let options = "0.001 dtM\n60 TmaxIC\n0.1 dtOut\n200 FricDamp\n3 odd\n";
    let text = with(&text_of("coupled1.txt"), "0.001 dtM\n", options);
    let case = case_of(&text, &plain());
    for said in [
        "Passed over, as of a solver or of outputs: dtM, TmaxIC, dtOut.",
        "Passed over, though MoorDyn has other forces by it: FricDamp.",
        "Options that are not known have no effect: odd.",
    ] {
        assert_eq!(case.matches(said).count(), 1, "{said}\n{case}");
    }
    let map = case_of(&text_of("omit_contact.map"), &of_map(180.0));
    assert!(map.contains("outputs: outer_tol."), "{map}");
}

/// A file of many rows is refused by its number of rows before any of them is read: in a tenth of a second where nothing else computes, where
/// work by the square took a minute.
#[test]
fn many_rows_are_counted_first() {
    let count = 20_000;
    let mut moordyn = "--- LINE TYPES ---\nName Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx\n(-) (m) (kg/m) (N) (-) (-) (-) (-) (-) (-)\n\
        c 0.1 180 8e8 -0.8 0 1.2 1 0.1 0\n--- POINTS ---\nID Type X Y Z M V CdA CA\n(#) (-) (m) (m) (m) (kg) (m3) (m2) (-)\n"
        .to_owned();
    for k in 1..=count {
        moordyn += &format!("{k} Fixed {k} 0 -50 0 0 0 0\n");
    }
    moordyn += "--- LINES ---\nID LineType AttachA AttachB UnstrLen NumSegs Outputs\n(#) (-) (-) (-) (m) (-) (-)\n";
    for k in 1..count {
        moordyn += &format!("{k} c {k} {} 200 20 -\n", k + 1);
    }
    let mut design = "mooring:\n  water_depth: 50\n  points:\n".to_owned();
    for k in 0..count {
        design += &format!("    - {{name: a{k}, type: fixed, location: [{k}, 0, -50]}}\n");
    }
    design += "  lines: []\n  line_types: []\n";
    for (text, name) in [(moordyn, "many.dat"), (design, "many.yaml")] {
        let start = Instant::now();
        let all = import::read(&text, name, &plain()).unwrap_err();
        assert!(
            start.elapsed() < Duration::from_secs(5),
            "{:?}",
            start.elapsed()
        );
        assert!(all[0].remedy.contains("--limit-tables"), "{}", all[0]);
    }
}
