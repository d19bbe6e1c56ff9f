//! Every command of every pane of every kind of file, and what it opens, with hostile files: nothing of them reaches a cell raw. The
//! lists of panes and of what lies over them are those of the program: one that the walk does not see fails it.

use std::collections::BTreeSet;
use std::path::PathBuf;

use seacable::tui::command::CommandId;
use seacable::tui::pane::PaneId;
use seacable::tui::recovery::RecoveredEdits;
use seacable::tui::state::overlay::RunText;
use seacable::tui::state::{Overlay, PromptPurpose, Question};
use seacable::tui::update::run_command;
use seacable::tui::{Msg, panes, plots};

use super::answers::{answers, found_jobs};
use super::documents::{KINDS, file_read, list, open};
use super::{HOSTILE, SEEN, check};
use crate::workbench::desk::Desk;
use crate::workbench::{LARGE, SMALL};

/// The variants of an enumeration by name: a list, and a match that does not compile where one is missing.
macro_rules! every {
    ($all:ident, $name:ident, $of:ty { $($variant:pat => $words:literal,)* }) => {
        const $all: &[&str] = &[$($words),*];

        fn $name(it: &$of) -> &'static str {
            match it {
                $($variant => $words,)*
            }
        }
    };
}

every!(PANES, pane_name, PaneId {
    PaneId::Cases => "cases",
    PaneId::Inputs => "inputs",
    PaneId::Charts => "charts",
    PaneId::Results => "results",
    PaneId::Runs => "runs",
    PaneId::Validation => "validation",
    PaneId::Report => "report",
    PaneId::Jobs => "jobs",
    PaneId::Trials => "trials",
    PaneId::Nodes => "nodes",
    PaneId::Modes => "modes",
    PaneId::Tables => "tables",
    PaneId::Drawing => "drawing",
    PaneId::Ropeway => "ropeway",
    PaneId::Ship => "ship",
    PaneId::System => "system",
    PaneId::Sweep => "load cases",
    PaneId::Model => "model",
});

every!(OVERLAYS, overlay_name, Overlay {
    Overlay::Help { .. } => "help",
    Overlay::Palette(_) => "palette",
    Overlay::Messages { .. } => "messages",
    Overlay::Explanation { .. } => "explanation",
    Overlay::Text { .. } => "text",
    Overlay::Page { .. } => "page",
    Overlay::Ask(Question::Unsaved { .. }) => "unsaved",
    Overlay::Ask(Question::JobsRunning) => "jobs running",
    Overlay::Ask(Question::JobsGoOn { .. }) => "jobs go on",
    Overlay::Ask(Question::DeleteRuns { .. }) => "delete runs",
    Overlay::Ask(Question::Recover { .. }) => "recover",
    Overlay::Ask(Question::Overwrite) => "overwrite",
    Overlay::Ask(Question::ManyRuns { .. }) => "many runs",
    Overlay::Ask(Question::ReportFormat) => "report format",
    Overlay::Studies { .. } => "studies",
    Overlay::Curves { .. } => "curves",
    Overlay::LineTypes(_) => "line types",
    Overlay::Picker(_) => "picker",
    Overlay::Form(_) => "form",
    Overlay::Columns(_) => "columns",
    Overlay::Prompt { purpose: PromptPurpose::Resume(_), .. } => "resume",
    Overlay::Prompt { purpose: PromptPurpose::SaveAs, .. } => "save as",
    Overlay::Prompt { purpose: PromptPurpose::RunText { what: RunText::Name, .. }, .. } => "name",
    Overlay::Prompt { purpose: PromptPurpose::RunText { what: RunText::Tags, .. }, .. } => "tags",
    Overlay::Prompt { purpose: PromptPurpose::RunText { what: RunText::Note, .. }, .. } => "note",
});

/// As many charts or tables as no pane has.
const TABS: usize = 12;

/// What the walk has seen.
#[derive(Default)]
struct Walk {
    panes: BTreeSet<&'static str>,
    overlays: BTreeSet<&'static str>,
    frames: usize,
}

impl Walk {
    /// Looks at the screen.
    fn look(&mut self, desk: &Desk, what: &dyn Fn() -> String) {
        self.frames += 1;
        self.panes.insert(pane_name(&desk.state.focus()));
        self.overlays
            .extend(desk.state.overlay.as_ref().map(overlay_name));
        check(desk, what);
    }

    /// Every pane with every command, at both sizes.
    fn walk(&mut self, kind: &str, desk: &mut Desk) {
        for size in [SMALL, LARGE] {
            desk.tell(Msg::Resize(size.0, size.1));
            let numbers = 1..=desk.state.panes().len().max(1);
            let keys = numbers.map(|number| (number % 10).to_string());
            for number in keys.chain(["B".to_owned()]) {
                if desk.state.document.is_some() {
                    desk.keys(&number);
                }
                let what = || format!("{kind}, pane {number} at {size:?}");
                self.look(desk, &what);
                // On the small screen the same commands, from one place only.
                let places = places(desk.state.focus());
                let count = if size == SMALL { 1 } else { places.len() };
                for keys in &places[..count] {
                    desk.keys(keys);
                    let what = || format!("{}, {keys}", what());
                    self.look(desk, &what);
                    for command in panes::commands(&desk.state) {
                        self.command(desk, command.id, &|| {
                            format!("{}, `{:?}`", what(), command.id)
                        });
                    }
                }
                // Every chart, every table.
                for tab in 0..TABS {
                    desk.keys("]");
                    self.look(desk, &|| format!("{}, tab {tab}", what()));
                }
            }
        }
    }

