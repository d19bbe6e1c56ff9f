//! The manifests: every crate below `src` is built, tested and linted with the program, and stands on lower floors alone.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use toml::{Table, Value};

use super::floors::FLOORS;

fn manifest(folder: &str) -> Table {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(root.join(folder).join("Cargo.toml")).unwrap();
    text.parse().unwrap()
}

fn listed(workspace: &Value, key: &str) -> BTreeSet<String> {
    let list = workspace[key].as_array().unwrap();
    let words = list.iter().map(|word| word.as_str().unwrap().to_owned());
    words.collect()
}

#[test]
fn cargo_test_leaves_no_floor_out() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = fs::read_dir(root.join("src")).unwrap();
    let folders = folders.map(|folder| folder.unwrap().path());
    let floors = folders.filter(|folder| folder.join("Cargo.toml").exists());
    let floors: BTreeSet<String> = floors
        .map(|folder| format!("src/{}", folder.file_name().unwrap().to_str().unwrap()))
        .collect();
    let known = FLOORS.map(|floor| format!("src/{floor}"));
    assert_eq!(floors, BTreeSet::from(known));
    let workspace = &manifest("")["workspace"];
    assert_eq!(listed(workspace, "members"), floors);
    let mut tested = listed(workspace, "default-members");
    assert!(tested.remove("."), "the program itself");
    assert_eq!(tested, floors);
}

#[test]
fn lints_and_version_are_those_of_the_workspace() {
    for floor in FLOORS {
        let manifest = manifest(&format!("src/{floor}"));
        assert_eq!(
            manifest["lints"]["workspace"].as_bool(),
            Some(true),
            "{floor}"
        );
        for key in ["version", "edition", "rust-version", "license", "publish"] {
            let shared = manifest["package"][key]["workspace"].as_bool();
            assert_eq!(shared, Some(true), "{floor}: {key}");
        }
    }
}

#[test]
fn floors_stand_on_lower_floors() {
    let height = |name: &str| FLOORS.iter().position(|floor| *floor == name).unwrap();
    for floor in FLOORS {
        let manifest = manifest(&format!("src/{floor}"));
        for kind in ["dependencies", "dev-dependencies"] {
            let Some(needed) = manifest.get(kind).and_then(Value::as_table) else {
                continue;
            };
            for below in needed
                .keys()
                .filter_map(|name| name.strip_prefix("seacable-"))
            {
                assert!(height(below) < height(floor), "{floor} stands on {below}");
            }
        }
    }
}
