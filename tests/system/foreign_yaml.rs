//! Designs in YAML: RAFT, the IEA ontology, libraries of line types; and what is wrong with one, row by row.

use std::fs;
use std::path::Path;

use seacable::case::{Diagnostic, kind};
use seacable::import::yaml::library;
use seacable::import::{self, ImportOptions, Imported};
use seacable::kinds::foreign;
use seacable::system::quantities::value;
use seacable::system::{SolvedSystem, SystemFile};

pub(crate) const RAFT: &str = include_str!("foreign/raft.yaml");
pub(crate) const ONTOLOGY: &str = include_str!("foreign/ontology.yaml");
pub(crate) const LIBRARY: &str = include_str!("foreign/library.yaml");
pub(crate) const FAMODEL: &str = include_str!("foreign/famodel.yaml");

/// Tension at the fairleads of VolturnUS-S \[N\] (Lozon 2025, by discretised lines).
const FAIRLEAD: f64 = 2.4371e6;

pub(crate) fn read(text: &str) -> Result<Imported, Vec<Diagnostic>> {
    import::read(text, "design.yaml", &ImportOptions::default())
}

pub(crate) fn case_of(text: &str) -> String {
    read(text).unwrap_or_else(|all| panic!("{all:#?}")).text
}

pub(crate) fn solved(text: &str) -> SolvedSystem {
    kind::parse::<SystemFile>(text, "case.toml").unwrap_or_else(|all| panic!("{text}\n{all:#?}"))
}

#[track_caller]
pub(crate) fn assert_fairlead(system: &SolvedSystem, line: &str, wanted: f64, share: f64) {
    let tension = value(system, &format!("tension_n[{line}|b]")).unwrap();
    let off = (tension / wanted - 1.0).abs();
    assert!(off < share, "{line}: {tension} N, {off:e} off");
}

#[test]
fn a_raft_design_and_an_ontology_have_the_tension_of_others() {
    for text in [RAFT, ONTOLOGY] {
        let system = solved(&case_of(text));
        assert_eq!(system.network.bodies.len(), 1);
        let lines = system.network.lines.len();
        assert_eq!(lines, 3);
        assert_fairlead(&system, "line1", FAIRLEAD, 0.005);
        assert_fairlead(&system, "line2", FAIRLEAD, 0.005);
    }
    let [raft, ontology] = [RAFT, ONTOLOGY].map(|text| solved(&case_of(text)));
    let tension = value(&raft, "tension_n[line1|b]").unwrap();
    assert_fairlead(&ontology, "line1", tension, 1e-9);
}

#[test]
fn what_a_design_leaves_open_is_put_down_with_whose_default_it_is() {
    let silent = RAFT.replace(
        "    rho_water   : 1025.0     # [kg/m^3]\n    g           : 9.81\n",
        "",
    );
    let case = case_of(&silent);
    assert!(case.contains("gravity_m_per_s2 = 9.81 "), "{case}");
    assert!(case.contains("assumed: MoorPy, which computes the lines of RAFT,"));
    let other = RAFT
        .replace("water_depth : 200 ", "water_depth : 320 ")
        .replace("rho_water   : 1025", "rho_water   : 1000");
    let case = case_of(&other);
    assert!(case.contains("The depth is 200 m in `mooring` and 320 m in `site`"));
    assert!(case.contains("Lines have the density of `site`, 1000 kg/m3"));
    assert!(case.contains("depth_m = 200.0"));
    // What RAFT ignores is ignored, and said.
    let extra = RAFT.replace("cost: 100.0", "zeta: 0.8");
    assert!(case_of(&extra).contains("mooring.line_types.zeta is read neither by RAFT nor here."));
    // Many are one remark.
    let mut more = "zeta: 0.8".to_owned();
    for k in 0..30 {
        more.push_str(&format!("\n          eta{k}: 1.0"));
    }
    let case = case_of(&RAFT.replace("cost: 100.0", &more));
    let said = "mooring.line_types.eta10 and 19 more are read neither by RAFT nor here.";
    assert!(case.contains(said), "{case}");
}

#[test]
fn values_say_the_rows_they_come_from() {
    let imported = read(RAFT).unwrap();
    let rows: Vec<&str> = RAFT.lines().collect();
    let case: Vec<&str> = imported.text.lines().collect();
    let of = |key: &str| {
        let line = case.iter().find(|line| line.starts_with(key)).unwrap();
        let words = line.split("# line ").nth(1).unwrap();
        let number: usize = words.split(',').next().unwrap().parse().unwrap();
        (rows[number - 1].trim(), words.to_owned())
    };
    assert!(of("ea_n").0.starts_with("stiffness:"), "{:?}", of("ea_n"));
    assert!(of("ea_n").1.ends_with(", stiffness"));
    assert!(of("length_m").0.starts_with("length:"));
    assert!(of("depth_m").0.starts_with("water_depth"));
    assert!(of("water_density").0.starts_with("rho_water"));
}

