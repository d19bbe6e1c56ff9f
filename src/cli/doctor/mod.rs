//! `seacable doctor`: what the program finds where it runs, and what is wrong with it.

mod finding;
mod places;
mod program;
mod session;
mod terminal;

use std::io::{IsTerminal, stdout};
use std::process::ExitCode;

use serde_json::json;

use finding::{DoctorFinding, Health, Surroundings};

use super::about_args::DoctorArgs;
use super::{BAD_RESULT, CommandError, output};
use seacable_base::padding::{at_left, blanks};

/// Looks at everything.
#[must_use]
pub(super) fn examine(around: &Surroundings<'_>) -> Vec<DoctorFinding> {
    let mut found = program::findings();
    found.extend(terminal::findings(around));
    found.extend(places::findings(around));
    found.extend(session::findings(around));
    found
}

/// Whether anything is in the way of work.
#[must_use]
pub(super) fn has_problems(found: &[DoctorFinding]) -> bool {
    found
        .iter()
        .any(|finding| finding.health == Health::Problem)
}

/// Prints what was found; the exit status says whether anything is in the way.
pub(super) fn doctor(args: &DoctorArgs) -> Result<ExitCode, CommandError> {
    let size = stdout().is_terminal().then(crossterm::terminal::size);
    let around = Surroundings {
        var: &|name| std::env::var(name).ok(),
        size: size.and_then(Result::ok),
        directory: std::env::current_dir().unwrap_or_default(),
    };
    let found = examine(&around);
    if args.json {
        output::object(&object(&found))?;
    } else {
        output::results(&page(&found), args.ascii)?;
    }
    Ok(match has_problems(&found) {
        true => ExitCode::from(BAD_RESULT),
        false => ExitCode::SUCCESS,
    })
}

/// The page: topic by topic, remedies below what they are for.
fn page(found: &[DoctorFinding]) -> String {
    let widest = found.iter().map(|finding| finding.name.len()).max();
    let width = widest.unwrap_or(0);
    let mut text = String::new();
    let mut topic = "";
    for finding in found {
        if finding.topic != topic {
            topic = finding.topic;
            text.push_str(&format!("{topic}\n"));
        }
        let word = finding.health.word();
        let name = at_left(&finding.name, width);
        text.push_str(&format!("  {word:<7}  {name}  {}\n", finding.value));
        if !finding.remedy.is_empty() {
            let name = blanks(width);
            text.push_str(&format!("  {:<7}  {name}    {}\n", "", finding.remedy));
        }
    }
    let problems = found.iter().filter(|f| f.health == Health::Problem).count();
    text.push_str(&match problems {
        0 => "\nNothing is in the way.\n".to_owned(),
        1 => "\n1 problem.\n".to_owned(),
        count => format!("\n{count} problems.\n"),
    });
    text
}

fn object(found: &[DoctorFinding]) -> serde_json::Value {
    let each = found.iter().map(|finding| {
        json!({
            "topic": finding.topic,
            "name": finding.name,
            "value": finding.value,
            "health": finding.health.word().to_lowercase(),
            "remedy": finding.remedy,
        })
    });
    json!({ "findings": each.collect::<Vec<_>>(), "problems": has_problems(found) })
}

#[cfg(test)]
mod tests;
