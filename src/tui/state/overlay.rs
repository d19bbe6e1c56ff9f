//! What lies over the screen and takes the keys.

use std::path::PathBuf;

use tui_input::Input;

use super::case_list::Filter;
use super::command_line::CommandLine;
use super::form::Form;
use super::picker::Picker;
use crate::column_plot::ColumnPair;
use crate::recovery::RecoveredEdits;
use crate::report::document::ReportFormat;

/// What lies over the screen.
#[derive(Debug, Clone)]
pub enum Overlay {
    /// The keys that work here.
    Help {
        /// First line shown.
        scroll: usize,
        /// The filter of the keys.
        filter: Filter,
    },
    /// The line on which a command is typed.
    Palette(CommandLine),
    /// The messages so far.
    Messages {
        /// Lines scrolled up from the newest.
        scroll: usize,
        /// The filter of the messages.
        filter: Filter,
    },
    /// What a column is, until the next key.
    Explanation {
        /// Its head.
        title: String,
        /// What it is.
        text: String,
    },
    /// A text to read, such as all that is wrong with a case file.
    Text {
        /// Title of the frame.
        title: String,
        /// The text.
        text: String,
        /// First line shown.
        scroll: usize,
        /// The file that it is about, to be opened in the user's editor.
        file: PathBuf,
    },
    /// A page that can be written to a file.
    Page {
        /// Title of the frame.
        title: String,
        /// The text.
        text: String,
        /// First line shown.
        scroll: usize,
    },
    /// A question with an answer a key.
    Ask(Question),
    /// The studies of the case, to choose one from.
    Studies {
        /// The lines.
        items: Vec<String>,
        /// Cursor.
        cursor: usize,
    },
    /// The curves of the chart, to be shown or hidden one by one.
    Curves {
        /// Cursor.
        cursor: usize,
    },
    /// The library of line types, to add one as a material.
    LineTypes(LineTypePicker),
    /// A list to choose one thing from.
    Picker(Picker),
    /// A form to fill in.
    Form(Box<Form>),
    /// A column of the table of runs against another.
    Columns(ColumnPair),
    /// A line to type.
    Prompt {
        /// What it is for.
        purpose: PromptPurpose,
        /// What is typed.
        input: Input,
        /// What to know about it, or why the last answer was refused.
        words: String,
    },
}

/// A line type being chosen, and its nominal diameter being typed.
#[derive(Debug, Clone, Default)]
pub struct LineTypePicker {
    /// Number of the type in the library.
    pub cursor: usize,
    /// The nominal diameter as typed.
    pub input: Input,
    /// Why what was typed is refused; empty where nothing is.
    pub problem: String,
}

/// What the user may say of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunText {
    /// A name.
    Name,
    /// Tags.
    Tags,
    /// A note.
    Note,
}

/// What a typed line is for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PromptPurpose {
    /// The time \[s\] up to which the run in this directory is resumed.
    Resume(PathBuf),
    /// A text about these runs.
    RunText {
        /// Which.
        what: RunText,
        /// Their directories.
        dirs: Vec<PathBuf>,
    },
    /// Another file name, for a case whose own file cannot be written.
    SaveAs,
}

/// A question.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Question {
    /// Unsaved edits are in the way of leaving the case; `quit` when the program is left too.
    Unsaved {
        /// Leave the program, not only the case.
        quit: bool,
    },
    /// Jobs are in the way of quitting.
    JobsRunning,
    /// Jobs go on when the program ends.
    JobsGoOn {
        /// How many.
        count: usize,
        /// Why they do not, where the system ends them.
        warning: Option<String>,
    },
    /// Stored runs are to be deleted.
    DeleteRuns {
        /// Their directories.
        dirs: Vec<PathBuf>,
        /// What they are, in words.
        what: String,
    },
    /// Edits of an earlier session were kept.
    Recover {
        /// The text with those edits, and ranges that wait.
        left: RecoveredEdits,
    },
    /// The file changed on disk since it was read.
    Overwrite,
    /// The format in which a report is written.
    ReportFormat,
    /// A range that is typed into a field makes many runs.
    ManyRuns {
        /// How many.
        count: usize,
    },
}

impl Question {
    /// The format that a key chooses where the format of a report is asked for.
    #[must_use]
    pub const fn format_of(key: char) -> Option<ReportFormat> {
        Some(match key {
            'h' => ReportFormat::Html,
            'm' => ReportFormat::Markdown,
            't' => ReportFormat::Text,
            'v' => ReportFormat::Csv,
            'j' => ReportFormat::Json,
            _ => return None,
        })
    }

    /// The question, and its answers as key and meaning. Esc always means the last one.
    #[must_use]
    pub fn wording(&self) -> (String, &'static [(char, &'static str)]) {
        match self {
            Self::Unsaved { .. } => (
                "This case has changes that are not saved.".to_owned(),
                &[('s', "save them"), ('d', "drop them"), ('c', "stay here")],
            ),
            Self::JobsRunning => (
                "Jobs are running. What they have so far is kept and marked as partial; \
                 this question closes when they end."
                    .to_owned(),
                &[('q', "stop them and quit"), ('c', "stay here")],
            ),
            Self::JobsGoOn { count, warning } => (
                jobs_go_on(*count, warning.as_deref()),
                &[
                    ('q', "quit; they go on"),
                    ('x', "cancel them and quit"),
                    ('c', "stay here"),
                ],
            ),
            Self::DeleteRuns { dirs, what } => (
                format!("Delete {what} with all files? This cannot be undone."),
                if dirs.len() == 1 {
                    &[('d', "delete"), ('c', "keep it")]
                } else {
                    &[('d', "delete"), ('c', "keep them")]
                },
            ),
            Self::Recover { .. } => (
                "An earlier session ended before its edits of this case were saved.".to_owned(),
                &[
                    ('r', "bring them back"),
                    ('d', "drop them"),
                    ('c', "decide later"),
                ],
            ),
            Self::ManyRuns { count } => (
                format!("This makes {count} runs; each is computed and stored."),
                &[('r', "run them"), ('c', "edit the range")],
            ),
            Self::ReportFormat => ("Write the report as:".to_owned(), REPORT_FORMATS),
            Self::Overwrite => (
                "The file has changed on disk since it was opened.".to_owned(),
                &[
                    ('o', "overwrite it"),
                    ('a', "save under another name"),
                    ('c', "leave it"),
                ],
            ),
        }
    }
}

/// Keys of the formats of a report, as [`Question::format_of`] has them.
const REPORT_FORMATS: &[(char, &str)] = &[
    ('h', "HTML with its charts, for browser and printer"),
    ('m', "Markdown"),
    ('t', "text"),
    ('v', "CSV of the results"),
    ('j', "JSON of the results"),
    ('c', "do not write it"),
];

fn jobs_go_on(count: usize, warning: Option<&str>) -> String {
    let jobs = format!(
        "Jobs are running: {count}. They go on without this screen; the next `seacable` shows them again."
    );
    warning.map_or(jobs.clone(), |warning| format!("{jobs} But {warning}"))
}
