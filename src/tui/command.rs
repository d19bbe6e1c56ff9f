//! What commands there are, and the tables of those that several panes share. Each pane lists its own.

/// What a command does, in the words of its [`Command::doc`].
#[expect(
    missing_docs,
    reason = "every command has one line of help where it is listed"
)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CommandId {
    Open,
    Filter,
    Reload,
    Edit,
    Reset,
    DropRange,
    ExternalEditor,
    Undo,
    Redo,
    Save,
    NextGroup,
    PreviousGroup,
    Run,
    Method,
    Study,
    Validate,
    Keep,
    NextTable,
    PreviousTable,
    LineInput,
    NextTrace,
    KeepPosition,
    NextChart,
    PreviousChart,
    NextSeries,
    PreviousSeries,
    CursorLeft,
    CursorRight,
    PanLeft,
    PanRight,
    ZoomIn,
    ZoomOut,
    Fit,
    Mark,
    FitHeight,
    PanUp,
    PanDown,
    LeapLeft,
    LeapRight,
    Freeze,
    Limits,
    Curves,
    Difference,
    LogUp,
    LogAlong,
    Copy,
    ShowAlone,
    Select,
    SelectNone,
    Trials,
    Resume,
    Delete,
    MarkAll,
    HoldAgainst,
    Compare,
    Statistics,
    InputEffects,
    Physics,
    StepUp,
    StepDown,
    LeapUp,
    LeapDown,
    Fold,
    Zoom,
    NameRun,
    TagRuns,
    NoteRun,
    PlotColumns,
    RunCase,
    RunAgain,
    SortAround,
    ColumnLeft,
    ColumnRight,
    Explain,
    HideColumn,
    ShowColumns,
    CancelJob,
    ScrollLeft,
    ScrollRight,
    Sort,
    Write,
    WriteAs,
    WritePicture,
    Down,
    Up,
    PageDown,
    PageUp,
    Top,
    Bottom,
    NextPane,
    PreviousPane,
    /// Pane by its number, counted from 1.
    Pane(u8),
    Back,
    Help,
    Palette,
    Glyphs,
    Keys,
    ReadSettings,
    Tutorial,
    TutorialSkip,
    Messages,
    Redraw,
    Interrupt,
    Suspend,
    Quit,
    AddLineType,
    Sweep,
    StartSweep,
    NextResult,
    PreviousResult,
    AxisAcross,
    AxisDown,
    Rule,
    HoldNext,
    HoldPrevious,
    OtherAxis,
    NextSweep,
    PreviousSweep,
    Model,
    NewFile,
    Add,
    Remove,
    CopyTable,
    Rename,
    Divide,
    MoveUp,
    MoveDown,
}

/// A command with its keys. Keys, footer, `?` help and `:` palette come from these alone.
#[derive(Debug, Clone, Copy)]
pub struct Command {
    /// What it does.
    pub id: CommandId,
    /// Its keys, the one shown in the footer first.
    pub keys: &'static [&'static str],
    /// Two words for the footer; empty: not in the footer.
    pub label: &'static str,
    /// One line for help and palette.
    pub doc: &'static str,
    /// Position in footer, help and palette; commands of the same order stay as listed.
    pub order: CommandOrder,
}

/// Where a command appears in footer, help and palette.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum CommandOrder {
    /// The main commands of a pane.
    Main,
    /// The main commands of a kind of file.
    Kind,
    /// To the next pane.
    Next,
    /// Write what a pane shows.
    Write,
    /// Save, undo, back.
    Document,
    /// Filter, solver, study and the like.
    Setup,
    /// The other commands of a pane.
    Other,
    /// The other commands of a document.
    Rare,
    /// Cursor and scrolling.
    Motion,
    /// To a pane by its number.
    Pane,
    /// What works everywhere.
    Everywhere,
}

/// A command of this order.
#[must_use]
pub const fn command(
    order: CommandOrder,
    id: CommandId,
    keys: &'static [&'static str],
    label: &'static str,
    doc: &'static str,
) -> Command {
    Command {
        id,
        keys,
        label,
        doc,
        order,
    }
}

/// A main command of a pane.
#[must_use]
pub const fn main(
    id: CommandId,
    keys: &'static [&'static str],
    label: &'static str,
    doc: &'static str,
) -> Command {
    command(CommandOrder::Main, id, keys, label, doc)
}

/// Another command of a pane; without a label it is in help and palette only.
#[must_use]
pub const fn other(
    id: CommandId,
    keys: &'static [&'static str],
    label: &'static str,
    doc: &'static str,
) -> Command {
    command(CommandOrder::Other, id, keys, label, doc)
}

/// The command that writes what a pane shows.
#[must_use]
pub const fn write(doc: &'static str) -> Command {
    command(CommandOrder::Write, CommandId::Write, &["w"], "write", doc)
}

