//! Keys that the user binds: footer, help and messages show them, and no keys break the screen.

use std::path::Path;
use std::sync::Arc;

use proptest::prelude::*;
use seacable::tui::Msg;
use seacable::tui::bindings::names::{name, pane_name};
use seacable::tui::bindings::{file, listing, registry};
use seacable::tui::key::KeyPress;
use seacable::tui::pane::PaneId;
use seacable::tui::settings::UserSettings;
use seacable::tui::state::{Overlay, Severity};

use super::desk::Desk;
use super::{SMALL, said};

/// The case open, with the keys of a file.
fn with_keys(text: &str) -> Desk {
    let mut desk = Desk::with_case(SMALL);
    let (keys, faults) = file::read(text, "keys.toml");
    assert!(faults.is_empty(), "{faults:#?}");
    desk.state.keys = Arc::new(keys);
    desk
}

#[test]
fn footer_help_palette_and_messages_show_the_keys_of_the_user() {
    let mut desk = with_keys("[keys]\nrun = \"f5\"\nundo = \"f7\"\n[inputs]\nstep_up = \"+\"\n");
    let screen = desk.screen();
    let foot = screen.lines().nth(23).unwrap();
    assert!(foot.contains("+ step") && foot.contains("f5 run"), "{foot}");
    desk.keys("?");
    assert!(desk.screen().contains(" f5 "), "{}", desk.screen());
    desk.keys("esc :");
    desk.type_text("run");
    assert!(desk.screen().contains("f5"), "{}", desk.screen());
    desk.keys("esc R");
    assert!(said(&desk).contains("`R` does nothing here"));
    desk.keys("f5");
    assert_eq!(desk.started().len(), 1);
    desk.keys("2 =");
    assert!(desk.state.note.is_none() || !said(&desk).contains("`:"));
}

#[test]
fn faults_of_the_file_are_shown_and_open_the_editor() {
    let mut desk = Desk::with_case(SMALL);
    let (keys, faults) = file::read("[keys]\nrnu = \"f5\"\nsave = \"f6\"\n", "keys.toml");
    desk.tell(Msg::SettingsRead(Box::new(UserSettings {
        keys,
        faults,
        ..UserSettings::default()
    })));
    assert_eq!(desk.state.note.as_ref().unwrap().level, Severity::Error);
    let Some(Overlay::Text { text, .. }) = &desk.state.overlay else {
        panic!("nothing is shown");
    };
    assert!(
        text.contains("rnu") && text.contains("write `run`"),
        "{text}"
    );
    // What is right is in force.
    desk.keys("esc M f6");
    assert!(
        desk.asked
            .iter()
            .any(|e| matches!(e, seacable::tui::Effect::SaveCase { .. }))
    );
}

#[test]
fn the_names_of_all_commands() {
    let lines = listing::commands(&seacable::tui::bindings::KeyTable::default());
    let lines = lines
        .iter()
        .map(|l| format!("{}.{} = {}\n", l.table, l.name, l.keys.joined()));
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("tui_commands", lines.collect::<String>()));
}

/// Messages name commands, so that they show the keys of the user: no source of the screen has a key in a text.
#[test]
fn no_message_names_a_key() {
    let mut keys: Vec<String> = registry::declared()
        .iter()
        .flat_map(|(_, command)| command.keys.iter().map(|key| format!("`{key}`")))
        .filter(|key| key != "`ctrl+c`" && key != "`ctrl+z`" && key != "`:`" && key != "`=`")
        .collect();
    keys.sort_unstable();
    keys.dedup();
    let mut found = Vec::new();
    look_into(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("src/tui"),
        &keys,
        &mut found,
    );
    assert!(
        found.is_empty(),
        "name the command instead, as in `:undo`:\n{}",
        found.join("\n")
    );
}

fn look_into(path: &Path, keys: &[String], found: &mut Vec<String>) {
    if path.is_dir() {
        for item in std::fs::read_dir(path).unwrap() {
            look_into(&item.unwrap().path(), keys, found);
        }
        return;
    }
    if path.ends_with("key.rs") || path.to_string_lossy().contains("bindings") {
        return;
    }
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    for (number, line) in (1..).zip(text.lines()) {
        let code = line.trim_start();
        // `+` and `u` in comments are of no concern; `+` behind a range is typed, not bound.
        if !code.starts_with("//") && keys.iter().any(|key| code.contains(key.as_str())) {
            found.push(format!("{}:{number}: {code}", path.display()));
        }
    }
}

/// A file of keys with any commands and any keys.
fn any_file() -> impl Strategy<Value = String> {
    let commands: Vec<String> = registry::declared()
        .iter()
        .map(|(_, c)| name(c.id))
        .collect();
    let mut tables: Vec<String> = PaneId::ALL.into_iter().map(pane_name).collect();
    tables.push("keys".to_owned());
    let key = prop_oneof![
        "[a-zA-Z0-9+=/?:-]",
        prop::sample::select(vec![
            "enter", "f5", "ctrl+x", "space", "tab", "esc", "nonsense"
        ])
        .prop_map(str::to_owned),
    ];
    let line = (
        prop::sample::select(tables),
        prop::sample::select(commands),
        prop::collection::vec(key, 0..3),
    );
    prop::collection::vec(line, 0..12).prop_map(|lines| {
        let mut text = String::new();
        let mut lines = lines;
        lines.sort();
        let mut table = String::new();
        for (of, command, keys) in lines {
            if of != table {
                text.push_str(&format!("[{of}]\n"));
                table = of;
            }
            text.push_str(&format!("{command} = {keys:?}\n"));
        }
        text
    })
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 24,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn no_file_of_keys_and_no_keys_break_the_screen(
        text in any_file(),
        keys in "[a-zA-Z0-9+=/?:-]{0,40}",
    ) {
        let mut desk = Desk::opening(SMALL);
        let (table, faults) = file::read(&text, "keys.toml");
        for fault in &faults {
            prop_assert!(fault.line > 0, "{fault}");
        }
        // In every pane a key does one thing.
        for pane in PaneId::ALL {
            let mut seen = std::collections::HashMap::new();
            for command in registry::together(pane) {
                let bound = table.keys_of(pane, &command);
                for key in bound.iter() {
                    let other = seen.insert(key.to_owned(), command);
                    let declared = other.is_some_and(|other| {
                        other.keys.contains(&key) && command.keys.contains(&key)
                    });
                    prop_assert!(other.is_none() || declared, "{pane:?}: {key} in\n{text}");
                }
            }
        }
        desk.state.keys = Arc::new(table);
        for c in keys.chars() {
            desk.tell(Msg::Key(KeyPress::Char(c)));
        }
        desk.buffer();
        desk.keys("esc ?");
        desk.buffer();
    }
}
