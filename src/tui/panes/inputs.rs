//! The parameter editor.

use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use super::interface::{Pane, PaneInfo, about};
use crate::case::{ReplacedValue, YOURS};
use crate::command::{self, Command, CommandId, CommandOrder, FILTER, LIST, main, other};
use crate::facade::FieldRow;
use crate::msg::Effect;
use crate::state::{AppState, Document, ParameterEditor};
use crate::update::edit::{self, optional};
use crate::update::motion::{moved, step};
use crate::update::step_value::step_value;
use crate::update::{results, vary};
use crate::view::layout;
use crate::view::paint::{below_head, rest, row, span, wrap};
use crate::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::Edit, &["enter", "e"], "edit", "Edit the value under the cursor; a range such as 0.2..0.8/4 runs the case at each value; + behind it keeps it for a grid with a further field"),
    main(CommandId::StepUp, &["right", "l"], "step", "Step the value up: a number by a small round part of it, a word to the next"),
    FILTER,
    other(CommandId::StepDown, &["left", "h"], "", "Step the value down"),
    other(CommandId::LeapUp, &["L"], "", "Step the value up by ten steps"),
    other(CommandId::LeapDown, &["H"], "", "Step the value down by ten steps"),
    other(CommandId::HoldAgainst, &["v"], "hold", "Hold the results: later ones are shown with their difference from them"),
    other(CommandId::Zoom, &["z"], "zoom", "Give the inputs the whole screen, with their help, or share it with chart and results"),
    other(CommandId::Fold, &["x"], "defaults", "Show the defaults among the inputs, or fold them"),
    other(CommandId::ExternalEditor, &["E"], "editor", "Open the file in $VISUAL or $EDITOR, and read it again afterwards"),
    other(CommandId::Reset, &["r"], "reset", "Put the field back to the value of the file"),
    other(CommandId::NextGroup, &["]"], "", "Go to the next group of fields"),
    other(CommandId::PreviousGroup, &["["], "", "Go to the previous group of fields"),
    command::DOWN,
];

/// While a range waits for one in a further field.
#[rustfmt::skip]
const KEPT: &[Command] = &[
    main(CommandId::DropRange, &["esc"], "drop range", "Drop the range that waits for one in a further field"),
    command::command(CommandOrder::Document, CommandId::Back, &["b"], "cases", "Back to the list of cases"),
];

pub(super) struct InputsPane;

impl Pane for InputsPane {
    fn about(&self) -> PaneInfo {
        about("Inputs", "Go to the inputs", &[COMMANDS, LIST])
    }

    fn commands(&self, state: &AppState) -> Vec<Command> {
        let waits = state.editor().is_some_and(|editor| !editor.kept.is_empty());
        let kept = if waits { KEPT } else { &[] };
        [kept, COMMANDS, LIST].concat()
    }

