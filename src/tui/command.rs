//! The one table of commands. Keys, footer, `?` help and `:` palette are views of it.

use super::key::Key;
use super::pane::{
    CASES, CHARTS, DOWN, DRAWING, EVERYWHERE, IN_CASE, IN_FILE, IN_SHEET, INPUTS, JOBS, LISTS,
    MODES, NODES, PaneId, ROPEWAY, RUNS, TABLES, TRIALS, WIDE, WRITABLE,
};

/// What a command does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Id {
    /// Open the case under the cursor.
    Open,
    /// Type a filter for the list.
    Filter,
    /// Read the list of cases again.
    Reload,
    /// Edit the value under the cursor.
    Edit,
    /// Put the field back to the value of the file.
    Reset,
    /// Open the file in the user's editor.
    ExternalEditor,
    /// Undo the last edit.
    Undo,
    /// Redo the edit undone last.
    Redo,
    /// Save the case to its file.
    Save,
    /// Go to the next group of fields.
    NextGroup,
    /// Go to the previous group of fields.
    PreviousGroup,
    /// Run the case and store the run.
    Run,
    /// Change to the next solver.
    Method,
    /// Run all variants of a study.
    Study,
    /// Run everything the validation table needs.
    Validate,
    /// Keep the live run on disk.
    Keep,
    /// Show the next tab of the tables.
    NextTable,
    /// Show the previous tab of the tables.
    PreviousTable,
    /// Write what a line case takes over.
    HandOver,
    /// Draw the next motion of the ship alone.
    NextTrace,
    /// Go to the next span of the ropeway.
    NextSpan,
    /// Go to the previous span of the ropeway.
    PreviousSpan,
    /// Keep the cargo's place in the file.
    KeepPlace,
    /// Show the next chart.
    NextChart,
    /// Show the previous chart.
    PreviousChart,
    /// Show the next joint or component alone.
    NextSeries,
    /// Show the previous joint or component alone.
    PreviousSeries,
    /// Chart cursor left.
    CursorLeft,
    /// Chart cursor right.
    CursorRight,
    /// Pan left.
    PanLeft,
    /// Pan right.
    PanRight,
    /// Zoom in about the cursor.
    ZoomIn,
    /// Zoom out about the cursor.
    ZoomOut,
    /// Show everything.
    Fit,
    /// Set or remove a mark at the cursor.
    Mark,
    /// Fit the height to what is seen.
    FitUp,
    /// Pan up.
    PanUp,
    /// Pan down.
    PanDown,
    /// Cursor by large steps to the left.
    LeapLeft,
    /// Cursor by large steps to the right.
    LeapRight,
    /// Freeze the live curves.
    Freeze,
    /// Copy the values at the cursor.
    Copy,
    /// Show one run alone.
    ShowAlone,
    /// Add or remove a run on the charts.
    Select,
    /// Show only the live run.
    SelectNone,
    /// Compute the trials of the case, or of all hard cases.
    Trials,
    /// Go on with a stored run up to a later end.
    Resume,
    /// Delete a stored run.
    Delete,
    /// Cancel the job under the cursor.
    CancelJob,
    /// Table to the left.
    ScrollLeft,
    /// Table to the right.
    ScrollRight,
    /// Sort the table by its next column.
    Sort,
    /// Write what the pane shows to a file.
    Write,
    /// Cursor down.
    Down,
    /// Cursor up.
    Up,
    /// A page down.
    PageDown,
    /// A page up.
    PageUp,
    /// To the first line.
    Top,
    /// To the last line.
    Bottom,
    /// Next pane.
    NextPane,
    /// Previous pane.
    PreviousPane,
    /// Pane by its number, counted from 1.
    Pane(u8),
    /// Back to the case list.
    Back,
    /// Help.
    Help,
    /// Command palette.
    Palette,
    /// Change between braille and ASCII.
    Glyphs,
    /// The messages so far.
    Messages,
    /// Paint the screen anew.
    Redraw,
    /// Cancel the job of this pane; again: quit.
    Interrupt,
    /// Stop the program, `fg` brings it back.
    Suspend,
    /// Quit.
    Quit,
}

/// A line of the table.
#[derive(Debug, Clone, Copy)]
pub struct Command {
    /// What it does.
    pub id: Id,
    /// Its keys, the one shown in the footer first.
    pub keys: &'static [&'static str],
    /// Two words for the footer; empty: not in the footer.
    pub label: &'static str,
    /// One line for help and palette.
    pub doc: &'static str,
    /// Where it applies.
    pub places: &'static [PaneId],
}

