//! Commands typed with their arguments.

use seacable::chart::Glyphs;
use seacable::tui::Effect;
use seacable::tui::pane::PaneId;
use seacable::tui::state::Overlay;
use seacable::tui::theme::Palette;

use super::desk::Desk;
use super::{SMALL, has, said, snapshot};

/// Types a line and presses Enter.
fn line(desk: &mut Desk, text: &str) {
    desk.keys(":");
    desk.type_text(text);
    desk.keys("enter");
}

fn problem(desk: &Desk) -> &str {
    match &desk.state.overlay {
        Some(Overlay::Palette(line)) => &line.problem,
        _ => "",
    }
}

#[test]
fn the_line_of_commands() {
    let mut desk = Desk::with_case(SMALL);
    desk.keys(":");
    snapshot("tui_command_line_80x24", &desk);
    desk.type_text("set current.");
    snapshot("tui_command_line_keys_80x24", &desk);
    desk.keys("tab");
    desk.type_text("x");
    desk.keys("enter");
    assert!(desk.screen().contains("Refused"), "{}", desk.screen());
}

#[test]
fn keys_are_set_and_gone_to() {
    let mut desk = Desk::with_case(SMALL);
    line(&mut desk, "set current.speed_m_per_s=0.8");
    assert!(
        desk.state
            .editor()
            .unwrap()
            .text
            .contains("speed_m_per_s = 0.8")
    );
    line(&mut desk, "goto payload");
    let field = desk.state.editor().unwrap().current_field().unwrap();
    assert!(field.path.starts_with("payload"), "{}", field.path);
    line(&mut desk, "set current.speed=1");
    assert!(
        problem(&desk).contains("no key `current.speed`"),
        "{}",
        problem(&desk)
    );
    desk.keys("esc");
    assert!(desk.state.overlay.is_none());
}

#[test]
fn a_case_is_varied_from_the_line() {
    let mut desk = Desk::with_case(SMALL);
    line(&mut desk, "vary current.speed_m_per_s=0.2..0.4/3");
    assert_eq!(desk.started().len() + desk.state.jobs.waiting.len(), 3);
    line(&mut desk, "vary current.speed_m_per_s=0.3");
    assert!(problem(&desk).contains("one value"), "{}", problem(&desk));
    let mut desk = Desk::with_case(SMALL);
    line(
        &mut desk,
        "vary current.speed_m_per_s=0.2, 0.3 payload.drag_area_m2=100, 120",
    );
    assert_eq!(desk.started().len() + desk.state.jobs.waiting.len(), 4);
}

#[test]
fn cases_are_opened_by_a_part_of_their_names() {
    let mut desk = Desk::new(SMALL);
    line(&mut desk, "open bdy");
    assert!(has(
        &desk,
        |e| matches!(e, Effect::ReadCase(path) if path.ends_with("body.toml"))
    ));
    let mut desk = Desk::with_case(SMALL);
    desk.keys("M");
    line(&mut desk, "open broken");
    assert!(
        problem(&desk).contains("`s` saves them") || problem(&desk).contains("not saved"),
        "{}",
        problem(&desk)
    );
}

#[test]
fn panes_filters_sorting_and_columns() {
    let mut desk = Desk::with_case(SMALL);
    line(&mut desk, "pane nod");
    assert_eq!(desk.state.focus(), PaneId::Nodes);
    line(&mut desk, "sort tension");
    line(&mut desk, "sort tension");
    let sorted = desk
        .state
        .table_pane()
        .unwrap()
        .sorted_by()
        .cloned()
        .unwrap();
    assert_eq!(sorted, ("tension [N]".to_owned(), true));
    line(&mut desk, "hide y [m]");
    assert_eq!(desk.state.table_pane().unwrap().hidden(), ["y [m]"]);
    line(&mut desk, "show ");
    assert!(desk.state.table_pane().unwrap().hidden().is_empty());
    line(&mut desk, "explain z");
    assert!(matches!(
        desk.state.overlay,
        Some(Overlay::Explanation { .. })
    ));
    desk.keys("esc");
    line(&mut desk, "filter tension");
    let table = desk.state.focused_table().unwrap();
    assert_eq!(desk.state.table_pane().unwrap().count(&table), 1);
}

#[test]
fn looks_and_names() {
    let mut desk = Desk::with_case(SMALL);
    line(&mut desk, "theme lig");
    assert_eq!(desk.state.capabilities.palette, Palette::Light);
    line(&mut desk, "glyphs ascii");
    assert_eq!(desk.state.capabilities.glyphs, Glyphs::Ascii);
    line(&mut desk, "save as other.toml");
    assert!(has(
        &desk,
        |e| matches!(e, Effect::SaveCase { path, new: true, .. } if path.ends_with("other.toml"))
    ));
    line(&mut desk, "nonsense");
    assert!(problem(&desk).contains("nonsense"));
}

#[test]
fn lines_of_before_are_recalled() {
    let mut desk = Desk::with_case(SMALL);
    line(&mut desk, "theme mono");
    line(&mut desk, "pane charts");
    desk.keys(": up");
    let typed = |desk: &Desk| match &desk.state.overlay {
        Some(Overlay::Palette(line)) => line.input.value().to_owned(),
        _ => String::new(),
    };
    assert_eq!(typed(&desk), "pane charts");
    desk.keys("up");
    assert_eq!(typed(&desk), "theme mono");
    desk.keys("down down");
    assert_eq!(typed(&desk), "");
    desk.keys("esc");
    assert!(!said(&desk).contains("theme"));
}
