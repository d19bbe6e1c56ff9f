//! Templates of new files: a scene of a kind with its main numbers asked for, written as a person would write it.
//!
//! What a template writes is complete and can be computed at once. Main lengths are `[parameters]`, so that one edit moves all that
//! follows from them. Numbers that are not asked for are marked as assumed where they matter.

mod cross_section;
mod line;
mod lowering;
mod mooring;
mod ropeway;
mod ship;
mod template;
mod umbilical;

pub use template::{Choices, Template, TemplateInput};

/// All templates, those of common scenes first.
pub static TEMPLATES: &[Template] = &[
    mooring::LINE,
    mooring::SPREAD,
    lowering::LOWERING,
    umbilical::UMBILICAL,
    ropeway::ROPEWAY,
    line::LINE,
    cross_section::SECTION,
    ship::SHIP,
];

/// The template of a name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Template> {
    TEMPLATES.iter().find(|template| template.name == name)
}
