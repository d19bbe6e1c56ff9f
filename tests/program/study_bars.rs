//! `seacable laboratory bars --varied`: variants of cases in the place of the cases.

use assert_cmd::Command;

fn bars(words: &[&str]) -> (bool, String) {
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(env!("CARGO_MANIFEST_DIR"));
    let output = command
        .args(["laboratory", "bars"])
        .args(words)
        .output()
        .unwrap();
    let text = [output.stdout, output.stderr].concat();
    (output.status.success(), String::from_utf8(text).unwrap())
}

#[test]
fn the_same_seed_gives_the_same_variants() {
    let case = "cases/basics/mooring_static.toml";
    let of_seed = |seed| bars(&[case, "--varied", "2", "--seed", seed]);
    let (done, text) = of_seed("3");
    assert!(done, "{text}");
    for row in ["variant 1", "variant 2", "all"] {
        assert!(text.contains(row), "{text}");
    }
    assert_eq!(of_seed("3").1, text);
    assert_ne!(of_seed("4").1, text);
}

#[test]
fn a_seed_without_variants_and_no_variants_are_refused() {
    for words in [&["--seed", "3"][..], &["--varied", "0"]] {
        let (done, text) = bars(words);
        assert!(!done && text.contains("--varied"), "{text}");
    }
}

#[test]
fn every_result_has_a_row_with_its_bar() {
    let case = "cases/basics/mooring_static.toml";
    let (done, text) = bars(&[case, "--results", "--json"]);
    assert!(done, "{text}");
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    let rows = json["rows"].as_array().unwrap();
    let (_, total) = bars(&[case]);
    assert!(total.contains(&format!(" {} ", rows.len())), "{total}");
    for row in rows {
        // At rest the mesh alone has an error.
        assert_eq!(row["bar"], row["by mesh"], "{row}");
        assert_eq!(row["by time step"], "-", "{row}");
        let [bar, error] = ["bar", "error"].map(|key| row[key].as_f64().unwrap());
        assert_eq!(row["inside"] == "yes", error <= bar, "{row}");
    }
}
