//! From a file to a checked case.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use toml::de::DeTable;

use super::check::check;
use super::diagnostic::{Diagnostic, Finding};
use super::model::Case;
use super::tree::Node;

/// A case with the text and the file it came from.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The text of the file.
    pub text: String,
    /// The case, checked.
    pub case: Case,
    /// The file.
    pub path: PathBuf,
}

/// Reads and checks a case file.
///
/// # Errors
///
/// Everything that is wrong, at once: that there is no such file, that it is a directory, binary
/// or empty, faults of the TOML syntax, or every fault of keys and values.
pub fn load(path: &Path) -> Result<Loaded, Vec<Diagnostic>> {
    let text = text_of(path).map_err(|diagnostic| vec![diagnostic])?;
    let case = parse(&text, &path.display().to_string())?;
    Ok(Loaded {
        text,
        case,
        path: path.to_owned(),
    })
}

/// Checks the text of a case. `file` is the name the diagnostics carry.
///
/// # Errors
///
/// Everything that is wrong, at once, in the order of the lines.
pub fn parse(text: &str, file: &str) -> Result<Case, Vec<Diagnostic>> {
    let diagnose = |found: Vec<Finding>| {
        found
            .into_iter()
            .map(|finding| finding.at(file, text))
            .collect()
    };
    if let Some(diagnostic) = nothing_said(text, file) {
        return Err(vec![diagnostic]);
    }
    let tree = tree_of(text).map_err(diagnose)?;
    let found = check(&tree);
    if !found.is_empty() {
        return Err(diagnose(found));
    }
    words_of(text).map_err(|finding| diagnose(vec![finding]))
}

/// The tree of the text, or its faults of syntax.
pub(crate) fn tree_of(text: &str) -> Result<Node, Vec<Finding>> {
    Node::parse(text).map_err(|first| {
        let (_, all) = DeTable::parse_recoverable(text);
        let mut found: Vec<Finding> = all
            .iter()
            .map(|fault| syntax(fault.span(), fault.message()))
            .collect();
        if found.is_empty() {
            found.push(syntax(first.span(), first.message()));
        }
        found.sort_by_key(|fault| fault.span.start);
        found
    })
}

fn syntax(span: Option<std::ops::Range<usize>>, message: &str) -> Finding {
    let said = message
        .lines()
        .map(str::trim)
        .collect::<Vec<_>>()
        .join(", ");
    Finding::new(
        &span.unwrap_or(0..0),
        "",
        format!("this is not TOML: {said}"),
        "a line holds `key = value`, a `[table]` header, or a `# comment`; text stands in quotes",
    )
}

/// The checked text as a [`Case`]. The checks leave nothing for this to find; should they miss
/// something, it is still told as a diagnostic.
fn words_of(text: &str) -> Result<Case, Finding> {
    let fault = |error: &toml_edit::de::Error| {
        let problem = error.message().lines().collect::<Vec<_>>().join(", ");
        Finding::new(
            &error.span().unwrap_or(0..0),
            "",
            problem,
            "compare with the cases that come with the program",
        )
    };
    let reader = toml_edit::de::Deserializer::parse(text).map_err(|error| fault(&error))?;
    Case::deserialize(reader).map_err(|error| fault(&error))
}

fn nothing_said(text: &str, file: &str) -> Option<Diagnostic> {
    let comment = |line: &str| line.trim().is_empty() || line.trim_start().starts_with('#');
    text.trim_start_matches('\u{feff}')
        .lines()
        .all(comment)
        .then(|| {
            Diagnostic::whole_file(
                file,
                "the file is empty: it holds no case",
                "a case has at least [case], [materials.<name>], [[line]] and [ends.a], [ends.b]",
            )
        })
}

fn text_of(path: &Path) -> Result<String, Diagnostic> {
    let file = path.display().to_string();
    if path.is_dir() {
        let remedy = "name a case file in it; `seacable DIR` opens the workbench on all of them";
        return Err(Diagnostic::whole_file(
            &file,
            "is a directory, not a case file",
            remedy,
        ));
    }
    let bytes = std::fs::read(path).map_err(|error| unreadable(&file, &error))?;
    String::from_utf8(bytes).map_err(|error| binary(&file, &error))
}

fn unreadable(file: &str, error: &std::io::Error) -> Diagnostic {
    match error.kind() {
        ErrorKind::NotFound => Diagnostic::whole_file(
            file,
            "there is no such file",
            "check the name and the directory",
        ),
        ErrorKind::PermissionDenied => Diagnostic::whole_file(
            file,
            "the file may not be read",
            "give yourself permission to read it",
        ),
        _ => Diagnostic::whole_file(
            file,
            format!("the file cannot be read: {error}"),
            "check the file and its disk",
        ),
    }
}

/// A file that is not UTF-8, with the place of the first byte that is not.
fn binary(file: &str, error: &std::string::FromUtf8Error) -> Diagnostic {
    let good = error.utf8_error().valid_up_to();
    let before = String::from_utf8_lossy(&error.as_bytes()[..good]);
    let problem = format!(
        "this is not text: byte {} of the file is not UTF-8",
        good + 1
    );
    let remedy = "a case is a text file in TOML, saved as UTF-8";
    let finding = Finding::new(&(good..good), "", problem, remedy);
    finding.at(file, &before)
}
