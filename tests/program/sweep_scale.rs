//! What many runs of a sweep cost beside the computing: files, bytes, and the time to list, index and gather them. The figures of
//! docs/CLUSTER.md are of 200 and 2,000:
//!
//!     SEACABLE_RUNS=2000 cargo test --test program scale -- --ignored --nocapture

use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use seacable::run::index::RunIndex;
use seacable::run::store;

use crate::chance::asked;
use crate::small::SMALL;

/// What a run is on the disk.
#[derive(Default)]
struct Size {
    files: usize,
    bytes: u64,
    /// With what the file system adds.
    on_disk: u64,
}

impl Size {
    fn add(&mut self, path: &Path) {
        let found = fs::symlink_metadata(path).unwrap();
        self.on_disk += found.blocks() * 512;
        if found.is_dir() {
            for item in fs::read_dir(path).unwrap() {
                self.add(&item.unwrap().path());
            }
        } else {
            self.files += 1;
            self.bytes += found.len();
        }
    }
}

fn sweep(dir: &Path, words: &[&str]) -> Duration {
    let begun = Instant::now();
    let mut command = Command::new(env!("CARGO_BIN_EXE_seacable"));
    command
        .arg("sweep")
        .args(words)
        .args(["--limit-points", "1e9"])
        .current_dir(dir);
    let done = command.stdout(Stdio::null()).output().unwrap();
    assert!(
        done.status.success(),
        "{}",
        String::from_utf8_lossy(&done.stderr)
    );
    begun.elapsed()
}

#[expect(clippy::print_stdout, reason = "figures are what it is for")]
fn timed<T>(what: &str, count: usize, work: impl FnOnce() -> T) -> T {
    let begun = Instant::now();
    let done = work();
    let took = begun.elapsed().as_secs_f64();
    println!(
        "{what}: {took:.3} s, {:.0} us a run",
        1e6 * took / count as f64
    );
    done
}

#[test]
#[ignore = "left out: it measures; name it to see the figures"]
fn what_the_runs_of_a_sweep_cost_at_scale() {
    let count = asked("SEACABLE_RUNS", 200);
    let place = tempfile::tempdir().unwrap();
    let dir = place.path();
    fs::write(dir.join("small.toml"), SMALL).unwrap();
    let vary = format!("payload.drag_area_m2=0.5..2/{count}");
    timed("computed with --jobs 2", count, || {
        sweep(
            dir,
            &["small.toml", "--vary", &vary, "--out", "s", "--jobs", "2"],
        )
    });
    let mut size = Size::default();
    for number in 1..=count {
        let digits = count.to_string().len().max(4);
        size.add(&dir.join(format!("s-{number:0digits$}")));
    }
    let by_run = |value: u64| value / count as u64;
    println!(
        "a run: {} files, {} inodes, {} bytes, {} on the disk",
        size.files / count,
        size.files / count + 1,
        by_run(size.bytes),
        by_run(size.on_disk)
    );
    timed("listed", count, || {
        assert_eq!(store::list(dir).unwrap().len(), count);
    });
    let cache = dir.join("cache");
    fs::create_dir(&cache).unwrap();
    let mut index = RunIndex::open(dir, Some(&cache)).unwrap();
    for what in ["indexed", "indexed again"] {
        timed(what, count, || {
            index.sync(&AtomicBool::new(false), &mut |_| {}).unwrap()
        });
    }
    let mut database = Size::default();
    database.add(&cache);
    println!("index: {} bytes a run", by_run(database.bytes));
    timed("gathered by --resume", count, || {
        sweep(dir, &["--resume", "s"])
    });
    timed("gathered by --resume --slurm", count, || {
        sweep(dir, &["--resume", "s", "--slurm"])
    });
    timed("a part of one, stored", 1, || {
        sweep(dir, &["--resume", "s", "--part", "1..1"])
    });
}
