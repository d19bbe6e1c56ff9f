//! Cases as the command line names them.

use seacable_base::visible;
use std::path::{Path, PathBuf};

use super::CommandError;
use seacable_base::files::{read, root, walk::Search};
use seacable_foreign::import::ImportOptions;
use seacable_foreign::open;
use seacable_model::case::{
    self, Case, Diagnostic, FieldRow, edit, file_kind::FileKind, kind, shipped,
};
use seacable_model::kinds::FileType;
use seacable_runs::run::store;

/// Where the cases that come with the program lie in its source.
pub(super) const FOLDER: &str = "cases";

/// Case files that lie so many directories deep are found.
const DEPTH: usize = 32;

/// A case with its text.
#[derive(Debug)]
pub(super) struct NamedCase {
    /// How the user knows it.
    pub(super) name: String,
    /// File name without directories.
    pub(super) file: String,
    /// The exact text.
    pub(super) text: String,
    /// What it says.
    pub(super) case: Case,
}

/// Loads a case file.
pub(super) fn load(path: &Path) -> Result<NamedCase, CommandError> {
    let name = path.display().to_string();
    let loaded = case::load(path).map_err(CommandError::Invalid)?;
    Ok(NamedCase {
        file: file_name(&name),
        name,
        text: loaded.text,
        case: loaded.case,
    })
}

/// Reads a case from its text.
pub(super) fn parse(text: &str, file: &str) -> Result<Case, CommandError> {
    case::parse(text, file).map_err(CommandError::Invalid)
}

/// Every `KEY=VALUE` as its two parts.
pub(super) fn edits(words: &[String]) -> Result<Vec<(&str, &str)>, CommandError> {
    let mut edits = Vec::with_capacity(words.len());
    for word in words {
        let Some((key, value)) = word.split_once('=') else {
            let what = format!(
                "`--set {word}` gives no value; write KEY=VALUE, for example current.speed_m_per_s=0.4."
            );
            return Err(CommandError::Usage(what));
        };
        // What the user types may name any file.
        root::allow(value.trim());
        edits.push((key.trim(), value.trim()));
    }
    Ok(edits)
}

/// Lets `KEY=VALUE,VALUE` name any file, as what the user types may.
pub(super) fn allow_values(words: &[String]) {
    let values = words.iter().filter_map(|word| word.split_once('='));
    for (_, values) in values {
        for value in values.split(',') {
            root::allow(value.trim());
        }
    }
}

/// Applies every `KEY=VALUE` to the text of a case.
pub(super) fn set(text: &str, words: &[String]) -> Result<String, CommandError> {
    let edits = edits(words)?;
    edit::set_all(text, &edits).map_err(|found| of_options(&edits, found))
}

