//! Every key that the footer offers does something that is seen, in all panes of every kind of file.

use seacable::tui::state::Severity;
use seacable::tui::view::offered;
use seacable::tui::{Msg, update};

use super::desk::Desk;
use super::{LARGE, SMALL};

/// Presses every key offered, each on a state of its own.
fn press_all(name: &str, desk: &Desk, idle: &mut Vec<String>) {
    let before = desk.screen();
    for command in offered(&desk.state) {
        let mut copy = Desk {
            state: desk.state.clone(),
            asked: Vec::new(),
            checks_at_once: true,
            opens_new_files: false,
            parts_at_once: true,
        };
        let key = command.keys.first().unwrap().parse().unwrap();
        copy.asked = update(&mut copy.state, Msg::Key(key));
        let pane = desk.state.focus();
        let refused = copy.state.note.as_ref().is_some_and(|note| {
            note.level == Severity::Error || note.text.starts_with("There is no")
        });
        let seen = copy.screen() != before || !copy.asked.is_empty();
        if !seen || refused {
            let (columns, _) = desk.state.size;
            idle.push(format!(
                "{name}, {columns} columns, {pane:?}: `{key}` {}",
                command.doc
            ));
        }
    }
}

fn each_pane(name: &str, desk: &mut Desk, idle: &mut Vec<String>) {
    let panes = desk.state.panes().len();
    for number in 1..=panes {
        desk.keys(&number.to_string());
        press_all(name, desk, idle);
    }
}

#[test]
fn what_the_footer_offers_does_something() {
    let mut idle = Vec::new();
    for size in [SMALL, LARGE] {
        press_all("the list", &Desk::new(size), &mut idle);
        each_pane("a case as opened", &mut Desk::opening(size), &mut idle);
        each_pane("a case", &mut Desk::with_case(size), &mut idle);
        let mut desk = Desk::with_case(size);
        desk.keys("R");
        desk.finish_jobs();
        each_pane("a case with a run", &mut desk, &mut idle);
        desk.keys("1 j j M");
        desk.finish_jobs();
        each_pane("an edited case", &mut desk, &mut idle);
        desk.keys("1 enter ctrl+u");
        desk.type_text("1..2/2");
        desk.keys("+");
        assert!(!desk.state.editor().unwrap().kept.is_empty());
        each_pane("a case with a range kept", &mut desk, &mut idle);
        each_pane("a section", &mut Desk::with_section(size), &mut idle);
        each_pane("a ropeway", &mut Desk::with_ropeway(size), &mut idle);
        each_pane("a ship", &mut Desk::with_ship(size), &mut idle);
        each_pane("a system", &mut Desk::with_system(size), &mut idle);
    }
    assert!(idle.is_empty(), "{idle:#?}");
}
