//! Messages to the user, as the result of a command.

use crate::msg::Effect;
use crate::state::{AppState, Severity};

/// Says something that goes away with the next key.
pub fn info(state: &mut AppState, text: impl Into<String>) -> Vec<Effect> {
    state.say(Severity::Info, text);
    Vec::new()
}

/// Says something that the user should not miss.
pub fn warn(state: &mut AppState, text: impl Into<String>) -> Vec<Effect> {
    state.say(Severity::Warning, text);
    Vec::new()
}
