//! The lists of what the papers print: every statement has an answer, and each answer is there.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::sync::atomic::AtomicBool;

use seacable::case::kind::parse;
use seacable::case::shipped::BY_KIND;
use seacable::case::{Case, FieldRow};
use seacable::chart::Glyphs;
use seacable::kinds::FileType;
use seacable::reference::papers::{self, Answer, FileRows, JudgedStatement, Paper};
use seacable::reference::{RowKind, ValidationRow};
use seacable::report::validation::{Extent, JudgedPaper, page};
use seacable::ropeway::{self, Ropeway};
use seacable::section::{self, CrossSection};
use seacable::ship::{self, MotionAnalysis, Ship};
use seacable::system::{self, SystemFile};

use super::validation::ROWS;

static LISTS: LazyLock<Vec<Paper>> = LazyLock::new(|| {
    let parsed = |(name, text): &(&str, &str)| papers::parse(text, name).unwrap();
    papers::LISTS.iter().map(parsed).collect()
});

/// Path, text and rows of every file that a paper names.
static FILES: LazyLock<Vec<(&str, &str, Vec<ValidationRow>)>> = LazyLock::new(|| {
    let cases = LISTS.iter().flat_map(|paper| &paper.about.cases);
    cases.map(|case| rows_of(case)).collect()
});

fn rows_of(case: &'static str) -> (&'static str, &'static str, Vec<ValidationRow>) {
    let found = BY_KIND.iter().find_map(|(kind, files)| {
        let (_, text) = files.iter().find(|(path, _)| *path == case)?;
        Some((*kind, *text))
    });
    let (kind, text) = found.unwrap_or_else(|| panic!("{case} is not shipped"));
    let name = format!("cases/{case}");
    let rows = match kind {
        FileType::Line => {
            let rows = ROWS.iter().find(|(path, _)| *path == case);
            rows.unwrap().1.clone()
        }
        FileType::Ropeway => {
            ropeway::validation::rows(&parse::<Ropeway>(text, &name).unwrap(), text)
        }
        FileType::Ship => {
            let statics = parse::<Ship>(text, &name).unwrap();
            let folder = Path::new(&name).parent().unwrap();
            let motion = MotionAnalysis::of_statics(&statics, folder);
            ship::validation::rows(&statics.ship, motion.as_ref())
        }
        FileType::Section => {
            section::validation::rows(&parse::<CrossSection>(text, &name).unwrap())
        }
        FileType::System => {
            let text = &text.replace("[solver]", "[solver]\nerror_estimate = false");
            let solved = parse::<SystemFile>(text, &name).unwrap();
            let given = solved.file.solver.clone().unwrap();
            let cancel = AtomicBool::new(false);
            let run = system::motion::run::run(&solved, &given, &cancel, &mut |_| {}).unwrap();
            system::validation::rows(&solved, Some(&run))
        }
    };
    (case, text, rows)
}

fn files() -> Vec<FileRows<'static>> {
    let files = FILES.iter();
    files
        .map(|(file, text, rows)| FileRows { file, text, rows })
        .collect()
}

fn judged() -> impl Iterator<Item = (&'static Paper, Vec<JudgedStatement<'static>>)> {
    LISTS
        .iter()
        .map(|paper| (paper, papers::judge(paper, &files())))
}

#[test]
fn no_statement_is_without_an_answer() {
    for (paper, statements) in judged() {
        for one in statements {
            let where_ = format!("{}: {}", paper.about.title, one.statement.says);
            assert!(
                !matches!(one.answer, Answer::NotAttempted(_)),
                "{where_}: {:?}",
                one.answer
            );
            assert!(
                !matches!(one.second, Some(Answer::NotAttempted(_))),
                "{where_}: {:?}",
                one.second
            );
            if let Answer::NotReproduced(reason) | Answer::Untestable(reason) = &one.answer {
                assert!(one.statement.input.is_none(), "{where_}: {reason}");
                assert!(reason.len() > 40, "{where_}: {reason}");
            }
        }
    }
}

#[test]
fn code_and_tests_that_are_named_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut sources = String::new();
    let mut folders: Vec<PathBuf> = ["src", "tests"].map(|folder| root.join(folder)).into();
    while let Some(folder) = folders.pop() {
        for item in fs::read_dir(folder).unwrap() {
            let path = item.unwrap().path();
            match path.extension() {
                None if path.is_dir() => folders.push(path),
                Some(end) if end == "rs" => sources.push_str(&fs::read_to_string(&path).unwrap()),
                _ => {}
            }
        }
    }
    for statement in LISTS.iter().flat_map(|paper| &paper.statements) {
        if let (Some(code), Some(test)) = (&statement.code, &statement.test) {
            assert!(root.join(code).is_file(), "{}: {code}", statement.says);
            assert!(
                sources.contains(&format!("fn {test}(")),
                "{}: {test}",
                statement.says
            );
        }
    }
}

