//! Keys while a form is filled in.

use super::super::text_input::type_key;
use super::{edit_of_form, new_file, wanted};
use crate::key::KeyPress;
use crate::msg::Effect;
use crate::state::form::{Form, FormPurpose, NAME_OF_TABLE};
use crate::state::{AppState, Overlay};
use crate::update::motion::moved;
use seacable_model::case::fields::parameters_table::PARAMETERS;
use seacable_model::case::structure::StructureEdit;

/// Takes a key, with the form taken from the screen.
pub(in crate::update) fn key(
    state: &mut AppState,
    mut form: Box<Form>,
    key: KeyPress,
) -> Vec<Effect> {
    let count = form.shown().len();
    match key {
        KeyPress::Esc => return Vec::new(),
        KeyPress::Enter => return submit(state, form),
        KeyPress::Down => form.cursor = moved(form.cursor, 1, count),
        KeyPress::Up => form.cursor = moved(form.cursor, -1, count),
        KeyPress::PageDown => form.cursor = moved(form.cursor, 8, count),
        KeyPress::PageUp => form.cursor = moved(form.cursor, -8, count),
        KeyPress::Tab => fold(&mut form),
        KeyPress::Left | KeyPress::Right if has_choices(&form) => {
            choose(&mut form, key == KeyPress::Right);
        }
        _ => {
            if let Some(line) = form.current_mut()
                && type_key(&mut line.input, key)
            {
                form.problem.clear();
            }
        }
    }
    state.overlay = Some(Overlay::Form(form));
    Vec::new()
}

/// Shows all keys of the table, or those that are needed and given; the cursor stays on its line.
fn fold(form: &mut Form) {
    let at = form.shown().get(form.cursor).copied();
    form.whole = !form.whole;
    let shown = form.shown();
    let found = shown.iter().position(|number| Some(*number) == at);
    form.cursor = found.unwrap_or(0).min(shown.len().saturating_sub(1));
}

fn has_choices(form: &Form) -> bool {
    form.current().is_some_and(|line| !line.choices.is_empty())
}

/// The next or the previous word of the line.
fn choose(form: &mut Form, forward: bool) {
    let Some(line) = form.current_mut() else {
        return;
    };
    let now = line.value().to_owned();
    let at = line.choices.iter().position(|word| *word == now);
    let count = line.choices.len();
    let next = match (at, forward) {
        (None, _) => 0,
        (Some(at), true) => (at + 1) % count,
        (Some(at), false) => (at + count - 1) % count,
    };
    line.input = line.choices[next].clone().into();
    form.problem.clear();
}

/// Asks for what the form says.
fn submit(state: &mut AppState, mut form: Box<Form>) -> Vec<Effect> {
    if let FormPurpose::NewFile(template) = form.purpose {
        return new_file::make(state, form, template);
    }
    let asked = form.edit().map(|edit| of_parameter(&form, edit));
    match asked {
        Ok(StructureEdit::Fill { values, .. }) if values.is_empty() => Vec::new(),
        Ok(edit) => {
            let said = said(&form);
            if let Some(editor) = state.editor_mut() {
                editor.model.wanted = wanted(&edit);
            }
            state.overlay = Some(Overlay::Form(form));
            edit_of_form(state, edit, said)
        }
        Err(problem) => {
            form.problem = problem;
            state.overlay = Some(Overlay::Form(form));
            Vec::new()
        }
    }
}

/// A parameter is a key of its table, named by the user.
fn of_parameter(form: &Form, edit: StructureEdit) -> StructureEdit {
    match edit {
        StructureEdit::Add { table, .. } if table == PARAMETERS => {
            let typed = |key: &str| form.typed(key).unwrap_or_default().to_owned();
            StructureEdit::Add {
                table,
                name: None,
                values: vec![(typed(NAME_OF_TABLE), typed("value"))],
            }
        }
        edit => edit,
    }
}

/// What is said once the edit is taken.
fn said(form: &Form) -> String {
    match &form.purpose {
        FormPurpose::Add { table } => format!("Added to {table}. `:undo` takes it back."),
        FormPurpose::Fill { path } => format!("Set in {path}. `:undo` takes it back."),
        FormPurpose::Copy { path } => format!("Copied {path}. `:undo` takes it back."),
        FormPurpose::Rename { path } => format!("Renamed {path}. `:undo` takes it back."),
        FormPurpose::Divide { path } => format!("Divided {path}. `:undo` takes it back."),
        FormPurpose::NewFile(_) => String::new(),
    }
}
