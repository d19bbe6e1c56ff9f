//! The ropeway: its paper's tables, files that are wrong, answers at the limits, and no NaN.

use std::path::Path;
use std::process::{Command, Output};

use proptest::prelude::*;
use seacable::case::kind::{self, parse};
use seacable::case::shipped::ROPEWAYS;
use seacable::chart::Glyphs;
use seacable::reference::{Outcome, count_outcomes};
use seacable::report::ropeway::report;
use seacable::ropeway::elastic::Carrier;
use seacable::ropeway::winch::{ShipOffset, WinchState, simulate, statistics};
use seacable::ropeway::{Ropeway, RopewayError, SolvedRopeway, line, validation};

const SPAN_80: &str = include_str!("../../cases/ropeway/span_80.toml");
const TENSION: &str = include_str!("../../cases/ropeway/constant_tension.toml");

fn with(text: &str, edits: &[(&str, &str)]) -> SolvedRopeway {
    parse::<Ropeway>(&kind::set_all::<Ropeway>(text, edits).unwrap(), "edited").unwrap()
}

fn refused(text: &str, key: &str, value: &str) -> String {
    let all = kind::set::<Ropeway>(text, key, value).unwrap_err();
    let words: Vec<String> = all.iter().map(ToString::to_string).collect();
    words.join("\n")
}

fn seacable(words: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.current_dir(root).args(words).output().unwrap()
}

#[test]
fn the_tables_of_the_paper_hold_and_its_misprints_are_reported() {
    let expected = [("40", 10, 2), ("60", 12, 0), ("80", 15, 2)];
    for (span, pass, differs) in expected {
        let path = format!("ropeway/span_{span}.toml");
        let (_, text) = ROPEWAYS.iter().find(|known| known.0 == path).unwrap();
        let rows = validation::rows(&parse::<Ropeway>(text, &path).unwrap(), text);
        let count = count_outcomes(&rows);
        assert_eq!((count.pass, count.differs), (pass, differs), "{path}");
        assert_eq!((count.fail, count.not_run), (0, 0), "{path}");
        // Theory within 1e-4 or the printed digits; what ANSYS printed within 0.15 %.
        for row in rows.iter().filter(|row| row.published.is_some()) {
            let (Some(value), Some(tolerance)) = (row.published, row.tolerance) else {
                continue;
            };
            let theory = row.source.starts_with("table 5");
            let most = if theory { 5e-3 } else { 2e-3 } * value.abs();
            let difference = row.name.contains("less theory");
            assert!(difference || tolerance <= most, "{path}: {}", row.name);
        }
        let misprint = rows.iter().find(|row| row.name == "ANSYS tension").unwrap();
        let message = misprint.reason.as_deref().unwrap_or_default();
        assert_eq!(misprint.outcome == Outcome::Differs, span == "40");
        assert_eq!(message.contains("1157.20 N"), span == "40");
    }
}

#[test]
fn the_discretised_line_comes_to_the_exact_rope() {
    let off = |segments: &str| {
        let worked = with(
            SPAN_80,
            &[
                ("ropeway.segments", segments),
                ("ship.height_m", "9.0"),
                ("cargo.position", "0.3"),
            ],
        );
        let results = worked.results(0.3).unwrap();
        let line = results.line.unwrap();
        (line.ship_n - results.exact.ship_n()).abs() / results.exact.ship_n()
    };
    let (coarse, fine) = (off("40"), off("80"));
    assert!(fine < 1e-4, "{fine}");
    assert!((coarse / fine).log2() > 1.8, "{coarse} {fine}");
}

#[test]
fn the_line_case_is_one_that_runs_anywhere() {
    let worked = parse::<Ropeway>(SPAN_80, "span").unwrap();
    let rest = worked.equilibrium(0.5).unwrap();
    let text = line::static_case_file(&worked.ropeway, rest.length_m, rest.arc_m);
    let case = seacable::case::parse(&text, "line").unwrap();
    let built = line::static_case(&worked.ropeway, rest.length_m, rest.arc_m);
    assert_eq!(case, built);
    assert_eq!(case.clumps.len(), 1);
    assert_eq!(case.line.len(), 2);
}

