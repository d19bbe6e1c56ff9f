//! Text from outside on the screen: invisible characters are shown as escapes, on every pane.

use std::path::PathBuf;

use seacable::case;
use seacable::tui::Msg;
use seacable::tui::msg::FileRead;
use seacable::tui::state::CaseEntry;
use seacable::visible::is_invisible;

use super::LARGE;
use super::desk::{CASE, Desk, content_of};

/// A name that steers a terminal (C0, C1), reorders its neighbours and hides.
const HOSTILE: &str = "a\u{1b}[31m\u{9b}2J\u{202e}b\u{200b}c";

/// What is seen of it.
const SEEN: &str = "a\\u{1b}[31m\\u{9b}2J\\u{202e}b\\u{200b}c";

/// The case with a hostile title and path, open.
fn hostile() -> Desk {
    let mut desk = Desk::new(LARGE);
    let title: String = HOSTILE
        .chars()
        .map(|c| format!("\\U{:08X}", u32::from(c)))
        .collect();
    let at = CASE.find("title = \"").unwrap() + "title = \"".len();
    let end = at + CASE[at..].find('"').unwrap();
    let text = format!("{}{title}{}", &CASE[..at], &CASE[end..]);
    let path = PathBuf::from(format!("cases/{HOSTILE}.toml"));
    desk.tell(Msg::CasesRead(
        PathBuf::from(HOSTILE),
        vec![
            CaseEntry {
                path: path.clone(),
                name: HOSTILE.to_owned(),
                about: Ok((HOSTILE.to_owned(), HOSTILE.to_owned())),
            },
            CaseEntry {
                path: path.clone(),
                name: HOSTILE.to_owned(),
                about: Err((HOSTILE.to_owned(), HOSTILE.to_owned())),
            },
        ],
    ));
    check(&desk, "the list");
    assert!(desk.screen().contains(SEEN), "{}", desk.screen());
    let case = case::parse(&text, HOSTILE).unwrap();
    desk.tell(Msg::FileRead(Box::new(FileRead::new(
        path,
        text,
        content_of(case),
        None,
    ))));
    desk.finish_jobs();
    desk
}

fn check(desk: &Desk, what: &str) {
    let buffer = desk.buffer();
    let symbols = buffer.content.iter().map(ratatui::buffer::Cell::symbol);
    let raw: Vec<&str> = symbols.filter(|s| s.contains(is_invisible)).collect();
    assert!(raw.is_empty(), "{raw:?} in {what}");
}

#[test]
fn no_pane_shows_raw_invisible_characters() {
    let mut desk = hostile();
    assert!(desk.screen().contains(SEEN), "{}", desk.screen());
    for keys in [
        "1", "2", "3", "4", "5", "6", "7", "8", "?", "esc", ":", "esc",
    ] {
        desk.keys(keys);
        check(&desk, keys);
    }
    desk.keys("5");
    assert!(desk.screen().contains("\\u{202e}"), "{}", desk.screen());
}
