//! Files with parameters: values, faults, edits.

use seacable::case::{self, Case, edit, kind};
use seacable::system::SystemFile;

const MOORING: &str = include_str!("../../../cases/systems/three_chains.toml");

/// A line case whose lengths follow from a depth.
fn case_with(parameters: &str, length: &str, segments: &str) -> String {
    let text = include_str!("../../../cases/basics/hanging_line.toml");
    let (head, rest) = text.split_once("[materials").unwrap();
    let text = format!("{head}[parameters]\n{parameters}\n[materials{rest}");
    let line = text
        .find("length_m = ")
        .filter(|at| *at > text.find("[[line]]").unwrap());
    let line = line.unwrap_or_else(|| {
        let section = text.find("[[line]]").unwrap();
        section + text[section..].find("length_m = ").unwrap()
    });
    let end = line + text[line..].find('\n').unwrap();
    let text = format!("{}length_m = {length}{}", &text[..line], &text[end..]);
    let line = text.find("segments = ").unwrap();
    let end = line + text[line..].find('\n').unwrap();
    format!("{}segments = {segments}{}", &text[..line], &text[end..])
}

fn faults(text: &str) -> Vec<String> {
    let faults = case::parse(text, "x.toml").unwrap_err();
    faults
        .iter()
        .map(|fault| format!("{}: {}. {}", fault.key, fault.problem, fault.remedy))
        .collect()
}

#[test]
fn values_follow_the_parameters() {
    let text = case_with(
        "depth_m = 100\nfactor = \"1 + 0.05\"\nlength_m = \"factor * depth_m\"",
        "\"length_m\"",
        "\"round(length_m / 5)\"",
    );
    let case = case::parse(&text, "x.toml").unwrap();
    assert!((case.line[0].length_m - 105.0).abs() < 1e-12);
    assert_eq!(case.line[0].segments, 21);
    let text = edit::set(&text, "parameters.depth_m", "120").unwrap();
    let case = case::parse(&text, "x.toml").unwrap();
    assert!((case.line[0].length_m - 126.0).abs() < 1e-12);
    assert_eq!(case.line[0].segments, 25);
}

#[test]
fn coordinates_of_a_system_follow_the_parameters() {
    let text = MOORING.replacen("[seabed]", "[parameters]\ndeep_m = 55\n\n[seabed]", 1);
    let depth = edit::get(&text, "seabed.depth_m").unwrap();
    let edited = kind::put::<SystemFile>(&text, "parameters.deep_m", &depth).unwrap();
    let edited = kind::put::<SystemFile>(&edited, "seabed.depth_m", "deep_m").unwrap();
    assert!(edited.contains("depth_m = \"deep_m\""), "{edited}");
    let rows = kind::rows::<SystemFile>(&edited);
    let row = rows
        .iter()
        .find(|row| row.path == "seabed.depth_m")
        .unwrap();
    assert_eq!(row.value, "deep_m");
    assert_eq!(row.computed.as_deref(), Some(depth.trim_end_matches(".0")));
    let row = rows
        .iter()
        .find(|row| row.path == "parameters.deep_m")
        .unwrap();
    assert_eq!((row.label.as_ref(), row.unit), ("deep", "m"));
    kind::parse::<SystemFile>(&edited, "x.toml").unwrap();
}

#[test]
fn faults_say_what_would_be_right() {
    let good = "depth_m = 100";
    for (parameters, length, segments, expected) in [
        (
            good,
            "\"1.05 * dpeth_m\"",
            "20",
            "line.rope.length_m: names `dpeth_m`, which is no parameter of this file. did you mean `depth_m`?",
        ),
        (
            good,
            "\"1.05 * * depth_m\"",
            "20",
            "is no expression that can be read",
        ),
        (good, "\"depth_m / 0\"", "20", "is inf by its expression"),
        (
            good,
            "\"depth_m\"",
            "\"depth_m / 3\"",
            "and must be whole. write round(...)",
        ),
        (good, "\"-depth_m\"", "20", "is out of range: -100 m"),
        (good, "\"-depth_m^2\"", "20", "can be read in two ways"),
        (good, "\"25 m\"", "20", "must be a number, and is text"),
        (
            "a_m = \"b_m\"\nb_m = \"2 * a_m\"",
            "20.0",
            "20",
            "depends on itself (a_m, b_m)",
        ),
        (
            "a_m = \"c_m + 1\"",
            "20.0",
            "20",
            "parameters.a_m: names `c_m`",
        ),
        ("sin = 2", "20.0", "20", "is the name of a function"),
        (
            "\"a b\" = 2",
            "20.0",
            "20",
            "cannot be named in an expression",
        ),
        (
            "a_m = true",
            "20.0",
            "20",
            "must be a number, and is true or false",
        ),
        (
            "a_m = \"ln(-1)\"",
            "20.0",
            "20",
            "parameters.a_m: is NaN by its expression",
        ),
    ] {
        let found = faults(&case_with(parameters, length, segments));
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].contains(expected), "{found:?} / {expected}");
    }
}

#[test]
fn a_file_without_parameters_takes_no_expressions() {
    let text = case_with("", "\"2 * 50\"", "20").replace("[parameters]", "");
    assert!(faults(&text)[0].contains("is not a number: 2 * 50"));
}

#[test]
fn parameters_are_set_by_name_and_never_made_by_a_slip() {
    let text = case_with("depth_m = 100", "\"depth_m\"", "20");
    let refused = edit::set(&text, "parameters.dpeth_m", "3").unwrap_err();
    assert!(
        refused.remedy.contains("did you mean `depth_m`"),
        "{refused}"
    );
    assert!(kind::field::<Case>(&text, "parameters.depth_m").is_ok());
    assert!(kind::field::<Case>(&text, "parameters.dpeth_m").is_err());
    let typed = edit::set(&text, "line.rope.length_m", "0.5 * depth_m").unwrap();
    assert_eq!(
        case::parse(&typed, "x.toml").unwrap().line[0].length_m,
        50.0
    );
    let refused = edit::set(&text, "line.rope.length_m", "0.5 * deep").unwrap_err();
    assert!(refused.problem.contains("names `deep`"), "{refused}");
    let refused = edit::unset(&text, "parameters.depth_m").unwrap_err();
    assert!(
        refused.problem.contains("which is no parameter"),
        "{refused}"
    );
}

#[test]
fn a_parameter_has_its_label_and_unit_in_its_name() {
    let text = case_with("wire_length_m = 100", "\"wire_length_m\"", "20");
    let path = "parameters.wire_length_m";
    let field = kind::field::<Case>(&text, path).unwrap();
    assert_eq!(field.in_words(path), ("wire length".to_owned(), "m"));
    let other = kind::field::<Case>(&text, "line.rope.length_m").unwrap();
    assert_eq!(other.in_words("line.rope.length_m").1, "m");
}