#[test]
fn a_rope_set_by_tension_keeps_it_wherever_the_cargo_hangs() {
    let worked = parse::<Ropeway>(TENSION, "tension").unwrap();
    for position in [0.0, 0.01, 0.37, 0.9, 1.0] {
        let rest = worked.equilibrium(position).unwrap();
        assert!((rest.ship_n() / 6000.0 - 1.0).abs() < 1e-9, "{position}");
    }
}

#[test]
fn a_winch_without_limits_keeps_the_tension_and_one_with_limits_reports_it() {
    let free = with(
        TENSION,
        &[("winch.speed_m_per_s", "50.0"), ("winch.power_w", "1e6")],
    );
    let series = free.ship_motion().unwrap();
    let kept = free
        .run_winch(&series)
        .unwrap()
        .constant_tension
        .unwrap()
        .unwrap();
    let tension = statistics(&kept, |m| m.ship_n);
    assert!((tension.max - 6000.0).abs() < 1e-4 && (tension.min - 6000.0).abs() < 1e-4);
    // The rope that is paid out is what the ship goes off, all but for sag: the rope is taut.
    let rope = statistics(&kept, |m| m.length_m);
    assert!(
        (rope.max - rope.min - 2.0 * 1.22453).abs() < 0.06,
        "{rope:?}"
    );
    let slow = with(TENSION, &[("winch.speed_m_per_s", "0.05")]);
    let kept = slow
        .run_winch(&series)
        .unwrap()
        .constant_tension
        .unwrap()
        .unwrap();
    assert!(kept.iter().any(|m| m.state == WinchState::SpeedLimit));
    assert!(statistics(&kept, |m| m.speed_m_per_s.abs()).max < 0.05 + 1e-9);
    assert!(statistics(&kept, |m| m.ship_n).max > 6100.0);
    let weak = with(TENSION, &[("winch.power_w", "100.0")]);
    let kept = weak
        .run_winch(&series)
        .unwrap()
        .constant_tension
        .unwrap()
        .unwrap();
    assert!(kept.iter().any(|m| m.state == WinchState::PowerLimit));
}

#[test]
fn a_ship_beyond_reach_is_an_error() {
    let worked = with(TENSION, &[("rope.carrier.length_m", "81.0")]);
    let series = worked.ship_motion().unwrap();
    let kept = worked
        .run_winch(&series)
        .unwrap()
        .constant_tension
        .unwrap()
        .unwrap();
    assert!(kept.iter().any(|m| m.state == WinchState::RopeOut));
    assert!(statistics(&kept, |m| m.length_m).max < 81.0 + 1e-9);
    let away = [ShipOffset {
        time_s: 7.0,
        x_m: 20.0,
        z_m: 0.0,
    }];
    let start = worked.equilibrium(0.5).unwrap();
    let message = simulate(&worked.rope, &start, None, &away).unwrap_err();
    assert!(
        matches!(message, RopewayError::BeyondReach { .. }),
        "{message}"
    );
}

