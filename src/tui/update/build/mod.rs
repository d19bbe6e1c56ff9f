//! Building a model: tables of the file that is open added, filled in, removed, copied, renamed, divided, put in order.

pub mod form;
pub mod new_file;
pub mod picker;

use super::ask_edit::ask;
use super::notice::info;
use crate::facade;
use crate::msg::Effect;
use crate::state::form::{Form, FormLine, FormPurpose, NAME_OF_TABLE, below, line_of, title_of};
use crate::state::pending::{Change, EditSource, PendingEdit};
use crate::state::picker::{Choice, Picker, PickerItem};
use crate::state::{AppState, Overlay};
use seacable_model::case::TomlNode;
use seacable_model::case::fields::parameters_table::PARAMETERS;
use seacable_model::case::fields::{AbsentValue, Schema, TableSchema, TableShape, join, split};
use seacable_model::case::structure::{StructureEdit, free_name, table_of, values_of};

/// What the file that is open may hold.
fn schema(state: &AppState) -> Option<&'static Schema> {
    let document = state.document.as_ref()?;
    Some(facade::schema(document.content.file_type()))
}

/// Asks for an edit of the structure.
fn edit(state: &mut AppState, edit: StructureEdit, said: String) -> Vec<Effect> {
    let change = Change::Structure(Box::new(edit));
    ask(
        state,
        PendingEdit {
            said: Some(said),
            ..PendingEdit::command(change)
        },
    )
}

/// Asks for the edit of a form, which stays open until it is accepted.
fn edit_of_form(state: &mut AppState, edit: StructureEdit, said: String) -> Vec<Effect> {
    let change = Change::Structure(Box::new(edit));
    ask(
        state,
        PendingEdit {
            change,
            source: EditSource::Form,
            said: Some(said),
        },
    )
}

/// The path under the cursor of the list, and its parts.
fn current(state: &AppState) -> Option<(String, Vec<String>)> {
    let row = state.editor()?.model.current()?;
    Some((row.path.clone(), split(&row.path)?))
}

/// Shows what can be added here: to the table under the cursor, then to the file.
pub fn add(state: &mut AppState) -> Vec<Effect> {
    let Some(schema) = schema(state) else {
        return Vec::new();
    };
    let inner = current(state).and_then(|(path, parts)| Some((table_of(schema, &parts)?, path)));
    let mut items = Vec::new();
    if let Some(((table, _), path)) = inner {
        let pattern = table.pattern();
        let tables = schema.tables_in(&pattern);
        items.extend(tables.map(|table| item(table, &format!("{path}.{}", table.key()))));
        // Another one like that under the cursor.
        let parent = path_of_kind(schema, &path);
        items.extend(parent.map(|parent| item(table, &parent)));
    }
    if schema.tables.iter().any(|table| table.path == "materials") {
        items.push(PickerItem {
            name: "line type of the library".to_owned(),
            help: "Chain, wire or fibre rope by nominal diameter, as a material.".to_owned(),
            choice: Choice::LineType,
        });
    }
    items.push(PickerItem {
        name: "parameter".to_owned(),
        help: "A named number, for values written as expressions.".to_owned(),
        choice: Choice::Parameter,
    });
    let present: Vec<String> = state.editor().map_or(Vec::new(), |editor| {
        editor
            .model
            .rows
            .iter()
            .map(|row| row.path.clone())
            .collect()
    });
    for table in schema.tables_in("") {
        let is_there = table.shape == TableShape::One && present.contains(&table.path);
        let hidden = ["files", PARAMETERS].contains(&table.key());
        let known = items
            .iter()
            .any(|item| item.choice == Choice::Table(table.path.clone()));
        if !(is_there || hidden || known) {
            items.push(item(table, &table.path));
        }
    }
    let items = items
        .into_iter()
        .filter(|item| !matches!(&item.choice, Choice::Table(path) if is_one_that_is_there(schema, &present, path)))
        .collect();
    let title = "Add (type a word, arrows choose, Enter takes it, Esc closes)";
    state.overlay = Some(Overlay::Picker(Picker::new(title, items)));
    Vec::new()
}

/// Whether a path is that of a single table which the file has.
fn is_one_that_is_there(schema: &'static Schema, present: &[String], path: &str) -> bool {
    let table = split(path).and_then(|parts| table_of(schema, &parts));
    let one = table.is_some_and(|(table, _)| table.shape == TableShape::One);
    one && present.iter().any(|known| known == path)
}

/// The path of the tables of a kind, of one of them: `lines` of `lines.a`; nothing for a single table.
fn path_of_kind(schema: &'static Schema, path: &str) -> Option<String> {
    let parts = split(path)?;
    let (table, named) = table_of(schema, &parts)?;
    match (table.shape, named) {
        (TableShape::One, _) => None,
        (_, true) => Some(join(&parts[..parts.len() - 1])),
        (_, false) => Some(path.to_owned()),
    }
}

