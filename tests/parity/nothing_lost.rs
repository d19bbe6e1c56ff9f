//! Keys, commands and channels that were there are there, by their names.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use seacable::case;
use seacable::case::fields::{Schema, json_schema};
use seacable::case::{CASE, kind};
use seacable::system::motion::channels::Channels;
use seacable::system::motion::start::start;
use seacable::system::{SYSTEM, SystemFile};
use serde_json::Value;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn fixture(name: &str) -> String {
    let place = root().join("tests/data/before_one_march").join(name);
    fs::read_to_string(place).unwrap()
}

/// The paths of all keys of a schema: `solver.duration_s`.
fn keys(schema: &Value) -> BTreeSet<String> {
    fn walk(node: &Value, path: &str, found: &mut BTreeSet<String>) {
        match node {
            Value::Object(map) => {
                for (name, inner) in map {
                    if name == "properties" {
                        for (key, inner) in inner.as_object().unwrap() {
                            let path = format!("{path}.{key}");
                            found.insert(path.clone());
                            walk(inner, &path, found);
                        }
                    } else {
                        walk(inner, path, found);
                    }
                }
            }
            Value::Array(items) => items.iter().for_each(|inner| walk(inner, path, found)),
            _ => {}
        }
    }
    let mut found = BTreeSet::new();
    walk(schema, "", &mut found);
    found
}

fn assert_keys(fixture_name: &str, schema: &'static Schema) {
    let before = keys(&serde_json::from_str(&fixture(fixture_name)).unwrap());
    let now = keys(&json_schema(schema));
    let lost: Vec<&String> = before.difference(&now).collect();
    assert!(lost.is_empty(), "{lost:#?}");
    assert!(before.len() > 100, "{}", before.len());
}

#[test]
fn no_key_of_a_line_is_lost() {
    assert_keys("case.schema.json", &CASE);
}

#[test]
fn no_key_of_a_system_is_lost() {
    assert_keys("system.schema.json", &SYSTEM);
}

/// What `--help` of a command says.
fn help(words: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    let output = command.args(words).arg("--help").output().unwrap();
    assert!(output.status.success(), "{words:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// Studies that measure the program, which went to the laboratory.
const LABORATORY: [&str; 4] = ["systems", "intervals", "bars", "accuracy"];

/// The name of a command now.
fn now(command: &str) -> String {
    let moved = command.strip_prefix("seacable study ");
    match moved.filter(|study| LABORATORY.contains(study)) {
        Some(study) => format!("seacable laboratory {study}"),
        None => command.to_owned(),
    }
}

#[test]
fn no_command_and_no_option_is_lost() {
    let text = fixture("commands.txt");
    let lines: Vec<String> = text.lines().map(str::to_owned).collect();
    assert_commands(&lines);
    // By their new names too: scripts have the old ones.
    let moved = lines.iter().filter_map(|line| {
        let (command, option) = line.split_once(" --").unwrap_or((line, ""));
        let separator = if option.is_empty() { "" } else { " --" };
        let name = now(command);
        (name != command).then(|| format!("{name}{separator}{option}"))
    });
    let moved: Vec<String> = moved.collect();
    assert!(moved.len() > 50, "{}", moved.len());
    assert_commands(&moved);
}

#[test]
fn studies_are_of_moorings_and_the_laboratory_is_of_the_program() {
    let listed = |words: &[&str], name: &str| {
        let help = help(words);
        help.lines()
            .any(|line| line.split_whitespace().next() == Some(name))
    };
    for name in LABORATORY {
        assert!(listed(&["laboratory"], name), "{name}");
        assert!(!listed(&["study"], name), "{name}");
    }
    assert!(listed(&["study"], "effects"));
}

fn assert_commands(lines: &[String]) {
    let mut shown = (String::new(), String::new());
    for line in lines {
        let (command, option) = match line.split_once(" --") {
            Some((command, option)) => (command, Some(format!("--{option}"))),
            None => (line.as_str(), None),
        };
        if shown.0 != command {
            let words: Vec<&str> = command.split(' ').skip(1).collect();
            shown = (command.to_owned(), help(&words));
        }
        if let Some(option) = option {
            let has = shown.1.split_whitespace().any(|word| {
                let word = word.trim_end_matches([',', '=']);
                word == option || word.split(['=', '[']).next() == Some(&option)
            });
            assert!(has, "{command} has no {option}");
        }
    }
}

/// The channels of the shipped cases, by the names that their runs had.
#[test]
fn no_channel_of_a_shipped_case_is_lost() {
    let text = fixture("names.tsv");
    let rows = text.lines().map(|line| {
        let mut fields = line.split('\t');
        [(); 3].map(|()| fields.next().unwrap())
    });
    let rows: Vec<[&str; 3]> = rows.filter(|[_, what, _]| *what == "channel").collect();
    let mut tried = 0;
    for own in rows.chunk_by(|one, other| one[0] == other[0]) {
        let file = PathBuf::from(own[0][0]);
        let text = fs::read_to_string(root().join(&file)).unwrap();
        let now: Vec<String> = match text.contains("[system]") {
            true => of_system(&file),
            false if text.contains("[case]") => of_line(&file),
            // Ships and ropeways print their results.
            false => continue,
        };
        for [_, _, name] in own {
            assert!(
                now.iter().any(|known| known == name),
                "{}: {name}",
                own[0][0]
            );
        }
        tried += 1;
    }
    assert!(tried > 40, "{tried}");
}

fn of_line(file: &Path) -> Vec<String> {
    let case = case::load(&root().join(file)).unwrap();
    let channels = case::channels(&case.case);
    channels
        .iter()
        .map(|channel| channel.id.to_string())
        .collect()
}

fn of_system(file: &Path) -> Vec<String> {
    let (name, folder) = (file.display().to_string(), root().join(file));
    let text = fs::read_to_string(&folder).unwrap();
    let solved = kind::parse_beside::<SystemFile>(&text, &name, folder.parent().unwrap()).unwrap();
    let begun = start(&solved, 1.0).unwrap();
    let channels = Channels::of_system(&begun.system);
    channels.ids.iter().map(ToString::to_string).collect()
}
