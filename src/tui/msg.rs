//! What reaches the state, and what the state asks of the world.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::key::KeyPress;
use super::recovery::RecoveredEdits;
use super::screen_memory::ScreenMemory;
use super::screen_memory::file::SessionMemory;
use super::settings::UserSettings;
use super::state::edit_check::{EditAnswer, EditCheck};
use super::state::job_process::{ProcessEffect, ProcessMsg};
use super::state::modes::ModesOf;
use super::state::part_request::PartRequest;
use super::state::parts::{PartKey, PartView};
use super::state::report::ReportRequest;
use super::state::ship::ShipAtSea;
use super::state::study_request::StudyRequest;
use super::state::sweep_request::{SweepEffect, SweepMsg};
use super::state::text_request::TextRequest;
use super::state::trials::{TrialProgress, TrialsOf};
use super::state::value_check::{ValidationTable, ValueCheck};
use super::state::{
    CaseEntry, DocumentContent, FileOfText, JobNumber, JobRequest, ParameterEditor, Reading,
    RunCurves, RunEntry, Severity, VariantPlan, VariedRuns,
};
use crate::case::Case;
use crate::chart::Glyphs;
use crate::modes::LineModes;
use crate::run::Run;
use crate::run::index::{RunColumns, SyncProgress};
use crate::run::job::JobEvent;
use crate::run::store::RunNotes;
use crate::ship::DynamicAnalysis;
use crate::study::vary::Variation;

/// Something happened.
#[derive(Debug, Clone)]
pub enum Msg {
    /// A key was pressed.
    Key(KeyPress),
    /// Text was pasted.
    Paste(String),
    /// The terminal has this size.
    Resize(u16, u16),
    /// A job said something.
    Job(JobNumber, Box<JobEvent>),
    /// The text of the open file as an editor left it, or all that is wrong with it.
    Edited(Result<String, String>),
    /// The natural modes of the file with this text, or why there are none.
    Modes(String, Result<Arc<LineModes>, String>),
    /// How far trials are.
    TrialProgress(JobNumber, Box<TrialProgress>),
    /// How a stored run is resumed up to a later end \[s\], or why it does not.
    ResumeReady(PathBuf, f64, Result<JobRequest, String>),
    /// A coarse run ahead of that of a job.
    Coarse(JobNumber, Arc<Run>),
    /// What a job has recorded since it was last asked.
    Recorded(JobNumber, Box<RunCurves>),
    /// The run of a job has this directory.
    Stored(JobNumber, PathBuf),
    /// A job could not be started or stored, for this reason.
    JobFailed(JobNumber, String),
    /// What is said of jobs that are processes of their own.
    Process(ProcessMsg),
    /// The cases of a directory.
    CasesRead(PathBuf, Vec<CaseEntry>),
    /// A file was read; with edits that an earlier session left behind.
    FileRead(Box<FileRead>),
    /// A ship at sea was computed, by the thread that this stops, with its validation table; nothing where it was stopped or failed.
    ShipComputed(
        Arc<AtomicBool>,
        Option<(Arc<DynamicAnalysis>, Box<ValidationTable>)>,
    ),
    /// A part of the screen is worked out.
    PartMade(Box<PartKey>, Arc<PartView>),
    /// The comparison of this token with published values is made.
    ValuesChecked(Arc<()>, Box<ValidationTable>),
    /// A case file cannot be opened: the file, and all that is wrong.
    CaseRejected(PathBuf, String),
    /// A case was saved here.
    Saved(PathBuf, String),
    /// Another program changed this file, which has this text now.
    ChangedOutside(PathBuf, String),
    /// Other files are in this directory now.
    ListChanged(PathBuf),
    /// A new file is not made, for this reason.
    NotMade(String),
    /// A case cannot be saved, for this reason.
    NotSaved(String),
    /// The file of a case is not what it was when it was read.
    ChangedOnDisk,
    /// What the index says of the runs of the open case.
    RunsListed(Box<RunsFound>),
    /// How far the index is in step with the directories of the runs.
    Indexing(SyncProgress),
    /// The variants of the case with this text.
    Planned(Box<VariantPlan>),
    /// A page that was asked for: its title and text, or why there is none; and whether a study computed it.
    Page(String, Result<String, String>, bool),
    /// How many variants of a study are computed, of how many.
    StudyProgress(usize, usize),
    /// What is said of sweeps.
    Sweep(SweepMsg),
    /// The runs of a case over ranges of its inputs.
    Varied(Box<VariedRuns>),
    /// What became of edits.
    EditsChecked(Box<EditAnswer>),
    /// The report that was asked for.
    Report(Box<ReportRequest>, String),
    /// The exact case of a stored run, for this.
    RunCase(
        PathBuf,
        RunCaseUse,
        Result<(String, DocumentContent), String>,
    ),
    /// A stored run was read.
    RunRead(PathBuf, Result<Arc<Run>, String>),
    /// Stored runs were deleted.
    RunsDeleted(Vec<PathBuf>),
    /// The live run was kept here.
    Kept(PathBuf, Arc<Run>),
    /// What the files of the user set.
    SettingsRead(Box<UserSettings>),
    /// A message to the user.
    Say(Severity, String),
}

