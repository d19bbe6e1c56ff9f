//! Many stored runs of a case: one is computed, and copied under other names, with other values of one of its inputs.

use std::fs;
use std::path::Path;
use std::process::Command;

/// Makes `count` runs of a case below `dir/runs`.
pub(crate) fn make(dir: &Path, case: &str, count: usize, program: &str) {
    let runs = dir.join("runs");
    let first = runs.join("first");
    let ran = Command::new(program)
        .current_dir(dir)
        .args(["run", case, "--set", "current.speed_m_per_s=0.2", "--out"])
        .arg(&first)
        .output()
        .unwrap();
    assert!(
        ran.status.success(),
        "{}",
        String::from_utf8_lossy(&ran.stderr)
    );
    let read = |name: &str| fs::read_to_string(first.join(name)).unwrap();
    let (info, case) = (read("run.toml"), read("case.toml"));
    let linked: Vec<_> = fs::read_dir(&first)
        .unwrap()
        .map(|item| item.unwrap().file_name())
        .collect();
    for number in 1..count {
        let (name, speed) = (format!("module-{number:05}"), 0.2 + 1e-5 * number as f64);
        let dir = runs.join(&name);
        fs::create_dir(&dir).unwrap();
        let key = format!("speed_m_per_s = {speed:.5}");
        let other = |text: &str| text.replace("speed_m_per_s = 0.2", &key);
        let info = info.replace("\"first\"", &format!("{name:?}"));
        let info = info.replace("speed_m_per_s=0.2", &format!("speed_m_per_s={speed:.5}"));
        fs::write(dir.join("run.toml"), info).unwrap();
        fs::write(dir.join("case.toml"), other(&case)).unwrap();
        for file in linked
            .iter()
            .filter(|f| *f != "run.toml" && *f != "case.toml")
        {
            fs::hard_link(first.join(file), dir.join(file)).unwrap();
        }
    }
}
