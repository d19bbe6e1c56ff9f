//! A text read as a file of its kind: its content, its fields, and which of them are the user's.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::document_content::DocumentContent;
use super::field_rows::rows;
use super::inputs_before::InputsBefore;
use super::line::LineView;
use super::ropeway::RopewayView;
use super::section::SectionView;
use super::ship::ShipView;
use super::system::SystemView;
use crate::case::edited::{self, EditedKey};
use crate::case::file_kind::FileKind;
use crate::case::structure::{self, OutlineRow};
use crate::case::{self, Attachment, Diagnostic, kind};
use crate::facade::{self, FieldRow};
use crate::import::ImportOptions;
use crate::kinds::{FileBytes, FileType};
use crate::open::{self, OpenedFile};
use crate::ropeway::Ropeway;
use crate::section::CrossSection;
use crate::ship::Ship;
use crate::system::SystemFile;

/// A file, apart from its text.
#[derive(Debug, Clone)]
pub struct FileOfText {
    /// Its kind.
    pub kind: FileType,
    /// Where it is.
    pub path: PathBuf,
    /// Its name in messages.
    pub name: String,
    /// Its text as read or saved last.
    pub saved: String,
    /// The fields of a text that the file has or had.
    pub saved_rows: Option<Arc<SavedRows>>,
    /// What its inputs were before the user's edits; absent: those of `saved`.
    pub before: Option<Arc<InputsBefore>>,
    /// The files that it named as it was read last, with what was parsed of them.
    pub files: BTreeMap<String, Attachment>,
}

/// The fields of a file as it is on disk.
#[derive(Debug, Clone)]
pub struct SavedRows {
    /// Its text.
    pub text: String,
    /// Its fields.
    pub rows: Vec<FieldRow>,
}

/// A text as read.
#[derive(Debug, Clone)]
pub struct Reading {
    /// The text.
    pub text: String,
    /// Its content, with the validation table where that needs no runs.
    pub content: DocumentContent,
    /// Its fields.
    pub rows: Vec<FieldRow>,
    /// What it is made of.
    pub outline: Vec<OutlineRow>,
    /// The fields of the file.
    pub saved_rows: Arc<SavedRows>,
    /// What its inputs were before the user's edits.
    pub before: Arc<InputsBefore>,
    /// The inputs that are the user's.
    pub edited: Vec<EditedKey>,
}

impl Reading {
    /// Reads a text of a file.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn new(file: &FileOfText, text: String) -> Result<Self, Vec<Diagnostic>> {
        let content = content_again(file.kind, &text, (&file.path, &file.name), &file.files)?;
        Ok(Self::of_text(file, text, content))
    }

    /// The reading of a text with this content.
    #[must_use]
    pub fn of_text(file: &FileOfText, text: String, mut content: DocumentContent) -> Self {
        let before = file.before.clone();
        let before = before.unwrap_or_else(|| Arc::new(InputsBefore::new(file.kind, &file.saved)));
        let known = file.saved_rows.clone();
        let known = known.filter(|known| known.text == file.saved);
        let saved_rows = known.unwrap_or_else(|| {
            Arc::new(SavedRows {
                text: file.saved.clone(),
                rows: rows(file.kind, &file.saved),
            })
        });
        let mut rows = match text == saved_rows.text {
            true => saved_rows.rows.clone(),
            false => rows(file.kind, &text),
        };
        let edited = before.edited(&rows, &file.saved);
        edited::mark(&mut rows, &edited);
        content.kind_mut().validate(&text, &edited);
        Self {
            outline: structure::outline(facade::schema(file.kind), &text),
            text,
            content,
            rows,
            saved_rows,
            before,
            edited,
        }
    }
}

/// A text that is kept although it is not complete: tables are still missing, or name what is not there.
#[derive(Debug, Clone)]
pub struct Draft {
    /// What is wrong with it, the first fault and how many more there are, as full sentences.
    pub fault: String,
    /// Its fields.
    pub rows: Vec<FieldRow>,
    /// What it is made of.
    pub outline: Vec<OutlineRow>,
}

impl Draft {
    /// The draft of a text with these faults.
    #[must_use]
    pub fn new(kind: FileType, text: &str, faults: &[Diagnostic]) -> Self {
        let first = faults.first().map_or_else(String::new, facade::missing);
        let more = match faults.len() {
            0 | 1 => String::new(),
            2 => " One more fault is in the file.".to_owned(),
            all => format!(" {} more faults are in the file.", all - 1),
        };
        Self {
            fault: format!("{first}{more}"),
            rows: rows(kind, text),
            outline: structure::outline(facade::schema(kind), text),
        }
    }
}

