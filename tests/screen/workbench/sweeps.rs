//! Load cases on the screen: heat map, table, checks; computed in the background, watched, and followed down to a run.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use seacable::case::judging_rows::is_judging;
use seacable::case::{StudyValue, kind};
use seacable::chart::Glyphs;
use seacable::kinds::FileType;
use seacable::run::{Cost, Quantity, RunInfo, RunState, Settings, VERSION, Work};
use seacable::study::points::{PointOutcome, PointRun};
use seacable::study::sweep::{
    SweepFolder, SweepOutcomes, SweepPlan, SweepProgress, SweepResults, SweepSnapshot,
};
use seacable::system::SystemFile;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::state::sweep_request::{SweepEffect, SweepMsg, SweepRequest};
use seacable::tui::state::sweep_verdict::SweepVerdict;
use seacable::tui::state::sweeps::SweepRead;
use seacable::tui::state::{DocumentContent, JobNumber, JobState, SystemView};
use seacable::tui::view::offered;
use seacable::tui::{Effect, Msg, update};

use super::desk::{Desk, looks};
use super::{LARGE, SMALL, has, said, snapshot};

const BRIDLE: &str = include_str!("../../../cases/systems/bridle_in_heave.toml");

/// Six periods, five masses, two drag coefficients.
const LOAD_CASES: &str = r#"
[[load_cases]]
key = "points.top.period_s"
values = [6.0, 7.0, 8.0, 9.0, 10.0, 12.0]

[[load_cases]]
key = "points.clump.mass_kg"
values = [300.0, 400.0, 500.0, 600.0, 800.0]

[[load_cases]]
key = "materials.wire.drag_normal"
values = [1.0, 1.6]
"#;

/// Two periods, and limits of which one is kept and one is not.
const CHECKED: &str = r#"
[[load_cases]]
key = "points.top.period_s"
values = [6.0, 8.0]

[[checks]]
name = "weak wire"
kind = "safety-factor"
factor = 1.5
break_load_n = 2e4

[[checks]]
name = "strong wire"
kind = "safety-factor"
factor = 1.5
break_load_n = 1e9
"#;

const DIR: &str = "runs/bridle-sweep-20260102-030405";

/// The bridle, short and coarse, with load cases.
fn text(more: &str) -> String {
    let text = BRIDLE.replace("segments = 40", "segments = 8").replace(
        "duration_s = 60.0",
        "duration_s = 3.0\nerror_estimate = false",
    );
    format!("{text}{more}")
}

fn request(text: &str) -> SweepRequest {
    SweepRequest {
        kind: FileType::System,
        text: text.to_owned(),
        path: PathBuf::from("cases/bridle.toml"),
        overrides: Vec::new(),
    }
}

/// A run made by hand: tensions grow with the mass, and fall with the period.
fn outcome(plan: &SweepPlan, index: usize, state: RunState) -> PointOutcome {
    let SweepResults::InTime(ids) = &plan.sweep.results else {
        panic!("{:?}", plan.sweep.results);
    };
    let values = plan.sweep.variation.points[index].settings.iter();
    let values: Vec<f64> = values
        .map(|setting| match &setting.value {
            StudyValue::Number(value) => *value,
            StudyValue::Word(word) => panic!("{word}"),
        })
        .collect();
    let tension = 40.0 * values[1] + 6e5 / values[0].powi(2) * values.get(2).unwrap_or(&1.0);
    let quantity = |(place, id): (usize, &_)| Quantity {
        id: Clone::clone(id),
        value: tension * (1.0 + 0.1 * place as f64),
        time_error: index.is_multiple_of(2).then_some(120.0),
        mesh_error: index.is_multiple_of(2).then_some(60.0),
        unsettled: None,
    };
    let done = state == RunState::Done;
    Ok(PointRun {
        info: RunInfo {
            id: format!("{index}"),
            title: String::new(),
            case_file: "bridle.toml".to_owned(),
            state,
            version: VERSION.to_owned(),
            started: "2026-01-02T03:04:05Z".to_owned(),
            overrides: Vec::new(),
            failure: (!done).then(|| "step 7 did not converge".to_owned()),
            warnings: Vec::new(),
            happened: Vec::new(),
            settings: Settings::default(),
            work: Work::default(),
            cost: Cost::default(),
        },
        summary: ids
            .iter()
            .enumerate()
            .filter(|_| done)
            .map(quantity)
            .collect(),
        dir: Some(PathBuf::from(format!("{DIR}-{:04}", index + 1))),
    })
}

