//! A cross-section on the screen: the design and the zoom of its drawing.

use std::path::PathBuf;

use super::document::DocumentContent;
use super::document_kind::{DocumentKind, KindInfo};
use crate::report::chart::{Chart, Glyphs};
use crate::report::section::{self as views, tables};
use crate::report::table::Table;
use crate::section::stiffness::EndRotation;
use crate::section::{self, Design};
use crate::tui::facade::FieldRow;
use crate::tui::pane::PaneId;
use crate::tui::plot_pane::PlotPane;

/// Columns of what is written to a file.
pub const PAPER_WIDTH: usize = 100;

/// A cross-section.
#[derive(Debug, Clone)]
pub struct SectionView {
    /// The result of the text.
    pub design: Design,
    /// Zoom and pan of the drawing.
    pub view: PlotPane,
}

impl SectionView {
    /// A design as read.
    #[must_use]
    pub fn new(design: Design) -> Self {
        Self {
            design,
            view: PlotPane::default(),
        }
    }
}

impl DocumentKind for SectionView {
    fn info(&self) -> KindInfo<'_> {
        KindInfo {
            name: "cross-section",
            title: &self.design.section.about.title,
            source: &self.design.section.about.source,
            panes: &[PaneId::Inputs, PaneId::Drawing, PaneId::Tables],
            first: PaneId::Inputs,
            tabs: &["Layers", "Whole", "Stiffness", "Carried"],
        }
    }

    fn tab(&self, tab: usize) -> (Option<Chart>, Table) {
        let design = &self.design;
        let table = match tab {
            0 => tables::layers(design),
            1 => tables::summary(design),
            2 => tables::stiffness(design),
            _ => {
                let core = design.section.about.core;
                tables::load_sharing(design, core, EndRotation::Fixed, views::tension(design))
            }
        };
        (None, table)
    }

    fn renew(&mut self, newer: DocumentContent) {
        let DocumentContent::Section(newer) = newer else {
            return;
        };
        self.design = newer.design;
    }

    fn report_name(&self) -> (&'static str, &'static str) {
        ("tables", "The cross-section with its tables")
    }

    fn report(&self, _rows: &[FieldRow], glyphs: Glyphs) -> Option<String> {
        Some(views::report(&self.design, PAPER_WIDTH, glyphs, None))
    }

    fn copy(&self) -> Option<String> {
        Some(section::material_table(&self.design))
    }

    fn line_input(&self, _stem: &str) -> (PathBuf, Option<String>, &'static str) {
        let name = &self.design.section.about.name;
        (
            PathBuf::from(format!("{name}-material.txt")),
            Some(section::material_table(&self.design)),
            "The table [materials] for a line case",
        )
    }
}