#[test]
fn no_two_statements_are_the_same() {
    for paper in LISTS.iter() {
        let mut said: Vec<(&str, &str)> = paper
            .statements
            .iter()
            .map(|statement| (statement.printed_in.as_str(), statement.says.as_str()))
            .collect();
        said.sort_unstable();
        for pair in said.windows(2) {
            assert_ne!(pair[0], pair[1], "{}", paper.about.title);
        }
    }
}

/// No tolerance without a reason; what is no evidence says why it is none.
#[test]
fn tolerances_have_reasons_and_fitted_rows_notes() {
    for (path, rows) in ROWS
        .iter()
        .map(|(path, rows)| (path, rows))
        .chain(FILES.iter().map(|(path, _, rows)| (path, rows)))
    {
        for row in rows {
            let at = format!("{path}: {}", row.name);
            assert!(
                row.tolerance.is_none() || row.tolerance_reason.is_some(),
                "{at}"
            );
            let by_construction = matches!(row.kind, RowKind::Fitted | RowKind::Echoed);
            assert!(
                !by_construction || row.note.is_some() || row.basis.is_some(),
                "{at}"
            );
        }
    }
}

/// The table of the README is what `seacable validate --summary` begins with.
#[test]
fn the_readme_shows_the_summary() {
    let papers: Vec<JudgedPaper<'_>> = judged()
        .map(|(paper, statements)| JudgedPaper { paper, statements })
        .collect();
    let text = page(&[], &papers, Extent::Summary).to_text(80, Glyphs::Braille);
    let table = text.lines().skip(3).take(2 + papers.len());
    let table: Vec<String> = table.map(|line| format!("    {line}")).collect();
    let readme = include_str!("../../README.md");
    let table = table.join("\n");
    assert!(readme.contains(&table), "README.md lacks:\n{table}");
}

/// Every input of a paper's cases is printed, which the list says, or marked with where it comes from.
#[test]
fn inputs_are_printed_or_marked() {
    let mut unsaid = Vec::new();
    for paper in LISTS.iter() {
        let statements = paper.statements.iter();
        let printed: Vec<(&str, Option<f64>)> = statements
            .filter_map(|statement| {
                let (_, key) = statement.input.as_ref()?.split_once(": ")?;
                Some((key, statement.value.as_ref()?.number()))
            })
            .collect();
        for case in &paper.about.cases {
            for (key, value) in unmarked(case) {
                let said = printed.iter().any(|(known, number)| {
                    *known == key && number.is_none_or(|n| value.parse() == Ok(n))
                });
                if !said {
                    unsaid.push(format!("{case}: {key} = {value}"));
                }
            }
        }
    }
    assert!(unsaid.is_empty(), "{}", unsaid.join("\n"));
}

/// The inputs of a file that have no mark, with their values; what only says how to compute is none.
fn unmarked(case: &str) -> Vec<(String, String)> {
    let found = BY_KIND.iter().find_map(|(kind, files)| {
        let (_, text) = files.iter().find(|(path, _)| *path == case)?;
        Some((*kind, *text))
    });
    let (kind, text) = found.unwrap();
    let rows = match kind {
        FileType::Line => seacable::case::kind::rows::<Case>(text),
        FileType::Ropeway => seacable::case::kind::rows::<Ropeway>(text),
        FileType::Ship => seacable::case::kind::rows::<Ship>(text),
        // The system has the inputs of the line case beside it; the section says of itself that all but the size of its units is
        // assumed.
        FileType::System | FileType::Section => Vec::new(),
    };
    let physical = |path: &str| {
        let tables = [
            "solver.",
            "output.",
            "modes.",
            "case.",
            "study",
            "published",
            "trend",
            "marks.",
        ];
        let words = [
            ".name",
            ".title",
            ".segments",
            ".kind",
            ".source",
            ".notes",
            ".material",
            ".tolerance_reason",
            ".by",
            ".shape",
            ".seed",
            ".step_s",
            ".components",
            ".records",
            ".follows",
            ".duration_s",
            ".ramp_s",
            ".from_s",
        ];
        !tables.iter().any(|table| path.starts_with(table))
            && !words.iter().any(|word| path.ends_with(word))
    };
    // Words name what a file has; zeros are where its axes begin.
    let number = |value: &str| value.contains(|c: char| ('1'..='9').contains(&c));
    let numbers = |row: &FieldRow| row.value.starts_with('[') || row.value.parse::<f64>().is_ok();
    let rows = rows.into_iter().filter(|row| {
        let given = row.given && row.standing.is_none() && physical(&row.path);
        given && numbers(row) && number(&row.value)
    });
    rows.map(|row| (row.path, row.value)).collect()
}
