//! Keys, doctor, manual and what is kept for the next session, with the program itself.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use super::pty::{Start, place};

/// The program with folders of its own below a directory.
fn run(dir: &Path, args: &[&str]) -> Output {
    program(dir).args(args).output().unwrap()
}

fn program(dir: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command
        .env_clear()
        .env("HOME", dir)
        .env("LANG", "C.UTF-8")
        .current_dir(dir);
    for name in ["PATH", "LLVM_PROFILE_FILE"] {
        if let Some(value) = std::env::var_os(name) {
            command.env(name, value);
        }
    }
    command
}

fn text(output: &Output) -> String {
    let all = [output.stdout.as_slice(), output.stderr.as_slice()].concat();
    String::from_utf8_lossy(&all).into_owned()
}

/// Writes the user's file of keys.
fn keys(dir: &Path, text: &str) {
    let folder = dir.join(".config/seacable");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("keys.toml"), text).unwrap();
}

#[test]
fn doctor_says_what_is_in_the_way() {
    let dir = tempfile::tempdir().unwrap();
    let fine = run(dir.path(), &["doctor"]);
    assert!(fine.status.success(), "{}", text(&fine));
    assert!(text(&fine).contains("Nothing is in the way."));
    keys(dir.path(), "[keys]\nrnu = \"F5\"\n");
    let bad = run(dir.path(), &["doctor", "--json"]);
    assert_eq!(bad.status.code(), Some(1), "{}", text(&bad));
    let object: serde_json::Value = serde_json::from_slice(&bad.stdout).unwrap();
    let found = object["findings"].as_array().unwrap();
    let fault = found.iter().find(|of| of["health"] == "problem").unwrap();
    assert!(
        fault["value"]
            .as_str()
            .unwrap()
            .contains("keys.toml:2:1: keys.rnu")
    );
    assert_eq!(fault["remedy"], "write `run`");
}

#[test]
fn bindings_lists_the_keys_of_the_user_and_prints_a_whole_file() {
    let dir = tempfile::tempdir().unwrap();
    let whole = run(dir.path(), &["bindings", "--default"]);
    keys(dir.path(), &text(&whole));
    let listed = run(dir.path(), &["bindings", "charts"]);
    assert!(
        listed.status.success() && text(&listed).contains("zoom_in"),
        "{}",
        text(&listed)
    );
    keys(dir.path(), "[charts]\nzoom_in = \"F9\"\nzoom_out = \"q\"\n");
    let listed = run(dir.path(), &["bindings", "charts"]);
    assert_eq!(listed.status.code(), Some(1));
    let said = text(&listed);
    assert!(
        said.contains("f9") && said.contains("`q` is the key of `quit`"),
        "{said}"
    );
    assert!(said.contains("keys.toml:3:12"), "{said}");
}

/// Whether a program is installed.
fn has(name: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|dir| dir.join(name).is_file())
}

#[test]
fn manual_and_completions_are_put_in_place_and_taken_away() {
    let dir = tempfile::tempdir().unwrap();
    let data = dir.path().join(".local/share");
    let page = data.join("man/man1/seacable.1");
    let all = [
        "install-manual",
        "--shell",
        "bash",
        "--shell",
        "zsh",
        "--shell",
        "fish",
    ];
    assert!(run(dir.path(), &all).status.success());
    assert!(page.is_file() && data.join("man/man1/seacable-study-vary.1").is_file());
    let bash = data.join("bash-completion/completions/seacable");
    assert!(bash.is_file() && data.join("zsh/site-functions/_seacable").is_file());
    pages_have_no_faults(&data.join("man/man1"));
    completes(&bash);
    std::fs::write(&page, "a page of another program\n").unwrap();
    let again = run(dir.path(), &all);
    assert_eq!(again.status.code(), Some(1), "{}", text(&again));
    assert!(text(&again).contains("KEPT"));
    assert!(
        run(dir.path(), &["install-manual", "--remove"])
            .status
            .code()
            == Some(1)
    );
    assert!(page.is_file() && !bash.exists());
    assert!(
        run(dir.path(), &["install-manual", "--force"])
            .status
            .success()
    );
    assert!(
        run(dir.path(), &["install-manual", "--remove"])
            .status
            .success()
    );
    assert!(!page.exists());
}

/// Every page is set by groff without a warning, where that is installed.
fn pages_have_no_faults(dir: &Path) {
    if !has("groff") {
        return;
    }
    for page in std::fs::read_dir(dir).unwrap() {
        let page = page.unwrap().path();
        let set = Command::new("groff")
            .args(["-man", "-Tutf8", "-ww", "-z"])
            .arg(&page)
            .output()
            .unwrap();
        assert!(set.stderr.is_empty(), "{}: {}", page.display(), text(&set));
    }
}

/// The function that bash is given completes a command.
fn completes(file: &Path) {
    let script = format!(
        "source {}; complete -p seacable; COMP_WORDS=(seacable doc); COMP_CWORD=1; \
         _seacable seacable doc seacable; echo \"got ${{COMPREPLY[*]}}\"",
        file.display()
    );
    let said = Command::new("bash")
        .args(["--norc", "--noprofile", "-c", &script])
        .output()
        .unwrap();
    let said = text(&said);
    assert!(
        said.contains("-F _seacable") && said.contains("got doctor"),
        "{said}"
    );
}

#[test]
fn the_pages_and_completions_are_printed() {
    let dir = tempfile::tempdir().unwrap();
    assert!(text(&run(dir.path(), &["man", "study", "vary"])).contains(".TH seacable-study-vary"));
    let unknown = run(dir.path(), &["man", "nothing"]);
    assert_eq!(unknown.status.code(), Some(2), "{}", text(&unknown));
    for (shell, word) in [
        ("bash", "complete"),
        ("zsh", "#compdef"),
        ("fish", "complete -c"),
        ("elvish", "edit:"),
        ("powershell", "Register"),
    ] {
        let said = text(&run(dir.path(), &["completions", shell]));
        assert!(said.contains(word), "{shell}: {said}");
    }
}