    fn at_times(&self) -> &'static [Command] {
        KEPT
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        match id {
            CommandId::HoldAgainst => results::why_not_held(state),
            CommandId::Zoom => layout::why_not_zoomed(state),
            CommandId::Reset if state.line().is_some() => {
                let own = state.editor()?.current_field()?.replaced.is_none();
                own.then_some("The field is as the file has it.")
            }
            _ => None,
        }
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let by = step(state, id);
        match id {
            CommandId::Edit => edit::begin(state),
            CommandId::DropRange => return Some(vary::drop_kept(state)),
            CommandId::StepUp => return Some(step_value(state, 1.0)),
            CommandId::StepDown => return Some(step_value(state, -1.0)),
            CommandId::LeapUp => return Some(step_value(state, 10.0)),
            CommandId::LeapDown => return Some(step_value(state, -10.0)),
            CommandId::HoldAgainst => return Some(results::hold_live(state)),
            CommandId::Fold => edit::fold(state),
            CommandId::Zoom => {
                let document = state.document.as_mut()?;
                document.zoomed = !document.zoomed;
            }
            CommandId::Reset => return Some(edit::reset(state)),
            CommandId::NextGroup => edit::next_group(state, true),
            CommandId::PreviousGroup => edit::next_group(state, false),
            CommandId::ExternalEditor => {
                let path = state.editor()?.path.clone();
                return Some(vec![Effect::EditFile(path)]);
            }
            CommandId::Filter => state.editor_mut()?.filter.typing = true,
            _ => {
                let editor = state.editor_mut()?;
                editor.field = moved(editor.field, by?, editor.fields().count());
            }
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let Some(document) = &painter.state.document else {
            return;
        };
        let editor = &document.editor;
        let compact = area.width < COMPACT;
        let help_rows = if area.height > 14 && !compact { 5 } else { 3 };
        let waiting = vary::kept_words(editor).map(|words| wrap(&words, area.width.into()));
        let waiting = waiting.unwrap_or_default();
        let waiting_rows = u16::try_from(waiting.len()).unwrap_or(2).min(2);
        let [list, wait, help] = Layout::vertical([
            Constraint::Min(0),
            Constraint::Length(waiting_rows),
            Constraint::Length(help_rows),
        ])
        .areas(area);
        let strong = painter.theme.strong();
        painter.lines(wait, waiting.into_iter().map(|line| (line, strong)));
        let list = filter_line(painter, list, editor);
        fields(painter, list, editor);
        if editor.editing.is_some() {
            edit_lines(painter, help, document);
        } else {
            help_lines(painter, help, editor);
        }
    }
}

fn filter_line(painter: &mut Painter, list: Rect, editor: &ParameterEditor) -> Rect {
    let all = editor.rows.iter().filter(|row| row.is_shown()).count();
    painter.filter_line(list, &editor.filter, (editor.fields().count(), all))
}

/// A line of the list.
enum ListLine<'a> {
    Group(&'a str),
    Field(usize, &'a FieldRow),
    /// The fields that are folded away.
    Folded,
}

fn fields(painter: &mut Painter, list: Rect, editor: &ParameterEditor) {
    let mut lines = Vec::new();
    let mut group = "";
    let mut cursor = 0;
    for (i, field) in editor.fields().enumerate() {
        if field.group != group {
            group = &field.group;
            lines.push(ListLine::Group(group));
        }
        if i == editor.field {
            cursor = lines.len();
        }
        lines.push(ListLine::Field(i, field));
    }
    if lines.is_empty() {
        painter.text(list, "No field passes the filter.", painter.theme.plain());
    }
    if editor.folded && editor.filter.is_empty() && editor.folded_away().0 > 0 {
        lines.push(ListLine::Folded);
    }
    let compact = list.width < COMPACT;
    let label = |field: &FieldRow| field.label.width();
    let unit = |field: &FieldRow| field.unit.width();
    let longest = (
        editor.fields().map(label).max().unwrap_or(0),
        editor.fields().map(unit).max().unwrap_or(0),
    );
    painter.list(list, cursor, lines.len(), |painter, at, i| match lines[i] {
        ListLine::Group(name) => {
            painter.text(at, name, painter.theme.head());
        }
        ListLine::Field(i, field) if compact => {
            compact_line(painter, at, shown(editor, field), i == editor.field);
        }
        ListLine::Field(i, field) => {
            field_line(
                painter,
                at,
                shown(editor, field),
                longest,
                i == editor.field,
            );
        }
        ListLine::Folded => folded_line(painter, at, editor),
    });
}

/// Narrower lists have value, unit and standing close together.
const COMPACT: u16 = 56;

/// What is folded away.
fn folded_line(painter: &mut Painter, at: Rect, editor: &ParameterEditor) {
    let (count, assumed) = editor.folded_away();
    let words = format!("+ {count} defaults, {assumed} inputs assumed (x)");
    painter.text(at, &words, painter.theme.faint());
}

/// Label, value with unit, and where the value comes from, in little room.
fn compact_line(painter: &mut Painter, line: Rect, shown: ShownField, selected: bool) {
    let (field, instead) = shown;
    let base = painter.line_style(selected);
    painter.buf.set_style(line, base);
    let note = note(shown);
    let note_width = u16::try_from(note.width()).unwrap_or(0).max(5);
    let value = match (instead, field.absent) {
        (Some(instead), _) => format!("{} {}", instead.words(), field.unit)
            .trim_end()
            .to_owned(),
        (None, Some(words)) if field.value.is_empty() => words.to_owned(),
        _ => format!("{} {}", field.shown_value(), field.unit)
            .trim_end()
            .to_owned(),
    };
    let value_width = u16::try_from(value.width()).unwrap_or(0);
    let room = line.width.saturating_sub(note_width + 2);
    let label_width = room.saturating_sub(value_width + 1).max(room / 2);
    painter.text(
        span(line, 1, label_width.saturating_sub(1)),
        &field.label,
        base,
    );
    let at = span(line, label_width, room - label_width);
    let strong = if field.given {
        base.patch(painter.theme.strong())
    } else {
        base
    };
    let from = at.width.saturating_sub(value_width);
    painter.text(span(at, from, at.width - from), &value, strong);
    let style = note_style(painter, field, base);
    painter.text(span(line, room + 1, note_width), note, style);
}

/// Where a value comes from, in a word.
fn note((field, instead): ShownField) -> &'static str {
    match &field.standing {
        _ if matches!(instead, Some(Instead::Unchecked(_))) => "checking",
        _ if field.replaced.is_some() => YOURS,
        Some(mark) => mark.status.name(),
        None if !field.applies => "no effect",
        None if field.computed.is_some() => "computed",
        None if !field.given => "default",
        None => "",
    }
}

