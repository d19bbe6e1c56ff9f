//! Curves of a chart: hidden one by one, named at their ends, as differences, on logarithmic axes.

use std::sync::Arc;

use seacable::tui::plots;

use super::desk::Desk;
use super::{SMALL, said, snapshot};

#[test]
fn each_curve_is_hidden_and_shown_again() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("2 c");
    snapshot("tui_curves_80x24", &desk);
    desk.keys("j space esc");
    let visible = |desk: &Desk| -> Vec<bool> {
        let line = desk.state.line().unwrap();
        let chart = plots::viewed(desk.state.charted().unwrap(), line.runs_view.chart);
        chart.series.iter().map(|series| series.visible).collect()
    };
    assert_eq!(visible(&desk), [true, false, true]);
    let text = desk.screen();
    assert!(
        text.contains("1 hidden") && !text.contains("x chain|rope"),
        "{text}"
    );
    // Another chart has all of its curves, this one still not.
    desk.keys("]");
    assert_eq!(visible(&desk), [true, true]);
    desk.keys("[ c space a esc");
    assert_eq!(visible(&desk), [true, true, true]);
    desk.keys("c space space q");
    assert_eq!(visible(&desk), [true, true, true]);
}

#[test]
fn a_hidden_curve_stays_hidden_beside_a_later_run() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("2 c j space esc 1 j j right 2");
    let line = desk.state.line().unwrap();
    let chart = plots::viewed(desk.state.charted().unwrap(), line.runs_view.chart);
    let hidden = chart.series.iter().filter(|series| !series.visible);
    let hidden: Vec<&str> = hidden.map(|series| series.label.as_str()).collect();
    assert!(!hidden.is_empty() && hidden.iter().all(|name| name.starts_with("chain|rope")));
}

#[test]
fn curves_are_drawn_less_those_of_the_run_held() {
    let mut desk = Desk::with_case(SMALL);
    let line = desk.state.line_mut().unwrap();
    let held = line.runs_view.against.as_mut().unwrap();
    let mut other = (*held.1).clone();
    for value in &mut other.history.channels[1].values {
        *value -= 5e4;
    }
    *held = ("run 3".to_owned(), Arc::new(other));
    desk.keys("2 d");
    assert!(
        said(&desk).contains("less those of run 3"),
        "{}",
        said(&desk)
    );
    let line = desk.state.line().unwrap();
    let chart = plots::viewed(desk.state.charted().unwrap(), line.runs_view.chart);
    let last = |i: usize| chart.series[i].points.last().unwrap().1;
    assert_eq!([last(0), last(1), last(2)], [0.0, 5e4, 0.0]);
    snapshot("tui_difference_80x24", &desk);
    desk.keys("d");
    let line = desk.state.line().unwrap();
    assert!(
        plots::viewed(desk.state.charted().unwrap(), line.runs_view.chart).series[0].points[60].1
            > 1e6
    );
    // Not of shapes.
    desk.keys("] ] d");
    assert!(
        said(&desk).contains("Only curves against time"),
        "{}",
        said(&desk)
    );
}

#[test]
fn a_chart_has_logarithmic_axes() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("2 g");
    snapshot("tui_log_80x24", &desk);
    desk.keys("G");
    let text = desk.screen();
    assert!(text.contains("time, log [s]"), "{text}");
    // Cursor and zoom follow the axis.
    desk.keys("l + + l l L - - 0 g G");
    let text = desk.screen();
    assert!(!text.contains(", log"), "{text}");
    desk.keys("] ] g");
    assert!(said(&desk).contains("linear"), "{}", said(&desk));
}
