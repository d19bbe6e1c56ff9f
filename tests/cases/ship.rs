//! A ship at single-point mooring: every heading in balance, its words, and no panic whatever is asked.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use assert_cmd::Command;
use predicates::{prelude::*, str::contains};
use proptest::prelude::*;
use seacable::case::{FieldRow, kind};
use seacable::chart::Glyphs;
use seacable::physics::sea::DEGREES;
use seacable::reference::Outcome;
use seacable::report::ship::report;
use seacable::ropeway::winch::{WinchState, statistics};
use seacable::ship::quantities::quantity;
use seacable::ship::yaw_equilibria::YawStability;
use seacable::ship::{DynamicAnalysis, MotionAnalysis, Ship, StaticAnalysis, validation};

const TEXT: &str = include_str!("../../cases/ship/anchored.toml");

/// The fields of a text.
fn fields(text: &str) -> Vec<FieldRow> {
    kind::rows::<Ship>(text)
}

fn shipped() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/ship/anchored.toml")
}

fn rest(text: &str) -> StaticAnalysis {
    kind::parse::<Ship>(text, "ship.toml")
        .map_err(|faults| faults[0].to_string())
        .unwrap()
}

fn set(text: &str, key: &str, value: &str) -> String {
    kind::set::<Ship>(text, key, value)
        .map_err(|faults| faults[0].to_string())
        .unwrap()
}

#[test]
fn the_anchored_ship_points_into_what_acts_and_lies_downstream_of_its_anchor() {
    let rest = rest(TEXT);
    let equilibrium = rest.governing().unwrap();
    assert_eq!(equilibrium.yaw.stability, YawStability::Stable);
    // The force at the mooring pulls the bow ahead, nearly along the ship.
    let ahead = (equilibrium.yaw.force_direction - equilibrium.yaw.heading).cos();
    assert!(ahead < -0.9, "{ahead}");
    let [bow, centre] = equilibrium.positions(rest.loads.arm).unwrap();
    assert!(centre.0.hypot(centre.1) > bow.0.hypot(bow.1));
    // The line pulls back as much as the loads push.
    let line = equilibrium.line.as_ref().unwrap().as_ref().unwrap();
    let level = line.tension * line.angle.cos();
    assert!((level / equilibrium.yaw.pull - 1.0).abs() < 1e-8);
}

#[test]
fn a_turn_of_everything_turns_the_headings() {
    let one = rest(TEXT);
    let mut turned = TEXT.to_owned();
    for (key, value) in [("wind", 40.0), ("current", 0.0), ("drift", 40.0)] {
        turned = set(
            &turned,
            &format!("{key}.towards_deg"),
            &format!("{:?}", value + 77.0),
        );
    }
    let other = rest(&turned);
    let (one, other) = (one.equilibria.unwrap(), other.equilibria.unwrap());
    assert_eq!(one.len(), other.len());
    for a in &one {
        let same = other.iter().any(|b| {
            let apart = b.yaw.heading - a.yaw.heading - 77.0_f64.to_radians();
            (apart.sin().abs() < 1e-10) && apart.cos() > 0.0 && a.yaw.stability == b.yaw.stability
        });
        assert!(same, "{a:?}");
    }
}

#[test]
fn straight_lines_and_spline_agree_at_the_points_and_differ_between() {
    let linear = set(TEXT, "wind.interpolation", "linear");
    let (cubic, linear) = (rest(TEXT), rest(&linear));
    let at = |rest: &StaticAnalysis, angle: f64| {
        let wind = &rest.loads.each[0];
        wind.at(wind.towards - angle.to_radians()).0
    };
    for angle in [0.0, 30.0, 60.0, 90.0, 210.0, 330.0] {
        let (a, b) = (at(&cubic, angle), at(&linear, angle));
        for i in 0..3 {
            assert!((a[i] - b[i]).abs() < 1e-9 * cubic.loads.each[0].reference[i]);
        }
    }
    assert!((at(&cubic, 45.0)[1] - at(&linear, 45.0)[1]).abs() > 1.0);
    // Mirrored to the other side.
    assert!((at(&cubic, 50.0)[1] + at(&cubic, -50.0)[1]).abs() < 1e-9);
    assert!((at(&cubic, 50.0)[0] - at(&cubic, -50.0)[0]).abs() < 1e-9);
}

