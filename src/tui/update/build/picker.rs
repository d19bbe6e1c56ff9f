//! Keys while something is chosen from a list.

use super::super::line_types;
use super::super::text_input::type_key;
use super::{form_of_new, form_of_parameter, new_file};
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::state::picker::{Choice, Picker};
use crate::state::{AppState, Overlay};
use crate::update::motion::moved;

/// Takes a key, with the list taken from the screen.
pub(in crate::update) fn key(
    state: &mut AppState,
    mut picker: Picker,
    key: KeyPress,
) -> Vec<Effect> {
    let count = picker.shown().len();
    match key {
        KeyPress::Esc => return Vec::new(),
        KeyPress::Enter => {
            let chosen = picker
                .shown()
                .get(picker.cursor)
                .map(|item| item.choice.clone());
            if let Some(chosen) = chosen {
                return take(state, &chosen);
            }
        }
        KeyPress::Down | KeyPress::Tab => picker.cursor = moved(picker.cursor, 1, count),
        KeyPress::Up | KeyPress::BackTab => picker.cursor = moved(picker.cursor, -1, count),
        KeyPress::PageDown => picker.cursor = moved(picker.cursor, 10, count),
        KeyPress::PageUp => picker.cursor = moved(picker.cursor, -10, count),
        _ => {
            if type_key(&mut picker.input, key) {
                picker.cursor = 0;
            }
        }
    }
    state.overlay = Some(Overlay::Picker(picker));
    Vec::new()
}

fn take(state: &mut AppState, chosen: &Choice) -> Vec<Effect> {
    let form = match chosen {
        Choice::LineType => return line_types::open(state),
        Choice::Table(path) => form_of_new(state, path),
        Choice::Parameter => Some(form_of_parameter()),
        Choice::File(template) => Some(new_file::form(state, template)),
    };
    state.overlay = form.map(|form| Overlay::Form(Box::new(form)));
    Vec::new()
}