/// The sweep with so many load cases done; the eighth failed.
fn sweep(text: &str, done: usize) -> SweepRead {
    let plan = request(text).plan().unwrap();
    let SweepResults::InTime(ids) = plan.sweep.results.clone() else {
        panic!("{:?}", plan.sweep.results);
    };
    let state = |index| match index {
        7 => RunState::Failed,
        _ => RunState::Done,
    };
    let runs = (0..plan.sweep.variation.points.len())
        .map(|index| (index < done).then(|| outcome(&plan, index, state(index))));
    let outcomes = SweepOutcomes::Runs(runs.collect(), ids);
    SweepRead::new(SweepSnapshot::computed(
        Path::new(DIR),
        Arc::new(plan),
        outcomes,
    ))
}

impl Desk {
    fn with_load_cases(size: (u16, u16), text: &str) -> Self {
        let mut desk = Self::new(size);
        desk.tell(Msg::FileRead(Box::new(FileRead::new(
            PathBuf::from("cases/bridle.toml"),
            text.to_owned(),
            DocumentContent::System(Box::new(SystemView::new(
                kind::parse::<SystemFile>(text, "bridle.toml").unwrap(),
            ))),
            None,
        ))));
        desk
    }

    /// The sweeps that were asked for.
    fn sweeps_asked(&mut self) -> Vec<SweepEffect> {
        let mut found = Vec::new();
        self.asked.retain(|effect| match effect {
            Effect::Sweep(effect) => {
                found.push(effect.clone());
                false
            }
            _ => true,
        });
        found
    }

    /// Begins the sweep: its job, and its folder.
    fn begins(&mut self) -> JobNumber {
        self.keys("W");
        let asked = self.sweeps_asked();
        let ticket = asked.iter().find_map(|effect| match effect {
            SweepEffect::Start(ticket, _) => Some(*ticket),
            _ => None,
        });
        let ticket = ticket.unwrap();
        self.sweep(SweepMsg::Begun(ticket, PathBuf::from(DIR)));
        ticket
    }

    fn sweep(&mut self, msg: SweepMsg) {
        self.tell(Msg::Sweep(msg));
    }

    /// The load cases computed, and shown.
    fn with_sweep(size: (u16, u16)) -> Self {
        let text = text(LOAD_CASES);
        let mut desk = Self::with_load_cases(size, &text);
        let ticket = desk.begins();
        desk.sweep(SweepMsg::Ended(ticket, Ok((sweep(&text, 60), false))));
        desk.sweeps_asked();
        desk
    }
}

#[test]
fn load_cases_as_a_heat_map() {
    let mut desk = Desk::with_sweep(SMALL);
    assert!(said(&desk).contains("59 of 60 load cases are done, 1 without results"));
    desk.keys("l j");
    snapshot("tui_sweep_map_80x24", &desk);
    desk.keys("]");
    snapshot("tui_sweep_table_80x24", &desk);
    let mut desk = Desk::with_sweep(LARGE);
    desk.keys("l j");
    snapshot("tui_sweep_map_200x60", &desk);
    let mut desk = Desk::with_sweep(SMALL);
    desk.state.capabilities = looks(Glyphs::Ascii, false);
    desk.keys("l j");
    snapshot("tui_sweep_map_ascii_mono_80x24", &desk);
    let buffer = desk.buffer();
    assert!(buffer.content().iter().all(|cell| cell.symbol().is_ascii()));
    let plain = ratatui::style::Color::Reset;
    assert!(buffer.content().iter().all(|cell| cell.fg == plain));
}