#[test]
fn impossible_values_are_reported_with_their_key() {
    let reported = |text: &str| {
        let faults = kind::parse::<Ship>(text, "ship.toml").unwrap_err();
        let lines: Vec<String> = faults.iter().map(ToString::to_string).collect();
        lines.join("\n")
    };
    let changed = |from: &str, to: &str| {
        assert!(TEXT.contains(from), "{from}");
        reported(&TEXT.replacen(from, to, 1))
    };
    for (from, to, says) in [
        (
            "draft_m = 1.955",
            "draft_m = -1",
            "ship.draft_m: is out of range",
        ),
        ("draft_m = 1.955", "draft = 1", "draft_m"),
        (
            "30.0, 60.0",
            "60.0, 30.0",
            "wind.angle_deg: does not ascend from 60 to 30 degrees",
        ),
        (
            "150.0, 180.0]",
            "150.0, 170.0]",
            "wind.angle_deg: ends at 170 degrees",
        ),
        (
            "[0.0, 30.0",
            "[10.0, 30.0",
            "wind.angle_deg: begins at 10 degrees",
        ),
        (
            "0.45, 0.0]",
            "0.45]",
            "wind.sway: holds 6 numbers for 7 angles",
        ),
        (
            "0.45, 0.0]",
            "0.45, 0.2]",
            "wind.sway: must be zero at 0 and 180 degrees",
        ),
        (
            "[drift]",
            "[drift]\nsurge = [1.0]",
            "drift.surge_cosines: is a series, and there is a table too",
        ),
        (
            "\"ship.length_m\" =",
            "\"ship.lenght_m\" =",
            "there is no key `ship.lenght_m` in this ship; did you mean `ship.length_m`?",
        ),
        (
            "yaw_sines = [0.0, -0.06]",
            "yaw_sines = [nan]",
            "current.yaw_sines: must be a finite number",
        ),
    ] {
        let lines = changed(from, to);
        assert!(lines.contains(says), "{says}\n{lines}");
        assert!(lines.starts_with("ship.toml:"), "{lines}");
    }
    let bare = "[ship]\ntitle = \"x\"\nlength_m = 50.0\ndraft_m = 2.0\n";
    assert!(reported(bare).contains("no load acts on the ship"));
    assert!(
        reported(&format!(
            "{bare}[current]\nspeed_m_per_s = 1.0\ntowards_deg = 0.0\n"
        ))
        .contains("current: has no coefficients")
    );
    assert!(reported("[case]\ntitle = \"x\"\n").contains("this is a line case, not a ship"));
    assert!(reported("").contains("it holds no ship"));
}

#[test]
fn errors_of_single_keys_and_between_keys_are_reported_at_once() {
    let text = TEXT
        .replacen("draft_m = 1.955", "draft_m = -1", 1)
        .replacen("[0.0, 30.0", "[10.0, 30.0", 1)
        .replacen("\"ship.length_m\" =", "\"ship.lenght_m\" =", 1);
    let errors = kind::parse::<Ship>(&text, "ship.toml").unwrap_err();
    let keys: Vec<&str> = errors.iter().map(|error| error.key.as_str()).collect();
    let marks = "marks.\"ship.lenght_m\"";
    assert_eq!(keys, ["ship.draft_m", "wind.angle_deg", marks]);
    for (error, word) in errors.iter().zip(["-1", "[10.0", "\"ship.lenght_m\""]) {
        let line = text.lines().nth(error.line as usize - 1).unwrap();
        assert_eq!(line.find(word), Some(error.column as usize - 1), "{error}");
    }
}

#[test]
fn no_heading_in_balance_is_said() {
    let text = "[ship]\ntitle = \"wheel\"\nlength_m = 50.0\ndraft_m = 2.0\n[current]\nspeed_m_per_s = 1.0\ntowards_deg = 0.0\nangle_deg = [0.0, 120.0, 240.0]\nsurge = [0.1, 0.1, 0.1]\nsway = [0.0, 0.0, 0.0]\nyaw = [0.2, 0.1, 0.3]\n";
    let rest = rest(text);
    assert!(rest.equilibria.is_err());
    let page = report(&rest, None, &fields(text)).to_text(80, Glyphs::Ascii);
    assert!(page.contains("never vanishes"), "{page}");
}

#[test]
fn the_command_prints_the_page_and_refuses_what_is_wrong() {
    let seacable = || Command::cargo_bin("seacable").unwrap();
    seacable()
        .args(["ship", "--ascii", "--set", "wind.speed_m_per_s=12"])
        .arg(shipped())
        .assert()
        .success()
        .stdout(contains("Equilibrium headings").and(contains("stable")));
    seacable()
        .args(["ship", "--set", "wind.speed_m_per_s=-1"])
        .arg(shipped())
        .assert()
        .code(2)
        .stderr(contains("out of range"));
    seacable()
        .arg("run")
        .arg(shipped())
        .assert()
        .code(2)
        .stderr(contains("seacable ship"));
}

