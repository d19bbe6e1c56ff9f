//! `seacable validate`: cases compared with the published values they state, and the page of all of them.

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
use seacable_base::visible;
use seacable_display::chart::Glyphs;
use seacable_model::case::{Case, EditedKey, StudyPoint, kind};
use seacable_report::{
    document::{Block, Report},
    run_json, text,
    validation::{self, Extent, JudgedPaper},
};
use seacable_runs::reference::{
    self, OutcomeCounts, ValidationRow,
    papers::{self, FileRows, Paper},
};
use seacable_runs::run::{
    Run,
    job::{self, Request},
};

pub(super) fn validate(args: &ValidateArgs) -> Result<ExitCode, CommandError> {
    let named = cases::named_or_shipped(&args.cases)?;
    let set = cases::edits(&args.set)?;
    let stop = StopFlag::listen()?;
    let others = named.others.iter().map(|file| {
        let (title, rows) = kinds::validation(file, &set, stop.cancel())?;
        Ok(Validated::new(&title, &file.name, &file.text, rows))
    });
    let others: Vec<Validated> = others.collect::<Result<_, CommandError>>()?;
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
        tables.push(Validated::new(
            &loaded.case.case.title,
            &loaded.name,
            &loaded.text,
            rows,
        ));
    }
    tables.extend(others);
    let lists = papers(&tables)?;
    if args.cases.is_empty() {
        tables.retain(|file| !file.rows.is_empty());
    }
    show(args, &tables, &lists)?;
    let holds = total(&tables).holds();
    Ok(if holds {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(BAD_RESULT)
    })
}

/// Prints what was asked for: of cases that were named their tables, otherwise the page.
fn show(args: &ValidateArgs, tables: &[Validated], lists: &[Paper]) -> Result<(), CommandError> {
    let rows: Vec<FileRows<'_>> = tables.iter().map(Validated::rows).collect();
    let judged: Vec<JudgedPaper<'_>> = lists
        .iter()
        .map(|paper| JudgedPaper {
            paper,
            statements: papers::judge(paper, &rows),
        })
        .collect();
    if args.json {
        return output::object(&object(tables, &judged));
    }
    let whole = args.cases.is_empty();
    let extent = match (args.summary, args.details) {
        (true, _) => Some(Extent::Summary),
        (_, true) => Some(Extent::Details),
        _ => whole.then_some(Extent::Page),
    };
    let of_papers = |extent| validation::page(&rows, &judged, extent);
    let mut report = extent.map_or_else(Report::default, of_papers);
    let with_tables = extent.is_none() || args.details;
    let glyphs = output::glyphs(args.ascii);
    if args.markdown || args.html {
        if with_tables {
            report.extend(tables.iter().flat_map(Validated::blocks).collect());
        }
        let page = match args.html {
            true => report.to_html(),
            false => report.to_markdown(glyphs),
        };
        return output::results(&page, args.ascii);
    }
    let mut page = report.to_text(text::WIDTH, glyphs);
    if extent != Some(Extent::Summary) {
        if with_tables {
            page.push_str(&full_tables(tables, glyphs));
        }
        page.push_str(&format!("\nAll cases: {}\n", total(tables)));
        if extent == Some(Extent::Page) {
            page.push_str(MORE);
        }
    }
    output::results(page.trim_start_matches('\n'), args.ascii)
}

const MORE: &str = "\
`seacable validate --details` shows inputs, equations and every row with its note; `seacable validate FILE` one file.\n";

/// The lists of the papers of which every file was computed.
fn papers(tables: &[Validated]) -> Result<Vec<Paper>, CommandError> {
    let mut lists = Vec::new();
    for (name, text) in papers::LISTS {
        let paper = papers::parse(text, name).map_err(CommandError::Invalid)?;
        let mut cases = paper.about.cases.iter();
        if cases.all(|case| tables.iter().any(|file| file.rows().file == case)) {
            lists.push(paper);
        }
    }
    Ok(lists)
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
    let (text, overrides) = match at {
        None => (loaded.text.clone(), Vec::new()),
        Some(at) => {
            let case = &loaded.case;
            let variant =
                reference::variant::<Case>(&loaded.text, &case.case.title, &case.study, at)
                    .map_err(CommandError::Invalid)?;
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
struct Validated {
    title: String,
    /// How the user knows it.
    name: String,
    text: String,
    rows: Vec<ValidationRow>,
}

impl Validated {
    fn new(title: &str, name: &str, text: &str, rows: Vec<ValidationRow>) -> Self {
        Self {
            title: title.to_owned(),
            name: name.to_owned(),
            text: text.to_owned(),
            rows,
        }
    }

    /// Title and name.
    fn head(&self) -> String {
        visible::line(&format!("{} ({})", self.title, self.name)).into_owned()
    }

    /// Its table, each row with its note.
    fn blocks(&self) -> [Block; 3] {
        [
            Block::Heading(self.head()),
            Block::Table(reference::table(&self.rows)),
            Block::Paragraph(reference::count_outcomes(&self.rows).to_string()),
        ]
    }

    fn rows(&self) -> FileRows<'_> {
        let folder = format!("{}/", cases::FOLDER);
        FileRows {
            file: self.name.strip_prefix(&folder).unwrap_or(&self.name),
            text: &self.text,
            rows: &self.rows,
        }
    }
}

fn total(tables: &[Validated]) -> OutcomeCounts {
    tables
        .iter()
        .map(|file| reference::count_outcomes(&file.rows))
        .fold(OutcomeCounts::default(), |a, b| a + b)
}

/// Papers and tables as one JSON object.
fn object(tables: &[Validated], papers: &[JudgedPaper<'_>]) -> serde_json::Value {
    let files = tables.iter().map(|file| {
        let rows = run_json::validation(&file.rows);
        serde_json::json!({"file": file.head(), "path": file.name, "rows": rows})
    });
    let papers = papers
        .iter()
        .map(|one| run_json::paper(one.paper, &one.statements));
    serde_json::json!({
        "papers": papers.collect::<Vec<_>>(),
        "files": files.collect::<Vec<_>>(),
        "counts": total(tables).to_string(),
    })
}

/// The validation table of every file, each row with its note.
fn full_tables(tables: &[Validated], glyphs: Glyphs) -> String {
    let mut out = String::new();
    for file in tables {
        let head = file.head();
        out.push_str(&format!("\n{head}\n{}\n", "=".repeat(head.chars().count())));
        match file.rows.is_empty() {
            true => out.push_str("The case states no published values.\n"),
            false => {
                let mut report = Report::default();
                text::add_validation(&mut report, &file.rows);
                out.push_str(&report.to_text(text::WIDTH, glyphs));
            }
        }
    }
    out
}
