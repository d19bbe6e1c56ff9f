//! `seacable laboratory systems`: random systems of lines, each solved or refused.

use std::process::ExitCode;

use super::args::SystemsArgs;
use super::random_refusals::frequent;
use super::{invariants, random_motion, refined_systems};
use crate::{BAD_RESULT, CommandError, output};
use seacable_display::table::{NumberFormat, Table};
use seacable_report::run_json;
use seacable_studies::laboratory::random_systems::{KINDS, RandomOutcome, RandomRest, run};

/// What came of a kind.
struct RandomTally {
    name: &'static str,
    solved: Vec<RandomRest>,
    refused: Vec<String>,
    longest_s: f64,
}

pub(crate) fn systems(args: &SystemsArgs) -> Result<ExitCode, CommandError> {
    if args.invariants {
        return invariants::systems(args);
    }
    if args.in_motion {
        return random_motion::systems(args);
    }
    if let Some(by) = args.refined {
        return refined_systems::systems(args, by as usize);
    }
    let outcomes = run(args.count as usize, args.seed);
    let tallies: Vec<RandomTally> = (0..KINDS.len())
        .map(|kind| tally(kind, &outcomes))
        .collect();
    let count = |many: usize| many as f64;
    let worst = |kind: &RandomTally| {
        kind.solved
            .iter()
            .map(|rest| rest.residual)
            .fold(0.0, f64::max)
    };
    let table = Table::of_records("Random systems at rest", &tallies)
        .text("kind", |kind| kind.name)
        .number("solved", NumberFormat::Digits(6, ""), |kind| {
            count(kind.solved.len())
        })
        .number("refused", NumberFormat::Digits(6, ""), |kind| {
            count(kind.refused.len())
        })
        .number("inexact", NumberFormat::Digits(6, ""), |kind| {
            count(inexact(kind))
        })
        .number("greatest residual", NumberFormat::Digits(2, ""), worst)
        .number("steps, greatest", NumberFormat::Digits(6, ""), |kind| {
            count(kind.solved.iter().map(|rest| rest.steps).max().unwrap_or(0))
        })
        .number("longest", NumberFormat::Digits(3, "s"), |kind| {
            kind.longest_s
        })
        .build();
    if args.json {
        output::object(&run_json::study("systems", &table))?;
        return Ok(status(&tallies));
    }
    let mut text = table.to_text(110);
    text.push_str("\nReasons:\n");
    let reasons = tallies.iter().flat_map(|kind| &kind.refused);
    for (reason, many) in frequent(reasons.map(String::as_str)) {
        text.push_str(&format!("{many:6}  {reason}\n"));
    }
    if args.list {
        for (index, outcome) in outcomes.iter().enumerate() {
            if let Err(reason) = &outcome.result {
                text.push_str(&format!("{index}: {}: {reason}\n", KINDS[outcome.kind]));
            }
        }
    }
    output::results(&text, args.ascii)?;
    Ok(status(&tallies))
}

fn status(tallies: &[RandomTally]) -> ExitCode {
    match tallies.iter().any(|kind| inexact(kind) > 0) {
        true => ExitCode::from(BAD_RESULT),
        false => ExitCode::SUCCESS,
    }
}

fn inexact(kind: &RandomTally) -> usize {
    kind.solved.iter().filter(|rest| !rest.is_exact()).count()
}

fn tally(kind: usize, outcomes: &[RandomOutcome]) -> RandomTally {
    let mut tally = RandomTally {
        name: KINDS[kind],
        solved: Vec::new(),
        refused: Vec::new(),
        longest_s: 0.0,
    };
    for outcome in outcomes.iter().filter(|outcome| outcome.kind == kind) {
        tally.longest_s = tally.longest_s.max(outcome.time.as_secs_f64());
        match &outcome.result {
            Ok(rest) => tally.solved.push(*rest),
            Err(reason) => tally.refused.push(reason.clone()),
        }
    }
    tally
}