#[test]
fn axes_rule_and_result_are_chosen_and_the_title_says_so() {
    let mut desk = Desk::with_sweep(SMALL);
    assert!(
        desk.screen()
            .contains("greatest of 2 values of drag normal")
    );
    desk.keys("m m");
    assert!(desk.screen().contains("mean of 2 values of drag normal"));
    desk.keys(">");
    assert!(desk.screen().contains("at drag normal 1"));
    desk.keys("> >");
    assert!(desk.screen().contains("mean of 2 values"));
    desk.keys("y");
    let screen = desk.screen();
    assert!(screen.contains("down: drag normal") && screen.contains("of mass [kg]"));
    desk.keys("x");
    assert!(desk.screen().contains("across: mass [kg]"));
    let first = desk.screen();
    desk.keys("n");
    assert_ne!(desk.screen(), first);
    desk.keys("p m m");
    // Every key of the footer does something here too.
    for tabs in ["", "]", "] ]", "] ] ]"] {
        let mut desk = Desk::with_sweep(SMALL);
        desk.keys(tabs);
        for command in offered(&desk.state) {
            let mut copy = desk.state.clone();
            let key = command.keys.first().unwrap().parse().unwrap();
            let asked = update(&mut copy, Msg::Key(key));
            let mut after = Desk::new(SMALL);
            after.state = copy;
            let seen = after.screen() != desk.screen() || !asked.is_empty();
            assert!(seen, "{tabs}: `{key}` {}", command.doc);
        }
    }
}

#[test]
fn a_cell_leads_to_its_load_cases_and_to_a_run() {
    let mut desk = Desk::with_sweep(SMALL);
    desk.keys("l enter");
    snapshot("tui_sweep_cell_80x24", &desk);
    desk.keys("esc");
    assert_eq!(desk.state.focus(), PaneId::Sweep);
    assert!(desk.screen().contains("Heat map"));
    // The cursor is on the load case that governs: the greater drag.
    desk.keys("enter enter");
    let dir = PathBuf::from(format!("{DIR}-0012"));
    assert!(has(&desk, |e| matches!(e, Effect::ReadRun(d) if *d == dir)));
    assert_eq!(desk.state.focus(), PaneId::Charts);
    assert!(said(&desk).contains("load case 12 (period 7 s, mass 300 kg, drag normal 1.6)"));
    desk.keys("C");
    assert_eq!(desk.state.focus(), PaneId::Sweep);
    // A load case that failed has its run too; one that is not computed has none.
    let mut desk = Desk::with_load_cases(SMALL, &text(LOAD_CASES));
    let ticket = desk.begins();
    let part = sweep(&text(LOAD_CASES), 20);
    desk.sweep(SweepMsg::Ended(ticket, Ok((part, true))));
    assert!(said(&desk).contains("Stopped with 19 of 60 load cases done"));
    desk.keys("] G enter");
    assert!(said(&desk).contains("Load case 60 has no stored run: not computed"));
    assert_eq!(desk.state.focus(), PaneId::Sweep);
}

