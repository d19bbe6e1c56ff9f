//! Text from outside that would steer a terminal or reorder what is read: it leaves the program as visible escapes only.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use seacable::visible::is_invisible;

use crate::small::SMALL;

/// Escape sequences of C0 and C1, bidirectional controls and marks, zero-width characters, separators, a tag, DEL.
pub(crate) const HOSTILE: &str = "a\u{1b}]0;x\u{7}\u{9b}31m\u{202e}b\u{2066}\u{200f}\u{61c}\u{200b}\u{feff}\u{2028}\u{e0041}\u{7f}\u{8}\rc";

/// The subcommands that take a file, up to its name, and whether the file is a line case.
const COMMANDS: [&[&str]; 10] = [
    &[],
    &["run"],
    &["validate"],
    &["report"],
    &["catenary"],
    &["section"],
    &["ship"],
    &["modes"],
    &["ropeway"],
    &["study", "hard-cases"],
];

struct Probe {
    dir: tempfile::TempDir,
    count: usize,
}

impl Probe {
    fn new() -> Self {
        Self {
            dir: tempfile::tempdir().unwrap(),
            count: 0,
        }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.dir.path().join(name)
    }

    fn put(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    /// Runs the program and checks all it prints.
    fn run(&mut self, words: &[&str]) -> Output {
        self.count += 1;
        let words: Vec<OsString> = words.iter().map(OsString::from).collect();
        let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
        let done = command.args(&words).current_dir(self.dir.path());
        let done = done.output().unwrap();
        check(&done.stdout, &format!("standard output of {words:?}"));
        check(&done.stderr, &format!("standard error of {words:?}"));
        assert!(!done.stdout.is_empty() || !done.stderr.is_empty() || done.status.success());
        done
    }

    /// Checks a file that the program wrote.
    fn written(&self, name: &str) {
        check(&fs::read(self.path(name)).unwrap(), name);
    }
}

fn check(bytes: &[u8], what: &str) {
    let text = std::str::from_utf8(bytes).unwrap();
    let raw: Vec<char> = text
        .chars()
        .filter(|c| is_invisible(*c) && !matches!(c, '\n' | '\t'))
        .collect();
    assert!(
        raw.is_empty(),
        "{raw:?} in {what}:\n{}",
        text.escape_debug()
    );
}

/// The text as a TOML string with every character escaped.
pub(crate) fn toml_string(text: &str) -> String {
    let each = text.chars().map(|c| format!("\\U{:08X}", u32::from(c)));
    format!("\"{}\"", each.collect::<String>())
}

fn shipped(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases")
        .join(name);
    fs::read_to_string(path).unwrap()
}

/// The text with the value of its first `key = ` replaced.
pub(crate) fn with_value(text: &str, key: &str, value: &str) -> String {
    let head = format!("{key} = ");
    let at = text.find(&head).unwrap() + head.len();
    let end = at + text[at..].find('\n').unwrap();
    format!("{}{value}{}", &text[..at], &text[end..])
}

#[test]
fn arguments_and_paths() {
    let mut probe = Probe::new();
    let option = format!("--{HOSTILE}");
    let set = format!("{HOSTILE}={HOSTILE}");
    probe.put("case.toml", SMALL);
    probe.put(HOSTILE, HOSTILE);
    for words in COMMANDS {
        for tail in [
            &[HOSTILE][..],
            &["absent", HOSTILE, HOSTILE],
            &[&option],
            &["case.toml", "--set", &set],
            &["case.toml", "--set", HOSTILE],
            &["case.toml", "-o", HOSTILE],
            &["case.toml", "-o", HOSTILE, "--force"],
            &["case.toml", "--out", HOSTILE],
            &["case.toml", "--solver", HOSTILE],
            &["case.toml", "--count", HOSTILE],
            &["--glyphs", HOSTILE],
        ] {
            probe.run(&[words, tail].concat());
        }
    }
    for words in [
        ["study", HOSTILE],
        [HOSTILE, "case.toml"],
        ["help", HOSTILE],
        ["keys", HOSTILE],
    ] {
        probe.run(&words);
    }
    assert!(probe.count > 100);
}

#[test]
fn files_of_every_kind() {
    let mut probe = Probe::new();
    let kinds = [
        SMALL.to_owned(),
        shipped("umbilical/section.toml"),
        shipped("ropeway/span_60.toml"),
        shipped("ship/anchored.toml"),
    ];
    let value = toml_string(HOSTILE);
    for text in &kinds {
        for (place, spoilt) in [
            ("raw text", format!("{HOSTILE}{text}")),
            (
                "raw title",
                with_value(text, "title", &format!("\"{HOSTILE}\"")),
            ),
            ("title", with_value(text, "title", &value)),
            ("number", text.replacen(".0", &format!(".0{HOSTILE}"), 1)),
            ("key", format!("{value} = 1\n{text}")),
            ("table", format!("{text}\n[{value}]\n{value} = {value}\n")),
        ] {
            probe.put("case.toml", &spoilt);
            for words in COMMANDS {
                let fails_at_once = !matches!(place, "title");
                if fails_at_once || words != ["study", "hard-cases"] {
                    probe.run(&[words, &["case.toml"]].concat());
                }
            }
        }
    }
    for key in ["name", "material", "kind", "shape"] {
        probe.put("case.toml", &with_value(SMALL, key, &value));
        for words in [["run"], ["modes"], ["validate"]] {
            probe.run(&[&words[..], &["case.toml"]].concat());
        }
    }
    assert!(probe.count > 200);
}

#[test]
fn files_that_are_written() {
    let mut probe = Probe::new();
    let value = toml_string(HOSTILE);
    let title = |text: &str| with_value(text, "title", &value);
    probe.put("case.toml", &title(SMALL));
    probe.put("section.toml", &title(&shipped("umbilical/section.toml")));
    probe.put("ropeway.toml", &title(&shipped("ropeway/span_60.toml")));
    probe.put(
        "lines.csv",
        &format!(
            "x_m,z_m,length_m,ea_n,weight_n_per_m,{HOSTILE}\n{HOSTILE},0,120,1e9,50,{HOSTILE}\n"
        ),
    );
    probe.put(
        "lines.json",
        "{\"name\": \"\u{202e}\u{9b}\u{200b}\", \"sections\": [[120, 50, 1e9]], \"x_m\": 100, \"z_m\": 0}\n{\"\u{202e}\": 1, \"sections\": \"\u{202e}\"}\n",
    );
    for (words, file) in [
        (&["modes", "case.toml", "-o", "modes.csv"][..], "modes.csv"),
        (
            &["section", "section.toml", "-o", "material.toml"],
            "material.toml",
        ),
        (
            &["ropeway", "ropeway.toml", "--line", "line.toml"],
            "line.toml",
        ),
    ] {
        assert!(probe.run(words).status.success(), "{words:?}");
        probe.written(file);
    }
    for table in ["lines.csv", "lines.json"] {
        probe.run(&["catenary", table]);
        probe.run(&["catenary", table, "-o", "out"]);
        if let Ok(bytes) = fs::read(probe.path("out")) {
            check(&bytes, table);
            fs::remove_file(probe.path("out")).unwrap();
        }
    }
    let json = probe.run(&["catenary", "lines.json"]).stdout;
    let json = String::from_utf8(json).unwrap();
    assert!(json.contains(r#""name": "\u202e\u009b\u200b""#), "{json}");
    assert!(json.contains(r#""h_b_n""#), "{json}");
}

#[test]
fn stored_runs() {
    let mut probe = Probe::new();
    probe.put(
        "case.toml",
        &with_value(SMALL, "title", &toml_string(HOSTILE)),
    );
    let id = HOSTILE.replace(['\r', '\u{8}'], "");
    assert!(
        probe
            .run(&["run", "case.toml", "--out", &id])
            .status
            .success()
    );
    for words in [
        &["report", &id][..],
        &["report", &id, "-o", "report.txt"],
        &["report", &id, "--ascii"],
        &["run", "--resume", &id, "--until", "6"],
        &["run", "case.toml", "--out", &id],
    ] {
        probe.run(words);
    }
    probe.written("report.txt");
    // The case is the user's file to the last byte; everything else is the program's.
    for item in fs::read_dir(probe.path(&id)).unwrap() {
        let path = item.unwrap().path();
        if path.file_name().unwrap() != "case.toml" {
            check(&fs::read(&path).unwrap(), &path.display().to_string());
        }
    }
    let info = probe.path(&id).join("run.toml");
    let text = fs::read_to_string(&info).unwrap();
    for spoilt in [
        format!("{HOSTILE}\n{text}"),
        with_value(&text, "version", &toml_string(HOSTILE)),
        with_value(&text, "state", &toml_string(HOSTILE)),
    ] {
        fs::write(&info, spoilt).unwrap();
        probe.run(&["report", &id]);
        probe.run(&["run", "--resume", &id]);
    }
}

/// What other programs read back holds the same text, by the escapes of its own format.
#[test]
fn json_and_toml_read_back_to_the_same_text() {
    let mut probe = Probe::new();
    let title = HOSTILE.replace(['\r', '\u{8}'], "");
    let value = toml_string(&title);
    probe.put("case.toml", &with_value(SMALL, "title", &value));
    for words in [
        &["run", "case.toml", "--out", "run", "--json"][..],
        &["validate", "case.toml", "--json"],
        &["modes", "case.toml", "--json"],
    ] {
        let done = probe.run(words);
        assert!(done.status.success(), "{words:?}");
        let object: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
        let read = object.to_string();
        let stated = serde_json::Value::from(title.as_str()).to_string();
        assert!(
            !read.contains("title") || read.contains(stated.trim_matches('"')),
            "{words:?}: {read}"
        );
    }
    let exported = probe.run(&["export", &tripod(), "--moordyn", "-o", "tripod.txt"]);
    assert!(exported.status.success());
    let text = fs::read_to_string(probe.path("tripod.txt")).unwrap();
    probe.put(
        "hostile.txt",
        &format!("{}\n{text}", HOSTILE.replace(['\r', '\n'], "")),
    );
    let done = probe.run(&["import", "hostile.txt"]);
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(
        done.status.success() && text.parse::<toml::Table>().is_ok(),
        "{text}"
    );
}

fn tripod() -> String {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    cases
        .join("systems/tripod.toml")
        .to_str()
        .unwrap()
        .to_owned()
}

/// A line feed in a path or an argument begins no line of its own, which could pass for a message of the program.
#[test]
fn a_line_feed_in_a_path_forges_no_message() {
    let mut probe = Probe::new();
    let name = "a\nerror: forged.toml";
    probe.put(name, "nothing\n");
    probe.put("case.toml", SMALL);
    for words in COMMANDS {
        for tail in [
            &[name][..],
            &["b\nerror: forged.toml"],
            &["case.toml", "-o", name],
            &["case.toml", "--out", name],
            &["case.toml", "--set", "x=1\nerror: forged"],
            &["case.toml", "--force\nerror: forged"],
        ] {
            let done = probe.run(&[words, tail].concat());
            let said = String::from_utf8(done.stderr).unwrap();
            let forged = said.lines().any(|line| line.starts_with("error: forged"));
            assert!(!forged, "{words:?} {tail:?}: {said}");
        }
    }
}
