//! The program itself and the machine.

use std::path::Path;

use super::finding::DoctorFinding;
use seacable_base::files::read;
use seacable_base::visible;
use seacable_runs::run::VERSION;

const TOPIC: &str = "program";

pub(super) fn findings() -> Vec<DoctorFinding> {
    let mut found = vec![
        DoctorFinding::fine(TOPIC, "version", version()),
        DoctorFinding::fine(TOPIC, "file", file()),
        DoctorFinding::fine(
            TOPIC,
            "system",
            format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH),
        ),
        cores(),
    ];
    found.extend(memory());
    found
}

fn version() -> String {
    let build = if cfg!(debug_assertions) {
        "built for debugging"
    } else {
        "built for release"
    };
    let parquet = if cfg!(feature = "parquet") {
        "with"
    } else {
        "without"
    };
    format!("seacable {VERSION}, {build}, {parquet} Parquet files")
}

fn file() -> String {
    std::env::current_exe().map_or_else(|error| error.to_string(), |path| visible::path(&path))
}

fn cores() -> DoctorFinding {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let found = DoctorFinding::fine(TOPIC, "cores", cores.to_string());
    match cores {
        1 => {
            found.note("with one core the screen and the solvers share it; keys may wait a little")
        }
        _ => found,
    }
}

/// Memory that is there and that is free, from Linux's `/proc`; nothing elsewhere.
fn memory() -> Option<DoctorFinding> {
    let text = read::text(Path::new("/proc/meminfo")).ok()?;
    let total = kib(&text, "MemTotal:")?;
    let free = kib(&text, "MemAvailable:")?;
    let value = format!("{:.1} GiB, {:.1} GiB of it free", gib(total), gib(free));
    let found = DoctorFinding::fine(TOPIC, "memory", value);
    Some(match gib(free) {
        free if free < 0.25 => found
            .problem("less than 256 MiB are free: large systems may not fit; end other programs"),
        _ => found,
    })
}

fn gib(kib: f64) -> f64 {
    kib / f64::from(1 << 20)
}

/// A number of `/proc/meminfo`.
fn kib(text: &str, name: &str) -> Option<f64> {
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    line.split_whitespace().next()?.parse().ok()
}
