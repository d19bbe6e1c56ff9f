//! Cases as the command line names them.

use seacable_base::visible;
use std::path::{Path, PathBuf};

use super::CommandError;
use seacable_base::files::{root, walk::FileSearch};
use seacable_foreign::import::ImportOptions;
use seacable_foreign::open::OpenedFile;
use seacable_model::case::{
    self, Case, Diagnostic, FieldRow, ReadFile, edit, file_kind::FileKind, kind, shipped,
};
use seacable_model::kinds::{FileBytes, FileType};
use seacable_runs::run::store;
use seacable_studies::study::hard_cases::HardCase;
use seacable_systems::system::SystemFile;

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

/// Reads the case of a file with every `KEY=VALUE` applied to its text; the faults of the file itself come first.
pub(super) fn load_set(file: FileBytes, words: &[String]) -> Result<NamedCase, CommandError> {
    let path = file.path().to_owned();
    let name = path.display().to_string();
    let text = case::text_of_line(file).map_err(CommandError::Invalid)?;
    let own = |text: &str| case::parse_of(text, &path).map_err(CommandError::Invalid);
    let read = |text: String| own(&text).map(|case| (text, case));
    let (text, case) = match words {
        [] => read(text)?,
        words => {
            let edited = set(&text, words).and_then(read);
            // What is wrong without the edits is said of the file, at its lines.
            edited.map_err(|error| own(&text).err().unwrap_or(error))?
        }
    };
    Ok(NamedCase {
        file: file_name(&name),
        name,
        text,
        case,
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
    let of_options = |found| of_options(edits, found);
    let read = kind::read_with::<K>(text, edits, path).map_err(of_options)?;
    let text = read.text.clone();
    Ok((text, read.compute().map_err(of_options)?))
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

/// A file of a kind that is read with keys set; nothing is computed yet.
pub(super) struct EditedFile<'w, K: FileKind> {
    /// With the keys.
    read: ReadFile<K>,
    /// Without.
    opened: OpenedFile,
    edits: Vec<(&'w str, &'w str)>,
}

/// The same with its answer.
pub(super) struct ComputedFile<K: FileKind> {
    /// As it is listed, and as it was without the keys.
    texts: [String; 2],
    /// Its answer.
    pub(super) computed: K::Computed,
}

impl<'w, K: FileKind> EditedFile<'w, K> {
    /// Reads a file with every `KEY=VALUE` applied to its text.
    pub(super) fn read(
        file: FileBytes,
        words: &'w [String],
        options: &ImportOptions,
    ) -> Result<Self, CommandError> {
        let opened = OpenedFile::of_bytes::<K>(file, options).map_err(CommandError::Invalid)?;
        Self::of_opened(opened, edits(words)?)
    }

    /// With more keys set after those.
    pub(super) fn with(self, words: &'w [String]) -> Result<Self, CommandError> {
        if words.is_empty() {
            return Ok(self);
        }
        let more = edits(words)?;
        Self::of_opened(self.opened, [self.edits, more].concat())
    }

    fn of_opened(opened: OpenedFile, edits: Vec<(&'w str, &'w str)>) -> Result<Self, CommandError> {
        let read = match edits.as_slice() {
            [] => opened.read().map_err(CommandError::Invalid)?,
            edits => kind::read_with(&opened.text, edits, &opened.path).map_err(|found| {
                let own = opened.read::<K>().err();
                own.map_or_else(|| of_options(edits, found), CommandError::Invalid)
            })?,
        };
        Ok(Self {
            read,
            opened,
            edits,
        })
    }

    /// What it says.
    pub(super) const fn content(&self) -> &K {
        &self.read.content
    }

    /// Its text with the keys, and the files that it names.
    pub(super) fn whole_text(&self) -> String {
        self.read.whole_text()
    }

    /// Computes it. What shows only then without the keys too is said of the file, at its lines.
    pub(super) fn compute(self) -> Result<ComputedFile<K>, CommandError> {
        let Self {
            read,
            opened,
            edits,
        } = self;
        let text = read.text.clone();
        let computed = read.compute().map_err(|found| {
            if edits.is_empty() {
                return CommandError::Invalid(opened.at_its_rows(found));
            }
            let own = opened.compute::<K>().err();
            own.map_or_else(|| of_options(&edits, found), CommandError::Invalid)
        })?;
        Ok(ComputedFile {
            texts: [text, opened.text],
            computed,
        })
    }
}

impl<K: FileKind> ComputedFile<K> {
    /// Its fields: many of a large file.
    pub(super) fn fields(&self) -> Vec<FieldRow> {
        let [now, before] = &self.texts;
        kind::edited_rows::<K>(now, before).0
    }
}

/// The fields of a file of a kind that is read with keys set, and its result.
pub(super) fn load_with<K: FileKind>(
    file: FileBytes,
    words: &[String],
    options: &ImportOptions,
) -> Result<(Vec<FieldRow>, K::Computed), CommandError> {
    let file = EditedFile::<K>::read(file, words, options)?.compute()?;
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

/// The files with trials among those named, of lines and then of systems; without names, among those below `cases` here, or else among
/// those that come with the program.
pub(super) fn with_trials(paths: &[PathBuf]) -> Result<Vec<HardCase>, CommandError> {
    let ValidationFiles { lines, others } = named(paths)?;
    let of_line = |NamedCase {
                       file, text, case, ..
                   }: NamedCase| {
        HardCase::new(file, case::stand_alone(&text, &case).into_owned(), &case)
    };
    let mut cases: Vec<HardCase> = lines.into_iter().map(of_line).collect();
    for OtherFile { name, text, .. } in systems_of(others) {
        let read = kind::read::<SystemFile>(&text, &name).map_err(CommandError::Invalid)?;
        let (file, text) = (file_name(&name), read.whole_text());
        cases.push(HardCase::new(file, text, &read.content));
    }
    cases.retain(|hard| !hard.trials.is_empty());
    if cases.is_empty() {
        let what = "There is no case with trials; a hard case has at least one table [[trial]].";
        return Err(CommandError::Usage(what.to_owned()));
    }
    Ok(cases)
}

/// The line cases named; without names, those below `cases` here, or else those that come with the program. Of these the hard
/// ones are left out, whose answers converge only where their trials say so.
pub(super) fn of_lines(paths: &[PathBuf]) -> Result<Vec<NamedCase>, CommandError> {
    let ValidationFiles { lines, others } = named(paths)?;
    let is_named = |file: &&OtherFile| paths.iter().any(|path| *path == Path::new(&file.name));
    if let Some(file) = others.iter().find(is_named) {
        return Err(CommandError::Usage(format!(
            "This study takes cases of lines; {} is {}.",
            visible::path(Path::new(&file.name)),
            file.kind.description().0
        )));
    }
    let mut cases = lines;
    if paths.is_empty() {
        cases.retain(|loaded| loaded.case.trial.is_empty());
    }
    Ok(cases)
}

/// The line cases among files that are named.
pub(super) fn lines_among(paths: &[PathBuf]) -> Result<Vec<NamedCase>, CommandError> {
    named(paths).map(|files| files.lines)
}

/// The systems among files that are named; none without names.
pub(super) fn systems(paths: &[PathBuf]) -> Result<Vec<PathBuf>, CommandError> {
    if paths.is_empty() {
        return Ok(Vec::new());
    }
    let systems = systems_of(named(paths)?.others);
    Ok(systems.map(|file| PathBuf::from(file.name)).collect())
}

/// The systems among files of other kinds than line cases.
fn systems_of(others: Vec<OtherFile>) -> impl Iterator<Item = OtherFile> {
    let others = others.into_iter();
    others.filter(|file| file.kind == FileType::System)
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
        let bytes = FileBytes::read(file);
        match bytes.kind() {
            FileType::Line => named.lines.push(load_set(bytes, &[])?),
            kind => {
                let text = bytes.utf8().map_err(unreadable)?;
                named.add(kind, file.display().to_string(), text)?;
            }
        }
    }
    Ok(named)
}

/// The case files below a directory; those of stored runs are none.
fn files_below(dir: &Path) -> Result<Vec<PathBuf>, CommandError> {
    let search = FileSearch {
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
