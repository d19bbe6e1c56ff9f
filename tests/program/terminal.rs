//! The program on a real pseudo-terminal: from start to report, and every way to end.

#![cfg(target_os = "linux")]

use crate::pty;
use std::time::Duration;

use crate::pty::{Start, wait_gone, wait_until};
use rustix::process::{Pid, Signal, kill_process};

const LIST: &str = "Manifold, 300 t";

fn signal(process: i32, signal: Signal) {
    kill_process(Pid::from_raw(process).unwrap(), signal).unwrap();
}

#[test]
fn from_start_to_a_saved_report() {
    let mut pty = Start::default().go();
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("solver alpha");
    pty.send("R");
    pty.wait_for("is done");
    pty.send("4");
    pty.wait_for("PASS");
    pty.send("2");
    pty.wait_for("Tension at the joints");
    pty.send("5");
    pty.wait_for("`w` saves it");
    pty.send("w");
    pty.wait_for("The report is in runs/manifold-");
    let run = std::fs::read_dir(pty.dir.path().join("runs"))
        .unwrap()
        .next()
        .unwrap()
        .unwrap();
    let report = std::fs::read_to_string(run.path().join("report.txt")).unwrap();
    assert!(report.contains("Manifold, 300 t"), "{report}");
    assert!(run.path().join("history.csv").exists());
    pty.send("q");
    pty.ended(0);
}

#[test]
fn quit_gives_the_terminal_back_and_leaves_nothing_on_it() {
    let mut pty = Start::default().go();
    pty.wait_for(LIST);
    assert!(!pty.cooked());
    pty.send("q");
    pty.ended(0);
    assert_eq!(pty.text().trim(), "[ended 0]");
}

#[test]
fn sigterm_and_sighup_give_the_terminal_back() {
    for (which, status) in [(Signal::TERM, 143), (Signal::HUP, 129), (Signal::INT, 130)] {
        let pty = Start::default().go();
        pty.wait_for(LIST);
        signal(pty.process(), which);
        pty.ended(status);
    }
}

#[test]
fn a_panic_restores_the_terminal_before_its_message() {
    let mut pty = Start {
        vars: &[("LANG", "C.UTF-8"), ("SEACABLE_MAY_PANIC", "1")],
        ..Start::default()
    }
    .go();
    pty.wait_for(LIST);
    pty.send("\x1b[24~");
    pty.ended(101);
    assert!(pty.text().contains("SEACABLE_MAY_PANIC") || pty.text().contains("panicked"));
}

