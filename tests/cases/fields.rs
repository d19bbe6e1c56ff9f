//! The table of fields says what the reader of the file does: defaults, words, units, rows.

use seacable::case::fields::{AbsentValue, Field, Schema, ValueType, unit_suffix};
use seacable::case::{self, Case, Provenance, Statistic};
use seacable::case::{CASE, field_at, kind};

/// A case that gives nothing that has a default, but holds every table.
const BARE: &str = r#"
materials.m = { diameter_m = 0.1, mass_kg_per_m = 10.0, ea_n = 1e8, bore = { diameter_m = 0.05 } }
line = [{ name = "s", material = "m", length_m = 10.0, segments = 2 }]
floats = [{ section = "s", lift_kg = 1.0 }]
clumps = [{ name = "c", section = "s", at_m = 5.0, mass_kg = 1.0, wet_mass_kg = 1.0 }]
traveller = { name = "v", mass_kg = 1.0, wet_mass_kg = 1.0, speed_m_per_s = 1.0 }
modules = [{ section = "s", diameter_m = 1.0, length_m = 1.0, pitch_m = 2.0, density_kg_per_m3 = 400.0 }]
seabed.depth_m = 100.0
files."f.csv" = { text = "a" }
waves = { kind = "regular", height_m = 1.0, period_s = 5.0 }
modes.count = 10
study = [{ name = "t", key = "line.s.length_m", values = [10.0] }]
case.title = "bare"
current.speed_m_per_s = 0.1
published = [{ name = "p", channel = "x_m[b]", statistic = "mean", value = 1.0, tolerance_abs = 1.0, source = "s", inputs = "published", at = { study = "t", value = 10.0 } }]
trend = [{ name = "q", study = "t", channel = "x_m[b]", statistic = "mean", expect = "rises", source = "s" }]
checks = [{ kind = "safety-factor", factor = 2.0 }]
trial = [{ name = "w", set = ["solver.method=rk4"], rows = ["p"] }]
marks."materials.m.ea_n" = { status = "assumed", reason = "r" }

[ends]
a = { name = "a", kind = "fixed", position_m = [0.0, 0.0, 0.0] }
b = { name = "b", kind = "payload" }

[payload]
dry_mass_kg = 10.0
wet_mass_kg = 5.0
shape = { kind = "box", length_m = 1.0, breadth_m = 1.0, height_m = 1.0 }
rotation = { centre_of_gravity_m = 1.0, inertia_kg_m2 = 2.0 }
"#;

fn bare() -> Case {
    case::parse(BARE, "bare").unwrap_or_else(|faults| panic!("{faults:#?}"))
}

/// The bare case with a key added to the table of its field.
fn with(field: &Field, written: &str) -> String {
    let named = |part: &str, name: &str| part.replace('*', name);
    let path = match field.table() {
        "ends.*" => "ends.a".to_owned(),
        "materials.*" => named(field.table(), "m"),
        "line.*" => named(field.table(), "s"),
        table => {
            let list = table.split('.').next().unwrap();
            let name = match list {
                "materials" => "m",
                "floats" | "modules" => "s",
                "clumps" => "c",
                "checks" => "1",
                "study" => "t",
                "published" => "p",
                "trend" => "q",
                "trial" => "w",
                "files" => "\"f.csv\"",
                "marks" => "\"materials.m.ea_n\"",
                _ => "",
            };
            named(table, name)
        }
    };
    let key = format!("{path}.{}", field.key());
    case::edit::set(BARE, &key, written).unwrap_or_else(|fault| panic!("{key}: {fault}"))
}

#[test]
fn a_key_that_is_given_its_default_changes_nothing() {
    let bare = bare();
    // Defaults that the checks refuse as without effect beside the other keys of the bare case.
    let idle = [
        "waves.spectrum",
        "waves.gamma",
        "waves.components",
        "waves.seed",
        "waves.decay_depth_m",
        "seabed.friction_law",
        "seabed.slip_speed_m_per_s",
        "published_curve.*.window_s",
        "published_curve.*.kind",
    ];
    let mut tried = 0;
    for field in CASE
        .fields
        .iter()
        .filter(|field| !idle.contains(&&*field.path))
    {
        if let AbsentValue::Default(written) = field.absent {
            let again = case::parse(&with(field, written), "default");
            assert_eq!(again.as_ref(), Ok(&bare), "{}", field.path);
            tried += 1;
        }
    }
    assert!(tried > 60, "{tried}");
}

