//! Edits of the structure of every shipped file.

use seacable::case::TomlNode;
use seacable::case::fields::value_text;
use seacable::case::fields::{Schema, TableShape, join, split};
use seacable::case::file_kind::FileKind;
use seacable::case::kind;
use seacable::case::shipped::BY_KIND;
use seacable::case::structure::{OutlineRow, StructureEdit, apply, free_name, outline, table_of};
use seacable::case::tree::TomlData;
use seacable::case::{CASE, Case};
use seacable::kinds::FileType;
use seacable::ropeway::Ropeway;
use seacable::section::CrossSection;
use seacable::ship::Ship;
use seacable::system::SystemFile;

fn schema(kind: FileType) -> &'static Schema {
    match kind {
        FileType::Line => Case::schema(),
        FileType::Section => CrossSection::schema(),
        FileType::Ropeway => Ropeway::schema(),
        FileType::Ship => Ship::schema(),
        FileType::System => SystemFile::schema(),
    }
}

/// The shipped files with their schemas and names.
fn files() -> impl Iterator<Item = (&'static str, &'static Schema, &'static str)> {
    let all = BY_KIND.iter().flat_map(|(_, files)| *files);
    all.map(|(path, text)| (*path, schema(FileType::of_text(text)), *text))
        .filter(|(_, _, text)| TomlNode::parse(text).is_ok())
}

/// What a text says, without places.
fn said(text: &str) -> String {
    fn words(node: &TomlNode, out: &mut String) {
        match &node.data {
            TomlData::Table(_, entries) => {
                let mut entries: Vec<_> = entries.iter().collect();
                entries.sort_by_key(|entry| entry.key.clone());
                out.push('{');
                for entry in entries {
                    out.push_str(&entry.key);
                    out.push('=');
                    words(&entry.node, out);
                }
                out.push('}');
            }
            TomlData::List(items) => {
                out.push('[');
                items.iter().for_each(|item| words(item, out));
                out.push(']');
            }
            data => out.push_str(&format!("{data:?};")),
        }
    }
    let mut out = String::new();
    words(&TomlNode::parse(text).unwrap(), &mut out);
    out
}

/// Of very many tables some, spread evenly.
fn sample(rows: &[OutlineRow]) -> impl Iterator<Item = &OutlineRow> {
    rows.iter().step_by(1 + rows.len() / 16)
}

fn several(schema: &'static Schema, text: &str) -> Vec<OutlineRow> {
    let rows = outline(schema, text);
    rows.into_iter()
        .filter(|row| !row.is_heading)
        .filter(|row| table_of(schema, &split(&row.path).unwrap()).unwrap().1)
        .collect()
}

#[test]
fn every_table_can_be_removed_and_what_is_left_is_as_it_was() {
    let mut removed = 0;
    for (name, schema, text) in files() {
        let rows = outline(schema, text);
        for row in sample(&rows).filter(|row| !row.is_heading) {
            let edit = StructureEdit::Remove {
                path: row.path.clone(),
            };
            let Ok(edited) = apply(schema, text, &edit) else {
                continue;
            };
            removed += 1;
            let lines = |text: &str| -> Vec<String> { text.lines().map(str::to_owned).collect() };
            let (before, after) = (lines(text), lines(&edited));
            let mut left = before.iter();
            assert!(
                after.iter().all(|line| left.any(|other| other == line)),
                "{name}: {}",
                row.path
            );
            let tree =
                TomlNode::parse(&edited).unwrap_or_else(|e| panic!("{name} {}: {e}", row.path));
            let count = |tree: &TomlNode| {
                let path = split(&row.path).unwrap();
                let parent = &path[..path.len() - 1];
                tree.find(parent)
                    .map_or(0, |node| node.items().len().max(node.entries().len()))
            };
            assert!(
                count(&tree) < count(&TomlNode::parse(text).unwrap()),
                "{name}: {}",
                row.path
            );
        }
    }
    assert!(removed > 300, "{removed}");
}

