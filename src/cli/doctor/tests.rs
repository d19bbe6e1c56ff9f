//! What is found in surroundings made for it.

use std::path::PathBuf;

use super::*;

fn around<'a>(
    var: &'a dyn Fn(&str) -> Option<String>,
    size: Option<(u16, u16)>,
) -> Surroundings<'a> {
    Surroundings {
        var,
        size,
        directory: PathBuf::from("."),
    }
}

fn of(pairs: &[(&str, &str)], name: &str) -> DoctorFinding {
    let var = |wanted: &str| {
        let found = pairs.iter().find(|(name, _)| *name == wanted);
        found.map(|(_, value)| (*value).to_owned())
    };
    let found = terminal::findings(&around(&var, Some((80, 24))));
    let found = found.into_iter().find(|finding| finding.name == name);
    found.unwrap_or_else(|| panic!("nothing is said of {name}"))
}

#[test]
fn the_locale_says_which_characters_are_drawn() {
    assert!(
        of(&[("LANG", "C")], "characters")
            .value
            .starts_with("ASCII: LANG")
    );
    let utf8 = [("LC_ALL", "en_US.UTF-8"), ("LANG", "C"), ("TERM", "xterm")];
    assert!(of(&utf8, "characters").value.starts_with("braille: LC_ALL"));
    let none = of(&[], "locale");
    assert_eq!(none.health, Health::Note);
    assert!(!none.remedy.is_empty());
}

#[test]
fn a_small_terminal_is_a_problem_and_none_is_not() {
    let none = |_: &str| None;
    let size = |size| {
        let found = terminal::findings(&around(&none, size));
        found[0].health
    };
    assert_eq!(size(Some((30, 8))), Health::Problem);
    assert_eq!(size(Some((60, 20))), Health::Note);
    assert_eq!(size(Some((80, 24))), Health::Fine);
    assert_eq!(size(None), Health::Note);
}

#[test]
fn screen_is_told_that_it_passes_no_copies_on() {
    let screen = of(&[("STY", "1.pts")], "multiplexer");
    assert!(screen.remedy.contains("clipboard"));
}

#[test]
fn an_editor_that_is_not_there_is_said() {
    let found = of(
        &[("EDITOR", "no-such-editor -w"), ("PATH", "/bin")],
        "editor",
    );
    assert_eq!(found.health, Health::Note);
    let found = of(&[("EDITOR", "sh"), ("PATH", "/bin:/usr/bin")], "editor");
    assert_eq!(found.health, Health::Fine);
}

#[test]
fn a_problem_is_told_from_what_is_only_worth_knowing() {
    let fine = DoctorFinding::fine("a", "b", "c");
    assert!(!has_problems(&[fine.clone(), fine.clone().note("d")]));
    let found = [fine.clone(), fine.problem("mend it")];
    assert!(has_problems(&found));
    let page = page(&found);
    assert!(page.contains("PROBLEM") && page.contains("mend it") && page.ends_with("1 problem.\n"));
}
