//! A cross-section in views: drawing and tables, and all of them as a text report.

pub mod drawing;
pub mod tables;

use crate::report::chart::Glyphs;
use crate::report::table::Table;
use crate::report::text::Page;
use crate::section::Design;
use crate::section::stiffness::EndRotation;

/// Tension of the load sharing where no strength is known \[N\].
const SAMPLE: f64 = 1e5;

/// Default tension of the load sharing \[N\]: the allowable tension, or 100 kN where that is unknown.
#[must_use]
pub fn tension(design: &Design) -> f64 {
    let allowable = design.strength.as_ref().map(|s| s.allowable);
    allowable.unwrap_or(SAMPLE)
}

/// The design as text of this width. `tension` is that of the load sharing \[N\], [`tension`](tension()) by default.
#[must_use]
pub fn report(design: &Design, width: usize, glyphs: Glyphs, tension: Option<f64>) -> String {
    let about = &design.section.about;
    let tension = tension.unwrap_or_else(|| self::tension(design));
    let mut page = Page::new(width);
    page.chart(&drawing::chart(design), width / 2, glyphs);
    page.prose([&about.source, &about.notes]);
    if !design.layout.warnings.is_empty() {
        let warnings = design.layout.warnings.iter();
        page.table(&Table::titled("Warnings").noted(warnings.map(ToString::to_string)));
    }
    page.table(&tables::layers(design));
    page.table(&tables::summary(design));
    page.table(&tables::stiffness(design));
    page.table(&tables::load_sharing(
        design,
        about.core,
        EndRotation::Fixed,
        tension,
    ));
    page.finish()
}