fn motion(text: &str) -> MotionAnalysis {
    MotionAnalysis::of_statics(&rest(text), Path::new(""))
        .unwrap()
        .unwrap()
}

/// A ship at sea, its file standing in this folder.
fn at_sea(text: &str, folder: &Path) -> DynamicAnalysis {
    DynamicAnalysis::new(&rest(text), folder, &AtomicBool::new(false)).unwrap()
}

#[test]
fn the_record_has_the_printed_root_mean_squares_of_tables_2_to_4() {
    let asked = [
        (
            "displacement",
            [0.44091, 0.00841, 0.04797, 0.00653, 0.49998, 0.00287],
        ),
        (
            "velocity",
            [0.08906, 0.00052, 0.06232, 0.00499, 0.66631, 0.0002],
        ),
        (
            "acceleration",
            [0.11537, 0.00041, 0.08809, 0.00395, 1.04121, 0.00004],
        ),
    ];
    for seed in ["2", "77"] {
        let motion = motion(&set(TEXT, "motion.seed", seed));
        for (rate, values) in asked {
            for (degree, value) in DEGREES.iter().zip(values) {
                // The printed displacements are read as about the mean.
                let statistic = if rate == "displacement" {
                    "deviation"
                } else {
                    "rms"
                };
                let name = format!("{degree}.{rate}.{statistic}");
                let made = quantity(&motion, &name).unwrap();
                assert!((made / value - 1.0).abs() < 0.01, "{name}: {made} {value}");
            }
        }
        for degree in DEGREES {
            let of = |statistic: &str| quantity(&motion, &format!("{degree}.velocity.{statistic}"));
            assert!(of("mean").unwrap().abs() < 1e-6 * of("rms").unwrap());
        }
    }
}

#[test]
fn records_are_the_same_by_seed_for_any_number_of_threads() {
    let with = |threads: usize, seed: &str| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let text = set(TEXT, "motion.seed", seed);
        pool.install(|| motion(&text).records)
    };
    let one = with(1, "5");
    assert!(one == with(4, "5"));
    assert!(one != with(4, "6"));
}

#[test]
fn the_record_is_gaussian_in_its_waves_and_its_rates_belong_together() {
    let motion = motion(&set(TEXT, "motion.duration_s", "10800.0"));
    // Heave: 2237 waves, so skewness and excess scatter by about 0.05 and 0.1.
    let heave = &motion.statistics[2][0];
    assert!(
        heave.skewness.abs() < 0.15 && heave.excess.abs() < 0.3,
        "{heave:?}"
    );
    // Crossings by Rice's formula, from the moments.
    let period = std::f64::consts::TAU * heave.deviation / motion.statistics[2][1].deviation;
    assert!((10_800.0 / period / heave.crossings as f64 - 1.0).abs() < 0.03);
    for record in &motion.records {
        let h = motion.motion.step;
        let scale = record.a.iter().fold(0.0_f64, |m, a| m.max(a.abs()));
        for i in (1..4000).step_by(97) {
            let slope = (record.x[i + 1] - 2.0 * record.x[i] + record.x[i - 1]) / (h * h);
            assert!((slope - record.a[i]).abs() < 0.05 * scale);
        }
    }
}

#[test]
fn every_printed_statistic_has_a_row_and_none_fails() {
    let rows = validation::rows(&rest(TEXT).ship, Some(&Ok(motion(TEXT))));
    assert_eq!(rows.len(), 72);
    for row in &rows {
        let fine = matches!(row.outcome, Outcome::Pass | Outcome::Differs);
        assert!(fine, "{}: {:?} {:?}", row.name, row.published, row.computed);
    }
    let differ: Vec<&str> = rows
        .iter()
        .filter(|row| row.outcome == Outcome::Differs)
        .map(|row| row.name.as_str())
        .collect();
    assert_eq!(
        differ,
        ["surge, acceleration, mean", "heave, acceleration, mean"]
    );
}