#[test]
fn a_hang_up_without_a_signal_ends_the_program_at_once() {
    let mut pty = Start {
        // Without a controlling terminal nobody sends SIGHUP.
        script: r#"trap "" HUP; setsid -w "$0" "$@"; echo $? > status"#,
        ..Start::default()
    }
    .go();
    pty.wait_for(LIST);
    let process = pty.process();
    pty.hang_up();
    signal(process, Signal::WINCH);
    wait_gone(process);
    let status = pty.dir.path().join("status");
    let until = std::time::Instant::now() + Duration::from_secs(60);
    let mut reported = String::new();
    while reported.is_empty() && std::time::Instant::now() < until {
        reported = std::fs::read_to_string(&status).unwrap_or_default();
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_eq!(reported.trim(), "129");
}

#[test]
fn a_hang_up_with_its_signal_ends_the_program() {
    let mut pty = Start::default().go();
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("solver alpha");
    let process = pty.process();
    pty.hang_up();
    signal(process, Signal::WINCH);
    wait_gone(process);
}

#[test]
fn control_z_gives_the_shell_its_terminal_and_fg_brings_the_screen_back() {
    let mut pty = Start {
        script: r#"export PS1='$ '; exec bash --norc --noprofile -i"#,
        ..Start::default()
    }
    .go();
    pty.wait_for("$ ");
    let program = env!("CARGO_BIN_EXE_seacable");
    pty.send(&format!("{program}\r"));
    pty.wait_for(LIST);
    pty.send("\x1a");
    pty.wait("the shell again", |screen| {
        !screen.alternate_screen() && screen.contents().contains("Stopped")
    });
    pty.send("fg\r");
    pty.wait("the list again", |screen| {
        screen.alternate_screen() && screen.contents().contains(LIST)
    });
    pty.send("q");
    pty.wait("the shell at the end", |screen| !screen.alternate_screen());
}

#[test]
fn control_z_without_a_shell_behind_says_why_it_does_not_stop() {
    let mut pty = Start {
        script: r#"exec "$0" "$@""#,
        ..Start::default()
    }
    .go();
    pty.wait_for(LIST);
    pty.send("\x1a");
    pty.wait_for("There is no shell behind this terminal");
}

#[test]
fn a_terminal_of_any_size_that_changes_during_a_run() {
    let mut pty = Start {
        size: (39, 9),
        ..Start::default()
    }
    .go();
    pty.wait_for("need 40x10");
    pty.resize(80, 24);
    pty.wait_for(LIST);
    pty.send("\rMMM");
    pty.wait_for("solver");
    pty.send("R2");
    pty.wait_for("Tensions");
    pty.resize(200, 60);
    pty.wait_for("Tension along the line");
    pty.resize(120, 30);
    pty.wait("two panes", |screen| {
        let text = screen.contents();
        text.contains("1 Inputs") && text.contains("Shape") && !text.contains("along the line")
    });
    pty.send("\x03");
    pty.wait_for("Ctrl-C again quits");
    pty.send("q");
    pty.wait_for("Question");
    pty.send("d");
    pty.wait("an end or a question about jobs", |screen| {
        let text = screen.contents();
        text.contains("[ended 0]") || text.contains("Jobs are running")
    });
    if pty.text().contains("Jobs are running") {
        pty.send("q");
    }
    pty.ended(0);
}

#[test]
fn no_color_keeps_the_selection_and_sends_no_colour() {
    let mut pty = Start {
        vars: &[("LANG", "C.UTF-8"), ("NO_COLOR", "1")],
        ..Start::default()
    }
    .go();
    pty.wait_for(LIST);
    pty.wait("a reversed line", |screen| {
        (0..24).any(|row| screen.cell(row, 5).is_some_and(vt100::Cell::inverse))
    });
    pty.send("\r2");
    pty.wait_for("Tension at the joints");
    pty.send("q");
    pty.ended(0);
    let bytes = pty.bytes();
    let text = String::from_utf8_lossy(&bytes);
    for sequence in text.split("\x1b[").skip(1) {
        let end = sequence
            .find(|c: char| c.is_ascii_alphabetic())
            .unwrap_or(0);
        let (parameters, letter) = sequence.split_at(end);
        if letter.starts_with('m') {
            let colour = |p: &str| matches!(p.parse::<u8>(), Ok(30..=38 | 40..=48 | 90..=107));
            assert!(
                !parameters.split([';', ':']).any(colour),
                "colour in {parameters:?}"
            );
        }
    }
}

#[test]
fn lang_c_gets_ascii_and_nothing_else() {
    let mut pty = Start {
        vars: &[("LANG", "C")],
        ..Start::default()
    }
    .go();
    pty.wait_for(LIST);
    pty.send("\r2");
    pty.wait_for("vessel|chain");
    pty.send("q");
    pty.ended(0);
    assert!(pty.bytes().is_ascii());
}

#[test]
fn without_a_locale_every_pane_is_ascii_and_no_character_is_lost() {
    let mut pty = Start {
        vars: &[],
        ..Start::default()
    }
    .go();
    pty.wait_for("No locale is set, so this is ASCII.");
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("1 Inputs");
    for pane in ["1", "2", "3", "4", "5", "6", "7", "8"] {
        pty.send(pane);
        pty.wait("the pane", |screen| {
            let text = screen.contents();
            let foot = text.lines().last().unwrap_or_default();
            // The one question mark is the key of the help.
            text.contains(&format!(" {pane} "))
                && foot.contains("? help")
                && text.matches('?').count() == 1
        });
    }
    pty.send("q");
    pty.ended(0);
    assert!(pty.bytes().is_ascii());
}

#[test]
fn results_for_a_terminal_without_a_locale_are_ascii() {
    let start = |vars| Start {
        vars,
        args: &["keys", "payload"],
        ..Start::default()
    };
    let pty = start(&[]).go();
    pty.ended(0);
    assert!(pty.bytes().is_ascii());
    let pty = start(&[("LC_ALL", "C.UTF-8")]).go();
    pty.ended(0);
    assert!(pty.text().contains('²'));
}

#[test]
fn on_a_dumb_terminal_the_alternative_is_named() {
    let pty = Start {
        vars: &[("LANG", "C.UTF-8"), ("TERM", "dumb")],
        ..Start::default()
    }
    .go();
    pty.ended(2);
    assert!(pty.text().contains("seacable run CASE"), "{}", pty.text());
    assert!(!pty.bytes().windows(5).any(|w| w == b"\x1b[?10"));
}

#[test]
fn escape_sequences_cut_by_a_slow_link_are_still_keys() {
    let mut pty = Start {
        args: &["--slow-link"],
        ..Start::default()
    }
    .go();
    pty.wait_for(LIST);
    let selected = |text: &'static str| {
        move |screen: &vt100::Screen| {
            (0..24).any(|row| {
                let line: String = screen.contents_between(row, 0, row, 79);
                line.contains(text) && screen.cell(row, 2).is_some_and(vt100::Cell::inverse)
            })
        }
    };
    pty.wait("the manifold selected", selected("manifold.toml"));
    for piece in ["\x1b", "[", "A"] {
        pty.send(piece);
        // The pieces must arrive one by one; this is the slow link itself, no wait for a result.
        std::thread::sleep(Duration::from_millis(30));
    }
    pty.wait("another line selected", |screen| {
        !selected("manifold.toml")(screen) && selected(".toml")(screen)
    });
    pty.send("q");
    pty.ended(0);
}

