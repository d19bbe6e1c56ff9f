//! Files of every kind whose titles, names, sources and notes are hostile, open, with runs whose stored texts are hostile too.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use seacable::case::TextDigest;
use seacable::kinds::FileType;
use seacable::run::index::{IndexedRun, InputColumn, MeasuredResult, ResultColumn, RunColumns};
use seacable::run::job::JobEvent;
use seacable::run::store::RunNotes;
use seacable::run::{Run, RunState};
use seacable::tui::msg::{FileRead, RunsFound};
use seacable::tui::pane::PaneId;
use seacable::tui::recovery::RecoveredEdits;
use seacable::tui::state::{CaseEntry, JobNumber, JobRequest, RunEntry, reading};
use seacable::tui::{Effect, Msg};

use super::{HOSTILE, escaped};
use crate::workbench::SMALL;
use crate::workbench::desk::{CASE, Desk};

/// A file to spoil: its kind, its text, and the names in it.
struct File {
    kind: FileType,
    text: String,
    names: &'static [&'static str],
}

/// Keys whose values are free text.
const TEXTS: [&str; 7] = [
    "title",
    "source",
    "notes",
    "reason",
    "tolerance_reason",
    "out_of_reach",
    "status_reason",
];

/// Parts of a system that nothing names: names that are parts of channels have letters and digits only.
const UNUSED: &str = "
[materials.unused]
mass_kg_per_m = 20.0
diameter_m = 0.06
ea_n = 1e8

[points.unused]
kind = \"fixed\"
position_m = [1.0, 2.0, -3.0]

[bodies.unused]
kind = \"held\"
";

/// Load cases, whose results and reasons are hostile.
const LOAD_CASES: &str = "
[[load_cases]]
key = \"points.clump.mass_kg\"
values = [400.0, 500.0]
";

/// One more study, so that one is to be chosen.
const SECOND_STUDY: &str = "
[[study]]
name = \"mass\"
key = \"payload.dry_mass_kg\"
values = [310e3]
";

/// The files, by the names of their kinds.
pub(super) const KINDS: [&str; 6] = ["line", "section", "ropeway", "ship", "at rest", "in motion"];

fn file(kind: &str) -> File {
    let of = |kind, text: &str, names| File {
        kind,
        text: text.to_owned(),
        names,
    };
    match kind {
        "line" => {
            let mut file = of(
                FileType::Line,
                CASE,
                &["links", "fibre", "late tension", "early tension", "table 1"],
            );
            file.text.push_str(SECOND_STUDY);
            file.text = file
                .text
                // Names that are parts of channels are refused; those of materials are not.
                .replace("materials.chain", "materials.links")
                .replace("materials.rope", "materials.fibre")
                .replace("material = \"chain\"", "material = \"links\"")
                .replace("material = \"rope\"", "material = \"fibre\"")
                .replace("duration_s = 600.0", "duration_s = 6.0")
                .replace("[300.0, 600.0]", "[3.0, 6.0]");
            file
        }
        "section" => of(
            FileType::Section,
            include_str!("../../../../cases/umbilical/section.toml"),
            &["tube", "electric", "fibre"],
        ),
        "ropeway" => of(
            FileType::Ropeway,
            include_str!("../../../../cases/ropeway/span_80.toml"),
            &[],
        ),
        "ship" => {
            let mut file = of(
                FileType::Ship,
                include_str!("../../../../cases/ship/anchored.toml"),
                &[],
            );
            file.text = file.text.replace("records = 10", "records = 2");
            file
        }
        "at rest" => of(
            FileType::System,
            &format!(
                "{}{UNUSED}",
                include_str!("../../../../cases/systems/oc3_free.toml")
            ),
            &["unused"],
        ),
        _ => {
            let mut file = of(
                FileType::System,
                &format!(
                    "{}{UNUSED}{LOAD_CASES}",
                    include_str!("../../../../cases/systems/bridle_in_heave.toml")
                ),
                &["unused"],
            );
            file.text = file
                .text
                .replace("segments = 40", "segments = 8")
                .replace("duration_s = 60.0", "duration_s = 4.0")
                .replace(
                    "name = \"left\"\n",
                    "name = \"left\"\nbreak_at_m = 50.0\nbreak_s = 3.0\n",
                );
            file
        }
    }
}

impl File {
    /// The text with hostile values and names; what TOML lets stand raw is also in a comment.
    fn spoilt(&self) -> String {
        let hostile = escaped(HOSTILE);
        // Kinds are no names, and stay: in other quotes they are not found.
        let lines = self
            .text
            .lines()
            .map(|line| match line.starts_with("kind = ") {
                true => line.replace('"', "'") + "\n",
                false => format!("{line}\n"),
            });
        let mut text: String = lines.collect();
        for name in self.names {
            for (before, quote, after) in [
                ("\"materials.", "", "."),
                ("\"bodies.", "", "."),
                ("\"", "", "\""),
                (".", "\"", "]"),
                (".", "\"", "."),
                ("[", "", "|"),
                ("|", "", "]"),
            ] {
                let to = format!("{before}{quote}{hostile}{name}{quote}{after}");
                text = text.replace(&format!("{before}{name}{after}"), &to);
            }
        }
        for key in TEXTS {
            for (begin, quotes) in [("\"\"\"", 3), ("\"", 1)] {
                let head = format!("{key} = {begin}");
                let mut parts = text.split(&head);
                let mut out = parts.next().unwrap().to_owned();
                for part in parts {
                    out.push_str(&head);
                    // A long text begins with the same quotes as a short one.
                    if quotes == 3 || !part.starts_with("\"\"") {
                        out.push_str(&hostile);
                    }
                    out.push_str(part);
                }
                text = out;
            }
        }
        format!("# \u{9b}2J\u{202e}\u{2066}\u{200f}\u{2028}\n{text}")
    }
}