#[test]
fn a_sweep_is_watched_while_it_is_computed() {
    let text = text(LOAD_CASES);
    let mut desk = Desk::with_load_cases(SMALL, &text);
    desk.keys("0");
    assert!(desk.screen().contains("No sweep of this file is stored"));
    let ticket = desk.begins();
    let reads = |desk: &mut Desk| {
        let asked = desk.sweeps_asked();
        asked
            .iter()
            .filter(|e| matches!(e, SweepEffect::Read { .. }))
            .count()
    };
    assert_eq!(reads(&mut desk), 1);
    let dir = || PathBuf::from(DIR);
    desk.sweep(SweepMsg::Read(dir(), Ok(sweep(&text, 0))));
    assert_eq!(reads(&mut desk), 0);
    let progress = |done| SweepProgress {
        done,
        stored: 0,
        of: 60,
    };
    desk.sweep(SweepMsg::Progress(ticket, progress(12), 6.0));
    desk.sweep(SweepMsg::Progress(ticket, progress(20), 10.0));
    // One look at a time.
    assert_eq!(reads(&mut desk), 1);
    desk.sweep(SweepMsg::Read(dir(), Ok(sweep(&text, 18))));
    assert_eq!(reads(&mut desk), 1);
    snapshot("tui_sweep_part_80x24", &desk);
    desk.keys("8");
    assert!(
        desk.screen().contains("20 of 60 load cases, 20 s left"),
        "{}",
        desk.screen()
    );
    desk.keys("0 W");
    assert!(said(&desk).contains("being computed"));
    desk.keys("ctrl+c");
    assert!(has(
        &desk,
        |e| matches!(e, Effect::Cancel(t) if *t == ticket)
    ));
    desk.sweep(SweepMsg::Ended(ticket, Ok((sweep(&text, 20), true))));
    assert_eq!(desk.state.jobs.lines[0].state, JobState::Cancelled);
    // It goes on with the same key; the threads behind the screen find what is stored.
    desk.keys("W");
    assert!(
        desk.sweeps_asked()
            .iter()
            .any(|e| matches!(e, SweepEffect::Start(..)))
    );
    let other = desk.state.jobs.lines[1].ticket;
    let why = "runs/x is being computed by another program.".to_owned();
    desk.sweep(SweepMsg::Ended(other, Err(why)));
    assert!(said(&desk).contains("another program"));
}

#[test]
fn a_stored_sweep_is_read_judged_and_followed_to_the_governing_run() {
    let place = tempfile::tempdir().unwrap();
    let text = text(CHECKED);
    let plan = request(&text).plan().unwrap();
    let dir = place.path().join("bridle-sweep");
    let names = (plan.sweep.results.names(), None);
    let folder = SweepFolder::create(Some(&dir), &plan.sweep.variation, names).unwrap();
    let before = SweepSnapshot::read(&dir, &AtomicBool::new(false)).unwrap();
    assert_eq!((before.done(), before.load_cases()), (0, 2));
    plan.sweep
        .compute(Some(&folder), &AtomicBool::new(false), &|_| {});
    // A later look has what has ended since.
    let read = before.newer().unwrap();
    assert_eq!(read.done(), 2);
    let mut desk = Desk::with_load_cases(SMALL, &text);
    let ticket = desk.begins();
    desk.sweep(SweepMsg::Begun(ticket, dir.clone()));
    desk.sweep(SweepMsg::Read(dir.clone(), Ok(SweepRead::new(read))));
    desk.keys("] ]");
    let asked = desk.sweeps_asked();
    let snapshot = asked.iter().find_map(|effect| match effect {
        SweepEffect::Check(snapshot) => Some(snapshot.clone()),
        _ => None,
    });
    let verdict = SweepVerdict::of_snapshot(&snapshot.unwrap());
    desk.sweep(SweepMsg::Checked(dir.clone(), Arc::new(verdict)));
    let screen = desk.screen();
    for words in ["weak wire", "fails", "strong wire", "Uses"] {
        assert!(screen.contains(words), "{words}: {screen}");
    }
    desk.keys("enter");
    assert!(has(
        &desk,
        |e| matches!(e, Effect::ReadRun(of) if of.starts_with(place.path()))
    ));
    // The share that a check uses is a result of the map too.
    desk.keys("C [ [ p");
    assert!(
        desk.screen().contains("used: strong wire"),
        "{}",
        desk.screen()
    );
    // After an edit the sweep is of other inputs, and says so once that is known.
    let compared = |desk: &mut Desk| {
        let asked = desk.sweeps_asked();
        let found = asked.into_iter().find_map(|effect| match effect {
            SweepEffect::Compare(snapshot, request) => Some((snapshot, request)),
            _ => None,
        });
        let (snapshot, request) = found.unwrap();
        let same = request.is_of(&snapshot);
        desk.sweep(SweepMsg::Compared(dir.clone(), request.text, same));
        same
    };
    desk.asked.extend(
        asked
            .into_iter()
            .filter(|effect| matches!(effect, SweepEffect::Compare(..)))
            .map(Effect::Sweep),
    );
    assert!(compared(&mut desk));
    assert!(!desk.screen().contains("not of these inputs"));
    desk.keys("1 /");
    desk.type_text("clump mass");
    desk.keys("enter enter ctrl+u");
    desk.type_text("450");
    desk.keys("enter 0");
    assert!(!compared(&mut desk));
    assert!(desk.screen().contains("not of these inputs"));
}

