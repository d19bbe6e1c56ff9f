//! `seacable sweep --slurm` beside programs that answer as Slurm's do, and `--part`: no cluster, no waiting. Slurm itself is in
//! `tests/real_programs`.

use std::fs::{self, Permissions};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::Duration;

use seacable::run::{RunState, store};

use crate::small::SMALL;

/// Computes the tasks at once, one after the other, as sbatch has them computed by and by, and keeps its words.
const SBATCH: &str = r#"#!/bin/sh
printf '%s|' "$@" >> "$LOG"; echo >> "$LOG"
for word in "$@"; do
    case "$word" in
        --array=*) tasks=${word#--array=};;
        --chdir=*) cd "${word#--chdir=}" || exit 1;;
    esac
    script=$word
done
for range in $(echo "$tasks" | tr , ' '); do
    for task in $(seq "${range%-*}" "${range#*-}"); do
        SLURM_ARRAY_TASK_ID=$task sh "$script" > "tasks/7_$task.log" 2>&1
    done
done
echo 7
"#;
/// An empty queue.
const EMPTY: &str = "#!/bin/sh\n";

struct Place(tempfile::TempDir);

impl Place {
    fn new(sbatch: &str, squeue: &str) -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        fs::create_dir(place.dir().join("bin")).unwrap();
        place.program("sbatch", sbatch);
        place.program("squeue", squeue);
        fs::write(place.dir().join("small.toml"), SMALL).unwrap();
        place
    }

    fn dir(&self) -> &Path {
        self.0.path()
    }

    fn program(&self, name: &str, text: &str) {
        let file = self.dir().join("bin").join(name);
        fs::write(&file, text).unwrap();
        fs::set_permissions(&file, Permissions::from_mode(0o755)).unwrap();
    }

    fn command(&self, words: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
        command.arg("sweep").args(words).current_dir(self.dir());
        let others = std::env::var("PATH").unwrap();
        let path = format!("{}:{others}", self.dir().join("bin").display());
        command.env("PATH", path).env("LOG", self.dir().join("log"));
        command.env("NO_COLOR", "1").stdin(Stdio::null());
        command
    }

    fn sweep(&self, words: &[&str]) -> (Option<i32>, String, String) {
        let Output {
            status,
            stdout,
            stderr,
        } = self.command(words).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (status.code(), text(stdout), text(stderr))
    }

    fn refused(&self, words: &[&str], why: &[&str]) {
        let (status, _, said) = self.sweep(words);
        assert_eq!(status, Some(2), "{words:?}: {said}");
        for why in why {
            assert!(said.contains(why), "{words:?}: {why}: {said}");
        }
    }

    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.dir().join(name)).unwrap()
    }

    /// The words of each call of sbatch.
    fn submissions(&self) -> Vec<String> {
        let log = fs::read_to_string(self.dir().join("log")).unwrap_or_default();
        log.lines().map(str::to_owned).collect()
    }

    fn runs(&self, sweep: &str) -> usize {
        let names = fs::read_dir(self.dir()).unwrap().flatten();
        let begins = format!("{sweep}-");
        let names = names.map(|item| item.file_name().into_string().unwrap());
        names.filter(|name| name.contains(&begins)).count()
    }
}

/// Six load cases, of which the case refuses the second.
const CASES: &str = "payload.dry_mass_kg,payload.wet_mass_kg\n500,400\n500,600\n520,400\n540,400\n560,400\n580,400\n";