/// The command that writes a report in another format, of the report pane and of files that have a report and no such pane.
#[rustfmt::skip]
pub const WRITE_AS: Command = command(CommandOrder::Write, CommandId::WriteAs, &["F"], "format", "Write the report as HTML, Markdown, text, CSV or JSON");
const WRITE_MODEL_AS: Command = Command {
    label: "",
    order: CommandOrder::Rare,
    ..WRITE_AS
};

/// Sorts the table of a pane.
#[rustfmt::skip]
pub const SORT: Command = other(CommandId::Sort, &["o"], "sort", "Sort by the column under the cursor, then the other way round, then in the original order; without a cursor by the next column");

/// What a column of a table is.
#[rustfmt::skip]
pub const EXPLAIN: Command = other(CommandId::Explain, &["i"], "column", "Say what the column under the cursor is, its unit, and where it comes from");

/// Takes a column out of the table.
#[rustfmt::skip]
pub const HIDE_COLUMN: Command = other(CommandId::HideColumn, &["-"], "", "Hide the column under the cursor");

/// Brings hidden columns back.
#[rustfmt::skip]
pub const SHOW_COLUMNS: Command = other(CommandId::ShowColumns, &["+"], "", "Show all columns of the table again");

/// Of a table whose columns have a cursor.
#[rustfmt::skip]
pub const TABLE: &[Command] = &[
    FILTER,
    SORT,
    EXPLAIN,
    HIDE_COLUMN,
    SHOW_COLUMNS,
    other(CommandId::SortAround, &["O"], "", "Sort the other way round"),
];

/// The cursor from column to column.
#[rustfmt::skip]
pub const COLUMNS: &[Command] = &[
    command(CommandOrder::Motion, CommandId::ColumnRight, &["l", "right"], "", "To the next column of the table"),
    command(CommandOrder::Motion, CommandId::ColumnLeft, &["h", "left"], "", "To the previous column of the table"),
];

/// Adds a material to a file that has materials.
#[rustfmt::skip]
const ADD_LINE_TYPE: Command = command(CommandOrder::Rare, CommandId::AddLineType, &["A"], "", "Add a line type: chain, wire or fibre rope by nominal diameter, as a material at the end of the file");

/// Computes the load cases of a file.
#[rustfmt::skip]
const START_SWEEP: Command = command(CommandOrder::Kind, CommandId::StartSweep, &["W"], "sweep", "Compute all load cases in the background; a sweep of them that was stopped goes on");

/// Shows the load cases of a file.
#[rustfmt::skip]
const SWEEP: Command = command(CommandOrder::Kind, CommandId::Sweep, &["C"], "load cases", "Go to the load cases: heat map, table, checks");

/// Computes the trials of a line case or of a system.
#[rustfmt::skip]
const TRIALS: Command = command(CommandOrder::Rare, CommandId::Trials, &["T"], "trials", "Compute the trials of this hard case, and compare them with the results required");

/// Of a line case.
#[rustfmt::skip] // a table: one command a line
pub const LINE: &[Command] = &[
    command(CommandOrder::Kind, CommandId::Run, &["R"], "run", "Run the case with the chosen solver and store the run"),
    command(CommandOrder::Kind, CommandId::Validate, &["V"], "validate", "Run everything that the validation table needs"),
    command(CommandOrder::Setup, CommandId::Method, &["M"], "solver", "Change to the next solver: static, quasi, rk4, alpha"),
    command(CommandOrder::Setup, CommandId::Study, &["S"], "study", "Run all variants of a study and overlay them"),
    command(CommandOrder::Setup, CommandId::Keep, &["K"], "keep", "Keep the live run on disk"),
    TRIALS,
    START_SWEEP,
    SWEEP,
    ADD_LINE_TYPE,
];

/// Of a file other than a line case.
#[rustfmt::skip]
pub const MODEL: &[Command] = &[
    command(CommandOrder::Kind, CommandId::LineInput, &["M"], "for line", "Write the input for a line case to a file: a section's material, a ropeway's rope, the motion of a ship's hang point"),
    command(CommandOrder::Rare, CommandId::Write, &["w"], "write", "Write the report to a text file; from the validation pane: its table; from a section's drawing: the drawing"),
    WRITE_MODEL_AS,
    command(CommandOrder::Rare, CommandId::Copy, &["y"], "copy", "Copy the table [materials.<name>] to the clipboard of your terminal, and write it to a file"),
];

/// Of a system of lines at rest: a file that has a report and nothing for a line case.
#[rustfmt::skip]
pub const REPORTED: &[Command] = &[
    ADD_LINE_TYPE,
    command(CommandOrder::Rare, CommandId::Write, &["w"], "write", "Write the report to a text file; from the validation pane: its table"),
    WRITE_MODEL_AS,
    TRIALS,
    START_SWEEP,
    SWEEP,
];

/// Of a system of lines that is computed in time.
#[rustfmt::skip]
pub const MOVING: &[Command] = &[
    command(CommandOrder::Kind, CommandId::Run, &["R"], "run", "Compute the system in time and store the run"),
    REPORTED[0],
    REPORTED[1],
    WRITE_MODEL_AS,
    TRIALS,
    START_SWEEP,
    SWEEP,
];

