//! All commands that there are, by the panes in which they are found together.

use super::Scope;
use crate::command::{self, Command, CommandId};
use crate::pane::PaneId;
use crate::panes;

/// Commands whose keys are fixed: the terminal and the shell know them by these.
pub const FIXED: [CommandId; 2] = [CommandId::Interrupt, CommandId::Suspend];

/// The numbers that panes have.
const NUMBERS: std::ops::RangeInclusive<usize> = 1..=10;

/// The commands of the kinds of file that have a pane; nothing where no file need be open.
fn kinds(pane: PaneId) -> &'static [&'static [Command]] {
    match pane {
        PaneId::Cases | PaneId::Trials => &[],
        PaneId::Inputs | PaneId::Tables | PaneId::Validation | PaneId::Model => &[
            command::LINE,
            command::MODEL,
            command::REPORTED,
            command::MOVING,
        ],
        PaneId::Charts
        | PaneId::Results
        | PaneId::Runs
        | PaneId::Report
        | PaneId::Jobs
        | PaneId::Sweep
        | PaneId::Nodes
        | PaneId::Modes => &[command::LINE, command::REPORTED, command::MOVING],
        PaneId::Drawing | PaneId::Ropeway | PaneId::Ship => &[command::MODEL],
        PaneId::System => &[command::REPORTED, command::MOVING],
    }
}

/// The own commands of a pane, also those that it has at times only.
fn of_pane(pane: PaneId) -> Vec<Command> {
    let pane = panes::pane(pane);
    [pane.about().commands.concat(), pane.at_times().to_vec()].concat()
}

/// The commands that go to a pane by its number.
fn numbers() -> impl Iterator<Item = Command> {
    NUMBERS.filter_map(|number| command::pane(number, "Go to the pane of this number"))
}

/// All commands that a pane may have at once, each once.
#[must_use]
pub fn together(pane: PaneId) -> Vec<Command> {
    let mut all = of_pane(pane);
    let kinds = kinds(pane);
    all.extend(kinds.concat());
    if !kinds.is_empty() {
        all.extend(command::DOCUMENT);
        all.extend(numbers());
    }
    all.extend(command::EVERYWHERE);
    once(all)
}

/// Every command with the scope in which it is listed, each once in its scope.
#[must_use]
pub fn declared() -> Vec<(Scope, Command)> {
    let mut everywhere = [
        command::LINE,
        command::MODEL,
        command::REPORTED,
        command::MOVING,
        command::DOCUMENT,
        command::EVERYWHERE,
        command::SHARED,
        command::LIST,
        command::WIDE,
    ]
    .concat();
    everywhere.extend(numbers());
    let mut all: Vec<(Scope, Command)> = once(everywhere)
        .into_iter()
        .map(|command| (Scope::Everywhere, command))
        .collect();
    for pane in PaneId::ALL {
        let own = once(of_pane(pane)).into_iter();
        all.extend(own.map(|command| (Scope::Pane(pane), command)));
    }
    all
}

/// The first of several commands for one thing.
fn once(mut all: Vec<Command>) -> Vec<Command> {
    let mut seen = Vec::new();
    all.retain(|command| {
        let new = !seen.contains(&command.id);
        seen.push(command.id);
        new
    });
    all
}
