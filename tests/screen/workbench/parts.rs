//! What takes more than drawing is worked out behind the screen: panes show what was answered, and nothing else.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use seacable::case::shipped;
use seacable::kinds::FileType;
use seacable::table::Table;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::parts::{PartKey, PartView};
use seacable::tui::state::reading;
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{LARGE, SMALL, has};

const OLDER: &str = "older than the inputs: computing";

/// A shipped file, open, whose parts are answered by the test.
fn open(kind: FileType, name: &str, text: &str, size: (u16, u16)) -> Desk {
    let path = PathBuf::from("cases").join(name);
    let content = reading::content(kind, text, &path, name).unwrap();
    let mut desk = Desk::new(size);
    desk.parts_at_once = false;
    let read = FileRead::new(path, text.to_owned(), content, None);
    desk.tell(Msg::FileRead(Box::new(read)));
    desk
}

/// The parts asked for and not answered.
fn asked(desk: &mut Desk) -> Vec<PartKey> {
    let mut keys = Vec::new();
    desk.asked.retain(|effect| match effect {
        Effect::MakePart(request) => {
            keys.push(request.key.clone());
            false
        }
        _ => true,
    });
    keys
}

/// Answers with a table that has this title alone.
fn answer(desk: &mut Desk, keys: Vec<PartKey>, title: &str) {
    for key in keys {
        let view = PartView {
            table: Table::titled(title),
            words: vec![(title.to_owned(), Default::default())],
            ..PartView::default()
        };
        desk.tell(Msg::PartMade(Box::new(key), Arc::new(view)));
    }
}

#[test]
fn tabs_and_views_of_models_show_what_was_answered_and_nothing_else() {
    for (kind, files) in shipped::BY_KIND {
        if kind == FileType::Line {
            continue;
        }
        for (name, text) in files {
            let mut desk = open(kind, name, text, SMALL);
            let panes = desk.state.panes().to_vec();
            for (i, pane) in panes.iter().enumerate() {
                desk.keys(&((i + 1) % 10).to_string());
                let tabs = match pane {
                    PaneId::Inputs
                    | PaneId::Validation
                    | PaneId::Charts
                    | PaneId::Runs
                    | PaneId::Results
                    | PaneId::Report
                    | PaneId::Sweep
                    | PaneId::Jobs
                    | PaneId::Modes => continue,
                    PaneId::Tables => desk.state.document.as_ref().unwrap().tables.len(),
                    _ => 1,
                };
                for tab in 0..tabs {
                    // The first view was asked for when the file was opened.
                    let screen = desk.screen();
                    assert!(
                        screen.contains("Computing."),
                        "{name} {pane:?} {tab}\n{screen}"
                    );
                    let keys = asked(&mut desk);
                    assert_eq!(keys.len(), 1, "{name} {pane:?} {tab}");
                    let title = format!("answer {i} {tab}");
                    answer(&mut desk, keys, &title);
                    let screen = desk.screen();
                    let drawn = matches!(pane, PaneId::Drawing) || screen.contains(&title);
                    assert!(drawn && !screen.contains(OLDER), "{screen}");
                    desk.keys("j");
                    assert!(asked(&mut desk).len() <= 1);
                    if tab + 1 < tabs {
                        desk.keys("]");
                    }
                }
            }
        }
    }
}

fn ropeway(size: (u16, u16)) -> Desk {
    let (name, text) = shipped::ROPEWAYS[3];
    open(FileType::Ropeway, name, text, size)
}

#[test]
fn the_slider_moves_at_once_and_its_results_follow() {
    let mut desk = ropeway(LARGE);
    let keys = asked(&mut desk);
    assert_eq!(keys.len(), 2, "the view, and the table below it");
    answer(&mut desk, keys, "at the middle");
    desk.keys("l l l");
    let screen = desk.screen();
    assert!(
        screen.contains("53.0 %") && screen.contains(OLDER),
        "{screen}"
    );
    // One view at a time, and nothing of the tables: the crossing does not depend on the position.
    let keys = asked(&mut desk);
    assert_eq!(keys.len(), 1);
    answer(&mut desk, keys, "at 0.51");
    assert!(desk.screen().contains(OLDER));
    let keys = asked(&mut desk);
    answer(&mut desk, keys, "at 0.53");
    let screen = desk.screen();
    assert!(
        screen.contains("at 0.53") && !screen.contains(OLDER),
        "{screen}"
    );
    assert!(asked(&mut desk).is_empty());
}

#[test]
fn an_edit_makes_parts_older_until_they_are_answered() {
    let mut desk = ropeway(LARGE);
    let keys = asked(&mut desk);
    let stale = keys.clone();
    answer(&mut desk, keys, "before");
    desk.keys("1 /");
    desk.type_text("setting.sag");
    desk.keys("enter enter ctrl+u 5 enter");
    assert!(desk.screen().contains(OLDER));
    answer(&mut desk, stale, "of the text before");
    let screen = desk.screen();
    assert!(screen.contains(OLDER) && !screen.contains("of the text before"));
    let keys = asked(&mut desk);
    assert_eq!(keys.len(), 2);
    answer(&mut desk, keys, "after");
    assert!(!desk.screen().contains(OLDER));
}

#[test]
fn the_validation_table_follows_its_runs_and_writing_waits_for_it() {
    let (kind, text) = (FileType::Line, super::desk::CASE);
    let mut desk = open(kind, "body.toml", text, SMALL);
    desk.keys("4");
    assert!(desk.screen().contains("Computing."), "nothing is known yet");
    let mut desk = Desk::with_case(SMALL);
    desk.parts_at_once = false;
    desk.keys("R");
    desk.finish_jobs();
    desk.keys("4");
    assert!(desk.screen().contains(OLDER));
    desk.keys("w");
    let writes = |effect: &Effect| matches!(effect, Effect::WriteText { .. });
    assert!(!has(&desk, writes));
    let at = desk
        .asked
        .iter()
        .rposition(|e| matches!(e, Effect::CheckValues(_)));
    let Effect::CheckValues(check) = desk.asked.remove(at.unwrap()) else {
        panic!("no comparison was asked for");
    };
    desk.tell(Msg::ValuesChecked(
        Arc::clone(&check.token),
        Box::new(check.table()),
    ));
    // Runs that landed meanwhile are compared next.
    while let Some(at) = desk
        .asked
        .iter()
        .rposition(|e| matches!(e, Effect::CheckValues(_)))
    {
        if let Effect::CheckValues(check) = desk.asked.remove(at) {
            desk.tell(Msg::ValuesChecked(
                Arc::clone(&check.token),
                Box::new(check.table()),
            ));
        }
    }
    assert!(!desk.screen().contains(OLDER));
    assert!(has(&desk, writes));
}

/// What computes, parses or solves, by its names in the sources.
const FAR: &[&str] = &[
    "facade::parse",
    "facade::checks",
    "reference::table",
    "kind::parse",
    "case::parse",
    "part_views::of_model",
    "part_views::line",
    "report::ropeway",
    "report::section",
    "report::ship",
    "report::system",
    "validation::rows",
    ".results()",
    ".computed()",
    "material_table",
    "limits::of_run",
    ".csv(",
    "Analyses::of",
];

#[test]
fn panes_updates_and_views_name_nothing_that_computes() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/tui");
    let mut folders = ["panes", "update", "view"]
        .map(|name| root.join(name))
        .to_vec();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            for name in FAR {
                assert!(!text.contains(name), "{} names {name}", path.display());
            }
        }
    }
}
