//! When what the screen shows is kept for the next session: at intervals, and as the program ends; only where it has changed.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use super::msg::Effect;
use super::screen_memory::ScreenMemory;
use super::screen_memory::file::SessionMemory;
use super::state::AppState;

/// How often it is looked whether anything has changed.
const LOOK: Duration = Duration::from_secs(5);

/// What was kept last.
#[derive(Debug)]
pub(super) struct MemoryKeeper {
    /// The directory that the screen belongs to.
    directory: PathBuf,
    screen: Option<ScreenMemory>,
    session: SessionMemory,
    looked: Instant,
}

impl MemoryKeeper {
    pub(super) fn new(
        directory: PathBuf,
        screen: Option<ScreenMemory>,
        session: SessionMemory,
    ) -> Self {
        Self {
            directory,
            screen,
            session,
            looked: Instant::now(),
        }
    }

    /// What is to be kept now, where it is time to look.
    pub(super) fn at_times(&mut self, state: &AppState) -> Vec<Effect> {
        match self.looked.elapsed() >= LOOK {
            true => self.changes(state),
            false => Vec::new(),
        }
    }

    /// What has changed since it was kept.
    pub(super) fn changes(&mut self, state: &AppState) -> Vec<Effect> {
        self.looked = Instant::now();
        let mut effects = Vec::new();
        let screen = ScreenMemory::of_state(state);
        if self.screen.as_ref() != Some(&screen) {
            let kept = Box::new(screen.clone());
            effects.push(Effect::KeepScreen(self.directory.clone(), kept));
            self.screen = Some(screen);
        }
        let session = session_of(state);
        if self.session != session {
            effects.push(Effect::KeepSession(Box::new(session.clone())));
            self.session = session;
        }
        effects
    }
}

/// What holds wherever the program is started.
fn session_of(state: &AppState) -> SessionMemory {
    SessionMemory {
        theme: state.theme.map(|palette| palette.name().to_owned()),
        tutorial_offered: true,
        tutorial_step: match &state.tutorial {
            Some(tutorial) => Some(tutorial.step),
            None => state.tutorial_left,
        },
        commands: state.history.lines().to_vec(),
    }
}