#[test]
fn the_results_are_those_of_a_sweep_without_a_cluster() {
    let place = Place::new(SBATCH, EMPTY);
    fs::write(place.dir().join("cases.csv"), CASES).unwrap();
    let with = |out: &'static str| ["small.toml", "--load-cases", "cases.csv", "--out", out];
    fs::create_dir(place.dir().join("here")).unwrap();
    let (status, expected, said) = place.sweep(&[&with("here/s")[..], &["--csv"]].concat());
    assert_eq!(status, Some(1), "{said}");
    let words = [
        "--slurm",
        "--cases-per-task",
        "4",
        "--jobs",
        "2",
        "--slurm-option=--comment=it's mine",
    ];
    let (status, tables, said) = place.sweep(&[&with("s")[..], &words].concat());
    assert_eq!(status, Some(1), "{said}");
    assert!(
        tables.contains("REFUSED") && expected.contains("REFUSED"),
        "{tables}"
    );
    assert_eq!(
        place.text("s/results.csv"),
        place.text("here/s/results.csv")
    );
    assert!(said.contains("Submitted 6 of 6 load cases as Slurm's job 7: tasks 2, up to 4 load cases and 2 cores each, with '--comment="), "{said}");
    // What is refused is not submitted again.
    let [submitted] = &place.submissions()[..] else {
        panic!("{:?}", place.submissions());
    };
    assert!(
        submitted.starts_with("--comment=it's mine|--parsable|--job-name=seacable-s-"),
        "{submitted}"
    );
    assert!(submitted.contains("|--array=0-1|--chdir=/"), "{submitted}");
    let script = place.text("s/array.sh");
    assert!(
        script.contains("--cpus-per-task=2\n") && script.contains("'--comment=it'\\''s mine'"),
        "{script}"
    );
    assert!(!place.dir().join("s/tasks").exists());
    // It is done: nothing is asked of Slurm to go on without it.
    place.program("squeue", "#!/bin/sh\nexit 1\n");
    let (status, _, said) = place.sweep(&["--resume", "s"]);
    assert_eq!(status, Some(1), "{said}");
    assert_eq!(
        place.text("s/results.csv"),
        place.text("here/s/results.csv")
    );
}

#[test]
fn a_part_computes_its_load_cases_and_no_results() {
    let place = Place::new(SBATCH, EMPTY);
    let vary = ["--vary", "payload.drag_area_m2=0.5..2/4"];
    let (status, _, said) = place.sweep(&[&["small.toml", "--out", "whole"], &vary[..]].concat());
    assert_eq!(status, Some(0), "{said}");
    // A sweep that was stopped before its first run.
    fs::create_dir(place.dir().join("s")).unwrap();
    for name in ["case.toml", "load_cases.csv", "sweep.toml"] {
        fs::copy(
            place.dir().join("whole").join(name),
            place.dir().join("s").join(name),
        )
        .unwrap();
    }
    let part = |range: &'static str| place.sweep(&["--resume", "s", "--part", range]);
    let (status, line, said) = part("2..3");
    assert_eq!(
        (status, line.as_str()),
        (Some(0), "Load cases 2 to 3 of 4: 2 computed.\n"),
        "{said}"
    );
    assert!(place.dir().join("s-0002/run.toml").exists() && !place.dir().join("s-0001").exists());
    assert!(!place.dir().join("s/results.csv").exists());
    let (status, line, _) = part("1..9");
    assert_eq!(
        (status, line.as_str()),
        (
            Some(0),
            "Load cases 1 to 4 of 4: 2 computed, 2 stored before.\n"
        )
    );
    let run = store::read(&place.dir().join("s-0003")).unwrap();
    assert_eq!(
        (run.info.state, run.info.id.as_str()),
        (RunState::Done, "s-0003")
    );
    place.refused(
        &["--resume", "s", "--part", "5..6"],
        &["no load case 5: the sweep has 4"],
    );
    place.refused(&["--resume", "s", "--part", "0..6"], &["1..250"]);
    place.refused(&["small.toml", "--part", "1..2"], &["--resume"]);
    let (status, _, said) = place.sweep(&["--resume", "s"]);
    assert_eq!(status, Some(0), "{said}");
    assert_eq!(
        place.text("s/results.csv"),
        place.text("whole/results.csv").replace("whole-", "s-")
    );
}

