//! Tables: filters, columns that are hidden, and what every column is.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use seacable::study::hard_cases;
use seacable::table::{Table, explanations};
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::Overlay;
use seacable::tui::state::reading::read_file;
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{LARGE, SMALL, said};

/// Shipped files that have all tables of their kinds between them.
const FILES: [&str; 11] = [
    "basics/hanging_line.toml",
    "basics/steep_wave.toml",
    "umbilical/section.toml",
    "ropeway/hauling.toml",
    "ropeway/made_fast.toml",
    "ropeway/span_80.toml",
    "ship/anchored.toml",
    "ship/coupled.toml",
    "systems/crows_foot.toml",
    "systems/buoy_and_clump.toml",
    "systems/oc3_spar.toml",
];

/// A shipped file, open.
fn opened(name: &str) -> Desk {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases")
        .join(name);
    let (text, content) = read_file(&path).unwrap();
    let mut desk = Desk::new(LARGE);
    let read = FileRead::new(PathBuf::from("cases").join(name), text, content, None);
    desk.tell(Msg::FileRead(Box::new(read)));
    desk
}

/// The heads of a table that nothing is known of.
fn unknown(table: &Table, name: &str, found: &mut BTreeSet<String>) {
    for column in &table.columns {
        if explanations::known(&table.title, &column.head).is_none() {
            found.insert(format!("{name}: `{}` of \"{}\"", column.head, table.title));
        }
    }
}

/// The tables of a file, pane by pane.
fn of_file(name: &str, found: &mut BTreeSet<String>) {
    let mut desk = opened(name);
    desk.finish_jobs();
    for effect in std::mem::take(&mut desk.asked) {
        if let Effect::FindModes { of, text } = effect {
            desk.tell(Msg::Modes(text, of.find()));
        }
    }
    for pane in desk.state.panes() {
        desk.state.document.as_mut().unwrap().pane = *pane;
        let tabs = if matches!(pane, PaneId::Tables | PaneId::Nodes) {
            12
        } else {
            1
        };
        for _ in 0..tabs {
            // What is seen is asked for with the next message.
            desk.tell(Msg::Resize(LARGE.0, LARGE.1));
            if let Some(table) = desk.state.focused_table() {
                unknown(&table, name, found);
            }
            desk.keys("]");
        }
    }
}

#[test]
fn every_column_of_the_tables_on_the_screen_is_explained() {
    let mut found = BTreeSet::new();
    for name in FILES {
        of_file(name, &mut found);
    }
    for table in [hard_cases::table(&[]), hard_cases::compact_table(&[])] {
        unknown(&table, "trials", &mut found);
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// The case with a run, its nodes shown.
fn nodes() -> Desk {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("7");
    desk
}

#[test]
fn a_table_is_filtered_and_esc_drops_the_filter_before_it_leaves() {
    let mut desk = nodes();
    let rows = desk.state.focused_table().unwrap().rows.len();
    assert!(rows > 5);
    desk.keys("/");
    desk.type_text("tension");
    let shown = |desk: &Desk| {
        let table = desk.state.focused_table().unwrap();
        desk.state.table_pane().unwrap().count(&table)
    };
    let few = shown(&desk);
    assert!(0 < few && few < rows, "{few} of {rows}");
    assert!(
        desk.screen().contains(&format!("{few} of {rows}")),
        "{}",
        desk.screen()
    );
    desk.keys("enter j j");
    assert!(desk.state.table_pane().unwrap().selected <= few);
    desk.keys("esc");
    assert_eq!(shown(&desk), rows);
    assert!(desk.state.document.is_some());
    desk.keys("esc");
    assert!(desk.state.document.is_none());
}

#[test]
fn columns_are_explained_sorted_by_and_hidden_under_their_cursor() {
    let mut desk = nodes();
    let heads = |desk: &Desk| {
        let table = desk.state.focused_table().unwrap();
        let pane = desk.state.table_pane().unwrap();
        pane.shown(&table).len()
    };
    let all = heads(&desk);
    desk.keys("-");
    assert!(
        said(&desk).contains("`l` puts it on one"),
        "{}",
        said(&desk)
    );
    desk.keys("l l i");
    let Some(Overlay::Explanation { title, text }) = &desk.state.overlay else {
        panic!("no explanation");
    };
    assert!(!title.is_empty() && text.len() > 20, "{title}: {text}");
    desk.keys("x");
    assert!(desk.state.overlay.is_none());
    desk.keys("o");
    let sorted = desk
        .state
        .table_pane()
        .unwrap()
        .sorted_by()
        .cloned()
        .unwrap();
    desk.keys("o");
    let around = desk
        .state
        .table_pane()
        .unwrap()
        .sorted_by()
        .cloned()
        .unwrap();
    assert_eq!(
        (sorted.0.clone(), sorted.1, around.1),
        (around.0.clone(), false, true)
    );
    desk.keys("- -");
    assert_eq!(heads(&desk), all - 2);
    desk.keys("+");
    assert_eq!(heads(&desk), all);
}

#[test]
fn columns_of_the_runs_are_explained_and_hidden() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("R");
    desk.finish_jobs();
    desk.keys("3 l l i");
    let Some(Overlay::Explanation { text, .. }) = &desk.state.overlay else {
        panic!("no explanation");
    };
    assert!(text.contains('.'), "{text}");
    let shown = |desk: &Desk| desk.state.runs_view().unwrap().runs.shown_columns().len();
    let all = shown(&desk);
    desk.keys("esc -");
    assert_eq!(shown(&desk), all - 1);
    desk.keys("+");
    assert_eq!(shown(&desk), all);
}

#[test]
fn help_messages_and_jobs_are_filtered() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("? /");
    desk.type_text("solver");
    let screen = desk.screen();
    assert!(
        screen.contains("Run the case") && !screen.contains("Undo the last edit"),
        "{screen}"
    );
    desk.keys("enter esc");
    assert!(matches!(desk.state.overlay, Some(Overlay::Help { .. })));
    desk.keys("esc");
    assert!(desk.state.overlay.is_none());
    desk.state
        .say(seacable::tui::state::Severity::Info, "one anchor");
    desk.state
        .say(seacable::tui::state::Severity::Info, "one buoy");
    desk.keys("! /");
    desk.type_text("anchor");
    let screen = desk.screen();
    assert!(
        screen.contains("one anchor") && screen.contains("1 of "),
        "{screen}"
    );
    desk.keys("esc esc R");
    desk.finish_jobs();
    desk.keys("6 /");
    desk.type_text("nothing like that");
    assert_eq!(desk.state.jobs.shown().len(), 0);
    desk.keys("esc");
    assert!(!desk.state.jobs.shown().is_empty());
}