fn note_style(painter: &Painter, field: &FieldRow, base: Style) -> Style {
    let theme = painter.theme;
    match (&field.standing, &field.replaced) {
        (_, Some(_)) => base.patch(theme.strong()),
        (Some(_), None) => base.patch(theme.warning()),
        (None, None) => base.patch(theme.faint()),
    }
}

/// Columns of a number with its sign and exponent.
const NUMBER: u16 = 12;

/// Columns of labels and units: as many as the longest needs, where numbers have room beside them.
fn columns(longest: usize) -> u16 {
    u16::try_from(longest + 1).unwrap_or(u16::MAX)
}

/// A field, and what is shown in place of its value.
type ShownField<'a> = (&'a FieldRow, Option<Instead<'a>>);

/// What is shown in place of the value of a field.
#[derive(Clone, Copy)]
enum Instead<'a> {
    /// A range that waits for one in a further field.
    Range(&'a str),
    /// A value that is being checked.
    Unchecked(&'a str),
}

impl<'a> Instead<'a> {
    const fn words(self) -> &'a str {
        match self {
            Self::Range(words) | Self::Unchecked(words) => words,
        }
    }
}

fn shown<'a>(editor: &'a ParameterEditor, field: &'a FieldRow) -> ShownField<'a> {
    let range = editor.kept_range(&field.path).map(Instead::Range);
    let unchecked = editor.pending.value(&field.path).map(Instead::Unchecked);
    (field, range.or(unchecked))
}

