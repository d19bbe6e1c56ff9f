//! Choosing a line type and its diameter, and adding it to the file as a material.

use super::edit;
use super::motion::moved;
use super::text_input::type_key;
use crate::key::KeyPress;
use crate::line_types::{LINE_TYPES, LineProperties, nominal_diameter, properties, with_material};
use crate::msg::Effect;
use crate::state::overlay::LineTypePicker;
use crate::state::{AppState, Overlay};

/// Shows the library.
pub fn open(state: &mut AppState) -> Vec<Effect> {
    state.overlay = Some(Overlay::LineTypes(LineTypePicker::default()));
    Vec::new()
}

pub(super) fn key(state: &mut AppState, mut picker: LineTypePicker, key: KeyPress) -> Vec<Effect> {
    let count = LINE_TYPES.len();
    match key {
        KeyPress::Esc => return Vec::new(),
        KeyPress::Enter => match chosen(&picker) {
            Ok(line) => return add(state, &line),
            Err(problem) => picker.problem = problem,
        },
        KeyPress::Down | KeyPress::Tab => picker.cursor = moved(picker.cursor, 1, count),
        KeyPress::Up | KeyPress::BackTab => picker.cursor = moved(picker.cursor, -1, count),
        _ => {
            if type_key(&mut picker.input, key) {
                picker.problem.clear();
            }
        }
    }
    state.overlay = Some(Overlay::LineTypes(picker));
    Vec::new()
}

/// The type under the cursor at the diameter typed, or why there is none.
pub(crate) fn chosen(picker: &LineTypePicker) -> Result<LineProperties, String> {
    let line_type = LINE_TYPES.get(picker.cursor);
    let line_type = line_type.ok_or_else(|| "No line type is chosen.".to_owned())?;
    let line = nominal_diameter(picker.input.value());
    let line = line.and_then(|diameter| properties(line_type, diameter));
    line.map_err(|error| format!("{error}."))
}

/// Adds the material at the end of the file, as an edit that can be undone.
fn add(state: &mut AppState, line: &LineProperties) -> Vec<Effect> {
    let Some(editor) = state.editor() else {
        return Vec::new();
    };
    let (text, name) = with_material(&editor.text, line);
    let said = format!("Added [materials.{name}] at the end of the file. `:undo` takes it back.");
    edit::replace(state, text, said)
}
