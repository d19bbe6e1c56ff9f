//! Trials of hard cases of a line, computed as they are and as those of their systems.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use seacable::case::shipped;
use seacable::import::line_case;
use seacable::study::TrialVerdict;
use seacable::study::hard_cases::{self, HardCase};

/// The hard cases of a line, each with its system.
fn hard_lines() -> Vec<[HardCase; 2]> {
    let files = shipped::SHIPPED.iter();
    let both = files.filter_map(|(name, text)| {
        let line = HardCase::read(text, name).unwrap();
        if line.trials.is_empty() {
            return None;
        }
        let path = format!("{}/cases/{name}", env!("CARGO_MANIFEST_DIR"));
        let system = line_case::read(text, Path::new(&path)).unwrap().text;
        Some([line, HardCase::read(&system, name).unwrap()])
    });
    both.collect()
}

/// The outcomes of all trials by their names.
fn outcomes(hard: &HardCase) -> BTreeMap<String, TrialVerdict> {
    let cases = std::slice::from_ref(hard);
    let never = AtomicBool::new(false);
    let computed = hard_cases::compute_all(cases, &never, &|_, _| {});
    let verdicts = hard_cases::verdicts(cases, &computed);
    verdicts
        .into_iter()
        .map(|of| (of.trial.clone(), of))
        .collect()
}

/// Trials whose outcome is another for the system, in words, and how many of what there are: those of the line, those of the system.
fn compared(hard: &[[HardCase; 2]]) -> (Vec<String>, [usize; 2]) {
    let mut apart = Vec::new();
    let mut count = [0, 0];
    let found: Vec<[_; 2]> = hard
        .par_iter()
        .map(|both| [&both[0], &both[1]].map(outcomes))
        .collect();
    for [line, system] in &found {
        count[0] += line.len();
        count[1] += system.len();
        for (name, own) in system {
            let other = &line[name];
            if own.outcome != other.outcome {
                let words = |of: &TrialVerdict| format!("{} {:?}", of.outcome.word(), of.reason);
                apart.push(format!(
                    "{}, {name}: {} as a line, {}",
                    own.file,
                    words(other),
                    words(own)
                ));
            }
        }
    }
    (apart, count)
}

/// Trials that come out otherwise: of a line that friction alone holds, whose system comes to no equilibrium, and one whose refusal names the
/// section of a segment.
fn is_apart(trial: &str) -> bool {
    trial.starts_with("hard/stick_slip.toml, ")
        || trial.starts_with("hard/ten_km.toml, rk4, steps of 0.002 s")
}

/// All of them: `cargo test --test parity every_trial -- --ignored --nocapture`.
#[test]
#[ignore = "the next test has a sample of the same"]
fn every_trial_of_a_line_comes_out_alike_as_a_system() {
    let (apart, [all, carried]) = compared(&hard_lines());
    println!("{carried} of {all} trials are those of systems, too");
    let apart: Vec<&String> = apart.iter().filter(|trial| !is_apart(trial)).collect();
    assert!(apart.is_empty(), "{apart:#?}");
}

/// Of quick ones, at rest and in time, with a shape, a current, a bed and waves.
#[test]
fn trials_of_quick_lines_come_out_alike_as_those_of_systems() {
    let quick = [
        "vertical",
        "crest",
        "slack",
        "falling",
        "coincident",
        "taut",
        "buoyant",
    ];
    let names = quick.map(|name| format!("hard/{name}.toml"));
    let mut hard = hard_lines();
    let trials = |hard: &[[HardCase; 2]], of: usize| {
        hard.iter().map(|both| both[of].trials.len()).sum::<usize>()
    };
    assert_eq!([0, 1].map(|of| trials(&hard, of)), [165, 155]);
    hard.retain(|both| names.contains(&both[0].file));
    let (apart, [all, carried]) = compared(&hard);
    assert!(apart.is_empty(), "{apart:#?}");
    assert!(carried >= 20 && carried <= all, "{carried} of {all}");
}

/// A trial sets the keys of the system, and what is computed moves by them.
#[test]
fn a_trial_sets_the_keys_of_the_system() {
    let hard = hard_lines();
    let named = |file: &str| hard.iter().find(|both| both[0].file == file).unwrap();
    let set = |file: &str, name: &str| {
        let [_, system] = named(file);
        let trial = system.trials.iter().find(|trial| trial.name == name);
        trial.unwrap().set.clone().unwrap()
    };
    let stiff = set("hard/taut.toml", "statics, EA 1e13 N");
    assert!(
        stiff.contains(&"materials.wire.ea_n=1e13".to_owned()),
        "{stiff:?}"
    );
    let mirrored = set("hard/frames.toml", "static, mirrored");
    let place = "points.b.position_m=[-75.85397659, 0.0, 43.12495602]";
    assert!(mirrored.contains(&place.to_owned()), "{mirrored:?}");
}