/// The path of the hostile files.
pub(super) fn path() -> PathBuf {
    PathBuf::from(format!("cases/{HOSTILE}/{HOSTILE}.toml"))
}

/// The list of hostile cases, one of them broken.
pub(super) fn list() -> Desk {
    let mut desk = Desk::new(SMALL);
    let entry = |about| CaseEntry {
        path: path(),
        name: HOSTILE.to_owned(),
        about,
    };
    let said = || (HOSTILE.to_owned(), HOSTILE.to_owned());
    desk.tell(Msg::CasesRead(
        PathBuf::from(HOSTILE),
        vec![entry(Ok(said())), entry(Err(said()))],
    ));
    desk
}

/// A hostile file as read, with what an earlier session left of it.
pub(super) fn file_read(kind: &str, recovered: Option<RecoveredEdits>) -> Msg {
    let file = file(kind);
    let text = file.spoilt();
    let content = reading::content(file.kind, &text, &path(), HOSTILE);
    let content = content.unwrap_or_else(|faults| panic!("{kind}: {:?}", faults[0]));
    Msg::FileRead(Box::new(FileRead::new(path(), text, content, recovered)))
}

/// A hostile file open, with runs that are done, where its kind has runs.
pub(super) fn open(kind: &str) -> Desk {
    let mut desk = list();
    desk.tell(file_read(kind, None));
    if matches!(kind, "line" | "in motion") {
        for _ in 0..2 {
            desk.keys("R");
            compute(&mut desk);
        }
        desk.tell(Msg::RunsListed(Box::new(listed())));
        // More than one run on the charts, so that their names are in the legends.
        let runs = desk.state.number_of(PaneId::Runs).to_string();
        desk.keys(&runs);
        desk.keys("j space j space j space");
        if kind == "line" {
            desk.keys("g space");
        }
    }
    sail(&mut desk);
    desk.asked.clear();
    desk
}

/// Computes the jobs asked for, and what comes of them, without studies.
fn compute(desk: &mut Desk) {
    for _ in 0..4 {
        for (ticket, request) in begun(desk) {
            desk.tell(Msg::Stored(ticket, path()));
            let mut run = request.execute(&AtomicBool::new(false), &mut |event| {
                desk.tell(Msg::Job(ticket, Box::new(event)));
            });
            spoil(&mut run);
            desk.tell(Msg::Job(
                ticket,
                Box::new(JobEvent::Finished(Box::new(run))),
            ));
        }
    }
}

/// The jobs asked for and not yet answered.
fn begun(desk: &mut Desk) -> Vec<(JobNumber, JobRequest)> {
    let mut begun = Vec::new();
    for effect in std::mem::take(&mut desk.asked) {
        if let Effect::Start {
            ticket, request, ..
        } = effect
        {
            begun.push((ticket, request));
        }
    }
    begun
}

/// What a folder that came by mail may say of a run.
fn spoil(run: &mut Run) {
    let said = || HOSTILE.to_owned();
    let info = &mut run.info;
    (info.id, info.title, info.version, info.started) = (said(), said(), said(), said());
    info.case_file = format!("{HOSTILE}.toml");
    info.overrides = vec![said()];
    info.warnings = vec![said(), format!("{HOSTILE}\n{HOSTILE}")];
    info.happened.push(said());
    info.settings.method = said();
    info.settings.error_method = said();
}

/// Runs as the index lists them, in every state.
fn listed() -> RunsFound {
    let said = || HOSTILE.to_owned();
    let states = [
        RunState::Done,
        RunState::Partial,
        RunState::Failed,
        RunState::Cancelled,
        RunState::Partial,
    ];
    let changed = (1..).zip(states).map(|(id, state)| {
        let run = IndexedRun {
            id,
            name: format!("{HOSTILE}{id}"),
            case_file: format!("{HOSTILE}.toml"),
            state,
            failure: Some(said()),
            damaged: id == 3,
            started: if id == 1 {
                "2026-01-02T03:04:05Z".to_owned()
            } else {
                said()
            },
            method: said(),
            duration_s: 6.0,
            steps: 10,
            cpu_s: 0.1,
            overrides: vec![said(), said()],
            text: TextDigest::of_text(HOSTILE),
            notes: RunNotes {
                name: if id == 2 { String::new() } else { said() },
                tags: vec![said(), said()],
                note: said(),
            },
        };
        RunEntry::stored(run, PathBuf::from(format!("runs/{HOSTILE}{id}")), id == 5)
    });
    let result = MeasuredResult {
        value: 1.0,
        unit: said(),
        error: Some(0.1),
        unsettled: None,
    };
    RunsFound {
        changed: changed.collect(),
        all: (1..=5).collect(),
        columns: Some(RunColumns {
            inputs: vec![
                InputColumn {
                    key: said(),
                    usual: Some(said()),
                    values: vec![(1, None), (2, Some(said()))],
                },
                InputColumn {
                    key: format!("materials.{HOSTILE}.ea_n"),
                    usual: None,
                    values: vec![(1, Some(said()))],
                },
            ],
            results: vec![ResultColumn {
                name: said(),
                values: (1..=4).map(|id| (id, result.clone())).collect(),
            }],
        }),
        whole: true,
    }
}

/// Answers as the thread does that works a ship at sea out.
fn sail(desk: &mut Desk) {
    let asked = desk.asked.iter().rev().find_map(|effect| match effect {
        Effect::ComputeShip(ship) => Some(ship.clone()),
        _ => None,
    });
    if let Some(mut ship) = asked {
        ship.folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/ship");
        let computed = ship.computed();
        desk.tell(Msg::ShipComputed(ship.stop, computed));
    }
}
