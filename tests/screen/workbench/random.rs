//! Any keys at any size: the screen never breaks.

use proptest::prelude::*;
use seacable::chart::Glyphs;
use seacable::tui::Msg;
use seacable::tui::key::KeyPress;

use super::desk::{Desk, looks};

fn any_msg() -> impl Strategy<Value = Msg> {
    let letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 []{}+-=?:/.,";
    let letters: Vec<KeyPress> = letters.chars().map(KeyPress::Char).collect();
    let named: Vec<KeyPress> = [
        "enter",
        "esc",
        "tab",
        "shift+tab",
        "backspace",
        "del",
        "up",
        "down",
        "left",
        "right",
        "home",
        "end",
        "pgup",
        "pgdn",
        "ctrl+c",
        "ctrl+r",
        "ctrl+u",
        "ctrl+d",
        "ctrl+l",
        "ctrl+z",
    ]
    .iter()
    .map(|name| name.parse().unwrap())
    .collect();
    prop_oneof![
        4 => prop::sample::select(letters).prop_map(Msg::Key),
        4 => prop::sample::select(named).prop_map(Msg::Key),
        1 => (0..260_u16, 0..90_u16).prop_map(|(w, h)| Msg::Resize(w, h)),
        1 => "[ -~é日\n\u{1b}]{0,12}".prop_map(Msg::Paste),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 48,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn no_size_and_no_keys_break_the_screen(
        messages in prop::collection::vec(any_msg(), 0..60),
        size in (0..260_u16, 0..90_u16),
        answered in any::<bool>(),
        ascii in any::<bool>(),
        of_section in any::<bool>(),
    ) {
        let mut desk = if of_section {
            Desk::with_section(size)
        } else {
            Desk::opening(size)
        };
        if ascii {
            desk.state.capabilities = looks(Glyphs::Ascii, false);
        }
        for (i, message) in messages.into_iter().enumerate() {
            desk.tell(message);
            if answered && i % 7 == 3 {
                desk.finish_jobs();
            }
            if i % 5 == 0 {
                desk.buffer();
            }
        }
        desk.buffer();
    }
}
