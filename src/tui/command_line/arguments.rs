//! The arguments that a command may be given now, with what each is.

use super::candidates::Argument;
use super::{LineCommand, TypedLine};
use crate::bindings::names::pane_name;
use crate::case::fields::ValueType;
use crate::facade::FieldRow;
use crate::pane::PaneId;
use crate::panes;
use crate::run_cells;
use crate::state::AppState;
use crate::theme::Palette;

/// All arguments that there are, and the part of what is typed that they are to fit.
pub(super) fn arguments<'a>(state: &AppState, line: TypedLine<'a>) -> (Vec<Argument>, &'a str) {
    let all = match line.word.id {
        LineCommand::Open => cases(state),
        LineCommand::Set | LineCommand::Vary => return of_key(state, line.argument),
        LineCommand::GoTo => keys(state, "").collect(),
        LineCommand::Pane => pane_names(state),
        LineCommand::Sort | LineCommand::Explain => columns(state, false),
        LineCommand::Hide => columns(state, false),
        LineCommand::Show => columns(state, true),
        LineCommand::Theme => named(&[
            (
                Palette::Dark.name(),
                "colours that are read on a dark background",
            ),
            (
                Palette::Light.name(),
                "colours that are read on a light background",
            ),
            (Palette::Mono.name(), "no colours: weight and marks alone"),
        ]),
        LineCommand::Glyphs => named(&[
            ("braille", "curves of fine dots, frames of lines"),
            ("ascii", "plain characters, for terminals without others"),
        ]),
        LineCommand::Filter | LineCommand::SaveAs => Vec::new(),
    };
    (all, line.argument)
}

fn named(all: &[(&str, &str)]) -> Vec<Argument> {
    let each = all.iter().map(|(text, help)| Argument {
        text: (*text).to_owned(),
        help: (*help).to_owned(),
    });
    each.collect()
}

fn cases(state: &AppState) -> Vec<Argument> {
    let each = state.cases.entries.iter().map(|entry| Argument {
        text: entry.name.clone(),
        help: match &entry.about {
            Ok((title, _)) => title.clone(),
            Err((problem, _)) => format!("cannot be read: {problem}"),
        },
    });
    each.collect()
}

fn pane_names(state: &AppState) -> Vec<Argument> {
    let each = (1..).zip(state.panes()).map(|(number, pane)| Argument {
        text: pane_name(*pane),
        help: format!("{number} {}", panes::pane(*pane).about().title),
    });
    each.collect()
}

/// The fields of the open file, each followed by `end`.
fn keys<'a>(state: &'a AppState, end: &'a str) -> impl Iterator<Item = Argument> + 'a {
    let rows = state.editor().map_or(&[][..], |editor| &editor.rows);
    let shown = rows.iter().filter(|row| row.is_shown());
    shown.map(move |row| Argument {
        text: format!("{}{end}", row.path),
        help: field(row),
    })
}

/// Label, value and unit of a field.
fn field(row: &FieldRow) -> String {
    let value = match (row.value.is_empty(), row.absent) {
        (true, Some(words)) => words.to_owned(),
        _ => format!("{} {}", row.value, row.unit),
    };
    format!("{}: {}", row.label, value.trim_end())
}

/// Of `KEY=VALUE` the keys or, once there is one, the words that it may be.
fn of_key<'a>(state: &AppState, argument: &'a str) -> (Vec<Argument>, &'a str) {
    // Of several keys the last is being typed.
    let last = argument.rsplit(' ').next().unwrap_or(argument);
    let before = &argument[..argument.len() - last.len()];
    let Some((key, value)) = last.split_once('=') else {
        let keys = keys(state, "=").map(|of| Argument {
            text: format!("{before}{}", of.text),
            ..of
        });
        return (keys.collect(), last);
    };
    let rows = state.editor().map_or(&[][..], |editor| &editor.rows);
    let row = rows.iter().find(|row| row.path == key);
    let words: &[&str] = match row.map(|row| row.field.kind) {
        Some(ValueType::Choice(words)) => words,
        Some(ValueType::Boolean) => &["true", "false"],
        _ => &[],
    };
    let words = words.iter().map(|word| Argument {
        text: format!("{before}{key}={word}"),
        help: row.map_or_else(String::new, |row| row.label.clone().into_owned()),
    });
    (words.collect(), value)
}

/// The heads of the columns of the table with the focus: those that are shown, or those that are hidden.
pub fn columns(state: &AppState, hidden: bool) -> Vec<Argument> {
    if state.focus() == PaneId::Runs {
        return run_columns(state, hidden);
    }
    let (Some(table), Some(pane)) = (state.focused_table(), state.table_pane()) else {
        return Vec::new();
    };
    let shown = pane.shown(&table);
    let all = table.columns.iter().enumerate();
    let wanted = all.filter(|(place, _)| shown.contains(place) != hidden);
    let each = wanted.map(|(_, column)| Argument {
        text: column.head.clone(),
        help: crate::table::explanations::words(&table.title, &column.head),
    });
    each.collect()
}

fn run_columns(state: &AppState, hidden: bool) -> Vec<Argument> {
    let Some(view) = state.runs_view() else {
        return Vec::new();
    };
    let runs = &view.runs;
    let columns: Vec<_> = match hidden {
        false => runs.shown_columns().to_vec(),
        true => runs
            .hidden
            .iter()
            .filter_map(|name| runs.column_of(name))
            .collect(),
    };
    let each = columns.into_iter().map(|column| {
        let (_, help) = crate::run_columns::explanation(runs, column);
        Argument {
            text: run_cells::plain_head(runs, column),
            help,
        }
    });
    each.collect()
}

/// What is known of the argument that is being typed: of a key its help, its unit and what it may be.
#[must_use]
pub fn meaning(state: &AppState, line: TypedLine) -> String {
    let keyed = matches!(
        line.word.id,
        LineCommand::Set | LineCommand::Vary | LineCommand::GoTo
    );
    let last = line.argument.rsplit(' ').next().unwrap_or_default();
    let key = last.split('=').next().unwrap_or_default();
    let rows = state.editor().map_or(&[][..], |editor| &editor.rows);
    match rows.iter().find(|row| keyed && row.path == key) {
        Some(row) => {
            let range = match row.range.as_str() {
                "" => String::new(),
                range => format!(" May be: {range}."),
            };
            let unit = match row.unit {
                "" | "-" => String::new(),
                unit => format!(" [{unit}]"),
            };
            format!(
                "{}{unit}, now {}. {}{range}",
                row.label, row.value, row.help
            )
        }
        None => format!(
            "{} {}: {}.",
            line.word.name, line.word.argument, line.word.doc
        ),
    }
}
