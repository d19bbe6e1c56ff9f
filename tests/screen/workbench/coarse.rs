//! A slow case answers coarsely first: marked as such everywhere, and never stored, held or reported.

use std::sync::Arc;

use seacable::run::job::{JobEvent, Request};
use seacable::run::{Run, RunState};
use seacable::tui::Msg;
use seacable::tui::state::JobNumber;

use super::desk::{Desk, run};
use super::{SMALL, said, snapshot};

/// An edit whose solve is on its way, with its coarse answer: 10 kN less.
fn answered_coarsely() -> (Desk, JobNumber, Request) {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("j j right");
    let (ticket, request) = desk.started().remove(0);
    desk.tell(Msg::Coarse(ticket, Arc::new(coarse(&request))));
    (desk, ticket, request)
}

fn coarse(request: &Request) -> Run {
    let mut run = run(request, RunState::Done);
    for quantity in &mut run.summary {
        quantity.value -= 1e4;
        (quantity.time_error, quantity.mesh_error) = (None, None);
    }
    run
}

fn finish(desk: &mut Desk, ticket: JobNumber, run: Run) {
    let event = JobEvent::Finished(Box::new(run));
    desk.tell(Msg::Job(ticket, Box::new(event)));
}

#[test]
fn coarse_results_are_marked_until_the_full_ones_are_there() {
    let (mut desk, ticket, request) = answered_coarsely();
    let text = desk.screen();
    assert!(text.contains("coarse: the full solve goes on"), "{text}");
    assert!(text.contains("~1.95 MN"), "{text}");
    assert!(text.contains("(coarse)"), "{text}");
    snapshot("tui_coarse_80x24", &desk);
    finish(&mut desk, ticket, run(&request, RunState::Done));
    let text = desk.screen();
    assert!(!text.contains("coarse") && !text.contains(" ~1"), "{text}");
    assert!(text.contains("1.9550 MN"), "{text}");
}

#[test]
fn coarse_results_are_neither_held_nor_kept_nor_reported() {
    let (mut desk, ..) = answered_coarsely();
    let before = desk
        .state
        .line()
        .unwrap()
        .runs_view
        .against
        .clone()
        .unwrap();
    desk.keys("v");
    assert!(said(&desk).contains("coarse"), "{}", said(&desk));
    let after = desk
        .state
        .line()
        .unwrap()
        .runs_view
        .against
        .clone()
        .unwrap();
    assert!(Arc::ptr_eq(&before.1, &after.1));
    desk.keys("K");
    assert!(
        said(&desk).contains("still being computed"),
        "{}",
        said(&desk)
    );
    let line = desk.state.line().unwrap();
    let solved = line
        .runs_view
        .live
        .done
        .as_ref()
        .unwrap()
        .run
        .as_ref()
        .unwrap();
    assert!(Arc::ptr_eq(&line.runs_view.reported().unwrap().1, solved));
}

#[test]
fn a_later_edit_makes_them_older_than_the_inputs() {
    let (mut desk, ticket, request) = answered_coarsely();
    desk.keys("right");
    let text = desk.screen();
    assert!(text.contains("coarse, older than the inputs"), "{text}");
    // The answer to the earlier edit comes too late.
    let late = Arc::new(coarse(&request));
    desk.tell(Msg::Coarse(ticket, late));
    let live = &desk.state.line().unwrap().runs_view.live;
    assert_ne!(live.coarse.as_ref().unwrap().text, live.going_text);
}

#[test]
fn a_cancelled_solve_leaves_the_coarse_answer_and_says_so() {
    let (mut desk, ticket, request) = answered_coarsely();
    finish(&mut desk, ticket, run(&request, RunState::Cancelled));
    let text = desk.screen();
    assert!(
        text.contains("coarse: the full solve was cancelled"),
        "{text}"
    );
}