/// The text of a file and its content, by the kind of the file.
///
/// # Errors
/// Everything that is wrong with the file.
pub fn read_file(path: &Path) -> Result<(String, DocumentContent), Vec<Diagnostic>> {
    read_bytes(FileBytes::read(path))
}

/// The same of a file that was read from disk.
///
/// # Errors
/// Everything that is wrong with the file.
pub fn read_bytes(bytes: FileBytes) -> Result<(String, DocumentContent), Vec<Diagnostic>> {
    let options = ImportOptions::default();
    Ok(match bytes.kind() {
        FileType::Line => {
            let file = case::load_from(bytes)?;
            (
                file.text,
                DocumentContent::Line(Box::new(LineView::new(file.case))),
            )
        }
        FileType::Section => {
            let file = open::load_from::<CrossSection>(bytes, &options)?;
            let view = SectionView::new(file.computed);
            (file.text, DocumentContent::Section(Box::new(view)))
        }
        FileType::Ropeway => {
            let file = open::load_from::<Ropeway>(bytes, &options)?;
            let view = RopewayView::new(file.computed);
            (file.text, DocumentContent::Ropeway(Box::new(view)))
        }
        FileType::Ship => {
            let file = open::load_from::<Ship>(bytes, &options)?;
            let view = ShipView::new(file.computed);
            (file.text, DocumentContent::Ship(Box::new(view)))
        }
        FileType::System => {
            let file = open::load_from::<SystemFile>(bytes, &options)?;
            let view = SystemView::new(file.computed);
            (file.text, DocumentContent::System(Box::new(view)))
        }
    })
}

/// What a list says of a file.
#[derive(Debug, Clone)]
pub struct FileTitle {
    /// Its kind.
    pub kind: FileType,
    /// Its title.
    pub title: String,
    /// The source of its data.
    pub source: String,
}

/// What a list says of a file, which is read and checked; nothing is computed.
///
/// # Errors
/// Everything that is wrong with the file.
pub fn read_title(path: &Path) -> Result<FileTitle, Vec<Diagnostic>> {
    let bytes = FileBytes::read(path);
    let kind = bytes.kind();
    let (title, source) = match kind {
        FileType::Line => {
            let about = case::load_from(bytes)?.case.case;
            (about.title, about.source)
        }
        FileType::Section => {
            let about = read::<CrossSection>(bytes)?.about;
            (about.title, about.source)
        }
        FileType::Ropeway => {
            let about = read::<Ropeway>(bytes)?.about;
            (about.title, about.source)
        }
        FileType::Ship => {
            let about = read::<Ship>(bytes)?.ship;
            (about.title, about.source)
        }
        FileType::System => {
            let about = read::<SystemFile>(bytes)?.about;
            (about.title, about.source)
        }
    };
    Ok(FileTitle {
        kind,
        title,
        source,
    })
}

fn read<K: FileKind>(bytes: FileBytes) -> Result<K, Vec<Diagnostic>> {
    let opened = OpenedFile::of_bytes::<K>(bytes, &ImportOptions::default())?;
    Ok(opened.read::<K>()?.content)
}

/// The content of a text; a case may name files beside its own.
///
/// # Errors
/// All that is wrong with it.
pub fn content(
    kind: FileType,
    text: &str,
    path: &Path,
    file: &str,
) -> Result<DocumentContent, Vec<Diagnostic>> {
    content_again(kind, text, (path, file), &BTreeMap::new())
}

/// The same of a text whose file was read before: files that it named then and that have not changed are not parsed again.
fn content_again(
    kind: FileType,
    text: &str,
    (path, file): (&Path, &str),
    known: &BTreeMap<String, Attachment>,
) -> Result<DocumentContent, Vec<Diagnostic>> {
    Ok(match kind {
        FileType::Line => {
            let case = facade::parse_at(text, (path, file), known)?;
            DocumentContent::Line(Box::new(LineView::new(case)))
        }
        FileType::Section => {
            let design = kind::parse::<CrossSection>(text, file)?;
            DocumentContent::Section(Box::new(SectionView::new(design)))
        }
        FileType::Ropeway => {
            let worked = kind::parse::<Ropeway>(text, file)?;
            DocumentContent::Ropeway(Box::new(RopewayView::new(worked)))
        }
        FileType::Ship => {
            let statics = kind::parse::<Ship>(text, file)?;
            DocumentContent::Ship(Box::new(ShipView::new(statics)))
        }
        FileType::System => {
            let solved = kind::read_again::<SystemFile>(text, file, known)?.compute()?;
            DocumentContent::System(Box::new(SystemView::new(solved)))
        }
    })
}
