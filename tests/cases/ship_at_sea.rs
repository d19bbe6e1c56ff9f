//! A ship that answers a sea by its responses, and with its anchor line in time: spectra, orders, closed forms, and what
//! cannot be.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use assert_cmd::Command;
use predicates::{prelude::*, str::contains};
use seacable::case::kind;
use seacable::report::ship::report;
use seacable::ship::coupled::{CHANNELS, CoupledAnalysis};
use seacable::ship::stability::DynamicStability;
use seacable::ship::{DynamicAnalysis, MotionAnalysis, MotionError, Ship, StaticAnalysis};

const TEXT: &str = include_str!("../../cases/ship/coupled.toml");
const RESPONSES: &str = include_str!("../../cases/ship/landing_craft.csv");

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/ship")
}

fn with(edits: &[(&str, &str)]) -> String {
    kind::set_all::<Ship>(TEXT, edits)
        .map_err(|faults| faults[0].to_string())
        .unwrap()
}

fn rest(text: &str) -> StaticAnalysis {
    kind::parse::<Ship>(text, "ship.toml")
        .map_err(|faults| faults[0].to_string())
        .unwrap()
}

fn motion(text: &str) -> Result<MotionAnalysis, MotionError> {
    MotionAnalysis::of_statics(&rest(text), &folder()).unwrap()
}

fn coupled(edits: &[(&str, &str)]) -> CoupledAnalysis {
    let rest = rest(&with(edits));
    let motion = MotionAnalysis::of_statics(&rest, &folder())
        .unwrap()
        .unwrap();
    CoupledAnalysis::new(&rest, Some(&motion), &AtomicBool::new(false)).unwrap()
}

#[test]
fn the_sea_and_its_answers_have_the_moments_of_their_spectra() {
    let motion = motion(TEXT).unwrap();
    let waves = motion.waves.as_ref().unwrap();
    assert!((waves.target.significant_height() - 1.0).abs() < 1e-12);
    assert!((waves.realised.significant_height() - 1.0).abs() < 0.02);
    let period = waves.realised.crossing_period() / waves.target.crossing_period();
    assert!((period - 1.0).abs() < 0.02, "{period}");
    for (degree, made) in motion.motion.degrees.iter().zip(&motion.statistics) {
        let off = made[0].deviation / degree.target.displacement - 1.0;
        assert!(off.abs() < 0.03, "{off}");
        assert!(made[1].mean.abs() < 1e-2 * made[1].rms);
    }
    // The same by seed, another by another.
    let again = self::motion(TEXT).unwrap();
    assert!(again.records == motion.records);
    let other = self::motion(&with(&[("motion.seed", "2")])).unwrap();
    assert!(other.records != motion.records);
}

#[test]
fn waves_from_the_other_side_mirror_the_motion() {
    // Turned to the same angle on the other side: sway, roll and yaw change their sign, the others stay.
    let one = motion(&with(&[
        ("motion.heading_deg", "0.0"),
        ("motion.waves_towards_deg", "150.0"),
    ]));
    let other = motion(&with(&[
        ("motion.heading_deg", "0.0"),
        ("motion.waves_towards_deg", "-150.0"),
    ]));
    let (one, other) = (one.unwrap(), other.unwrap());
    for degree in 0..6 {
        let sign = if matches!(degree, 1 | 3 | 5) {
            -1.0
        } else {
            1.0
        };
        let scale = one.statistics[degree][0].deviation;
        let pairs = one.records[degree].x.iter().zip(&other.records[degree].x);
        for (a, b) in pairs.step_by(997) {
            assert!((a - sign * b).abs() < 1e-9 * scale.max(1e-12));
        }
    }
}

#[test]
fn heave_of_the_coupled_ship_is_its_answer_to_the_sea() {
    // Line, wind and current hardly touch heave: in time it must be the sum of the responses.
    let made = coupled(&[
        ("coupled.duration_s", "240.0"),
        ("coupled.from_s", "120.0"),
        ("coupled.step_s", "0.05"),
    ]);
    let motion = motion(TEXT).unwrap();
    let (mut apart, mut all) = (0.0, 0.0);
    for (i, heave) in made.records[2].iter().enumerate().skip(2400) {
        let t = made.step * i as f64;
        let components = &motion.motion.degrees[2].components;
        let answer: f64 = components.iter().map(|c| c.at(t)).sum();
        apart += (heave - answer).powi(2);
        all += answer * answer;
    }
    assert!((apart / all).sqrt() < 0.02, "{}", (apart / all).sqrt());
}

