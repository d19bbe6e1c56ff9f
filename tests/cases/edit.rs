//! Setting a key changes its value and no other byte.

use seacable::case::{self, edit};

const MANIFOLD: &str = include_str!("../../cases/pendulous/manifold.toml");

/// Sets a key and checks that the text changed from `old` to `new` in one place only.
fn changes(key: &str, value: &str, old: &str, new: &str) {
    let edited = edit::set(MANIFOLD, key, value).unwrap_or_else(|fault| panic!("{fault}"));
    assert!(MANIFOLD.contains(old), "{old}");
    assert_eq!(edited, MANIFOLD.replacen(old, new, 1));
    assert!(case::parse(&edited, "edited").is_ok());
}

#[test]
fn a_value_is_replaced_and_its_comment_stays() {
    changes(
        "current.speed_m_per_s",
        "0.45",
        "speed_m_per_s = 0.3   # uniform",
        "speed_m_per_s = 0.45   # uniform",
    );
    changes(
        "line.polyester.length_m",
        "1426",
        "length_m = 1326.0",
        "length_m = 1426",
    );
    changes(
        "payload.dry_mass_kg",
        "3.1e5",
        "dry_mass_kg = 300e3",
        "dry_mass_kg = 3.1e5",
    );
    changes(
        "ends.a.position_m",
        "[0, 0, -5]",
        "position_m = [0.0, 0.0, 0.0]",
        "position_m = [0, 0, -5]",
    );
}

#[test]
fn bare_words_are_text_where_the_field_takes_words() {
    changes(
        "solver.method",
        "rk4",
        "method = \"alpha\"",
        "method = \"rk4\"",
    );
    changes(
        "solver.method",
        "\"quasi\"",
        "method = \"alpha\"",
        "method = \"quasi\"",
    );
    changes(
        "case.title",
        "Other words: \"x\"",
        "\"Manifold, 300 t, lowered by the pendulous method\"",
        "'Other words: \"x\"'",
    );
    changes(
        "materials.chain.drag_normal",
        "1.2",
        "drag_normal = \"jia-2019-normal\"             # eq. (4)",
        "drag_normal = 1.2             # eq. (4)",
    );
}

#[test]
fn an_absent_key_goes_to_the_end_of_its_table() {
    changes(
        "solver.max_iterations",
        "20",
        "duration_s = 1200.0\n",
        "duration_s = 1200.0\nmax_iterations = 20\n",
    );
    changes(
        "materials.wire.drag_tangential_width",
        "perimeter",
        "break_load_n = 9.8067e6      # 1000 t\n",
        "break_load_n = 9.8067e6      # 1000 t\ndrag_tangential_width = \"perimeter\"\n",
    );
}

#[test]
fn an_absent_table_goes_to_the_end_of_the_file() {
    let without = MANIFOLD.replace("[output]\ninterval_s = 0.5\nshape_interval_s = 10.0\n", "");
    let edited = edit::set(&without, "output.interval_s", "0.25").unwrap();
    assert_eq!(edited, format!("{without}\n[output]\ninterval_s = 0.25\n"));
    let mark = edit::set_all(
        MANIFOLD,
        &[
            ("marks.\"output.interval_s\".status", "assumed"),
            ("marks.\"output.interval_s\".reason", "fine enough"),
        ],
    )
    .unwrap();
    assert_eq!(
        mark,
        format!(
            "{MANIFOLD}\n[marks.\"output.interval_s\"]\nstatus = \"assumed\"\nreason = \"fine enough\"\n"
        )
    );
}

/// The text without the table that this heading opens.
fn without(text: &str, heading: &str) -> String {
    let begin = text.find(heading).unwrap();
    let length = text[begin + heading.len()..].find("\n[").unwrap();
    format!(
        "{}{}",
        &text[..begin],
        &text[begin + heading.len() + length..]
    )
}

#[test]
fn inline_tables_dotted_keys_and_line_ends_keep_their_form() {
    let dotted = MANIFOLD.replace(
        "[start]\nshape = \"straight\"\nazimuth_deg = 0.0\nelevation_deg = -2.05     # the far end 50 m down, at the foot of the splash zone\n",
        "",
    );
    let dotted = format!(
        "start = {{ shape = \"straight\" }} # lying\nsolver.method = \"alpha\"\n{}",
        without(&dotted, "\n[solver]\n")
    );
    let edited = edit::set(&dotted, "start.azimuth_deg", "5").unwrap();
    assert!(edited.starts_with("start = { shape = \"straight\", azimuth_deg = 5 } # lying\n"));
    let edited = edit::set(&dotted, "solver.duration_s", "1200").unwrap();
    assert!(edited.contains("solver.method = \"alpha\"\nsolver.duration_s = 1200\n"));

    let windows = MANIFOLD.replace('\n', "\r\n");
    let edited = edit::set(&windows, "solver.rho_inf", "0.2").unwrap();
    assert_eq!(
        edited,
        edit::set(MANIFOLD, "solver.rho_inf", "0.2")
            .unwrap()
            .replace('\n', "\r\n")
    );
}

