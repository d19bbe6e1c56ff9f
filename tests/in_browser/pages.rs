//! The pages that are opened: reports of every kind, made by the program.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use assert_cmd::Command;

/// A report.
pub(crate) struct Page {
    pub(crate) name: &'static str,
    pub(crate) html: String,
}

fn seacable(dir: &Path, words: &[&str]) -> String {
    let mut command = Command::cargo_bin("seacable").unwrap();
    let done = command.current_dir(dir).args(words).assert().success();
    String::from_utf8(done.get_output().stdout.clone()).unwrap()
}

fn shipped(name: &str) -> String {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "cases", name].iter().collect();
    path.to_str().unwrap().to_owned()
}

/// All pages, made once.
pub(crate) fn pages() -> &'static [Page] {
    static PAGES: LazyLock<Vec<Page>> = LazyLock::new(made);
    &PAGES
}

fn made() -> Vec<Page> {
    let dir = tempfile::tempdir().unwrap();
    let run = |words: &[&str]| seacable(dir.path(), words);
    let html = |name: &'static str, words: &[&str]| Page {
        name,
        html: run(&[&["report", "--format", "html"], words].concat()),
    };
    let [manifold, pendulum, bridle] = [
        "pendulous/manifold.toml",
        "basics/pendulum.toml",
        "systems/bridle_in_heave.toml",
    ]
    .map(shipped);
    run(&["run", &manifold, "--out", "manifold"]);
    let faster = "--set=current.speed_m_per_s=0.5";
    run(&["run", &manifold, faster, "--out", "faster"]);
    run(&["run", &bridle, "--out", "bridle"]);
    let vary = [
        "--vary=solver.duration_s=2..4/3",
        "--vary=materials.wire.mass_kg_per_m=0.05..0.4/8",
    ];
    run(&["sweep", &pendulum, vary[0], vary[1], "--out", "sweep"]);
    vec![
        html("run", &["manifold"]),
        html("comparison", &["faster", "--against", "manifold"]),
        html("system in time", &["bridle"]),
        html("sweep", &["sweep"]),
        html("section", &[&shipped("umbilical/section.toml")]),
        html("ropeway", &[&shipped("ropeway/span_60.toml")]),
        html("ship", &[&shipped("ship/coupled.toml")]),
        html("system at rest", &[&shipped("systems/volturnus.toml")]),
    ]
}
