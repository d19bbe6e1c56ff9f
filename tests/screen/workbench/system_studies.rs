//! Studies of a result of a system on the screen: at rest, at rest on its mesh, and in time.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use seacable::case::kind;
use seacable::system::SystemFile;
use seacable::tui::msg::FileRead;
use seacable::tui::pane::PaneId;
use seacable::tui::result_lines;
use seacable::tui::state::{DocumentContent, SystemView};
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{LARGE, SMALL, said, snapshot};

const SEMI_TAUT: &str = include_str!("../../../cases/systems/semi_taut.toml");
const BRIDLE: &str = include_str!("../../../cases/systems/bridle_in_heave.toml");

impl Desk {
    /// A system with this text, open at its results.
    fn at_results_of(size: (u16, u16), text: &str) -> Self {
        let mut desk = Self::new(size);
        let solved = kind::parse::<SystemFile>(text, "system.toml").unwrap();
        let content = DocumentContent::System(Box::new(SystemView::new(solved)));
        let path = PathBuf::from("cases/system.toml");
        let read = FileRead::new(path, text.to_owned(), content, None);
        desk.tell(Msg::FileRead(Box::new(read)));
        let panes = desk.state.panes();
        let at = panes.iter().position(|pane| *pane == PaneId::Results);
        desk.keys(&(at.unwrap() + 1).to_string());
        desk
    }

    /// Computes the study that was asked for, and shows its page without what it cost.
    fn study(&mut self) {
        let asked = std::mem::take(&mut self.asked);
        let studies = asked.into_iter().filter_map(|effect| match effect {
            Effect::Study(request, _) => Some(request),
            _ => None,
        });
        for request in studies {
            let page = request.page(&AtomicBool::new(false), &|_| {});
            let page = page.map(|text| {
                let lines = text.lines().filter(|line| !line.starts_with("Cost:"));
                lines.collect::<Vec<_>>().join("\n")
            });
            let title = request.of.title(&request.result);
            self.tell(Msg::Page(title, page, true));
        }
    }
}

fn names(desk: &Desk) -> Vec<String> {
    let listed = result_lines::all(desk.state.document.as_ref().unwrap());
    listed.into_iter().map(|line| line.name).collect()
}

/// At rest the results have values before anything is run; each input is varied, and each effect left out.
#[test]
fn what_matters_to_a_system_at_rest_and_what_it_needs() {
    let mut desk = Desk::at_results_of(SMALL, SEMI_TAUT);
    assert_eq!(names(&desk)[1], "tension_n[mooring|b].final");
    desk.keys("j");
    snapshot("tui_results_at_rest_80x24", &desk);
    desk.keys("i");
    let study = desk.state.document.as_ref().unwrap().study.as_ref();
    assert_eq!(study.map(|study| study.all), Some(0));
    desk.study();
    snapshot("tui_effects_at_rest_80x24", &desk);
    assert!(desk.state.document.as_ref().unwrap().study.is_none());
    desk.keys("esc P");
    desk.study();
    let screen = desk.screen();
    assert!(
        screen.contains("what tension_n[mooring|b].final needs"),
        "{screen}"
    );
    assert!(screen.contains("elasticity: matters"), "{screen}");
    // They are not solved with every edit, and stand beside nothing.
    desk.keys("esc space");
    assert!(
        said(&desk).contains("Only results of a line case"),
        "{}",
        said(&desk)
    );
    let desk = Desk::at_results_of(LARGE, SEMI_TAUT);
    snapshot("tui_results_at_rest_200x60", &desk);
}

/// By the method static the results are those of a run, which the study computes whether it was run before or not.
#[test]
fn studies_of_a_system_by_the_method_static() {
    let text = format!("{SEMI_TAUT}\n[solver]\nmethod = \"static\"\n");
    let mut desk = Desk::at_results_of(SMALL, &text);
    assert_eq!(names(&desk)[1], "tension_n[mooring|b].max");
    assert!(
        desk.screen().contains("not computed yet"),
        "{}",
        desk.screen()
    );
    desk.keys("j i");
    desk.study();
    let screen = desk.screen();
    assert!(
        screen.contains("what matters to tension_n[mooring|b].max"),
        "{screen}"
    );
    assert!(
        screen.contains("[1] points.anchor.position_m.x"),
        "{screen}"
    );
    desk.keys("esc P");
    desk.study();
    let screen = desk.screen();
    assert!(screen.contains("elasticity: matters"), "{screen}");
    assert!(screen.contains("mesh halved"), "{screen}");
}

/// In time the results of a run of the same text are listed, with their errors.
#[test]
fn studies_of_a_system_in_time() {
    let text = BRIDLE.replace("segments = 40", "segments = 8").replace(
        "duration_s = 60.0",
        "duration_s = 2.0\nerror_estimate = false",
    );
    let mut desk = Desk::at_results_of(SMALL, &text);
    let before = names(&desk);
    desk.keys("R");
    desk.compute(f64::INFINITY, true);
    let after = names(&desk);
    assert!(
        before.iter().all(|name| after.contains(name)),
        "{before:?} {after:?}"
    );
    assert!(after.len() > before.len());
    snapshot("tui_results_in_time_80x24", &desk);
    desk.keys("P");
    desk.study();
    let screen = desk.screen();
    assert!(screen.contains("inertia: matters"), "{screen}");
    // Another text has no run yet.
    desk.keys("esc 1");
    desk.keys("/ d u r a t i o n enter enter ctrl+u 3 enter 9");
    assert!(
        desk.screen().contains("not computed yet"),
        "{}",
        desk.screen()
    );
}
