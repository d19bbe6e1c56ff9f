//! Ranges typed into a field: a run of the case at each of their values.
//!
//! `0.2..0.8/4` or `0.2, 0.4, 0.8` in a field varies it alone; ` x KEY=VALUES` behind it varies a further key, to a grid. `+` keeps
//! the range, and one typed into a further field makes the grid.

use super::notice::info;
use super::{jobs, recovery, runs, studies};
use crate::case::fields::{Field, ValueType};
use crate::case::{self, StudyValue, TextDigest};
use crate::msg::Effect;
use crate::pane::PaneId;
use crate::run::job::Request;
use crate::state::{
    AppState, Document, JobRequest, KeptRange, Overlay, ParameterEditor, Question, RunEntry,
    Severity, VariedRuns,
};
use crate::study::points::{BaseCase, Setting};
use crate::study::vary::{Variation, VariationError, VariedKey};

/// More runs than this are asked about first.
const MANY: usize = 200;

/// More runs than this are no work for the screen.
const MOST: usize = 2000;

/// Values of a key that are named one by one.
const NAMED: usize = 8;

/// What is being typed, as a variation of the case; nothing where it is one value.
#[must_use]
pub fn typed(document: &Document) -> Option<Result<Variation, VariationError>> {
    let words = typed_words(document)?;
    let editor = &document.editor;
    let keys = words.iter().map(|word| varied_key(editor, word));
    let keys = keys.collect::<Result<Vec<_>, _>>();
    Some(keys.and_then(|keys| Variation::of_keys(BaseCase::new(&editor.text, &editor.file), keys)))
}

/// Reads `KEY=VALUES` by the fields that are listed; the text is read only to say what is wrong with a key that is none of them.
fn varied_key(editor: &ParameterEditor, word: &str) -> Result<VariedKey, VariationError> {
    VariedKey::parse_by(word, |path| {
        let row = editor.rows.iter().find(|row| row.path == path);
        row.map_or_else(
            || case::edit::field(&editor.text, path),
            |row| Ok(row.field),
        )
    })
}

/// `KEY=VALUES` of the ranges kept, of the one being typed, and of those behind it.
fn typed_words(document: &Document) -> Option<Vec<String>> {
    document.line()?;
    let editor = &document.editor;
    let editing = editor.editing.as_ref()?;
    let row = editor.rows.iter().find(|row| row.path == editing.path)?;
    let mut parts = editing.input.value().split(" x ");
    let own = parts.next().filter(|own| is_range(own, row.field))?;
    let others = editor.kept.iter().filter(|kept| kept.path != row.path);
    let mut words: Vec<String> = others.map(KeptRange::word).collect();
    words.push(format!("{}={own}", row.path));
    words.extend(parts.map(str::to_owned));
    Some(words)
}

/// Whether a text is meant as several values. `1,5` and `1,500` are not: they may be a number with a comma.
fn is_range(text: &str, field: &Field) -> bool {
    let of_words = matches!(field.kind, ValueType::Choice(_) | ValueType::Boolean);
    if !(field.takes_number() || of_words) || text.trim().starts_with('[') {
        return false;
    }
    let listed = text.split_once(',').is_some_and(|(first, rest)| {
        let clear = first.contains('.') || rest.starts_with(' ') || of_words;
        clear && !rest.trim().is_empty()
    });
    text.contains("..") || listed
}

/// How a variation is read, or what it lacks; the key being edited is not named, and ranges kept are shown already.
#[must_use]
pub fn words(typed: &Result<Variation, VariationError>, editor: &ParameterEditor) -> String {
    let edited = editor.editing.as_ref();
    let is_edited = |key: &VariedKey| edited.is_some_and(|editing| editing.path == key.path);
    match typed {
        Ok(variation) => {
            let keys = variation.keys.iter();
            let keys = keys.filter(|key| is_edited(key) || editor.kept_range(&key.path).is_none());
            let keys = keys.map(|key| match is_edited(key) {
                true => values(key),
                false => format!("{} {}", key.path, values(key)),
            });
            let keys = keys.collect::<Vec<_>>().join(" x ");
            let runs = match variation.points.len() {
                1 => "1 run".to_owned(),
                count => format!("{count} runs"),
            };
            format!("Enter begins {runs}, + keeps the range for a grid: {keys}")
        }
        Err(why) => format!("Not yet a range: {}", reason(why)),
    }
}