#[test]
fn unsaved_changes_survive_a_kill_and_are_offered_again() {
    let mut pty = Start::default().go();
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("solver alpha");
    pty.send("M");
    pty.wait_for("*unsaved");
    let process = pty.process();
    let kept = pty.dir.path().join(".local/state/seacable/recovery");
    pty.wait("the solver changed", |screen| {
        screen.contents().contains("solver static")
    });
    // A busy disk may take longer than a frame.
    wait_until("the edit is kept", || {
        let Ok(entries) = std::fs::read_dir(&kept) else {
            return false;
        };
        let names = entries.map(|item| item.unwrap().path());
        names
            .filter(|path| path.extension().is_some_and(|end| end == "toml"))
            .count()
            == 1
    });
    signal(process, Signal::KILL);
    pty.wait_for("[ended 137]");
    let dir = std::mem::replace(&mut pty.dir, tempfile::tempdir().unwrap());
    drop(pty);
    let mut again = Start {
        args: &["--fresh"],
        ..Start::default()
    }
    .go_in(dir);
    again.wait_for(LIST);
    again.send("\r");
    again.wait_for("bring them back");
    again.send("r");
    again.wait_for("*unsaved");
    again.send("s");
    again.wait_for("Saved to");
    again.send("q");
    again.ended(0);
    let text = std::fs::read_to_string(again.dir.path().join("cases/pendulous/manifold.toml"));
    assert!(text.unwrap().contains("method = \"static\""));
    assert_eq!(
        std::fs::read_dir(again.dir.path().join(".local/state/seacable/recovery"))
            .unwrap()
            .count(),
        0
    );
}

#[test]
fn nothing_is_written_while_nothing_happens() {
    let mut pty = Start::default().go();
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("solver alpha");
    // The live solve is over when the head says nothing of it any more.
    pty.send("3");
    pty.wait("the live run done", |screen| {
        screen.contents().contains("in memory") && screen.contents().contains(" done ")
    });
    pty.send("j");
    let before = pty.bytes().len();
    std::thread::sleep(Duration::from_millis(700));
    let between = pty.bytes().len();
    std::thread::sleep(Duration::from_millis(700));
    assert_eq!(pty.bytes().len(), between, "{before}");
    pty.send("q");
    pty.ended(0);
}