#[cfg(target_os = "linux")]
mod on_the_screen {
    use super::*;

    /// Only the case of the tutorial and two others, so that the list is there soon.
    fn few() -> tempfile::TempDir {
        let dir = tempfile::tempdir().unwrap();
        let whole = place();
        let cases = dir.path().join("cases/pendulous");
        std::fs::create_dir_all(&cases).unwrap();
        let from = whole.path().join("cases/pendulous/manifold.toml");
        std::fs::copy(from, cases.join("manifold.toml")).unwrap();
        let from = whole.path().join("cases/basics/hanging_line.toml");
        std::fs::copy(from, dir.path().join("cases/hanging_line.toml")).unwrap();
        dir
    }

    fn state(dir: &Path) -> PathBuf {
        dir.join(".local/state/seacable")
    }

    #[test]
    fn the_next_session_opens_as_the_last_one_ended() {
        let mut pty = Start::default().go_in(few());
        pty.wait_for("hanging_line.toml");
        pty.send("/hanging\r\r");
        pty.wait_for("1 Inputs");
        pty.send("7");
        pty.wait_for("tension [N]");
        pty.send("llo");
        pty.wait_for("(up)");
        pty.send("q");
        pty.ended(0);
        let dir = pty.kill();
        let kept = std::fs::read_dir(state(dir.path()).join("screen")).unwrap();
        assert_eq!(kept.count(), 1);
        let mut pty = Start::default().go_in(dir);
        pty.wait_for("(up)");
        pty.send("q");
        pty.ended(0);
        let dir = pty.kill();
        // Damage is said, and not used.
        let file = std::fs::read_dir(state(dir.path()).join("screen"))
            .unwrap()
            .next()
            .unwrap()
            .unwrap();
        std::fs::write(file.path(), "pane = [\n").unwrap();
        let mut pty = Start::default().go_in(dir);
        pty.wait_for("is damaged and is not used");
        pty.wait_for("Cases (2)");
        pty.send("q");
        pty.ended(0);
        let mut pty = Start {
            args: &["--fresh", "--keep-screen"],
            ..Start::default()
        }
        .go_in(pty.kill());
        pty.wait_for("Cases (2)");
        pty.send("q");
        pty.ended(0);
        assert!(pty.text().contains("Cases (2)"), "{}", pty.text());
    }

    #[test]
    fn a_fault_is_kept_for_the_doctor() {
        let mut pty = Start {
            vars: &[("LANG", "C.UTF-8"), ("SEACABLE_MAY_PANIC", "1")],
            ..Start::default()
        }
        .go_in(few());
        pty.wait_for("Cases (2)");
        pty.send("\x1b[24~");
        pty.ended(101);
        let dir = pty.kill();
        let said = text(&run(dir.path(), &["doctor"]));
        assert!(
            said.contains("SEACABLE_MAY_PANIC") && said.contains("crash.log"),
            "{said}"
        );
    }

    #[test]
    fn keys_of_a_file_work_and_faults_are_shown() {
        let dir = few();
        keys(dir.path(), "[keys]\nquit = \"f4\"\nhelp = \"nonsense\"\n");
        let mut pty = Start::default().go_in(dir);
        pty.wait_for("keys.toml:3:8");
        pty.send("\x1b");
        pty.wait_for("f4 quit");
        pty.send("q");
        pty.wait_for("`q` does nothing here");
        pty.send("\x1bOS");
        pty.ended(0);
    }

    #[test]
    fn a_newcomer_is_led_to_a_written_report() {
        let mut pty = Start {
            args: &["--tutorial"],
            ..Start::default()
        }
        .go_in(few());
        let step = |pty: &super::super::pty::Pty, title: &str| pty.wait_for(title);
        step(&pty, "Tutorial 1 of 11: Open a case");
        pty.wait_for("pendulous/manifold.toml");
        pty.send("/manifold\r\r");
        step(&pty, "Tutorial 2");
        pty.send("9");
        step(&pty, "Tutorial 3");
        pty.send("1/current speed\r");
        pty.wait_for("1 of ");
        pty.send("l");
        step(&pty, "Tutorial 4");
        // Results are held when the full solve is complete.
        pty.wait("the solve is complete", |screen| {
            let text = screen.contents();
            text.contains("± ") && !text.contains("coarse") && !text.contains("older")
        });
        pty.send("v");
        pty.wait_for("against");
        pty.send("l");
        step(&pty, "Tutorial 5");
        pty.send("4");
        step(&pty, "Tutorial 6");
        pty.send("uu");
        step(&pty, "Tutorial 7");
        pty.send("R");
        step(&pty, "Tutorial 8");
        pty.send("1l");
        pty.wait_for("*unsaved");
        pty.send("R");
        step(&pty, "Tutorial 9");
        pty.send("3Gmkm=");
        step(&pty, "Tutorial 10");
        pty.send("\x1b");
        pty.wait_for("3 Runs");
        pty.send("5");
        pty.wait_for("Report on");
        pty.send("w");
        step(&pty, "Tutorial 11 of 11: That is all");
        let report = || {
            let runs = std::fs::read_dir(pty.dir.path().join("runs")).ok()?;
            let mut files = runs.flatten().map(|run| run.path().join("report.txt"));
            files.find(|file| file.is_file())
        };
        let beside = pty.dir.path().join("manifold-report.txt");
        assert!(
            report().is_some() || beside.is_file(),
            "no report is written"
        );
    }
}
