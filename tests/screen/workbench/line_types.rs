//! The library of line types: a material is chosen, added, and taken back.

use seacable::case::parse;
use seacable::tui::Effect;
use seacable::tui::state::Overlay;

use super::desk::Desk;
use super::{LARGE, SMALL, has, said, snapshot};

/// The library open, grade R4 without stud under the cursor, a diameter typed.
fn choosing(mut desk: Desk, diameter: &str) -> Desk {
    desk.keys("A down down down down");
    desk.type_text(diameter);
    desk
}

#[test]
fn the_library_shows_what_it_would_add() {
    let desk = choosing(Desk::with_case(SMALL), "120mm");
    snapshot("tui_line_types_80x24", &desk);
    let desk = choosing(Desk::with_case(LARGE), "300 mm");
    snapshot("tui_line_types_200x60", &desk);
}

#[test]
fn a_line_type_is_added_as_a_material_and_can_be_undone() {
    let mut desk = choosing(Desk::with_case(SMALL), "120mm");
    let before = desk.state.editor().unwrap().text.clone();
    desk.keys("enter");
    assert!(said(&desk).contains("[materials.chain-r4-studless-120mm]"));
    let text = desk.state.editor().unwrap().text.clone();
    assert!(text.starts_with(&before));
    let case = parse(&text, "case.toml").unwrap();
    let chain = &case.materials["chain-r4-studless-120mm"];
    assert!((chain.mass_kg_per_m - 286.56).abs() < 1e-9);
    assert_eq!(chain.diameter_m, 0.216);
    assert!(has(
        &desk,
        |e| matches!(e, Effect::KeepRecovery { text: Some(t), .. } if t.contains("chain-r4"))
    ));
    // A second of the same size has a name of its own.
    let mut desk = choosing(desk, "0.12");
    desk.keys("enter");
    assert!(said(&desk).contains("[materials.chain-r4-studless-120mm-2]"));
    desk.keys("u u");
    assert_eq!(desk.state.editor().unwrap().text, before);
}

#[test]
fn a_system_takes_line_types_too() {
    let mut desk = choosing(Desk::with_system(SMALL), "84 mm");
    desk.keys("enter");
    assert!(said(&desk).contains("[materials.chain-r4-studless-84mm]"));
}

#[test]
fn a_diameter_that_is_none_is_refused_and_esc_closes() {
    for typed in ["", "wide", "-3mm", "500", "12 kg"] {
        let mut desk = choosing(Desk::with_case(SMALL), typed);
        desk.keys("enter");
        assert!(
            matches!(&desk.state.overlay, Some(Overlay::LineTypes(p)) if !p.problem.is_empty())
        );
        desk.keys("esc");
        assert!(desk.state.overlay.is_none());
        assert!(!desk.state.editor().unwrap().unsaved());
    }
}
