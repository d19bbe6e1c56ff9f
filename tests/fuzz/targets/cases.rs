//! Cases of every kind, lists of papers, and what is typed about them.

use std::path::Path;

use seacable::case::{self, Case, ChannelId, Diagnostic, QuantityId, Subject, edit, kind, shipped};
use seacable::export::{self, ExportOptions};
use seacable::import::line_case;
use seacable::kinds::FileType;
use seacable::line_types::nominal_diameter;
use seacable::reference::papers;
use seacable::ropeway::Ropeway;
use seacable::scene;
use seacable::section::CrossSection;
use seacable::ship::Ship;
use seacable::study::vary::VariedKey;
use seacable::system::SystemFile;
use seacable::system::motion::job as system_job;
use seacable::tui::run_filter::RunFilter;

use super::Target;
use super::place::{contained, file};

pub(super) const ALL: &[Target] = &[
    Target {
        name: "line_case",
        run: line_case,
        seeds: || shipped_files(FileType::Line),
        share: 4,
    },
    Target {
        name: "line_as_system",
        run: line_as_system,
        seeds: || {
            let mut files = shipped_files(FileType::Line);
            files.retain(|file| line_as_system(file));
            files
        },
        share: 4,
    },
    Target {
        name: "system",
        run: system,
        seeds: || shipped_files(FileType::System),
        share: 4,
    },
    Target {
        name: "section",
        run: |data| {
            computed(data, |text, file| {
                kind::parse::<CrossSection>(text, file).map(drop)
            })
        },
        seeds: || shipped_files(FileType::Section),
        share: 10,
    },
    Target {
        name: "ropeway",
        run: |data| {
            computed(data, |text, file| {
                kind::parse::<Ropeway>(text, file).map(drop)
            })
        },
        seeds: || shipped_files(FileType::Ropeway),
        share: 10,
    },
    Target {
        name: "ship",
        run: |data| computed(data, |text, file| kind::parse::<Ship>(text, file).map(drop)),
        seeds: || shipped_files(FileType::Ship),
        share: 5,
    },
    Target {
        name: "paper",
        run: paper,
        seeds: || {
            papers::LISTS
                .iter()
                .map(|(_, text)| text.as_bytes().to_vec())
                .collect()
        },
        share: 5,
    },
    Target {
        name: "override",
        run: overridden,
        seeds: overrides,
        share: 2,
    },
    Target {
        name: "vary",
        run: vary,
        seeds: || {
            lines(
                "solver.time_step_s=0.01..0.1/4log\nsolver.method=alpha,rk4\nline.chain.length_m=100..200/3\npayload.dry_mass_kg=1e3,2e3",
            )
        },
        share: 20,
    },
    Target {
        name: "name",
        run: name,
        seeds: || {
            lines(
                "tension_n[wire|payload]\nz_m[payload].max\nenergy_drift_percent.final\nperiod_s[1]\ncase:hard state:done /word\n76 mm\n3 in",
            )
        },
        share: 4000,
    },
];

/// The shipped files of a kind.
fn shipped_files(wanted: FileType) -> Vec<Vec<u8>> {
    let mut kinds = shipped::BY_KIND.iter();
    let files = kinds
        .find(|(kind, _)| *kind == wanted)
        .map(|(_, files)| *files);
    let files = files.unwrap_or_default().iter();
    files.map(|(_, text)| text.as_bytes().to_vec()).collect()
}

fn lines(text: &str) -> Vec<Vec<u8>> {
    text.lines().map(|line| line.as_bytes().to_vec()).collect()
}

/// Looks at what is wrong as the command line does: that it is refused. Of many faults a few.
pub(super) fn shown(faults: &[Diagnostic]) -> bool {
    assert!(!faults.is_empty());
    for fault in faults.iter().take(4) {
        assert!(!fault.render(false).is_empty());
    }
    false
}

fn line_case(data: &[u8]) -> bool {
    let text = contained(data);
    match case::parse(&text, &file("case.toml")) {
        Ok(case) => {
            assert!(!kind::rows::<Case>(&text).is_empty());
            assert!(case::stand_alone(&text, &case).len() >= text.len());
            scene::build(&case, 1).is_ok()
        }
        Err(faults) => shown(&faults),
    }
}

