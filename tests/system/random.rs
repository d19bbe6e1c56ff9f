//! A sample of random systems; `seacable study systems` solves more.

use seacable::study::random_systems::{KINDS, run};

/// Solved exactly or refused with a reason, never wrong by more than rounding; few are refused.
#[test]
fn random_systems_are_solved_exactly_or_refused() {
    let outcomes = run(KINDS.len() * 60, 20_261_123);
    let mut refused = 0;
    for (index, outcome) in outcomes.iter().enumerate() {
        match &outcome.result {
            Ok(rest) => assert!(
                rest.is_exact(),
                "system {index}, {}: {rest:?}",
                KINDS[outcome.kind]
            ),
            Err(reason) => {
                assert!(!reason.is_empty());
                refused += 1;
            }
        }
    }
    // Some cannot be solved: points that lines pull out of the water, platforms that turn over.
    assert!(
        refused * 10 < outcomes.len(),
        "{refused} of {} refused",
        outcomes.len()
    );
}
