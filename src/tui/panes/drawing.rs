//! A cross-section drawn.

use std::path::PathBuf;

use ratatui::layout::Rect;

use super::{About, Pane, about};
use crate::report::chart;
use crate::report::section::drawing;
use crate::tui::command::{self, Command, Id, main, other};
use crate::tui::msg::Effect;
use crate::tui::state::{AppState, Content, Document, SectionView};
use crate::tui::update::export::{self, TEXT_WIDTH};
use crate::tui::update::motion::plot_verb;
use crate::tui::view::layout;
use crate::tui::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(Id::ZoomIn, &["+", "="], "zoom", "Zoom in about the middle"),
    main(Id::PanLeft, &["h", "left", "H"], "left", "Show what lies further left"),
    main(Id::PanDown, &["j", "down", "{"], "down", "Show what lies lower"),
    main(Id::PanUp, &["k", "up", "}"], "up", "Show what lies higher"),
    main(Id::PanRight, &["l", "right", "L"], "right", "Show what lies further right"),
    other(Id::Fit, &["0"], "fit", "Show the whole cross-section again"),
    other(Id::ZoomOut, &["-"], "", "Zoom out about the middle"),
    command::command(command::Order::Rare, Id::Write, &["w"], "write", "Write the drawing to a text file"),
];

pub(super) struct Drawing;

/// The cross-section that is open.
fn section(document: &mut Document) -> Option<&mut SectionView> {
    match &mut document.content {
        Content::Section(section) => Some(section),
        _ => None,
    }
}

impl Pane for Drawing {
    fn about(&self) -> About {
        about("Drawing", "Go to the drawing", &[COMMANDS])
    }

    fn update(&self, state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
        let glyphs = state.capabilities.glyphs;
        let area = layout::drawing_area(state);
        let document = state.document.as_mut()?;
        let path = PathBuf::from(format!("{}-drawing.txt", document.editor.stem()));
        let section = section(document)?;
        let base = drawing::chart(&section.design);
        if id == Id::Write {
            let shown = section.view.chart(&base);
            let text = chart::draw(&shown, TEXT_WIDTH, TEXT_WIDTH / 2, glyphs).to_text();
            return Some(export::write(path, Some(text), "The drawing"));
        }
        let verb = plot_verb(id)?;
        let size = (area.width.into(), area.height.into());
        let frame = chart::frame(&section.view.chart(&base), size.0, size.1, glyphs);
        section.view.act(&verb, &base, frame);
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let document = painter.state.document.as_ref();
        if let Some(Content::Section(section)) = document.map(|document| &document.content) {
            let chart = section.view.chart(&drawing::chart(&section.design));
            painter.chart(&chart, area);
        }
    }
}
