//! Reports written from the screen, in the format that is asked for, and charts as pictures.

use seacable::tui::msg::Effect;
use seacable::tui::state::{Overlay, Question};

use super::SMALL;
use super::desk::Desk;
use super::snapshot;

/// What is to be written: paths and texts, in order.
fn written(desk: &Desk) -> Vec<(String, String)> {
    let written = desk.asked.iter().filter_map(|effect| match effect {
        Effect::WriteText { path, text, .. } => Some((path.display().to_string(), text.clone())),
        _ => None,
    });
    written.collect()
}

/// A screen with a finished run on its report pane.
fn reported() -> Desk {
    let mut desk = Desk::with_case(SMALL);
    desk.keys("R");
    desk.finish_jobs();
    desk.keys("5");
    desk
}

#[test]
fn the_format_of_a_report_is_asked_for() {
    let mut desk = reported();
    desk.keys("F");
    assert!(matches!(
        desk.state.overlay,
        Some(Overlay::Ask(Question::ReportFormat))
    ));
    snapshot("tui_report_format_80x24", &desk);
    desk.keys("esc");
    assert!(desk.state.overlay.is_none() && written(&desk).is_empty());
    for (key, ending, begins) in [
        ("h", "html", "<!DOCTYPE html>"),
        ("m", "md", "# Body lowered on a chain and a rope"),
        ("t", "txt", "Body lowered on a chain and a rope"),
        ("v", "csv", "quantity,value,unit,error,"),
        ("j", "json", "{"),
    ] {
        desk.keys(&format!("F {key}"));
        let (path, text) = written(&desk).pop().unwrap();
        assert!(
            path.starts_with("runs") && path.ends_with(&format!("report.{ending}")),
            "{path}"
        );
        assert!(text.starts_with(begins), "{text}");
    }
    // The text is what the pane shows and `w` writes.
    desk.keys("w");
    let all = written(&desk);
    assert_eq!(all[2].1, all[5].1);
}

#[test]
fn a_file_without_runs_has_its_report_in_every_format() {
    let mut desk = Desk::with_section(SMALL);
    desk.keys("F h F m w");
    let names: Vec<String> = written(&desk).into_iter().map(|(path, _)| path).collect();
    assert_eq!(
        names,
        [
            "section-tables.html",
            "section-tables.md",
            "section-tables.txt"
        ]
    );
    assert!(written(&desk)[0].1.contains("<svg"));
}

#[test]
fn a_chart_is_written_as_a_picture() {
    let mut desk = reported();
    desk.keys("2 P");
    let (path, text) = written(&desk).pop().unwrap();
    assert!(path.ends_with("-tensions.svg"), "{path}");
    assert!(
        text.starts_with("<svg ") && text.contains("tension ["),
        "{text}"
    );
}
