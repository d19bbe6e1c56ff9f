//! What the user sets in files, taken by the screen.

use std::sync::Arc;

use super::notice::info;
use crate::msg::Effect;
use crate::settings::{UserSettings, keys_file};
use crate::state::{AppState, Overlay, Severity};

/// Takes what the files set as the program starts: what is wrong is shown, what is not is in force.
pub fn begin(state: &mut AppState, settings: UserSettings) {
    if let Some(palette) = settings.config.palette {
        state.capabilities.palette = palette;
    }
    if let Some(glyphs) = settings.config.glyphs {
        state.capabilities.glyphs = glyphs;
    }
    report(state, &settings);
    state.keys = Arc::new(settings.keys);
}

/// Takes what the files set when they are read again.
pub(super) fn read(state: &mut AppState, settings: UserSettings) -> Vec<Effect> {
    let is_right = settings.faults.is_empty();
    begin(state, settings);
    match is_right {
        true => info(state, "Your keys and settings are read."),
        false => Vec::new(),
    }
}

fn report(state: &mut AppState, settings: &UserSettings) {
    let (Some(text), Ok(path)) = (settings.story(), keys_file()) else {
        return;
    };
    let first = settings.faults.first();
    let first = first.map_or_else(String::new, ToString::to_string);
    let more = match settings.faults.len() {
        0 | 1 => String::new(),
        count => format!(" ({} more)", count - 1),
    };
    state.say(Severity::Error, format!("{first}{more}"));
    let of_config = settings
        .faults
        .iter()
        .all(|fault| fault.file.ends_with("config.toml"));
    state.overlay = Some(Overlay::Text {
        title: "Your settings".to_owned(),
        text,
        scroll: 0,
        file: match of_config {
            true => path.with_file_name("config.toml"),
            false => path,
        },
    });
}
