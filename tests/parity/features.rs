//! Features by scene. A cell says whether the program has the feature for the scene; where it does not, why not.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use rayon::prelude::*;
use toml::{Table, Value};

/// The scenes: a line, lines that meet at a point, a body on lines, a file of MoorDyn.
const SCENES: [&str; 4] = ["line.toml", "points.toml", "body.toml", "moordyn.txt"];

/// Whether a scene has a feature.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Has {
    Yes,
    /// Not yet.
    No,
    /// For a reason of physics.
    Never(&'static str),
}

use Has::{Never, No, Yes};

/// A feature: what is tried, and which scenes have it.
struct Feature {
    name: &'static str,
    tried: fn(&Trial) -> bool,
    has: [Has; SCENES.len()],
}

/// A scene being tried.
struct Trial {
    scene: PathBuf,
    dir: tempfile::TempDir,
}

impl Trial {
    fn of(scene: &str) -> Self {
        let dir = tempfile::tempdir().unwrap();
        let from = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("tests/parity/scenes")
            .join(scene);
        let to = dir.path().join(scene);
        fs::copy(from, &to).unwrap();
        Self { scene: to, dir }
    }

    fn path(&self, name: &str) -> String {
        self.dir.path().join(name).display().to_string()
    }

    fn command(&self, words: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
        command.args(words).current_dir(self.dir.path());
        command.output().unwrap()
    }

    /// A run in time into `run`; what it prints.
    fn run(&self, more: &[&str]) -> Option<String> {
        let (scene, out) = (self.scene.display().to_string(), self.path("run"));
        let words = ["run", &scene, "--out", &out, "--set", "solver.duration_s=4"];
        let output = self.command(&[&words[..], more].concat());
        let text = String::from_utf8(output.stdout).unwrap();
        output.status.success().then_some(text)
    }

    /// The scene as a system, converted where it is none, with something edited in it; its path.
    fn as_system(&self, mut edit: impl FnMut(&mut Table)) -> Option<String> {
        let scene = self.scene.display().to_string();
        let text = match fs::read_to_string(&self.scene).unwrap() {
            text if text.contains("[system]") => text,
            _ => {
                let output = self.command(&["import", &scene]);
                output.status.success().then_some(())?;
                String::from_utf8(output.stdout).unwrap()
            }
        };
        let mut table: Table = text.parse().unwrap();
        let solver = "duration_s = 4.0\nerror_estimate = false\n"
            .parse()
            .unwrap();
        table.insert("solver".to_owned(), Value::Table(solver));
        edit(&mut table);
        let path = self.path("edited.toml");
        fs::write(&path, table.to_string()).unwrap();
        Some(path)
    }

    /// Whether the scene as a system is computed when it is edited and has these tables, and then has this in its summary.
    fn runs_with(&self, tables: &str, edit: fn(&mut Table), shows: &str) -> bool {
        let add = |table: &mut Table| {
            edit(table);
            let name = first_line(table)["name"].as_str().unwrap().to_owned();
            let more: Table = tables.replace("LINE", &name).parse().unwrap();
            table.extend(more);
        };
        let run = |path: String| self.command(&["run", &path, "--out", &self.path("run")]);
        let ran = self.as_system(add).map(run);
        ran.is_some_and(|output| output.status.success()) && self.summary().contains(shows)
    }

    /// Leaves a second of its simulated time.
    fn shorten(&self) {
        let text = fs::read_to_string(&self.scene).unwrap();
        let short = text.replace("duration_s = 10.0", "duration_s = 1.0");
        fs::write(&self.scene, short).unwrap();
    }

    /// A study of the scene, as quick as it can be.
    fn studies(&self, words: &[&str]) -> bool {
        let scene = self.scene.display().to_string();
        let words = [&["study", words[0], &scene], &words[1..]].concat();
        self.command(&words).status.success()
    }

    /// A study of the scene at rest, as quick as it can be.
    fn studies_at_rest(&self, words: &[&str]) -> bool {
        self.at_rest(&[&["study", words[0]], &words[1..]].concat())
    }