const fn command(
    id: Id,
    keys: &'static [&'static str],
    label: &'static str,
    doc: &'static str,
    places: &'static [PaneId],
) -> Command {
    Command {
        id,
        keys,
        label,
        doc,
        places,
    }
}

/// Every command, in the order in which the footer offers them.
#[rustfmt::skip] // a table: one command a line
pub const COMMANDS: &[Command] = &[
    command(Id::Open, &["enter", "l", "right"], "open", "Open the case under the cursor", CASES),
    command(Id::Edit, &["enter", "e"], "edit", "Edit the value under the cursor", INPUTS),
    command(Id::ShowAlone, &["enter"], "show", "Show this run alone on the charts, in the table and in the report", RUNS),
    command(Id::Select, &["space"], "overlay", "Add this run to the charts or take it off", RUNS),
    command(Id::Resume, &["c"], "go on", "Go on with this stored run, from where it stands, up to a time that is asked for", RUNS),
    command(Id::CancelJob, &["x", "d"], "cancel", "Cancel the job under the cursor", JOBS),
    command(Id::CancelJob, &["x"], "stop", "Stop computing the trials", TRIALS),
    command(Id::Sort, &["o"], "sort", "Sort by the next column; after the last: as it came", TRIALS),
    command(Id::Write, &["w"], "write", "Write the table to a text file", TRIALS),
    command(Id::Trials, &["T"], "anew", "Compute the trials anew", TRIALS),
    command(Id::Back, &["esc", "b"], "back", "Back to where you were; the trials go on", TRIALS),
    command(Id::NextChart, &["]", "n"], "chart", "Show the next chart", CHARTS),
    command(Id::NextSeries, &["j", "down"], "curve", "Show the next joint or component alone; after the last: all of them", CHARTS),
    command(Id::CursorRight, &["l", "right"], "cursor", "Move the cursor right; on the line's shape: a later instant", CHARTS),
    command(Id::ZoomIn, &["+", "="], "zoom", "Zoom in about the cursor", CHARTS),
    command(Id::Down, &["j", "down"], "mode", "Select the next mode", MODES),
    command(Id::NextChart, &["]", "n"], "picture", "Show the mode along the line, or over the line at rest", MODES),
    command(Id::Write, &["w"], "write", "Write the modes with their shapes as CSV", MODES),
    command(Id::NextTable, &["]", "n"], "table", "Show the next table", TABLES),
    command(Id::NextTable, &["]", "n"], "table", "Show the next table of the line", NODES),
    command(Id::NextTrace, &["c"], "motion", "Draw the next of a ship's six motions alone; after the last: all of them", TABLES),
    command(Id::ZoomIn, &["+", "="], "zoom", "Zoom in about the middle", DRAWING),
    command(Id::PanLeft, &["h", "left", "H"], "left", "Show what lies further left", DRAWING),
    command(Id::PanDown, &["j", "down", "{"], "down", "Show what lies lower", DRAWING),
    command(Id::PanUp, &["k", "up", "}"], "up", "Show what lies higher", DRAWING),
    command(Id::PanRight, &["l", "right", "L"], "right", "Show what lies further right", DRAWING),
    command(Id::CursorRight, &["l", "right"], "to ship", "Move the cargo towards the ship", ROPEWAY),
    command(Id::CursorLeft, &["h", "left"], "to platform", "Move the cargo towards the platform", ROPEWAY),
    command(Id::NextSpan, &["]", "n"], "span", "Go to the next span of 40, 60 and 80 m; an edit like any other", ROPEWAY),
    command(Id::Fit, &["0"], "file's place", "Put the cargo back where the file has it", ROPEWAY),
    command(Id::KeepPlace, &["K"], "keep place", "Set cargo.position in the file to where the cargo is", ROPEWAY),
    command(Id::HandOver, &["M"], "for line", "Write what a line case takes over to a file: a section's material, a ropeway's rope, the motion of a ship's hang point", IN_SHEET),
    command(Id::Run, &["R"], "run", "Run the case with the chosen solver and store the run", IN_CASE),
    command(Id::Validate, &["V"], "validate", "Run everything that the validation table needs", IN_CASE),
    command(Id::NextPane, &["tab"], "pane", "Go to the next pane", IN_FILE),
    command(Id::Write, &["w"], "write", "Write what this pane shows to a text file; the report into its run, the nodes as CSV", WRITABLE),
    command(Id::Save, &["s"], "save", "Save the case to its file, with your comments kept", IN_FILE),
    command(Id::Undo, &["u"], "undo", "Undo the last edit", IN_FILE),
    command(Id::Back, &["esc", "b"], "cases", "Back to the list of cases", IN_FILE),
    command(Id::Filter, &["/"], "filter", "Type letters that the lines must contain; Enter keeps, Esc drops the filter", &[PaneId::Cases, PaneId::Inputs, PaneId::Keys]),
    command(Id::Method, &["M"], "solver", "Change to the next solver: static, quasi, rk4, alpha", IN_CASE),
    command(Id::Study, &["S"], "study", "Run all variants of a study and overlay them", IN_CASE),
    command(Id::Keep, &["K"], "keep", "Keep the live run on disk", IN_CASE),
    command(Id::SelectNone, &["a"], "live only", "Show the live run only", RUNS),
    command(Id::Delete, &["d"], "delete", "Delete this stored run (asks first)", RUNS),
    command(Id::Sort, &["o"], "sort", "Sort by the next column; after the last: as it came", &[PaneId::Validation, PaneId::Nodes]),
    command(Id::Fit, &["0"], "fit", "Show everything again, at the newest instant", CHARTS),
    command(Id::Freeze, &["f"], "freeze", "Hold the curves still while the job goes on, or let them go on", CHARTS),
    command(Id::ExternalEditor, &["E"], "editor", "Open the file in $VISUAL or $EDITOR, and read it again afterwards", INPUTS),
    command(Id::Reset, &["r"], "reset", "Put the field back to the value of the file", INPUTS),
    command(Id::Fit, &["0"], "fit", "Show the whole cross-section again", DRAWING),
    command(Id::ZoomOut, &["-"], "", "Zoom out about the middle", DRAWING),
    command(Id::PreviousTable, &["[", "p"], "", "Show the previous table", TABLES),
    command(Id::PreviousTable, &["[", "p"], "", "Show the previous table of the line", NODES),
    command(Id::Sort, &["o"], "sort", "Sort by the next column; after the last: as it came", &[PaneId::Tables, PaneId::Checks]),
    command(Id::Write, &["w"], "write", "Write the report to a text file; from the validation pane: its table; from a section's drawing: the drawing", IN_SHEET),
    command(Id::LeapRight, &["L", "pgdn"], "", "Move the cargo towards the ship by a tenth of the span", ROPEWAY),
    command(Id::LeapLeft, &["H", "pgup"], "", "Move the cargo towards the platform by a tenth of the span", ROPEWAY),
    command(Id::PreviousSpan, &["[", "p"], "", "Go to the previous span of 40, 60 and 80 m", ROPEWAY),
    command(Id::Pane(4), &["4"], "", "Go to the validation table", IN_SHEET),
    command(Id::Copy, &["y"], "copy", "Copy the table [materials.<name>] to the clipboard of your terminal, and write it to a file", IN_SHEET),
    command(Id::Pane(2), &["2"], "", "Go to the drawing", IN_SHEET),
    command(Id::Pane(3), &["3"], "", "Go to the tables", IN_SHEET),
    command(Id::Trials, &["T"], "trials", "Compute the trials of all hard cases listed, and hold them against what must come out", CASES),
    command(Id::Trials, &["T"], "trials", "Compute the trials of this hard case, and hold them against what must come out", IN_CASE),
    command(Id::Reload, &["ctrl+r"], "", "Read the list of cases again", CASES),
    command(Id::PreviousChart, &["[", "p"], "", "Show the previous chart", CHARTS),
    command(Id::PreviousChart, &["[", "p"], "", "Show the mode along the line, or over the line at rest", MODES),
    command(Id::PreviousSeries, &["k", "up"], "", "Show the previous joint or component alone", CHARTS),
    command(Id::CursorLeft, &["h", "left"], "", "Move the cursor left; on the line's shape: an earlier instant", CHARTS),
    command(Id::LeapRight, &["pgdn", "ctrl+d"], "", "Move the cursor right by a tenth of the chart", CHARTS),
    command(Id::LeapLeft, &["pgup", "ctrl+u"], "", "Move the cursor left by a tenth of the chart", CHARTS),
    command(Id::ZoomOut, &["-"], "", "Zoom out about the cursor", CHARTS),
    command(Id::PanRight, &["L"], "", "Pan right", CHARTS),
    command(Id::PanLeft, &["H"], "", "Pan left", CHARTS),
    command(Id::PanUp, &["}"], "", "Pan up; on the map: read the place above", CHARTS),
    command(Id::PanDown, &["{"], "", "Pan down; on the map: read the place below", CHARTS),
    command(Id::FitUp, &["z"], "", "Fit the height to what is seen", CHARTS),
    command(Id::Mark, &["m"], "", "Set a mark at the cursor, or remove the mark there", CHARTS),
    command(Id::Copy, &["y"], "", "Copy the values at the cursor to the clipboard of your terminal, and write them to a file", CHARTS),
    command(Id::Redo, &["U", "ctrl+r"], "", "Redo the edit undone last", IN_FILE),
    command(Id::NextGroup, &["]"], "", "Go to the next group of fields", INPUTS),
    command(Id::PreviousGroup, &["["], "", "Go to the previous group of fields", INPUTS),
    command(Id::Down, &["j", "down"], "", "Down", DOWN),
    command(Id::Up, &["k", "up"], "", "Up", LISTS),
    command(Id::PageDown, &["pgdn", "ctrl+d"], "", "A page down", LISTS),
    command(Id::PageUp, &["pgup", "ctrl+u"], "", "A page up", LISTS),
    command(Id::Top, &["g", "home"], "", "To the first line", LISTS),
    command(Id::Bottom, &["G", "end"], "", "To the last line", LISTS),
    command(Id::ScrollRight, &["l", "right"], "", "Scroll right", WIDE),
    command(Id::ScrollLeft, &["h", "left"], "", "Scroll left", WIDE),
    command(Id::PreviousPane, &["shift+tab"], "", "Go to the previous pane", IN_FILE),
    command(Id::Pane(1), &["1"], "", "Go to the inputs", IN_FILE),
    command(Id::Pane(2), &["2"], "", "Go to the charts", IN_CASE),
    command(Id::Pane(3), &["3"], "", "Go to the runs", IN_CASE),
    command(Id::Pane(4), &["4"], "", "Go to the validation table", IN_CASE),
    command(Id::Pane(5), &["5"], "", "Go to the report", IN_CASE),
    command(Id::Pane(6), &["6"], "", "Go to the jobs", IN_CASE),
    command(Id::Pane(7), &["7"], "", "Go to the line node by node", IN_CASE),
    command(Id::Pane(8), &["8"], "", "Go to the natural modes", IN_CASE),
    command(Id::Help, &["?", "f1"], "help", "Show every key that works here", EVERYWHERE),
    command(Id::Palette, &[":"], "", "Find a command by its name", EVERYWHERE),
    command(Id::Glyphs, &[], "", "Change between braille and ASCII characters, and remember it", EVERYWHERE),
    command(Id::Messages, &[], "", "Show the messages so far", EVERYWHERE),
    command(Id::Redraw, &["ctrl+l"], "", "Paint the screen anew", EVERYWHERE),
    command(Id::Interrupt, &["ctrl+c"], "", "Cancel the running job; pressed again: quit", EVERYWHERE),
    command(Id::Suspend, &["ctrl+z"], "", "Stop the program; `fg` in the shell brings it back", EVERYWHERE),
    command(Id::Quit, &["q"], "quit", "Quit (asks when work would be lost)", EVERYWHERE),
];

