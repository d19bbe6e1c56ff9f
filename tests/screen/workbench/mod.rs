//! The screens without a terminal: what keys do, and what it looks like.

#![expect(clippy::float_cmp, reason = "compares numbers that are the same bits")]

mod beside;
mod bindings;
mod build;
mod coarse;
mod column_plot;
mod columns;
mod command_line;
mod curves;
mod desk;
mod earlier;
mod footer;
mod hostile;
mod job_processes;
mod line_types;
mod marks;
mod modes;
mod parts;
mod pending;
mod random;
mod reports;
mod response;
mod resume;
mod ropeway;
mod section;
mod ship;
mod sweeps;
mod system;
mod system_runs;
mod system_studies;
mod tutorial;
mod umbilical;
mod vary;

use std::path::PathBuf;

use desk::{Desk, content_of, looks, run, shared};
use seacable::chart::Glyphs;
use seacable::run::RunState;
use seacable::run::job::JobEvent;
use seacable::tui::command_line::candidates::{CompletionCandidate, candidates};
use seacable::tui::key::KeyPress;
use seacable::tui::panes;
use seacable::tui::recovery::RecoveredEdits;
use seacable::tui::state::{JobState, Overlay, PromptPurpose, Question, Severity};
use seacable::tui::{Effect, Msg};

const SMALL: (u16, u16) = (80, 24);
const LARGE: (u16, u16) = (200, 60);

fn snapshot(name: &str, desk: &Desk) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, desk.screen()));
}

fn said(desk: &Desk) -> &str {
    desk.state.note.as_ref().map_or("", |note| &note.text)
}

fn has(desk: &Desk, wanted: impl Fn(&Effect) -> bool) -> bool {
    desk.asked.iter().any(wanted)
}

#[test]
fn the_case_list() {
    let mut desk = Desk::new(SMALL);
    snapshot("tui_cases_80x24", &desk);
    desk.keys("j");
    snapshot("tui_cases_broken_80x24", &desk);
}

#[test]
fn the_panes_of_a_case_at_80x24() {
    let mut desk = Desk::with_case(SMALL);
    snapshot("tui_inputs_80x24", &desk);
    desk.keys("2");
    snapshot("tui_tensions_80x24", &desk);
    desk.keys("] ] ]");
    snapshot("tui_shape_80x24", &desk);
    desk.keys("3");
    snapshot("tui_runs_80x24", &desk);
    desk.keys("4");
    snapshot("tui_validation_80x24", &desk);
    desk.keys("5");
    snapshot("tui_report_80x24", &desk);
    desk.keys("6");
    snapshot("tui_jobs_80x24", &desk);
    desk.keys("?");
    snapshot("tui_help_80x24", &desk);
}

#[test]
fn everything_at_once_at_200x60() {
    let mut desk = Desk::with_case(LARGE);
    snapshot("tui_case_200x60", &desk);
    desk.keys("2 l l l l l l l l");
    snapshot("tui_charts_cursor_200x60", &desk);
}

#[test]
fn two_panes_at_120x30_without_colour_in_ascii() {
    let mut desk = Desk::with_case((120, 30));
    desk.state.capabilities = looks(Glyphs::Ascii, false);
    snapshot("tui_ascii_mono_120x30", &desk);
    let buffer = desk.buffer();
    assert!(buffer.content().iter().all(|cell| cell.symbol().is_ascii()));
    let plain = ratatui::style::Color::Reset;
    assert!(
        buffer
            .content()
            .iter()
            .all(|cell| cell.fg == plain && cell.bg == plain)
    );
}

#[test]
fn a_screen_that_is_too_small_says_so() {
    for size in [(39, 24), (80, 9), (1, 1)] {
        let desk = Desk::with_case(size);
        let text = desk.screen();
        assert!(
            text.starts_with(&"need 40x10"[..usize::from(size.0).min(10)]),
            "{text}"
        );
    }
}

#[test]
fn a_bad_value_is_refused_with_its_reason_and_a_good_one_solves_again() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("/");
    desk.type_text("current speed");
    desk.keys("enter enter ctrl+u");
    desk.type_text("99");
    desk.keys("enter");
    snapshot("tui_refused_80x24", &desk);
    assert!(desk.started().is_empty());
    desk.keys("ctrl+u");
    desk.type_text("0.8");
    desk.keys("enter");
    let started = desk.started();
    assert_eq!(started.len(), 1);
    assert!(started[0].1.text.contains("speed_m_per_s = 0.8  # along x"));
    assert_eq!(started[0].1.overrides, ["current.speed_m_per_s=0.8"]);
    assert!(desk.state.editor().unwrap().unsaved());
    desk.keys("u");
    assert!(!desk.state.editor().unwrap().unsaved());
    desk.keys("U");
    assert!(desk.state.editor().unwrap().unsaved());
    desk.keys("r");
    assert!(!desk.state.editor().unwrap().unsaved());
}