    /// Whether a command takes the scene as a system at rest.
    fn at_rest(&self, words: &[&str]) -> bool {
        let path = self.as_system(|system| drop(system.remove("solver")));
        path.is_some_and(|path| self.command(&[words, &[&path]].concat()).status.success())
    }

    /// Adds a trial to the file, of a step that its method refuses, and computes it.
    fn tries_what_is_refused(&self) -> bool {
        let mut text = fs::read_to_string(&self.scene).unwrap();
        text.push_str(REFUSED_TRIAL);
        fs::write(&self.scene, text).unwrap();
        self.studies(&["hard-cases"])
    }

    /// A file of the run, by its lines without the head.
    fn rows(&self, file: &str) -> usize {
        let text = fs::read_to_string(Path::new(&self.path("run")).join(file)).unwrap();
        text.lines().count() - 1
    }

    fn head(&self, file: &str) -> String {
        let text = fs::read_to_string(Path::new(&self.path("run")).join(file)).unwrap();
        text.lines().next().unwrap_or_default().to_owned()
    }

    fn summary(&self) -> String {
        fs::read_to_string(Path::new(&self.path("run")).join("summary.csv")).unwrap()
    }
}

/// The first line of a system.
fn first_line(system: &mut Table) -> &mut Table {
    let lines = system["lines"].as_array_mut().unwrap();
    lines[0].as_table_mut().unwrap()
}

/// Puts the end B of the last line on a body that is held there, where there is no body.
fn put_on_body(system: &mut Table) {
    system.remove("solver");
    if system.contains_key("bodies") {
        return;
    }
    let end = system["lines"].as_array().unwrap().last().unwrap()["to"].as_str();
    let end = end.unwrap().to_owned();
    let place = system["points"][&end]["position_m"].clone();
    let point = "kind = \"body\"\nbody = \"vessel\"\nposition_m = [0.0, 0.0, 0.0]\n";
    system["points"][&end] = Value::Table(point.parse().unwrap());
    let mut vessel: Table = "kind = \"held\"\n".parse().unwrap();
    vessel.insert("position_m".to_owned(), place);
    let bodies = Table::from_iter([("vessel".to_owned(), Value::Table(vessel))]);
    system.insert("bodies".to_owned(), Value::Table(bodies));
}

/// Pays out the first line.
const PAYOUT: &str = "[[payouts]]\nline = \"LINE\"\nend = \"a\"\nrate_m_per_s = 0.5\n";

/// Leaves the bending stiffness of all materials out.
fn without_stiffness(system: &mut Table) {
    for (_, material) in system["materials"].as_table_mut().unwrap() {
        let material = material.as_table_mut().unwrap();
        material.remove("ei_n_m2");
        material.remove("min_bend_radius_m");
    }
}

/// Lets the first line break in its middle.
fn break_line(system: &mut Table) {
    let line = first_line(system);
    line.insert("break_at_m".to_owned(), Value::Float(20.0));
    line.insert("break_s".to_owned(), Value::Float(1.0));
}

const REFUSED_TRIAL: &str = r#"
[[trial]]
name = "rk4, far above its limit"
set = ["solver.method=rk4", "solver.time_step_s=1.0"]
refused = "above the stability limit"
"#;

const FAST: &[&str] = &["--set", "solver.error_estimate=false"];

/// A line has no bending stiffness in files of this scene.
const NO_STIFFNESS: Has = Never("its file has no bending stiffness");

/// What that file cannot say of the body here.
const NO_BUOYANCY: Has =
    Never("a file of MoorDyn has no centre of buoyancy apart from that of gravity");

/// What nothing at rest has.
const NO_STEPS: Has = Never("nothing is marched at rest");

/// What that file cannot say at all.
const NO_TRIALS: Has = Never("a file of MoorDyn has no trials: its format has no place for them");