#[test]
fn chains_by_diameter_alone_take_the_formulas_of_the_library() {
    let stated = "type: custom\n               mass_density: 685.0\n               stiffness: 3.27e9\n               breaking_load: 2.2286e7\n               cost: 1000.0";
    assert!(ONTOLOGY.contains(stated));
    let by_name = |diameter: &str, material: &str| {
        ONTOLOGY
            .replace("diameter: 0.333", &format!("diameter: {diameter}"))
            .replace(stated, &format!("type: {material}"))
    };
    let nominal = case_of(&by_name("0.185", "chain"));
    assert!(nominal.contains("185 mm is taken as nominal"), "{nominal}");
    assert!(nominal.contains("diameter_m = 0.333 "), "{nominal}");
    // 19.9e3 d^2 is 0.6 % below the 685 kg/m of the published chain.
    assert_fairlead(&solved(&nominal), "line1", FAIRLEAD, 0.02);
    let outer = case_of(&by_name("0.333", "Chain"));
    assert!(outer.contains("333 mm is taken as volume-equivalent"));
    let [one, other] =
        [nominal, outer].map(|case| value(&solved(&case), "tension_n[line1|b]").unwrap());
    assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
    let all = read(&by_name("0.185", "polypropylene")).unwrap_err();
    assert_eq!(
        (all.len(), all[0].key.as_str()),
        (1, "components.mooring.line_types.main.type")
    );
}

#[test]
fn angles_before_version_2_are_in_radians() {
    let old = ONTOLOGY
        .replace("windIO_version: '2.0'\n", "")
        .replace(", 180.0,", ", 3.141592653589793,")
        .replace(", 60.0,", ", 1.0471975511965976,");
    let [old, new] = [&old, ONTOLOGY].map(|text| solved(&case_of(text)));
    let tension = value(&new, "tension_n[line2|b]").unwrap();
    assert_fairlead(&old, "line2", tension, 1e-9);
}

#[test]
fn json_and_windows_rows_and_other_encodings_are_read() {
    let windows = RAFT.replace('\n', "\r\n");
    let [one, other] = [RAFT, &windows].map(case_of);
    assert_eq!(one, other);
    let faulty = windows.replacen(
        "[418.8, 725.383, -200.0]",
        "[418.8, \u{e9}t\u{e9}, -200.0]",
        1,
    );
    let fault = &read(&faulty).unwrap_err()[0];
    assert_eq!((fault.line, fault.column), (22, 29));
    let json = r#"{"mooring": {"water_depth": 100,
        "points": [{"name": "a", "type": "fixed", "location": [0, 0, -100]}, {"name": "b", "type": "vessel", "location": [60, 0, -10]}],
        "lines": [{"name": "l", "endA": "a", "endB": "b", "type": "t", "length": 120}],
        "line_types": [{"name": "t", "diameter": 0.1, "mass_density": 20, "stiffness": "1e8"}]}}"#;
    assert!(foreign::is_design(json) && foreign::is_design(RAFT) && foreign::is_design(ONTOLOGY));
    let system = solved(&case_of(json));
    assert!(value(&system, "tension_n[l|b]").unwrap() > 0.0);
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("latin.yaml");
    let mut bytes = RAFT.as_bytes().to_vec();
    bytes.extend(b"# caf\xe9\n");
    fs::write(&path, &bytes).unwrap();
    assert!(seacable::open::load::<SystemFile>(&path).is_ok());
}

#[test]
fn a_design_and_its_case_are_the_same_system() {
    let dir = tempfile::tempdir().unwrap();
    for (name, text) in [("raft", RAFT), ("ontology", ONTOLOGY)] {
        let path = dir.path().join(name).with_extension("yaml");
        fs::write(&path, text).unwrap();
        let file = seacable::open::load::<SystemFile>(&path).unwrap();
        let case = import::case_path(&path);
        assert_eq!(case, path.with_extension("toml"));
        fs::write(&case, &file.text).unwrap();
        let case = seacable::open::load::<SystemFile>(&case).unwrap();
        assert_eq!(file.computed.file, case.computed.file);
        let key = "tension_n[line2|a]";
        let bits = [&file, &case].map(|of| value(&of.computed, key).unwrap().to_bits());
        assert_eq!(bits[0], bits[1]);
    }
}

