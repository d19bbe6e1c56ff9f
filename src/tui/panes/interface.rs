//! What a pane is to the rest of the screen.

use crate::command::{Command, CommandId};
use crate::msg::Effect;
use crate::state::AppState;
use crate::view::painter::Painter;
use ratatui::layout::Rect;

/// What a pane is called and which commands it has.
#[derive(Debug, Clone, Copy)]
pub struct PaneInfo {
    /// The name on its frame and tab.
    pub title: &'static str,
    /// What its number key does, for the help.
    pub go: &'static str,
    /// Its own commands, and the tables of those that it shares with others.
    pub commands: &'static [&'static [Command]],
}

pub(super) const fn about(
    title: &'static str,
    go: &'static str,
    commands: &'static [&'static [Command]],
) -> PaneInfo {
    PaneInfo {
        title,
        go,
        commands,
    }
}

/// A pane of the screen.
pub trait Pane: Sync {
    /// What it is called and which commands it has.
    fn about(&self) -> PaneInfo;

    /// The commands that it has now.
    fn commands(&self, _state: &AppState) -> Vec<Command> {
        self.about().commands.concat()
    }

    /// Commands that it has at times only, beside those of [`PaneInfo`].
    fn at_times(&self) -> &'static [Command] {
        &[]
    }

    /// Why a command cannot be done now.
    fn reason(&self, _state: &AppState, _id: CommandId) -> Option<&'static str> {
        None
    }

    /// Does a command; nothing where it is none of this pane.
    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>>;

    /// Draws it.
    fn view(&self, painter: &mut Painter, area: Rect);
}