/// Label, value, unit, and where the value comes from.
fn field_line(
    painter: &mut Painter,
    line: Rect,
    shown: ShownField,
    longest: (usize, usize),
    selected: bool,
) {
    let (field, instead) = shown;
    let theme = painter.theme;
    let base = painter.line_style(selected);
    painter.buf.set_style(line, base);
    let note = note(shown);
    let note_width = 11.min(line.width / 4);
    let unit_width = columns(longest.1).clamp(4, 9).min(line.width / 6);
    let room = line.width.saturating_sub(note_width + unit_width + 4);
    let left = room.saturating_sub(NUMBER).max(room / 2);
    let label_width = columns(longest.0).max(25).min(left);
    let value_width = room - label_width;
    let (value, style) = match (instead, field.absent) {
        (Some(instead), _) => (instead.words(), base.patch(theme.strong())),
        (None, Some(words)) if field.value.is_empty() => (words, base.patch(theme.faint())),
        _ if !field.applies => (field.shown_value(), base.patch(theme.faint())),
        _ if field.given => (field.shown_value(), base.patch(theme.strong())),
        _ => (field.shown_value(), base),
    };
    let note_style = note_style(painter, field, base);
    let unit_x = 3 + label_width + value_width;
    let cells: [(u16, u16, &str, Style); 4] = [
        (2, label_width.saturating_sub(1), &field.label, base),
        (2 + label_width, value_width, value, style),
        (unit_x, unit_width, field.unit, base),
        (unit_x + unit_width + 1, line.width, note, note_style),
    ];
    for (from, width, words, style) in cells {
        painter.text(span(line, from, width), words, style);
    }
}

/// Help, range, and why a value is assumed.
fn help_lines(painter: &mut Painter, area: Rect, editor: &ParameterEditor) {
    let Some(field) = editor.current_field() else {
        return;
    };
    let mut words = vec![
        format!("{}: {}", field.path, field.help),
        range_words(field),
    ];
    let replaced = field.replaced.as_ref().map(ReplacedValue::words);
    let standing = field.standing.as_ref();
    let standing = standing.map(|mark| format!("{}: {}", mark.status.name(), mark.reason));
    let computed = field.computed.as_ref();
    let computed = computed.map(|_| format!("computed by the file: {}", field.value));
    words.extend(computed.into_iter().chain(replaced).chain(standing));
    if area.width < COMPACT {
        // In little room first what is not in the documentation.
        words.rotate_left(2);
    }
    let words = words.join("\n");
    let (plain, faint) = (painter.theme.plain(), painter.theme.faint());
    let styles = std::iter::once(plain).chain(std::iter::repeat(faint));
    painter.lines(
        area,
        wrap(&words, area.width.into()).into_iter().zip(styles),
    );
}

/// The value being typed, and why it is refused.
fn edit_lines(painter: &mut Painter, area: Rect, document: &Document) {
    let editor = &document.editor;
    let (Some(editing), Some(field)) = (&editor.editing, editor.current_field()) else {
        return;
    };
    let line = row(area, 0);
    let unit = if field.unit.is_empty() {
        String::new()
    } else {
        format!(" [{}]", field.unit)
    };
    let prompt = format!("{}{unit} = ", field.label);
    let half = span(line, 0, line.width / 2);
    let x = painter.text(half, &prompt, painter.theme.strong()).x;
    painter.input(rest(line, x), &editing.input, true);
    let (words, style) = match (&editing.problem, vary::typed(document)) {
        _ if !editor.pending.is_empty() => (
            "The file is checked with this value; Ctrl-C twice drops it.".to_owned(),
            painter.theme.plain(),
        ),
        (Some(problem), _) => (format!("Refused: {problem}"), painter.theme.error()),
        (None, Some(typed)) => (vary::words(&typed, editor), painter.theme.plain()),
        (None, None) => {
            let empty = if document.line().is_some() && optional(field) {
                "; nothing typed: not given"
            } else {
                ""
            };
            let range = range_words(field);
            let words = format!("{range}\nEnter takes it, Esc leaves it as it was{empty}.");
            (words, painter.theme.faint())
        }
    };
    let [_, below] = below_head(area);
    let lines = wrap(&words, area.width.into());
    painter.lines(below, lines.into_iter().map(|line| (line, style)));
}

fn range_words(field: &FieldRow) -> String {
    if field.range.is_empty() {
        String::new()
    } else {
        format!("May be: {}", field.range)
    }
}