#[test]
fn load_cases_statistics_and_checks_are_edited_like_all_keys() {
    let mut desk = Desk::with_load_cases(SMALL, &text(CHECKED));
    let find = |desk: &Desk, end: &str| {
        let rows = desk.state.editor().unwrap().rows.iter();
        let judging = rows.filter(|row| is_judging(&row.path) && row.is_shown());
        let found = judging.filter(|row| row.path.ends_with(end));
        found.map(|row| row.group.clone()).collect::<Vec<_>>()
    };
    assert_eq!(
        find(&desk, "break_load_n")[..2],
        ["check weak wire", "check strong wire"]
    );
    assert_eq!(find(&desk, "hours"), ["statistics"]);
    assert_eq!(find(&desk, "load_cases.1.values"), ["load cases 1"]);
    desk.keys("1 /");
    desk.type_text("weak factor");
    desk.keys("enter enter ctrl+u");
    desk.type_text("-1");
    desk.keys("enter");
    let editing = desk.state.editor().unwrap().editing.as_ref();
    assert!(editing.unwrap().problem.is_some());
    desk.keys("ctrl+u");
    desk.type_text("2.5");
    desk.keys("enter");
    let editor = desk.state.editor().unwrap();
    assert!(editor.text.contains("factor = 2.5"), "{}", editor.text);
    // It is the user's limit, not an input of the run.
    assert!(editor.unsaved() && editor.overrides(&editor.rows).is_empty());
    desk.keys("W");
    let asked = desk.sweeps_asked();
    let has_factor = |effect: &SweepEffect| match effect {
        SweepEffect::Start(_, request) => {
            request.text.contains("factor = 2.5") && request.overrides.is_empty()
        }
        _ => false,
    };
    assert!(asked.iter().any(has_factor));
}

#[test]
fn every_view_is_drawn_at_any_size_and_with_many_values() {
    let many = "
[[load_cases]]
key = \"points.top.period_s\"
range = \"6..16/60\"

[[load_cases]]
key = \"points.clump.mass_kg\"
range = \"300..900/50\"
";
    for more in [LOAD_CASES, many] {
        let text = text(more);
        let mut desk = Desk::with_load_cases(SMALL, &text);
        let ticket = desk.begins();
        let read = sweep(&text, usize::MAX);
        desk.sweep(SweepMsg::Ended(ticket, Ok((read, false))));
        for size in [(40, 10), (60, 12), SMALL, (120, 30), (180, 45), LARGE] {
            desk.tell(Msg::Resize(size.0, size.1));
            for keys in ["G l l l l l l", "g", "enter", "esc", "] G", "] j", "]", "]"] {
                desk.keys(keys);
                assert!(!desk.screen().is_empty());
            }
        }
        desk.tell(Msg::Resize(80, 24));
        desk.keys("G");
        let last = if more == many { "900" } else { "800" };
        assert!(desk.screen().contains(last), "{}", desk.screen());
    }
}