/// The text of a file of a kind with every key set, and its result.
pub(super) fn set_and_compute<K: FileKind>(
    text: &str,
    edits: &[(&str, &str)],
    path: &Path,
) -> Result<(String, K::Computed), CommandError> {
    if edits.is_empty() {
        let computed = kind::parse::<K>(text, &path.display().to_string());
        let computed = computed.map_err(CommandError::Invalid)?;
        return Ok((text.to_owned(), computed));
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let done = kind::set_and_compute_beside::<K>(text, edits, folder);
    done.map_err(|found| of_options(edits, found))
}

/// Faults of edits, in the words of the options that give them in the place of a file.
fn of_options(edits: &[(&str, &str)], found: Vec<Diagnostic>) -> CommandError {
    let each: Vec<[String; 2]> = edits
        .iter()
        .map(|(key, value)| [format!("{key} = {value}"), format!("--set {key}={value}")])
        .collect();
    let joined = |which: usize, between: &str| {
        let words: Vec<&str> = each.iter().map(|both| both[which].as_str()).collect();
        words.join(between)
    };
    let all = [joined(0, ", "), joined(1, " ")];
    let of_option = |found: Diagnostic| {
        let known = each.iter().chain([&all]).find(|both| both[0] == found.file);
        match known {
            Some([_, option]) => found.of_option(option),
            None => found,
        }
    };
    CommandError::Invalid(found.into_iter().map(of_option).collect())
}

/// A file of a kind that is read with keys set.
pub(super) struct EditedFile<K: FileKind> {
    /// Its text with the keys, and the files that it names.
    pub(super) whole_text: String,
    /// As it is listed, and as it was without the keys.
    texts: [String; 2],
    /// Its result.
    pub(super) computed: K::Computed,
}

impl<K: FileKind> EditedFile<K> {
    /// Reads a file.
    pub(super) fn load(
        path: &Path,
        words: &[String],
        options: &ImportOptions,
    ) -> Result<Self, CommandError> {
        let loaded = open::load_as::<K>(path, options).map_err(CommandError::Invalid)?;
        if words.is_empty() {
            return Ok(Self {
                whole_text: loaded.whole_text,
                texts: [loaded.text.clone(), loaded.text],
                computed: loaded.computed,
            });
        }
        let (text, computed) = set_and_compute::<K>(&loaded.whole_text, &edits(words)?, path)?;
        Ok(Self {
            whole_text: text.clone(),
            texts: [text, loaded.text],
            computed,
        })
    }

    /// Its fields: many of a large file.
    pub(super) fn fields(&self) -> Vec<FieldRow> {
        let [now, before] = &self.texts;
        kind::edited_rows::<K>(now, before).0
    }
}

/// The fields of a file of a kind that is read with keys set, and its result.
pub(super) fn load_with<K: FileKind>(
    path: &Path,
    words: &[String],
    options: &ImportOptions,
) -> Result<(Vec<FieldRow>, K::Computed), CommandError> {
    let file = EditedFile::<K>::load(path, words, options)?;
    Ok((file.fields(), file.computed))
}

/// What may state published values.
#[derive(Debug, Default)]
pub(super) struct ValidationFiles {
    /// Line cases.
    pub(super) lines: Vec<NamedCase>,
    /// Files of the other kinds.
    pub(super) others: Vec<OtherFile>,
}

/// A file of another kind than a line case.
#[derive(Debug)]
pub(super) struct OtherFile {
    pub(super) kind: FileType,
    /// How the user knows it.
    pub(super) name: String,
    pub(super) text: String,
}

/// The cases named; without names, those below `cases` here, or else those that come with the
/// program, as far as they state published values.
pub(super) fn named_or_shipped(paths: &[PathBuf]) -> Result<ValidationFiles, CommandError> {
    let mut named = named(paths)?;
    if paths.is_empty() {
        named.lines.retain(|loaded| {
            let case = &loaded.case;
            !(case.published.is_empty() && case.published_curve.is_empty() && case.trend.is_empty())
        });
    }
    Ok(named)
}

/// The files named; without names, those below `cases` here, or else those that come with the program.
fn named(paths: &[PathBuf]) -> Result<ValidationFiles, CommandError> {
    let folder = Path::new(FOLDER);
    if !paths.is_empty() {
        below(paths)
    } else if folder.is_dir() {
        below(&[folder.to_owned()])
    } else {
        shipped()
    }
}

/// The cases with trials among those named; without names, among those below `cases` here, or else among those that
/// come with the program.
pub(super) fn with_trials(paths: &[PathBuf]) -> Result<Vec<NamedCase>, CommandError> {
    let mut cases = named(paths)?.lines;
    cases.retain(|loaded| !loaded.case.trial.is_empty());
    if cases.is_empty() {
        let what = "There is no case with trials; a hard case has at least one table [[trial]].";
        return Err(CommandError::Usage(what.to_owned()));
    }
    Ok(cases)
}

/// The line cases named; without names, those below `cases` here, or else those that come with the program. Of these the hard
/// ones are left out, whose answers converge only where their trials say so.
pub(super) fn of_lines(paths: &[PathBuf]) -> Result<Vec<NamedCase>, CommandError> {
    let mut cases = named(paths)?.lines;
    if paths.is_empty() {
        cases.retain(|loaded| loaded.case.trial.is_empty());
    }
    Ok(cases)
}

fn shipped() -> Result<ValidationFiles, CommandError> {
    let mut named = ValidationFiles::default();
    for (kind, files) in shipped::BY_KIND {
        for (path, text) in files {
            named.add(kind, format!("{FOLDER}/{path}"), (*text).to_owned())?;
        }
    }
    Ok(named)
}

impl ValidationFiles {
    /// Adds a file.
    fn add(&mut self, kind: FileType, name: String, text: String) -> Result<(), CommandError> {
        match kind {
            FileType::Line => self.lines.push(NamedCase {
                file: file_name(&name),
                case: parse(&text, &name)?,
                name,
                text,
            }),
            _ => self.others.push(OtherFile { kind, name, text }),
        }
        Ok(())
    }
}

/// Every file named, and every case file below every directory named.
fn below(paths: &[PathBuf]) -> Result<ValidationFiles, CommandError> {
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            root::open(path);
            files.extend(files_below(path)?);
        } else {
            files.push(path.clone());
        }
    }
    let mut named = ValidationFiles::default();
    for file in &files {
        let unreadable =
            |error| CommandError::Usage(format!("Reading {} failed: {error}", visible::path(file)));
        match FileType::of(file) {
            FileType::Line => named.lines.push(load(file)?),
            kind => {
                let text = read::text(file).map_err(unreadable)?;
                named.add(kind, file.display().to_string(), text)?;
            }
        }
    }
    Ok(named)
}

/// The case files below a directory; those of stored runs are none.
fn files_below(dir: &Path) -> Result<Vec<PathBuf>, CommandError> {
    let search = Search {
        extension: "toml",
        except_with: store::RUN,
        depth: DEPTH,
    };
    let found = search.below(dir);
    if let Some((at, error)) = found.faults.first() {
        let what = format!("Listing {} failed: {error}", visible::path(at));
        return Err(CommandError::Usage(what));
    }
    if let Some(link) = found.outside.first() {
        let what = format!(
            "{} is a symbolic link that leads outside {}; --root DIR names a directory in which both lie.",
            visible::path(link),
            visible::path(dir)
        );
        return Err(CommandError::Usage(what));
    }
    if found.files.is_empty() {
        let what = format!(
            "There is no case file (*.toml) below {}.",
            visible::path(dir)
        );
        return Err(CommandError::Usage(what));
    }
    Ok(found.files)
}

fn file_name(path: &str) -> String {
    let name = Path::new(path).file_name();
    name.map_or_else(|| path.to_owned(), |n| n.to_string_lossy().into_owned())
}