/// The values of a key with their unit.
fn values(key: &VariedKey) -> String {
    let all = &key.range.values;
    let written = |value: &StudyValue| Setting::new(&key.path, value.clone()).written();
    let list = |some: &[StudyValue]| some.iter().map(written).collect::<Vec<_>>().join(", ");
    let words = match all.as_slice() {
        [first, second, .., last] if all.len() > NAMED => {
            format!(
                "{}, {} .. {}",
                written(first),
                written(second),
                written(last)
            )
        }
        few => list(few),
    };
    format!("{words} {}", key.unit()).trim_end().to_owned()
}

/// What is wrong, without the key that is being edited.
fn reason(why: &VariationError) -> String {
    let words = match why {
        VariationError::Range(_, why) => why.to_string(),
        why => why.to_string(),
    };
    format!("{}.", words.trim_end_matches('.'))
}

/// Enter on a range: runs it, asks first, or says what is wrong with it. Nothing where a value is typed.
pub(super) fn enter(state: &mut AppState) -> Option<Vec<Effect>> {
    let document = state.document.as_mut()?;
    let problem = match typed(document)? {
        Ok(variation) => match variation.points.len() {
            0..=MANY => return Some(begin(state)),
            count @ ..=MOST => {
                state.overlay = Some(Overlay::Ask(Question::ManyRuns { count }));
                return Some(Vec::new());
            }
            count => format!(
                "{count} runs are more than {MOST}; `seacable study vary` computes as many."
            ),
        },
        Err(why) => reason(&why),
    };
    if let Some(editing) = &mut document.editor.editing {
        editing.problem = Some(problem);
    }
    Some(Vec::new())
}

/// Whether a whole range is typed, with the cursor behind it: `+` is part of a number elsewhere.
pub(super) fn can_keep(state: &AppState) -> bool {
    let Some(document) = &state.document else {
        return false;
    };
    let editing = document.editor.editing.as_ref();
    let behind = editing.is_some_and(|editing| {
        let input = &editing.input;
        input.cursor() == input.value().chars().count()
    });
    behind && matches!(typed(document), Some(Ok(_)))
}

/// `+` behind a range: keeps it until a further field has one.
pub(super) fn keep(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &mut state.document else {
        return Vec::new();
    };
    let Some(words) = typed_words(document) else {
        return Vec::new();
    };
    let editor = &mut document.editor;
    editor.kept = words.iter().filter_map(|w| KeptRange::read(w)).collect();
    editor.editing = None;
    info(
        state,
        "The range is kept: one in a second field begins the grid, Esc drops it.",
    );
    recovery::keep_recovery(state)
}

/// Drops the ranges that wait.
pub fn drop_kept(state: &mut AppState) -> Vec<Effect> {
    if let Some(editor) = state.editor_mut() {
        editor.kept.clear();
    }
    info(state, "The range kept for a grid is dropped.");
    recovery::keep_recovery(state)
}

/// The ranges that wait, in words; nothing where none does.
#[must_use]
pub fn kept_words(editor: &ParameterEditor) -> Option<String> {
    let label = |path: &str| {
        let row = editor.rows.iter().find(|row| row.path == path);
        row.map_or_else(|| path.to_owned(), |row| row.label.clone().into_owned())
    };
    let kept = editor.kept.iter();
    let ranges = kept.map(|kept| format!("{} {}", label(&kept.path), kept.values));
    let ranges = ranges.collect::<Vec<_>>().join(" x ");
    let next = match editor.kept.len() {
        0 => return None,
        1 => "second",
        _ => "further",
    };
    Some(format!("{ranges}, waiting for a {next} field"))
}

/// Drops the ranges that the case of a new text no longer takes.
pub(super) fn recheck(state: &mut AppState) {
    let Some(editor) = state.editor_mut() else {
        return;
    };
    let kept = std::mem::take(&mut editor.kept);
    let before = kept.len();
    let takes = |kept: &KeptRange| varied_key(editor, &kept.word()).is_ok();
    let kept: Vec<KeptRange> = kept.into_iter().filter(takes).collect();
    let dropped = kept.len() < before;
    editor.kept = kept;
    if dropped {
        let words = "A range kept for a grid is dropped: the case no longer takes it.";
        state.say(Severity::Warning, words.to_owned());
    }
}

