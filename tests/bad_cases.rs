//! Bad case files, one by one: each fault is told with line, column, key, reason and remedy.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::path::Path;

use seacable::case::{self, Diagnostic};

/// A small case without faults. Every test below spoils it in one place.
const GOOD: &str = r#"[case]
title = "Test"

[current]
speed_m_per_s = [0.5, 0.2]
depth_m = [0.0, 100.0]

[materials.chain]
diameter_m = 0.1
mass_kg_per_m = 200.0
ea_n = 1e9
axial_damping_ratio = 0.02
drag_normal = 1.2

[[line]]
name = "upper"
material = "chain"
length_m = 80.0
segments = 8

[[line]]
name = "lower"
material = "chain"
length_m = 20.0
segments = 2

[ends.a]
name = "vessel"
kind = "fixed"
position_m = [0.0, 0.0, 0.0]

[ends.b]
name = "load"
kind = "payload"

[payload]
dry_mass_kg = 1000.0
wet_mass_kg = 800.0
drag_area_m2 = 2.0
added_mass_kg = 500.0

[[floats]]
section = "upper"
from_m = 10.0
to_m = 30.0
lift_kg = 100.0

[marks]
"payload.drag_area_m2" = { status = "assumed", reason = "a guess" }

[[study]]
name = "current"
key = "materials.chain.diameter_m"
values = [0.05, 0.1]

[[published]]
name = "tension at the load"
channel = "tension_n[lower|load]"
statistic = "mean"
window_s = [0.0, 200.0]
value = 7.7e3
tolerance_rel = 0.03
source = "a paper"
inputs = "published"
at = { study = "current", value = 0.05 }

[[trend]]
name = "thicker, more drag"
study = "current"
channel = "x_m[load]"
statistic = "final"
expect = "rises"
source = "a paper"
"#;

fn faults(text: &str) -> Vec<Diagnostic> {
    case::parse(text, "bad.toml").unwrap_err()
}

/// The one fault of the good case with `old` replaced by `new`.
fn spoilt(old: &str, new: &str) -> Diagnostic {
    assert_eq!(
        GOOD.matches(old).count(),
        1,
        "`{old}` must stand there once"
    );
    let mut found = faults(&GOOD.replace(old, new));
    assert_eq!(found.len(), 1, "{found:#?}");
    found.remove(0)
}

/// Holds a fault against where it must be and what it must say.
fn tells(fault: &Diagnostic, at: (u32, u32), key: &str, problem: &str, remedy: &str) {
    assert_eq!((fault.line, fault.column), at, "{fault}");
    assert_eq!(fault.key, key, "{fault}");
    assert!(fault.problem.contains(problem), "{fault}");
    assert!(fault.remedy.contains(remedy), "{fault}");
}

#[test]
fn the_good_case_has_no_faults() {
    assert!(case::parse(GOOD, "good.toml").is_ok());
}

// Keys.

#[test]
fn unknown_key() {
    let fault = spoilt("lift_kg = 100.0", "lift_kg = 100.0\ncolour = 3");
    tells(
        &fault,
        (47, 1),
        "floats.upper.colour",
        "not a known key",
        "the keys known here are `section`",
    );
}

#[test]
fn misspelt_key_names_the_right_one_and_is_not_missing_too() {
    let fault = spoilt("length_m = 80.0", "lenght_m = 80.0");
    tells(
        &fault,
        (18, 1),
        "line.upper.lenght_m",
        "not a known key",
        "did you mean `length_m`?",
    );
}

#[test]
fn key_of_another_table() {
    let fault = spoilt("drag_area_m2 = 2.0", "drag_area_m2 = 2.0\nduration_s = 5.0");
    tells(
        &fault,
        (40, 1),
        "payload.duration_s",
        "not a known key",
        "belongs in `solver`",
    );
}

#[test]
fn unknown_table() {
    let fault = spoilt("[current]", "[curent]");
    tells(
        &fault,
        (4, 2),
        "curent",
        "not a known key",
        "did you mean `current`?",
    );
}