/// The commands that apply at a place, in table order.
pub fn at(place: PaneId) -> impl Iterator<Item = &'static Command> {
    COMMANDS.iter().filter(move |c| c.places.contains(&place))
}

/// The command that a key means at a place.
#[must_use]
pub fn find(place: PaneId, key: Key) -> Option<&'static Command> {
    let name = key.to_string();
    at(place).find(|c| c.keys.contains(&name.as_str()))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn every_key_is_well_spelled_and_means_one_thing_at_a_place() {
        for place in PaneId::ALL {
            let mut seen: BTreeMap<&str, Id> = BTreeMap::new();
            for command in at(place) {
                for key in command.keys {
                    assert_eq!(
                        key.parse::<Key>().map(|k| k.to_string()).as_deref(),
                        Ok(*key)
                    );
                    let other = seen.insert(key, command.id);
                    assert_eq!(other, None, "`{key}` at {place:?} is also {:?}", command.id);
                }
            }
        }
    }

    #[test]
    fn keys_that_multiplexers_and_flow_control_eat_are_not_used() {
        let eaten = ["ctrl+a", "ctrl+b", "ctrl+s", "ctrl+q"];
        for command in COMMANDS {
            assert!(
                command.keys.iter().all(|k| !eaten.contains(k)),
                "{command:?}"
            );
        }
    }

    #[test]
    fn every_command_says_what_it_does() {
        for command in COMMANDS {
            assert!(
                !command.doc.is_empty() && !command.places.is_empty(),
                "{command:?}"
            );
        }
    }
}