const FEATURES: &[Feature] = &[
    Feature {
        name: "a profile of every line, with envelopes",
        tried: |trial| {
            trial.run(FAST).is_some()
                && trial.rows("profile.csv") >= 40
                && trial.head("profile.csv").contains("tension_max_n")
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "shapes of every line over time",
        tried: |trial| trial.run(FAST).is_some() && trial.rows("shapes.csv") >= 2 * 40,
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "extremes along every line, with their places",
        tried: |trial| {
            trial.run(FAST).is_some()
                && trial.summary().contains(".arc_of_max,")
                && trial.summary().matches(".arc_of_min,").count() >= 1
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "bend radius along every line",
        tried: |trial| trial.run(FAST).is_some() && trial.summary().contains("bend_radius_m"),
        has: [Yes, Yes, Yes, NO_STIFFNESS],
    },
    Feature {
        name: "numerical damping said",
        tried: |trial| {
            trial.run(FAST).is_some() && {
                let place = Path::new(&trial.path("run")).join("run.toml");
                fs::read_to_string(place)
                    .unwrap()
                    .contains("numerical_damping_period_s")
            }
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "errors by observed orders",
        tried: |trial| {
            trial.run(&[]).is_some() && {
                let dir = trial.path("run");
                let text = fs::read_to_string(Path::new(&dir).join("run.toml")).unwrap();
                text.contains("by the order observed")
            }
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "resumed to a later end",
        tried: |trial| {
            let to = trial.path("later");
            trial.run(FAST).is_some()
                && trial
                    .command(&["run", "--resume", "run", "--until", "8", "--out", &to])
                    .status
                    .success()
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "a report and a comparison of stored runs",
        tried: |trial| {
            trial.run(FAST).is_some()
                && trial.command(&["report", "run"]).status.success()
                && trial.command(&["compare", "run", "run"]).status.success()
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "by Runge-Kutta of order 4",
        tried: |trial| trial.run(&[FAST, &["--solver", "rk4"]].concat()).is_some(),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "quasi-static in time",
        tried: |trial| {
            trial
                .run(&[FAST, &["--solver", "quasi"]].concat())
                .is_some()
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "the method chosen by the program",
        tried: |trial| trial.run(&[FAST, &["--solver", "auto"]].concat()).is_some(),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "mesh and steps for an accuracy asked",
        tried: |trial| {
            trial.run(&["--accuracy", "0.05"]).is_some_and(|text| {
                text.contains("Accuracy: 0.05 asked; ") && text.contains(" reached by 95 % of ")
            })
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "length of line on the bed over time",
        tried: |trial| trial.run(FAST).is_some() && trial.summary().contains("on_bed_m["),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "exported to a file of MoorDyn",
        tried: |trial| {
            let (scene, to) = (
                trial.scene.display().to_string(),
                trial.path("exported.txt"),
            );
            let words = ["export", "--moordyn", &scene, "-o", &to];
            trial.command(&words).status.success()
        },
        has: [Yes, Yes, NO_BUOYANCY, Yes],
    },
    Feature {
        name: "a quick look at seas",
        tried: |trial| {
            let waves = "[[waves]]\nkind = \"irregular\"\nsignificant_height_m = 0.5\npeak_period_s = 8.0\n";
            let more: Table = waves.parse().unwrap();
            let path = trial.as_system(|system| system.extend(more.clone()));
            path.is_some_and(|path| {
                let words = ["sweep", &path, "--quick", "--vary", "waves.1.seed=1,2"];
                trial.command(&words).status.success()
            })
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "an offset curve of a body on a line",
        tried: |trial| {
            let path = trial.as_system(put_on_body);
            path.is_some_and(|path| {
                let words = ["study", "offsets", &path, "--to", "1", "--steps", "2"];
                trial.command(&words).status.success()
            })
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "a length sought for a tension",
        tried: |trial| {
            let path = trial.scene.display().to_string();
            let mut name = String::new();
            trial
                .as_system(|system| name = first_line(system)["name"].as_str().unwrap().to_owned());
            let vary = format!("lines.{name}.length_m");
            // One of them is within reach.
            ["2.2e4", "4.5e4"].iter().any(|tension| {
                let want = format!("tension_n[{name}|b]={tension}");
                let words = ["study", "seek", &path, "--vary", &vary];
                let words = [&words[..], &["--between", "30..120", "--want", &want]].concat();
                trial.command(&words).status.success()
            })
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "a line paid out",
        tried: |trial| trial.runs_with(PAYOUT, without_stiffness, "length_m["),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "a line paid out with the stiffness that its file has",
        tried: |trial| trial.runs_with(PAYOUT, |_| {}, "length_m["),
        has: [No, No, No, Yes],
    },
    Feature {
        name: "a line that breaks",
        tried: |trial| {
            let path = trial.as_system(break_line);
            path.is_some_and(|path| {
                let words = ["run", &path, "--out", &trial.path("run")];
                trial.command(&words).status.success()
            })
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "lines that age",
        tried: |trial| {
            let ageing = "[ageing]\nyears = 10.0\n[[ageing.growth]]\nthickness_m = [0.05]\n";
            trial.runs_with(ageing, |_| {}, "tension_n")
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "error bars held against converged runs",
        tried: |trial| {
            trial.shorten();
            trial.studies(&["bars"])
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "accuracies held against converged runs",
        tried: |trial| {
            trial.shorten();
            trial.studies(&["accuracy", "--accuracy", "0.05", "--budget", "5s"])
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "study of speed against error",
        tried: |trial| trial.studies(&["speed", "--repeats", "1", "--set", "solver.duration_s=1"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "study of steps",
        tried: |trial| trial.studies(&["steps", "--variants", "1", "--set", "solver.duration_s=1"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "study of effects left out",
        tried: |trial| trial.studies(&["physics", "--set", "solver.duration_s=4"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "study of the effects of inputs",
        tried: |trial| trial.studies(&["effects", "--set", "solver.duration_s=4"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "at rest: speed against error",
        tried: |trial| trial.studies_at_rest(&["speed", "--repeats", "1"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "speed against error of the equilibrium of a scene in time",
        tried: |trial| trial.studies(&["speed", "--at-rest", "--repeats", "1"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "at rest: effects left out",
        tried: |trial| trial.studies_at_rest(&["physics"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "at rest: effects of inputs",
        tried: |trial| trial.studies_at_rest(&["effects"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "at rest: error bars held against converged runs",
        tried: |trial| trial.studies_at_rest(&["bars"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "at rest: accuracies held against converged runs",
        tried: |trial| trial.studies_at_rest(&["accuracy", "--accuracy", "0.05", "--budget", "5s"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "at rest: the mesh for an accuracy asked",
        tried: |trial| trial.at_rest(&["run", "--accuracy", "0.01"]),
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "at rest: by the method `static` of its file",
        tried: |trial| {
            let text = trial.command(&[
                "run",
                "--solver",
                "static",
                &trial.scene.display().to_string(),
            ]);
            text.status.success()
        },
        has: [Yes, Yes, Yes, Yes],
    },
    Feature {
        name: "at rest: study of steps",
        tried: |trial| trial.studies_at_rest(&["steps", "--variants", "1"]),
        has: [NO_STEPS; SCENES.len()],
    },
    Feature {
        name: "trials of hard cases",
        tried: Trial::tries_what_is_refused,
        has: [Yes, Yes, Yes, NO_TRIALS],
    },
];

/// Every cell is as the table says: what has come to work is said, and what works stays.
#[test]
fn every_scene_has_what_the_table_says() {
    let cells = FEATURES.par_iter().flat_map_iter(|feature| {
        let scenes = SCENES.iter().zip(feature.has);
        scenes.filter_map(|(scene, has)| {
            let found = (feature.tried)(&Trial::of(scene));
            let why = match has {
                Never(why) => why,
                _ => "",
            };
            let wrong = found != (has == Yes);
            wrong.then(|| format!("{scene}: {}: {found} {why}", feature.name))
        })
    });
    let wrong: Vec<String> = cells.collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