#[test]
fn missing_key() {
    let fault = spoilt("ea_n = 1e9\n", "");
    tells(
        &fault,
        (8, 1),
        "materials.chain.ea_n",
        "is missing",
        "add `ea_n = ...` (axial stiffness EA): greater than 0 N",
    );
}

#[test]
fn missing_table() {
    let fault = spoilt("[case]\ntitle = \"Test\"\n", "");
    tells(&fault, (1, 1), "case", "is missing", "add [case]");
}

#[test]
fn missing_unit() {
    let fault = spoilt("length_m = 80.0", "length = 80.0");
    tells(
        &fault,
        (18, 1),
        "line.upper.length",
        "has no unit in its name",
        "write `length_m`, with the value in m",
    );
}

#[test]
fn wrong_unit() {
    let fault = spoilt("diameter_m = 0.1", "diameter_mm = 100.0");
    tells(
        &fault,
        (9, 1),
        "materials.chain.diameter_mm",
        "has the wrong unit",
        "write `diameter_m`, with the value in m",
    );
    let fault = spoilt("dry_mass_kg = 1000.0", "dry_mass_t = 1.0");
    tells(
        &fault,
        (37, 1),
        "payload.dry_mass_t",
        "has the wrong unit",
        "write `dry_mass_kg`, with the value in kg",
    );
}

#[test]
fn key_given_twice() {
    let fault = spoilt("ea_n = 1e9", "ea_n = 1e9\nea_n = 2e9");
    tells(&fault, (12, 1), "", "duplicate key", "key = value");
}

// Values.

#[test]
fn wrong_type() {
    let fault = spoilt("length_m = 80.0", "length_m = true");
    tells(
        &fault,
        (18, 12),
        "line.upper.length_m",
        "must be a number, and is true or false",
        "greater than 0 m",
    );
    let fault = spoilt("segments = 8", "segments = 8.0");
    tells(
        &fault,
        (19, 12),
        "line.upper.segments",
        "must be a whole number without a decimal point",
        "a whole number from 1 to 10000",
    );
    let fault = spoilt("title = \"Test\"", "title = 5");
    tells(
        &fault,
        (2, 9),
        "case.title",
        "must be text in quotes, and is a whole number",
        "text",
    );
}

#[test]
fn unit_in_the_value() {
    let fault = spoilt("length_m = 80.0", "length_m = \"80 m\"");
    tells(
        &fault,
        (18, 12),
        "line.upper.length_m",
        "must be a number, and is text",
        "without quotes and without a unit, with the value in m: length_m = 80",
    );
}

#[test]
fn table_written_as_a_value() {
    let fault = spoilt(
        "[marks]\n\"payload.drag_area_m2\" = { status = \"assumed\", reason = \"a guess\" }",
        "[marks]\n\"payload.drag_area_m2\" = \"assumed\"",
    );
    tells(
        &fault,
        (49, 26),
        "marks.\"payload.drag_area_m2\"",
        "must be written as [marks.<name>], and is text",
        "[marks.<name>]",
    );
}

#[test]
fn list_written_as_a_table() {
    let text = GOOD.replace("[[floats]]", "[floats]");
    let found = faults(&text);
    tells(
        &found[0],
        (42, 1),
        "floats",
        "must be written as [[floats]], and is a table",
        "[[floats]]",
    );
}

#[test]
fn negative_length() {
    let fault = spoilt("length_m = 80.0", "length_m = -80.0");
    tells(
        &fault,
        (18, 12),
        "line.upper.length_m",
        "is out of range: -80 m",
        "give greater than 0 m, up to 1e5 m",
    );
}

#[test]
fn zero_segments() {
    let fault = spoilt("segments = 8", "segments = 0");
    tells(
        &fault,
        (19, 12),
        "line.upper.segments",
        "is out of range: 0",
        "give a whole number from 1 to 10000",
    );
}

