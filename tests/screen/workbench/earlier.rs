//! What the screen showed is kept, and shown again by the next session.

use std::path::PathBuf;

use seacable::case;
use seacable::tui::Msg;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::screen_memory::ScreenMemory;
use seacable::tui::screen_memory::file::Remembered;
use seacable::tui::update::earlier;

use super::desk::{CASE, Desk, content_of};
use super::{SMALL, said};

/// The case opened by a session that finds this memory.
fn next_session(memory: &ScreenMemory) -> Desk {
    let mut desk = Desk::new(SMALL);
    let mut remembered = Remembered {
        screen: Some(memory.clone()),
        ..Remembered::default()
    };
    earlier::begin(&mut desk.state, &mut remembered, true);
    // The file is not there in the tests; it is read all the same.
    desk.state.earlier = Some(Box::new(memory.clone()));
    desk.tell(Msg::FileRead(Box::new(FileRead::new(
        PathBuf::from("cases/body.toml"),
        CASE.to_owned(),
        content_of(case::parse(CASE, "body.toml").unwrap()),
        None,
    ))));
    desk.finish_jobs();
    desk
}

#[test]
fn the_next_session_shows_what_the_last_one_did() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("R");
    desk.finish_jobs();
    desk.keys("1 x /");
    desk.type_text("current");
    desk.keys("enter j 2 ] + 7 l l o - 3 /");
    desk.type_text("body");
    desk.keys("enter l -");
    let memory = ScreenMemory::of_state(&desk.state);
    let text = toml::to_string(&memory).unwrap();
    assert!(
        text.contains("pane = \"runs\"") && text.contains("input_filter = \"current\""),
        "{text}"
    );
    let read: ScreenMemory = toml::from_str(&text).unwrap();
    assert_eq!(read, memory);
    let next = next_session(&read);
    assert_eq!(next.state.focus(), PaneId::Runs);
    assert_eq!(ScreenMemory::of_state(&next.state), memory);
}

#[test]
fn a_memory_of_another_file_or_of_nonsense_changes_nothing() {
    let desk = Desk::with_case(SMALL);
    let before = ScreenMemory::of_state(&desk.state);
    let other = ScreenMemory {
        case: Some(PathBuf::from("/elsewhere/other.toml")),
        pane: "jobs".to_owned(),
        ..ScreenMemory::default()
    };
    assert_eq!(ScreenMemory::of_state(&next_session(&other).state), before);
    let odd = "pane = \"no such pane\"\ntab = 99\n[charts]\nchart = \"none\"\nx = [nan, inf]\n[[tables]]\ntable = \"nodes\"\nsort = \"no such column\"\n";
    let odd: ScreenMemory = toml::from_str(odd).unwrap();
    let odd = ScreenMemory {
        case: before.case.clone(),
        ..odd
    };
    let mut desk = next_session(&odd);
    desk.keys("7");
    desk.buffer();
}

#[test]
fn the_tutorial_is_offered_once_and_damage_is_said() {
    let mut desk = Desk::new(SMALL);
    earlier::begin(&mut desk.state, &mut Remembered::default(), true);
    assert!(
        said(&desk).contains("`ctrl+t` begins a tutorial"),
        "{}",
        said(&desk)
    );
    let mut desk = Desk::new(SMALL);
    let mut damaged = Remembered {
        faults: vec!["session.toml is damaged and is not used: why".to_owned()],
        ..Remembered::default()
    };
    earlier::begin(&mut desk.state, &mut damaged, true);
    assert!(said(&desk).contains("damaged"));
}
