//! `seacable study effects`: what matters.

use std::sync::atomic::AtomicBool;

use assert_cmd::Command;
use assert_cmd::assert::Assert;
use predicates::{prelude::*, str::contains};
use seacable::case::QuantityId;
use seacable::study::effects;
use seacable::study::points::BaseCase;

use crate::small::SMALL;

const TENSION: &str = "tension_n[vessel|rope].final";

/// A body hanging at rest: its tension at the top is the weight of body and rope in water.
fn hanging() -> String {
    let at_rest = SMALL.split("[start]").next().unwrap();
    let marks = "[marks]\n\"payload.wet_mass_kg\" = { status = \"assumed\", reason = \"weighed\", tolerance_abs = 100.0 }\n";
    format!("{at_rest}[solver]\nmethod = \"static\"\n{marks}")
}

/// What a study of a case prints.
fn study(text: &str, words: &[&str]) -> Assert {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("small.toml"), text).unwrap();
    let mut command = Command::cargo_bin("seacable").unwrap();
    command.current_dir(dir.path()).env("NO_COLOR", "1");
    command
        .args(["study", words[0], "small.toml"])
        .args(&words[1..]);
    command.assert()
}

fn printed(study: Assert) -> String {
    String::from_utf8(study.success().get_output().stdout.clone()).unwrap()
}

/// The tension at the top is `g (wet mass + wet weight x length)`: its changes are known.
#[test]
fn effects_at_rest_are_those_of_the_closed_form() {
    let base = BaseCase::new(&hanging(), "small.toml");
    let found = effects::compute(&base, &AtomicBool::new(false), &|_| {}).unwrap();
    let id: QuantityId = TENSION.parse().unwrap();
    let ranked = found.ranked(&id).unwrap();
    let of = |path: &str| {
        ranked
            .iter()
            .find(|effect| effect.input.path == path)
            .unwrap()
    };
    let g = 9.80665;
    let close = |found: Option<f64>, exact: f64| {
        assert!(
            (found.unwrap() - exact).abs() < 1e-6 * exact.abs().max(1.0),
            "{found:?} {exact}"
        );
    };
    // The stated 100 kg, not 10 %.
    let body = of("payload.wet_mass_kg");
    close(body.changes[0], -100.0 * g);
    close(body.changes[1], 100.0 * g);
    assert_eq!(ranked[0].input.path, "payload.wet_mass_kg");
    // Sinking volume of the rope: diameter 0.05 m, up and down by 10 %.
    let area = |d: f64| std::f64::consts::PI / 4.0 * d * d;
    let buoyancy = |d: f64| 1025.0 * 20.0 * g * (area(0.05) - area(d));
    close(of("materials.rope.diameter_m").changes[0], buoyancy(0.045));
    close(of("materials.rope.diameter_m").changes[1], buoyancy(0.055));
    // Drag at rest in still water is nothing.
    assert!(of("payload.drag_area_m2").size() < 1e-6);
    assert!(
        found
            .skipped
            .iter()
            .any(|input| input.path == "line.rope.segments")
    );
}

#[test]
fn the_tornado_is_drawn_ranked_and_exported() {
    let words = ["effects", "--result", TENSION, "--ascii"];
    let text = printed(study(&hanging(), &words));
    for word in [
        "[1] payload.wet_mass_kg",
        "|",
        "-------",
        "+++++++",
        "Not varied: ",
        "a count or a seed",
        "stated",
        "Cost: ",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    assert!(
        text.is_ascii() && text.lines().all(|line| line.len() <= 80),
        "{text}"
    );
    let csv = printed(study(&hanging(), &["effects", "--csv"]));
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let sizes = rows.iter().map(|row| {
        let size = |column: usize| row[column].parse::<f64>().map_or(0.0, f64::abs);
        size(13).max(size(14))
    });
    assert!(
        sizes
            .collect::<Vec<f64>>()
            .windows(2)
            .all(|pair| pair[0] >= pair[1]),
        "{csv}"
    );
    let wrong = study(&hanging(), &["effects", "--result", "tension_n.mx"]).code(2);
    wrong.stderr(contains("did you mean `tension_n.max`"));
}

#[test]
fn a_case_that_fails_gives_its_reason() {
    let failing = SMALL.replace("[solver]", "[solver]\nmethod = \"rk4\"\ntime_step_s = 1.0");
    let name = "effects";
    let found = study(&failing, &[name]).code(2).stdout("");
    found.stderr(contains("stability limit").and(contains("small.toml")));
    let base = BaseCase::new(SMALL, "small.toml");
    let cancel = AtomicBool::new(true);
    assert!(effects::compute(&base, &cancel, &|_| {}).is_err());
}
