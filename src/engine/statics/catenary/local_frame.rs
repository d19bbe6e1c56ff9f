//! A line of several sections, checked, in the local frame: A at the origin, B to the right, a surface above turned into a
//! bed below.

use super::composite_line::CompositeLine;
use super::elements::{LineElement, LineElements};
use super::error::CatenaryError;
use super::line::{CatenaryLine, RigidBed, SectionProperties};
use super::planar_line::ends_above;
use super::solution::LocalFrame;

/// The line in the local frame.
pub(super) fn in_local_frame(line: &CatenaryLine<'_>) -> Result<CompositeLine, CatenaryError> {
    line.ends.check()?;
    if line.sections.is_empty() {
        return Err(CatenaryError::Input {
            quantity: "the number of sections",
            value: 0.0,
            needs: "at least one",
        });
    }
    for section in line.sections {
        section.check()?;
    }
    let last = line.sections[line.sections.len() - 1].clump_n;
    if last != 0.0 {
        return Err(CatenaryError::Input {
            quantity: "the weight of a body at end B [N]",
            value: last,
            needs: "zero: what holds B carries it",
        });
    }
    let length: f64 = line.sections.iter().map(|s| s.length_m).sum();
    if let Some(bed) = line.bed {
        bed.check()?;
        ends_above(&bed, line.ends.x_m, line.ends.z_m, length)?;
    }
    // With a surface above and no bed below, the line is solved upside down.
    let (up, bed) = match (line.bed, line.surface_above_a_m) {
        (None, Some(above)) => (-1.0, Some(above)),
        (bed, _) => (1.0, bed.map(|bed| bed.below_a_m)),
    };
    if up < 0.0 {
        let flipped = RigidBed {
            below_a_m: bed.unwrap_or(0.0),
            ..RigidBed::default()
        };
        ends_above(&flipped, line.ends.x_m, -line.ends.z_m, length).map_err(
            |refusal| match refusal {
                CatenaryError::EndBelowBed { end, below_m } => CatenaryError::EndAboveSurface {
                    end,
                    above_m: below_m,
                },
                other => other,
            },
        )?;
    }
    Ok(CompositeLine {
        chain: LineElements::new(elements(line.sections, up)),
        x: line.ends.x_m.abs(),
        z: up * line.ends.z_m,
        // Sloping beds are treated separately.
        bed: bed
            .filter(|_| line.bed.is_none_or(|bed| bed.slope_rad == 0.0))
            .map(|depth| depth.max(0.0)),
        frame: LocalFrame {
            along: if line.ends.x_m < 0.0 { -1.0 } else { 1.0 },
            up,
        },
    })
}

fn elements(sections: &[SectionProperties], up: f64) -> Vec<LineElement> {
    let mut elements = Vec::with_capacity(2 * sections.len());
    for section in sections {
        elements.push(LineElement {
            length: section.length_m,
            weight: up * section.weight_n_per_m,
            ea: section.ea_n,
            load: 0.0,
        });
        if section.clump_n != 0.0 {
            elements.push(LineElement {
                length: 0.0,
                weight: 0.0,
                ea: section.ea_n,
                load: up * section.clump_n,
            });
        }
    }
    elements
}