/// The OC3 spar's chain in the form of `MoorDyn`, for designs that name a file.
pub(crate) const MOORDYN: &str = "\
--- LINE TYPES ---
Name Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(-) (m) (kg/m) (N) (N-s) (N-m2) (-) (-) (-) (-)
main 0.09 77.7066 384.243E6 -0.8 0 1.6 1.0 0.1 0.0
--- POINTS ---
ID Type X Y Z Mass Volume CdA Ca
(-) (-) (m) (m) (m) (kg) (m3) (m2) (-)
1 Fixed 853.87 0 -320 0 0 0 0
2 Vessel 5.2 0 -70 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(-) (-) (-) (-) (m) (-) (-)
1 main 1 2 902.2 20 -
--- OPTIONS ---
9.80665 g
";

#[test]
fn a_file_that_a_design_names_is_read_beside_it() {
    let dir = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| {
        let path = dir.path().join(name);
        fs::write(&path, text).unwrap();
        path
    };
    put("lines.dat", MOORDYN);
    let design = put(
        "design.yaml",
        "mooring:\n  water_depth: 320\n  file: lines.dat\n",
    );
    let loaded = seacable::open::load::<SystemFile>(&design).unwrap();
    assert!(
        loaded.text.contains("# lines.dat line 13, UnstrLen"),
        "{}",
        loaded.text
    );
    assert!(
        loaded
            .text
            .contains("depth_m = 320.0                         # line 2")
    );
    // MAP++, without friction of the bed.
    assert_fairlead(&loaded.computed, "line1", 911_089.0, 1e-3);
    put("lines.dat", &MOORDYN.replace("1 main 1 2", "1 main 1 3"));
    let all = seacable::open::load::<SystemFile>(&design).unwrap_err();
    assert_eq!((all[0].line, all[0].column), (3, 9), "{all:#?}");
    assert!(
        all[0]
            .problem
            .contains("in `lines.dat`, line 13, column 10")
    );
    // What the case finds is shown where the file is named, too.
    put(
        "lines.dat",
        &MOORDYN.replace("853.87 0 -320", "853.87 0 -350"),
    );
    let all = seacable::open::load::<SystemFile>(&design).unwrap_err();
    assert_eq!((all[0].line, all[0].column), (3, 9), "{all:#?}");
    assert!(
        all[0].problem.contains("in `lines.dat`, line 8"),
        "{all:#?}"
    );
}

#[test]
fn a_text_is_a_design_by_its_top_keys() {
    assert!(!foreign::is_design("[system]\nmooring = 1\n"));
    assert!(!foreign::is_design("    mooring: x\n"));
    assert!(foreign::is_named_yaml(Path::new("a/b.YML")));
    assert!(!import::is_foreign("[case]\nmooring: 3\n"));
}

#[test]
fn a_library_has_the_properties_that_its_coefficients_give() {
    let library = library::read(LIBRARY, "library.yaml").unwrap();
    let names: Vec<&str> = library.types.iter().map(|of| of.name.as_str()).collect();
    assert_eq!(names, ["chain", "rope"]);
    let near =
        |value: f64, wanted: f64| assert!((value / wanted - 1.0).abs() < 1e-12, "{value} {wanted}");
    let chain = library.properties(&library.types[0], 0.12).unwrap();
    near(chain.mass.value, 19.9e3 * 0.0144);
    near(chain.diameter.value, 0.216);
    near(chain.ea.value, 85.6e9 * 0.0144 - 3.93e7 * 0.001_728);
    near(
        chain.break_load.value,
        9.11e2 * 0.12 + 1.21e9 * 0.0144 - 2.19e9 * 0.001_728,
    );
    assert_eq!(chain.ea.formula, "8.56e10 d^2 - 3.93e7 d^3");
    let rope = library
        .properties(library.find("ROPE").unwrap(), 0.1)
        .unwrap();
    near(rope.break_load.value, 1e4 + 3e6);
    near(rope.ea.value, 15.0 * 3.01e6);
    near(
        rope.diameter.value,
        (4.0 * 7.0 / (std::f64::consts::PI * 1400.0)).sqrt(),
    );
    assert_eq!(
        rope.line_type.dynamic_stiffness.as_ref().unwrap().0,
        [12.0, 0.4]
    );
    let (text, name) = seacable::line_types::with_material("[case]\n", &rope);
    assert!(text.contains(&format!("[materials.{name}]")));
    let wide = library.properties(&library.types[0], 0.3).unwrap_err();
    assert!(wide.to_string().contains("up to 250 mm"), "{wide}");
    assert!(library.properties(&library.types[0], f64::NAN).is_err());
}