/// A run to be compared.
#[derive(Debug, Clone)]
pub enum RunToCompare {
    /// One in memory.
    Memory(Arc<Run>),
    /// One in this directory.
    Stored(PathBuf),
}

/// What the exact case of a stored run is wanted for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunCaseUse {
    /// To be edited.
    Edit,
    /// To be run again.
    RunAgain,
}

/// What the index says of the runs of a case.
#[derive(Debug, Clone, Default)]
pub struct RunsFound {
    /// Runs that are new or have changed, oldest first.
    pub changed: Vec<RunEntry>,
    /// The numbers of all, ascending.
    pub all: Vec<i64>,
    /// The columns of the table, where they may have changed.
    pub columns: Option<RunColumns>,
    /// True when the index is in step with the directories.
    pub whole: bool,
}

/// A file as read.
#[derive(Debug, Clone)]
pub struct FileRead {
    /// Where it is.
    pub path: PathBuf,
    /// Its text as read.
    pub read: Reading,
    /// What an earlier session left unsaved.
    pub recovered: Option<RecoveredEdits>,
}

impl FileRead {
    /// A file with this text and content.
    #[must_use]
    pub fn new(
        path: PathBuf,
        text: String,
        content: DocumentContent,
        recovered: Option<RecoveredEdits>,
    ) -> Self {
        let file = FileOfText {
            kind: content.file_type(),
            name: ParameterEditor::name_of(&path),
            path,
            saved: text.clone(),
            saved_rows: None,
            before: None,
            files: BTreeMap::new(),
        };
        Self {
            read: Reading::of_text(&file, text, content),
            path: file.path,
            recovered,
        }
    }
}

