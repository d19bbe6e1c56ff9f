//! What differs between the kinds of file on the screen.

use std::path::PathBuf;

use super::parts::ScreenPart;
use super::value_check::ValidationTable;
use crate::case::EditedKey;
use crate::command::{Command, CommandId, MODEL};
use crate::facade::FieldRow;
use crate::pane::PaneId;
use crate::report::subject::ReportSubject;

/// A kind of file and its panes, and what is said of one file.
#[derive(Debug, Clone, Copy)]
pub struct KindInfo<'a> {
    /// Name of the kind.
    pub name: &'static str,
    /// The title of this file.
    pub title: &'a str,
    /// The source of its data.
    pub source: &'a str,
    /// Its panes, in the order of their numbers.
    pub panes: &'static [PaneId],
    /// The pane that has the focus at first.
    pub first: PaneId,
    /// The names of the tabs of its tables pane.
    pub tabs: &'static [&'static str],
}

/// What the screen needs of a kind of file. A `source` gives path and name of the file of a text.
pub trait DocumentKind {
    /// The kind with its panes, and title and source of this file.
    fn info(&self) -> KindInfo<'_>;

    /// What the first line of the screen says of it.
    fn headline(&self) -> String {
        self.info().name.to_owned()
    }

    /// What the user has chosen that a part depends on besides the inputs.
    fn choice(&self, _part: ScreenPart) -> u64 {
        0
    }

    /// Whether a part is of an analysis that is older than the inputs, and is being made anew.
    fn is_behind(&self, _part: ScreenPart) -> bool {
        false
    }

    /// Works out what is shown of a text beside its result: analyses, and the validation table, of whose inputs these are the user's.
    /// For the threads behind the screen.
    fn validate(&mut self, _text: &str, _edited: &[EditedKey]) {}

    /// The validation table, where its kind has one.
    fn checks(&self) -> Option<&ValidationTable> {
        None
    }

    /// What it computes in the background, in a few words.
    fn busy(&self) -> Option<&'static str> {
        None
    }

    /// Stops what it computes in the background.
    fn stop(&mut self) {}

    /// End of the file name of its report, and the name of the report in a message.
    fn report_name(&self) -> (&'static str, &'static str) {
        ("report", "The report")
    }

    /// What its report is of, with the fields of its text; absent where there is no result. For the threads behind the screen.
    fn report<'a>(&'a self, _rows: &'a [FieldRow]) -> Option<ReportSubject<'a>> {
        None
    }

    /// Its own commands, whatever pane has the focus.
    fn commands(&self) -> &'static [Command] {
        MODEL
    }

    /// Why one of them cannot be done now.
    fn reason(&self, id: CommandId) -> Option<&'static str> {
        (id == CommandId::Copy && self.copy().is_none()).then_some(
            "Only the material of a cross-section is copied; `:line_input` writes it to a file.",
        )
    }

    /// The text for the clipboard.
    fn copy(&self) -> Option<&str> {
        None
    }

    /// Input for a line case: the name of a file beside `stem`, its text, and what it is. For the threads behind the screen.
    fn line_input(&self, _stem: &str) -> (PathBuf, Option<String>, &'static str) {
        (PathBuf::new(), None, "")
    }
}
