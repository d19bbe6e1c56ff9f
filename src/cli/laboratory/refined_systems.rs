//! `seacable laboratory systems --refined`: random systems with divided lines, their stated errors held against a finer mesh.

use std::process::ExitCode;

use super::args::SystemsArgs;
use super::random_refusals::frequent;
use crate::{CommandError, output};
use seacable_display::table::{NumberFormat, Table};
use seacable_report::run_json;
use seacable_studies::laboratory::random_systems::divided::DIVIDED_KINDS;
use seacable_studies::laboratory::random_systems::refined::{
    RefinedSystem, RefinedTally, run, tally,
};

/// What came of a kind, or of all.
struct KindTally {
    name: &'static str,
    tally: RefinedTally,
}

pub(super) fn systems(args: &SystemsArgs, by: usize) -> Result<ExitCode, CommandError> {
    let systems = run(args.count as usize, args.seed, by);
    let kinds = DIVIDED_KINDS.iter().enumerate();
    let of_kind = |kind| systems.iter().filter(move |system| system.kind == kind);
    let each = kinds.map(|(kind, name)| KindTally {
        name,
        tally: tally(of_kind(kind)),
    });
    let all = KindTally {
        name: "all",
        tally: tally(systems.iter()),
    };
    let rows: Vec<KindTally> = each.chain([all]).collect();
    const WHOLE: NumberFormat = NumberFormat::Digits(6, "");
    let table = Table::of_records("Stated errors at rest against a finer mesh", &rows)
        .text("kind", |row| row.name)
        .number("refused", WHOLE, |row| row.tally.refused as f64)
        .number("systems", WHOLE, |row| row.tally.systems as f64)
        .number("all hold", NumberFormat::Percent, |row| {
            row.tally.systems_that_hold
        })
        .number("values", WHOLE, |row| row.tally.values as f64)
        .number("hold", NumberFormat::Percent, |row| {
            row.tally.values_that_hold
        })
        .number("bar by error", NumberFormat::Digits(3, ""), |row| {
            row.tally.median_ratio
        })
        .number("over ten times", NumberFormat::Percent, |row| {
            row.tally.too_wide
        })
        .build();
    if args.json {
        output::object(&run_json::study("systems", &table))?;
        return Ok(ExitCode::SUCCESS);
    }
    let mut text = table.to_text(110);
    text.push_str("\nReasons:\n");
    let reasons = systems
        .iter()
        .filter_map(|system| system.values.as_ref().err());
    for (reason, many) in frequent(reasons.map(String::as_str)) {
        text.push_str(&format!("{many:6}  {reason}\n"));
    }
    if args.list {
        systems.iter().for_each(|system| list(system, &mut text));
    }
    output::results(&text, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}

/// Lists what is refused and the values outside their errors.
fn list(system: &RefinedSystem, text: &mut String) {
    let head = format!("{}: {}: ", system.index, DIVIDED_KINDS[system.kind]);
    match &system.values {
        Err(reason) => text.push_str(&format!("{head}{reason}\n")),
        Ok(values) => {
            for value in values.iter().filter(|value| !value.holds()) {
                text.push_str(&format!(
                    "{head}{} {:?}, stated {:?}, on the finer mesh {:?}\n",
                    value.name, value.value, value.stated, value.refined
                ));
            }
        }
    }
}
