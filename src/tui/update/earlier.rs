//! What earlier sessions left for this one, taken as the program starts.

use crate::screen_memory::file::Remembered;
use crate::state::{AppState, LineHistory, Severity};
use crate::theme::Palette;

/// Takes it: the screen where no file is named, or the file that it is of.
pub fn begin(state: &mut AppState, earlier: &mut Remembered, without_file: bool) {
    let session = &earlier.session;
    state.history = LineHistory::of_lines(session.commands.clone());
    state.tutorial_left = session.tutorial_step;
    let named = |name: &String| Palette::NAMES.iter().find(|(known, _)| known == name);
    if let Some((_, palette)) = session.theme.as_ref().and_then(named) {
        state.theme = Some(*palette);
        state.capabilities.palette = *palette;
    }
    if let Some(screen) = &earlier.screen {
        let is_there = screen.case.as_ref().is_none_or(|case| case.is_file());
        if without_file {
            screen.restore_list(state);
        }
        state.earlier = is_there.then(|| Box::new(screen.clone()));
    }
    for fault in &earlier.faults {
        state.say(Severity::Warning, format!("{fault}."));
    }
    if !session.tutorial_offered && earlier.faults.is_empty() {
        let words = "New here? `:tutorial` begins a tutorial of five minutes on this screen.";
        state.say(Severity::Info, words);
    }
}