#[test]
fn not_a_number_and_infinite() {
    let fault = spoilt("ea_n = 1e9", "ea_n = nan");
    tells(
        &fault,
        (11, 8),
        "materials.chain.ea_n",
        "must be a finite number, and is nan",
        "greater than 0 N",
    );
    let fault = spoilt("ea_n = 1e9", "ea_n = inf");
    tells(
        &fault,
        (11, 8),
        "materials.chain.ea_n",
        "must be a finite number, and is inf",
        "greater than 0 N",
    );
    let fault = spoilt(
        "position_m = [0.0, 0.0, 0.0]",
        "position_m = [0.0, nan, 0.0]",
    );
    tells(
        &fault,
        (30, 20),
        "ends.a.position_m",
        "must be a finite number, and is nan",
        "along x, y, z",
    );
}

#[test]
fn wrong_count() {
    let fault = spoilt("position_m = [0.0, 0.0, 0.0]", "position_m = [0.0, 0.0]");
    tells(
        &fault,
        (30, 14),
        "ends.a.position_m",
        "must hold 3 numbers, and holds 2",
        "three numbers along x, y, z",
    );
}

#[test]
fn unknown_word() {
    let fault = spoilt("kind = \"fixed\"", "kind = \"fixd\"");
    tells(
        &fault,
        (29, 8),
        "ends.a.kind",
        "is not known: \"fixd\"",
        "did you mean \"fixed\"?",
    );
    let fault = spoilt("drag_normal = 1.2", "drag_normal = \"jia\"");
    tells(
        &fault,
        (13, 15),
        "materials.chain.drag_normal",
        "is not known: \"jia\"",
        "`jia-2019-normal`",
    );
}

#[test]
fn name_that_channels_cannot_carry() {
    let fault = spoilt("name = \"vessel\"", "name = \"the|vessel\"");
    tells(
        &fault,
        (28, 8),
        "ends.a.name",
        "is not a usable name",
        "letters, digits, - and _",
    );
}

// The line.

#[test]
fn unknown_material() {
    let fault = spoilt(
        "name = \"upper\"\nmaterial = \"chain\"",
        "name = \"upper\"\nmaterial = \"chian\"",
    );
    tells(
        &fault,
        (17, 12),
        "line.upper.material",
        "there is no material named \"chian\"",
        "did you mean \"chain\"?",
    );
}

#[test]
fn name_used_twice() {
    let fault = spoilt("name = \"vessel\"", "name = \"upper\"");
    tells(
        &fault,
        (28, 8),
        "ends.a.name",
        "the name \"upper\" is used twice",
        "a name of its own",
    );
}

#[test]
fn end_off_the_lines_reach() {
    let fault = spoilt(
        "kind = \"payload\"",
        "kind = \"payload\"\nposition_m = [0.0, 0.0, -1000.0]",
    );
    tells(
        &fault,
        (35, 14),
        "ends.b.position_m",
        "off the line's reach: the ends are 1000 m apart and the line is 100 m long",
        "within 150 m of each other",
    );
    let taut = GOOD.replace(
        "kind = \"payload\"",
        "kind = \"payload\"\nposition_m = [0.0, 0.0, -101.0]",
    );
    assert!(case::parse(&taut, "taut").is_ok());
}

#[test]
fn held_end_without_position() {
    let fault = spoilt("position_m = [0.0, 0.0, 0.0]\n", "");
    tells(
        &fault,
        (27, 1),
        "ends.a.position_m",
        "is missing",
        "position_m = [x, y, z]",
    );
}

#[test]
fn moving_end_without_period() {
    let fault = spoilt(
        "kind = \"fixed\"",
        "kind = \"moving\"\namplitude_m = [0.0, 0.0, 1.0]",
    );
    tells(
        &fault,
        (27, 1),
        "ends.a.period_s",
        "is missing",
        "needs the period of its motion",
    );
}

#[test]
fn nothing_holds_the_line() {
    let fault = spoilt("kind = \"fixed\"", "kind = \"free\"");
    tells(
        &fault,
        (34, 8),
        "ends.b.kind",
        "nothing holds the line",
        "start.shape = \"straight\"",
    );
}