#[test]
fn moved_down_and_up_again_is_the_same_text() {
    let mut moved = 0;
    for (name, schema, text) in files() {
        for row in sample(&several(schema, text)) {
            let shift = |text: &str, path: &str, down| {
                let edit = StructureEdit::Move {
                    path: path.to_owned(),
                    down,
                };
                apply(schema, text, &edit)
            };
            let Ok(down) = shift(text, &row.path, true) else {
                continue;
            };
            moved += 1;
            // Elements without a name are known by their number, which is another one then.
            let mut path = split(&row.path).unwrap();
            let last = path.last_mut().unwrap();
            if let Ok(number) = last.parse::<usize>() {
                *last = (number + 1).to_string();
            }
            let up = shift(&down, &join(&path), false);
            let up = up.unwrap_or_else(|e| panic!("{name} {}: {e}", row.path));
            assert_eq!(up, text, "{name}: {}", row.path);
        }
    }
    assert!(moved > 100, "{moved}");
}

#[test]
fn copies_are_removed_without_a_trace_and_names_change_back() {
    let (mut copied, mut renamed) = (0, 0);
    for (name, schema, text) in files() {
        for row in sample(&several(schema, text)) {
            let path = split(&row.path).unwrap();
            let (last, parent) = path.split_last().unwrap();
            let has_name = TomlNode::parse(text)
                .unwrap()
                .find(&path)
                .unwrap()
                .get("name")
                .is_some()
                || table_of(schema, &path).unwrap().0.shape == TableShape::ByName;
            if !has_name {
                continue;
            }
            let to = free_name(text, parent, &format!("{last}-x"));
            let other = join(&[parent, std::slice::from_ref(&to)].concat());
            let edit = StructureEdit::Copy {
                path: row.path.clone(),
                name: Some(to.clone()),
            };
            if let Ok(with_copy) = apply(schema, text, &edit) {
                copied += 1;
                let edit = StructureEdit::Remove {
                    path: other.clone(),
                };
                let again = apply(schema, &with_copy, &edit).unwrap();
                assert_eq!(said(&again), said(text), "{name}: {}", row.path);
            }
            let edit = StructureEdit::Rename {
                path: row.path.clone(),
                to: to.clone(),
            };
            if let Ok(with_name) = apply(schema, text, &edit) {
                renamed += 1;
                let back = StructureEdit::Rename {
                    path: other,
                    to: last.clone(),
                };
                let again = apply(schema, &with_name, &back).unwrap();
                assert_eq!(said(&again), said(text), "{name}: {}", row.path);
            }
        }
    }
    assert!(copied > 100 && renamed > 100, "{copied} {renamed}");
}

/// Every table of a file added to an empty text, one after the other, with its keys: what comes out says the same.
#[test]
fn every_shipped_file_is_built_from_nothing() {
    let mut built = 0;
    for (name, schema, text) in files() {
        let tree = TomlNode::parse(text).unwrap();
        let mut out = String::new();
        for row in outline(schema, text).iter().filter(|row| !row.is_heading) {
            let path = split(&row.path).unwrap();
            let node = tree.find(&path).unwrap();
            let (declared, named) = table_of(schema, &path).unwrap();
            let table = if named {
                &path[..path.len() - 1]
            } else {
                &path[..]
            };
            let by_name = declared.shape == TableShape::ByName;
            let own = node.entries().iter().filter(|entry| {
                !entry.node.is_table()
                    && (entry.node.items().is_empty() || !entry.node.is_list_of_tables())
            });
            let quoted = |node: &TomlNode| match node.text() {
                Some(text) => toml_edit::Value::from(text).to_string(),
                None => value_text(text, node),
            };
            let values = own
                .map(|entry| (entry.key.clone(), quoted(&entry.node)))
                .collect();
            let unquoted = |values: Vec<(String, String)>| -> Vec<(String, String)> {
                values
                    .into_iter()
                    .map(|(key, value)| {
                        match (key.as_str(), node.get(&key).and_then(TomlNode::text)) {
                            ("name", Some(text)) => (key, text.to_owned()),
                            _ => (key, value),
                        }
                    })
                    .collect()
            };
            let edit = StructureEdit::Add {
                table: join(table),
                name: (named && by_name).then(|| path.last().unwrap().clone()),
                values: unquoted(values),
            };
            out = apply(schema, &out, &edit).unwrap_or_else(|e| panic!("{name} {}: {e}", row.path));
        }
        if tree.get("files").is_none() {
            assert_eq!(said(&out), said(text), "{name}\n{out}");
            built += 1;
        }
    }
    assert!(built > 60, "{built}");
}

const SPREAD: &str = include_str!("../../../cases/systems/bridle_and_buoy.toml");
const HANGING: &str = include_str!("../../../cases/basics/hanging_line.toml");

