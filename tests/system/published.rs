//! Shipped systems in motion against the curves that they state.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use seacable::case::shipped::SYSTEMS;
use seacable::reference::Outcome;
use seacable::system::motion::run::run;
use seacable::system::validation::rows;

use crate::solved;

#[test]
fn shipped_systems_in_motion_come_within_their_published_curves() {
    let stated: Vec<_> = SYSTEMS
        .par_iter()
        .filter(|(_, text)| text.contains("[[published_curve]]"))
        .map(|(path, text)| {
            let solved = solved(&text.replace("[solver]", "[solver]\nerror_estimate = false"));
            let given = solved.file.solver.clone().unwrap();
            let run = run(&solved, &given, &AtomicBool::new(false), &mut |_| {}).unwrap();
            (*path, rows(&solved, Some(&run)))
        })
        .collect();
    assert!(stated.len() >= 10, "{}", stated.len());
    for (path, rows) in stated {
        for row in rows {
            let ok = matches!(row.outcome, Outcome::Pass | Outcome::Differs);
            assert!(ok, "{path}: {row:#?}");
        }
    }
}