#[test]
fn payload_without_an_end_and_end_without_payload() {
    let text = GOOD.replace("kind = \"payload\"", "kind = \"free\"");
    tells(
        &faults(&text)[0],
        (36, 1),
        "payload",
        "no end carries the payload",
        "\"payload\", or remove [payload]",
    );
    let payload = "[payload]\ndry_mass_kg = 1000.0\nwet_mass_kg = 800.0\ndrag_area_m2 = 2.0\nadded_mass_kg = 500.0\n";
    let found = faults(&GOOD.replace(payload, ""));
    tells(
        &found[0],
        (34, 8),
        "ends.b.kind",
        "carries a payload, and the case has none",
        "add a table [payload]",
    );
    let fault = spoilt(
        "kind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n",
        "kind = \"payload\"\nposition_m = [0.0, 0.0, 0.0]\n[start]\nshape = \"straight\"\n",
    );
    tells(
        &fault,
        (36, 8),
        "ends.b.kind",
        "both ends carry the payload",
        "leave it on one end",
    );
}

#[test]
fn floats_off_their_section() {
    let fault = spoilt("to_m = 30.0", "to_m = 90.0");
    tells(
        &fault,
        (45, 8),
        "floats.upper.to_m",
        "reach beyond their section: 90 m",
        "section \"upper\" is 80 m long",
    );
    let fault = spoilt("from_m = 10.0", "from_m = 40.0");
    tells(
        &fault,
        (44, 10),
        "floats.upper.from_m",
        "the stretch is empty",
        "begin before it ends",
    );
    let fault = spoilt("section = \"upper\"", "section = \"middle\"");
    tells(
        &fault,
        (43, 11),
        "floats.middle.section",
        "there is no section named \"middle\"",
        "`upper` and `lower`",
    );
}

// Loads.

#[test]
fn current_table() {
    let fault = spoilt("depth_m = [0.0, 100.0]\n", "");
    tells(
        &fault,
        (5, 17),
        "current.speed_m_per_s",
        "the depths it belongs to are missing",
        "with 2 depths in m",
    );
    let fault = spoilt("depth_m = [0.0, 100.0]", "depth_m = [0.0, 50.0, 100.0]");
    tells(
        &fault,
        (5, 17),
        "current.speed_m_per_s",
        "has 2 values for 3 depths",
        "one value for each depth",
    );
    let fault = spoilt("depth_m = [0.0, 100.0]", "depth_m = [100.0, 0.0]");
    tells(
        &fault,
        (6, 19),
        "current.depth_m",
        "must increase: 0 m follows 100 m",
        "from the surface down",
    );
    let fault = spoilt("speed_m_per_s = [0.5, 0.2]", "speed_m_per_s = 0.5");
    tells(
        &fault,
        (6, 11),
        "current.depth_m",
        "has no effect",
        "a list of speeds",
    );
}

#[test]
fn damping_given_twice() {
    let fault = spoilt(
        "axial_damping_ratio = 0.02",
        "axial_damping_ratio = 0.02\naxial_damping_n_s = 1e5",
    );
    tells(
        &fault,
        (13, 1),
        "materials.chain.axial_damping_n_s",
        "given twice",
        "keep one",
    );
}

#[test]
fn payload_weight() {
    let fault = spoilt(
        "wet_mass_kg = 800.0",
        "wet_mass_kg = 800.0\nvolume_m3 = 0.2",
    );
    tells(
        &fault,
        (39, 13),
        "payload.volume_m3",
        "given twice",
        "keep one",
    );
    let fault = spoilt("wet_mass_kg = 800.0", "wet_mass_kg = 1800.0");
    tells(
        &fault,
        (38, 15),
        "payload.wet_mass_kg",
        "more than the 1000 kg in air",
        "less the mass of the displaced water",
    );
    let fault = spoilt("wet_mass_kg = 800.0\n", "");
    tells(
        &fault,
        (36, 1),
        "payload.wet_mass_kg",
        "the weight in water is not known",
        "volume_m3",
    );
}

