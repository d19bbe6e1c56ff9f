//! Shipped systems, at rest and in motion, against the values and curves that they state.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use seacable::case::kind;
use seacable::case::shipped::SYSTEMS;
use seacable::reference::Outcome;
use seacable::system::SystemFile;
use seacable::system::motion::run::run;
use seacable::system::results_in_time::has_published_in_time;
use seacable::system::validated::validated;
use seacable::system::validation::{rows, stated};

use crate::solved;

#[test]
fn shipped_systems_come_within_their_published_values() {
    let stated: Vec<_> = SYSTEMS
        .par_iter()
        .filter(|(_, text)| text.contains("[[published"))
        .map(|(path, text)| {
            let solved = solved(&text.replace("[solver]", "[solver]\nerror_estimate = false"));
            let in_time = solved.file.in_time();
            let in_time = in_time.filter(|_| has_published_in_time(&solved.file));
            let run = in_time
                .map(|given| run(&solved, given, &AtomicBool::new(false), &mut |_| {}).unwrap());
            (*path, rows(&solved, run.as_ref()))
        })
        .collect();
    assert!(stated.len() >= 30, "{}", stated.len());
    for (path, rows) in stated {
        for row in rows {
            let ok = matches!(row.outcome, Outcome::Pass | Outcome::Differs);
            assert!(ok, "{path}: {row:#?}");
        }
    }
}

/// A weight on a rope in air, `tension = (mass + 1.1 * 20) g` at the top, with rows along a study of the mass.
const WEIGHT: &str = r#"
[system]
title = "weight on a rope"
tolerance_reason = "by hand"
[environment]
water_density_kg_per_m3 = 0.0
gravity_m_per_s2 = 10.0
[materials.rope]
diameter_m = 0.02
mass_kg_per_m = 1.1
ea_n = 2e9
[points.top]
kind = "fixed"
position_m = [0.0, 0.0, 20.0]
[points.weight]
kind = "free"
mass_kg = 50.0
[[lines]]
name = "rope"
from = "top"
to = "weight"
material = "rope"
length_m = 20.0

[[study]]
name = "mass"
key = "points.weight.mass_kg"
values = [50.0, 200.0, 100.0]
"#;

/// The rows, each by its last word, with the value that is right.
const ROWS: [(&str, &str, f64); 5] = [
    ("here", "", 720.0),
    ("there", "at = { study = \"mass\", value = 200 }", 2220.0),
    (
        "change",
        "at = { study = \"mass\", value = 200 }\nchange_from = { study = \"mass\", value = 100 }",
        1000.0,
    ),
    (
        "ratio",
        "at = { study = \"mass\", value = 200 }\nratio_to = { study = \"mass\", value = 100 }",
        2220.0 / 1220.0,
    ),
    ("share", "divided_by = \"tension_n[rope|b]\"", 720.0 / 500.0),
];

fn with_rows(motion: &str, statistic: &str) -> String {
    let mut text = format!("{WEIGHT}{motion}");
    for (name, point, value) in ROWS {
        let point = point.replace("|b]", &format!("|b]{statistic}"));
        text.push_str(&format!(
            "[[published]]\nname = \"{name}\"\nquantity = \"tension_n[rope|a]{statistic}\"\n{point}\nvalue = {value:?}\ntolerance_rel = 1e-3\nsource = \"by hand\"\ninputs = \"published\"\n"
        ));
    }
    for expect in ["rises", "falls"] {
        text.push_str(&format!(
            "[[trend]]\nname = \"{expect}\"\nstudy = \"mass\"\nquantity = \"tension_n[rope|a]{statistic}\"\nexpect = \"{expect}\"\nsource = \"by hand\"\n"
        ));
    }
    text
}

/// Values at points of a study, changes and ratios between them, ratios of two results, and trends, at rest and in time.
#[test]
fn published_values_are_held_along_studies() {
    let motion = "[solver]\nduration_s = 1.0\nerror_estimate = false\n";
    for (motion, statistic) in [("", ""), (motion, ".mean")] {
        let text = with_rows(motion, statistic);
        let own = solved(&text);
        let points = stated(&own.file).plan();
        assert_eq!(points.len(), 4, "{points:?}");
        let all = validated(own, &text, "system.toml", &AtomicBool::new(false)).unwrap();
        let outcomes: Vec<&str> = all.iter().map(|row| row.outcome.word()).collect();
        let right = ["PASS", "PASS", "PASS", "PASS", "PASS", "PASS", "FAIL"];
        assert_eq!(outcomes, right, "{all:#?}");
        for (row, (_, _, value)) in all.iter().zip(ROWS) {
            let off = (row.computed.unwrap() - value).abs();
            assert!(off < 1e-3 * value, "{row:#?}");
        }
        // The file alone gives the rows of where it stands.
        let own = solved(&text);
        let in_time = own.file.in_time();
        let run = in_time.map(|given| run(&own, given, &AtomicBool::new(false), &mut |_| {}));
        let alone = rows(&own, run.transpose().unwrap().as_ref());
        let words: Vec<&str> = alone.iter().map(|row| row.outcome.word()).collect();
        assert_eq!(words[0], "PASS");
        assert_eq!(words[4], "PASS");
        assert!([1, 2, 3, 5, 6].iter().all(|row| words[*row] == "NOT RUN"));
    }
}

/// What names no study, no point of one or no result is refused at its key, as are two others at once.
#[test]
fn faults_of_rows_along_studies_are_at_their_keys() {
    let row = "[[published]]\nname = \"r\"\nquantity = \"tension_n[rope|a]\"\nvalue = 1.0\ntolerance_rel = 0.1\nsource = \"s\"\ninputs = \"assumed\"\n";
    let cases = [
        (format!("{row}at = {{ study = \"weight\", value = 50 }}\n"), "at.study"),
        (format!("{row}ratio_to = {{ study = \"mass\", value = 60 }}\n"), "ratio_to.value"),
        (format!("{row}divided_by = \"tension_n[rod|a]\"\n"), "divided_by"),
        (
            format!("{row}divided_by = \"tension_n[rope|b]\"\nchange_from = {{ study = \"mass\", value = 50 }}\n"),
            "ratio_to",
        ),
        (
            "[[trend]]\nname = \"t\"\nstudy = \"mass\"\nquantity = \"tension_n[rod|a]\"\nexpect = \"rises\"\nsource = \"s\"\n".to_owned(),
            "trend.t.quantity",
        ),
        (
            "[[study]]\nname = \"other\"\nkey = \"points.weight.mass\"\nvalues = [1.0, 2.0]\n".to_owned(),
            "study.other.key",
        ),
    ];
    for (more, key) in cases {
        let found = kind::read::<SystemFile>(&format!("{WEIGHT}{more}"), "system.toml");
        let found = found.map(|_| key).unwrap_err();
        let keys: Vec<&str> = found.iter().map(|fault| fault.key.as_str()).collect();
        assert!(
            keys.len() == 1 && keys[0].ends_with(key),
            "{key}: {found:?}"
        );
        assert!(found[0].line > 0);
    }
}