#[test]
fn parts_of_the_same_load_cases_store_each_once_and_a_killed_one_stores_nothing() {
    let place = Place::new("#!/bin/sh\necho 7\n", EMPTY);
    let words = [
        "small.toml",
        "--vary",
        "payload.drag_area_m2=0.5..2/12",
        "--set",
        "solver.step_tolerance=1e-7",
        "--out",
        "s",
        "--slurm",
    ];
    // Nothing comes of the arrays.
    place.refused(
        &words,
        &[
            "After 3 arrays 12 of 12 load cases have no run: 1-12.",
            "/s --slurm`",
            "--cases-per-task 1",
        ],
    );
    let spawn = |range: &str| {
        let mut command = place.command(&["--resume", "s", "--jobs", "1", "--part", range]);
        command
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    };
    let mut killed = spawn("1..12");
    thread::sleep(Duration::from_millis(400));
    killed.kill().unwrap();
    killed.wait().unwrap();
    for number in 1..=12 {
        let info = store::read_info(&place.dir().join(format!("s-{number:04}")));
        assert!(info.map_or(true, |info| info.state == RunState::Done));
    }
    let parts = ["1..12", "1..12", "4..9"].map(spawn);
    let lines =
        parts.map(|part| String::from_utf8(part.wait_with_output().unwrap().stdout).unwrap());
    let count = |line: &String| {
        let words = line.split(": ").nth(1).unwrap();
        words.split(' ').next().unwrap().parse::<usize>().unwrap()
    };
    assert!(lines.iter().map(count).sum::<usize>() <= 12, "{lines:?}");
    assert_eq!(place.runs("s"), 12);
    // What the killed one left goes with the end.
    let (status, _, said) = place.sweep(&["--resume", "s", "--slurm"]);
    assert_eq!(status, Some(0), "{said}");
    assert_eq!(place.runs("s"), 12);
    assert!(!place.dir().join("s/tasks").exists());
}

#[test]
fn what_is_missing_is_submitted_again_and_what_failed_is_not() {
    let place = Place::new(SBATCH, EMPTY);
    let vary = ["--vary", "payload.drag_area_m2=0.5..2/6"];
    let (status, _, said) =
        place.sweep(&[&["small.toml", "--slurm", "--out", "s"], &vary[..]].concat());
    assert_eq!(status, Some(0), "{said}");
    let results = place.text("s/results.csv");
    let failed = place.dir().join("s-0005/run.toml");
    let text = fs::read_to_string(&failed).unwrap();
    fs::write(
        &failed,
        text.replace(
            "state = \"done\"",
            "state = \"failed\"\nfailure = \"it diverged\"",
        ),
    )
    .unwrap();
    for lost in ["s-0002", "s-0003", "s-0006"] {
        fs::remove_dir_all(place.dir().join(lost)).unwrap();
    }
    let (status, _, said) = place.sweep(&["--resume", "s", "--slurm"]);
    assert_eq!(status, Some(1), "{said}");
    assert!(
        said.contains("Job 7 has left the queue. Submitted 3 of 6 load cases"),
        "{said}"
    );
    let submissions = place.submissions();
    assert!(
        submissions.len() == 2 && submissions[1].contains("|--array=1-2,5|"),
        "{submissions:?}"
    );
    let (rows, before) = (place.text("s/results.csv"), results);
    for (number, (row, before)) in rows.lines().zip(before.lines()).enumerate() {
        assert_eq!(row == before, number != 5, "{row}");
    }
    assert!(rows.contains("FAILED,it diverged"), "{rows}");
}