#[test]
fn payload_shape_of_another_kind() {
    let shape = "added_mass_kg = 500.0\nshape = { kind = \"box\", length_m = 1.0, breadth_m = 1.0, height_m = 1.0, sphere_diameter_m = 2.0 }";
    let fault = spoilt("added_mass_kg = 500.0", shape);
    tells(
        &fault,
        (41, 74),
        "payload.shape.sphere_diameter_m",
        "belongs to a table with kind = \"sphere-and-cylinder\"",
        "remove it",
    );
    let shape =
        "added_mass_kg = 500.0\nshape = { kind = \"box\", length_m = 1.0, breadth_m = 1.0 }";
    let fault = spoilt("added_mass_kg = 500.0", shape);
    tells(
        &fault,
        (41, 9),
        "payload.shape.height_m",
        "is missing",
        "box height",
    );
}

#[test]
fn more_output_than_a_disk_holds() {
    let fault = spoilt("[marks]", "[output]\ninterval_s = 1e-6\n[marks]");
    tells(
        &fault,
        (49, 14),
        "output.interval_s",
        "output instants in 600 s",
        "at least",
    );
}

// Claims.

#[test]
fn study_of_a_key_that_is_not_there() {
    let fault = spoilt(
        "key = \"materials.chain.diameter_m\"",
        "key = \"materials.chain.diametr_m\"",
    );
    tells(
        &fault,
        (53, 7),
        "study.current.key",
        "there is no key `materials.chain.diametr_m`",
        "did you mean `materials.chain.diameter_m`?",
    );
    let fault = spoilt(
        "key = \"materials.chain.diameter_m\"",
        "key = \"case.title\"",
    );
    tells(
        &fault,
        (53, 7),
        "study.current.key",
        "is not a number",
        "takes one number",
    );
    let fault = spoilt("values = [0.05, 0.1]", "values = [0.05, -0.1]");
    tells(
        &fault,
        (54, 17),
        "study.current.values",
        "is out of range: -0.1 m",
        "greater than 0 m",
    );
}

#[test]
fn published_value_of_a_channel_that_is_not_recorded() {
    let fault = spoilt(
        "channel = \"tension_n[lower|load]\"",
        "channel = \"tension_n[lower|loda]\"",
    );
    tells(
        &fault,
        (58, 11),
        "published.\"tension at the load\".channel",
        "there is no channel named",
        "did you mean \"tension_n[lower|load]\"?",
    );
    let fault = spoilt("channel = \"x_m[load]\"", "channel = \"x_m[vessel]\"");
    tells(
        &fault,
        (70, 11),
        "trend.\"thicker, more drag\".channel",
        "there is no channel named \"x_m[vessel]\"",
        "x_m[load]",
    );
}

#[test]
fn published_value_without_tolerance() {
    let fault = spoilt("tolerance_rel = 0.03\n", "");
    tells(
        &fault,
        (56, 1),
        "published.\"tension at the load\".tolerance_rel",
        "no tolerance",
        "tolerance_abs",
    );
}

#[test]
fn window_that_runs_backward() {
    let fault = spoilt("window_s = [0.0, 200.0]", "window_s = [200.0, 0.0]");
    tells(
        &fault,
        (60, 12),
        "published.\"tension at the load\".window_s",
        "the window is empty",
        "begin before it ends",
    );
}

#[test]
fn point_of_a_study_that_is_not_there() {
    let fault = spoilt("at = { study = \"current\"", "at = { study = \"curent\"");
    tells(
        &fault,
        (65, 16),
        "published.\"tension at the load\".at.study",
        "there is no study named \"curent\"",
        "did you mean \"current\"?",
    );
    let fault = spoilt("value = 0.05 }", "value = 0.06 }");
    tells(
        &fault,
        (65, 35),
        "published.\"tension at the load\".at.value",
        "0.06 is not a value of the study",
        "0.05, 0.1",
    );
    let fault = spoilt("study = \"current\"\n", "study = \"weight\"\n");
    tells(
        &fault,
        (69, 9),
        "trend.\"thicker, more drag\".study",
        "there is no study named \"weight\"",
        "`current`",
    );
}

