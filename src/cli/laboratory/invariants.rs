//! `seacable laboratory systems --invariants`: random systems held against themselves.

use std::path::Path;
use std::process::ExitCode;

use super::args::SystemsArgs;
use super::random_refusals::frequent;
use crate::{BAD_RESULT, CommandError, output};
use seacable_base::files::{WriteTarget, disk};
use seacable_display::table::{NumberFormat, Table};
use seacable_report::run_json;
use seacable_studies::laboratory::invariants::{
    Invariant, InvariantOutcome, KINDS, VariantOutcome, file, one, run, text,
};

/// What came of an invariant over all systems.
struct Tally<'a> {
    name: &'static str,
    held: Vec<&'a VariantOutcome>,
}

impl Tally<'_> {
    fn count(&self, is: impl Fn(&VariantOutcome) -> bool) -> f64 {
        self.held.iter().filter(|held| is(held)).count() as f64
    }
}

pub(super) fn systems(args: &SystemsArgs) -> Result<ExitCode, CommandError> {
    if let Some(index) = args.show {
        let (_, file) = file(index, args.seed, args.in_motion);
        let shown = match &file {
            Ok(file) => text(file),
            Err(why) => format!("{why}\n"),
        };
        output::results(&shown, args.ascii)?;
        return Ok(ExitCode::SUCCESS);
    }
    let outcomes = match args.only {
        Some(index) => vec![one(index as usize, args.seed, args.in_motion)],
        None => run(args.count as usize, args.seed, args.in_motion),
    };
    if let Some(folder) = &args.write {
        write(folder, &outcomes, args.only.is_some())?;
    }
    let held = outcomes
        .iter()
        .any(|outcome| outcome.violations().next().is_some());
    let status = match held {
        true => ExitCode::from(BAD_RESULT),
        false => ExitCode::SUCCESS,
    };
    let table = table(&outcomes);
    if args.json {
        output::object(&run_json::study("invariants of systems", &table))?;
        return Ok(status);
    }
    let mut shown = table.to_text(110);
    let answered = outcomes.iter().filter(|outcome| outcome.refused.is_none());
    let (answered, all) = (answered.count(), outcomes.len());
    shown.push_str(&format!("\n{answered} of {all} systems have an answer.\n"));
    let refused = outcomes
        .iter()
        .filter_map(|outcome| outcome.refused.as_deref());
    shown.push_str(&reasons("Others are refused:", refused));
    let variants = outcomes.iter().flat_map(InvariantOutcome::violations);
    let variants = variants.filter_map(|(_, held, _)| match held {
        VariantOutcome::Refused(why) => Some(why.as_str()),
        _ => None,
    });
    shown.push_str(&reasons("Refused when asked for otherwise:", variants));
    if args.list || args.only.is_some() {
        for outcome in &outcomes {
            shown.push_str(&listed(outcome));
        }
    }
    output::results(&shown, args.ascii)?;
    Ok(status)
}

fn table(outcomes: &[InvariantOutcome]) -> Table {
    const COUNT: NumberFormat = NumberFormat::Digits(6, "");
    let tallies: Vec<Tally<'_>> = Invariant::ALL
        .into_iter()
        .enumerate()
        .map(|(number, invariant)| Tally {
            name: invariant.name(),
            held: outcomes
                .iter()
                .filter_map(|one| Some(&one.held.get(number)?.0))
                .collect(),
        })
        .collect();
    let greatest = |tally: &Tally<'_>| {
        let apart = tally.held.iter().map(|held| match held {
            VariantOutcome::Differs(violation) => violation.excess(),
            _ => 0.0,
        });
        apart.fold(0.0, f64::max)
    };
    Table::of_records("Random systems held against themselves", &tallies)
        .text("asked for", |tally| tally.name)
        .number("systems", COUNT, |tally| {
            tally.count(|held| *held != VariantOutcome::NotAsked)
        })
        .number("agree", COUNT, |tally| {
            tally.count(|held| matches!(held, VariantOutcome::Agrees(_)))
        })
        .number("differ", COUNT, |tally| {
            tally.count(|held| matches!(held, VariantOutcome::Differs(_)))
        })
        .number("refused", COUNT, |tally| {
            tally.count(|held| matches!(held, VariantOutcome::Refused(_)))
        })
        .number(
            "greatest difference by what is allowed",
            NumberFormat::Digits(3, ""),
            greatest,
        )
        .build()
}

/// Reasons by how often each is given.
fn reasons<'a>(title: &str, given: impl Iterator<Item = &'a str>) -> String {
    let all = frequent(given);
    if all.is_empty() {
        return String::new();
    }
    let rows = all
        .iter()
        .map(|(reason, many)| format!("{many:6}  {reason}\n"));
    format!("\n{title}\n{}", rows.collect::<String>())
}

/// A line for each way in which a system answers otherwise, or for its refusal.
fn listed(outcome: &InvariantOutcome) -> String {
    let begin = format!("{}: {}", outcome.index, KINDS[outcome.kind]);
    if let Some(why) = &outcome.refused {
        return format!("{begin}: refused: {why}\n");
    }
    let rows = outcome.violations().map(|(invariant, held, _)| {
        let how = invariant.name();
        match held {
            VariantOutcome::Differs(off) => format!(
                "{begin}: {how}: {}: {:.6e} and {:.6e}, {:.3} times what is allowed\n",
                off.name,
                off.value,
                off.other,
                off.excess()
            ),
            VariantOutcome::Refused(why) => format!("{begin}: {how}: refused: {why}\n"),
            VariantOutcome::NotAsked | VariantOutcome::Agrees(_) => String::new(),
        }
    });
    rows.collect()
}

/// Writes the files of the systems that answer otherwise, or of all.
fn write(folder: &Path, outcomes: &[InvariantOutcome], all: bool) -> Result<(), CommandError> {
    let failed = |source: seacable_base::files::WriteError| CommandError::Write {
        option: "--write",
        source,
    };
    disk::create_dir_all(folder).map_err(CommandError::Output)?;
    let put = |name: String, text: &str| {
        let path = folder.join(name);
        WriteTarget::replacing(&path)
            .write(text.as_bytes())
            .map_err(failed)
    };
    for outcome in outcomes {
        let index = outcome.index;
        let mut otherwise = outcome.violations().peekable();
        if all || otherwise.peek().is_some() {
            put(format!("{index}.toml"), &text(&outcome.file))?;
        }
        for (invariant, _, variant) in otherwise {
            put(
                format!("{index}-{}.toml", invariant.name()),
                &variant.text(),
            )?;
        }
    }
    Ok(())
}