/// Asks for the texts of the runs.
pub(super) fn begin(state: &mut AppState) -> Vec<Effect> {
    let Some(document) = &mut state.document else {
        return Vec::new();
    };
    let Some(Ok(mut variation)) = typed(document) else {
        return Vec::new();
    };
    document.editor.editing = None;
    let had_kept = !std::mem::take(&mut document.editor.kept).is_empty();
    let Some((line, editor)) = document.line_and_editor() else {
        return Vec::new();
    };
    // What was edited is part of every run, but for the keys that vary.
    let mut overrides = jobs::overrides(editor);
    overrides.retain(|set| {
        let key = set.split('=').next();
        variation
            .keys
            .iter()
            .all(|varied| Some(varied.path.as_str()) != key)
    });
    variation.base = BaseCase {
        // With the files that it names: the name alone does not say where they are.
        text: case::stand_alone(&editor.text, &line.case).into_owned(),
        path: editor.file.clone(),
        overrides,
        files: line.case.files.clone(),
    };
    let mut effects = vec![Effect::Vary(editor.path.clone(), Box::new(variation))];
    if had_kept {
        effects.extend(recovery::keep_recovery(state));
    }
    effects
}

/// What became of the runs of a range.
#[derive(Debug, Default)]
struct Queued {
    begun: usize,
    there: usize,
    /// Why the case refuses the others.
    refused: Vec<String>,
}

/// Queues the runs that are not there yet, and shows them all.
pub(super) fn begun(state: &mut AppState, found: VariedRuns) -> Vec<Effect> {
    let Some(document) = state.document.as_mut() else {
        return Vec::new();
    };
    if document.editor.path != found.path {
        return Vec::new();
    }
    document.pane = PaneId::Runs;
    if let Some(line) = state.line_mut() {
        line.runs_view.hide_runs();
    }
    let mut effects = vec![Effect::RefreshRuns];
    let mut queued = Queued::default();
    for (label, request) in found.runs {
        match request {
            Ok(request) => effects.extend(show_or_queue(state, label, request, &mut queued)),
            Err(why) => queued.refused.push(format!("{label}: {why}")),
        }
    }
    if let Some(line) = state.line_mut() {
        line.runs_view.runs.arrange();
        if queued.begun > 0 {
            line.runs_view.runs.go_to_newest();
        }
    }
    effects.extend(jobs::start_waiting(state));
    runs::check(state);
    say(state, &found.keys, &queued);
    effects
}

/// Shows a run that is there already, or queues it.
fn show_or_queue(
    state: &mut AppState,
    label: String,
    mut request: Request,
    queued: &mut Queued,
) -> Vec<Effect> {
    let digest = TextDigest::of_text(&request.text);
    let same = |run: &RunEntry| run.text == digest && studies::usable(run);
    let Some((line, editor)) = state.document.as_mut().and_then(Document::line_and_editor) else {
        return Vec::new();
    };
    if let Some(run) = line.runs_view.runs.newest_mut(same) {
        queued.there += 1;
        run.label = label;
        run.shown = true;
        return runs::load(run);
    }
    queued.begun += 1;
    editor.stem().clone_into(&mut request.id);
    let request = JobRequest::Line(Box::new(request), None);
    jobs::queue(state, request, label, None, true);
    Vec::new()
}

/// Says what became of the runs.
fn say(state: &mut AppState, keys: &str, queued: &Queued) {
    let runs = match queued.begun {
        1 => "1 run".to_owned(),
        begun => format!("{begun} runs"),
    };
    let words = match (queued.begun, queued.there) {
        (0, 0) => format!("No run begun over {keys}."),
        (0, _) => format!("All runs over {keys} are there already; the charts show them."),
        (_, 0) => {
            format!("{runs} begun over {keys}. `:pane_2` shows the curves, `:pane_6` the jobs.")
        }
        (_, there) => {
            format!("{runs} begun over {keys}; {there} there already. `:pane_2` shows the curves.")
        }
    };
    info(state, words);
    if let Some(first) = queued.refused.first() {
        let count = queued.refused.len();
        let words = format!("The case refuses {count} of the runs. {first}");
        state.say(Severity::Error, words);
    }
}