#[test]
fn the_rope_follows_the_ship_and_the_winch_keeps_its_tension_while_it_can() {
    let folder = shipped().parent().unwrap().to_owned();
    let at = |text: String| at_sea(&text, &folder).rope.unwrap().unwrap();
    let short = set(
        &set(TEXT, "motion.duration_s", "1200.0"),
        "rope.records",
        "4",
    );
    let ahead = at(short.clone());
    let fast = statistics(ahead.winch.made_fast.as_ref().unwrap(), |s| s.ship_n);
    let kept = ahead
        .winch
        .constant_tension
        .as_ref()
        .unwrap()
        .as_ref()
        .unwrap();
    assert!(statistics(kept, |s| s.ship_n).deviation < 1e-2 * fast.deviation);
    assert_eq!(ahead.maxima_n.len(), 4);
    assert!((ahead.maxima_n[0] / fast.max - 1.0).abs() < 1e-12);
    // The record of another seed, followed in full, has the same greatest tension.
    let other = at(set(&short, "motion.seed", "2"));
    assert!((other.maxima_n[0] / ahead.maxima_n[1] - 1.0).abs() < 1e-9);
    let gumbel = ahead.gumbel.unwrap();
    assert!(gumbel.greatest.spread > 0.0 && gumbel.quantile(0.9) > gumbel.greatest.expected);
    // Conclusion 2 of the paper: with the side to the platform surge and pitch hardly matter.
    let abeam = at(set(&short, "rope.bearing_deg", "90.0"));
    let aside = statistics(abeam.winch.made_fast.as_ref().unwrap(), |s| s.ship_n);
    assert!(
        aside.deviation < 0.2 * fast.deviation,
        "{} {}",
        aside.deviation,
        fast.deviation
    );
    // A ropeway that is not there is said, and does not stop the rest.
    let lost = set(&short, "rope.ropeway", "\"nowhere.toml\"");
    let lost = at_sea(&lost, &folder).rope.unwrap();
    assert!(lost.unwrap_err().contains("no such file"));
}

#[test]
fn a_winch_out_of_its_depth_is_said() {
    let dir = tempfile::tempdir().unwrap();
    let slow = include_str!("../../cases/ropeway/constant_tension.toml").replace(
        "[winch]\nspeed_m_per_s = 0.5",
        "[winch]\nspeed_m_per_s = 0.02",
    );
    std::fs::write(dir.path().join("slow.toml"), slow).unwrap();
    let text = set(
        &set(TEXT, "motion.duration_s", "600.0"),
        "rope.ropeway",
        "\"slow.toml\"",
    );
    let sea = at_sea(&text, dir.path());
    let rope = sea.rope.as_ref().unwrap().as_ref().unwrap();
    let kept = rope
        .winch
        .constant_tension
        .as_ref()
        .unwrap()
        .as_ref()
        .unwrap();
    assert!(kept.iter().any(|s| s.state == WinchState::SpeedLimit));
    let page = report(&rest(&text), Some(&sea), &fields(&text)).to_text(80, Glyphs::Ascii);
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        page.contains("WARNING: the winch is at its maximum speed"),
        "{page}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever acts: no panic, every heading balances, and stable and unstable ones follow each other in turn.
    #[test]
    fn headings_balance_and_alternate(
        wind in 0.0..40.0f64,
        current in 0.0..3.0f64,
        waves in 0.0..5.0f64,
        towards in prop::array::uniform3(-360.0..360.0f64),
        linear: bool,
        sines in prop::collection::vec(-1.0..1.0f64, 1..6),
    ) {
        let still = TEXT[..TEXT.find("[motion]").unwrap()].to_owned();
        let mut text = set(&still, "wind.speed_m_per_s", &format!("{wind:?}"));
        text = set(&text, "current.speed_m_per_s", &format!("{current:?}"));
        text = set(&text, "drift.significant_height_m", &format!("{waves:?}"));
        text = set(&text, "drift.sway_sines", &format!("{sines:?}"));
        for (table, towards) in ["wind", "current", "drift"].iter().zip(towards) {
            text = set(&text, &format!("{table}.towards_deg"), &format!("{towards:?}"));
        }
        if linear {
            text = set(&text, "wind.interpolation", "linear");
        }
        let rest = rest(&text);
        let size = rest.loads.moment_bound();
        if let Ok(equilibria) = &rest.equilibria {
            let mut turns = 0;
            for one in equilibria {
                let (moment, _) = rest.loads.moment(one.yaw.heading);
                prop_assert!(moment.abs() <= 1e-9 * size.max(1e-300), "{one:?}");
                prop_assert!(one.yaw.pull.is_finite());
                turns += match one.yaw.stability {
                    YawStability::Stable => 1,
                    YawStability::Unstable => -1,
                    _ => 0,
                };
            }
            prop_assert_eq!(turns, 0, "{:?}", equilibria);
        }
        let page = report(&rest, None, &fields(&text)).to_text(80, Glyphs::Braille);
        prop_assert!(!page.contains("NaN"));
    }
}
