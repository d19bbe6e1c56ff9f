//! `seacable sweep`: load cases from tables, files and options; the same results whatever the threads, kills and resumes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

use seacable::run::{RunState, store};

use crate::chance::{Chance, asked, seed};
use crate::kills::RESULTS;
use crate::small::SMALL;

const BRIDLE: &str = include_str!("../../cases/systems/bridle_in_heave.toml");
const OC3: &str = include_str!("../../cases/systems/oc3_spar.toml");

/// Tables of load cases of the small case: 2 times 3.
const TABLES: &str = r#"
[[load_cases]]
key = "solver.duration_s"
values = [4.0, 6.0]
probability = [0.25, 0.75]

[[load_cases]]
file = "bodies.csv"
"#;
const BODIES: &str = "payload.dry_mass_kg,payload.wet_mass_kg\n500,400\n600,500\n700 kg,0.6 t\n";

struct Place(tempfile::TempDir);

impl Place {
    fn new() -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        place.put("small.toml", &format!("{SMALL}{TABLES}"));
        place.put("bodies.csv", BODIES);
        place
    }

    fn dir(&self) -> &Path {
        self.0.path()
    }

    fn put(&self, name: &str, text: &str) {
        fs::write(self.dir().join(name), text).unwrap();
    }

    fn command(&self, words: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
        command.arg("sweep").args(words).current_dir(self.dir());
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

    fn results(&self, sweep: &str) -> String {
        fs::read_to_string(self.dir().join(sweep).join("results.csv")).unwrap()
    }

    /// The runs of a sweep by number, with the files that do not depend on when they were computed.
    fn runs(&self, sweep: &str) -> BTreeMap<String, Vec<Option<Vec<u8>>>> {
        let mut runs = BTreeMap::new();
        for entry in fs::read_dir(self.dir()).unwrap() {
            let path: PathBuf = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if let Some(number) = name.strip_prefix(&format!("{sweep}-")) {
                let files = RESULTS.iter().map(|file| fs::read(path.join(file)).ok());
                runs.insert(number.to_owned(), files.collect());
            }
        }
        runs
    }
}

/// The table of results without the names of the runs, which begin with that of the sweep.
fn without_runs(csv: &str) -> Vec<String> {
    let cut = |line: &str| line.rsplit_once(',').unwrap().0.to_owned();
    csv.lines().map(cut).collect()
}

#[test]
fn load_cases_are_the_combinations_of_tables_files_and_options() {
    let place = Place::new();
    place.put(
        "speeds.csv",
        "payload.drag_area_m2, occurrences\n1.0, 9\n2.0, 1\n",
    );
    let words = [
        "small.toml",
        "--load-cases",
        "speeds.csv",
        "--vary",
        "payload.added_mass_kg=100,200",
        "--out",
        "s",
        "--ascii",
    ];
    let (status, text, said) = place.sweep(&words);
    assert_eq!(status, Some(0), "{said}");
    for word in ["24", "tension_n.max", "probability", "The sweep is s;"] {
        assert!(text.contains(word), "{word}: {text}");
    }
    let csv = place.results("s");
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 25);
    assert_eq!(
        rows[0][..3],
        ["point", "solver.duration_s [s]", "payload.dry_mass_kg [kg]"]
    );
    let column = |name: &str| rows[0].iter().position(|head| *head == name).unwrap();
    let probability = column("probability");
    let sum: f64 = rows[1..]
        .iter()
        .map(|row| row[probability].parse::<f64>().unwrap())
        .sum();
    assert!((sum - 1.0).abs() < 1e-12, "{sum}");
    // 0.25 of a third of 0.9, shared by two.
    let first: f64 = rows[1][probability].parse().unwrap();
    assert!((first - 0.25 / 3.0 * 0.9 / 2.0).abs() < 1e-12, "{first}");
    assert_eq!(rows[24][1..6], ["6", "700", "600", "2", "200"]);
    assert!(rows[24].last().unwrap().ends_with("s-0024"));
    // Each is a run of its own, of a case without load cases.
    let dir = place.dir().join("s-0024");
    let run = store::read(&dir).unwrap();
    assert_eq!(run.info.state, RunState::Done);
    assert!(!run.case_text.contains("load_cases"), "{}", run.case_text);
    assert!(
        run.info
            .overrides
            .contains(&"payload.wet_mass_kg=600".to_owned()),
        "{:?}",
        run.info.overrides
    );
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let place = Place::new();
    for (jobs, out) in [("1", "one"), ("2", "two"), ("7", "seven")] {
        let (status, _, said) = place.sweep(&["small.toml", "--jobs", jobs, "--out", out]);
        assert_eq!(status, Some(0), "{said}");
    }
    let one = without_runs(&place.results("one"));
    for other in ["two", "seven"] {
        assert_eq!(one, without_runs(&place.results(other)));
        assert_eq!(place.runs("one"), place.runs(other));
    }
}