/// A ship let go turned from its heading, without waves.
const LET_GO: [(&str, &str); 4] = [
    ("motion.significant_height_m", "0.0"),
    ("coupled.start_yaw_deg", "2.0"),
    ("coupled.duration_s", "60.0"),
    ("coupled.from_s", "5.0"),
];

#[test]
fn the_error_of_the_step_falls_with_its_square() {
    let errors = |step: &str| {
        let made = coupled(&[&LET_GO[..], &[("coupled.step_s", step)]].concat());
        made.time_errors.unwrap()
    };
    let (long, short) = (errors("1.0"), errors("0.5"));
    for channel in [1, 5] {
        let order = (long[channel] / short[channel]).log2();
        assert!(
            (1.7..2.5).contains(&order),
            "{}: {order}",
            CHANNELS[channel].0
        );
    }
}

#[test]
fn the_error_of_the_mesh_falls_with_the_segments() {
    let errors = |segments: &str| {
        let made = coupled(&[&LET_GO[..], &[("coupled.segments", segments)]].concat());
        made.mesh_errors.unwrap()
    };
    // Where the line touches down moves over whole segments, so that the order is measured over a range of them.
    let (coarse, fine) = (errors("20"), errors("160"));
    for channel in [0, 9] {
        let order = (coarse[channel] / fine[channel]).log2() / 3.0;
        assert!(order > 1.0, "{}: {order}", CHANNELS[channel].0);
    }
}

#[test]
fn released_it_swings_with_the_period_of_the_linearised_equations() {
    let made = coupled(&[&LET_GO[..], &[("coupled.segments", "160")]].concat());
    let decay = made.decay.unwrap();
    assert!(
        (decay.measured_s / decay.linear_s - 1.0).abs() < 0.02,
        "{decay:?}"
    );
    assert!(
        (decay.measured_ratio - decay.linear_ratio).abs() < 0.1,
        "{decay:?}"
    );
}

#[test]
fn the_same_ship_in_time_is_the_same_for_any_number_of_threads() {
    let edits = [("coupled.duration_s", "20.0"), ("coupled.from_s", "5.0")];
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| coupled(&edits))
    };
    assert!(with(1) == with(3));
}

#[test]
fn a_ship_at_rest_without_waves_stays_and_its_rope_follows() {
    let text = with(&[
        ("motion.significant_height_m", "0.0"),
        ("coupled.duration_s", "40.0"),
        ("coupled.from_s", "20.0"),
        ("coupled.segments", "160"),
    ]);
    let sea = DynamicAnalysis::new(&rest(&text), &folder(), &AtomicBool::new(false)).unwrap();
    let made = sea.coupled.unwrap().unwrap();
    // Off its place by no more than the mesh error of the pull.
    assert!(
        made.statistics[0].max.abs() < 0.02,
        "{:?}",
        made.statistics[0]
    );
    assert!(made.statistics[3].rms < 1e-3);
    let rope = sea.rope.unwrap().unwrap();
    assert!(rope.gumbel.is_none() && rope.winch.made_fast.is_ok());
    let page = report(&rest(&text), None, &kind::rows::<Ship>(&text));
    let page = page.to_text(80, seacable::chart::Glyphs::Ascii);
    assert!(page.contains("dynamic analysis is still running"));
}

#[test]
fn stopped_in_time_it_gives_no_answer() {
    let stop = AtomicBool::new(true);
    assert!(DynamicAnalysis::new(&rest(TEXT), &folder(), &stop).is_none());
}

#[test]
fn damping_decides_whether_the_ship_fishtails() {
    let dynamic_stability =
        |text: &str| rest(text).governing().unwrap().dynamic_stability().unwrap();
    assert!(matches!(
        dynamic_stability(TEXT),
        DynamicStability::Stable { .. }
    ));
    // Without its own damping in yaw, and moored near its middle, it swings further and further or turns away.
    let bare = with(&[
        ("hull.damping_si", "[0.0, 0.0, 8.0e5, 1.8e6, 1.5e8, 0.0]"),
        (
            "hull.added_mass_si",
            "[3.0e4, 4.5e5, 1.4e6, 1.5e6, 2.3e8, 6.0e8]",
        ),
    ]);
    let (own, bare) = (dynamic_stability(TEXT), dynamic_stability(&bare));
    let growth = |dynamic_stability: DynamicStability| match dynamic_stability {
        DynamicStability::Stable { half_life, .. } => -1.0 / half_life,
        DynamicStability::Neutral => 0.0,
        DynamicStability::Divergence { doubling_time }
        | DynamicStability::Fishtailing { doubling_time, .. } => 1.0 / doubling_time,
    };
    assert!(growth(bare) > growth(own), "{own:?} {bare:?}");
}

