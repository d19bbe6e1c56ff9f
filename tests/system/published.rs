//! Shipped systems, at rest and in motion, against the values and curves that they state.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use seacable::case::shipped::SYSTEMS;
use seacable::reference::Outcome;
use seacable::system::motion::run::run;
use seacable::system::results_in_time::has_published_in_time;
use seacable::system::validation::rows;

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
