//! Files of other programs: the OC3 spar in three dialects, ropes, rods and motions, and what is wrong with a file, line by line.

use std::fs;
use std::path::Path;

use seacable::case::{Diagnostic, kind};
use seacable::import::{self, ImportOptions, Imported};
use seacable::system::quantities::value;
use seacable::system::{SolvedSystem, SystemFile};

/// The spar of OC3 (Jonkman 2010, NREL/TP-500-47535, section 5) in the form of MoorDyn 2.
const OC3: &str = "\
--------------------- MoorDyn Input File ------------------------------------
The spar of OC3
----------------------- LINE TYPES ------------------------------------------
TypeName   Diam    Mass/m     EA         BA/-zeta    EI         Cd     Ca     CdAx    CaAx
(name)     (m)     (kg/m)     (N)        (N-s/-)     (N-m^2)    (-)    (-)    (-)     (-)
main       0.09    77.7066    384.243E6  -0.8        0          1.6    1.0    0.1     0.0
---------------------- POINTS -----------------------------------------------
ID    Type      X       Y       Z       Mass   Volume  CdA    Ca
(#)   (-)       (m)     (m)     (m)     (kg)   (m^3)   (m^2)  (-)
1     Fixed     853.87  0       -320.0  0      0       0      0
2     Fixed     -426.935 739.47311 -320.0 0    0       0      0
3     Fixed     -426.935 -739.47311 -320.0 0   0       0      0
4     Vessel    5.2     0.0     -70.0   0      0       0      0
5     Vessel    -2.6    4.50333 -70.0   0      0       0      0
6     Vessel    -2.6   -4.50333 -70.0   0      0       0      0
---------------------- LINES ------------------------------------------------
ID   LineType   AttachA  AttachB  UnstrLen  NumSegs  LineOutputs
(#)   (name)     (#)      (#)       (m)       (-)     (-)
1     main       1        4         902.2     20      -
2     main       2        5         902.2     20      -
3     main       3        6         902.2     20      -
---------------------- OPTIONS ----------------------------------------------
0.002         dtM           time step
1025.0        WtrDnsty      water density (kg/m^3)
320           WtrDpth       water depth (m)
0.001         FrictionCoefficient
------------------------- need this line ------------------------------------
";

/// The same in the form of MoorDyn 1: other columns, other orders, options by name before value.
const OC3_1: &str = "\
MoorDyn input of the OC3 spar
---------------------- LINE DICTIONARY --------------------------------------
LineType  Diam    MassDenInAir  EA        BA/-zeta   Can  Cat  Cdn  Cdt
(-)       (m)     (kg/m)        (N)       (Pa-s/-)   (-)  (-)  (-)  (-)
main      0.09    77.7066       3.84243D8 -0.8       1.0  0.0  1.6  0.1
---------------------- NODE PROPERTIES --------------------------------------
Node  Type     X        Y    Z      M  V  FX FY FZ CdA Ca
(-)   (-)      (m)      (m)  (m)    (kg) (m^3) (kN) (kN) (kN) (m2) (-)
1     Fixed    853.87   0    -320.0 0  0  0  0  0  0   0
4     Vessel   5.2      0    -70.0  0  0  0  0  0  0   0
---------------------- LINE PROPERTIES --------------------------------------
Line  LineType  UnstrLen  NumSegs  NodeAnch  NodeFair  Flags/Outputs
(-)   (-)       (m)       (-)      (-)       (-)       (-)
1     main      902.2     20       1         4         p
---------------------- SOLVER OPTIONS ---------------------------------------
WtrDnsty 1025
WtrDpth  320
FrictionCoefficient 0.001
---------------------- need this line ---------------------------------------
";

/// The same in the form of MAP++.
const OC3_MAP: &str = "\
---------------------- LINE DICTIONARY --------------------------------------
LineType  Diam   MassDenInAir  EA        CB     CIntDamp  Ca   Cdn  Cdt
(-)       (m)    (kg/m)        (N)       (-)    (Pa-s)    (-)  (-)  (-)
main      0.09   77.7066       384.243E6 0.001  0         0    0    0
---------------------- NODE PROPERTIES --------------------------------------
Node Type    X       Y   Z      M  B  FX FY FZ
(-)  (-)     (m)     (m) (m)    (kg) (m3) (N) (N) (N)
1    fix     853.87  0   depth  0  0  #  #  #
2    Vessel  5.2     0   -70.0  0  0  #  #  #
---------------------- LINE PROPERTIES --------------------------------------
Line LineType UnstrLen NodeAnch NodeFair Flags
(-)  (-)      (m)      (-)      (-)      (-)
1    main     902.2    1        2        plot gx_pos
---------------------- SOLVER OPTIONS ---------------------------------------
Option
(-)
outer_tol 1e-5
repeat 120 240
";

/// Tension at the fairlead by MAP++ 1.20.10 \[N\].
const FAIRLEAD: f64 = 911_089.457;

fn read(text: &str) -> Result<Imported, Vec<Diagnostic>> {
    import::read(text, "case.dat", &ImportOptions::default())
}

fn imported(text: &str, options: &ImportOptions) -> Imported {
    import::read(text, "case.dat", options).unwrap_or_else(|all| panic!("{all:#?}"))
}

fn solved(text: &str) -> SolvedSystem {
    kind::parse::<SystemFile>(text, "case.toml").unwrap_or_else(|all| panic!("{text}\n{all:#?}"))
}

#[track_caller]
fn assert_fairlead(text: &str, line: &str) {
    let tension = value(&solved(text), &format!("tension_n[{line}|b]")).unwrap();
    let off = (tension / FAIRLEAD - 1.0).abs();
    assert!(off < 1e-6, "{tension} N, {off:e} off");
}

#[test]
fn three_dialects_have_the_tension_of_map() {
    for line in ["line1", "line2", "line3"] {
        assert_fairlead(&read(OC3).unwrap().text, line);
    }
    assert_fairlead(&read(OC3_1).unwrap().text, "line1");
    let options = ImportOptions {
        depth: Some(320.0),
        density: Some(1025.0),
        gravity: Some(9.80665),
        ..ImportOptions::default()
    };
    let map = imported(OC3_MAP, &options).text;
    for line in ["line1", "line1@120", "line1@240"] {
        assert_fairlead(&map, line);
    }
    // The platform is one body, whose stiffness is that of Jonkman's table 5-1.
    let system = solved(&read(OC3).unwrap().text);
    assert_eq!(system.network.bodies.len(), 1);
}

/// MAP++ turns what it repeats clockwise.
#[test]
fn repeats_of_map_are_turned_clockwise() {
    let options = ImportOptions {
        depth: Some(320.0),
        density: Some(1025.0),
        gravity: Some(9.80665),
        ..ImportOptions::default()
    };
    let text = OC3_MAP.replace("repeat 120 240", "repeat 60");
    let system = solved(&imported(&text, &options).text);
    let sixth = 60f64.to_radians();
    let turned = system.rest.placement.points.iter().any(|place| {
        (place.x - 853.87 * sixth.cos()).abs() < 1e-6
            && (place.y + 853.87 * sixth.sin()).abs() < 1e-6
    });
    assert!(turned, "{:?}", system.rest.placement.points);
}

#[test]
fn what_map_is_told_from_outside_is_asked_for() {
    let all = read(OC3_MAP).unwrap_err();
    assert_eq!(all.len(), 3);
    for (fault, option) in all.iter().zip(["--gravity", "--density", "--depth"]) {
        assert!(fault.remedy.contains(option), "{fault:?}");
    }
}

/// Faults: what is replaced, by what, the line it is reported on, a word of the problem.
const FAULTS: [(&str, &str, u32, &str); 18] = [
    (
        "902.2     20      -\n2",
        "902.2     0      -\n2",
        19,
        "no segments",
    ),
    (
        "902.2     20      -\n2",
        "902.2     2x      -\n2",
        19,
        "not a whole number",
    ),
    (
        "902.2     20      -\n2",
        "902.2\n2",
        19,
        "5 columns where 6",
    ),
    (
        "1        4         902.2",
        "1        9         902.2",
        19,
        "no point `9`",
    ),
    (
        "1        4         902.2",
        "R1A        4         902.2",
        19,
        "no rod `1`",
    ),
    (
        "1        4         902.2",
        "4        4         902.2",
        19,
        "same point",
    ),
    (
        "main       2        5",
        "man       2        5",
        20,
        "no line type `man`",
    ),
    (
        "3     main       3",
        "2     main       3",
        21,
        "second line `2`",
    ),
    (
        "902.2     20      -\n3",
        "-902.2     20      -\n3",
        20,
        "not above 0",
    ),
    ("384.243E6", "384.243E6x", 6, "not a number"),
    ("384.243E6", "1e8|2e8|3|4", 6, "more than three"),
    ("0.1     0.0\n", "0.1\n", 6, "9 columns where 10"),
    ("1025.0  ", "salt    ", 24, "not a number"),
    ("5     Vessel", "5     Vesel", 14, "what holds it"),
    ("5     Vessel", "5     Body2", 14, "no body `2`"),
    ("LINES ---", "LINNES ---", 16, "not a section"),
    (
        "AttachB  UnstrLen  NumSegs",
        "UnstrLen  AttachB  NumSegs",
        17,
        "the header names UnstrLen where AttachB is read",
    ),
    (
        "ID   LineType   AttachA  AttachB  UnstrLen  NumSegs  LineOutputs\n",
        "",
        17,
        "names of its columns",
    ),
];

#[test]
fn every_fault_is_on_its_line() {
    for (of, by, line, problem) in FAULTS {
        assert!(OC3.contains(of), "{of}");
        let text = OC3.replacen(of, by, 1);
        let all = read(&text).expect_err(by);
        let found = all.iter().find(|fault| fault.problem.contains(problem));
        let Some(found) = found else {
            panic!("{by}: {all:#?}");
        };
        assert_eq!(found.line, line, "{by}: {found:#?}");
        assert!(!found.remedy.is_empty(), "{by}");
    }
}

#[test]
fn what_the_case_finds_is_shown_at_the_row_of_the_file() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("deep.dat");
    // The anchor lies below the bed.
    let text = OC3.replace(
        "1     Fixed     853.87  0       -320.0",
        "1     Fixed     853.87  0       -350.0",
    );
    fs::write(&path, &text).unwrap();
    let all = seacable::open::load::<SystemFile>(&path).unwrap_err();
    assert_eq!(all[0].line, 10, "{all:#?}");
}

#[test]
fn a_file_and_its_case_are_the_same_system() {
    let dir = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| {
        let path = dir.path().join(name);
        fs::write(&path, text).unwrap();
        path
    };
    let file = seacable::open::load::<SystemFile>(&put("oc3.dat", OC3)).unwrap();
    let case = seacable::open::load::<SystemFile>(&put("oc3.toml", &file.text)).unwrap();
    assert_eq!(file.text, case.text);
    assert_eq!(file.computed.file, case.computed.file);
    let key = "tension_n[line2|a]";
    let [one, other] = [&file, &case].map(|of| value(&of.computed, key).unwrap().to_bits());
    assert_eq!(one, other);
    assert_eq!(
        import::case_path(&dir.path().join("oc3.dat")),
        dir.path().join("oc3.toml")
    );
}

#[test]
fn vibrations_are_refused_at_their_column_or_left_out() {
    let text = OC3
        .replace("CdAx    CaAx", "CdAx    CaAx  Cl")
        .replace("0.1     0.0\n", "0.1     0.0  0.7\n");
    let all = read(&text).unwrap_err();
    assert_eq!((all.len(), all[0].line), (1, 6), "{all:#?}");
    assert!(all[0].remedy.contains("--without viv"));
    let options = ImportOptions {
        without: vec!["viv".to_owned()],
        ..ImportOptions::default()
    };
    let case = imported(&text, &options).text;
    assert!(case.contains("LEFT OUT"), "{case}");
    assert_fairlead(&case, "line1");
}

/// A polyester rope between two points, of so many stiffnesses.
fn rope(stiffness: &str, damping: &str) -> String {
    format!(
        "--- LINE TYPES ---\nName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx\n(-)\n\
         rope 0.2 40 {stiffness} {damping} 0 0 0 0 0\n\
         --- POINTS ---\nID Type X Y Z M V CdA Ca\n(-)\n1 Fixed 0 0 -5 0 0 0 0\n2 Coupled 101 0 -5 0 0 0 0\n\
         --- LINES ---\nID LineType NodeA NodeB UnstrLen NumSegs Outputs\n(-)\n1 rope 1 2 100 4 -\n\
         --- SYROPE IC ---\nLines Tmax0 Tmean0\n(-)\n1 1.2e6 4e5\n--- OPTIONS ---\n0 g\n200 WtrDpth\n"
    )
}

#[test]
fn ropes_that_creep_are_read() {
    let case = read(&rope("1.4e8|1.6e8|0.4", "4e9|11e6")).unwrap().text;
    for key in [
        "creep_model = \"viscoelastic\"",
        "dynamic_ea_n = 160000000.0",
        "dynamic_ea_per_tension = 0.4",
        "slow_damping_n_s = 4000000000.0",
        "fast_damping_n_s = 11000000.0",
    ] {
        assert!(case.contains(key), "{key}\n{case}");
    }
    // One per cent of strain at the slow stiffness.
    let tension = value(&solved(&case), "tension_n[line1|b]").unwrap();
    assert!((tension / 1.4e6 - 1.0).abs() < 1e-6, "{tension}");
}

#[test]
fn syrope_ropes_take_their_curves_from_files() {
    let dir = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| fs::write(dir.path().join(name), text).unwrap();
    put(
        "owc.dat",
        "strain tension\n(-) (N)\n0 0\n0.01 8e5\n0.02 1.8e6\n0.05 6e6\n",
    );
    put(
        "rope.dat",
        "owc.dat OWC\nLINEAR WCType\n1.25e8 k1\n0.0 k2\n",
    );
    let path = dir.path().join("line.txt");
    fs::write(&path, rope("SYROPE:rope.dat|1.53e8|23.12", "5e10|1e5")).unwrap();
    let loaded = seacable::open::load::<SystemFile>(&path).unwrap_or_else(|all| panic!("{all:#?}"));
    for key in [
        "strain = [0.0, 0.01, 0.02, 0.05]",
        "working_curve_ea_n = 125000000.0",
        "past_tension_n = 1200000.0",
        "initial_mean_tension_n = 400000.0",
    ] {
        assert!(loaded.text.contains(key), "{key}\n{}", loaded.text);
    }
    put("rope.dat", "owc.dat OWC\nCUBIC WCType\n1.25e8 k1\n0.0 k2\n");
    let all = seacable::open::load::<SystemFile>(&path).unwrap_err();
    assert_eq!(all[0].line, 4, "{all:#?}");
}

#[test]
fn coupled_points_move_by_a_table() {
    let dir = tempfile::tempdir().unwrap();
    let table = dir.path().join("motion.csv");
    let mut text = String::from("time_s,surge,sway,heave,roll_deg,pitch_deg,yaw_deg\n");
    for k in 0..=40 {
        let t = f64::from(k) * 0.25;
        let heave = 0.5 * (0.1 * t).min(1.0) * (0.6 * t).sin();
        text.push_str(&format!("{t},0,0,{heave},0,{},0\n", 0.2 * heave));
    }
    fs::write(&table, text).unwrap();
    let options = ImportOptions {
        motion: Some(table),
        ..ImportOptions::default()
    };
    let case = imported(OC3, &options).text;
    assert!(case.contains("duration_s = 10.0"), "{case}");
    assert!(case.contains("table_pitch_deg"), "{case}");
    let system = solved(&case);
    assert!(system.file.solver.is_some());
    assert_fairlead(&case, "line1");
    let wrong = ImportOptions {
        motion: Some(Path::new("nowhere.csv").to_owned()),
        ..ImportOptions::default()
    };
    assert!(import::read(OC3, "case.dat", &wrong).is_err());
}

/// A line of two stiffnesses that bends, joined by a rod without length, clamped at a held rod.
const BENDS: &str = "\
--- LINE TYPES ---
Name Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(-)
cable 0.1 25 4e8 -1 4e4 1.1 1 0.01 0
float 0.3 59 4e8 -1 3e4 1.1 1 0.01 0
--- ROD TYPES ---
Name Diam Mass/m Cd Ca CdEnd CaEnd
(-)
joint 0.1 0 0 0 0 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs
(-)
1 joint Fixed -100 0 -80 -99 0 -80 0 -
2 joint Free -60 0 -60 -60 0 -60 0 -
3 joint Free -30 0 -50 -30 0 -50 0 -
--- POINTS ---
ID Type X Y Z M V CdA Ca
(-)
1 Fixed 0 0 -10 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(-)
1 cable R1B R2A 50 20 -
2 float R3A R2B 40 20 -
3 cable R3B 1 60 20 -
--- OPTIONS ---
90 WtrDpth
";

#[test]
fn lines_that_bend_run_through_joints_without_length() {
    let case = read(BENDS).unwrap().text;
    assert_eq!(case.matches("[[lines]]").count(), 1, "{case}");
    assert_eq!(case.matches("[[lines.sections]]").count(), 3);
    assert!(case.contains("clamp_a_elevation_deg = 0.0"), "{case}");
    let system = solved(&case);
    let pieces: Vec<(&str, f64)> = system.file.lines[0]
        .sections
        .iter()
        .map(|section| (section.material.as_str(), section.length_m))
        .collect();
    assert_eq!(pieces, [("cable", 50.0), ("float", 40.0), ("cable", 60.0)]);
    // The end that hangs from above carries half of the last section at least.
    let cable = (25.0 - 1025.0 * std::f64::consts::PI * 0.05_f64.powi(2)) * 9.80665;
    let tension = value(&system, "tension_n[line1|b]").unwrap();
    assert!(tension > 30.0 * cable, "{tension} N");
}

#[test]
fn lines_come_off_where_the_file_says_so() {
    let options = "---------------------- OPTIONS ";
    let failure = "--- FAILURE ---\nFailID Point Line(s) FailTime FailTen\n(-)\n1 Point4 1 5.0 0\n";
    let text = OC3.replacen(options, &format!("{failure}{options}"), 1);
    let case = read(&text).unwrap().text;
    assert!(case.contains("release_b_s = 5.0"), "{case}");
    let dangling = text.replace("1 Point4 1 5.0 0", "1 Point4 7 5.0 0");
    let all = read(&dangling).unwrap_err();
    assert!(all[0].problem.contains("no line `7`"), "{all:#?}");
    let unknown = ImportOptions {
        without: vec!["vivv".to_owned()],
        ..ImportOptions::default()
    };
    let all = import::read(OC3, "case.dat", &unknown).unwrap_err();
    assert!(all[0].remedy.contains("viv"), "{all:#?}");
}

/// A grid of depths in the form of MoorDyn: a plane that rises by this slope towards +x, 320 m deep at the anchor of the first line.
fn seafloor(slope: f64) -> String {
    let mut text = "3 2\n-1000 0 1000\n-1000 1000\n".to_owned();
    for x in [-1000.0, 0.0, 1000.0] {
        for y in [-1000.0, 1000.0] {
            text += &format!("{x} {y} {}\n", -320.0 + slope * (x - 853.87));
        }
    }
    text
}

#[test]
fn a_sea_floor_over_a_grid_is_that_of_the_case() {
    let folder = std::env::temp_dir().join(format!("seacable-seafloor-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let level = OC3.replace("0.001         FrictionCoefficient\n", "");
    let over_grid = level.replace(
        "320           WtrDpth",
        "depths.txt    SeafloorFile\n320 WtrDpth",
    );
    let path = folder.join("oc3.dat");
    let read = |text: &str, slope: f64| {
        fs::write(folder.join("depths.txt"), seafloor(slope)).unwrap();
        fs::write(&path, text).unwrap();
        seacable::open::load_as::<SystemFile>(&path, &ImportOptions::default())
    };
    let tension = |text: &str, slope: f64| {
        let solved = read(text, slope).unwrap().computed;
        value(&solved, "tension_n[line1|b]").unwrap()
    };
    let flat = tension(&level, 0.0);
    assert_eq!(tension(&over_grid, 0.0).to_bits(), flat.to_bits());
    let steep = read(&over_grid, 0.02);
    assert!(steep.is_ok() || !steep.unwrap_err().is_empty());
    fs::remove_file(folder.join("depths.txt")).unwrap();
    fs::write(&path, &over_grid).unwrap();
    let found =
        seacable::open::load_as::<SystemFile>(&path, &ImportOptions::default()).unwrap_err();
    let row = over_grid
        .lines()
        .position(|row| row.contains("SeafloorFile"));
    assert_eq!(found[0].line as usize, row.unwrap() + 1, "{found:?}");
    fs::remove_dir_all(&folder).unwrap();
}

fn map_options() -> ImportOptions {
    ImportOptions {
        depth: Some(320.0),
        density: Some(1025.0),
        gravity: Some(9.80665),
        ..ImportOptions::default()
    }
}

fn map(text: &str) -> Result<Imported, Vec<Diagnostic>> {
    import::read(text, "case.map", &map_options())
}

fn map_note(text: &str, note: &str) -> String {
    let text = map(text).unwrap_or_else(|all| panic!("{all:#?}")).text;
    assert!(text.contains(note), "{text}");
    text
}

#[test]
fn an_option_of_map_behind_a_blank_is_a_comment() {
    let text = OC3_MAP.replace("repeat 120 240", " repeat 120 240");
    let text = map_note(&text, "a comment in MAP++: nothing is repeated");
    assert!(!text.contains("repeat_at_deg"), "{text}");
    let text = OC3_MAP.replace("\n1    main ", "\n  1    main ");
    assert!(map_note(&text, "repeat_at_deg").contains("[[lines]]"));
}

#[test]
fn options_and_flags_that_map_does_not_know_are_named() {
    let text = OC3_MAP.replace("repeat 120 240", "repeet 120");
    map_note(
        &text,
        "`repeet` is not known and has no effect; did you mean `repeat`?",
    );
    let text = OC3_MAP.replace("gx_pos", "gx_poss");
    map_note(
        &text,
        "Line 1: the flag `gx_poss` is not known and has no effect; did you mean `gx_pos`?",
    );
    let text = OC3_MAP.replace("gx_pos", "GX_POS seg_size 10 damage_time 5 h_fair");
    let text = map_note(
        &text,
        "Line 1: the flag damage_time has no effect, as in MAP++: the line is not cut.",
    );
    assert!(!text.contains("not known"), "{text}");
}

#[test]
fn coefficients_that_map_does_not_use_are_0() {
    for mark in ["-999.9", "-1.0"] {
        let row = format!("0.001  {mark} {mark} {mark} {mark}\n");
        let text = OC3_MAP.replace("0.001  0         0    0    0\n", &row);
        let note = format!("CIntDamp of main ({mark}), Cdn of main ({mark})");
        let text = map_note(&text, &note);
        assert!(text.contains("drag_normal = 0"), "{text}");
    }
    let text = OC3_MAP.replace("0.001  0         0    0    0\n", "0.001  0 0 -2 0\n");
    let all = map(&text).unwrap_err();
    assert_eq!((all[0].line, all[0].key.as_str()), (4, "LINE TYPES, Cdn"));
}

#[test]
fn a_length_that_map_solves_for_is_refused_at_its_column() {
    let all = map(&OC3_MAP.replace(" 902.2 ", " #902.2 ")).unwrap_err();
    let [one] = all.as_slice() else {
        panic!("{all:#?}")
    };
    assert_eq!(
        (one.line, one.column, one.key.as_str()),
        (13, 15, "LINES, UnstrLen")
    );
    assert!(
        one.problem.contains("MAP++ solves for the length"),
        "{one:?}"
    );
}

#[test]
fn a_line_of_map_without_contact_hangs_through_the_bed() {
    let text = OC3_MAP.replace("plot gx_pos", "plot omit_contact");
    map_note(&text, "bed_contact = false");
    let joined = "1    main     500.0    1        3        plot\n2    main     402.2    3        2        omit_contact\n";
    let text = OC3_MAP
        .replace(
            "2    Vessel",
            "3    Connect #400 #0 #-200 0 0 0 0 0\n2    Vessel",
        )
        .replace(
            "1    main     902.2    1        2        plot gx_pos\n",
            joined,
        );
    let text = map_note(&text, "bed_contact = false");
    assert_eq!(text.matches("bed_contact").count(), 1, "{text}");
}