#[test]
fn the_newest_solve_wins_and_the_old_curve_stays_dimmed_until_it_lands() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("M");
    let first = desk.started().remove(0);
    desk.keys("M");
    assert!(has(
        &desk,
        |e| matches!(e, Effect::Cancel(t) if *t == first.0)
    ));
    let second = desk.started().remove(0);
    desk.stream(second.0, &second.1, 150.0);
    // What the old job still says changes nothing.
    let before = desk.buffer();
    desk.stream(first.0, &first.1, 600.0);
    let late = run(&first.1, RunState::Done);
    desk.tell(Msg::Job(
        first.0,
        Box::new(JobEvent::Finished(Box::new(late))),
    ));
    assert_eq!(desk.buffer(), before);
    desk.keys("2");
    snapshot("tui_live_80x24", &desk);
    let whole = run(&second.1, RunState::Done);
    desk.tell(Msg::Job(
        second.0,
        Box::new(JobEvent::Finished(Box::new(whole))),
    ));
    let open = desk.state.line().unwrap();
    assert!(
        open.runs_view.live.going.is_none()
            && open.runs_view.live.done_text == desk.state.editor().unwrap().text
    );
}

#[test]
fn a_run_is_stored_validated_and_reported() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("R");
    assert!(has(&desk, |e| matches!(
        e,
        Effect::Start { store: true, .. }
    )));
    desk.finish_jobs();
    let open = desk.state.line().unwrap();
    assert_eq!(open.runs_view.runs.len(), 1);
    assert_eq!(open.checks.rows.len(), 2);
    desk.keys("5 w");
    let written = desk.asked.iter().find_map(|e| match e {
        Effect::WriteText { path, text, .. } => Some((path.clone(), text.clone())),
        _ => None,
    });
    let (path, text) = written.unwrap();
    assert!(path.starts_with("runs"), "{}", path.display());
    assert!(text.contains("Body lowered on a chain and a rope"));
}

#[test]
fn a_study_runs_all_its_variants_one_after_the_other_and_overlays_them() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("S");
    let running = desk
        .state
        .jobs
        .lines
        .iter()
        .filter(|l| l.state == JobState::Running);
    assert_eq!(running.count(), 1);
    assert_eq!(desk.state.jobs.waiting.len(), 1);
    desk.finish_jobs();
    snapshot("tui_study_80x24", &desk);
    desk.keys("S");
    assert_eq!(said(&desk), "Everything needed has been run already.");
}

#[test]
fn runs_can_be_overlaid_shown_alone_and_deleted_after_a_question() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("S");
    desk.finish_jobs();
    desk.keys("3 g space");
    assert!(!desk.state.line().unwrap().runs_view.live.hidden);
    desk.keys("enter");
    let open = desk.state.line().unwrap();
    assert!(
        open.runs_view.live.hidden && open.runs_view.runs[0].shown && !open.runs_view.runs[1].shown
    );
    desk.keys("d");
    snapshot("tui_delete_80x24", &desk);
    desk.keys("esc");
    assert!(!has(&desk, |e| matches!(e, Effect::DeleteRuns(_))));
    desk.keys("d d");
    let dir = desk.state.line().unwrap().runs_view.runs[0]
        .dir
        .clone()
        .unwrap();
    assert!(has(
        &desk,
        |e| matches!(e, Effect::DeleteRuns(d) if *d == [dir.clone()])
    ));
    desk.tell(Msg::RunsDeleted(vec![dir]));
    assert_eq!(desk.state.line().unwrap().runs_view.runs.len(), 1);
}

#[test]
fn control_c_cancels_first_and_quits_second() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("R");
    let (ticket, request) = desk.started().remove(0);
    desk.keys("ctrl+c");
    assert!(has(
        &desk,
        |e| matches!(e, Effect::Cancel(t) if *t == ticket)
    ));
    assert!(
        said(&desk).ends_with("Ctrl-C again quits."),
        "{}",
        said(&desk)
    );
    let cancelled = run(&request, RunState::Cancelled);
    desk.tell(Msg::Job(
        ticket,
        Box::new(JobEvent::Finished(Box::new(cancelled))),
    ));
    desk.keys("ctrl+c");
    assert!(has(&desk, |e| matches!(e, Effect::Quit)));
}