#[test]
fn a_killed_sweep_goes_on_and_ends_with_the_same_bytes() {
    let place = Place::new();
    fn with(out: &str) -> [&str; 5] {
        [
            "small.toml",
            "--set",
            "solver.step_tolerance=1e-7",
            "--out",
            out,
        ]
    }
    let begun = Instant::now();
    let (status, _, said) = place.sweep(&with("whole"));
    assert_eq!(status, Some(0), "{said}");
    let whole = begun.elapsed();
    let expected = without_runs(&place.results("whole"));
    let mut chance = Chance::new(seed());
    let (mut killed, mut kept) = (0, 0);
    for number in 0..asked("SEACABLE_KILLS", 6) {
        let name = format!("killed-{number}");
        let mut child = place
            .command(&with(&name))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        thread::sleep(whole.mul_f64(1.05 * chance.share()));
        child.kill().unwrap();
        child.wait().unwrap();
        let dir = place.dir().join(&name);
        if !dir.join("sweep.toml").exists() {
            continue;
        }
        killed += 1;
        kept += place.runs(&name).len();
        // Killed once more on its way.
        let resume = ["--resume", &name];
        let mut child = place
            .command(&resume)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        thread::sleep(whole.mul_f64(0.5 * chance.share()));
        let _ = child.kill();
        child.wait().unwrap();
        let (status, _, said) = place.sweep(&resume);
        assert_eq!(status, Some(0), "{said}");
        assert_eq!(without_runs(&place.results(&name)), expected, "{name}");
        assert_eq!(place.runs(&name), place.runs("whole"), "{name}");
    }
    println!("{killed} sweeps killed under way, {kept} of their runs begun");
    // What they left half written goes with the next sweep, once it is old.
    let strays = || {
        let entries = fs::read_dir(place.dir()).unwrap().flatten();
        let hidden = entries.filter(|entry| entry.file_name().to_string_lossy().starts_with('.'));
        hidden.map(|entry| entry.path()).collect::<Vec<PathBuf>>()
    };
    for left in strays() {
        let old = SystemTime::now() - Duration::from_secs(120);
        fs::File::open(&left).unwrap().set_modified(old).unwrap();
    }
    assert_eq!(place.sweep(&with("last")).0, Some(0));
    assert_eq!(strays(), Vec::<PathBuf>::new());
}

#[test]
fn a_finished_sweep_computes_nothing_again() {
    let place = Place::new();
    let (status, _, said) = place.sweep(&["small.toml", "--out", "s"]);
    assert_eq!(status, Some(0), "{said}");
    let (results, run) = (place.results("s"), place.dir().join("s-0003/run.toml"));
    let written = fs::metadata(&run).unwrap().modified().unwrap();
    thread::sleep(Duration::from_millis(20));
    let (status, text, said) = place.sweep(&["--resume", "s"]);
    assert_eq!(status, Some(0), "{said}");
    assert!(text.contains("Extremes"), "{text}");
    assert_eq!(place.results("s"), results);
    assert_eq!(fs::metadata(&run).unwrap().modified().unwrap(), written);
    // One that is lost is computed again, to the same bytes.
    fs::remove_dir_all(place.dir().join("s-0003")).unwrap();
    let (status, _, said) = place.sweep(&["--resume", "s"]);
    assert_eq!(status, Some(0), "{said}");
    assert_eq!(place.results("s"), results);
}

#[test]
fn a_load_case_that_fails_does_not_end_the_others() {
    let place = Place::new();
    let words = [
        "small.toml",
        "--vary",
        "payload.drag_area_m2=1,2",
        "--set",
        "output.interval_s=1",
        "--out",
        "s",
    ];
    place.put(
        "bodies.csv",
        "payload.dry_mass_kg,payload.wet_mass_kg\n500,400\n500,600\n",
    );
    let (status, text, said) = place.sweep(&words);
    assert_eq!(status, Some(1), "{said}");
    assert!(
        text.contains("REFUSED") && text.contains("payload.wet_mass_kg"),
        "{text}"
    );
    let csv = place.results("s");
    assert_eq!(
        csv.lines().filter(|line| line.contains(",OK,")).count(),
        4,
        "{csv}"
    );
    assert_eq!(
        csv.lines().filter(|line| line.contains("REFUSED")).count(),
        4,
        "{csv}"
    );
}

