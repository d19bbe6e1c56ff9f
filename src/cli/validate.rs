//! `seacable validate`: cases compared with the published values they state.

use std::{
    path::Path,
    process::ExitCode,
    sync::atomic::{AtomicUsize, Ordering},
};

use rayon::prelude::*;

use super::{
    BAD_RESULT, CommandError,
    args::ValidateArgs,
    cases::{self, Loaded},
    output, progress,
    signals::Stop,
};
use crate::{
    case::At,
    reference::{self, Outcome, OutcomeCounts, ValidationRow},
    report::text,
    ropeway::validation,
    run::{
        Run,
        job::{self, Request},
    },
    ship, visible,
};

pub(super) fn validate(args: &ValidateArgs) -> Result<ExitCode, CommandError> {
    let named = cases::named_or_shipped(&args.cases)?;
    let cases = named.lines;
    let variants = variants(&cases)?;
    let stop = Stop::listen()?;
    let runs = compute(&variants, &stop);
    if let Some(status) = stop.status() {
        output::message("Stopped before all variants were computed; nothing was judged.");
        return Ok(status);
    }

    let mut tables = Vec::with_capacity(cases.len());
    for (i, loaded) in cases.iter().enumerate() {
        let of_case = || variants.iter().zip(&runs).filter(|(v, _)| v.case == i);
        let lookup = |at: Option<&At>| {
            of_case()
                .find(|(v, _)| v.at.as_ref() == at)
                .map(|(_, run)| run)
        };
        let rows = reference::rows(&loaded.case, &lookup);
        tables.push(ValidatedFile::new(
            &loaded.case.case.title,
            &loaded.name,
            rows,
        ));
    }
    for (name, loaded) in &named.ropeways {
        let rows = validation::rows(&loaded.worked, &loaded.text);
        let title = &loaded.worked.ropeway.about.title;
        tables.push(ValidatedFile::new(title, name, rows));
    }
    for (name, rest) in &named.ships {
        let folder = Path::new(name).parent().unwrap_or(Path::new(""));
        tables.push(ValidatedFile::new(
            &rest.ship.ship.title,
            name,
            ship::validation::rows(&rest.ship, ship::MotionAnalysis::of(rest, folder).as_ref()),
        ));
    }
    output::results(&text(&tables), args.ascii)?;
    let holds = total(&tables).holds();
    Ok(if holds {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(BAD_RESULT)
    })
}

/// A variant of a case, ready to be computed.
struct Variant {
    case: usize,
    at: Option<At>,
    request: Request,
}

fn variants(cases: &[Loaded]) -> Result<Vec<Variant>, CommandError> {
    let mut variants = Vec::new();
    for (i, loaded) in cases.iter().enumerate() {
        for at in reference::plan(&loaded.case) {
            let request = request(loaded, at.as_ref())?;
            variants.push(Variant {
                case: i,
                at,
                request,
            });
        }
    }
    Ok(variants)
}

fn request(loaded: &Loaded, at: Option<&At>) -> Result<Request, CommandError> {
    let wrong = CommandError::invalid(&loaded.text);
    let (text, overrides) = match at {
        None => (loaded.text.clone(), Vec::new()),
        Some(at) => {
            let variant = reference::variant(&loaded.text, &loaded.case, at).map_err(wrong)?;
            (variant.text, variant.overrides)
        }
    };
    let case = cases::parse(&text, &loaded.name)?;
    Ok(Request {
        case,
        text,
        file: loaded.file.clone(),
        overrides,
        id: String::new(),
    })
}

/// Every variant on its own core.
fn compute(variants: &[Variant], stop: &Stop) -> Vec<Run> {
    let line = std::sync::Mutex::new(progress::Line::new());
    let done = AtomicUsize::new(0);
    let say = |count: usize| {
        if let Ok(mut line) = line.lock() {
            line.show(&format!("{count} of {} variants computed", variants.len()));
        }
    };
    say(0);
    let one = |variant: &Variant| {
        let run = job::execute(&variant.request, stop.cancel(), &mut |_| ());
        say(done.fetch_add(1, Ordering::Relaxed) + 1);
        run
    };
    variants.par_iter().map(one).collect()
}

/// A file with the rows of its validation.
struct ValidatedFile {
    /// Its title and its name.
    head: String,
    rows: Vec<ValidationRow>,
}

impl ValidatedFile {
    fn new(title: &str, name: &str, rows: Vec<ValidationRow>) -> Self {
        Self {
            head: visible::line(&format!("{title} ({name})")).into_owned(),
            rows,
        }
    }
}

fn total(tables: &[ValidatedFile]) -> OutcomeCounts {
    tables
        .iter()
        .map(|file| reference::count_outcomes(&file.rows))
        .fold(OutcomeCounts::default(), |a, b| a + b)
}

fn text(tables: &[ValidatedFile]) -> String {
    let mut out = String::new();
    for ValidatedFile { head, rows } in tables {
        out.push_str(&format!("{head}\n{}\n", "=".repeat(head.chars().count())));
        if rows.is_empty() {
            out.push_str("The case states no published values.\n\n");
            continue;
        }
        out.push_str(&text::validation(rows));
        out.push('\n');
    }
    let differing = tables
        .iter()
        .flat_map(|file| &file.rows)
        .filter(|r| r.outcome == Outcome::Differs);
    let differing = differing.count();
    if differing > 0 {
        out.push_str(&format!(
            "{differing} published numbers differ and are declared out of reach by their case;\n\
             the reasons are below its table.\n"
        ));
    }
    out.push_str(&format!("All cases: {}\n", total(tables)));
    out
}