#[test]
fn impossible_values_are_reported_with_their_key() {
    let reported = |edits: &[(&str, &str)]| {
        let faults = kind::set_all::<Ship>(TEXT, edits).unwrap_err();
        faults
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join("\n")
    };
    for (edits, says) in [
        (&[("hull.mass_kg", "0.0")][..], "out of range"),
        (&[("hull.added_mass_si", "[1.0, 2.0]")], "holds 2 numbers"),
        (
            &[("hull.added_mass_si", "[-6.2e5, 0.0, 0.0, 0.0, 0.0, 0.0]")],
            "not positive definite",
        ),
        (
            &[("hull.damping_si", "[-1.0e5, 0.0, 0.0, 0.0, 0.0, 0.0]")],
            "feeds energy",
        ),
        (
            &[("hull.restoring_si", "[0.0, 0.0, 3.7e6, -1.0, 7.3e8, 0.0]")],
            "sinks or capsizes",
        ),
        (&[("coupled.from_s", "5000.0")], "leaves nothing"),
        (&[("coupled.segments", "41")], "is odd"),
        (
            &[("coupled.step_s", "0.001"), ("coupled.duration_s", "1e5")],
            "gives more than",
        ),
        (&[("motion.peak_period_s", "0.0")], "out of range"),
    ] {
        let lines = reported(edits);
        assert!(lines.contains(says), "{says}\n{lines}");
    }
    let parse = |text: &str| {
        let faults = kind::parse::<Ship>(text, "ship.toml").unwrap_err();
        faults
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join("\n")
    };
    let without = |table: &str| {
        let from = TEXT.find(&format!("[{table}]")).unwrap();
        let to = TEXT[from + 1..].find("\n[").unwrap() + from + 1;
        let mut text = format!("{}{}", &TEXT[..from], &TEXT[to..]);
        let marked = |line: &&str| !line.starts_with(&format!("\"{table}."));
        text = text.lines().filter(marked).collect::<Vec<_>>().join("\n");
        text
    };
    assert!(parse(&without("hull")).contains("needs [hull]"));
    assert!(parse(&without("mooring")).contains("needs [mooring]"));
    assert!(parse(&without("coupled")).contains("needs [coupled]"));
    let stray = TEXT.replace("by = \"responses\"", "by = \"statistics\"");
    assert!(
        parse(&stray).contains("by = \"responses\""),
        "{}",
        parse(&stray)
    );
}

#[test]
fn invalid_responses_are_reported_with_file_line_and_column() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(
        dir.path().join("ship.toml"),
        TEXT.split("[rope]").next().unwrap(),
    )
    .unwrap();
    let ship = |responses: Option<String>| {
        let file = dir.path().join("landing_craft.csv");
        match responses {
            Some(text) => std::fs::write(&file, text).unwrap(),
            None => drop(std::fs::remove_file(&file)),
        }
        let mut command = Command::cargo_bin("seacable").unwrap();
        command.arg("ship").arg(dir.path().join("ship.toml"));
        command.assert().code(2)
    };
    ship(None).stderr(contains("cannot be read"));
    let changed = |from: &str, to: &str| {
        assert!(RESPONSES.contains(from), "{from}");
        Some(RESPONSES.replacen(from, to, 1))
    };
    ship(changed("0,2.5,0.0144", "0,2.5,-0.0144"))
        .stderr(contains("landing_craft.csv:6:7").and(contains("negative")));
    ship(changed("0,2.5,0.0144", "0,2.5,calm")).stderr(contains("`calm` is not a number"));
    ship(changed("roll_phase_deg", "roll_lag_deg")).stderr(contains("no column of this table"));
    let aft: Vec<&str> = RESPONSES
        .lines()
        .filter(|line| !line.starts_with("180,") && !line.starts_with("150,"))
        .collect();
    ship(Some(aft.join("\n"))).stderr(contains("deg from the bow"));
}

#[test]
fn a_coupled_ship_without_water_is_refused() {
    let dry = rest(&with(&[("ship.water_density_kg_per_m3", "0.0")]));
    let refused = CoupledAnalysis::new(&dry, None, &AtomicBool::new(false));
    let why = refused.map(|_| ()).unwrap_err().to_string();
    assert!(why.contains("no water"), "{why}");
}
