//! Drawing and tables of a cross-section.

use super::part_view::{with_chart, with_table};
use crate::report::section::{self as views, drawing, tables};
use crate::section::stiffness::EndRotation;
use crate::state::SectionView;
use crate::state::parts::{PartView, ScreenPart};

pub(super) fn view(section: &SectionView, part: ScreenPart) -> PartView {
    let design = &section.design;
    let table = match part {
        ScreenPart::Tab(0) => tables::layers(design),
        ScreenPart::Tab(1) => tables::summary(design),
        ScreenPart::Tab(2) => tables::stiffness(design),
        ScreenPart::Tab(_) => {
            let core = design.section.about.core;
            tables::load_sharing(design, core, EndRotation::Fixed, views::tension(design))
        }
        _ => return with_chart(drawing::chart(design)),
    };
    with_table((None, table))
}
