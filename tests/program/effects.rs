//! `seacable study effects` and `seacable study physics`: what matters, and what is needed.

use std::sync::atomic::{AtomicBool, Ordering};

use assert_cmd::Command;
use assert_cmd::assert::Assert;
use predicates::{prelude::*, str::contains};
use seacable::case::{Case, QuantityId};
use seacable::study::effects;
use seacable::study::physics;
use seacable::study::points::BaseCase;
use seacable::system::SystemFile;

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
    let found = effects::compute::<Case>(&base, &AtomicBool::new(false), &|_| {}).unwrap();
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

/// In motion, drag and inertia matter to a body that swings down; bending, waves and a bed are not there.
#[test]
fn what_is_not_needed_is_within_the_errors() {
    let base = BaseCase::new(SMALL, "small.toml");
    let study = physics::compute::<Case>(&base, &AtomicBool::new(false), &|_| {}).unwrap();
    let id: QuantityId = "tension_n[rope|payload].mean".parse().unwrap();
    let matters = |name: &str| {
        let variant = study
            .variants
            .iter()
            .find(|variant| variant.part.name == name);
        study.omission(variant.unwrap(), &id).unwrap().matters
    };
    assert_eq!(matters("drag of bodies"), Some(true));
    assert_eq!(matters("inertia"), Some(true));
    assert_eq!(matters("mesh halved"), Some(false));
    assert!(study.variants.iter().all(|variant| variant.run().is_ok()));
    assert_eq!(
        study.absent,
        [
            "drag along the line",
            "bending stiffness",
            "mass damping",
            "dynamic stiffness",
            "creep",
            "bed friction",
            "bed damping",
            "current",
            "waves",
            "water surface",
            "motion of the ends",
            "rotation of the payload"
        ]
    );
}

/// Without its dynamic stiffness a rope has no channel of it, and the case no published value of that channel; the rest is computed.
#[test]
fn channels_that_go_with_an_effect_take_their_published_values_along() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/cases/mooring/hybrid_fixed.toml"
    );
    let base = BaseCase::new(&std::fs::read_to_string(path).unwrap(), path);
    let study = physics::compute::<Case>(&base, &AtomicBool::new(false), &|_| {}).unwrap();
    let variants = || study.variants.iter();
    assert!(variants().all(|variant| variant.run().is_ok()));
    let variant = variants()
        .find(|variant| variant.part.name == "dynamic stiffness")
        .unwrap();
    let of = |name: &str| study.omission(variant, &name.parse().unwrap());
    assert!(of("tension_n.max").is_some());
    assert!(of("stiffness_k[polyester.a].final").is_none());
}

#[test]
fn physics_prints_changes_costs_and_reasons() {
    let text = printed(study(
        SMALL,
        &["physics", "--ascii", "--result", "tension_n.max"],
    ));
    for word in [
        "drag of bodies: matters",
        "R1 tension_n.max",
        "Not in this case: ",
        "Cannot be left out: weight",
        "axial stiffness x 10",
        "steps",
        "+/-",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    assert!(text.lines().all(|line| line.len() <= 80), "{text}");
    let csv = printed(study(
        SMALL,
        &["physics", "--csv", "--result", "tension_n.max"],
    ));
    assert!(
        csv.starts_with(
            "left out,how,result,unit,base,base_error,value,change,matters,cpu_s,steps,reason\n"
        ),
        "{csv}"
    );
}

#[test]
fn a_case_that_fails_gives_its_reason() {
    let failing = SMALL.replace("[solver]", "[solver]\nmethod = \"rk4\"\ntime_step_s = 1.0");
    for name in ["effects", "physics"] {
        let found = study(&failing, &[name]).code(2).stdout("");
        found.stderr(contains("stability limit").and(contains("small.toml")));
    }
    let base = BaseCase::new(SMALL, "small.toml");
    let cancel = AtomicBool::new(true);
    assert!(effects::compute::<Case>(&base, &cancel, &|_| {}).is_err());
    cancel.store(false, Ordering::Relaxed);
    let some = physics::compute::<Case>(&base, &cancel, &|_| cancel.store(true, Ordering::Relaxed))
        .unwrap();
    assert!(
        some.variants
            .iter()
            .any(|variant| variant.outcome.is_none())
    );
}

/// A body on a line of two parts, let go beside the place where it hangs at rest; the drag of the line acts on it.
const SWUNG: &str = r#"
[system]
title = "a body on a line"
[materials.rope]
mass_kg_per_m = 5.0
diameter_m = 0.02
ea_n = 1e7
drag_normal = 1.2
[points.top]
kind = "fixed"
position_m = [0.0, 0.0, -10.0]
[points.body]
kind = "free"
mass_kg = 500.0
volume_m3 = 0.1
start_offset_m = [4.0, 0.0, 0.41]
[[lines]]
name = "rope"
from = "top"
to = "body"
material = "rope"
length_m = 20.0
segments = 16
[solver]
duration_s = 6.0
"#;

/// At rest the tension at the top is `g (M - rho V + (m - rho A) L)`.
#[test]
fn effects_on_a_system_are_those_of_the_closed_form() {
    let base = BaseCase::new(
        &SWUNG.replace("[4.0, 0.0, 0.41]", "[0.0, 0.0, 0.0]"),
        "swung.toml",
    );
    let found = effects::compute::<SystemFile>(&base, &AtomicBool::new(false), &|_| {}).unwrap();
    let ranked = found
        .ranked(&"tension_n[rope|a].final".parse().unwrap())
        .unwrap();
    let change = |path: &str| {
        let effect = ranked.iter().find(|effect| effect.input.path == path);
        effect.unwrap().changes[1].unwrap()
    };
    let g = 9.80665;
    for (path, exact) in [
        ("points.body.mass_kg", g * 50.0),
        ("points.body.volume_m3", -g * 1025.0 * 0.01),
        ("materials.rope.mass_kg_per_m", g * 0.5 * 20.0),
    ] {
        let change = change(path);
        assert!(
            (change / exact - 1.0).abs() < 1e-3,
            "{path}: {change} {exact}"
        );
    }
}

#[test]
fn what_a_system_needs_is_told() {
    let base = BaseCase::new(SWUNG, "swung.toml");
    let study = physics::compute::<SystemFile>(&base, &AtomicBool::new(false), &|_| {}).unwrap();
    let id: QuantityId = "tension_n[rope|b].max".parse().unwrap();
    let of = |name: &str| {
        let mut all = study.variants.iter();
        let variant = all.find(|variant| variant.part.name == name).unwrap();
        assert!(variant.run().is_ok(), "{name}: {:?}", variant.run());
        study.omission(variant, &id).unwrap().matters
    };
    assert_eq!(of("inertia"), Some(true));
    assert_eq!(of("mesh doubled"), Some(false));
    assert!(study.absent.contains(&"waves") && study.absent.contains(&"drag of bodies"));

    let text = printed(self::study(SWUNG, &["physics", "--ascii"]));
    for word in [
        "R1 tension_n[rope|a].max",
        "drag of the line",
        "Not in this case: ",
    ] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
    let at_rest = SWUNG.split("[solver]").next().unwrap();
    let text = printed(self::study(at_rest, &["physics", "--ascii"]));
    assert!(text.contains("R1 tension_n[rope|"), "{text}");
    self::study(at_rest, &["steps"])
        .code(2)
        .stderr(contains("no steps to compare"));
    self::study(SWUNG, &["effects", "--result", "tension_n[rope|a].mx"])
        .code(2)
        .stderr(contains("did you mean `tension_n[rope|a].max`"));
}