#[test]
fn mark_of_a_key_that_is_not_there() {
    let fault = spoilt("\"payload.drag_area_m2\" =", "\"payload.drag_aera_m2\" =");
    tells(
        &fault,
        (49, 1),
        "marks.\"payload.drag_aera_m2\"",
        "there is no key `payload.drag_aera_m2`",
        "did you mean `payload.drag_area_m2`?",
    );
}

#[test]
fn all_faults_are_told_at_once_in_the_order_of_lines() {
    let text = GOOD
        .replace("length_m = 80.0", "length_m = -80.0")
        .replace("ea_n = 1e9", "ea = 1e9")
        .replace("\"x_m[load]\"", "\"x_m[laod]\"")
        .replace("section = \"upper\"", "section = \"uper\"");
    let keys: Vec<String> = faults(&text).into_iter().map(|fault| fault.key).collect();
    assert_eq!(
        keys,
        [
            "materials.chain.ea",
            "line.upper.length_m",
            "floats.uper.section",
            "trend.\"thicker, more drag\".channel"
        ]
    );
}

// Files.

fn load(path: &Path) -> Diagnostic {
    let mut found = case::load(path).unwrap_err();
    assert_eq!(found.len(), 1, "{found:#?}");
    found.remove(0)
}

#[test]
fn syntax_that_is_not_toml() {
    let text = "[case]\ntitle = \nsource = ?\n[line\n";
    let found = faults(text);
    assert!(found.len() >= 2, "{found:#?}");
    tells(&found[0], (2, 9), "", "this is not TOML", "key = value");
    let last = found.last().unwrap();
    tells(
        last,
        (4, 6),
        "",
        "this is not TOML: unclosed table",
        "key = value",
    );
    let shown = last.render(text, false);
    assert!(shown.contains("4 | [line\n  |      ^"), "{shown}");
}

#[test]
fn no_such_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("none.toml");
    let fault = load(&path);
    tells(
        &fault,
        (1, 1),
        "",
        "there is no such file",
        "check the name",
    );
    assert!(fault.file.ends_with("none.toml"));
}

#[test]
fn a_directory() {
    let folder = tempfile::tempdir().unwrap();
    tells(
        &load(folder.path()),
        (1, 1),
        "",
        "is a directory",
        "name a case file",
    );
}

#[test]
fn an_empty_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("empty.toml");
    for text in ["", " \n\n", "# only a comment\n"] {
        std::fs::write(&path, text).unwrap();
        tells(&load(&path), (1, 1), "", "the file is empty", "[case]");
    }
}

#[test]
fn a_binary_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("binary.toml");
    std::fs::write(&path, b"[case]\nt\xff\xfe\x00").unwrap();
    tells(
        &load(&path),
        (2, 2),
        "",
        "this is not text: byte 9",
        "UTF-8",
    );
    std::fs::write(&path, b"[case]\nt\0\0").unwrap();
    let found = case::load(&path).unwrap_err();
    assert!(
        found
            .iter()
            .all(|fault| fault.problem.contains("this is not TOML"))
    );
}

#[test]
fn a_fault_is_shown_under_its_line() {
    let text = GOOD.replace("length_m = 80.0", "length_m = -80.0");
    let shown = case::render_all(&faults(&text), &text, false);
    assert_eq!(
        shown,
        "error: line.upper.length_m: is out of range: -80 m
  --> bad.toml:18:12
   |
18 | length_m = -80.0
   |            ^^^^^
   |
   = help: give greater than 0 m, up to 1e5 m"
    );
    assert!(case::render_all(&faults(&text), &text, true).contains('\u{1b}'));
}