/// ^C typed in the editor reaches the whole foreground group; the workbench does not leave for it.
#[test]
fn what_interrupts_the_editor_leaves_the_workbench() {
    let dir = pty::place();
    let editor = dir.path().join("ed.sh");
    std::fs::write(&editor, "kill -INT $PPID\nsleep 0.2\n").unwrap();
    let words = format!("sh {}", editor.display());
    let vars = [("LANG", "C.UTF-8"), ("EDITOR", words.as_str())];
    let mut pty = Start {
        vars: &vars,
        ..Start::default()
    }
    .go_in(dir);
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("solver alpha");
    pty.send("E");
    pty.wait_for("The file is as it was");
    pty.send("q");
    pty.ended(0);
}

/// The user's editor has the terminal as the shell has it, and what it leaves is read: as an edit, or as faults.
#[test]
fn the_users_editor_gets_the_terminal_and_gives_it_back() {
    let dir = pty::place();
    let editor = dir.path().join("ed.sh");
    let script =
        "test -t 0 && stty -a | grep -q ' icanon' && sed -i \"s/$(cat was)/$(cat is)/\" \"$1\"\n";
    std::fs::write(&editor, script).unwrap();
    let say = |dir: &std::path::Path, was: &str, is: &str| {
        std::fs::write(dir.join("was"), was).unwrap();
        std::fs::write(dir.join("is"), is).unwrap();
    };
    say(dir.path(), "duration_s = 1200.0", "duration_s = 300.0");
    let words = format!("sh {}", editor.display());
    let vars = [("LANG", "C.UTF-8"), ("EDITOR", words.as_str())];
    let mut pty = Start {
        vars: &vars,
        ..Start::default()
    }
    .go_in(dir);
    pty.wait_for(LIST);
    pty.send("\r");
    pty.wait_for("solver alpha");
    pty.send("E");
    pty.wait_for("Read from the file again");
    assert!(!pty.cooked());
    pty.send("/duration\r");
    pty.wait_for("300");
    say(pty.dir.path(), "duration_s = 300.0", "duration_s = -3.0");
    pty.send("E");
    pty.wait_for("out of range");
    pty.send("q");
    pty.send("q");
    pty.ended(0);
}

const CHAIN_60: &str = include_str!("../trials/files/loud_chain_60.toml");

/// Parameters in a chain of 60 in any file of a folder ended the workbench by an overflow of the stack.
#[test]
fn a_folder_with_deep_files_opens() {
    let dir = pty::place();
    let folder = dir.path().join("odd");
    std::fs::create_dir(&folder).unwrap();
    let rows = |count: usize, end: &str| {
        let rows: String = (1..count)
            .map(|i| format!("p{i} = \"p{}\"\n", i + 1))
            .collect();
        format!("\n[parameters]\n{rows}p{count} = {end}\n")
    };
    let small = crate::small::SMALL;
    let deep = format!("x = {}1{}\n{small}", "[".repeat(5_000), "]".repeat(5_000));
    for (name, text) in [
        ("a_line.toml", small.to_owned()),
        ("chain_60.toml", CHAIN_60.to_owned()),
        ("chain_1900.toml", small.to_owned() + &rows(1_900, "1.0")),
        ("circle.toml", small.to_owned() + &rows(1_900, "\"p1\"")),
        ("deep.toml", deep),
    ] {
        std::fs::write(folder.join(name), text).unwrap();
    }
    let mut pty = Start {
        args: &["odd"],
        ..Start::default()
    }
    .go_in(dir);
    // Those that cannot be read are listed by their names.
    for name in ["A small pendulum", "chain_60", "circle", "deep"] {
        pty.wait_for(name);
    }
    pty.send("\r");
    pty.wait_for("solver alpha");
    pty.send("q");
    pty.ended(0);
}
