//! A column of the table of runs against another.

use seacable::run::index::{InputColumn, MeasuredResult, ResultColumn, RunColumns};
use seacable::tui::msg::RunsFound;
use seacable::tui::state::{Overlay, RunColumn};
use seacable::tui::{Effect, Msg};

use super::desk::Desk;
use super::{SMALL, has, said, snapshot};

const SPEEDS: [&str; 4] = ["0.8", "0.2", "0.6", "0.4"];

/// Four runs over the current speed, as the index has them.
fn with_runs() -> Desk {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("/");
    desk.type_text("current speed");
    desk.keys("enter enter ctrl+u");
    desk.type_text(&SPEEDS.join(", "));
    desk.keys("enter");
    desk.finish_jobs();
    let runs = desk.state.line().unwrap().runs_view.runs.all().to_vec();
    let changed: Vec<_> = (1..)
        .zip(runs)
        .map(|(number, mut run)| {
            run.number = Some(number);
            run
        })
        .collect();
    let all: Vec<i64> = changed.iter().filter_map(|run| run.number).collect();
    let measured = |at: usize| MeasuredResult {
        value: 1e5 * (1.0 + SPEEDS[at].parse::<f64>().unwrap()),
        unit: "N".to_owned(),
        error: Some(6e3),
        unsettled: None,
    };
    let results = ["tension_n[top]:max", "tension_n[top]:min"].map(|name| ResultColumn {
        name: name.to_owned(),
        values: all.iter().copied().zip((0..4).map(measured)).collect(),
    });
    let values = SPEEDS.iter().map(|speed| Some((*speed).to_owned()));
    let columns = RunColumns {
        inputs: vec![InputColumn {
            key: "current.speed_m_per_s".to_owned(),
            usual: None,
            values: all.iter().copied().zip(values).collect(),
        }],
        results: results.to_vec(),
    };
    desk.tell(Msg::RunsListed(Box::new(RunsFound {
        changed,
        all,
        columns: Some(columns),
        whole: true,
    })));
    desk
}

fn pair(desk: &Desk) -> (RunColumn, RunColumn) {
    match &desk.state.overlay {
        Some(Overlay::Columns(pair)) => {
            let [x, y] = pair
                .columns(&desk.state.line().unwrap().runs_view.runs)
                .unwrap();
            (x, y)
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_first_result_against_the_first_input() {
    let mut desk = with_runs();
    desk.keys("p");
    assert_eq!(pair(&desk), (RunColumn::Input(0), RunColumn::Result(0)));
    snapshot("tui_columns_80x24", &desk);
    desk.keys("]");
    assert_eq!(pair(&desk).1, RunColumn::Result(1));
    desk.keys("] [ [");
    assert_eq!(pair(&desk).1, RunColumn::Result(0));
    desk.keys("}");
    assert_eq!(pair(&desk).0, RunColumn::Result(1));
    desk.keys("{ {");
    assert_eq!(pair(&desk).0, RunColumn::Cpu);
    desk.keys("esc");
    assert!(desk.state.overlay.is_none());
}

#[test]
fn chart_and_values_are_written_in_the_order_along_x() {
    let mut desk = with_runs();
    desk.keys("p w");
    let written = |effect: &Effect| match effect {
        Effect::WriteText { path, text, .. } => {
            let lines: Vec<&str> = text.lines().rev().take(4).collect();
            let speeds: Vec<&str> = lines
                .iter()
                .rev()
                .filter_map(|line| line.split_whitespace().next())
                .collect();
            path.ends_with("body-runs.txt") && speeds == ["0.2", "0.4", "0.6", "0.8"]
        }
        _ => false,
    };
    assert!(has(&desk, written), "{:?}", desk.asked);
    assert!(matches!(desk.state.overlay, Some(Overlay::Columns(_))));
}

#[test]
fn the_columns_stay_when_the_table_has_others() {
    let mut desk = with_runs();
    desk.keys("p ]");
    let runs = desk.state.line().unwrap().runs_view.runs.clone();
    let (mut columns, title) = (runs.columns.clone(), title(&desk));
    columns.results.swap(0, 1);
    let before = InputColumn {
        key: "current.depth_m".to_owned(),
        ..columns.inputs[0].clone()
    };
    columns.inputs.insert(0, before);
    let all = runs.all().iter().filter_map(|run| run.number).collect();
    desk.tell(Msg::RunsListed(Box::new(RunsFound {
        changed: Vec::new(),
        all,
        columns: Some(columns),
        whole: true,
    })));
    assert_eq!(pair(&desk), (RunColumn::Input(1), RunColumn::Result(0)));
    assert_eq!(self::title(&desk), title);
}

fn title(desk: &Desk) -> String {
    match &desk.state.overlay {
        Some(Overlay::Columns(pair)) => pair.title(&desk.state.line().unwrap().runs_view.runs),
        other => panic!("{other:?}"),
    }
}

#[test]
fn sorting_scrolls_to_its_column() {
    let mut desk = with_runs();
    desk.keys("3");
    let columns = desk
        .state
        .line()
        .unwrap()
        .runs_view
        .runs
        .shown_columns()
        .to_vec();
    for column in columns {
        desk.keys("o");
        let sort = desk.state.line().unwrap().runs_view.runs.sort;
        assert_eq!(sort, Some((column, false)));
        let text = desk.screen();
        assert!(text.contains(" ^"), "{column:?}\n{text}");
    }
    desk.keys("o");
    let runs = &desk.state.line().unwrap().runs_view.runs;
    assert_eq!((runs.sort, runs.scroll), (None, 0));
}

#[test]
fn the_filter_of_the_table_applies() {
    let mut desk = with_runs();
    desk.keys("/");
    desk.type_text("speed>0.3");
    desk.keys("enter p");
    let text = desk.screen();
    assert!(text.contains("3 of 3 runs"), "{text}");
}

#[test]
fn without_runs_it_says_why_not() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("3 p");
    assert!(desk.state.overlay.is_none());
    assert!(said(&desk).contains("no two columns"), "{}", said(&desk));
}

#[test]
fn its_axes_are_logarithmic_on_request() {
    let mut desk = with_runs();
    desk.keys("3 p g G");
    let text = desk.screen();
    assert!(
        text.contains(", log [kN]") && text.contains(", log [m/s]"),
        "{text}"
    );
    desk.keys("g G");
    assert!(!desk.screen().contains(", log"));
}