#[test]
fn a_new_name_is_taken_wherever_the_old_one_was_used() {
    let text = include_str!("../../../cases/systems/spread_mooring.toml");
    let schema = SystemFile::schema();
    let rename = |text: &str, path: &str, to: &str| {
        let edit = StructureEdit::Rename {
            path: path.to_owned(),
            to: to.to_owned(),
        };
        apply(schema, text, &edit).unwrap()
    };
    let edited = rename(text, "bodies.platform", "semi");
    assert!(edited.contains("[bodies.semi]") && edited.contains("body = \"semi\""));
    assert!(edited.contains("of = [\"semi\"]") && !edited.contains("\"platform\""));
    let edited = rename(text, "materials.chain", "stud-chain");
    assert!(edited.contains("material = \"stud-chain\"") && edited.contains("name = \"chain\""));
    let edited = rename(text, "points.anchor", "pile");
    assert!(edited.contains("from = \"pile\"") && edited.contains("[points.pile]"));
}

#[test]
fn a_section_is_divided_into_two() {
    let divide = |text: &str, at: &str| {
        let edit = StructureEdit::Divide {
            path: "line.rope".to_owned(),
            at_m: at.to_owned(),
        };
        apply(&CASE, text, &edit)
    };
    let before = seacable::case::parse(HANGING, "x.toml").unwrap();
    let length = before.line[0].length_m;
    let edited = divide(HANGING, &format!("{}", length / 4.0)).unwrap();
    let after = seacable::case::parse(&edited, "x.toml").unwrap();
    assert_eq!(after.line.len(), 2);
    assert!((after.line[0].length_m - length / 4.0).abs() < 1e-6);
    let total: f64 = after.line.iter().map(|section| section.length_m).sum();
    assert!((total - length).abs() < 1e-9);
    let segments: usize = after.line.iter().map(|section| section.segments).sum();
    assert_eq!(segments, before.line[0].segments);
    assert!(
        divide(HANGING, "1e9")
            .unwrap_err()
            .contains("between 0 and")
    );
    assert!(
        divide(HANGING, "half")
            .unwrap_err()
            .contains("between 0 and")
    );
}

#[test]
fn a_line_of_a_system_is_divided_at_a_free_point() {
    let text = include_str!("../../../cases/systems/single_chain.toml");
    let schema = SystemFile::schema();
    let lines = several(schema, text);
    let line = lines
        .iter()
        .find(|row| row.path.starts_with("lines."))
        .unwrap();
    let edit = StructureEdit::Divide {
        path: line.path.clone(),
        at_m: "100".to_owned(),
    };
    let edited = apply(schema, text, &edit).unwrap();
    let before = kind::parse::<SystemFile>(text, "x.toml").unwrap();
    let after = kind::parse::<SystemFile>(&edited, "x.toml").unwrap();
    assert_eq!(after.file.lines.len(), before.file.lines.len() + 1);
    assert_eq!(after.file.points.len(), before.file.points.len() + 1);
    // The same chain: the tension at its end is that of before.
    let top = |text: &str| {
        let solved = kind::parse::<SystemFile>(text, "x.toml").unwrap();
        solved.rest.balance.tension
    };
    let (old, new) = (top(text), top(&edited));
    assert!((old - new).abs() < 1e-6 * old, "{old} {new}");
}

#[test]
fn a_section_of_a_line_of_a_system_is_divided() {
    let schema = SystemFile::schema();
    let rows = several(schema, SPREAD);
    let section = rows
        .iter()
        .find(|row| row.path.contains(".sections."))
        .unwrap();
    let edit = StructureEdit::Divide {
        path: section.path.clone(),
        at_m: "10".to_owned(),
    };
    let edited = apply(schema, SPREAD, &edit).unwrap();
    kind::parse::<SystemFile>(&edited, "x.toml").unwrap();
    let count = |text: &str| text.matches("[[lines.sections]]").count();
    assert_eq!(count(&edited), count(SPREAD) + 1);
}

/// The first line of a spread with names of its sections, the second line with the same.
fn with_names() -> String {
    let mut names = ["chain", "rope"].into_iter().cycle();
    let parts: Vec<&str> = SPREAD.split("[[lines.sections]]\n").collect();
    let mut text = parts[0].to_owned();
    for part in &parts[1..] {
        text += &format!(
            "[[lines.sections]]\nname = \"{}\"\n{part}",
            names.next().unwrap()
        );
    }
    text
}

