//! A cross-section in views: drawing and tables, and all of them as a text report.

pub mod drawing;
pub mod tables;

use crate::report::chart::Glyphs;
use crate::report::table::Table;
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
    let prose = [&about.source, &about.notes];
    let mut parts = vec![drawing::text(design, width, width / 2, glyphs)];
    parts.extend(
        prose
            .iter()
            .filter(|w| !w.is_empty())
            .map(|w| paragraph(w, width)),
    );
    if !design.layout.warnings.is_empty() {
        parts.push(warnings(design).to_text(width));
    }
    parts.push(tables::layers(design).to_text(width));
    parts.push(tables::summary(design).to_text(width));
    parts.push(tables::stiffness(design).to_text(width));
    parts
        .push(tables::load_sharing(design, about.core, EndRotation::Fixed, tension).to_text(width));
    parts.join("\n")
}

fn paragraph(words: &str, width: usize) -> String {
    let table = Table {
        title: words.split_whitespace().collect::<Vec<_>>().join(" "),
        ..Table::default()
    };
    table.to_text(width)
}

/// Warnings about the geometry.
fn warnings(design: &Design) -> Table {
    Table {
        title: "Warnings".to_owned(),
        notes: design
            .layout
            .warnings
            .iter()
            .map(ToString::to_string)
            .collect(),
        ..Table::default()
    }
}