#[test]
fn edges_have_answers_or_clear_errors() {
    assert!(refused(SPAN_80, "ropeway.span_m", "0").contains("out of range"));
    assert!(refused(TENSION, "setting.tension_n", "500").contains("the least is 1666.6 N"));
    assert!(
        refused(SPAN_80, "rope.carrier.length_m", "70").contains("of the shortest there is 70 m")
    );
    assert!(
        refused(SPAN_80, "setting.by", "length")
            .contains("is missing: the rope is set by its length")
    );
    assert!(refused(SPAN_80, "ship.height_m", "900").contains("steeper"));
    let at_support = with(SPAN_80, &[("cargo.position", "1.0")]);
    let results = at_support.results(1.0).unwrap();
    assert_eq!(results.exact.carrier, Carrier::Ship);
    assert!(results.line.is_err() && results.exact.sag_m.abs() < 1e-9);
    // A slack rope still has its answer; the cargo is then deep in the water, with a warning.
    let slack = with(
        SPAN_80,
        &[("setting.length_m", "99.0"), ("setting.by", "length")],
    );
    let results = slack.results(0.5).unwrap();
    assert!(results.exact.sag_m > 20.0);
    let message = seacable::report::ropeway::tables::warnings(&slack, &results).join(" ");
    assert!(message.contains("cargo is in the water"), "{message}");
    // So short that it must stretch: exact, though the paper's model, which cannot stretch, has none.
    let tight = with(
        SPAN_80,
        &[("setting.length_m", "79.9"), ("setting.by", "length")],
    );
    assert!(matches!(
        tight.inextensible,
        Err(RopewayError::TooShort { .. })
    ));
    assert!(tight.results(0.5).unwrap().exact.ship_n() > 2e4);
    let shorter = kind::set_all::<Ropeway>(
        SPAN_80,
        &[("setting.length_m", "70.0"), ("setting.by", "length")],
    );
    assert!(
        shorter.unwrap_err()[0]
            .problem
            .contains("stretch by more than 5 %")
    );
}

#[test]
fn errors_of_a_file_have_their_place() {
    let wrong = SPAN_80.replace(
        "quantity = \"model.horizontal_n\"",
        "quantity = \"model.horizontl_n\"",
    );
    let message = parse::<Ropeway>(&wrong, "a.toml").unwrap_err();
    assert!(
        message[0]
            .to_string()
            .contains("did you mean \"model.horizontal_n\"?"),
        "{}",
        message[0]
    );
    let wrong = SPAN_80.replace("[marks.\"cargo.position\"]", "[marks.\"cargo.place\"]");
    assert!(
        parse::<Ropeway>(&wrong, "a.toml").unwrap_err()[0]
            .problem
            .contains("no key `cargo.place`")
    );
    let wrong = SPAN_80.replace("span_m = 80.0", "span = 80.0");
    let message = parse::<Ropeway>(&wrong, "a.toml").unwrap_err();
    assert!(
        message[0].line > 1 && message[0].to_string().contains("span_m"),
        "{}",
        message[0]
    );
}

#[test]
fn errors_of_single_keys_and_between_keys_are_reported_at_once() {
    let text = SPAN_80
        .replacen("model.horizontal_n", "model.horizontl_n", 1)
        .replacen("span_m = 80.0", "span_m = -80.0", 1)
        .replacen("sag_m", "length_m", 1);
    let errors = parse::<Ropeway>(&text, "a.toml").unwrap_err();
    let of = |key: &str| {
        let error = errors.iter().find(|error| error.key == key);
        error.unwrap_or_else(|| panic!("{key}: {errors:?}"))
    };
    assert!(of("ropeway.span_m").problem.contains("out of range"));
    let setting = of("setting.sag_m");
    assert!(setting.problem.contains("the rope is set by its sag"));
    let line = text.lines().nth(setting.line as usize - 1).unwrap();
    assert_eq!(line, "[setting]");
    let quantity = errors.iter().find(|error| error.key.ends_with("quantity"));
    assert!(quantity.unwrap().remedy.contains("model.horizontal_n"));
}

#[test]
fn every_key_is_listed_and_one_value_changes_without_the_rest() {
    let rows = kind::rows::<Ropeway>(SPAN_80);
    let mark = |path: &str| {
        rows.iter()
            .find(|r| r.path == path)
            .unwrap()
            .standing
            .is_some()
    };
    assert!(mark("cargo.position") && !mark("cargo.mass_kg"));
    let edited = kind::set::<Ropeway>(SPAN_80, "cargo.position", "0.25").unwrap();
    assert_eq!(edited, SPAN_80.replace("position = 0.5", "position = 0.25"));
}