#[test]
fn while_an_array_is_in_the_queue_nothing_is_computed_here() {
    let place = Place::new("#!/bin/sh\necho 7\n", EMPTY);
    let vary = ["--vary", "payload.drag_area_m2=0.5..2/6"];
    place.refused(
        &[&["small.toml", "--slurm", "--out", "s"], &vary[..]].concat(),
        &["After 3 arrays"],
    );
    place.program(
        "squeue",
        "#!/bin/sh\necho 7 0 RUNNING x\necho 7 1 PENDING x\necho 9 0 RUNNING other\n",
    );
    let why = [
        "Slurm's job 7 (1 task running, 1 waiting)",
        "`scancel 7`",
        "--resume s --slurm",
    ];
    place.refused(&["--resume", "s"], &why);
    place.refused(
        &["--resume", "s", "--slurm", "--cases-per-task", "3"],
        &["goes on as it was submitted"],
    );
    // A signal ends the watching alone.
    let mut watching = place.command(&["--resume", "s", "--slurm"]);
    let watching = watching
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    thread::sleep(Duration::from_millis(500));
    let id = rustix::process::Pid::from_child(&watching);
    rustix::process::kill_process(id, rustix::process::Signal::INT).unwrap();
    let done = watching.wait_with_output().unwrap();
    let said = String::from_utf8(done.stderr).unwrap();
    assert_eq!(done.status.code(), Some(130), "{said}");
    assert!(
        said.contains("Found Slurm's job 7") && said.contains("Slurm's job 7 goes on"),
        "{said}"
    );
    place.program(
        "squeue",
        "#!/bin/sh\necho cannot reach the controller >&2\nexit 1\n",
    );
    let why = [
        "is not known: `squeue --noheader",
        "cannot reach the controller",
        "remove s/slurm.toml",
    ];
    place.refused(&["--resume", "s"], &why);
    place.refused(
        &["--resume", "s", "--slurm"],
        &["cannot reach the controller"],
    );
    place.program("squeue", EMPTY);
    let (status, _, said) = place.sweep(&["--resume", "s"]);
    assert_eq!(status, Some(0), "{said}");
    let record = place.text("s/slurm.toml");
    fs::write(place.dir().join("s/slurm.toml"), record + "mine = 1\n").unwrap();
    place.refused(
        &["--resume", "s"],
        &["slurm.toml cannot be used", "mine", "remove the file"],
    );
}

#[test]
fn what_cannot_be_submitted_is_said_and_nothing_is_lost() {
    let place = Place::new(
        "#!/bin/sh\necho 'sbatch: error: invalid partition specified: lang' >&2\nexit 1\n",
        EMPTY,
    );
    let vary = ["--vary", "payload.drag_area_m2=0.5..2/4"];
    let with = |out: &'static str| [&["small.toml", "--slurm", "--out", out], &vary[..]].concat();
    place.refused(
        &[&with("s")[..], &["--slurm-option=--partition=lang"]].concat(),
        &[
            "`sbatch --partition=lang --parsable",
            "invalid partition specified: lang",
            "Nothing is lost",
        ],
    );
    place.refused(
        &[&with("t")[..], &["--slurm-option=-p lang"]].concat(),
        &["--partition=long"],
    );
    place.refused(
        &[&with("t")[..], &["--slurm-option=--a\n#SBATCH"]].concat(),
        &["such as line feeds"],
    );
    place.refused(
        &[&with("t")[..], &["--cases-per-task", "0"]].concat(),
        &["1 or more"],
    );
    place.refused(&[&with("a\nb")[..]].concat(), &["such as line feeds"]);
    assert!(!place.dir().join("t").exists());
    place.program("sbatch", "#!/bin/sh\necho Submitted\n");
    place.refused(
        &["--resume", "s", "--slurm"],
        &["answered `Submitted`, where the number of a job was expected"],
    );
    place.program("sbatch", SBATCH);
    let (status, _, said) = place.sweep(&[
        "--resume",
        "s",
        "--slurm",
        "--slurm-option=--partition=long",
    ]);
    assert_eq!(status, Some(0), "{said}");
    assert!(place.submissions()[0].starts_with("--partition=long|"));
    // On a machine without Slurm.
    let without = |words: &[&str]| {
        let mut command = place.command(words);
        let done = command.env("PATH", "/nonexistent").output().unwrap();
        (done.status.code(), String::from_utf8(done.stderr).unwrap())
    };
    let (status, said) = without(&with("u"));
    assert_eq!(status, Some(2), "{said}");
    assert!(
        said.contains("`sbatch --parsable")
            && said.contains("cannot be run")
            && said.contains("PATH"),
        "{said}"
    );
    let (status, said) = without(&["--resume", "u"]);
    assert_eq!(status, Some(0), "{said}");
    let words = [
        "oc3.toml",
        "--vary",
        "materials.chain.diameter_m=0.08,0.1",
        "--slurm",
    ];
    fs::write(
        place.dir().join("oc3.toml"),
        include_str!("../../cases/systems/oc3_spar.toml"),
    )
    .unwrap();
    place.refused(&words, &["computed at rest", "Leave out --slurm"]);
}
