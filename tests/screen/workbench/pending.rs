//! Edits that are being checked: what is shown meanwhile, and which keys wait.

use seacable::tui::state::edit_check::EditCheck;
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{SMALL, said};

const SPEED: &str = "current.speed_m_per_s";

/// The case open at the current speed, edits checked when they are asked to be.
fn desk() -> Desk {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("/");
    desk.type_text("current speed");
    desk.keys("enter");
    desk.checks_at_once = false;
    desk
}

/// The check that is under way.
fn check(desk: &mut Desk) -> Option<EditCheck> {
    let at = desk
        .asked
        .iter()
        .position(|effect| matches!(effect, Effect::CheckEdits(_)))?;
    match desk.asked.remove(at) {
        Effect::CheckEdits(check) => Some(*check),
        _ => None,
    }
}

/// Answers the check that is under way.
fn answer(desk: &mut Desk) {
    let check = check(desk).unwrap();
    desk.tell(Msg::EditsChecked(Box::new(check.answer())));
}

fn value(desk: &Desk) -> String {
    let rows = &desk.state.editor().unwrap().rows;
    let row = rows.iter().find(|row| row.path == SPEED).unwrap();
    row.value.clone()
}

#[test]
fn no_step_is_lost_while_a_check_is_under_way() {
    let mut desk = desk();
    desk.keys("right right right");
    assert_eq!(value(&desk), "0.3");
    let screen = desk.screen();
    assert!(
        screen.contains("0.33") && screen.contains("checking"),
        "{screen}"
    );
    assert!(screen.contains("older than the inputs"), "{screen}");
    answer(&mut desk);
    assert_eq!(value(&desk), "0.31");
    assert!(desk.screen().contains("0.33"), "{}", desk.screen());
    desk.keys("right");
    // Those asked for during a check are checked together.
    answer(&mut desk);
    assert_eq!(value(&desk), "0.33");
    answer(&mut desk);
    assert_eq!(value(&desk), "0.34");
    assert!(check(&mut desk).is_none());
    assert_eq!(desk.state.editor().unwrap().undo.len(), 4);
}

#[test]
fn a_key_meant_for_the_edited_text_waits_for_it() {
    let mut desk = desk();
    desk.keys("right s j");
    let saves = |desk: &Desk| {
        let mut saved = desk.asked.iter();
        saved.find_map(|effect| match effect {
            Effect::SaveCase { text, .. } => Some(text.clone()),
            _ => None,
        })
    };
    assert!(saves(&desk).is_none());
    answer(&mut desk);
    let text = saves(&desk).unwrap();
    assert!(text.contains("speed_m_per_s = 0.31"), "{text}");
    assert!(desk.state.held.is_empty());
}

#[test]
fn a_typed_value_stays_open_until_it_is_accepted() {
    let mut desk = desk();
    desk.keys("enter ctrl+u");
    desk.type_text("99");
    desk.keys("enter ctrl+u");
    assert!(desk.screen().contains("is checked with this value"));
    answer(&mut desk);
    // The key that was typed behind it goes to the field that is still open.
    let editing = desk.state.editor().unwrap().editing.clone().unwrap();
    assert_eq!(editing.input.value(), "");
    desk.type_text("0.5");
    desk.keys("enter right");
    answer(&mut desk);
    assert!(desk.state.editor().unwrap().editing.is_none());
    answer(&mut desk);
    assert_eq!(value(&desk), "0.51");
}

#[test]
fn steps_beyond_the_range_stop_at_its_end() {
    let mut desk = desk();
    desk.keys("right L L L L L L L L L L");
    answer(&mut desk);
    answer(&mut desk);
    let stepped: f64 = value(&desk).parse().unwrap();
    assert!(stepped > 1.0, "{stepped}");
    assert!(check(&mut desk).is_none());
}

#[test]
fn a_second_interrupt_drops_what_is_being_checked() {
    let mut desk = desk();
    desk.keys("right s ctrl+c");
    let late = check(&mut desk).unwrap();
    desk.keys("ctrl+c");
    assert!(said(&desk).contains("is dropped"), "{}", said(&desk));
    assert!(desk.state.held.is_empty());
    desk.tell(Msg::EditsChecked(Box::new(late.answer())));
    assert_eq!(value(&desk), "0.3");
}