    /// Does a command, types into what it opens, and hears the worst answers.
    fn command(&mut self, from: &Desk, id: CommandId, what: &dyn Fn() -> String) {
        let mut desk = copy(from);
        let effects = run_command(&mut desk.state, id);
        desk.perform(effects);
        self.look(&desk, what);
        if matches!(id, CommandId::Pane(_) | CommandId::Redraw) {
            return;
        }
        for effect in std::mem::take(&mut desk.asked) {
            for answer in answers(effect) {
                desk.tell(answer);
                self.look(&desk, &|| format!("{}, answered", what()));
            }
        }
        let typed = desk.state.overlay.is_some() || is_typing(&mut desk);
        if typed {
            for key in ["down", "end"] {
                desk.keys(key);
                self.look(&desk, &|| format!("{}, {key}", what()));
            }
            desk.tell(Msg::Paste(HOSTILE.to_owned()));
            self.look(&desk, &|| format!("{}, pasted into", what()));
            for key in ["enter", "enter", "!"] {
                desk.keys(key);
                self.look(&desk, &|| format!("{}, {key}", what()));
            }
        }
    }
}

/// Keys that lead to places of a pane, one after the other, where its commands do something else.
fn places(pane: PaneId) -> &'static [&'static str] {
    match pane {
        // Every run: live, of this session, and of the index in every state.
        PaneId::Runs => &["g", "j", "j", "j", "j", "j", "j m k m"],
        // With a cursor on the chart.
        PaneId::Charts | PaneId::Results => &["g", "l l"],
        PaneId::Inputs | PaneId::Model => &["g", "j", "G"],
        _ => &["g"],
    }
}

fn is_typing(desk: &mut Desk) -> bool {
    let editing = |desk: &Desk| desk.state.editor().is_some_and(|e| e.editing.is_some());
    editing(desk)
        || desk
            .state
            .filter_mut()
            .is_some_and(|(filter, ..)| filter.typing)
}

/// The same workbench again.
fn copy(desk: &Desk) -> Desk {
    Desk {
        state: desk.state.clone(),
        asked: Vec::new(),
        opens_new_files: false,
        // Elsewhere edits are answered as here, and some take long.
        checks_at_once: desk.state.focus() == PaneId::Inputs,
        // The walk has seen those of the file; those of edited ones take long.
        parts_at_once: false,
    }
}

#[test]
fn every_pane_and_all_that_lies_over_it() {
    let mut walk = Walk::default();
    let mut desk = list();
    assert!(desk.screen().contains(SEEN), "{}", desk.screen());
    walk.walk("the list", &mut desk);
    for kind in KINDS {
        let mut desk = open(kind);
        desk.keys("1");
        assert!(desk.screen().contains(SEEN), "{kind}: {}", desk.screen());
        walk.walk(kind, &mut desk);
    }
    rare(&mut walk);
    assert_eq!(walk.panes, PANES.iter().copied().collect());
    assert_eq!(walk.overlays, OVERLAYS.iter().copied().collect());
    assert!(walk.frames > 5000, "{}", walk.frames);
}

/// What no single command opens.
fn rare(walk: &mut Walk) {
    let line = open("line");
    let charted = line
        .state
        .charted()
        .map(|on| plots::chart(on, on.view.chart));
    let labels = charted.map_or(Vec::new(), |chart| chart.series);
    assert!(labels.iter().any(|series| series.label.contains(HOSTILE)));
    let mut desk = copy(&line);
    desk.checks_at_once = true;
    desk.keys("1 M");
    for command in panes::commands(&desk.state) {
        walk.command(&desk, command.id, &|| format!("edited, `{:?}`", command.id));
    }
    let mut desk = copy(&line);
    desk.keys("R q");
    walk.look(&desk, &|| "jobs on their way".to_owned());
    let mut desk = copy(&line);
    desk.state.jobs.processes = Some(PathBuf::from("/"));
    for found in found_jobs() {
        desk.tell(found);
        for key in ["6", "!", "esc"] {
            desk.keys(key);
            walk.look(&desk, &|| format!("jobs found, {key}"));
        }
    }
    desk.keys("R q");
    walk.look(&desk, &|| "jobs that go on".to_owned());
    let mut desk = copy(&line);
    desk.keys("1 /");
    desk.type_text("current speed");
    desk.keys("enter enter ctrl+u");
    desk.tell(Msg::Paste("0..1/500".to_owned()));
    desk.keys("enter");
    walk.look(&desk, &|| "many runs".to_owned());
    let kept = vec![HOSTILE.to_owned(), format!("{HOSTILE}=0..1/5")];
    let left = RecoveredEdits {
        text: HOSTILE.to_owned(),
        kept,
    };
    for key in ["esc", "d", "r"] {
        let mut desk = list();
        desk.tell(file_read("line", Some(left.clone())));
        walk.look(&desk, &|| "edits kept".to_owned());
        desk.keys(key);
        walk.look(&desk, &|| format!("edits kept, {key}"));
        desk.keys("!");
        walk.look(&desk, &|| format!("edits kept, {key}, messages"));
    }
}
