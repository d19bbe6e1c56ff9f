//! `seacable laboratory systems --in-motion`: random systems of lines, each run for some seconds.

use std::process::ExitCode;

use super::args::SystemsArgs;
use super::random_refusals::frequent;
use crate::{BAD_RESULT, CommandError, output};
use seacable_display::table::{NumberFormat, Table};
use seacable_report::run_json;
use seacable_studies::laboratory::random_motion::{KINDS, MotionEnd, RandomMotion, run_all};

pub(super) fn systems(args: &SystemsArgs) -> Result<ExitCode, CommandError> {
    let outcomes = run_all(args.count as usize, args.seed);
    let kinds: Vec<(&str, Vec<&RandomMotion>)> = KINDS
        .iter()
        .enumerate()
        .map(|(kind, name)| {
            let of_kind = outcomes.iter().filter(|outcome| outcome.kind == kind);
            (*name, of_kind.collect())
        })
        .collect();
    let table = table(&kinds);
    let sound = outcomes.iter().all(|outcome| outcome.end.is_sound());
    let status = if sound {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(BAD_RESULT)
    };
    if args.json {
        output::object(&run_json::study("systems in motion", &table))?;
        return Ok(status);
    }
    let mut text = table.to_text(110);
    text.push_str("\nReasons:\n");
    let reasons = outcomes.iter().filter_map(|outcome| match &outcome.end {
        MotionEnd::Early(why) | MotionEnd::Refused(why) => Some(why.as_str()),
        _ => None,
    });
    for (reason, many) in frequent(reasons) {
        text.push_str(&format!("{many:6}  {reason}\n"));
    }
    if args.list {
        for (index, outcome) in outcomes.iter().enumerate() {
            if !matches!(outcome.end, MotionEnd::Ran { warned: false, .. }) {
                text.push_str(&format!(
                    "{index}: {}: {:?}\n",
                    KINDS[outcome.kind], outcome.end
                ));
            }
        }
    }
    if let Some(shown) = args.show.and_then(|index| outcomes.get(index)) {
        text.push_str(&shown.text);
    }
    output::results(&text, args.ascii)?;
    Ok(status)
}

type OfKind<'a> = (&'static str, Vec<&'a RandomMotion>);

fn table(kinds: &[OfKind<'_>]) -> Table {
    const COUNT: NumberFormat = NumberFormat::Digits(6, "");
    fn count(kind: &OfKind<'_>, is: fn(&MotionEnd) -> bool) -> f64 {
        kind.1.iter().filter(|outcome| is(&outcome.end)).count() as f64
    }
    let drift = |kind: &OfKind<'_>| {
        let drifts = kind.1.iter().map(|outcome| match outcome.end {
            MotionEnd::Ran {
                drift,
                warned: false,
                ..
            } => drift,
            _ => 0.0,
        });
        100.0 * drifts.fold(0.0, f64::max)
    };
    let steps = |kind: &OfKind<'_>| {
        let steps = kind.1.iter().map(|outcome| match outcome.end {
            MotionEnd::Ran { steps, .. } => steps as f64,
            _ => 0.0,
        });
        steps.fold(0.0, f64::max)
    };
    let longest = |kind: &OfKind<'_>| {
        let times = kind.1.iter().map(|outcome| outcome.time.as_secs_f64());
        times.fold(0.0, f64::max)
    };
    Table::of_records("Random systems in motion", kinds)
        .text("kind", |kind| kind.0)
        .number("ran", COUNT, |kind| {
            count(kind, |end| matches!(end, MotionEnd::Ran { .. }))
        })
        .number("warned of energy", COUNT, |kind| {
            count(kind, |end| {
                matches!(end, MotionEnd::Ran { warned: true, .. })
            })
        })
        .number("ended early", COUNT, |kind| {
            count(kind, |end| matches!(end, MotionEnd::Early(_)))
        })
        .number("refused", COUNT, |kind| {
            count(kind, |end| matches!(end, MotionEnd::Refused(_)))
        })
        .number("unsound", COUNT, |kind| count(kind, |end| !end.is_sound()))
        .number("not finite", COUNT, |kind| {
            count(kind, |end| *end == MotionEnd::NotFinite)
        })
        .number("panicked", COUNT, |kind| {
            count(kind, |end| *end == MotionEnd::Panicked)
        })
        .number(
            "energy missing, greatest",
            NumberFormat::Digits(2, "%"),
            drift,
        )
        .number("steps, greatest", COUNT, steps)
        .number("longest", NumberFormat::Digits(3, "s"), longest)
        .build()
}