fn item(table: &TableSchema, path: &str) -> PickerItem {
    PickerItem {
        name: path.replace('_', " ").replace('.', " > "),
        help: table.help.to_owned(),
        choice: Choice::Table(path.to_owned()),
    }
}

/// The form of a new table.
pub fn form_of_new(state: &AppState, table: &str) -> Option<Form> {
    let schema = schema(state)?;
    let text = &state.editor()?.text;
    let parts = split(table)?;
    let (declared, _) = table_of(schema, &parts)?;
    let pattern = declared.pattern();
    let mut lines = Vec::new();
    let singular = declared.key().trim_end_matches('s').to_owned();
    if declared.shape == TableShape::ByName {
        let name = free_name(text, &parts, &singular);
        let help = "Its name: letters, digits, - and _.";
        lines.push(FormLine::required(NAME_OF_TABLE, "name", &name, help));
    }
    for field in schema.fields_of(&pattern) {
        let mut line = line_of(schema, text, field, "");
        let is_named = field.absent == AbsentValue::Required || has_names(text, &parts);
        if field.key() == "name" && declared.shape == TableShape::List && is_named {
            line.input = free_name(text, &parts, &singular).into();
        }
        lines.push(line);
    }
    let whole = !lines.iter().any(|line| line.required);
    Some(Form {
        title: format!("New {} {}", declared.header(), declared.help),
        purpose: FormPurpose::Add {
            table: table.to_owned(),
        },
        lines,
        cursor: 0,
        whole,
        problem: String::new(),
    })
}

/// Whether the tables of a list give themselves names.
fn has_names(text: &str, list: &[String]) -> bool {
    let tree = TomlNode::parse(text).ok();
    let list = tree.as_ref().and_then(|tree| tree.find(list));
    let items = list.map_or(&[][..], TomlNode::items);
    items.iter().any(|item| item.get("name").is_some())
}

/// The form of a new parameter.
#[must_use]
pub fn form_of_parameter() -> Form {
    let name = FormLine::required(
        NAME_OF_TABLE,
        "name",
        "",
        "Letters, digits and _, its unit at the end: depth_m.",
    );
    let value = FormLine::required(
        "value",
        "value",
        "",
        "A number, or an expression of other parameters: 4 * depth_m.",
    );
    Form {
        title: "New parameter".to_owned(),
        purpose: FormPurpose::Add {
            table: PARAMETERS.to_owned(),
        },
        lines: vec![name, value],
        cursor: 0,
        whole: true,
        problem: String::new(),
    }
}

/// Opens the keys of the table under the cursor as a form.
pub fn open(state: &mut AppState) -> Vec<Effect> {
    let Some((path, _)) = current(state) else {
        return Vec::new();
    };
    let is_heading = state
        .editor()
        .and_then(|editor| editor.model.current())
        .is_some_and(|row| row.is_heading);
    let form = match is_heading {
        true => form_of_new(state, &path),
        false => form_of_old(state, &path),
    };
    state.overlay = form.map(|form| Overlay::Form(Box::new(form)));
    Vec::new()
}

/// The form of a table that is there.
fn form_of_old(state: &AppState, path: &str) -> Option<Form> {
    let schema = schema(state)?;
    let editor = state.editor()?;
    let parts = split(path)?;
    let (declared, _) = table_of(schema, &parts)?;
    let values = values_of(&editor.text, &parts);
    let value = |key: &str| {
        let found = values.iter().find(|(known, _)| known == key);
        found.map_or("", |(_, value)| value.as_str())
    };
    let lines: Vec<FormLine> = match path == PARAMETERS {
        true => values
            .iter()
            .map(|(key, value)| FormLine {
                before: value.clone(),
                required: false,
                ..FormLine::required(key, key, value, "A number, or an expression; empty: gone.")
            })
            .collect(),
        false => schema
            .fields_of(&declared.pattern())
            .map(|field| line_of(schema, &editor.text, field, value(field.key())))
            .collect(),
    };
    let title = editor.model.rows.iter().find(|row| row.path == path);
    Some(Form {
        title: title.map_or_else(|| path.to_owned(), title_of),
        purpose: FormPurpose::Fill {
            path: path.to_owned(),
        },
        lines,
        cursor: 0,
        whole: path == PARAMETERS,
        problem: String::new(),
    })
}

/// Takes the table under the cursor out.
pub fn remove(state: &mut AppState) -> Vec<Effect> {
    let Some((path, _)) = current(state) else {
        return Vec::new();
    };
    let said = format!("Removed {path}. `:undo` takes it back.");
    edit(state, StructureEdit::Remove { path }, said)
}

