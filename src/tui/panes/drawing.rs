//! A cross-section drawn.

use std::path::PathBuf;

use ratatui::layout::Rect;

use super::interface::{Pane, PaneInfo, about};
use crate::chart;
use crate::command::{self, Command, CommandId, main, other};
use crate::msg::Effect;
use crate::state::parts::ScreenPart;
use crate::state::{AppState, DocumentContent};
use crate::update::export::{self, TEXT_WIDTH};
use crate::update::motion::plot_verb;
use crate::view::layout;
use crate::view::painter::Painter;

#[rustfmt::skip] // a table: one command a line
const COMMANDS: &[Command] = &[
    main(CommandId::ZoomIn, &["+", "="], "zoom", "Zoom in about the middle"),
    main(CommandId::PanLeft, &["h", "left", "H"], "left", "Show what lies further left"),
    main(CommandId::PanDown, &["j", "down", "{"], "down", "Show what lies lower"),
    main(CommandId::PanUp, &["k", "up", "}"], "up", "Show what lies higher"),
    main(CommandId::PanRight, &["l", "right", "L"], "right", "Show what lies further right"),
    other(CommandId::Fit, &["0"], "fit", "Show the whole cross-section again"),
    other(CommandId::ZoomOut, &["-"], "", "Zoom out about the middle"),
    command::command(command::CommandOrder::Rare, CommandId::Write, &["w"], "write", "Write the drawing to a text file"),
];

pub(super) struct DrawingPane;

impl Pane for DrawingPane {
    fn about(&self) -> PaneInfo {
        about("Drawing", "Go to the drawing", &[COMMANDS])
    }

    fn reason(&self, state: &AppState, id: CommandId) -> Option<&'static str> {
        let DocumentContent::Section(section) = &state.document.as_ref()?.content else {
            return None;
        };
        (id == CommandId::Fit && section.view.is_fitted())
            .then_some("The whole cross-section is shown already.")
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let glyphs = state.capabilities.glyphs;
        let area = layout::drawing_area(state);
        let document = state.document.as_mut()?;
        let path = PathBuf::from(format!("{}-drawing.txt", document.editor.stem()));
        let DocumentContent::Section(section) = &mut document.content else {
            return None;
        };
        let verb = plot_verb(id);
        if verb.is_none() && id != CommandId::Write {
            return None;
        }
        let shown = document.parts.last(ScreenPart::Drawing);
        let Some(base) = shown.and_then(|view| view.chart.as_ref()) else {
            return Some(Vec::new());
        };
        let Some(verb) = verb else {
            let shown = section.view.chart(base);
            let text = chart::draw(&shown, TEXT_WIDTH, TEXT_WIDTH / 2, glyphs).to_text();
            return Some(export::write(path, Some(text), "The drawing"));
        };
        let size = (area.width.into(), area.height.into());
        let frame = chart::frame(&section.view.chart(base), size.0, size.1, glyphs);
        section.view.act(verb, base, frame);
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let document = painter.state.document.as_ref();
        if let Some(DocumentContent::Section(section)) = document.map(|document| &document.content)
        {
            painter.part(area, ScreenPart::Drawing, |painter, view| {
                if let Some(base) = &view.chart {
                    painter.chart(&section.view.chart(base), area);
                }
            });
        }
    }
}
