//! The cases that come with the program are free of faults.

use std::path::{Path, PathBuf};

use std::sync::atomic::AtomicBool;

use seacable::case::{self, LoadedCase, StudyPoint, edit};
use seacable::kinds::FileType;
use seacable::reference::{self, Outcome};
use seacable::run::job::{self, Request};
use seacable::run::{Run, RunState};

fn case_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(case_files(&path));
        } else if path.extension().is_some_and(|ending| ending == "toml")
            && FileType::of_path(&path) == FileType::Line
        {
            files.push(path);
        }
    }
    files.sort();
    files
}

fn shipped() -> Vec<LoadedCase> {
    let files = case_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("cases"));
    assert!(!files.is_empty());
    files
        .iter()
        .map(|path| match case::load(path) {
            Ok(loaded) => loaded,
            Err(faults) => {
                let reported: Vec<String> = faults.iter().map(ToString::to_string).collect();
                panic!("{}", reported.join("\n"))
            }
        })
        .collect()
}

#[test]
fn shipped_cases_have_no_faults() {
    shipped();
}

#[test]
fn every_value_of_a_study_makes_a_case() {
    for loaded in shipped() {
        for study in &loaded.case.study {
            for value in &study.values {
                let text = edit::set_value(&loaded.text, &study.key, value)
                    .unwrap_or_else(|fault| panic!("{}: {fault}", loaded.path.display()));
                case::parse(&text, &study.name).unwrap();
            }
        }
    }
}

#[test]
fn small_cases_run_and_meet_their_closed_forms() {
    for loaded in shipped().into_iter().filter(|loaded| {
        loaded
            .path
            .parent()
            .is_some_and(|folder| folder.ends_with("basics"))
    }) {
        let request = Request {
            case: loaded.case.clone(),
            text: loaded.text,
            file: loaded.path.display().to_string(),
            overrides: Vec::new(),
            id: "shipped".to_owned(),
        };
        let run = job::execute(&request, &AtomicBool::new(false), &mut |_| {});
        assert_eq!(
            run.info.state,
            RunState::Done,
            "{}: {:?}",
            request.file,
            run.info.failure
        );
        assert!(run.info.warnings.is_empty(), "{:?}", run.info.warnings);
        for row in reference::rows(&loaded.case, &|at| at.is_none().then_some(&run)) {
            assert_eq!(
                row.outcome,
                Outcome::Pass,
                "{}: {} is {:?}",
                request.file,
                row.name,
                row.computed
            );
        }
    }
}

#[test]
fn benchmarks_meet_what_is_published() {
    for loaded in shipped().into_iter().filter(|loaded| {
        loaded
            .path
            .parent()
            .is_some_and(|folder| folder.ends_with("benchmarks"))
    }) {
        let runs: Vec<(Option<StudyPoint>, Run)> = reference::plan(&loaded.case)
            .into_iter()
            .map(|at| (at.clone(), run_at(&loaded, at.as_ref())))
            .collect();
        let lookup = |at: Option<&StudyPoint>| {
            let found = runs.iter().find(|(known, _)| known.as_ref() == at);
            found.map(|(_, run)| run)
        };
        let rows = reference::rows(&loaded.case, &lookup);
        assert!(!rows.is_empty());
        for row in rows {
            let off = (row.computed.unwrap_or(f64::NAN) - row.published.unwrap()).abs();
            assert_eq!(row.outcome, Outcome::Pass, "{}: {off}", row.name);
            // Curves have no numerical error of their own.
            if row.unit.starts_with("% of") {
                continue;
            }
            // The tolerance is not met by chance: the error is a small part of it, but for its factor of safety of up to three.
            assert!(
                row.error.unwrap() / 3.0 < 0.1 * row.tolerance.unwrap(),
                "{}",
                row.name
            );
        }
    }
}

/// A case at a point of a study.
fn run_at(loaded: &LoadedCase, at: Option<&StudyPoint>) -> Run {
    let mut text = loaded.text.clone();
    if let Some(at) = at {
        let study = loaded.case.study.iter().find(|s| s.name == at.study);
        text = edit::set_value(&text, &study.unwrap().key, &at.value).unwrap();
    }
    let request = Request {
        case: case::parse(&text, "benchmark").unwrap(),
        text,
        file: loaded.path.display().to_string(),
        overrides: Vec::new(),
        id: "benchmark".to_owned(),
    };
    job::execute(&request, &AtomicBool::new(false), &mut |_| {})
}
