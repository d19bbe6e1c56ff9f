//! A sweep as a job array of a real Slurm, of which a node dies and comes back, and whose watching program is killed.
//!
//! Needs `munged` (Debian's package munge), and `slurmctld`, `slurmd`, `sbatch`, `squeue` and `sinfo` (slurm-wlm), built to run several
//! nodes on a machine, as Debian's are; no service, no superuser, and nothing but the loopback. Takes about a minute on two cores.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use seacable::run::{RunState, store};

use crate::slurm_servers::Slurm;
use crate::small::SMALL;
use crate::work::{search_path, until};

/// Far beyond what the sweep takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(300);

/// 200 load cases, each of a fifth of a second.
const SWEEP: [&str; 11] = [
    "sweep",
    "small.toml",
    "--vary",
    "payload.drag_area_m2=0.5..2/20",
    "--vary",
    "payload.added_mass_kg=50..500/10",
    "--set",
    "solver.step_tolerance=1e-9",
    "--set",
    "solver.duration_s=60",
    "--out",
];

/// Ends a program that a failed test leaves.
struct Program(Child);

impl Drop for Program {
    fn drop(&mut self) {
        drop(self.0.kill());
        drop(self.0.wait());
    }
}

impl Program {
    /// Waits for its end.
    fn ended(&mut self) -> ExitStatus {
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(status) = self.0.try_wait().unwrap() {
                return status;
            }
            assert!(Instant::now() < end, "the sweep does not end");
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

fn program(dir: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command.args(words).current_dir(dir).env("NO_COLOR", "1");
    command.env("PATH", search_path()).stdin(Stdio::null());
    command
}

/// The program with what it says kept in a file.
fn watching(dir: &Path, slurm: &Slurm, said: &str, words: &[&str]) -> Program {
    let file = |name: &str| File::create(dir.join(name)).unwrap();
    let mut command = program(dir, words);
    command.env("SLURM_CONF", slurm.settings_file());
    command.stdout(file("tables")).stderr(file(said));
    Program(command.spawn().unwrap())
}

fn text(dir: &Path, name: &str) -> String {
    fs::read_to_string(dir.join(name)).unwrap_or_default()
}

/// All names beside the folder of a sweep that begin with its name, hidden ones too.
fn names(dir: &Path, sweep: &str) -> BTreeSet<String> {
    let all = fs::read_dir(dir).unwrap().flatten();
    let all = all.map(|item| item.file_name().into_string().unwrap());
    all.filter(|name| name.trim_start_matches('.').starts_with(sweep))
        .collect()
}

#[test]
#[ignore = "left out: needs Slurm; .ci/run runs it"]
fn a_sweep_on_a_cluster_outlives_a_node_and_its_watcher() {
    let place = tempfile::tempdir().unwrap();
    // Names that a shell would take apart.
    let dir = &place.path().join("it's a \"folder\" of $HOME");
    fs::create_dir(dir).unwrap();
    fs::write(dir.join("small.toml"), SMALL).unwrap();
    let mut slurm = Slurm::start(place.path());

    let begin = [&SWEEP[..], &["s", "--slurm", "--cases-per-task", "20"]].concat();
    let mut first = watching(dir, &slurm, "said-1", &begin);
    until("some runs", || names(dir, "s-").len() > 10);
    first.0.kill().unwrap();
    first.0.wait().unwrap();
    let said = text(dir, "said-1");
    assert!(
        said.contains("Submitted 200 of 200 load cases as Slurm's job "),
        "{said}"
    );
    assert!(
        said.contains("tasks 10, up to 20 load cases and 1 core each"),
        "{said}"
    );

    // The array goes on, and nobody computes the same here.
    let mut here = program(dir, &["sweep", "--resume", "s"]);
    let here = here
        .env("SLURM_CONF", slurm.settings_file())
        .output()
        .unwrap();
    let said = String::from_utf8(here.stderr).unwrap();
    assert_eq!(here.status.code(), Some(2), "{said}");
    assert!(
        said.contains("is being computed by Slurm's job") && said.contains("scancel"),
        "{said}"
    );

    let mut second = watching(
        dir,
        &slurm,
        "said-2",
        &["sweep", "--resume", "s", "--slurm"],
    );
    until("the array to be found", || {
        text(dir, "said-2").contains("Found Slurm's job")
    });
    until("work on the second node", || slurm.is_at_work(2));
    slurm.kill_node(2);
    until("its end", || !slurm.is_at_work(2));
    std::thread::sleep(Duration::from_secs(1));
    slurm.start_node(2);
    let status = second.ended();
    let said = text(dir, "said-2");
    assert_eq!(status.code(), Some(0), "{said}");
    assert!(said.contains("has left the queue"), "{said}");

    // Each run once, done, and nothing else.
    let expected: BTreeSet<String> = (1..=200).map(|number| format!("s-{number:04}")).collect();
    assert_eq!(names(dir, "s-"), expected);
    for name in &expected {
        let info = store::read_info(&dir.join(name)).unwrap();
        assert_eq!((info.state, &info.id), (RunState::Done, name));
    }
    let left: BTreeSet<String> = names(&dir.join("s"), "");
    let files = [
        "array.sh",
        "case.toml",
        "checks.csv",
        "load_cases.csv",
        "report.txt",
        "results.csv",
        "seas.csv",
        "slurm.toml",
        "sweep.toml",
    ];
    assert_eq!(left, files.map(str::to_owned).into());
    let record = text(dir, "s/slurm.toml");
    assert!(record.matches("[[submissions]]").count() > 1, "{record}");
    assert!(record.contains("gathered = true"), "{record}");

    // The same as here, to the byte: the sweep has the same name in another place.
    let other = &place.path().join("here");
    fs::create_dir(other).unwrap();
    fs::write(other.join("small.toml"), SMALL).unwrap();
    let local = [&SWEEP[..], &["s"]].concat();
    let done = program(other, &local).output().unwrap();
    assert_eq!(
        done.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&done.stderr)
    );
    let results = fs::read(other.join("s/results.csv")).unwrap();
    assert!(!results.is_empty() && results == fs::read(dir.join("s/results.csv")).unwrap());
}