/// Something to be done outside of the state.
#[derive(Debug, Clone)]
pub enum Effect {
    /// List the cases.
    ReadCases,
    /// Read a case file, or a file of another kind.
    ReadCase(PathBuf),
    /// Write the text of a case, unless the file no longer holds `expected`.
    SaveCase {
        /// Where to.
        path: PathBuf,
        /// What.
        text: String,
        /// What the file should hold; absent: whatever it holds, write.
        expected: Option<String>,
        /// Do not overwrite a file that is there.
        new: bool,
    },
    /// Watch this file or directory for changes by other programs, in place of another.
    Watch(PathBuf),
    /// Write a new file, and open it.
    NewFile {
        /// Where to.
        path: PathBuf,
        /// What.
        text: String,
    },
    /// Keep unsaved text in case the program ends badly.
    KeepRecovery {
        /// The case it belongs to.
        path: PathBuf,
        /// The text; absent: there is nothing unsaved any more.
        text: Option<String>,
        /// Ranges kept for a grid, as `KEY=VALUES`.
        kept: Vec<String>,
    },
    /// The same, and then delete what earlier sessions left of the case.
    TakeOverRecovery {
        /// The case it belongs to.
        path: PathBuf,
        /// The text; absent: there is nothing unsaved.
        text: Option<String>,
        /// Ranges kept for a grid, as `KEY=VALUES`.
        kept: Vec<String>,
    },
    /// Delete what earlier sessions left of a case.
    DropRecovery(PathBuf),
    /// Start a job.
    Start {
        /// Its number.
        ticket: JobNumber,
        /// What to compute.
        request: JobRequest,
        /// Whether its run is stored.
        store: bool,
    },
    /// Cancel a job.
    Cancel(JobNumber),
    /// Start or follow a job that is a process of its own.
    Process(ProcessEffect),
    /// Compute a ship at sea on a thread of its own.
    ComputeShip(Box<ShipAtSea>),
    /// Work out a part of the screen.
    MakePart(Box<PartRequest>),
    /// Compare runs with published values.
    CheckValues(Box<ValueCheck>),
    /// Give the terminal to the user's editor with this file, and take it back.
    EditFile(PathBuf),
    /// Find the natural modes of what is open.
    FindModes {
        /// That.
        of: ModesOf,
        /// Its text, by which the answer is known.
        text: String,
    },
    /// Compute trials of hard cases.
    StartTrials {
        /// Number of the job.
        ticket: JobNumber,
        /// Whose trials.
        of: TrialsOf,
    },
    /// Prepare to resume a stored run up to a later end \[s\].
    PrepareResume(PathBuf, f64),
    /// List the stored runs of a case file, the first, and of those beside it, with these results.
    ListRuns {
        /// Names of the case files.
        files: Vec<String>,
        /// Names of the results.
        results: Vec<String>,
    },
    /// Look for runs that are new or have changed.
    RefreshRuns,
    /// Work out the variants of a case.
    Plan {
        /// The case.
        case: Box<Case>,
        /// Its text.
        text: String,
        /// The name of its file.
        file: String,
    },
    /// Compare runs with the first of them, on so many columns, under this name.
    Compare {
        /// The runs.
        runs: Vec<RunToCompare>,
        /// Columns of the page.
        width: usize,
        /// Characters of its charts.
        glyphs: Glyphs,
        /// Its title.
        name: String,
    },
    /// Compute a study until the flag is set.
    Study(Box<StudyRequest>, Arc<AtomicBool>),
    /// List, read, judge or compute sweeps.
    Sweep(SweepEffect),
    /// Work out the runs of a variation of the case in this file.
    Vary(PathBuf, Box<Variation>),
    /// Keep what the user says of a stored run.
    WriteNotes(PathBuf, RunNotes),
    /// Read the exact case of a stored run.
    ReadRunCase {
        /// The directory of the run.
        dir: PathBuf,
        /// What for.
        wanted: RunCaseUse,
        /// The file of the open case: files that the run names are beside it.
        beside: PathBuf,
    },
    /// Apply edits to a text, and read it with them.
    CheckEdits(Box<EditCheck>),
    /// Read what the user's editor left of a file.
    ReadEdited(PathBuf),
    /// Make a text, and write it to a new file; when the name is taken, to the next free one.
    WriteMade(Box<TextRequest>),
    /// Make the report of a run.
    MakeReport(Box<ReportRequest>),
    /// Read a stored run.
    ReadRun(PathBuf),
    /// Delete stored runs.
    DeleteRuns(Vec<PathBuf>),
    /// Store a run that is in memory.
    KeepRun(Arc<Run>),
    /// Write a text to a new file; when the name is taken, to the next free one.
    WriteText {
        /// Where to.
        path: PathBuf,
        /// What.
        text: String,
        /// What it is, for the message ("The report").
        what: &'static str,
    },
    /// Copy text to the clipboard of the user's terminal, and to a file.
    Copy(String),
    /// Keep what the screen shows of a directory for the next session.
    KeepScreen(PathBuf, Box<ScreenMemory>),
    /// Keep what holds wherever the program is started.
    KeepSession(Box<SessionMemory>),
    /// Read the files of the user's settings.
    ReadSettings,
    /// Give the terminal to the user's editor with the file of keys, made with all keys as comments where there is none.
    EditKeys,
    /// Remember the glyphs for the next session.
    RememberGlyphs(Glyphs),
    /// Paint the whole screen anew.
    Repaint,
    /// Stop until `fg`.
    Suspend,
    /// End the program.
    Quit,
}