#[test]
fn the_command_line_reports_validates_and_points_the_way() {
    let report = seacable(&[
        "ropeway",
        "cases/ropeway/span_60.toml",
        "--ascii",
        "--set",
        "cargo.position=0.3",
    ]);
    let words = String::from_utf8(report.stdout).unwrap();
    assert!(report.status.success() && words.is_ascii());
    for part in [
        "30.0 % of the span",
        "inextensible",
        "Hauling",
        "winch",
        "eq. 12",
        "assumed",
    ] {
        assert!(words.contains(part), "{part}");
    }
    assert!(words.lines().all(|line| line.len() <= 80));
    let run = seacable(&["run", "cases/ropeway/span_60.toml"]);
    assert_eq!(run.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&run.stderr).contains("`seacable ropeway` works it out"));
    let held = seacable(&["validate", "cases/ropeway"]);
    assert!(held.status.success());
    assert!(
        String::from_utf8_lossy(&held.stdout)
            .contains("51 rows: 47 PASS, 0 FAIL, 4 DIFFERS, 0 NOT RUN")
    );
    let bad = seacable(&[
        "ropeway",
        "cases/ropeway/span_60.toml",
        "--set",
        "cargo.position=2",
    ]);
    assert_eq!(bad.status.code(), Some(2));
    let dir = tempfile::tempdir().unwrap();
    let line = dir.path().join("line.toml");
    let line = line.to_str().unwrap();
    assert!(
        seacable(&["ropeway", "cases/ropeway/span_60.toml", "--line", line])
            .status
            .success()
    );
    assert_eq!(
        seacable(&["ropeway", "cases/ropeway/span_60.toml", "--line", line])
            .status
            .code(),
        Some(2)
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn whatever_a_file_says_there_is_an_answer_or_a_reason(
        span in 1.0..3000.0_f64,
        sag in 1e-3..1.0_f64,
        rise in -20.0..20.0_f64,
        mass in 0.0..5000.0_f64,
        position in 0.0..1.0_f64,
        by in 0..2_usize,
    ) {
        let by = ["bare-sag", "loaded-sag"][by];
        let number = |value: f64| format!("{value:?}");
        let edits = [
            ("ropeway.span_m", number(span)),
            ("setting.sag_m", number(sag * span)),
            ("setting.by", by.to_owned()),
            ("platform.height_m", number(20.0)),
            ("ship.height_m", number(20.0 + rise)),
            ("cargo.mass_kg", number(mass)),
            ("cargo.position", number(position)),
            ("rope.carrier.length_m", number(9e3)),
            ("rope.hauling.length_m", number(9e3)),
            ("rope.return.length_m", number(9e3)),
            ("ropeway.segments", "12".to_owned()),
            ("dynamics.duration_s", "10.0".to_owned()),
        ];
        let edits: Vec<(&str, &str)> = edits.iter().map(|(k, v)| (*k, v.as_str())).collect();
        if let Ok(edited) = kind::set_all::<Ropeway>(SPAN_80, &edits) {
            let worked = parse::<Ropeway>(&edited, "random").unwrap();
            if let Ok(results) = worked.results(position) {
                let exact = &results.exact;
                for number in [exact.ship_n(), exact.platform_n(), exact.sag_m, exact.length_m] {
                    prop_assert!(number.is_finite());
                }
                let held = exact.solution.v_b_n - exact.solution.v_a_n;
                let on_rope = if exact.carrier == Carrier::Rope { worked.rope.cargo_n } else { 0.0 };
                let weight = worked.rope.weight_n_per_m * exact.length_m + on_rope;
                prop_assert!((held - weight).abs() < 1e-6 * weight.max(exact.ship_n()));
                let report = report(&worked, &results, &kind::rows::<Ropeway>(&edited)).to_text(80, Glyphs::Ascii);
                prop_assert!(!report.contains("NaN"));
            }
        }
    }
}
