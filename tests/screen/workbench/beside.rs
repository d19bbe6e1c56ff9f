//! A case that names a file beside it, opened from another folder.

use std::path::Path;

use seacable::case;
use seacable::tui::Msg;
use seacable::tui::msg::FileRead;

use super::desk::{CASE, Desk, content_of};
use super::{SMALL, said};

/// The body's vessel swings by a table.
fn write(folder: &Path) -> FileRead {
    let table = "time_s,x_m,y_m,z_m\n0,0,0,0\n10,1,0,0\n600,0,0,0\n";
    std::fs::write(folder.join("swing.csv"), table).unwrap();
    let moving = "kind = \"moving\"\nmotion = \"table\"\nmotion_file = \"swing.csv\"";
    let path = folder.join("body.toml");
    std::fs::write(&path, CASE.replacen("kind = \"fixed\"", moving, 1)).unwrap();
    let loaded = case::load(&path).unwrap();
    FileRead::new(path, loaded.text, content_of(loaded.case), None)
}

#[test]
fn the_files_a_case_names_are_found_from_another_folder() {
    let folder = tempfile::tempdir().unwrap();
    let mut desk = Desk::new(SMALL);
    desk.tell(Msg::FileRead(Box::new(write(folder.path()))));
    desk.started();
    // An edit is taken and computed.
    desk.keys("/");
    desk.type_text("current speed");
    desk.keys("enter enter ctrl+u");
    desk.type_text("0.8");
    desk.keys("enter");
    assert!(!said(&desk).contains("cannot be read"), "{}", said(&desk));
    let started = desk.started();
    assert!(!started.is_empty(), "{}", said(&desk));
    assert!(
        started
            .iter()
            .all(|(_, r)| r.case.files.contains_key("swing.csv"))
    );
    // So are the points of a study.
    desk.keys("S");
    assert!(!said(&desk).contains("cannot be read"), "{}", said(&desk));
}
