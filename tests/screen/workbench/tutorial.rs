//! The tutorial, from the list of cases to a written report.

use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{SMALL, snapshot};

/// The title in the strip.
fn step(desk: &Desk) -> &'static str {
    desk.state
        .tutorial
        .as_ref()
        .map_or("none", |now| now.shown().title)
}

#[test]
fn a_newcomer_is_led_from_the_list_to_a_report() {
    let mut desk = Desk::new(SMALL);
    desk.keys("ctrl+t");
    snapshot("tui_tutorial_80x24", &desk);
    assert_eq!(step(&desk), "Open a case");
    let open = Desk::opening(SMALL);
    desk.state.document = open.state.document;
    desk.asked = open.asked;
    desk.state.jobs = open.state.jobs;
    desk.finish_jobs();
    assert_eq!(step(&desk), "Results and their errors");
    desk.keys("9");
    assert_eq!(step(&desk), "Change a value");
    desk.keys("1 /");
    desk.type_text("current speed");
    desk.keys("enter right");
    desk.finish_jobs();
    assert_eq!(step(&desk), "Hold results, and see differences");
    desk.keys("v right");
    desk.finish_jobs();
    assert_eq!(step(&desk), "Published values");
    snapshot("tui_tutorial_held_80x24", &desk);
    desk.keys("4");
    assert_eq!(step(&desk), "Undo");
    desk.keys("u u");
    desk.finish_jobs();
    assert_eq!(step(&desk), "Run and store");
    desk.keys("R");
    desk.finish_jobs();
    assert_eq!(step(&desk), "A second run");
    desk.keys("1 right R");
    desk.finish_jobs();
    assert_eq!(step(&desk), "Compare two runs");
    desk.keys("3 g j m m =");
    assert!(
        desk.asked
            .iter()
            .any(|e| matches!(e, Effect::Compare { .. }))
    );
    desk.tell(Msg::Page(
        "comparison".to_owned(),
        Ok("the page\n".to_owned()),
        false,
    ));
    assert_eq!(step(&desk), "Write a report");
    desk.keys("esc 5 w");
    let written = desk
        .asked
        .iter()
        .any(|e| matches!(e, Effect::WriteText { .. }));
    assert!(written);
    desk.tell(Msg::Say(
        seacable::tui::state::Severity::Info,
        "The report is in runs/body-1/report.txt.".to_owned(),
    ));
    assert_eq!(step(&desk), "That is all");
    desk.keys("ctrl+t");
    assert_eq!((step(&desk), desk.state.tutorial_left), ("none", None));
}

#[test]
fn steps_are_skipped_and_the_tutorial_goes_on_where_it_was_left() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("ctrl+n");
    assert!(
        super::said(&desk).contains("`ctrl+t` begins it"),
        "{}",
        super::said(&desk)
    );
    desk.keys("ctrl+t");
    // A case is open already.
    assert_eq!(step(&desk), "Results and their errors");
    desk.keys("ctrl+n ctrl+n");
    assert_eq!(step(&desk), "Hold results, and see differences");
    desk.keys("ctrl+t");
    assert_eq!(step(&desk), "none");
    desk.keys("ctrl+t");
    assert_eq!(step(&desk), "Hold results, and see differences");
    for _ in 0..20 {
        desk.keys("ctrl+n");
    }
    assert_eq!(step(&desk), "none");
}

#[test]
fn the_words_name_the_keys_of_the_user_and_the_strip_leaves_small_screens_alone() {
    let mut desk = Desk::new(SMALL);
    let (keys, _) = seacable::tui::bindings::file::read("[cases]\nopen = \"f9\"\n", "keys.toml");
    desk.state.keys = std::sync::Arc::new(keys);
    desk.keys("ctrl+t");
    assert!(
        desk.screen().contains("open it with `f9`"),
        "{}",
        desk.screen()
    );
    desk.state.size = (40, 10);
    assert!(!desk.screen().contains("Tutorial"), "{}", desk.screen());
    desk.state.size = (40, 13);
    assert!(desk.screen().contains("Tutorial"), "{}", desk.screen());
}
