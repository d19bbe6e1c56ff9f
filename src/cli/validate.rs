//! `seacable validate`: cases compared with the published values they state.

use std::{
    process::ExitCode,
    sync::atomic::{AtomicUsize, Ordering},
};

use rayon::prelude::*;

use super::{
    BAD_RESULT, CommandError,
    args::ValidateArgs,
    cases::{self, NamedCase},
    kinds, output, progress,
    signals::StopFlag,
};
use crate::{
    case::{Case, EditedKey, StudyPoint, kind},
    reference::{self, Outcome, OutcomeCounts, ValidationRow},
    report::{run_json, text},
    run::{
        Run,
        job::{self, Request},
    },
    visible,
};

pub(super) fn validate(args: &ValidateArgs) -> Result<ExitCode, CommandError> {
    let named = cases::named_or_shipped(&args.cases)?;
    let set = cases::edits(&args.set)?;
    let stop = StopFlag::listen()?;
    let others = named.others.iter().map(|file| {
        let (title, rows) = kinds::validation(file, &set, stop.cancel())?;
        Ok(ValidatedFile::new(&title, &file.name, rows))
    });
    let others: Vec<ValidatedFile> = others.collect::<Result<_, CommandError>>()?;
    let cases: Vec<EditedCase> = named
        .lines
        .into_iter()
        .map(|loaded| EditedCase::new(loaded, &args.set))
        .collect::<Result<_, CommandError>>()?;
    let variants = variants(&cases)?;
    let runs = compute(&variants, &stop);
    if let Some(status) = stop.status() {
        output::message("Stopped before all variants were computed; nothing was judged.");
        return Ok(status);
    }

    let mut tables = Vec::with_capacity(cases.len());
    for (i, EditedCase { loaded, edited }) in cases.iter().enumerate() {
        let of_case = || variants.iter().zip(&runs).filter(|(v, _)| v.case == i);
        let lookup = |at: Option<&StudyPoint>| {
            of_case()
                .find(|(v, _)| v.at.as_ref() == at)
                .map(|(_, run)| run)
        };
        let rows = reference::rows_of_edited(&loaded.case, edited, &lookup);
        tables.push(ValidatedFile::new(
            &loaded.case.case.title,
            &loaded.name,
            rows,
        ));
    }
    tables.extend(others);
    if args.cases.is_empty() {
        tables.retain(|file| !file.rows.is_empty());
    }
    let page = match args.json {
        true => format!("{:#}\n", object(&tables)),
        false => text(&tables),
    };
    output::results(&page, args.ascii)?;
    let holds = total(&tables).holds();
    Ok(if holds {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(BAD_RESULT)
    })
}

/// A case with the keys set on top of its file.
struct EditedCase {
    loaded: NamedCase,
    /// The inputs that are not those of the file.
    edited: Vec<EditedKey>,
}

impl EditedCase {
    fn new(loaded: NamedCase, set: &[String]) -> Result<Self, CommandError> {
        let text = cases::set(&loaded.text, set)?;
        let (_, edited) = kind::edited_rows::<Case>(&text, &loaded.text);
        let case = match set {
            [] => loaded.case,
            _ => cases::parse(&text, &loaded.name)?,
        };
        let loaded = NamedCase {
            text,
            case,
            ..loaded
        };
        Ok(Self { loaded, edited })
    }
}

/// A variant of a case, ready to be computed.
struct VariantRequest {
    case: usize,
    at: Option<StudyPoint>,
    request: Request,
}

fn variants(cases: &[EditedCase]) -> Result<Vec<VariantRequest>, CommandError> {
    let mut variants = Vec::new();
    for (i, EditedCase { loaded, .. }) in cases.iter().enumerate() {
        for at in reference::plan(&loaded.case) {
            let request = request(loaded, at.as_ref())?;
            variants.push(VariantRequest {
                case: i,
                at,
                request,
            });
        }
    }
    Ok(variants)
}

fn request(loaded: &NamedCase, at: Option<&StudyPoint>) -> Result<Request, CommandError> {
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
fn compute(variants: &[VariantRequest], stop: &StopFlag) -> Vec<Run> {
    let line = std::sync::Mutex::new(progress::ProgressLine::new());
    let done = AtomicUsize::new(0);
    let say = |count: usize| {
        if let Ok(mut line) = line.lock() {
            line.show(&format!("{count} of {} variants computed", variants.len()));
        }
    };
    say(0);
    let one = |variant: &VariantRequest| {
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

/// All tables as one JSON object.
fn object(tables: &[ValidatedFile]) -> serde_json::Value {
    let files = tables.iter().map(|file| {
        let rows = run_json::validation(&file.rows);
        serde_json::json!({"file": file.head, "rows": rows})
    });
    let counts = total(tables).to_string();
    serde_json::json!({"files": files.collect::<Vec<_>>(), "counts": counts})
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
