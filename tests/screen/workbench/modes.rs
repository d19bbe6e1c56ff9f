//! Natural modes and trials of hard cases on the screen.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use seacable::case;
use seacable::study::hard_cases::{self, HardCase, TrialRun};
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::trials::{TrialProgress, TrialsOf};
use seacable::tui::{Effect, Msg};

use super::desk::{Desk, content_of};
use super::{LARGE, SMALL, said, snapshot};

/// A case that comes with the program, open.
fn open(size: (u16, u16), file: &str, text: &str) -> Desk {
    let mut desk = Desk::new(size);
    desk.tell(Msg::FileRead(Box::new(FileRead::new(
        PathBuf::from("cases").join(file),
        text.to_owned(),
        content_of(case::parse(text, file).unwrap()),
        None,
    ))));
    desk
}

const CATENARY: &str = include_str!("../../../cases/basics/hanging_line.toml");

/// Answers what the screen asked for on modes; how often it asked.
fn answer_modes(desk: &mut Desk) -> usize {
    let asked: Vec<_> = std::mem::take(&mut desk.asked)
        .into_iter()
        .filter_map(|effect| match effect {
            Effect::FindModes { of, text } => Some((of, text)),
            _ => None,
        })
        .collect();
    for (of, text) in &asked {
        desk.tell(Msg::Modes(text.clone(), of.find()));
    }
    asked.len()
}

#[test]
fn modes_are_found_in_the_background_drawn_and_followed() {
    let mut desk = open(SMALL, "hanging_line.toml", CATENARY);
    desk.keys("8");
    assert!(desk.screen().contains("computed in the background"));
    assert_eq!(answer_modes(&mut desk), 1);
    desk.keys("j");
    snapshot("tui_modes_80x24", &desk);
    desk.keys("]");
    snapshot("tui_modes_over_the_line_80x24", &desk);
    // One search at a time: an edit while one is going on is followed when that one has ended.
    let frequency = |desk: &Desk| {
        let view = &desk.state.line().unwrap().modes;
        let found = view.found.as_ref().unwrap().as_ref().unwrap();
        found.modes[0].mode.frequency_hz()
    };
    let before = frequency(&desk);
    desk.keys("1 / l e n g t h _ m enter enter ctrl+u 8 0 0 enter");
    assert_eq!(frequency(&desk).to_bits(), before.to_bits());
    assert!(
        desk.state.line().unwrap().modes.beside,
        "seen beside the inputs"
    );
    assert_eq!(answer_modes(&mut desk), 1);
    assert!(
        frequency(&desk) < 0.9 * before,
        "a longer line swings slower"
    );
    assert_eq!(answer_modes(&mut desk), 0);
    desk.keys("8 w");
    let wrote = |e: &Effect| matches!(e, Effect::WriteText { path, .. } if path.ends_with("hanging_line-modes.csv"));
    assert!(desk.asked.iter().any(wrote));
    // The charts take the place beside the inputs back.
    desk.keys("2");
    assert!(!desk.state.line().unwrap().modes.beside);
}

/// The pane of modes of a whole system, on both sizes; an edit is followed beside the inputs.
#[test]
fn a_system_shows_the_modes_of_all_its_lines() {
    let mut desk = Desk::with_system(SMALL);
    desk.keys("6");
    assert!(desk.screen().contains("computed in the background"));
    assert_eq!(answer_modes(&mut desk), 1);
    snapshot("tui_system_modes_80x24", &desk);
    desk.tell(Msg::Resize(LARGE.0, LARGE.1));
    desk.keys("j");
    snapshot("tui_system_modes_200x60", &desk);
    desk.keys("1");
    assert!(desk.state.modes().unwrap().beside);
    assert!(desk.screen().contains("mostly"), "{}", desk.screen());
    desk.keys("2");
    assert!(!desk.state.modes().unwrap().beside);
}

#[test]
fn modes_have_the_right_half_of_a_large_screen() {
    let mut desk = open(LARGE, "hanging_line.toml", CATENARY);
    desk.keys("8");
    answer_modes(&mut desk);
    snapshot("tui_modes_200x60", &desk);
}

const FALLING: &str = include_str!("../../../cases/hard/falling.toml");

/// Computes the trials of a case, telling of the first so many, then of all.
fn trialled(first: usize) -> (TrialProgress, TrialProgress) {
    let hard = [HardCase::read(FALLING, "falling.toml").unwrap()];
    let all = hard_cases::compute_all(&hard, &AtomicBool::new(false), &|_, _| {});
    let of = |computed: &[Option<TrialRun>], over| TrialProgress {
        findings: hard_cases::verdicts(&hard, computed),
        done: computed.iter().flatten().count(),
        all: all.len(),
        over,
    };
    let some: Vec<_> = all
        .iter()
        .enumerate()
        .map(|(i, one)| one.clone().filter(|_| i < first))
        .collect();
    (of(&some, false), of(&all, true))
}

#[test]
fn trials_fill_their_table_row_by_row() {
    let mut desk = open(SMALL, "falling.toml", FALLING);
    desk.asked.clear();
    desk.keys("T");
    let Some(Effect::StartTrials { ticket, of }) = desk.asked.pop() else {
        panic!("{:?}", desk.asked);
    };
    let text = FALLING.to_owned();
    let file = "falling.toml".to_owned();
    assert_eq!(of, TrialsOf::Case { file, text });
    assert_eq!(desk.state.focus(), PaneId::Trials);
    let (some, all) = trialled(2);
    let rows = |desk: &Desk| desk.state.trials.as_ref().unwrap().progress.findings.len();
    desk.tell(Msg::TrialProgress(ticket, Box::new(some)));
    assert_eq!(rows(&desk), 2);
    snapshot("tui_trials_going_80x24", &desk);
    // They go on behind the screen, and are there when they are asked for again.
    desk.keys("esc");
    assert_eq!(desk.state.focus(), PaneId::Inputs);
    desk.tell(Msg::TrialProgress(ticket, Box::new(all.clone())));
    assert!(said(&desk).contains("OK"), "{}", said(&desk));
    desk.asked.clear();
    desk.keys("T");
    assert!(desk.asked.is_empty() && rows(&desk) == all.findings.len());
    desk.keys("x");
    assert!(said(&desk).contains("already"));
    // What an earlier job still says is dropped.
    desk.tell(Msg::TrialProgress(ticket + 7, Box::default()));
    assert_eq!(rows(&desk), all.findings.len());
}

#[test]
fn trials_of_the_whole_family_are_stopped_by_a_key() {
    let mut desk = Desk::new(LARGE);
    desk.keys("T");
    let Some(Effect::StartTrials { ticket, of }) = desk.asked.pop() else {
        panic!("{:?}", desk.asked);
    };
    assert!(matches!(of, TrialsOf::Files(files) if files.len() == 2));
    let (some, _) = trialled(3);
    desk.tell(Msg::TrialProgress(ticket, Box::new(some)));
    snapshot("tui_trials_200x60", &desk);
    desk.keys("x");
    assert!(matches!(desk.asked.pop(), Some(Effect::Cancel(t)) if t == ticket));
    assert!(desk.screen().contains("stopped at 3 of"));
    desk.keys("esc");
    assert_eq!(desk.state.focus(), PaneId::Cases);
}