/// The value that a written case holds at a field's path, `*` being the one name there is.
fn held<'a>(root: &'a toml::Value, field: &Field) -> Option<&'a toml::Value> {
    let mut parts = field.path.split('.');
    parts.try_fold(root, |value, part| match (part, value) {
        ("*", toml::Value::Array(list)) => list.first(),
        ("*", toml::Value::Table(table)) => table.values().next(),
        (part, value) => value.get(part),
    })
}

#[test]
fn an_absent_key_without_default_holds_nothing() {
    let root = toml::Value::Table(case::write(&bare()).parse().unwrap());
    let without_default = |field: &&Field| matches!(field.absent, AbsentValue::Means(_));
    let absent = CASE.fields.iter().filter(without_default);
    let mut tried = 0;
    for field in absent.filter(|field| !BARE.contains(field.key())) {
        assert_eq!(held(&root, field), None, "{}", field.path);
        tried += 1;
    }
    assert!(tried > 40, "{tried}");
    let given = CASE.fields.iter().find(|f| f.path == "materials.*.ea_n");
    assert!(held(&root, given.unwrap()).is_some());
}

#[test]
fn every_key_of_a_written_case_is_a_field() {
    fn visit(value: &toml::Value, path: &mut Vec<String>, found: &mut Vec<Vec<String>>) {
        let mut inner = |part: &str, value: &toml::Value| {
            path.push(part.to_owned());
            visit(value, path, found);
            path.pop();
        };
        match value {
            toml::Value::Table(table) => table.iter().for_each(|(key, value)| inner(key, value)),
            toml::Value::Array(list) if list.iter().all(toml::Value::is_table) => {
                list.iter().for_each(|value| inner("*", value));
            }
            _ => found.push(path.clone()),
        }
    }
    let root: toml::Table = case::write(&bare()).parse().unwrap();
    let mut found = Vec::new();
    visit(&toml::Value::Table(root), &mut Vec::new(), &mut found);
    assert!(found.len() > 50, "{}", found.len());
    for path in found {
        assert!(field_at(&path).is_some(), "{path:?}");
    }
}

#[test]
fn every_word_of_a_choice_is_read() {
    let read = |old: &str, new: &str| {
        let text = BARE.replace(old, new);
        case::parse(&text, "word").unwrap_or_else(|faults| panic!("{new}: {faults:#?}"))
    };
    for statistic in Statistic::ALL.into_iter().filter(|s| s.over_time()) {
        let case = read(
            "statistic = \"mean\", value",
            &format!("statistic = \"{}\", value", statistic.name()),
        );
        assert_eq!(case.published[0].statistic, statistic);
    }
    let words = |path: &[&str]| match field_at(path).unwrap().kind {
        ValueType::Choice(words) | ValueType::NumberOrChoice(words) => words,
        other => panic!("{other:?}"),
    };
    for word in words(&["solver", "method"]) {
        read(
            "case.title",
            &format!("solver.method = \"{word}\"\ncase.title"),
        );
    }
    for word in words(&["marks", "x", "status"]) {
        read("status = \"assumed\"", &format!("status = \"{word}\""));
    }
    for word in words(&["materials", "m", "drag_tangential"]) {
        read(
            "ea_n = 1e8",
            &format!("ea_n = 1e8, drag_tangential = \"{word}\""),
        );
    }
    for word in words(&["materials", "m", "drag_normal"]) {
        read(
            "ea_n = 1e8",
            &format!("ea_n = 1e8, drag_normal = \"{word}\""),
        );
    }
    for word in words(&["materials", "m", "drag_tangential_width"]) {
        read(
            "ea_n = 1e8",
            &format!("ea_n = 1e8, drag_tangential_width = \"{word}\""),
        );
    }
    let straight = BARE.replace("case.title", "start.shape = \"straight\"\ncase.title");
    for word in words(&["ends", "a", "kind"]) {
        let kind = format!("kind = \"{word}\", period_s = 5.0");
        let text = straight
            .replace("kind = \"payload\"", "kind = \"free\"")
            .replace("kind = \"fixed\"", &kind);
        let unclaimed = text.replace("\"x_m[b]\"", "\"tension_n[a|s]\"");
        let faults = case::parse(&unclaimed, "kind").err().unwrap_or_default();
        assert!(
            faults.iter().all(|fault| fault.key == "payload"
                || fault.problem.contains("the payload hangs at end B")),
            "{word}: {faults:#?}"
        );
    }
    for word in words(&["start", "shape"]) {
        let shape = match *word {
            "given" => {
                "start.arc_m = [0.0, 10.0]\nstart.x_m = [0.0, 10.0]\nstart.z_m = [0.0, 0.0]\n"
            }
            _ => "",
        };
        read(
            "case.title",
            &format!("{shape}start.shape = \"{word}\"\ncase.title"),
        );
    }
    for word in words(&["trend", "q", "expect"]) {
        read("expect = \"rises\"", &format!("expect = \"{word}\""));
    }
}

