//! Water in files of MoorDyn: currents over time and place, and waves by a history of their elevation.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;
use std::sync::atomic::AtomicBool;

use seacable::case::{Diagnostic, kind};
use seacable::import::{self, ImportOptions};
use seacable::system::motion::run::{MotionRun, run};
use seacable::system::{SolvedSystem, SystemFile};

use crate::current_file::end_tensions;
use crate::motion::channel;

/// A chain that hangs from a fixed point, with a free end, in a water that options name.
fn hanging(options: &str) -> String {
    format!(
        "\
--------------------- MoorDyn Input File ------------------------------------
A hanging chain
----------------------- LINE TYPES ------------------------------------------
TypeName   Diam    Mass/m     EA         BA/-zeta    EI         Cd     Ca     CdAx    CaAx
(name)     (m)     (kg/m)     (N)        (N-s/-)     (N-m^2)    (-)    (-)    (-)     (-)
chain      0.0133  1.1        7.51E6     -0.5        0          2.4    1.0    0.1     0.0
---------------------- POINTS -----------------------------------------------
ID    Type      X       Y       Z       Mass   Volume  CdA    Ca
(#)   (-)       (m)     (m)     (m)     (kg)   (m^3)   (m^2)  (-)
1     Fixed     18      5       -10     0      0       0      0
2     Free      18      5       -40     10     0       0.1    0
---------------------- LINES ------------------------------------------------
ID   LineType   AttachA  AttachB  UnstrLen  NumSegs  LineOutputs
(#)   (name)     (#)      (#)       (m)       (-)     (-)
1     chain      1        2         30        20      -
---------------------- OPTIONS ----------------------------------------------
0.001         dtM           time step
400           WtrDpth       water depth (m)
{options}
------------------------- need this line ------------------------------------
"
    )
}

/// A folder with these files, and the file of MoorDyn that names them.
struct Folder {
    dir: tempfile::TempDir,
    text: String,
}

impl Folder {
    fn of(options: &str, files: &[(&str, &str)]) -> Self {
        let dir = tempfile::tempdir().unwrap();
        for (name, text) in files {
            fs::write(dir.path().join(name), text).unwrap();
        }
        let text = hanging(options);
        fs::write(dir.path().join("hanging.txt"), &text).unwrap();
        Self { dir, text }
    }

    fn path(&self) -> std::path::PathBuf {
        self.dir.path().join("hanging.txt")
    }

    fn case(&self) -> String {
        let path = self.path();
        let imported = import::read(
            &self.text,
            path.to_str().unwrap(),
            &ImportOptions::default(),
        );
        imported.unwrap_or_else(|all| panic!("{all:#?}")).text
    }

    fn solved(&self) -> SolvedSystem {
        let found = seacable::open::load_as::<SystemFile>(&self.path(), &ImportOptions::default());
        found.unwrap_or_else(|all| panic!("{all:#?}")).computed
    }

    #[track_caller]
    fn assert_fault(&self, row: &str, problem: &str) {
        let found: Vec<Diagnostic> =
            seacable::open::load_as::<SystemFile>(&self.path(), &ImportOptions::default())
                .unwrap_err();
        let wanted = self
            .text
            .lines()
            .position(|line| line.contains(row))
            .unwrap()
            + 1;
        assert_eq!(found[0].line as usize, wanted, "{found:#?}");
        assert!(found[0].problem.contains(problem), "{found:#?}");
    }
}

/// The text of a case in motion.
fn in_motion(case: &str, duration: f64) -> String {
    format!(
        "{case}\n[solver]\nduration_s = {duration:?}\ntime_step_s = 0.05\nerror_estimate = false\n[output]\ninterval_s = 0.25\n"
    )
}

fn parsed(text: &str) -> SolvedSystem {
    kind::parse::<SystemFile>(text, "case.toml").unwrap_or_else(|all| panic!("{text}\n{all:#?}"))
}

fn moved(text: &str) -> MotionRun {
    let system = parsed(text);
    let given = system.file.solver.clone().unwrap();
    let found = run(&system, &given, &AtomicBool::new(false), &mut |_| {}).unwrap();
    assert_eq!(found.failure, None);
    found
}

const DYNAMIC: &str = "title\ntitle\n\n\n-40 -25 -10\n\n0 0.3 0.4 0.5 0.1 0.1 0.1\n5 0.3 0.4 0.5 0.1 0.1 0.1\n10 0.9 1.0 1.1 0.1 0.2 0.3\n";
const PROFILE: &str = "title\ntitle\nz ux uy uz\n-40 0.3 0.1 0\n-25 0.4 0.1 0\n-10 0.5 0.1 0\n";

/// The profile at every corner of a grid, and the same twice as fast at 20 s.
fn grid() -> String {
    let mut text = "2 2 3 2\n0 40\n-10 10\n-40 -25 -10\n0 20\n".to_owned();
    for x in [0, 40] {
        for y in [-10, 10] {
            for (z, u) in [(-40, 0.3), (-25, 0.4), (-10, 0.5)] {
                for (t, times) in [(0, 1.0), (20, 2.0)] {
                    writeln!(text, "{x} {y} {z} {t} {:?} {:?} 0", u * times, 0.1 * times).unwrap();
                }
            }
        }
    }
    text
}

#[test]
fn currents_over_time_and_place_are_those_of_the_profile_at_rest() {
    let profile = Folder::of("1 Currents", &[("current_profile.txt", PROFILE)]);
    let dynamic = Folder::of("2 Currents", &[("current_profile_dynamic.txt", DYNAMIC)]);
    let over_grid = Folder::of("5 Currents", &[("current_profile_4d.txt", &grid())]);
    let wanted = end_tensions(&profile.solved());
    for folder in [&dynamic, &over_grid] {
        let found = end_tensions(&folder.solved());
        for (found, wanted) in found.iter().zip(&wanted) {
            assert!((found / wanted - 1.0).abs() < 1e-9, "{found} for {wanted}");
        }
        // The file and its case are the same system, bit for bit.
        assert_eq!(end_tensions(&parsed(&folder.case())), found);
        assert!(folder.case().contains("constant beyond"));
    }
    // While the current is the same, so is the motion.
    let steady = moved(&in_motion(&profile.case(), 5.0));
    let varying = moved(&in_motion(&dynamic.case(), 15.0));
    let end = "x_m[p2]";
    let (steady, varying) = (channel(&steady, end), channel(&varying, end));
    for (a, b) in steady.iter().zip(varying) {
        assert!((a - b).abs() < 1e-8, "{a} {b}");
    }
    let (before, after) = (varying[20], varying[varying.len() - 1]);
    assert!(after - before > 2.0, "{before} {after}");
}

/// The elevation of two waves whose periods fit into the record.
fn height(t: f64) -> f64 {
    0.8 * (TAU / 10.0 * t + 0.4).cos() + 0.3 * (TAU / 4.0 * t - 1.0).cos()
}

fn history() -> String {
    (0..=200).fold(String::new(), |mut text, k| {
        let t = 0.1 * f64::from(k);
        writeln!(text, "{t:?} {:?}", height(t)).unwrap();
        text
    })
}

#[test]
fn a_history_of_elevation_is_the_height_of_the_waves() {
    let text = history();
    let folder = Folder::of("3 WaveKin\n0.1 dtWave", &[("wave_elevation.txt", &text)]);
    let case = folder.case();
    assert!(case.contains("kind = \"components\""), "{case}");
    let run = moved(&in_motion(&case, 15.0));
    let heights = channel(&run, "wave_elevation_m[gauge]");
    for (t, found) in run.history.time.iter().zip(heights) {
        assert!((found - height(*t)).abs() < 1e-6 * 2.2, "{t} s: {found}");
    }
    let again = moved(&in_motion(&case, 15.0));
    assert_eq!(channel(&again, "wave_elevation_m[gauge]"), heights);
    assert_eq!(end_tensions(&parsed(&case)), end_tensions(&folder.solved()));
}

#[test]
fn faults_of_the_water_are_shown_where_it_is_named() {
    let currents = |text: &str| Folder::of("2 Currents", &[("current_profile_dynamic.txt", text)]);
    currents(&DYNAMIC.replace("0.3 0.4 0.5", "0.3 none 0.5")).assert_fault(
        "2 Currents",
        "line 7 of current_profile_dynamic.txt: `none` is not a number",
    );
    currents(&DYNAMIC.replace("\n10 ", "\n5 ")).assert_fault(
        "2 Currents",
        "line 9 of current_profile_dynamic.txt: the times do not rise",
    );
    currents(&DYNAMIC.replace("10 0.9 1.0 1.1 0.1 0.2 0.3", "10 0.9 1.0")).assert_fault(
        "2 Currents",
        "line 9 of current_profile_dynamic.txt: the row has 3 numbers for 3 heights",
    );
    Folder::of("2 Currents", &[]).assert_fault(
        "2 Currents",
        "there is no file `current_profile_dynamic.txt`",
    );
    let short = grid().replace("\n0 -10 -40 0 0.3 0.1 0\n", "\n");
    Folder::of("5 Currents", &[("current_profile_4d.txt", &short)]).assert_fault(
        "5 Currents",
        "line 1 of current_profile_4d.txt: 23 rows follow for a grid of 2 by 2 by 3 by 2",
    );
    let waves = |text: &str, step: &str| {
        Folder::of(
            &format!("3 WaveKin\n{step} dtWave"),
            &[("wave_elevation.txt", text)],
        )
    };
    waves("0 1\n1 high\n", "0.5").assert_fault(
        "3 WaveKin",
        "line 2 of wave_elevation.txt: `high` is not a number",
    );
    waves("0 1\n1 2\n1 3\n", "0.5").assert_fault(
        "3 WaveKin",
        "line 3 of wave_elevation.txt: the time 1 s does not come after 1 s",
    );
    waves("0 1\n1 2\n", "0").assert_fault("0 dtWave", "takes no waves");
    Folder::of("3 WaveKin", &[]).assert_fault("3 WaveKin", "there is no file `wave_elevation.txt`");
    Folder::of("1 WaveKin", &[]).assert_fault("1 WaveKin", "waves given from outside");
    Folder::of("3 Currents", &[])
        .assert_fault("3 Currents", "which MoorDyn does not compute either");
}