#[test]
fn quitting_asks_while_jobs_run_and_proceeds_when_they_end() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("R q");
    assert!(matches!(
        desk.state.overlay,
        Some(Overlay::Ask(Question::JobsRunning))
    ));
    assert!(!has(&desk, |e| matches!(e, Effect::Quit)));
    desk.finish_jobs();
    assert!(desk.state.overlay.is_none());
    assert!(has(&desk, |e| matches!(e, Effect::Quit)));
}

#[test]
fn unsaved_changes_ask_and_are_kept_for_recovery_meanwhile() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("M q");
    assert!(has(&desk, |e| matches!(
        e,
        Effect::KeepRecovery { text: Some(_), .. }
    )));
    snapshot("tui_unsaved_80x24", &desk);
    desk.keys("s");
    let saved = desk.asked.iter().find_map(|e| match e {
        Effect::SaveCase { path, text, .. } => Some((path.clone(), text.clone())),
        _ => None,
    });
    let (path, text) = saved.unwrap();
    desk.tell(Msg::Saved(path, text));
    assert!(has(&desk, |e| matches!(e, Effect::Quit)));
    assert!(has(&desk, |e| matches!(
        e,
        Effect::KeepRecovery { text: None, .. }
    )));
}

#[test]
fn edits_made_while_a_save_is_on_its_way_are_saved_after_it_and_kept_until_then() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("M s M s");
    let saves: Vec<(String, Option<String>)> = desk
        .asked
        .iter()
        .filter_map(|effect| match effect {
            Effect::SaveCase { text, expected, .. } => Some((text.clone(), expected.clone())),
            _ => None,
        })
        .collect();
    assert_eq!(saves.len(), 2);
    assert_eq!(saves[0].1.as_deref(), Some(desk::CASE));
    assert_eq!(saves[1].1.as_ref(), Some(&saves[0].0));
    desk.asked.clear();
    let path = PathBuf::from("cases/body.toml");
    desk.tell(Msg::Saved(path.clone(), saves[0].0.clone()));
    let dropped = |e: &Effect| matches!(e, Effect::KeepRecovery { text: None, .. });
    assert!(!has(&desk, dropped), "{:?}", desk.asked);
    assert!(has(
        &desk,
        |e| matches!(e, Effect::KeepRecovery { text: Some(text), .. } if *text == saves[1].0)
    ));
    desk.tell(Msg::Saved(path, saves[1].0.clone()));
    assert!(has(&desk, dropped));
    assert!(!desk.state.editor().unwrap().unsaved());
    // Without an answer on its way, the file is what was saved last.
    desk.keys("M s");
    desk.tell(Msg::ChangedOnDisk);
    desk.keys("c");
    desk.asked.clear();
    desk.keys("s");
    assert!(has(
        &desk,
        |e| matches!(e, Effect::SaveCase { expected: Some(text), .. } if *text == saves[1].0)
    ));
}

#[test]
fn edits_of_an_earlier_session_are_dropped_only_after_they_are_kept_anew() {
    let mut desk = Desk::new(SMALL);
    let recovered = RecoveredEdits {
        text: desk::CASE.replace("= 0.3", "= 0.7"),
        kept: Vec::new(),
    };
    desk.tell(Msg::FileRead(Box::new(seacable::tui::msg::FileRead::new(
        PathBuf::from("cases/body.toml"),
        desk::CASE.to_owned(),
        content_of(seacable::case::parse(desk::CASE, "body.toml").unwrap()),
        Some(recovered.clone()),
    ))));
    desk.keys("r");
    let dropped = |e: &Effect| matches!(e, Effect::DropRecovery(_));
    assert!(!has(&desk, dropped), "{:?}", desk.asked);
    assert!(has(&desk, |e| matches!(
        e,
        Effect::TakeOverRecovery { text: Some(text), .. } if *text == recovered.text
    )));
}

#[test]
fn a_file_that_cannot_be_written_offers_another_name() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("M s");
    desk.tell(Msg::NotSaved(
        "cases/body.toml cannot be written: it is read-only.".to_owned(),
    ));
    assert!(matches!(
        desk.state.overlay,
        Some(Overlay::Prompt {
            purpose: PromptPurpose::SaveAs,
            ..
        })
    ));
    assert_eq!(desk.state.note.as_ref().unwrap().level, Severity::Error);
    desk.asked.clear();
    desk.keys("enter");
    assert!(has(&desk, |e| matches!(
        e,
        Effect::SaveCase { path, new: true, .. } if path.as_os_str() == "body-copy.toml"
    )));
}