#[test]
fn rows_list_given_and_defaulted_fields_with_their_standing() {
    let text = include_str!("../../cases/pendulous/manifold.toml");
    let rows = kind::rows::<Case>(text);
    let row = |path: &str| {
        rows.iter()
            .find(|row| row.path == path)
            .unwrap_or_else(|| panic!("no row {path}"))
    };

    let drag = row("payload.drag_area_m2");
    assert_eq!(
        (drag.value.as_str(), drag.unit, drag.given),
        ("[87.0, 87.0, 124.0]", "m²", true)
    );
    assert_eq!(
        drag.standing.as_ref().unwrap().status,
        Provenance::Calibrated
    );
    let most = row("solver.max_iterations");
    assert_eq!(
        (most.value.as_str(), most.given, most.absent),
        ("30", false, None)
    );
    let step = row("solver.time_step_s");
    assert_eq!(
        (step.value.as_str(), step.absent),
        ("", Some("chosen by the solver"))
    );
    assert_eq!(row("line.polyester.length_m").group, "section polyester");
    assert_eq!(row("ends.b.name").group, "end B (payload)");
    assert_eq!(row("solver.method").value, "alpha");
    assert_eq!(row("payload.shape.length_m").value, "16.0");
    assert!(
        rows.iter()
            .all(|row| row.path != "payload.shape.sphere_diameter_m")
    );

    let mut groups: Vec<&str> = rows.iter().map(|row| row.group.as_str()).collect();
    groups.dedup();
    assert_eq!(
        groups,
        [
            "environment",
            "current",
            "material chain",
            "material polyester",
            "material wire",
            "section chain",
            "section polyester",
            "section wire",
            "end A (vessel)",
            "end B (payload)",
            "payload",
            "floats on wire",
            "start",
            "solver",
            "output"
        ]
    );
}

#[test]
fn every_row_with_a_value_can_be_set_to_it_again() {
    let text = include_str!("../../cases/pendulous/module.toml");
    let case = case::parse(text, "module").unwrap();
    for row in kind::rows::<Case>(text)
        .into_iter()
        .filter(|row| !row.value.is_empty())
    {
        let edited =
            case::edit::set(text, &row.path, &row.value).unwrap_or_else(|fault| panic!("{fault}"));
        let again = case::parse(&edited, &row.path).unwrap();
        assert_eq!(again, case, "{}", row.path);
        if row.given {
            assert_eq!(edited, text, "{}", row.path);
        }
    }
}

#[test]
fn help_is_written_for_every_field() {
    for field in CASE.fields.iter() {
        assert!(field.help.ends_with('.'), "{}", field.path);
        assert!(
            !field.label.is_empty() && field.help.len() < 130,
            "{}",
            field.path
        );
    }
    assert!(CASE.tables.iter().all(|table| table.help.ends_with('.')));
}

#[test]
fn a_path_finds_its_field() {
    let field = field_at(&["line", "polyester", "length_m"]).unwrap();
    assert_eq!(field.path, "line.*.length_m");
    assert_eq!(field.stem(), "length");
    assert!(field_at(&["line", "polyester"]).is_none());
    assert!(field_at(&["line", "a", "b", "length_m"]).is_none());
}

#[test]
fn a_coordinate_is_a_number_in_the_range_of_its_position() {
    let field = field_at(&["ends", "b", "position_m", "y"]).unwrap();
    let whole = field_at(&["ends", "b", "position_m"]).unwrap();
    assert!(field.takes_number() && !whole.takes_number());
    assert_eq!((field.range, field.unit), (whole.range, whole.unit));
    assert!(field_at(&["ends", "b", "position_m", "w"]).is_none());
}

/// The schemas of all kinds of file.
fn all() -> [&'static Schema; 4] {
    use seacable::{ropeway, section, ship};
    [&CASE, &section::SECTION, &ropeway::ROPEWAY, &ship::SHIP]
}

#[test]
fn every_unit_stands_in_its_key() {
    for field in all().iter().flat_map(|schema| schema.fields.iter()) {
        match unit_suffix(field.unit) {
            Some(suffix) => assert!(field.key().ends_with(suffix), "{}", field.path),
            None => assert!(matches!(field.unit, "" | "-"), "{}", field.path),
        }
    }
}

#[test]
fn every_field_stands_in_a_known_table() {
    for (schema, field) in all()
        .iter()
        .flat_map(|s| s.fields.iter().map(move |f| (s, f)))
    {
        let known = schema
            .tables
            .iter()
            .any(|table| field.table() == table.pattern());
        assert!(known, "{}", field.path);
    }
}