#[test]
fn systems_are_computed_in_time_or_at_rest_and_lines_are_lost() {
    let place = Place::new();
    let short = BRIDLE.replace("duration_s = 60.0", "duration_s = 4.0");
    assert_ne!(short, BRIDLE);
    place.put("bridle.toml", &short);
    let words = [
        "bridle.toml",
        "--vary",
        "damage.lost_line=none,left",
        "--set",
        "solver.error_estimate=false",
        "--result",
        "tension_n[right|b].max",
        "--out",
        "s",
    ];
    place.put("bridle.toml", &format!("{short}\n[damage]\n"));
    let (status, text, said) = place.sweep(&words);
    assert_eq!(status, Some(0), "{said}");
    let runs =
        [1, 2].map(|number| store::read(&place.dir().join(format!("s-000{number}"))).unwrap());
    let lines = runs.each_ref().map(|run| {
        run.summary
            .iter()
            .filter(|quantity| quantity.id.to_string().starts_with("tension_n[left|a]."))
            .count()
    });
    assert_eq!(lines, [4, 0], "{text}");
    // A sweep is found from within too.
    let before = place.results("s");
    let mut command = place.command(&["--resume", "."]);
    command.current_dir(place.dir().join("s"));
    assert_eq!(command.output().unwrap().status.code(), Some(0));
    assert_eq!(place.results("s"), before);
    // At rest nothing is stored but the table.
    place.put("oc3.toml", OC3);
    let (status, text, said) = place.sweep(&[
        "oc3.toml",
        "--vary",
        "materials.chain.diameter_m=0.08,0.1",
        "--out",
        "r",
    ]);
    assert_eq!(status, Some(0), "{said}");
    assert!(text.contains("tension_n[mooring|b]"), "{text}");
    assert_eq!(place.results("r").lines().count(), 3);
    assert!(place.runs("r").is_empty());
    let before = place.results("r");
    assert_eq!(place.sweep(&["--resume", "r"]).0, Some(0));
    assert_eq!(place.results("r"), before);
}

#[test]
fn a_line_that_is_lost_must_be_one() {
    let place = Place::new();
    place.put(
        "oc3.toml",
        &format!("{OC3}\n[damage]\nlost_line = \"moring@120\"\n"),
    );
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    let done = command
        .args(["run", "oc3.toml"])
        .current_dir(place.dir())
        .output()
        .unwrap();
    let said = String::from_utf8(done.stderr).unwrap();
    assert_eq!(done.status.code(), Some(2));
    assert!(
        said.contains("damage.lost_line") && said.contains("did you mean `mooring@120`?"),
        "{said}"
    );
}

#[test]
fn what_cannot_be_swept_or_resumed_is_said() {
    let place = Place::new();
    place.put("plain.toml", SMALL);
    let (status, _, said) = place.sweep(&["small.toml", "--out", "s"]);
    assert_eq!(status, Some(0), "{said}");
    let refused = |words: &[&str], why: &str| {
        let (status, _, said) = place.sweep(words);
        assert_eq!(status, Some(2), "{words:?}: {said}");
        assert!(said.contains(why), "{words:?}: {said}");
    };
    refused(&["plain.toml"], "There are no load cases");
    refused(&["small.toml", "--out", "s"], "exists already");
    refused(&["--resume", "nowhere"], "holds no sweep");
    refused(&["small.toml", "--resume", "s"], "cannot be used with");
    refused(
        &["small.toml", "--vary", "payload.dry_mas_kg=1,2"],
        "did you mean `dry_mass_kg`?",
    );
    refused(
        &["small.toml", "--vary", "solver.duration_s=1,2"],
        "is set by two tables",
    );
    refused(&["small.toml", "--result", "tension_n.mx"], "--result: ");
    refused(&["small.toml", "--load-cases", "none.csv"], "none.csv");
    refused(&["small.toml", "--limit-points", "5"], "`--limit-points 6`");
    // A run that is not the sweep's is neither read for one of it nor deleted.
    fs::remove_dir_all(place.dir().join("s-0002")).unwrap();
    fs::rename(place.dir().join("s-0001"), place.dir().join("s-0002")).unwrap();
    let (status, text, _) = place.sweep(&["--resume", "s"]);
    assert_eq!(status, Some(1), "{text}");
    assert!(text.contains("s-0002 is another run"), "{text}");
    assert!(
        place.dir().join("s-0002/run.toml").exists()
            && place.dir().join("s-0001/run.toml").exists()
    );
    let case = place.dir().join("s/case.toml");
    fs::write(&case, fs::read_to_string(&case).unwrap() + "\n# mine\n").unwrap();
    refused(&["--resume", "s"], "was changed since the sweep began");
}