#[test]
fn edits_of_an_earlier_session_are_offered() {
    let mut desk = Desk::new(SMALL);
    let edited = desk::CASE.replace("= 0.3", "= 0.7");
    let recovered = RecoveredEdits {
        text: edited.clone(),
        kept: vec!["payload.drag_area_m2=100, 120".to_owned()],
    };
    desk.tell(Msg::FileRead(Box::new(seacable::tui::msg::FileRead::new(
        PathBuf::from("cases/body.toml"),
        desk::CASE.to_owned(),
        content_of(seacable::case::parse(desk::CASE, "body.toml").unwrap()),
        Some(recovered),
    ))));
    desk.keys("r");
    assert_eq!(desk.state.editor().unwrap().text, edited);
    assert!(desk.state.editor().unwrap().unsaved());
    assert_eq!(desk.state.editor().unwrap().kept.len(), 1);
    desk.keys("u");
    assert_eq!(desk.state.editor().unwrap().text, desk::CASE);
}

#[test]
fn a_terminal_of_ascii_is_sent_ascii_whatever_a_file_says() {
    let mut desk = Desk::with_case(SMALL);
    desk.state.capabilities = looks(Glyphs::Ascii, true);
    desk.state
        .say(Severity::Info, "Dépôt at 20 °C: 5 ± 1 m², 0…1");
    let screen = desk.screen();
    assert!(screen.is_ascii());
    assert!(
        screen.contains("Depot at 20 degC: 5 +/- 1 m2, 0...1"),
        "{screen}"
    );
}

#[test]
fn a_file_that_was_named_is_searched_before_there_is_a_list() {
    let mut desk = Desk::unread(SMALL);
    assert!(
        desk.screen()
            .contains("The cases of the directory are being read.")
    );
    desk.state.cases.opening = Some(PathBuf::from("slow.toml"));
    let words = "slow.toml is being read, and its equilibrium searched.";
    assert!(desk.screen().contains(words), "{}", desk.screen());
    desk.keys("enter");
    assert_eq!(said(&desk), "The cases are still being read.");
    let rejected = Msg::CaseRejected(PathBuf::from("slow.toml"), "no equilibrium".to_owned());
    desk.tell(rejected);
    desk.keys("esc");
    assert!(!desk.screen().contains(words), "{}", desk.screen());
    desk.tell(Msg::CasesRead(PathBuf::from("cases"), Vec::new()));
    assert!(
        desk.screen().contains("There is no case file"),
        "{}",
        desk.screen()
    );
}

#[test]
fn a_broken_case_opens_in_the_editor_from_the_list() {
    let mut desk = Desk::new(SMALL);
    desk.keys("G");
    let edits =
        |effect: &Effect| matches!(effect, Effect::EditFile(path) if path.ends_with("broken.toml"));
    desk.keys("E");
    assert!(has(&desk, edits));
    desk.asked.clear();
    // As the editor left it, it is still broken; the list of what is wrong offers the editor too.
    desk.tell(Msg::Edited(Err("line 21 is wrong".to_owned())));
    assert!(has(&desk, |effect| matches!(effect, Effect::ReadCases)));
    assert!(desk.screen().contains("E opens it in your editor"));
    desk.asked.clear();
    desk.keys("E");
    assert!(has(&desk, edits));
    desk.tell(Msg::Edited(Ok(String::new())));
    assert!(said(&desk).contains("Enter opens the file"));
}

#[test]
fn long_messages_take_two_lines_and_say_where_the_rest_is() {
    let mut desk = Desk::with_case(SMALL);
    let long = "word ".repeat(25);
    desk.state.say(Severity::Error, format!("{long}end"));
    let screen = desk.screen();
    assert!(
        screen.contains("end") && !screen.contains("shows all"),
        "{screen}"
    );
    desk.state.say(Severity::Error, format!("{long}{long}end"));
    let screen = desk.screen();
    assert!(screen.contains("… (! shows all)"), "{screen}");
    desk.keys("! G");
    assert!(desk.screen().contains("end"));
}

#[test]
fn the_report_scrolls_to_its_last_page_and_back() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("R");
    desk.finish_jobs();
    desk.keys("5");
    let first = desk.screen();
    desk.keys("G");
    let (_, report) = desk.state.line().unwrap().runs_view.report.clone().unwrap();
    let rows: Vec<String> = desk.screen().lines().take(22).map(str::to_owned).collect();
    let last = report.lines().last().unwrap();
    // Head, tabs, the name of the report, 19 lines of it, and the line of messages.
    assert_eq!(rows[21].trim_end(), last.trim_end(), "{rows:#?}");
    desk.keys("k g");
    assert_eq!(desk.screen(), first);
}