#[test]
fn a_bad_value_is_refused_with_its_range() {
    let fault = edit::set(MANIFOLD, "line.wire.length_m", "-5").unwrap_err();
    assert_eq!(
        fault.to_string(),
        "line.wire.length_m = -5:1:22: line.wire.length_m: is out of range: -5 m; give greater than 0 m, up to 1e5 m"
    );
    let fault = edit::set(MANIFOLD, "solver.method", "rk5").unwrap_err();
    assert!(fault.remedy.contains("did you mean \"rk4\"?"), "{fault}");
    let fault = edit::set(MANIFOLD, "line.wire.segments", "2.5").unwrap_err();
    assert!(fault.problem.contains("whole number"), "{fault}");
    let fault = edit::set(MANIFOLD, "solver.duration_s", "ten").unwrap_err();
    assert!(fault.remedy.contains("greater than 0 s"), "{fault}");
}

#[test]
fn a_key_that_no_case_has_is_refused_with_the_one_meant() {
    let fault = edit::set(MANIFOLD, "line.wire.length", "5").unwrap_err();
    assert_eq!(&*fault.remedy, "write `length_m`, with the value in m");
    let fault = edit::set(MANIFOLD, "line.wier.length_m", "5").unwrap_err();
    assert!(fault.remedy.contains("chain, polyester, wire"), "{fault}");
    let fault = edit::set(MANIFOLD, "curent.speed_m_per_s", "5").unwrap_err();
    assert!(fault.remedy.contains("current.speed_m_per_s"), "{fault}");
}

#[test]
fn an_edit_that_contradicts_the_case_is_refused() {
    let fault = edit::set(MANIFOLD, "ends.b.kind", "free").unwrap_err();
    assert!(
        fault.problem.contains("no end carries the payload"),
        "{fault}"
    );
}

#[test]
fn numbers_are_written_as_their_field_wants_them() {
    let edited = edit::set_number(MANIFOLD, "line.wire.segments", 4.0).unwrap();
    assert_eq!(
        edit::get(&edited, "line.wire.segments").as_deref(),
        Some("4")
    );
    let edited = edit::set_number(MANIFOLD, "payload.drag_area_m2", 100.0).unwrap();
    assert_eq!(
        edit::get(&edited, "payload.drag_area_m2").as_deref(),
        Some("100.0")
    );
    assert_eq!(
        edit::get(MANIFOLD, "solver.method").as_deref(),
        Some("alpha")
    );
    assert_eq!(edit::get(MANIFOLD, "solver.max_iterations"), None);
}

#[test]
fn a_coordinate_of_an_end_is_set_alone() {
    let text = include_str!("../../cases/umbilical/steep_wave.toml");
    let set = edit::set_number(text, "ends.b.position_m.y", 10.0).unwrap();
    assert!(set.contains("position_m = [100.0, 10.0, 0.0]"));
    assert_eq!(set.replace("[100.0, 10.0, 0.0]", "[100.0, 0.0, 0.0]"), text);
    assert_eq!(
        edit::get(&set, "ends.b.position_m.y").as_deref(),
        Some("10.0")
    );
    // A coordinate needs its position, its axis and its range.
    assert!(edit::set(text, "ends.b.position_m.w", "1.0").is_err());
    assert!(edit::set(text, "ends.b.position_m.x", "1e9").is_err());
    let without = text.replace("position_m = [100.0, 0.0, 0.0]\n", "");
    assert!(edit::set(&without, "ends.b.position_m.x", "1.0").is_err());
}

/// An optional key left out: its line goes, a comment behind it stays, and the rest of the file is as it was.
#[test]
fn an_optional_key_is_left_out_and_comments_stay() {
    let text = "[case]\ntitle = \"t\"\n[materials.r]\ndiameter_m = 0.1\nmass_kg_per_m = 1.0\nea_n = 1e6\n  drag_normal = 1.2   # of a rope\nbreak_load_n = 1e5\n\n[[line]]\nname = \"l\"\nmaterial = \"r\"\nlength_m = 10.0\nsegments = 2\n\n[ends]\na = { name = \"a\", kind = \"moving\", position_m = [0, 0, 0], period_s = 5.0, ramp_s = 1.0 }\nb = { name = \"b\", kind = \"free\" }\n";
    case::parse(text, "t.toml").unwrap();
    let without = |key: &str| edit::unset(text, key);
    let changed = |from: &str, to: &str| {
        assert!(text.contains(from));
        text.replace(from, to)
    };
    assert_eq!(
        without("materials.r.drag_normal").unwrap(),
        changed("  drag_normal = 1.2   # of a rope\n", "# of a rope\n")
    );
    assert_eq!(
        without("materials.r.break_load_n").unwrap(),
        changed("break_load_n = 1e5\n", "")
    );
    assert_eq!(
        without("ends.a.ramp_s").unwrap(),
        changed(", ramp_s = 1.0", "")
    );
    let refused = |key: &str| without(key).unwrap_err().problem;
    assert!(refused("line.l.length_m").contains("is needed"));
    assert!(refused("solver.rho_inf").contains("is not given"));
    assert!(refused("solver.rho").contains("is not given"));
    // A contradiction without it is reported as a fault of the file.
    let fault = without("ends.a.period_s").unwrap_err();
    assert!(fault.key.starts_with("ends.a"), "{fault}");
    // Left out and given again, the case says the same.
    let again = edit::set(
        &without("materials.r.drag_normal").unwrap(),
        "materials.r.drag_normal",
        "1.2",
    );
    assert_eq!(
        case::parse(&again.unwrap(), "t.toml"),
        case::parse(text, "t.toml")
    );
}