#[test]
fn a_named_section_is_divided_renamed_and_moved() {
    let schema = SystemFile::schema();
    let text = with_names();
    let lines: Vec<OutlineRow> = several(schema, &text);
    let first = lines
        .iter()
        .find(|row| row.path.contains(".sections."))
        .unwrap();
    let line = first.path.split(".sections.").next().unwrap().to_owned();
    assert!(first.path.ends_with(".sections.chain"), "{}", first.path);
    let floats = format!(
        "\n[[lines.floats]]\nsection = \"chain\"\nlift_kg = 1.0\n[marks.\"{}.length_m\"]\nkind = \"assumed\"\nreason = \"r\"\n",
        first.path
    );
    let edit = |text: &str, edit: StructureEdit| apply(schema, text, &edit);
    let divided = edit(
        &text,
        StructureEdit::Divide {
            path: first.path.clone(),
            at_m: "10".to_owned(),
        },
    )
    .unwrap();
    kind::parse::<SystemFile>(&divided, "x.toml").unwrap();
    assert!(divided.contains("name = \"chain-2\""), "{divided}");
    let renamed = edit(
        &format!("{text}{floats}"),
        StructureEdit::Rename {
            path: first.path.clone(),
            to: "ground".to_owned(),
        },
    )
    .unwrap();
    assert!(
        renamed.contains(&format!("marks.\"{line}.sections.ground.length_m\"")),
        "{renamed}"
    );
    let moved = edit(
        &text,
        StructureEdit::Move {
            path: first.path.clone(),
            down: true,
        },
    )
    .unwrap();
    let place = |name: &str| moved.find(&format!("name = \"{name}\"\nmaterial")).unwrap();
    assert!(place("rope") < place("chain"), "{moved}");
}

#[test]
fn the_clump_of_a_divided_section_stays_at_its_end() {
    const CLUMP: &str = "clump_kg = 50.0\nclump_mass_kg = 80.0\nclump_drag_area_normal_m2 = 2.0\nclump_drag_area_tangential_m2 = 0.5\nclump_added_mass_normal_kg = 30.0\nclump_added_mass_tangential_kg = 4.0\n";
    let text = SPREAD.replacen("clump_kg = 1500.0\n", CLUMP, 1);
    let schema = SystemFile::schema();
    let rows = several(schema, &text);
    let section = rows
        .iter()
        .find(|row| row.path.contains(".sections."))
        .unwrap();
    let edit = StructureEdit::Divide {
        path: section.path.clone(),
        at_m: "10".to_owned(),
    };
    let edited = apply(schema, &text, &edit).unwrap();
    let sections: Vec<&str> = edited.split("[[lines.sections]]").collect();
    for key in CLUMP.lines() {
        assert!(!sections[1].contains(key), "{key}\n{edited}");
        assert!(sections[2].contains(key), "{key}\n{edited}");
    }
}

#[test]
fn what_cannot_be_done_is_refused_with_the_reason() {
    let refused = |edit: StructureEdit| apply(&CASE, HANGING, &edit).unwrap_err();
    let path = |path: &str| path.to_owned();
    for (edit, expected) in [
        (
            StructureEdit::Remove {
                path: path("line.x"),
            },
            "There is no line.x",
        ),
        (
            StructureEdit::Move {
                path: path("line.rope"),
                down: true,
            },
            "is the last one",
        ),
        (
            StructureEdit::Move {
                path: path("environment"),
                down: true,
            },
            "has no order",
        ),
        (
            StructureEdit::Copy {
                path: path("ends.a"),
                name: None,
            },
            "cannot be there twice",
        ),
        (
            StructureEdit::Rename {
                path: path("line.rope"),
                to: path("a b"),
            },
            "is not a usable name",
        ),
        (
            StructureEdit::Add {
                table: path("nothing"),
                name: None,
                values: vec![],
            },
            "has no table nothing",
        ),
        (
            StructureEdit::Add {
                table: path("materials"),
                name: None,
                values: vec![],
            },
            "Give it a name",
        ),
        (
            StructureEdit::Add {
                table: path("ends.a"),
                name: None,
                values: vec![],
            },
            "There is a ends.a already",
        ),
        (
            StructureEdit::Fill {
                path: path("line.rope"),
                values: vec![(path("length_m"), Some(path("-3")))],
            },
            "is out of range",
        ),
    ] {
        let said = refused(edit.clone());
        assert!(said.contains(expected), "{edit:?}: {said}");
    }
}