/// Of every open file.
#[rustfmt::skip]
pub const DOCUMENT: &[Command] = &[
    command(CommandOrder::Next, CommandId::NextPane, &["tab"], "pane", "Go to the next pane"),
    command(CommandOrder::Document, CommandId::Save, &["s"], "save", "Save the case to its file, with your comments kept"),
    command(CommandOrder::Document, CommandId::Undo, &["u"], "undo", "Undo the last edit"),
    command(CommandOrder::Setup, CommandId::Model, &["B"], "build", "Go to the model: add, remove, divide, rename and order what the file is made of"),
    command(CommandOrder::Document, CommandId::Back, &["esc", "b"], "cases", "Back to the list of cases"),
    command(CommandOrder::Rare, CommandId::Redo, &["U", "ctrl+r"], "", "Redo the edit undone last"),
    command(CommandOrder::Motion, CommandId::PreviousPane, &["shift+tab"], "", "Go to the previous pane"),
];

/// Filter of a list.
#[rustfmt::skip]
pub const FILTER: Command = command(CommandOrder::Setup, CommandId::Filter, &["/"], "filter", "Type words that the lines must hold, or letters of them in their order; Enter keeps, Esc drops the filter");

/// The cursor one line down.
#[rustfmt::skip]
pub const DOWN: Command = command(CommandOrder::Motion, CommandId::Down, &["j", "down"], "", "Down");

/// What several panes have, each in a table of its own.
pub const SHARED: &[Command] = &[
    FILTER,
    SORT,
    DOWN,
    write("Write what the pane shows to a file"),
];

/// Cursor and scrolling in a list, without [`DOWN`].
#[rustfmt::skip]
pub const LIST: &[Command] = &[
    command(CommandOrder::Motion, CommandId::Up, &["k", "up"], "", "Up"),
    command(CommandOrder::Motion, CommandId::PageDown, &["pgdn", "ctrl+d"], "", "A page down"),
    command(CommandOrder::Motion, CommandId::PageUp, &["pgup", "ctrl+u"], "", "A page up"),
    command(CommandOrder::Motion, CommandId::Top, &["g", "home"], "", "To the first line"),
    command(CommandOrder::Motion, CommandId::Bottom, &["G", "end"], "", "To the last line"),
];

/// Scrolling of what may be wider than the screen.
#[rustfmt::skip]
pub const WIDE: &[Command] = &[
    command(CommandOrder::Motion, CommandId::ScrollRight, &["l", "right"], "", "Scroll right"),
    command(CommandOrder::Motion, CommandId::ScrollLeft, &["h", "left"], "", "Scroll left"),
];

/// What works everywhere.
#[rustfmt::skip]
pub const EVERYWHERE: &[Command] = &[
    command(CommandOrder::Everywhere, CommandId::Help, &["?", "f1"], "help", "Show every key that works here"),
    command(CommandOrder::Everywhere, CommandId::Palette, &[":"], "", "Find a command by its name"),
    command(CommandOrder::Everywhere, CommandId::Glyphs, &[], "", "Change between braille and ASCII characters, and remember it"),
    command(CommandOrder::Everywhere, CommandId::Keys, &[], "", "Open your file of keys in $VISUAL or $EDITOR, and take the keys as they are then"),
    command(CommandOrder::Everywhere, CommandId::ReadSettings, &[], "", "Read your files of keys and settings again"),
    command(CommandOrder::Everywhere, CommandId::Tutorial, &["ctrl+t"], "", "Begin the tutorial of five minutes, or leave it and go on later"),
    command(CommandOrder::Everywhere, CommandId::TutorialSkip, &["ctrl+n"], "", "Skip a step of the tutorial"),
    command(CommandOrder::Everywhere, CommandId::Messages, &["!"], "", "Show the messages so far in full"),
    command(CommandOrder::Everywhere, CommandId::Redraw, &["ctrl+l"], "", "Paint the screen anew"),
    command(CommandOrder::Everywhere, CommandId::Interrupt, &["ctrl+c"], "", "Cancel the running job; pressed again: quit"),
    command(CommandOrder::Everywhere, CommandId::Suspend, &["ctrl+z"], "", "Stop the program; `fg` in the shell brings it back"),
    command(CommandOrder::Everywhere, CommandId::Quit, &["q"], "quit", "Quit (asks when work would be lost)"),
];

/// The key of a pane by its number, counted from 1.
#[must_use]
pub fn pane(number: usize, doc: &'static str) -> Option<Command> {
    const KEYS: &[&str] = &["1", "2", "3", "4", "5", "6", "7", "8", "9", "0"];
    let keys = KEYS.get(number.checked_sub(1)?..number)?;
    let id = CommandId::Pane(u8::try_from(number).ok()?);
    Some(command(CommandOrder::Pane, id, keys, "", doc))
}