/// Moves the table under the cursor before the one before it, or behind the one behind it.
pub fn shift(state: &mut AppState, down: bool) -> Vec<Effect> {
    let Some((path, mut parts)) = current(state) else {
        return Vec::new();
    };
    // One without a name is known by its number, which changes with its place.
    if let Some(last) = parts.last_mut()
        && let Ok(number) = last.parse::<usize>()
    {
        *last = match down {
            true => number + 1,
            false => number.saturating_sub(1).max(1),
        }
        .to_string();
        let wanted = join(&parts);
        if let Some(editor) = state.editor_mut() {
            editor.model.wanted = Some(wanted);
        }
    }
    let said = format!("Moved {path}.");
    edit(state, StructureEdit::Move { path, down }, said)
}

/// Asks for the name of a copy of the table under the cursor; one of a list without names is copied at once.
pub fn copy(state: &mut AppState) -> Vec<Effect> {
    let Some((path, parts)) = current(state) else {
        return Vec::new();
    };
    let has_name = schema(state)
        .and_then(|schema| {
            let (table, _) = table_of(schema, &parts)?;
            let by_name = table.shape == TableShape::ByName;
            let pattern = table.pattern();
            let mut fields = schema.fields_of(&pattern);
            let (_, list) = parts.split_last()?;
            let is_named = |text: &str| has_names(text, list);
            let is_named = state.editor().is_some_and(|editor| is_named(&editor.text));
            Some(by_name || is_named && fields.any(|field| field.key() == "name"))
        })
        .unwrap_or(false);
    if !has_name {
        let said = format!("Copied {path}.");
        return edit(state, StructureEdit::Copy { path, name: None }, said);
    }
    let name = match (state.editor(), parts.split_last()) {
        (Some(editor), Some((last, parent))) => free_name(&editor.text, parent, last),
        _ => String::new(),
    };
    let help = "The name of the copy: letters, digits, - and _.";
    let line = FormLine::required(NAME_OF_TABLE, "name", &name, help);
    ask_one(
        state,
        format!("Copy {path}"),
        FormPurpose::Copy { path },
        line,
    )
}

/// Asks for another name of the table under the cursor.
pub fn rename(state: &mut AppState) -> Vec<Effect> {
    let Some((path, parts)) = current(state) else {
        return Vec::new();
    };
    let name = parts.last().map_or("", String::as_str);
    let help = "The new name; keys and marks that name it follow.";
    let line = FormLine::required(NAME_OF_TABLE, "name", name, help);
    ask_one(
        state,
        format!("Rename {path}"),
        FormPurpose::Rename { path },
        line,
    )
}

/// Asks where the line or section under the cursor is divided.
pub fn divide(state: &mut AppState) -> Vec<Effect> {
    let Some((path, _)) = current(state) else {
        return Vec::new();
    };
    let help = "Length of the first part from the start; the rest is the second part.";
    let mut line = FormLine::required("at_m", "length", "", help);
    line.unit = "m".to_owned();
    ask_one(
        state,
        format!("Divide {path} into two"),
        FormPurpose::Divide { path },
        line,
    )
}

fn ask_one(state: &mut AppState, title: String, of: FormPurpose, line: FormLine) -> Vec<Effect> {
    state.overlay = Some(Overlay::Form(Box::new(Form::of_one(title, of, line))));
    Vec::new()
}

/// The path that the cursor goes to once an edit is taken: that of the table which is new.
fn wanted(edit: &StructureEdit) -> Option<String> {
    let beside = |path: &str, name: &str| {
        let mut parts = split(path)?;
        name.clone_into(parts.last_mut()?);
        Some(join(&parts))
    };
    match edit {
        StructureEdit::Add { table, .. } if table == PARAMETERS => Some(table.clone()),
        StructureEdit::Add {
            table,
            name,
            values,
        } => {
            let own = values.iter().find(|(key, _)| key == "name");
            let name = name.as_deref().or(own.map(|(_, name)| name.as_str()));
            Some(name.map_or_else(|| table.clone(), |name| below(table, name)))
        }
        StructureEdit::Copy {
            path,
            name: Some(name),
        } => beside(path, name),
        StructureEdit::Rename { path, to } => beside(path, to),
        _ => None,
    }
}

/// Shows why a form is refused.
pub(super) fn refused(state: &mut AppState, why: String) -> Vec<Effect> {
    if let Some(Overlay::Form(form)) = &mut state.overlay {
        form.problem = why;
        return Vec::new();
    }
    info(state, why)
}

/// Closes the form whose edit is accepted.
pub(super) fn accepted(state: &mut AppState) {
    if matches!(state.overlay, Some(Overlay::Form(_))) {
        state.overlay = None;
    }
}
