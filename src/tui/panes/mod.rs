//! The panes: each has its title, its commands, when they can be done, what they do, and how it is drawn, in one file.
//! A new pane is a file here, a line in [`PaneId`], a line in [`pane`], and a place among the panes of a kind of file.

mod cases;
mod charts;
mod drawing;
mod inputs;
mod interface;
mod jobs;
mod model;
pub mod modes;
mod nodes;
mod report;
pub mod results;
mod ropeway;
mod runs;
mod ship;
mod sweep;
mod system;
mod tables;
mod trials;
mod validation;

use super::bindings::BoundCommand;
use super::command::{self, Command, CommandId};
use super::key::KeyPress;
use super::pane::PaneId;
use super::state::{AppState, ParameterEditor};
use super::update::tables::why_not;
pub use interface::{Pane, PaneInfo};
pub(super) use jobs::load_cases;

/// A pane by its name.
#[must_use]
pub fn pane(id: PaneId) -> &'static dyn Pane {
    match id {
        PaneId::Cases => &cases::CasesPane,
        PaneId::Inputs => &inputs::InputsPane,
        PaneId::Charts => &charts::ChartsPane,
        PaneId::Results => &results::ResultsPane,
        PaneId::Runs => &runs::RunsPane,
        PaneId::Validation => &validation::ValidationPane,
        PaneId::Report => &report::ReportPane,
        PaneId::Jobs => &jobs::JobsPane,
        PaneId::Trials => &trials::TrialsPane,
        PaneId::Nodes => &nodes::NodesPane,
        PaneId::Modes => &modes::ModesPane,
        PaneId::Tables => &tables::TablesPane,
        PaneId::Drawing => &drawing::DrawingPane,
        PaneId::Ropeway => &ropeway::RopewayPane,
        PaneId::Ship => &ship::ShipPane,
        PaneId::System => &system::SystemPane,
        PaneId::Sweep => &sweep::SweepPane,
        PaneId::Model => &model::ModelPane,
    }
}

/// The commands that apply now with their keys, in the order of footer and help.
#[must_use]
pub fn commands(state: &AppState) -> Vec<BoundCommand> {
    let focus = state.focus();
    let mut all: Vec<Command> = pane(focus).commands(state);
    if let Some(document) = state.document.as_ref().filter(|_| focus != PaneId::Trials) {
        let kind = document.kind();
        all.extend(kind.commands());
        all.extend(command::DOCUMENT);
        let numbered = (1..).zip(kind.info().panes);
        all.extend(numbered.filter_map(|(n, id)| command::pane(n, pane(*id).about().go)));
    }
    all.extend(command::EVERYWHERE);
    all.sort_by_key(|command| command.order);
    // The first of several for one thing is the one of the pane.
    let mut seen = Vec::new();
    all.retain(|command| {
        let new = !seen.contains(&command.id);
        seen.push(command.id);
        new
    });
    let bound = all.iter().map(|command| state.keys.bound(focus, command));
    bound.collect()
}

/// The command of a key.
#[must_use]
pub fn find(state: &AppState, key: KeyPress) -> Option<BoundCommand> {
    let name = key.to_string();
    let all = commands(state);
    all.into_iter().find(|command| command.keys.has(&name))
}

/// Nothing, or the reason why the command cannot be done now.
///
/// # Errors
/// The reason, as a full sentence.
pub fn enabled(state: &AppState, id: CommandId) -> Result<(), String> {
    let focus = state.focus();
    let reason = pane(focus).reason(state, id);
    let without = || {
        let skips = id == CommandId::TutorialSkip && state.tutorial.is_none();
        skips.then_some("The tutorial does not run; `:tutorial` begins it.")
    };
    let reason = reason
        .or_else(|| why_not(state, id))
        .or_else(without)
        .or_else(|| {
            let document = state
                .document
                .as_ref()
                .filter(|_| focus != PaneId::Trials)?;
            in_editor(&document.editor, id).or_else(|| document.kind().reason(id))
        });
    reason.map_or(Ok(()), |reason| Err(state.worded(reason)))
}

/// What the editor of every kind of file cannot do now.
fn in_editor(editor: &ParameterEditor, id: CommandId) -> Option<&'static str> {
    let when = |condition: bool, reason: &'static str| condition.then_some(reason);
    match id {
        CommandId::Run
        | CommandId::Study
        | CommandId::Validate
        | CommandId::StartSweep
        | CommandId::Trials
        | CommandId::InputEffects
        | CommandId::Physics
        | CommandId::LineInput
            if editor.draft.is_some() =>
        {
            Some(
                "The file is not complete yet: `:messages` shows what it lacks, `:undo` takes edits back.",
            )
        }
        CommandId::Undo => when(editor.undo.is_empty(), "There is nothing to undo."),
        CommandId::Redo => when(editor.redo.is_empty(), "There is nothing to redo."),
        CommandId::ExternalEditor => when(
            editor.unsaved(),
            "There are changes that the file does not hold; `:save` saves them first.",
        ),
        CommandId::Reset if !editor.unsaved() => Some("The field is as the file has it."),
        CommandId::Save => when(!editor.unsaved(), "The file already holds everything."),
        CommandId::Edit | CommandId::Reset => when(
            editor.current_field().is_none(),
            "No field passes the filter. `:filter` and Esc drop it.",
        ),
        _ => None,
    }
}