#[test]
fn the_selected_tab_is_seen_on_narrow_screens() {
    for columns in [40, 60] {
        let mut desk = Desk::with_case((columns, 24));
        for (number, title) in [(1, "Inputs"), (4, "Validation"), (6, "Jobs"), (8, "Modes")] {
            desk.keys(&number.to_string());
            let screen = desk.screen();
            let tabs = screen.lines().nth(1).unwrap();
            assert!(tabs.contains(&format!("{number} {title}")), "{screen}");
            assert!(tabs.contains('<') || tabs.contains('>'), "{screen}");
        }
    }
}

#[test]
fn the_palette_finds_a_command_by_its_words_and_does_it() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys(":");
    desk.type_text("braille");
    desk.keys("enter");
    assert_eq!(desk.state.capabilities.glyphs, Glyphs::Ascii);
    assert!(has(&desk, |e| matches!(
        e,
        Effect::RememberGlyphs(Glyphs::Ascii)
    )));
}

#[test]
fn a_command_that_cannot_be_done_says_why() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("u");
    assert_eq!(said(&desk), "There is nothing to undo.");
    desk.keys("f2");
    assert!(said(&desk).contains("`f2` does nothing here"));
}

#[test]
fn a_paste_goes_to_the_field_and_never_to_the_commands() {
    let mut desk = Desk::with_case(SMALL);
    desk.tell(Msg::Paste("q\nq".to_owned()));
    assert!(desk.state.overlay.is_none());
    desk.keys("x g enter ctrl+u");
    desk.tell(Msg::Paste("9.81\n".to_owned()));
    desk.keys("enter");
    assert_eq!(
        desk.state.line().unwrap().case.environment.gravity_m_per_s2,
        9.81
    );
}

#[test]
fn the_statistics_of_the_curves_are_of_what_is_shown() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("2 i");
    let Some(Overlay::Page { text, .. }) = &desk.state.overlay else {
        panic!("there is no page");
    };
    assert!(
        text.contains("mean") && text.contains("vessel|chain"),
        "{text}"
    );
    let whole = text.clone();
    desk.keys("esc l + + i");
    let Some(Overlay::Page { text, .. }) = &desk.state.overlay else {
        panic!("there is no page");
    };
    assert_ne!(*text, whole, "a window has statistics of its own");
}

#[test]
fn the_live_run_can_be_kept() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("K");
    assert!(has(&desk, |e| matches!(e, Effect::KeepRun(_))));
    desk.keys("R");
    let request = desk.started().remove(0).1;
    desk.tell(Msg::Kept(PathBuf::from("runs/body-1"), shared(&request)));
    desk.keys("K");
    assert_eq!(said(&desk), "The live run is already kept.");
}

#[test]
fn the_charts_share_one_instant() {
    let mut desk = Desk::with_case(LARGE);
    desk.keys("2 l pgdn");
    let open = desk.state.line().unwrap();
    let at = open.runs_view.instant.unwrap();
    assert!((300.0..420.0).contains(&at), "{at}");
    assert!(desk.screen().contains("line at 400 s"));
    desk.keys("0");
    assert_eq!(desk.state.line().unwrap().runs_view.instant, None);
}

#[test]
fn every_command_can_be_reached_by_a_key_or_by_its_name() {
    let desks = [
        Desk::new(SMALL),
        Desk::with_case(SMALL),
        Desk::with_section(SMALL),
        Desk::with_ropeway(SMALL),
        Desk::with_ship(SMALL),
        Desk::with_system(SMALL),
    ];
    let eaten = ["ctrl+a", "ctrl+b", "ctrl+s", "ctrl+q"];
    for mut desk in desks {
        for id in desk.state.panes().iter().copied().map(Some).chain([None]) {
            if let (Some(id), Some(document)) = (id, &mut desk.state.document) {
                document.pane = id;
            }
            let mut seen = std::collections::BTreeMap::new();
            for command in panes::commands(&desk.state) {
                assert!(!command.doc.is_empty(), "{command:?}");
                let found = candidates(&desk.state, command.doc);
                let is_it = |c: &CompletionCandidate| matches!(c, CompletionCandidate::Command(of) if of.id == command.id);
                assert!(found.iter().any(is_it), "{}", command.doc);
                for key in command.keys.iter() {
                    let spelled = key.parse::<KeyPress>().map(|k| k.to_string());
                    assert_eq!(spelled.as_deref(), Ok(key));
                    assert!(
                        !eaten.contains(&key),
                        "multiplexers and flow control take `{key}`"
                    );
                    let other = seen.insert(key.to_owned(), command.id);
                    assert_eq!(other, None, "`{key}` at {id:?} is also {:?}", command.id);
                }
            }
        }
    }
}
