//! A new file of a template.

use std::path::PathBuf;

use crate::msg::Effect;
use crate::state::form::{Form, FormLine, FormPurpose, NAME_OF_FILE};
use crate::state::picker::{Choice, Picker, PickerItem};
use crate::state::{AppState, Overlay};
use crate::templates::{TEMPLATES, Template};

/// Shows the templates.
pub fn choose(state: &mut AppState) -> Vec<Effect> {
    let items = TEMPLATES.iter().map(|template| PickerItem {
        name: template.name.to_owned(),
        help: template.about.to_owned(),
        choice: Choice::File(template),
    });
    let title = "New file (type a word, arrows choose, Enter takes it, Esc closes)";
    state.overlay = Some(Overlay::Picker(Picker::new(title, items.collect())));
    Vec::new()
}

/// The form of a template: the name of the file, then what the template needs.
pub(super) fn form(state: &AppState, template: &'static Template) -> Form {
    let stem = template.name.replace(' ', "_");
    let taken = |name: &str| state.cases.entries.iter().any(|entry| entry.name == name);
    let names =
        std::iter::once(format!("{stem}.toml")).chain((2..).map(|n| format!("{stem}_{n}.toml")));
    let name = names
        .into_iter()
        .find(|name| !taken(name))
        .unwrap_or_default();
    let help = "Where it is written, below the directory of the list of cases.";
    let mut lines = vec![FormLine::required(NAME_OF_FILE, "file", &name, help)];
    lines.extend(template.inputs.iter().map(|input| {
        FormLine {
            unit: input.unit.to_owned(),
            choices: input
                .choices
                .iter()
                .map(|word| (*word).to_owned())
                .collect(),
            ..FormLine::required(input.key, input.label, input.value, input.help)
        }
    }));
    Form {
        title: format!("New: {}", template.about),
        purpose: FormPurpose::NewFile(template),
        lines,
        cursor: 0,
        whole: true,
        problem: String::new(),
    }
}

/// Asks for the file, or shows what is wrong with the form.
pub(super) fn make(
    state: &mut AppState,
    mut form: Box<Form>,
    template: &'static Template,
) -> Vec<Effect> {
    let values = template.inputs.iter().map(|input| {
        let typed = form.typed(input.key).unwrap_or_default();
        (input.key, typed.to_owned())
    });
    let values: Vec<(&str, String)> = values.collect();
    let made = file_name(&form).and_then(|name| Ok((name, template.text(&values)?)));
    match made {
        Ok((name, text)) => {
            let path = state.cases.dir.join(name);
            state.overlay = Some(Overlay::Form(form));
            vec![Effect::NewFile { path, text }]
        }
        Err(problem) => {
            form.problem = problem;
            state.overlay = Some(Overlay::Form(form));
            Vec::new()
        }
    }
}

/// The name of the file, with its ending.
fn file_name(form: &Form) -> Result<PathBuf, String> {
    let typed = form.typed(NAME_OF_FILE).ok_or("Give the file a name.")?;
    let typed = typed.strip_suffix(".toml").unwrap_or(typed);
    let name = PathBuf::from(format!("{typed}.toml"));
    let plain = name
        .components()
        .all(|part| matches!(part, std::path::Component::Normal(_)));
    match plain {
        true => Ok(name),
        false => Err("Give a name below this directory, without `..`.".to_owned()),
    }
}

/// Whether the form of a new file is open.
#[must_use]
pub fn is_asked(state: &AppState) -> bool {
    matches!(&state.overlay, Some(Overlay::Form(form)) if matches!(form.purpose, FormPurpose::NewFile(_)))
}

/// The file is not made.
pub fn failed(state: &mut AppState, why: String) -> Vec<Effect> {
    super::refused(state, why)
}
