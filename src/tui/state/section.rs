//! A cross-section on the screen: the design and the zoom of its drawing.

use std::path::PathBuf;
use std::sync::Arc;

use super::document_kind::{DocumentKind, KindInfo};
use super::value_check::ValidationTable;
use crate::case::EditedKey;
use crate::facade::FieldRow;
use crate::pane::PaneId;
use crate::plot_pane::PlotPane;
use crate::report::subject::ReportSubject;
use crate::section::{self, Design};

/// A cross-section.
#[derive(Debug, Clone)]
pub struct SectionView {
    /// The result of the text.
    pub design: Arc<Design>,
    /// Its table of materials for a line case.
    pub material: String,
    /// Zoom and pan of the drawing.
    pub view: PlotPane,
    /// The validation table, a pane where the file states published values.
    pub checks: ValidationTable,
}

impl SectionView {
    /// A design as read.
    #[must_use]
    pub fn new(design: Design) -> Self {
        Self {
            material: section::material_table(&design),
            design: Arc::new(design),
            view: PlotPane::default(),
            checks: ValidationTable::default(),
        }
    }
}

impl SectionView {
    /// Replaces the result by that of a newer text; what the user looks at stays.
    pub(super) fn renew(&mut self, newer: Self) {
        self.design = newer.design;
        self.material = newer.material;
        self.checks = newer.checks;
    }
}

impl DocumentKind for SectionView {
    fn info(&self) -> KindInfo<'_> {
        KindInfo {
            name: "cross-section",
            title: &self.design.section.about.title,
            source: &self.design.section.about.source,
            panes: match self.checks.rows.is_empty() {
                true => &[PaneId::Inputs, PaneId::Drawing, PaneId::Tables],
                false => &[
                    PaneId::Inputs,
                    PaneId::Drawing,
                    PaneId::Tables,
                    PaneId::Validation,
                ],
            },
            first: PaneId::Inputs,
            tabs: &["Layers", "Whole", "Stiffness", "Carried"],
        }
    }

    fn validate(&mut self, _text: &str, edited: &[EditedKey]) {
        let rows = section::validation::rows(&self.design);
        self.checks = ValidationTable::edited(rows, edited);
    }

    fn checks(&self) -> Option<&ValidationTable> {
        Some(&self.checks)
    }

    fn report_name(&self) -> (&'static str, &'static str) {
        ("tables", "The cross-section with its tables")
    }

    fn report<'a>(&'a self, rows: &'a [FieldRow]) -> Option<ReportSubject<'a>> {
        Some(ReportSubject::Section(&self.design, rows, None))
    }

    fn copy(&self) -> Option<&str> {
        Some(&self.material)
    }

    fn line_input(&self, _stem: &str) -> (PathBuf, Option<String>, &'static str) {
        let name = &self.design.section.about.name;
        (
            PathBuf::from(format!("{name}-material.txt")),
            Some(self.material.clone()),
            "The table [materials] for a line case",
        )
    }
}