/// A case of a line, written as a system: what is written is a file, and faults of it are at rows of the case.
fn line_as_system(data: &[u8]) -> bool {
    let text = contained(data);
    let name = file("case.toml");
    let system = match line_case::read(&text, Path::new(&name)) {
        Ok(system) => system,
        Err(faults) => return shown(&faults),
    };
    assert!(
        system.text.parse::<toml::Table>().is_ok(),
        "{}",
        system.text
    );
    let Err(faults) = kind::read::<SystemFile>(&system.text, &name) else {
        return true;
    };
    for fault in faults.iter().take(4) {
        assert!(system.at_its_row(fault, &name, &text).line >= 1);
    }
    shown(&faults)
}

fn system(data: &[u8]) -> bool {
    let text = contained(data);
    let name = file("system.toml");
    let solved = match kind::parse::<SystemFile>(&text, &name) {
        Ok(solved) => solved,
        Err(faults) => return shown(&faults),
    };
    assert!(!kind::rows::<SystemFile>(&text).is_empty());
    for target in [export::Target::MoorDyn, export::Target::MapPlusPlus] {
        drop(export::export(&solved, target, ExportOptions::default()));
    }
    drop(system_job::request(solved.into(), &text, name, Vec::new()));
    true
}

/// A file that is computed as it is read.
fn computed(data: &[u8], compute: fn(&str, &str) -> Result<(), Vec<Diagnostic>>) -> bool {
    let text = contained(data);
    let computed = compute(&text, &file("file.toml"));
    computed.map_or_else(|faults| shown(&faults), |()| true)
}

fn paper(data: &[u8]) -> bool {
    computed(data, |text, file| papers::parse(text, file).map(drop))
}

const LINE: &str = include_str!("../../../cases/pendulous/manifold.toml");
const SYSTEM: &str = include_str!("../../../cases/systems/bridle_in_heave.toml");

fn overrides() -> Vec<Vec<u8>> {
    lines(
        "solver.time_step_s=0.01\nsolver.method=alpha\ncase.title=\"a\"\nends.a.position_m=[0, 0, -10]\nline.wire.length_m=12\n\
         current.depth_m=[0, 10]\nmaterials.wire.ea_n=1e7\nlines.left.break_s=2\npoints.clump.mass_kg=500\nsolver.error_estimate=true",
    )
}

/// `KEY=VALUE` on a line case and on a system.
fn overridden(data: &[u8]) -> bool {
    let text = contained(data);
    let Some((key, value)) = text.split_once('=') else {
        return false;
    };
    drop(edit::get(LINE, key));
    drop(edit::unset(LINE, key));
    let of_system = kind::put::<SystemFile>(SYSTEM, key.trim(), value);
    match edit::set_all(LINE, &[(key.trim(), value)]) {
        Ok(edited) => case::parse(&edited, &file("case.toml")).is_ok(),
        Err(faults) => !faults.is_empty() && of_system.is_ok(),
    }
}

fn vary(data: &[u8]) -> bool {
    let key = VariedKey::parse(&contained(data), LINE);
    key.is_ok_and(|key| !key.range.values.is_empty())
}

/// Names of channels, quantities and subjects, diameters, and words to filter runs by.
fn name(data: &[u8]) -> bool {
    let text = String::from_utf8_lossy(data);
    // What a name is read as is written so that it is read as the same.
    let channel = text.parse::<ChannelId>();
    if let Ok(id) = &channel {
        assert!(
            id.to_string()
                .parse::<ChannelId>()
                .is_ok_and(|same| same == *id)
        );
    }
    let quantity = text.parse::<QuantityId>();
    if let Ok(id) = &quantity {
        assert!(
            id.to_string()
                .parse::<QuantityId>()
                .is_ok_and(|same| same == *id)
        );
    }
    let has_words = RunFilter::new(&text).has_words();
    let others = [
        text.parse::<Subject>().is_ok(),
        nominal_diameter(&text).is_ok(),
        has_words,
    ];
    channel.is_ok() || quantity.is_ok() || others.contains(&true)
}
